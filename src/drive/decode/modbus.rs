//! Telegrams of Modbus in words: frames, and the codes that the ACTIVE family reads and writes with (CM-485 manual 6.4).

use super::services::kind_field;
use super::{Reader, Said, addressed, field, field8, field16, no_telegram, wrong};
use crate::outcome::{Field, TelegramDoc};
use crate::profile::{Family, Route, format_value};
use crate::protocol::check;
use crate::protocol::modbus::pdu::{self, Exception, ParamAddress, Reply, Request};
use crate::protocol::modbus::{Adu, Framing, Hex, rtu};
use crate::text::{Text, both};

impl Reader<'_> {
    pub(super) fn modbus(&self, framing: Framing, bytes: &[u8], is_request: Option<bool>) -> TelegramDoc {
        let decoded = framing.decode(bytes);
        let mut doc = TelegramDoc::blank(framing.name(), Hex(bytes).to_string(), decoded.is_ok());
        let adu = match decoded {
            Ok(adu) => adu,
            Err(error) => {
                doc.meaning = no_telegram(&wrong::frame(&error));
                return doc;
            }
        };
        doc.address = Some(adu.station);
        doc.function = adu.pdu.first().map(|function| function & !pdu::EXCEPTION_BIT);
        doc.refuses = adu.pdu.first().is_some_and(|function| function & pdu::EXCEPTION_BIT != 0);
        let (direction, (meaning, fields)) = self.pdu(&adu.pdu, is_request);
        doc.direction = direction;
        doc.meaning = Text::join([&addressed(adu.station), &meaning], ": ");
        doc.fields = frame_fields(framing, &adu, fields);
        doc
    }

    /// Direction, meaning and fields of a PDU. Where request and reply look the same, it is called an echo.
    fn pdu(&self, pdu: &[u8], is_request: Option<bool>) -> (Option<&'static str>, Said) {
        match (Request::decode(pdu), Reply::decode(pdu), is_request) {
            (_, Ok(Reply::Exception { function, code }), _) => (Some("reply"), refusal(pdu, function, code)),
            (Ok(request), _, Some(true)) | (Ok(request), Err(_), _) => (Some("request"), self.request(&request)),
            (_, Ok(reply), Some(false)) | (Err(_), Ok(reply), _) => (Some("reply"), self.reply(&reply)),
            (Ok(request), Ok(_), None) => {
                let (meaning, fields) = self.request(&request);
                let either = both!("{meaning} (request, or its echo)", "{meaning} (Anfrage oder ihr Echo)", meaning);
                (None, (either, fields))
            }
            (Err(_), Err(error), Some(false)) | (Err(error), Err(_), _) => {
                (None, (wrong::pdu(&error), vec![raw(pdu.get(1..).unwrap_or_default())]))
            }
        }
    }

    fn request(&self, request: &Request) -> Said {
        match request {
            Request::ReadRegisters { start, count } if self.paired().is_some() => self.reads(*start, *count),
            Request::WriteRegister { address, value } if self.paired().is_some() => {
                (writes(&self.assigned(*address, &[*value])), self.single(*address, *value))
            }
            Request::ReadRegisters { start, count } => {
                let param = self.param(*start);
                let meaning = match count {
                    1 => both!("read {param}, 16 bit", "lesen {param}, 16 Bit", param),
                    count => {
                        both!("read {count} registers, {param}", "lesen {count} Register, {param}", param)
                    }
                };
                (meaning, vec![self.address_field(*start), count_field(*count)])
            }
            Request::ReadInputs { start, count } => {
                let many =
                    both!("read {count} input register(s) from {start}", "lesen {count} Eingangsregister ab {start}");
                (
                    many,
                    vec![
                        field16(*start, both!("input register", "Eingangsregister"), Text::name(start)),
                        count_field(*count),
                    ],
                )
            }
            Request::WriteRegister { address, value } => {
                let shown = self.value(*address, (*value).into(), false);
                (writes(&self.equals(*address, &shown)), self.written(*address, &value.to_be_bytes(), shown))
            }
            Request::WriteRegisters { start, values } => self.writes(*start, values),
            Request::ExchangeRegisters { start, count, write_start, values } => {
                self.exchanges(*start, *count, *write_start, values)
            }
            Request::Diagnostics { sub, data } => self.diagnostics(*sub, *data, true),
            Request::ReadIdentification { category, object } => self.asks_identification(*category, *object),
            Request::ReadLong { address } => {
                let meaning = both!("read {param}, 32 bit", "lesen {param}, 32 Bit", param = self.param(*address));
                (meaning, vec![self.address_field(*address)])
            }
            Request::WriteLong { address, value } => {
                let shown = self.value(*address, *value, true);
                (writes(&self.equals(*address, &shown)), self.written(*address, &value.to_be_bytes(), shown))
            }
            Request::Other { function, data } => unknown(*function, data),
        }
    }

    fn reply(&self, reply: &Reply) -> Said {
        match reply {
            Reply::Registers(words) | Reply::Inputs(words) | Reply::RegistersExchanged(words) => self.told(words),
            Reply::RegisterWritten { address, value } if self.paired().is_some() => {
                (written(&self.assigned(*address, &[*value])), self.single(*address, *value))
            }
            Reply::RegisterWritten { address, value } => {
                let shown = self.value(*address, (*value).into(), false);
                (written(&self.equals(*address, &shown)), self.written(*address, &value.to_be_bytes(), shown))
            }
            Reply::RegistersWritten { start, count } => self.taken(*start, *count),
            Reply::Diagnostics { sub, data } => self.diagnostics(*sub, *data, false),
            Reply::Identification(told) => self.identifies(told),
            Reply::Long(bits) => {
                let shown = Text::name(format_args!("{} (0x{bits:08X})", *bits as i32));
                let meaning = both!("value {shown}", "Wert {shown}", shown);
                (meaning, vec![field(&bits.to_be_bytes(), both!("value", "Wert"), shown)])
            }
            Reply::LongWritten { address, value } => {
                let shown = self.value(*address, *value, true);
                (written(&self.equals(*address, &shown)), self.written(*address, &value.to_be_bytes(), shown))
            }
            Reply::Exception { function, code } => refusal(&reply.encode(), *function, *code),
            Reply::Other { function, data } => unknown(*function, data),
        }
    }

    /// The family, if its address words carry a data set and a parameter number.
    pub(super) fn active(&self) -> Option<&Family> {
        self.family.filter(|family| family.link.route == Route::Active)
    }

    pub(super) fn param(&self, word: u16) -> Text {
        let address = ParamAddress::from_word(word);
        let label = Text::name(format_args!("P.{}@{}", address.number(), address.set()));
        match self.active().and_then(|family| family.param(address.number().into())) {
            Some(param) => Text::join([&label, &param.name], " "),
            None => label,
        }
    }

    fn equals(&self, word: u16, shown: &Text) -> Text {
        Text::join([&self.param(word), shown], " = ")
    }

    pub(super) fn value(&self, word: u16, bits: u32, long: bool) -> Text {
        let number = ParamAddress::from_word(word).number();
        Text::name(match self.active().and_then(|family| family.param(number.into())) {
            Some(param) => format_value(param, bits, long),
            None if long => format!("{} (0x{bits:08X})", bits as i32),
            None => format!("{bits} (0x{bits:04X})"),
        })
    }

    fn address_field(&self, word: u16) -> Field {
        field16(word, both!("data set / parameter", "Datensatz / Parameter"), self.param(word))
    }

    fn written(&self, address: u16, bytes: &[u8], shown: Text) -> Vec<Field> {
        vec![self.address_field(address), field(bytes, both!("value", "Wert"), shown)]
    }
}

