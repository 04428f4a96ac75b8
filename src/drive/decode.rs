//! Takes telegrams apart without a line: for `decode`, `-v` and recordings.

mod answered;
mod block;
mod can;
pub mod dp;
mod modbus;
mod registers;
mod services;
mod vabus;
pub(super) mod wrong;

use super::route::{Inquiry, Route};
use crate::outcome::{Field, TelegramDoc};
use crate::profile::{Family, Link};
use crate::protocol::Protocol;
use crate::protocol::can::Telegram;
use crate::protocol::modbus::pdu::WordOrder;
use crate::protocol::modbus::{BROADCAST, Framing, Hex, ascii, rtu};
use crate::text::{Text, both};
use crate::transport::{TraceLine, read_trace};

pub(super) use can::damaged_word;
pub use can::{Written, is_can, log};

/// Meaning and fields of what stands between the address and the check value.
type Said = (Text, Vec<Field>);

/// What is known besides the bytes.
#[derive(Clone, Copy, Debug)]
pub struct Reader<'a> {
    /// What is spoken.
    pub protocol: Protocol,
    /// System-bus node that questions go to; 0 is the drive itself.
    pub node: u8,
    /// Names of parameters, if the family is known.
    pub family: Option<&'a Family>,
    /// Which half of a value in two registers comes first, if that is known; no telegram tells.
    pub order: Option<WordOrder>,
}

/// Why a text is no telegram.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum InputError {
    /// Nothing there.
    #[error("{}", self.text().en)]
    Empty,
    /// No hex digits.
    #[error("{}", self.text().en)]
    Hex(String),
}

impl InputError {
    /// In words for people.
    pub fn text(&self) -> Text {
        match self {
            InputError::Empty => both!(
                "nothing to decode: expected hex bytes such as '01 03 21 74 00 01 CE 2C', an ASCII telegram such as \
                 ':010321740001 66', or a trace file",
                "nichts zu zerlegen: erwartet Hex-Bytes wie '01 03 21 74 00 01 CE 2C', ein ASCII-Telegramm wie \
                 ':010321740001 66' oder eine Aufzeichnung"
            ),
            InputError::Hex(word) => both!(
                "'{word}' is no hex byte; expected pairs of digits such as '01 03 21 74'",
                "'{word}' ist kein Hex-Byte; erwartet Ziffernpaare wie '01 03 21 74'"
            ),
        }
    }
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
    let bytes = hex_bytes(text)?;
    // The hex columns of the manual also print ASCII telegrams byte by byte.
    let protocol = match bytes.first() {
        Some(&ascii::START) => Framing::Ascii.into(),
        _ if rtu::decode(&bytes).is_err() && vabus::is_telegram(&bytes) => Protocol::Vabus,
        _ => Framing::Rtu.into(),
    };
    Ok((protocol, bytes))
}

