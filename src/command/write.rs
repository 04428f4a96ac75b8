//! `write`: set parameters, with proof.

use super::read::select_failure;
use super::verb::{Verb, Working};
use super::{Context, Reader, addresses_to_write, connect, is_over, offline, summary, target};
use crate::args::Settings;
use crate::drive::{AccessError, Cell, Inquiry, Order, Session, Target, WriteFate, describe};
use crate::failure::{Class, Failure};
use crate::gate::{self, Hazard, Permit, Question};
use crate::outcome::{Data, Document, ErrorDoc, Outcome, TelegramDoc, Warning, Write, WriteResult, Written};
use crate::profile::value::{self, ValueError, format_decimal};
use crate::profile::{DataSets, Effective, Family, HazardKind, Holds, Lang, Param, Selector, Store, Type};
use crate::tick::Span;
use clap::Args as ClapArgs;

/// Writes parameters.
///
/// A value may carry its unit and a decimal point or comma: 376@4=1.5kW, 480=-12,5, 395=rtu, 410=0x0F. @N picks a data
/// set, @ram and @2ram write to RAM only, which is lost at power-off but does not wear the EEPROM. Without @ the value
/// goes to data set 0, which sets all four sets of a switchable parameter.
///
/// What cuts the line at once (P.1376, P.395) or restarts the drive goes last; two of these are refused beside each other.
///
/// Everything is checked before anything is sent. Then old and new values are shown and you are asked; every write is
/// read back. What the drive has already is not sent again.
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    /// What to write: `PARAMETER[@SET]=VALUE`, such as 376@4=1.5kW
    #[arg(value_name = "PARAMETER=VALUE", required = true)]
    pub assignments: Vec<String>,

    /// Write with this type, whatever the catalogue says: uint, int, word, long
    #[arg(long = "type", value_name = "TYPE")]
    pub kind: Option<Type>,

    /// Take the value with this many decimals, whatever the catalogue says
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(0..=6))]
    pub decimals: Option<u8>,

    /// Send also what the catalogue forbids or what would change nothing, and let the drive judge
    #[arg(long)]
    pub force: bool,
}

/// A value for one parameter in one data set.
#[derive(Clone, Debug)]
pub(super) struct Step {
    pub(super) param: Param,
    pub(super) set: u8,
    pub(super) raw: i64,
    pub(super) kind: Option<Type>,
}

impl Verb for Args {
    const NAME: &'static str = "write";
    type Prints = Document<Write>;

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(run(self, context))
    }
}

/// Writes to every drive that was named.
pub async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let addresses = addresses_to_write(context.settings)?;
    let lang = context.settings.lang;
    super::known_somewhere(context.settings, context.registry, &selectors(args)?)?;
    let (family, planned) = offline(context.settings, context.registry, |family| steps(args, family, lang))?;
    if context.settings.dry_run {
        return plan_only(context.settings, &addresses, &family, &planned);
    }
    let Context { settings, registry, interrupt, observe, ask } = context;
    let mut session = connect(settings, registry, interrupt, *observe).await?;
    let mut jobs = Vec::new();
    for address in addresses {
        let mut target = match address {
            0 => Target::new(0, family.clone()).in_word_order(settings.word_order),
            _ => target(&mut session, settings, registry, address, false).await?,
        };
        let steps = steps(args, &target.family, settings.lang)?;
        let rows = prepare(&mut session, &mut target, settings, &steps, args.force).await?;
        jobs.push(Job { target, steps, rows });
    }
    let permit = match permit(&mut session, *ask, &jobs, settings.lang).await {
        Ok(Some(permit)) => permit,
        Ok(None) => return Ok(done(jobs, Vec::new(), settings)),
        Err(failure) if failure.class == Class::Port => {
            let failure = leave(&mut jobs, failure, lang);
            return Ok(done(jobs, vec![failure], settings));
        }
        Err(failure) => return Err(failure),
    };
    let mut failures = Vec::new();
    for job in &mut jobs {
        if carry_out(&mut session, job, settings, &permit, &mut failures).await {
            break;
        }
    }
    Ok(done(jobs, failures, settings))
}

