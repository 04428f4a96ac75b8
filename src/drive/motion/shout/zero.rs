//! A setpoint of zero, said before anything is asked that it does not need.

use super::super::look::role_raw;
use super::word::TO_TELL;
use super::{
    BRIEF, PAUSE, SHORT, SHOUTING, TIMES, TURN, at_once, doubted, in_short, in_turn, insist, narrowed, others,
    presumed, unless_interrupted,
};
use crate::drive::access::AccessError;
use crate::drive::route::{Cell, Inquiry, Meant, no};
use crate::drive::session::Session;
use crate::drive::target::Target;
use crate::exchange::{Answer, Limits, Question};
use crate::failure::unanswered_stop;
use crate::outcome::Event;
use crate::profile::{Family, Mode, Registry, Type};
use crate::text::both;
use crate::tick::{Span, Tick};
use std::collections::VecDeque;
use std::rc::Rc;

/// When the last question whether a setpoint of zero only slows the shaft ends: a drive that has told the first has told both by then.
const LOOKED: Span = Span::from_millis(900);
/// Who refuses to tell so often has none of its own, and is not busy for a moment only.
const REFUSALS: u8 = 3;

/// Gives a setpoint of zero before anything is asked that it does not need; says whether one went out. `modes`: those of a
/// family that may be meant.
pub async fn shout_zero(
    session: &mut Session<'_>,
    registry: &Registry,
    meant: &Meant,
    modes: &dyn Fn(&Family) -> Vec<Mode>,
) -> Result<bool, AccessError> {
    let (tried, mut again) = (session.now(), true);
    loop {
        let say = async |session: &mut Session<'_>| say_zero(session, registry, meant, modes).await;
        match at_once(session, say).await {
            Err(error) if error.is_stuck() && session.now().since(tried) < SHOUTING => {}
            // A gateway that has closed its connection may take another one.
            Err(error) if error.is_lost() && std::mem::take(&mut again) && session.reopen().await.is_ok() => {}
            said => return said,
        }
    }
}

async fn say_zero(
    session: &mut Session<'_>,
    registry: &Registry,
    meant: &Meant,
    modes: &dyn Fn(&Family) -> Vec<Mode>,
) -> Result<bool, AccessError> {
    let now = session.now();
    let (mut families, told) = match &meant.family {
        Some(family) => (vec![family.clone()], true),
        None => presumed(session, registry, meant.address).await?,
    };
    let asked = (!told).then_some(now);
    let (mut said, refused) = say_zero_to(session, meant, (&mut families, asked), modes).await?;
    let others = refused.then(|| others(registry, &families)).flatten();
    if let Some((named, mut others)) = others
        && let Some(why) = doubted(meant, &named)
    {
        session.tell(Event::Note(both!(
            "the drive refuses the setpoint of the family {drive}{why} A zero of the other families goes out too, \
             where they know it",
            "der Antrieb lehnt den Sollwert der Familie {drive} ab{why} Die Null der anderen Familien geht auch \
             hinaus, wo sie sie kennen",
            drive = named.drive,
            why
        )));
        said |= say_zero_to(session, meant, (&mut others, None), modes).await?.0;
    }
    Ok(said)
}

