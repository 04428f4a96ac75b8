//! What is told of a `dataset load` or `dataset undo`: how it ended, what is left to do.

use crate::command::again::word;
use crate::command::{Context, terms, write};
use crate::drive::job::{self, Step};
use crate::drive::transaction::{Applied, CUTS, NOT_SHOWN, Plan, SET, STORE, THEIRS, UNDO_FILE, switch_off};
use crate::drive::{Terms, describe};
use crate::failure::{Class, Failure};
use crate::outcome::{Data, ErrorDoc, Load, LoadEnd, NotLoaded, NotLoadedWhy, Outcome, Warning, WriteResult, Written};
use crate::profile::paramfile::{Settings, ranges};
use crate::profile::{Effective, Family, Param, Role, Type};
use crate::text::{Text, both};
use std::collections::BTreeSet;
use std::path::Path;
use std::rc::Rc;

/// A load with all that is told of it.
#[derive(Debug)]
pub(in crate::command) struct Told {
    pub(in crate::command) load: Load,
    pub(in crate::command) warnings: Vec<Warning>,
    pub(in crate::command) failure: Option<Failure>,
}

impl From<Told> for Outcome {
    fn from(Told { load, warnings, failure }: Told) -> Self {
        Outcome { data: Some(Data::Load(load)), warnings, failure }
    }
}

/// A report that knows nothing yet.
pub(in crate::command) fn blank(address: u8, drive: &str, files: Vec<String>, left_out: Vec<NotLoaded>) -> Load {
    Load {
        address,
        node: 0,
        drive: drive.to_owned(),
        files,
        dry_run: false,
        ended: None,
        undo_file: None,
        eeprom_writes: 0,
        eeprom_writes_back: 0,
        restart: false,
        left_out,
        values: Vec::new(),
        closing: None,
    }
}

/// The last word of a load: how much was written, and what takes it back.
fn closing(load: &Load) -> Option<Text> {
    let written = load.values.iter().filter(|row| matches!(row.result, WriteResult::Verified | WriteResult::Stored));
    let values = Text::count(written.count() as u64, ["value", "values"], ["Wert", "Werte"]);
    let file = word(load.undo_file.as_ref()?);
    let proven = match load.ended? {
        LoadEnd::Done => both!("{values} written and proven", "{values} geschrieben und geprüft", values),
        LoadEnd::Stored => {
            both!("{values} written, not all in force", "{values} geschrieben, nicht alle wirken", values)
        }
        LoadEnd::Untouched | LoadEnd::Back | LoadEnd::Torn => return None,
    };
    Some(both!(
        "{proven}; `antrieb dataset undo {file}` takes that back",
        "{proven}; `antrieb dataset undo {file}` nimmt das zurück",
        proven
    ))
}

/// Why nothing may be begun, if so: the rows say which values are in the way.
pub(in crate::command) fn forbidden(plan: &mut Plan, so: &Text) -> Option<Failure> {
    let failure = in_the_way(std::mem::take(&mut plan.failures), so)?;
    for row in plan.job.rows.iter_mut().filter(|row| row.result == WriteResult::Planned) {
        row.result = WriteResult::Skipped;
    }
    Some(failure)
}

/// What comes of that where something was to be written.
pub(in crate::command) fn nothing_written() -> Text {
    both!("nothing was written", "es wurde nichts geschrieben")
}

/// The same where it is only looked at what would be.
pub(in crate::command) fn nothing_to_come() -> Text {
    both!("nothing would be written", "es würde nichts geschrieben")
}

/// The first of what is in the way, and how many more there are.
fn in_the_way(failures: Vec<Failure>, so: &Text) -> Option<Failure> {
    // Four data sets that stand in one line are one thing in the way.
    let count = failures.iter().map(|failure| &failure.message.en).collect::<BTreeSet<_>>().len();
    let without = without(&failures);
    let first = failures.into_iter().next()?;
    let why = first.message.clone();
    let message = match count {
        1 => both!("{why}; {so}", "{why}; {so}", why, so),
        _ => both!(
            "{why}; {more} more in the way; {so}",
            "{why}; außerdem im Weg: {more}; {so}",
            why,
            so,
            more = count - 1
        ),
    };
    let failure = Failure { message, ..first };
    Some(match without {
        Some(hint) => failure.hint(hint),
        None => failure,
    })
}

