//! The wire: one frame at a time, the smallest identifier first, everybody hears it (ISO 11898-1).

use super::adapter::{Adapter, Channel, Out, Quirks};
use super::confinement::Ended;
use super::node::Node;
use crate::protocol::can::nmt::{Command, Order};
use crate::protocol::can::{Body, Frame, LAST_DRIVE, SdoChannel, Service, duration};
use crate::protocol::line::{LineSetting, Parity};
use crate::simulator::dice::Dice;
use crate::tick::{Span, Tick};
use std::collections::VecDeque;

/// A CAN bus with drives on it, behind an adapter, and its judge.
#[derive(Clone, Debug)]
pub struct Can {
    now: Tick,
    /// Bits per second of everybody but the adapter.
    rate: u32,
    nodes: Vec<Node>,
    foreign: Vec<Foreign>,
    adapter: Adapter,
    /// What waits for the bus.
    waiting: Vec<(Sender, Frame)>,
    /// What is on it, and until when.
    running: Option<(Tick, Sender, Frame)>,
    /// What comes to the host of the adapter.
    heard: VecDeque<(Tick, u8)>,
    /// Of a thousand frames to the adapter or from it, so many are lost.
    losses: u64,
    dice: Dice,
    remarks: Vec<String>,
    orders: Vec<Order>,
    received: u64,
    answered: u64,
}

/// Somebody else who says the same again and again.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Foreign {
    pub(crate) frame: Frame,
    pub(crate) every: Span,
    pub(crate) at: Tick,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Sender {
    Adapter,
    Node(usize),
    Foreign,
}

/// Everything of a bus but its drives.
#[derive(Clone, Debug)]
pub(crate) struct Setup {
    pub(crate) rate: u32,
    pub(crate) quirks: Quirks,
    pub(crate) foreign: Vec<Foreign>,
    pub(crate) losses: u64,
    pub(crate) seed: u64,
}

/// Bit rate of the standard bus; the factory setting of P.903 is not printed.
pub(crate) const RATE: u32 = 500_000;
/// Remarks kept.
const MOST_REMARKS: usize = 1_000;
/// Bytes that the driver keeps for a master that does not read.
const MOST_HEARD: usize = 65_536;
/// Frames that wait for the bus; a controller has some.
const MOST_WAITING: usize = 256;
/// Status flags of an adapter that hears what is no frame, and of one whom nobody acknowledges (Lawicel CANUSB manual, F).
const HEARS_ERRORS: u8 = 1 << 7 | 1 << 2;
const UNACKNOWLEDGED: u8 = 1 << 7 | 1 << 5 | 1 << 2;
/// Events at one and the same time after which the bus moves on whatever happens.
const MOST_AT_ONCE: u32 = 10_000;

impl Can {
    pub(crate) fn new(setup: Setup, nodes: Vec<Node>) -> Self {
        Can {
            now: Tick::ZERO,
            rate: setup.rate,
            nodes,
            foreign: setup.foreign,
            adapter: Adapter::new(setup.quirks),
            waiting: Vec::new(),
            running: None,
            heard: VecDeque::new(),
            losses: setup.losses,
            dice: Dice::new(setup.seed),
            remarks: Vec::new(),
            orders: Vec::new(),
            received: 0,
            answered: 0,
        }
    }

    /// How a host talks to the adapter.
    pub fn line(&self) -> LineSetting {
        LineSetting { baud: 115_200, data_bits: 8, parity: Parity::None, stop_bits: 1 }
    }

    /// What is on it: word of the family, its node, if it takes part, and its bits per second.
    pub fn nodes(&self) -> impl Iterator<Item = (&'static str, Option<u8>, u32)> {
        self.nodes.iter().map(|node| (node.device.model(), node.id, node.rate(self.rate)))
    }

    /// Raw value in the RAM of a node.
    pub fn ram(&self, node: u8, number: u32, set: u8) -> Option<i64> {
        self.nodes.iter().find(|found| found.id == Some(node))?.device.ram(number, set)
    }

    /// Raw value in the EEPROM of a node.
    pub fn eeprom(&self, node: u8, number: u32, set: u8) -> Option<i64> {
        self.nodes.iter().find(|found| found.id == Some(node))?.device.eeprom(number, set)
    }

