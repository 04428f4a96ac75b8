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

use super::passing::Look;
use super::relief::command_of;
use crate::drive::access::AccessError;
use crate::drive::route::{Meant, no};
use crate::drive::session::Session;
use crate::exchange::{Answer, Limits, Question};
use crate::failure::unanswered_stop;
use crate::gate::Relief;
use crate::outcome::Event;
use crate::profile::{Family, Registry};
use crate::text::both;
use crate::tick::{Span, Tick};
use presumed::{doubted, narrowed, others, presumed};
use saying::{at_once, glimpsed, in_short, in_turn, insist, passed_by, unless_interrupted};
use std::collections::VecDeque;
use std::rc::Rc;
use word::{first_word, must_ask, telegrams};

mod presumed;
mod saying;
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
/// Behind a turn that was longer than that the others are looked at.
const LONG: Span = Span::from_millis(200);
/// How long one telegram of it may take with its answer, whatever comes over the line.
const BRIEF: Span = Span::from_millis(450);
/// The pause before the same is asked again: a drive may say no, or say nothing that can be read, at once.
const PAUSE: Span = Span::from_millis(10);
/// How often the stop is said while nobody acknowledges it: replies of 900 ms (CM-485 manual 6.8 promises less) are in time.
const TIMES: u8 = 5;
/// Or so long, each of its words once at least: where --timeout makes every wait long.
const SHOUTING: Span = Span::from_secs(8);
/// How often others are kept waiting for an answer for a short time only.
const EARLY: usize = 2;

/// What went out first to a drive whose control word has more than one meaning.
#[derive(Clone, Debug, Default)]
pub struct FirstWord {
    /// The control word; it can only stop.
    pub(super) word: Option<u16>,
    /// A quick stop in place of the ramp that was asked for.
    pub(super) instead: bool,
    /// One of the kind that it is, once that is known.
    pub(super) kind: Option<Rc<Family>>,
    /// Somebody interrupted meanwhile, so a stronger one follows.
    pub pressed: bool,
    /// It takes the power, because somebody interrupted those before it.
    strongest: bool,
    /// The drive takes long to answer.
    pub(super) is_late: bool,
    /// The drive has acknowledged it.
    pub(super) heard: bool,
    /// The shaft was seen to become slower by it.
    pub(super) obeyed: bool,
    /// What it showed of itself behind it, in order.
    pub(super) looks: Vec<Look>,
}

impl FirstWord {
    /// Somebody did not wait for what comes of the one before this one, which is for `act`.
    pub fn interrupted(self, act: Relief) -> Self {
        FirstWord { pressed: true, strongest: act == Relief::DisableVoltage, ..self }
    }

    /// Whether only the strongest stop is stronger: it went out, or the drive has acknowledged a quick stop in place of the ramp.
    pub fn leaves_the_strongest(&self) -> bool {
        self.strongest || (self.heard && self.instead)
    }

    /// One of the kind of drive that has acknowledged it, if a standstill of these shows only for a while: then it is looked at before
    /// it is asked which of them it is. `waits`: others wait as well, so that this would take long.
    pub fn passing(&self, waits: bool) -> Option<Rc<Family>> {
        self.kind.clone().filter(|family| (waits || self.is_late) && family.motion.stator.is_some())
    }

    /// Which family its drive is taken for, if it was not asked.
    pub fn taken_for(self, kind: Option<Rc<Family>>) -> Self {
        FirstWord { kind, ..self }
    }
}

/// Sends what stops a drive until it is acknowledged, or has been said often enough. An act that is no command sends nothing.
pub async fn shout(
    session: &mut Session<'_>,
    registry: &Registry,
    meant: &Meant,
    act: Relief,
) -> Result<FirstWord, AccessError> {
    Call { tell: Tell::Alone, ..Call::new(meant, act) }.go_on(session, registry).await
}

/// The same, each word once: for who did not answer before.
pub async fn shout_once(
    session: &mut Session<'_>,
    registry: &Registry,
    meant: &Meant,
    act: Relief,
) -> Result<FirstWord, AccessError> {
    Call { tell: Tell::Alone, times: 1, ..Call::new(meant, act) }.go_on(session, registry).await
}

