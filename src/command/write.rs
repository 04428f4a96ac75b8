//! `write`: set parameters, with proof.

mod relief;

use super::lines::OverLines;
use super::profibus::{self, SlaveArgs};
use super::read::select_failure;
use super::verb::{Verb, Working};
use super::{Context, addresses_to_write, asking, connect, offline, target_to_change, terms};
use crate::args::{Takes, below_zero};
use crate::drive::job::{self, Job, Step};
use crate::drive::motion::{foreseen, present};
use crate::drive::{Session, Target, Terms, Upper, describe};
use crate::failure::{Class, Failure};
use crate::gate::{Ask, Hazard, Permit, Writes, Writing};
use crate::outcome::{Data, Document, Event, Outcome, Warning, Write, Written};
use crate::profile::value::{self, ValueError};
use crate::profile::{DataSets, Family, HazardKind, Param, Role, Selector, Store, Type};
use crate::text::{Text, both};
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
/// read back. What the drive has already is not sent again. Nobody is asked for what can only take motion away: the control
/// words 0 and 2, and a setpoint of zero, unless the drive adds another one to it that turns the shaft the other way.
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    /// PARAMETER=VALUE, such as 480=12,5Hz or 376@4=1.5kW
    ///
    /// Or as two words: 376@4 1.5kW, 480 -12,5Hz.
    #[arg(value_name = "PARAMETER=VALUE", required = true, allow_negative_numbers = true, value_parser = below_zero::word)]
    pub assignments: Vec<String>,

    /// uint, int, word or long, whatever the catalogue says
    #[arg(long = "type", value_name = "TYPE")]
    pub kind: Option<Type>,

    /// Decimals, whatever the catalogue says
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(0..=6))]
    pub decimals: Option<u8>,

    /// Send also what is forbidden or changes nothing
    ///
    /// What the catalogue forbids is judged by the drive then.
    #[arg(long)]
    pub force: bool,

    /// How a slave is taken.
    #[command(flatten)]
    pub slave: SlaveArgs,
}

impl Verb for Args {
    const NAME: &'static str = "write";
    const TAKES: Takes = Takes::WRITES;
    const PROFIBUS: bool = true;
    const SDO: bool = true;
    const EXAMPLES: &'static [&'static str] = &[
        "antrieb --port sim -a 1 write 376@4=1.5kW 480@1=6Hz --yes",
        "antrieb --port sim -a 1 write 480@1ram=6,5 --dry-run",
        "antrieb --port sim --protocol dp -a 3 write F002=5s 915.1=34 --yes",
    ];
    const UPPER: Upper = Upper::drive(30)
        .each(16, "value")
        .unless("Over PROFIBUS a motor that becomes slower under the stop word is waited for as well.");
    type Prints = Document<Write>;

    fn over_lines(&self) -> OverLines {
        OverLines::One(Some(both!(
            "one call for each line, with its port behind -p; a parameter file with these values goes into all of them with `dataset load`, \
             behind one question, and can be taken back",
            "ein Aufruf für jede Leitung, mit ihrem Anschluss hinter -p; eine Parameterdatei mit diesen Werten geht mit `dataset load` in \
             alle, hinter einer Frage, und lässt sich zurücknehmen"
        )))
    }

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(run(self, context))
    }
}

