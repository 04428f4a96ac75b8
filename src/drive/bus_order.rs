//! Tells nodes of a CAN bus something as master of the network (EM-RES-03 manual 5.8.1), and looks what they do behind it.

use super::access::AccessError;
use super::session::Session;
use crate::exchange::can::Sign;
use crate::protocol::can::nmt::{Command, Order};
use crate::tick::Span;

/// What nodes can be told.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BusOrder {
    /// Operational: PDOs flow.
    Start,
    /// Stopped: neither PDOs nor SDOs.
    Stop,
    /// Pre-Operational: no PDOs.
    PreOperational,
    /// Begin anew.
    Reset,
}

/// How long a node gets to obey; a choice, the manual has no time. One that begins anew takes longer: the software of a drive a few
/// seconds (CM-485 manual 5.2.1).
const OBEYING: Span = Span::from_millis(100);
const ANEW: Span = Span::from_secs(5);
/// So often it is looked whether one has begun anew.
const LOOK: Span = Span::from_millis(50);

impl BusOrder {
    fn to(self, node: Option<u8>) -> Order {
        let command = match self {
            BusOrder::Start => Command::Start,
            BusOrder::Stop => Command::Stop,
            BusOrder::PreOperational => Command::PreOperational,
            BusOrder::Reset => Command::ResetNode,
        };
        Order { command, node: node.unwrap_or(0) }
    }

    /// The frame that tells it to a node, or to all, as candump writes it.
    pub fn shown(self, node: Option<u8>) -> String {
        let [specifier, node] = self.to(node).encode();
        format!("000#{specifier:02X}{node:02X}")
    }
}

impl Session<'_> {
    /// Tells a node something, or all of them, and waits until these may have obeyed: behind a reset until all of `awaited` have shown a
    /// boot-up, or 5 s, which are waited out where nobody is named. Nothing proves it here; an error is a port that is lost, or an interrupt.
    pub async fn tell_nodes(&mut self, what: BusOrder, node: Option<u8>, awaited: &[u8]) -> Result<(), AccessError> {
        self.forget_nodes();
        self.order(what.to(node)).await?;
        if what != BusOrder::Reset {
            return self.rest(OBEYING).await;
        }
        let until = self.now() + ANEW;
        while self.now() < until && (awaited.is_empty() || awaited.iter().any(|node| !self.has_booted(*node))) {
            self.rest(LOOK).await?;
        }
        self.rest(OBEYING).await
    }

    /// Whether the boot-up of a node was heard since it was told something.
    pub fn has_booted(&self, node: u8) -> bool {
        let signs = |traffic: crate::exchange::can::Traffic| traffic.nodes.get(&node).cloned();
        self.traffic().and_then(signs).is_some_and(|signs| signs.contains(&Sign::BootUp))
    }

    /// Nodes that were heard so far.
    pub fn nodes_heard(&self) -> Vec<u8> {
        self.traffic().map(|traffic| traffic.nodes.into_keys().collect()).unwrap_or_default()
    }

    /// Whether a master of the network was heard.
    pub fn has_master(&self) -> bool {
        self.traffic().is_some_and(|traffic| traffic.has_master)
    }
}
