//! Reading and writing parameters of one drive: widths, data sets, refusals, proof of writes.

use super::route::{self, RegisterAddress};
use super::session::{AccessError, ERROR_REGISTER, Refusal, Session};
use crate::gate::Permit;
use crate::profile::{DataSets, Family, Param, Type, value};
use crate::protocol::modbus::pdu::{Exception, Reply};
use std::collections::BTreeMap;
use std::rc::Rc;

/// Error register: the sets have different values, so set 0 cannot be read (CM-485 manual 6.6, 7).
const SETS_DIFFER: u16 = 9;
/// Error register: the width of the telegram is not the one of the parameter (CM-485 manual 6.6).
const WRONG_WIDTH: u16 = 14;
/// Error register: wrong type (CM-485 manual 6.6).
const WRONG_TYPE: u16 = 10;

/// A drive on the line.
#[derive(Debug)]
pub struct Target {
    /// Address of the drive; 0 is everybody.
    pub address: u8,
    /// What it is.
    pub family: Rc<Family>,
    /// Widths that were found out by asking, for this run.
    widths: BTreeMap<u32, Type>,
    /// What the error register held before identifying the drive could overwrite it.
    pub(super) kept_register: Option<u16>,
    /// The drive's watchdog in seconds, as it was read last.
    pub(super) known_watchdog: Option<i64>,
}

/// A value as it was read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reading {
    /// Data set on the wire, 0-9.
    pub set: u8,
    /// The value without its decimal point.
    pub raw: i64,
    /// Its type, from the catalogue or found out.
    pub kind: Type,
    /// The catalogue names another width, and the drive is right.
    pub corrected: bool,
}

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
    /// A drive of a known family.
    pub fn new(address: u8, family: Rc<Family>) -> Self {
        Target { address, family, widths: BTreeMap::new(), kept_register: None, known_watchdog: None }
    }

    /// Reads a parameter in the data sets that are meant. Asks set 0 first; if the sets differ (P.11 = 9), reads each
    /// of the four.
    pub async fn read(
        &mut self,
        session: &mut Session<'_>,
        param: &Param,
        sets: DataSets,
    ) -> Vec<(u8, Result<Reading, AccessError>)> {
        let mut rows = Vec::new();
        for set in sets.wire() {
            let result = self.read_set(session, param, set).await;
            let differ = matches!(&result, Err(AccessError::Refused(Refusal { cause: Some(SETS_DIFFER), .. })));
            if !(differ && (set == 0 || set == DataSets::RAM_OFFSET)) {
                let fatal = result.as_ref().is_err_and(AccessError::is_fatal);
                rows.push((set, result));
                if fatal {
                    break;
                }
                continue;
            }
            for single in set + 1..=set + 4 {
                rows.push((single, self.read_set(session, param, single).await));
            }
        }
        rows
    }

    /// Reads a parameter in one data set, given as on the wire (0-9).
    pub async fn read_set(
        &mut self,
        session: &mut Session<'_>,
        param: &Param,
        set: u8,
    ) -> Result<Reading, AccessError> {
        if param.id == ERROR_REGISTER
            && let Some(kept) = self.kept_register.take()
        {
            return Ok(Reading { set, raw: kept.into(), kind: Type::Uint, corrected: false });
        }
        let at = RegisterAddress::new(param.id, set)
            .ok_or(AccessError::Refused(Refusal { exception: Exception::IllegalDataAddress, cause: None }))?;
        let stated = self.widths.get(&param.id).copied().or(param.kind);
        let first = stated.unwrap_or(Type::Word);
        let error = match self.read_as(session, param, at, first).await {
            Ok(raw) => return Ok(self.found(param, set, raw, first)),
            Err(error) => error,
        };
        let doubtful = stated.is_none() || param.unconfirmed.iter().any(|field| field == "type" || field == "row");
        let width = matches!(
            &error,
            AccessError::Refused(Refusal { cause: Some(WRONG_WIDTH | WRONG_TYPE), .. })
                | AccessError::Refused(Refusal { exception: Exception::IllegalDataAddress, cause: None | Some(0) })
        );
        if !(doubtful && width) {
            return Err(error);
        }
        let second = if first.bits() == Some(32) { Type::Word } else { Type::Long };
        match self.read_as(session, param, at, second).await {
            Ok(raw) => Ok(self.found(param, set, raw, second)),
            Err(AccessError::Refused(_)) => Err(error),
            Err(other) => Err(other),
        }
    }

    async fn read_as(
        &self,
        session: &mut Session<'_>,
        param: &Param,
        at: RegisterAddress,
        kind: Type,
    ) -> Result<i64, AccessError> {
        let (reply, _) = session.demand(self.address, route::read(at, kind)).await?;
        let bits = match reply {
            Reply::Registers(values) => values.first().copied().unwrap_or(0).into(),
            Reply::Long(value) => value,
            _ => 0,
        };
        Ok(value::from_wire(bits, kind, param.min))
    }

    fn found(&mut self, param: &Param, set: u8, raw: i64, kind: Type) -> Reading {
        let corrected = param.kind.is_some_and(|stated| stated.bits() != kind.bits());
        if param.kind.is_none() || corrected {
            self.widths.insert(param.id, kind);
        }
        Reading { set, raw, kind, corrected }
    }

    /// The type to write a parameter with: from the catalogue, found out earlier, or found out now by reading it.
    pub async fn width(&mut self, session: &mut Session<'_>, param: &Param, set: u8) -> Result<Type, AccessError> {
        if let Some(kind) = self.widths.get(&param.id).copied().or(param.kind) {
            return Ok(kind);
        }
        match self.read_set(session, param, set).await {
            Ok(reading) => Ok(reading.kind),
            Err(error) => Err(error),
        }
    }

    /// The type of a parameter that was found out or set in this run.
    pub fn known_width(&self, param: u32) -> Option<Type> {
        self.widths.get(&param).copied()
    }

    /// Uses this width for a parameter, whatever the catalogue says.
    pub fn set_width(&mut self, param: u32, kind: Type) {
        self.widths.insert(param, kind);
    }

    /// Writes a parameter in one data set and proves it.
    ///
    /// A missing echo is settled by reading back, never by guessing. The permit says that somebody agreed.
    pub async fn write(
        &mut self,
        session: &mut Session<'_>,
        param: &Param,
        order: Order,
        _permit: &Permit,
    ) -> Result<WriteFate, AccessError> {
        let Order { set, raw, kind, read_back } = order;
        let refused = || AccessError::Refused(Refusal { exception: Exception::IllegalDataValue, cause: None });
        let at = RegisterAddress::new(param.id, set).ok_or_else(refused)?;
        let bits = value::to_wire(raw, kind).map_err(|_| refused())?;
        let request = route::write(at, kind, bits);
        if self.address == crate::protocol::modbus::BROADCAST {
            session.ask(self.address, request).await?;
            return Ok(WriteFate::Broadcast);
        }
        let limits = session.limits();
        let mut tries = 0;
        loop {
            tries += 1;
            session.set_limits(crate::exchange::modbus::Limits { retries: 0, ..limits });
            let sent = session.demand(self.address, request.clone()).await;
            session.set_limits(limits);
            let missing = match sent {
                Ok(_) if !read_back => return Ok(WriteFate::Written),
                Ok(_) => None,
                Err(AccessError::Exchange(error)) => Some(AccessError::Exchange(error)),
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
                (Err(error), None) => return Ok(WriteFate::Unknown(error)),
                (Err(_), Some(error)) => return Ok(WriteFate::Unknown(error)),
            }
        }
    }
}
