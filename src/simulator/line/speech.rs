//! What is spoken on a line.

use crate::protocol::modbus::Framing;
use crate::tick::Span;

/// Longest pause inside a telegram of VABus: well below the 500 ms after which a master repeats (CM-485 manual 6.8).
pub(crate) const VABUS_PAUSE: Span = Span::from_millis(250);

/// What a station speaks on its line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Spoken {
    Modbus(Framing),
    Vabus,
    /// P-Bus, for special applications (CM-485 manual 6); nobody on this bench understands it.
    PBus,
}

impl Spoken {
    pub(crate) const RTU: Spoken = Spoken::Modbus(Framing::Rtu);
    pub(crate) const ASCII: Spoken = Spoken::Modbus(Framing::Ascii);

    /// The word for it in a bench file.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Spoken::Vabus => "vabus",
            Spoken::PBus => "p-bus",
            Spoken::RTU => "rtu",
            Spoken::ASCII => "ascii",
            Spoken::Modbus(Framing::Tcp) => "tcp",
        }
    }

    /// How its telegrams are framed, if it is Modbus.
    pub(crate) fn framing(self) -> Option<Framing> {
        match self {
            Spoken::Modbus(framing) => Some(framing),
            Spoken::Vabus | Spoken::PBus => None,
        }
    }
}
