//! Writing parameters of one drive, with proof.

use super::access::{AccessError, Refusal};
use super::route::{Cell, Inquiry, No};
use super::session::Session;
use super::target::Target;
use crate::exchange::Limits;
use crate::gate::{Permit, Writes};
use crate::profile::{Param, Role, Type, value};
use crate::protocol::modbus::BROADCAST;
use crate::protocol::modbus::pdu::Exception;

/// A value to write.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Order {
    /// Data set on the wire, 0-9.
    pub set: u8,
    /// The value without its decimal point.
    pub raw: i64,
    /// Its type.
    pub kind: Type,
    /// Read it back; not where the line or the drive is gone at once.
    pub read_back: bool,
}

/// What became of a write.
#[derive(Debug)]
pub enum WriteFate {
    /// Echoed, and read back the same.
    Verified,
    /// Echoed; not read back, because that is impossible or would disturb.
    Written,
    /// Echoed, but reads back as this.
    Differs(i64),
    /// The reply is missing and reading back does not settle it.
    Unknown(AccessError),
    /// Sent to everybody.
    Broadcast,
}

impl Target {
    /// A value as it goes over the line.
    fn bits(&self, raw: i64, kind: Type) -> Result<u32, AccessError> {
        let fits = value::check_width(raw, kind, 0);
        let bits = fits.and_then(|()| value::to_wire(raw, self.family.link.route.carried(kind)));
        bits.map_err(|_| AccessError::Unspeakable)
    }

    /// Writes a parameter in one data set and proves it.
    ///
    /// A missing echo is settled by reading back, never by guessing. The permit says that somebody agreed.
    pub async fn write(
        &mut self,
        session: &mut Session<'_>,
        param: &Param,
        order: Order,
        _permit: &Permit<impl Writes>,
    ) -> Result<WriteFate, AccessError> {
        let Order { set, raw, kind, read_back } = order;
        let bits = self.bits(raw, kind)?;
        let cell = Cell { number: param.id, set };
        let route = self.route(session).await?;
        let plain = route.question(Inquiry::Write(cell, kind, bits)).ok_or(AccessError::Unspeakable)?;
        if self.address == BROADCAST {
            session.ask(self.address, plain).await?;
            return Ok(WriteFate::Broadcast);
        }
        session.unlock(route, &self.family).await?;
        let both =
            route.question(Inquiry::WriteAndRead(cell, kind, bits)).filter(|_| read_back && !self.lacks_exchange);
        let mut question = both.unwrap_or_else(|| plain.clone());
        let limits = session.limits();
        // It wears the EEPROM: where its answer is missing or may be another's, the value is read before it goes out again.
        let once = Limits { retries: 0, witness: !read_back, ..limits };
        let mut tries = 0;
        loop {
            tries += 1;
            let sent = session.demand_within(route, &self.family, question.clone(), once).await;
            if self.family.role(Role::WordOrder).is_some_and(|order| order.id == param.id) {
                self.order = None; // it may hold at once
            }
            let missing = match sent {
                Ok(_) if !read_back => return Ok(WriteFate::Written),
                Ok(Some((said, _))) if route.tells(&said, bits) => return Ok(WriteFate::Verified),
                Ok(_) => None,
                // The drive does not know the code that writes and reads.
                Err(AccessError::Refused(Refusal { no: No::Exception(Exception::IllegalFunction), .. }))
                    if question != plain =>
                {
                    self.lacks_exchange = true;
                    question = plain.clone();
                    continue;
                }
                Err(AccessError::Exchange(error)) => Some(AccessError::Exchange(error)),
                // Nor does anybody know of a busy drive whether it has done it: Acknowledge says that it will (V1.1b3 7).
                Err(error) if read_back && error.passes() && !session.is_insisting() => {
                    session.bears(&error, tries).await?;
                    Some(error)
                }
                // The manual leaves open what an EEPROM that fails has taken, and what an unknown error is.
                Err(AccessError::Refused(no))
                    if read_back && no.leaves_open(&self.family) && !session.is_insisting() =>
                {
                    let now = self.read_set(session, param, set).await.ok();
                    return Err(AccessError::Refused(Refusal { taken: now.map(|now| now.raw == raw), ..no }));
                }
                Err(error) => return Err(error),
            };
            if !read_back {
                return Ok(WriteFate::Unknown(missing.unwrap_or(AccessError::Interrupted)));
            }
            match (self.read_set(session, param, set).await, missing) {
                (Ok(reading), _) if reading.raw == raw => return Ok(WriteFate::Verified),
                (Ok(reading), None) => return Ok(WriteFate::Differs(reading.raw)),
                // The old value still stands: the telegram never arrived, so it may be sent again.
                (Ok(_), Some(_)) if tries <= limits.retries => {}
                (Ok(_), Some(error)) => return Err(error),
                (Err(AccessError::Refused(_)), None) => return Ok(WriteFate::Written),
                (Err(error), None) | (Err(_), Some(error)) => return Ok(WriteFate::Unknown(error)),
            }
        }
    }
}
