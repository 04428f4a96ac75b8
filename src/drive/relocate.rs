//! Moves a drive to another protocol, address, speed or parity without losing it.
//!
//! Every step is one write. After one that moves the drive, the line follows, and the drive has to answer there before
//! the next. If it does not, but still answers where it was, everything is put back. Sources: CM-485 manual 5.2 (P.10,
//! P.1375, P.1376, P.34), 6 (P.395), 11.2 (P.394); facts A1 (format of VABus).

mod said;

use super::route::{Cell, Inquiry};
use super::session::{AccessError, Session};
use super::transfer::{Order, Target, WriteFate};
use crate::exchange::ExchangeError;
use crate::failure::Failure;
use crate::gate::Permit;
use crate::outcome::{self, ErrorDoc, Moves, Relocation, RelocationResult, RelocationStep, StepResult};
use crate::profile::{Family, Lang, Param, Type};
use crate::protocol::Protocol;
use crate::protocol::line::{LineSetting, Parity};
use crate::protocol::modbus::{Framing, LAST_STATION};
use crate::protocol::vabus::Address;
use crate::tick::Span;
use said::{behind_another, cannot_follow, left, lost, occupied, out_of_range, unknown_settings, unmoved};
use std::fmt;

/// P.395 (CM-485 manual 6). 1 is the P-Bus, which nobody but its maker speaks.
const PROTOCOLS: [(i64, Protocol); 3] =
    [(0, Protocol::Vabus), (2, Protocol::Modbus(Framing::Rtu)), (3, Protocol::Modbus(Framing::Ascii))];
/// P.10 (CM-485 manual 5.2.1).
const BAUD_RATES: [(i64, u32); 6] = [(1, 2_400), (2, 4_800), (3, 9_600), (4, 19_200), (5, 57_600), (6, 115_200)];
/// P.1375 (CM-485 manual 5.2.1).
const PARITIES: [(i64, Parity); 3] = [(0, Parity::Even), (1, Parity::Odd), (2, Parity::None)];
/// P.34: restarts the software (CM-485 manual 5.2.1).
const RESTART: i64 = 123;
/// How often a step is tried while the drive still answers where it was.
const TRIES: u8 = 3;
/// The drive is "ready after a few seconds" (CM-485 manual 5.2.1).
const LONGEST_RESTART: Span = Span::from_secs(15);
/// Between two looks for a drive that restarts.
const PAUSE: Span = Span::from_millis(500);

/// How a drive is reached.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    protocol: Protocol,
    line: LineSetting,
    address: u8,
}

/// What a drive's line is to be; `None` leaves it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Wish {
    /// P.395.
    pub protocol: Option<Protocol>,
    /// P.10: 2400, 4800, 9600, 19200, 57600 or 115200.
    pub baud: Option<u32>,
    /// P.1375.
    pub parity: Option<Parity>,
    /// P.1376 while the drive speaks Modbus, 1-247; P.394 while it speaks VABus, 1-30.
    pub address: Option<u8>,
}

/// The way of a drive from where it is to where it is to be.
#[derive(Debug)]
pub struct Course {
    from: Place,
    to: Place,
    legs: Vec<Leg>,
}

/// One write of it.
#[derive(Clone, Debug)]
struct Leg {
    param: Param,
    old: Option<i64>,
    raw: i64,
    then: Then,
}

/// What follows a write.
#[derive(Clone, Copy, Debug)]
enum Then {
    /// Nothing before the next restart.
    Stored,
    /// The drive is there, at once.
    At(Place),
    /// It restarts, and is there.
    Restart(Place),
}

impl Place {
    fn usual(protocol: Protocol, baud: u32, parity: Parity, address: u8) -> Self {
        let line = match protocol {
            Protocol::Vabus => LineSetting::vabus(baud),
            Protocol::Modbus(_) => protocol.line(baud, parity),
        };
        Place { protocol, line, address }
    }

    fn doc(self) -> outcome::Place {
        let LineSetting { baud, data_bits, parity, stop_bits } = self.line;
        let (protocol, parity) = (self.protocol.name(), parity.name());
        outcome::Place { protocol, baud, parity, data_bits, stop_bits, address: self.address, text: self.to_string() }
    }

