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

use super::relief::command_of;
use crate::drive::access::AccessError;
use crate::drive::recognise;
use crate::drive::route::{Meant, no};
use crate::drive::session::Session;
use crate::exchange::{Answer, Limits, Question};
use crate::failure::{Class, Failure};
use crate::gate::Relief;
use crate::outcome::Event;
use crate::profile::{Family, Registry};
use crate::text::both;
use crate::tick::{Span, Tick};
use std::collections::VecDeque;
use std::rc::Rc;
use word::{first_word, telegrams};

mod word;
mod zero;

pub use zero::shout_zero;

/// How long an answer is waited for before the stop is said again. Longer than a drive takes that has nothing else to do;
/// an answer that comes later still counts, because the same was asked again.
const SHORT: Span = Span::from_millis(250);
/// How long the stop waits for the answer to a question before it.
const GLANCE: Span = Span::from_millis(150);
/// How long a drive keeps the others waiting in the first round: for as long as a drive may take to answer (CM-485 manual 6.8).
const TURN: Span = Span::from_millis(500);
/// How long one telegram of it may take with its answer, whatever comes over the line.
const BRIEF: Span = Span::from_millis(450);
/// The pause before the same is asked again: a drive may say no, or say nothing that can be read, at once.
const PAUSE: Span = Span::from_millis(10);
/// How often the stop is said while nobody acknowledges it: replies of 900 ms (CM-485 manual 6.8 promises less) are in time.
const TIMES: u8 = 5;

/// What went out first to a drive whose control word has more than one meaning.
#[derive(Clone, Debug, Default)]
pub struct FirstWord {
    /// The control word; it can only stop.
    pub(super) word: Option<u16>,
    /// A quick stop in place of the ramp that was asked for.
    pub(super) instead: bool,
    /// One of the kind that it is, once that is known.
    pub(super) family: Option<Rc<Family>>,
}

/// Sends what stops a drive until it is acknowledged, or has been said often enough. An act that is no command sends nothing.
pub async fn shout(
    session: &mut Session<'_>,
    registry: &Registry,
    meant: &Meant,
    act: Relief,
) -> Result<FirstWord, AccessError> {
    let mut shouting = Shouting::new(std::slice::from_ref(meant), act);
    while shouting.goes_on() {
        shouting.round(session, registry).await;
    }
    shouting.end().pop().unwrap_or_else(|| Ok(FirstWord::default()))
}

/// Telling drives to stop, in rounds: whoever is silent is spoken to again only when everybody else had his turn, which is no longer
/// than one reply may take. So the drives behind a cabinet that is switched off hear their stop in time.
///
/// [`Shouting::round`] first; then that or [`Shouting::next`] as long as it goes on, and [`Shouting::end`].
pub struct Shouting<'m> {
    calls: Vec<Call<'m>>,
    act: Relief,
    tell: Tell,
    interrupted: bool,
    /// Whose turn is next.
    at: usize,
}

impl<'m> Shouting<'m> {
    /// Nothing is sent yet.
    pub fn new(drives: &'m [Meant], act: Relief) -> Self {
        let calls: Vec<Call<'m>> = drives.iter().map(Call::new).collect();
        let tell = if calls.len() == 1 { Tell::Alone } else { Tell::First };
        Shouting { calls, act, tell, interrupted: false, at: 0 }
    }

    /// Whether somebody has not acknowledged it yet, and was not told often enough.
    pub fn goes_on(&self) -> bool {
        command_of(self.act).is_some() && self.calls.iter().any(Call::goes_on)
    }

    /// A turn of everybody who has not acknowledged it.
    pub async fn round(&mut self, session: &mut Session<'_>, registry: &Registry) {
        for at in 0..self.calls.len() {
            self.turn(session, registry, at).await;
        }
        if self.tell == Tell::First {
            self.tell = Tell::Again;
        }
    }

    /// A turn of the next one who has not.
    pub async fn next(&mut self, session: &mut Session<'_>, registry: &Registry) {
        let count = self.calls.len();
        let order = (0..count).map(|step| (self.at + step) % count);
        let Some(at) = order.clone().find(|&at| self.calls.get(at).is_some_and(Call::goes_on)) else { return };
        self.at = at + 1;
        self.turn(session, registry, at).await;
    }