/// Gives the zeros of these families; whether one went out, and whether nobody took one and somebody refused it. Who was `asked` who he
/// is, and has not told, may tell it late, and is given none of the others then.
async fn say_zero_to(
    session: &mut Session<'_>,
    meant: &Meant,
    (families, asked): (&mut Vec<Rc<Family>>, Option<Tick>),
    modes: &dyn Fn(&Family) -> Vec<Mode>,
) -> Result<(bool, bool), AccessError> {
    let (mut wholes, mut unspeakable) = (Vec::new(), false);
    let opening = match asked {
        Some(asked) => open(session, meant, (families, asked), modes).await?,
        None => Opening::default(),
    };
    let mut slow = false;
    for family in &families.clone() {
        slow = slow || (asked.is_some() && narrowed(session, meant.address, families));
        if !families.iter().any(|left| left.drive == family.drive) {
            continue;
        }
        // Who has said nothing for as long as a drive may take is asked nothing more before his zero.
        let is_silent = !slow && !opening.answered && asked.is_some_and(|asked| session.now().since(asked) >= TURN);
        // Each acts in its own mode only, so one that is acknowledged is not enough.
        let mut zeros = VecDeque::new();
        let all = modes(family);
        for mode in if is_silent { all } else { acting(session, meant, family, all).await? } {
            if mode.source.is_none() || is_silent || only_slows(session, meant, family).await? {
                let zero = zero_of(session, meant, family, &mode);
                // What the protocol has no telegram for was refused before it went out.
                unspeakable |= zero.is_empty();
                zeros.extend(zero);
            }
        }
        if opening.said.as_ref() == zeros.front() {
            // It went out already.
            zeros.rotate_left(1.min(zeros.len()));
        }
        wholes.extend(Some((family.clone(), zeros)).filter(|(_, zeros)| !zeros.is_empty()));
    }
    slow = slow || (asked.is_some() && narrowed(session, meant.address, families));
    wholes.retain(|(family, _)| families.iter().any(|left| left.drive == family.drive));
    let wholes: Vec<_> = wholes.into_iter().map(|(_, zeros)| zeros.into()).collect();
    let said = !wholes.is_empty();
    let refused = match repeat(session, meant, wholes, (slow, opening.pressed)).await {
        // It went out: what came of it is told.
        Err(AccessError::Interrupted) => false,
        repeated => repeated?,
    };
    Ok((said, refused || (unspeakable && !said)))
}

/// The zero that goes out before its family is known.
#[derive(Default)]
struct Opening {
    said: Option<Question>,
    /// The drive has answered, whatever it said.
    answered: bool,
    /// Somebody interrupted meanwhile.
    pressed: bool,
}

/// Says the first zero that needs no question to a drive that has not told in time who it is; it has the rest of the time for that
/// then, in which the zero of another kind would meet its answer on the line.
async fn open(
    session: &mut Session<'_>,
    meant: &Meant,
    (families, asked): (&mut Vec<Rc<Family>>, Tick),
    modes: &dyn Fn(&Family) -> Vec<Mode>,
) -> Result<Opening, AccessError> {
    let plain = |family: &Rc<Family>| {
        let mode = modes(family).into_iter().next().filter(|mode| mode.source.is_none())?;
        Some((family.clone(), zero_of(session, meant, family, &mode).into_iter().next()?))
    };
    let Some((family, zero)) = families.iter().find_map(plain) else {
        return Ok(Opening::default());
    };
    let waits = SHORT.longer((asked + TURN + PAUSE).since(session.now()));
    let limits = Limits { reply_timeout: waits, ..session.limits() };
    let tells = async |session: &mut Session<'_>| session.sound(meant.address).await;
    let said = async |session: &mut Session<'_>| insist(session, meant.address, &zero, tells).await;
    let (answer, pressed) = session.within(limits, said).await;
    let answered = match answer {
        Ok(Answer::Reply { said, .. }) => {
            if no(&said).is_none() {
                *families = vec![family];
            }
            true
        }
        Err(error) if error.is_fatal() => return Err(error),
        _ => false,
    };
    Ok(Opening { said: Some(zero), answered, pressed })
}

/// The telegrams that set the setpoint of a mode to 0.
fn zero_of(session: &Session<'_>, meant: &Meant, family: &Family, mode: &Mode) -> Vec<Question> {
    let param = family.param_or_unknown(mode.setpoint);
    let inquiry = Inquiry::Write(Cell { number: param.id, set: 0 }, param.kind.unwrap_or(Type::Long), 0);
    meant.questions(session.protocol(), session.node(), family, inquiry, false)
}

