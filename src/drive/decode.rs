//! Takes telegrams apart without a line: for `decode`, `-v` and recordings.

mod vabus;

use super::route::{Inquiry, Route};
use crate::outcome::{Field, TelegramDoc};
use crate::profile::{Family, Lang, Link, format_value};
use crate::protocol::Protocol;
use crate::protocol::modbus::pdu::{self, Exception, ParamAddress, Reply, Request};
use crate::protocol::modbus::{Adu, BROADCAST, FrameError, Framing, Hex, ascii, rtu};
use crate::transport::{TraceLine, read_trace};

/// What is known besides the bytes.
#[derive(Clone, Copy, Debug)]
pub struct Reader<'a> {
    /// What is spoken.
    pub protocol: Protocol,
    /// Names of parameters, if the family is known.
    pub family: Option<&'a Family>,
    /// Language of names.
    pub lang: Lang,
}

/// Why a text is no telegram.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum InputError {
    /// Nothing there.
    #[error(
        "nothing to decode: expected hex bytes such as '01 03 21 74 00 01 CE 2C', an ASCII telegram such as ':010321740001 66', or a trace file"
    )]
    Empty,
    /// No hex digits.
    #[error("'{0}' is no hex byte; expected pairs of digits such as '01 03 21 74'")]
    Hex(String),
}

/// Reads bytes as people type them: `01 03 21 74`, `01032174`, `0x01,0x03`; or an ASCII telegram from its colon on,
/// with or without its CR LF. Tells what they are spoken in: no telegram of VABus is one of RTU with a right CRC, but
/// for the rarest chance.
fn parse_input(text: &str) -> Result<(Protocol, Vec<u8>), InputError> {
    let text = text.trim();
    if text.is_empty() {
        return Err(InputError::Empty);
    }
    if text.starts_with(':') {
        let digits: String = text.chars().filter(|c| !c.is_whitespace()).collect();
        let digits = digits.replace("\\r", "").replace("\\n", "");
        return Ok((Framing::Ascii.into(), [digits.as_bytes(), ascii::END].concat()));
    }
    let mut bytes = Vec::new();
    for word in text.split(|c: char| c.is_whitespace() || matches!(c, ',' | ';' | '-')).filter(|word| !word.is_empty())
    {
        let digits = word.strip_prefix("0x").or_else(|| word.strip_prefix("0X")).unwrap_or(word);
        let bad = || InputError::Hex(word.to_owned());
        if digits.is_empty() || digits.len() % 2 != 0 || !digits.is_ascii() {
            return Err(bad());
        }
        for pair in digits.as_bytes().chunks(2) {
            let pair = std::str::from_utf8(pair).map_err(|_| bad())?;
            bytes.push(u8::from_str_radix(pair, 16).map_err(|_| bad())?);
        }
    }
    // The hex columns of the manual also print ASCII telegrams byte by byte.
    let protocol = match bytes.first() {
        Some(&ascii::START) => Framing::Ascii.into(),
        _ if rtu::decode(&bytes).is_err() && vabus::is_telegram(&bytes) => Protocol::Vabus,
        _ => Framing::Rtu.into(),
    };
    Ok((protocol, bytes))
}

