//! Telegrams of VABus in words (sources A2, EM-RES-03 manual 5.10.2.2).

use super::Reader;
use crate::outcome::{Field, TelegramDoc};
use crate::profile::{Lang, Type, format_value};
use crate::protocol::Protocol;
use crate::protocol::modbus::Hex;
use crate::protocol::vabus::{
    Address, Data, EOT, Header, Heard, Receiver, Reply, Request, SystemNode, Telegram, TelegramError, bcc,
};

/// Bytes that were heard together, cut into telegrams and what is none.
pub(super) fn cut(bytes: &[u8]) -> Vec<Vec<u8>> {
    let mut receiver = Receiver::default();
    let heard = receiver.feed(bytes).into_iter().chain(receiver.silence());
    heard
        .map(|heard| match heard {
            Heard::Telegram(_, bytes) | Heard::Noise(bytes, _) => bytes,
        })
        .collect()
}

/// Whether these bytes are exactly one telegram.
pub(super) fn is_telegram(bytes: &[u8]) -> bool {
    bytes == [EOT] || Request::decode(bytes).is_ok() || Reply::decode(bytes).is_ok()
}

impl Reader<'_> {
    /// A telegram of VABus: its first byte tells who speaks.
    pub(super) fn vabus(&self, bytes: &[u8]) -> TelegramDoc {
        let telegram = match bytes {
            [EOT] => Ok(Telegram::End),
            [EOT, ..] => Request::decode(bytes).map(Telegram::Request),
            _ => Reply::decode(bytes).map(Telegram::Reply),
        };
        let mut doc = TelegramDoc {
            at_us: None,
            protocol: Protocol::Vabus.name(),
            direction: None,
            address: None,
            function: None,
            check_ok: telegram.is_ok(),
            hex: Hex(bytes).to_string(),
            meaning: String::new(),
            fields: Vec::new(),
        };
        match telegram {
            Ok(telegram) => self.describe(&telegram, &mut doc),
            Err(error) => {
                let prefix = self.pick("no valid telegram", "kein gültiges Telegramm");
                doc.meaning = format!("{prefix}: {}", self.telegram_error(&error));
            }
        }
        doc
    }

    fn describe(&self, telegram: &Telegram, doc: &mut TelegramDoc) {
        let (direction, address, meaning) = match telegram {
            Telegram::End => {
                doc.direction = Some("request");
                doc.fields = vec![self.control("04", "EOT", "end of the exchange", "Ende des Austauschs")];
                return doc.meaning.push_str(self.pick("end of the exchange", "Ende des Austauschs"));
            }
            Telegram::Request(Request::Enquiry { address, header }) => {
                doc.fields = [self.opening(*address), self.header(*header)].concat();
                doc.fields.push(self.control("05", "ENQ", "asks for the value", "fragt nach dem Wert"));
                ("request", *address, format!("{} {}", self.pick("read", "lesen"), self.subject(*header)))
            }
            Telegram::Request(Request::Select { address, header, data }) => {
                doc.fields = [self.opening(*address), self.text(*header, data)].concat();
                let write = self.pick("write", "schreiben");
                let shown = self.shown(*header, data);
                ("request", *address, format!("{write} {} = {shown}", self.subject(*header)))
            }
            Telegram::Reply(Reply::Value { address, header, data }) => {
                doc.fields = [vec![self.address(*address)], self.text(*header, data)].concat();
                ("reply", *address, format!("{} = {}", self.subject(*header), self.shown(*header, data)))
            }
            Telegram::Reply(Reply::Ack { address }) => {
                doc.fields = vec![self.address(*address), self.control("06", "ACK", "done", "ausgeführt")];
                ("reply", *address, self.pick("done (ACK)", "ausgeführt (ACK)").to_owned())
            }
            Telegram::Reply(Reply::Nak { address }) => {
                doc.fields = vec![self.address(*address), self.control("15", "NAK", "refused", "abgelehnt")];
                let meaning = self.pick("refused (NAK); P.11 tells why", "abgelehnt (NAK); P.11 nennt den Grund");
                ("reply", *address, meaning.to_owned())
            }
        };
        doc.direction = Some(direction);
        doc.address = Some(address.id());
        doc.meaning = format!("{}: {meaning}", self.drive(address));
    }

    fn drive(&self, address: Address) -> String {
        match address.is_broadcast() {
            true => self.pick("to everybody", "an alle").to_owned(),
            false => format!("{} {address}", self.pick("address", "Adresse")),
        }
    }

    /// Parameter, data set and name; the node where it is not the addressed drive itself.
    fn subject(&self, header: Header) -> String {
        let (number, set) = (header.number.get(), header.set.number());
        let name = self.family.and_then(|family| family.param(number.into()));
        let name = name.map_or_else(String::new, |param| format!(" {}", param.name(self.lang)));
        let node = match header.node {
            SystemNode::SELF => String::new(),
            node => format!("{} {}, ", self.pick("system-bus node", "Systembusknoten"), node.id()),
        };
        format!("{node}P.{number}@{set}{name}")
    }

    /// A value as far as the catalogue tells what it is; four or eight digits may be a text too.
    fn shown(&self, header: Header, data: &Data) -> String {
        let param = self.family.and_then(|family| family.param(header.number.get().into()));
        let is_text = param.is_some_and(|param| param.kind == Some(Type::String));
        let number = data.as_word().map(|bits| (u32::from(bits), false)).or(data.as_long().map(|bits| (bits, true)));
        match (number.filter(|_| !is_text), param) {
            (Some((bits, long)), Some(param)) => format_value(param, bits, long),
            (Some((bits, true)), None) => format!("{} (0x{bits:08X})", bits as i32),
            (Some((bits, false)), None) => format!("{bits} (0x{bits:04X})"),
            (None, _) => format!("\"{}\"", data.characters().escape_ascii()),
        }
    }

    fn opening(&self, address: Address) -> Vec<Field> {
        vec![self.control("04", "EOT", "a telegram of the master", "ein Telegramm des Masters"), self.address(address)]
    }

    fn address(&self, address: Address) -> Field {
        self.part(&[address.character()], ("address", "Adresse"), self.drive(address))
    }

    fn header(&self, header: Header) -> Vec<Field> {
        let [first, second, third] = header.number.characters();
        let itself = self.pick("the drive itself", "der Umrichter selbst").to_owned();
        let node = if header.node == SystemNode::SELF { itself } else { header.node.id().to_string() };
        let memory = if header.set.number() < 5 { "EEPROM" } else { "RAM" };
        let number = self.subject(Header { node: SystemNode::SELF, ..header });
        vec![
            self.part(&[header.node.character()], ("system-bus node", "Systembusknoten"), node),
            self.part(
                &[b'0' + header.set.number()],
                ("data set", "Datensatz"),
                format!("{} {memory}", header.set.number()),
            ),
            self.part(&[first, second, third], ("parameter", "Parameter"), number),
        ]
    }

    /// Everything from STX on.
    fn text(&self, header: Header, data: &Data) -> Vec<Field> {
        let length = format!("{:02}", data.characters().len());
        let whole = Reply::Value { address: Address::BROADCAST, header, data: data.clone() }.encode();
        let between = whole.get(2..whole.len().saturating_sub(2)).unwrap_or_default();
        let mut fields = vec![self.control("02", "STX", "start of the text", "Textanfang")];
        fields.extend(self.header(header));
        fields.extend([
            self.part(length.as_bytes(), ("length", "Länge"), length.clone()),
            self.part(data.characters(), ("value", "Wert"), self.shown(header, data)),
            self.control("03", "ETX", "end of the text", "Textende"),
            self.part(&[bcc(between)], ("BCC", "BCC"), "ok".to_owned()),
        ]);
        fields
    }

    fn part(&self, bytes: &[u8], (en, de): (&'static str, &'static str), value: String) -> Field {
        Field { hex: Hex(bytes).to_string(), name: self.pick(en, de).to_owned(), value }
    }

    fn control(&self, hex: &str, name: &str, en: &'static str, de: &'static str) -> Field {
        Field { hex: hex.to_owned(), name: name.to_owned(), value: self.pick(en, de).to_owned() }
    }

    fn telegram_error(&self, error: &TelegramError) -> String {
        if self.lang == Lang::En {
            return error.to_string();
        }
        match error {
            TelegramError::TooShort { len } => format!("{len} Bytes sind zu wenig für ein Telegramm"),
            TelegramError::TooLong { extra } => format!("{extra} Bytes zu viel hinter dem Telegramm"),
            TelegramError::Control { expected, got } => {
                format!("{got:02X}h, wo {} stehen muss", expected.replace(" or ", " oder "))
            }
            TelegramError::Address(byte) => format!("{byte:02X}h ist keine Adresse (41h bis 5Eh, 60h für alle)"),
            TelegramError::Node(byte) => format!("{byte:02X}h ist kein Systembusknoten (30h oder 41h bis 7Fh)"),
            TelegramError::Set(byte) => format!("{byte:02X}h ist kein Datensatz"),
            TelegramError::Number(text) => format!("{text:02X?} ist keine Parameternummer (000 bis 999, A00 bis F99)"),
            TelegramError::Length(text) => format!("{text:02X?} ist keine Länge (01 bis 99)"),
            TelegramError::Text(byte) => format!("Steuerzeichen {byte:02X}h in den Daten"),
            TelegramError::Check { expected, got } => format!("Prüfzeichen {got:02X}h, erwartet {expected:02X}h"),
        }
    }
}
