//! `dataset check`: does a drive hold what its file says?

use super::naming::Naming;
use super::opened::Opened;
use super::scope::Picks;
use super::weighing::{Weighed, against_drive, told};
use crate::command::verb::Verb;
use crate::command::{Context, addresses_to_read, connect, plan, read_question, terms};
use crate::drive::is_over;
use crate::drive::paramfile::{of_file, ram_sets};
use crate::failure::Failure;
use crate::outcome::Outcome;
use clap::Args as ClapArgs;
use std::path::PathBuf;

#[derive(Clone, Debug, ClapArgs)]
pub(super) struct Options {
    /// A file of `dataset save`; with {address} or {name} one a drive
    #[arg(value_name = "FILE")]
    file: PathBuf,
    #[command(flatten)]
    picks: Picks,
    /// Show the differences as lines of both files
    #[arg(long)]
    unified: bool,
}

pub(super) async fn run(options: &Options, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let addresses = addresses_to_read(context.settings, context.observe)?;
    let named = context.settings.named_drive();
    let open = |of: &Naming| {
        let mut file = Opened::read(&of.own(&options.file), context.registry, named)?;
        file.pick(&options.picks.choice())?;
        Ok::<_, Failure>(file)
    };
    let drives = Naming::of_line(context.settings, &addresses)?;
    let files = drives.iter().map(open).collect::<Result<Vec<_>, _>>()?;
    if let (true, Some(file)) = (context.settings.dry_run, files.first()) {
        let asked = of_file(&file.settings, &file.family);
        let sets =
            asked.iter().flat_map(|one| one.sets.iter().flat_map(|sets| sets.wire()).map(|set| (&one.param, set)));
        let ram = asked.iter().flat_map(|one| ram_sets(one, &file.family).into_iter().map(|set| (&one.param, set)));
        let questions: Vec<_> = sets.chain(ram).map(|(param, set)| read_question(param, set)).collect();
        return plan(context, &file.family, &questions);
    }
    let Context { settings, registry, interrupt, observe, .. } = context;
    let terms = terms(settings, registry)?;
    let mut session = connect(settings, registry, interrupt, *observe).await?;
    let mut weighed = Vec::new();
    for (&address, file) in addresses.iter().zip(&files) {
        session.allow(session.now(), <super::Args as Verb>::UPPER.questions(file.settings.len() as u64));
        let one = against_drive(&mut session, &terms, address, file, options.unified).await;
        let one = one.unwrap_or_else(|failure| Weighed::failed(file, address, failure));
        let over = one.failure.as_ref().is_some_and(is_over);
        weighed.push(one);
        if over {
            break;
        }
    }
    Ok(told(weighed))
}
