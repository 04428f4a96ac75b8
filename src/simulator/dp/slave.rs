//! A slave of PROFIBUS-DP: the data link layer with its frame count bit, and the states of DP-V0 (IEC 61158-4-3, 61158-6-3).
//!
//! Wait_Prm -> (Set_Prm) -> Wait_Cfg -> (Chk_Cfg) -> Data_Exchange. What is refused, a watchdog and an Unlock lead back.

use super::inverter::EXTERNAL;
use super::module::{End, Module};
use super::readings::{self, Reading};
use crate::protocol::dp::cfg::Layout;
use crate::protocol::dp::control::{Count, Function, Station, Status};
use crate::protocol::dp::diagnosis::{Block, NOBODY};
use crate::protocol::dp::prm::{LOCK, UNLOCK};
use crate::protocol::dp::{Control, Diagnosis, EVERYBODY, Frame, Parameters, Service, Telegram};
use crate::tick::{Span, Tick};

/// Where the slave stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum State {
    WaitPrm,
    WaitCfg,
    Exchange,
}

/// A question as it was answered: the same again gets the same again.
#[derive(Clone, Debug)]
struct Answered {
    from: u8,
    bit: bool,
    reply: Option<Vec<u8>>,
}

#[derive(Clone, Debug)]
pub(crate) struct Slave {
    pub(crate) module: Module,
    ident: u16,
    state: State,
    /// Who parameterised it.
    master: Option<u8>,
    user: Vec<u8>,
    groups: u8,
    watchdog: Option<Span>,
    fed: Tick,
    prm_fault: bool,
    cfg_fault: bool,
    /// A diagnosis that the master has not fetched.
    has_news: bool,
    /// What was configured last.
    configured: Option<Layout>,
    last: Option<Answered>,
    /// Off, or reading the inverter, until then.
    pub(crate) up: Tick,
    /// Nothing comes to it, and nothing of it comes to anybody.
    pub(crate) is_cut: bool,
}

/// Bits of the first and second byte of Slave_Diag (IEC 61158-6-3).
const NOT_READY: u8 = 1 << 1;
const CFG_FAULT: u8 = 1 << 2;
const EXT_DIAG: u8 = 1 << 3;
const PRM_FAULT: u8 = 1 << 6;
const PRM_REQ: u8 = 1;
const ALWAYS: u8 = 1 << 2;
const WD_ON: u8 = 1 << 3;
/// Global_Control: outputs to zero.
const CLEAR: u8 = 1 << 1;
/// The module reads the inverter first, and is not ready meanwhile (SJ2-PB manual 3.1; how long is in no source).
const READS_INVERTER: Span = Span::from_millis(500);
/// Where a master asks from (IEC 61158-6-3: MS0).
const SAP_OF_MASTER: u8 = 62;

/// What a question gets.
enum Said {
    Ack,
    Data(Vec<u8>),
    Refused(Status),
    Nothing,
}

impl Slave {
    pub(crate) fn new(module: Module, ident: u16) -> Self {
        let up = Tick::ZERO + READS_INVERTER;
        Slave {
            module,
            ident,
            state: State::WaitPrm,
            master: None,
            user: Vec::new(),
            groups: 0,
            watchdog: None,
            fed: Tick::ZERO,
            prm_fault: false,
            cfg_fault: false,
            has_news: false,
            configured: None,
            last: None,
            up,
            is_cut: false,
        }
    }

    pub(crate) fn address(&self) -> u8 {
        self.module.address
    }

    /// Whether data are exchanged.
    pub(crate) fn exchanges(&self) -> bool {
        self.state == State::Exchange
    }

    /// When its watchdog acts.
    pub(crate) fn next(&self) -> Option<Tick> {
        let watchdog = self.watchdog.filter(|_| self.state != State::WaitPrm)?;
        Some(self.fed + watchdog)
    }