/// How to leave out all that is in the way, where that is several parameters and nothing else.
fn without(failures: &[Failure]) -> Option<Text> {
    let number = |failure: &Failure| failure.context.iter().find(|(key, _)| *key == "param")?.1.parse().ok();
    let numbers: BTreeSet<u32> = failures.iter().map(number).collect::<Option<_>>()?;
    let all = ranges(numbers.iter().copied()).replace(", ", ",");
    (numbers.len() > 1).then(|| {
        both!(
            "is it the drive, and the module, that the file was made for? --except {all} leaves them out",
            "ist es der Antrieb, und das Modul, für die die Datei gemacht wurde? --except {all} lässt sie weg"
        )
    })
}

/// The scope leaves out all that the files hold: nothing is as it was wanted, so that is no success.
pub(super) fn nothing_to_write(mut report: Load, values: &Settings) -> Outcome {
    let held = values.len();
    report.ended = Some(LoadEnd::Untouched);
    let asked: Vec<String> =
        report.left_out.iter().filter(|row| row.why == NotLoadedWhy::NotAskedFor).map(number).collect();
    let asked: BTreeSet<String> = asked.into_iter().collect();
    let asked = asked.into_iter().collect::<Vec<_>>().join(",");
    let is_left_out = |param: &Param| report.left_out.iter().any(|row| row.param == param.id);
    let is_none_a_setting = asked.is_empty() && held > 0 && values.params().all(is_left_out);
    let sent = report.left_out.iter().filter(|row| matches!(row.why, NotLoadedWhy::Command | NotLoadedWhy::Restarts));
    let sent = ranges(sent.map(|row| row.param).collect::<BTreeSet<_>>());
    let message = match held {
        0 => both!(
            "the files hold no values; nothing was written",
            "die Dateien enthalten keine Werte; geschrieben wurde nichts"
        ),
        _ if is_none_a_setting => both!(
            "nothing is left to write: what the files hold are no settings",
            "es bleibt nichts zu schreiben: was die Dateien enthalten, sind keine Einstellungen"
        ),
        1 => both!(
            "nothing is left to write: the one value of the files was not asked for",
            "es bleibt nichts zu schreiben: der eine Wert der Dateien war nicht verlangt"
        ),
        _ => both!(
            "nothing is left to write: of the {held} values of the files none was asked for",
            "es bleibt nichts zu schreiben: von den {held} Werten der Dateien war keiner verlangt"
        ),
    };
    let numbers = ranges(values.params().map(|param| param.id));
    let hint = match (held, asked.is_empty()) {
        (0, _) => both!(
            "`antrieb dataset save` writes files with values",
            "`antrieb dataset save` schreibt Dateien mit Werten"
        ),
        _ if is_none_a_setting && sent.is_empty() => {
            both!("they can only be read: {numbers}", "sie lassen sich nur lesen: {numbers}")
        }
        _ if is_none_a_setting => both!(
            "actual values, commands and setpoints are not loaded; `antrieb write` sends one by one: {sent}",
            "Istwerte, Befehle und Sollwerte werden nicht geladen; `antrieb write` sendet einzeln: {sent}"
        ),
        (_, true) => both!(
            "--only, --except and --sets pick what is written; the files hold {numbers}",
            "--only, --except und --sets wählen aus, was geschrieben wird; die Dateien enthalten {numbers}"
        ),
        _ => both!(
            "settings of a bus, and what hangs on an index, are written only if they are named: --only {asked}",
            "Einstellungen eines Busses und was an einem Index hängt werden nur geschrieben, wenn sie genannt sind: --only {asked}"
        ),
    };
    let failure = Failure::new(Class::No, "no.values", message).hint(hint);
    Outcome { data: Some(Data::Load(report)), warnings: Vec::new(), failure: Some(failure) }
}

fn number(left: &NotLoaded) -> String {
    left.param.to_string()
}

