//! Texts for people, in both languages from the moment they are made. Whoever finds, refuses or asks something says it in
//! both; only who prints it picks one.
//!
//! What is the same in every language (a name, a number, a path, the words of the operating system) is a [`Text::name`].

use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Deserializer, Serialize};
use std::borrow::Cow;
use std::fmt;
use std::str::FromStr;

/// A [`Text`] of two formats. What is captured by its name in the braces is the same in both; what is another `Text` is named
/// behind them: `both!("{part} refused: {why}", "{part} abgelehnt: {why}", why)`, or `why = error.text()`.
macro_rules! both {
    ($en:literal, $de:literal $(, $name:ident $(= $value:expr)?)* $(,)?) => {
        match ($(&$crate::text::both!(@ $name $(= $value)?),)*) {
            ($($name,)*) => $crate::text::Text::formatted(
                ::std::format_args!($en $(, $name = $crate::text::Say::say($name, $crate::text::Lang::En))*),
                ::std::format_args!($de $(, $name = $crate::text::Say::say($name, $crate::text::Lang::De))*),
            ),
        }
    };
    (@ $name:ident) => { $name };
    (@ $name:ident = $value:expr) => { $value };
}
pub(crate) use both;

/// Language of names and texts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Lang {
    /// English.
    #[default]
    En,
    /// German.
    De,
}

impl Lang {
    /// Both.
    pub const ALL: [Lang; 2] = [Lang::En, Lang::De];

    /// The language of a POSIX locale name such as `de_DE.UTF-8`; English for all but German.
    pub fn of_locale(locale: &str) -> Self {
        let is_german = locale == "de" || ["de_", "de-", "de.", "de@"].iter().any(|start| locale.starts_with(start));
        if is_german { Lang::De } else { Lang::En }
    }

    /// One of two texts.
    pub fn pick<T>(self, en: T, de: T) -> T {
        match self {
            Lang::En => en,
            Lang::De => de,
        }
    }
}

impl FromStr for Lang {
    type Err = Wrong;
    fn from_str(text: &str) -> Result<Self, Wrong> {
        match text {
            "en" => Ok(Lang::En),
            "de" => Ok(Lang::De),
            _ => Err(Wrong(both!("expected en or de, got '{text}'", "erwartet: en oder de; angegeben: '{text}'"))),
        }
    }
}

/// A text in both languages. Serialised it has both, as `{"en": …, "de": …}`; `render` puts the one in its place that was
/// chosen, which is why its JSON Schema is that of a string.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Text {
    /// English.
    pub en: Cow<'static, str>,
    /// German.
    pub de: Cow<'static, str>,
}

impl Text {
    /// A text that stands in the program; `both!` makes one that is put together.
    pub const fn new(en: &'static str, de: &'static str) -> Self {
        Text { en: Cow::Borrowed(en), de: Cow::Borrowed(de) }
    }

    /// What is called so in every language: a name, a number, a path, bytes, what the operating system or a device says.
    pub fn name(name: impl fmt::Display) -> Self {
        let name = name.to_string();
        Text { en: Cow::Owned(name.clone()), de: Cow::Owned(name) }
    }

    /// What a library or the system says, which has one language: between quotation marks in the other.
    pub fn quoted(words: impl fmt::Display) -> Self {
        both!("{words}", "\"{words}\"")
    }

    /// So many of something, in each language by its name for one and for several: `1 sample`, `2 samples`.
    pub fn count(count: u64, en: [&str; 2], de: [&str; 2]) -> Self {
        let nth = usize::from(count != 1);
        let [en, de] = [en, de].map(|names| names.get(nth).copied().unwrap_or_default());
        both!("{count} {en}", "{count} {de}")
    }

    /// The text with the first place of another one in it replaced.
    pub fn replacing(&self, old: &Text, new: &Text) -> Self {
        let in_one = |text: &str, old: &str, new: &str| text.replacen(old, new, 1).into();
        Text { en: in_one(&self.en, &old.en, &new.en), de: in_one(&self.de, &old.de, &new.de) }
    }

    /// What `say` says in each language.
    pub fn by(say: impl Fn(Lang) -> String) -> Self {
        Text { en: Cow::Owned(say(Lang::En)), de: Cow::Owned(say(Lang::De)) }
    }

