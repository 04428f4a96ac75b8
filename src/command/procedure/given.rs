//! What a procedure must know from elsewhere: KEY=VALUE on the command line, or a TOML file.

use super::Args;
use crate::args::{Settings, in_directory};
use crate::drive::motion::{watchdog_raw, watchdog_seconds};
use crate::failure::{Class, Failure};
use crate::files;
use crate::outcome::{GivenValue, ProcedureRecord};
use crate::profile::procedure::Procedure;
use crate::profile::value::format_decimal;
use crate::profile::{Family, stumbled};
use crate::text::{Text, both};
use crate::tick::Span;
use std::collections::BTreeMap;

/// Values by their names, as they were typed.
#[derive(Debug, Default)]
pub(super) struct Given(BTreeMap<String, String>);

impl Given {
    /// What was typed, and what stands in the file; what was typed holds. Where neither says anything, what it was begun with.
    ///
    /// # Errors
    /// A file that cannot be read, a name that the procedure does not know, or one that it must have is missing.
    pub(super) fn of(
        args: &Args,
        procedure: &Procedure,
        settings: &Settings,
        kept: Option<&ProcedureRecord>,
    ) -> Result<Self, Failure> {
        let mut values = BTreeMap::new();
        if let (Some(kept), true, None) = (kept, args.values.is_empty(), &args.given) {
            values = kept.given.iter().map(|row| (row.key.clone(), row.value.clone())).collect();
        }
        if let Some(file) = &args.given {
            values = read(&in_directory(settings, file))?;
        }
        for word in &args.values {
            let (key, value) = word.split_once('=').ok_or_else(|| {
                let message = both!("expected KEY=VALUE, got '{word}'", "erwartet: NAME=WERT; angegeben: '{word}'");
                Failure::new(Class::Usage, "usage.value", message).hint(known(procedure))
            })?;
            values.insert(key.trim().to_owned(), value.trim().to_owned());
        }
        let is_known = |key: &String| procedure.values.iter().any(|value| &value.key == key);
        if let Some(key) = values.keys().find(|key| !is_known(key)) {
            let message =
                both!("{name} knows no value '{key}'", "{name} kennt keinen Wert '{key}'", name = procedure.slug);
            return Err(Failure::new(Class::Usage, "usage.value", message).hint(known(procedure)));
        }
        let missing = procedure.values.iter().filter(|value| !value.optional && !values.contains_key(&value.key));
        let missing: Vec<Text> = missing.map(|value| named(&value.key, &value.what)).collect();
        if !missing.is_empty() {
            let missing = Text::join(&missing, "; ");
            let message = both!(
                "what must be known is missing: {missing}",
                "es fehlt, was bekannt sein muss: {missing}",
                missing
            );
            return Err(Failure::new(Class::Usage, "usage.value", message).hint(both!(
                "type it behind the name, as KEY=VALUE, or take it from a file with --given",
                "hinter dem Namen als NAME=WERT angeben, oder mit --given aus einer Datei nehmen"
            )));
        }
        Ok(Given(values))
    }

    /// A value as it was typed.
    pub(super) fn get(&self, key: &str) -> Option<&str> {
        self.0.get(key).map(String::as_str)
    }

    /// A time.
    ///
    /// # Errors
    /// It is none.
    pub(super) fn span(&self, key: &str) -> Result<Option<Span>, Failure> {
        let span = self.get(key).map(crate::args::parse_span).transpose();
        span.map_err(|why| bad(key, &Text::from(why)))
    }

    /// All of it, for the record.
    pub(super) fn told(&self) -> Vec<GivenValue> {
        self.0.iter().map(|(key, value)| GivenValue { key: key.clone(), value: value.clone() }).collect()
    }

    /// Refuses what the drive cannot take, before anything is opened.
    ///
    /// # Errors
    /// A value that does not do.
    pub(super) fn fit(&self, family: &Family) -> Result<(), Failure> {
        let Some(span) = self.span("watchdog")? else { return Ok(()) };
        let raw = watchdog_raw(family, span)?;
        let told = watchdog_seconds(family, raw);
        // 0 is no watchdog (CM-485 manual 6.9), and what the drive cannot hold exactly would not be what the record says.
        let is_exact = told.raw * 10i64.pow(6 - u32::from(told.decimals)) == span.as_micros() as i64;
        if span > Span::ZERO && is_exact {
            return Ok(());
        }
        let (text, least) = (self.get("watchdog").unwrap_or_default(), format_decimal(1, told.decimals));
        Err(bad(
            "watchdog",
            &both!(
                "expected a whole multiple of {least} s above 0, got '{text}' (0 would be no watchdog)",
                "erwartet wird ein ganzes Vielfaches von {least} s über 0; angegeben: '{text}' (0 wäre kein Watchdog)"
            ),
        ))
    }
}

/// The failure of a value that does not do.
pub(super) fn bad(key: &str, why: &Text) -> Failure {
    Failure::new(Class::Data, "data.value", both!("{key}: {why}", "{key}: {why}", why))
}

fn known(procedure: &Procedure) -> Text {
    let told: Vec<Text> = procedure.values.iter().map(|value| named(&value.key, &value.what)).collect();
    match told.is_empty() {
        true => both!("it needs none", "sie braucht keinen"),
        false => Text::join(&told, "; "),
    }
}

fn named(key: &str, what: &Text) -> Text {
    both!("{key} ({what})", "{key} ({what})", what)
}

/// Values of a file: texts and numbers, by their names.
fn read(path: &std::path::Path) -> Result<BTreeMap<String, String>, Failure> {
    let broken = |why: &Text| {
        let message = both!("{file}: {why}", "{file}: {why}", file = path.display(), why);
        Failure::new(Class::Data, "data.given", message)
    };
    let text = files::read(path, files::TEXT).map_err(|error| broken(&error.text()))?;
    let table: BTreeMap<String, toml::Value> = toml::from_str(&text).map_err(|error| broken(&stumbled(&error).1))?;
    let plain = |(key, value): (String, toml::Value)| match value {
        toml::Value::String(text) => Ok((key, text)),
        toml::Value::Integer(_) | toml::Value::Float(_) => Ok((key, value.to_string())),
        _ => Err(broken(&both!("{key}: expected a text or a number", "{key}: erwartet wird ein Text oder eine Zahl"))),
    };
    table.into_iter().map(plain).collect()
}
