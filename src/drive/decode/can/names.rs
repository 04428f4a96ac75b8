//! What services, commands, states and errors of CAN are called.

use crate::protocol::can::nmt::{Command, Life};
use crate::protocol::can::slcan::{RATES, Word};
use crate::protocol::can::{FrameError, PdoNumber, Service};
use crate::text::{Text, both};

pub(super) fn eight_bytes() -> Text {
    both!("eight bytes", "acht Byte")
}

pub(super) fn empty() -> Text {
    both!(
        "nothing to decode: expected a frame such as 605#4074010200000000, or t60584074010200000000",
        "nichts zu zerlegen: erwartet ein Frame wie 605#4074010200000000 oder t60584074010200000000"
    )
}

/// What is wrong with a frame.
pub(super) fn wrong(error: &FrameError) -> Text {
    let got = match error {
        FrameError::Identifier(text) => {
            return both!(
                "'{text}' is no identifier: expected three hex digits up to 7FF, or eight up to 1FFFFFFF",
                "'{text}' ist kein Identifier: erwartet drei Hex-Ziffern bis 7FF oder acht bis 1FFFFFFF"
            );
        }
        FrameError::Bytes(text) => {
            return both!(
                "'{text}' is no data: expected up to eight hex bytes",
                "'{text}' sind keine Daten: erwartet bis zu acht Hex-Byte"
            );
        }
        FrameError::Length(text) => {
            return both!(
                "'{text}' is no length: expected 0 to 8, and as many bytes",
                "'{text}' ist keine Länge: erwartet 0 bis 8 und ebenso viele Byte"
            );
        }
        FrameError::Fd => {
            return both!(
                "a frame of CAN FD, which no drive speaks",
                "ein Frame von CAN FD, das kein Umrichter spricht"
            );
        }
        FrameError::Form(text) => text,
    };
    both!(
        "'{got}' is no CAN frame: expected one such as 605#4074010200000000, or t60584074010200000000",
        "'{got}' ist kein CAN-Frame: erwartet eines wie 605#4074010200000000 oder t60584074010200000000"
    )
}

/// EM-RES-03 manual 5.8.1, with what it does to a drive.
pub(super) fn command(command: Command) -> Text {
    match command {
        Command::Start => both!(
            "Start Remote Node (PDOs begin, which can release a drive)",
            "Start Remote Node (PDOs beginnen, das kann einen Antrieb freigeben)"
        ),
        Command::Stop => both!(
            "Stop Remote Node (no PDOs, no SDOs; it stops no shaft)",
            "Stop Remote Node (keine PDOs, keine SDOs; es hält keine Welle an)"
        ),
        Command::PreOperational => both!(
            "Enter Pre-Operational (no PDOs; it stops no shaft)",
            "Enter Pre-Operational (keine PDOs; es hält keine Welle an)"
        ),
        Command::ResetNode => Text::name("Reset Node"),
        Command::ResetCommunication => Text::name("Reset Communication"),
        Command::Unknown(specifier) => both!("unknown command {specifier}", "unbekannter Befehl {specifier}"),
    }
}

pub(super) fn life(state: Life) -> Text {
    match state {
        Life::BootUp => Text::name("Boot-Up"),
        Life::Stopped => Text::name("Stopped"),
        Life::Operational => Text::name("Operational"),
        Life::PreOperational => Text::name("Pre-Operational"),
        Life::Unknown(state) => both!("unknown state {state}", "unbekannter Zustand {state}"),
    }
}

pub(super) fn pdo(pdo: PdoNumber, sent: bool) -> String {
    format!("{}PDO{}", if sent { "Tx" } else { "Rx" }, pdo.number())
}

pub(super) fn service(service: Service) -> Text {
    let (name, node) = match service {
        Service::Nmt => return Text::name("NMT"),
        Service::Sync => return Text::name("SYNC"),
        Service::Time => return both!("time of day", "Uhrzeit"),
        Service::Free => return both!("no service", "kein Dienst"),
        Service::Emergency(node) => ("Emergency".to_owned(), node),
        Service::TxPdo(number, node) => (pdo(number, true), node),
        Service::RxPdo(number, node) => (pdo(number, false), node),
        Service::FourthPdo { sent: true, node } => ("TxPDO4".to_owned(), node),
        Service::FourthPdo { sent: false, node } => ("RxPDO4".to_owned(), node),
        Service::SdoReply(channel, node) => (format!("TxSDO{}", channel.number()), node),
        Service::SdoRequest(channel, node) => (format!("RxSDO{}", channel.number()), node),
        Service::BootUp(node) => return both!("node guarding of node {node}", "Node Guarding von Knoten {node}"),
    };
    both!("{name} of node {node}", "{name} von Knoten {node}")
}

/// A sub-index as a data set; which memory 5 to 9 are over CAN is not printed.
pub(super) fn set(sub: u8) -> Text {
    match sub {
        0..=4 => both!("data set {sub}", "Datensatz {sub}"),
        _ => Text::name(sub),
    }
}

/// A control byte that no drive takes.
pub(super) fn strange(command: u8) -> Text {
    both!(
        "control byte {command:02X}h: a block transfer, or none; the drives know neither",
        "Steuerbyte {command:02X}h: Blocktransfer oder keiner; die Umrichter kennen beides nicht"
    )
}

/// Abort codes of CiA 301 (table 22).
pub(super) fn abort(code: u32) -> Text {
    let unknown = both!("unknown reason", "unbekannter Grund");
    let why = reason(code).unwrap_or(&unknown);
    both!("abort code {code:08X}h, {why}", "Abbruchcode {code:08X}h, {why}", why)
}

/// What such a code says.
pub(in crate::drive::decode) fn reason(code: u32) -> Option<&'static Text> {
    ABORTS.iter().find(|row| row.0 == code).map(|row| &row.1)
}