    /// The options of our own command line that reach it.
    fn options(self) -> String {
        let Place { protocol, line, address } = self;
        let usual = protocol.line(line.baud, line.parity);
        let mut text = format!("--protocol {protocol} -b {} --parity {} -a {address}", line.baud, line.parity.name());
        if line.data_bits != usual.data_bits {
            text += &format!(" --data-bits {}", line.data_bits);
        }
        text
    }
}

/// Prints `rtu 19200 8E1, address 1`.
impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}, address {}", self.protocol, self.line, self.address)
    }
}

impl Wish {
    /// Reads the name of a protocol that a drive can be set to: `rtu`, `ascii`, `vabus`.
    pub fn to_protocol(text: &str) -> Result<Self, String> {
        let found = PROTOCOLS.iter().find(|row| row.1.name().eq_ignore_ascii_case(text.trim()));
        let protocol = found.map(|row| row.1).ok_or_else(|| format!("expected rtu, ascii or vabus, got '{text}'"))?;
        Ok(Wish { protocol: Some(protocol), ..Wish::default() })
    }

    /// Refuses what no drive can be set to.
    pub fn check(&self, lang: Lang) -> Result<(), Failure> {
        if let Some(baud) = self.baud.filter(|baud| number(&BAUD_RATES, baud).is_none()) {
            let rates = BAUD_RATES.map(|row| row.1.to_string()).join(", ");
            return Err(out_of_range("baud", &rates, &baud, lang));
        }
        match self.address.filter(|address| !(1..=LAST_STATION).contains(address)) {
            Some(address) => Err(out_of_range("address", &format!("1-{LAST_STATION}"), &address, lang)),
            None => Ok(()),
        }
    }
}

/// The writes that bring a drive of this family, on a line that speaks `protocol`, to what is wished for, as far as they
/// can be told without asking it.
pub fn orders(wish: &Wish, protocol: Protocol, family: &Family) -> Vec<Inquiry> {
    let address = if protocol == Protocol::Vabus { "node-id" } else { "address" };
    let baud = coded(&BAUD_RATES, wish.baud).map(|row| row.1);
    let parity = coded(&PARITIES, wish.parity).map(|row| row.1);
    let restart = baud.or(parity).map(|_| RESTART);
    let writes = [
        ("protocol", coded(&PROTOCOLS, wish.protocol).map(|row| row.1)),
        (address, wish.address.map(i64::from)),
        ("baud-rate", baud),
        ("parity", parity),
        ("reset", restart),
    ];
    let order = |(role, raw): (&str, Option<i64>)| {
        let cell = Cell { number: family.role(role)?.id, set: 0 };
        Some(Inquiry::Write(cell, Type::Uint, u32::try_from(raw?).ok()?))
    };
    writes.into_iter().filter_map(order).collect()
}

