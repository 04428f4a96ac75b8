//! `apply`: the parameter files of a plant into its drives.

use super::lines::{Wanted, on_lines, wanted};
use super::told::{LEFT_OUT, UNLIKE};
use super::{dry_run, look, must_choose, told};
use crate::args::Takes;
use crate::command::dataset::loaded::nothing_written;
use crate::command::dataset::scope::Scope;
use crate::command::verb::{Verb, Working};
use crate::command::{Context, asking};
use crate::drive::plant::{Line, Member, Together};
use crate::drive::{Upper, job};
use crate::failure::{Class, Failure};
use crate::gate::Question;
use crate::outcome::{Document, Outcome, Plant, WriteResult};
use crate::text::{Text, both};
use clap::Args as ClapArgs;
use futures_util::future::join_all;
use std::cell::Cell;

/// Writes what antrieb.toml says into its drives, with one question.
///
/// Every drive is read and checked first, all ports at once, the drives of a line in turn; nothing that is equal is written. You are
/// asked once. Each drive is a transaction with an undo file of its own, beside antrieb.toml: every value is proven, and whatever
/// goes wrong, what was written to this drive goes back. A drive that does not answer, is another one than antrieb.toml says, or
/// may not be written to now is left out and named (exit 9). Ctrl-C takes back the drives that are under way and begins no other.
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    #[command(flatten)]
    scope: Scope,
    /// All drives or none: if one fails, all go back
    ///
    /// Nothing is begun if one of them cannot be written to, and what is done already is taken back, each value proven.
    #[arg(long)]
    atomic: bool,
}

impl Verb for Args {
    const NAME: &'static str = "apply";
    const OF_PLANT: bool = true;
    const TAKES: Takes = Takes::WRITES;
    const EXAMPLES: &'static [&'static str] = &[
        "antrieb --port sim --config plant.toml apply --yes",
        "antrieb --port sim --config plant.toml -a pump apply --dry-run",
        "antrieb --port sim --config plant.toml -a @water apply --atomic --yes",
    ];
    const UPPER: Upper = Upper::drive(30).each(48, "parameter");
    type Prints = Document<Plant>;

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(run(self, context))
    }
}

async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let wanted = wanted(context, &args.scope.choice())?;
    write(context, wanted, args.atomic, async |_, wanted| Ok(wanted)).await
}