/// Writes to every drive that was named.
pub async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    if args.slave.is_meant(context.settings)? {
        return over_profibus(args, context).await;
    }
    let addresses = addresses_to_write(context.settings)?;
    super::known_somewhere(context.settings, context.registry, &selectors(args)?)?;
    let terms = terms(context.settings, context.registry)?;
    let (family, planned) = offline(context.settings, context.registry, |family| steps(args, family, &terms))?;
    super::on_bus::check(context.settings, &planned)?;
    for note in
        [better_by_line(&planned, &family, terms.own_address()), is_a_stop(&planned, &family)].into_iter().flatten()
    {
        (context.observe)(Event::Note(note));
    }
    if context.settings.dry_run {
        return plan_only(&terms, &addresses, &family, &planned);
    }
    let Context { settings, registry, interrupt, observe, ask, .. } = context;
    let mut session = connect(settings, registry, interrupt, *observe).await?;
    let mut jobs = Vec::new();
    for address in addresses {
        let mut target = match address {
            0 => Target::new(0, family.clone()).in_word_order(settings.word_order),
            _ => target_to_change(&mut session, settings, registry, address).await.map_err(job::nothing_sent)?,
        };
        let steps = steps(args, &target.family, &terms)?;
        let rows = job::prepare(&mut session, &mut target, &terms, &steps, args.force).await?;
        jobs.push(Job { target, steps, rows });
    }
    let mut failures = Vec::new();
    if let Some(permit) = relief::permit(&mut session, &mut jobs).await? {
        carry_out(&mut session, &mut jobs, &terms, &permit, &mut failures).await;
        return Ok(job::done(jobs, failures, &terms));
    }
    let permit = match permit(&mut session, *ask, &mut jobs).await {
        Ok(Some(permit)) => permit,
        Ok(None) => return Ok(job::done(jobs, Vec::new(), &terms)),
        // Nothing was begun; a script is told what it would have been asked about.
        Err(failure) if failure.class == Class::Port || !ask.is_there() => {
            let failure = job::leave(&mut jobs, failure);
            return Ok(job::done(jobs, vec![failure], &terms));
        }
        Err(failure) => return Err(failure),
    };
    carry_out(&mut session, &mut jobs, &terms, &permit, &mut failures).await;
    Ok(job::done(jobs, failures, &terms))
}

async fn carry_out(
    session: &mut Session<'_>,
    jobs: &mut [Job],
    terms: &Terms<'_>,
    permit: &Permit<impl Writes>,
    failures: &mut Vec<Failure>,
) {
    for job in jobs {
        if job::carry_out(session, job, terms, permit, failures).await {
            break;
        }
    }
}

/// The same with PROFIBUS spoken: an inverter has no data sets, and its parameters have types of their own.
async fn over_profibus(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    profibus::refuse(&[("--type", args.kind.is_some()), ("--decimals", args.decimals.is_some())])?;
    let assigned = |family: &Family, who: &str, what: &str| assigned(args, family, who, what);
    let wanted = profibus::write::Wanted { assignments: assignments(args)?, assigned: &assigned, force: args.force };
    let mut outcome = profibus::write::write(&wanted, &args.slave, context).await?;
    outcome.warnings.extend(context.settings.dry_run.then(dry_run_reads));
    Ok(outcome)
}

/// Asks for permission for everything that is left to do, and looks again what stands there; `None` if that is nothing.
pub(super) async fn permit(
    session: &mut Session<'_>,
    ask: &mut dyn Ask,
    jobs: &mut [Job],
) -> Result<Option<Permit<Writing>>, Failure> {
    let Some(mut question) = job::question(jobs, session.own_address()) else { return Ok(None) };
    if question.hazards.contains(&Hazard::Motion) && ask.is_there() && ask.takes_time() {
        for job in jobs.iter_mut().filter(|job| job.target.address != 0) {
            let family = job.target.family.clone();
            let is_start = |role| job.steps.iter().any(|step| Some(&step.param) == family.role(role));
            let starts = is_start("control-word") || is_start("control-mode");
            question.details.extend(present(session, &mut job.target, starts).await);
            let coming: Vec<_> = job.steps.iter().map(|step| (&step.param, step.set, step.raw)).collect();
            question.details.extend(foreseen(session, &mut job.target, &coming).await.unwrap_or_default());
        }
    }
    let permit = asking::on_line(session, ask, &question).await?;
    if ask.takes_time() {
        job::look_again(session, jobs).await;
    }
    Ok(Some(permit))
}

