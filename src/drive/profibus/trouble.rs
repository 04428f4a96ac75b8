//! What goes wrong on a PROFIBUS line, said in both languages, with what to do next.

use crate::exchange::dp::Unanswered;
use crate::failure::{Class, Failure};
use crate::protocol::line::LineSetting;
use crate::protocol::modbus::Hex;
use crate::text::both;

pub(super) use crate::drive::trouble::{interrupted, link};

/// Another master was heard.
pub(super) fn other_master(master: u8) -> Failure {
    let message = both!(
        "another master is active on this line, at address {master}; nothing more was sent",
        "auf dieser Leitung ist ein anderer Master aktiv, unter Adresse {master}; es wurde nichts weiter gesendet"
    );
    Failure::new(Class::Forbidden, "forbidden.other_master", message).hint(both!(
        "disconnect the module from the controller's line, or the controller; telegrams of a recording: `antrieb decode \
         trace FILE`",
        "das Modul von der Leitung der Steuerung trennen oder die Steuerung abklemmen; Telegramme einer Aufzeichnung: \
         `antrieb decode trace DATEI`"
    ))
}

/// Somebody speaks whom nobody understands.
pub(super) fn somebody(line: LineSetting) -> Failure {
    let message = both!(
        "somebody speaks on this line, and it is no PROFIBUS at {line}; nothing was sent",
        "jemand spricht auf dieser Leitung, und es ist kein PROFIBUS mit {line}; es wurde nichts gesendet"
    );
    Failure::new(Class::Forbidden, "forbidden.talker", message).hint(both!(
        "is it another speed (--baud), or another line?",
        "Ist es eine andere Baudrate (--baud) oder eine andere Leitung?"
    ))
}

/// A station did not answer.
pub(super) fn unanswered(address: u8, why: &Unanswered) -> Failure {
    let failure = match why {
        Unanswered::OtherMaster(master) => other_master(*master),
        Unanswered::Silence { slot, asked } => Failure::new(
            Class::Silence,
            "silence.no_reply",
            both!(
                "station {address} does not answer: asked {asked} times, {slot} each",
                "Station {address} antwortet nicht: {asked}-mal gefragt, je {slot}"
            ),
        )
        .hint(both!(
            "check the two rotary switches, A and B, termination, and the supply of the module; an adapter may need a longer \
             --slot-time",
            "die beiden Drehschalter, A und B, Abschluss und Versorgung des Moduls prüfen; ein Adapter braucht vielleicht \
             mehr --slot-time"
        )),
        Unanswered::Garbled { asked, bytes } => {
            let bytes = Hex(bytes.get(..bytes.len().min(SHOWN)).unwrap_or_default());
            Failure::new(
                Class::Garbled,
                "garbled.no_reply",
                both!(
                    "station {address}: no valid answer, asked {asked} times; at first came {bytes}",
                    "Station {address}: keine gültige Antwort, {asked}-mal gefragt; zuerst kam {bytes}"
                ),
            )
            .hint(both!(
                "check termination and bias (pin 6 gives them 5 V), and whether two stations have this address",
                "Abschluss und Ruhepegel prüfen (Pin 6 gibt ihnen 5 V), und ob zwei Stationen diese Adresse haben"
            ))
        }
    };
    failure.with("address", address)
}

/// Bytes of garbage that are shown.
const SHOWN: usize = 16;
