//! A line on which everything goes wrong that goes wrong on lines, by chance, with stations behind it that tell the truth.
//!
//! What the stations keep to (CM-485 manual 6.8; 6 s and 500 ms: docs/measured.md): each answers in the order in which it was asked, not
//! later than 6 s; a copy comes up to 500 ms after the end of what it copies. Two telegrams at once spoil each other, but a
//! station that is nearer to another master may hear his question all the same, where it ends before ours does.

use super::dice::Dice;
use super::stations::{CELLS, STATIONS, STRANGER};
use antrieb::protocol::Protocol;
use antrieb::protocol::line::LineSetting;
use antrieb::protocol::modbus::Framing;
use antrieb::protocol::modbus::pdu::{ParamAddress, Request};
use antrieb::tick::{Span, Tick};
use std::collections::{BTreeMap, HashSet};

const LATEST_MS: u64 = 6_000;
const COPY_MS: u64 = 500;
const SLICE: Span = Span::from_millis(2);

/// What the line does, each once in so many telegrams; 0: never.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Hazards {
    pub(crate) late: u64,
    /// A gateway that hands replies on whole, and some so late that younger ones overtake them.
    pub(crate) overtaken: u64,
    pub(crate) doubled: u64,
    /// A second drive at every address, with other values.
    pub(crate) twins: bool,
    pub(crate) lost: u64,
    pub(crate) foreign: u64,
    pub(crate) echo: u64,
    pub(crate) noise: u64,
    pub(crate) torn: u64,
    pub(crate) flipped: u64,
    /// So often there is a pause before a question, in which nobody reads.
    pub(crate) pause: u64,
    /// Another master; its pauses, in milliseconds.
    pub(crate) master: Option<u64>,
    /// It asks our stations too.
    pub(crate) shared: bool,
}

impl Hazards {
    /// About every third of them, each as often as the dice say.
    pub(crate) fn thrown(dice: &mut Dice) -> Self {
        let mut often = || if dice.one_in(3) { 2 + dice.below(20) } else { 0 };
        let (late, doubled, lost, foreign) = (often(), often(), often(), often());
        let (noise, torn, flipped, pause) = (often(), often(), often(), often());
        let echo = dice.pick(&[0, 0, 0, 0, 1, 7]);
        Hazards { late, doubled, lost, foreign, echo, noise, torn, flipped, pause, ..Hazards::default() }
    }
}

/// Bytes that are on their way to the master.
#[derive(Debug)]
struct Piece {
    start: Tick,
    end: Tick,
    /// When the program may read them.
    at: Tick,
    bytes: Vec<u8>,
    whole: bool,
}

#[derive(Debug)]
pub(crate) struct HostileLine {
    pub(crate) now: Tick,
    pub(crate) hazards: Hazards,
    pub(super) protocol: Protocol,
    line: LineSetting,
    pub(super) dice: Dice,
    pieces: Vec<Piece>,
    /// Our own telegram.
    ours: (Tick, Tick),
    busy: BTreeMap<(u8, bool), Tick>,
    pub(super) count: u16,
    /// So much more a twin has counted, which may have been switched on earlier.
    pub(super) ahead: u16,
    /// Valid telegrams that somebody really sent.
    told: HashSet<Vec<u8>>,
    /// When the other master asks next.
    other: Tick,
    /// Its questions that are on the wire: start, end.
    questions: Vec<(Tick, Tick, Vec<u8>)>,
}

impl HostileLine {
    pub(crate) fn new(protocol: Protocol, line: LineSetting, hazards: Hazards, mut dice: Dice) -> Self {
        let ahead = if hazards.twins { dice.pick(&[0, 0, 3, 40]) } else { 0 };
        HostileLine {
            now: Tick::ZERO,
            hazards,
            protocol,
            line,
            dice,
            pieces: Vec::new(),
            ours: (Tick::ZERO, Tick::ZERO),
            busy: BTreeMap::new(),
            count: 0,
            ahead,
            told: HashSet::new(),
            other: Tick::ZERO,
            questions: Vec::new(),
        }
    }

    /// A pause between two questions. What comes in it nobody reads, but for a driver that keeps it.
    pub(crate) fn pause(&mut self) {
        if self.dice.one_in(self.hazards.pause) {
            self.now += Span::from_millis(self.dice.below(8_000));
        }
    }

