//! Telegrams of Modbus in words: frames, and the codes that the ACTIVE family reads and writes with (CM-485 manual 6.4).

use super::{Reader, Said, field, field16};
use crate::outcome::{Field, TelegramDoc};
use crate::profile::{Family, Lang, Route, format_value};
use crate::protocol::check;
use crate::protocol::modbus::pdu::{self, Exception, ParamAddress, PduError, Reply, Request};
use crate::protocol::modbus::{Adu, FrameError, Framing, Hex, MAX_PDU, rtu};

impl Reader<'_> {
    pub(super) fn modbus(&self, framing: Framing, bytes: &[u8], is_request: Option<bool>) -> TelegramDoc {
        let decoded = framing.decode(bytes);
        let mut doc = TelegramDoc {
            at_us: None,
            protocol: framing.name(),
            direction: None,
            address: None,
            function: None,
            check_ok: decoded.is_ok(),
            hex: Hex(bytes).to_string(),
            meaning: String::new(),
            fields: Vec::new(),
        };
        let adu = match decoded {
            Ok(adu) => adu,
            Err(error) => {
                let prefix = self.pick("no valid telegram", "kein gültiges Telegramm");
                doc.meaning = format!("{prefix}: {}", self.frame_error(&error));
                return doc;
            }
        };
        doc.address = Some(adu.station);
        doc.function = adu.pdu.first().map(|function| function & !pdu::EXCEPTION_BIT);
        let (direction, (meaning, fields)) = self.pdu(&adu.pdu, is_request);
        doc.direction = direction;
        doc.meaning = format!("{}: {meaning}", self.station(adu.station));
        doc.fields = self.frame_fields(framing, &adu, fields);
        doc
    }

    /// Direction, meaning and fields of a PDU. Where request and reply look the same, it is called an echo.
    fn pdu(&self, pdu: &[u8], is_request: Option<bool>) -> (Option<&'static str>, Said) {
        match (Request::decode(pdu), Reply::decode(pdu), is_request) {
            (_, Ok(Reply::Exception { function, code }), _) => (Some("reply"), self.refusal(pdu, function, code)),
            (Ok(request), _, Some(true)) | (Ok(request), Err(_), _) => (Some("request"), self.request(&request)),
            (_, Ok(reply), Some(false)) | (Err(_), Ok(reply), _) => (Some("reply"), self.reply(&reply)),
            (Ok(request), Ok(_), None) => {
                let (meaning, fields) = self.request(&request);
                let either = self.pick("request, or its echo", "Anfrage oder ihr Echo");
                (None, (format!("{meaning} ({either})"), fields))
            }
            (Err(_), Err(error), Some(false)) | (Err(error), Err(_), _) => {
                (None, (self.pdu_error(&error), vec![self.raw(pdu.get(1..).unwrap_or_default())]))
            }
        }
    }

    fn request(&self, request: &Request) -> Said {
        let (read, write) = (self.pick("read", "lesen"), self.pick("write", "schreiben"));
        match request {
            Request::ReadRegisters { start, count } if self.paired().is_some() => self.reads(*start, *count),
            Request::WriteRegister { address, value } if self.paired().is_some() => {
                (format!("{write} {}", self.assigned(*address, &[*value])), self.single(*address, *value))
            }
            Request::ReadRegisters { start, count } => {
                let meaning = match count {
                    1 => format!("{read} {}, 16 bit", self.param(*start)),
                    count => format!("{read} {count} {}, {}", self.pick("registers", "Register"), self.param(*start)),
                };
                (meaning, vec![self.address_field(*start), self.count_field(*count)])
            }
            Request::WriteRegister { address, value } => {
                let shown = self.value(*address, (*value).into(), false);
                let meaning = format!("{write} {} = {shown}", self.param(*address));
                (meaning, self.written(*address, &value.to_be_bytes(), shown))
            }
            Request::WriteRegisters { start, values } => self.writes(*start, values),
            Request::ExchangeRegisters { start, count, write_start, values } => {
                self.exchanges(*start, *count, *write_start, values)
            }
            Request::Diagnostics { sub, data } => self.diagnostics(*sub, *data, true),
            Request::ReadIdentification { category, object } => self.asks_identification(*category, *object),
            Request::ReadLong { address } => {
                (format!("{read} {}, 32 bit", self.param(*address)), vec![self.address_field(*address)])
            }
            Request::WriteLong { address, value } => {
                let shown = self.value(*address, *value, true);
                let meaning = format!("{write} {} = {shown}", self.param(*address));
                (meaning, self.written(*address, &value.to_be_bytes(), shown))
            }
            Request::Other { function, data } => self.unknown(*function, data),
        }
    }

    fn reply(&self, reply: &Reply) -> Said {
        let (value, done) = (self.pick("value", "Wert"), self.pick("written", "geschrieben"));
        match reply {
            Reply::Registers(words) | Reply::RegistersExchanged(words) => self.told(words),
            Reply::RegisterWritten { address, value } if self.paired().is_some() => {
                (format!("{} {done}", self.assigned(*address, &[*value])), self.single(*address, *value))
            }
            Reply::RegisterWritten { address, value } => {
                let shown = self.value(*address, (*value).into(), false);
                let meaning = format!("{} = {shown} {done}", self.param(*address));
                (meaning, self.written(*address, &value.to_be_bytes(), shown))
            }
            Reply::RegistersWritten { start, count } => self.taken(*start, *count),
            Reply::Diagnostics { sub, data } => self.diagnostics(*sub, *data, false),
            Reply::Identification(told) => self.identifies(told),
            Reply::Long(bits) => {
                let shown = format!("{} (0x{bits:08X})", *bits as i32);
                (format!("{value} {shown}"), vec![field(&bits.to_be_bytes(), value, shown)])
            }
            Reply::LongWritten { address, value } => {
                let shown = self.value(*address, *value, true);
                let meaning = format!("{} = {shown} {done}", self.param(*address));
                (meaning, self.written(*address, &value.to_be_bytes(), shown))
            }
            Reply::Exception { function, code } => self.refusal(&reply.encode(), *function, *code),
            Reply::Other { function, data } => self.unknown(*function, data),
        }
    }

    /// A refusal; code 43 may carry its type before the exception (LXM05 manual 6.2).
    fn refusal(&self, pdu: &[u8], function: u8, code: Exception) -> Said {
        let refused = self.pick("refuses function code", "lehnt ab: Funktionscode");
        let exception = self.pick("exception", "Ausnahme");
        let mut fields = match pdu {
            &[_, kind, _] => vec![self.kind_field(kind)],
            _ => Vec::new(),
        };
        fields.push(field(&[code.code()], exception, code));
        (format!("{refused} {function}, {exception} {code}"), fields)
    }

    fn unknown(&self, function: u8, data: &[u8]) -> Said {
        let meaning = format!("{} {function}", self.pick("function code", "Funktionscode"));
        (meaning, vec![self.raw(data)])
    }

    fn raw(&self, data: &[u8]) -> Field {
        let count = format!("{} {}", data.len(), self.pick("bytes", "Bytes"));
        field(data, self.pick("data", "Daten"), count)
    }

    /// The family, if its address words carry a data set and a parameter number.
    fn active(&self) -> Option<&Family> {
        self.family.filter(|family| family.link.route == Route::Active)
    }

    fn param(&self, word: u16) -> String {
        let address = ParamAddress::from_word(word);
        let name = self.active().and_then(|family| family.param(address.number().into()));
        let name = name.map_or_else(String::new, |param| format!(" {}", param.name(self.lang)));
        format!("P.{}@{}{name}", address.number(), address.set())
    }

    fn value(&self, word: u16, bits: u32, long: bool) -> String {
        let number = ParamAddress::from_word(word).number();
        match self.active().and_then(|family| family.param(number.into())) {
            Some(param) => format_value(param, bits, long),
            None if long => format!("{} (0x{bits:08X})", bits as i32),
            None => format!("{bits} (0x{bits:04X})"),
        }
    }

    fn address_field(&self, word: u16) -> Field {
        field16(word, self.pick("data set / parameter", "Datensatz / Parameter"), self.param(word))
    }

    pub(super) fn count_field(&self, count: u16) -> Field {
        field16(count, self.pick("register count", "Registeranzahl"), count)
    }

    fn written(&self, address: u16, bytes: &[u8], shown: String) -> Vec<Field> {
        vec![self.address_field(address), field(bytes, self.pick("value", "Wert"), shown)]
    }

    /// Station, function code and check value around the fields of the PDU.
    fn frame_fields(&self, framing: Framing, adu: &Adu, inner: Vec<Field>) -> Vec<Field> {
        let function = adu.pdu.first().copied().unwrap_or(0);
        let mut fields = vec![
            field(&[adu.station], self.pick("address", "Adresse"), self.station(adu.station)),
            field(&[function], self.pick("function code", "Funktionscode"), function),
        ];
        fields.extend(inner);
        let (name, value) = match framing {
            Framing::Tcp => return fields, // no check value
            Framing::Rtu => ("CRC", rtu::encode(adu.station, &adu.pdu).split_off(adu.pdu.len() + 1)),
            Framing::Ascii => ("LRC", vec![check::lrc(&[[adu.station].as_slice(), &adu.pdu].concat())]),
        };
        fields.push(field(&value, name, "ok"));
        fields
    }

    fn frame_error(&self, error: &FrameError) -> String {
        match (self.lang, error) {
            (Lang::En, error) => error.to_string(),
            (Lang::De, FrameError::TooShort { len }) => format!("{len} Bytes sind zu wenig für ein Telegramm"),
            (Lang::De, FrameError::TooLong { len }) => format!("{len} Bytes sind zu viel für ein Telegramm"),
            (Lang::De, FrameError::Check { expected, got }) => format!("Prüfwert {got:04X}h, erwartet {expected:04X}h"),
            (Lang::De, FrameError::Delimiter) => "ein ASCII-Telegramm beginnt mit ':' und endet mit CR LF".to_owned(),
            (Lang::De, FrameError::Digit { byte }) => {
                format!("Zeichen {byte:02X}h ist keine Hexadezimalziffer eines ASCII-Telegramms")
            }
        }
    }

    fn pdu_error(&self, error: &PduError) -> String {
        match (self.lang, error) {
            (Lang::En, error) => error.to_string(),
            (Lang::De, PduError::Empty) => "kein Funktionscode".to_owned(),
            (Lang::De, PduError::Length { function, len, expected }) => {
                format!("Funktionscode {function}: {len} Datenbytes, erwartet {expected}")
            }
            (Lang::De, PduError::ByteCount { function, got, count }) => {
                format!("Funktionscode {function}: {got} Bytes für {count} Register angekündigt")
            }
            (Lang::De, PduError::TooLong { len }) => {
                format!("{len} Bytes hinter der Adresse, höchstens {MAX_PDU} sind erlaubt")
            }
        }
    }
}