/// Writes into these drives what is wanted of them; all or none of them if `atomic`. What the open lines show may change before that
/// what is wanted (`settle`).
pub(in crate::command) async fn write(
    context: &mut Context<'_>,
    wanted: Vec<Wanted>,
    atomic: bool,
    settle: impl AsyncFnOnce(&mut [Line<'_>], Vec<Wanted>) -> Result<Vec<Wanted>, Failure>,
) -> Result<Outcome, Failure> {
    must_choose(&wanted)?;
    if context.settings.dry_run {
        return dry_run(context, &wanted);
    }
    let together = Together { interrupt: context.interrupt.clone(), atomic, failed: Cell::new(false) };
    on_lines(context, wanted, async |lines, wanted, ask| {
        let wanted = &settle(lines, wanted).await?;
        lines.iter_mut().flat_map(|line| &mut line.members).zip(wanted).for_each(|(member, one)| one.gives(member));
        look(lines, Args::UPPER, &nothing_written()).await;
        leave_unsettled(wanted, lines);
        try_undo_files(lines);
        if atomic {
            leave_all(lines);
        }
        if let Some(question) = question(wanted, lines).filter(|_| !together.interrupt.is_raised()) {
            let permit = match asking::off_line(&together.interrupt, ask, &question).await {
                Err(denied) if !ask.is_there() => {
                    let told = told::plant(wanted, lines, (false, LEFT_OUT));
                    return Ok(Outcome { failure: Some(denied), ..told });
                }
                permit => permit?,
            };
            if atomic {
                join_all(lines.iter_mut().map(Line::look_again)).await;
                leave_all(lines);
            }
            join_all(lines.iter_mut().map(|line| line.apply(&permit, &together))).await;
            if atomic && together.failed.get() {
                join_all(lines.iter_mut().map(|line| line.take_back(&permit))).await;
            }
        }
        Ok(told::plant(wanted, lines, (together.interrupt.is_raised(), UNLIKE)))
    })
    .await?
}

/// Leaves out who cannot have all that is wanted of him.
fn leave_unsettled(wanted: &[Wanted], lines: &mut [Line<'_>]) {
    for (one, member) in wanted.iter().zip(lines.iter_mut().flat_map(|line| &mut line.members)) {
        if let Some(failure) = one.unsettled.as_ref().filter(|_| member.found.is_some()) {
            member.leave(failure.clone());
        }
    }
}

/// Leaves out whose undo file cannot be left: told before anybody is asked, and only where something is to be written.
fn try_undo_files(lines: &mut [Line<'_>]) {
    for member in lines.iter_mut().flat_map(|line| &mut line.members).filter(|member| member.is_due()) {
        let Err(failure) = member.try_undo() else { continue };
        let so = nothing_written();
        member.leave(Failure { message: both!("{why}; {so}", "{why}; {so}", why = failure.message, so), ..failure });
    }
}

/// All or nothing: where one cannot be begun, none is.
fn leave_all(lines: &mut [Line<'_>]) {
    let mut members = lines.iter().flat_map(|line| &line.members);
    let Some(name) = members.find(|member| member.left.is_some()).map(|member| member.name.clone()) else { return };
    let message = both!(
        "not begun: {name} cannot be written to, and it is all or none (--atomic)",
        "nicht begonnen: in {name} lässt sich nicht schreiben, und es gilt alle oder keiner (--atomic)"
    );
    let failure = Failure::new(Class::Forbidden, "forbidden.atomic", message);
    for member in lines.iter_mut().flat_map(|line| &mut line.members).filter(|member| member.is_due()) {
        member.leave(failure.clone());
    }
}

/// The one question about all of it; `None` if there is nothing to do.
fn question(wanted: &[Wanted], lines: &[Line<'_>]) -> Option<Question> {
    let members = lines.iter().flat_map(|line| &line.members);
    let (mut hazards, mut details, mut last): (Vec<_>, Vec<Text>, Vec<Text>) = Default::default();
    let (mut values, mut drives, mut there, mut back) = (0, 0, 0, 0);
    for (one, member) in wanted.iter().zip(members) {
        if let Some(why) = &member.left {
            last.push(both!(
                "{name} is left out: {why}",
                "{name} wird ausgelassen: {why}",
                name = member.name,
                why = why.told()
            ));
        }
        let Some(plan) = member.found.as_ref().filter(|_| member.is_due()).map(|found| &found.plan) else { continue };
        let Some(mut asked) = job::question(std::slice::from_ref(&plan.job), member.terms.own_address()) else {
            continue;
        };
        // Behind the values comes what can happen: told once for all drives.
        let consequences = asked.details.split_off(job::lines(&plan.job).min(asked.details.len()));
        let consequences = consequences.into_iter().chain(plan.hidden.clone()).chain(plan.open_memory());
        let consequences = consequences.chain(plan.unwatched());
        last.extend(consequences.filter(|text| !last.contains(text)).collect::<Vec<_>>());
        details.push(about(one, member, asked.title));
        let doubts = one.doubts().into_iter().map(|warning| warning.message);
        details.extend(asked.details.into_iter().chain(plan.notes.iter().cloned()).chain(doubts));
        hazards.extend(asked.hazards);
        (values, drives) = (values + plan.todo(), drives + 1);
        (there, back) = (there + plan.eeprom_writes, back + plan.eeprom_writes_back);
    }
    if drives == 0 {
        return None;
    }
    hazards.sort_unstable();
    hazards.dedup();
    details.extend(last);
    if there > 0 {
        details.push(both!(
            "writes to the EEPROM: at most {there}; if all of it has to go back, at most {back} more",
            "Schreibvorgänge im EEPROM: höchstens {there}; muss alles zurück, höchstens {back} weitere"
        ));
    }
    let drives = Text::count(drives, ["drive", "drives"], ["Antrieb", "Antriebe"]);
    let values = Text::count(values as u64, ["value", "values"], ["Wert", "Werte"]);
    let title = both!("{drives}: write {values}", "{drives}: {values} schreiben", drives, values);
    Some(Question { hazards, title, details })
}

/// A drive, and how much of it is equal already.
fn about(one: &Wanted, member: &Member<'_>, title: Text) -> Text {
    let rows = member.found.iter().flat_map(|found| &found.plan.job.rows);
    let unchanged = rows.filter(|row| row.result == WriteResult::Unchanged).count();
    let (name, port) = (&member.name, one.port());
    let equal = match unchanged {
        0 => Text::default(),
        _ => both!("; equal already: {unchanged}", "; schon gleich: {unchanged}"),
    };
    both!("{name} ({port}): {title}{equal}", "{name} ({port}): {title}{equal}", title, equal)
}
