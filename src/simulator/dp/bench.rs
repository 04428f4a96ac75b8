//! A PROFIBUS line with modules on it, in virtual time.

use super::ear::{Ear, bits};
use super::inverter::{Inverter, Kind};
use super::judge::Judge;
use super::module::Module;
use super::readings::{Readings, a004_scale};
use super::slave::Slave;
use crate::profile::Registry;
use crate::protocol::dp::Telegram;
use crate::protocol::line::{LineSetting, Parity};
use crate::simulator::dice::Dice;
use crate::simulator::line::wire::{Sender, Slot, Wire, fits};
use crate::tick::{Span, Tick};
use std::collections::VecDeque;

/// A PROFIBUS line with SJ2-PB modules on it, and its judge.
#[derive(Clone, Debug)]
pub struct Profibus {
    now: Tick,
    line: LineSetting,
    slaves: Vec<Slave>,
    wire: Wire,
    /// What a station says, and when.
    replies: Vec<(Tick, usize, Vec<u8>)>,
    ear: Ear,
    judge: Judge,
    disturbance: Disturbance,
    dice: Dice,
    heard: VecDeque<(Tick, u8)>,
    /// What will happen to the inverters.
    events: Vec<(Tick, usize, Event)>,
    answered: u64,
    received: u64,
    /// A telegram of the master is on its way: bytes that are still to come of it.
    rest: usize,
    /// From when until when the master's port takes no bytes.
    stuck: Vec<(Tick, Tick)>,
    /// When another master passes the token to itself, and its address.
    tokens: VecDeque<(Tick, u8)>,
}

/// What happens to replies on their way, and to requests.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Disturbance {
    /// Of a thousand bytes of anybody, so many have a bit flipped.
    pub(crate) flips: u64,
    /// Of a thousand bytes to the master, so many are lost.
    pub(crate) losses: u64,
    /// The adapter hears itself.
    pub(crate) echo: bool,
    /// The adapter holds bytes back for so long.
    pub(crate) latency: Span,
}

/// What happens to an inverter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Event {
    /// An external trip.
    Trip,
    /// The start contact.
    Contact(bool),
    /// The wire to the module is cut, or whole again.
    Cut(bool),
    /// A load keeps the shaft from becoming slower.
    Dragged(bool),
}

/// A module as it is built.
#[derive(Clone, Debug)]
pub(crate) struct Setup {
    pub(crate) kind: Kind,
    pub(crate) address: u8,
    pub(crate) ident: u16,
    pub(crate) readings: Readings,
    /// Index, element of an array or 0, raw value.
    pub(crate) set: Vec<(u32, u8, i64)>,
    pub(crate) events: Vec<(Tick, Event)>,
}

/// Pause of a station before its answer, bit times, and how much it varies (IEC 61158-4-3: min T_SDR 11, max T_SDR 60 up to
/// 187.5 kBd).
const TSDR: u64 = 11;
const TSDR_VARIES: u64 = 49;
/// Bytes that the driver keeps for a master that does not read.
const MOST_HEARD: usize = 65_536;
/// Ident of the modules of the bench; the true one is in no source.
pub(crate) const IDENT: u16 = 0x0BE7;

impl Profibus {
    /// An L200 at 3 and an SJ200 at 5, 19200 8E1.
    pub fn standard(registry: &Registry) -> Self {
        let at = |kind, address| Setup {
            kind,
            address,
            ident: IDENT,
            readings: Readings::default(),
            set: Vec::new(),
            events: Vec::new(),
        };
        let setups = [at(Kind::L200, 3), at(Kind::Sj200, 5)];
        Profibus::new(LineSetting::rtu(19_200, Parity::Even), setups.into(), Disturbance::default(), 0, registry)
    }

    /// A line with these modules.
    pub(crate) fn new(
        line: LineSetting,
        setups: Vec<Setup>,
        disturbance: Disturbance,
        seed: u64,
        registry: &Registry,
    ) -> Self {
        let mut events = Vec::new();
        let slaves = setups.into_iter().enumerate().filter_map(|(place, setup)| {
            let family = registry.family(setup.kind.name())?;
            let inverter = Inverter::new(setup.kind, &family, a004_scale(setup.readings));
            let mut module = Module::new(setup.address, inverter, setup.readings);
            for (index, element, raw) in setup.set {
                module.preset(index, element, raw);
            }
            events.extend(setup.events.into_iter().map(|(at, event)| (at, place, event)));
            Some(Slave::new(module, setup.ident))
        });
        Profibus {
            now: Tick::ZERO,
            line,
            slaves: slaves.collect(),
            wire: Wire::default(),
            replies: Vec::new(),
            ear: Ear::default(),
            judge: Judge::default(),
            disturbance,
            dice: Dice::new(seed),
            heard: VecDeque::new(),
            events,
            answered: 0,
            received: 0,
            rest: 0,
            stuck: Vec::new(),
            tokens: VecDeque::new(),
        }
    }

