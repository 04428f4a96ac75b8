//! Frames of CAN in words, as the system bus of the drives has them (EM-RES-03 manual, chapter 5) and CANopen beside it.
//!
//! An identifier says only what it is for by the predefined connection set: drives may have been given others (P.918, P.921 to
//! P.929), so of a PDO nothing is claimed but its bytes.

pub(super) mod names;
mod recording;
mod sdo;

use super::{Reader, field};
use crate::drive::describe;
use crate::outcome::{CanDoc, Field, TelegramDoc};
use crate::protocol::can::candump::{self, What};
use crate::protocol::can::emergency::Emergency;
use crate::protocol::can::nmt::{Life, Order};
use crate::protocol::can::pdo::{Kind, Pdo, Place};
use crate::protocol::can::{
    Body, Frame, FrameError, Identifier, LAST_DRIVE, Payload, PdoNumber, Service, slcan, telegram_frame,
};
use crate::text::{Text, both};

pub use recording::{Written, is_can, log};

/// What is said of a frame besides its bytes.
struct Told {
    service: &'static str,
    direction: Option<&'static str>,
    node: Option<u8>,
    /// Which of several PDOs or SDOs.
    channel: Option<u8>,
    param: Option<u32>,
    data_set: Option<u8>,
    raw: Option<i64>,
    is_right: bool,
    /// It is an answer that refuses.
    refuses: bool,
    meaning: Text,
    fields: Vec<Field>,
}

impl Told {
    fn new(service: &'static str, meaning: Text) -> Self {
        Told {
            service,
            direction: None,
            node: None,
            channel: None,
            param: None,
            data_set: None,
            raw: None,
            is_right: true,
            refuses: false,
            meaning,
            fields: Vec::new(),
        }
    }

    /// Of a service whose data have another length.
    fn wrong(service: &'static str, expected: &Text) -> Self {
        let meaning =
            both!("no valid frame: expected {expected}", "kein gültiger Frame: erwartet {expected}", expected);
        Told { is_right: false, ..Told::new(service, meaning) }
    }
}