/// Leaves out what is planned: the port went away before anything was sent.
fn leave(jobs: &mut [Job], mut failure: Failure, lang: Lang) -> Failure {
    failure.message = format!("{}; {}", failure.message, lang.pick("nothing was begun", "es wurde nichts begonnen"));
    let planned = jobs.iter_mut().flat_map(|job| &mut job.rows).filter(|row| row.result == WriteResult::Planned);
    for row in planned {
        row.result = WriteResult::Skipped;
        row.error = Some(ErrorDoc::from(&failure));
    }
    failure
}

/// What is to be written to one drive.
#[derive(Debug)]
pub(super) struct Job {
    pub(super) target: Target,
    pub(super) steps: Vec<Step>,
    pub(super) rows: Vec<Written>,
}

fn halves(text: &str) -> Result<(&str, &str), Failure> {
    text.split_once('=').ok_or_else(|| {
        Failure::new(Class::Usage, "usage.assignment", format!("expected PARAMETER=VALUE, got '{text}'"))
            .hint("for example 376@4=1.5kW")
    })
}

/// What the assignments name.
fn selectors(args: &Args) -> Result<Vec<Selector>, Failure> {
    let parsed = |text: &String| halves(text)?.0.parse().map_err(|error| select_failure(&error));
    args.assignments.iter().map(parsed).collect()
}

/// Reads the assignments; nothing is sent until all of them make sense.
fn steps(args: &Args, family: &Family, lang: Lang) -> Result<Vec<Step>, Failure> {
    let mut steps = Vec::new();
    for text in &args.assignments {
        let (who, what) = halves(text)?;
        let selector: Selector = who.parse().map_err(|error| select_failure(&error))?;
        if selector.is_group() {
            let message = format!("'{who}' is a group: one value for all of it makes no sense");
            return Err(Failure::new(Class::Usage, "usage.group", message).hint("name the parameters one by one"));
        }
        for selection in selector.resolve(family).map_err(|error| select_failure(&error))? {
            let mut param = selection.param;
            super::check_number(family, &param, lang)?;
            super::check_sets(family, selection.sets, lang)?;
            param.decimals = args.decimals.or(param.decimals);
            let kind = args.kind.or(param.kind);
            let raw = check(&param, family, what, kind, args.force)?;
            let sets = selection.sets.wire();
            steps.extend(sets.into_iter().map(|set| Step { param: param.clone(), set, raw, kind }));
        }
    }
    cutting_last(steps, lang)
}

/// Behind what cuts the line at once nobody is reached, so it goes last; and there is only one last.
fn cutting_last(mut steps: Vec<Step>, lang: Lang) -> Result<Vec<Step>, Failure> {
    steps.sort_by_key(|step| cuts(&step.param));
    let mut cutting = steps.iter().rev().take_while(|step| cuts(&step.param)).map(|step| step.param.label());
    let (Some(last), Some(other)) = (cutting.next(), cutting.next()) else { return Ok(steps) };
    let message = match lang {
        Lang::En => format!("{other} and {last} both cut the line or restart the drive at once; write them one by one"),
        Lang::De => format!("{other} und {last} kappen beide sofort die Leitung oder starten den Antrieb neu"),
    };
    Err(Failure::new(Class::Usage, "usage.cuts", message).hint(lang.pick(
        "behind the first the drive is reached with its new setting only; `line set` changes several and follows",
        "nach dem ersten ist der Antrieb nur mit der neuen Einstellung erreichbar; `line set` stellt mehrere um und folgt",
    )))
}

/// The raw value, if everything that the catalogue knows allows it.
fn check(param: &Param, family: &Family, text: &str, kind: Option<Type>, force: bool) -> Result<i64, Failure> {
    let bad = |code: &str, error: &ValueError| {
        let message = format!("parameter {} ({}): {error}", param.id, param.slug);
        Failure::new(Class::Data, code, message).with("param", param.id)
    };
    if !param.access.writes() && !force {
        let message = format!("parameter {} ({}) is read-only", param.id, param.slug);
        return Err(Failure::new(Class::Data, "data.read_only", message)
            .hint("--force sends it and lets the drive judge")
            .with("param", param.id));
    }
    if kind == Some(Type::String) {
        let message = format!("parameter {} ({}) is a text; Modbus carries numbers only", param.id, param.slug);
        return Err(Failure::new(Class::Data, "data.string", message).with("param", param.id));
    }
    let raw = value::parse(text, param, &family.choices(param)).map_err(|error| match &error {
        ValueError::NoScale { .. } => bad("data.no_scale", &error)
            .hint("name the decimals with --decimals, or write the raw integer in hexadecimal (0x…)"),
        _ => bad("data.value", &error),
    })?;
    if !force {
        value::check_range(raw, param)
            .map_err(|error| bad("data.range", &error).hint("--force sends it and lets the drive judge"))?;
    }
    if kind == Some(Type::Word) && raw < 0 && param.min.is_none_or(|min| min >= 0) {
        let error = ValueError::Width { value: format_decimal(raw, param.decimals_or_zero()), kind: "word" };
        return Err(bad("data.width", &error).hint("no source tells that it is signed; --type int says so"));
    }
    if let Some(kind) = kind {
        value::check_width(raw, kind, param.decimals_or_zero()).map_err(|error| bad("data.width", &error))?;
    }
    Ok(raw)
}

