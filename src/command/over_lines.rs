//! A verb over drives that lie on several lines: on each as if its drives alone were meant, and what came of it told as one.

use super::Context;
use super::lines::{Nobody, OverLines, one_recording, port, side_by_side};
use super::verb::Typed;
use crate::args::{Settings, called};
use crate::failure::{Class, Failure};
use crate::outcome::{Data, ErrorDoc, OnLine, Outcome, OverLines as Found, Unreached, Warning};
use crate::text::{Text, both};
use std::collections::BTreeMap;

/// Runs a verb: where its drives lie on several lines and it takes each by itself, on all of them.
///
/// # Errors
/// As the verb.
pub async fn run(verb: &dyn Typed, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let settings = context.settings;
    if settings.lines.is_empty() || verb.over_lines() != OverLines::Each {
        return verb.run(context).await;
    }
    one_recording(settings, settings.lines.len())?;
    let names = settings.lines.iter().map(called).collect::<Result<Vec<_>, _>>()?;
    let Context { registry, observe, interrupt, sheet, .. } = context;
    let (registry, interrupt, sheet) = (*registry, &*interrupt, *sheet);
    let came = side_by_side(&settings.lines, *observe, async |line, observe| {
        spoken(line)?;
        let mut ask = Nobody;
        let interrupt = interrupt.clone();
        verb.run(&mut Context { settings: line, registry, ask: &mut ask, observe, interrupt, sheet, calls: None }).await
    });
    let came = came.await;
    if let Some(failure) = alike(&came) {
        return Err(failure);
    }
    let mut all = All::default();
    for ((line, names), came) in settings.lines.iter().zip(names).zip(came) {
        all.take(line, names, came.unwrap_or_else(Outcome::from));
    }
    Ok(all.told())
}

/// Whoever takes a slave of PROFIBUS is asked about that one.
fn spoken(line: &Settings) -> Result<(), Failure> {
    if !line.profibus {
        return Ok(());
    }
    let message = both!(
        "nothing was sent: over PROFIBUS it is one call for each line",
        "es wurde nichts gesendet: über PROFIBUS ist es ein Aufruf für jede Leitung"
    );
    Err(Failure::new(Class::Usage, "usage.protocol", message))
}

/// What every line says alike, and none more: it is of what was typed.
fn alike(came: &[Result<Outcome, Failure>]) -> Option<Failure> {
    let first = came.first()?.as_ref().err()?;
    let is_same = |came: &Result<Outcome, Failure>| came.as_ref().is_err_and(|failure| failure == first);
    let is_typed = matches!(first.class, Class::Usage | Class::Data);
    (is_typed && came.iter().all(is_same)).then(|| first.clone())
}

/// What came of the lines so far.
#[derive(Debug, Default)]
struct All {
    lines: Vec<OnLine>,
    unreached: Vec<Unreached>,
    warnings: Vec<Warning>,
    failures: Vec<Failure>,
    /// Lines of which at least something came.
    good: usize,
}

impl All {
    fn take(&mut self, line: &Settings, names: BTreeMap<u8, String>, came: Outcome) {
        let (port, Outcome { mut data, warnings, failure }) = (port(line), came);
        self.good += usize::from(failure.as_ref().is_none_or(|it| matches!(it.class, Class::No | Class::Partial)));
        if let (Some(Data::Dataset(one)), Some(failure)) = (&mut data, &failure) {
            one.error.get_or_insert(ErrorDoc::from(failure));
        }
        let found = data.map(|data| OnLine { port: port.clone(), names: names.clone(), data });
        if let Some(failure) = &failure {
            let told = found.as_ref().map(OnLine::addresses).unwrap_or_default();
            for (address, called) in names.into_iter().filter(|(address, _)| !told.contains(address)) {
                if line.addresses.named().contains(&address) {
                    self.unreached.push(Unreached { called, port: port.clone(), address, error: failure.into() });
                }
            }
        }
        self.lines.extend(found);
        self.warnings.extend(warnings.into_iter().map(|Warning { code, message }| Warning {
            code,
            message: both!("{port}: {message}", "{port}: {message}", message),
        }));
        let of_port = |why| both!("{port}: {why}", "{port}: {why}", why);
        self.failures.extend(failure.map(|failure| failure.within(of_port)));
    }

    fn told(self) -> Outcome {
        let All { lines, unreached, warnings, failures, good } = self;
        let failure = summed_up(failures, good);
        let data = (!lines.is_empty()).then_some(Data::OverLines(Found { lines, unreached }));
        Outcome { data, warnings, failure }
    }
}

/// Why not all of it is as it was wanted: that something differs is told only where all could be asked, and each line is named with its reason.
fn summed_up(failures: Vec<Failure>, good: usize) -> Option<Failure> {
    if let Some(interrupted) = failures.iter().find(|failure| failure.class == Class::Interrupted) {
        return Some(interrupted.clone());
    }
    let is_broken = failures.iter().any(|failure| failure.class != Class::No);
    let told: Vec<Failure> = failures.into_iter().filter(|failure| !is_broken || failure.class != Class::No).collect();
    let message = Text::join(&told.iter().map(|failure| failure.message.clone()).collect::<Vec<_>>(), "; ");
    let first = Failure { message, ..told.into_iter().next()? };
    Some(match is_broken && good > 0 {
        true => Failure { class: Class::Partial, code: "partial".to_owned(), ..first },
        false => first,
    })
}