/// A refusal; code 43 may carry its type before the exception (LXM05 manual 6.2).
fn refusal(pdu: &[u8], function: u8, code: Exception) -> Said {
    let mut fields = match pdu {
        &[_, kind, _] => vec![kind_field(kind)],
        _ => Vec::new(),
    };
    fields.push(field(&[code.code()], both!("exception", "Ausnahme"), wrong::numbered(code)));
    let meaning = both!(
        "refuses function code {function}, {exception}",
        "lehnt ab: Funktionscode {function}, {exception}",
        exception = wrong::exception(code)
    );
    (meaning, fields)
}

fn unknown(function: u8, data: &[u8]) -> Said {
    (both!("function code {function}", "Funktionscode {function}"), vec![raw(data)])
}

fn raw(data: &[u8]) -> Field {
    field(data, both!("data", "Daten"), both!("{count} bytes", "{count} Bytes", count = data.len()))
}

/// What is written, of a request.
pub(super) fn writes(what: &Text) -> Text {
    both!("write {what}", "schreiben {what}", what)
}

/// The same, of a reply.
pub(super) fn written(what: &Text) -> Text {
    both!("{what} written", "{what} geschrieben", what)
}

pub(super) fn count_field(count: u16) -> Field {
    field16(count, both!("register count", "Registeranzahl"), Text::name(count))
}

/// Station, function code and check value around the fields of the PDU.
fn frame_fields(framing: Framing, adu: &Adu, inner: Vec<Field>) -> Vec<Field> {
    let function = adu.pdu.first().copied().unwrap_or(0);
    let mut fields = vec![
        field(&[adu.station], both!("address", "Adresse"), addressed(adu.station)),
        field8(function, both!("function code", "Funktionscode")),
    ];
    fields.extend(inner);
    let (name, value) = match framing {
        Framing::Tcp => return fields, // no check value
        Framing::Rtu => ("CRC", rtu::encode(adu.station, &adu.pdu).split_off(adu.pdu.len() + 1)),
        Framing::Ascii => ("LRC", vec![check::lrc(&[[adu.station].as_slice(), &adu.pdu].concat())]),
    };
    fields.push(field(&value, Text::name(name), Text::name("ok")));
    fields
}
