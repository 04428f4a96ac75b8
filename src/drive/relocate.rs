//! Moves a drive to another protocol, address, speed or parity without losing it.
//!
//! Every step is one write. After one that moves the drive, the line follows, and the drive has to answer there before
//! the next. If it does not, but still answers where it was, everything is put back. Sources: CM-485 manual 5.2 (P.10,
//! P.1375, P.1376, P.34), 6 (P.395), 11.2 (P.394); facts A1 (format of VABus).

mod journey;
mod plot;
mod said;

pub use plot::course;

use super::route::{Cell, Inquiry};
use super::session::Session;
use super::transfer::Target;
use crate::failure::Failure;
use crate::gate::Permit;
use crate::outcome::{self, ErrorDoc, Moves, Relocation, RelocationResult, RelocationStep, StepResult};
use crate::profile::{Family, Lang, Param, Type};
use crate::protocol::Protocol;
use crate::protocol::line::{LineSetting, Parity};
use crate::protocol::modbus::{Framing, LAST_STATION};
use journey::{Journey, Setback, follow, is_taken};
use said::{left, lost, occupied, out_of_range};
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

impl Leg {
    /// The write that undoes this one.
    fn back(&self, then: Then) -> Option<Leg> {
        Some(Leg { param: self.param.clone(), old: Some(self.raw), raw: self.old?, then })
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
