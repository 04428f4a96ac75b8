//! VABus of an ACT or ACU (sources A1 to A4; EM-RES-03 manual 5.10.2): what it answers, and the drives of the
//! system bus that can be reached through it.
//!
//! Choices where the sources are silent or say two things:
//! - a wrong check character gets NAK and cause 12, which the EM-RES-03 manual (5.10.1) names for this protocol only; all
//!   else that is wrong in the structure gets silence (sources A2), so cause 13 is left for values that are no digits;
//! - a SELECT during the lock gets NAK and changes nothing, the cause in P.11 neither;
//! - every NAK locks, also one to an enquiry; power-on and a change of the protocol unlock;
//! - a string parameter exists only where the bench file gives it a text, in one copy for all memories and data sets;
//! - a drive is system-bus master if the bench file puts nodes behind it; a node that restarts is not reachable; P.11 of
//!   a node does not hear of accesses through the master.

use super::access::Width;
use super::cause::Cause;
use super::readings::Reading;
use super::state::Active;
use crate::profile::Type;
use crate::protocol::modbus::pdu::ParamAddress;
use crate::protocol::vabus::{Address, Data, Header, ParamNumber, Reply, Request, SystemNode};
use crate::simulator::device::contract::{Effect, RESTART};
use crate::tick::Tick;

/// The VABus side of a drive.
#[derive(Clone, Debug)]
pub(crate) struct Slave {
    /// A NAK was sent and P.11 not read since.
    locked: bool,
    nodes: Vec<Node>,
}

/// A drive on the system bus.
#[derive(Clone, Debug)]
pub(crate) struct Node {
    pub(crate) id: u8,
    pub(crate) active: Active,
    /// It restarts until then.
    away: Tick,
}

impl Node {
    pub(crate) fn new(id: u8, active: Active) -> Self {
        Node { id, active, away: Tick::ZERO }
    }
}

/// Why a telegram gets NAK; `None` leaves P.11 as it is.
type Refusal = Option<Cause>;

impl Slave {
    pub(crate) fn new(nodes: Vec<Node>) -> Self {
        Slave { locked: false, nodes }
    }

    /// Takes SELECTs again.
    pub(crate) fn unlock(&mut self) {
        self.locked = false;
    }

    /// The drives behind this one.
    pub(crate) fn nodes(&self) -> impl Iterator<Item = &Active> {
        self.nodes.iter().map(|node| &node.active)
    }

    /// When something will happen behind this drive by itself.
    pub(crate) fn next(&self) -> Option<Tick> {
        self.nodes().filter_map(Active::next).min()
    }

    /// Lets the time pass for the drives behind this one.
    pub(crate) fn catch_up(&mut self, now: Tick) {
        self.nodes.iter_mut().for_each(|node| node.active.catch_up(now));
    }

    /// Executes a request and makes the reply; `None` is silence.
    pub(crate) fn answer(&mut self, drive: &mut Active, now: Tick, request: &Request) -> Option<(Reply, Effect)> {
        let address = request.address();
        if self.locked && matches!(request, Request::Select { .. }) && drive.has(Reading::SilentAfterNak) {
            return None;
        }
        Some(match self.execute(drive, now, request) {
            Ok((None, effect)) => (Reply::Ack { address }, effect),
            Ok((Some(data), effect)) => {
                let header = request.header();
                let set = if drive.has(Reading::SetAsAsked) { header.set } else { header.set.as_replied() };
                let header = Header { set, ..header };
                (Reply::Value { address, header, data }, effect)
            }
            Err(refusal) => (self.refuse(drive, address, refusal), Effect::None),
        })
    }

    /// Obeys a broadcast: nobody answers, and so nobody is locked by one.
    pub(crate) fn obey(&mut self, drive: &mut Active, now: Tick, request: &Request) -> Effect {
        match request {
            Request::Enquiry { .. } => Effect::None,
            Request::Select { .. } => self.execute(drive, now, request).map_or(Effect::None, |(_, effect)| effect),
        }
    }

