//! Several drives that were told to stop are looked at in turns, because a stator that shows the standstill of its shaft does so only
//! until its power is gone: who is looked at when the others are done shows nothing any more.

use super::patience::{FEW, Wait};
use super::shaft::Watch;
use super::shout::FirstWord;
use super::still::Sight;
use super::{Motor, Situation, has_power};
use crate::drive::describe;
use crate::drive::session::Session;
use crate::drive::target::Target;
use crate::exchange::Limits;
use crate::failure::{Class, Failure};
use crate::gate::{self, Permit};
use crate::tick::Span;

/// A shaft that does not become slower for so long gets the word that follows, whoever else is still on the way.
const SLOWS_WITHIN: Span = Span::from_secs(1);
/// One look takes no longer, whatever comes over the line.
const LOOK: Span = Span::from_millis(1_500);
/// Who says nothing so often is looked at when the others are done.
const MISSES: u8 = 2;

/// When a stop is proven.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Next {
    /// Its shaft becomes slower: it is looked at again.
    Look,
    /// Nothing becomes slower: at once.
    Prove,
    /// It was seen to stand, or nothing more is to be seen: when all are done.
    Later,
}

/// What looks in turns tell of one drive.
#[derive(Debug)]
pub struct Glimpse {
    target: Target,
    watch: Watch,
    wait: Wait,
    looks: u8,
    misses: u8,
    sight: Sight,
    powered: bool,
    first: Option<Situation>,
}

impl Glimpse {
    /// A drive that was told to stop; `None` if nobody knows what it is, or its shaft tells as well later on.
    pub fn of(session: &Session<'_>, address: u8, first: &FirstWord) -> Option<Self> {
        let family = first.family.clone().filter(|family| family.motion.stator.is_some())?;
        Some(Glimpse {
            watch: Watch::new(family.motion.movement),
            target: Target::new(address, family),
            wait: Wait::new(session.now(), SLOWS_WITHIN),
            looks: 0,
            misses: 0,
            sight: Sight::default(),
            powered: false,
            first: None,
        })
    }

    /// Looks once. Fails only with what ends the session.
    pub async fn look(&mut self, session: &mut Session<'_>, permit: &Permit<gate::Motion>) -> Result<Next, Failure> {
        let limits = Limits { retries: 0, ..session.limits() };
        session.insist(true);
        session.end_at(Some(session.now() + LOOK));
        let seen = session.within(limits, async |session: &mut Session<'_>| self.seen(session, permit).await).await;
        session.end_at(None);
        self.looks = self.looks.saturating_add(1);
        match seen {
            Ok(shows) => Ok(self.next(session, shows)),
            Err(failure) if matches!(failure.class, Class::Interrupted | Class::Port) => Err(failure),
            Err(_) => {
                self.misses += 1;
                Ok(if self.misses < MISSES { Next::Look } else { Next::Later })
            }
        }
    }

    /// What the frequency is under power.
    async fn seen(&mut self, session: &mut Session<'_>, permit: &Permit<gate::Motion>) -> Result<Option<i64>, Failure> {
        let mut motor = Motor::new(session, &mut self.target, permit, None);
        (motor.stopping, motor.powered) = (true, self.powered);
        // An encoder would cost every look twice the time; it tells as well when its drive's stop is proven.
        (motor.sight, motor.encoder) = (std::mem::take(&mut self.sight), Some(None));
        let seen = motor.glimpse(&mut self.first).await;
        (self.sight, self.powered) = (std::mem::take(&mut motor.sight), motor.powered);
        seen
    }

    fn next(&mut self, session: &Session<'_>, shows: Option<i64>) -> Next {
        self.misses = 0;
        if shows.is_none() || self.sight.standing() == Some(true) {
            return Next::Later;
        }
        let now = session.now();
        if self.watch.see(now, shows).slows {
            self.wait.renew(now);
        }
        if self.looks > FEW && self.wait.is_over(now) { Next::Prove } else { Next::Look }
    }
}

impl Motor<'_, '_> {
    /// One look at the state, and under power at the shaft.
    async fn glimpse(&mut self, first: &mut Option<Situation>) -> Result<Option<i64>, Failure> {
        let status = self.status().await?;
        let state = describe::state(&self.target.family, status).slug;
        let is_off = has_power(&state) == Some(false);
        first.get_or_insert_with(|| Situation { status, state, ..Situation::default() });
        if is_off {
            return Ok(None);
        }
        let shows = self.shaft().await?;
        if self.sight.must_look() {
            self.status().await?;
        }
        Ok(shows)
    }

    /// Goes on from what was seen in turns.
    pub fn goes_on_from(&mut self, glimpse: Glimpse) {
        (self.glimpsed, self.powered, self.first_seen) = (Some(glimpse.sight), glimpse.powered, glimpse.first);
    }
}