    /// The texts one after the other, with `between` between them.
    pub fn join<'t>(texts: impl IntoIterator<Item = &'t Text>, between: &str) -> Self {
        let texts: Vec<_> = texts.into_iter().collect();
        Text::by(|lang| texts.iter().map(|text| text.get(lang)).collect::<Vec<_>>().join(between))
    }

    /// The text in `lang`.
    pub fn get(&self, lang: Lang) -> &str {
        match lang {
            Lang::En => &self.en,
            Lang::De => &self.de,
        }
    }

    /// Both languages, English first.
    pub fn both(&self) -> [&str; 2] {
        Lang::ALL.map(|lang| self.get(lang))
    }

    /// Whether it says nothing in either language.
    pub fn is_empty(&self) -> bool {
        self.en.is_empty() && self.de.is_empty()
    }

    /// Reads a text that was printed in one language.
    pub fn as_printed<'de, D: Deserializer<'de>>(printed: D) -> Result<Self, D::Error> {
        String::deserialize(printed).map(Text::name)
    }

    /// The same of a text that may be missing.
    pub fn as_printed_or_null<'de, D: Deserializer<'de>>(printed: D) -> Result<Option<Self>, D::Error> {
        Option::<String>::deserialize(printed).map(|text| text.map(Text::name))
    }

    /// For [`both!`].
    pub(crate) fn formatted(en: fmt::Arguments<'_>, de: fmt::Arguments<'_>) -> Self {
        let one = |text: fmt::Arguments<'_>| text.as_str().map_or_else(|| text.to_string().into(), Cow::Borrowed);
        Text { en: one(en), de: one(de) }
    }
}

impl JsonSchema for Text {
    fn schema_name() -> Cow<'static, str> {
        String::schema_name()
    }
    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        String::json_schema(generator)
    }
    fn inline_schema() -> bool {
        String::inline_schema()
    }
}

/// Why something that was typed or stands in a file does not do, as an error. As such it speaks English; who prints it takes
/// the text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Wrong(pub Text);

impl fmt::Display for Wrong {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0.en)
    }
}

impl std::error::Error for Wrong {}

impl From<Wrong> for Text {
    fn from(wrong: Wrong) -> Self {
        wrong.0
    }
}

/// What can stand in a text: itself, or another text in the language of the whole.
pub trait Say {
    /// How it is shown.
    type Said<'s>: fmt::Display
    where
        Self: 's;
    /// Itself, in a language.
    fn say(&self, lang: Lang) -> Self::Said<'_>;
}

impl<T: fmt::Display + ?Sized> Say for T {
    type Said<'s>
        = &'s T
    where
        T: 's;
    fn say(&self, _lang: Lang) -> &T {
        self
    }
}

impl Say for Text {
    type Said<'s> = &'s str;
    fn say(&self, lang: Lang) -> &str {
        self.get(lang)
    }
}

impl Say for &Text {
    type Said<'s>
        = &'s str
    where
        Self: 's;
    fn say(&self, lang: Lang) -> &str {
        self.get(lang)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn locales_choose_the_language() {
        assert_eq!(Lang::of_locale("de_DE.UTF-8"), Lang::De);
        assert_eq!(Lang::of_locale("de"), Lang::De);
        assert_eq!(Lang::of_locale("den"), Lang::En);
        assert_eq!(Lang::of_locale("C"), Lang::En);
    }

    #[test]
    fn a_text_says_what_stands_in_it_in_its_own_language() {
        let (address, why) = (3, both!("silent", "stumm"));
        let text = both!("drive {address:02}: {why}, {n}", "Antrieb {address:02}: {why}, {n}", why, n = address + 1);
        assert_eq!(text.both(), ["drive 03: silent, 4", "Antrieb 03: stumm, 4"]);
        assert!(
            matches!(both!("fault", "Störung").de, Cow::Borrowed("Störung")),
            "nothing to format, nothing to allocate"
        );
        assert_eq!(Text::join([&Text::name("P.11"), &why], ": ").both(), ["P.11: silent", "P.11: stumm"]);
    }

    #[test]
    fn one_of_something_is_not_several() {
        let said = |count| Text::count(count, ["gap", "gaps"], ["Lücke", "Lücken"]);
        assert_eq!(said(1).both(), ["1 gap", "1 Lücke"]);
        assert_eq!([said(0), said(2)].map(|text| text.en), ["0 gaps", "2 gaps"]);
    }

    #[test]
    fn serialised_it_has_both_languages() {
        let text = both!("fault", "Störung");
        assert_eq!(serde_json::to_value(&text).unwrap(), serde_json::json!({"en": "fault", "de": "Störung"}));
    }
}
