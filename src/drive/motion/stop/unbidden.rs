//! Stops that came about in another way than they were given: the drive lost its power, its mode or its setpoint meanwhile, or its power
//! sooner than its shaft was seen to stand.

use super::super::Motor;
use super::super::before::elsewhere;
use super::super::own::shown;
use super::super::shaft::Trend;
use crate::failure::{Class, Failure};
use crate::outcome::State;
use crate::profile::{Mode, StopRow};
use crate::text::{Text, both};
use crate::tick::Span;

/// So many answers to a stop may be doubted on any line.
const DOUBTS: u64 = 3;
/// A stop is not said sooner again than so.
const INSISTS: Span = Span::from_millis(250);
/// States from which a drive comes up again: no ramp ends there.
const ANEW: &[&str] = &["not-ready", "switch-on-disabled"];

impl Motor<'_, '_> {
    /// A drive that had a mode and shows none that there is has restarted: its shaft coasted, whatever went out behind that.
    pub(super) fn shows_no_mode(&self, told: i64) -> Option<Text> {
        self.mode.as_ref().filter(|mode| self.entered && mode.zero_stops())?;
        let family = &self.target.family;
        if family.modes.iter().any(|mode| mode.value == Some(told)) {
            return None;
        }
        let label = family.role_label("mode-active");
        Some(both!(
            "the drive had lost its mode of operation ({label} = {told}), as behind a restart: a quick stop was sent in place of \
             the ramp, and the shaft may have coasted before",
            "der Antrieb hatte seine Betriebsart verloren ({label} = {told}), wie nach einem Neustart: gesendet wurde ein \
             Schnellhalt statt der Rampe, und die Welle lief vorher vielleicht aus"
        ))
    }

    /// That the setpoint of the mode that the drive shows does not count, because it takes another one from elsewhere: a 0 would stop
    /// nothing. Asked once; what is not told keeps no stop back.
    pub(super) async fn follows_another(&mut self, mode: &Mode) -> Option<Text> {
        let retries = self.session.set_retries(0);
        let other = elsewhere(self.session, self.target, mode).await;
        self.session.set_retries(retries);
        let (param, now) = other.ok().flatten()?;
        Some(both!(
            "{label} is {now}, so that a setpoint of 0 stops nothing: a quick stop was sent in place of the ramp",
            "{label} ist {now}, ein Sollwert 0 hält also nichts an: gesendet wurde ein Schnellhalt statt der Rampe",
            label = param.label()
        ))
    }

    /// Says a stop once more to a drive that has become faster under it: somebody else writes to it. From time to time only; whether it
    /// stands is what the looks tell.
    pub(in super::super) async fn insist(&mut self, trend: Trend) -> Result<(), Failure> {
        let Some((param, raw)) = self.again.clone().filter(|_| trend.rises) else { return Ok(()) };
        let is_word = self.target.family.role("control-word").is_some_and(|word| word.id == param.id);
        let stops = if is_word { !self.enables(raw) } else { raw == 0 };
        if !stops || self.session.now().since(self.fed) < INSISTS {
            return Ok(());
        }
        let label = param.label();
        let faster = both!(
            "the drive became faster while it was to stop: somebody else writes to it; {label} = {raw} went out again",
            "der Antrieb wurde schneller, während er anhalten sollte: jemand anderes schreibt ihm; {label} = {raw} ging nochmals hinaus"
        );
        if !self.notes.contains(&faster) {
            self.notes.push(faster);
        }
        match self.write_once(&param, 0, raw).await {
            Err(failure) if matches!(failure.class, Class::Port | Class::Interrupted) => Err(failure),
            _ => Ok(()),
        }
    }

    /// A ramp that ends in a state out of which a drive comes up again was ended by its power.
    pub(super) fn notes_lost_power(&mut self, row: &StopRow, state: &State) {
        let unbidden = self.had_power && row.slug == "ramp" && row.goal != state.slug && ANEW.contains(&&*state.slug);
        if unbidden && self.instead.is_none() {
            self.instead = Some(both!(
                "the drive lost its power during the ramp, so the shaft coasted: it is in '{state}'",
                "der Antrieb verlor während der Rampe seinen Strom, die Welle lief also aus: er ist in '{state}'",
                state = state.name
            ));
        }
    }

    /// What was seen last of a shaft that was about to stand as its power went: half a unit at most. Nobody saw it stand. Where answers
    /// were doubted again and again another drive may have given them.
    pub fn crept(&self) -> Option<Text> {
        if self.session.tally().fences > self.doubts + DOUBTS {
            return None;
        }
        let param = self.target.family.role("movement")?;
        let raw = self.sight.crept(10i64.pow(param.decimals_or_zero().into()) / 2)?;
        let last = shown(param, raw);
        Some(both!(
            "last seen at {last}, with power; whether it stands was not seen",
            "zuletzt mit {last} gesehen, unter Strom; ob sie steht, wurde nicht gesehen"
        ))
    }
}
