//! Telegrams of PROFIBUS-DP in words (IEC 61158; SJ2-PB manual 10-01-26), and what stands in them, alone.

mod cyclic;
mod services;
mod words;
mod wrong;

use super::{InputError, field, follows, hex_bytes, no_telegram, recorded_protocol, recorded_word};
use crate::outcome::{Field, Parts, TelegramDoc};
use crate::profile::Family;
use crate::protocol::dp::basic::trip_cause;
use crate::protocol::dp::cfg::Layout;
use crate::protocol::dp::control::{Count, Station, Status};
use crate::protocol::dp::{Control, Frame, Service, Telegram, frame};
pub(in crate::drive) use crate::protocol::dp::{EVERYBODY, NAME};
use crate::protocol::modbus::Hex;
use crate::text::{Text, Wrong, both};
use crate::transport::read_trace;
use std::str::FromStr;

/// The answer to Slave_Diag in words.
pub(in crate::drive) fn diagnosed(data: &[u8]) -> Parts {
    let (meaning, fields) = services::diagnosis(data).unwrap_or_else(|| (bytes_of(data), raw(data)));
    Parts { meaning, fields }
}

/// The answer to Get_Cfg in words.
pub(in crate::drive) fn configuration(data: &[u8]) -> Parts {
    let (meaning, fields) = services::configuration(data);
    Parts { meaning, fields }
}

/// Number of a refusal over PKW, and why.
pub(in crate::drive) fn refused(pwe: u32) -> (Text, Text) {
    cyclic::refused(pwe)
}

/// The cause of a trip in a status word of the Basic block (SJ2-PB manual 3.2.3).
pub(in crate::drive) fn trip(status: u16) -> (u8, Text) {
    let cause = trip_cause(status);
    (cause, words::trip_cause(cause))
}

/// What a station is, as it answers FDL status.
pub(in crate::drive) fn station(station: Station) -> Text {
    words::station(station)
}

/// What the cyclic data of a slave are: `basic`, `ppo1` to `ppo5`, or the bytes of its configuration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cyclic(pub(in crate::drive) Layout);

impl FromStr for Cyclic {
    type Err = Wrong;
    fn from_str(text: &str) -> Result<Self, Wrong> {
        let bytes = hex_bytes(text).unwrap_or_default();
        Layout::of(text.trim(), &bytes).map(Cyclic).ok_or_else(|| {
            let names: Vec<_> = Layout::all().map(Layout::name).collect();
            let names = names.join(", ");
            Wrong(both!(
                "expected {names}, or their bytes such as F3F1, got '{text}'",
                "erwartet: {names} oder ihre Bytes wie F3F1; angegeben: '{text}'"
            ))
        })
    }
}

/// What is known besides the bytes.
#[derive(Clone, Copy, Debug)]
pub struct Reader<'a> {
    /// Names of parameters and bits, if the inverter behind the module is known.
    pub family: Option<&'a Family>,
    /// What cyclic data are, if that is known; no telegram of Data_Exchange tells.
    pub cyclic: Option<Cyclic>,
}

/// Meaning and fields of what a telegram carries.
type Said = (Text, Vec<Field>);

/// Whether these bytes, as people type them, are telegrams of DP and nothing else: every byte is in one.
pub fn is_spoken(text: &str) -> bool {
    let bytes = hex_bytes(text).unwrap_or_default();
    !bytes.is_empty() && frame::cut(&bytes).into_iter().all(|piece| Telegram::decode(piece).is_ok())
}

/// Whether a recording is one of PROFIBUS: it says so, or says nothing, and is taken as one.
pub fn is_recorded(text: &str, is_set: bool) -> bool {
    recorded_word(text) == Some(NAME) || (is_set && recorded_protocol(text).is_none())
}

/// Bytes that came without a pause, each with the time that it came at.
type Heard = Vec<(u64, u8)>;

