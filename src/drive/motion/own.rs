//! What a drive makes of a setpoint by its own settings, and what it runs at without one; and whether that is still so.

use super::look::{role_raw, state_name, status_word, working};
use super::{Motor, Situation, has_power};
use crate::drive::describe;
use crate::drive::session::Session;
use crate::drive::target::Target;
use crate::failure::{Class, Failure};
use crate::profile::value::format_decimal;
use crate::profile::{Family, Mode, Param};
use crate::text::{Text, both};
use crate::tick::{Span, Tick};

/// A source of the drive's own may be an analog one, which is never quite the same: so much of it, and at least so much raw.
const WAVERS: u64 = 20;
const WAVERS_RAW: u64 = 50;
/// How often a run looks whether the drive still leads the shaft to what was agreed to.
const LOOKS: Span = Span::from_secs(1);
/// It runs otherwise than was agreed to.
const OTHERWISE: &str = "forbidden.otherwise";

/// What the settings of a drive make of the setpoint of a mode. `None`: it does not tell, or has no such setting. Setpoint and bounds are
/// raw integers with the decimals of the mode's setpoint; where something comes from is the raw value of a selection.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Own {
    /// Where its setpoint comes from.
    pub source: Option<i64>,
    /// Setpoint of its own, if it works with one.
    pub adds: Option<i64>,
    /// Where what it adds comes from, if only the sum of both is shown.
    pub by: Option<i64>,
    /// Bound in both directions.
    pub limit: Option<i64>,
    /// Least magnitude, to which it lifts what is smaller.
    pub least: Option<i64>,
}

impl Own {
    /// Reads it in the data set that the drive works with; what the run itself sets is that.
    pub async fn read(
        session: &mut Session<'_>,
        target: &mut Target,
        mode: &Mode,
        sets: &[(Param, i64)],
    ) -> Result<Own, Failure> {
        let mut own = Own::default();
        let mut will_be = async |id: u32| match sets.iter().find(|(param, _)| param.id == id) {
            Some((_, raw)) => Ok(Some(*raw)),
            None => {
                let param = target.family.param_or_unknown(id);
                working(session, target, &param).await
            }
        };
        if let Some(source) = &mode.source {
            own.source = will_be(source.param).await?;
        }
        if let Some(adds) = mode.adds.filter(|adds| own.takes(mode, adds.source)) {
            own.adds = will_be(adds.param).await?;
            own.by = if adds.sum { will_be(adds.by).await? } else { None };
        }
        if let Some(limit) = mode.limit {
            own.limit = will_be(limit).await?;
        }
        if let Some(floor) = mode.floor.as_ref().filter(|floor| own.source == Some(floor.source)) {
            own.least = will_be(floor.param).await?;
        }
        Ok(own)
    }

    /// Whether the drive works with what it adds with this source: in place of the line as well.
    fn takes(&self, mode: &Mode, with: Option<i64>) -> bool {
        let ignored = mode.source.as_ref().map(|source| source.ignored);
        with.is_none() || (self.source.is_some() && (self.source == with || self.source == ignored))
    }

    /// In the order of [`Promise::params`].
    fn values(&self) -> [Option<i64>; 5] {
        [self.source, self.adds, self.by, self.limit, self.least]
    }
}

/// How far a source may be from what it was.
fn wavers(value: i64) -> u64 {
    (value.unsigned_abs() / WAVERS).max(WAVERS_RAW)
}

/// What a drive makes of a setpoint by its own settings; raw integers with the decimals of the mode's setpoint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Total {
    /// Setpoint of its own that it adds.
    pub added: i64,
    /// Bound in both directions.
    pub limit: Option<i64>,
    /// Least magnitude, to which the drive lifts what is smaller.
    pub least: Option<i64>,
}

impl Total {
    /// What it runs at, told this; `None` if that cannot be reckoned.
    pub fn of(self, raw: i64) -> Option<i64> {
        let limit = self.limit.unwrap_or(i64::MAX).max(0);
        self.sum(raw).map(|sum| match self.least {
            Some(least) if sum.abs() < least => least * if sum < 0 { -1 } else { 1 },
            _ => sum.clamp(-limit, limit),
        })
    }

