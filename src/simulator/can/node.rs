//! A drive on the bus: its place, its state, what it answers and what it says by itself (EM-RES-03 manual 5.8 to 5.10).
//!
//! Its PDOs are in `process`, its parameters as objects in `server`, what a master makes of its slaves in `slaves`.
//!
//! Choices where the manual is silent:
//! - it is there as soon as the bench begins, Pre-Operational, and has said its boot-up before;
//! - after Reset Node and Reset Communication it says its boot-up 100 ms later, behind a software reset when that is over;
//! - a question of less than eight bytes is none;
//! - a SYNC of a master drive acts on its own PDOs as it is sent;
//! - behind a BUS-OFF of its own its controller begins anew 100 ms later;
//! - a cable that is off (`silent`) stops nothing in the drive, whose time-outs go on;
//! - what counts as a telegram of its script is a question over SDO to it, and a download is a write;
//! - a write that its script refuses is aborted with code 15, for any other error.

use super::confinement::{Ended, Errors};
use super::process::Process;
use super::readings::{Reading, Readings};
use super::server;
use super::settings::Settings;
use super::slaves::Slaves;
use crate::protocol::can::emergency::Emergency;
use crate::protocol::can::nmt::{Command, Life, Order};
use crate::protocol::can::sdo::{AbortCode, Initiate, Multiplexer, Reply, Request};
use crate::protocol::can::{Body, Frame, Identifier, SdoChannel, Service};
use crate::simulator::device::contract::{Action, Device, Effect, Fault, RESTART};
use crate::simulator::station::script::Script;
use crate::tick::{Span, Tick};

/// How a node takes part; the numbers are those of P.978 (manual 5.12).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum State {
    PreOperational = 1,
    Operational = 2,
    Stopped = 3,
}

/// A drive on the bus.
#[derive(Clone, Debug)]
pub(crate) struct Node {
    pub(crate) device: Box<dyn Device>,
    script: Script,
    readings: Readings,
    reply_delay: Span,
    /// Its node, 0 for the master; `None` where it is off the bus.
    pub(crate) id: Option<u8>,
    /// Its bits per second, if P.903 names any; the rate of the bus otherwise.
    rate: Option<u32>,
    /// The identifiers of its SDO1, and whether there is an SDO2: P.921 to P.923 as they hold.
    channels: [i64; 3],
    pub(crate) state: State,
    /// It initialises until then, and says its boot-up; whether it takes the place that its parameters name.
    booting: Option<(Tick, bool)>,
    /// What it has to say, and when.
    saying: Vec<(Tick, Frame)>,
    /// The fault that stood when it was looked at last.
    fault: u16,
    /// The master starts everybody then, and beats the time.
    starts: Option<Tick>,
    beats: Option<Tick>,
    process: Process,
    slaves: Slaves,
    /// Off the bus until then, and whether it begins anew.
    away: Option<(Tick, bool)>,
    /// Its controller gave up, which it has told nobody yet.
    owes_off: bool,
    errors: Errors,
    /// Writes to it are refused.
    refused: Option<u16>,
    /// Writes to it are acknowledged, and that is all.
    ignored: Option<u16>,
}

/// Parameters of the system bus (manual 7.2), and the fault key of the basic manual.
const NODE_ID: u32 = 900;
const BOOT_UP_DELAY: u32 = 904;
const SYNC_TIME: u32 = 919;
const BIT_RATE: u32 = 903;
const CHANNELS: [u32; 3] = [921, 922, 923];
/// Bit rates with their codes of P.903 (manual 5.4).
pub(crate) const RATES: [(u32, i64); 6] =
    [(50_000, 3), (100_000, 4), (125_000, 5), (250_000, 6), (500_000, 7), (1_000_000, 8)];