impl Reader<'_> {
    /// Takes a recording apart, telegram by telegram.
    pub fn recording(&self, text: &str) -> Result<Vec<TelegramDoc>, Text> {
        let (mut docs, mut heard, mut was_sent) = (Vec::new(), Heard::new(), false);
        for line in read_trace(text)? {
            let goes_on = heard.last().is_some_and(|(at, _)| !line.sent && !was_sent && follows(*at, line.at_us));
            if !goes_on {
                self.pieces(&mut heard, &mut docs);
            }
            was_sent = line.sent;
            heard.extend(line.bytes.into_iter().map(|byte| (line.at_us, byte)));
        }
        self.pieces(&mut heard, &mut docs);
        Ok(docs)
    }

    /// The telegrams of bytes that came without a pause, each at the time of its last byte.
    fn pieces(&self, heard: &mut Heard, docs: &mut Vec<TelegramDoc>) {
        let (times, bytes): (Vec<u64>, Vec<u8>) = std::mem::take(heard).into_iter().unzip();
        let mut end = 0;
        for piece in frame::cut(&bytes) {
            end += piece.len();
            let mut doc = self.telegram(piece);
            // A short acknowledgement names nobody: it is of whoever was asked.
            if doc.check_ok && doc.address.is_none() && doc.direction == Some("reply") {
                doc.address =
                    docs.last().filter(|asked| asked.direction == Some("request")).and_then(|asked| asked.address);
            }
            doc.at_us = times.get(end - 1).copied();
            docs.push(doc);
        }
    }

    /// Takes one telegram or several, one behind the other, apart.
    pub fn typed(&self, text: &str) -> Result<Vec<TelegramDoc>, InputError> {
        let bytes = hex_bytes(text)?;
        let pieces = frame::cut(&bytes);
        let is_whole = |piece: &&[u8]| Telegram::decode(piece).is_ok();
        // Where nothing is whole it was meant as one.
        let pieces = if pieces.iter().any(is_whole) { pieces } else { vec![&bytes[..]] };
        Ok(pieces.into_iter().map(|piece| self.telegram(piece)).collect())
    }

    /// Takes one telegram apart.
    pub fn telegram(&self, bytes: &[u8]) -> TelegramDoc {
        let telegram = Telegram::decode(bytes);
        let mut doc = TelegramDoc::blank(NAME, Hex(bytes).to_string(), telegram.is_ok());
        match telegram {
            Err(error) => doc.meaning = no_telegram(&wrong::frame(&error)),
            Ok(Telegram::Ack) => {
                doc.direction = Some("reply");
                doc.meaning = both!("SC: understood, nothing to say", "SC: verstanden, nichts zu melden");
                doc.fields = vec![field(bytes, Text::name("SC"), both!("short acknowledgement", "Kurzquittung"))];
            }
            Ok(Telegram::Token { to, from }) => {
                doc.meaning =
                    both!("the token goes from master {from} to {to}", "das Token geht von Master {from} an {to}");
                doc.fields = vec![
                    field(&[0xDC], Text::name("SD4"), both!("token", "Token")),
                    field(&[to], Text::name("DA"), Text::name(to)),
                    field(&[from], Text::name("SA"), Text::name(from)),
                ];
            }
            Ok(Telegram::Frame(frame)) => self.frame(bytes, &frame, &mut doc),
        }
        doc
    }

    fn frame(&self, bytes: &[u8], frame: &Frame, doc: &mut TelegramDoc) {
        let (meaning, fields) = self.carried(frame);
        let Frame { to, from, .. } = *frame;
        let is_request = matches!(frame.control, Control::Request { .. });
        doc.direction = Some(if is_request { "request" } else { "reply" });
        doc.address = Some(if is_request { to } else { from });
        let goal = match to {
            EVERYBODY => both!("everybody", "alle"),
            to => both!("station {to}", "Station {to}"),
        };
        let way = match is_request {
            true => both!("master {from} to {goal}", "Master {from} an {goal}", from, goal),
            false => both!("station {from} to master {to}", "Station {from} an Master {to}"),
        };
        doc.meaning = Text::join([&way, &meaning], ": ");
        doc.fields = framed(bytes, frame, fields);
    }

    /// What a frame is about, and its data field by field.
    fn carried(&self, frame: &Frame) -> Said {
        let service = Service::of(frame);
        let data = &frame.data[..];
        let said =
            match (service, frame.control) {
                (Service::Link, Control::Request { function, .. }) => return (words::function(function), raw(data)),
                (Service::Link, Control::Reply { station, status }) => {
                    let (is, status) = (words::station(station), words::status(status));
                    return (both!("{is}: {status}", "{is}: {status}", is, status), raw(data));
                }
                (Service::SlaveDiag, Control::Reply { .. }) => services::diagnosis(data),
                (Service::SetPrm, Control::Request { .. }) => services::parameters(data),
                (Service::ChkCfg, Control::Request { .. }) | (Service::GetCfg, Control::Reply { .. }) => {
                    Some(services::configuration(data))
                }
                (Service::GlobalControl, Control::Request { .. }) => services::global(data),
                (Service::DataExchange, control) => {
                    let is_request = matches!(control, Control::Request { .. });
                    Some(self.cyclic.map_or_else(
                        || cyclic::unknown(data),
                        |Cyclic(layout)| self.words_of(layout, data, is_request),
                    ))
                }
                _ => None,
            };
        let name = words::service(service);
        let (meaning, fields) = match said {
            Some((meaning, fields)) => (Text::join([&name, &meaning], ": "), fields),
            None if data.is_empty() => (name, Vec::new()),
            None => (Text::join([&name, &bytes_of(data)], ": "), raw(data)),
        };
        match frame.control {
            Control::Reply { status, .. } if !matches!(status, Status::Ok | Status::DataLow) => {
                (Text::join([&meaning, &words::status(status)], "; "), fields)
            }
            _ => (meaning, fields),
        }
    }
}

/// Bytes that nothing here tells more of.
fn raw(data: &[u8]) -> Vec<Field> {
    if data.is_empty() { Vec::new() } else { vec![field(data, both!("data", "Daten"), bytes_of(data))] }
}

