//! Reading and writing parameters of one drive: widths, data sets, refusals, proof of writes.

use super::route::{Cell, Content, Inquiry, No, Route, Width};
use super::session::{AccessError, Refusal, Session};
use crate::exchange::{ExchangeError, Limits};
use crate::gate::{Permit, Writes};
use crate::profile::{DataSets, Family, Param, Sets, Type, value};
use crate::protocol::modbus::BROADCAST;
use crate::protocol::modbus::pdu::{Exception, WordOrder};
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
    /// Which half of a value in two registers comes first, once it is known or given.
    pub order: Option<WordOrder>,
    /// It refused the code that writes and reads back in one exchange.
    lacks_exchange: bool,
    /// It was asked for something whose answer cannot be mistaken.
    pub(super) introduced: bool,
    /// Widths that were found out by asking, for this run.
    widths: BTreeMap<u32, Type>,
    /// What the error register held before identifying the drive could overwrite it.
    pub(super) kept_register: Option<u16>,
    /// It refused a question while it was recognised, which is its last synchronous error now.
    pub refused_on_the_way: bool,
    /// The drive's watchdog in seconds, as it was read last.
    pub(super) known_watchdog: Option<i64>,
}

/// A value as it was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Reading {
    /// Data set on the wire, 0-9.
    pub set: u8,
    /// The value without its decimal point; 0 for a string.
    pub raw: i64,
    /// The characters of a string.
    pub text: Option<String>,
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
        Target {
            address,
            family,
            order: None,
            lacks_exchange: false,
            introduced: false,
            widths: BTreeMap::new(),
            kept_register: None,
            refused_on_the_way: false,
            known_watchdog: None,
        }
    }

    /// The same with the word order that somebody gave, if any.
    #[must_use]
    pub fn in_word_order(self, order: Option<WordOrder>) -> Self {
        Target { order, ..self }
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
        let is_register = self.family.role("error-register").is_some_and(|register| register.id == param.id);
        if is_register && let Some(kept) = self.kept_register.take() {
            return Ok(Reading { set, raw: kept.into(), text: None, kind: Type::Uint, corrected: false });
        }
        let cell = Cell { number: param.id, set };
        if is_register {
            return self.read_once(session, param, cell).await;
        }
        let stated = self.widths.get(&param.id).copied().or(param.kind);
        let first = stated.unwrap_or(Type::Word);
        let error = match self.read_as(session, param, cell, first).await {
            Ok(reading) => return Ok(self.found(param, reading)),
            Err(error) => error,
        };
        let doubtful = stated.is_none() || param.unconfirmed.iter().any(|field| field == "type" || field == "row");
        let width = matches!(
            &error,
            AccessError::Refused(Refusal { cause: Some(WRONG_WIDTH | WRONG_TYPE), .. })
                | AccessError::Refused(Refusal {
                    no: No::Exception(Exception::IllegalDataAddress),
                    cause: None | Some(0),
                    ..
                })
        );
        if !(doubtful && width) {
            return Err(error);
        }
        let second = if first.bits() == Some(32) { Type::Word } else { Type::Long };
        match self.read_as(session, param, cell, second).await {
            Ok(reading) => Ok(self.found(param, reading)),
            Err(AccessError::Refused(_)) => Err(error),
            Err(other) => Err(other),
        }
    }

    /// Reads what is cleared by reading: asked again after a lost reply it would say that nothing happened.
    async fn read_once(
        &mut self,
        session: &mut Session<'_>,
        param: &Param,
        cell: Cell,
    ) -> Result<Reading, AccessError> {
        let (once, kind) =
            (Limits { witness: false, retries: 0, ..session.limits() }, param.kind.unwrap_or(Type::Uint));
        session.within(once, async |session: &mut Session<'_>| self.read_as(session, param, cell, kind).await).await
    }

    /// Reads those of the parameters that lie next to each other, in as few telegrams as possible. What is not
    /// returned, alone or refused with its neighbours, is to be read one by one.
    pub async fn neighbours(
        &mut self,
        session: &mut Session<'_>,
        params: &[Param],
    ) -> Result<Vec<(u32, Reading)>, AccessError> {
        let way = self.family.link.route;
        let mut readings = Vec::new();
        let lines = params.chunk_by(|one, next| way.neighbour(one.id) == Some(next.id));
        for chunk in lines.flat_map(|line| line.chunks(way.most())).filter(|chunk| chunk.len() > 1) {
            match self.read_chunk(session, chunk).await {
                Ok(chunk) => readings.extend(chunk),
                Err(error) if error.is_fatal() => return Err(error),
                Err(_) => {}
            }
        }
        Ok(readings)
    }

    async fn read_chunk(
        &mut self,
        session: &mut Session<'_>,
        chunk: &[Param],
    ) -> Result<Vec<(u32, Reading)>, AccessError> {
        let route = self.route(session).await?;
        let (first, count) = chunk.first().zip(u16::try_from(chunk.len()).ok()).ok_or(AccessError::Unspeakable)?;
        let inquiry = Inquiry::ReadMany(Cell { number: first.id, set: 0 }, count);
        let question = route.question(inquiry).ok_or(AccessError::Unspeakable)?;
        let answer = session.demand(route, &self.family, question).await?;
        let values = answer.map_or_else(Vec::new, |(said, _)| route.values(&said));
        let read = |(param, bits): (&Param, u32)| {
            let kind = param.kind.unwrap_or(Type::Long);
            (param.id, reading(param, 0, Content::Bits(bits, Width::AsAsked), kind))
        };
        Ok(chunk.iter().zip(values).map(read).collect())
    }

    /// The way to this drive on the line of the session. Where values take two registers, which half comes first is
    /// asked once: by the address, which is never 0 and so proves the order in force. The setting of the order proves it
    /// only if it is not 0, and may hold from the next power-on.
    pub async fn route(&mut self, session: &mut Session<'_>) -> Result<Route, AccessError> {
        let route = Route {
            node: session.node(),
            order: self.order.unwrap_or_default(),
            ..Route::new(session.protocol(), &self.family.link, self.address)
        };
        session.knows(self.address, &self.family, route.order);
        let asks = self.order.is_none() && self.address != BROADCAST;
        let family = self.family.clone();
        let Some(order) = family.role("word-order").filter(|_| asks) else {
            return Ok(route);
        };
        let mut proven = None;
        for param in family.role("address").into_iter().chain([order]) {
            let cell = Cell { number: param.id, set: 0 };
            let question = route.question(Inquiry::Read(cell, Type::Long)).ok_or(AccessError::Unspeakable)?;
            let answer = match session.demand(route, &self.family, question).await {
                Err(AccessError::Refused(_)) => None,
                answer => answer?,
            };
            proven = answer.and_then(|(said, _)| route.content(&said)).and_then(|content| order_told(param, &content));
            if proven.is_some() {
                break;
            }
        }
        self.introduce(session, route).await?;
        // Without an answer that tells, the factory setting is presumed.
        let order = proven.unwrap_or_default();
        self.order = Some(order);
        session.knows(self.address, &self.family, order);
        Ok(Route { order, ..route })
    }

    /// Asks a drive that somebody named, and that was not recognised, for something whose answer cannot be mistaken: where two
    /// drives answer at the address, the second answer is the sign of it, before any value is read.
    async fn introduce(&mut self, session: &mut Session<'_>, route: Route) -> Result<(), AccessError> {
        if self.introduced || session.is_insisting() {
            return Ok(());
        }
        self.introduced = true;
        let Some(counter) = self.family.counters.first() else { return Ok(()) };
        let Some(question) = route.question(Inquiry::Counter(counter.sub)) else { return Ok(()) };
        session.ask(self.address, question).await.map(|_| ())
    }

    async fn read_as(
        &mut self,
        session: &mut Session<'_>,
        param: &Param,
        cell: Cell,
        kind: Type,
    ) -> Result<Reading, AccessError> {
        let route = self.route(session).await?;
        let question = route.question(Inquiry::Read(cell, kind)).ok_or(AccessError::Unspeakable)?;
        let doubts = |field: &String| ["type", "row"].contains(&field.as_str());
        let sure = param.kind == Some(kind) && !param.unconfirmed.iter().any(doubts);
        let mut asked = 0;
        loop {
            asked += 1;
            let answer = match session.demand(route, &self.family, question.clone()).await {
                // Refused again, it tells again why.
                Err(AccessError::Refused(Refusal { unheard: true, .. })) if asked <= session.limits().retries => {
                    continue;
                }
                // The cause that was lost would have told the width.
                Err(AccessError::Refused(Refusal { unheard: true, .. })) if !sure => return Err(session.too_late()),
                answer => answer?,
            };
            let (said, _) = answer.ok_or(AccessError::Unspeakable)?;
            let content = route.content(&said).ok_or(AccessError::Unspeakable)?;
            match route.misshapen(&said, kind).filter(|_| sure) {
                None => return Ok(reading(param, cell.set, content, kind)),
                Some(_) if asked <= session.limits().retries => {}
                Some(bytes) => return Err(ExchangeError::Garbled { asked, bytes }.into()),
            }
        }
    }

    /// Remembers the width that turned out to be the right one.
    fn found(&mut self, param: &Param, reading: Reading) -> Reading {
        let corrected = param.kind.is_some_and(|stated| stated.bits() != reading.kind.bits());
        if param.kind.is_none() || corrected {
            self.widths.insert(param.id, reading.kind);
        }
        Reading { corrected, ..reading }
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

    /// The data set (0-4) in which the drive works with a parameter; 0 where it exists once.
    pub async fn working_set(&mut self, session: &mut Session<'_>, param: &Param) -> Result<u8, AccessError> {
        let active = self.family.role("active-set").filter(|_| param.sets == Some(Sets::Four)).cloned();
        let Some(active) = active else { return Ok(0) };
        match self.read_set(session, &active, 0).await {
            Ok(reading) => Ok(u8::try_from(reading.raw).unwrap_or(1).clamp(1, 4)),
            Err(AccessError::Refused(_)) => Ok(1),
            Err(error) => Err(error),
        }
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
        _permit: &Permit<impl Writes>,
    ) -> Result<WriteFate, AccessError> {
        let Order { set, raw, kind, read_back } = order;
        let fits = value::check_width(raw, kind, 0);
        let bits = fits.and_then(|()| value::to_wire(raw, self.family.link.route.carried(kind)));
        let bits = bits.map_err(|_| AccessError::Unspeakable)?;
        let cell = Cell { number: param.id, set };
        let route = self.route(session).await?;
        let plain = route.question(Inquiry::Write(cell, kind, bits)).ok_or(AccessError::Unspeakable)?;
        if self.address == BROADCAST {
            session.ask(self.address, plain).await?;
            return Ok(WriteFate::Broadcast);
        }
        let both =
            route.question(Inquiry::WriteAndRead(cell, kind, bits)).filter(|_| read_back && !self.lacks_exchange);
        let mut question = both.unwrap_or_else(|| plain.clone());
        let limits = session.limits();
        let mut tries = 0;
        loop {
            tries += 1;
            session.set_limits(Limits { retries: 0, ..limits });
            let sent = session.demand(route, &self.family, question.clone()).await;
            session.set_limits(limits);
            if self.family.role("word-order").is_some_and(|order| order.id == param.id) {
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

/// The word order that a value of a small parameter proves, read with the upper half first; 0 proves nothing.
fn order_told(param: &Param, content: &Content) -> Option<WordOrder> {
    let Content::Bits(bits, _) = content else { return None };
    let fits = |half: u32| half != 0 && param.max.is_none_or(|max| i64::from(half) <= max);
    match (bits >> 16, bits & 0xFFFF) {
        (0, low) if fits(low) => Some(WordOrder::HighFirst),
        (high, 0) if fits(high) => Some(WordOrder::LowFirst),
        _ => None,
    }
}

/// A value from what came, with the type that its width proves: `kind` where the width is the same.
pub(super) fn reading(param: &Param, set: u8, content: Content, kind: Type) -> Reading {
    let blank = Reading { set, raw: 0, text: None, kind, corrected: false };
    let text = |text| Reading { text: Some(text), kind: Type::String, ..blank.clone() };
    match content {
        // Digits only, but it is a string all the same.
        Content::Bits(bits, Width::Word) if kind == Type::String => text(format!("{bits:04X}")),
        Content::Bits(bits, Width::Long) if kind == Type::String => text(format!("{bits:08X}")),
        // All of it is shown, also where its type promises less.
        Content::Bits(bits, Width::AsAsked) => Reading { raw: value::from_wire(bits, Type::Long, None), ..blank },
        Content::Bits(bits, width) => {
            let kind = match width {
                Width::Long => Type::Long,
                Width::Word if kind.bits() == Some(16) => kind,
                _ => Type::Word,
            };
            Reading { raw: value::from_wire(bits, kind, param.min), kind, ..blank }
        }
        Content::Text(characters) => text(characters),
        Content::Done => blank,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::profile::Registry;

    #[test]
    fn the_address_proves_the_word_order_in_force_and_a_setting_of_0_proves_nothing() {
        let family = Registry::open(&[]).unwrap().family("lxm05").unwrap();
        let told = |role, bits| order_told(family.role(role).unwrap(), &Content::Bits(bits, Width::AsAsked));
        assert_eq!(told("address", 0x0000_0001), Some(WordOrder::HighFirst));
        assert_eq!(told("address", 0x00F7_0000), Some(WordOrder::LowFirst));
        assert_eq!(told("word-order", 0x0001_0000), Some(WordOrder::LowFirst));
        for (role, bits) in [("word-order", 0), ("address", 0), ("address", 0x00F8_0000), ("address", 0x0001_0001)] {
            assert_eq!(told(role, bits), None, "{role} {bits:08X}");
        }
    }
}