/// Of these modes the one that the drive shows; all, where it shows none.
async fn acting(
    session: &mut Session<'_>,
    meant: &Meant,
    family: &Rc<Family>,
    modes: Vec<Mode>,
) -> Result<Vec<Mode>, AccessError> {
    let by = session.now() + BRIEF;
    let active = told(session, meant, family, ("mode-active", by)).await?.flatten();
    let known = |active: &i64| family.modes.iter().any(|mode| mode.value == Some(*active));
    let Some(active) = active.filter(known) else { return Ok(modes) };
    Ok(modes.into_iter().filter(|mode| mode.value.is_none_or(|value| value == active)).collect())
}

/// Whether a line setpoint of zero cannot turn the shaft faster, nor the other way, as far as that is told in time.
async fn only_slows(session: &mut Session<'_>, meant: &Meant, family: &Rc<Family>) -> Result<bool, AccessError> {
    let begun = session.now();
    let (mut internal, mut line, mut refusals) = (None, None, 0);
    while session.now().since(begun) < TO_TELL && refusals < REFUSALS {
        if internal.is_none() {
            let told = told(session, meant, family, ("setpoint-internal", begun + TO_TELL)).await?;
            refusals += u8::from(told == Some(None));
            internal = told.flatten();
        }
        // One after the other: the same asked again needs no fence between.
        if internal.is_some_and(|internal| internal != 0) && line.is_none() {
            line = told(session, meant, family, ("setpoint-bus", begun + LOOKED)).await?.flatten();
        }
        match (internal, line) {
            (Some(0), _) | (_, Some(0)) => return Ok(true),
            (Some(internal), Some(line)) => return Ok(internal.signum() == line.signum()),
            _ => {
                let rested = session.rest(PAUSE).await;
                if unless_interrupted(session, rested)?.is_none() {
                    break;
                }
            }
        }
    }
    Ok(internal.is_none() && line.is_none())
}

/// Says it until the whole of one of these is acknowledged, or has been said often enough; whether it was refused instead. Who is
/// `slow` has heard it: said again and again, nobody could tell his answers apart.
async fn repeat(
    session: &mut Session<'_>,
    meant: &Meant,
    mut wholes: Vec<Vec<Question>>,
    (slow, mut interrupted): (bool, bool),
) -> Result<bool, AccessError> {
    let (limits, patient) = (session.limits(), session.patient());
    session.warns(unanswered_stop());
    let mut refused = false;
    let (begun, mut round) = (session.now(), 0);
    while round < TIMES {
        let mut is_stuck = false;
        let waits = if slow || round == 1 { patient.reply_timeout } else { SHORT };
        session.set_limits(Limits { reply_timeout: waits, ..limits });
        for words in &mut wholes {
            for word in std::mem::take(words) {
                let (answer, pressed) =
                    insist(session, meant.address, &word, async |session| session.sound(meant.address).await).await;
                interrupted |= pressed;
                match answer {
                    Ok(Answer::Reply { said, .. }) if no(&said).is_none() => continue,
                    Ok(Answer::Reply { .. }) => refused = true,
                    Err(error) if error.is_stuck() => is_stuck = true,
                    Err(error) if error.is_fatal() => return Err(error),
                    _ => {}
                }
                words.push(word);
            }
            if words.is_empty() {
                return Ok(false);
            }
        }
        // What met something else on the line is said once more.
        if interrupted && (round > 0 || is_stuck) {
            return Err(AccessError::Interrupted);
        }
        // A port that takes no bytes has not said it.
        round += u8::from(!is_stuck || session.now().since(begun) >= SHOUTING);
    }
    Ok(refused)
}

/// The raw value of a role, `None` in it if the drive has none, if that is told in the time that it may take, and by then.
async fn told(
    session: &mut Session<'_>,
    meant: &Meant,
    family: &Rc<Family>,
    (role, by): (&str, Tick),
) -> Result<Option<Option<i64>>, AccessError> {
    let mut target = Target::new(meant.address, family.clone());
    let patient = in_turn(session);
    session.end_at(Some(by.min(session.now() + patient.reply_timeout)));
    let tell = async |session: &mut Session<'_>| role_raw(session, &mut target, role).await;
    let told = in_short(session.within(patient, tell).await);
    // Whoever interrupts that gets his zero at once.
    Ok(unless_interrupted(session, told)?.flatten())
}
