//! Which word goes out first to a drive of a family, and what must be asked for it before.

use super::super::look::raw;
use super::super::relief::command_of;
use super::{FirstWord, PAUSE, in_short, in_turn, unless_interrupted};
use crate::drive::access::AccessError;
use crate::drive::route::{Cell, Inquiry, Meant};
use crate::drive::session::Session;
use crate::drive::target::Target;
use crate::exchange::Question;
use crate::gate::Relief;
use crate::outcome::Event;
use crate::profile::{Control, DataSets, Family, Param, Sets, Type};
use crate::text::both;
use crate::tick::{Span, Tick};
use std::rc::Rc;

/// How long each question for a ramp, or for what a setpoint of zero does, is asked: for as long as a drive may take to answer (CM-485
/// manual 6.8), and once more, if that was lost, of a drive that answers at once.
pub(super) const TO_TELL: Span = Span::from_millis(560);

/// Whether something must be asked before the first word of this family.
pub(super) fn must_ask(family: &Family, act: Relief) -> bool {
    family.motion.control.is_some() && act == Relief::Disable
}

/// The word that goes out first. Where it could close contacts it must be proven that it does not.
/// `by`: it is asked until then; what was not told is a quick stop, or without `force` not known yet.
pub(super) async fn first_word(
    session: &mut Session<'_>,
    meant: &Meant,
    family: &Rc<Family>,
    act: Relief,
    (by, force): (Option<Tick>, bool),
) -> Result<Option<FirstWord>, AccessError> {
    let word_of = |slug| family.machine.command(slug).map(|command| command.word);
    let Some(control) = family.motion.control.filter(|_| act == Relief::Disable) else {
        return Ok(Some(FirstWord { word: command_of(act).and_then(word_of), instead: false, ..FirstWord::default() }));
    };
    match ramp_word(session, meant, family, control, by).await {
        Ok(Some(word)) => return Ok(Some(FirstWord { word: Some(word), instead: false, ..FirstWord::default() })),
        Ok(None) if !force => return Ok(None),
        // Whoever interrupts that gets a stop at once.
        ramp => unless_interrupted(session, ramp)?,
    };
    let label = family.role_label("control-mode");
    session.tell(Event::Note(both!(
        "{label} did not tell in time what the control word is: a quick stop in place of the ramp",
        "{label} sagte nicht rechtzeitig, was das Steuerwort ist: Schnellhalt statt Rampe"
    )));
    Ok(Some(FirstWord { word: word_of("quick-stop"), instead: true, ..FirstWord::default() }))
}

/// The word that ramps the drive down and closes no contact; `None` if that was not told in time.
async fn ramp_word(
    session: &mut Session<'_>,
    meant: &Meant,
    family: &Rc<Family>,
    control: Control,
    by: Option<Tick>,
) -> Result<Option<u16>, AccessError> {
    let command = command_of(Relief::Disable).and_then(|slug| family.machine.command(slug));
    let (Some(word), Some(disable)) = (family.role("control-word"), command.map(|command| command.word)) else {
        return Ok(None);
    };
    let Some(stands) = asked(session, meant, family, (word, 0), by).await?.and_then(|word| u16::try_from(word).ok())
    else {
        return Ok(None);
    };
    if disable & !stands == 0 {
        return Ok(Some(disable));
    }
    Ok(match in_force(session, meant, family, by).await? {
        Some(mode) if mode == control.obeys => Some(disable),
        Some(mode) if mode == control.contacts => Some(stands & !control.start_contacts),
        // Nobody listens to it: the one that could do no harm if somebody did.
        Some(_) => family.machine.command("quick-stop").map(|command| command.word),
        None => None,
    })
}

/// What the control word stands for, as the drive works with it.
async fn in_force(
    session: &mut Session<'_>,
    meant: &Meant,
    family: &Rc<Family>,
    by: Option<Tick>,
) -> Result<Option<i64>, AccessError> {
    let (Some(mode), Some(active)) = (family.role("control-mode"), family.role("active-set")) else { return Ok(None) };
    let active =
        if mode.sets == Some(Sets::Four) { asked(session, meant, family, (active, 0), by).await? } else { Some(0) };
    let Some(active) = active.and_then(|active| u8::try_from(active).ok()) else { return Ok(None) };
    asked(session, meant, family, (mode, DataSets::RAM_OFFSET + active), by).await
}

/// Asks by it is told, as long as a drive may take. Asked again sooner, an answer that comes then would count as none:
/// it could be one to either.
async fn asked(
    session: &mut Session<'_>,
    meant: &Meant,
    family: &Rc<Family>,
    (param, set): (&Param, u8),
    by: Option<Tick>,
) -> Result<Option<i64>, AccessError> {
    let mut target = Target::new(meant.address, family.clone());
    let by = by.unwrap_or(session.now() + TO_TELL);
    if by <= session.now() {
        return Ok(None);
    }
    session.end_at(Some(by));
    let patient = in_turn(session);
    let tell = async |session: &mut Session<'_>| loop {
        match raw(session, &mut target, param, set).await {
            Err(failure) if failure.is_unheard() && session.now() < by => {}
            told => break in_short(told).map(Option::flatten),
        }
        session.rest(PAUSE).await?;
    };
    session.within(patient, tell).await
}

/// The telegrams that carry a control word: in both orders where it is not known which half comes first.
pub(super) fn telegrams(session: &Session<'_>, meant: &Meant, family: &Family, word: u16) -> Vec<Question> {
    let Some(param) = family.role("control-word") else { return Vec::new() };
    let cell = Cell { number: param.id, set: 0 };
    let inquiry = Inquiry::Write(cell, param.kind.unwrap_or(Type::Uint), word.into());
    let both = word != 0 && family.role("word-order").is_some();
    meant.questions(session.protocol(), session.node(), family, inquiry, both)
}