    /// Whether the drive will run at another value than what it is told and what it adds.
    pub fn bends(self, raw: i64) -> bool {
        self.of(raw) != self.sum(raw)
    }

    fn sum(self, raw: i64) -> Option<i64> {
        raw.checked_add(self.added)
    }
}

/// What somebody was shown of a drive's own settings and agreed to.
#[derive(Clone, Debug)]
pub struct Promise {
    mode: Mode,
    sets: Vec<(Param, i64)>,
    /// What they make of a setpoint.
    pub own: Own,
    /// What the drive adds is led by what the run sets: nobody can be held to it.
    led: bool,
}

impl Promise {
    /// Reads what there is to show of a mode; `sets` is what the run itself sets.
    pub async fn read(
        session: &mut Session<'_>,
        target: &mut Target,
        mode: &Mode,
        sets: &[(Param, i64)],
    ) -> Result<Promise, Failure> {
        let own = Own::read(session, target, mode, sets).await?;
        Ok(Promise { mode: mode.clone(), sets: sets.to_vec(), own, led: false })
    }

    /// The same where what the drive adds is led by what the run sets.
    pub fn led(self) -> Self {
        Promise { led: true, ..self }
    }

    /// Fails if it is otherwise now: a contact may have selected another data set while somebody was asked.
    pub async fn demand(&self, session: &mut Session<'_>, target: &mut Target) -> Result<(), Failure> {
        let now = Own::read(session, target, &self.mode, &self.sets).await?;
        let then = self.params(&self.own).into_iter().zip(self.own.values()).zip(self.wavering());
        let now = self.params(&now).into_iter().zip(now.values());
        let mut otherwise = Vec::new();
        for (((id, then), near), (new, now)) in then.zip(now) {
            if let Some(id) = id.or(new).filter(|_| !is_near(then, now, near)) {
                otherwise.push(changed(&target.family.param_or_unknown(id), then, now));
            }
        }
        if otherwise.is_empty() { Ok(()) } else { Err(broken(&otherwise)) }
    }

    /// What the shaft runs at by itself, in words; `None` if it does not.
    pub fn runs_at(&self, family: &Family) -> Option<Text> {
        let source = self.mode.source.as_ref()?;
        let adds = self.mode.adds.filter(|adds| adds.source.is_some()).map(|adds| (adds.param, self.own.adds));
        let least = self.mode.floor.as_ref().map(|floor| (floor.param, self.own.least));
        let own = adds.into_iter().chain(least).find_map(|(id, value)| Some((id, value?)));
        let (id, value) = own.filter(|&(_, value)| value != 0)?;
        let (param, by) = (family.param_or_unknown(id), family.param_or_unknown(source.param).label());
        let (value, label, chosen) = (shown(&param, value), param.label(), self.own.source.unwrap_or(0));
        Some(both!(
            "it runs at {value} by itself ({label}, {by} = {chosen})",
            "er läuft von selbst mit {value} ({label}, {by} = {chosen})"
        ))
    }

    /// The settings of which nothing could be read.
    pub fn unknown(&self, family: &Family) -> Vec<String> {
        let rows = self.params(&self.own).into_iter().zip(self.own.values());
        rows.filter_map(|(id, value)| id.filter(|_| value.is_none()))
            .map(|id| family.param_or_unknown(id).label())
            .collect()
    }

    /// Every setting that counts with the source that the drive works with.
    fn params(&self, own: &Own) -> [Option<u32>; 5] {
        let Mode { source, adds, limit, floor, .. } = &self.mode;
        let adds = adds.filter(|adds| own.takes(&self.mode, adds.source));
        [
            source.as_ref().map(|source| source.param),
            adds.map(|adds| adds.param),
            adds.filter(|adds| adds.sum).map(|adds| adds.by),
            *limit,
            floor.as_ref().filter(|floor| own.source == Some(floor.source)).map(|floor| floor.param),
        ]
    }

    /// How far each may be from what it was. Of a sum of which the run sets a part, and of what is led by that, nothing is agreed to.
    fn wavering(&self) -> [u64; 5] {
        let is_led = self.led || self.mode.adds.is_some_and(|adds| adds.sum);
        [0, if is_led { u64::MAX } else { wavers(self.own.adds.unwrap_or(0)) }, 0, 0, 0]
    }

