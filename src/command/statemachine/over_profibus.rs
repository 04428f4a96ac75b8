//! `statemachine` with PROFIBUS spoken: the state, a stop, a reset, or a motor that is held enabled. What turns is given as a setpoint.

use super::{Action, Args};
use crate::command::profibus::job::{self, Job};
use crate::command::profibus::run::{self, no_quick_stop};
use crate::command::{Context, profibus};
use crate::drive::profibus::Wanted;
use crate::failure::{Class, Failure};
use crate::gate::Relief;
use crate::outcome::Outcome;
use crate::text::both;

pub(super) async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let (action, word, motion) = match &args.action {
        None | Some(Action::Show) => return profibus::show(&args.slave, args.mode.choice(), context).await,
        Some(Action::Disable(motion)) => (job::Action::Stop(Relief::Disable), "disable", motion),
        Some(Action::DisableVoltage(motion)) => (job::Action::Stop(Relief::DisableVoltage), "disable-voltage", motion),
        Some(Action::QuickStop(motion)) => {
            no_quick_stop(context.observe);
            (job::Action::Stop(Relief::QuickStop), "quick-stop", motion)
        }
        Some(Action::Reset(motion)) => (job::Action::Reset, "reset", motion),
        // A motor that is enabled, and stands at its setpoint of 0.
        Some(Action::Enable(motion)) if motion.hold => (job::Action::Run(Wanted::Hertz(0)), "enable", motion),
        Some(
            Action::Shutdown(_)
            | Action::SwitchOn(_)
            | Action::Enable(_)
            | Action::Goto { .. }
            | Action::Contacts { .. },
        ) => return Err(not_held()),
    };
    let is_run = matches!(action, job::Action::Run(_));
    let motion = if is_run { motion.clone() } else { motion.of_a_stop() };
    let (slave, choice) = (&args.slave, args.mode.choice());
    run::run(&Job { action, word, motion: &motion, slave, choice, way: None, until: None }, context).await
}

/// The state of a slave is that of the word which this program sends it in every cycle.
fn not_held() -> Failure {
    let message = both!(
        "over PROFIBUS a state lasts only while this program exchanges data: there is nothing to walk to and leave",
        "am PROFIBUS dauert ein Zustand nur, solange dieses Programm Daten austauscht: es gibt kein Ziel, das bleibt"
    );
    Failure::new(Class::Usage, "usage.profibus", message).hint(both!(
        "`antrieb --protocol dp statemachine enable --hold` holds it enabled, `antrieb --protocol dp sollwert 20Hz --enable --hold` runs it; \
         `statemachine disable` stops it",
        "`antrieb --protocol dp statemachine enable --hold` hält ihn freigegeben, `antrieb --protocol dp sollwert 20Hz --enable --hold` \
         fährt ihn; `statemachine disable` hält ihn an"
    ))
}
