//! The line by the parameters of an ACT or ACU: which of them say what is spoken, how, and at which address.
//!
//! Choices where the manual is silent:
//! - a new protocol (P.395) or address (P.1376, P.394 of VABus) holds from the end of the reply to the write on, because
//!   that must come from the old address; P.10 and P.1375 wait for a reset (CM-485 manual 5.2);
//! - VABus is 7E1 (sources A1) whatever P.1375 says, which is called "Modbus parity".

use super::readings::Reading;
use super::state::Active;
use crate::protocol::line::{LineSetting, Parity};
use crate::simulator::device::contract::{Goes, NodeSetting};
use crate::simulator::line::speech::Spoken;

/// P.10 and what it means (CM-485 manual 5.2.1).
pub(crate) const BAUD_RATES: [(i64, u32); 6] =
    [(1, 2_400), (2, 4_800), (3, 9_600), (4, 19_200), (5, 57_600), (6, 115_200)];
/// P.1375 and what it means (CM-485 manual 5.2.1).
const PARITIES: [(i64, Parity); 3] = [(0, Parity::Even), (1, Parity::Odd), (2, Parity::None)];
/// P.395 and what it means (CM-485 manual 6).
const PROTOCOLS: [(i64, Spoken); 4] = [(0, Spoken::Vabus), (1, Spoken::PBus), (2, Spoken::RTU), (3, Spoken::ASCII)];
/// Protocol, both addresses, reset: what a reply can be lost by (CM-485 manual 5.2.1, 6; sources A1).
const LINE_PARAMS: [u16; 4] = [395, 1376, 394, 34];

/// What no parameter tells of the line, and what only power-on reads.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LineParams {
    /// P.1375 as it was at power-on.
    modbus_parity: Parity,
    /// Data bits in ASCII mode; 7 by the manual.
    ascii_bits: u8,
    /// Character format of VABus; 7E1 by the manual.
    vabus_line: LineSetting,
}

impl LineParams {
    pub(crate) fn new(place: NodeSetting) -> Self {
        let NodeSetting { spoken, line, .. } = place;
        LineParams {
            modbus_parity: line.parity,
            ascii_bits: if spoken == Spoken::ASCII { line.data_bits } else { 7 },
            vabus_line: if spoken == Spoken::Vabus { line } else { LineSetting::vabus(line.baud) },
        }
    }

    /// Everything, from the RAM copy of its parameters: only at power-on.
    pub(crate) fn at_power_on(&mut self, drive: &Active, before: NodeSetting) -> NodeSetting {
        let baud = BAUD_RATES.iter().find(|row| row.0 == drive.value(10)).map_or(before.line.baud, |row| row.1);
        let parity = PARITIES.iter().find(|row| row.0 == drive.value(1375)).map(|row| row.1);
        self.modbus_parity = parity.unwrap_or(self.modbus_parity);
        let NodeSetting { address, spoken, .. } = self.after_write(drive, before);
        NodeSetting { address, spoken, line: self.shape(spoken, baud) }
    }

    /// Protocol and address, from the RAM copy of their parameters.
    pub(crate) fn after_write(&self, drive: &Active, before: NodeSetting) -> NodeSetting {
        let number = drive.value(395);
        let spoken = PROTOCOLS.iter().find(|row| row.0 == number).map_or(Spoken::PBus, |row| row.1);
        let address = if spoken == Spoken::Vabus { 394 } else { 1376 };
        let address = u8::try_from(drive.value(address)).unwrap_or(before.address);
        let line = if spoken == before.spoken { before.line } else { self.shape(spoken, before.line.baud) };
        NodeSetting { address, spoken, line }
    }

    fn shape(&self, spoken: Spoken, baud: u32) -> LineSetting {
        let parity = self.modbus_parity;
        match spoken {
            Spoken::ASCII => LineSetting { data_bits: self.ascii_bits, ..LineSetting::ascii(baud, parity) },
            Spoken::Modbus(_) | Spoken::PBus => LineSetting::rtu(baud, parity),
            Spoken::Vabus => LineSetting { baud, ..self.vabus_line },
        }
    }
}

/// The parameters that hold a place on the line. VABus has an address of its own, P.394, and no use for the "Modbus
/// parity" P.1375.
pub(crate) fn values(place: NodeSetting) -> Vec<(u32, u8, i64)> {
    let NodeSetting { address, spoken, line } = place;
    let protocol = PROTOCOLS.iter().find(|row| row.1 == spoken).map_or(0, |row| row.0);
    let baud = BAUD_RATES.iter().find(|row| row.1 == line.baud).map_or(4, |row| row.0);
    let parity = PARITIES.iter().find(|row| row.1 == line.parity).map_or(0, |row| row.0);
    let own = match spoken {
        Spoken::Vabus => [(394, 0, address.into()), (1376, 0, 1), (1375, 0, 0)],
        Spoken::Modbus(_) | Spoken::PBus => [(394, 0, 1), (1376, 0, address.into()), (1375, 0, parity)],
    };
    [vec![(10, 0, baud), (395, 0, protocol)], own.to_vec()].concat()
}

/// How the reply to a write of this parameter goes out; `None` if none was written.
pub(crate) fn goes(drive: &Active, written: Option<u16>) -> Goes {
    match written.is_some_and(|number| LINE_PARAMS.contains(&number)) {
        true if drive.has(Reading::LineReplyLost) => Goes::Nowhere,
        true if drive.has(Reading::LineReplyNew) => Goes::Anew,
        _ => Goes::AsItStands,
    }
}
