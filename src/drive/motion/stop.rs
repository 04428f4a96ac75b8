//! The stop at the end of a run, and giving back what was changed for it.

use super::look::ram_set;
use super::{Lever, Motor, POLL, REMOTE_BIT};
use crate::drive::describe;
use crate::failure::{Class, Failure};
use crate::outcome::{Change, State, Stop};
use crate::profile::{DataSets, Lang, Takes};

/// Control by digital inputs (P.412 = 0; CM-485 manual 9).
const CONTACTS: i64 = 0;
/// How long the stop at the end is tried on a line that does not answer.
const STOP_TRIES: u8 = 5;

/// How a run is stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StopChoice {
    /// Disable operation: transition 5, by P.392.
    Ramp,
    /// Quick stop.
    QuickStop,
    /// Disable voltage.
    Coast,
    /// Not at all.
    Keep,
}

impl StopChoice {
    /// Name, command and the state that proves it.
    fn row(self) -> (&'static str, &'static str, &'static str) {
        match self {
            StopChoice::Ramp => ("ramp", "disable", "switched-on"),
            StopChoice::QuickStop => ("quick-stop", "quick-stop", "switch-on-disabled"),
            StopChoice::Coast => ("coast", "disable-voltage", "switch-on-disabled"),
            StopChoice::Keep => ("keep", "", ""),
        }
    }
}

impl Motor<'_, '_> {
    /// Changes a setting for the run, in RAM of the data set that the drive works with; it is given back at the end.
    pub async fn change(&mut self, role: &str, new: i64) -> Result<(), Failure> {
        let Some(param) = self.target.family.role(role).cloned() else { return Ok(()) };
        let set = ram_set(self.session, self.target, &param, self.lang).await?;
        let reading = self.target.read_set(self.session, &param, set).await;
        let old = reading.map_err(|error| self.failure(&error))?.raw;
        if old == new {
            return Ok(());
        }
        let (data_set, _) = describe::place(set);
        self.changes.push(Change { param: param.id, data_set, old, new, restored: false });
        self.write(&param, set, new).await
    }

    /// Gives back what was changed; settings that decide whether the drive still obeys only once it stands.
    pub(super) async fn give_back(&mut self, stands: bool) {
        if stands && self.setpoint.as_ref().is_some_and(|setpoint| setpoint.value.raw != 0) {
            let param = self.setpoint.as_ref().and_then(|setpoint| self.target.family.param(setpoint.param).cloned());
            if let Some(param) = param {
                // So that nobody is surprised by it at the next enable.
                let _best_effort = self.write(&param, 0, 0).await;
            }
        }
        if !stands {
            return;
        }
        for index in (0..self.changes.len()).rev() {
            let Some(change) = self.changes.get(index).cloned() else { continue };
            let param = self.target.family.param_or_unknown(change.param);
            if self.target.family.role("control-mode").is_some_and(|mode| mode.id == param.id)
                && !self.may_give_control_back(change.old).await
            {
                continue;
            }
            let mut restored = false;
            for _ in 0..STOP_TRIES {
                restored =
                    restored || self.write(&param, change.data_set + DataSets::RAM_OFFSET, change.old).await.is_ok();
            }
            if let Some(change) = self.changes.get_mut(index) {
                change.restored = restored;
            }
        }
    }

    /// Whether the drive stays where it is when P.412 goes back. The control word of the stop would close contacts under
    /// P.412 = 2, so it is cleared first; and contacts that are closed now would start the drive under P.412 = 0.
    pub(super) async fn may_give_control_back(&mut self, old: i64) -> bool {
        if self.write_control(0).await.is_err() {
            return false;
        }
        let Ok(status) = self.status().await else { return false };
        if old != CONTACTS || status & REMOTE_BIT == 0 {
            return true;
        }
        let note = self.lang.pick(
            "P.412 stays 1: enable and start contact are closed and would start the drive under P.412 = 0",
            "P.412 bleibt 1: Freigabe und Startkontakt sind geschlossen und würden den Antrieb unter P.412 = 0 starten",
        );
        self.notes.push(note.to_owned());
        false
    }

