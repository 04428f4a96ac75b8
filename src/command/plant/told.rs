//! What is told of a plant: each drive with what became of it, and how all of it ended.

use super::lines::Wanted;
use super::project;
use crate::command::again::for_drive;
use crate::command::dataset::loaded::{self, blank};
use crate::drive::plant::{Done, Found, Line, Member};
use crate::failure::{Class, Failure};
use crate::outcome::{Data, ErrorDoc, LoadEnd, Outcome, Plant, PlantDrive, PlantState, Warning};
use crate::text::{Text, both};

/// What became of every drive.
pub(super) fn plant(wanted: &[Wanted], lines: &mut [Line<'_>], (is_over, rest): (bool, Are)) -> Outcome {
    let members = lines.iter_mut().flat_map(|line| line.members.drain(..));
    let (mut drives, mut warnings, mut failures) = (Vec::new(), Vec::new(), Vec::new());
    let mut is_any_seen = false;
    for (one, member) in wanted.iter().zip(members) {
        let is_seen = member.found.is_some();
        let (state, mut told) = tell(one, member);
        is_any_seen |= is_seen && told.failure.is_some();
        told.failure = told.failure.map(|failure| hinted(one, failure));
        let told_of = one.doubts().into_iter().chain(told.warnings);
        warnings.extend(told_of.map(|warning| of(one, warning)));
        let closing = told.load.closing.map(|text| named(one, &text));
        told.load.closing = closing;
        let (called, port, error) = (one.place.name.clone(), one.port(), told.failure.as_ref().map(ErrorDoc::from));
        failures.extend(told.failure.map(|failure| (called.clone(), failure)));
        drives.push(PlantDrive { called, port, state, load: told.load, error });
    }
    let of = |state| drives.iter().any(|row| row.state == state);
    let (is_torn, is_back) = (of(PlantState::Torn), of(PlantState::Back));
    // A drive that failed itself says so of all that was written.
    let tells = |row: &PlantDrive| row.error.as_ref().is_some_and(|error| error.code == "partial.put_back");
    let adds = is_back && !drives.iter().any(tells);
    let rest = if is_any_seen { rest } else { UNSEEN };
    let failure = summary(failures, drives.len(), (is_torn || is_back, rest)).map(|failure| Failure {
        message: if adds && drives.len() > 1 { written_and_back(&failure.message, &drives) } else { failure.message },
        ..failure
    });
    let failure = match (failure, would_change(&drives)) {
        (Some(failure), Some(some)) => Some(beside(failure, &some)),
        (None, Some(some)) => Some(not_yet(some)),
        (failure, None) => failure,
    };
    let failure = failure.map(|failure| if is_over { interrupted(failure) } else { failure });
    Outcome { data: Some(Data::Plant(Plant { project: project(wanted), dry_run: false, drives })), warnings, failure }
}

/// A warning with the drive that it is about.
pub(super) fn of(one: &Wanted, warning: Warning) -> Warning {
    let Warning { code, message } = warning;
    Warning { code, message: named(one, &message) }
}

/// What is told of a drive, with its name.
fn named(one: &Wanted, told: &Text) -> Text {
    let told = for_drive(told, &one.typed(), &one.port());
    both!("{name}: {told}", "{name}: {told}", name = one.place.name, told)
}

/// A failure whose hint is for the drive that it is about.
pub(super) fn hinted(one: &Wanted, failure: Failure) -> Failure {
    let hint = failure.hint.as_deref().map(|hint| Box::new(for_drive(hint, &one.typed(), &one.port())));
    Failure { hint, ..failure }
}

/// How a drive stands, and all that is told of it.
fn tell(one: &Wanted, member: Member<'_>) -> (PlantState, loaded::Told) {
    let Member { found, left, applied, .. } = member;
    let drive = left.as_ref().map_or("unknown", Failure::family);
    let mut load = blank(one.place.address, drive, one.files(), one.left_out.clone());
    load.node = one.place.settings.node;
    let Some(Found { plan, .. }) = found else {
        return (PlantState::Skipped, loaded::Told { load, warnings: Vec::new(), failure: left });
    };
    load.drive = plan.job.target.family.drive.clone();
    (load.eeprom_writes, load.eeprom_writes_back) = (plan.eeprom_writes, plan.eeprom_writes_back);
    let Some(Done { applied, undo_file, taken_back }) = applied else {
        let state = match (&left, plan.todo()) {
            (Some(_), _) => PlantState::Skipped,
            (None, 0) => PlantState::Same,
            (None, _) => PlantState::Planned,
        };
        return (state, loaded::whole(load, plan, Vec::new(), left));
    };
    let undo_file = undo_file.map(|left| left.path().to_owned());
    load.undo_file = undo_file.as_ref().map(|file| file.display().to_string());
    let state = match applied.ended {
        LoadEnd::Done => PlantState::Done,
        LoadEnd::Stored => PlantState::Stored,
        LoadEnd::Untouched => PlantState::Untouched,
        LoadEnd::Back => PlantState::Back,
        LoadEnd::Torn => PlantState::Torn,
    };
    let undo_file = undo_file.unwrap_or_default();
    let mut told = loaded::applied(load, plan, applied, &undo_file);
    match taken_back {
        None => (state, told),
        Some(back) if back.is_empty() => {
            told.load.ended = Some(LoadEnd::Back);
            told.load.closing = None;
            told.failure = Some(put_back());
            (PlantState::Back, told)
        }
        Some(back) => {
            told.load.ended = Some(LoadEnd::Torn);
            told.load.closing = None;
            told.failure = loaded::not_all_back(back, &undo_file);
            (PlantState::Torn, told)
        }
    }
}

fn put_back() -> Failure {
    let message = both!(
        "taken back because another drive failed (--atomic); all that was written is as it was before",
        "zurückgenommen, weil ein anderer Antrieb gescheitert ist (--atomic); alles Geschriebene ist wie vorher"
    );
    Failure::new(Class::Partial, "partial.taken_back", message)
}

/// Nobody shall believe of a plant that nothing was written to it, because of its last drive.
fn written_and_back(why: &Text, drives: &[PlantDrive]) -> Text {
    let back = drives.iter().filter(|row| row.state == PlantState::Back).map(|row| row.called.as_str());
    let names = back.collect::<Vec<_>>().join(", ");
    both!("{why}; written to and as before again: {names}", "{why}; beschrieben und wieder wie vorher: {names}", why)
}

/// How some drives are: of one, and of several, in each language.
#[derive(Clone, Copy, Debug)]
pub(super) struct Are {
    en: [&'static str; 2],
    de: [&'static str; 2],
}

const SILENT: Are = Are { en: ["did not answer"; 2], de: ["antwortet nicht", "antworten nicht"] };
const UNSEEN: Are =
    Are { en: ["could not be looked at"; 2], de: ["ließ sich nicht ansehen", "ließen sich nicht ansehen"] };
/// Behind an attempt to write.
pub(super) const UNLIKE: Are = Are {
    en: ["is not as it shall be", "are not as they shall be"],
    de: ["ist nicht, wie er sein soll", "sind nicht, wie sie sein sollen"],
};
/// Before one: nobody knows how they are, or nothing may be written to them.
pub(super) const LEFT_OUT: Are =
    Are { en: ["would be left out"; 2], de: ["würde ausgelassen", "würden ausgelassen"] };
/// Held against their files.
pub(super) const UNCOMPARED: Are = Are {
    en: ["could not be compared whole"; 2],
    de: ["ließ sich nicht ganz vergleichen", "ließen sich nicht ganz vergleichen"],
};

impl Are {
    fn text(&self, count: usize) -> Text {
        let nth = usize::from(count != 1);
        let [en, de] = [self.en, self.de].map(|said| said.get(nth).copied().unwrap_or_default());
        Text::new(en, de)
    }
}

/// A failure, and what is to be said beside it.
pub(super) fn beside(failure: Failure, some: &Text) -> Failure {
    Failure { message: both!("{why}; {some}", "{why}; {some}", why = failure.message, some), ..failure }
}

/// Why not every drive is as it shall be: the names of those that are not, how they are, and the first reason.
pub(super) fn summary(
    failures: Vec<(String, Failure)>,
    drives: usize,
    (is_torn, rest): (bool, Are),
) -> Option<Failure> {
    let count = failures.len();
    let names: Vec<&str> = failures.iter().map(|(name, _)| name.as_str()).collect();
    let names = names.join(", ");
    // Of who is silent, or is another one, nobody knows how he is.
    let all = |holds: &dyn Fn(&Failure) -> bool| failures.iter().all(|(_, failure)| holds(failure));
    let is_silent = |failure: &Failure| failure.class == Class::Silence;
    let others = ["data.unknown_drive", "data.other_family", "data.other_drive"];
    let is_another = |failure: &Failure| is_silent(failure) || others.contains(&failure.code.as_str());
    let are = match (all(&is_silent), all(&is_another)) {
        (true, _) => SILENT,
        (_, true) => UNSEEN,
        _ => rest,
    };
    let are = are.text(count);
    let end = failures.iter().position(|(_, failure)| failure.class == Class::Interrupted);
    // What was left out only because of another one is no reason.
    let is_cause = |failure: &Failure| !["forbidden.atomic", "partial.taken_back"].contains(&failure.code.as_str());
    let cause = failures.iter().position(|(_, failure)| is_cause(failure));
    let (name, first) = failures.into_iter().nth(end.or(cause).unwrap_or(0))?;
    let named = first.within(|why| match drives {
        1 => both!("{name}: {why}", "{name}: {why}", why),
        _ => both!(
            "{count} of {drives} drives {are} ({names}); {name}: {why}",
            "{count} von {drives} Antrieben {are} ({names}); {name}: {why}",
            are,
            why
        ),
    });
    let is_partial = drives > 1 && end.is_none() && (is_torn || count < drives);
    Some(match is_partial {
        true => Failure { class: Class::Partial, code: "partial".to_owned(), ..named },
        false => named,
    })
}

/// What somebody wanted to end is no failure of the drives.
fn interrupted(failure: Failure) -> Failure {
    match failure.class {
        Class::Interrupted => failure,
        _ => Failure {
            class: Class::Interrupted,
            code: "interrupted".to_owned(),
            ..failure.within(|why| both!("interrupted; {why}", "unterbrochen; {why}", why))
        },
    }
}

/// The drives to which something would be written.
fn would_change(drives: &[PlantDrive]) -> Option<Text> {
    let planned: Vec<&str> =
        drives.iter().filter(|row| row.state == PlantState::Planned).map(|row| row.called.as_str()).collect();
    let (count, drives) = (planned.len() as u64, planned.join(", "));
    (count > 0).then(|| {
        let some = Text::count(
            count,
            ["drive would change", "drives would change"],
            ["Antrieb würde sich ändern", "Antriebe würden sich ändern"],
        );
        both!("{some}: {drives}", "{some}: {drives}", some)
    })
}

/// Something would be written.
pub(super) const NOT_YET: &str = "no.differences";

/// Nothing is wrong, but something would be written.
fn not_yet(some: Text) -> Failure {
    Failure::new(Class::No, NOT_YET, some)
}