/// Finds the way to what is wished for, by reading the settings of the drive; says why if there is none.
pub async fn course(
    session: &mut Session<'_>,
    target: &mut Target,
    wish: &Wish,
    lang: Lang,
) -> Result<Course, Failure> {
    let family = target.family.clone();
    wish.check(lang)?;
    if session.node() != 0 {
        return Err(behind_another(lang));
    }
    let row = |role| family.role(role).cloned().ok_or_else(|| unknown_settings(lang));
    let (protocol, baud, parity) = (row("protocol")?, row("baud-rate")?, row("parity")?);
    let (station, node, restart) = (row("address")?, row("node-id")?, row("reset")?);
    let (line, spoken) = (session.line(), session.protocol());
    let from = Place { protocol: spoken, line, address: target.address };
    let mut stored = async |param: &Param| {
        let reading = target.read_set(session, param, 0).await;
        reading.map(|reading| reading.raw).map_err(|error| error.failure(from.address, Some(&family), lang))
    };

    let mut here = from;
    let mut legs = Vec::new();
    if let Some((to, raw)) = coded(&PROTOCOLS, wish.protocol.filter(|to| *to != spoken)) {
        let address = stored(if to == Protocol::Vabus { &node } else { &station }).await?;
        let address = u8::try_from(address).map_err(|_| out_of_range("address", "1-247", &address, lang))?;
        // VABus does not know the parity of Modbus; the one in force is taken for the one that is stored.
        let kept = match spoken {
            Protocol::Modbus(_) => line.parity,
            Protocol::Vabus => meaning(&PARITIES, stored(&parity).await?).unwrap_or(Parity::Even),
        };
        here = Place::usual(to, line.baud, kept, address);
        legs.push(Leg { param: protocol, old: number(&PROTOCOLS, &spoken), raw, then: Then::At(here) });
    }
    if let Some(address) = wish.address.filter(|address| *address != here.address) {
        let (param, last) = match here.protocol {
            Protocol::Vabus => (node, Address::LAST),
            Protocol::Modbus(_) => (station, LAST_STATION),
        };
        if address > last {
            return Err(out_of_range("address", &format!("1-{last}"), &address, lang));
        }
        let old = Some(here.address.into());
        here.address = address;
        legs.push(Leg { param, old, raw: address.into(), then: Then::At(here) });
    }
    let mut restarts = false;
    if let Some((wished, raw)) = coded(&BAUD_RATES, wish.baud) {
        let old = stored(&baud).await?;
        legs.extend((old != raw).then_some(Leg { param: baud, old: Some(old), raw, then: Then::Stored }));
        restarts |= old != raw || line.baud != wished;
        here.line.baud = wished;
    }
    if let Some((wished, raw)) = coded(&PARITIES, wish.parity) {
        let old = stored(&parity).await?;
        let differs = here.protocol != Protocol::Vabus && here.line.parity != wished;
        legs.extend((old != raw).then_some(Leg { param: parity, old: Some(old), raw, then: Then::Stored }));
        restarts |= old != raw || differs;
        if differs {
            here.line = here.protocol.line(here.line.baud, wished);
        }
    }
    if restarts {
        legs.push(Leg { param: restart, old: None, raw: RESTART, then: Then::Restart(here) });
    }
    if here.line != from.line && !session.can_retune() {
        return Err(cannot_follow(session.port(), lang));
    }
    Ok(Course { from, to: here, legs })
}

impl Course {
    /// Whether the drive is there already.
    pub fn is_done(&self) -> bool {
        self.legs.is_empty()
    }

    /// Whether the drive restarts on the way.
    pub fn restarts(&self) -> bool {
        self.legs.iter().any(|leg| matches!(leg.then, Then::Restart(_)))
    }

    /// Every step in words, then from where to where.
    pub fn details(&self, lang: Lang) -> Vec<String> {
        let step = |leg: &Leg| {
            let old = leg.old.map_or_else(String::new, |old| format!("{old} -> "));
            let when = match leg.then {
                Then::Stored => lang.pick("holds after the restart", "gilt nach dem Neustart"),
                Then::At(_) => lang.pick("holds at once", "gilt sofort"),
                Then::Restart(_) => lang.pick("restarts the drive", "startet den Antrieb neu"),
            };
            format!("P.{} {}: {old}{}, {when}", leg.param.id, leg.param.name(lang), leg.raw)
        };
        self.legs.iter().map(step).chain([format!("{} -> {}", self.from, self.to)]).collect()
    }

    /// What can be told before anything is done, and if nothing has to be.
    pub fn told(&self, target: &Target, lang: Lang) -> Relocation {
        let steps = self.legs.iter().map(|leg| RelocationStep {
            param: leg.param.id,
            name: leg.param.name(lang).to_owned(),
            old_raw: leg.old,
            raw: leg.raw,
            text: target.family.text_of(&leg.param, leg.raw).map(|text| text.get(lang).to_owned()),
            moves: match leg.then {
                Then::Stored => Moves::AfterRestart,
                Then::At(_) => Moves::AtOnce,
                Then::Restart(_) => Moves::Restart,
            },
            result: StepResult::Planned,
            error: None,
        });
        Relocation {
            address: self.from.address,
            drive: target.family.drive.clone(),
            from: self.from.doc(),
            to: self.to.doc(),
            steps: steps.collect(),
            result: RelocationResult::Unchanged,
            now: Some(self.from.doc()),
            perhaps: Vec::new(),
            after_restart: None,
            way_back: None,
        }
    }

    /// Looks whether somebody else answers already where the drive will pass or stay; the line is as before then.
    pub async fn check_free(&self, session: &mut Session<'_>, target: &mut Target, lang: Lang) -> Result<(), Failure> {
        let places = self.legs.iter().filter_map(|leg| match leg.then {
            Then::At(place) | Then::Restart(place) => Some(place),
            Then::Stored => None,
        });
        for place in places.filter(|place| *place != self.from) {
            let taken = is_taken(session, target, place).await;
            let back = follow(session, target, self.from).await;
            if taken.and_then(|taken| back.map(|()| taken)).map_err(|error| error.failure(place.address, None, lang))? {
                return Err(occupied(place, lang));
            }
        }
        Ok(())
    }