    /// What has come by now and was not read.
    pub(crate) fn waiting(&mut self) -> Vec<u8> {
        self.meddle(self.now);
        self.take()
    }

    /// Whether telegrams have numbers, and no check value of their own.
    pub(crate) fn is_numbered(&self) -> bool {
        self.protocol == Protocol::Modbus(Framing::Tcp)
    }

    /// Whether a telegram with these bytes was ever sent by anybody.
    pub(crate) fn was_told(&self, telegram: &[u8]) -> bool {
        self.told.contains(telegram)
    }

    pub(crate) fn wait(&mut self, until: Tick) -> Vec<u8> {
        loop {
            // No further than anybody can foresee: what we send may meet what the other master sends.
            let slice = if self.hazards.master.is_some() { until.min(self.now + SLICE) } else { until };
            self.meddle(slice);
            self.settle();
            let first = self.pieces.first().map(|piece| piece.at).filter(|&at| at <= slice);
            self.now = self.now.max(first.unwrap_or(slice));
            if first.is_some() || self.now >= until {
                return self.take();
            }
        }
    }

    fn take(&mut self) -> Vec<u8> {
        let now = self.now;
        self.settle();
        let due = self.pieces.partition_point(|piece| piece.at <= now);
        self.pieces.drain(..due).flat_map(|piece| piece.bytes).collect()
    }

    /// What an adapter holds back holds back what follows: no byte overtakes another.
    fn settle(&mut self) {
        self.pieces.sort_by_key(|piece| piece.end);
        let mut last = Tick::ZERO;
        for piece in &mut self.pieces {
            piece.at = piece.at.max(last);
            last = piece.at;
        }
    }

    /// The master sends now.
    pub(crate) fn send(&mut self, bytes: &[u8]) {
        let end = self.now + self.duration(bytes.len());
        self.meddle(end);
        self.ours = (self.now, end);
        let met = self.hazards.overtaken == 0 && self.spoil(self.now, end);
        if self.dice.one_in(self.hazards.echo) {
            self.pieces.push(Piece { start: end, end, at: end, bytes: bytes.to_vec(), whole: false });
        }
        if !met {
            self.answer(end, bytes);
        }
    }

    fn duration(&self, bytes: usize) -> Span {
        match self.protocol {
            Protocol::Modbus(Framing::Tcp) => Span::ZERO,
            _ => self.line.chars(bytes as u64),
        }
    }

    /// Spoils everything that is on the wire in this time; tells whether there was anything.
    fn spoil(&mut self, start: Tick, end: Tick) -> bool {
        let mut met = false;
        self.questions.retain(|question| question.1 <= start || end <= question.0);
        for piece in self.pieces.iter_mut().filter(|piece| piece.start < end && start < piece.end) {
            met = true;
            piece.whole = false;
            for byte in &mut piece.bytes {
                *byte &= self.dice.below(256) as u8;
            }
        }
        met
    }

    /// What the stations do about a telegram that ended at `end`.
    fn answer(&mut self, end: Tick, bytes: &[u8]) {
        let Some((station, question, number)) = self.understand(bytes) else { return };
        self.count = self.count.wrapping_add(1);
        for twin in [false, true] {
            if twin && !self.hazards.twins {
                continue;
            }
            let Some(said) = self.says(station, &question, twin) else { return };
            let mut start = end + Span::from_micros(10_000 + self.dice.below(3_000));
            if twin {
                start += Span::from_millis(self.dice.below(60));
            }
            if self.dice.one_in(self.hazards.late) {
                let most = self.dice.pick(&[50, 150, 600, 1_500, LATEST_MS - 200]);
                start += Span::from_millis(self.dice.below(most));
            }
            if self.dice.one_in(self.hazards.overtaken) {
                start += Span::from_millis(self.dice.pick(&[300, 750, 1_500, 2_600, LATEST_MS - 200]));
            }
            // One after the other, where nothing is overtaken, and never later than stations are.
            if self.hazards.overtaken == 0 {
                start = start.max(self.busy.get(&(station, twin)).copied().unwrap_or_default() + self.line.t35());
            }
            if start.since(end) > Span::from_millis(LATEST_MS) {
                continue;
            }
            let frame = self.frame(station, &said, number);
            self.busy.insert((station, twin), start + self.duration(frame.len()));
            self.carry(start, frame);
        }
    }

