//! Which telegrams somebody wants to hear of.

use crate::outcome::TelegramDoc;
use crate::text::{Wrong, both};
use std::str::FromStr;

/// Words of which all must be true of a telegram: `address=3 !reply`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Filter(Vec<(bool, Word)>);

#[derive(Clone, Debug, PartialEq, Eq)]
enum Word {
    Request,
    Reply,
    Refused,
    Disturbed,
    /// One of these ranges.
    Address(Vec<(u8, u8)>),
    Function(Vec<(u8, u8)>),
    /// Bytes behind each other, as digits.
    Hex(String),
}

impl Filter {
    /// Whether it lets a telegram through.
    pub fn lets(&self, doc: &TelegramDoc) -> bool {
        self.0.iter().all(|(is_so, word)| word.is_true(doc) == *is_so)
    }

    /// Whether it names a function code, which only Modbus has.
    pub fn names_function(&self) -> bool {
        self.0.iter().any(|(_, word)| matches!(word, Word::Function(_)))
    }
}

impl Word {
    fn is_true(&self, doc: &TelegramDoc) -> bool {
        let within = |ranges: &[(u8, u8)], number: Option<u8>| {
            number.is_some_and(|number| ranges.iter().any(|(first, last)| (*first..=*last).contains(&number)))
        };
        match self {
            Word::Request => doc.direction == Some("request"),
            Word::Reply => doc.direction == Some("reply"),
            Word::Refused => doc.refuses,
            Word::Disturbed => !doc.check_ok,
            Word::Address(ranges) => within(ranges, doc.address),
            Word::Function(ranges) => within(ranges, doc.function),
            Word::Hex(digits) => doc.hex.contains(digits),
        }
    }

    fn read(word: &str) -> Option<Word> {
        let named = [
            ("request", Word::Request),
            ("reply", Word::Reply),
            ("refused", Word::Refused),
            ("disturbed", Word::Disturbed),
        ];
        if let Some((_, found)) = named.into_iter().find(|(name, _)| *name == word) {
            return Some(found);
        }
        let (name, value) = word.split_once('=')?;
        match name {
            "address" => ranges(value).map(Word::Address),
            "function" => ranges(value).map(Word::Function),
            "hex" => hex(value).map(Word::Hex),
            _ => None,
        }
    }
}

impl FromStr for Filter {
    type Err = Wrong;

    fn from_str(text: &str) -> Result<Self, Wrong> {
        let word = |typed: &str| {
            let bare = typed.strip_prefix('!');
            Word::read(bare.unwrap_or(typed)).map(|word| (bare.is_none(), word))
        };
        let words: Option<Vec<_>> = text.split_whitespace().map(word).collect();
        words.filter(|words| !words.is_empty()).map(Filter).ok_or_else(|| {
            Wrong(both!(
                "expected words such as request, reply, refused, disturbed, address=1,5-9, function=3, hex=4178, each with a ! \
                 before it if it must not be so; got '{text}'",
                "erwartet: Wörter wie request, reply, refused, disturbed, address=1,5-9, function=3, hex=4178, jedes mit einem ! \
                 davor, wenn es nicht so sein darf; angegeben: '{text}'"
            ))
        })
    }
}

/// `3,5-9`.
fn ranges(text: &str) -> Option<Vec<(u8, u8)>> {
    let range = |part: &str| {
        let (first, last) = part.split_once('-').unwrap_or((part, part));
        Some((first.parse().ok()?, last.parse().ok()?))
    };
    text.split(',').map(range).collect()
}

/// Digits in pairs, as telegrams are told: `4178` is `41 78`.
fn hex(text: &str) -> Option<String> {
    let is_hex =
        text.len().is_multiple_of(2) && !text.is_empty() && text.bytes().all(|digit| digit.is_ascii_hexdigit());
    let upper = is_hex.then(|| text.to_ascii_uppercase())?;
    let pairs: Vec<&str> = (0..upper.len()).step_by(2).filter_map(|at| upper.get(at..at + 2)).collect();
    Some(pairs.join(" "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_words_of_a_filter_must_be_true() {
        let doc = TelegramDoc::blank("rtu", "03 06 41 78 00 0F".to_owned(), true);
        let doc = TelegramDoc { address: Some(3), function: Some(6), direction: Some("request"), ..doc };
        for (text, lets) in [
            ("request", true),
            ("reply", false),
            ("!reply address=1,3-5", true),
            ("address=1,4-5", false),
            ("function=6 hex=4178", true),
            ("hex=7841", false),
            ("disturbed", false),
            ("!disturbed !refused", true),
        ] {
            assert_eq!(text.parse::<Filter>().unwrap().lets(&doc), lets, "{text}");
        }
        for text in ["", "adress=1", "address=x", "hex=417", "address=1-300", "!"] {
            assert!(text.parse::<Filter>().is_err(), "{text}");
        }
    }
}
