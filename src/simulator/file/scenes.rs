//! What is to happen on a bench: the readings and the script of a drive, and the disturbances of the line.

use super::tables::{DisturbTable, DriveTable, EventTable};
use super::{BenchError, Reader};
use crate::profile::value::parse_decimal;
use crate::simulator::babble::{Babbler, Pattern};
use crate::simulator::disturb::{Kind, Rule, When};
use crate::simulator::readings::{Readings, question};
use crate::simulator::script::{Action, Event, Trigger};
use crate::simulator::setup::{Model, Spoken};
use crate::tick::{Span, Tick};
use toml::Spanned;

impl Reader<'_> {
    /// What a drive makes of the questions that the manuals leave open.
    pub(super) fn readings(&self, row: &DriveTable, model: Model) -> Result<Readings, BenchError> {
        let mut readings = Readings::default();
        for (key, word) in &row.readings {
            let message = || format!("readings: an {} has no question \"{key}\"", model.name());
            let question = question(key, model).ok_or_else(|| self.error(word.span(), message()))?;
            if let Some(reading) = self.word(key, word, question.words)? {
                readings.add(reading);
            }
        }
        Ok(readings)
    }

    pub(super) fn event(
        &self,
        table: &Spanned<EventTable>,
        model: Model,
        script: &mut Vec<Event>,
    ) -> Result<(), BenchError> {
        let row = table.get_ref();
        let trigger = self.trigger(table)?;
        if model == Model::Lxm05 {
            let actions = self.servo_actions(table)?;
            script.extend(actions.into_iter().map(|action| Event { trigger, action, lasts: None }));
            return Ok(());
        }
        if row.class.is_some() || row.qualifier.is_some() {
            return Err(self.error(table.span(), "class and qualifier are for model lxm05".to_owned()));
        }
        let mut actions = Vec::new();
        if let Some(fault) = &row.fault {
            actions.push(Action::Fault(self.fault(fault)?));
        }
        actions.extend(row.warning.map(Action::Warning));
        if let Some(silent) = &row.silent {
            actions.push(Action::Silent(self.time("silent", silent)?));
        }
        actions.extend(row.power_cycle.filter(|&cycle| cycle).map(|_| Action::PowerCycle));
        actions.extend(row.mains.map(Action::Mains));
        actions.extend(row.enable.into_iter().flat_map(|on| match model {
            Model::Acu => vec![Action::StoA(on), Action::StoB(on)],
            _ => vec![Action::StoA(on)],
        }));
        for (sto, action) in [(&row.stoa, Action::StoA as fn(bool) -> Action), (&row.stob, Action::StoB)] {
            let Some(sto) = sto else { continue };
            self.check_sto(sto, model)?;
            actions.push(action(*sto.get_ref()));
        }
        actions.extend(row.start_right.map(Action::StartRight));
        actions.extend(row.start_left.map(Action::StartLeft));
        if let Some(torque) = &row.torque {
            actions.push(Action::Torque(self.torque(torque)?));
        }
        if actions.is_empty() {
            let message = "nothing happens in this event; expected fault, warning, power_cycle, silent, mains, enable, \
                           stoa, stob, start_right, start_left or torque";
            return Err(self.error(table.span(), message.to_owned()));
        }
        let lasts = row.lasts.as_ref().map(|got| self.time("for", got)).transpose()?;
        if let Some(got) = row.lasts.as_ref().filter(|_| actions.iter().any(|action| action.opposite().is_none())) {
            let message = "for goes only with mains, enable, stoa, stob, start_right, start_left";
            return Err(self.error(got.span(), message.to_owned()));
        }
        script.extend(actions.into_iter().map(|action| Event { trigger, action, lasts }));
        Ok(())
    }

    fn trigger(&self, table: &Spanned<EventTable>) -> Result<Trigger, BenchError> {
        let row = table.get_ref();
        match (&row.at, &row.when, &row.after_writes, &row.after_telegrams) {
            (Some(at), None, None, None) => Ok(Trigger::At(Tick::ZERO + self.time("at", at)?)),
            (None, Some(when), None, None) => condition(when.get_ref()).ok_or_else(|| {
                let message = format!("when = \"{}\"; expected \"running\" or \"above 20Hz\"", when.get_ref());
                self.error(when.span(), message)
            }),
            (None, None, Some(writes), None) => Ok(Trigger::Writes(self.count(writes)?)),
            (None, None, None, Some(count)) => Ok(Trigger::Telegrams(self.count(count)?)),
            _ => {
                let message = "expected exactly one of: at, when, after_writes, after_telegrams";
                Err(self.error(table.span(), message.to_owned()))
            }
        }
    }

    fn fault(&self, got: &Spanned<String>) -> Result<u16, BenchError> {
        let digits = got.get_ref().strip_prefix('F').filter(|digits| digits.len() == 4);
        let code = digits.and_then(|digits| u16::from_str_radix(digits, 16).ok()).filter(|&code| code != 0);
        let message = || format!("fault = \"{}\"; expected F and 4 digits, such as \"F0500\"", got.get_ref());
        code.ok_or_else(|| self.error(got.span(), message()))
    }

    fn count(&self, got: &Spanned<u64>) -> Result<u64, BenchError> {
        match *got.get_ref() {
            0 => Err(self.error(got.span(), "0 hits nothing; expected 1 or more".to_owned())),
            count => Ok(count),
        }
    }

    /// Somebody who speaks unasked; `None` if the table is about replies.
    pub(super) fn babbler(&self, table: &Spanned<DisturbTable>, spoken: Spoken) -> Result<Option<Babbler>, BenchError> {
        let row = table.get_ref();
        if row.kind.get_ref() != "babble" {
            return Ok(None);
        }
        if row.every.is_some() || row.once.is_some() || row.byte.is_some() || row.address.is_some() {
            let message = "babble goes only with at, by, for and pattern";
            return Err(self.error(table.span(), message.to_owned()));
        }
        let pattern = match row.pattern.as_ref() {
            None => Pattern::Bytes(vec![0x55]),
            Some(got) => pattern(got.get_ref(), spoken).ok_or_else(|| {
                let message = "expected random, digits, master, or bytes in hex such as \"55 AA\"";
                self.error(got.span(), format!("pattern = \"{}\"; {message}", got.get_ref()))
            })?,
        };
        let from = Tick::ZERO + self.time_or("at", row.at.as_ref(), Span::ZERO)?;
        let pause = self.time_or("by", row.by.as_ref(), BABBLE_PAUSE)?;
        let lasts = row.lasts.as_ref().map(|got| self.time("for", got)).transpose()?;
        Ok(Some(Babbler::new(pattern, from, pause, lasts)))
    }

    pub(super) fn rule(&self, table: &Spanned<DisturbTable>) -> Result<Rule, BenchError> {
        let row = table.get_ref();
        let when = match (&row.every, &row.once, &row.at) {
            (Some(every), None, None) => When::Every(self.count(every)?),
            (None, Some(once), None) => When::Once(self.count(once)?),
            (None, None, Some(at)) => When::From(Tick::ZERO + self.time("at", at)?),
            _ => return Err(self.error(table.span(), "expected exactly one of: every, once, at".to_owned())),
        };
        let by = self.time_or("by", row.by.as_ref(), Span::from_millis(150))?;
        let kinds = [
            ("late", Kind::Late(by)),
            ("lost", Kind::Lost),
            ("garbled", Kind::Garbled),
            ("truncated", Kind::Truncated),
            ("noise", Kind::Noise(row.byte.unwrap_or(0))),
            ("echo", Kind::Echo),
            ("doubled", Kind::Doubled(row.by.as_ref().map(|_| by))),
            ("foreign", Kind::Foreign),
            ("twin", Kind::Twin(row.by.as_ref().map_or(TWIN_PAUSE, |_| by))),
        ];
        let kind = self.word("kind", &row.kind, &kinds)?;
        if let Some(by) = row.by.as_ref().filter(|_| !matches!(kind, Kind::Late(_) | Kind::Doubled(_) | Kind::Twin(_)))
        {
            return Err(self.error(
                by.span(),
                "by goes only with kind = \"late\", \"doubled\", \"twin\" or \"babble\"".to_owned(),
            ));
        }
        if row.byte.is_some() && !matches!(kind, Kind::Noise(_)) {
            return Err(self.error(table.span(), "byte goes only with kind = \"noise\"".to_owned()));
        }
        if let Some(got) = row.pattern.as_ref().or(row.lasts.as_ref()) {
            return Err(self.error(got.span(), "pattern and for go only with kind = \"babble\"".to_owned()));
        }
        let station = row.address.as_ref().map(|got| self.station(got)).transpose()?;
        Ok(Rule::new(when, kind, station))
    }
}

/// A second drive answers so long after the first, as one does that is set the same and a little slower.
const TWIN_PAUSE: Span = Span::from_millis(5);
/// An adapter with a wrong rate delivers a byte every 20 ms (docs/open-points.md).
const BABBLE_PAUSE: Span = Span::from_millis(20);
/// Longest pattern of bytes.
const MOST_PATTERN: usize = 256;

/// Reads `random`, `digits`, `master`, `55 AA`.
fn pattern(text: &str, spoken: Spoken) -> Option<Pattern> {
    match text {
        "random" => return Some(Pattern::Random),
        "digits" => return Some(Pattern::Digits),
        "master" => return Some(Pattern::Master(spoken)),
        _ => {}
    }
    let byte = |word: &str| u8::from_str_radix(word, 16).ok().filter(|_| word.len() == 2);
    let bytes: Vec<u8> = text.split_whitespace().map(byte).collect::<Option<_>>()?;
    (1..=MOST_PATTERN).contains(&bytes.len()).then_some(Pattern::Bytes(bytes))
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
