//! What goes wrong with a motor, said in both languages, with what to do next.

use super::super::mode::{Mode, Seen};
use super::unproven;
use crate::failure::{Class, Failure};
use crate::profile::value::format_decimal;
use crate::text::{Text, both};

fn forbidden(code: &'static str, address: u8, message: Text) -> Failure {
    Failure::new(Class::Forbidden, code, message).with("address", address)
}

fn refused(code: &'static str, address: u8, message: Text) -> Failure {
    Failure::new(Class::Refused, code, message).with("address", address)
}

/// A setpoint that is higher than what 4000h is.
pub(in crate::drive::profibus) fn beyond(address: u8, most: i64, is_hertz: bool, called: &str) -> Failure {
    let most = format_decimal(most, 2);
    let message = match is_hertz {
        true => both!(
            "station {address}: the setpoint is above {most} Hz, the maximum frequency ({called})",
            "Station {address}: der Sollwert liegt über {most} Hz, der Maximalfrequenz ({called})"
        ),
        false => both!(
            "station {address}: the setpoint is above {most} %: 100 % is the maximum frequency ({called})",
            "Station {address}: der Sollwert liegt über {most} %: 100 % sind die Maximalfrequenz ({called})"
        ),
    };
    Failure::new(Class::Data, "data.range", message).with("address", address)
}

/// A fault stands there before a run.
pub(in crate::drive::profibus) fn faulted(address: u8) -> Failure {
    let message = both!(
        "station {address} is in fault: it does not start",
        "Station {address} ist in Störung: sie startet nicht"
    );
    forbidden("forbidden.fault", address, message).hint(reset(address))
}

/// A trip during a run.
pub(in crate::drive::profibus) fn tripped(address: u8) -> Failure {
    let message = both!("station {address} has tripped", "Station {address} hat eine Störung gemeldet");
    forbidden("forbidden.tripped", address, message).hint(reset(address))
}

/// There is nothing to acknowledge.
pub(in crate::drive::profibus) fn no_fault(address: u8) -> Failure {
    let message = both!(
        "station {address} is not in fault: there is nothing to reset",
        "Station {address} ist nicht in Störung: nichts zu quittieren"
    );
    forbidden("forbidden.no_fault", address, message)
}

/// A fault stays.
pub(in crate::drive::profibus) fn still_faulted(address: u8) -> Failure {
    let message = both!(
        "station {address} was told to acknowledge, but the fault stands",
        "Station {address} sollte quittieren, aber die Störung steht noch an"
    );
    refused("refused.fault_stands", address, message).hint(both!(
        "its cause is still there; the display tells which",
        "die Ursache besteht noch; die Anzeige nennt sie"
    ))
}

fn reset(address: u8) -> Text {
    both!(
        "its display tells which; `antrieb -a {address} --protocol dp statemachine reset` acknowledges it",
        "die Anzeige nennt sie; `antrieb -a {address} --protocol dp statemachine reset` quittiert sie"
    )
}

/// The word that prepares is not obeyed.
pub(in crate::drive::profibus) fn not_ready(address: u8, seen: Seen, is_still: bool) -> Failure {
    if !is_still {
        return unproven(address, Some(seen), None);
    }
    let (named, word) = (seen.named(), if seen.state.is_some() { "0050h" } else { "0406h" });
    let message = both!(
        "station {address} does not become ready: {named} behind {word}",
        "Station {address} wird nicht bereit: {named} hinter {word}",
        named
    );
    forbidden("forbidden.not_ready", address, message).hint(rights(seen))
}

/// What gives a master the control.
fn rights(seen: Seen) -> Text {
    if seen.state.is_some() {
        return both!(
            "Net Ctrl and Net Ref (bits 4 and 6) should come back: is the inverter's switch at OPE, and LED5 of the module green?",
            "Net Ctrl und Net Ref (Bits 4 und 6) sollten zurückkommen: steht der Schalter am Umrichter auf OPE, ist LED5 des Moduls \
             grün?"
        );
    }
    both!(
        "control from the bus needs P.928 = 1 (--take-control sets it for the run) and A001, A002 of the inverter for it",
        "Steuern über den Bus braucht P.928 = 1 (--take-control setzt es für den Lauf) und A001, A002 des Umrichters dafür"
    )
}

/// The start word is not obeyed.
pub(in crate::drive::profibus) fn not_started(address: u8, seen: Seen) -> Failure {
    let named = seen.named();
    let message = both!(
        "station {address} does not start: {named} behind the start word",
        "Station {address} startet nicht: {named} hinter dem Startwort",
        named
    );
    forbidden("forbidden.not_started", address, message).hint(rights(seen))
}

