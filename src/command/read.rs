//! `read`: values of parameters.

use super::lines::OverLines;
use super::profibus::{self, SlaveArgs};
pub(super) use super::selecting::select_failure;
use super::verb::{Verb, Working};
use super::{
    Context, Reader, addresses_to_read, check_number, check_sets, connect, finish, is_over, known_somewhere, offline,
    plan, read_question, target,
};
use crate::args::Takes;
use crate::drive::{Upper, describe};
use crate::failure::Failure;
use crate::outcome::{Data, Document, OrLines, OrPlan, Outcome, Read, Value, Warning};
use crate::profile::{Family, Selection, Selector, Type};
use clap::Args as ClapArgs;

/// Reads parameters.
///
/// A parameter is named by its number (372), its slug (rated-speed), or its English or German name; @N behind it picks
/// a data set (372@2), @all all four, @ram and @2ram the RAM copies. Several at once, ranges (480-483) and groups
/// (@actual, @modbus, @setpoints, @motor, @systembus, @all) work too. Without a parameter @actual is read.
///
/// Where the four data sets differ, set 0 cannot be read; then all four are shown side by side.
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    /// 372, 372@2, rated-speed@all, 480-483, @actual
    #[arg(value_name = "PARAMETER")]
    pub params: Vec<String>,

    /// uint, int, word or long, whatever the catalogue says
    #[arg(long = "type", value_name = "TYPE")]
    pub kind: Option<Type>,

    /// Decimals, whatever the catalogue says
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(0..=6))]
    pub decimals: Option<u8>,

    /// How a slave is taken.
    #[command(flatten)]
    pub slave: SlaveArgs,
}

impl Verb for Args {
    const NAME: &'static str = "read";
    const TAKES: Takes = Takes::READS;
    const PROFIBUS: bool = true;
    const SDO: bool = true;
    const EXAMPLES: &'static [&'static str] = &[
        "antrieb --port sim -a 1 read 372@2 481 @actual",
        "antrieb --port sim -a 1 read rated-speed@all",
        "antrieb --port sim -a 1 read 1234 --type uint --decimals 2 --dry-run",
        "antrieb --port sim --protocol dp -a 3 read F002 915.1 --yes",
    ];
    const UPPER: Upper = Upper::drive(30)
        .each(12, "parameter")
        .unless("Over PROFIBUS a motor that becomes slower under the stop word is waited for as well.");
    type Prints = Document<OrPlan<OrLines<Read>>>;

    fn over_lines(&self) -> OverLines {
        OverLines::Each
    }

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(run(self, context))
    }
}

/// Reads the parameters of every drive that was named.
pub async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    if args.slave.is_meant(context.settings)? {
        profibus::refuse(&[("--type", args.kind.is_some()), ("--decimals", args.decimals.is_some())])?;
        let actual = ["@actual".to_owned()];
        let typed = if args.params.is_empty() { &actual[..] } else { &args.params };
        return profibus::read::read(typed, &args.slave, context).await;
    }
    let selectors = selectors(&args.params)?;
    let Context { settings, registry, interrupt, observe, .. } = context;
    let addresses = addresses_to_read(settings, *observe)?;
    let named = || {
        known_somewhere(settings, registry, &selectors)?;
        offline(settings, registry, |family| select(&selectors, family, args))
    };
    if settings.dry_run {
        let (family, selections) = named()?;
        let sets = selections.iter().flat_map(|one| one.sets.wire().into_iter().map(move |set| (&one.param, set)));
        let questions: Vec<_> = sets.map(|(param, set)| read_question(param, set)).collect();
        return plan(context, &family, &questions);
    }
    // The catalogue is read while the open line keeps the silence before its first telegram. A wrong name is told before
    // trouble with the port; some drive must know all of them.
    let session = connect(settings, registry, interrupt, *observe).await;
    let (family, _) = named()?;
    let shows_register = shows_register(&selectors, &family, args)?;
    let mut session = session?;
    let mut haul = Haul::default();
    let most = select(&selectors, &family, args)?.len();
    for address in addresses {
        let begun = session.now();
        session.allow(begun, <Args as Verb>::UPPER.questions(most as u64));
        let mut target = match target(&mut session, settings, registry, address, shows_register).await {
            Ok(target) => target,
            Err(failure) => {
                let over = is_over(&failure);
                let selections = select(&selectors, &family, args)?;
                // Every row counts, whatever it is missing for.
                let rows = unreachable(address, &selections, &family, &failure);
                haul.failures.extend(std::iter::repeat_n(failure, rows.len().max(1)));
                haul.values.extend(rows);
                if over {
                    break;
                }
                continue;
            }
        };
        let selections = select(&selectors, &target.family, args)?;
        session.allow(begun, <Args as Verb>::UPPER.questions(selections.len() as u64));
        if let Some(kind) = args.kind {
            selections.iter().for_each(|selection| target.set_width(selection.param.id, kind));
        }
        let reader = Reader::new(&mut session, &mut target);
        if !haul.take(reader, &selections).await {
            break;
        }
    }
    let Haul { values, failures, warnings } = haul;
    let succeeded = values.iter().filter(|value| value.error.is_none()).count();
    Ok(finish(Data::Read(Read { values }), failures, succeeded, warnings))
}