/// Its place on the bus, for which it initialises anew where that holds at once (manual 5.4, 5.5).
const PLACE: [u32; 2] = [NODE_ID, BIT_RATE];
const NODE_STATE: u32 = 978;
const CAN_STATE: u32 = 979;
const FAULT: u32 = 260;
/// The controller of its bus has given up (manual 5.12), and what P.979 shows then and else.
const BUS_OFF: u16 = 0x2210;
const OFF: i64 = 3;
const WARNING: i64 = 2;
const OKAY: i64 = 1;
/// How long a node needs for a new beginning of its communication.
const ANEW: Span = Span::from_millis(100);
/// How long behind its boot-up a node tells of the fault, where that comes second; longer than the boot-up on the slowest bus.
const BEHIND: Span = Span::from_millis(3);

impl Node {
    pub(crate) fn new(device: Box<dyn Device>, script: Script, readings: Readings, reply_delay: Span) -> Self {
        let mut node = Node {
            device,
            script,
            readings,
            reply_delay,
            id: None,
            rate: None,
            channels: [0; 3],
            state: State::PreOperational,
            booting: None,
            saying: Vec::new(),
            fault: 0,
            starts: None,
            beats: None,
            process: Process::new(readings),
            slaves: Slaves::default(),
            away: None,
            owes_off: false,
            errors: Errors::default(),
            refused: None,
            ignored: None,
        };
        node.take_place(Tick::ZERO);
        node.fault = node.fault_key();
        node
    }

    /// Whether it commands the others.
    pub(crate) fn is_master(&self) -> bool {
        self.id == Some(0)
    }

    fn value(&self, number: u32) -> i64 {
        self.device.ram(number, 0).unwrap_or(0)
    }

    /// Takes the place that its parameters name.
    fn take_place(&mut self, now: Tick) {
        self.id = u8::try_from(self.value(NODE_ID)).ok();
        self.rate = RATES.iter().find(|row| row.1 == self.value(BIT_RATE)).map(|row| row.0);
        self.channels = CHANNELS.map(|number| self.value(number));
        self.turn(now, State::PreOperational);
        self.device.act(now, Action::Set(CAN_STATE, 0, OKAY));
        self.starts = self.is_master().then(|| now + self.delay());
        self.beats = (self.is_master() && self.readings.has(Reading::SyncBeginsWithBootUp)).then_some(now);
        self.settle(now);
    }

    /// P.904, at least what is printed.
    fn delay(&self) -> Span {
        self.millis(BOOT_UP_DELAY).longer(Span::from_millis(3_500))
    }

    /// Its PDOs are as its parameters stand now.
    fn settle(&mut self, now: Tick) {
        let Some(id) = self.id else { return };
        self.process.set(now, Settings::of(&*self.device, id, self.readings));
    }

    /// The same, where settings hold at once.
    fn settle_at_once(&mut self, now: Tick) {
        let later = [Reading::SettingsHoldAtPowerOn, Reading::SettingsHoldAfterReset];
        if !later.into_iter().any(|reading| self.readings.has(reading)) {
            self.settle(now);
        }
    }

    fn millis(&self, number: u32) -> Span {
        Span::from_millis(u64::try_from(self.value(number)).unwrap_or(0))
    }

    fn turn(&mut self, now: Tick, state: State) {
        self.state = state;
        self.device.act(now, Action::Set(NODE_STATE, 0, state as i64));
        self.process.turn(now, state == State::Operational, self.device.system_bus());
    }

    fn fault_key(&self) -> u16 {
        if self.device.in_fault() { self.value(FAULT) as u16 } else { 0 }
    }

    /// When something will happen by itself.
    pub(crate) fn next(&self) -> Option<Tick> {
        let said = self.saying.iter().map(|said| said.0);
        let own = [
            self.device.next(),
            self.script.next(&*self.device),
            self.booting.map(|booting| booting.0),
            self.away.map(|away| away.0),
            self.starts,
            self.beats,
            self.process.next(),
        ];
        own.into_iter().flatten().chain(said).min()
    }

