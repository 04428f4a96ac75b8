//! `check`: do the drives of a plant have what their files say?

use super::lines::{Wanted, on_lines, wanted};
use super::{project, told};
use crate::args::Takes;
use crate::command::dataset::scope::Picks;
use crate::command::dataset::weighing::{Weighed, against_target};
use crate::command::verb::{Verb, Working};
use crate::command::{Context, behind, read_question, telegram_reader};
use crate::drive::paramfile::{Asking, of_file, ram_sets};
use crate::drive::plant::Line;
use crate::drive::transaction::{Choice, NO_VALUES};
use crate::drive::{Upper, is_over};
use crate::failure::{Class, Failure};
use crate::outcome::{Data, Document, Event, OrPlan, Outcome, Plan, PlantCheck, PlantComparison};
use crate::profile::Goes;
use crate::text::{Text, both};
use clap::Args as ClapArgs;
use futures_util::future::join_all;
use std::collections::BTreeSet;

/// Holds the drives of antrieb.toml against their files; 1 if one differs.
///
/// Asked is what the files hold, and nothing else, all ports at once, the drives of a line in turn. A drive that does not answer, or
/// is another one than antrieb.toml says, is named (exit 9).
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    #[command(flatten)]
    picks: Picks,
}

impl Verb for Args {
    const NAME: &'static str = "check";
    const OF_PLANT: bool = true;
    const TAKES: Takes = Takes::READS;
    const EXAMPLES: &'static [&'static str] = &[
        "antrieb --port sim --config plant.toml check",
        "antrieb --port sim --config plant.toml -a pump check --json",
    ];
    const UPPER: Upper = Upper::drive(30).each(48, "parameter");
    type Prints = Document<OrPlan<PlantCheck>>;

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(run(self, context))
    }
}

async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let mut wanted = wanted(context, &Choice::everything())?;
    let families = wanted.iter().map(|one| one.opened.family.clone()).collect();
    let choice = Choice { families, ..args.picks.choice() };
    let mut none = Vec::new();
    for (index, one) in wanted.iter_mut().enumerate() {
        match one.opened.pick(&choice) {
            // Others may have some of it.
            Err(failure) if failure.code == NO_VALUES => none.push((index, failure)),
            picked => picked?,
        }
    }
    if let (Some((_, failure)), true) = (none.first(), none.len() == wanted.len()) {
        return Err(failure.clone());
    }
    for (index, _) in none.into_iter().rev() {
        let name = wanted.remove(index).place.name;
        let note = both!(
            "{name}: its files hold nothing of what is meant",
            "{name}: von dem, was gemeint ist, steht in den Dateien nichts"
        );
        (context.observe)(Event::Note(note));
    }
    hold(context, wanted, async |_, wanted| Ok(wanted), &|values, names| drift(values, names, &args.picks.typed()))
        .await
}

/// What to do where values differ: these, of which no load takes the first unless they are named, and so many others.
type Hint<'h> = &'h dyn Fn(&BTreeSet<u32>, usize) -> Text;