    /// Every setting that was agreed to: what it was, and how far it may be from that.
    fn settings(&self) -> Vec<(u32, Option<i64>, u64)> {
        let rows = self.params(&self.own).into_iter().zip(self.own.values()).zip(self.wavering());
        rows.filter_map(|((id, value), near)| Some((id?, value, near))).filter(|row| row.2 < u64::MAX).collect()
    }
}

fn is_near(then: Option<i64>, now: Option<i64>, near: u64) -> bool {
    match (then, now) {
        _ if near == u64::MAX => true,
        (Some(then), Some(now)) => then.abs_diff(now) <= near,
        (then, now) => then == now,
    }
}

fn changed(param: &Param, then: Option<i64>, now: Option<i64>) -> String {
    let word = |value: Option<i64>| value.map_or_else(|| "-".to_owned(), |value| shown(param, value));
    format!("{}: {} -> {}", param.label(), word(then), word(now))
}

fn broken(changed: &[String]) -> Failure {
    let changed = changed.join(", ");
    otherwise(both!(
        "the drive would run otherwise than was agreed to, its own settings in force have changed: {changed}",
        "der Antrieb liefe anders als vereinbart, seine eigenen wirksamen Einstellungen haben sich geändert: {changed}"
    ))
}

/// Fails if somebody else has started the drive since it was shown without power: while somebody was asked.
pub async fn demand_as_shown(session: &mut Session<'_>, target: &mut Target, shown: &Situation) -> Result<(), Failure> {
    if has_power(&shown.state) != Some(false) {
        return Ok(());
    }
    let status = status_word(session, target).await?;
    let now = describe::state(&target.family, status);
    if has_power(&now.slug) != Some(true) {
        return Ok(());
    }
    let (then, now) = (state_name(&target.family, &shown.state), now.name);
    Err(otherwise(both!(
        "somebody else has started the drive: it was in '{then}' when you were asked, and is in '{now}'",
        "jemand anderes hat den Antrieb gestartet: bei der Frage war er in '{then}', jetzt in '{now}'",
        then,
        now
    )))
}

pub(super) fn otherwise(text: Text) -> Failure {
    Failure::new(Class::Forbidden, OTHERWISE, text).hint(both!(
        "another data set, an input, or somebody else: say it again to see what it runs at now",
        "ein anderer Datensatz, ein Eingang oder jemand anderes: noch einmal aufrufen zeigt, womit er jetzt liefe"
    ))
}

/// When it was last looked at whether a run still leads its shaft where was agreed to.
#[derive(Debug, Default)]
pub(super) struct Course {
    looked: Option<Tick>,
    /// Where the ramp was.
    ramp: Option<i64>,
    /// Every setting was what was shown, since the run began: from then on the way of the ramp tells.
    agrees: bool,
    /// The setting that is looked at next.
    next: usize,
}

impl Motor<'_, '_> {
    /// Fails if the drive leads the shaft away from its goal because its own settings have changed, or works in another mode. Asks now
    /// and then, at the first look for the settings themselves: as long as an answer, which takes so long, comes by then. That none
    /// comes is for the look at the state to judge.
    pub(super) async fn keeps(&mut self, takes: Span, by: Option<Tick>) -> Result<(), Failure> {
        match self.look_at_course(takes, by).await {
            // A lost port and an interrupt are there for the next question as well.
            Err(failure) if failure.code != OTHERWISE => {
                self.course.looked = Some(self.session.now());
                Ok(())
            }
            kept => kept,
        }
    }

    /// The same, and fails where no answer comes as well.
    pub(super) async fn look_at_course(&mut self, takes: Span, by: Option<Tick>) -> Result<(), Failure> {
        let now = self.session.now();
        let is_time = |takes: Span| by.is_none_or(|by| now + takes <= by);
        if self.course.looked.is_some_and(|looked| now.since(looked) < LOOKS) || !is_time(takes) {
            return Ok(());
        }
        self.course.looked = Some(now);
        let retries = self.session.set_retries(0);
        // Of a drive that does not show its ramp the settings themselves are looked at every time.
        let goal = self.expects.filter(|_| self.course.agrees && self.target.family.role("setpoint-ramp").is_some());
        let strayed = match goal {
            Some((_, goal)) => self.strayed(goal).await,
            None => self.otherwise_now(takes, by).await,
        };
        self.session.set_retries(retries);
        if strayed.is_err() {
            self.course.looked = None;
        }
        strayed?.map_or(Ok(()), Err)
    }

