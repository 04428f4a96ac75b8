//! What Data_Exchange carries with an SJ2-PB, in words: PKW and process data (manual 4.1), or the Basic block (3.2).

use super::super::{field, field16};
use super::{Reader, Said, bytes_of, words};
use crate::outcome::Field;
use crate::profile::Role;
use crate::profile::value::{format_decimal, from_wire, written};
use crate::protocol::dp::basic::{flags, is_faulted, trip_cause};
use crate::protocol::dp::cfg::Layout;
use crate::protocol::dp::pkw::{Answer, LENGTH, Pkw, Task};
use crate::text::{Text, both};

/// Data whose layout nobody has told.
pub(super) fn unknown(data: &[u8]) -> Said {
    if data.is_empty() {
        return (both!("no data", "keine Daten"), Vec::new());
    }
    let bytes = bytes_of(data);
    let what = both!("{bytes}; --cfg tells what they are", "{bytes}; --cfg sagt, was sie sind", bytes);
    (what, super::raw(data))
}

impl Reader<'_> {
    /// Data of a layout.
    pub(super) fn words_of(&self, layout: Layout, data: &[u8], is_request: bool) -> Said {
        if data.is_empty() {
            return (both!("no data", "keine Daten"), Vec::new());
        }
        if data.len() != layout.length() {
            let (got, name, expected) = (bytes_of(data), layout.name(), layout.length());
            let other =
                both!("{got}, and {name} has {expected}", "{got}, und {name} hat {expected}", got, name, expected);
            return (other, super::raw(data));
        }
        let Some((block, words)) = data.split_first_chunk::<LENGTH>().filter(|_| layout.has_pkw()) else {
            let words = words(data);
            return if layout == Layout::Basic { basic(&words, is_request) } else { self.process(&words, is_request) };
        };
        let (asks, mut fields) = self.pkw_block(block, is_request);
        let (drives, process) = self.process(&self::words(words), is_request);
        fields.extend(process);
        (Text::join([&asks, &drives], "; "), fields)
    }

    /// A PKW block.
    pub(super) fn pkw_block(&self, block: &[u8; LENGTH], is_request: bool) -> Said {
        let pkw = Pkw::decode(block);
        let (key, has_element, is_double, is_refused, says_value) = if is_request {
            let task = Task::of(pkw.ak);
            (words::task(task), task.has_element(), task.is_double(), false, task.writes())
        } else {
            let answer = Answer::of(pkw.ak);
            let is_value = matches!(
                answer,
                Answer::Word | Answer::Double | Answer::ElementWord | Answer::ElementDouble | Answer::Count
            );
            let is_refused = matches!(answer, Answer::Refused | Answer::NoRight);
            (words::answer(answer), answer.has_element(), answer.is_double(), is_refused, is_value)
        };
        let element = pkw.sub_index();
        let label = match has_element {
            true => format!("P.{}.{element}", pkw.pnu),
            false => format!("P.{}", pkw.pnu),
        };
        let named = match self.family.and_then(|family| family.param(pkw.pnu.into())) {
            Some(param) => Text::join([&Text::name(label), &param.name], " "),
            None => Text::name(label),
        };
        let is_count = !is_request && Answer::of(pkw.ak) == Answer::Count;
        let value = match is_refused {
            true if Answer::of(pkw.ak) == Answer::Refused => {
                let (number, why) = refused(pkw.pwe);
                both!("{number} ({why})", "{number} ({why})", number, why)
            }
            _ => Text::name(self.value(&pkw, is_double, has_element || is_count)),
        };
        let meaning = match pkw.ak {
            0 => both!("PKW: no request", "PKW: kein Auftrag"),
            _ if says_value => {
                both!("PKW: {key}: {named} = {value}", "PKW: {key}: {named} = {value}", key, named, value)
            }
            _ if is_refused && Answer::of(pkw.ak) == Answer::Refused => {
                both!("PKW: {key}: {named}: {value}", "PKW: {key}: {named}: {value}", key, named, value)
            }
            _ => both!("PKW: {key}: {named}", "PKW: {key}: {named}", key, named),
        };
        let &[a, b, c, d, e, f, g, h] = block;
        let spm = if pkw.spm { both!("; SPM set", "; SPM gesetzt") } else { Text::default() };
        let ak = pkw.ak;
        let fields = vec![
            field(
                &[a, b],
                Text::name("PKE"),
                both!("AK {ak} ({key}), {named}{spm}", "AK {ak} ({key}), {named}{spm}", ak, key, named, spm),
            ),
            field(&[c, d], Text::name("IND"), both!("element {element}", "Element {element}")),
            field(&[e, f, g, h], Text::name("PWE"), value),
        ];
        (meaning, fields)
    }

    /// A value as far as the catalogue tells what it is. Whether a negative word comes as 0000FFFF or FFFFFFFF is open
    /// (docs/open-points.md): of a word only the low half is read, and another high half is shown raw.
    fn value(&self, pkw: &Pkw, is_double: bool, is_plain: bool) -> String {
        let raw = pkw.pwe;
        let (low, high) = (raw & 0xFFFF, raw >> 16);
        let param = self.family.and_then(|family| family.param(pkw.pnu.into())).filter(|_| !is_plain);
        let fits = is_double || high == 0 || high == 0xFFFF && low & 0x8000 != 0;
        match param {
            Some(param) if fits && param.has_scale() && !param.hex => {
                let kind = param.kind.unwrap_or(crate::profile::Type::Word);
                let bits = if is_double { raw } else { low };
                let number = written(param, from_wire(bits, kind, param.min));
                param.unit.as_ref().map_or(number.clone(), |unit| format!("{number} {unit}"))
            }
            _ if is_double || !fits => format!("{raw} ({raw:08X}h)"),
            _ => format!("{low} ({low:04X}h)"),
        }
    }

    /// Process data: control or status word, setpoint or actual value, and what was mapped.
    fn process(&self, words: &[u16], is_request: bool) -> Said {
        let names = if is_request { ["STW", "HSW"] } else { ["ZSW", "HIW"] };
        let mut meanings = Vec::new();
        let mut fields = Vec::new();
        for (nth, &word) in words.iter().enumerate() {
            let pzd = nth + 1;
            let shown = match nth {
                0 => self.profile_word(word, is_request),
                1 => share(word),
                _ => both!("{word}; P.915 and P.916 say what it is", "{word}; was das ist, sagen P.915 und P.916"),
            };
            let name = names.get(nth).copied();
            let label = name.map_or_else(
                || Text::name(format_args!("PZD{pzd}")),
                |name| Text::name(format_args!("PZD{pzd} {name}")),
            );
            meanings.extend(name.map(|name| match nth {
                1 => Text::join([&Text::name(name), &share(word)], " "),
                _ => Text::name(format_args!("{name} {word:04X}h")),
            }));
            fields.push(field16(word, label, shown));
        }
        (Text::join(&meanings, ", "), fields)
    }

    /// The control or status word bit by bit, as far as a catalogue names them.
    fn profile_word(&self, word: u16, is_request: bool) -> Text {
        let role = if is_request { Role::ControlWord } else { Role::StatusWord };
        let Some((family, param)) = self.family.and_then(|family| Some((family, family.role(role)?))) else {
            return Text::name(format_args!("{word:04X}h"));
        };
        let bits = family.word(param, word.into(), |_| None).into_iter().filter(|bit| bit.set);
        let told: Vec<_> = bits
            .map(|bit| match bit.row {
                Some(row) => row.text(),
                None => both!("bit {bit}, undefined", "Bit {bit}, nicht definiert", bit = bit.bit),
            })
            .collect();
        if told.is_empty() { both!("nothing set", "nichts gesetzt") } else { Text::join(&told, ", ") }
    }
}

