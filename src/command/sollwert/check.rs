//! Holding a setpoint against what the drive says.

use super::wanted::{Wanted, out_of_range};
use super::{Args, in_hertz};
use crate::drive::motion::{Own, Promise, Situation, Total, in_fault, may_change_mode, no_control, role_raw, working};
use crate::drive::{Session, Target};
use crate::failure::{Class, Failure};
use crate::outcome::Event;
use crate::profile::value::check_range;
use crate::profile::{Adds, Family, Param, setpoint};
use crate::text::{Text, both};

/// Holds a setpoint against what the drive says, before anybody is asked.
pub(super) struct Check<'c, 's> {
    pub(super) args: &'c Args,
    pub(super) session: &'c mut Session<'s>,
    pub(super) target: &'c mut Target,
    pub(super) before: &'c Situation,
}

impl Check<'_, '_> {
    /// Also what of the drive's own settings that rests on.
    pub(super) async fn run(
        &mut self,
        mut wanted: Wanted,
        enable: bool,
        needs_control: bool,
    ) -> Result<(Wanted, Option<Promise>), Failure> {
        if enable && let Some(failure) = in_fault(self.before, &self.target.family) {
            return Err(failure);
        }
        if needs_control && let Some(failure) = no_control(self.before, self.target) {
            return Err(failure);
        }
        if wanted.start.is_some() && !enable && self.before.state != "operation-enabled" {
            let text = both!("the drive is not enabled, so nothing can start", "der Antrieb ist nicht freigegeben");
            let hint = both!("add --enable", "--enable angeben");
            return Err(Failure::new(Class::Forbidden, "forbidden.not_enabled", text).hint(hint));
        }
        may_change_mode(self.session, self.target, &self.before.state, &wanted.mode).await?;
        if wanted.by_speed {
            let pairs = self.pole_pairs().await?;
            let schedule = wanted.schedule.map(|raw| setpoint::frequency_of_speed(raw, pairs));
            wanted.schedule = schedule.ok_or_else(|| too_large(&wanted, &self.target.family))?;
            wanted.keys = match wanted.keys {
                Some(keys) => Some(
                    keys.map(|raw| setpoint::frequency_of_speed(raw, pairs))
                        .ok_or_else(|| too_large(&wanted, &self.target.family))?,
                ),
                None => None,
            };
            wanted.by_speed = false;
        }
        wanted.check_widths()?;
        for raw in wanted.values().filter(|_| !self.args.force) {
            check_range(raw, &wanted.param).map_err(|error| out_of_range(&wanted.param, &error))?;
        }
        let promise = Promise::read(self.session, self.target, &wanted.mode, &wanted.settings).await?;
        let own = promise.own;
        Self::is_obeyed(&wanted, own)?;
        let added = self.added(&wanted, own).await?;
        let limit = self.limit(&wanted, own, added.unwrap_or(0))?;
        let least = self.floor(&wanted, own);
        self.tells_unknown(&promise);
        wanted.effective = added.map(|added| Total { added, limit, least });
        wanted.least = promise.own.least;
        wanted.may_lift = self.may_lift(&wanted, own).await?;
        Ok((wanted, Some(promise)))
    }

    /// Whether a least setpoint stands in the drive of which no manual says that it counts only with another source: from its
    /// enabling on the shaft may turn at that.
    async fn may_lift(&mut self, wanted: &Wanted, own: Own) -> Result<bool, Failure> {
        let Some(floor) = wanted.mode.floor.as_ref().filter(|floor| own.source != Some(floor.source)) else {
            return Ok(false);
        };
        let param = self.target.family.param_or_unknown(floor.param);
        let set = wanted.settings.iter().find(|(param, _)| param.id == floor.param).map(|(_, raw)| *raw);
        let least = if set.is_some() { set } else { working(self.session, self.target, &param).await? };
        let Some(least) = least.filter(|&least| least > 0) else { return Ok(false) };
        if wanted.values().any(|raw| raw.saturating_abs() < least) {
            let (source, label) = (wanted.mode.source.as_ref(), param.label());
            let source = source.map_or(0, |source| source.param);
            self.session.tell(Event::Note(both!(
                "the drive may lift the setpoint to {label} = {least}: no source says that it does so only with {source} = {value}",
                "der Antrieb hebt den Sollwert vielleicht auf {label} = {least} an: keine Quelle sagt, dass er das nur bei {source} = \
                 {value} tut",
                least = wanted.shown(least, &self.target.family),
                source = self.target.family.param_or_unknown(source).label(),
                value = floor.source
            )));
        }
        Ok(true)
    }