    /// The port of the master takes no bytes in these times.
    pub(crate) fn stuck(self, stuck: Vec<(Tick, Tick)>) -> Self {
        Profibus { stuck, ..self }
    }

    /// Another master passes the token to itself at these moments, or as soon as the line is free behind them.
    pub(crate) fn beside(self, mut tokens: Vec<(Tick, u8)>) -> Self {
        tokens.sort_unstable();
        Profibus { tokens: tokens.into(), ..self }
    }

    /// Until when the port of the master takes no bytes.
    pub fn stuck_until(&self) -> Tick {
        let is_now = |(at, until): &&(Tick, Tick)| (*at..*until).contains(&self.now);
        self.stuck.iter().find(is_now).map_or(Tick::ZERO, |(_, until)| *until)
    }

    /// Lets the judge allow for this much where bytes may be read late.
    pub fn allow(&mut self, slack: Span) {
        self.judge.slack = slack;
    }

    /// Speed and format of the line.
    pub fn line(&self) -> LineSetting {
        self.line
    }

    /// What stands on it: word of the family, address.
    pub fn modules(&self) -> impl Iterator<Item = (&'static str, u8)> {
        self.slaves.iter().map(|slave| (slave.module.inverter.kind.name(), slave.address()))
    }

    /// What the judge noted about the master, the first thousand.
    pub fn remarks(&self) -> &[String] {
        self.judge.remarks()
    }

    /// Telegrams for a station, answers, remarks, and modules that exchange data.
    pub fn counts(&self) -> [u64; 4] {
        let exchanging = self.slaves.iter().filter(|slave| slave.exchanges()).count();
        [self.received, self.answered, self.judge.count(), exchanging as u64]
    }

    /// Shafts that turn, and inverters that feed a motor.
    pub fn turning(&self) -> [u64; 2] {
        let motors = || self.slaves.iter().map(|slave| slave.module.inverter.motor);
        let count = |is: &dyn Fn(super::motor::Motor) -> bool| motors().filter(|motor| is(*motor)).count() as u64;
        [count(&|motor| motor.shaft(self.now) != 0), count(&|motor| motor.is_fed())]
    }

    /// Speed of a shaft, 0.01 Hz.
    pub fn shaft(&self, address: u8) -> Option<i64> {
        let slave = self.slaves.iter().find(|slave| slave.address() == address)?;
        Some(slave.module.inverter.motor.shaft(self.now))
    }

    /// A raw value of an inverter, or of an element of an array.
    pub fn raw(&self, address: u8, index: u16, element: Option<u8>) -> Option<i64> {
        let module = &self.slaves.iter().find(|slave| slave.address() == address)?.module;
        match element {
            Some(element) => Some(module.element(index, element).into()),
            None => module.value(self.now, index.into()),
        }
    }

    /// The master puts `bytes` on the wire, back to back.
    pub fn master_sends(&mut self, at: Tick, line: LineSetting, bytes: &[u8]) {
        let at = at.max(self.now);
        self.run_to(at);
        if bytes.is_empty() || line.baud == 0 {
            return;
        }
        let begins = self.rest == 0;
        self.weigh(at, line, bytes, begins);
        let bytes: Vec<u8> = bytes.iter().map(|byte| self.flipped(*byte)).collect();
        let (_, collided) = self.wire.put(Sender::Master, line, at, &bytes);
        if collided {
            self.judge.collides(at);
        }
        if self.disturbance.echo {
            let latency = self.disturbance.latency;
            self.heard.extend((1..).zip(&bytes).map(|(count, byte)| (at + line.chars(count) + latency, *byte)));
        }
    }

    /// The judge looks at what the master sends.
    fn weigh(&mut self, at: Tick, line: LineSetting, bytes: &[u8], mut begins: bool) {
        for (count, _) in (0..).zip(bytes) {
            let (start, end) = (at + line.chars(count), at + line.chars(count + 1));
            self.judge.master_byte(line, start, end, begins);
            begins = false;
        }
        // A client of a pseudo terminal may hand a telegram over in pieces.
        let whole = crate::protocol::dp::frame::length(bytes).ok().flatten();
        self.rest = match self.rest {
            0 => whole.map_or(0, |whole| whole.saturating_sub(bytes.len())),
            rest => rest.saturating_sub(bytes.len()),
        };
    }