/// Number of a refusal, and why. In which half of PWE it stands is not printed; the other half is 0 then.
pub(super) fn refused(pwe: u32) -> (Text, Text) {
    let (high, low) = (pwe >> 16, pwe & 0xFFFF);
    match (high, low) {
        (0, number) | (number, 0) => (Text::name(number), words::refusal(number)),
        _ => (Text::name(format_args!("{pwe:08X}h")), words::refusal(u32::MAX)),
    }
}

/// A setpoint or actual value in parts of the highest frequency: 4000h is 100 % (manual 4.1.2.3).
fn share(word: u16) -> Text {
    let raw = i64::from(word as i16);
    let hundredths = (raw * 10_000 + raw.signum() * WHOLE / 2) / WHOLE;
    let percent = format_decimal(hundredths, 2);
    both!("{percent} % of A004", "{percent} % von A004")
}

/// 100 %.
const WHOLE: i64 = 0x4000;

fn words(data: &[u8]) -> Vec<u16> {
    let pair = |pair: &[u8]| pair.iter().fold(0, |word, byte| word << 8 | u16::from(*byte));
    data.chunks(2).map(pair).collect()
}

/// The four words of the Basic block.
fn basic(words: &[u16], is_request: bool) -> Said {
    let &[word, second, third, fourth] = words else { return (Text::default(), Vec::new()) };
    let (meaning, mut fields) = if is_request { basic_control(word) } else { basic_status(word) };
    let scaled = |raw: u16, decimals: u8, unit: &str| {
        Text::name(format_args!("{} {unit}", format_decimal(raw.into(), decimals)))
    };
    let rows: [Field; 3] = match is_request {
        true => [
            field16(second, both!("frequency setpoint", "Frequenzsollwert"), scaled(second, 2, "Hz")),
            field16(third, both!("acceleration time", "Hochlaufzeit"), scaled(third, 1, "s")),
            field16(fourth, both!("deceleration time", "Runterlaufzeit"), scaled(fourth, 1, "s")),
        ],
        false => [
            field16(second, both!("output frequency", "Ausgangsfrequenz"), scaled(second, 2, "Hz")),
            field16(third, both!("motor current", "Motorstrom"), current(third)),
            field16(fourth, both!("operating state", "Betriebszustand"), state(fourth)),
        ],
    };
    let frequency = scaled(second, 2, "Hz");
    fields.extend(rows);
    (Text::join([&meaning, &frequency], "; "), fields)
}

