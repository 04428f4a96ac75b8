//! What a device is asked that nobody knows yet: its status word, as if it were an ACTIVE drive.

use super::route::{Cell, Inquiry, Route};
use crate::exchange::Question;
use crate::profile::{Route as Way, Type};
use crate::protocol::Protocol;
use crate::protocol::modbus::pdu::{Request, WordOrder};

/// Status word of both families (CM-485 manual 9, 10).
pub(super) const STATUS_WORD: Cell = Cell { number: 411, set: 0 };

/// The way to a device that nobody knows yet: as if it were an ACTIVE drive.
pub(super) fn presumed(protocol: Protocol, address: u8) -> Route {
    Route { protocol, way: Way::Active, address, node: 0, order: WordOrder::default() }
}

/// The question that every device is asked first: its status word. An ACTIVE drive answers it without touching its
/// error register; any other Modbus device says something too. `None` if the protocol has no such address.
pub(super) fn probe(protocol: Protocol, address: u8) -> Option<Question> {
    presumed(protocol, address).question(Inquiry::Read(STATUS_WORD, Type::Uint))
}

/// A question whose echo cannot be taken for its reply.
pub(super) fn sounding() -> Request {
    Request::ReadRegisters { start: STATUS_WORD.number as u16, count: 1 }
}
