//! Rules of VABus (sources A2).

use super::sin::Sin;
use crate::protocol::vabus::{Address, ParamNumber, Reply, Request, SystemNode};
use std::collections::BTreeSet;

/// Transmissions of one telegram in one exchange of VABus (sources A2).
const MOST_TRANSMISSIONS: u32 = 3;

/// What a master of VABus has to keep in mind.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rules {
    /// Drives that sent NAK and whose P.11 has not been told since.
    locked: BTreeSet<Address>,
    /// The last request, and how often it was sent without a good reply.
    repeated: Option<(Request, u32)>,
}

impl Rules {
    /// A request of VABus is complete: whether the master may send it, and how often.
    pub(crate) fn weigh(&mut self, request: &Request) -> Vec<(Sin, String)> {
        let mut broken = Vec::new();
        let count = match self.repeated.take() {
            Some((last, count)) if last == *request => count + 1,
            _ => 1,
        };
        self.repeated = Some((request.clone(), count));
        if count > MOST_TRANSMISSIONS {
            let text = format!("transmission {count} of one telegram, at most {MOST_TRANSMISSIONS} allowed");
            broken.push((Sin::TooOften, text));
        }
        if matches!(request, Request::Select { address, .. } if self.locked.contains(address)) {
            let address = request.address();
            let text = format!("SELECT to drive {address} after its NAK; P.11 has to be read first");
            broken.push((Sin::Locked, text));
        }
        broken
    }

    /// The master ends an exchange of VABus.
    pub(crate) fn ends_exchange(&mut self) {
        self.repeated = None;
    }

    /// A drive puts this reply on the wire, as the master will hear it.
    pub(crate) fn overhears(&mut self, frame: &[u8]) {
        let Ok(reply) = Reply::decode(frame) else { return };
        self.repeated = None;
        match reply {
            Reply::Nak { address } => {
                self.locked.insert(address);
            }
            Reply::Value { address, header, .. }
                if (header.node, header.number) == (SystemNode::SELF, ParamNumber::ERROR_REGISTER) =>
            {
                self.locked.remove(&address);
            }
            Reply::Value { .. } | Reply::Ack { .. } => {}
        }
    }
}
