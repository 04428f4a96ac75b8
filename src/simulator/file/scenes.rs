//! What is to happen on a bench: the readings and the script of a drive, and the disturbances of the line.

use super::tables::{DisturbTable, DriveTable, EventTable};
use super::{BenchError, Reader};
use crate::profile::value::parse_decimal;
use crate::simulator::disturb::{Kind, Rule, When};
use crate::simulator::readings::{Readings, question};
use crate::simulator::script::{Action, Event, Trigger};
use crate::simulator::setup::Model;
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
        ];
        let kind = self.word("kind", &row.kind, &kinds)?;
        if let Some(by) = row.by.as_ref().filter(|_| !matches!(kind, Kind::Late(_) | Kind::Doubled(_))) {
            return Err(self.error(by.span(), "by goes only with kind = \"late\" or \"doubled\"".to_owned()));
        }
        if row.byte.is_some() && !matches!(kind, Kind::Noise(_)) {
            return Err(self.error(table.span(), "byte goes only with kind = \"noise\"".to_owned()));
        }
        let station = row.address.as_ref().map(|got| self.station(got)).transpose()?;
        Ok(Rule::new(when, kind, station))
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