/// Shows what would be sent, without opening anything.
pub(super) fn plan_only(
    settings: &Settings,
    addresses: &[u8],
    family: &Family,
    steps: &[Step],
) -> Result<Outcome, Failure> {
    let mut values = Vec::new();
    for &address in addresses {
        for step in steps {
            let kind = step.kind.ok_or_else(|| no_width(&step.param, settings.lang))?;
            let row = describe::to_write(address, family, &step.param, step.set, step.raw, settings.lang);
            let mut row = Written { node: settings.node, ..row };
            tell(&mut row, telegram(settings, family, address, step, kind));
            values.push(row);
        }
    }
    let mut outcome = Outcome::of(Data::Write(Write { dry_run: true, values }));
    let proves = settings.lang.pick(
        "before the first of these every old value is read, after each the new one; what the drive has already is not sent",
        "vor dem ersten wird jeder alte Wert gelesen, nach jedem der neue; was der Antrieb schon hat, wird nicht gesendet",
    );
    outcome.warnings.push(Warning { code: "dry_run.reads".to_owned(), message: proves.to_owned() });
    if settings.drive.is_none() {
        outcome.warnings.push(Warning {
            code: "dry_run.family".to_owned(),
            message: format!("a dry run asks no drive: taken for '{}'; --drive names another", family.drive),
        });
    }
    Ok(outcome)
}

/// The telegram of a step, taken apart.
fn telegram(settings: &Settings, family: &Family, address: u8, step: &Step, kind: Type) -> Option<TelegramDoc> {
    let at = Cell { number: step.param.id, set: step.set };
    let bits = value::to_wire(step.raw, family.link.route.carried(kind)).ok()?;
    let reader = super::telegram_reader(settings, family);
    let proves = address != 0 && step.param.access.reads();
    let both = proves.then(|| reader.question(address, Inquiry::WriteAndRead(at, kind, bits))).flatten();
    both.or_else(|| reader.question(address, Inquiry::Write(at, kind, bits)))
}

/// Reads the old values and says what there is to do.
pub(super) async fn prepare(
    session: &mut Session<'_>,
    target: &mut Target,
    settings: &Settings,
    steps: &[Step],
    force: bool,
) -> Result<Vec<Written>, Failure> {
    let mut rows = Vec::new();
    for step in steps {
        let (address, lang) = (target.address, settings.lang);
        let row = describe::to_write(address, &target.family, &step.param, step.set, step.raw, lang);
        let mut row = Written { node: session.node(), ..row };
        if let Some(kind) = step.kind {
            target.set_width(step.param.id, kind);
        }
        if address != 0 && step.param.access.reads() {
            let mut reader = Reader::new(session, target, settings);
            let old = reader.rows(&step.param, wire_sets(step.set)).await?;
            if let [old] = old.as_slice() {
                (row.old_raw, row.old) = (old.raw, old.value);
            }
            let failures = reader.failures;
            if let Some(failure) = failures.into_iter().find(|failure| forbids(failure, force)) {
                return Err(nothing_sent(failure, lang));
            }
        }
        check_found(step, target, lang)?;
        if row.old_raw == Some(step.raw) && !force {
            row.result = WriteResult::Unchanged;
        }
        let kind = step.kind.or(target.known_width(step.param.id));
        tell(&mut row, kind.and_then(|kind| telegram(settings, &target.family, address, step, kind)));
        rows.push(row);
    }
    Ok(rows)
}

/// Whether a parameter that cannot be read must not be written either: one that the drive does not have would end the
/// run in the middle. Where the drive names another reason, such as that it can only be written, it may still be.
fn forbids(failure: &Failure, force: bool) -> bool {
    let names_another = failure.context.iter().any(|(key, code)| *key == "p11" && code != "0")
        && !["refused.unknown_parameter", "refused.data_set_not_permitted"].contains(&failure.code.as_str());
    failure.class != Class::Refused || !(force || names_another)
}