    /// What a telegram with a wrong check character gets, if it names this drive.
    pub(crate) fn garbled(&mut self, drive: &mut Active, own: Address, telegram: &[u8]) -> Option<(Reply, Effect)> {
        let named = telegram.get(1).is_some_and(|&byte| byte == own.character());
        let named = named && !drive.has(Reading::SilentOnWrongCheck);
        named.then(|| (self.refuse(drive, own, Some(Cause::Check)), Effect::None))
    }

    /// What a write gets that is refused, with P.11 as it is.
    pub(crate) fn refused(&mut self, drive: &mut Active, own: Address) -> Option<Reply> {
        let is_silent = self.locked && drive.has(Reading::SilentAfterNak);
        (!is_silent).then(|| self.refuse(drive, own, None))
    }

    fn refuse(&mut self, drive: &mut Active, address: Address, refusal: Refusal) -> Reply {
        self.locked = true;
        if let Some(cause) = refusal {
            drive.blame(cause);
        }
        Reply::Nak { address }
    }

    fn execute(&mut self, drive: &mut Active, now: Tick, request: &Request) -> Result<(Option<Data>, Effect), Refusal> {
        let Header { node, set, number } = request.header();
        let at = ParamAddress::new(set.number(), number.get()).ok_or(Some(Cause::Unknown))?;
        match request {
            Request::Enquiry { .. } if node == SystemNode::SELF => {
                let data = read(drive, now, at)?;
                if number == ParamNumber::ERROR_REGISTER {
                    self.locked = false;
                }
                Ok((Some(data), Effect::None))
            }
            Request::Select { .. } if self.locked => Err(None),
            Request::Select { data, .. } if node == SystemNode::SELF => Ok((None, write(drive, now, at, data)?)),
            Request::Enquiry { .. } => {
                Ok((Some(read(&mut self.node(drive, now, node, at)?.active, now, at)?), Effect::None))
            }
            Request::Select { data, .. } => {
                let behind = self.node(drive, now, node, at)?;
                if write(&mut behind.active, now, at, data)? == Effect::Reset {
                    behind.away = now + RESTART;
                    behind.active.power_up(now, behind.away);
                }
                Ok((None, Effect::None))
            }
        }
    }

    /// The drive behind this one that an access means. The parameter must exist in the master too, and strings do not
    /// travel (EM-RES-03 manual 5.10.2, 5.8.4).
    fn node(&mut self, drive: &Active, now: Tick, node: SystemNode, at: ParamAddress) -> Result<&mut Node, Cause> {
        if drive.kind(at.number())? == Type::String {
            return Err(Cause::StringOnBus);
        }
        let reached = self.nodes.iter_mut().find(|behind| behind.id == node.id() && behind.away <= now);
        reached.ok_or(Cause::NotReachable)
    }
}

fn read(drive: &mut Active, now: Tick, at: ParamAddress) -> Result<Data, Cause> {
    match drive.kind(at.number())? {
        Type::String => drive.read_text(at).and_then(|text| Data::text(text).map_err(|_| Cause::Other)),
        Type::Long => drive.fetch(now, at, Width::Long).map(Data::long),
        _ => drive.fetch(now, at, Width::Word).map(|bits| Data::word(bits as u16)),
    }
}

fn write(drive: &mut Active, now: Tick, at: ParamAddress, data: &Data) -> Result<Effect, Cause> {
    let (width, digits, bits) = match drive.kind(at.number())? {
        Type::String => return drive.write_text(at, data.characters()),
        Type::Long => (Width::Long, 8, data.as_long()),
        _ => (Width::Word, 4, data.as_word().map(u32::from)),
    };
    match bits {
        Some(bits) => drive.put(now, at, width, bits),
        None if data.characters().len() == digits => Err(Cause::Syntax),
        None => Err(Cause::Width),
    }
}