/// Somebody else gives the setpoint or starts and stops.
pub(in crate::drive::profibus) fn others(address: u8, who: u32, seen: Seen) -> Failure {
    let message = both!(
        "station {address}: setpoint or control do not come from the bus (P.600 = {who})",
        "Station {address}: Sollwert oder Steuerung kommen nicht vom Bus (P.600 = {who})"
    );
    forbidden("forbidden.control", address, message).hint(rights(seen))
}

/// The control went to somebody else while the motor ran.
pub(in crate::drive::profibus) fn lost_control(address: u8, seen: Seen) -> Failure {
    let (named, bits) = (seen.named(), if seen.state.is_some() { "4, 6" } else { "9" });
    let message = both!(
        "station {address} no longer obeys the bus: {named}, bit {bits} is gone",
        "Station {address} gehorcht dem Bus nicht mehr: {named}, Bit {bits} fehlt",
        named
    );
    forbidden("forbidden.control", address, message).hint(rights(seen))
}

/// The start word is obeyed, and nothing turns.
pub(in crate::drive::profibus) fn turns_not(address: u8) -> Failure {
    let message = both!(
        "station {address} is enabled, but puts out no frequency",
        "Station {address} ist freigegeben, gibt aber keine Frequenz aus"
    );
    forbidden("forbidden.turns_not", address, message).hint(both!(
        "is the setpoint below the start frequency (b082), or is a stop given at its terminals?",
        "Liegt der Sollwert unter der Startfrequenz (b082), oder steht an den Klemmen ein Halt an?"
    ))
}

/// The frequency stays somewhere else than at the setpoint.
pub(in crate::drive::profibus) fn not_reached(address: u8) -> Failure {
    let message = both!(
        "station {address}: the setpoint is not reached, and the frequency no longer changes",
        "Station {address}: der Sollwert wird nicht erreicht, und die Frequenz ändert sich nicht mehr"
    );
    Failure::new(Class::No, "no.not_reached", message).with("address", address).hint(both!(
        "is it above A004 or A061, or held back by a current limit (b021)?",
        "liegt er über A004 oder A061, oder hält eine Stromgrenze (b021) ihn zurück?"
    ))
}

/// What is said where the ramp is not obeyed.
pub(in crate::drive::profibus) fn coasts_instead() -> Text {
    both!("ramp is not obeyed: coast (OFF3) in its place", "ramp wird nicht befolgt: stattdessen coast (OFF3)")
}

/// Somebody ended a run.
pub(in crate::drive::profibus) fn ended() -> Failure {
    Failure::new(Class::Interrupted, "interrupted", both!("interrupted", "unterbrochen"))
}

/// The slave went away and came back.
pub(in crate::drive::profibus) fn left(address: u8) -> Failure {
    let message = both!(
        "station {address} left the exchange of data by itself (its watchdog, its supply?): it is not started anew",
        "Station {address} hat den Datenaustausch von sich aus verlassen (Überwachung, Versorgung?): sie wird nicht neu \
         gestartet"
    );
    refused("refused.left", address, message)
}

/// What a setpoint means is not what the inverter says that it means.
pub(in crate::drive::profibus) fn scale(
    address: u8,
    (hsw, told): (u16, i64),
    (maxima, called): (&[i64], &str),
) -> Failure {
    let (told, hertz) = (format_decimal(told, 2), |maximum: &i64| format_decimal(*maximum, 2));
    let maxima = maxima.iter().map(hertz).collect::<Vec<_>>().join(", ");
    let maxima = if maxima.is_empty() { "?".to_owned() } else { maxima };
    let message = both!(
        "station {address}: {hsw:04X}h is {told} Hz (P.611), which fits no maximum frequency that {called} may mean ({maxima} Hz)",
        "Station {address}: {hsw:04X}h sind {told} Hz (P.611); das passt zu keiner Maximalfrequenz, die {called} bedeuten kann ({maxima} \
         Hz)"
    );
    forbidden("forbidden.scale", address, message).hint(both!(
        "give the setpoint in percent of the maximum frequency, such as 30%",
        "den Sollwert in Prozent der Maximalfrequenz geben, etwa 30%"
    ))
}

/// The line is dead while the motor was to be stopped.
pub(in crate::drive::profibus) fn unreached(failure: Failure, mode: Mode, lost: Option<u32>) -> Failure {
    let told = if mode.is_basic() { behind_basic() } else { behind(lost) };
    Failure { alarm: true, ..failure }.hint(both!(
        "{told}; what stops it now: its terminals, the emergency stop, the mains",
        "{told}; was ihn jetzt anhält: seine Klemmen, der Not-Halt, das Netz",
        told
    ))
}

