//! What `protocol` refuses and what a slave answers with, in both languages.

use super::can::names::reason;
use crate::protocol::can::sdo::AbortCode;
use crate::protocol::modbus::pdu::{Exception, PduError};
use crate::protocol::modbus::{FrameError, MAX_PDU};
use crate::protocol::vabus::TelegramError;
use crate::text::{Text, both};

/// An exception by its number and name.
pub(in crate::drive) fn exception(exception: Exception) -> Text {
    both!("exception {code}", "Ausnahme {code}", code = numbered(exception))
}

/// An abort of SDO; where it carries a number of the drives that is told beside it (EM-RES-03 manual 5.10.1).
pub(in crate::drive) fn abort(code: u32) -> Text {
    match AbortCode(code).of_a_drive() {
        Some(_) => both!("SDO abort", "SDO-Abbruch"),
        None => match reason(code) {
            Some(why) => both!("SDO abort {code:08X}h ({why})", "SDO-Abbruch {code:08X}h ({why})", why),
            None => both!("SDO abort {code:08X}h", "SDO-Abbruch {code:08X}h"),
        },
    }
}

/// The number with the name; the English one is that of the norm (V1.1b3, 7).
pub(super) fn numbered(exception: Exception) -> Text {
    let name = match exception {
        Exception::IllegalFunction => "Funktionscode unzulässig",
        Exception::IllegalDataAddress => "Datenadresse unzulässig",
        Exception::IllegalDataValue => "Datenwert unzulässig",
        Exception::DeviceFailure => "Fehler im Slave",
        Exception::Acknowledge => "angenommen, dauert länger",
        Exception::DeviceBusy => "Slave beschäftigt",
        Exception::MemoryParity => "Paritätsfehler im Speicher",
        Exception::GatewayPath => "Gateway kennt keinen Weg dorthin",
        Exception::GatewayTarget => "keine Antwort hinter dem Gateway",
        Exception::Other(_) => "nicht genormt",
    };
    let code = exception.code();
    both!("{exception}", "{code} ({name})")
}

/// Why bytes are no frame of Modbus.
pub(super) fn frame(error: &FrameError) -> Text {
    match error {
        FrameError::TooShort { len } => both!("{error}", "{len} Bytes sind zu wenig für ein Telegramm"),
        FrameError::TooLong { len } => both!("{error}", "{len} Bytes sind zu viel für ein Telegramm"),
        FrameError::Check { expected, got } => both!("{error}", "Prüfwert {got:04X}h, erwartet {expected:04X}h"),
        FrameError::Delimiter => both!("{error}", "ein ASCII-Telegramm beginnt mit ':' und endet mit CR LF"),
        FrameError::Digit { byte } => {
            both!("{error}", "Zeichen {byte:02X}h ist keine Hexadezimalziffer eines ASCII-Telegramms")
        }
    }
}

/// Why the inside of a frame is no question and no answer.
pub(super) fn pdu(error: &PduError) -> Text {
    match error {
        PduError::Empty => both!("{error}", "kein Funktionscode"),
        PduError::Length { function, len, expected } => {
            both!("{error}", "Funktionscode {function}: {len} Datenbytes, erwartet {expected}")
        }
        PduError::ByteCount { function, got, count } => {
            both!("{error}", "Funktionscode {function}: {got} Bytes für {count} Register angekündigt")
        }
        PduError::TooLong { len } => {
            both!("{error}", "{len} Bytes hinter der Adresse, höchstens {MAX_PDU} sind erlaubt")
        }
    }
}

/// Why bytes are no telegram of VABus.
pub(super) fn telegram(error: &TelegramError) -> Text {
    match error {
        TelegramError::TooShort { len } => both!("{error}", "{len} Bytes sind zu wenig für ein Telegramm"),
        TelegramError::TooLong { extra } => both!("{error}", "{extra} Bytes zu viel hinter dem Telegramm"),
        TelegramError::Control { expected, got } => {
            let expected = expected.replace(" or ", " oder ");
            both!("{error}", "{got:02X}h, wo {expected} stehen muss")
        }
        TelegramError::Address(byte) => {
            both!("{error}", "{byte:02X}h ist keine Adresse (41h bis 5Eh, 60h für alle)")
        }
        TelegramError::Node(byte) => {
            both!("{error}", "{byte:02X}h ist kein Systembusknoten (30h oder 41h bis 7Fh)")
        }
        TelegramError::Set(byte) => both!("{error}", "{byte:02X}h ist kein Datensatz"),
        TelegramError::Number(text) => {
            both!("{error}", "{text:02X?} ist keine Parameternummer (000 bis 999, A00 bis F99)")
        }
        TelegramError::Length(text) => both!("{error}", "{text:02X?} ist keine Länge (01 bis 99)"),
        TelegramError::Text(byte) => both!("{error}", "Steuerzeichen {byte:02X}h in den Daten"),
        TelegramError::Check { expected, got } => {
            both!("{error}", "Prüfzeichen {got:02X}h, erwartet {expected:02X}h")
        }
    }
}