/// What would be sent, without opening anything; what `fits` refuses would end it.
pub(super) fn dry_run(
    context: &Context<'_>,
    mut report: Load,
    family: &Rc<Family>,
    steps: &[Step],
    fits: impl Fn(&Step, Option<Type>, (&Family, Option<Role>)) -> Result<(), Failure>,
) -> Result<Outcome, Failure> {
    let failures = describe_steps(&terms(context.settings, context.registry)?, &mut report, family, steps, fits);
    let failure = would_be_in_the_way(failures);
    Ok(Outcome { data: Some(Data::Load(report)), warnings: vec![write::dry_run_reads()], failure })
}

/// The rows of what would be sent; what `fits` refuses of it.
pub(in crate::command) fn describe_steps(
    terms: &Terms<'_>,
    report: &mut Load,
    family: &Rc<Family>,
    steps: &[Step],
    fits: impl Fn(&Step, Option<Type>, (&Family, Option<Role>)) -> Result<(), Failure>,
) -> Vec<Failure> {
    let mut failures = Vec::new();
    for step in steps {
        let mut row = describe::to_write(report.address, family, &step.param, step.set, step.raw);
        row.node = terms.speech.node;
        job::tell(&mut row, step.kind.and_then(|kind| job::telegram(terms, family, report.address, step, kind)));
        row.note = step.kind.is_none().then(of_width_asked);
        let here = Step { param: terms.on_line(family, &step.param), ..step.clone() };
        if let Err(failure) = fits(&here, step.kind, (family, terms.own_address())) {
            row.result = WriteResult::Refused;
            row.error = Some(ErrorDoc::from(&failure));
            failures.push(failure);
        }
        report.values.push(row);
    }
    report.dry_run = true;
    failures
}

/// Why a row has no telegram.
fn of_width_asked() -> Text {
    both!(
        "no source tells its type: the drive is asked for it first, and the telegram goes by what it tells",
        "keine Quelle nennt seinen Typ: danach wird der Antrieb zuerst gefragt, und das Telegramm richtet sich nach seiner Antwort"
    )
}

/// Why nothing would be written, if so.
pub(in crate::command) fn would_be_in_the_way(failures: Vec<Failure>) -> Option<Failure> {
    let so = nothing_to_come();
    // Nobody has asked the drive, and what it has already cuts nothing.
    let so = match failures.iter().all(|failure| failure.code == CUTS) {
        true => both!("unless the drive has it already, {so}", "es sei denn, der Antrieb hat es schon: {so}", so),
        false => so,
    };
    in_the_way(failures, &so)
}

/// The whole of it, with what takes effect later.
pub(in crate::command) fn whole(
    mut load: Load,
    plan: Plan,
    mut warnings: Vec<Warning>,
    failure: Option<Failure>,
) -> Told {
    let family = plan.job.target.family.clone();
    let rows = plan.job.steps.iter().zip(&plan.job.rows);
    let later: Vec<String> = rows
        .filter(|(step, row)| row.result == WriteResult::Verified && step.param.effective == Effective::Reset)
        .map(|(step, _)| step.param.label())
        .collect();
    load.restart = !later.is_empty();
    if load.restart {
        let labels = later.join(", ");
        let how = family.role(Role::Reset).map_or_else(Text::default, |param| {
            both!(" (restarts it: {label})", " (startet ihn neu: {label})", label = param.label())
        });
        let take = if later.len() == 1 { "takes" } else { "take" };
        let message = both!(
            "{labels} {take} effect after a restart of the drive{how}",
            "{labels}: wirkt erst nach einem Neustart des Antriebs{how}",
            how
        );
        warnings.push(Warning { code: "load.restart".to_owned(), message });
    }
    let tells = |row: &Written| matches!(row.result, WriteResult::Restored | WriteResult::Unrestored);
    let is_nothing = plan.job.rows.iter().all(|row| row.result == WriteResult::Unchanged);
    if load.ended.is_some() {
        let hidden = plan.hidden.clone();
        warnings.extend(hidden.map(|message| Warning { code: "load.in_force".to_owned(), message }));
        let unwatched = plan.unwatched().filter(|_| !is_nothing);
        warnings.extend(unwatched.map(|message| Warning { code: "load.unwatched".to_owned(), message }));
    }
    if load.ended.is_some() && (is_nothing || plan.job.rows.iter().any(tells)) {
        let open = plan.open_memory();
        warnings.extend(open.map(|message| Warning { code: "load.open_memory".to_owned(), message }));
    }
    load.values = plan.job.rows;
    load.closing = closing(&load);
    Told { load, warnings, failure }
}

