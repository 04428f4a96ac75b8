//! A setpoint of zero, which only takes motion away; and when it does more than that.

use super::Args;
use super::wanted::Wanted;
use crate::args::below_zero::SIGN;
use crate::command::running::Plan;
use crate::drive::motion::{OPERATION, Situation, elsewhere, role_raw, turns, zero_only_slows};
use crate::drive::{Session, Target};
use crate::failure::{Class, Failure};
use crate::gate::Relief;
use crate::profile::{Family, Mode};
use crate::text::{Text, both};

/// Whether a setpoint as it was typed is a zero, whatever its unit.
pub(super) fn is_said(setpoint: &str) -> bool {
    let number = setpoint.trim().trim_start_matches(['-', '+', SIGN]);
    let number = number.trim_end_matches(|letter: char| !letter.is_ascii_digit());
    number.contains('0') && number.chars().all(|letter| matches!(letter, '0' | '.' | ','))
}

/// Whether a setpoint of zero is all that is given, and it can do nothing else, as far as the words tell: control is not
/// taken for it.
pub(super) fn is_meant(args: &Args, wanted: &Wanted) -> bool {
    is_aim(args, wanted) && Plan::only_relieves(&args.motion, false)
}

/// Whether nothing but a standstill is wanted.
pub(super) fn is_aim(args: &Args, wanted: &Wanted) -> bool {
    goes_first(args, wanted) && args.source.is_none() && !args.motion.hold
}

/// Whether it is a zero that goes out whatever else is wanted: what somebody must agree to is asked behind it.
pub(super) fn goes_first(args: &Args, wanted: &Wanted) -> bool {
    // A standstill is waited for anyway (--until reached).
    let plain = !args.enable && args.options.is_empty();
    let mode = &wanted.mode;
    plain
        && args.jog.is_none()
        && args.ramp.is_none()
        && args.profile.is_none()
        && mode.zero_stops()
        && mode.starts.is_empty()
        && wanted.schedule.values().all(|raw| raw == 0)
}

/// Whether a zero changes where the setpoint comes from: somebody must agree to that, and it is to bring the shaft to rest all the same.
pub(super) fn changes_source(args: &Args, wanted: &Wanted) -> bool {
    goes_first(args, wanted) && args.source.is_some() && !args.motion.hold
}

/// Whether such a zero stops a drive that has power.
pub(super) fn is_waited_for(args: &Args, wanted: &Wanted, before: &Situation) -> bool {
    changes_source(args, wanted) && before.state == OPERATION
}

/// The modes of a family that a zero may mean, before the drive is asked.
pub(super) fn modes(args: &Args, bare: bool, wanted: Option<Wanted>, family: &Family) -> Vec<Mode> {
    let Some(wanted) = wanted.filter(|wanted| goes_first(args, wanted)) else { return Vec::new() };
    match bare && wanted.mode.value.is_some() {
        true => family.modes.iter().filter(|mode| mode.zero_stops() && mode.starts.is_empty()).cloned().collect(),
        false => vec![wanted.mode],
    }
}

/// What a zero is on this drive, as it works now: a relief, unless it would change the mode, or something else would then
/// turn the shaft another way.
pub(super) async fn relief(
    session: &mut Session<'_>,
    target: &mut Target,
    before: &Situation,
    wanted: &Wanted,
) -> Result<Option<Relief>, Failure> {
    let active = role_raw(session, target, "mode-active").await?;
    if wanted.mode.value.is_some() && active != wanted.mode.value {
        return Ok(None);
    }
    let only_slows = zero_only_slows(session, target, &wanted.mode, &before.state).await?;
    Ok(only_slows.then_some(Relief::Zero))
}

/// The mode in which the drive works, for a zero without a unit.
pub(super) async fn present_mode(session: &mut Session<'_>, target: &mut Target) -> Result<Option<Mode>, Failure> {
    let Some(active) = role_raw(session, target, "mode-active").await? else { return Ok(None) };
    let mode = target.family.modes.iter().find(|mode| mode.value == Some(active)).cloned();
    match mode {
        Some(mode) if !mode.zero_stops() => {
            let text = both!(
                "a setpoint of 0 does not stop the drive in this mode: {mode}",
                "in dieser Betriebsart hält ein Sollwert 0 den Antrieb nicht an: {mode}",
                mode = mode.text()
            );
            Err(stops_nothing(session, target, text).await?)
        }
        Some(mode) => demand_its_own(session, target, &mode).await.map(|()| Some(mode)),
        None => Ok(None),
    }
}

/// Fails where the drive works in this mode and takes its setpoint from elsewhere, so that a zero counts for nothing.
pub(super) async fn demand_its_own(session: &mut Session<'_>, target: &mut Target, mode: &Mode) -> Result<(), Failure> {
    if mode.engage.is_empty() || role_raw(session, target, "mode-active").await? != mode.value {
        return Ok(());
    }
    let Some((param, now)) = elsewhere(session, target, mode).await? else { return Ok(()) };
    let text = both!(
        "a setpoint of 0 stops nothing here, the drive takes another one: {label} = {now}",
        "ein Sollwert 0 hält hier nichts an, der Antrieb nimmt einen anderen: {label} = {now}",
        label = param.label()
    );
    Err(stops_nothing(session, target, text).await?)
}

/// Whoever asked for a standstill must know that there is none.
async fn stops_nothing(session: &mut Session<'_>, target: &mut Target, text: Text) -> Result<Failure, Failure> {
    let alarm = turns(session, target).await?;
    Ok(Failure { alarm, ..Failure::new(Class::Forbidden, "forbidden.mode", text) }
        .hint(both!("`antrieb statemachine quick-stop` stops it", "`antrieb statemachine quick-stop` hält ihn an")))
}