fn nothing_sent(failure: Failure, lang: Lang) -> Failure {
    let text = lang.pick("nothing was written", "es wurde nichts geschrieben");
    Failure { message: format!("{}; {text}", failure.message), ..failure }
}

/// The width that the drive has told, or that nobody tells, before anything is sent.
fn check_found(step: &Step, target: &Target, lang: Lang) -> Result<(), Failure> {
    let Some(kind) = step.kind.or(target.known_width(step.param.id)) else { return Err(no_width(&step.param, lang)) };
    value::check_width(step.raw, kind, step.param.decimals_or_zero()).map_err(|error| {
        let message = format!("{} ({}): {error}", step.param.label(), step.param.slug);
        nothing_sent(Failure::new(Class::Data, "data.width", message).with("param", step.param.id), lang)
    })
}

fn no_width(param: &Param, lang: Lang) -> Failure {
    let message = match lang {
        Lang::En => format!("parameter {}: no source tells its width, and nobody can be asked", param.id),
        Lang::De => format!("Parameter {}: keine Quelle nennt seine Breite, und fragen lässt sich niemand", param.id),
    };
    Failure::new(Class::Data, "data.width", message)
        .hint(lang.pick("name it with --type uint, int, word or long", "mit --type uint, int, word oder long angeben"))
}

fn tell(row: &mut Written, telegram: Option<TelegramDoc>) {
    row.meaning = telegram.as_ref().map(|doc| doc.meaning.clone());
    row.telegram = telegram.map(|doc| doc.hex);
}

fn wire_sets(set: u8) -> DataSets {
    let (set, store) = describe::place(set);
    DataSets::One(set, store)
}

/// Asks for permission for everything that is left to do; `None` if that is nothing.
pub(super) async fn permit(
    session: &mut Session<'_>,
    ask: &mut dyn gate::Ask,
    jobs: &[Job],
    lang: Lang,
) -> Result<Option<Permit>, Failure> {
    let todo = jobs.iter().flat_map(|job| job.steps.iter().zip(&job.rows).map(move |pair| (job, pair)));
    let todo: Vec<_> = todo.filter(|(_, (_, row))| row.result == WriteResult::Planned).collect();
    if todo.is_empty() {
        return Ok(None);
    }
    let mut hazards = vec![Hazard::Write];
    let mut details = Vec::new();
    for (job, (step, row)) in &todo {
        hazards.extend(hazards_of(step, &job.target.family));
        details.push(describe_step(step, row, &job.target.family, lang));
    }
    hazards.sort_unstable();
    hazards.dedup();
    if todo.len() > 1 && todo.iter().any(|(_, (step, _))| cuts(&step.param)) {
        let last =
            lang.pick("what cuts the line at once goes last", "was die Leitung sofort kappt, geht zuletzt hinaus");
        details.push(last.to_owned());
    }
    details.extend(hazards.iter().filter_map(|hazard| consequence(*hazard, lang)).map(str::to_owned));
    let title = match (todo.len(), lang) {
        (1, Lang::En) => "write 1 value".to_owned(),
        (1, Lang::De) => "1 Wert schreiben".to_owned(),
        (count, Lang::En) => format!("write {count} values"),
        (count, Lang::De) => format!("{count} Werte schreiben"),
    };
    super::asking::on_line(session, ask, &Question { hazards, title, details }, lang).await.map(Some)
}

fn hazards_of(step: &Step, family: &Family) -> Vec<Hazard> {
    let (_, store) = describe::place(step.set);
    let mut hazards = Vec::new();
    if store == Store::Eeprom && !step.param.is_volatile() && family.link.route.has_data_sets() {
        hazards.push(Hazard::Wear);
    }
    hazards.extend(step.param.hazard.map(|hazard| match hazard {
        HazardKind::Motion => Hazard::Motion,
        HazardKind::Line => Hazard::Line,
        HazardKind::Reset => Hazard::Reset,
    }));
    hazards
}

