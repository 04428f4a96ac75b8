//! Moves a drive to another protocol, address, speed or parity without losing it.
//!
//! Every step is one write. After one that moves the drive, the line follows, and the drive has to answer there before
//! the next. If it does not, but still answers where it was, everything is put back. What the values mean and when they
//! hold stands in the family's catalogue, `[link.line]`; format of VABus: sources A1.

mod bus;
mod journey;
mod plot;
mod said;

use plot::address_role;
pub use plot::course;

use super::interrupt::Interrupt;
use super::route::{Cell, Inquiry};
use super::session::Session;
use super::target::Target;
use crate::failure::{Class, Failure};
use crate::gate::{Line, Permit};
use crate::outcome::{self, ErrorDoc, Moves, Relocation, RelocationResult, RelocationStep, StepResult};
use crate::profile::{Family, Param, Role, Type};
use crate::protocol::Protocol;
use crate::protocol::can::SdoChannel;
use crate::protocol::line::{LineSetting, Parity};
use crate::protocol::modbus::{Framing, LAST_STATION};
use crate::text::{Text, Wrong, both};
use journey::{Journey, Setback, follow, is_taken};
use said::{ADDRESS, BAUD, left, lost, occupied, other_line, out_of_range};
use std::rc::Rc;

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
    /// P.395; on a CAN bus the channel, so that the one for tools is there (P.923) or not.
    pub protocol: Option<Protocol>,
    /// P.10: 2400, 4800, 9600, 19200, 57600 or 115200; on a CAN bus P.903, in bits per second.
    pub baud: Option<u32>,
    /// P.1375.
    pub parity: Option<Parity>,
    /// P.1376 while the drive speaks Modbus, 1-247; P.394 while it speaks VABus, 1-30.
    pub address: Option<u32>,
}

/// The way of a drive from where it is to where it is to be.
#[derive(Debug)]
pub struct Course {
    from: Place,
    to: Place,
    legs: Vec<Leg>,
    /// When a stored setting takes effect, in the words of the family.
    after_reset: Text,
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
    /// It changes at once, or when it is switched on the next time (docs/open-points.md); both are looked at.
    Perhaps(Change),
    /// It restarts, and is there.
    Restart(Place),
}

/// What is another one of a place.
#[derive(Clone, Copy, Debug)]
enum Change {
    Address(u8),
    Line(LineSetting),
    /// Bits per second of a CAN bus.
    Rate(u32),
    /// Of a CAN bus: the channel.
    Channel(SdoChannel),
}

impl Change {
    fn of(self, place: Place) -> Place {
        match self {
            Change::Address(address) => Place { address, ..place },
            Change::Line(line) => Place { line, ..place },
            Change::Rate(rate) => Place { line: LineSetting::can(rate), ..place },
            Change::Channel(channel) => Place { protocol: Protocol::Sdo(channel), ..place },
        }
    }

    /// Whether the drive is looked for where it was first: at another rate whoever asks disturbs those who are there, and over SDO1 a drive
    /// answers as well while it has SDO2.
    fn stays_first(self) -> bool {
        matches!(self, Change::Rate(_) | Change::Channel(SdoChannel::One))
    }
}

impl Place {
    fn usual(protocol: Protocol, baud: u32, parity: Parity, address: u8) -> Self {
        let line = match protocol {
            Protocol::Vabus => LineSetting::vabus(baud),
            Protocol::Modbus(_) | Protocol::Sdo(_) | Protocol::Pkw => protocol.line(baud, parity),
        };
        Place { protocol, line, address }
    }

    fn doc(self) -> outcome::Place {
        let LineSetting { baud, data_bits, parity, stop_bits } = self.line;
        let (protocol, parity) = (self.protocol.name(), parity.name());
        outcome::Place { protocol, baud, parity, data_bits, stop_bits, address: self.address, text: self.text() }
    }