    /// Lets the time pass; what it puts on the bus now.
    pub(crate) fn run(&mut self, now: Tick) -> Vec<Frame> {
        self.device.catch_up(now);
        while let Some(action) = self.script.due(now, &*self.device) {
            self.happens(now, action);
        }
        let comes_back = self.comes_back(now);
        if let Some((_, anew)) = self.booting.filter(|booting| booting.0 <= now) {
            self.booting = None;
            match anew {
                true => self.take_place(now),
                false => self.turn(now, State::PreOperational),
            }
            self.boots_up(now);
        }
        if let Some(bus) = self.device.system_bus() {
            let (out, fault) = self.process.run(now, bus);
            self.saying.extend(out.into_iter().map(|frame| (now, frame)));
            if let Some(number) = fault {
                self.device.act(now, Action::Fault(Fault { number, ..Fault::default() }));
            }
        }
        if self.is_master() {
            self.slaves.look(now, &mut *self.device, self.readings);
        }
        let is_late = comes_back && !self.readings.has(Reading::EmergencyComesFirst);
        self.look_for_faults(now, if is_late { now + BEHIND } else { now });
        self.command(now);
        let (due, later) = std::mem::take(&mut self.saying).into_iter().partition(|said| said.0 <= now);
        self.saying = later;
        if self.id.is_none() || self.away.is_some() {
            return Vec::new();
        }
        due.into_iter().map(|said: (Tick, Frame)| said.1).collect()
    }

    /// Something of the script.
    fn happens(&mut self, now: Tick, action: Action) {
        self.device.act(now, action);
        match action {
            Action::PowerCycle => self.restart(now, RESTART),
            Action::Silent(span) => self.away = Some((now + span, false)),
            Action::BusOff(span) => self.gives_up(now, span),
            Action::Set(..) => self.settle_at_once(now),
            Action::Refuses(place) => self.refused = Some(place),
            Action::Ignores(place) => self.ignored = Some(place),
            _ => {}
        }
    }

    /// Its controller is off the bus (manual 5.12).
    fn gives_up(&mut self, now: Tick, span: Span) {
        self.away = Some((now + span, true));
        self.errors = Errors::default();
        self.owes_off = true;
        self.turn(now, State::PreOperational);
        self.device.act(now, Action::Set(CAN_STATE, 0, OFF));
        self.device.act(now, Action::Fault(Fault { number: BUS_OFF, ..Fault::default() }));
    }

    /// Bits per second, on a bus that has so many.
    pub(super) fn rate(&self, bus: u32) -> u32 {
        self.rate.unwrap_or(bus)
    }

    /// Whether its controller acknowledges what others send.
    pub(super) fn takes_part(&self) -> bool {
        self.id.is_some() && self.booting.is_none() && self.away.is_none()
    }

    /// Whether it has failed so often that it disturbs nobody any more.
    pub(super) fn is_passive(&self) -> bool {
        self.errors.is_passive()
    }

    /// So a frame ended, its own or one of somebody else.
    pub(super) fn ended(&mut self, now: Tick, own: bool, ended: Ended) {
        if !self.takes_part() {
            return;
        }
        let before = self.can_state();
        if own {
            self.errors.sent(ended)
        } else {
            self.errors.heard(ended)
        }
        if self.errors.is_off() {
            self.gives_up(now, ANEW);
        } else if self.can_state() != before {
            self.device.act(now, Action::Set(CAN_STATE, 0, self.can_state()));
        }
    }

    /// P.979 of a controller that is on the bus.
    fn can_state(&self) -> i64 {
        let count = if self.readings.has(Reading::WarnsLate) { 128 } else { 96 };
        if self.errors.reaches(count) { WARNING } else { OKAY }
    }

    /// It is on the bus again; whether it begins anew there, as behind BUS-OFF (manual 5.12).
    fn comes_back(&mut self, now: Tick) -> bool {
        let Some((_, anew)) = self.away.filter(|away| away.0 <= now) else { return false };
        self.away = None;
        if anew {
            self.boots_up(now);
            if !self.readings.has(Reading::OffStaysShown) {
                self.device.act(now, Action::Set(CAN_STATE, 0, OKAY));
            }
            if self.is_master() && self.readings.has(Reading::MasterWaitsAgain) {
                self.starts = Some(now + self.delay());
            }
        }
        anew
    }

