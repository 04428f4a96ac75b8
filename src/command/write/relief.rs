//! Values that can only take motion away: nobody is asked before they are written.
//!
//! - The control words of "disable voltage" and "quick stop" (`motion::shout` says why they start nothing, whatever a drive takes them for). Any
//!   other one may: as contacts 07h closes S1IND (CM-485 manual 9.1.3), and 80h resets a fault.
//! - The setpoint 0 of a mode in which it brings the shaft to rest, where nothing is added to it that turns the other way (9.2.1). Not the
//!   percentage: what a controller makes of 0 % its own settings say (9.2.2).
//! - What goes to every drive is asked: nobody has looked what is there.

use crate::drive::job::{Job, Step};
use crate::drive::motion::{role_raw, zero_only_slows};
use crate::drive::{Session, Target, describe};
use crate::failure::Failure;
use crate::gate::{Motion, Permit, Relief};
use crate::outcome::WriteResult;
use crate::profile::{Family, Mode, Role};

/// Commands whose word can only stop, whatever the drive takes it for, with what they are.
const STOPS: [(&str, Relief); 2] = [("disable-voltage", Relief::DisableVoltage), ("quick-stop", Relief::QuickStop)];

/// The command that a step is, if it can only stop.
pub(super) fn stop(step: &Step, family: &Family) -> Option<(&'static str, Relief)> {
    let word = family.role(Role::ControlWord).filter(|word| word.id == step.param.id)?;
    let is = |slug: &str| family.machine.command(slug).is_some_and(|command| i64::from(command.word) == step.raw);
    STOPS.into_iter().find(|(slug, _)| word.access.writes() && is(slug))
}

/// The mode of which a step is the setpoint 0, if the shaft comes to rest by it.
fn zero<'f>(step: &Step, family: &'f Family) -> Option<&'f Mode> {
    let rests = |mode: &&Mode| mode.setpoint == step.param.id && mode.zero_stops() && mode.starts.is_empty();
    family.modes.iter().find(rests).filter(|_| step.raw == 0)
}

/// The permit for what is left to write, if all of it can only take motion away.
pub(super) async fn permit(session: &mut Session<'_>, jobs: &mut [Job]) -> Result<Option<Permit<Motion>>, Failure> {
    let mut found = None;
    for Job { target, steps, rows } in jobs {
        let planned = steps.iter().zip(rows).filter(|(_, row)| row.result == WriteResult::Planned);
        for (step, _) in planned {
            match act(session, target, step).await? {
                Some(act) => found = Some(act),
                None => return Ok(None),
            }
        }
    }
    Ok(found.map(Relief::permit))
}

async fn act(session: &mut Session<'_>, target: &mut Target, step: &Step) -> Result<Option<Relief>, Failure> {
    let family = target.family.clone();
    match (stop(step, &family), zero(step, &family)) {
        _ if target.address == 0 => Ok(None),
        (Some((_, act)), _) => Ok(Some(act)),
        (None, Some(mode)) => {
            let Some(status) = role_raw(session, target, "status-word").await? else { return Ok(None) };
            let state = describe::state(&family, status as u32).slug;
            Ok(zero_only_slows(session, target, mode, &state).await?.then_some(Relief::Zero))
        }
        (None, None) => Ok(None),
    }
}
