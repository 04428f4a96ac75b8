//! What goes wrong on a PROFIBUS line, said in both languages, with what to do next.

use super::mode::{Mode, Seen};
use super::refusal::{locked, no};
use crate::exchange::dp::{Place, Told, Trouble, Unanswered};
use crate::failure::{Class, Failure};
use crate::profile::Family;
use crate::profile::value::format_decimal;
use crate::protocol::line::LineSetting;
use crate::protocol::modbus::Hex;
use crate::text::both;

pub(super) mod motion;

pub(super) use crate::drive::trouble::{interrupted, link};
pub(super) use motion::*;

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

/// The code of a slave whose parameters are locked.
pub const LOCKED: &str = "refused.locked";

/// Parameters are locked (5.1).
pub(super) fn is_locked(address: u8) -> Failure {
    let message = both!(
        "station {address} tells no parameter but P.927, which is 0",
        "Station {address} nennt keinen Parameter außer P.927, und der ist 0"
    );
    Failure::new(Class::Refused, LOCKED, message).with("address", address).hint(locked())
}

/// The code of an inverter of another series than the one that was named.
pub const OTHER_SERIES: &str = "data.other_family";

/// P.624 tells another series than the one that was named (5.3).
pub(super) fn other_series(address: u8, named: &Family, found: &'static str) -> Failure {
    let of = &named.drive;
    let message = both!(
        "station {address} is of the family '{found}' (P.624), not of the family '{of}' that was named; nothing was changed",
        "Station {address} ist von der Familie '{found}' (P.624), nicht von der genannten Familie '{of}'; geändert wurde nichts"
    );
    Failure::new(Class::Data, OTHER_SERIES, message).with("address", address).of_family(found).hint(both!(
        "if this inverter is meant: --drive {found}, or leave --drive out",
        "ist dieser Umrichter gemeint: --drive {found}, oder --drive weglassen"
    ))
}

/// What came of a request over PKW.
pub(super) fn told(address: u8, place: Place, told: Told) -> Result<u32, Failure> {
    let label = label(place);
    let (class, code, message) = match told {
        Told::Value(bits) => return Ok(bits),
        Told::Refused(pwe) => {
            let why = no(Some(pwe));
            let message =
                both!("station {address} refuses {label}: {why}", "Station {address} lehnt {label} ab: {why}", why);
            let failure = Failure::new(Class::Refused, "refused.pkw", message).with("address", address);
            return Err(failure.with("pwe", format!("{pwe:08X}")));
        }
        Told::NoRight => (
            Class::Refused,
            "refused.no_right",
            both!(
                "station {address} gives no right to {label} over PKW",
                "Station {address} gibt über PKW kein Recht auf {label}"
            ),
        ),
        Told::Silence => (
            Class::Silence,
            MUTE,
            both!(
                "station {address} exchanges data, but does not answer for {label}",
                "Station {address} tauscht Daten aus, antwortet aber nicht zu {label}"
            ),
        ),
    };
    let failure = Failure::new(class, code, message).with("address", address);
    Err(match told {
        Told::NoRight => failure.hint(locked()),
        _ => failure,
    })
}

/// A parameter as messages call it: `P.703`, `P.915.1`.
pub(super) fn label(place: Place) -> String {
    let element = place.element.map_or_else(String::new, |element| format!(".{element}"));
    format!("P.{}{element}", place.pnu)
}

/// What was written does not stand there.
pub(super) fn differs(address: u8, place: Place, bits: u32) -> Failure {
    let label = label(place);
    let message = both!(
        "station {address} took the new value of {label}, but {bits:X}h stands there",
        "Station {address} hat den neuen Wert von {label} angenommen, dort steht aber {bits:X}h"
    );
    Failure::new(Class::Refused, "refused.reads_back_differently", message).with("address", address)
}

/// A slave exchanges data and does not answer for a parameter.
pub(super) const MUTE: &str = "silence.pkw";
/// The motor was not seen standing.
pub const NOT_STILL: &str = "forbidden.not_still";

/// The motor was not seen standing.
pub(super) fn unproven(address: u8, seen: Option<Seen>, told: Option<u32>) -> Failure {
    let told = match seen {
        _ if told.is_some_and(|told| told != 0) => {
            format!("{} Hz (P.614)", format_decimal(told.unwrap_or_default().into(), 2))
        }
        Some(Seen { hiw, state: Some(_), .. }) => format!("{} Hz", format_decimal(hiw.into(), 2)),
        seen => format!("{:04X}h (HIW)", seen.map_or(0, |seen| seen.hiw & 0xFFFF)),
    };
    let message = both!(
        "station {address}: the stop word goes out, but the frequency stays at {told}",
        "Station {address}: das Stoppwort geht hinaus, aber die Frequenz bleibt bei {told}"
    );
    let hint = match seen.and_then(|seen| seen.state) {
        None => both!(
            "what stops it now: its terminals or its keypad where they run it (P.928 is not 1 then), the emergency stop, or the mains",
            "was ihn jetzt anhält: Klemmen oder Bedienfeld, wenn er darüber fährt (P.928 ist dann nicht 1), Not-Halt oder Netz"
        ),
        Some(_) => both!(
            "what stops it now: its terminals or its keypad where they run it, the emergency stop, or the mains",
            "was ihn jetzt anhält: Klemmen oder Bedienfeld, wenn er darüber fährt, Not-Halt oder Netz"
        ),
    };
    let failure = Failure::new(Class::Forbidden, NOT_STILL, message).with("address", address).hint(hint);
    Failure { alarm: true, ..failure }
}

