//! Writes that are acknowledged, and nothing comes of them.

use crate::protocol::modbus::pdu::{Reply, Request};
use crate::protocol::vabus as bus;

/// What acknowledges a write to this place over Modbus.
pub(super) fn acknowledged(pdu: &[u8], place: u16) -> Option<Reply> {
    match Request::decode(pdu).ok()? {
        Request::WriteRegister { address, value } if address == place => {
            Some(Reply::RegisterWritten { address, value })
        }
        Request::WriteRegisters { start, values } if start == place => {
            Some(Reply::RegistersWritten { start, count: values.len() as u16 })
        }
        Request::WriteLong { address, value } if address == place => Some(Reply::LongWritten { address, value }),
        _ => None,
    }
}

/// The same over VABus, whatever the data set.
pub(super) fn acked(request: &bus::Request, place: u16) -> Option<bus::Reply> {
    match *request {
        bus::Request::Select { address, header, .. } if header.number.get() == place => {
            Some(bus::Reply::Ack { address })
        }
        _ => None,
    }
}
