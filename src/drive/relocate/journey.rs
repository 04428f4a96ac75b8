//! A drive on its way: step by step, and back where a step fails.

use super::plot::address_role;
use super::said::unmoved;
use super::{Change, Leg, Place, Then, number, parities, protocols};
use crate::drive::access::AccessError;
use crate::drive::probe::probe;
use crate::drive::session::Session;
use crate::drive::target::Target;
use crate::drive::transaction::LONGEST_RESTART;
use crate::drive::write::{Order, WriteFate};
use crate::exchange::{ExchangeError, Limits};
use crate::failure::Failure;
use crate::gate::{Line, Permit};
use crate::profile::{Role, Type};
use crate::protocol::Protocol;
use crate::tick::Span;
use crate::transport::LinkError;

/// How often a step is tried while the drive still answers where it was.
const TRIES: u8 = 3;
/// Between two looks for a drive that restarts.
const PAUSE: Span = Span::from_millis(500);

/// A drive on its way.
pub(super) struct Journey<'j, 's> {
    pub(super) session: &'j mut Session<'s>,
    pub(super) target: &'j mut Target,
    pub(super) permit: &'j Permit<Line>,
    /// Where it answered last.
    pub(super) here: Place,
    /// What puts it back, in the order in which it was done.
    pub(super) undo: Vec<Leg>,
}

/// Why a step is not done.
pub(super) struct Setback {
    pub(super) cause: Failure,
    /// Where the drive may be, the likeliest first; empty while it still answers where it was.
    pub(super) perhaps: Vec<Place>,
}

impl Setback {
    pub(super) fn is_lost(&self) -> bool {
        !self.perhaps.is_empty()
    }
}

impl Journey<'_, '_> {
    pub(super) async fn leg(&mut self, leg: &Leg) -> Result<(), Setback> {
        match leg.then {
            Then::Stored => self.store(leg).await,
            Then::At(place) => self.hop(leg, place).await,
            Then::Perhaps(change) => self.hop_or_store(leg, change).await,
            Then::Restart(place) => self.restart(leg, place).await,
        }
    }

    /// Writes what only a restart brings into force.
    async fn store(&mut self, leg: &Leg) -> Result<(), Setback> {
        self.undo.extend(leg.back(Then::Stored));
        let error = match self.write(leg, true).await {
            Ok(WriteFate::Verified | WriteFate::Written) => return Ok(()),
            Ok(WriteFate::Unknown(error)) | Err(error) => error,
            Ok(WriteFate::Differs(_) | WriteFate::Broadcast) => {
                return Err(Setback { cause: unmoved(self.here), perhaps: Vec::new() });
            }
        };
        if error.is_refused() {
            self.undo.pop();
        }
        let answers = error.is_refused() || (!error.is_fatal() && self.answers(self.here, None).await.unwrap_or(false));
        let perhaps = if answers { Vec::new() } else { vec![self.here] };
        Err(Setback { cause: self.failure(&error), perhaps })
    }

    /// Writes what moves the drive at once, and follows it.
    async fn hop(&mut self, leg: &Leg, place: Place) -> Result<(), Setback> {
        let places = self.landings(place);
        let both: Vec<Place> = places.iter().copied().chain([self.here]).collect();
        let mut last = None;
        for _ in 0..TRIES {
            match self.write(leg, false).await {
                Ok(WriteFate::Unknown(error)) => last = Some(error),
                Ok(_) => {}
                Err(error) if error.is_refused() => {
                    return Err(Setback { cause: self.failure(&error), perhaps: Vec::new() });
                }
                Err(error) => last = Some(error),
            }
            // Twice at the likeliest: a line that is disturbed for a moment is no reason to give up.
            match self.arrives(&[&[place, self.here][..], &both].concat()).await {
                Ok(Some(found)) if found != self.here => {
                    self.undo.extend(leg.back(Then::At(self.here)));
                    self.here = found;
                    return Ok(());
                }
                Ok(Some(_)) => {}
                Ok(None) => {
                    let cause = last.as_ref().map_or_else(|| unmoved(place), |error| self.failure(error));
                    return Err(Setback { cause, perhaps: both });
                }
                Err(error) => return Err(Setback { cause: self.failure(&error), perhaps: both }),
            }
        }
        let cause = last.as_ref().map_or_else(|| unmoved(place), |error| self.failure(error));
        Err(Setback { cause, perhaps: Vec::new() })
    }