    /// A reply goes its way.
    fn carry(&mut self, start: Tick, mut frame: Vec<u8>) {
        let hazards = self.hazards;
        if self.dice.one_in(hazards.lost) {
            return;
        }
        if self.dice.one_in(hazards.foreign) {
            frame = self.of_another(&frame).unwrap_or(frame);
        }
        let copy = self.dice.one_in(hazards.doubled).then(|| frame.clone());
        let mut whole = true;
        if self.dice.one_in(hazards.flipped) {
            whole = false;
            for _ in 0..=self.dice.below(3) {
                let place = self.dice.below(frame.len() as u64) as usize;
                frame[place] ^= 1 << self.dice.below(8);
            }
        }
        let end = start + self.duration(frame.len());
        let (torn, noise) = (self.dice.one_in(hazards.torn), self.dice.one_in(hazards.noise));
        if noise {
            let count = 1 + self.dice.below(6);
            let bytes = self.dice.bytes(count);
            _ = self.put(start, bytes, false);
        }
        match torn {
            // The rest does not come, or comes when everybody has turned away.
            true => {
                let cut = self.dice.below(frame.len() as u64) as usize;
                let rest = frame.split_off(cut);
                self.put(start, frame, false);
                if self.dice.one_in(2) {
                    let later = start + self.duration(cut) + Span::from_millis(self.dice.below(300));
                    self.put(later, rest, false);
                }
            }
            false => _ = self.put(start, frame, whole),
        }
        if let Some(copy) = copy {
            let later = end + Span::from_micros(self.dice.below(COPY_MS * 1_000));
            self.put(later, copy, true);
        }
    }

    /// Puts bytes on the wire; tells whether they are whole there.
    fn put(&mut self, start: Tick, mut bytes: Vec<u8>, mut whole: bool) -> bool {
        if bytes.is_empty() {
            return whole;
        }
        let end = start + self.duration(bytes.len());
        let meets = end > start && self.hazards.overtaken == 0;
        if meets && (self.spoil(start, end) || (self.ours.0 < end && start < self.ours.1)) {
            whole = false;
            let and = self.dice.bytes(bytes.len() as u64);
            bytes.iter_mut().zip(and).for_each(|(byte, and)| *byte &= and);
        }
        if whole {
            self.told.insert(bytes.clone());
        }
        // Adapters hold bytes back, and hand a telegram on in pieces.
        let cut = if self.hazards.overtaken == 0 && self.dice.one_in(4) {
            self.dice.below(bytes.len() as u64) as usize
        } else {
            0
        };
        let rest = bytes.split_off(cut);
        let middle = start + self.duration(cut);
        if cut > 0 {
            self.pieces.push(Piece { start, end: middle, at: middle, bytes, whole });
        }
        let at = end + Span::from_micros(if cut > 0 { self.dice.below(16_000) } else { 0 });
        self.pieces.push(Piece { start: middle, end, at, bytes: rest, whole });
        whole
    }

    /// The other master speaks until then.
    fn meddle(&mut self, until: Tick) {
        let Some(gap) = self.hazards.master else { return };
        let Protocol::Modbus(framing @ (Framing::Rtu | Framing::Ascii)) = self.protocol else { return };
        while self.other <= until {
            let ours = self.hazards.shared && self.dice.one_in(2);
            let station = if ours { self.dice.pick(&STATIONS) } else { STRANGER };
            let (number, set, _) = self.dice.pick(&CELLS[..5]);
            let start = ParamAddress::new(set, number).unwrap().word();
            let frame = framing.encode(station, &Request::ReadRegisters { start, count: 1 }.encode());
            let (began, end) = (self.other, self.other + self.duration(frame.len()));
            self.other = end + Span::from_millis(22 + gap) + Span::from_micros(self.dice.below(4_000));
            // What it meets is spoilt, and so is it.
            if !self.put(began, frame.clone(), true) {
                continue;
            }
            self.questions.push((began, end, frame));
        }
        let over = self.questions.extract_if(.., |question| question.1 <= until).collect::<Vec<_>>();
        for (_, end, frame) in over {
            self.answer(end, &frame);
        }
    }
}
