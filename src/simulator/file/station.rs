//! What a bench file says of a station, whatever stands behind it: its times, its script, the readings of its manuals.

use super::reader::{BenchFile, Model, quoted};
use super::tables::{DriveTable, EventTable};
use crate::profile::Broken;
use crate::profile::value::parse_decimal;
use crate::simulator::device::readings::{Reading, Readings};
use crate::simulator::station::script::Trigger;
use crate::simulator::station::setup::REPLY_DELAY;
use crate::text::both;
use crate::tick::{Span, Tick};
use toml::Spanned;

/// Reply time under high load: any time above 500 ms (CM-485 manual 6.8).
const SLOW: Span = Span::from_millis(700);
impl BenchFile<'_> {
    pub(crate) fn delay(&self, row: &DriveTable) -> Result<Span, Broken> {
        if let Some(slow) = &row.slow {
            return self.time("slow", slow);
        }
        let high = row.load.as_ref().map(|got| self.word("load", got, &[("normal", false), ("high", true)]));
        match high.transpose()? {
            Some(true) => Ok(SLOW),
            _ => self.time_or("reply_delay", row.reply_delay.as_ref(), REPLY_DELAY),
        }
    }

    /// What a drive makes of the questions that its manuals leave open.
    pub(crate) fn readings<R: Reading>(&self, row: &DriveTable, model: Model) -> Result<Readings<R>, Broken> {
        let mut readings = Readings::default();
        for (key, word) in &row.readings {
            let message = || {
                both!(
                    "readings: an {model} has no question \"{key}\"",
                    "readings: ein {model} hat keine Frage \"{key}\"",
                    model = model.name()
                )
            };
            let question = R::question(key).filter(|_| model != Model::Foreign);
            let question = question.ok_or_else(|| self.error(word.span(), message()))?;
            if let Some(reading) = self.word(key, word, question.words)? {
                readings.add(reading);
            }
        }
        Ok(readings)
    }

    pub(crate) fn trigger(&self, table: &Spanned<EventTable>) -> Result<Trigger, Broken> {
        let row = table.get_ref();
        match (&row.at, &row.when, &row.after_writes, &row.after_telegrams) {
            (Some(at), None, None, None) => Ok(Trigger::At(Tick::ZERO + self.time("at", at)?)),
            (None, Some(when), None, None) => condition(when.get_ref()).ok_or_else(|| {
                let expected = both!("\"running\" or \"above 20Hz\"", "\"running\" oder \"above 20Hz\"");
                self.unfit("when", when.span(), &quoted(when), &expected)
            }),
            (None, None, Some(writes), None) => Ok(Trigger::Writes(self.count(writes)?)),
            (None, None, None, Some(count)) => Ok(Trigger::Telegrams(self.count(count)?)),
            _ => {
                let message = both!(
                    "expected exactly one of: at, when, after_writes, after_telegrams",
                    "erwartet wird genau eines von: at, when, after_writes, after_telegrams"
                );
                Err(self.error(table.span(), message))
            }
        }
    }
}

/// Reads `running`, `above 20Hz`.
fn condition(text: &str) -> Option<Trigger> {
    if text.trim() == "running" {
        return Some(Trigger::Running);
    }
    let limit = text.trim().strip_prefix("above")?.strip_suffix("Hz")?;
    let limit = parse_decimal(limit.trim(), 2).ok().filter(|&limit| limit >= 0)?;
    Some(Trigger::Above(limit))
}
