//! The first telegrams of an act that takes motion away: they go out before anything is asked that they do not need.
//!
//! Which word can only stop, whoever hears it:
//! - An ACTIVE drive takes P.410 as commands with P.412 = 1, as contacts with P.412 = 2, and not at all with P.412 = 0
//!   (CM-485 manual 9.1). 00h is "disable voltage" and all contacts open. 02h is "quick stop", and as contacts it leaves
//!   S1IND open, without which there is no release (9.1.3): neither can start anything. 07h, "disable operation", would
//!   close S1IND to S3IND and could. So it goes out only where P.412, as the drive works with it, reads as 1, which costs
//!   two short questions (P.249, P.412); otherwise the quick stop goes out in its place. Bit 9 of the status word, Remote,
//!   would cost one, but 9.1.3 names it with P.412 = 2 too.
//! - An LXM05 always obeys DCOMcontrol (CiA 402, facts H). Which half of a value comes first may be unknown: 0 is the same
//!   in both orders, and 2 and 7 in the wrong one have a lower half of 0, so that they go out in both.
//! - Where nobody tells the family, each gets its own word at its own parameter; the other has no such parameter and
//!   refuses it.
//!
//! A setpoint of zero can only slow a shaft as well, with one exception:
//! - ACTIVE, P.434 = 3: internal and line setpoint are added (CM-485 manual 9.2.1), so behind a line setpoint of 0 the internal
//!   one is left; if it has the other sign, the shaft turns faster, or the other way. With P.434 = 1 the line setpoint does
//!   not count; with 2 the least frequency takes its sign from the last one. So P.228 and P.282 are read first, in short
//!   questions, and signs that agree let it go out whatever P.434 is. Where neither is told within [`LOOKING`] it goes out
//!   unseen, because that is what was ordered, and most drives stop by it; where what was told leaves it open, it does not,
//!   until the usual questions have been answered.
//! - LXM05: a setpoint acts in its own mode only, so that of the mode that the drive shows goes out; if it shows none, that of
//!   every mode in which a zero brings the shaft to rest.

use super::look::{role_raw, working};
use super::relief::command_of;
use crate::drive::family;
use crate::drive::route::{Cell, Inquiry, Meant};
use crate::drive::session::{AccessError, Session};
use crate::drive::transfer::Target;
use crate::exchange::{Answer, Limits, Question};
use crate::failure::{Class, Failure};
use crate::gate::Relief;
use crate::outcome::Event;
use crate::profile::{Family, Lang, Mode, Registry, Type};
use crate::tick::Span;
use std::rc::Rc;

/// How long an answer is waited for before the stop is said again. Longer than a drive takes that has nothing else to do;
/// an answer that comes later still counts, because the same was asked again.
const SHORT: Span = Span::from_millis(250);
/// How long the stop waits for the answer to a question before it.
const GLANCE: Span = Span::from_millis(150);
/// How long it is looked whether a setpoint of zero only slows the shaft.
const LOOKING: Span = Span::from_millis(600);
/// How long one telegram of it may take with its answer, whatever comes over the line.
const BRIEF: Span = Span::from_millis(450);
/// How often the stop is said while nobody acknowledges it: replies of 900 ms (CM-485 manual 6.8 promises less) are in time.
const TIMES: u8 = 5;