/// What was read so far, and what came of the rest.
#[derive(Debug, Default)]
struct Haul {
    values: Vec<Value>,
    failures: Vec<Failure>,
    warnings: Vec<Warning>,
}

impl Haul {
    /// Reads one drive; `false` if the session is over.
    async fn take(&mut self, mut reader: Reader<'_, '_>, selections: &[Selection]) -> bool {
        let params: Vec<_> = selections.iter().map(|selection| selection.param.clone()).collect();
        let mut fetched = reader.fetch(&params).await;
        for Selection { param, sets, lenient, .. } in selections {
            reader.lenient = *lenient;
            let rows = match std::mem::replace(&mut fetched, Ok(())) {
                Ok(()) => reader.rows(param, *sets).await,
                Err(failure) => Err(failure),
            };
            match rows {
                Ok(rows) => self.values.extend(rows),
                Err(failure) => {
                    let (address, set) = (reader.target.address, sets.wire().first().copied().unwrap_or(0));
                    let family = &reader.target.family;
                    self.values.push(describe::unread(address, family, param, set, &failure));
                    self.failures.push(failure);
                    return false;
                }
            }
        }
        self.warnings.append(&mut reader.warnings);
        self.failures.extend(reader.into_failures().0);
        true
    }
}

/// Reads what the user typed; without anything, the group of actual values.
fn selectors(params: &[String]) -> Result<Vec<Selector>, Failure> {
    if params.is_empty() {
        return Ok(vec![Selector::group("actual")]);
    }
    params.iter().map(|text| text.parse().map_err(|error| select_failure(&error))).collect()
}

fn select(selectors: &[Selector], family: &Family, args: &Args) -> Result<Vec<Selection>, Failure> {
    let mut selections = Vec::new();
    for selector in selectors {
        selections.extend(selector.resolve(family).map_err(|error| select_failure(&error))?);
    }
    for selection in &mut selections {
        check_number(family, &selection.param)?;
        check_sets(family, selection.sets)?;
        if let Some(decimals) = args.decimals {
            selection.param.decimals = Some(decimals);
        }
        if let Some(kind) = args.kind {
            selection.param.kind = Some(kind);
            selection.param.unconfirmed.retain(|field| field != "type" && field != "row");
        }
    }
    Ok(selections)
}

/// Whether the error register is among what is read.
fn shows_register(selectors: &[Selector], family: &Family, args: &Args) -> Result<bool, Failure> {
    let register = family.role("error-register").map(|param| param.id);
    Ok(select(selectors, family, args)?.iter().any(|selection| Some(selection.param.id) == register))
}

/// The rows of a drive that does not answer at all.
fn unreachable(address: u8, selections: &[Selection], family: &Family, failure: &Failure) -> Vec<Value> {
    let rows =
        selections.iter().flat_map(|selection| selection.sets.wire().into_iter().map(move |set| (selection, set)));
    rows.map(|(selection, set)| Value {
        drive: "unknown".to_owned(),
        ..describe::unread(address, family, &selection.param, set, failure)
    })
    .collect()
}