/// What was typed as `PARAMETER=VALUE`, or as two words: `PARAMETER VALUE`.
fn assignments(args: &Args) -> Result<Vec<(&str, &str)>, Failure> {
    let mut found = Vec::new();
    let mut words = args.assignments.iter();
    while let Some(text) = words.next() {
        let behind = || words.clone().next().filter(|value| !value.contains('='));
        match (text.split_once('='), behind()) {
            (Some(halves), _) => found.push(halves),
            (None, Some(value)) => {
                found.push((text.as_str(), value.as_str()));
                words.next();
            }
            (None, None) => {
                let message =
                    both!("expected PARAMETER=VALUE, got '{text}'", "erwartet: PARAMETER=WERT; angegeben: '{text}'");
                let hint = match found.last().filter(|(_, value)| is_number(value)) {
                    Some((name, value)) => both!(
                        "a unit stands behind its number without a blank: {name}={value}{text}",
                        "eine Einheit steht ohne Leerzeichen hinter der Zahl: {name}={value}{text}"
                    ),
                    None => both!("for example 376@4=1.5kW", "zum Beispiel 376@4=1.5kW"),
                };
                return Err(Failure::new(Class::Usage, "usage.assignment", message).hint(hint));
            }
        }
    }
    Ok(found)
}

fn is_number(text: &str) -> bool {
    text.contains(|letter: char| letter.is_ascii_digit())
        && text.chars().all(|letter| letter.is_ascii_digit() || matches!(letter, '.' | ',' | '-'))
}

/// What is a setting of the line has a verb of its own, which goes with it.
fn better_by_line(steps: &[Step], family: &Family, own: Option<Role>) -> Option<Text> {
    let verbs = [
        (own.unwrap_or(Role::Address), "line set --address"),
        (Role::BaudRate, "line set --baud"),
        (Role::Parity, "line set --parity"),
        (Role::Protocol, "protocol set"),
    ];
    let cuts = |step: &Step| step.param.hazard == Some(HazardKind::Line);
    let is_written =
        |role: Role| family.role(role).filter(|param| steps.iter().any(|step| cuts(step) && step.param.id == param.id));
    let (param, verb) = verbs.into_iter().find_map(|(role, verb)| Some((is_written(role)?, verb)))?;
    Some(both!(
        "{label} is a setting of the line: `{verb}` changes it, follows the drive and proves that it answers",
        "{label} ist eine Einstellung der Leitung: `{verb}` ändert sie, folgt dem Antrieb und prüft, dass er antwortet",
        label = param.label()
    ))
}

/// Whoever stops a drive by hand has a verb that is quicker, and tells what came of it.
fn is_a_stop(steps: &[Step], family: &Family) -> Option<Text> {
    let (step, (verb, _)) = steps.iter().find_map(|step| Some((step, relief::stop(step, family)?)))?;
    Some(both!(
        "{label} = {word} is a stop: `antrieb statemachine {verb}` sends it at once and looks what came of it",
        "{label} = {word} ist ein Halt: `antrieb statemachine {verb}` sendet ihn sofort und sieht nach, was daraus wurde",
        label = step.param.label(),
        word = step.raw
    ))
}

/// What the assignments name.
fn selectors(args: &Args) -> Result<Vec<Selector>, Failure> {
    let parsed = |(who, _): (&str, &str)| who.parse().map_err(|error| select_failure(&error));
    assignments(args)?.into_iter().map(parsed).collect()
}

/// Reads the assignments; nothing is sent until all of them make sense.
fn steps(args: &Args, family: &Family, terms: &Terms<'_>) -> Result<Vec<Step>, Failure> {
    let mut steps = Vec::new();
    for (who, what) in assignments(args)? {
        let here = |step: Step| Step { param: terms.on_line(family, &step.param), ..step };
        steps.extend(assigned(args, family, who, what)?.into_iter().map(here));
    }
    once_each(&steps)?;
    cutting_last(steps, family, (terms.own_address(), terms.speech.node))
}

