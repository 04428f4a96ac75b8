//! A telegram of the master as the judge sees it: where it begins and ends, what it says, and in which protocol.

use crate::protocol::line::LineSetting;
use crate::protocol::modbus::{Adu, FrameError, ascii, rtu};
use crate::protocol::vabus::{Address, EOT, Request, TelegramError};
use crate::simulator::line::speech::{Spoken, VABUS_PAUSE};
use crate::tick::{Span, Tick};

/// Bytes kept of a telegram that does not end: more than the longest ASCII frame has.
const MOST_BYTES: usize = 1_024;

/// A telegram of the master, whole or not.
#[derive(Clone, Debug)]
pub(crate) struct MasterTelegram {
    /// Start of the first start bit.
    pub(crate) start: Tick,
    /// End of the last stop bit.
    pub(crate) end: Tick,
    pub(crate) line: LineSetting,
    bytes: Vec<u8>,
    /// A pause was inside, so that drives discard it.
    pub(crate) torn: bool,
}

/// What a telegram of a master says.
pub(crate) enum Spelt {
    Modbus(Result<Adu, FrameError>),
    /// `None` for an EOT alone, which ends an exchange.
    Vabus(Result<Option<Request>, TelegramError>),
}

impl MasterTelegram {
    /// A telegram that begins with `bytes`.
    pub(crate) fn begin(start: Tick, line: LineSetting, bytes: &[u8]) -> Self {
        let end = start + line.chars(bytes.len() as u64);
        MasterTelegram { start, end, line, bytes: bytes.iter().copied().take(MOST_BYTES).collect(), torn: false }
    }

    /// More of it, up to `end`.
    pub(crate) fn extend(&mut self, end: Tick, bytes: &[u8]) {
        let room = MOST_BYTES.saturating_sub(self.bytes.len());
        self.bytes.extend(bytes.iter().take(room));
        self.end = self.end.max(end);
    }

    /// The protocol that the master means, as far as the bytes tell until now.
    pub(crate) fn spoken(&self) -> Spoken {
        if looks_ascii(&self.bytes) {
            Spoken::ASCII
        } else if looks_vabus(self.line, &self.bytes) {
            Spoken::Vabus
        } else {
            Spoken::RTU
        }
    }

    pub(crate) fn limits(&self) -> (Span, Span) {
        match self.spoken() {
            Spoken::ASCII => (ascii::MAX_PAUSE, ascii::MAX_PAUSE),
            Spoken::Vabus => (VABUS_PAUSE, VABUS_PAUSE),
            Spoken::Modbus(_) | Spoken::PBus => (self.line.t15(), self.line.t35()),
        }
    }

    pub(crate) fn spelt(&self) -> Spelt {
        match self.spoken() {
            Spoken::Modbus(framing) => Spelt::Modbus(framing.decode(&self.bytes)),
            Spoken::Vabus | Spoken::PBus if self.is_end() => Spelt::Vabus(Ok(None)),
            Spoken::Vabus | Spoken::PBus => Spelt::Vabus(Request::decode(self.vabus_bytes()).map(Some)),
        }
    }

    /// Whether it is an EOT alone, until now.
    pub(crate) fn is_end(&self) -> bool {
        self.bytes.iter().all(|&byte| byte == EOT)
    }

    /// A request without what ended the exchange before it.
    fn vabus_bytes(&self) -> &[u8] {
        let ends = self.bytes.iter().take_while(|&&byte| byte == EOT).count();
        self.bytes.get(ends.saturating_sub(1)..).unwrap_or_default()
    }

    /// Whether nothing can be missing at its end. Behind an EOT a telegram may follow.
    pub(crate) fn complete(&self) -> bool {
        matches!(self.spelt(), Spelt::Modbus(Ok(_)) | Spelt::Vabus(Ok(Some(_))))
    }
}

/// Whether the master speaks ASCII: from `:` on only characters that occur in such telegrams. An RTU telegram to
/// station 58 also starts with `:`, but holds other bytes.
fn looks_ascii(bytes: &[u8]) -> bool {
    let fits = |byte: &u8| byte.is_ascii_hexdigit() || matches!(byte, b':' | b'\r' | b'\n');
    bytes.first() == Some(&ascii::START) && bytes.iter().all(fits)
}

/// Whether the master speaks VABus: EOT first, and nothing behind it that no such telegram holds. An RTU telegram to
/// station 4 begins with the same byte, but no drive of this maker knows function codes that are addresses of VABus.
fn looks_vabus(line: LineSetting, bytes: &[u8]) -> bool {
    let rest = match bytes {
        [EOT, rest @ ..] => rest,
        _ => return false,
    };
    let address = rest.iter().find(|&&byte| byte != EOT);
    line.data_bits == 7 || address.is_none_or(|&byte| Address::from_character(byte).is_ok())
}

/// Why a telegram cannot be one of RTU, beside its bytes.
pub(crate) fn wrong_format(telegram: &MasterTelegram) -> Option<String> {
    match telegram.spoken() {
        Spoken::RTU if telegram.line.data_bits != 8 => {
            Some(format!("an RTU telegram needs 8 data bits, not {}", telegram.line))
        }
        Spoken::RTU if telegram.bytes.len() > rtu::MAX_FRAME => Some("an RTU telegram of over 256 bytes".to_owned()),
        _ => None,
    }
}
