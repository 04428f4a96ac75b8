//! One value of a plan: whether it is to be written, whether it may be, and why not.

use crate::drive::job::{self, Step};
use crate::drive::terms::is_place_on_bus;
use crate::drive::transfer::hides_width;
use crate::drive::{Session, Target, Terms, describe, is_over};
use crate::failure::{Class, Failure};
use crate::outcome::{ErrorDoc, WriteResult, Written};
use crate::profile::paramfile::value_text;
use crate::profile::{DataSets, Family, FileRules, Param, Role, Type, value};
use crate::text::{Text, both};
use std::collections::{BTreeMap, BTreeSet};

/// The code of a value that cannot be read on the way back.
const UNREAD: &str = "partial.unread";
/// So many values in a row that do not come tell that nobody is there.
const MOST_SILENCES: usize = 2;

/// What was to come, by number and data set as on the wire.
pub type Coming = BTreeMap<(u32, u8), i64>;

/// Places, by number and data set as on the wire, of which the drive may tell what is not stored there.
pub type Unproven = BTreeSet<(u32, u8)>;

/// Where a transaction goes.
pub(super) enum Purpose {
    /// To new values.
    Forward,
    /// Back.
    Back {
        /// From these, by number and data set; what is not named was changed by the drive itself.
        from: Coming,
        /// Of these the drive perhaps tells what is not stored.
        unproven: Unproven,
    },
}

impl Purpose {
    /// What a load was to bring to a place that is brought back.
    pub(super) fn came(&self, step: &Step) -> Option<i64> {
        let Purpose::Back { from, .. } = self else { return None };
        stated(step).iter().find_map(|place| from.get(place)).copied()
    }

    /// Whether a value that is stored as before may stand otherwise in a RAM that is not shown: a load was to bring another one,
    /// or nobody says what it was to bring.
    pub(super) fn may_stand_otherwise(&self, step: &Step) -> bool {
        let Purpose::Back { from, .. } = self else { return false };
        from.is_empty() || self.came(step).is_some_and(|raw| raw != step.raw)
    }

    /// Whether a place is written also where the drive tells what it shall hold.
    fn doubts(&self, step: &Step) -> bool {
        let Purpose::Back { unproven, .. } = self else { return false };
        unproven.iter().any(|(id, set)| *id == step.param.id && covers(*set, step.set))
    }

    /// Whether a value that does not come keeps nobody from bringing the others.
    pub(super) fn bears(&self, failure: &Failure, silences: usize) -> bool {
        matches!(self, Purpose::Back { .. }) && !is_over(failure) && silences < MOST_SILENCES
    }
}

/// Under which places a file may state something of a step: what is of all four data sets stands under 0, also where they differ by now.
fn stated(step: &Step) -> [(u32, u8); 2] {
    let all = step.set - step.set % DataSets::RAM_OFFSET;
    [step.set, all].map(|set| (step.param.id, set))
}

/// Whether two data sets as on the wire have a cell in common.
pub(super) fn covers(one: u8, other: u8) -> bool {
    let is_ram = |set: u8| set >= DataSets::RAM_OFFSET;
    is_ram(one) == is_ram(other) && (one == other || one.is_multiple_of(5) || other.is_multiple_of(5))
}

/// The row of a value, and why it cannot be written.
pub(super) fn weigh(
    session: &Session<'_>,
    target: &Target,
    terms: &Terms<'_>,
    (step, purpose): (&Step, &Purpose),
    old: Result<i64, Failure>,
) -> (Written, Option<Failure>) {
    let row = describe::to_write(target.address, &target.family, &step.param, step.set, step.raw);
    let mut row = Written { node: session.node(), ..row };
    if let Ok(old) = old {
        row.old_raw = Some(old);
        row.old = describe::scaled(&step.param, old);
    }
    let kind = target.known_width(step.param.id).or(step.kind);
    let is_hidden = |raw: i64| step.kind.is_none() && hides_width(session, &step.param, raw);
    let verdict = match (old, purpose) {
        (Ok(old), _) if old == step.raw && !purpose.doubts(step) => {
            row.result = WriteResult::Unchanged;
            return (row, None);
        }
        (Ok(old), _) if is_hidden(old) || is_hidden(step.raw) => Err(job::no_width(&step.param)),
        (Ok(_), Purpose::Forward) => {
            let known = kind.ok_or_else(|| job::no_width(&step.param));
            known.and_then(|kind| allowed(step, Some(kind), (&target.family, session.own_address())))
        }
        (Ok(old), Purpose::Back { .. }) if old == step.raw => {
            row.note = Some(not_taken_back());
            keeps_line(&step.param, (&target.family, session.own_address()))
        }
        (Ok(old), Purpose::Back { from, .. }) => {
            let came = purpose.came(step);
            let on_line = keeps_line(&step.param, (&target.family, session.own_address()));
            on_line.and_then(|()| stands_as_left(step, &target.family.files, (old, came), from))
        }
        (Err(failure), Purpose::Forward) => Err(no_way_back(&step.param, failure)),
        (Err(failure), Purpose::Back { .. }) => Err(not_told(&step.param, failure)),
    };
    job::tell(&mut row, kind.and_then(|kind| job::telegram(terms, &target.family, target.address, step, kind)));
    let failure = verdict.err().map(|failure| located(step, failure));
    if let Some(failure) = &failure {
        let is_unknown = failure.code == UNREAD;
        row.result = if is_unknown { WriteResult::Unrestored } else { WriteResult::Refused };
        row.error = Some(ErrorDoc::from(failure));
    }
    (row, failure)
}