/// In Basic mode there are no parameters.
pub(super) fn no_pkw(address: u8) -> Failure {
    let message = both!(
        "station {address} tells no parameter as it was taken: the Basic block, PPO3 and PPO4 have no PKW",
        "Station {address} nennt keine Parameter, wie sie übernommen wurde: Basic-Block, PPO3 und PPO4 haben kein PKW"
    );
    Failure::new(Class::Refused, "refused.no_pkw", message).with("address", address)
}

/// A word of a master would be a value of a parameter.
pub(super) fn mapped(address: u8, element: u8, index: u32) -> Failure {
    let word = element + 2;
    let message = both!(
        "P.915.{element} of station {address} is {index}: the word PZD{word} would write P.{index} in every cycle, and only a configuration \
         without it is taken",
        "P.915.{element} von Station {address} ist {index}: das Wort PZD{word} schriebe P.{index} in jedem Zyklus; genommen wird nur eine \
         Konfiguration ohne dieses Wort"
    );
    Failure::new(Class::Forbidden, "forbidden.mapped", message).with("address", address).hint(both!(
        "`antrieb --protocol dp write 915.{element}=0` takes it away; without --cfg it is PPO1",
        "`antrieb --protocol dp write 915.{element}=0` nimmt sie weg; ohne --cfg ist es PPO1"
    ))
}

/// The slave does not exchange data.
pub(super) fn not_exchanging(address: u8, why: &Trouble, mode: Mode) -> Failure {
    let configured = mode.name();
    let (code, told) = match why {
        Trouble::Locked(master) => ("forbidden.locked", both!("master {master} has it", "Master {master} hat sie")),
        Trouble::Other { expected, found } => (
            "data.ident",
            both!(
                "it tells ident number {found:04X}h, its GSD {expected:04X}h; nothing was sent to it but questions",
                "sie nennt Ident-Nummer {found:04X}h, ihre GSD {expected:04X}h; gesendet wurden nur Fragen"
            ),
        ),
        Trouble::Parameters => {
            ("refused.prm_fault", both!("it refuses Set_Prm (Prm_Fault)", "sie lehnt Set_Prm ab (Prm_Fault)"))
        }
        Trouble::Configuration => (
            "refused.cfg_fault",
            both!("it refuses {configured} in Chk_Cfg (Cfg_Fault)", "sie lehnt {configured} in Chk_Cfg ab (Cfg_Fault)"),
        ),
        Trouble::NotReady => (
            "refused.not_ready",
            both!("it stays not ready (Station_Not_Ready)", "sie bleibt nicht bereit (Station_Not_Ready)"),
        ),
        Trouble::Unanswered(_) | Trouble::Strange(_) => {
            ("garbled.service", both!("its answer has no sense", "ihre Antwort ist sinnlos"))
        }
    };
    let class = match why {
        Trouble::Locked(_) => Class::Forbidden,
        Trouble::Other { .. } => Class::Data,
        Trouble::Unanswered(_) | Trouble::Strange(_) => Class::Garbled,
        _ => Class::Refused,
    };
    let message = both!(
        "station {address} does not exchange data: {told}",
        "Station {address} tauscht keine Daten aus: {told}",
        told
    );
    let hint = match mode {
        _ if matches!(why, Trouble::Other { .. }) => both!(
            "is it the GSD of this slave? `antrieb -a {address} profibus live` tells its diagnosis",
            "Ist es die GSD dieses Slaves? `antrieb -a {address} profibus live` nennt seine Diagnose"
        ),
        _ if matches!(why, Trouble::Locked(_)) => both!(
            "let the other master release it, or take that one off the line; `antrieb -a {address} profibus live` tells its diagnosis",
            "den anderen Master sie freigeben lassen oder ihn von der Leitung nehmen; `antrieb -a {address} profibus live` nennt ihre \
             Diagnose"
        ),
        Mode::Profidrive(_) => both!(
            "PKW is there in ProfiDrive mode alone; what its GSD wants in Set_Prm, --gsd or --user-prm say; a module in Basic mode is run \
             with --mode basic and --drive; `antrieb -a {address} profibus live` tells its diagnosis",
            "PKW gibt es nur im ProfiDrive-Modus; was seine GSD in Set_Prm verlangt, sagen --gsd oder --user-prm; ein Modul im Basic-Modus \
             fährt mit --mode basic und --drive; `antrieb -a {address} profibus live` nennt seine Diagnose"
        ),
        Mode::Basic(_) => both!(
            "the block names the series: is --drive the inverter that is there? What its GSD wants in Set_Prm, --gsd or --user-prm \
             say, whole; a module in ProfiDrive mode is run with --mode profidrive; `antrieb -a {address} profibus live` tells its \
             diagnosis",
            "der Block nennt die Serie: ist --drive der Umrichter, der da ist? Was seine GSD in Set_Prm verlangt, sagen --gsd oder \
             ganz --user-prm; ein Modul im ProfiDrive-Modus fährt mit --mode profidrive; `antrieb -a {address} profibus live` nennt seine \
             Diagnose"
        ),
    };
    Failure::new(class, code, message).with("address", address).hint(hint)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn p614_is_named_where_it_alone_shows_a_frequency() {
        let seen = |hiw, state| Some(Seen { zsw: 0, hiw, state });
        for (seen, told, named) in [
            (seen(0, None), Some(500), "stays at 5.00 Hz (P.614)"),
            (seen(0x2000, None), Some(0), "stays at 2000h (HIW)"),
            (seen(0x2000, None), None, "stays at 2000h (HIW)"),
            (seen(2_000, Some(1)), None, "stays at 20.00 Hz"),
        ] {
            let message = unproven(3, seen, told).message;
            assert!(message.en.contains(named), "{message:?}");
        }
    }
}