    pub(crate) fn catch_up(&mut self, now: Tick) {
        if self.next().is_some_and(|at| at <= now) {
            self.leaves(now, End::Watchdog);
        }
        self.module.catch_up(now);
    }

    /// The inverter trips.
    pub(crate) fn trips(&mut self, now: Tick) {
        self.module.trips(now, EXTERNAL);
        self.has_news |= !self.module.readings.has(Reading::TripIsSilent) && self.state == State::Exchange;
    }

    /// Back to the beginning.
    fn leaves(&mut self, now: Tick, end: End) {
        let exchanged = self.state == State::Exchange;
        (self.state, self.master, self.watchdog, self.has_news) = (State::WaitPrm, None, None, false);
        if exchanged {
            self.module.ends(now, end);
            self.module.layout = None;
        }
    }

    /// Takes a telegram that was complete at `now`; its answer. Whether a repeat was another question.
    pub(crate) fn hear(&mut self, now: Tick, frame: &Frame) -> Option<Vec<u8>> {
        self.catch_up(now);
        let Control::Request { function, count } = frame.control else { return None };
        if frame.to == EVERYBODY {
            self.everybody(now, frame);
            return None;
        }
        if frame.to != self.address() {
            return None;
        }
        let bit = match count {
            Count::Bit(bit) => Some(bit),
            Count::First => Some(true),
            Count::Unused => None,
        };
        let again = self.last.as_ref().filter(|last| last.from == frame.from && count == Count::Bit(last.bit));
        if let Some(again) = again {
            return again.reply.clone();
        }
        if self.module.readings.has(Reading::FedByTelegrams) && self.master == Some(frame.from) {
            self.fed = now;
        }
        let reply = self.reply(now, function, frame);
        self.last = bit.map(|bit| Answered { from: frame.from, bit, reply: reply.clone() });
        reply
    }

    fn reply(&mut self, now: Tick, function: Function, frame: &Frame) -> Option<Vec<u8>> {
        let said = match function {
            Function::FdlStatus => Said::Refused(Status::Ok),
            Function::SrdLow | Function::SrdHigh => self.serve(now, frame),
            Function::SdaLow | Function::SdaHigh => Said::Refused(Status::NoService),
            _ => Said::Nothing,
        };
        let (status, data) = match said {
            Said::Nothing => return None,
            Said::Ack => return Some(Telegram::Ack.encode()),
            Said::Refused(status) => (status, Vec::new()),
            Said::Data(data) => {
                let is_exchange = Service::of(frame) == Service::DataExchange;
                (if is_exchange && self.has_news { Status::DataHigh } else { Status::DataLow }, data)
            }
        };
        let (dsap, ssap) = if data.is_empty() { (None, None) } else { (frame.ssap, frame.dsap) };
        let control = Control::Reply { station: Station::Slave, status };
        let reply = Frame { to: frame.from, from: self.address(), control, dsap, ssap, data, is_fixed: false };
        Some(Telegram::Frame(reply).encode())
    }

    fn serve(&mut self, now: Tick, frame: &Frame) -> Said {
        let service = Service::of(frame);
        if service != Service::DataExchange && frame.ssap != Some(SAP_OF_MASTER) {
            return Said::Refused(Status::NoService);
        }
        let owns = self.master == Some(frame.from);
        match service {
            Service::SlaveDiag => {
                self.has_news &= !owns;
                Said::Data(self.diagnosis(now).encode())
            }
            Service::GetCfg => {
                let layout = self.configured.unwrap_or(readings::unconfigured(self.module.readings));
                Said::Data(layout.bytes().to_vec())
            }
            // It reads the inverter first (3.1).
            _ if now < self.up => Said::Refused(Status::NoService),
            Service::SetPrm => self.parameterise(now, frame),
            Service::ChkCfg if owns && self.state != State::WaitPrm => self.configure(now, &frame.data),
            Service::DataExchange if owns && self.state == State::Exchange => self.exchange(now, &frame.data),
            _ => Said::Refused(Status::NoService),
        }
    }