fn consequence(hazard: Hazard, lang: Lang) -> Option<&'static str> {
    let (en, de) = match hazard {
        Hazard::Write => return None,
        Hazard::Wear => (
            "EEPROM: each of these writes wears it a little; @ram does not",
            "EEPROM: jedes Schreiben nutzt es etwas ab; @ram nicht",
        ),
        Hazard::Motion => (
            "MOTION: this can start the shaft or change how it turns",
            "BEWEGUNG: das kann die Welle anlaufen lassen oder ihre Drehung ändern",
        ),
        Hazard::Line => (
            "LINE: this can cut the line to the drive; the old setting is shown above",
            "LEITUNG: das kann die Verbindung zum Antrieb kappen; die alte Einstellung steht oben",
        ),
        Hazard::Reset => (
            "RESET: the drive restarts or its faults are reset",
            "RESET: der Antrieb startet neu oder seine Störungen werden quittiert",
        ),
    };
    Some(lang.pick(en, de))
}

fn describe_step(step: &Step, row: &Written, family: &Family, lang: Lang) -> String {
    let unit = row.unit.as_ref().map_or_else(String::new, |unit| format!(" {unit}"));
    let old = row.old.map_or_else(|| "?".to_owned(), |old| format_decimal(old.raw, old.decimals));
    let new = format_decimal(row.raw, row.value.decimals);
    let text = row.text.as_ref().map_or_else(String::new, |text| format!(" ({text})"));
    let who = match row.address {
        0 => lang.pick("every drive", "alle Antriebe").to_owned(),
        address => super::who(address, row.node, &row.drive, lang),
    };
    let (label, store) = match family.link.route.has_data_sets() {
        true => (format!("P.{}@{}", row.param, row.data_set), format!(", {}", row.store)),
        false => (step.param.label(), String::new()),
    };
    format!("{who}: {label} {}: {old} -> {new}{unit}{text}{store}", row.name)
}

/// Writes what is planned for one drive. The first failure skips the rest; returns whether the session is over.
pub(super) async fn carry_out(
    session: &mut Session<'_>,
    job: &mut Job,
    settings: &Settings,
    permit: &Permit,
    failures: &mut Vec<Failure>,
) -> bool {
    let (address, lang) = (job.target.address, settings.lang);
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
        let fate = match begin(session, &mut job.target, step).await {
            Ok(kind) => {
                tell(row, telegram(settings, &job.target.family, address, step, kind));
                let order = Order { set: step.set, raw: step.raw, kind, read_back: reads_back(&step.param) };
                let fate = job.target.write(session, &step.param, order, permit).await;
                let fate = proven_there(session, &job.target, step, fate).await;
                fate.map_err(|error| (error, WriteResult::Unknown))
            }
            Err(error) => Err((error, WriteResult::Skipped)),
        };
        let failure = match fate {
            Ok(fate) => {
                row.result = result(&fate);
                unproven(&fate, &job.target, row, settings)
            }
            Err((error, otherwise)) => {
                row.result = if error.is_refused() { WriteResult::Refused } else { otherwise };
                let mut failure = error.failure(address, Some(&job.target.family), lang);
                if row.result == WriteResult::Skipped {
                    failure.message = match lang {
                        Lang::En => format!("{}; P.{} was not begun", failure.message, row.param),
                        Lang::De => format!("{}; P.{} wurde nicht begonnen", failure.message, row.param),
                    };
                }
                Some(failure)
            }
        };
        if let Some(failure) = failure {
            let failure = failure.with("param", step.param.id);
            row.error = Some(ErrorDoc::from(&failure));
            over = is_over(&failure);
            stopped = true;
            failures.push(failure);
        }
    }
    over
}

