//! Does the shaft stand? What proves it, with the drive's power on or off, and what is said where nothing does.

use super::Motor;
use super::look::working;
use super::patience::{FEW, Wait};
use super::shaft::{DISOBEYED, Watch};
use crate::failure::{Class, Failure};
use crate::gate::Relief;
use crate::outcome::{Event, State};
use crate::profile::{Blind, Param};
use crate::text::{Text, both};
use crate::tick::Span;
pub(super) use sight::Sight;

mod sight;

/// States without power: a stop has done its work.
pub(super) const STOPPED: &[&str] = &["switched-on", "switch-on-disabled", "ready-to-switch-on", "fault", "not-ready"];
/// The state of a quick stop.
pub const QUICK_STOP: &str = "quick-stop-active";
/// The state of a drive that works.
pub const OPERATION: &str = "operation-enabled";
/// States with power. Of a reaction to a fault nobody knows.
const POWERED: &[&str] = &[OPERATION, QUICK_STOP];

/// A shaft that was to stand, and does not become slower.
pub(super) const STILL_TURNING: &str = "forbidden.still_turning";

/// How long a shaft is watched that coasts as asked for.
const COASTING: Span = Span::from_secs(30);

/// Whether the drive has power in this state; `None` where that is not known.
pub fn has_power(slug: &str) -> Option<bool> {
    POWERED.contains(&slug).then_some(true).or_else(|| STOPPED.contains(&slug).then_some(false))
}

impl Motor<'_, '_> {
    /// Whether nobody gave the drive power at any look, us included. Its shaft may coast from before all the same.
    pub fn is_idle(&self) -> bool {
        !self.powered && !self.shouted
    }

    /// Whether the state that was seen last is one without power.
    pub(super) fn shows_no_power(&self) -> bool {
        self.seen.as_deref().and_then(has_power) == Some(false)
    }

    /// Notes what a state says of the power.
    pub(super) fn see(&mut self, slug: &str) {
        let on = has_power(slug);
        self.powered |= on == Some(true);
        self.works = slug == OPERATION;
        // Nor does anybody come into operation behind "disable" by what stands in the control word then.
        if slug == QUICK_STOP || (self.works && self.commands(Relief::Disable)) {
            self.sight.brakes();
        }
        self.sight.state(on);
    }

    /// Whether the shaft stands: waits for it as long as it still slows down. `None` if the drive does not tell.
    pub(super) async fn standstill(&mut self) -> Result<Option<bool>, Failure> {
        let wait = self.wait();
        self.standstill_within(wait).await
    }

    /// A shaft that coasts is waited for as well, but not for ever, and that is said: what was changed goes back afterwards.
    pub(super) async fn coasts_out(&mut self) -> Result<Option<bool>, Failure> {
        let now = self.stands_now().await?;
        if now != Some(false) {
            return Ok(now);
        }
        self.session.tell(Event::Note(both!(
            "without power; the shaft is watched until it stands, at most {COASTING}; Ctrl-C ends that",
            "ohne Strom; die Welle wird bis zum Stillstand beobachtet, höchstens {COASTING}; Strg-C beendet das"
        )));
        let wait = self.wait().at_most(COASTING);
        self.standstill_within(wait).await
    }

    async fn standstill_within(&mut self, wait: Wait) -> Result<Option<bool>, Failure> {
        let still = self.watched(wait).await?;
        self.still = Some(still);
        Ok(still)
    }

    async fn watched(&mut self, mut wait: Wait) -> Result<Option<bool>, Failure> {
        let mut watch = Watch::new(self.target.family.motion.movement);
        let (mut looks, mut minded) = (0u8, false);
        loop {
            let Some(raw) = self.look_at_shaft().await? else { return Ok(None) };
            looks = looks.saturating_add(1);
            let trend = watch.see(self.session.now(), Some(raw));
            self.insist(trend).await?;
            if trend.lasts >= DISOBEYED && !std::mem::replace(&mut minded, true) {
                self.mind_mode().await?;
            }
            if trend.slows {
                wait.renew(self.session.now());
                if looks > FEW {
                    self.takes_time(Span::ZERO);
                }
            }
            let stands = self.stands(&watch);
            if stands != Some(false) || wait.is_over(self.session.now()) {
                return Ok(stands);
            }
            self.rest(self.beat()).await?;
        }
    }

