//! What the reader of TOML says of a broken file, word by word and in both languages.

use super::*;
use serde::Deserialize;
use std::collections::BTreeMap;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[expect(dead_code, reason = "only what goes wrong with it is looked at")]
struct Shape {
    #[serde(default)]
    small: u8,
    #[serde(default)]
    whole: i64,
    #[serde(default)]
    broken: f64,
    #[serde(default)]
    text: String,
    #[serde(default)]
    is: bool,
    #[serde(default)]
    list: Vec<i64>,
    #[serde(default)]
    pair: Option<(u8, u8)>,
    #[serde(default)]
    rows: BTreeMap<String, i64>,
    inner: Option<Inner>,
    word: Option<Word>,
    either: Option<Either>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[expect(dead_code, reason = "only what goes wrong with it is looked at")]
struct Inner {
    needed: u16,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Word {
    One,
    Two,
}

#[derive(Debug, Deserialize)]
#[serde(untagged)]
#[expect(dead_code, reason = "only what goes wrong with it is looked at")]
enum Either {
    Number(i64),
    Several(Vec<i64>),
}

fn of(text: &str) -> Text {
    stumbled(&toml::from_str::<Shape>(text).unwrap_err()).1
}

#[test]
fn types_are_told_in_words() {
    for (text, en, de) in [
        (
            "whole = \"1\"",
            "expected a whole number, got the text \"1\"",
            "erwartet: eine ganze Zahl; dort steht der Text \"1\"",
        ),
        (
            "small = 300",
            "expected a whole number 0 to 255, got the number 300",
            "erwartet: eine ganze Zahl von 0 bis 255; dort steht die Zahl 300",
        ),
        (
            "whole = 2417851639229258349412351",
            "got the number 2417851639229258349412351",
            "dort steht die Zahl 2417851639229258349412351",
        ),
        ("small = 1.5", "expected a whole number 0 to 255, got the number 1.5", "dort steht die Zahl 1.5"),
        (
            "is = 1",
            "expected `true` or `false`, got the number 1",
            "erwartet: `true` oder `false`; dort steht die Zahl 1",
        ),
        ("text = true", "expected a text in quotes, got `true`", "Text in Anführungszeichen; dort steht `true`"),
        ("word = 1", "expected a text in quotes", "erwartet: ein Text in Anführungszeichen"),
        ("list = 1", "expected a list in [ ], got the number 1", "erwartet: eine Liste in [ ]; dort steht"),
        ("rows = [1]", "expected a table, got a list", "erwartet: eine Tabelle; dort steht eine Liste"),
        ("inner = { needed = [] }", "got a list", "dort steht eine Liste"),
        ("inner = { }", "missing field `needed`", "es fehlt `needed`"),
        ("inner = { other = 1 }", "unknown field `other`, expected `needed`", "unbekannter Schlüssel `other`"),
        (
            "word = \"six\"",
            "unknown word `six`, expected `one` or `two`",
            "unbekanntes Wort `six`; erwartet: `one`, `two`",
        ),
        ("either = \"x\"", "a value of another kind", "ein Wert anderer Art"),
    ] {
        let said = of(text);
        assert_eq!((said.en.contains(en), said.de.contains(de)), (true, true), "{text}: {said:?}");
    }
}

/// What is no TOML is told in German wherever the reader stumbles.
#[test]
fn what_the_reader_says_is_known() {
    let spoilt = [
        "x",
        "x =",
        "= 1",
        "x = = 1",
        "x == 1",
        "x = 1 2",
        "x = 01",
        "x = 0X1",
        "x = 0x",
        "x = 0xG",
        "x = 0b2",
        "x = 0o8",
        "x = +0x1",
        "x = 0x0x1",
        "x = ++1",
        "x = 1__0",
        "x = _1",
        "x = 1_",
        "x = 1.",
        "x = .5",
        "x = 1e",
        "x = 1.5e+",
        "x = abc",
        "x = tru",
        "x = True",
        "x = 2026-13-01",
        "x = 2026-01-01T",
        "x = 99999999999999999999",
        "x = 1e999999",
        "x = [1",
        "x = [1 2]",
        "x = [,]",
        "x = [1,,2]",
        "x = [=]",
        "x = [1 = 2]",
        "x = {a = 1",
        "x = {a}",
        "x = {a =}",
        "x = {a = 1 b = 2}",
        "x = {,}",
        "x = {a = 1,, b = 2}",
        "x = {= 1}",
        "x = {a = = 1}",
        "x = {a 1}",
        "x = ]",
        "x = }",
        "x = \"a",
        "x = 'a",
        "x = \"\"\"a",
        "x = '''a",
        "x = \"\\q\"",
        "x = \"\\u12\"",
        "x = \"\\uD800\"",
        "x = \"\u{1}\"",
        "x = '\u{1}'",
        "# \u{1}",
        "x = 1\ry = 2",
        "[x",
        "[[x",
        "[[x]",
        "[x]]",
        "[]",
        "[[]]",
        "[x.]",
        "[.x]",
        "[x] y",
        "[x]\n[x]",
        "x = 1\nx = 2",
        "x = 1\nx.y = 2",
        "x = [1]\nx.y = 2",
        "x = {}\nx.y = 1",
        "x = 1\n[x]",
        "x = 1\n[[x]]",
        "x.y",
        "x. = 1",
        "\"\"\"x\"\"\" = 1",
        "'''x''' = 1",
        "ä = 1",
        "a b = 1",
        "x = a b",
        "x = nonsense # y",
        "\"x",
        "x = \"a\" b",
        "{x = 1}",
        ",",
        "x = ,",
        "x = 1,",
        "x = -",
        "x = +",
        "x = \\",
    ];
    let errors = spoilt.iter().filter_map(|text| toml::from_str::<toml::Value>(text).err());
    let said = errors.map(|error| stumbled(&error).1);
    let unknown: Vec<Text> = said.filter(|said| said.de == Text::quoted(&said.en).de || said.de == said.en).collect();
    assert_eq!(unknown, [], "not in the table");
    let deep = format!("x = {}", "[".repeat(300));
    assert!(of(&deep).de.contains("verschachtelt"), "{:?}", of(&deep));
}

#[test]
fn both_languages_go_through_a_reader_of_one() {
    #[derive(Debug)]
    struct Refused;
    impl<'de> Deserialize<'de> for Refused {
        fn deserialize<D: serde::Deserializer<'de>>(_: D) -> Result<Self, D::Error> {
            Err(in_both(&both!("no", "nein")))
        }
    }
    let error = toml::from_str::<BTreeMap<String, Refused>>("x = 1").unwrap_err();
    assert_eq!(stumbled(&error), (4, both!("no", "nein")));
    assert_eq!(said("words of tomorrow").both(), ["words of tomorrow", "\"words of tomorrow\""]);
}