    /// What cannot be read may bend the setpoint all the same; told.
    fn tells_unknown(&mut self, promise: &Promise) {
        let unknown = promise.unknown(&self.target.family);
        if !unknown.is_empty() {
            self.session.tell(Event::Note(both!(
                "the drive does not tell {unknown}: what it makes of the setpoint may be another one",
                "der Antrieb nennt {unknown} nicht: was er aus dem Sollwert macht, kann ein anderer sein",
                unknown = unknown.join(", ")
            )));
        }
    }

    async fn pole_pairs(&mut self) -> Result<i64, Failure> {
        let pairs = role_raw(self.session, self.target, "pole-pairs").await?;
        pairs.filter(|&pairs| pairs > 0).ok_or_else(|| {
            let label = self.target.family.role("pole-pairs").map_or_else(|| "-".to_owned(), Param::label);
            let text = both!(
                "the drive does not tell its pole pairs ({label})",
                "der Antrieb nennt seine Polpaarzahl ({label}) nicht"
            );
            Failure::new(Class::Data, "data.pole_pairs", text).hint(in_hertz())
        })
    }

    /// Refused if the setpoint is ignored with what the drive works with, or will in this run.
    fn is_obeyed(wanted: &Wanted, own: Own) -> Result<(), Failure> {
        let Some(source) = wanted.mode.source.as_ref().filter(|source| own.source == Some(source.ignored)) else {
            return Ok(());
        };
        let ways = source.choices.iter().map(|row| Text::name(format_args!("--source {} ({})", row.slug, row.value)));
        let ways = ways.reduce(|all, way| both!("{all} or {way}", "{all} oder {way}", all, way));
        let hint = both!(
            "{ways} sets it in RAM for the run",
            "{ways} stellt es für den Lauf im RAM um",
            ways = ways.unwrap_or_default()
        );
        Err(Failure::new(Class::Forbidden, "forbidden.ramp_setpoint", source.why.clone()).hint(hint))
    }

    /// What the drive adds by itself; told, because it turns the shaft too. `None` if that is not known.
    async fn added(&mut self, wanted: &Wanted, own: Own) -> Result<Option<i64>, Failure> {
        let Some(adds) = wanted.mode.adds.filter(|adds| adds.source.is_none_or(|with| own.source == Some(with))) else {
            // Who chooses between sources must say which; who has nothing to choose adds nothing.
            return Ok((wanted.mode.source.is_none() || own.source.is_some()).then_some(0));
        };
        let family = self.target.family.clone();
        let (shows, by) = (family.param_or_unknown(adds.param), family.param_or_unknown(adds.by));
        let Some(value) = own.adds else { return Ok(None) };
        if value != 0 && wanted.keys.is_some() {
            return Err(added_to_keys(&wanted.shown(value, &family), &shows.label()));
        }
        if value != 0 {
            let selected = working(self.session, self.target, &by).await?;
            let text = self.told_addition(wanted, adds, (&shows, value), (&by, selected));
            self.session.tell(Event::Note(text));
        }
        Ok(Some(value).filter(|_| !adds.sum))
    }