/// Reads hex bytes as people type them: `01 03 21 74`, `01032174`, `0x01,0x03`.
pub(super) fn hex_bytes(text: &str) -> Result<Vec<u8>, InputError> {
    let text = text.trim();
    if text.is_empty() {
        return Err(InputError::Empty);
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
    Ok(bytes)
}

/// Fewer bytes than this are no telegram that is checked: address, function code, CRC.
const MIN_TELEGRAM: usize = 4;

impl Reader<'_> {
    /// Takes one telegram apart as people type it, or a request with its reply behind it. It shows what it is spoken in; only a damaged one
    /// of VABus does not. What is no telegram is told as a damaged one; an error is only text that means no bytes.
    pub fn typed(&self, text: &str) -> Result<Vec<TelegramDoc>, InputError> {
        let (shown, bytes) = parse_input(text)?;
        let protocol = if self.protocol == Protocol::Vabus { self.protocol } else { shown };
        let reader = Reader { protocol, ..*self };
        let one = reader.telegram(&bytes, None);
        let pair = || (MIN_TELEGRAM..bytes.len()).find_map(|cut| reader.pair(bytes.get(..cut)?, bytes.get(cut..)?));
        Ok(if one.check_ok { vec![one] } else { pair().unwrap_or_else(|| vec![one]) })
    }

    /// A request and its reply, if these are two whole telegrams.
    fn pair(&self, request: &[u8], reply: &[u8]) -> Option<Vec<TelegramDoc>> {
        let [asked, mut told] = [(request, true), (reply, false)].map(|(bytes, asks)| self.telegram(bytes, Some(asks)));
        if !asked.check_ok || !told.check_ok {
            return None;
        }
        self.answered(&asked, (request, reply), &mut told);
        Some(vec![asked, told])
    }

    /// Takes a recording apart, telegram by telegram. What it says of its protocol goes before what is set here. A line that is none of a
    /// recording is refused, with its number.
    pub fn recording(&self, text: &str) -> Result<Vec<TelegramDoc>, Text> {
        if let Some(frames) = self.can_recording(text) {
            return frames;
        }
        let mut protocol = recorded_protocol(text).unwrap_or(self.protocol);
        let mut docs: Vec<(TraceLine, Vec<u8>)> = Vec::new();
        for line in read_trace(text)? {
            match docs.last_mut() {
                Some((last, bytes)) if !last.sent && !line.sent && follows(last.at_us, line.at_us) => {
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
                protocol = spoken(&bytes, protocol);
                let telegrams = if protocol == Protocol::Vabus { vabus::cut(&bytes) } else { vec![bytes] };
                let protocol = protocol;
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
            Protocol::Sdo(_) => self.sdo(bytes),
            Protocol::Pkw => self.block(bytes),
        }
    }

    /// A question as it would go over the line, taken apart; `None` if the protocol or the family has no telegram for it.
    pub fn question(&self, station: u8, inquiry: Inquiry) -> Option<TelegramDoc> {
        let presumed = Link::default();
        let link = self.family.map_or(&presumed, |family| &family.link);
        let usual = Route::new(self.protocol, link, station);
        let way = Route { node: self.node, order: self.order.unwrap_or(usual.order), ..usual };
        let question = way.question(inquiry)?;
        Some(self.telegram(&question.telegram(self.protocol, station), Some(true)))
    }
}

/// What bytes mean that are none.
fn no_telegram(why: &Text) -> Text {
    both!("no valid telegram: {why}", "kein gültiges Telegramm: {why}", why)
}

fn addressed(station: u8) -> Text {
    match station {
        BROADCAST => both!("to everybody", "an alle"),
        station => both!("address {station}", "Adresse {station}"),
    }
}

/// What these bytes are spoken in: as before, unless they make sense only in another protocol. A drive may have been
/// moved while the line was recorded.
fn spoken(bytes: &[u8], before: Protocol) -> Protocol {
    let all = [before, Framing::Rtu.into(), Framing::Ascii.into(), Protocol::Vabus];
    let makes_sense = |protocol: &Protocol| match protocol {
        Protocol::Modbus(framing) => framing.decode(bytes).is_ok(),
        Protocol::Vabus => vabus::cut(bytes).iter().all(|bytes| vabus::is_telegram(bytes)),
        Protocol::Sdo(_) => Telegram::decode(bytes).is_some(),
        Protocol::Pkw => false,
    };
    all.into_iter().find(makes_sense).unwrap_or(before)
}

/// Whether what came at `next` may belong to what came at `last`. Where the times run backwards something new began.
fn follows(last_us: u64, next_us: u64) -> bool {
    /// Longer than an adapter holds the rest of a telegram back (docs/measured.md: 16 ms).
    const ONE_TELEGRAM_US: u64 = 50_000;
    next_us.checked_sub(last_us).is_some_and(|pause| pause < ONE_TELEGRAM_US)
}

/// What the first line of a recording says of its protocol, behind the setting of the line.
fn recorded_protocol(text: &str) -> Option<Protocol> {
    recorded_word(text)?.parse().ok()
}

fn recorded_word(text: &str) -> Option<&str> {
    Some(text.lines().next()?.strip_prefix('#')?.rsplit(',').next()?.trim())
}

pub(super) fn field(bytes: &[u8], name: Text, value: Text) -> Field {
    Field { hex: Hex(bytes).to_string(), name, value }
}

fn field8(value: u8, name: Text) -> Field {
    field(&[value], name, Text::name(value))
}

fn field16(word: u16, name: Text, value: Text) -> Field {
    field(&word.to_be_bytes(), name, value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::profile::Registry;
    use proptest::prelude::*;

    const PROTOCOLS: [Protocol; 3] =
        [Protocol::Modbus(Framing::Rtu), Protocol::Modbus(Framing::Ascii), Protocol::Vabus];

    /// Readers of everything that we know a catalogue of.
    fn each_reader(mut work: impl FnMut(Reader<'_>)) {
        thread_local! {
            static FAMILIES: Vec<std::rc::Rc<Family>> = Registry::open(&[]).unwrap().families().collect();
        }
        for family in FAMILIES.with(Clone::clone) {
            for order in [WordOrder::HighFirst, WordOrder::LowFirst] {
                for protocol in PROTOCOLS {
                    work(Reader { protocol, node: 0, family: Some(&family), order: Some(order) });
                }
            }
        }
    }

    #[test]
    fn registers_that_run_past_the_last_one_are_told_all_the_same() {
        each_reader(|reader| {
            let reader = Reader { protocol: Framing::Rtu.into(), ..reader };
            // 65281 registers from 8564 on; two from 65535 on.
            let long = reader.typed("01 03 21 74 FF 01 8F DC").unwrap().remove(0);
            assert!(long.check_ok && long.meaning.en.contains("65281"), "{:?}", long.meaning);
            for pdu in [[3, 0xFF, 0xFF, 0, 2].as_slice(), &[16, 0xFF, 0xFF, 0, 2, 4, 0, 1, 0, 2]] {
                assert!(reader.typed(&Hex(&rtu::encode(1, pdu)).to_string()).unwrap()[0].check_ok);
            }
        });
    }

    #[test]
    fn a_recording_whose_times_run_backwards_is_told_telegram_by_telegram() {
        each_reader(|reader| {
            let text = "900 > 01 03 21 74 00 01 CE 2C\n500 < 01 03 02 05 6E 3A F8\n400 < 01 03 02 05 6E 3A F8\n";
            let ends = format!("{text}{} < 01\n0 < 02\n{} > 03\n", 1_u64 << 53, 1_u64 << 53);
            assert_eq!(reader.recording(text).unwrap().len(), 3);
            assert!(reader.recording(&ends).is_ok());
        });
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn no_telegram_brings_the_reader_down(
            function in prop::sample::select(vec![3_u8, 6, 8, 16, 23, 43, 100, 101, 0x83, 0x41]),
            data in prop::collection::vec(prop_oneof![Just(0_u8), Just(0xFF), any::<u8>()], 0..40),
        ) {
            let pdu = [&[function], &data[..]].concat();
            each_reader(|reader| {
                for is_request in [None, Some(true), Some(false)] {
                    reader.telegram(&rtu::encode(1, &pdu), is_request);
                    reader.telegram(&ascii::encode(1, &pdu), is_request);
                    reader.telegram(&pdu, is_request);
                }
            });
        }
    }
}
