//! `monitor` with PROFIBUS spoken: a slave is taken, held by the stop word while it is watched, and let go again.

use super::{Args, Wanted, record, rounds};
use crate::args::Settings;
use crate::command::{Context, output, profibus, terms};
use crate::failure::Failure;
use crate::outcome::Outcome;
use crate::profile::Family;

pub(super) async fn run(args: &Args, wanted: Wanted, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    profibus::refuse(&[("--reconnect", args.reconnect)])?;
    let select = |family: &Family| wanted.chosen(family);
    if let (Some(path), Settings { force, dry_run: false, .. }) = (&args.record, context.settings) {
        output::check_in_place(path, *force)?;
    }
    let waited = wanted.waits_for(args);
    let rounds = rounds(args, &wanted, context.calls.take());
    let terms = terms(context.settings, context.registry)?;
    let job = profibus::Watch {
        select: &select,
        rounds,
        terms,
        slave: &args.slave,
        choice: args.mode.choice(),
        is_paced: !args.unpaced,
    };
    let outcome = profibus::watch(job, context).await?;
    Ok(record::told(outcome, waited))
}
