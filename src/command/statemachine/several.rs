//! `-a 1-5 statemachine quick-stop`: what only takes motion away, of several drives.

use super::rehearse;
use crate::args::MotionArgs;
use crate::command::rehearse::Rehearsal;
use crate::command::running::{self, Plan};
use crate::command::{Context, offline_family};
use crate::drive::motion::{Motor, Situation};
use crate::drive::{Session, Target};
use crate::failure::Failure;
use crate::gate::Relief;
use crate::outcome::Outcome;
use crate::text::Text;

/// Stops them. What somebody would have to agree to is one drive's, and everybody is none.
pub(super) async fn stop(
    context: &mut Context<'_>,
    addresses: &[u8],
    act: Relief,
    (slug, announce, motion): (&'static str, Text, &MotionArgs),
) -> Result<Outcome, Failure> {
    if !Plan::only_relieves(motion, true) || addresses.contains(&0) {
        running::single_address(context)?;
    }
    if !context.settings.dry_run {
        let plan = || Plan { aim: Some(act), relief: Some(act), ..Plan::of(slug, announce.clone(), motion) };
        let check = async |_: &mut Session<'_>, _: &mut Target, _: &Situation, _: &mut Plan<'_>| Ok(());
        let work = async |motor: &mut Motor<'_, '_>, ()| motor.relieve(act).await;
        return running::stop_each(context, act, plan, check, work).await;
    }
    let mut told = Vec::new();
    for line in running::lines(context.settings) {
        let family = offline_family(line, context.registry)?;
        for &address in line.addresses.named() {
            told.push(
                rehearse(line, &family, address, motion, (true, true), Some(slug), |told| told.command(slug))?
                    .planned(),
            );
        }
    }
    Ok(Rehearsal::of_all(context.settings, told))
}
