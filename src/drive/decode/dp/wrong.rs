//! Why bytes are no telegram of DP, in both languages.

use crate::protocol::dp::FrameError;
use crate::text::{Text, both};

pub(super) fn frame(error: &FrameError) -> Text {
    match error {
        FrameError::Start(byte) => {
            both!("{error}", "{byte:02X}h beginnt kein PROFIBUS-Telegramm (10h, 68h, A2h, DCh, E5h)")
        }
        FrameError::TooShort { expected, got } => both!("{error}", "{got} Bytes, das Telegramm hat {expected}"),
        FrameError::TooLong { extra } => both!("{error}", "{extra} Bytes zu viel hinter dem Telegramm"),
        FrameError::Length { first, second } => both!(
            "{error}",
            "Länge {first:02X}h {second:02X}h: sie steht zweimal da, 04h bis F9h, zwischen 68h und 68h"
        ),
        FrameError::Check { expected, got } => both!("{error}", "Prüfbyte {got:02X}h, erwartet {expected:02X}h"),
        FrameError::End(byte) => both!("{error}", "{byte:02X}h, wo das Telegramm mit 16h endet"),
        FrameError::Control(byte) => both!("{error}", "Steuerbyte {byte:02X}h: Bit 7 ist immer 0"),
        FrameError::AccessPoint => {
            both!("{error}", "eine Adresse kündigt einen Dienstzugangspunkt an, der fehlt")
        }
    }
}