    fn diagnosis(&self, now: Tick) -> Diagnosis {
        let bit = |is: bool, bit: u8| if is { bit } else { 0 };
        let tripped = self.module.inverter.trip.is_some() && !self.module.readings.has(Reading::TripIsSilent);
        let not_ready = self.state != State::Exchange || now < self.up;
        let first = bit(not_ready, NOT_READY)
            | bit(self.cfg_fault, CFG_FAULT)
            | bit(tripped, EXT_DIAG)
            | bit(self.prm_fault, PRM_FAULT);
        let second = ALWAYS | bit(self.state == State::WaitPrm, PRM_REQ) | bit(self.watchdog.is_some(), WD_ON);
        let cause = self.module.inverter.trip.map_or(0, |trip| trip.cause);
        let block = Block::Device(vec![2, cause]);
        let blocks = if tripped { vec![block] } else { Vec::new() };
        let master = self.master.unwrap_or(NOBODY);
        Diagnosis { status: [first, second, 0], master, ident: self.ident, blocks }
    }

    /// Set_Prm: of somebody else than its master, or for another device, it changes nothing.
    fn parameterise(&mut self, now: Tick, frame: &Frame) -> Said {
        let Some(said) = Parameters::decode(&frame.data) else { return Said::Refused(Status::NoService) };
        if self.master.is_some_and(|master| master != frame.from) {
            return Said::Ack;
        }
        if said.status & UNLOCK != 0 {
            self.leaves(now, End::Unlock);
            return Said::Ack;
        }
        if said.status & LOCK == 0 {
            return Said::Ack;
        }
        if said.ident != self.ident {
            self.leaves(now, End::Unlock);
            self.prm_fault = true;
            return Said::Ack;
        }
        let was = self.state;
        (self.prm_fault, self.cfg_fault) = (false, false);
        (self.state, self.master, self.groups) = (State::WaitCfg, Some(frame.from), said.groups);
        (self.watchdog, self.fed) = (said.watchdog_time(), now);
        if was == State::Exchange && self.user == said.user {
            self.state = State::Exchange; // the same again changes only times and groups
        }
        self.user = said.user;
        Said::Ack
    }

    fn configure(&mut self, now: Tick, cfg: &[u8]) -> Said {
        if self.state == State::Exchange && self.configured.is_some_and(|layout| layout.bytes() == cfg) {
            return Said::Ack;
        }
        match self.module.configure(cfg, &self.user) {
            Some(layout) => {
                self.configured = Some(layout);
                (self.state, self.fed, self.cfg_fault) = (State::Exchange, now, false);
            }
            None => {
                self.leaves(now, End::Unlock);
                let is_series = self.module.readings.has(Reading::SeriesIsPrmFault) && Layout::of("", cfg).is_some();
                (self.prm_fault, self.cfg_fault) = (is_series, !is_series);
            }
        }
        Said::Ack
    }

    fn exchange(&mut self, now: Tick, outputs: &[u8]) -> Said {
        if self.configured.is_none_or(|layout| layout.length() != outputs.len()) {
            self.leaves(now, End::Unlock);
            self.cfg_fault = true;
            return Said::Refused(Status::NoService);
        }
        self.fed = now;
        Said::Data(self.module.exchange(now, outputs))
    }

    /// Global_Control: to everybody, or to groups; only its master commands.
    fn everybody(&mut self, now: Tick, frame: &Frame) {
        let &[command, groups, ..] = &*frame.data else { return };
        let is_meant = groups == 0 || groups & self.groups != 0;
        if Service::of(frame) != Service::GlobalControl || self.master != Some(frame.from) || !is_meant {
            return;
        }
        if command & CLEAR != 0 && self.state == State::Exchange {
            self.module.ends(now, End::Clear);
        }
    }
}