    /// A last look at what was agreed to, where a run found nothing in its way: what changed since the look before shows here.
    pub(super) async fn kept<T>(&mut self, result: Result<T, Failure>) -> Result<T, Failure> {
        if result.is_err() || self.relieving.is_some() || self.unheard {
            return result;
        }
        self.course = Course::default();
        self.keeps(Span::ZERO, None).await.and(result)
    }

    /// What is looked at: the mode that was set with all that makes its setpoint count, as long as it runs, because a drive may end
    /// these with the run; and what was agreed to.
    fn looked_at(&self) -> Vec<(u32, Option<i64>, u64)> {
        let shows = self.target.family.role("mode-active");
        let mode = self.mode.as_ref().filter(|_| !self.stopping);
        let active = mode.and_then(|mode| Some((shows?.id, Some(mode.value?), 0)));
        let presets = mode.iter().flat_map(|mode| &mode.engage).map(|preset| (preset.param, Some(preset.value), 0));
        // A setpoint that is not given again and again may be changed by somebody else.
        let given = mode.zip(self.setpoint.as_ref()).filter(|(mode, _)| !mode.zero && mode.starts.is_empty());
        let given = given.into_iter().flat_map(|(mode, setpoint)| {
            let below = mode.denominator.zip(setpoint.denominator);
            [Some((setpoint.param, setpoint.value.raw)), below].into_iter().flatten()
        });
        let given = given.map(|(param, raw)| (param, Some(raw), 0));
        let agreed = self.promises.iter().flat_map(Promise::settings);
        active.into_iter().chain(presets).chain(given).chain(agreed).collect()
    }

    /// It works in another mode, or something that decides on its way was changed.
    fn is_otherwise(&self, param: &Param, then: Option<i64>, now: i64) -> Failure {
        let family = &self.target.family;
        let name = self
            .mode
            .as_ref()
            .map(Mode::text)
            .filter(|_| family.role("mode-active").is_some_and(|row| row.id == param.id));
        let Some(name) = name else { return broken(&[changed(param, then, Some(now))]) };
        let label = param.label();
        otherwise(both!(
            "the drive has left the mode '{name}': {label} = {now}",
            "der Antrieb hat die Betriebsart '{name}' verlassen: {label} = {now}",
            name
        ))
    }

    async fn strayed(&mut self, goal: i64) -> Result<Option<Failure>, Failure> {
        let Some(ramp) = role_raw(self.session, self.target, "setpoint-ramp").await? else { return Ok(None) };
        let far = ramp.abs_diff(goal);
        // A goal that is led may have gone away from it meanwhile: that the ramp was farther from where it is now is what counts.
        let nears = self.course.ramp.replace(ramp).is_none_or(|before| far < before.abs_diff(goal));
        if nears || far <= wavers(goal) { Ok(None) } else { self.otherwise_now(Span::ZERO, None).await }
    }

    /// What the run has set stands in one data set, and another may be in force. What there is no time for is looked at the next time.
    async fn otherwise_now(&mut self, takes: Span, by: Option<Tick>) -> Result<Option<Failure>, Failure> {
        let family = self.target.family.clone();
        let settings = self.looked_at();
        while let Some((id, then, near)) = settings.get(self.course.next).copied() {
            // The data set may be asked for before it.
            if by.is_some_and(|by| self.session.now() + takes.times(2) > by) {
                self.course.looked = None;
                return Ok(None);
            }
            let param = family.param_or_unknown(id);
            let now = working(self.session, self.target, &param).await?;
            // What is not told is no change.
            if let Some(now) = now.filter(|_| !is_near(then, now, near)) {
                return Ok(Some(self.is_otherwise(&param, then, now)));
            }
            self.course.next += 1;
        }
        (self.course.agrees, self.course.next) = (true, 0);
        Ok(None)
    }
}

/// A value with its unit.
pub(super) fn shown(param: &Param, value: i64) -> String {
    let number = format_decimal(value, param.decimals_or_zero());
    param.unit.as_ref().map_or(number.clone(), |unit| format!("{number} {unit}"))
}
