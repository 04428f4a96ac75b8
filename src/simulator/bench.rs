//! A bus with drives, and its judge: what is on the wire, who hears it, who answers.

use super::judge::{Judge, MasterTelegram, Remark, Sin, Spelt, wrong_format};
use super::line::disturb::{Disturber, Outgoing, Parting};
use super::line::port::Port;
use super::line::speech::Spoken;
use super::line::wire::{Sender, Slot, Wire, fits};
use super::station::Drive;
use super::totals::Totals;
use crate::protocol::line::LineSetting;
use crate::protocol::modbus::pdu::{ReplyEnd, Request};
use crate::protocol::modbus::{Adu, BROADCAST, FrameError, LAST_STATION};
use crate::protocol::vabus as bus;
use crate::tick::{Span, Tick};
use std::collections::VecDeque;

/// Events at one and the same time after which the bench moves on whatever happens.
const MOST_AT_ONCE: u32 = 10_000;
/// Bytes that the driver keeps for a master that does not read: more than any has (Linux: 4 KiB behind each tty).
const MOST_HEARD: usize = 65_536;

/// A bus with drives, and its judge.
#[derive(Clone, Debug)]
pub struct Bench {
    pub(crate) now: Tick,
    drives: Vec<Drive>,
    wire: Wire,
    /// Telegrams that the line holds back.
    delayed: Vec<Delayed>,
    disturber: Disturber,
    judge: Judge,
    /// Setting of the master's last telegram.
    master: Option<LineSetting>,
    /// What the master hears with, once it is known how he is set.
    port: Option<Port>,
    /// What the master hears, in order of time.
    heard: VecDeque<(Tick, u8)>,
    totals: Totals,
}

#[derive(Clone, Debug)]
struct Delayed {
    at: Tick,
    drive: usize,
    line: LineSetting,
    frame: Vec<u8>,
}

impl Bench {
    /// Lets the judge allow for this much in its 500 ms rules: in real time a telegram is stamped when somebody gets to
    /// read it, which may be late, and a correct master must not be blamed for that. Virtual time needs none.
    pub fn allow(&mut self, slack: Span) {
        self.judge.slack = slack;
    }

    /// A bench with these drives on a line that is disturbed so.
    pub(crate) fn new(drives: Vec<Drive>, disturber: Disturber) -> Bench {
        Bench {
            now: Tick::ZERO,
            drives,
            wire: Wire::default(),
            delayed: Vec::new(),
            disturber,
            judge: Judge::default(),
            master: None,
            port: None,
            heard: VecDeque::new(),
            totals: Totals::default(),
        }
    }

    /// The master puts `bytes` on the wire, back to back; the first start bit begins at `at`.
    ///
    /// `at` never lies before that of an earlier call, or before a time that the bench was advanced to: an earlier
    /// one is taken as that time. If somebody is sending already, both telegrams are spoilt.
    pub fn master_sends(&mut self, at: Tick, line: LineSetting, bytes: &[u8]) {
        let at = at.max(self.now);
        self.run_to(at);
        if bytes.is_empty() || line.baud == 0 {
            return;
        }
        if let Some(telegram) = self.judge.before(at, line, bytes) {
            self.classify(&telegram);
        }
        self.judge.sends(at, line, bytes);
        self.master = Some(line);
        self.listens(line);
        self.wire.put(Sender::Master, line, at, bytes);
        let station = addressee(bytes);
        if let Some(by) = self.disturber.echoes(at, station) {
            let echo = (1..).zip(bytes).map(|(count, &byte)| (at + by + line.chars(count), byte));
            self.heard.extend(echo);
            self.overflow();
        }
    }

    /// The master's port is set so from now on, whether or not he sends.
    pub fn listens(&mut self, line: LineSetting) {
        if self.port.as_ref().map(Port::line) != Some(line) {
            self.port = Some(Port::new(line, self.now));
        }
    }

    /// The next moment at which something may change if the master stays silent.
    pub fn next_event(&self) -> Option<Tick> {
        let drives = self.drives.iter().filter_map(Drive::next_event);
        let delayed = self.delayed.iter().map(|delayed| delayed.at);
        let heard = self.heard.front().map(|heard| heard.0);
        drives.chain(delayed).chain(self.wire.next()).chain(heard).chain(self.alone()).min()
    }

    /// Runs until `to`, inclusive; returns every byte that came to the master since the last call, each with the time
    /// at which its last bit was on the wire.
    pub fn advance(&mut self, to: Tick) -> Vec<(Tick, u8)> {
        self.run_to(to);
        self.heard.make_contiguous().sort_by_key(|heard| heard.0);
        let due = self.heard.partition_point(|heard| heard.0 <= to);
        self.heard.drain(..due).collect()
    }

    /// Whether the connection to the master was ended since this was asked last, and how: what he had not heard yet is lost.
    pub fn hangs_up(&mut self) -> Option<Parting> {
        let parting = self.disturber.hangs_up()?;
        self.heard.clear();
        Some(parting)
    }

