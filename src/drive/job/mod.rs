//! Writing values, with proof: what there is to do, the question, the writes, what became of them.
//!
//! A job is first prepared (old values are read, nothing is sent), then asked for as a whole, then carried out drive by
//! drive; the first failure leaves out the rest of its drive.

mod asked;

pub use asked::{lines, look_again, question};

use super::stands::{NO_SUCH_SET, has_ram, in_ram};
use super::{
    AccessError, Cell, Inquiry, Order, Reader, Refusal, Session, Target, Terms, WriteFate, describe, is_over, summary,
};
use crate::failure::{Class, Failure};
use crate::gate::{Permit, Writes};
use crate::outcome::{Data, ErrorDoc, Outcome, TelegramDoc, Warning, Write, WriteResult, Written};
use crate::profile::paramfile::At;
use crate::profile::value;
use crate::profile::{Effective, Family, HazardKind, Holds, Param, Role, Type};
use crate::text::{Text, both};
use crate::tick::Span;

/// The node of a drive on the system bus (EM-RES-03 manual 5.5).
const NODE: u32 = 900;

/// A value for one parameter in one data set.
#[derive(Clone, Debug)]
pub struct Step {
    /// The parameter.
    pub param: Param,
    /// Data set as on the wire, 0-9.
    pub set: u8,
    /// The value without its decimal point.
    pub raw: i64,
    /// Its type; `None` to find it out by asking.
    pub kind: Option<Type>,
    /// Where a file states it.
    pub at: Option<At>,
}

/// Leaves out what is planned: nobody said yes, or the port went away before anything was sent.
pub fn leave(jobs: &mut [Job], mut failure: Failure) -> Failure {
    if failure.is_gone() {
        failure.message = both!("{why}; nothing was begun", "{why}; es wurde nichts begonnen", why = failure.message);
    }
    let planned = jobs.iter_mut().flat_map(|job| &mut job.rows).filter(|row| row.result == WriteResult::Planned);
    for row in planned {
        row.result = WriteResult::Skipped;
        row.error = Some(ErrorDoc::from(&failure));
    }
    failure
}

/// What is to be written to one drive.
#[derive(Debug)]
pub struct Job {
    /// The drive.
    pub target: Target,
    /// What is to be written.
    pub steps: Vec<Step>,
    /// What becomes of it, a row for each step.
    pub rows: Vec<Written>,
}

/// The telegram of a step, taken apart.
pub fn telegram(terms: &Terms<'_>, family: &Family, address: u8, step: &Step, kind: Type) -> Option<TelegramDoc> {
    let at = Cell { number: step.param.id, set: step.set };
    let bits = value::to_wire(step.raw, family.link.route.carried(kind)).ok()?;
    let reader = terms.telegrams(family);
    let proves = address != 0 && step.param.access.reads();
    let both = proves.then(|| reader.question(address, Inquiry::WriteAndRead(at, kind, bits))).flatten();
    both.or_else(|| reader.question(address, Inquiry::Write(at, kind, bits)))
}

/// Reads the old values and says what there is to do.
pub async fn prepare(
    session: &mut Session<'_>,
    target: &mut Target,
    terms: &Terms<'_>,
    steps: &[Step],
    force: bool,
) -> Result<Vec<Written>, Failure> {
    let mut rows = Vec::new();
    for step in steps {
        let address = target.address;
        let row = describe::to_write(address, &target.family, &step.param, step.set, step.raw);
        let mut row = Written { node: session.node(), ..row };
        if let Some(kind) = step.kind {
            target.set_width(step.param.id, kind);
        }
        if address != 0 && step.param.access.reads() {
            let mut reader = Reader::new(session, target);
            let old = reader.rows(&step.param, describe::sets(step.set)).await?;
            if let [old] = old.as_slice() {
                (row.old_raw, row.old) = (old.raw, old.value);
            }
            let failures = reader.failures;
            if let Some(failure) = failures.into_iter().find(|failure| forbids(failure, force)) {
                return Err(nothing_sent(failure));
            }
        }
        check_found(step, target)?;
        // What is written to its parameter before it changes it too, in all data sets or in the RAM.
        let stands =
            !rows.iter().any(|other: &Written| other.param == row.param && other.result == WriteResult::Planned);
        if row.old_raw == Some(step.raw) && stands && !force {
            let in_ram = in_ram(session, target, &step.param, &[step.set]).await.map_err(nothing_sent)?;
            if in_ram.iter().all(|(_, raw)| *raw == step.raw) {
                row.result = WriteResult::Unchanged;
                row.note = might_be_ram(target, step);
            }
        }
        let kind = step.kind.or(target.known_width(step.param.id));
        tell(&mut row, kind.and_then(|kind| telegram(terms, &target.family, address, step, kind)));
        rows.push(row);
    }
    Ok(rows)
}