/// Holds these drives against what is wanted of them. What the open lines show may change before that what is wanted (`settle`).
pub(in crate::command) async fn hold(
    context: &mut Context<'_>,
    wanted: Vec<Wanted>,
    settle: impl AsyncFnOnce(&mut [Line<'_>], Vec<Wanted>) -> Result<Vec<Wanted>, Failure>,
    hint: Hint<'_>,
) -> Result<Outcome, Failure> {
    if context.settings.dry_run {
        return Ok(dry_run(&wanted));
    }
    let held = on_lines(context, wanted, async |lines, wanted, _| {
        let wanted = settle(lines, wanted).await?;
        let mut rest = wanted.as_slice();
        let mut works = Vec::new();
        for line in lines {
            let (own, others) = rest.split_at(line.members.len().min(rest.len()));
            rest = others;
            works.push(weigh(line, own));
        }
        let weighed = join_all(works).await.into_iter().flatten().collect();
        Ok::<_, Failure>((wanted, weighed))
    });
    let (wanted, weighed): (Vec<Wanted>, Vec<Weighed>) = held.await??;
    Ok(report(project(&wanted).unwrap_or_default(), &wanted, weighed, hint))
}

/// Holds the drives of a line against their files, in turn.
async fn weigh(line: &mut Line<'_>, wanted: &[Wanted]) -> Vec<Weighed> {
    let (mut weighed, mut over) = (Vec::new(), None);
    for (member, one) in line.members.iter_mut().zip(wanted) {
        let result = match (over.clone().or_else(|| member.left.take()), &mut line.session) {
            (Some(failure), _) => Err(failure),
            (None, Some(session)) => {
                session.allow(session.now(), Args::UPPER.questions(one.opened.settings.len() as u64));
                match member.identify(session).await {
                    Ok(drive) => against_target(session, drive.target, &one.opened, false).await,
                    Err(failure) => Err(failure),
                }
            }
            (None, None) => break,
        };
        let result = result.unwrap_or_else(|failure| Weighed::failed(&one.opened, member.address, failure));
        let result = result.beside(one.unsettled.as_ref());
        over = over.or_else(|| result.failure.clone().filter(is_over));
        weighed.push(result);
    }
    weighed
}

/// What each drive would be asked.
fn dry_run(wanted: &[Wanted]) -> Outcome {
    let mut telegrams = Vec::new();
    for Wanted { place, opened, .. } in wanted {
        let reader = telegram_reader(&place.settings, &opened.family);
        let asked = of_file(&opened.settings, &opened.family);
        let stored = asked.iter().map(|asking| (asking, asking.sets.iter().flat_map(|sets| sets.wire()).collect()));
        let in_force = asked.iter().map(|asking| (asking, ram_sets(asking, &opened.family)));
        let places: Vec<(&Asking, Vec<u8>)> = stored.chain(in_force).collect();
        for (asking, sets) in places {
            let sets = sets.into_iter();
            telegrams.extend(sets.filter_map(|set| reader.question(place.address, read_question(&asking.param, set))));
        }
    }
    Outcome::of(Data::Plan(Plan { dry_run: true, telegrams, notes: Vec::new() }))
}

/// Every drive beside its files, and how all of it ended.
fn report(project: String, wanted: &[Wanted], weighed: Vec<Weighed>, hint: Hint<'_>) -> Outcome {
    let (mut drives, mut warnings, mut failures) = (Vec::new(), Vec::new(), Vec::new());
    let (mut differing, mut values, mut unnamed, mut others) = (Vec::new(), 0, BTreeSet::new(), 0);
    for (one, Weighed { mut comparison, failure, warnings: more }) in wanted.iter().zip(weighed) {
        behind::compared(&mut comparison, one.place.settings.node);
        warnings.extend(more.into_iter().map(|warning| told::of(one, warning)));
        let called = one.place.name.clone();
        match failure {
            Some(failure) if failure.class != Class::No => failures.push((called.clone(), failure)),
            Some(_) => {
                differing.push(called.clone());
                let rows = || comparison.differences.iter().filter(|row| row.error.is_none());
                values += rows().count() as u64;
                let family = &one.opened.family;
                let is_unnamed =
                    |id: &u32| family.param(*id).is_some_and(|param| family.files.goes(param) == Goes::IfAsked);
                let (asked, always): (Vec<u32>, Vec<u32>) = rows().map(|row| row.param).partition(is_unnamed);
                unnamed.extend(asked);
                others += always.len();
            }
            None => {}
        }
        drives.push(PlantComparison { called, port: one.port(), address: one.place.address, comparison });
    }
    let failure = match (
        told::summary(failures, drives.len(), (false, told::UNCOMPARED)),
        differ(&differing, values).map(|failure| failure.hint(hint(&unnamed, others))),
    ) {
        (Some(failure), Some(drift)) => Some(told::beside(failure, &drift.message)),
        (failure, drift) => failure.or(drift),
    };
    Outcome { data: Some(Data::PlantCheck(PlantCheck { project, drives })), warnings, failure }
}

/// That drives differ.
fn differ(drives: &[String], values: u64) -> Option<Failure> {
    let some =
        Text::count(values, ["value differs", "values differ"], ["Wert ist verschieden", "Werte sind verschieden"]);
    let names = drives.join(", ");
    let failure = || Failure::new(Class::No, "no.differences", both!("{some}: {names}", "{some}: {names}", some));
    (!drives.is_empty()).then(failure)
}

/// What brings the values of files back. What no load takes unless it is named is brought back by its name alone.
fn drift(unnamed: &BTreeSet<u32>, others: usize, typed: &str) -> Text {
    let rest = both!(
        "`antrieb plan{typed}` shows what `antrieb apply{typed}` would bring back",
        "`antrieb plan{typed}` zeigt, was `antrieb apply{typed}` wiederherstellen würde"
    );
    let only = unnamed.iter().map(u32::to_string).collect::<Vec<_>>().join(",");
    let by_name = both!(
        "settings of a line go into a drive only if they are named: `antrieb plan --only {only}`",
        "Einstellungen einer Leitung gehen nur in einen Antrieb, wenn sie genannt sind: `antrieb plan --only {only}`"
    );
    let hints: Vec<Text> =
        (others > 0).then_some(rest).into_iter().chain((!unnamed.is_empty()).then_some(by_name)).collect();
    Text::join(&hints, "; ")
}