    fn told_addition(
        &self,
        wanted: &Wanted,
        adds: Adds,
        (shows, value): (&Param, i64),
        (by, selected): (&Param, Option<i64>),
    ) -> Text {
        let family = &self.target.family;
        let (own, label) = (wanted.shown(value, family), shows.label());
        let by = format!("{} = {}", by.label(), selected.map_or_else(|| "?".to_owned(), |raw| raw.to_string()));
        if adds.sum {
            return both!(
                "the drive adds what {by} selects; {label} shows {own} now, before this setpoint",
                "der Antrieb addiert, was {by} wählt; {label} zeigt jetzt {own}, vor diesem Sollwert",
                own
            );
        }
        let last = wanted.schedule.at(u64::MAX);
        let sum = last.checked_add(value).map_or_else(|| Text::name("?"), |sum| wanted.shown(sum, family));
        let source = wanted.mode.source.as_ref();
        let without = source.and_then(|source| source.choices.iter().find(|row| Some(row.value) != adds.source));
        let way = without.map_or_else(Text::default, |row| {
            both!("; --source {slug} leaves it out", "; --source {slug} lässt ihn weg", slug = row.slug)
        });
        both!(
            "{sum}: {own} internal setpoint are added ({label}, {by}){way}",
            "{sum}: {own} interner Sollwert kommen dazu ({label}, {by}){way}",
            sum,
            own,
            way
        )
    }

    /// The bound of the setpoint, if there is one; refused beyond it, with what the drive adds.
    pub(super) fn limit(&self, wanted: &Wanted, own: Own, added: i64) -> Result<Option<i64>, Failure> {
        let Some((id, limit)) = wanted.mode.limit.zip(own.limit) else { return Ok(None) };
        let sums = wanted.values().map(|raw| raw.saturating_add(added));
        let peak = sums.max_by_key(|sum| sum.unsigned_abs()).unwrap_or(0);
        let param = self.target.family.param_or_unknown(id);
        // What only takes motion away is not refused.
        if self.args.force || wanted.values().all(|raw| raw == 0) || i128::from(peak).abs() <= i128::from(limit) {
            return Ok(Some(limit));
        }
        let family = &self.target.family;
        let text = both!(
            "{peak} is above the limit {label} = {limit} ({name})",
            "{peak} liegt über der Grenze {label} = {limit} ({name})",
            peak = wanted.shown(peak, family),
            label = param.label(),
            limit = wanted.shown(limit, family),
            name = param.name
        );
        let hint = both!("--force sends it; the drive limits it", "--force sendet ihn; der Antrieb begrenzt ihn");
        Err(Failure::new(Class::Data, "data.range", text).hint(hint))
    }

    /// The least setpoint, if the drive lifts one to it; told.
    fn floor(&mut self, wanted: &Wanted, own: Own) -> Option<i64> {
        let (floor, least) = wanted.mode.floor.as_ref().zip(own.least.filter(|&least| least > 0))?;
        let lifted = self.ends_at_zero() || wanted.values().any(|raw| raw.saturating_abs() < least);
        if lifted {
            let least = wanted.shown(least, &self.target.family);
            let why = Text::by(|lang| floor.why.get(lang).replace("{}", least.get(lang)));
            self.session.tell(Event::Note(why));
        }
        lifted.then_some(least)
    }

    /// Whether a setpoint of 0 is all that ends the run, because others start and stop the drive.
    fn ends_at_zero(&self) -> bool {
        let motion = &self.args.motion;
        let enables = self.args.enable || self.args.jog.is_some();
        let is_bounded = motion.ends_in_a_stop();
        is_bounded && !(enables || self.before.obeys(&self.target.family))
    }
}

fn too_large(wanted: &Wanted, family: &Family) -> Failure {
    let text = both!(
        "{value} is more than any drive can be told",
        "{value} ist mehr, als ein Antrieb gesagt bekommen kann",
        value = wanted.shown(wanted.schedule.peak(), family)
    );
    Failure::new(Class::Data, "data.range", text).with("param", wanted.param.id)
}

/// Where the drive adds something, the bounds of the arrows are not those of the shaft: a step up could turn it the other way.
fn added_to_keys(own: &Text, label: &str) -> Failure {
    let text = both!(
        "the arrows cannot lead this setpoint: the drive adds {own} ({label}), so that --min and --max would not hold for the \
         shaft",
        "die Pfeile können diesen Sollwert nicht führen: der Antrieb addiert {own} ({label}), --min und --max gälten nicht \
         für die Welle",
        own
    );
    Failure::new(Class::Data, "data.keys", text).hint(both!(
        "--source line leaves it out; or run without --step",
        "--source line lässt ihn weg; oder ohne --step fahren"
    ))
}