    /// Sends the stop and waits for the state that proves it. Never fails: it reports.
    pub(super) async fn stop(&mut self, choice: StopChoice, because: &'static str) -> Stop {
        let (name, command, goal) = choice.row();
        let mut stop = Stop { choice: name, because, acknowledged: false, state: None, note: None };
        if choice == StopChoice::Keep {
            stop.note = Some(
                self.lang
                    .pick("the drive keeps running, as asked for", "der Antrieb läuft weiter, wie verlangt")
                    .to_owned(),
            );
            return stop;
        }
        let word = match self.lever {
            Lever::ControlWord => self.target.family.machine.command(command).map_or(0, |command| command.word),
            Lever::Contacts | Lever::Setpoint => 0,
        };
        let goal = if self.lever == Lever::ControlWord { goal } else { "switched-on" };
        for _ in 0..STOP_TRIES {
            let sent = match (self.lever, self.setpoint.as_ref().map(|setpoint| setpoint.param)) {
                (Lever::Setpoint, Some(param)) => {
                    let param = self.target.family.param_or_unknown(param);
                    self.write(&param, 0, 0).await
                }
                _ => self.write_control(word).await,
            };
            if sent.is_err() {
                continue;
            }
            let stopped = match self.lever {
                Lever::Setpoint => self.until_still().await,
                Lever::ControlWord | Lever::Contacts => self.until_stopped(goal).await,
            };
            match stopped {
                Ok(state) => {
                    stop.acknowledged = true;
                    stop.state = Some(state);
                    return stop;
                }
                Err(failure) if failure.class == Class::Port => break,
                Err(_) => {}
            }
        }
        if let (Ok(status), true) = (self.status().await, self.lever != Lever::Setpoint) {
            let state = describe::state(&self.target.family, status, self.lang);
            stop.acknowledged = stopped_states(goal).contains(&state.slug.as_str());
            stop.state = Some(state);
        }
        if !stop.acknowledged {
            stop.note = Some(self.watchdog_note().await);
        }
        stop
    }

    /// A drive that tripped, or that lies in a state below the goal, does not turn either.
    pub(super) async fn until_stopped(&mut self, goal: &str) -> Result<State, Failure> {
        let status = self.status().await?;
        let state = describe::state(&self.target.family, status, self.lang);
        if stopped_states(goal).contains(&state.slug.as_str()) {
            return Ok(state);
        }
        let takes = if goal == "switched-on" { Takes::Transition5 } else { Takes::QuickStop };
        self.until(goal, Some(takes), true).await
    }

    /// Waits until the shaft stands; patience begins anew while it still slows down.
    pub(super) async fn until_still(&mut self) -> Result<State, Failure> {
        let mut seen = None;
        let mut since = self.session.now();
        loop {
            let status = self.status().await?;
            let state = describe::state(&self.target.family, status, self.lang);
            let speed = self.speed().await?;
            if speed == Some(0) || state.slug != "operation-enabled" {
                return Ok(state);
            }
            if seen != Some(speed) {
                seen = Some(speed);
                since = self.session.now();
            }
            if self.session.now().since(since) > self.patience {
                return Err(self.stuck(&state, "switched-on").await);
            }
            self.rest(POLL).await?;
        }
    }

    pub(super) async fn watchdog_note(&mut self) -> String {
        let changed = self.target.family.role("watchdog").map(|param| param.id);
        let set = self.changes.iter().find(|change| Some(change.param) == changed).map(|change| change.new);
        let seconds = match set {
            Some(seconds) => Some(seconds),
            None => self.role_raw("watchdog").await.ok().flatten().or(self.target.known_watchdog),
        };
        match (seconds, self.lang) {
            (Some(0), Lang::En) => "the drive's watchdog (P.413) is off: THE SHAFT MAY STILL TURN".to_owned(),
            (Some(0), Lang::De) => "der Watchdog (P.413) ist aus: DIE WELLE KANN NOCH DREHEN".to_owned(),
            (Some(s), Lang::En) => format!("the drive's watchdog (P.413) trips it {s} s after the last telegram"),
            (Some(s), Lang::De) => format!("der Watchdog (P.413) schaltet {s} s nach dem letzten Telegramm ab"),
            (None, Lang::En) => {
                "whether the drive's watchdog stops it is not known: THE SHAFT MAY STILL TURN".to_owned()
            }
            (None, Lang::De) => "ob der Watchdog abschaltet, ist unbekannt: DIE WELLE KANN NOCH DREHEN".to_owned(),
        }
    }
}

/// States in which a stop that leads to `goal` has done its work.
fn stopped_states(goal: &str) -> &'static [&'static str] {
    match goal {
        "switched-on" => &["switched-on", "ready-to-switch-on", "switch-on-disabled", "fault", "not-ready"],
        _ => &["switch-on-disabled", "ready-to-switch-on", "switched-on", "fault", "not-ready"],
    }
}