/// What forbids a value that is to be written to a drive of this family, reached under the address of this role, as far as that can be told without asking:
/// the line, the range, the type if it is known.
///
/// # Errors
/// What forbids it.
pub fn fits(step: &Step, kind: Option<Type>, reached: (&Family, Option<Role>)) -> Result<(), Failure> {
    allowed(step, kind, reached).map_err(|failure| located(step, failure))
}

/// The failure with the line of the file that it is about.
fn located(step: &Step, failure: Failure) -> Failure {
    let Some(at) = &step.at else { return failure };
    Failure { message: both!("{at}: {why}", "{at}: {why}", why = failure.message), ..failure }
}

/// See [`fits`].
fn allowed(step: &Step, kind: Option<Type>, reached: (&Family, Option<Role>)) -> Result<(), Failure> {
    let Step { param, raw, .. } = step;
    let label = param.label();
    keeps_line(param, reached)?;
    let wrong = |code: &str, error: value::ValueError| {
        let message = both!(
            "{label} ({called}): {why}",
            "{label} ({called}): {why}",
            called = param.called(),
            why = error.text()
        );
        Failure::new(Class::Data, code, message).with("param", param.id).hint(both!(
            "--except {id} leaves it out",
            "--except {id} lässt es weg",
            id = param.id
        ))
    };
    value::check_range(*raw, param).map_err(|error| wrong("data.range", error))?;
    let typed = kind.map_or(Ok(()), |kind| value::check_type(*raw, kind, param));
    typed.map_err(|error| wrong("data.width", error))
}

/// The code of a value that cuts the line.
pub const CUTS: &str = "forbidden.cuts";

/// Refuses what cuts the line: nobody could take it back over that line, nor prove that it came back.
fn keeps_line(param: &Param, (family, own): (&Family, Option<Role>)) -> Result<(), Failure> {
    if !job::cuts(param, family, own) {
        return Ok(());
    }
    let label = param.label();
    let message = both!(
        "{label} can cut the line at once, and what cuts the line cannot be taken back over it",
        "{label} kann die Leitung sofort kappen, und was sie kappt, lässt sich über sie nicht zurücknehmen"
    );
    // A drive that is reached by an address on its own plug has this hazard only where it is reached behind another one.
    let hint = match own.is_some() && is_place_on_bus(param) {
        true => both!(
            "`antrieb write` sends a single value, and looks behind it whether the node still answers",
            "`antrieb write` sendet einen einzelnen Wert und prüft danach, ob der Knoten noch antwortet"
        ),
        false => both!(
            "`antrieb line set` and `antrieb protocol set` change the line and follow the drive; `antrieb write` sends a single value",
            "`antrieb line set` und `antrieb protocol set` stellen die Leitung um und folgen dem Antrieb; `antrieb write` sendet einen \
             einzelnen Wert"
        ),
    };
    Err(Failure::new(Class::Forbidden, CUTS, message).hint(hint))
}

/// Whether a value still is what the transaction made of it: what somebody has changed since is his.
fn stands_as_left(
    step: &Step,
    rules: &FileRules,
    (now, left): (i64, Option<i64>),
    from: &Coming,
) -> Result<(), Failure> {
    let alters = |(id, _): &(u32, u8)| rules.altered_by(*id).any(|altered| altered == step.param.id);
    let shown = |raw| value_text(&step.param, raw);
    let left = match left {
        None if from.is_empty() || from.keys().any(alters) => return Ok(()),
        None => return Err(unnamed(step, &shown(now))),
        Some(left) if left == now => return Ok(()),
        Some(left) => left,
    };
    let message = both!(
        "{label} reads as {now}, which is neither the value before the load ({before}) nor the one that it was to write ({left})",
        "{label} liest sich als {now}; das ist weder der Wert vor dem Laden ({before}) noch der, den es schreiben sollte ({left})",
        label = place(step),
        now = shown(now),
        before = shown(step.raw),
        left = shown(left)
    );
    Err(Failure::new(Class::Forbidden, "forbidden.changed_since", message).hint(both!(
        "somebody has changed it since, or it is another drive; --force takes it back all the same",
        "jemand hat es seitdem geändert, oder es ist ein anderer Antrieb; --force nimmt es trotzdem zurück"
    )))
}