    /// The next moment at which something may change if the master stays silent.
    pub fn next_event(&self) -> Option<Tick> {
        self.next_inside().into_iter().chain(self.heard.iter().map(|heard| heard.0)).min()
    }

    fn next_inside(&self) -> Option<Tick> {
        let slaves = self.slaves.iter().filter_map(Slave::next);
        let events = self.events.iter().map(|event| event.0);
        let replies = self.replies.iter().map(|reply| reply.0);
        let token = self.tokens.front().filter(|_| self.is_free()).map(|token| token.0);
        slaves.chain(events).chain(replies).chain(self.wire.next()).chain(token).min()
    }

    /// Whether nobody speaks, or is about to answer.
    fn is_free(&self) -> bool {
        self.wire.next().is_none() && self.replies.is_empty()
    }

    /// Runs until `to`, inclusive; returns every byte that came to the master since the last call, with its time.
    pub fn advance(&mut self, to: Tick) -> Vec<(Tick, u8)> {
        self.run_to(to);
        self.heard.make_contiguous().sort_by_key(|heard| heard.0);
        let due = self.heard.partition_point(|heard| heard.0 <= to);
        self.heard.drain(..due).collect()
    }

    fn run_to(&mut self, to: Tick) {
        while let Some(next) = self.next_inside().filter(|next| *next <= to) {
            self.now = self.now.max(next);
            self.step();
        }
        self.now = self.now.max(to);
        for slave in &mut self.slaves {
            slave.catch_up(self.now);
        }
    }

    fn step(&mut self) {
        let now = self.now;
        while let Some(place) = self.events.iter().position(|event| event.0 <= now) {
            let (_, slave, event) = self.events.remove(place);
            if let Some(slave) = self.slaves.get_mut(slave) {
                match event {
                    Event::Trip => slave.trips(now),
                    Event::Contact(is_closed) => slave.module.contact(now, is_closed),
                    Event::Cut(is_cut) => slave.is_cut = is_cut,
                    Event::Dragged(is_dragged) => slave.module.inverter.motor.drag(now, is_dragged),
                }
            }
        }
        for slave in &mut self.slaves {
            slave.catch_up(now);
        }
        while let Some(slot) = self.wire.take(now) {
            self.deliver(&slot);
        }
        while let Some(place) = self.replies.iter().position(|reply| reply.0 <= now) {
            let (_, slave, bytes) = self.replies.remove(place);
            let bytes: Vec<u8> = bytes.iter().map(|byte| self.flipped(*byte)).collect();
            self.wire.put(Sender::Drive(slave), self.line, now, &bytes);
            self.answered += 1;
        }
        if self.is_free()
            && self.tokens.front().is_some_and(|token| token.0 <= now)
            && let Some((_, master)) = self.tokens.pop_front()
        {
            let token = Telegram::Token { to: master, from: master }.encode();
            self.wire.put(Sender::Drive(self.slaves.len()), self.line, now, &token);
        }
    }

    fn deliver(&mut self, slot: &Slot) {
        if slot.sender != Sender::Master {
            self.judge.other_byte(slot.end);
            if !self.chance(self.disturbance.losses) {
                self.heard.push_back((slot.end + self.disturbance.latency, slot.byte));
            }
            let surplus = self.heard.len().saturating_sub(MOST_HEARD);
            self.heard.drain(..surplus);
        }
        if !fits(self.line, slot.line) {
            return;
        }
        let Some(bytes) = self.ear.feed(self.line, slot.start, slot.end, slot.byte) else { return };
        let said = Telegram::decode(&bytes).ok();
        if slot.sender != Sender::Master {
            return;
        }
        let frame = match &said {
            Some(Telegram::Frame(frame)) => Some(frame),
            _ => None,
        };
        if self.disturbance.flips == 0 {
            self.judge.telegram(slot.end, frame);
        }
        let Some(frame) = frame else { return };
        self.received += 1;
        for (place, slave) in self.slaves.iter_mut().enumerate().filter(|(_, slave)| !slave.is_cut) {
            if let Some(reply) = slave.hear(slot.end, frame) {
                let pause = TSDR + self.dice.below(TSDR_VARIES + 1);
                self.replies.push((slot.end + bits(self.line, pause), place, reply));
            }
        }
    }

    fn chance(&mut self, thousandths: u64) -> bool {
        thousandths > 0 && self.dice.below(1_000) < thousandths
    }

    fn flipped(&mut self, byte: u8) -> u8 {
        if self.chance(self.disturbance.flips) { byte ^ 1 << self.dice.below(8) } else { byte }
    }
}