    /// What a source tells in a node.
    pub fn source(&mut self, node: u8, number: u16) -> Option<i64> {
        let node = self.nodes.iter_mut().find(|found| found.id == Some(node))?;
        node.device.system_bus().map(|bus| bus.source(number))
    }

    /// What the master has told nodes as master of the network, the first thousand.
    pub fn orders(&self) -> &[Order] {
        &self.orders
    }

    /// The time of the bus.
    pub fn now(&self) -> Tick {
        self.now
    }

    /// What the judge noted about the master, the first thousand.
    pub fn remarks(&self) -> &[String] {
        &self.remarks
    }

    /// Whether the adapter takes part in the bus.
    pub fn is_open(&self) -> bool {
        self.adapter.channel == Channel::Open
    }

    /// Frames of the master, answers, and cells of EEPROMs written.
    pub fn counts(&self) -> [u64; 3] {
        let writes = self.nodes.iter().map(|node| node.device.eeprom_writes()).sum();
        [self.received, self.answered, writes]
    }

    /// Shafts that turn, and drives that feed a motor.
    pub fn turning(&self) -> [u64; 2] {
        let turning = self.nodes.iter().map(|node| node.device.turning(self.now)).sum();
        [turning, self.nodes.iter().map(|node| node.device.energised()).sum()]
    }

    /// The host of the adapter says this.
    pub fn master_sends(&mut self, at: Tick, bytes: &[u8]) {
        let at = at.max(self.now);
        self.run_to(at);
        for &byte in bytes {
            for out in self.adapter.feed(byte) {
                match out {
                    Out::Says(text, later) => self.say(&text, later),
                    Out::Sends(frame) => self.take(frame),
                }
            }
        }
    }

    /// A frame of the master.
    fn take(&mut self, frame: Frame) {
        self.received += 1;
        self.judge(&frame);
        if !self.fits() || !self.is_acknowledged(Sender::Adapter) {
            return self.adapter.flags(UNACKNOWLEDGED);
        }
        self.wait_for_bus(Sender::Adapter, frame);
    }

    fn judge(&mut self, frame: &Frame) {
        let identifier = frame.identifier.number();
        let service = u16::try_from(identifier).map_or(Service::Free, Service::of);
        let has_master = self.nodes.iter().any(Node::is_master);
        match service {
            Service::SdoRequest(SdoChannel::Two, _) => {}
            Service::SdoRequest(SdoChannel::One, _) if has_master => self.remark("SDO1 is the master's"),
            Service::SdoRequest(SdoChannel::One, _) => {}
            Service::Nmt => self.judge_order(frame, has_master),
            _ => self.remark(&format!("{frame}: nothing but SDO and NMT is anybody's but the drives'")),
        }
        if !self.fits() && !self.is_mixed() {
            self.remark("the adapter disturbs the bus: it sends at another bit rate");
        }
        if matches!(frame.body, Body::Remote(_)) {
            self.remark("a remote request, which no drive answers");
        }
    }

    /// Only the master may use identifier 0 (EM-RES-03 manual 5.8.1), and a controller or a tool may be it.
    fn judge_order(&mut self, frame: &Frame, has_master: bool) {
        let known = |order: &Order| !matches!(order.command, Command::Unknown(_)) && order.node <= LAST_DRIVE;
        match Order::decode(frame.bytes()).filter(known) {
            Some(_) if has_master => self.remark("the network is the master drive's"),
            None => self.remark(&format!("{frame}: no command of NMT")),
            Some(_) => {}
        }
        if self.orders.len() < MOST_REMARKS {
            self.orders.extend(Order::decode(frame.bytes()));
        }
    }

    fn remark(&mut self, text: &str) {
        if self.remarks.len() < MOST_REMARKS {
            self.remarks.push(format!("{} us: {text}", self.now.as_micros()));
        }
    }

    /// The adapter says something to its host.
    fn say(&mut self, text: &str, later: Span) {
        let at = self.now + self.adapter.quirks.latency + later;
        self.heard.extend(text.bytes().map(|byte| (at, byte)));
        let surplus = self.heard.len().saturating_sub(MOST_HEARD);
        self.heard.drain(..surplus);
    }