/// Whether a parameter that cannot be read must not be written either: one that the drive does not have would end the
/// run in the middle. Where the drive names another reason, such as that it can only be written, it may still be.
fn forbids(failure: &Failure, force: bool) -> bool {
    let names_another = told_cause(failure).is_some_and(|code| code != "0")
        && !["refused.unknown_parameter", NO_SUCH_SET].contains(&failure.code.as_str());
    failure.class != Class::Refused || !(force || names_another)
}

/// A failure on the way to the first write; it says that nothing was written.
pub fn nothing_sent(failure: Failure) -> Failure {
    let text = both!("nothing was written", "es wurde nichts geschrieben");
    Failure { message: both!("{why}; {text}", "{why}; {text}", why = failure.message, text), ..failure }
}

/// The width that the drive has told, or that nobody tells, before anything is sent.
fn check_found(step: &Step, target: &Target) -> Result<(), Failure> {
    let Some(kind) = step.kind.or(target.known_width(step.param.id)) else { return Err(no_width(&step.param)) };
    value::check_type(step.raw, kind, &step.param).map_err(|error| {
        let (label, called) = (step.param.label(), step.param.called());
        let message = both!("{label} ({called}): {why}", "{label} ({called}): {why}", called, why = error.text());
        nothing_sent(Failure::new(Class::Data, "data.width", message).with("param", step.param.id))
    })
}

/// The failure of a value whose width nobody tells.
pub fn no_width(param: &Param) -> Failure {
    let message = both!(
        "parameter {param}: no source tells its width, and nobody can be asked",
        "Parameter {param}: keine Quelle nennt seine Breite, und fragen lässt sich niemand",
        param = param.id
    );
    Failure::new(Class::Data, "data.width", message)
        .hint(both!("name it with --type uint, int, word or long", "mit --type uint, int, word oder long angeben"))
}

/// Says in a row what is sent for it.
pub fn tell(row: &mut Written, telegram: Option<TelegramDoc>) {
    row.meaning = telegram.as_ref().map(|doc| doc.meaning.clone());
    row.telegram = telegram.map(|doc| doc.hex);
}

/// Some drives read the value in force from the EEPROM's sets (facts: readings): nobody can tell then what they store.
fn might_be_ram(target: &Target, step: &Step) -> Option<Text> {
    let hint = both!("if it was set in RAM only, --force stores it", "stand er nur im RAM, speichert ihn --force");
    has_ram(target, &step.param, step.set).then_some(hint)
}

/// Writes what is planned for one drive. The first failure skips the rest; returns whether the session is over.
pub async fn carry_out(
    session: &mut Session<'_>,
    job: &mut Job,
    terms: &Terms<'_>,
    permit: &Permit<impl Writes>,
    failures: &mut Vec<Failure>,
) -> bool {
    let mut stopped = false;
    let mut over = false;
    for (step, row) in job.steps.iter().zip(&mut job.rows) {
        if row.result != WriteResult::Planned {
            continue;
        }
        if stopped {
            row.result = WriteResult::Skipped;
            continue;
        }
        if let Some(mut failure) = carry_step(session, &mut job.target, step, row, terms, permit).await {
            if eeprom_failed(&failure)
                && row.result == WriteResult::Refused
                && has_ram(&job.target, &step.param, step.set)
            {
                failure.message = perhaps_in_ram(failure.message, &step.param, step.set);
                row.error = Some(ErrorDoc::from(&failure));
            }
            over = is_over(&failure);
            stopped = true;
            failures.push(failure);
        }
    }
    over
}

