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

use super::look::working;
use super::relief::command_of;
use crate::drive::family;
use crate::drive::route::{Cell, Inquiry, Meant};
use crate::drive::session::{AccessError, Session};
use crate::drive::transfer::Target;
use crate::exchange::{Answer, Limits, Question};
use crate::failure::Class;
use crate::gate::Relief;
use crate::profile::{Family, Lang, Registry, Type};
use crate::tick::Span;
use std::rc::Rc;

/// How long an answer is waited for before the stop is said again. Longer than a drive takes that has nothing else to do;
/// an answer that comes later still counts, because the same was asked again.
const SHORT: Span = Span::from_millis(250);
/// How long the stop waits for the answer to a question before it.
const GLANCE: Span = Span::from_millis(150);
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
    session.insist(true);
    let limits = session.limits();
    session.set_limits(Limits { reply_timeout: GLANCE.min(limits.reply_timeout), retries: 0, ..limits });
    let said = say(session, registry, meant, act).await;
    session.set_limits(limits);
    session.insist(false);
    said
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
    let limits = session.limits();
    session.set_limits(Limits { reply_timeout: SHORT, ..limits });
    for _ in 0..TIMES {
        for word in &words {
            match session.blurt(meant.address, word.clone()).await {
                Ok(Answer::Reply { said, .. }) if crate::drive::route::no(&said).is_none() => return Ok(true),
                Err(error) if error.is_fatal() => return Err(error),
                _ => {}
            }
        }
    }
    Ok(false)
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
    match working(session, &mut target, mode, Lang::En).await {
        Ok(mode) => Ok(mode == Some(control.obeys)),
        Err(failure) if failure.class == Class::Interrupted => Err(AccessError::Interrupted),
        Err(_) => Ok(false),
    }
}

/// The telegrams that carry a control word: in both orders where it is not known which half comes first.
fn telegrams(session: &Session<'_>, meant: &Meant, family: &Family, word: u16) -> Vec<Question> {
    let Some(param) = family.role("control-word") else { return Vec::new() };
    let cell = Cell { number: param.id, set: 0 };
    let inquiry = Inquiry::Write(cell, param.kind.unwrap_or(Type::Uint), word.into());
    let both = word != 0 && family.role("word-order").is_some();
    meant.questions(session.protocol(), session.node(), family, inquiry, both)
}