/// A file that does not say what came to a place does not tell whether it still stands there.
fn unnamed(step: &Step, now: &str) -> Failure {
    let message = both!(
        "{label} reads as {now}, and the file does not say in [undo] what was written there",
        "{label} liest sich als {now}, und die Datei sagt in [undo] nicht, was dorthin geschrieben wurde",
        label = place(step)
    );
    Failure::new(Class::Data, "data.undo_unnamed", message)
        .with("param", step.param.id)
        .hint(both!("--force takes it back all the same", "--force nimmt es trotzdem zurück"))
}

/// What cannot be read cannot be put back, so it is not written.
fn no_way_back(param: &Param, failure: Failure) -> Failure {
    let failure = failure.within(|why| {
        both!(
            "{label}: {why}; what cannot be read cannot be taken back",
            "{label}: {why}; was sich nicht lesen lässt, lässt sich nicht zurücknehmen",
            label = param.label(),
            why
        )
    });
    let hint = both!(
        "is it the drive, and the module, that the file was made for? --except {id} leaves it out",
        "ist es der Antrieb, und das Modul, für die die Datei gemacht wurde? --except {id} lässt ihn weg",
        id = param.id
    );
    failure.hint(hint)
}

/// A value that cannot be read is not brought back: nobody could tell whether somebody has changed it since.
fn not_told(param: &Param, failure: Failure) -> Failure {
    let said = failure.within(|why| {
        both!(
            "{label} is left as it is, because it cannot be read: {why}",
            "{label} bleibt, wie er ist, weil er sich nicht lesen lässt: {why}",
            label = param.label(),
            why
        )
    });
    Failure { code: UNREAD.to_owned(), ..said }
}

pub(super) fn unread(param: &Param) -> Failure {
    let message = both!("{label} was not read", "{label} wurde nicht gelesen", label = param.label());
    Failure::new(Class::Garbled, "garbled.unread", message)
}

/// What nobody can look at before a file goes into a drive whose family tells no state.
pub(super) fn unwatched(target: &Target) -> Option<Text> {
    target.family.role(Role::StatusWord).is_none().then(|| {
        both!(
            "the family {drive} tells no state: whether drive {address} runs, nobody could look",
            "die Familie {drive} nennt keinen Zustand: ob Antrieb {address} läuft, ließ sich nicht ansehen",
            drive = target.family.drive,
            address = target.address
        )
    })
}

/// Why a value that is stored already is written, into the RAM alone.
pub(super) fn not_in_force() -> Text {
    both!(
        "stored already, but the drive works with another value (RAM)",
        "schon gespeichert, der Antrieb arbeitet aber mit einem anderen Wert (RAM)"
    )
}

/// Why a value that the drive tells as before is written.
pub(super) fn not_taken_back() -> Text {
    both!(
        "told as before, but an earlier way back was not proven to its end, and the drive may tell its RAM as stored",
        "gelesen wie vorher, aber ein früheres Zurücknehmen wurde nicht bis zum Ende bestätigt, und vielleicht zeigt der Antrieb sein RAM \
         als gespeichert"
    )
}

/// Why a value that is stored as before is written, into a RAM that nobody can read.
pub(super) fn unread_in_ram() -> Text {
    both!(
        "stored as before; the drive does not show what it works with, and its acknowledgement is the only proof",
        "gespeichert wie vorher; womit der Antrieb arbeitet, zeigt er nicht, und seine Bestätigung ist der einzige Nachweis"
    )
}

/// What is to be said of a value in force that is not the one that is stored.
pub(super) fn differs_in_ram(
    step: &Step,
    (set, raw): (u8, i64),
    result: WriteResult,
    purpose: &Purpose,
) -> Option<Text> {
    let (label, set) = (step.param.label(), set - DataSets::RAM_OFFSET);
    let is_new = raw != step.raw;
    let raw = value_text(&step.param, raw);
    match (purpose, result) {
        (Purpose::Forward, _) => Some(both!(
            "{label}@{set}: the drive works with {raw} (RAM), which is not what is stored; both are replaced, and an undo file \
             brings back only what is stored",
            "{label}@{set}: der Antrieb arbeitet mit {raw} (RAM), gespeichert ist anderes; beides wird ersetzt, und eine Datei \
             zum Zurücknehmen bringt nur das Gespeicherte zurück"
        )),
        (Purpose::Back { .. }, WriteResult::Unchanged) => Some(both!(
            "{label}@{set}: what is stored is as before; the drive works with {raw} (RAM) until it is switched off",
            "{label}@{set}: gespeichert ist der Wert von vorher; der Antrieb arbeitet bis zum Ausschalten mit {raw} (RAM)"
        )),
        (Purpose::Back { .. }, WriteResult::Planned) if is_new => Some(both!(
            "{label}@{set}: the drive works with {raw} (RAM), which is not what is stored; both are replaced",
            "{label}@{set}: der Antrieb arbeitet mit {raw} (RAM), gespeichert ist anderes; beides wird ersetzt"
        )),
        (Purpose::Back { .. }, _) => None,
    }
}

/// A parameter with its data set, as people name it.
pub(super) fn place(step: &Step) -> String {
    let label = step.param.label();
    if step.set.is_multiple_of(5) { label } else { format!("{label}@{}", step.set % 5) }
}
