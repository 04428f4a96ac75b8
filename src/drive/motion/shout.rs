//! The first telegrams of an act that takes motion away: they go out before anything is asked that they do not need.
//!
//! Which word can only stop, whoever hears it:
//! - An ACTIVE drive takes P.410 as commands with P.412 = 1, as contacts with P.412 = 2, and not at all with P.412 = 0
//!   (CM-485 manual 9.1). 00h is "disable voltage" and all contacts open. 02h is "quick stop", and as contacts it leaves
//!   S1IND open, without which there is no release (9.1.3): neither can start anything. 07h, "disable operation", would
//!   close S1IND to S3IND and could. So P.410 is asked first: where the three stand already, 07h takes bits away only and
//!   closes nothing, whoever listens; a drive that was enabled by commands shows 0Fh. Where they do not, P.412 decides, as
//!   the drive works with it (P.249, P.412): with 1 the word is 07h; with 2 it is P.410 without the start contacts, so that
//!   S1IND keeps the power for the ramp. Each question has the 500 ms that 6.8 allows, and a little more; where nothing is
//!   told in time the quick stop goes out in place of the ramp. Bit 9 of the status word, Remote, tells nothing: 9.1.3
//!   names it with P.412 = 2 too.
//! - An LXM05 always obeys DCOMcontrol (CiA 402, sources H). Which half of a value comes first may be unknown: 0 is the same
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

use super::look::{raw, role_raw};
use super::relief::command_of;
use crate::drive::access::AccessError;
use crate::drive::recognise;
use crate::drive::route::{Cell, Inquiry, Meant};
use crate::drive::session::Session;
use crate::drive::target::Target;
use crate::exchange::{Answer, Limits, Question};
use crate::failure::{Class, Failure};
use crate::gate::Relief;
use crate::outcome::Event;
use crate::profile::{Control, DataSets, Family, Mode, Param, Registry, Sets, Type};
use crate::text::both;
use crate::tick::Span;
use std::rc::Rc;

/// How long an answer is waited for before the stop is said again. Longer than a drive takes that has nothing else to do;
/// an answer that comes later still counts, because the same was asked again.
const SHORT: Span = Span::from_millis(250);
/// How long the stop waits for the answer to a question before it.
const GLANCE: Span = Span::from_millis(150);
/// How long it is asked what a ramp is: for as long as a drive may take to answer (500 ms, CM-485 manual 6.8), and once more,
/// if that was lost.
const TO_TELL: Span = Span::from_millis(700);
/// How long it is looked whether a setpoint of zero only slows the shaft.
const LOOKING: Span = Span::from_millis(600);
/// How long one telegram of it may take with its answer, whatever comes over the line.
const BRIEF: Span = Span::from_millis(450);
/// The pause before the same is asked again: a drive may say no, or say nothing that can be read, at once.
const PAUSE: Span = Span::from_millis(10);
/// How often the stop is said while nobody acknowledges it: replies of 900 ms (CM-485 manual 6.8 promises less) are in time.
const TIMES: u8 = 5;

/// What went out first to a drive whose control word has more than one meaning.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FirstWord {
    /// The control word; it can only stop.
    pub(super) word: Option<u16>,
    /// A quick stop in place of the ramp that was asked for.
    pub(super) instead: bool,
}