    /// In words: `rtu 19200 8E1, address 1`.
    fn text(self) -> Text {
        let Place { protocol, line, address } = self;
        both!("{protocol} {line}, address {address}", "{protocol} {line}, Adresse {address}")
    }

    /// The options of our own command line that reach it.
    fn options(self) -> String {
        let Place { protocol, line, address } = self;
        if let Protocol::Sdo(_) = protocol {
            return format!("--protocol {protocol} -b {} -a {address}", line.baud);
        }
        let usual = protocol.line(line.baud, line.parity);
        let mut text = format!("--protocol {protocol} -b {} --parity {} -a {address}", line.baud, line.parity.name());
        if line.data_bits != usual.data_bits {
            text += &format!(" --data-bits {}", line.data_bits);
        }
        text
    }
}

/// Whether a drive can be set to it.
fn is_settable(protocol: &Protocol) -> bool {
    *protocol != Framing::Tcp.into() && *protocol != Protocol::Pkw
}

/// Speeds that drives of a family can be set to, with their values.
fn rates(family: &Family, is_on_bus: bool) -> &[(i64, u32)] {
    let line = &family.link.line;
    if is_on_bus { &line.bus_rates } else { &line.baud_rates }
}

impl Wish {
    /// Reads the name of a protocol that a drive can be set to: `rtu`, `ascii`, `vabus`; on a CAN bus `sdo` or `sdo1`.
    pub fn to_protocol(text: &str) -> Result<Self, Wrong> {
        let found = text.trim().to_ascii_lowercase().parse().ok().filter(is_settable);
        let protocol = found.ok_or_else(|| {
            Wrong(both!(
                "expected rtu, ascii or vabus, on a CAN bus sdo or sdo1, got '{text}'",
                "erwartet: rtu, ascii oder vabus, am CAN-Bus sdo oder sdo1; angegeben: '{text}'"
            ))
        })?;
        Ok(Wish { protocol: Some(protocol), ..Wish::default() })
    }

    /// Refuses what no drive of these families can be set to, over what is spoken with it now.
    pub fn check(&self, families: &[Rc<Family>], now: Protocol) -> Result<(), Failure> {
        let is_on_bus = now.is_can();
        if self.protocol.is_some_and(|to| to.is_can() != is_on_bus) || (is_on_bus && self.parity.is_some()) {
            return Err(other_line(is_on_bus));
        }
        let mut rates: Vec<u32> =
            families.iter().flat_map(|family| rates(family, is_on_bus)).map(|row| row.1).collect();
        rates.sort_unstable();
        rates.dedup();
        if rates.is_empty() {
            let message = both!(
                "no catalogue tells how the line of this drive is set",
                "kein Katalog sagt, wie die Leitung dieses Antriebs eingestellt wird"
            );
            return Err(Failure::new(Class::Data, "data.fixed_line", message));
        }
        if let Some(baud) = self.baud.filter(|baud| !rates.contains(baud)) {
            let rates = rates.iter().map(u32::to_string).collect::<Vec<_>>().join(", ");
            return Err(out_of_range(&BAUD, &rates, &baud));
        }
        match self.address.filter(|&address| !(1..=u32::from(LAST_STATION)).contains(&address)) {
            Some(address) => Err(out_of_range(&ADDRESS, &format!("1-{LAST_STATION}"), &address)),
            None => Ok(()),
        }
    }
}