/// Tells several drives to stop: whoever is silent is spoken to again only when everybody else had his turn, which is no longer than
/// one reply may take. So the drives behind a cabinet that is switched off hear their stop in time. What is said to each goes on
/// with [`Call::go_on`]. Returns it with whether somebody interrupted.
pub async fn shout_round<'m>(
    session: &mut Session<'_>,
    registry: &Registry,
    drives: &'m [Meant],
    act: Relief,
) -> (Vec<Call<'m>>, bool) {
    let (mut calls, mut interrupted): (Vec<Call<'_>>, bool) = (Vec::new(), false);
    // Whose family is named is asked nothing before his word, so its answer could be the echo of the line.
    let mut sounded = command_of(act).is_none() || drives.iter().all(|meant| meant.family.is_none());
    for meant in drives {
        let mut call = Call { tell: if sounded { Tell::First } else { Tell::Unsounded }, ..Call::new(meant, act) };
        session.speaks_of(Some(meant.address));
        let begun = session.now();
        interrupted |= call.said(session, registry).await;
        if session.now().since(begun) >= LONG {
            // A standstill that shows for a while only would be over before everybody was told.
            for told in &mut calls {
                told.look(session).await;
            }
        }
        sounded = sounded || session.echoes().is_some();
        call.tell = Tell::Again;
        calls.push(call);
    }
    session.speaks_of(None);
    (calls, interrupted)
}

/// How long it may be asked which word stops a drive, and what follows where that is not told.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Tell {
    /// Nobody waits for it: a quick stop.
    Alone,
    /// Others wait: it is asked again.
    First,
    /// The same on a line that may echo, where others do not wait for an answer that could be the echo.
    Unsounded,
    /// Others wait, and it was asked before: a quick stop.
    Again,
}

impl Tell {
    fn is_first(self) -> bool {
        matches!(self, Tell::First | Tell::Unsounded)
    }
}

/// What one drive is told.
pub struct Call<'m> {
    meant: &'m Meant,
    act: Relief,
    tell: Tell,
    /// How often each word is said.
    times: u8,
    /// The families that it may be, once that was asked.
    families: Option<Vec<Rc<Family>>>,
    /// Those of them whose word is not known yet.
    untold: Vec<Rc<Family>>,
    /// What is said in turn.
    words: VecDeque<(Rc<Family>, Question)>,
    /// How often something was said, and when that began.
    said: usize,
    begun: Option<Tick>,
    /// When that was tried first.
    tried: Option<Tick>,
    /// When it was asked who it is, if it has not told in time.
    asked: Option<Tick>,
    /// The port was lost and opened once more.
    again: bool,
    /// Its answers come, and late.
    slow: bool,
    first: FirstWord,
    /// So many of its words were refused one after the other.
    refusals: usize,
    /// It is told those of the others too.
    widened: bool,
    ended: Option<Result<(), AccessError>>,
}

impl<'m> Call<'m> {
    /// Nothing is said yet; others wait.
    fn new(meant: &'m Meant, act: Relief) -> Self {
        Call {
            meant,
            act,
            tell: Tell::First,
            times: TIMES,
            families: None,
            untold: Vec::new(),
            words: VecDeque::new(),
            said: 0,
            begun: None,
            tried: None,
            asked: None,
            again: false,
            slow: false,
            first: FirstWord::default(),
            refusals: 0,
            widened: false,
            ended: command_of(act).is_none().then_some(Ok(())),
        }
    }

    /// Says it until it is acknowledged, or has been said often enough; returns what went out, or why that was broken off.
    pub async fn go_on(mut self, session: &mut Session<'_>, registry: &Registry) -> Result<FirstWord, AccessError> {
        let mut interrupted = false;
        while self.ended.is_none() {
            interrupted |= self.said(session, registry).await;
            if interrupted && self.was_told() {
                self.ended = Some(Err(AccessError::Interrupted));
            }
            if self.ended.is_none() && session.is_shared() {
                // Whoever says no at once keeps nobody waiting.
                interrupted |= session.rest(PAUSE).await.is_err();
            }
        }
        let kind = self.kind();
        self.ended.unwrap_or(Ok(())).map(|()| FirstWord { kind, pressed: interrupted, ..self.first })
    }

    /// Says one word more, at once; whether somebody interrupted that.
    async fn said(&mut self, session: &mut Session<'_>, registry: &Registry) -> bool {
        if self.ended.is_some() {
            return false;
        }
        let tried = *self.tried.get_or_insert(session.now());
        let turn = async |session: &mut Session<'_>| self.turn(session, registry).await;
        match at_once(session, turn).await {
            Ok(pressed) => pressed,
            Err(error) if error.is_stuck() && session.now().since(tried) < SHOUTING => false,
            // A gateway that has closed its connection may take another one.
            Err(error)
                if error.is_lost() && !std::mem::replace(&mut self.again, true) && session.reopen().await.is_ok() =>
            {
                false
            }
            Err(error) => {
                self.ended = Some(Err(error));
                false
            }
        }
    }