/// Writes one value and proves it; the row says what became of it, and why. A row that is `Skipped` was not begun.
pub(in crate::drive) async fn carry_step(
    session: &mut Session<'_>,
    target: &mut Target,
    step: &Step,
    row: &mut Written,
    terms: &Terms<'_>,
    permit: &Permit<impl Writes>,
) -> Option<Failure> {
    let address = target.address;
    let fate = match begin(session, target, step).await {
        Ok(kind) => {
            tell(row, telegram(terms, &target.family, address, step, kind));
            let read_back = reads_back(&step.param, &target.family, session.own_address());
            let order = Order { set: step.set, raw: step.raw, kind, read_back };
            let fate = target.write(session, &step.param, order, permit).await;
            let fate = proven_there(session, target, step, fate).await;
            fate.map_err(|error| (error, WriteResult::Unknown))
        }
        Err(error) => Err((error, WriteResult::Skipped)),
    };
    let failure = match fate {
        Ok(fate) => {
            row.result = result(&fate);
            unproven(&fate, target, row)
        }
        Err((error, otherwise)) => {
            row.result = match error.refusal() {
                // Whether it is stored as well, reading does not tell.
                Some(Refusal { taken: Some(true), .. }) => WriteResult::Unknown,
                Some(_) => WriteResult::Refused,
                None => otherwise,
            };
            let mut failure = error.failure(address, Some(&target.family));
            if row.result == WriteResult::Skipped {
                failure.message = both!(
                    "{why}; P.{param} was not begun",
                    "{why}; P.{param} wurde nicht begonnen",
                    why = failure.message,
                    param = row.param
                );
            }
            Some(failure)
        }
    };
    let failure = failure?.with("param", step.param.id);
    row.error = Some(ErrorDoc::from(&failure));
    Some(failure)
}

/// Whether the EEPROM did not take it (CM-485 manual 6.6).
pub(in crate::drive) fn eeprom_failed(failure: &Failure) -> bool {
    told_cause(failure) == Some("6")
}

/// The cause of a refusal, from the error register, or from the abort that tells the same (EM-RES-03 manual 5.10.1).
fn told_cause(failure: &Failure) -> Option<&str> {
    let cause = failure.context.iter().find(|(key, _)| ["p11", "abort"].contains(key));
    cause.map(|(_, code)| code.as_str())
}

/// A write to the EEPROM goes into the RAM too (CM-485 manual 7), perhaps also where the EEPROM does not take it.
fn perhaps_in_ram(why: Text, param: &Param, set: u8) -> Text {
    let id = param.id;
    both!(
        "{why}; the drive may work with the new value all the same: `antrieb read {id}@{set}ram` tells",
        "{why}; der Antrieb kann trotzdem mit dem neuen Wert arbeiten: `antrieb read {id}@{set}ram` sagt es",
        why
    )
}

/// What became of a write behind which the drive has another address at once: there it is asked.
async fn proven_there(
    session: &mut Session<'_>,
    target: &mut Target,
    step: &Step,
    fate: Result<WriteFate, AccessError>,
) -> Result<WriteFate, AccessError> {
    let Some(role) = session.own_address() else { return fate };
    if session.node() > 0 && step.param.hazard == Some(HazardKind::Line) && step.param.access.reads() {
        return still_there(session, target, step, fate).await;
    }
    let family = &target.family;
    let at_once = family.link.line.address == Holds::AtOnce && cuts(&step.param, family, Some(role));
    let moves = at_once && is_in(role, &step.param, family);
    let (Ok(new), true) = (u8::try_from(step.raw), moves && target.address != 0) else { return fate };
    if !matches!(fate, Ok(WriteFate::Written | WriteFate::Unknown(_))) {
        return fate;
    }
    let mut there = Target::new(new, target.family.clone());
    match there.read_set(session, &step.param, step.set).await {
        Ok(reading) if reading.raw == step.raw => Ok(WriteFate::Verified),
        Ok(reading) => Ok(WriteFate::Differs(reading.raw)),
        Err(error) if error.is_fatal() => Err(error),
        Err(error) => Ok(WriteFate::Unknown(error)),
    }
}

