//! The PDOs of a node: what goes out and when, what came and when it is handed on, what is missed (EM-RES-03 manual 5.7.2, 5.9.2,
//! 5.11).
//!
//! Choices where the manual is silent:
//! - a TxPDO by time goes out for the first time when its time is over;
//! - a remote request for a PDO is not answered;
//! - a telegram that is missed is missed again when its time-out is over once more; a PDO that is off is not missed;
//! - words arrive without a sign, longs with one.

use super::readings::{Reading, Readings};
use super::settings::{Function, Rx, Settings, Tx};
use crate::protocol::can::Frame;
use crate::protocol::can::pdo::{Kind, Pdo, Place};
use crate::simulator::device::contract::OnSystemBus;
use crate::tick::{Span, Tick};

/// The PDOs of a node.
#[derive(Clone, Debug, Default)]
pub(super) struct Process {
    pub(super) settings: Settings,
    readings: Readings,
    /// PDOs flow in Operational only.
    flows: bool,
    sends: [Option<Tick>; 3],
    /// What came and is not handed on yet.
    came: [Option<Pdo>; 3],
    /// What came by time is handed on then.
    hands_on: Option<Tick>,
    /// When SYNC and the RxPDOs are missed.
    missed: [Option<Tick>; 4],
}

/// Faults of the time-outs: SYNC, RxPDO1 to 3 (manual 5.11.3).
const MISSED: [u16; 4] = [0x2200, 0x2201, 0x2202, 0x2203];
/// RxPDOs by time are looked at so often (manual 5.7.2, 5.11.2).
const POLLING: u64 = 1_000;
/// First source of an RxPDO, and of its words and longs behind it (manual 5.11.5.2).
const FIRST_SOURCE: u16 = 700;
/// Sources that have four bytes, as far as the manual lists them (5.11.5.1).
const LONGS: [u16; 5] = [0, 1, 5, 50, 62];

impl Process {
    pub(super) fn new(readings: Readings) -> Self {
        Process { readings, ..Process::default() }
    }

    /// The settings are these from now on.
    pub(super) fn set(&mut self, now: Tick, settings: Settings) {
        if self.settings != settings {
            self.settings = settings;
            if self.flows {
                self.begin(now);
            }
        }
    }

    /// Operational, or not any more.
    pub(super) fn turn(&mut self, now: Tick, flows: bool, bus: Option<&mut dyn OnSystemBus>) {
        if self.flows == flows {
            return;
        }
        self.flows = flows;
        if flows {
            return self.begin(now);
        }
        self.sends = [None; 3];
        self.came = [None; 3];
        self.hands_on = None;
        if !self.readings.has(Reading::WatchedEverywhere) {
            self.missed = [None; 4];
        }
        if let Some(bus) = bus.filter(|_| self.readings.has(Reading::LeavingEmpties)) {
            let empty: Vec<_> = self.settings.rx.iter().flat_map(|rx| self.values(rx, Pdo::default())).collect();
            bus.receive(now, &empty);
        }
    }

    fn begin(&mut self, now: Tick) {
        for (sends, tx) in self.sends.iter_mut().zip(&self.settings.tx) {
            *sends = tx.every.filter(|_| tx.function == Function::Time).map(|every| now + every);
        }
        let begun = !self.readings.has(Reading::WatchBeginsWithFirst);
        for place in 0..MISSED.len() {
            let until = self.patience(place).filter(|_| begun).map(|patience| now + patience);
            self.missed.get_mut(place).map(|missed| *missed = until).unwrap_or_default();
        }
    }

    /// How long SYNC (0) or an RxPDO may be missing.
    fn patience(&self, place: usize) -> Option<Span> {
        match place.checked_sub(1) {
            None => self.settings.sync_timeout.filter(|_| self.settings.uses_sync()),
            Some(place) => self.settings.rx.get(place).filter(|rx| rx.function != Function::Off)?.timeout,
        }
    }

    /// SYNC (0) or an RxPDO has come.
    fn feed(&mut self, now: Tick, place: usize) {
        let until = self.patience(place).map(|patience| now + patience);
        self.missed.get_mut(place).map(|missed| *missed = until).unwrap_or_default();
    }

    /// When something will happen by itself.
    pub(super) fn next(&self) -> Option<Tick> {
        self.sends.iter().chain(&self.missed).chain([&self.hands_on]).flatten().copied().min()
    }

    /// What goes out now, and the fault of what is missed.
    pub(super) fn run(&mut self, now: Tick, bus: &mut dyn OnSystemBus) -> (Vec<Frame>, Option<u16>) {
        let mut out = Vec::new();
        for (sends, tx) in self.sends.iter_mut().zip(&self.settings.tx) {
            if sends.is_some_and(|at| at <= now) {
                *sends = tx.every.map(|every| now + every);
                out.extend(filled(tx, self.readings, bus));
            }
        }
        if self.hands_on.is_some_and(|at| at <= now) {
            self.hands_on = None;
            self.hand_on(now, Function::Time, bus);
        }
        let mut fault = None;
        for (place, code) in MISSED.into_iter().enumerate() {
            if self.missed.get(place).is_some_and(|missed| missed.is_some_and(|at| at <= now)) {
                self.feed(now, place);
                fault = fault.or(Some(code));
            }
        }
        (out, fault)
    }

