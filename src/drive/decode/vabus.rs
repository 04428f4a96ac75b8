//! Telegrams of VABus in words (sources A2, EM-RES-03 manual 5.10.2.2).

use super::{Reader, field, no_telegram, wrong};
use crate::outcome::{Field, TelegramDoc};
use crate::profile::{Type, format_value};
use crate::protocol::Protocol;
use crate::protocol::modbus::Hex;
use crate::protocol::vabus::{Address, Data, EOT, Header, Heard, Receiver, Reply, Request, SystemNode, Telegram, bcc};
use crate::text::{Text, both};

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
        let mut doc = TelegramDoc::blank(Protocol::Vabus.name(), Hex(bytes).to_string(), telegram.is_ok());
        match telegram {
            Ok(telegram) => self.describe(&telegram, &mut doc),
            Err(error) => doc.meaning = no_telegram(&wrong::telegram(&error)),
        }
        doc
    }

    fn describe(&self, telegram: &Telegram, doc: &mut TelegramDoc) {
        let (direction, address, meaning) = match telegram {
            Telegram::End => {
                let end = both!("end of the exchange", "Ende des Austauschs");
                doc.direction = Some("request");
                doc.fields = vec![control("04", "EOT", end.clone())];
                doc.meaning = end;
                return;
            }
            Telegram::Request(Request::Enquiry { address, header }) => {
                doc.fields = [opening(*address), self.header(*header)].concat();
                doc.fields.push(control("05", "ENQ", both!("asks for the value", "fragt nach dem Wert")));
                ("request", *address, both!("read {what}", "lesen {what}", what = self.subject(*header)))
            }
            Telegram::Request(Request::Select { address, header, data }) => {
                doc.fields = [opening(*address), self.text(*header, data)].concat();
                let what = self.value_of(*header, data);
                ("request", *address, both!("write {what}", "schreiben {what}", what))
            }
            Telegram::Reply(Reply::Value { address, header, data }) => {
                doc.fields = [vec![addressed(*address)], self.text(*header, data)].concat();
                ("reply", *address, self.value_of(*header, data))
            }
            Telegram::Reply(Reply::Ack { address }) => {
                doc.fields = vec![addressed(*address), control("06", "ACK", both!("done", "ausgeführt"))];
                ("reply", *address, both!("done (ACK)", "ausgeführt (ACK)"))
            }
            Telegram::Reply(Reply::Nak { address }) => {
                doc.refuses = true;
                doc.fields = vec![addressed(*address), control("15", "NAK", both!("refused", "abgelehnt"))];
                let meaning = both!("refused (NAK); P.11 tells why", "abgelehnt (NAK); P.11 nennt den Grund");
                ("reply", *address, meaning)
            }
        };
        doc.direction = Some(direction);
        doc.address = Some(address.id());
        doc.meaning = Text::join([&drive(address), &meaning], ": ");
    }

    /// Parameter, data set and name; the node where it is not the addressed drive itself.
    fn subject(&self, header: Header) -> Text {
        let (number, set) = (header.number.get(), header.set.number());
        let label = Text::name(format_args!("P.{number}@{set}"));
        let named = match self.family.and_then(|family| family.param(number.into())) {
            Some(param) => Text::join([&label, &param.name], " "),
            None => label,
        };
        match header.node {
            SystemNode::SELF => named,
            node => both!("system-bus node {id}, {named}", "Systembusknoten {id}, {named}", id = node.id(), named),
        }
    }

    fn value_of(&self, header: Header, data: &Data) -> Text {
        Text::join([&self.subject(header), &self.shown(header, data)], " = ")
    }

    /// A value as far as the catalogue tells what it is; four or eight digits may be a text too.
    fn shown(&self, header: Header, data: &Data) -> Text {
        let param = self.family.and_then(|family| family.param(header.number.get().into()));
        let is_text = param.is_some_and(|param| param.kind == Some(Type::String));
        let number = data.as_word().map(|bits| (u32::from(bits), false)).or(data.as_long().map(|bits| (bits, true)));
        Text::name(match (number.filter(|_| !is_text), param) {
            (Some((bits, long)), Some(param)) => format_value(param, bits, long),
            (Some((bits, true)), None) => format!("{} (0x{bits:08X})", bits as i32),
            (Some((bits, false)), None) => format!("{bits} (0x{bits:04X})"),
            (None, _) => format!("\"{}\"", data.characters().escape_ascii()),
        })
    }

    fn header(&self, header: Header) -> Vec<Field> {
        let [first, second, third] = header.number.characters();
        let node = match header.node {
            SystemNode::SELF => both!("the drive itself", "der Umrichter selbst"),
            node => Text::name(node.id()),
        };
        let set = header.set.number();
        let memory = if set < 5 { "EEPROM" } else { "RAM" };
        let number = self.subject(Header { node: SystemNode::SELF, ..header });
        vec![
            field(&[header.node.character()], both!("system-bus node", "Systembusknoten"), node),
            field(&[b'0' + set], both!("data set", "Datensatz"), Text::name(format_args!("{set} {memory}"))),
            field(&[first, second, third], both!("parameter", "Parameter"), number),
        ]
    }

    /// Everything from STX on.
    fn text(&self, header: Header, data: &Data) -> Vec<Field> {
        let length = format!("{:02}", data.characters().len());
        let whole = Reply::Value { address: Address::BROADCAST, header, data: data.clone() }.encode();
        let between = whole.get(2..whole.len().saturating_sub(2)).unwrap_or_default();
        let mut fields = vec![control("02", "STX", both!("start of the text", "Textanfang"))];
        fields.extend(self.header(header));
        fields.extend([
            field(length.as_bytes(), both!("length", "Länge"), Text::name(&length)),
            field(data.characters(), both!("value", "Wert"), self.shown(header, data)),
            control("03", "ETX", both!("end of the text", "Textende")),
            field(&[bcc(between)], Text::name("BCC"), Text::name("ok")),
        ]);
        fields
    }
}

fn drive(address: Address) -> Text {
    match address.is_broadcast() {
        true => both!("to everybody", "an alle"),
        false => both!("address {address}", "Adresse {address}"),
    }
}

fn opening(address: Address) -> Vec<Field> {
    vec![control("04", "EOT", both!("a telegram of the master", "ein Telegramm des Masters")), addressed(address)]
}

fn addressed(address: Address) -> Field {
    field(&[address.character()], both!("address", "Adresse"), drive(address))
}

fn control(hex: &str, name: &str, value: Text) -> Field {
    Field { hex: hex.to_owned(), name: Text::name(name), value }
}
