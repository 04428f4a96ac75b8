//! What is changed for a run, and giving it back.

use super::look::{raw, read_working};
use super::own::shown;
use super::watchdog::guard;
use super::{Lever, Motor, StopChoice, has_power};
use crate::drive::describe;
use crate::drive::session::Session;
use crate::drive::target::Target;
use crate::failure::{Class, Failure};
use crate::outcome::{Change, Stop};
use crate::profile::{DataSets, Family, Param};
use crate::text::{Text, both};
use std::fmt;

/// What keeps a change that is about to be made, so that it can be given back by whoever comes when this program is gone.
#[derive(Clone, Copy)]
pub struct Keeps<'k>(pub &'k dyn Fn(&Change) -> Result<(), Failure>);

impl fmt::Debug for Keeps<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Keeps")
    }
}

/// A refusal with the parameter that was refused.
fn named(failure: Failure, param: &Param) -> Failure {
    if failure.class != Class::Refused {
        return failure;
    }
    let label = param.label();
    failure.within(|why| both!("{label}: {why}", "{label}: {why}", why)).with("param", param.id)
}

/// How often it is tried.
const TRIES: u8 = 5;

/// The data set of a setting that is changed, and its place, as messages call it.
fn placed(family: &Family, param: &Param, set: u8) -> (u8, String) {
    let (data_set, _) = describe::place(set);
    (data_set, place_name(family, param, data_set))
}

/// A setting of a data set in RAM, as messages call it.
pub fn place_name(family: &Family, param: &Param, data_set: u8) -> String {
    match family.link.route.has_data_sets() {
        true => format!("{}@{data_set}ram", param.label()),
        false => param.label(),
    }
}

/// What [`Motor::change_param`] would change: place, value before and value then, with their units; `None` if it is so already.
pub async fn would_change(
    session: &mut Session<'_>,
    target: &mut Target,
    param: &Param,
    new: i64,
) -> Result<Option<(String, String, String)>, Failure> {
    let (set, reading) = read_working(session, target, param).await?;
    let old = reading.map_err(|error| error.failure(target.address, Some(&target.family)))?.raw;
    let (_, name) = placed(&target.family, param, set);
    Ok((old != new).then(|| (name, shown(param, old), shown(param, new))))
}

impl Motor<'_, '_> {
    /// Changes the setting with a role for the run, if the family has it; it is given back at the end.
    pub async fn change(&mut self, role: &str, new: i64) -> Result<(), Failure> {
        let Some(param) = self.target.family.role(role).cloned() else { return Ok(()) };
        self.change_param(&param, new).await?;
        if role == "watchdog" {
            self.guard = guard(self.target, Some(new));
        }
        Ok(())
    }

    /// Changes a setting for the run, in RAM of the data set that the drive works with; it is given back at the end.
    pub async fn change_param(&mut self, param: &Param, new: i64) -> Result<(), Failure> {
        let (set, reading) = read_working(self.session, self.target, param).await?;
        let old = reading.map_err(|error| self.failure(&error))?.raw;
        if old == new {
            return Ok(());
        }
        self.note_change(param, set, old, new)?;
        self.write(param, set, new).await.map_err(|failure| named(failure, param))
    }

    /// Changes a setting for the run, as often as need be, and reads it back; it is given back at the end, as it was first.
    pub async fn adjust(&mut self, param: &Param, new: i64) -> Result<(), Failure> {
        let (set, old) = self.bear(async |motor: &mut Self| motor.in_force(param).await).await?;
        if old == new {
            return Ok(());
        }
        match self.settled.contains(&(param.id, set)) {
            false => self.note_change(param, set, old, new)?,
            true => self.note_again(param, set, new)?,
        }
        self.write(param, set, new).await.map_err(|failure| named(failure, param))?;
        let (_, now) = self.bear(async |motor: &mut Self| motor.in_force(param).await).await?;
        if now == new {
            return Ok(());
        }
        let label = param.label();
        let text = both!(
            "{label} was to be {new} for the run, and the drive works with {now}",
            "{label} sollte für den Lauf {new} sein, der Antrieb arbeitet aber mit {now}"
        );
        Err(Failure::new(Class::Refused, "refused.reads_back_differently", text).with("param", param.id))
    }

    /// In which data set the drive works with a setting, and its value there.
    pub(super) async fn in_force(&mut self, param: &Param) -> Result<(u8, i64), Failure> {
        let (set, reading) = read_working(self.session, self.target, param).await?;
        Ok((set, reading.map_err(|error| self.failure(&error))?.raw))
    }

    /// What an actual value is now; 0 if the drive does not tell it.
    pub async fn told(&mut self, param: &Param) -> Result<i64, Failure> {
        self.raw(param).await.map(|raw| raw.unwrap_or(0))
    }

    /// Whether nothing is left of a write when the run is over: of a control word, of a setpoint that the end sets to 0, of
    /// taking away what stood there from before; nor is it to be otherwise of a setpoint that stays.
    pub(super) fn ends_with_the_run(&self, param: &Param, raw: i64) -> bool {
        let family = &self.target.family;
        let is_setpoint = self.setpoint.as_ref().is_some_and(|setpoint| setpoint.param == param.id);
        family.role("control-word").is_some_and(|word| word.id == param.id)
            || (is_setpoint && (!self.bounded || self.mode.as_ref().is_none_or(|mode| mode.zero)))
            || (raw == 0 && family.motion.rest.iter().any(|row| row.param == param.id))
    }

    /// Reads what a parameter is before the run writes it for the first time.
    pub(super) async fn remember(&mut self, param: &Param, set: u8, new: i64) -> Result<(), Failure> {
        self.remember_if(param, set, new, |_| true).await
    }