    /// Writes what may move the drive at once or with the next power-on, and looks under both. Nobody answered at the new
    /// place before, so whoever does now is the drive.
    async fn hop_or_store(&mut self, leg: &Leg, change: Change) -> Result<(), Setback> {
        let place = change.of(self.here);
        let both = [place, self.here];
        let mut last = None;
        for _ in 0..TRIES {
            match self.write(leg, false).await {
                Ok(WriteFate::Unknown(error)) => last = Some(error),
                Ok(_) => {}
                Err(error) if error.is_refused() => {
                    return Err(Setback { cause: self.failure(&error), perhaps: Vec::new() });
                }
                Err(error) => last = Some(error),
            }
            let stays = change.stays_first() && !self.shows_itself(change).await;
            let looked = if stays { [self.here, place] } else { both };
            let found = self.arrives(&[looked, looked].concat()).await;
            let stored = match found {
                Ok(Some(found)) if found == place => {
                    self.undo.extend(leg.back(Then::At(self.here)));
                    self.here = place;
                    return Ok(());
                }
                Ok(Some(_)) => self.target.read_set(self.session, &leg.param, 0).await,
                Ok(None) => {
                    let cause = last.as_ref().map_or_else(|| unmoved(place), |error| self.failure(error));
                    return Err(Setback { cause, perhaps: both.to_vec() });
                }
                Err(error) => return Err(Setback { cause: self.failure(&error), perhaps: both.to_vec() }),
            };
            if stored.is_ok_and(|reading| reading.raw == leg.raw) {
                self.undo.extend(leg.back(Then::Stored));
                return Ok(());
            }
        }
        let cause = last.as_ref().map_or_else(|| unmoved(place), |error| self.failure(error));
        Err(Setback { cause, perhaps: Vec::new() })
    }

    /// Restarts the drive, and waits for it where it will be.
    async fn restart(&mut self, leg: &Leg, place: Place) -> Result<(), Setback> {
        let both = vec![place, self.here];
        let lost =
            |journey: &Self, error: &AccessError| Setback { cause: journey.failure(error), perhaps: both.clone() };
        match self.write(leg, false).await {
            Err(error) if error.is_refused() => {
                return Err(Setback { cause: self.failure(&error), perhaps: Vec::new() });
            }
            Err(error) if error.is_fatal() => return Err(lost(self, &error)),
            _ => {}
        }
        let until = self.session.now() + LONGEST_RESTART;
        while self.session.now() < until {
            self.session.rest(PAUSE).await.map_err(|error| lost(self, &error))?;
            if self.answers(place, Some(0)).await.map_err(|error| lost(self, &error))? {
                self.here = place;
                return Ok(());
            }
        }
        let stays = self.answers(self.here, None).await.map_err(|error| lost(self, &error))?;
        let perhaps = if stays { Vec::new() } else { both.clone() };
        Err(Setback { cause: unmoved(place), perhaps })
    }

    /// Puts everything back that was done, the last first.
    pub(super) async fn put_back(&mut self) -> Result<(), Setback> {
        while let Some(leg) = self.undo.pop() {
            let depth = self.undo.len();
            let back = self.leg(&leg).await;
            self.undo.truncate(depth);
            back?;
        }
        Ok(())
    }

    async fn write(&mut self, leg: &Leg, read_back: bool) -> Result<WriteFate, AccessError> {
        let kind = leg.param.kind.unwrap_or(Type::Uint);
        let order = Order { set: 0, raw: leg.raw, kind, read_back };
        self.target.write(self.session, &leg.param, order, self.permit).await
    }