/// Two pages of the manual scale it differently (3.2.1: A/10, 3.2.3: A/100).
fn current(raw: u16) -> Text {
    let [fine, coarse] = [2, 1].map(|decimals| format_decimal(raw.into(), decimals));
    both!(
        "{fine} A, or {coarse} A: the manual scales it in two ways",
        "{fine} A oder {coarse} A: die Anleitung skaliert ihn auf zwei Weisen"
    )
}

/// Fourth input word (manual 3.2.3).
fn state(word: u16) -> Text {
    match word {
        0 => both!("stop", "Stop"),
        1 => both!("run", "Betrieb"),
        2 => both!("jogging", "Tippbetrieb"),
        3 => both!("coasting", "Freilauf"),
        4 => both!("DC braking", "DC-Bremse"),
        10 => both!("tripped", "Störung"),
        other => both!("{other}, in no source", "{other}, in keiner Quelle"),
    }
}

/// Bits of the Basic words that control and status share: bit, name of the manual (3.2.2, 3.2.3).
const SHARED: [(u8, &str); 7] = [
    (0, "Run Fwd"),
    (1, "Run Rev"),
    (4, "Net Ctrl"),
    (5, "Inv Ref"),
    (6, "Net Ref"),
    (14, "Conn Sta"),
    (15, "EEp Wri"),
];

/// The control word of the Basic block (manual 3.2.2).
pub(super) fn basic_control(word: u16) -> Said {
    let mut told = named(word, &[(7, "Reset")]);
    told.push(match (word & 0x10 != 0, word & 0x03) {
        (false, _) => both!("the terminals start and stop", "die Klemmen starten und halten an"),
        (true, 0) => both!("stop", "Halt"),
        (true, 1) => both!("run forward", "Rechtslauf"),
        (true, 2) => both!("run reverse", "Linkslauf"),
        (true, _) => both!(
            "both directions: what that does is in no source",
            "beide Richtungen: was das tut, steht in keiner Quelle"
        ),
    });
    if word & 0x4000 != 0 {
        told.push(both!("keeps the motor running if the bus is lost", "lässt den Motor laufen, wenn der Bus ausfällt"));
    }
    let meaning = Text::join(&told, "; ");
    (meaning.clone(), vec![field16(word, both!("control word", "Steuerwort"), meaning)])
}

