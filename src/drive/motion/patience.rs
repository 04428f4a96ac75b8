//! How long something may take: looks and their pauses, what a bad line may cost, and when waiting ends.

use super::shaft::Watch;
use super::{Motor, look};
use crate::failure::Failure;
use crate::outcome::State;
use crate::profile::Takes;
use crate::tick::{Span, Tick};

/// How long a state may take that needs no ramp, and how long a line without answers is borne where the drive has no
/// watchdog.
pub(super) const USUAL: Span = Span::from_secs(3);
/// What takes motion away ends 12 s after its word, so it is asked before that why nothing changes, however long somebody is ready to
/// wait: the drive may hold its shaft.
const UNCHANGED: Span = Span::from_secs(10);
/// Nothing is waited for longer, however evenly the shaft still changes, unless `--wait` itself is longer.
const LONGEST: Span = Span::from_secs(600);
/// How long the state is not looked at while the frequency of the stator falls.
const FALLING: Span = Span::from_secs(1);
/// Nor where it will be 0 so soon: on a slow line the look at the state would fall into the time that the 0 lasts.
const SHORTLY: Span = Span::from_secs(2);
/// After so many looks a shaft that becomes slower does so.
pub(super) const FEW: u8 = 3;
/// How often the state is looked at while waiting.
const POLL: Span = Span::from_millis(50);
/// A round of holding a run, in looks.
pub(super) const ROUND: u64 = 5;

/// A wait that begins anew while something still changes, but not for ever.
#[derive(Debug)]
pub(super) struct Wait {
    patience: Span,
    most: Span,
    begun: Tick,
    since: Tick,
}

impl Wait {
    pub(super) fn new(now: Tick, patience: Span) -> Self {
        Wait { patience, most: LONGEST.longer(patience), begun: now, since: now }
    }

    /// As a whole no longer than this.
    pub(super) fn at_most(self, most: Span) -> Self {
        Wait { most, ..self }
    }

    /// Something has changed.
    pub(super) fn renew(&mut self, now: Tick) {
        self.since = now;
    }

    /// It may take so much longer.
    pub(super) fn extend(&mut self, more: Span) {
        self.patience = self.patience + more;
        self.most = self.most.longer(self.patience);
    }

    pub(super) fn is_over(&self, now: Tick) -> bool {
        now.since(self.since) > self.patience || now.since(self.begun) > self.most
    }
}

impl Motor<'_, '_> {
    /// A wait that begins now.
    pub(super) fn wait(&self) -> Wait {
        let most = if self.relieving.is_some() { UNCHANGED } else { self.patience };
        Wait::new(self.session.now(), self.patience.min(most))
    }

    /// Pause between looks that leaves the drive's watchdog room for the telegrams between.
    pub(super) fn beat(&self) -> Span {
        self.guard.map_or(POLL, |guard| Span::from_millis((guard.as_millis() / 10).clamp(1, POLL.as_millis())))
    }

    /// How long an answer may be missing: half of the drive's watchdog, so that the stop still comes before it does, or
    /// without one our patience. The stop itself is tried anew as a whole.
    fn margin(&self) -> Span {
        match self.guard {
            _ if self.stopping => Span::ZERO,
            Some(guard) => Span::from_millis(guard.as_millis() / 2),
            None => self.patience,
        }
    }

    /// Asks, and asks again where no valid answer comes, as long as that can be borne. Only for what can be said twice:
    /// questions, and writes of the same value.
    pub(super) async fn bear<T>(
        &mut self,
        mut ask: impl AsyncFnMut(&mut Self) -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        let begun = self.session.now();
        loop {
            let failure = match ask(self).await {
                Err(failure) if failure.is_unheard() => failure,
                done => return done,
            };
            if self.session.now().since(begun) >= self.margin() || self.session.is_over() || self.is_mute() {
                return Err(failure);
            }
            self.rest(self.beat()).await?;
        }
    }

    /// Whether it is asked again only where that must be.
    fn is_mute(&self) -> bool {
        self.session.is_mute(self.target.address).is_some()
    }