    /// Goes the way. What became of it is told in any case; a failure beside it says why it is not what was wished for.
    pub async fn go(
        &self,
        session: &mut Session<'_>,
        target: &mut Target,
        permit: &Permit,
        lang: Lang,
    ) -> (Relocation, Option<Failure>) {
        // Half a move is worse than one that takes some seconds longer.
        session.ignore_interrupts();
        let mut told = self.told(target, lang);
        let mut journey = Journey { session, target, permit, lang, here: self.from, undo: Vec::new() };
        for (leg, step) in self.legs.iter().zip(&mut told.steps) {
            let setback = match journey.leg(leg).await {
                Ok(()) => {
                    step.result = StepResult::Proven;
                    continue;
                }
                Err(setback) => setback,
            };
            step.result = if setback.is_lost() { StepResult::Unknown } else { StepResult::Failed };
            step.error = Some(ErrorDoc::from(&setback.cause));
            let failure = self.end(&mut journey, setback, &mut told).await;
            return (told, Some(failure));
        }
        if !self.is_done() {
            told.result = RelocationResult::Moved;
        }
        told.now = Some(journey.here.doc());
        told.way_back = self.way_back(journey.here, journey.session.port());
        (told, None)
    }

    /// Puts back what can be put back, and says where the drive is.
    async fn end(&self, journey: &mut Journey<'_, '_>, setback: Setback, told: &mut Relocation) -> Failure {
        let lang = journey.lang;
        if setback.is_lost() {
            told.result = RelocationResult::Lost;
            (told.now, told.perhaps) = (None, setback.perhaps.iter().map(|place| place.doc()).collect());
            told.after_restart = self.after_restart(&told.steps);
            return lost(setback.cause, &setback.perhaps, told.after_restart.as_ref(), lang);
        }
        let undone = journey.put_back().await;
        for step in told.steps.iter_mut().filter(|step| step.result == StepResult::Proven) {
            step.result = if undone.is_ok() { StepResult::Undone } else { StepResult::Unknown };
        }
        match undone {
            Ok(()) => {
                told.result = RelocationResult::Restored;
                told.now = Some(self.from.doc());
                left(setback.cause, lang.pick("left as it was", "gelassen, wie er war"), self.from, lang)
            }
            Err(second) if second.is_lost() => {
                told.result = RelocationResult::Lost;
                (told.now, told.perhaps) = (None, second.perhaps.iter().map(|place| place.doc()).collect());
                told.after_restart = self.after_restart(&told.steps);
                lost(setback.cause, &second.perhaps, told.after_restart.as_ref(), lang)
            }
            Err(_) => {
                told.result = RelocationResult::Halfway;
                told.now = Some(journey.here.doc());
                told.after_restart = self.after_restart(&told.steps);
                let what = lang.pick("not all of it could be put back", "nicht alles ließ sich zurücksetzen");
                left(setback.cause, what, journey.here, lang)
            }
        }
    }

    /// Where a restart would take the drive, if something that waits for one may have been written.
    fn after_restart(&self, steps: &[RelocationStep]) -> Option<outcome::Place> {
        let written = |step: &&RelocationStep| matches!(step.result, StepResult::Proven | StepResult::Unknown);
        steps.iter().filter(written).find(|step| step.moves != Moves::AtOnce)?;
        Some(self.to.doc())
    }

    /// The command line that goes back from where the drive is.
    fn way_back(&self, here: Place, port: &str) -> Option<String> {
        let from = self.from;
        let wish = if from.protocol != here.protocol {
            format!("protocol set {}", from.protocol)
        } else {
            let baud = (from.line.baud != here.line.baud).then(|| format!(" --baud {}", from.line.baud));
            let parity =
                (from.line.parity != here.line.parity).then(|| format!(" --parity {}", from.line.parity.name()));
            let address = (from.address != here.address).then(|| format!(" --address {}", from.address));
            let wished: String = [baud, parity, address].into_iter().flatten().collect();
            format!("line set{wished}")
        };
        (from != here).then(|| format!("antrieb -p {port} {} {wish}", here.options()))
    }
}