    async fn turn(&mut self, session: &mut Session<'_>, registry: &Registry, at: usize) {
        let (act, tell) = (self.act, self.tell);
        let Some(call) = self.calls.get_mut(at).filter(|call| call.goes_on() && command_of(act).is_some()) else {
            return;
        };
        let turn = async |session: &mut Session<'_>| call.turn(session, registry, act, tell).await;
        match at_once(session, turn).await {
            Ok(pressed) => self.interrupted |= pressed,
            Err(error) => call.ended = Some(Err(error)),
        }
        if self.interrupted {
            self.calls.iter_mut().filter(|call| call.was_told()).for_each(Call::interrupt);
        }
    }

    /// What went out to the drives so far, in their order.
    pub fn first(&self) -> Vec<FirstWord> {
        self.calls.iter().map(Call::first).collect()
    }

    /// What went out to each, or why that was broken off.
    pub fn end(self) -> Vec<Result<FirstWord, AccessError>> {
        self.calls.into_iter().map(Call::end).collect()
    }
}

/// How long it may be asked which word stops a drive, and what follows where that is not told.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Tell {
    /// Nobody waits for it: a quick stop.
    Alone,
    /// Others wait: it is asked again.
    First,
    /// Others wait, and it was asked before: a quick stop.
    Again,
}

/// What one drive is told.
struct Call<'m> {
    meant: &'m Meant,
    /// The families that it may be, once that was asked.
    families: Option<Vec<Rc<Family>>>,
    /// Those of them whose word is not known yet.
    untold: Vec<Rc<Family>>,
    /// What is said in turn.
    words: VecDeque<Question>,
    /// How often something was said.
    said: usize,
    first: FirstWord,
    /// It refused the words of its family.
    refused: bool,
    /// It is told those of the others too.
    widened: bool,
    ended: Option<Result<(), AccessError>>,
}

impl<'m> Call<'m> {
    fn new(meant: &'m Meant) -> Self {
        Call {
            meant,
            families: None,
            untold: Vec::new(),
            words: VecDeque::new(),
            said: 0,
            first: FirstWord::default(),
            refused: false,
            widened: false,
            ended: None,
        }
    }

    fn first(&self) -> FirstWord {
        let family = match self.families.as_deref() {
            Some([family]) if !self.widened => Some(family.clone()),
            _ => None,
        };
        FirstWord { family, ..self.first.clone() }
    }

    fn end(self) -> Result<FirstWord, AccessError> {
        let first = self.first();
        self.ended.unwrap_or(Ok(())).map(|()| first)
    }

    fn goes_on(&self) -> bool {
        self.ended.is_none()
    }

    /// Whether every word that it knows went out.
    fn was_told(&self) -> bool {
        self.goes_on() && self.untold.is_empty() && self.said >= self.words.len()
    }

    fn interrupt(&mut self) {
        self.ended = Some(Err(AccessError::Interrupted));
    }

    /// Says one word more; whether somebody interrupted that.
    async fn turn(
        &mut self,
        session: &mut Session<'_>,
        registry: &Registry,
        act: Relief,
        tell: Tell,
    ) -> Result<bool, AccessError> {
        let by = session.now() + TURN;
        if self.families.is_none() {
            let families = match &self.meant.family {
                Some(family) => vec![family.clone()],
                None => presumed(session, registry, self.meant.address).await?,
            };
            self.untold.clone_from(&families);
            self.families = Some(families);
        }
        self.learn(session, act, tell, by).await?;
        let is_late = tell == Tell::First && !self.untold.is_empty() && session.now() >= by;
        let by = if tell == Tell::First { by } else { session.now() };
        let pressed = if is_late { false } else { self.say(session, by).await? };
        let often = self.said >= usize::from(TIMES) * self.words.len() && self.untold.is_empty();
        let widens = self.goes_on() && (often || self.refused) && self.widen(session, registry);
        if self.goes_on() && often && !widens {
            self.ended = Some(Ok(()));
        }
        Ok(pressed)
    }