    /// A frame with these bytes was on the bus; what goes out behind it.
    pub(super) fn hear(&mut self, now: Tick, identifier: u16, bytes: &[u8], bus: &mut dyn OnSystemBus) -> Vec<Frame> {
        if !self.flows {
            return Vec::new();
        }
        let has_data = !bytes.is_empty() && self.readings.has(Reading::SyncHasNoData);
        let out = if identifier == self.settings.sync && !has_data { self.sync(now, bus) } else { Vec::new() };
        let whole = self.readings.has(Reading::ShortIsTaken) || bytes.len() == Pdo::LEN;
        let mut pdo = Pdo::default();
        pdo.0.iter_mut().zip(bytes).for_each(|(byte, new)| *byte = *new);
        let meant = |rx: &Rx| rx.identifier == identifier && rx.function != Function::Off && whole;
        let places: Vec<usize> = (0..).zip(&self.settings.rx).filter(|row| meant(row.1)).map(|row| row.0).collect();
        for place in places {
            let by_time = self.settings.rx.get(place).is_some_and(|rx| rx.function == Function::Time);
            self.came.get_mut(place).map(|came| *came = Some(pdo)).unwrap_or_default();
            if by_time {
                let at = Tick::ZERO + Span::from_micros((now.as_micros() / POLLING + 1) * POLLING);
                self.hands_on = self.hands_on.or(Some(at));
            }
            if by_time || !self.readings.has(Reading::HandOverFeeds) {
                self.feed(now, place + 1);
            }
        }
        out
    }

    /// A SYNC, heard or sent; what goes out behind it.
    pub(super) fn sync(&mut self, now: Tick, bus: &mut dyn OnSystemBus) -> Vec<Frame> {
        if !self.flows {
            return Vec::new();
        }
        self.feed(now, 0);
        let hands_on_first = self.readings.has(Reading::SyncHandsOnFirst);
        if hands_on_first {
            self.hand_on(now, Function::Sync, bus);
        }
        let due = self.settings.tx.iter().filter(|tx| tx.function == Function::Sync);
        let out = due.filter_map(|tx| filled(tx, self.readings, bus)).collect();
        if !hands_on_first {
            self.hand_on(now, Function::Sync, bus);
        }
        out
    }

    /// What came goes to its sources.
    fn hand_on(&mut self, now: Tick, function: Function, bus: &mut dyn OnSystemBus) {
        for place in 0..self.came.len() {
            let Some(rx) = self.settings.rx.get(place).filter(|rx| rx.function == function).cloned() else { continue };
            let Some(pdo) = self.came.get_mut(place).and_then(Option::take) else { continue };
            bus.receive(now, &self.values(&rx, pdo));
            if function == Function::Sync && self.readings.has(Reading::HandOverFeeds) {
                self.feed(now, place + 1);
            }
        }
    }

    /// What a PDO brings to which source (manual 5.11.5.2).
    fn values(&self, rx: &Rx, pdo: Pdo) -> Vec<(u16, i64)> {
        let first = FIRST_SOURCE + 10 * rx.number.index();
        let value = |place: Place| {
            let raw = pdo.get(place);
            match place.kind() {
                Kind::Boolean if self.readings.has(Reading::TrueIsBitZero) => (first, i64::from(raw & 1)),
                Kind::Boolean => (first, i64::from(raw != 0)),
                Kind::Word => (first + 4, i64::from(raw)),
                Kind::Long => (first + 8, i64::from(raw as i32)),
            }
        };
        Place::all().map(|place| (value(place).0 + place.index(), value(place).1)).collect()
    }
}

/// A TxPDO with what its sources tell.
fn filled(tx: &Tx, readings: Readings, bus: &mut dyn OnSystemBus) -> Option<Frame> {
    let mut pdo = Pdo::default();
    let earlier = readings.has(Reading::EarlierInputWins);
    let inputs: Vec<_> = if earlier { tx.inputs.iter().rev().collect() } else { tx.inputs.iter().collect() };
    for (place, source) in inputs {
        let value = bus.source(*source);
        let raw = match place.kind() {
            Kind::Boolean if value == 0 => 0,
            Kind::Boolean if readings.has(Reading::TrueIsAllOnes) => 0xFFFF,
            Kind::Boolean => 1,
            Kind::Word if is_long(*source) && readings.has(Reading::LongGivesHighWord) => (value >> 16) as u32,
            Kind::Word if is_long(*source) && readings.has(Reading::LongGivesNothing) => 0,
            Kind::Word | Kind::Long => value as u32,
        };
        pdo.set(*place, raw);
    }
    Frame::data(tx.identifier, &pdo.0)
}

fn is_long(source: u16) -> bool {
    LONGS.contains(&source) || (FIRST_SOURCE..FIRST_SOURCE + 30).contains(&source) && source % 10 >= 8
}