/// What became of a write behind which the drive has another address at once: there it is asked.
async fn proven_there(
    session: &mut Session<'_>,
    target: &Target,
    step: &Step,
    fate: Result<WriteFate, AccessError>,
) -> Result<WriteFate, AccessError> {
    let role = if session.protocol().name() == "vabus" { "node-id" } else { "address" };
    let family = &target.family;
    let at_once = family.link.line.address == Holds::AtOnce && cuts(&step.param);
    let moves = at_once && family.role(role).is_some_and(|param| param.id == step.param.id);
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

/// How wide the value goes out, with a look at the line: at the question somebody may have unplugged the adapter or pressed
/// Ctrl-C. Nothing that fails here has changed anything.
async fn begin(session: &mut Session<'_>, target: &mut Target, step: &Step) -> Result<Type, AccessError> {
    session.rest(Span::ZERO).await?;
    target.width(session, &step.param, step.set).await
}

/// Whether reading back proves anything: not where the line or the drive is gone at once.
fn reads_back(param: &Param) -> bool {
    param.access.reads() && !cuts(param)
}

/// Whether the line or the drive is gone at once behind a write.
fn cuts(param: &Param) -> bool {
    match param.hazard {
        Some(HazardKind::Line) => param.effective == Effective::AtOnce,
        Some(HazardKind::Reset) => true,
        Some(HazardKind::Motion) | None => false,
    }
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

fn unproven(fate: &WriteFate, target: &Target, row: &Written, settings: &Settings) -> Option<Failure> {
    let address = target.address;
    match fate {
        WriteFate::Verified | WriteFate::Written | WriteFate::Broadcast => None,
        WriteFate::Differs(raw) => {
            let read = format_decimal(*raw, row.value.decimals);
            let message = format!("drive {address} took the telegram, but P.{} reads back as {read}", row.param);
            Some(
                Failure::new(Class::Refused, "refused.reads_back_differently", message)
                    .hint("the drive limits the value, or something else writes it too"),
            )
        }
        WriteFate::Unknown(error) => {
            let mut failure = error.failure(address, Some(&target.family), settings.lang);
            failure.message = format!("whether P.{} was written is unknown: {}", row.param, failure.message);
            Some(failure)
        }
    }
}

/// Puts the rows of all drives together.
fn done(jobs: Vec<Job>, failures: Vec<Failure>, settings: &Settings) -> Outcome {
    let mut warnings = Vec::new();
    for job in &jobs {
        for (step, row) in job.steps.iter().zip(&job.rows) {
            warnings.extend(way_back(step, row, &job.target.family, settings));
        }
    }
    let values: Vec<Written> = jobs.into_iter().flat_map(|job| job.rows).collect();
    if values.iter().any(|row| row.address == 0 && row.result == WriteResult::Broadcast) {
        let message = settings.lang.pick(
            "sent to everybody: no drive confirms it, so nobody knows whether it was taken; read it back drive by drive",
            "an alle gesendet: kein Antrieb bestätigt das, ob es angenommen wurde, weiß niemand; einzeln zurücklesen",
        );
        warnings.push(Warning { code: "write.broadcast".to_owned(), message: message.to_owned() });
    }
    let succeeded = values.iter().filter(|row| row.error.is_none() && row.result != WriteResult::Skipped).count();
    let failure = summary(failures, succeeded, settings.lang);
    Outcome { data: Some(Data::Write(Write { dry_run: false, values })), warnings, failure }
}

/// How to get back to a drive whose line settings were changed.
fn way_back(step: &Step, row: &Written, family: &Family, settings: &Settings) -> Option<Warning> {
    let sent = matches!(row.result, WriteResult::Verified | WriteResult::Written | WriteResult::Unknown);
    if !sent || step.param.hazard != Some(HazardKind::Line) {
        return None;
    }
    let lang = settings.lang;
    let is_address = family.role("address").is_some_and(|param| param.id == step.param.id);
    let when = match (step.param.effective, is_address, family.link.line.address) {
        (Effective::Reset, ..) => lang.pick("after the next reset", "nach dem nächsten Reset"),
        (_, true, Holds::Unsaid) => lang.pick(
            "from now on or after the next power-on, which its manual does not say,",
            "ab jetzt oder nach dem nächsten Einschalten, was die Anleitung nicht sagt,",
        ),
        _ => lang.pick("from now on", "ab jetzt"),
    };
    let unknown = || lang.pick("its old value", "den alten Wert").to_owned();
    let old = row.old.map_or_else(unknown, |old| format_decimal(old.raw, old.decimals));
    let new = row.text.clone().unwrap_or_else(|| format_decimal(row.raw, row.value.decimals));
    let (label, address, line, protocol) = (step.param.label(), row.address, settings.line, settings.protocol.name());
    let message = match lang {
        Lang::En => format!(
            "{label} is {new}: {when} the drive is no longer reached with address {address} at {line} {protocol}; the way \
             back is to write {old} with the new setting"
        ),
        Lang::De => format!(
            "{label} ist {new}: {when} ist der Antrieb nicht mehr mit Adresse {address} bei {line} {protocol} erreichbar; \
             zurück führt, mit der neuen Einstellung {old} zu schreiben"
        ),
    };
    Some(Warning { code: "line.changed".to_owned(), message })
}