/// Sends what stops the drive until it is acknowledged, or has been said often enough. An act that is no command sends
/// nothing.
pub async fn shout(
    session: &mut Session<'_>,
    registry: &Registry,
    meant: &Meant,
    act: Relief,
) -> Result<FirstWord, AccessError> {
    if command_of(act).is_none() {
        return Ok(FirstWord::default());
    }
    at_once(session, async |session: &mut Session<'_>| say(session, registry, meant, act).await).await
}

async fn say(
    session: &mut Session<'_>,
    registry: &Registry,
    meant: &Meant,
    act: Relief,
) -> Result<FirstWord, AccessError> {
    let families = match &meant.family {
        Some(family) => vec![family.clone()],
        None => presumed(session, registry, meant.address).await?,
    };
    let (said, refused) = say_to(session, meant, &families, act).await?;
    if let Some((named, others)) = refused.then(|| others(registry, &families)).flatten() {
        session.tell(Event::Note(both!(
            "the drive refuses the stop of a {drive}: is --drive right? The stop of the other families goes out too",
            "der Antrieb lehnt den Halt eines {drive} ab: stimmt --drive? Der Halt der anderen Familien geht auch hinaus",
            drive = named.drive
        )));
        say_to(session, meant, &others, act).await?;
    }
    Ok(said)
}

/// Who refuses the words of its family may be of another one, and runs: the families of the other kinds, if there was one.
fn others(registry: &Registry, families: &[Rc<Family>]) -> Option<(Rc<Family>, Vec<Rc<Family>>)> {
    let [named] = families else { return None };
    let others = kinds(registry).into_iter().filter(|family| kind(family) != kind(named)).collect();
    named.is_movable().then(|| (named.clone(), others))
}

/// Says it in the words of these families; whether nobody acknowledged it and somebody refused it.
async fn say_to(
    session: &mut Session<'_>,
    meant: &Meant,
    families: &[Rc<Family>],
    act: Relief,
) -> Result<(FirstWord, bool), AccessError> {
    let (mut words, mut said) = (Vec::new(), FirstWord::default());
    for family in families {
        let first = first_word(session, meant, family, act).await?;
        words.extend(first.word.into_iter().flat_map(|word| telegrams(session, meant, family, word)));
        if family.motion.control.is_some() {
            said = first;
        }
    }
    // What the protocol has no telegram for was refused before it went out.
    let unspeakable = words.is_empty();
    let refused = repeat(session, meant, words.into_iter().map(|word| vec![word]).collect()).await?;
    Ok((said, refused || unspeakable))
}

/// Says it until the whole of one of these is acknowledged, or has been said often enough; whether it was refused instead.
async fn repeat(session: &mut Session<'_>, meant: &Meant, mut wholes: Vec<Vec<Question>>) -> Result<bool, AccessError> {
    let limits = session.limits();
    let (mut refused, mut interrupted) = (false, false);
    session.set_limits(Limits { reply_timeout: SHORT, ..limits });
    for _ in 0..TIMES {
        for words in &mut wholes {
            for word in std::mem::take(words) {
                let (answer, pressed) = insist(session, meant.address, &word).await;
                interrupted |= pressed;
                match answer {
                    Ok(Answer::Reply { said, .. }) if crate::drive::route::no(&said).is_none() => continue,
                    Ok(Answer::Reply { .. }) => refused = true,
                    Err(error) if error.is_fatal() => return Err(error),
                    _ => {}
                }
                words.push(word);
            }
            if words.is_empty() {
                return Ok(false);
            }
        }
        if interrupted {
            return Err(AccessError::Interrupted);
        }
    }
    Ok(refused)
}

/// Says it once; whoever interrupts that gets it said again, and waits no longer than for this answer. Whether somebody did.
async fn insist(session: &mut Session<'_>, address: u8, word: &Question) -> (Result<Answer, AccessError>, bool) {
    let mut pressed = false;
    loop {
        session.end_at(Some(session.now() + BRIEF));
        match session.blurt(address, word.clone()).await {
            Err(AccessError::Interrupted) => {
                session.note_interrupts();
                pressed = true;
            }
            answer => return (answer, pressed),
        }
    }
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
async fn at_once<T>(
    session: &mut Session<'_>,
    work: impl AsyncFnOnce(&mut Session<'_>) -> Result<T, AccessError>,
) -> Result<T, AccessError> {
    session.insist(true);
    let limits = session.limits();
    let brief = Limits { reply_timeout: GLANCE.min(limits.reply_timeout), retries: 0, ..limits };
    let said = session.within(brief, work).await;
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
    let (mut said, refused) = say_zero_to(session, meant, &families, modes).await?;
    if let Some((named, others)) = refused.then(|| others(registry, &families)).flatten() {
        session.tell(Event::Note(both!(
            "the drive refuses the setpoint of a {drive}: is --drive right? A zero of the other families goes out too, \
             where they know it",
            "der Antrieb lehnt den Sollwert eines {drive} ab: stimmt --drive? Die Null der anderen Familien geht auch \
             hinaus, wo sie sie kennen",
            drive = named.drive
        )));
        said |= say_zero_to(session, meant, &others, modes).await?.0;
    }
    Ok(said)
}

/// Gives the zeros of these families; whether one went out, and whether nobody took one and somebody refused it.
async fn say_zero_to(
    session: &mut Session<'_>,
    meant: &Meant,
    families: &[Rc<Family>],
    modes: &dyn Fn(&Family) -> Vec<Mode>,
) -> Result<(bool, bool), AccessError> {
    let (mut wholes, mut unspeakable) = (Vec::new(), false);
    for family in families {
        // Each acts in its own mode only, so one that is acknowledged is not enough.
        let mut zeros = Vec::new();
        for mode in acting(session, meant, family, modes(family)).await? {
            if mode.source.is_none() || only_slows(session, meant, family).await? {
                let param = family.param_or_unknown(mode.setpoint);
                let inquiry = Inquiry::Write(Cell { number: param.id, set: 0 }, param.kind.unwrap_or(Type::Long), 0);
                let zero = meant.questions(session.protocol(), session.node(), family, inquiry, false);
                // What the protocol has no telegram for was refused before it went out.
                unspeakable |= zero.is_empty();
                zeros.extend(zero);
            }
        }
        wholes.extend(Some(zeros).filter(|zeros| !zeros.is_empty()));
    }
    let said = !wholes.is_empty();
    let refused = match repeat(session, meant, wholes).await {
        // It went out: what came of it is told.
        Err(AccessError::Interrupted) => false,
        repeated => repeated?,
    };
    Ok((said, refused || (unspeakable && !said)))
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
            _ => session.rest(PAUSE).await?,
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
    in_short(role_raw(session, &mut target, role).await)
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
    let mut kinds = kinds(registry);
    session.end_at(Some(session.now() + BRIEF));
    let describes = recognise::describes_itself(session, address).await;
    if let Some(describes) = unless_interrupted(session, describes)?.flatten() {
        kinds.retain(|family| family.link.product.is_some() == describes);
    }
    Ok(kinds)
}

/// Whoever interrupts a question before the stop ends the question: the stop goes out without its answer.
fn unless_interrupted<T>(session: &mut Session<'_>, told: Result<T, AccessError>) -> Result<Option<T>, AccessError> {
    match told {
        Err(AccessError::Interrupted) => {
            session.note_interrupts();
            Ok(None)
        }
        told => told.map(Some),
    }
}

/// One family of each kind that can be moved.
fn kinds(registry: &Registry) -> Vec<Rc<Family>> {
    let mut kinds: Vec<Rc<Family>> = Vec::new();
    for family in registry.families().into_iter().filter(|family| family.is_movable()) {
        if kinds.iter().all(|known| kind(known) != kind(&family)) {
            kinds.push(family);
        }
    }
    kinds
}

/// Drives whose control words are reached the same way are stopped the same way.
fn kind(family: &Family) -> (crate::profile::Route, Option<u32>) {
    (family.link.route, family.role("control-word").map(|param| param.id))
}

/// The word that goes out first. Where it could close contacts it must be proven that it does not.
async fn first_word(
    session: &mut Session<'_>,
    meant: &Meant,
    family: &Rc<Family>,
    act: Relief,
) -> Result<FirstWord, AccessError> {
    let word_of = |slug| family.machine.command(slug).map(|command| command.word);
    let Some(control) = family.motion.control.filter(|_| act == Relief::Disable) else {
        return Ok(FirstWord { word: command_of(act).and_then(word_of), instead: false });
    };
    let ramp = ramp_word(session, meant, family, control).await;
    if let Some(word) = unless_interrupted(session, ramp)?.flatten() {
        return Ok(FirstWord { word: Some(word), instead: false });
    }
    let label = family.role_label("control-mode");
    session.tell(Event::Note(both!(
        "{label} did not tell in time what the control word is: a quick stop in place of the ramp",
        "{label} sagte nicht rechtzeitig, was das Steuerwort ist: Schnellhalt statt Rampe"
    )));
    Ok(FirstWord { word: word_of("quick-stop"), instead: true })
}

/// The word that ramps the drive down and closes no contact; `None` if that was not told in time.
async fn ramp_word(
    session: &mut Session<'_>,
    meant: &Meant,
    family: &Rc<Family>,
    control: Control,
) -> Result<Option<u16>, AccessError> {
    let command = command_of(Relief::Disable).and_then(|slug| family.machine.command(slug));
    let (Some(word), Some(disable)) = (family.role("control-word"), command.map(|command| command.word)) else {
        return Ok(None);
    };
    let Some(stands) = asked(session, meant, family, word, 0).await?.and_then(|word| u16::try_from(word).ok()) else {
        return Ok(None);
    };
    if disable & !stands == 0 {
        return Ok(Some(disable));
    }
    Ok(match in_force(session, meant, family).await? {
        Some(mode) if mode == control.obeys => Some(disable),
        Some(mode) if mode == control.contacts => Some(stands & !control.start_contacts),
        // Nobody listens to it: the one that could do no harm if somebody did.
        Some(_) => family.machine.command("quick-stop").map(|command| command.word),
        None => None,
    })
}

/// What the control word stands for, as the drive works with it.
async fn in_force(session: &mut Session<'_>, meant: &Meant, family: &Rc<Family>) -> Result<Option<i64>, AccessError> {
    let (Some(mode), Some(active)) = (family.role("control-mode"), family.role("active-set")) else { return Ok(None) };
    let active = if mode.sets == Some(Sets::Four) { asked(session, meant, family, active, 0).await? } else { Some(0) };
    let Some(active) = active.and_then(|active| u8::try_from(active).ok()) else { return Ok(None) };
    asked(session, meant, family, mode, DataSets::RAM_OFFSET + active).await
}

/// Asks until it is told, as long as a drive may take. Asked again sooner, an answer that comes then would count as none:
/// it could be one to either.
async fn asked(
    session: &mut Session<'_>,
    meant: &Meant,
    family: &Rc<Family>,
    param: &Param,
    set: u8,
) -> Result<Option<i64>, AccessError> {
    let mut target = Target::new(meant.address, family.clone());
    let until = session.now() + TO_TELL;
    session.end_at(Some(until));
    let patient = Limits { reply_timeout: Limits::default().reply_timeout, ..session.limits() };
    let tell = async |session: &mut Session<'_>| loop {
        match raw(session, &mut target, param, set).await {
            Err(failure) if matches!(failure.class, Class::Silence | Class::Garbled) && session.now() < until => {}
            told => break in_short(told),
        }
        session.rest(PAUSE).await?;
    };
    session.within(patient, tell).await
}

/// The telegrams that carry a control word: in both orders where it is not known which half comes first.
fn telegrams(session: &Session<'_>, meant: &Meant, family: &Family, word: u16) -> Vec<Question> {
    let Some(param) = family.role("control-word") else { return Vec::new() };
    let cell = Cell { number: param.id, set: 0 };
    let inquiry = Inquiry::Write(cell, param.kind.unwrap_or(Type::Uint), word.into());
    let both = word != 0 && family.role("word-order").is_some();
    meant.questions(session.protocol(), session.node(), family, inquiry, both)
}