    /// Finds out the words that are not known yet.
    async fn learn(&mut self, session: &mut Session<'_>, act: Relief, tell: Tell, by: Tick) -> Result<(), AccessError> {
        for family in std::mem::take(&mut self.untold) {
            let by = match tell {
                Tell::Alone => None,
                Tell::First => Some(by),
                Tell::Again => Some(session.now() + SHORT),
            };
            let Some(first) = first_word(session, self.meant, &family, act, (by, tell != Tell::First)).await? else {
                self.untold.push(family);
                continue;
            };
            self.words.extend(first.word.into_iter().flat_map(|word| telegrams(session, self.meant, &family, word)));
            if family.motion.control.is_some() && !self.widened {
                self.first = first;
            }
        }
        Ok(())
    }

    /// Waits for the answer at least until `by`, where nothing was asked before it.
    async fn say(&mut self, session: &mut Session<'_>, by: Tick) -> Result<bool, AccessError> {
        let Some(word) = self.words.pop_front() else { return Ok(false) };
        let limits = Limits { reply_timeout: SHORT.longer(by.since(session.now())), ..session.limits() };
        let address = self.meant.address;
        let said = async |session: &mut Session<'_>| insist(session, address, &word).await;
        let (answer, pressed) = session.within(limits, said).await;
        self.said += 1;
        match answer {
            Ok(Answer::Reply { said, .. }) => match no(&said) {
                None => self.ended = Some(Ok(())),
                // Who is busy may take it a moment later.
                Some(no) => self.refused |= !no.passes(),
            },
            Err(error) if error.is_fatal() => return Err(error),
            _ => {}
        }
        self.words.push_back(word);
        Ok(pressed)
    }

    /// Who refuses the words of its family, or cannot be told them, may be of another one, and runs.
    fn widen(&mut self, session: &mut Session<'_>, registry: &Registry) -> bool {
        let may_be = self.families.as_deref().unwrap_or_default();
        let is_refused = self.refused || self.words.is_empty();
        let Some((named, others)) = others(registry, may_be).filter(|_| is_refused && !self.widened) else {
            return false;
        };
        session.tell(Event::Note(both!(
            "the drive refuses the stop of a {drive}: is --drive right? The stop of the other families goes out too",
            "der Antrieb lehnt den Halt eines {drive} ab: stimmt --drive? Der Halt der anderen Familien geht auch hinaus",
            drive = named.drive
        )));
        (self.untold, self.widened, self.said) = (others, true, 0);
        true
    }
}

/// Who refuses the words of its family may be of another one: the families of the other kinds, if there was one.
fn others(registry: &Registry, families: &[Rc<Family>]) -> Option<(Rc<Family>, Vec<Rc<Family>>)> {
    let [named] = families else { return None };
    let others = kinds(registry).into_iter().filter(|family| kind(family) != kind(named)).collect();
    named.is_movable().then(|| (named.clone(), others))
}

/// Says it once; whoever interrupts that gets it said again, and waits no longer than for this answer. Whether somebody did.
async fn insist(session: &mut Session<'_>, address: u8, word: &Question) -> (Result<Answer, AccessError>, bool) {
    let mut pressed = false;
    loop {
        session.end_at(Some(session.now() + BRIEF.longer(session.limits().reply_timeout)));
        match session.blurt(address, word.clone()).await {
            Err(AccessError::Interrupted) => {
                session.note_interrupts();
                pressed = true;
            }
            answer => return (answer, pressed),
        }
    }
}

/// Does it in short questions, also into a busy line; afterwards the session is as before.
async fn at_once<T>(session: &mut Session<'_>, work: impl AsyncFnOnce(&mut Session<'_>) -> T) -> T {
    session.insist(true);
    let limits = session.limits();
    let brief = Limits { reply_timeout: GLANCE.min(limits.reply_timeout), retries: 0, ..limits };
    let said = session.within(brief, work).await;
    session.end_at(None);
    session.insist(false);
    said
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