impl Reader<'_> {
    /// Takes one telegram apart as people type it. It shows what it is spoken in; only a damaged one of VABus does not.
    pub fn typed(&self, text: &str) -> Result<TelegramDoc, InputError> {
        let (shown, bytes) = parse_input(text)?;
        let protocol = if self.protocol == Protocol::Vabus { self.protocol } else { shown };
        Ok(Reader { protocol, ..*self }.telegram(&bytes, None))
    }

    /// Takes a recording apart, telegram by telegram. What it says of its protocol goes before what is set here.
    pub fn recording(&self, text: &str) -> Result<Vec<TelegramDoc>, String> {
        let protocol = recorded_protocol(text).unwrap_or(self.protocol);
        let mut docs: Vec<(TraceLine, Vec<u8>)> = Vec::new();
        for line in read_trace(text)? {
            match docs.last_mut() {
                // Chunks of one direction that follow each other within 50 ms are one telegram.
                Some((last, bytes)) if last.sent == line.sent && !line.sent && line.at_us - last.at_us < 50_000 => {
                    bytes.extend(&line.bytes);
                    last.at_us = line.at_us;
                }
                _ => {
                    let bytes = line.bytes.clone();
                    docs.push((line, bytes));
                }
            }
        }
        Ok(docs
            .into_iter()
            .flat_map(|(line, bytes)| {
                let (protocol, telegrams) = match protocol {
                    Protocol::Vabus => (protocol, vabus::cut(&bytes)),
                    _ if bytes.first() == Some(&ascii::START) => (Framing::Ascii.into(), vec![bytes]),
                    _ => (protocol, vec![bytes]),
                };
                telegrams.into_iter().map(move |bytes| {
                    let mut doc = Reader { protocol, ..*self }.telegram(&bytes, Some(line.sent));
                    doc.at_us = Some(line.at_us);
                    doc
                })
            })
            .collect())
    }

    /// Takes one telegram apart. `is_request` is `None` if the direction is unknown.
    pub fn telegram(&self, bytes: &[u8], is_request: Option<bool>) -> TelegramDoc {
        match self.protocol {
            Protocol::Modbus(framing) => self.modbus(framing, bytes, is_request),
            Protocol::Vabus => self.vabus(bytes),
        }
    }

    fn modbus(&self, framing: Framing, bytes: &[u8], is_request: Option<bool>) -> TelegramDoc {
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
        let (direction, meaning, fields) = self.pdu(&adu, is_request);
        doc.direction = direction;
        doc.meaning = format!("{}: {meaning}", self.station(adu.station));
        doc.fields = self.frame_fields(framing, &adu, fields);
        doc
    }

    /// A question as it would go over the line, taken apart; `None` if the protocol or the family has no telegram for it.
    pub fn question(&self, station: u8, inquiry: Inquiry) -> Option<TelegramDoc> {
        let presumed = Link::default();
        let link = self.family.map_or(&presumed, |family| &family.link);
        let question = Route::new(self.protocol, link, station).question(inquiry)?;
        Some(self.telegram(&question.telegram(self.protocol, station), Some(true)))
    }

    fn pick(&self, en: &'static str, de: &'static str) -> &'static str {
        if self.lang == Lang::De { de } else { en }
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

    fn station(&self, station: u8) -> String {
        match station {
            BROADCAST => self.pick("to everybody", "an alle").to_owned(),
            station => format!("{} {station}", self.pick("address", "Adresse")),
        }
    }

    /// Direction, meaning and fields of a PDU. Where request and reply look the same, it is called an echo.
    fn pdu(&self, adu: &Adu, is_request: Option<bool>) -> (Option<&'static str>, String, Vec<Field>) {
        let request = Request::decode(&adu.pdu).ok();
        let reply = Reply::decode(&adu.pdu).ok();
        let is_exception = matches!(reply, Some(Reply::Exception { .. }));
        match (request, reply, is_request) {
            (_, Some(reply @ Reply::Exception { .. }), _) if is_exception => {
                let (meaning, fields) = self.reply(&reply);
                (Some("reply"), meaning, fields)
            }
            (Some(request), _, Some(true)) | (Some(request), None, _) => {
                let (meaning, fields) = self.request(&request);
                (Some("request"), meaning, fields)
            }
            (_, Some(reply), Some(false)) | (None, Some(reply), _) => {
                let (meaning, fields) = self.reply(&reply);
                (Some("reply"), meaning, fields)
            }
            (Some(request), Some(_), None) => {
                let (meaning, fields) = self.request(&request);
                let either = self.pick("request, or its echo", "Anfrage oder ihr Echo");
                (None, format!("{meaning} ({either})"), fields)
            }
            (None, None, _) => {
                let why = Request::decode(&adu.pdu).err().map_or_else(String::new, |error| error.to_string());
                (None, why, Vec::new())
            }
        }
    }

    fn request(&self, request: &Request) -> (String, Vec<Field>) {
        let (read, write) = (self.pick("read", "lesen"), self.pick("write", "schreiben"));
        match request {
            Request::ReadRegisters { start, count } => {
                let meaning = match count {
                    1 => format!("{read} {}, 16 bit", self.param(*start)),
                    count => format!("{read} {count} {}, {}", self.pick("registers", "Register"), self.param(*start)),
                };
                (
                    meaning,
                    vec![
                        self.address_field(*start),
                        field16(*count, self.pick("register count", "Registeranzahl"), count),
                    ],
                )
            }
            Request::WriteRegister { address, value } => {
                let shown = self.value(*address, (*value).into(), false);
                (
                    format!("{write} {} = {shown}", self.param(*address)),
                    self.written(*address, &value.to_be_bytes(), shown),
                )
            }
            Request::Diagnostics { sub, data } => (self.diagnostics(*sub, None), self.diagnostics_fields(*sub, *data)),
            Request::ReadLong { address } => {
                (format!("{read} {}, 32 bit", self.param(*address)), vec![self.address_field(*address)])
            }
            Request::WriteLong { address, value } => {
                let shown = self.value(*address, *value, true);
                (
                    format!("{write} {} = {shown}", self.param(*address)),
                    self.written(*address, &value.to_be_bytes(), shown),
                )
            }
            other => {
                let meaning = format!("{} {}", self.pick("function code", "Funktionscode"), other.function());
                (meaning, vec![self.raw(other.encode().get(1..).unwrap_or_default())])
            }
        }
    }

    fn reply(&self, reply: &Reply) -> (String, Vec<Field>) {
        let value = self.pick("value", "Wert");
        match reply {
            Reply::Registers(values) => {
                let shown: Vec<String> = values.iter().map(|word| format!("{word} (0x{word:04X})")).collect();
                let mut fields = vec![field8(values.len() as u8 * 2, self.pick("byte count", "Byteanzahl"))];
                fields.extend(values.iter().map(|word| field16(*word, value, word)));
                (format!("{value} {}", shown.join(", ")), fields)
            }
            Reply::RegisterWritten { address, value } => {
                let shown = self.value(*address, (*value).into(), false);
                let done = self.pick("written", "geschrieben");
                (
                    format!("{} = {shown} {done}", self.param(*address)),
                    self.written(*address, &value.to_be_bytes(), shown),
                )
            }
            Reply::Diagnostics { sub, data } => {
                (self.diagnostics(*sub, Some(*data)), self.diagnostics_fields(*sub, *data))
            }
            Reply::Long(bits) => {
                let shown = format!("{} (0x{bits:08X})", *bits as i32);
                (
                    format!("{value} {shown}"),
                    vec![Field { hex: Hex(&bits.to_be_bytes()).to_string(), name: value.to_owned(), value: shown }],
                )
            }
            Reply::LongWritten { address, value } => {
                let shown = self.value(*address, *value, true);
                let done = self.pick("written", "geschrieben");
                (
                    format!("{} = {shown} {done}", self.param(*address)),
                    self.written(*address, &value.to_be_bytes(), shown),
                )
            }
            Reply::Exception { function, code } => {
                let refused = self.pick("refuses function code", "lehnt ab: Funktionscode");
                (format!("{refused} {function}, exception {code}"), vec![self.exception(*code)])
            }
            other => {
                let meaning = format!("{} {}", self.pick("function code", "Funktionscode"), other.function());
                (meaning, vec![self.raw(other.encode().get(1..).unwrap_or_default())])
            }
        }
    }

    fn param(&self, word: u16) -> String {
        let address = ParamAddress::from_word(word);
        let name = self.family.and_then(|family| family.param(address.number().into()));
        let name = name.map_or_else(String::new, |param| format!(" {}", param.name(self.lang)));
        format!("P.{}@{}{name}", address.number(), address.set())
    }

    fn value(&self, word: u16, bits: u32, long: bool) -> String {
        let number = ParamAddress::from_word(word).number();
        match self.family.and_then(|family| family.param(number.into())) {
            Some(param) => format_value(param, bits, long),
            None if long => format!("{} (0x{bits:08X})", bits as i32),
            None => format!("{bits} (0x{bits:04X})"),
        }
    }

    fn diagnostics(&self, sub: u16, data: Option<u16>) -> String {
        let row = self.family.and_then(|family| family.counters.iter().find(|row| row.sub == sub));
        let name = match (sub, row) {
            (pdu::CLEAR_COUNTERS, _) => self.pick("clear all counters", "alle Zähler löschen").to_owned(),
            (_, Some(row)) => row.name(self.lang).to_owned(),
            (sub, None) => format!("{} 0x{sub:02X}", self.pick("counter", "Zähler")),
        };
        let diagnostics = self.pick("diagnostics", "Diagnose");
        match data {
            Some(count) if sub != pdu::CLEAR_COUNTERS => format!("{diagnostics}, {name}: {count}"),
            _ => format!("{diagnostics}, {name}"),
        }
    }

    fn address_field(&self, word: u16) -> Field {
        field16(word, self.pick("data set / parameter", "Datensatz / Parameter"), self.param(word))
    }

    fn written(&self, address: u16, bytes: &[u8], shown: String) -> Vec<Field> {
        let name = self.pick("value", "Wert").to_owned();
        vec![self.address_field(address), Field { hex: Hex(bytes).to_string(), name, value: shown }]
    }

    fn diagnostics_fields(&self, sub: u16, data: u16) -> Vec<Field> {
        vec![
            field16(sub, self.pick("sub-function", "Unterfunktion"), format!("0x{sub:04X}")),
            field16(data, self.pick("data", "Daten"), data),
        ]
    }

    fn exception(&self, code: Exception) -> Field {
        Field {
            hex: format!("{:02X}", code.code()),
            name: self.pick("exception", "Ausnahme").to_owned(),
            value: code.to_string(),
        }
    }

    fn raw(&self, data: &[u8]) -> Field {
        let name = self.pick("data", "Daten").to_owned();
        Field { hex: Hex(data).to_string(), name, value: format!("{} bytes", data.len()) }
    }

    /// Station, function code and check value around the fields of the PDU.
    fn frame_fields(&self, framing: Framing, adu: &Adu, inner: Vec<Field>) -> Vec<Field> {
        let function = adu.pdu.first().copied().unwrap_or(0);
        let mut fields = vec![
            Field {
                hex: format!("{:02X}", adu.station),
                name: self.pick("address", "Adresse").to_owned(),
                value: self.station(adu.station),
            },
            Field {
                hex: format!("{function:02X}"),
                name: self.pick("function code", "Funktionscode").to_owned(),
                value: function.to_string(),
            },
        ];
        fields.extend(inner);
        let frame = match framing {
            Framing::Tcp => return fields, // no check value
            Framing::Rtu => rtu::encode(adu.station, &adu.pdu).split_off(adu.pdu.len() + 1),
            Framing::Ascii => {
                let body = [[adu.station].as_slice(), &adu.pdu].concat();
                vec![crate::protocol::check::lrc(&body)]
            }
        };
        let name = if framing == Framing::Rtu { "CRC" } else { "LRC" };
        fields.push(Field { hex: Hex(&frame).to_string(), name: name.to_owned(), value: "ok".to_owned() });
        fields
    }
}

/// What the first line of a recording says of its protocol, behind the setting of the line.
fn recorded_protocol(text: &str) -> Option<Protocol> {
    text.lines().next()?.strip_prefix('#')?.rsplit(',').next()?.parse().ok()
}

fn field8(value: u8, name: &str) -> Field {
    Field { hex: format!("{value:02X}"), name: name.to_owned(), value: value.to_string() }
}

fn field16(word: u16, name: &str, value: impl ToString) -> Field {
    Field { hex: Hex(&word.to_be_bytes()).to_string(), name: name.to_owned(), value: value.to_string() }
}