const ABORTS: &[(u32, Text)] = &[
    (0, Text::new("no reason told", "kein Grund genannt")),
    (0x0503_0000, Text::new("toggle bit not alternated", "Toggle-Bit nicht gewechselt")),
    (0x0504_0000, Text::new("time-out", "Zeitüberschreitung")),
    (0x0504_0001, Text::new("control byte not known", "Steuerbyte nicht bekannt")),
    (0x0504_0005, Text::new("out of memory", "Speicher voll")),
    (0x0601_0000, Text::new("access not supported", "Zugriff nicht unterstützt")),
    (0x0601_0001, Text::new("cannot be read", "nicht lesbar")),
    (0x0601_0002, Text::new("cannot be written", "nicht schreibbar")),
    (0x0602_0000, Text::new("no such object", "kein solches Objekt")),
    (0x0604_0041, Text::new("cannot be mapped to a PDO", "nicht in ein PDO abbildbar")),
    (0x0604_0042, Text::new("mapping longer than the PDO", "Abbildung länger als das PDO")),
    (0x0604_0043, Text::new("parameters do not fit together", "Parameter passen nicht zusammen")),
    (0x0606_0000, Text::new("hardware error", "Hardwarefehler")),
    (0x0607_0010, Text::new("wrong type or length", "falscher Typ oder falsche Länge")),
    (0x0607_0012, Text::new("too long", "zu lang")),
    (0x0607_0013, Text::new("too short", "zu kurz")),
    (0x0609_0011, Text::new("no such sub-index", "kein solcher Subindex")),
    (0x0609_0030, Text::new("value out of range", "Wert außerhalb des Bereichs")),
    (0x0609_0031, Text::new("value too high", "Wert zu groß")),
    (0x0609_0032, Text::new("value too low", "Wert zu klein")),
    (0x0800_0000, Text::new("general error", "allgemeiner Fehler")),
    (0x0800_0020, Text::new("cannot be stored", "nicht speicherbar")),
    (0x0800_0021, Text::new("under local control", "unter örtlicher Steuerung")),
    (0x0800_0022, Text::new("not in this state", "nicht in diesem Zustand")),
    (0x0800_0023, Text::new("no object dictionary", "kein Objektverzeichnis")),
];

/// What a controller reports (linux/can/error.h).
pub(super) fn trouble(class: u32) -> Text {
    let known: Vec<&Text> = TROUBLES.iter().filter(|row| class & row.0 != 0).map(|row| &row.1).collect();
    let unknown = both!("class {class:X}h", "Klasse {class:X}h");
    let told = if known.is_empty() { unknown } else { Text::join(known, ", ") };
    both!("the CAN interface reports: {told}", "die CAN-Schnittstelle meldet: {told}", told)
}

const TROUBLES: &[(u32, Text)] = &[
    (0x001, Text::new("could not send in time", "nicht rechtzeitig gesendet")),
    (0x002, Text::new("arbitration lost", "Arbitrierung verloren")),
    (0x004, Text::new("trouble of the controller", "Störung im Controller")),
    (0x008, Text::new("violation of the protocol", "Protokollverletzung")),
    (0x010, Text::new("trouble of the transceiver", "Störung im Transceiver")),
    (0x020, Text::new("nobody acknowledges", "niemand bestätigt")),
    (0x040, Text::new("BUS-OFF", "BUS-OFF")),
    (0x080, Text::new("bus error", "Busfehler")),
    (0x100, Text::new("controller begins anew", "Controller beginnt neu")),
];

/// What is said to an SLCAN adapter, or by it; a bare end of line is either, and is told by who said it.
pub(super) fn adapter(word: &Word, is_sent: bool) -> (&'static str, Text) {
    let said = match word {
        Word::Done if is_sent => both!("end what was begun", "Angefangenes beenden"),
        Word::Frame { .. } => both!("a frame", "ein Frame"),
        Word::Rate(number) => {
            let rate = RATES.get(usize::from(*number)).copied().unwrap_or_default();
            match rate {
                800 => both!("bit rate 800 kbit/s, or 750 on some", "Bitrate 800 kbit/s, bei manchen 750"),
                rate => both!("bit rate {rate} kbit/s", "Bitrate {rate} kbit/s"),
            }
        }
        Word::Registers(digits) => both!("bit rate by registers {digits}", "Bitrate nach Registern {digits}"),
        Word::Open => both!("open the channel", "Kanal öffnen"),
        Word::Listen => both!("open the channel to listen only", "Kanal nur zum Zuhören öffnen"),
        Word::Close => both!("close the channel", "Kanal schließen"),
        Word::Status => both!("read the status flags", "Statusbits lesen"),
        Word::Flags(flags) => {
            return ("reply", both!("adapter: status flags {flags:02X}h", "Adapter: Statusbits {flags:02X}h"));
        }
        Word::Version(told) if told.is_empty() => both!("ask for the version", "Version erfragen"),
        Word::Version(told) => return ("reply", both!("adapter: version {told}", "Adapter: Version {told}")),
        Word::Serial(told) if told.is_empty() => both!("ask for the serial number", "Seriennummer erfragen"),
        Word::Serial(told) => return ("reply", both!("adapter: serial number {told}", "Adapter: Seriennummer {told}")),
        Word::Stamps(true) => both!("times on", "Zeitstempel ein"),
        Word::Stamps(false) => both!("times off", "Zeitstempel aus"),
        Word::Done => return ("reply", both!("adapter: done", "Adapter: ausgeführt")),
        Word::Refused => return ("reply", both!("adapter: refused (BEL)", "Adapter: abgelehnt (BEL)")),
    };
    ("request", both!("to the adapter: {said}", "an den Adapter: {said}", said))
}