    /// Something is to go out. Of a PDO that waits still, what is newer goes out in its place.
    fn wait_for_bus(&mut self, sender: Sender, frame: Frame) {
        if let Some(waiting) = self.waits(sender, &frame).and_then(|place| self.waiting.get_mut(place)) {
            waiting.1 = frame;
        } else if self.waiting.len() < MOST_WAITING {
            self.waiting.push((sender, frame));
        }
    }

    /// Where a PDO of the same identifier waits for the bus.
    fn waits(&self, sender: Sender, frame: &Frame) -> Option<usize> {
        let Sender::Node(_) = sender else { return None };
        let identifier = u16::try_from(frame.identifier.number()).ok()?;
        if matches!(Service::of(identifier), Service::SdoReply(..) | Service::Emergency(_)) {
            return None;
        }
        self.waiting.iter().position(|row| row.0 == sender && row.1.identifier == frame.identifier)
    }

    /// The next moment at which something may change if the master stays silent.
    pub fn next_event(&self) -> Option<Tick> {
        self.next_inside().into_iter().chain(self.heard.iter().map(|heard| heard.0)).min()
    }

    fn next_inside(&self) -> Option<Tick> {
        let nodes = self.nodes.iter().filter_map(Node::next);
        let foreign = self.foreign.iter().map(|foreign| foreign.at);
        let goes_out = !self.waiting.is_empty() && self.running.is_none() && !self.is_deaf();
        let waiting = goes_out.then_some(self.now);
        nodes.chain(foreign).chain(self.running.map(|running| running.0)).chain(waiting).min()
    }

    /// Runs until `to`, inclusive; returns every byte that came to the host since the last call, with its time.
    pub fn advance(&mut self, to: Tick) -> Vec<(Tick, u8)> {
        self.run_to(to);
        self.heard.make_contiguous().sort_by_key(|heard| heard.0);
        let due = self.heard.partition_point(|heard| heard.0 <= to);
        self.heard.drain(..due).collect()
    }

    fn run_to(&mut self, to: Tick) {
        let mut at_once = 0;
        while let Some(next) = self.next_inside().filter(|next| *next <= to) {
            at_once = if next > self.now { 0 } else { at_once + 1 };
            if at_once > MOST_AT_ONCE {
                break;
            }
            self.now = self.now.max(next);
            self.step();
        }
        self.now = self.now.max(to);
    }

    fn step(&mut self) {
        let now = self.now;
        if let Some((_, sender, frame)) = self.running.filter(|running| running.0 <= now) {
            self.running = None;
            self.deliver(sender, &frame);
        }
        for place in 0..self.nodes.len() {
            let said = self.nodes.get_mut(place).map(|node| node.run(now)).unwrap_or_default();
            said.into_iter().for_each(|frame| self.wait_for_bus(Sender::Node(place), frame));
        }
        for place in 0..self.foreign.len() {
            let Some(foreign) = self.foreign.get_mut(place).filter(|foreign| foreign.at <= now) else { continue };
            foreign.at = now + foreign.every;
            let frame = foreign.frame;
            self.wait_for_bus(Sender::Foreign, frame);
        }
        self.arbitrate();
    }

    /// Who has the smallest identifier gets a bus that is free.
    fn arbitrate(&mut self) {
        if self.running.is_some() || self.is_deaf() {
            return;
        }
        let first =
            (0..self.waiting.len()).min_by_key(|place| self.waiting.get(*place).map(|(_, frame)| frame.identifier));
        let Some((sender, frame)) = first.map(|place| self.waiting.remove(place)) else { return };
        let ends = self.now + duration(self.common_rate(), frame.bytes().len() as u64);
        self.running = Some((ends, sender, frame));
    }

    /// Bits per second of everybody who takes part, the adapter apart.
    fn rates(&self) -> impl Iterator<Item = u32> {
        let nodes = self.nodes.iter().filter(|node| node.takes_part()).map(|node| node.rate(self.rate));
        nodes.chain(self.foreign.iter().map(|_| self.rate))
    }