/// Refuses what would be overwritten by something behind it: data set 0 is all four, and what is stored goes into the RAM as well (CM-485 manual 7).
fn once_each(steps: &[Step]) -> Result<(), Failure> {
    let covers = |later: &Step, step: &Step| {
        let ((all, store), (one, other)) = (describe::place(later.set), describe::place(step.set));
        (all == 0 || all == one) && (store == Store::Eeprom || store == other)
    };
    for (nth, step) in steps.iter().enumerate() {
        let later = steps.iter().skip(nth + 1).find(|later| later.param.id == step.param.id && covers(later, step));
        let Some(later) = later else { continue };
        let place = |step: &Step| match (step.param.label(), describe::sets(step.set)) {
            (label, DataSets::One(0, Store::Eeprom)) => label,
            (label, sets) => format!("{label}@{sets}"),
        };
        let message = both!(
            "{first} would be overwritten by {then} behind it: nothing was sent",
            "{first} würde von {then} dahinter überschrieben: es wurde nichts gesendet",
            first = place(step),
            then = place(later)
        );
        return Err(Failure::new(Class::Usage, "usage.twice", message).hint(both!(
            "name each place once; a value for all data sets goes before that for one",
            "jede Stelle einmal nennen; ein Wert für alle Datensätze steht vor dem für einen"
        )));
    }
    Ok(())
}

/// One of them: a step for each parameter and data set that it names.
fn assigned(args: &Args, family: &Family, who: &str, what: &str) -> Result<Vec<Step>, Failure> {
    let selector: Selector = who.parse().map_err(|error| select_failure(&error))?;
    if selector.is_group() {
        let message = both!(
            "'{who}' is a group: one value for all of it makes no sense",
            "'{who}' ist eine Gruppe: ein Wert für alle daraus ergibt keinen Sinn"
        );
        return Err(Failure::new(Class::Usage, "usage.group", message)
            .hint(both!("name the parameters one by one", "die Parameter einzeln nennen")));
    }
    let mut steps = Vec::new();
    for selection in selector.resolve(family).map_err(|error| select_failure(&error))? {
        let mut param = selection.param;
        super::check_number(family, &param)?;
        super::check_sets(family, selection.sets)?;
        param.decimals = args.decimals.or(param.decimals);
        let kind = args.kind.or(param.kind);
        let raw = check(&param, family, what, kind, args.force)?;
        let sets = selection.sets.wire();
        steps.extend(sets.into_iter().map(|set| Step { param: param.clone(), set, raw, kind, at: None }));
    }
    Ok(steps)
}

/// Behind what cuts the line at once nobody is reached, so it goes last; and there is only one last.
fn cutting_last(mut steps: Vec<Step>, family: &Family, (own, node): (Option<Role>, u8)) -> Result<Vec<Step>, Failure> {
    let cuts = |step: &Step| job::cuts(&step.param, family, own);
    steps.sort_by_key(cuts);
    let mut cutting = steps.iter().rev().take_while(|step| cuts(step)).map(|step| step.param.label());
    let (Some(last), Some(other)) = (cutting.next(), cutting.next()) else { return Ok(steps) };
    let message = both!(
        "{other} and {last} both can cut the line or restart the drive at once; write them one by one",
        "{other} und {last} können beide sofort die Leitung kappen oder den Antrieb neu starten; einzeln schreiben"
    );
    let hint = match node {
        0 => both!(
            "behind the first the drive is reached with its new setting only; `line set` changes several and follows",
            "nach dem ersten ist der Antrieb nur mit der neuen Einstellung erreichbar; `line set` stellt mehrere um und \
             folgt"
        ),
        _ => both!(
            "behind each of them it is looked whether the node still answers; `line set` follows no node behind a drive",
            "nach jedem wird geprüft, ob der Knoten noch antwortet; `line set` folgt keinem Knoten hinter einem Antrieb"
        ),
    };
    Err(Failure::new(Class::Usage, "usage.cuts", message).hint(hint))
}

