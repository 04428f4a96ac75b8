//! Stops that came about in another way than they were given: the drive lost its power, its mode or its setpoint meanwhile, or its power
//! sooner than its shaft was seen to stand.

use super::super::Motor;
use super::super::before::elsewhere;
use super::super::own::shown;
use super::super::shaft::{DISOBEYED, Trend};
use crate::failure::Failure;
use crate::outcome::State;
use crate::profile::{Mode, Param, StopRow};
use crate::text::{Text, both};
use crate::tick::Span;

/// So many answers to a stop may be doubted on any line.
const DOUBTS: u64 = 3;
/// A stop is not said sooner again than so.
const INSISTS: Span = Span::from_millis(250);
/// So often a stop is said again before a stronger one follows.
const MOST: u8 = 4;
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

    /// Says a stop once more to a drive that has become faster under it: somebody else writes to it. From time to time only; one that does
    /// not become slower by that is not stopped by it.
    pub(in super::super) async fn insist(&mut self, trend: Trend) -> Result<(), Failure> {
        let Some(since) = trend.rises else {
            if trend.lasts >= DISOBEYED && self.session.now().since(self.fed) >= DISOBEYED {
                // It may not have heard it, or somebody else was heard behind it.
                self.say_stop_again().await?;
            }
            return Ok(());
        };
        // A setpoint of 0 may be lifted by the drive itself, and whoever asked for nothing more is told what comes of it.
        let may_lift = |(param, _): &(Param, i64)| self.zeroes != Some(param.id) && !self.is_control_word(param);
        if (since >= DISOBEYED || self.insisted >= MOST) && self.says_stop().is_some_and(|said| !may_lift(&said)) {
            self.insisted = 0;
            let state = self.state().await?;
            return Err(self.still_turning(&state));
        }
        let Some((param, raw)) = self.say_stop_again().await? else { return Ok(()) };
        let label = param.label();
        let faster = both!(
            "the drive became faster while it was to stop, by somebody else or a setting of its own; {label} = {raw} went out again",
            "der Antrieb wurde schneller, während er anhalten sollte, durch jemand anderen oder eine eigene Einstellung; {label} = {raw} \
             ging nochmals hinaus"
        );
        self.insisted = self.insisted.saturating_add(1);
        self.note_once(faster);
        // What was seen of it before that is no proof any more.
        self.state().await.map(|_| ())
    }

    /// What was written last, where that is a stop.
    fn says_stop(&self) -> Option<(Param, i64)> {
        let (param, raw) = self.again.clone().filter(|_| self.stopping)?;
        let stops = if self.is_control_word(&param) { !self.enables(raw) } else { raw == 0 };
        stops.then_some((param, raw))
    }

    /// Says a stop once more, unless that was done a moment ago; what went out.
    pub(in super::super) async fn say_stop_again(&mut self) -> Result<Option<(Param, i64)>, Failure> {
        let Some((param, raw)) = self.says_stop().filter(|_| self.session.now().since(self.fed) >= INSISTS) else {
            return Ok(None);
        };
        self.write_again(&param, raw).await?;
        Ok(Some((param, raw)))
    }

    /// A setpoint of 0 stops nothing in another mode than its own, which somebody else may have chosen meanwhile.
    pub(in super::super) async fn mind_mode(&mut self) -> Result<(), Failure> {
        let mode = self.mode.as_ref().filter(|mode| self.entered && mode.zero_stops());
        let Some(value) = mode.and_then(|mode| mode.value) else { return Ok(()) };
        let is_zero = self.again.as_ref().is_some_and(|(param, raw)| *raw == 0 && Some(param.id) == self.zeroes);
        if !is_zero || self.mode_shown().await.0.is_none_or(|told| told == value) {
            return Ok(());
        }
        let state = self.state().await?;
        Err(self.still_turning(&state))
    }

    /// A ramp that ends in a state out of which a drive comes up again was ended by its power.
    pub(super) fn notes_lost_power(&mut self, row: &StopRow, state: &State) {
        let is_anew = row.goal != state.slug && ANEW.contains(&&*state.slug);
        let unbidden = self.had_power && row.slug == "ramp" && is_anew && !self.said_quick_stop;
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