    /// The rate of the bus as it is now: drives may have been set to another one.
    fn common_rate(&self) -> u32 {
        self.rates().next().unwrap_or(self.rate)
    }

    /// Whether two rates are on the bus, so that everybody destroys what the others say.
    fn is_mixed(&self) -> bool {
        self.rates().any(|rate| rate != self.common_rate())
    }

    /// The adapter has the bit rate of the bus.
    fn fits(&self) -> bool {
        self.adapter.rate == Some(self.common_rate()) && !self.is_mixed()
    }

    /// Whether somebody else acknowledges what one sends. Who only listens does not.
    fn is_acknowledged(&self, sender: Sender) -> bool {
        let adapter = sender != Sender::Adapter && self.adapter.channel == Channel::Open && self.fits();
        let mut nodes = (0..).zip(&self.nodes).filter(|row| sender != Sender::Node(row.0));
        adapter || !self.foreign.is_empty() || nodes.any(|row| row.1.takes_part())
    }

    /// Whether nobody acknowledges what waits and nobody hears how it is said again and again, so that it can wait.
    fn is_deaf(&self) -> bool {
        let heard = |(sender, _): &(Sender, Frame)| self.is_acknowledged(*sender);
        self.adapter.channel == Channel::Closed && !self.waiting.iter().any(heard)
    }

    /// A frame is over.
    fn deliver(&mut self, sender: Sender, frame: &Frame) {
        let disturbs = self.adapter.channel == Channel::Open && !self.fits() && !self.adapter.errors.is_passive();
        if sender != Sender::Adapter && self.adapter.channel != Channel::Closed && !self.fits() {
            self.adapter.flags(HEARS_ERRORS);
        }
        let ended = match sender {
            Sender::Adapter => Ended::Well,
            _ if disturbs || self.is_mixed() => Ended::Disturbed,
            _ if self.is_acknowledged(sender) => Ended::Well,
            _ => Ended::Alone,
        };
        let now = self.now;
        for (place, node) in (0..).zip(&mut self.nodes) {
            node.ended(now, sender == Sender::Node(place), ended);
        }
        match ended {
            Ended::Well => self.everybody_hears(sender, frame),
            Ended::Alone => self.said_in_vain(sender, *frame),
            Ended::Disturbed => {
                if disturbs {
                    self.adapter.errors.heard(ended);
                    self.remark("the adapter disturbs the bus: it takes part at another bit rate");
                }
                self.says_again(sender, *frame);
            }
        }
    }

    /// Nobody has acknowledged it. Who listens hears it all the same, but for the error flags of one who still gives some.
    fn said_in_vain(&mut self, sender: Sender, frame: Frame) {
        let is_passive = |place: usize| self.nodes.get(place).is_some_and(Node::is_passive);
        match sender {
            Sender::Node(place) if is_passive(place) => self.adapter_hears(&frame),
            _ if self.adapter.channel != Channel::Closed => self.adapter.flags(HEARS_ERRORS),
            _ => {}
        }
        self.says_again(sender, frame);
    }

    /// A controller says a frame until it has gone out, but not a drive that is off the bus.
    fn says_again(&mut self, sender: Sender, frame: Frame) {
        match sender {
            Sender::Node(place) if !self.nodes.get(place).is_some_and(Node::takes_part) => {
                self.waiting.retain(|row| row.0 != sender);
            }
            Sender::Node(_) if self.waits(sender, &frame).is_none() => self.waiting.insert(0, (sender, frame)),
            _ => {}
        }
    }

    fn adapter_hears(&mut self, frame: &Frame) {
        if self.fits()
            && !self.chance()
            && let Some(text) = self.adapter.hears(frame)
        {
            self.say(&text, Span::ZERO);
        }
    }

    fn everybody_hears(&mut self, sender: Sender, frame: &Frame) {
        if sender != Sender::Adapter {
            self.adapter_hears(frame);
        } else if self.chance() {
            return;
        }
        for (place, node) in self.nodes.iter_mut().enumerate() {
            if sender != Sender::Node(place) {
                self.answered += u64::from(node.hear(self.now, frame));
            }
        }
    }

    fn chance(&mut self) -> bool {
        self.losses > 0 && self.dice.below(1_000) < self.losses
    }
}