fn bytes_of(data: &[u8]) -> Text {
    Text::count(data.len() as u64, ["byte", "bytes"], ["Byte", "Bytes"])
}

/// Everything around the data, in the order of the line.
fn framed(bytes: &[u8], frame: &Frame, data: Vec<Field>) -> Vec<Field> {
    let extended = |address: u8, sap: Option<u8>| address | if sap.is_some() { 0x80 } else { 0 };
    let start = match bytes {
        [0x68, length, ..] => {
            let length = both!("any length: {length} bytes", "beliebige Länge: {length} Bytes");
            field(bytes.get(..4).unwrap_or_default(), Text::name("SD2"), length)
        }
        [0xA2, ..] => field(&[0xA2], Text::name("SD3"), both!("eight bytes", "acht Bytes")),
        _ => field(&[0x10], Text::name("SD1"), both!("without data", "ohne Daten")),
    };
    let mut fields = vec![
        start,
        field(&[extended(frame.to, frame.dsap)], Text::name("DA"), Text::name(frame.to)),
        field(&[extended(frame.from, frame.ssap)], Text::name("SA"), Text::name(frame.from)),
        field(&[frame.control.encode()], Text::name("FC"), control(frame.control)),
    ];
    let is_request = matches!(frame.control, Control::Request { .. });
    let points = [("DSAP", frame.dsap, is_request), ("SSAP", frame.ssap, !is_request)];
    let points = points.into_iter().filter_map(|(name, sap, is_slave)| Some((name, sap?, is_slave)));
    let named = |(name, sap, is_slave)| field(&[sap], Text::name(name), words::access_point(sap, is_slave));
    fields.extend(points.map(named));
    fields.extend(data);
    let tail = bytes.len().saturating_sub(2);
    if let Some(&[check, end]) = bytes.get(tail..) {
        fields.push(field(&[check], Text::name("FCS"), Text::name("ok")));
        fields.push(field(&[end], Text::name("ED"), both!("end", "Ende")));
    }
    fields
}

fn control(control: Control) -> Text {
    match control {
        Control::Request { function, count } => {
            let count = match count {
                Count::Unused => both!("not counted", "nicht gezählt"),
                Count::First => both!("FCB 1, FCV 0: the counting begins", "FCB 1, FCV 0: die Zählung beginnt"),
                Count::Bit(bit) => both!("FCB {bit}, FCV 1", "FCB {bit}, FCV 1", bit = Text::name(u8::from(bit))),
            };
            Text::join([&words::function(function), &count], "; ")
        }
        Control::Reply { station, status } => Text::join([&words::station(station), &words::status(status)], "; "),
    }
}

/// What stands in a telegram, without the telegram.
impl Reader<'_> {
    /// A PKW block of eight bytes.
    pub fn pkw(&self, text: &str, is_request: bool) -> Result<Parts, Text> {
        let bytes = hex_bytes(text).map_err(|error| error.text())?;
        let got = bytes.len();
        let block = bytes.try_into().map_err(|_| {
            both!(
                "a PKW block has 8 bytes (PKE, IND, PWE), got {got}",
                "ein PKW-Block hat 8 Bytes (PKE, IND, PWE); angegeben: {got}"
            )
        })?;
        let (meaning, fields) = self.pkw_block(&block, is_request);
        Ok(Parts { meaning, fields })
    }
}

/// The bytes that a slave answers to Slave_Diag.
pub fn diagnosis(text: &str) -> Result<Parts, Text> {
    let bytes = hex_bytes(text).map_err(|error| error.text())?;
    let got = bytes.len();
    let (meaning, fields) = services::diagnosis(&bytes).ok_or_else(|| {
        both!("a diagnosis has at least 6 bytes, got {got}", "eine Diagnose hat mindestens 6 Bytes; angegeben: {got}")
    })?;
    Ok(Parts { meaning, fields })
}

/// A word of the Basic block: the status word, or the control word.
pub fn basic(word: u16, is_control: bool) -> Parts {
    let (meaning, fields) = if is_control { cyclic::basic_control(word) } else { cyclic::basic_status(word) };
    Parts { meaning, fields }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn no_bytes_bring_the_reader_down_and_the_fields_are_the_telegram(
            to in 0_u8..128, from in 0_u8..128, control in 0_u8..128,
            dsap in proptest::option::of(49_u8..64), ssap in proptest::option::of(49_u8..64),
            data in proptest::collection::vec(any::<u8>(), 0..40),
            layout in proptest::sample::select(Layout::all().collect::<Vec<_>>()),
        ) {
            let control = Control::decode(control).unwrap();
            let bytes =
                Telegram::Frame(Frame { to, from, control, dsap, ssap, data, is_fixed: false }).encode();
            for cyclic in [None, Some(Cyclic(layout))] {
                let doc = Reader { family: None, cyclic }.telegram(&bytes);
                prop_assert!(doc.check_ok);
                let hex: Vec<_> = doc.fields.iter().map(|field| field.hex.as_str()).collect();
                prop_assert_eq!(hex.join(" "), doc.hex);
            }
        }
    }
}