/// A drive on its way.
struct Journey<'j, 's> {
    session: &'j mut Session<'s>,
    target: &'j mut Target,
    permit: &'j Permit,
    lang: Lang,
    /// Where it answered last.
    here: Place,
    /// What puts it back, in the order in which it was done.
    undo: Vec<Leg>,
}

/// Why a step is not done.
struct Setback {
    cause: Failure,
    /// Where the drive may be, the likeliest first; empty while it still answers where it was.
    perhaps: Vec<Place>,
}

impl Setback {
    fn is_lost(&self) -> bool {
        !self.perhaps.is_empty()
    }
}

impl Journey<'_, '_> {
    async fn leg(&mut self, leg: &Leg) -> Result<(), Setback> {
        match leg.then {
            Then::Stored => self.store(leg).await,
            Then::At(place) => self.hop(leg, place).await,
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
                return Err(Setback { cause: unmoved(self.here, self.lang), perhaps: Vec::new() });
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
                    let cause = last.as_ref().map_or_else(|| unmoved(place, self.lang), |error| self.failure(error));
                    return Err(Setback { cause, perhaps: both });
                }
                Err(error) => return Err(Setback { cause: self.failure(&error), perhaps: both }),
            }
        }
        let cause = last.as_ref().map_or_else(|| unmoved(place, self.lang), |error| self.failure(error));
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
        Err(Setback { cause: unmoved(place, self.lang), perhaps })
    }

    /// Puts everything back that was done, the last first.
    async fn put_back(&mut self) -> Result<(), Setback> {
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
            let others = PARITIES.iter().filter(|row| row.1 != place.line.parity);
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
        follow(self.session, self.target, place).await?;
        let usual = retries.map(|retries| self.session.set_retries(retries));
        let Some(param) = self.target.family.role("protocol").cloned() else { return Ok(false) };
        let reading = self.target.read_set(self.session, &param, 0).await;
        if let Some(usual) = usual {
            self.session.set_retries(usual);
        }
        match reading {
            Ok(reading) => Ok(Some(reading.raw) == number(&PROTOCOLS, &place.protocol)),
            Err(error) if error.is_fatal() => Err(error),
            Err(_) => Ok(false),
        }
    }

    fn failure(&self, error: &AccessError) -> Failure {
        error.failure(self.here.address, Some(&self.target.family), self.lang)
    }
}

impl Leg {
    /// The write that undoes this one.
    fn back(&self, then: Then) -> Option<Leg> {
        Some(Leg { param: self.param.clone(), old: Some(self.raw), raw: self.old?, then })
    }
}

/// Speaks as it is spoken there, from now on.
async fn follow(session: &mut Session<'_>, target: &mut Target, place: Place) -> Result<(), AccessError> {
    target.address = place.address;
    if (session.protocol(), session.line()) == (place.protocol, place.line) {
        return Ok(());
    }
    session.retune(place.protocol, place.line).await
}

/// Whether anybody answers there, whatever he says.
async fn is_taken(session: &mut Session<'_>, target: &mut Target, place: Place) -> Result<bool, AccessError> {
    follow(session, target, place).await?;
    let Some(question) = super::family::probe(place.protocol, place.address) else { return Ok(false) };
    let usual = session.set_retries(0);
    let answer = session.ask(place.address, question).await;
    session.set_retries(usual);
    match answer {
        Ok(_) => Ok(true),
        Err(AccessError::Exchange(ExchangeError::Silence { .. })) => Ok(false),
        Err(AccessError::Exchange(_)) => Ok(true),
        Err(error) => Err(error),
    }
}

/// What is wished for, with the value that stands for it.
fn coded<T: PartialEq>(rows: &[(i64, T)], wished: Option<T>) -> Option<(T, i64)> {
    let wished = wished?;
    number(rows, &wished).map(|raw| (wished, raw))
}

fn number<T: PartialEq>(rows: &[(i64, T)], meaning: &T) -> Option<i64> {
    rows.iter().find(|row| row.1 == *meaning).map(|row| row.0)
}

fn meaning<T: Copy>(rows: &[(i64, T)], number: i64) -> Option<T> {
    rows.iter().find(|row| row.0 == number).map(|row| row.1)
}