/// How a transaction ended, and what to do next.
pub(in crate::command) fn applied(mut report: Load, plan: Plan, applied: Applied, left: &Path) -> Told {
    let Applied { ended, failures, notes } = applied;
    report.ended = Some(ended);
    let mut warnings: Vec<Warning> =
        notes.into_iter().map(|message| Warning { code: "load.altered".to_owned(), message }).collect();
    let is_of_ram = plan.is_of_ram();
    let is_lost = failures.iter().any(|failure| !is_of_ram && failure.context.contains(&(STORE, "ram".to_owned())));
    let places = places(failures.iter().skip(1));
    let kinds: Vec<String> = failures.iter().skip(1).map(|failure| failure.code.clone()).collect();
    let mut failures = failures.into_iter();
    let failure = failures.next().map(|first| {
        let why = first.message.clone();
        let again = match first.class {
            // Whoever ended it knows why.
            Class::Interrupted => both!("loading it again begins anew", "noch einmal laden beginnt von vorn"),
            _ => both!("mend that and load it again", "das beheben und noch einmal laden"),
        };
        match ended {
            LoadEnd::Done | LoadEnd::Untouched => unchanged(first),
            LoadEnd::Stored => Failure { message: stored(&why, failures.len() + 1), ..first },
            LoadEnd::Back => partial(
                first,
                "partial.put_back",
                both!(
                    "{why}; all that was written is as it was before",
                    "{why}; alles Geschriebene ist wie vorher",
                    why
                ),
                again,
            ),
            LoadEnd::Torn => partial(first, "partial.torn", unlike(&why, places), by_undo(left, &kinds, is_lost)),
        }
    });
    let more = failures.map(|failure| Warning { code: "load.not_put_back".to_owned(), message: failure.told() });
    warnings.extend(more);
    whole(report, plan, warnings, failure)
}

/// What takes back what did not come back; an undo file knows only what is stored.
fn by_undo(left: &Path, kinds: &[String], is_lost: bool) -> Text {
    let file = word(&left.display().to_string());
    if !kinds.is_empty() && kinds.iter().all(|code| code == NOT_SHOWN) {
        return switch_off();
    }
    if kinds.iter().any(|code| code == UNDO_FILE) {
        return behind_power(left);
    }
    if kinds.iter().any(|code| code == THEIRS) {
        return both!(
            "what somebody has changed stays: `antrieb dataset undo {file}` brings back the rest, with --force that too",
            "was jemand geändert hat, bleibt: `antrieb dataset undo {file}` holt das Übrige zurück, mit --force auch das"
        );
    }
    match is_lost {
        false => both!(
            "`antrieb dataset undo {file}` brings them back once the drive answers",
            "`antrieb dataset undo {file}` holt sie zurück, sobald der Antrieb antwortet"
        ),
        true => both!(
            "`antrieb dataset undo {file}` brings back what is stored; what the drive worked with (RAM) it only names: switching \
             the drive off and on takes it from what is stored, `antrieb write` with @1ram to @4ram sets it",
            "`antrieb dataset undo {file}` holt zurück, was gespeichert ist; womit der Antrieb arbeitete (RAM), nennt es nur: Aus- \
             und Einschalten nimmt dafür das Gespeicherte, `antrieb write` mit @1ram bis @4ram setzt es"
        ),
    }
}

/// Why a drive that has every value does not do by all of them.
fn stored(why: &Text, count: usize) -> Text {
    match count {
        1 => both!("{why}; everything is stored, proven", "{why}; gespeichert ist alles, geprüft", why),
        _ => both!(
            "{why}; everything is stored, proven, but {count} values are not in force, the rows say which",
            "{why}; gespeichert ist alles, geprüft, doch {count} Werte wirken nicht, die Zeilen sagen welche",
            why
        ),
    }
}

fn partial(first: Failure, code: &str, message: Text, hint: Text) -> Failure {
    Failure { class: Class::Partial, code: code.to_owned(), message, ..first }.hint(hint)
}