/// The slave was taken and let go before it exchanged data.
pub(in crate::drive::profibus) fn never_reached(address: u8) -> Text {
    both!(
        "station {address} was taken and let go again before it exchanged data: no word of ours came to its motor, and what that does is not \
         known",
        "Station {address} wurde übernommen und wieder freigegeben, bevor sie Daten austauschte: zu ihrem Motor kam kein Wort von hier, und was \
         er tut, ist nicht bekannt"
    )
}

/// Another master began to speak while a slave was ours.
pub(in crate::drive::profibus) fn other_master_beside(master: u8) -> Failure {
    let message = both!(
        "another master became active on this line, at address {master}; behind that only what ends the exchange was sent",
        "auf dieser Leitung wurde ein anderer Master aktiv, unter Adresse {master}; danach wurde nur noch gesendet, was den Austausch beendet"
    );
    Failure { message, ..super::other_master(master) }
}

/// Control is not given back.
pub(in crate::drive::profibus) fn right_stays() -> Text {
    both!(
        "P.928 stays 1: the motor turned before control was taken, and would be started again",
        "P.928 bleibt 1: der Motor drehte, bevor das Steuern übernommen wurde, und würde wieder gestartet"
    )
}

/// What a lost master does is not given back.
pub(in crate::drive::profibus) fn loss_stays(new: u16) -> Text {
    both!(
        "P.703 stays {new}: with 4 the terminals, which would start the motor, may have it as soon as it is let go",
        "P.703 bleibt {new}: mit 4 bekämen ihn, sobald er freigegeben ist, vielleicht die Klemmen, die ihn starten würden"
    )
}

/// The terminals may have the motor as soon as it is let go.
pub(in crate::drive::profibus) fn to_terminals() -> Text {
    both!(
        "P.703 = 4: once it is let go, a closed start contact may start the motor at once",
        "P.703 = 4: sobald er freigegeben ist, startet ein geschlossener Startkontakt den Motor vielleicht sofort"
    )
}

/// Control was given back, and taken again.
pub(in crate::drive::profibus) fn right_again() -> Text {
    both!(
        "P.928 stays 1: as it was given back, the motor was started at once by somebody else (its terminals?), and stopped again",
        "P.928 bleibt 1: als es zurückgegeben war, startete jemand anderes den Motor sofort (seine Klemmen?), und er wurde wieder \
         angehalten"
    )
}

/// Somebody else starts the motor as soon as he may. Whether letting the slave go is a loss of the bus is open.
pub(in crate::drive::profibus) fn not_given_back(address: u8, lost: Option<u32>) -> Failure {
    let message = both!(
        "station {address}: P.928 was not given back, because somebody else (its terminals?) would start the motor then",
        "Station {address}: P.928 wurde nicht zurückgegeben, weil dann jemand anderes (seine Klemmen?) den Motor startete"
    );
    let hint = match lost {
        Some(4) => both!(
            "P.703 = 4: as soon as nobody exchanges data with it, the terminals may start the motor; open the start contact",
            "P.703 = 4: sobald niemand mehr Daten mit ihr austauscht, können die Klemmen den Motor starten; den Startkontakt öffnen"
        ),
        _ => both!(
            "whether it stays at rest without a master no source tells: open the start contact, then `antrieb --protocol dp write 928=0`",
            "ob sie ohne Master stehen bleibt, sagt keine Quelle: den Startkontakt öffnen, dann `antrieb --protocol dp write 928=0`"
        ),
    };
    let failure = Failure::new(Class::Partial, "partial.not_given_back", message).with("address", address).hint(hint);
    Failure { alarm: true, ..failure }
}

/// What a motor does whose slave lost us, by P.703 (5.2).
fn behind(lost: Option<u32>) -> Text {
    match lost {
        Some(0) => both!(
            "P.703 = 0: without a master it keeps the last words, and may run on",
            "P.703 = 0: ohne Master behält er die letzten Wörter und läuft vielleicht weiter"
        ),
        Some(1) => both!(
            "P.703 = 1: once its watchdog acts, it coasts",
            "P.703 = 1: sobald seine Überwachung anspricht, läuft er aus"
        ),
        Some(2) => both!(
            "P.703 = 2: once its watchdog acts, it stops by its ramp",
            "P.703 = 2: sobald seine Überwachung anspricht, hält er an der Rampe an"
        ),
        Some(3) => both!(
            "P.703 = 3: once its watchdog acts, it stops by the DC brake",
            "P.703 = 3: sobald seine Überwachung anspricht, hält er mit der Gleichstrombremse an"
        ),
        Some(4) => both!(
            "P.703 = 4: once its watchdog acts, its terminals or its keypad have it (A001, A002)",
            "P.703 = 4: sobald seine Überwachung anspricht, haben ihn Klemmen oder Bedienfeld (A001, A002)"
        ),
        _ => both!("what it does without a master was not told", "was er ohne Master tut, wurde nicht genannt"),
    }
}