    /// Whether the shaft stands now; `None` if the drive does not tell.
    pub(super) async fn stands_now(&mut self) -> Result<Option<bool>, Failure> {
        let mut watch = Watch::new(self.target.family.motion.movement);
        loop {
            let Some(raw) = self.look_at_shaft().await? else { return Ok(None) };
            let trend = watch.see(self.session.now(), Some(raw));
            self.insist(trend).await?;
            if watch.tells() {
                return Ok(self.stands(&watch));
            }
            self.rest(self.beat()).await?;
        }
    }

    /// Whether nothing was said to the drive behind the proof that its shaft stands: the word that takes the power, as control goes back,
    /// may take it from a shaft that somebody else turns again.
    pub fn stays_still(&self) -> bool {
        self.still == Some(Some(true))
    }

    /// Whether the shaft stands as the program leaves; `None` if the drive does not tell. A standstill that was
    /// proven of a drive without power stays proven.
    pub async fn stands_at_the_end(&mut self) -> Result<Option<bool>, Failure> {
        match self.still {
            Some(still) if self.is_off() && still != Some(false) => Ok(still),
            _ => match self.through_others(async |motor: &mut Self| motor.stands_now().await).await {
                // What was seen to stand stands, also where a later answer is lost.
                Err(_) if self.is_off() && !self.sight.by_setting => Ok(self.sight.standing().filter(|stands| *stands)),
                stands => stands.map_err(|lost| lost.failure),
            },
        }
    }

    /// Waits until the shaft stands, with the drive's power on or not.
    pub(super) async fn until_still(&mut self) -> Result<State, Failure> {
        let still = self.standstill().await?;
        let state = self.state().await?;
        match still {
            Some(false) => Err(self.still_turning(&state)),
            _ => Ok(state),
        }
    }

    /// The failure to show where the shaft does not come to rest.
    pub(super) fn still_turning(&self, state: &State) -> Failure {
        let text = both!(
            "the shaft does not come to rest; state: {state}",
            "die Welle kommt nicht zum Stillstand; Zustand: {state}",
            state = state.name
        );
        Failure::new(Class::Forbidden, STILL_TURNING, text)
    }

    fn stands(&self, watch: &Watch) -> Option<bool> {
        match self.target.family.motion.stator {
            Some(_) => self.sight.standing(),
            None => Some(watch.stands()),
        }
    }

    /// What the last looks showed, where no other can be waited for; a shaft whose position was watched still turned.
    pub(super) fn last_seen(&self) -> Option<bool> {
        if self.target.family.motion.stator.is_some() { self.sight.standing() } else { Some(false) }
    }

    /// Looks at the shaft, and as often at the state as it takes to know whether that was under power.
    async fn look_at_shaft(&mut self) -> Result<Option<i64>, Failure> {
        if self.target.family.motion.stator.is_none() {
            return self.movement().await;
        }
        if self.sight.on != Some(false) {
            self.state().await?;
        }
        let mut raw = self.shaft().await?;
        if self.sight.zero {
            self.state().await?;
            if self.sight.on == Some(false) {
                raw = self.shaft().await?;
            }
        }
        self.doubt().await?;
        Ok(raw)
    }

    /// What tells of the shaft: without power also an encoder.
    pub(super) async fn shaft(&mut self) -> Result<Option<i64>, Failure> {
        let Some(raw) = self.movement().await? else { return Ok(None) };
        if self.target.family.motion.stator.is_none() {
            return Ok(Some(raw));
        }
        let raw = match (raw, self.sight.on) {
            (0, Some(false)) => self.encoder().await?.unwrap_or(0),
            (raw, Some(true)) if raw != 0 && self.encoder.is_none() && !self.first_word.is_late => {
                // One that turns is there, so that it tells later on; a slow drive would stand for less time than that takes.
                self.sight.free |= self.encoder().await?.is_some_and(|shown| shown != 0);
                raw
            }
            (raw, _) => raw,
        };
        self.sight.frequency(raw);
        Ok(Some(raw))
    }