    /// Looks at a drive that was told and answers at once, as long as that may show its standstill.
    async fn look(&mut self, session: &mut Session<'_>) {
        let told = self.first.heard && !self.first.is_late && self.ended.as_ref().is_some_and(Result::is_ok);
        let Some(family) = self.kind().filter(|family| told && family.motion.stator.is_some()) else { return };
        let (address, mut looks) = (self.meant.address, std::mem::take(&mut self.first.looks));
        at_once(session, async |session: &mut Session<'_>| passed_by(session, address, &family, &mut looks).await)
            .await;
        self.first.looks = looks;
    }

    fn kind(&self) -> Option<Rc<Family>> {
        match self.families.as_deref() {
            Some([family]) if !self.widened => Some(family.clone()),
            _ => None,
        }
    }

    fn goes_on(&self) -> bool {
        self.ended.is_none()
    }

    /// Whether every word that it knows went out.
    fn was_told(&self) -> bool {
        self.goes_on() && self.untold.is_empty() && self.said >= self.words.len()
    }

    /// Says one word more; whether somebody interrupted that.
    async fn turn(&mut self, session: &mut Session<'_>, registry: &Registry) -> Result<bool, AccessError> {
        let (by, tell) = (session.now() + TURN, self.tell);
        self.meet(session, registry).await?;
        if session.is_shared() {
            self.hears_late(session);
        }
        if !self.goes_on() {
            return Ok(false);
        }
        self.learn(session, by).await?;
        let is_late = tell.is_first() && !self.untold.is_empty() && session.now() >= by;
        let by = if tell.is_first() { by } else { session.now() };
        let pressed = if is_late { false } else { self.say(session, by).await? };
        let round = self.words.len();
        let long = self.said >= round && self.begun.is_some_and(|begun| session.now().since(begun) >= SHOUTING);
        let often = (long || self.said >= usize::from(self.times) * round) && self.untold.is_empty();
        let widens = self.goes_on() && (often || self.refusals > 0) && self.widen(session, registry);
        if self.goes_on() && often && !widens {
            self.ended = Some(Ok(()));
        }
        Ok(pressed)
    }

    /// Finds out of which families it may be; what it told late counts too.
    async fn meet(&mut self, session: &mut Session<'_>, registry: &Registry) -> Result<(), AccessError> {
        let (address, now) = (self.meant.address, session.now());
        let Some(families) = &mut self.families else {
            let (families, told) = match &self.meant.family {
                Some(family) => (vec![family.clone()], true),
                None => presumed(session, registry, address).await?,
            };
            self.asked = (!told).then_some(now);
            self.untold.clone_from(&families);
            self.families = Some(families);
            return Ok(());
        };
        if self.asked.is_some() && !self.widened && narrowed(session, address, families) {
            (self.asked, self.slow) = (None, true);
            let is_left = |family: &Rc<Family>| families.iter().any(|left| left.drive == family.drive);
            self.untold.retain(is_left);
            self.words.retain(|(family, _)| is_left(family));
        }
        Ok(())
    }

    /// Finds out the words that are not known yet.
    async fn learn(&mut self, session: &mut Session<'_>, by: Tick) -> Result<(), AccessError> {
        let (act, tell) = (self.act, self.tell);
        // A word that needs no question goes out before those that do, where it keeps nobody else waiting.
        let waits = |family: &Rc<Family>| tell == Tell::Alone && must_ask(family, act);
        let (asking, mut ready): (Vec<_>, Vec<_>) = std::mem::take(&mut self.untold).into_iter().partition(waits);
        if ready.is_empty() {
            ready = asking
        } else {
            self.untold = asking
        }
        let mut fresh = VecDeque::new();
        for family in ready {
            let by = match tell {
                // Who has said nothing for as long as a drive may take is not asked once more.
                Tell::Alone if self.is_silent(session.now()) => Some(session.now()),
                Tell::Alone => None,
                Tell::First | Tell::Unsounded => Some(by),
                Tell::Again => Some(session.now() + SHORT),
            };
            let asked = session.now();
            let Some(first) = first_word(session, self.meant, &family, act, (by, !tell.is_first())).await? else {
                self.untold.push(family);
                continue;
            };
            self.slow |= session.now().since(asked) > GLANCE;
            let words = first.word.into_iter().flat_map(|word| telegrams(session, self.meant, &family, word));
            fresh.extend(words.map(|word| (family.clone(), word)));
            if family.motion.control.is_some() && !self.widened {
                self.first = first;
            }
        }
        // Before what was said already.
        fresh.append(&mut self.words);
        self.words = fresh;
        Ok(())
    }

    /// Whether it has answered neither who it is nor a word.
    fn is_silent(&self, now: Tick) -> bool {
        self.refusals == 0 && self.asked.is_some_and(|asked| now.since(asked) >= TURN)
    }

    /// Waits for the answer at least until `by`, where nothing was asked before it.
    async fn say(&mut self, session: &mut Session<'_>, by: Tick) -> Result<bool, AccessError> {
        let Some((family, word)) = self.words.pop_front() else { return Ok(false) };
        let now = session.now();
        let begun = *self.begun.get_or_insert(now);
        if !self.tell.is_first() {
            session.warns(unanswered_stop());
        }
        let waits = match self.tell {
            Tell::Unsounded => GLANCE,
            // What comes later would come in the turn of another; but at first others are not kept waiting for that.
            Tell::Again if self.said > EARLY * self.words.len() => TURN,
            // Who is slower than that has heard it by now: said again and again, nobody could tell his answers apart.
            Tell::Alone if self.slow || self.said / (self.words.len() + 1) == 1 => session.patient().reply_timeout,
            // The word of another kind goes out when it has had its time to tell who it is.
            Tell::Alone => SHORT.longer(self.asked.map_or(SHORT, |asked| (asked + TURN + PAUSE).since(now))),
            Tell::First | Tell::Again => SHORT.longer(by.since(now)),
        };
        let limits = Limits { reply_timeout: waits, ..session.limits() };
        let (meant, mut looks) = (self.meant, Vec::new());
        let tells = async |session: &mut Session<'_>| glimpsed(session, meant, &family, &mut looks).await;
        let said = async |session: &mut Session<'_>| insist(session, meant.address, &word, tells).await;
        let (answer, pressed) = session.within(limits, said).await;
        self.said += 1;
        match answer {
            Ok(Answer::Reply { said, after }) => match no(&said) {
                None => {
                    let since = session.now().since(begun);
                    let is_late = self.slow || after > GLANCE || (self.tell == Tell::Alone && since > GLANCE);
                    self.was_heard(&family, is_late, looks);
                }
                // Who is busy may take it a moment later.
                Some(no) => self.refusals += usize::from(!no.passes()),
            },
            Err(error) if error.is_fatal() => {
                self.words.push_front((family, word));
                return Err(error);
            }
            _ => self.refusals = 0,
        }
        self.words.push_back((family, word));
        Ok(pressed)
    }

    /// An answer to one of its words that came in the turn of another is one all the same: what the drive does tells the rest.
    fn hears_late(&mut self, session: &Session<'_>) {
        let address = self.meant.address;
        let takes = |word: &Question| session.came_late(address, word).is_some_and(|said| no(&said).is_none());
        let heard = self.words.iter().find(|(_, word)| takes(word)).map(|(family, _)| family.clone());
        if let Some(family) = heard {
            self.was_heard(&family, true, Vec::new());
        }
    }

    /// The word of this family is acknowledged.
    fn was_heard(&mut self, family: &Rc<Family>, is_late: bool, looks: Vec<Look>) {
        if family.motion.control.is_none() {
            // What was found out for another kind does not count.
            self.first = FirstWord::default();
        }
        (self.first.heard, self.first.is_late, self.first.looks) = (true, is_late, looks);
        self.ended = Some(Ok(()));
        if !self.widened {
            self.families = Some(vec![family.clone()]);
        }
    }

    /// Whether every word of the families that it may be of is refused, in both word orders where these are not known, or there is none.
    fn is_refused(&self) -> bool {
        self.refusals >= self.words.len()
    }

    /// Who refuses the words of its family, or cannot be told them, may be of another one, and runs.
    fn widen(&mut self, session: &mut Session<'_>, registry: &Registry) -> bool {
        let may_be = self.families.as_deref().unwrap_or_default();
        let Some((named, others)) = others(registry, may_be).filter(|_| self.is_refused() && !self.widened) else {
            return false;
        };
        let Some(why) = doubted(self.meant, &named) else { return false };
        session.tell(Event::Note(both!(
            "the drive refuses the stop of the family {drive}{why} The stop of the other families goes out too",
            "der Antrieb lehnt den Halt der Familie {drive} ab{why} Der Halt der anderen Familien geht auch hinaus",
            drive = named.drive,
            why
        )));
        (self.untold, self.widened, self.said) = (others, true, 0);
        true
    }
}