    /// Where the drive can be once it is on its way to `place`. What parity Modbus has in force cannot be seen from VABus:
    /// the stored one may wait for a restart.
    fn landings(&self, place: Place) -> Vec<Place> {
        let mut places = vec![place];
        if self.here.protocol == Protocol::Vabus && place.protocol != Protocol::Vabus {
            let others = parities(&self.target.family).into_iter().filter(|row| row.1 != place.line.parity);
            places.extend(others.map(|row| Place { line: place.protocol.line(place.line.baud, row.1), ..place }));
        }
        places
    }

    /// At which of these places the drive answers; the line stays there.
    async fn arrives(&mut self, places: &[Place]) -> Result<Option<Place>, AccessError> {
        for &place in places {
            if self.answers(place, None).await? {
                return Ok(Some(place));
            }
        }
        Ok(None)
    }

    /// Whether the drive answers there, and says that it speaks what is spoken there. With `retries` in place of the
    /// usual number.
    async fn answers(&mut self, place: Place, retries: Option<u8>) -> Result<bool, AccessError> {
        match follow(self.session, self.target, place).await {
            // On a CAN bus of another rate there are errors, and no drive of ours.
            Err(AccessError::Link(LinkError::Unacknowledged { .. })) => return Ok(false),
            followed => followed?,
        }
        let usual = self.session.limits();
        let limits = Limits { retries: retries.unwrap_or(usual.retries), ..usual };
        let is_on_bus = matches!(place.protocol, Protocol::Sdo(_));
        let protocol = self.target.family.role(Role::Protocol).filter(|_| !is_on_bus).cloned();
        let spoken = number(&protocols(&self.target.family), &place.protocol);
        // Where a drive speaks one protocol only, as on a CAN bus, its address is as good a sign as any.
        let Some(param) = protocol.clone().or_else(|| self.target.family.role(address_role(place.protocol)).cloned())
        else {
            return Ok(false);
        };
        let target = &mut *self.target;
        let read = async |session: &mut Session<'_>| target.read_set(session, &param, 0).await;
        match self.session.within(limits, read).await {
            Ok(reading) => Ok(protocol.is_none() || Some(reading.raw) == spoken),
            Err(AccessError::Link(LinkError::Unacknowledged { .. })) => Ok(false),
            Err(error) if error.is_fatal() => Err(error),
            Err(_) => Ok(false),
        }
    }

    /// Whether somebody is heard at another bit rate of a CAN bus before anybody is asked there. The adapter leaves the old one at once: a
    /// drive that has gone, and says so, would be disturbed.
    async fn shows_itself(&mut self, change: Change) -> bool {
        let Change::Rate(_) = change else { return false };
        let place = change.of(self.here);
        let followed = follow(self.session, self.target, place).await;
        followed.is_ok() && self.session.traffic().is_some_and(|traffic| traffic.frames > 0)
    }

    fn failure(&self, error: &AccessError) -> Failure {
        error.failure(self.here.address, Some(&self.target.family))
    }
}

/// Speaks as it is spoken there, from now on.
pub(super) async fn follow(session: &mut Session<'_>, target: &mut Target, place: Place) -> Result<(), AccessError> {
    target.address = place.address;
    if (session.protocol(), session.line()) == (place.protocol, place.line) {
        return Ok(());
    }
    session.retune(place.protocol, place.line).await
}

/// Whether anybody answers there, whatever he says.
pub(super) async fn is_taken(
    session: &mut Session<'_>,
    target: &mut Target,
    place: Place,
) -> Result<bool, AccessError> {
    follow(session, target, place).await?;
    let Some(question) = probe(place.protocol, place.address) else { return Ok(false) };
    let once = Limits { retries: 0, ..session.limits() };
    match session.ask_within(place.address, question, once).await {
        Ok(_) => Ok(true),
        Err(AccessError::Exchange(ExchangeError::Silence { .. })) => Ok(false),
        Err(AccessError::Exchange(_)) => Ok(true),
        Err(error) => Err(error),
    }
}