    /// Until when the port of the master takes no bytes.
    pub fn stuck_until(&self) -> Tick {
        self.disturber.stuck_until()
    }

    /// What the judge noted about the master, the first thousand.
    pub fn remarks(&self) -> &[Remark] {
        self.judge.remarks()
    }

    /// Everything that stands on the bench.
    pub fn drives(&self) -> impl Iterator<Item = &Drive> {
        self.drives.iter()
    }

    /// The first drive with this address.
    pub fn drive(&self, address: u8) -> Option<&Drive> {
        self.drives.iter().find(|drive| drive.address() == address)
    }

    /// The setting of the drive that a telegram addresses, or of the first one: for a line that carries no setting.
    pub fn line_of(&self, bytes: &[u8]) -> Option<LineSetting> {
        self.drive(addressee(bytes)).or(self.drives.first()).map(Drive::line)
    }

    /// The first drive with this address.
    pub fn drive_mut(&mut self, address: u8) -> Option<&mut Drive> {
        self.drives.iter_mut().find(|drive| drive.address() == address)
    }

    /// Closing counts.
    pub fn totals(&self) -> Totals {
        Totals {
            answered: self.drives.iter().map(|drive| drive.answered().0).sum(),
            exceptions: self.drives.iter().map(|drive| drive.answered().1).sum(),
            eeprom_writes: self.drives.iter().map(Drive::eeprom_writes).sum(),
            remarks: self.judge.count(),
            gaps: self.judge.gaps.gaps(),
            turning: self.drives.iter().map(|drive| drive.turning(self.now)).sum(),
            energised: self.drives.iter().map(Drive::energised).sum(),
            ..self.totals
        }
    }

    fn run_to(&mut self, to: Tick) {
        let mut at_once = 0;
        while let Some(next) = self.next_inside().filter(|&next| next <= to) {
            at_once = if next > self.now { 0 } else { at_once + 1 };
            if at_once > MOST_AT_ONCE {
                break;
            }
            self.now = self.now.max(next);
            self.step();
        }
        self.now = self.now.max(to);
        self.step();
    }

    /// Like [`Bench::next_event`], without what only waits to be fetched.
    fn next_inside(&self) -> Option<Tick> {
        let drives = self.drives.iter().filter_map(Drive::next_event);
        let delayed = self.delayed.iter().map(|delayed| delayed.at);
        drives.chain(delayed).chain(self.wire.next()).chain(self.alone()).min()
    }

    /// What happens by itself: somebody speaks unasked, the master's port makes out a character of another setting.
    fn alone(&self) -> impl Iterator<Item = Tick> {
        let heard = self.port.as_ref().and_then(Port::due).filter(|&due| !self.wire.speaks_before(due));
        self.disturber.next_babble().into_iter().chain(heard)
    }

    /// Everything that is due now: first what was on the wire, then what the drives do about it.
    fn step(&mut self) {
        let now = self.now;
        while let Some(slot) = self.wire.take(now) {
            self.deliver(&slot);
        }
        if let Some(port) = self.port.as_mut().filter(|port| port.due().is_some_and(|due| due <= now))
            && !self.wire.speaks_before(now)
        {
            self.heard.extend(port.rest(now));
        }
        if let Some(telegram) = self.judge.settle(now) {
            self.classify(&telegram);
        }
        while let Some(place) = self.delayed.iter().position(|delayed| delayed.at <= now) {
            let delayed = self.delayed.remove(place);
            self.put(delayed);
        }
        let setting = self.master.or(self.drives.first().map(Drive::line));
        while let Some((line, (bytes, own))) = setting.and_then(|line| Some((line, self.disturber.babble(now, line)?)))
        {
            let sender = if own.is_some() { Sender::Stranger } else { Sender::Noise };
            self.wire.put(sender, own.unwrap_or(line), now, &bytes);
        }
        for index in 0..self.drives.len() {
            while let Some(reply) = self.drives.get_mut(index).and_then(|drive| drive.run(now)) {
                self.send(index, &reply);
            }
        }
    }

    /// What nobody fetches is lost when the driver's buffer is full: the oldest first, which is as good as any.
    fn overflow(&mut self) {
        let surplus = self.heard.len().saturating_sub(MOST_HEARD);
        self.heard.drain(..surplus);
    }

    fn deliver(&mut self, slot: &Slot) {
        if slot.sender != Sender::Master {
            let is_clear = |port: &Port| slot.sender == Sender::Noise || fits(port.line(), slot.line);
            match self.port.as_mut().filter(|port| !is_clear(port)) {
                Some(port) => self.heard.extend(port.hear(slot)),
                None => self.heard.push_back((slot.end, slot.byte)),
            }
        }
        if let Sender::Drive(index) = slot.sender {
            let rest = self.drives.get(index).map_or(Span::ZERO, Drive::rest);
            self.judge.heard(slot.end, rest);
        }
        self.overflow();
        for (index, drive) in self.drives.iter_mut().enumerate() {
            if slot.sender != Sender::Drive(index) {
                drive.hear(slot);
            }
        }
    }