    fn boots_up(&mut self, now: Tick) {
        let boots = !self.is_master() || self.readings.has(Reading::MasterBootsUp);
        let frame = self.id.and_then(|id| Service::BootUp(id).identifier());
        let frame = frame.and_then(|identifier| Frame::data(identifier, &Life::BootUp.encode()));
        self.saying.extend(frame.filter(|_| boots).map(|frame| (now, frame)));
    }

    /// A fault that came or was acknowledged is told at that time (manual 5.8.3, 5.9.3), behind BUS-OFF when the bus is there again. BUS-OFF
    /// itself is told of also by who stood in another fault already (manual 5.12).
    fn look_for_faults(&mut self, now: Tick, at: Tick) {
        let fault = self.fault_key();
        if self.away.is_some() {
            return;
        }
        let is_off = std::mem::take(&mut self.owes_off);
        if fault == std::mem::replace(&mut self.fault, fault) && !is_off {
            return;
        }
        if fault == 0 {
            self.device.act(now, Action::Set(CAN_STATE, 0, self.can_state()));
        }
        if self.state == State::Stopped && self.readings.has(Reading::StoppedIsMute) {
            return;
        }
        let told = match (is_off, fault) {
            (true, _) => Emergency::of_a_drive(BUS_OFF),
            (false, 0) => Emergency::CLEARED,
            (false, fault) => Emergency::of_a_drive(fault),
        };
        let identifier = self.id.and_then(|id| Service::Emergency(id).identifier());
        let frame = identifier.and_then(|identifier| Frame::data(identifier, &told.encode()));
        self.saying.extend(frame.map(|frame| (at, frame)));
    }

    /// What a master drive does: it starts all again and again, and beats the time (manual 5.8.1, 5.8.2).
    fn command(&mut self, now: Tick) {
        if self.starts.is_some_and(|at| at <= now) {
            self.starts = Some(now + self.delay());
            let order = Order { command: Command::Start, node: 0 };
            self.saying.extend(Frame::data(0, &order.encode()).map(|frame| (now, frame)));
            self.turn(now, State::Operational);
            self.beats = self.beats.or(Some(now));
        }
        if self.beats.is_some_and(|at| at <= now) {
            let beat = self.millis(SYNC_TIME);
            self.beats = (beat > Span::ZERO).then(|| now + beat);
            if beat > Span::ZERO {
                self.saying.extend(Frame::data(self.process.settings.sync, &[]).map(|frame| (now, frame)));
                let bus = self.device.system_bus();
                let out = bus.map(|bus| self.process.sync(now, bus)).unwrap_or_default();
                self.saying.extend(out.into_iter().map(|frame| (now, frame)));
            }
        }
    }

    /// It begins anew, and is away meanwhile.
    fn restart(&mut self, now: Tick, span: Span) {
        self.device.power_up(now, now + span);
        self.turn(now, State::PreOperational);
        self.booting = Some((now + span, true));
        self.owes_off = false;
        self.saying.clear();
    }

    /// A frame of somebody else was on the bus until now. Whether it was a question that it answers.
    pub(crate) fn hear(&mut self, now: Tick, frame: &Frame) -> bool {
        let (Identifier::Standard(identifier), Body::Data(payload)) = (frame.identifier, &frame.body) else {
            return false;
        };
        let Some(id) = self.id.filter(|_| self.booting.is_none() && self.away.is_none()) else { return false };
        self.device.catch_up(now);
        if let Some(bus) = self.device.system_bus() {
            let out = self.process.hear(now, identifier, payload.bytes(), bus);
            self.saying.extend(out.into_iter().map(|frame| (now, frame)));
        }
        if self.is_master()
            && let Service::Emergency(node) = Service::of(identifier)
            && let Some(told) = Emergency::decode(payload.bytes())
        {
            self.slaves.hear(now, node, told, &mut *self.device, self.readings);
        }
        if identifier == 0 {
            if let Some(order) = Order::decode(payload.bytes()).filter(|order| order.node == 0 || order.node == id) {
                self.obey(now, order.command);
            }
            return false;
        }
        let Some(reply_on) = self.served(id, identifier).filter(|_| self.state != State::Stopped) else { return false };
        let Some(reply) = payload.eight().and_then(|data| self.serve(now, Request::decode(data))) else { return false };
        self.saying.extend(Frame::data(reply_on, &reply.encode()).map(|frame| (now + self.reply_delay, frame)));
        true
    }