    /// What an encoder shows; which one is found out once.
    async fn encoder(&mut self) -> Result<Option<i64>, Failure> {
        let family = self.target.family.clone();
        let roles = family.motion.stator.iter().flat_map(|stator| &stator.encoders);
        let candidates: Vec<Param> = match &self.encoder {
            Some(known) => known.iter().cloned().collect(),
            None => roles.filter_map(|role| family.role(role)).cloned().collect(),
        };
        for param in candidates {
            let shown = self.bear(async |motor: &mut Self| motor.raw(&param).await).await?;
            if shown.is_some() {
                self.encoder = Some(Some(param));
                return Ok(shown);
            }
        }
        self.encoder = Some(None);
        Ok(None)
    }

    /// Direct current takes the frequency of the stator away, not the speed of the shaft.
    async fn doubt(&mut self) -> Result<(), Failure> {
        if self.sight.held && self.sight.by_setting {
            self.sight.held = self.ending().await?.is_none_or(|row| row.coasts);
            self.sight.settled = true;
        }
        Ok(())
    }

    /// The way in which the drive is set to end a ramp stop, if it is one that its frequency does not show.
    async fn ending(&mut self) -> Result<Option<Blind>, Failure> {
        if let Some(known) = &self.ending {
            return Ok(known.clone());
        }
        let family = self.target.family.clone();
        let Some(stator) = &family.motion.stator else { return Ok(None) };
        let Some(setting) = family.role(stator.ends) else { return Ok(None) };
        let ask = async |motor: &mut Self| working(motor.session, motor.target, setting).await;
        let value = self.bear(ask).await?;
        let ending = stator.blind.iter().find(|row| Some(row.value) == value).cloned();
        self.ending = Some(ending.clone());
        Ok(ending)
    }

    /// Why nothing showed a standstill of a drive that was stopped.
    pub async fn why_unseen(&mut self) -> Unseen {
        let family = self.target.family.clone();
        let Some(stator) = &family.motion.stator else {
            let why = both!("no answer told of its shaft", "keine Antwort sagte etwas von seiner Welle");
            return Unseen { why, as_set: false };
        };
        let ending = if self.sight.by_setting { self.ending().await.ok().flatten() } else { None };
        match ending {
            Some(row) if self.powered || row.coasts => Unseen { why: row.text(), as_set: row.coasts },
            _ if !self.powered => Unseen { why: never_powered(), as_set: false },
            _ => Unseen { why: stator.early.clone(), as_set: false },
        }
    }
}

/// What is said of the shaft of a drive that had no power at any look: it may coast from before.
pub(super) fn never_powered() -> Text {
    both!(
        "it had no power at any look, and without it nothing tells of its shaft, which may coast from before: look at it; \
         `disable-voltage` and `--on-exit coast` promise no standstill",
        "er war bei jedem Blick ohne Strom, und dann zeigt nichts, ob seine Welle von vorher ausläuft: selbst hinsehen; \
         `disable-voltage` und `--on-exit coast` versprechen keinen Stillstand"
    )
}

/// Why nothing showed a standstill.
#[derive(Clone, Debug)]
pub struct Unseen {
    /// In words, with what to do about it.
    pub why: Text,
    /// The drive is set to coast, so that whoever disables it was given what is set.
    pub as_set: bool,
}

/// What is said of a shaft without power.
pub fn coasting(standing: Option<bool>) -> Option<Text> {
    match standing {
        Some(true) => None,
        Some(false) => Some(both!(
            "without power, but the shaft still turns by itself",
            "ohne Strom, aber die Welle dreht noch von selbst"
        )),
        None => Some(both!(
            "without power: a shaft that was turning coasts; nothing tells when it stands",
            "ohne Strom: eine Welle, die drehte, läuft aus; nichts zeigt, wann sie steht"
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_state_tells_of_the_power() {
        for (slug, on) in [
            ("operation-enabled", Some(true)),
            ("quick-stop-active", Some(true)),
            ("fault-reaction-active", None),
            ("unknown", None),
            ("fault", Some(false)),
            ("switched-on", Some(false)),
            ("ready-to-switch-on", Some(false)),
            ("switch-on-disabled", Some(false)),
            ("not-ready", Some(false)),
        ] {
            assert_eq!(has_power(slug), on, "{slug}");
        }
    }

    #[test]
    fn what_is_said_of_a_shaft_without_power() {
        assert_eq!(coasting(Some(true)), None);
        assert!(coasting(Some(false)).is_some_and(|text| text.en.contains("still turns")));
        assert!(coasting(None).is_some_and(|text| text.de.contains("nichts zeigt")));
    }
}