/// No source tells when the place of a node on its bus holds, so it is asked where it was. Who is silent there may have gone.
async fn still_there(
    session: &mut Session<'_>,
    target: &mut Target,
    step: &Step,
    fate: Result<WriteFate, AccessError>,
) -> Result<WriteFate, AccessError> {
    if !matches!(fate, Ok(WriteFate::Written)) {
        return fate;
    }
    match target.read_set(session, &step.param, step.set).await {
        Ok(reading) if reading.raw == step.raw => Ok(WriteFate::Verified),
        Ok(reading) => Ok(WriteFate::Differs(reading.raw)),
        Err(error) if error.is_fatal() => Err(error),
        Err(_) => fate,
    }
}

/// How wide the value goes out, with a look at the line: at the question somebody may have unplugged the adapter or pressed
/// Ctrl-C. Nothing that fails here has changed anything.
async fn begin(session: &mut Session<'_>, target: &mut Target, step: &Step) -> Result<Type, AccessError> {
    session.rest(Span::ZERO).await?;
    target.width(session, &step.param, step.set).await
}

/// Whether reading back proves anything: not where the line or the drive is gone at once.
fn reads_back(param: &Param, family: &Family, own: Option<Role>) -> bool {
    param.access.reads() && !cuts(param, family, own)
}

/// Whether the line or the drive is gone at once behind a write, where the drive is reached under the address of this role.
pub fn cuts(param: &Param, family: &Family, own: Option<Role>) -> bool {
    match param.hazard {
        Some(HazardKind::Line) => param.effective == Effective::AtOnce && !is_elsewhere(param, family, own),
        Some(HazardKind::Reset) => true,
        Some(HazardKind::Motion) | None => false,
    }
}

/// Whether it is the address of another protocol than the one that is spoken, which has its own: P.394 is that of VABus, P.1376 that of Modbus (CM-485
/// manual 11.2).
fn is_elsewhere(param: &Param, family: &Family, own: Option<Role>) -> bool {
    [Role::Address, Role::NodeId].into_iter().any(|role| own != Some(role) && is_in(role, param, family))
}

fn is_in(role: Role, param: &Param, family: &Family) -> bool {
    family.role(role).is_some_and(|own| own.id == param.id)
}

fn result(fate: &WriteFate) -> WriteResult {
    match fate {
        WriteFate::Verified => WriteResult::Verified,
        WriteFate::Written => WriteResult::Written,
        WriteFate::Differs(_) => WriteResult::Differs,
        WriteFate::Unknown(_) => WriteResult::Unknown,
        WriteFate::Broadcast => WriteResult::Broadcast,
    }
}

fn unproven(fate: &WriteFate, target: &Target, row: &Written) -> Option<Failure> {
    let address = target.address;
    match fate {
        WriteFate::Verified | WriteFate::Written | WriteFate::Broadcast => None,
        WriteFate::Differs(raw) => {
            let param = row.param;
            let read = value::written(&target.family.param_or_unknown(param), *raw);
            let message = both!(
                "drive {address} took the telegram, but P.{param} reads back as {read}",
                "Antrieb {address} hat das Telegramm angenommen, aber P.{param} liest sich als {read} zurück"
            );
            Some(Failure::new(Class::Refused, "refused.reads_back_differently", message).hint(both!(
                "the drive limits the value, or something else writes it too",
                "der Antrieb begrenzt den Wert, oder etwas anderes schreibt ihn auch"
            )))
        }
        WriteFate::Unknown(error) => {
            let failure = error.failure(address, Some(&target.family));
            Some(failure.within(|why| {
                both!(
                    "whether P.{param} was written is unknown: {why}",
                    "ob P.{param} geschrieben wurde, ist unbekannt: {why}",
                    param = row.param,
                    why
                )
            }))
        }
    }
}