/// Sends what stops the drive until it is acknowledged, or has been said often enough; says whether it was. An act that is
/// no command sends nothing.
pub async fn shout(
    session: &mut Session<'_>,
    registry: &Registry,
    meant: &Meant,
    act: Relief,
) -> Result<bool, AccessError> {
    if command_of(act).is_none() {
        return Ok(false);
    }
    at_once(session, async |session: &mut Session<'_>| say(session, registry, meant, act).await).await
}

async fn say(session: &mut Session<'_>, registry: &Registry, meant: &Meant, act: Relief) -> Result<bool, AccessError> {
    let families = match &meant.family {
        Some(family) => vec![family.clone()],
        None => presumed(session, registry, meant.address).await?,
    };
    let mut words = Vec::new();
    for family in &families {
        let word = first_word(session, meant, family, act).await?;
        words.extend(word.into_iter().flat_map(|word| telegrams(session, meant, family, word)));
    }
    repeat(session, meant, &words).await
}

/// Says it until it is acknowledged, or has been said often enough.
async fn repeat(session: &mut Session<'_>, meant: &Meant, words: &[Question]) -> Result<bool, AccessError> {
    let limits = session.limits();
    session.set_limits(Limits { reply_timeout: SHORT, ..limits });
    for _ in 0..TIMES {
        for word in words {
            session.end_at(Some(session.now() + BRIEF));
            match session.blurt(meant.address, word.clone()).await {
                Ok(Answer::Reply { said, .. }) if crate::drive::route::no(&said).is_none() => return Ok(true),
                Err(error) if error.is_fatal() => return Err(error),
                _ => {}
            }
        }
    }
    Ok(false)
}

/// Gives a setpoint of zero before anything is asked that it does not need; says whether one went out. `modes`: those of a
/// family that may be meant.
pub async fn shout_zero(
    session: &mut Session<'_>,
    registry: &Registry,
    meant: &Meant,
    modes: &dyn Fn(&Family) -> Vec<Mode>,
) -> Result<bool, AccessError> {
    at_once(session, async |session: &mut Session<'_>| say_zero(session, registry, meant, modes).await).await
}

/// Does it in short questions, also into a busy line; afterwards the session is as before.
async fn at_once(
    session: &mut Session<'_>,
    work: impl AsyncFnOnce(&mut Session<'_>) -> Result<bool, AccessError>,
) -> Result<bool, AccessError> {
    session.insist(true);
    let limits = session.limits();
    session.set_limits(Limits { reply_timeout: GLANCE.min(limits.reply_timeout), retries: 0, ..limits });
    let said = work(session).await;
    session.set_limits(limits);
    session.end_at(None);
    session.insist(false);
    said
}

async fn say_zero(
    session: &mut Session<'_>,
    registry: &Registry,
    meant: &Meant,
    modes: &dyn Fn(&Family) -> Vec<Mode>,
) -> Result<bool, AccessError> {
    let families = match &meant.family {
        Some(family) => vec![family.clone()],
        None => presumed(session, registry, meant.address).await?,
    };
    let mut zeros = Vec::new();
    for family in &families {
        for mode in acting(session, meant, family, modes(family)).await? {
            if mode.source.is_none() || only_slows(session, meant, family).await? {
                let param = family.param_or_unknown(mode.setpoint);
                let inquiry = Inquiry::Write(Cell { number: param.id, set: 0 }, param.kind.unwrap_or(Type::Long), 0);
                zeros.extend(meant.questions(session.protocol(), session.node(), family, inquiry, false));
            }
        }
    }
    repeat(session, meant, &zeros).await?;
    Ok(!zeros.is_empty())
}

/// Of these modes the one that the drive shows; all, where it shows none.
async fn acting(
    session: &mut Session<'_>,
    meant: &Meant,
    family: &Rc<Family>,
    modes: Vec<Mode>,
) -> Result<Vec<Mode>, AccessError> {
    let active = told(session, meant, family, "mode-active").await?;
    let known = |active: &i64| family.modes.iter().any(|mode| mode.value == Some(*active));
    let Some(active) = active.filter(known) else { return Ok(modes) };
    Ok(modes.into_iter().filter(|mode| mode.value.is_none_or(|value| value == active)).collect())
}

/// Whether a line setpoint of zero cannot turn the shaft faster, nor the other way, as far as that is told in time.
async fn only_slows(session: &mut Session<'_>, meant: &Meant, family: &Rc<Family>) -> Result<bool, AccessError> {
    let begun = session.now();
    let (mut internal, mut line) = (None, None);
    while session.now().since(begun) < LOOKING {
        if internal.is_none() {
            internal = told(session, meant, family, "setpoint-internal").await?;
        }
        // One after the other: the same asked again needs no fence between.
        if internal.is_some_and(|internal| internal != 0) && line.is_none() {
            line = told(session, meant, family, "setpoint-bus").await?;
        }
        match (internal, line) {
            (Some(0), _) | (_, Some(0)) => return Ok(true),
            (Some(internal), Some(line)) => return Ok(internal.signum() == line.signum()),
            _ => {}
        }
    }
    Ok(internal.is_none() && line.is_none())
}

/// The raw value of a role, if the drive tells it in a short time.
async fn told(
    session: &mut Session<'_>,
    meant: &Meant,
    family: &Rc<Family>,
    role: &str,
) -> Result<Option<i64>, AccessError> {
    let mut target = Target::new(meant.address, family.clone());
    session.end_at(Some(session.now() + BRIEF));
    in_short(role_raw(session, &mut target, role, Lang::En).await)
}

/// What was not told in a short time is not known.
fn in_short(told: Result<Option<i64>, Failure>) -> Result<Option<i64>, AccessError> {
    match told {
        Ok(value) => Ok(value),
        Err(failure) if failure.class == Class::Interrupted => Err(AccessError::Interrupted),
        Err(_) => Ok(None),
    }
}

/// The families that it may be. One question tells who describes itself and who does not; without an answer it may be any.
async fn presumed(session: &mut Session<'_>, registry: &Registry, address: u8) -> Result<Vec<Rc<Family>>, AccessError> {
    // One of each kind: drives whose control words are reached the same way are stopped the same way.
    let mut kinds: Vec<Rc<Family>> = Vec::new();
    for family in registry.families() {
        let key = |family: &Family| (family.link.route, family.role("control-word").map(|param| param.id));
        if key(&family).1.is_some() && kinds.iter().all(|known| key(known) != key(&family)) {
            kinds.push(family);
        }
    }
    session.end_at(Some(session.now() + BRIEF));
    if let Some(describes) = family::describes_itself(session, address).await? {
        kinds.retain(|family| family.link.product.is_some() == describes);
    }
    Ok(kinds)
}

/// The word that goes out first. Where it would close contacts it must be proven that it is none of them.
async fn first_word(
    session: &mut Session<'_>,
    meant: &Meant,
    family: &Rc<Family>,
    act: Relief,
) -> Result<Option<u16>, AccessError> {
    let sure = act == Relief::Disable && obeys(session, meant, family).await?;
    if let Some(mode) = family.role("control-mode").filter(|_| act == Relief::Disable && !sure) {
        let (label, lang) = (mode.label(), session.lang());
        session.tell(Event::Note(match lang {
            Lang::En => {
                format!("{label} did not tell in time that commands are obeyed: a quick stop in place of the ramp")
            }
            Lang::De => format!("{label} sagte nicht rechtzeitig, dass Befehle gelten: Schnellhalt statt Rampe"),
        }));
    }
    Ok(blind(family, act, sure).and_then(|slug| family.machine.command(slug)).map(|command| command.word))
}

/// The command that can only stop; `obeyed`: the control word stands for commands, so that nothing can be closed by it.
pub(super) fn blind(family: &Family, act: Relief, obeyed: bool) -> Option<&'static str> {
    match act {
        Relief::Disable if family.motion.control.is_some() && !obeyed => Some("quick-stop"),
        act => command_of(act),
    }
}

/// Whether the drive says that the control word stands for commands. What it does not say in a short time is no.
async fn obeys(session: &mut Session<'_>, meant: &Meant, family: &Rc<Family>) -> Result<bool, AccessError> {
    let (Some(control), Some(mode)) = (family.motion.control, family.role("control-mode")) else { return Ok(false) };
    let mut target = Target::new(meant.address, family.clone());
    session.end_at(Some(session.now() + BRIEF));
    Ok(in_short(working(session, &mut target, mode, Lang::En).await)? == Some(control.obeys))
}

/// The telegrams that carry a control word: in both orders where it is not known which half comes first.
fn telegrams(session: &Session<'_>, meant: &Meant, family: &Family, word: u16) -> Vec<Question> {
    let Some(param) = family.role("control-word") else { return Vec::new() };
    let cell = Cell { number: param.id, set: 0 };
    let inquiry = Inquiry::Write(cell, param.kind.unwrap_or(Type::Uint), word.into());
    let both = word != 0 && family.role("word-order").is_some();
    meant.questions(session.protocol(), session.node(), family, inquiry, both)
}