/// The writes that bring a drive of this family, on a line that speaks `protocol`, to what is wished for, as far as they
/// can be told without asking it.
pub fn orders(wish: &Wish, protocol: Protocol, family: &Family) -> Vec<Inquiry> {
    let address = address_role(protocol);
    let line = &family.link.line;
    let is_on_bus = protocol.is_can();
    let baud = coded(rates(family, is_on_bus), wish.baud).map(|row| row.1);
    let parity = coded(&parities(family), wish.parity).map(|row| row.1);
    let restart = baud.or(parity).and(line.restart).filter(|_| !is_on_bus);
    let (speaks, rate) = if is_on_bus { (Role::BusTool, Role::BusRate) } else { (Role::Protocol, Role::BaudRate) };
    let spoken = if is_on_bus { bus::CHANNELS.to_vec() } else { protocols(family) };
    let writes = [
        (speaks.name(), coded(&spoken, wish.protocol).map(|row| row.1)),
        (address.name(), wish.address.map(i64::from)),
        (rate.name(), baud),
        (line.parity.as_str(), parity),
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
    pub fn details(&self) -> Vec<Text> {
        let step = |leg: &Leg| {
            let old = leg.old.map_or_else(String::new, |old| format!("{old} -> "));
            let when = match leg.then {
                Then::Stored => both!("holds after the restart", "gilt nach dem Neustart"),
                Then::At(_) => both!("holds at once", "gilt sofort"),
                Then::Perhaps(Change::Line(_)) => self.after_reset.clone(),
                Then::Perhaps(_) => both!(
                    "holds at once or when the drive is switched on the next time: its manual does not say; both are \
                     looked at",
                    "gilt sofort oder ab dem nächsten Einschalten: die Anleitung sagt es nicht; unter beiden wird \
                     nachgesehen"
                ),
                Then::Restart(_) => both!("restarts the drive", "startet den Antrieb neu"),
            };
            both!(
                "{label} {name}: {old}{raw}, {when}",
                "{label} {name}: {old}{raw}, {when}",
                label = leg.param.label(),
                name = leg.param.name,
                raw = leg.raw,
                when
            )
        };
        let way = Text::join([&self.from.text(), &self.to.text()], " -> ");
        let on_bus = self.legs.iter().filter(|_| self.from.line.is_can());
        let besides = on_bus.filter_map(|leg| bus::besides(leg.then));
        self.legs.iter().map(step).chain([way]).chain(besides).collect()
    }

    /// What can be told before anything is done, and if nothing has to be.
    pub fn told(&self, target: &Target) -> Relocation {
        let steps = self.legs.iter().map(|leg| RelocationStep {
            param: leg.param.id,
            name: leg.param.name.clone(),
            old_raw: leg.old,
            raw: leg.raw,
            text: target.family.text_of(&leg.param, leg.raw).cloned(),
            moves: match leg.then {
                Then::Stored => Moves::AfterRestart,
                Then::At(_) => Moves::AtOnce,
                Then::Perhaps(Change::Line(_)) => Moves::AfterRestart,
                Then::Perhaps(_) => Moves::Unsaid,
                Then::Restart(_) => Moves::Restart,
            },
            result: StepResult::Planned,
            error: None,
        });
        let waits = self.from != self.to;
        Relocation {
            address: self.from.address,
            drive: target.family.drive.clone(),
            from: self.from.doc(),
            to: self.to.doc(),
            steps: steps.collect(),
            // What is stored already, but not in force yet, waits for nothing but the restart.
            result: if self.is_done() && waits { RelocationResult::Stored } else { RelocationResult::Unchanged },
            now: Some(self.from.doc()),
            perhaps: Vec::new(),
            after_restart: (self.is_done() && waits).then(|| self.to.doc()),
            way_back: None,
        }
    }

    /// Looks whether somebody else answers already where the drive will pass or stay; the line is as before then.
    pub async fn check_free(&self, session: &mut Session<'_>, target: &mut Target) -> Result<(), Failure> {
        let places = self.legs.iter().filter_map(|leg| match leg.then {
            Then::At(place) | Then::Restart(place) => Some(place),
            // Nobody is asked at the rate of another bus, and over the other channel the drive itself may answer.
            Then::Perhaps(Change::Rate(_) | Change::Channel(_)) | Then::Stored => None,
            Then::Perhaps(change) => Some(change.of(self.from)),
        });
        for place in places.filter(|place| *place != self.from) {
            let taken = is_taken(session, target, place).await;
            let back = follow(session, target, self.from).await;
            if taken.and_then(|taken| back.map(|()| taken)).map_err(|error| error.failure(place.address, None))? {
                return Err(occupied(place));
            }
        }
        Ok(())
    }

    /// Goes the way. What became of it is told in any case; a failure beside it says why it is not what was wished for.
    pub async fn go(
        &self,
        session: &mut Session<'_>,
        target: &mut Target,
        permit: &Permit<Line>,
    ) -> (Relocation, Option<Failure>) {
        // Half a move is worse than one that takes some seconds longer.
        session.heed(Interrupt::default());
        let mut told = self.told(target);
        let mut journey = Journey { session, target, permit, here: self.from, undo: Vec::new() };
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
        if journey.here != self.to {
            told.result = RelocationResult::Stored;
            told.after_restart = Some(self.to.doc());
        }
        told.now = Some(journey.here.doc());
        told.way_back = self.way_back(journey.here, journey.session.port());
        (told, None)
    }

    /// Puts back what can be put back, and says where the drive is.
    async fn end(&self, journey: &mut Journey<'_, '_>, setback: Setback, told: &mut Relocation) -> Failure {
        if setback.is_lost() {
            told.result = RelocationResult::Lost;
            (told.now, told.perhaps) = (None, setback.perhaps.iter().map(|place| place.doc()).collect());
            told.after_restart = self.after_restart(&told.steps);
            return lost(setback.cause, &setback.perhaps, told.after_restart.as_ref());
        }
        let undone = journey.put_back().await;
        for step in told.steps.iter_mut().filter(|step| step.result == StepResult::Proven) {
            step.result = if undone.is_ok() { StepResult::Undone } else { StepResult::Unknown };
        }
        match undone {
            Ok(()) => {
                told.result = RelocationResult::Restored;
                told.now = Some(self.from.doc());
                left(setback.cause, &both!("left as it was", "gelassen, wie er war"), self.from)
            }
            Err(second) if second.is_lost() => {
                told.result = RelocationResult::Lost;
                (told.now, told.perhaps) = (None, second.perhaps.iter().map(|place| place.doc()).collect());
                told.after_restart = self.after_restart(&told.steps);
                lost(setback.cause, &second.perhaps, told.after_restart.as_ref())
            }
            Err(_) => {
                told.result = RelocationResult::Halfway;
                told.now = Some(journey.here.doc());
                told.after_restart = self.after_restart(&told.steps);
                let what = both!("not all of it could be put back", "nicht alles ließ sich zurücksetzen");
                left(setback.cause, &what, journey.here)
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
        // What is stored has to be put back too, wherever the drive answers now.
        let (from, to) = (self.from, self.to);
        let wish = if from.protocol != to.protocol {
            format!("protocol set {}", from.protocol)
        } else {
            let baud = (from.line.baud != to.line.baud).then(|| format!(" --baud {}", from.line.baud));
            let parity = (from.line.parity != to.line.parity).then(|| format!(" --parity {}", from.line.parity.name()));
            let address = (from.address != to.address).then(|| format!(" --address {}", from.address));
            let wished: String = [baud, parity, address].into_iter().flatten().collect();
            format!("line set{wished}")
        };
        (from != to).then(|| format!("antrieb -p {port} {} {wish}", here.options()))
    }
}

impl Leg {
    /// The write that undoes this one.
    fn back(&self, then: Then) -> Option<Leg> {
        Some(Leg { param: self.param.clone(), old: Some(self.raw), raw: self.old?, then })
    }
}

/// What the drives of a family can be told to speak.
fn protocols(family: &Family) -> Vec<(i64, Protocol)> {
    named(&family.link.line.protocols)
}

/// The parities that they can be set to.
fn parities(family: &Family) -> Vec<(i64, Parity)> {
    named(&family.link.line.parities)
}

fn named<T: std::str::FromStr>(rows: &[(i64, String)]) -> Vec<(i64, T)> {
    rows.iter().filter_map(|(raw, name)| Some((*raw, name.parse().ok()?))).collect()
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