/// The status word of the Basic block (manual 3.2.3).
pub(super) fn basic_status(word: u16) -> Said {
    let mut told = named(flags(word), &[(7, "Faulted"), (3, "Trip cond 1"), (2, "Trip cond 2")]);
    let cause = trip_cause(word);
    let why = words::trip_cause(cause);
    match is_faulted(word) {
        true => told.push(both!("trip cause {cause:02X}h: {why}", "Störungsursache {cause:02X}h: {why}", why)),
        // 0 is "overcurrent at constant speed", and what stands there without a trip is printed nowhere.
        false if cause != 0 => told.push(both!(
            "cause {cause:02X}h without a trip: perhaps the last one ({why})",
            "Ursache {cause:02X}h ohne Störung: vielleicht die letzte ({why})",
            why
        )),
        false => {}
    }
    let meaning = if told.is_empty() { both!("nothing set", "nichts gesetzt") } else { Text::join(&told, "; ") };
    (meaning.clone(), vec![field16(word, both!("status word", "Statuswort"), meaning)])
}

/// The names of the bits that are set, and the numbers of those that have none.
fn named(word: u16, own: &[(u8, &str)]) -> Vec<Text> {
    let name = |bit: u8| own.iter().chain(&SHARED).find(|row| row.0 == bit).map(|row| row.1);
    let set = (0..16_u8).filter(|bit| word & (1 << bit) != 0);
    set.map(|bit| name(bit).map_or_else(|| both!("bit {bit}, undefined", "Bit {bit}, nicht definiert"), Text::name))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::Cyclic;
    use super::*;

    fn data(words: &[u16]) -> Vec<u8> {
        words.iter().flat_map(|word| word.to_be_bytes()).collect()
    }

    /// The exchange of 4.1 in PPO2: A038 is put into PZD3 while the drive is told to stop.
    #[test]
    fn the_exchange_of_the_manual() {
        let reader = Reader { family: None, cyclic: Some(Cyclic(Layout::Ppo(2))) };
        let sent = data(&[0x7393, 0x0100, 0, 0x22, 0x0406, 0x2000, 0x01F4, 0, 0, 0]);
        let (meaning, fields) = reader.words_of(Layout::Ppo(2), &sent, true);
        assert_eq!(meaning.en, "PKW: write an element, 16 bit: P.915.1 = 34 (0022h); STW 0406h, HSW 50.00 % of A004");
        assert_eq!(fields.len(), 3 + 6);
        let received = data(&[0x4393, 0x0100, 0, 0x22, 0x0231, 0x2000, 0x01F4, 0, 0, 0]);
        let (meaning, _) = reader.words_of(Layout::Ppo(2), &received, false);
        assert_eq!(meaning.de, "PKW: Element, 16 Bit: P.915.1 = 34 (0022h); ZSW 0231h, HIW 50.00 % von A004");
    }

    #[test]
    fn a_refusal_is_told_whichever_half_its_number_stands_in() {
        let reader = Reader { family: None, cyclic: None };
        for pwe in [[0, 0, 0, 11], [0, 11, 0, 0]] {
            let [a, b, c, d] = pwe;
            let (meaning, _) = reader.pkw_block(&[0x70, 0xF0, 0, 0, a, b, c, d], false);
            assert_eq!(meaning.en, "PKW: refused: P.240: 11 (no right to change it (P.927))");
        }
    }

    /// 3.2.2, 3.2.3: 1388h is 50 Hz, 64h is 10 s, 7D0h is 20 Hz.
    #[test]
    fn the_basic_block_of_the_manual() {
        let (control, fields) = basic(&[0x0051, 0x1388, 0x64, 0x64], true);
        assert_eq!(control.en, "Run Fwd; Net Ctrl; Net Ref; run forward; 50.00 Hz");
        let values: Vec<_> = fields.iter().skip(1).map(|field| field.value.en.to_string()).collect();
        assert_eq!(values, ["50.00 Hz", "10.0 s", "10.0 s"]);
        let (status, fields) = basic(&[0x0DD0, 0x07D0, 0x32, 10], false);
        assert_eq!(status.de, "Net Ctrl; Net Ref; Faulted; Störungsursache 0Dh: Erdschluss; 20.00 Hz");
        assert_eq!(fields[2].value.en, "0.50 A, or 5.0 A: the manual scales it in two ways");
        assert_eq!(
            basic_status(0x0550).0.en,
            "Net Ctrl; Net Ref; cause 05h without a trip: perhaps the last one (overload)"
        );
    }
}