    fn send(&mut self, drive: usize, reply: &Outgoing) {
        let now = self.now;
        for (at, frame) in self.disturber.pass(now, reply) {
            let delayed = Delayed { at, drive, line: reply.line, frame };
            if at <= now { self.put(delayed) } else { self.delayed.push(delayed) }
        }
    }

    fn put(&mut self, telegram: Delayed) {
        let (end, _) = self.wire.put(Sender::Drive(telegram.drive), telegram.line, self.now, &telegram.frame);
        let station = self.drives.get(telegram.drive).map_or(BROADCAST, Drive::address);
        self.judge.answers(station, end);
        if self.drives.get(telegram.drive).map(Drive::spoken) == Some(Spoken::Vabus) {
            self.judge.overhears(&telegram.frame);
        }
    }

    /// Says what will become of a telegram of the master that is over.
    fn classify(&mut self, telegram: &MasterTelegram) {
        match telegram.spelt() {
            Spelt::Modbus(adu) => self.classify_modbus(telegram, adu),
            Spelt::Vabus(Ok(None)) => self.judge.ends_exchange(),
            Spelt::Vabus(Ok(Some(request))) => self.classify_vabus(telegram, &request),
            Spelt::Vabus(Err(error)) => {
                self.totals.received += 1;
                self.totals.ignored.malformed += 1;
                self.judge.remark(telegram.start, Sin::Malformed, error.to_string());
            }
        }
    }

    fn classify_vabus(&mut self, telegram: &MasterTelegram, request: &bus::Request) {
        self.totals.received += 1;
        self.judge.weigh_request(telegram.start, request);
        if telegram.torn {
            self.totals.ignored.malformed += 1;
            return;
        }
        match (request.address().is_broadcast(), request) {
            (true, bus::Request::Select { .. }) => self.totals.broadcasts += 1,
            (true, bus::Request::Enquiry { .. }) => self.read_by_broadcast(telegram),
            (false, _) => {
                let station = request.address().id();
                let taken = self.who_takes(telegram, station);
                self.judge.asked(telegram.end, station, taken);
            }
        }
    }

    fn read_by_broadcast(&mut self, telegram: &MasterTelegram) {
        self.totals.ignored.broadcast_reads += 1;
        let text = "a broadcast can only write, nobody answers it".to_owned();
        self.judge.remark(telegram.start, Sin::BroadcastRead, text);
    }

    fn classify_modbus(&mut self, telegram: &MasterTelegram, adu: Result<Adu, FrameError>) {
        self.totals.received += 1;
        let adu = match adu {
            Ok(adu) => adu,
            Err(error) => {
                self.totals.ignored.malformed += 1;
                let text = wrong_format(telegram).unwrap_or_else(|| error.to_string());
                return self.judge.remark(telegram.start, Sin::Malformed, text);
            }
        };
        if let Some(text) = wrong_format(telegram) {
            self.judge.remark(telegram.start, Sin::Malformed, text);
        }
        if telegram.torn {
            self.totals.ignored.malformed += 1;
            return;
        }
        if adu.station == BROADCAST {
            if Request::decode(&adu.pdu).is_ok_and(|request| request.is_write()) {
                self.totals.broadcasts += 1;
            } else {
                self.read_by_broadcast(telegram);
            }
            return;
        }
        if adu.station > LAST_STATION {
            let text = format!("address {} is none: stations have 1 to {LAST_STATION}", adu.station);
            self.judge.remark(telegram.start, Sin::Malformed, text);
        }
        let taken = self.who_takes(telegram, adu.station);
        // Nobody waits for the answer of a station that was told to be silent.
        if !Request::decode(&adu.pdu).is_ok_and(|request| request.reply_end() == ReplyEnd::Never) {
            self.judge.asked(telegram.end, adu.station, taken);
        }
    }

    /// Whether a drive answers; if none does, the best reason is counted.
    fn who_takes(&mut self, telegram: &MasterTelegram, station: u8) -> bool {
        let ignored = &mut self.totals.ignored;
        let mut reason = &mut ignored.no_station;
        for drive in self.drives.iter().filter(|drive| drive.address() == station) {
            if !drive.awake() {
                reason = &mut ignored.away;
            } else if drive.spoken() != telegram.spoken() {
                reason = &mut ignored.wrong_protocol;
            } else if !fits(drive.line(), telegram.line) {
                reason = &mut ignored.wrong_line;
            } else {
                return true;
            }
        }
        *reason += 1;
        false
    }
}

/// The station that a telegram of a master names, by its first bytes; 0 if it names none.
fn addressee(bytes: &[u8]) -> u8 {
    let digit = |byte: u8| char::from(byte).to_digit(16).unwrap_or(0) as u8;
    match bytes {
        [bus::EOT, character, ..] => bus::Address::from_character(*character).map_or(bus::EOT, bus::Address::id),
        [b':', high, low, ..] => digit(*high) << 4 | digit(*low),
        [station, ..] => *station,
        [] => 0,
    }
}