    /// The same; what is not `fit` to be given back stays.
    pub(super) async fn remember_if(
        &mut self,
        param: &Param,
        set: u8,
        new: i64,
        fit: impl Fn(i64) -> bool,
    ) -> Result<(), Failure> {
        if self.settled.contains(&(param.id, set)) {
            return self.note_again(param, set, new);
        }
        match raw(self.session, self.target, param, set).await? {
            Some(old) if old != new && fit(old) => self.note_change(param, set, old, new)?,
            // Written once more with another value it is another matter.
            Some(old) if old == new => {}
            _ => self.settled.push((param.id, set)),
        }
        Ok(())
    }

    /// Notes what a parameter was, also where that is to outlive this program, before it is written.
    pub(super) fn note_change(&mut self, param: &Param, set: u8, old: i64, new: i64) -> Result<(), Failure> {
        let (data_set, name) = placed(&self.target.family, param, set);
        let change = Change { param: param.id, name, data_set, old, new, restored: false };
        if let Some(Keeps(keep)) = self.keeps {
            keep(&change)?;
        }
        self.settled.push((param.id, set));
        self.changes.push(change);
        Ok(())
    }

    /// Notes what a parameter that was changed is changed to now, before it is written; not where it only becomes what it was.
    fn note_again(&mut self, param: &Param, set: u8, new: i64) -> Result<(), Failure> {
        let (data_set, _) = placed(&self.target.family, param, set);
        let mut rows: Vec<_> =
            self.changes.iter_mut().filter(|row| (row.param, row.data_set) == (param.id, data_set)).collect();
        let is_back = rows.iter().any(|row| row.old == new);
        let Some(row) = rows.pop().filter(|row| row.new != new && !is_back) else { return Ok(()) };
        row.new = new;
        let change = row.clone();
        self.keeps.map_or(Ok(()), |Keeps(keep)| keep(&change))
    }

    /// Whether what was changed goes back: not to a drive that still runs and may need it, but to one that is without power,
    /// or obeys somebody else.
    pub(super) fn may_give_back(&self, stop: Option<&Stop>) -> bool {
        let is_off = |stop: &Stop| stop.state.as_ref().is_some_and(|state| has_power(&state.slug) == Some(false));
        let ended =
            stop.is_none_or(|stop| stop.choice != StopChoice::Keep.slug() && (stop.acknowledged || is_off(stop)));
        ended || self.lever == Lever::Taken
    }

    /// Where a run went wrong: whether what it has set in RAM is gone, as behind a power failure.
    pub(super) async fn notes_restart(&mut self) {
        let undone = self.undone().await;
        self.notes.extend(undone);
    }

    /// That what the run has set in RAM is gone.
    pub(super) async fn undone(&mut self) -> Option<Text> {
        // A drive may end with the run by itself what makes a setpoint count.
        let family = self.target.family.clone();
        let stays = |change: &&Change| !family.motion.rest.iter().any(|row| row.param == change.param);
        let changed = self.changes.iter().filter(stays).find(|change| change.old != change.new);
        let change = changed.cloned()?;
        let param = family.param_or_unknown(change.param);
        let ram = if self.target.family.link.route.has_data_sets() { DataSets::RAM_OFFSET } else { 0 };
        let now = raw(self.session, self.target, &param, change.data_set + ram).await;
        now.is_ok_and(|now| now == Some(change.old)).then(|| {
            both!(
                "{name} is {old} again, which this run has not set back: the drive has restarted, or somebody else writes to it",
                "{name} ist wieder {old}, ohne dass dieser Lauf es zurückstellte: der Antrieb ist neu gestartet, oder jemand \
                 anderes schreibt",
                name = change.name,
                old = change.old
            )
        })
    }

    /// Gives back what was changed; settings that decide whether the drive still obeys only once it stands.
    pub(super) async fn give_back(&mut self, may: bool) {
        if !may {
            return;
        }
        let zeroed = self.mode.as_ref().is_none_or(|mode| mode.zero);
        if zeroed && self.setpoint.as_ref().is_some_and(|setpoint| setpoint.value.raw != 0) {
            let param = self.setpoint.as_ref().and_then(|setpoint| self.target.family.param(setpoint.param).cloned());
            if let Some(param) = param {
                // So that nobody is surprised by it at the next enable.
                if !self.set_back(&param, 0, 0).await {
                    self.notes.push(both!(
                        "{label} may still stand in the drive; it could not be set to 0",
                        "{label} steht vielleicht noch im Antrieb; 0 war nicht zu schreiben",
                        label = param.label()
                    ));
                }
            }
        }
        for index in (0..self.changes.len()).rev() {
            let Some(change) = self.changes.get(index).cloned() else { continue };
            let param = self.target.family.param_or_unknown(change.param);
            if self.target.family.role("control-mode").is_some_and(|mode| mode.id == param.id)
                && !self.may_give_control_back(&change).await
            {
                continue;
            }
            let ram = if self.target.family.link.route.has_data_sets() { DataSets::RAM_OFFSET } else { 0 };
            let restored = self.set_back(&param, change.data_set + ram, change.old).await;
            if let Some(change) = self.changes.get_mut(index) {
                change.restored = restored;
            }
        }
        // What fed the watchdog in the run would bring back what it was.
        self.again = None;
    }

    /// Whether a value stands there again, as often as it takes within reason: the line may be silent for a moment.
    async fn set_back(&mut self, param: &Param, set: u8, raw: i64) -> bool {
        for _ in 0..TRIES {
            if self.write(param, set, raw).await.is_ok() {
                return true;
            }
        }
        false
    }
}