/// What a motor does whose slave lost us in Basic mode (3.2.2, 5.3).
fn behind_basic() -> Text {
    both!(
        "once its watchdog acts, it stops (Conn Sta = 0), unless P.620 = 1 keeps it running",
        "sobald seine Überwachung anspricht, hält er an (Conn Sta = 0), wenn ihn nicht P.620 = 1 weiterlaufen lässt"
    )
}

/// What decides on a motor that Basic mode has let go.
pub(in crate::drive::profibus) fn terminals_have_it() -> Text {
    both!(
        "without us start and setpoint come from A002 and A001, which Basic mode does not tell: where the terminals may start the \
         inverter, a closed start contact starts it as the outputs become zero; P.620 = 1 keeps a motor running that loses us",
        "ohne uns bestimmen A002 und A001 Start und Sollwert; der Basic-Modus nennt sie nicht: wo die Klemmen starten dürfen, startet \
         ein geschlossener Startkontakt den Umrichter, sobald die Ausgänge null werden; P.620 = 1 lässt einen Motor weiterlaufen, \
         der uns verliert"
    )
}

/// Outputs of zero would give a motor to those who turned it before.
pub(in crate::drive::profibus) fn kept_from_terminals(address: u8) -> Failure {
    let message = both!(
        "station {address} was stopped, but it turned before it was taken: zero outputs may give it back to a closed contact, so \
         none went out, and it was let go under the stop word",
        "Station {address} wurde angehalten, drehte aber, bevor sie übernommen wurde: Ausgänge auf null gäben sie vielleicht einem \
         geschlossenen Kontakt zurück, also gingen keine hinaus; sie wurde unter dem Stoppwort freigegeben"
    );
    forbidden("forbidden.terminals", address, message).hint(open_the_contact())
}

/// Outputs of zero started the motor, and it was stopped again.
pub(in crate::drive::profibus) fn started_by_terminals(address: u8) -> Failure {
    let message = both!(
        "station {address} was started by somebody else as its outputs became zero (a closed contact?); it was stopped again, and let \
         go under the stop word",
        "Station {address} wurde von jemand anderem gestartet, als ihre Ausgänge null wurden (ein geschlossener Kontakt?); sie wurde \
         wieder angehalten und unter dem Stoppwort freigegeben"
    );
    forbidden("forbidden.terminals", address, message).hint(open_the_contact())
}

fn open_the_contact() -> Text {
    both!(
        "whether it stays at rest without a master no source tells: open its start contact (FW, RV)",
        "ob sie ohne Master stehen bleibt, sagt keine Quelle: den Startkontakt öffnen (FW, RV)"
    )
}

/// In Basic mode nothing tells what 100 % are.
pub(in crate::drive::profibus) fn no_maximum(address: u8) -> Failure {
    let message = both!(
        "station {address}: in Basic mode a setpoint is in Hz; the maximum frequency (A004), which is 100 %, is not told there",
        "Station {address}: im Basic-Modus ist ein Sollwert in Hz; die Maximalfrequenz (A004), also 100 %, wird dort nicht genannt"
    );
    Failure::new(Class::Usage, "usage.setpoint", message).with("address", address)
}

/// What is known of a shaft whose output went dark before it stood.
pub fn off() -> Text {
    both!(
        "the output is off, and whether the shaft stands nothing tells",
        "der Ausgang ist aus; ob die Welle steht, sagt nichts"
    )
}

/// The output is off, and nothing shows that the shaft stands.
pub fn coasting(address: u8) -> Failure {
    let message = both!(
        "station {address}: its output is off, but nothing shows that the shaft stands (it was not seen on its way down)",
        "Station {address}: der Ausgang ist aus, aber nichts zeigt, dass die Welle steht (sie wurde nicht beim Auslaufen gesehen)"
    );
    Failure { alarm: true, ..forbidden("forbidden.standstill_unproven", address, message) }
}
