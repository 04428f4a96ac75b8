//! What to do next, by the code of a failure.

use crate::failure::{Class, Failure};
use crate::text::Text;

/// A failure with what is to be done about it.
pub(super) fn advised(class: Class, code: &str, message: Text) -> Failure {
    let failure = Failure::new(class, code, message);
    match advice(code) {
        Some(hint) => failure.hint(hint),
        None => failure,
    }
}

/// What is to be done about a failure with this code on a serial line.
pub fn advice(code: &str) -> Option<Text> {
    ADVICE.into_iter().find(|row| row.0 == code).map(|(_, hint)| hint)
}

const WHO_ANSWERS: Text = Text::new(
    "-v shows the telegrams; is it a drive of this family, or is another master on the bus?",
    "-v zeigt die Telegramme; ist es ein Antrieb dieser Familie, oder ist ein zweiter Master am Bus?",
);

const ADVICE: [(&str, Text); 27] = [
    (
        "garbled.in_pieces",
        Text::new(
            "is it a drive (-a)? A node of another maker may answer there; `antrieb sniff` shows what it says",
            "Ist es ein Umrichter (-a)? Dort antwortet vielleicht ein Knoten eines anderen Herstellers; `antrieb sniff` zeigt, was er sagt",
        ),
    ),
    (
        "silence.no_reply",
        Text::new(
            "check address, baud rate, parity and protocol (P.395; a drive leaves the factory speaking VABus, not Modbus), \
             whether A and B are swapped, termination, and whether another master is on the bus; `antrieb scan` asks every \
             address",
            "Adresse, Baudrate, Parität und Protokoll prüfen (P.395; ab Werk spricht der Antrieb VABus, nicht Modbus), \
             ferner vertauschte Adern A und B, Abschluss und ob ein zweiter Master am Bus ist; `antrieb scan` fragt alle \
             Adressen",
        ),
    ),
    (
        "silence.no_acknowledge",
        Text::new(
            "check the bit rate (-b; P.903 of every drive), CAN high and low, both terminations, and whether a drive is on the bus at \
             all: with P.900 = -1, as from the factory, it is not",
            "Bitrate (-b; P.903 jedes Umrichters), CAN high und low und beide Abschlüsse prüfen, und ob überhaupt ein Umrichter am \
             Bus ist: mit P.900 = -1, wie ab Werk, ist er es nicht",
        ),
    ),
    (
        "port.can_unsent",
        Text::new(
            "its channel was closed, or it gave the bus up (bus off): unplug it and plug it in again; check bit rate and wiring",
            "sein Kanal ist geschlossen, oder er hat den Bus aufgegeben (Bus-Off): abziehen und wieder einstecken; Bitrate und \
             Verdrahtung prüfen",
        ),
    ),
    (
        "silence.no_time",
        Text::new(
            "is the cable still plugged in, and the drive under power? Where replies are only slow, a longer --timeout helps",
            "steckt das Kabel noch, und hat der Antrieb Spannung? Sind die Antworten nur langsam, hilft ein längeres --timeout",
        ),
    ),
    (
        "silence.gateway",
        Text::new(
            "check the address, and the serial setting of the gateway",
            "Adresse und serielle Einstellung des Gateways prüfen",
        ),
    ),
    (
        "garbled.no_valid_reply",
        Text::new(
            "check baud rate and parity, two drives with the same address, termination and shielding",
            "Baudrate und Parität, doppelt vergebene Adressen, Abschluss und Schirmung prüfen",
        ),
    ),
    (
        "garbled.short",
        Text::new(
            "a drive always sends 8 (EM-RES-03 manual 5.10.1): is it another device, or does the adapter cut frames? `antrieb sniff` shows \
             them",
            "ein Umrichter sendet immer 8 (Anleitung EM-RES-03 5.10.1): ist es ein anderes Gerät, oder kürzt der Adapter die Frames? \
             `antrieb sniff` zeigt sie",
        ),
    ),
    (
        "garbled.wrong_answer",
        Text::new(
            "a reply that comes later than --timeout looks so, too: try a longer one; -v shows the telegrams; or is it no drive of \
             this family, or another master on the bus?",
            "auch eine Antwort, die später als --timeout kommt, sieht so aus: länger warten; -v zeigt die Telegramme; oder ist es \
             kein Antrieb dieser Familie, oder ein zweiter Master am Bus?",
        ),
    ),
    ("garbled.wrong_responder", WHO_ANSWERS),
    (
        "garbled.never_silent",
        Text::new(
            "another master, two drives at one address, or a wrong baud rate? `antrieb sniff` shows what is said",
            "ein zweiter Master, zwei Antriebe mit einer Adresse oder eine falsche Baudrate? `antrieb sniff` zeigt, was \
             gesprochen wird",
        ),
    ),
    (
        "garbled.unproven",
        Text::new(
            "replies come late, twice or from somebody else: a longer --timeout, and look for a second master, a repeater \
             or two drives with one address",
            "Antworten kommen spät, doppelt oder von anderen: --timeout verlängern und nach einem zweiten Master, einem \
             Repeater oder zwei Antrieben mit einer Adresse suchen",
        ),
    ),
    (
        "garbled.two_answers",
        Text::new(
            "two drives answer at this address, or another master asks the same drive: leave one drive on the line and \
             give it another address",
            "zwei Antriebe antworten unter dieser Adresse, oder ein zweiter Master fragt denselben: nur einen Antrieb am \
             Bus lassen und ihm eine andere Adresse geben",
        ),
    ),
    ("usage.broadcast_read", Text::new("name one drive to read from", "zum Lesen einen Antrieb nennen")),
    (
        "port.busy",
        Text::new(
            "close the other program; ModemManager and brltty grab adapters on Linux (`fuser -v PORT`)",
            "das andere Programm schließen; unter Linux greifen ModemManager und brltty nach Adaptern (`fuser -v \
             PORT`)",
        ),
    ),
    (
        "port.permission",
        Text::new(
            "join the group that owns the port, usually `sudo usermod -aG dialout $USER`, and log in again",
            "der Gruppe des Anschlusses beitreten, meist `sudo usermod -aG dialout $USER`, und neu anmelden",
        ),
    ),
    (
        "port.setting",
        Text::new(
            "is it a serial port, and can it do this speed?",
            "ist es ein serieller Anschluss, und kann er diese Geschwindigkeit?",
        ),
    ),
    (
        "port.rs485",
        Text::new(
            "--rs485 adapter leaves the direction to the adapter, as most USB adapters want it",
            "--rs485 adapter überlässt die Richtung dem Adapter, wie es die meisten USB-Adapter wollen",
        ),
    ),
    (
        "port.fixed_line",
        Text::new(
            "set speed and parity at the device server, or use rfc2217:// where it offers that",
            "Geschwindigkeit und Parität am Geräteserver einstellen, oder rfc2217:// verwenden, wo er es anbietet",
        ),
    ),
    (
        "port.no_rfc2217",
        Text::new(
            "is it the raw port of the device server? Then it is tcp://HOST:PORT",
            "ist es der rohe Port des Geräteservers? Dann heißt er tcp://RECHNER:PORT",
        ),
    ),
    (
        "port.unreachable",
        Text::new(
            "check host and TCP port; many device servers accept one connection at a time",
            "Rechner und TCP-Port prüfen; viele Geräteserver nehmen nur eine Verbindung zugleich an",
        ),
    ),
    (
        "data.recording",
        Text::new("`--trace FILE` writes such a recording", "`--trace DATEI` schreibt eine solche Aufzeichnung"),
    ),
    (
        "port.recording",
        Text::new(
            "play it back with the command, the options and the version that recorded it",
            "mit dem Befehl, den Optionen und der Version abspielen, mit denen aufgezeichnet wurde",
        ),
    ),
    (
        "port.stuck",
        Text::new(
            "plug the adapter in again; if it is a device server, is its serial side stopped by a handshake?",
            "den Adapter neu einstecken; bei einem Geräteserver: hält ein Handshake seine serielle Seite an?",
        ),
    ),
    (
        "port.stranger",
        Text::new(
            "plug the first adapter in again, or start anew with -p; on Linux /dev/serial/by-id names an adapter for good",
            "den ersten Adapter wieder einstecken oder mit -p neu beginnen; unter Linux benennt ihn /dev/serial/by-id für immer",
        ),
    ),
    (
        "port.lost_server",
        Text::new(
            "is the server still there? Many device servers accept one connection at a time, and drop an idle one",
            "ist der Server noch da? Viele Geräteserver nehmen nur eine Verbindung zugleich an und trennen eine stille",
        ),
    ),
    (
        "port.lost",
        Text::new(
            "plug the adapter in again; on Linux it keeps its name under /dev/serial/by-id",
            "den Adapter wieder einstecken; unter Linux behält er seinen Namen in /dev/serial/by-id",
        ),
    ),
];