impl Reader<'_> {
    /// Takes frames apart as people type them: `585#42740102…` as candump logs them, also with blanks between the bytes, and
    /// `t585842740102…` as SLCAN has them.
    pub fn frames(&self, text: &str) -> Result<Vec<TelegramDoc>, Text> {
        let mut told: Vec<String> = Vec::new();
        for word in text.split_whitespace() {
            match told.last_mut().filter(|last| last.contains('#')) {
                Some(last) if !word.contains('#') && !slcan::is_frame(word) => last.push_str(word),
                _ => told.push(word.to_owned()),
            }
        }
        let one = |word: &String| -> Result<TelegramDoc, Text> {
            let wrong = |error: FrameError| names::wrong(&error);
            if word.contains('#') {
                return candump::what(word).map(|what| self.what(&what)).map_err(wrong);
            }
            slcan::Word::read(word).map(|word| self.slcan(&word, None)).map_err(wrong)
        };
        match told.is_empty() {
            true => Err(names::empty()),
            false => told.iter().map(one).collect(),
        }
    }

    /// A frame as a conversation over SDO has it.
    pub(super) fn sdo(&self, bytes: &[u8]) -> TelegramDoc {
        match telegram_frame(bytes) {
            Some(frame) => self.frame(&frame),
            None => document(Told::wrong("sdo", &names::eight_bytes()), None, crate::protocol::Hex(bytes).to_string()),
        }
    }

    /// What a recording has: a frame, or what the controller reports.
    fn what(&self, what: &What) -> TelegramDoc {
        match what {
            What::Frame(frame) => self.frame(frame),
            What::Trouble { class, data } => {
                let told = Told::new("trouble", names::trouble(*class));
                document(told, None, format!("{class:08X}!{}", crate::protocol::Hex(data.bytes())))
            }
        }
    }

    /// A word of SLCAN: a frame, or what is said to the adapter, or by it, where it is known who said it (`sent` by us).
    fn slcan(&self, word: &slcan::Word, sent: Option<bool>) -> TelegramDoc {
        match word {
            slcan::Word::Frame { frame, .. } => self.frame(frame),
            other => {
                let (direction, meaning) = names::adapter(other, sent == Some(true));
                let told = Told { direction: Some(direction), ..Told::new("adapter", meaning) };
                document(told, None, other.to_string().escape_default().to_string())
            }
        }
    }

    /// A frame in words.
    pub(in crate::drive) fn frame(&self, frame: &Frame) -> TelegramDoc {
        let told = match (frame.identifier, &frame.body) {
            (Identifier::Extended(_), _) => Told::new(
                "foreign",
                both!("29-bit identifier: not of the system bus", "29-Bit-Identifier: nicht vom Systembus"),
            ),
            (Identifier::Standard(number), Body::Remote(len)) => asked_for(Service::of(number), *len),
            (Identifier::Standard(number), Body::Data(payload)) => self.served(Service::of(number), payload),
        };
        document(told, Some(frame.identifier), frame.to_string())
    }

    fn served(&self, service: Service, payload: &Payload) -> Told {
        let bytes = payload.bytes();
        match service {
            Service::Nmt => order(bytes),
            Service::Sync => sync(bytes),
            Service::Emergency(node) => self.emergency(node, bytes),
            Service::TxPdo(pdo, node) => process_data(pdo, node, true, payload),
            Service::RxPdo(pdo, node) => process_data(pdo, node, false, payload),
            Service::SdoRequest(channel, node) => self.sdo_request(channel, node, payload),
            Service::SdoReply(channel, node) => self.sdo_reply(channel, node, payload),
            Service::BootUp(node) => life(node, bytes),
            Service::Time => Told::new("time", both!("time of day (CANopen)", "Uhrzeit (CANopen)")),
            Service::FourthPdo { sent, node } => {
                let (name, direction) = if sent { ("TxPDO4", "reply") } else { ("RxPDO4", "request") };
                let meaning = both!(
                    "node {node}: {name} of CANopen; the drives have three",
                    "Knoten {node}: {name} von CANopen; die Umrichter haben drei"
                );
                let service = if sent { "tx_pdo" } else { "rx_pdo" };
                let direction = Some(direction);
                Told { node: Some(node), channel: Some(4), direction, ..Told::new(service, meaning) }
            }
            Service::Free => Told::new(
                "free",
                both!(
                    "identifier of no service of the predefined connection set",
                    "Identifier ohne Dienst im Predefined Connection Set"
                ),
            ),
        }
    }

    fn emergency(&self, node: u8, bytes: &[u8]) -> Told {
        let Some(told) = Emergency::decode(bytes) else {
            return Told { node: Some(node), ..Told::wrong("emergency", &names::eight_bytes()) };
        };
        let fault = self.family.and_then(|family| describe::fault(family, told.fault.into()));
        let fault = fault.map_or_else(|| Text::name(format_args!("{:04X}h", told.fault)), |fault| fault.told());
        let meaning = match told {
            Emergency::CLEARED => both!(
                "node {node}: emergency cleared, the fault was acknowledged",
                "Knoten {node}: Emergency aufgehoben, die Störung ist quittiert"
            ),
            _ if told.is_of_a_drive() && node <= LAST_DRIVE => {
                both!("node {node}: fault {fault}", "Knoten {node}: Störung {fault}", fault)
            }
            Emergency { code, register, .. } => both!(
                "node {node}: emergency, error code {code:04X}h, error register {register:02X}h; not as the drives send it",
                "Knoten {node}: Emergency, Fehlercode {code:04X}h, Fehlerregister {register:02X}h; nicht, wie die Umrichter senden"
            ),
        };
        let hex = |number: u16| Text::name(format_args!("{number:04X}h"));
        let fields = vec![
            field(&told.code.to_le_bytes(), both!("error code", "Fehlercode"), hex(told.code)),
            field(
                &[told.register],
                both!("error register", "Fehlerregister"),
                Text::name(format_args!("{:02X}h", told.register)),
            ),
            field(&told.between, both!("unused", "unbenutzt"), Text::default()),
            field(&told.fault.to_le_bytes(), both!("fault key", "Fehlerschlüssel"), hex(told.fault)),
        ];
        let raw = Some(told.fault.into());
        Told { node: Some(node), direction: Some("reply"), raw, fields, ..Told::new("emergency", meaning) }
    }
}

/// What an adapter said that is no word of it.
pub(in crate::drive) fn damaged_word(word: &str, error: &FrameError) -> TelegramDoc {
    let told = Told { is_right: false, ..Told::new("adapter", names::wrong(error)) };
    document(told, None, word.escape_default().to_string())
}