    /// Looks at the state until it is one of `goals`. What ramps or holds gets the time that it needs: patience begins
    /// anew while the shaft still slows down.
    pub(super) async fn until(
        &mut self,
        goals: &[&str],
        takes: Option<Takes>,
        fault_is_fine: bool,
    ) -> Result<State, Failure> {
        let mut watch = Watch::new(self.target.family.motion.movement);
        let (mut wait, mut braking, mut seen, mut looks) = (self.wait(), takes, None, 0u8);
        if takes == Some(Takes::Transition5) {
            self.sight.goes_by_setting();
        }
        loop {
            self.demand_time()?;
            looks = looks.saturating_add(1);
            let asked = self.session.now();
            let state = self.state().await?;
            if goals.contains(&state.slug.as_str()) {
                return Ok(state);
            }
            if self.shows_no_power() {
                self.turns_not_before(asked);
            }
            if state.slug.starts_with("fault") && !fault_is_fine {
                return Err(self.fault_failure().await);
            }
            if takes.is_none() && self.works {
                // One that is in operation still, or again, where nothing ramps.
                self.say_stop_again().await?;
            }
            let slows = takes.is_some() && self.slows(&mut watch).await?;
            if slows || seen.as_ref() != Some(&state.slug) {
                seen = Some(state.slug.clone());
                wait.renew(self.session.now());
            }
            if slows && looks > FEW {
                self.takes_time(Span::ZERO);
            }
            if wait.is_over(self.session.now()) {
                // Asked only now: on a slow line the looks before are what shows the shaft standing.
                // Who works on as if nothing had been said neither holds nor brakes.
                let braking = braking.take().filter(|takes| *takes != Takes::QuickStop || !self.works);
                match self.braking(braking).await? {
                    Span::ZERO => return Err(self.stuck(&state, goals.first().copied().unwrap_or_default()).await),
                    more => {
                        self.takes_time(more);
                        wait.extend(more);
                    }
                }
            }
            if !self.sight.must_look() {
                self.rest(self.beat()).await?;
            }
        }
    }

    /// Whether the shaft slows down. A frequency that tells only under power is looked at again while it falls, because its
    /// 0 may be short.
    async fn slows(&mut self, watch: &mut Watch) -> Result<bool, Failure> {
        let (begun, mut slowed) = (self.session.now(), false);
        loop {
            let raw = self.shaft().await?;
            let trend = watch.see(self.session.now(), raw);
            self.insist(trend).await?;
            let slows = trend.slows;
            slowed |= slows;
            let since = self.session.now().since(begun);
            if !slows || !self.sight.falls() || (since >= FALLING && !watch.rests_within(SHORTLY)) {
                return Ok(slowed);
            }
            if since < FALLING {
                self.rest(self.beat()).await?;
            }
        }
    }

    /// How long the drive may hold or brake besides its ramp.
    async fn braking(&mut self, takes: Option<Takes>) -> Result<Span, Failure> {
        let mut sum = Span::ZERO;
        // It holds and brakes by direct current where the frequency is 0.
        let turns = self.target.family.motion.stator.is_some() && self.sight.standing() == Some(false);
        if turns || !matches!(takes, Some(Takes::Transition5 | Takes::QuickStop)) {
            return Ok(sum);
        }
        let family = self.target.family.clone();
        for param in family.motion.patience.iter().filter_map(|role| family.role(role)) {
            let raw = look::working(self.session, self.target, param).await?.unwrap_or(0);
            let ms = raw.saturating_mul(1_000) / 10i64.pow(param.decimals_or_zero().into());
            sum = sum + Span::from_millis(u64::try_from(ms).unwrap_or(0));
        }
        Ok(sum)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wait_begins_anew_with_every_change_but_not_for_ever() {
        let at = |second| Tick::ZERO + Span::from_secs(second);
        let mut wait = Wait::new(at(10), Span::from_secs(3));
        assert_eq!([10, 13, 14].map(|second| wait.is_over(at(second))), [false, false, true]);
        for second in (12..=610).step_by(2) {
            wait.renew(at(second));
            assert!(!wait.is_over(at(second)) && wait.is_over(at(second + 4)), "{second}");
        }
        wait.renew(at(611));
        assert!(wait.is_over(at(611)), "ten minutes are enough, however evenly it changes");
        let mut patient = Wait::new(at(0), Span::from_secs(700));
        assert_eq!([650, 700, 701].map(|second| patient.is_over(at(second))), [false, false, true]);
        patient.renew(at(690));
        assert_eq!([700, 701].map(|second| patient.is_over(at(second))), [false, true], "what was asked for is kept");
    }
}
