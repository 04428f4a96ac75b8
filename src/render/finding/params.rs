//! `params`: rows of the catalogue, or one of them in full.

use super::page::{Page, shown};
use super::{Finding, Rows};
use crate::outcome::{Decimal, ParamDoc, Params};
use crate::profile::{Lang, cited, origin};

impl Finding for Params {
    fn table(&self, page: Page) -> String {
        match self.params.as_slice() {
            [only] => page.param(only),
            several => page.params(several),
        }
    }

    fn rows(&self) -> Rows {
        Rows::of("param", &self.params)
    }
}

/// Fields of a row that no source may have confirmed.
const FIELDS: [(&str, &str); 14] = [
    ("access", "Zugriff"),
    ("bits", "Bits"),
    ("de", "deutscher Name"),
    ("decimals", "Nachkommastellen"),
    ("default", "Werkseinstellung"),
    ("en", "englischer Name"),
    ("enum", "Texte der Werte"),
    ("max", "größter Wert"),
    ("min", "kleinster Wert"),
    ("row", "die ganze Zeile"),
    ("sets", "Datensätze"),
    ("type", "Typ"),
    ("unit", "Einheit"),
    ("volatile", "ob flüchtig"),
];

impl Page {
    fn params(self, params: &[ParamDoc]) -> String {
        let rows = params.iter().map(|param| {
            vec![
                param.param.to_string(),
                param.slug.clone(),
                self.say(&param.name),
                param.unit.clone().unwrap_or_default(),
                range(param),
                param.access.to_owned(),
                param.data_sets.map_or_else(|| "?".to_owned(), |sets| sets.to_string()),
            ]
        });
        let head = [">param", "=slug", "=name", "unit", "=range", "access", "data sets"];
        self.yielding(&head, rows.collect(), &["data sets", "access", "=range", "name", "unit"])
    }

    fn param(self, param: &ParamDoc) -> String {
        let mut rows = vec![
            ("param", param.param.to_string()),
            ("slug", param.slug.clone()),
            ("name", self.say(&param.name)),
            ("type", param.kind.unwrap_or("?").to_owned()),
            ("access", param.access.to_owned()),
            ("data sets", param.data_sets.map_or_else(|| "?".to_owned(), |sets| sets.to_string())),
        ];
        rows.extend(param.decimals.map(|decimals| ("decimals", decimals.to_string())));
        rows.extend(param.unit.iter().map(|unit| ("unit", unit.clone())));
        if param.min.is_some() || param.max.is_some() {
            rows.push(("range", range(param)));
        }
        rows.extend(param.default.map(|default| ("default", shown(default, false))));
        rows.extend(param.hazard.map(|hazard| ("hazard", self.word(hazard).to_owned())));
        rows.extend(param.module.iter().map(|module| ("module", module.clone())));
        if param.volatile {
            rows.push(("volatile", self.word("yes").to_owned()));
        }
        if param.after_reset {
            rows.push(("note", self.word("after a reset").to_owned()));
        }
        for (index, choice) in param.values.iter().enumerate() {
            rows.push((if index == 0 { "values" } else { "" }, format!("{} = {}", choice.raw, self.say(&choice.text))));
        }
        for (index, bit) in param.bits.iter().enumerate() {
            rows.push((
                if index == 0 { "bits" } else { "" },
                format!("{} {}", bit.bit, self.say_or_not(bit.name.as_ref())),
            ));
        }
        rows.extend(param.note.iter().map(|note| ("note", self.say(note))));
        if !param.unconfirmed.is_empty() {
            let fields: Vec<&str> = param.unconfirmed.iter().map(|field| self.field(field)).collect();
            rows.push(("unconfirmed", fields.join(", ")));
        }
        let [source, origin] = [cited(&param.source), origin(&param.origin)].map(|text| self.say(&text));
        rows.push(("source", if source.is_empty() { origin } else { format!("{source} ({origin})") }));
        self.pairs(rows)
    }

    /// What a field of a row is, in German; in English it is called as in a catalogue.
    fn field(self, field: &str) -> &str {
        let german = FIELDS.iter().find(|(name, _)| *name == field).filter(|_| self.lang == Lang::De);
        german.map_or(field, |(_, german)| german)
    }
}

fn range(param: &ParamDoc) -> String {
    match (param.min, param.max) {
        (None, None) => String::new(),
        (min, max) => {
            let limit = |limit: Option<Decimal>| limit.map_or_else(|| "?".to_owned(), |limit| shown(limit, false));
            format!("{} … {}", limit(min), limit(max))
        }
    }
}