/// A document of what was told.
fn document(told: Told, identifier: Option<Identifier>, hex: String) -> TelegramDoc {
    TelegramDoc {
        direction: told.direction,
        address: told.node,
        refuses: told.refuses,
        meaning: told.meaning,
        fields: told.fields,
        can: Some(CanDoc {
            interface: None,
            sent: None,
            identifier: identifier.map(Identifier::number),
            service: told.service,
            channel: told.channel,
            param: told.param,
            data_set: told.data_set,
            raw: told.raw,
        }),
        ..TelegramDoc::blank("can", hex, told.is_right)
    }
}

/// A request for a frame (RTR), which the drives are nowhere said to answer.
fn asked_for(service: Service, len: u8) -> Told {
    let what = names::service(service);
    let meaning = both!(
        "remote request for {len}: {what}",
        "Anforderung (RTR) von {len}: {what}",
        len = Text::count(len.into(), ["byte", "bytes"], ["Byte", "Byte"]),
        what
    );
    Told { direction: Some("request"), ..Told::new("remote", meaning) }
}

fn order(bytes: &[u8]) -> Told {
    let Some(order) = Order::decode(bytes) else {
        return Told::wrong("nmt", &both!("two bytes", "zwei Byte"));
    };
    let whom = match order.node {
        0 => both!("to all nodes", "an alle Knoten"),
        node => both!("to node {node}", "an Knoten {node}"),
    };
    let command = names::command(order.command);
    let fields = vec![
        field(&[order.command.specifier()], both!("command specifier", "Command Specifier"), command.clone()),
        field(&[order.node], both!("node", "Knoten"), whom.clone()),
    ];
    let meaning = Text::join([&Text::name("NMT"), &whom, &command], ": ");
    Told { node: Some(order.node), direction: Some("request"), fields, ..Told::new("nmt", meaning) }
}

fn sync(bytes: &[u8]) -> Told {
    let meaning = match bytes.len() {
        0 => Text::name("SYNC"),
        len => both!(
            "SYNC, though with {len} of data",
            "SYNC, allerdings mit {len} Daten",
            len = Text::count(len as u64, ["byte", "bytes"], ["Byte", "Byte"])
        ),
    };
    Told { direction: Some("request"), ..Told::new("sync", meaning) }
}

fn life(node: u8, bytes: &[u8]) -> Told {
    let Some(state) = Life::decode(bytes) else {
        return Told { node: Some(node), ..Told::wrong("boot_up", &both!("one byte", "ein Byte")) };
    };
    let (service, meaning) = match state {
        Life::BootUp => ("boot_up", both!("node {node}: boot-up", "Knoten {node}: Boot-Up")),
        state => {
            let state = names::life(state);
            let meaning = both!(
                "node {node}: heartbeat, {state}; the drives send none",
                "Knoten {node}: Heartbeat, {state}; die Umrichter senden keinen",
                state
            );
            ("heartbeat", meaning)
        }
    };
    Told { node: Some(node), direction: Some("reply"), ..Told::new(service, meaning) }
}

/// A PDO, raw: neither its scale nor what stands where is told by the bus.
fn process_data(pdo: PdoNumber, node: u8, sent: bool, payload: &Payload) -> Told {
    let number = pdo.number();
    let name = names::pdo(pdo, sent);
    let (service, direction) = if sent { ("tx_pdo", "reply") } else { ("rx_pdo", "request") };
    let told = |meaning: Text| Told {
        node: Some(node),
        channel: Some(number),
        direction: Some(direction),
        ..Told::new(service, meaning)
    };
    let Some(data) = payload.eight().map(Pdo) else {
        let len = payload.bytes().len();
        return told(both!(
            "{name} of node {node}, {len} bytes; the drives send 8",
            "{name} von Knoten {node}, {len} Byte; die Umrichter senden 8"
        ));
    };
    let words = (1..=Kind::Word.places()).filter_map(|number| Place::new(Kind::Word, number));
    let words: Vec<(Place, u32)> = words.map(|place| (place, data.get(place))).collect();
    let shown = words.iter().map(|(_, word)| format!("{word:04X}h")).collect::<Vec<_>>().join(" ");
    let meaning = both!("{name} of node {node}: words {shown}", "{name} von Knoten {node}: Worte {shown}");
    let one = |(place, word): &(Place, u32)| {
        let bytes = place.bytes();
        let (first, last) = (bytes.start, bytes.end - 1);
        let name = both!("bytes {first} and {last}", "Byte {first} und {last}");
        field(data.0.get(bytes).unwrap_or_default(), name, Text::name(format_args!("{word:04X}h = {word}")))
    };
    Told { fields: words.iter().map(one).collect(), ..told(meaning) }
}