/// The raw value, if everything that the catalogue knows allows it.
fn check(param: &Param, family: &Family, text: &str, kind: Option<Type>, force: bool) -> Result<i64, Failure> {
    let (number, called) = (param.id, param.called());
    let label = match param.is_named() {
        true => both!("parameter {number} ({called})", "Parameter {number} ({called})", called),
        false => both!("parameter {number}", "Parameter {number}"),
    };
    let bad = |code: &str, error: &ValueError| {
        let message = both!("{label}: {why}", "{label}: {why}", label, why = error.text());
        Failure::new(Class::Data, code, message).with("param", param.id)
    };
    if !param.access.writes() && !force {
        let message = both!("{label} is read-only", "{label} ist nur lesbar", label);
        return Err(Failure::new(Class::Data, "data.read_only", message).hint(force_sends()).with("param", param.id));
    }
    if kind == Some(Type::String) {
        let message = both!(
            "{label} is a text; Modbus carries numbers only",
            "{label} ist ein Text; Modbus überträgt nur Zahlen",
            label
        );
        return Err(Failure::new(Class::Data, "data.string", message).with("param", param.id));
    }
    let raw = value::parse(text, param, &family.choices(param)).map_err(|error| match &error {
        ValueError::NoScale { .. } => bad("data.no_scale", &error).hint(both!(
            "name the decimals with --decimals, or write the raw integer in hexadecimal (0x…)",
            "die Nachkommastellen mit --decimals angeben, oder den Rohwert hexadezimal schreiben (0x…)"
        )),
        _ => bad("data.value", &error),
    })?;
    if !force {
        value::check_range(raw, param).map_err(|error| bad("data.range", &error).hint(force_sends()))?;
    }
    if let Some(kind) = kind {
        value::check_type(raw, kind, param).map_err(|error| match kind == Type::Word && raw < 0 {
            true => bad("data.width", &error).hint(both!(
                "no source tells that it is signed; --type int says so",
                "keine Quelle nennt ein Vorzeichen; --type int gibt eines an"
            )),
            false => bad("data.width", &error),
        })?;
    }
    Ok(raw)
}

fn force_sends() -> Text {
    both!("--force sends it and lets the drive judge", "--force sendet ihn und überlässt das Urteil dem Antrieb")
}

/// Shows what would be sent, without opening anything.
pub(super) fn plan_only(
    terms: &Terms<'_>,
    addresses: &[u8],
    family: &Family,
    steps: &[Step],
) -> Result<Outcome, Failure> {
    let mut values = Vec::new();
    for &address in addresses {
        for step in steps {
            let kind = step.kind.ok_or_else(|| job::no_width(&step.param))?;
            let row = describe::to_write(address, family, &step.param, step.set, step.raw);
            let mut row = Written { node: terms.speech.node, ..row };
            job::tell(&mut row, job::telegram(terms, family, address, step, kind));
            values.push(row);
        }
    }
    let mut outcome = Outcome::of(Data::Write(Write { dry_run: true, values }));
    outcome.warnings.push(dry_run_reads());
    if terms.said().is_none() {
        outcome.warnings.push(Warning {
            code: "dry_run.family".to_owned(),
            message: both!(
                "a dry run asks no drive: taken for '{drive}'; --drive names another",
                "ein Probelauf fragt keinen Antrieb: angenommen ist '{drive}'; --drive nennt einen anderen",
                drive = family.drive
            ),
        });
    }
    Ok(outcome)
}

/// What a dry run of writes cannot show.
pub(super) fn dry_run_reads() -> Warning {
    let proves = both!(
        "before the first of these every old value is read, after each the new one; what the drive has already is \
         not sent",
        "vor dem ersten wird jeder alte Wert gelesen, nach jedem der neue; was der Antrieb schon hat, wird nicht \
         gesendet"
    );
    Warning { code: "dry_run.reads".to_owned(), message: proves }
}