/// How taking a load back by this file ended: `theirs` is what was left as it is.
pub(super) fn undone_outcome(
    mut report: Load,
    plan: Plan,
    theirs: Vec<Failure>,
    (undone, file): (Applied, &Path),
) -> Outcome {
    let notes = plan.notes.iter().cloned();
    let mut warnings: Vec<Warning> =
        notes.map(|message| Warning { code: "load.in_force".to_owned(), message }).collect();
    let Applied { ended, failures, .. } = undone;
    let is_untouched = ended == LoadEnd::Untouched;
    report.ended = Some(if theirs.is_empty() || is_untouched { ended } else { LoadEnd::Torn });
    let (count, is_all) = (failures.len() + theirs.len(), theirs.is_empty());
    let named = places(failures.iter().chain(&theirs));
    let mut failures = failures.into_iter().chain(theirs);
    let failure = failures.next().map(|first| match is_untouched {
        true => unchanged(first),
        // Also where the last look was cut short: everything was written, and that is no mere silence.
        false if ended == LoadEnd::Stored && is_all => {
            Failure { class: Class::Partial, message: stored(&first.message, count), ..first }
        }
        false => {
            let (message, is_refused) = (unlike(&first.message, named), first.class == Class::Refused);
            let failure = Failure { class: Class::Partial, code: "partial.undo".to_owned(), message, ..first };
            if is_refused { failure.hint(once_more(file)) } else { failure }
        }
    });
    warnings.extend(failures.map(|failure| Warning { code: "load.not_put_back".to_owned(), message: failure.told() }));
    whole(report, plan, warnings, failure).into()
}

/// What brings back what a drive has refused to take back.
fn once_more(file: &Path) -> Text {
    both!(
        "the file keeps what did not come back: `antrieb dataset undo {file}` once more, when the drive takes values again",
        "die Datei behält, was nicht zurückkam: `antrieb dataset undo {file}` noch einmal, wenn der Antrieb wieder Werte annimmt",
        file = word(&file.display().to_string())
    )
}

/// The same where the file could not keep it: what is stored shows once the RAM is gone.
fn behind_power(file: &Path) -> Text {
    both!(
        "the file could not keep that: switch the drive off and on, so that it tells what is stored, then `antrieb dataset undo {file}`",
        "die Datei konnte das nicht behalten: den Antrieb aus- und einschalten, damit er das Gespeicherte zeigt, dann `antrieb dataset \
         undo {file}`",
        file = word(&file.display().to_string())
    )
}

/// Why not everything is as it was, and the file that takes it back later.
pub(in crate::command) fn not_all_back(failures: Vec<Failure>, file: &Path) -> Option<Failure> {
    let count = places(failures.iter());
    let is_kept = failures.iter().all(|failure| failure.code != UNDO_FILE);
    let first = failures.into_iter().next()?;
    let message = unlike(&first.message, count);
    let failure = Failure { class: Class::Partial, code: "partial.undo".to_owned(), message, ..first };
    Some(failure.hint(if is_kept { once_more(file) } else { behind_power(file) }))
}

fn unchanged(failure: Failure) -> Failure {
    let why = failure.message;
    Failure { message: both!("{why}; nothing was changed", "{why}; es wurde nichts geändert", why), ..failure }
}

/// How many values failures are about: of one, what is stored and what is in force may each be named. A file is none.
fn places<'f>(failures: impl Iterator<Item = &'f Failure>) -> usize {
    let fact = |failure: &Failure, name| failure.context.iter().find(|(key, _)| *key == name).map(|(_, it)| it.clone());
    let of = |(nth, failure): (usize, &Failure)| match (fact(failure, "param"), fact(failure, SET)) {
        (Some(param), Some(set)) => (param, set),
        _ => (String::new(), nth.to_string()),
    };
    failures.filter(|failure| failure.code != UNDO_FILE).enumerate().map(of).collect::<BTreeSet<_>>().len()
}

fn unlike(why: &Text, count: usize) -> Text {
    match count {
        1 => both!(
            "{why}; 1 value may not be as before, the rows say which",
            "{why}; 1 Wert ist vielleicht nicht wie vorher, die Zeilen sagen welcher",
            why
        ),
        _ => both!(
            "{why}; {count} values may not be as before, the rows say which",
            "{why}; {count} Werte sind vielleicht nicht wie vorher, die Zeilen sagen welche",
            why
        ),
    }
}