/// Puts the rows of all drives together.
pub fn done(jobs: Vec<Job>, failures: Vec<Failure>, terms: &Terms<'_>) -> Outcome {
    let mut warnings = Vec::new();
    for job in &jobs {
        for (step, row) in job.steps.iter().zip(&job.rows) {
            warnings.extend(way_back(step, row, &job.target.family, terms));
        }
    }
    let values: Vec<Written> = jobs.into_iter().flat_map(|job| job.rows).collect();
    if values.iter().any(|row| row.address == 0 && row.result == WriteResult::Broadcast) {
        let message = both!(
            "sent to everybody: no drive confirms it, so nobody knows whether it was taken; read it back drive by \
             drive",
            "an alle gesendet: kein Antrieb bestätigt das, ob es angenommen wurde, weiß niemand; einzeln zurücklesen"
        );
        warnings.push(Warning { code: "write.broadcast".to_owned(), message });
    }
    let succeeded = values.iter().filter(|row| row.error.is_none() && row.result != WriteResult::Skipped).count();
    let failure = summary(failures, succeeded);
    Outcome { data: Some(Data::Write(Write { dry_run: false, values })), warnings, failure }
}

/// How to get back to a drive whose line settings were changed.
fn way_back(step: &Step, row: &Written, family: &Family, terms: &Terms<'_>) -> Option<Warning> {
    let sent = matches!(row.result, WriteResult::Verified | WriteResult::Written | WriteResult::Unknown);
    if !sent || step.param.hazard != Some(HazardKind::Line) || is_elsewhere(&step.param, family, terms.own_address()) {
        return None;
    }
    if row.node > 0 {
        return Some(Warning { code: "line.changed".to_owned(), message: way_back_to_node(step, row) });
    }
    let is_address = is_in(Role::Address, &step.param, family);
    let when = match (step.param.effective, is_address, family.link.line.address) {
        (Effective::Reset, ..) => both!("after the next reset", "nach dem nächsten Reset"),
        (_, true, Holds::Unsaid) => both!(
            "from now on or after the next power-on, which its manual does not say,",
            "ab jetzt oder nach dem nächsten Einschalten, was die Anleitung nicht sagt,"
        ),
        _ => both!("from now on", "ab jetzt"),
    };
    let unknown = || both!("its old value", "den alten Wert");
    let (old, new, _) = describe::change(row);
    let (old, new) = (old.map_or_else(unknown, Text::name), row.text.clone().unwrap_or_else(|| Text::name(new)));
    let (label, address, line, protocol) = (step.param.label(), row.address, terms.line, terms.speech.protocol.name());
    let message = both!(
        "{label} is {new}: {when} the drive is no longer reached with address {address} at {line} {protocol}; the way \
             back is to write {old} with the new setting",
        "{label} ist {new}: {when} ist der Antrieb nicht mehr mit Adresse {address} bei {line} {protocol} erreichbar; \
             zurück führt, mit der neuen Einstellung {old} zu schreiben",
        new,
        when,
        old
    );
    Some(Warning { code: "line.changed".to_owned(), message })
}

/// The same of a node behind a drive, by what it showed behind the write.
fn way_back_to_node(step: &Step, row: &Written) -> Text {
    let (old, new, _) = describe::change(row);
    let old = old.map_or_else(|| both!("its old value", "den alten Wert"), Text::name);
    let (label, address, node) = (step.param.label(), row.address, row.node);
    let stands = match row.result {
        WriteResult::Verified => {
            both!("it still answers at {address}.{node}", "er antwortet weiter unter {address}.{node}")
        }
        _ => both!(
            "at {address}.{node} it did not answer behind it",
            "unter {address}.{node} antwortete er danach nicht"
        ),
    };
    let back = match (step.param.id, u8::try_from(step.raw)) {
        (NODE, Ok(there @ 1..)) => both!(
            "then it is reached at {address}.{there}, and the way back is to write {old} there",
            "dann ist er unter {address}.{there} erreichbar, und zurück führt, dort {old} zu schreiben",
            old
        ),
        _ => both!(
            "then it may be out of reach over the bus, and the way back is to write {old} over its own serial plug",
            "dann ist er über den Bus vielleicht nicht mehr erreichbar, und zurück führt, {old} über seinen eigenen seriellen \
             Anschluss zu schreiben",
            old
        ),
    };
    both!(
        "{label} is {new}: {stands}; from when on that holds, no source tells, at the latest behind a power-on: {back}",
        "{label} ist {new}: {stands}; ab wann das gilt, nennt keine Quelle, spätestens nach dem Einschalten: {back}",
        stands,
        back
    )
}
