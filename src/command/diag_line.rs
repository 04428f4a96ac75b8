//! `diag line`: how good is the line, and what to do about it?

use super::{Context, addresses_to_read, connect, is_over, target};
use crate::args::Settings;
use crate::drive::{check_line, harmless};
use crate::failure::{Class, Failure};
use crate::outcome::{Data, Outcome};
use crate::text::both;
use clap::Args as ClapArgs;

/// Measures the line: adapter, pauses, reply times with a histogram, errors, and what to do about them.
///
/// Asks every drive that was named the same harmless question many times, without repeats. Nothing in a drive changes.
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    /// How many questions to ask each drive
    #[arg(long, value_name = "N", default_value_t = 100, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub count: u32,
}

/// Measures the line to every drive that was named.
pub async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    not_over_profibus(context.settings)?;
    if context.settings.dry_run {
        let family = super::offline_family(context.settings, context.registry)?;
        return super::plan(context, &family, &[harmless(&family, context.settings.protocol)]);
    }
    let Context { settings, registry, interrupt, observe, .. } = context;
    let addresses = addresses_to_read(settings, *observe)?;
    let mut session = connect(settings, registry, interrupt, *observe).await?;
    let (mut targets, mut failed) = (Vec::new(), Vec::new());
    for address in addresses {
        match target(&mut session, settings, registry, address, false).await {
            Ok(target) => targets.push(target),
            Err(failure) if is_over(&failure) => return Err(failure),
            Err(failure) => failed.push((address, failure)),
        }
    }
    let (check, failures) = check_line(&mut session, targets, &failed, args.count.into()).await;
    let measured = check.drives.iter().filter(|drive| drive.error.is_none()).count();
    Ok(super::finish(Data::LineCheck(check), failures, measured, Vec::new()))
}

/// Refused where PROFIBUS is spoken: not a byte of another protocol goes out on its line.
fn not_over_profibus(settings: &Settings) -> Result<(), Failure> {
    if !settings.profibus {
        return Ok(());
    }
    let message = both!("this does not go over PROFIBUS-DP", "das geht nicht über PROFIBUS-DP");
    Err(Failure::new(Class::Usage, "usage.profibus", message).hint(both!(
        "`antrieb profibus live` tells who is on the line and how he answers, `sniff` what goes over it",
        "`antrieb profibus live` zeigt, wer an der Leitung ist und wie er antwortet, `sniff`, was darüber geht"
    )))
}