    fn obey(&mut self, now: Tick, command: Command) {
        if self.is_master() && !self.readings.has(Reading::MasterObeys) {
            return;
        }
        match command {
            Command::Start => self.turn(now, State::Operational),
            Command::Stop => self.turn(now, State::Stopped),
            Command::PreOperational => self.turn(now, State::PreOperational),
            Command::ResetNode | Command::ResetCommunication => {
                self.turn(now, State::PreOperational);
                if self.readings.has(Reading::SettingsHoldAfterReset) {
                    self.settle(now);
                }
                self.booting = Some((now + ANEW, self.readings.has(Reading::PlaceHoldsAfterReset)));
            }
            Command::Unknown(_) => {}
        }
    }

    /// The identifier on which a question under another one is answered.
    fn served(&self, id: u8, identifier: u16) -> Option<u16> {
        let [rx, tx, active] = self.channels;
        let set = |number: i64, usual: Service| {
            u16::try_from(number).ok().filter(|number| *number != 0).or(usual.identifier())
        };
        let serves_sdo1 = !self.is_master() || self.readings.has(Reading::MasterServesSdo1);
        if serves_sdo1 && set(rx, Service::SdoRequest(SdoChannel::One, id)) == Some(identifier) {
            return set(tx, Service::SdoReply(SdoChannel::One, id));
        }
        let is_second = Service::SdoRequest(SdoChannel::Two, id).identifier() == Some(identifier);
        Service::SdoReply(SdoChannel::Two, id).identifier().filter(|_| is_second && active == 1)
    }

    fn serve(&mut self, now: Tick, request: Request) -> Option<Reply> {
        let silent = self.readings.has(Reading::SegmentsAreSilent);
        let code = if self.readings.has(Reading::SegmentsAreWrongType) { server::TYPE } else { server::OTHER };
        let refused = |of, code: u8| Reply::Abort(of, AbortCode(code.into()));
        let nobody = Multiplexer { index: 0, sub: 0 };
        self.script.count(matches!(request, Request::Download(..)));
        match request {
            Request::Upload(of) => {
                let told = server::upload(&mut *self.device, self.readings, now, of);
                Some(told.unwrap_or_else(|code| refused(of, code)))
            }
            Request::Download(of, Initiate::Expedited { bytes, .. }) => {
                let done = self.download(now, of, u32::from_le_bytes(bytes));
                Some(done.map_or_else(|code| refused(of, code), |()| Reply::Downloaded(of)))
            }
            Request::Abort(..) => None,
            _ if silent => None,
            Request::Download(of, _) => Some(refused(of, code)),
            Request::DownloadSegment(_) | Request::UploadSegment { .. } | Request::Other(_) => {
                Some(refused(nobody, code))
            }
        }
    }

    fn download(&mut self, now: Tick, of: Multiplexer, bits: u32) -> Result<(), u8> {
        let place = Some(u16::from(of.sub) << 12 | of.index);
        if self.refused == place {
            return Err(server::OTHER);
        }
        if self.ignored == place {
            return Ok(());
        }
        match server::download(&mut *self.device, self.readings, now, of, bits)? {
            Effect::Reset => self.restart(now, RESTART),
            // The answer still goes out at the old place.
            Effect::None if self.readings.has(Reading::PlaceHoldsAtOnce) && PLACE.contains(&of.index.into()) => {
                self.booting = Some((now + ANEW, true));
            }
            Effect::None if self.readings.has(Reading::PlaceHoldsAtOnce) && CHANNELS.contains(&of.index.into()) => {
                self.channels = CHANNELS.map(|number| self.value(number));
            }
            Effect::None => self.settle_at_once(now),
        }
        Ok(())
    }
}
