//! Reading parameters of one drive: widths, data sets, refusals, what is cleared by reading.

use super::access::{AccessError, Refusal};
use super::route::{Cell, Content, Inquiry, Width, no};
use super::session::Session;
use super::target::Target;
use crate::exchange::{Answer, ExchangeError, Said};
use crate::profile::{DataSets, Param, Role, Sets, Type, value};
use crate::protocol::Protocol;

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

impl Target {
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
            let four = param.sets == Some(Sets::Four);
            let differ = result.as_ref().is_err_and(|error| error.sets_differ() || four && error.may_differ());
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
        let cell = Cell { number: param.id, set };
        if self.family.role(Role::ErrorRegister).is_some_and(|register| register.id == param.id) {
            return self.read_once(session, param, cell).await;
        }
        let stated = self.widths.get(&param.id).copied().or(param.kind);
        if stated.is_none() && !proves_width(session, param) {
            self.unstated.insert(param.id);
        }
        let first = stated.unwrap_or(Type::Word);
        let error = match self.read_as(session, param, cell, first).await {
            Ok(reading) => return Ok(self.found(param, reading)),
            Err(error) => error,
        };
        let doubtful = stated.is_none() || param.unconfirmed.iter().any(|field| field == "type" || field == "row");
        if !(doubtful && error.refusal().is_some_and(Refusal::is_of_width)) {
            return Err(error);
        }
        let second = if first.bits() == Some(32) { Type::Word } else { Type::Long };
        match self.read_as(session, param, cell, second).await {
            Ok(reading) => Ok(self.found(param, reading)),
            // It has this width: refused is set 0, because the four behind it differ.
            Err(differ) if differ.sets_differ() => {
                self.widths.insert(param.id, second);
                Err(differ)
            }
            Err(AccessError::Refused(again)) if again.is_of_width() || again.no.is_of_what_was_asked() => Err(error),
            // Whoever is busy, or cannot tell a value, says so of the width that is right.
            Err(other) => Err(other),
        }
    }

    /// Reads what is cleared by reading, unless recognising the drive has read it: then what was heard there counts, also
    /// that nothing was heard.
    async fn read_once(
        &mut self,
        session: &mut Session<'_>,
        param: &Param,
        cell: Cell,
    ) -> Result<Reading, AccessError> {
        let kind = param.kind.unwrap_or(Type::Uint);
        if let Some(kept) = self.kept_register.take() {
            return Ok(reading(param, cell.set, Content::Bits(kept?.into(), Width::Word), kind));
        }
        let route = self.route(session).await?;
        let question = route.question(Inquiry::Read(cell, kind)).ok_or(AccessError::Unspeakable)?;
        let Answer::Reply { said, .. } = session.ask_once(route, question).await? else {
            return Err(AccessError::Unspeakable);
        };
        if let Some(no) = no(&said) {
            return Err(AccessError::Refused(Refusal { no, cause: no.cause(), unheard: false, taken: None }));
        }
        match route.misshapen(&said, kind) {
            Some(bytes) => Err(misshapen(&said, 1, bytes).into()),
            None => Ok(reading(param, cell.set, route.content(&said).ok_or(AccessError::Unspeakable)?, kind)),
        }
    }

    /// Reads those of the parameters that lie next to each other, in as few telegrams as possible. What is not
    /// returned, alone or refused with its neighbours, is to be read one by one. Whatever ends the session, what was read
    /// stays.
    pub async fn neighbours(
        &mut self,
        session: &mut Session<'_>,
        params: &[Param],
    ) -> (Vec<(u32, Reading)>, Result<(), AccessError>) {
        let way = self.family.link.route;
        let mut readings = Vec::new();
        let lines = params.chunk_by(|one, next| way.neighbour(one.id) == Some(next.id));
        let chunks = lines.flat_map(|line| line.chunks(way.most())).filter(|chunk| chunk.len() > 1);
        for chunk in chunks {
            if chunk.iter().any(|param| self.apart.contains(&param.id)) {
                continue;
            }
            match self.read_chunk(session, chunk).await {
                Ok(chunk) => readings.extend(chunk),
                Err(error) if error.is_fatal() => return (readings, Err(error)),
                Err(AccessError::Refused(refusal)) if !refusal.no.passes() => {
                    self.apart.extend(chunk.iter().map(|param| param.id));
                }
                Err(_) => {}
            }
        }
        (readings, Ok(()))
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

    /// Reads a parameter at this width, and at no other.
    pub(super) async fn read_as(
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
            let answer = session.demand(route, &self.family, question.clone()).await;
            if let Err(error) = &answer
                && session.bears(error, asked).await?
            {
                continue;
            }
            let answer = match answer {
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
            match route.misshapen(&said, kind).filter(|_| sure || matches!(said, Said::Sdo(_))) {
                None => return Ok(reading(param, cell.set, content, kind)),
                Some(_) if asked <= session.limits().retries => {}
                Some(bytes) => return Err(misshapen(&said, asked, bytes).into()),
            }
        }
    }

    /// Remembers the width that turned out to be the right one, also where a file or an option says another.
    fn found(&mut self, param: &Param, reading: Reading) -> Reading {
        let usual = param.kind.filter(|stated| stated.bits() == reading.kind.bits());
        let corrected = param.kind.is_some() && usual.is_none();
        let is_other = |known: &Type| known.bits() != reading.kind.bits();
        if usual.is_none() || self.widths.get(&param.id).is_some_and(is_other) {
            self.widths.insert(param.id, usual.unwrap_or(reading.kind));
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
            // What refuses its value for all data sets may have told its width.
            Err(error) => self.known_width(param.id).ok_or(error),
        }
    }

    /// The type of a parameter that was found out or set in this run.
    pub fn known_width(&self, param: u32) -> Option<Type> {
        self.widths.get(&param).copied()
    }

    /// The data set (0-4) in which the drive works with a parameter; 0 where it exists once.
    pub async fn working_set(&mut self, session: &mut Session<'_>, param: &Param) -> Result<u8, AccessError> {
        let active = self.family.role(Role::ActiveSet).filter(|_| param.sets == Some(Sets::Four)).cloned();
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
        self.unstated.remove(&param);
    }

    /// Whether nobody has told the width of a parameter, nor did its answer.
    pub(super) fn is_untold(&self, param: u32) -> bool {
        self.unstated.contains(&param)
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
        Content::Bits(bits, Width::AsAsked) => {
            let whole = if kind == Type::Float { kind } else { Type::Long };
            Reading { raw: value::from_wire(bits, whole, None), ..blank }
        }
        Content::Bits(bits, Width::Untold) => untold(param, bits, kind, &blank),
        Content::Bits(bits, Width::AsKnown) => Reading { raw: value::from_wire(bits, kind, param.min), ..blank },
        Content::Bits(bits, width) => {
            let kind = match width {
                Width::Long if kind.bits() == Some(32) => kind,
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

/// Whether nobody knows what this value of a parameter is.
pub(super) fn hides_width(session: &Session<'_>, param: &Param, raw: i64) -> bool {
    !proves_width(session, param) && !is_alike(raw)
}

/// Whether the width of a parameter is certain once it was read: no source tells it, and over SDO no answer does (EM-RES-03 manual 5.10.1).
pub(super) fn proves_width(session: &Session<'_>, param: &Param) -> bool {
    param.kind.is_some() || !matches!(session.protocol(), Protocol::Sdo(_))
}

/// Whether a word and a long that hold this are the same over SDO.
pub(super) fn is_alike(raw: i64) -> bool {
    (0..=i64::from(i16::MAX)).contains(&raw)
}

/// Whether a reply carries its length, so that it tells a width by itself.
pub(super) fn tells_width(session: &Session<'_>) -> bool {
    session.protocol() == Protocol::Vabus
}

/// A value of which always four bytes come. A word fills the lower two; of one below zero the upper two are zero, as the manual prints
/// it, or say the sign once more. What is neither is no word, and is shown whole.
fn untold(param: &Param, bits: u32, kind: Type, blank: &Reading) -> Reading {
    let (high, low) = (bits >> 16, bits & 0xFFFF);
    let is_word = high == 0 || high == 0xFFFF && low & 0x8000 != 0 && param.kind != Some(Type::Uint);
    match kind.bits() {
        Some(16) if is_word => Reading { raw: value::from_wire(low, kind, param.min), ..blank.clone() },
        Some(32) => Reading { raw: value::from_wire(bits, kind, param.min), ..blank.clone() },
        _ => Reading { raw: value::from_wire(bits, Type::Long, None), kind: Type::Long, ..blank.clone() },
    }
}

/// What an answer is whose value has no form: disturbed, or over SDO announced in pieces.
fn misshapen(said: &Said, asked: u8, bytes: Vec<u8>) -> ExchangeError {
    match said {
        Said::Sdo(_) => ExchangeError::Pieces { asked },
        _ => ExchangeError::Garbled { asked, bytes },
    }
}
