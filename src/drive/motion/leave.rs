//! What is known of the drive as the program leaves: only what is reported, and in one short time.

use super::look::{watchdog_seconds, working_raw};
use super::{ENDING, ENDING_ALONE, Lever, Motor, Shown, Situation, Stop, StopChoice};
use crate::drive::describe;
use crate::failure::Failure;
use crate::gate::Relief;
use crate::outcome::Decimal;
use crate::profile::Param;
use crate::text::{Text, both};
use crate::tick::{Span, Tick};

/// So often it is looked whether a drive stays without power that somebody else has enabled again, and so long is waited between.
const RETURNS: u8 = 3;
const MOMENT: Span = Span::from_millis(150);
/// So much time a look behind what was owed has where that of the stop is over: an answer may be held for 0.6 s.
pub const LAST_LOOK: Span = Span::from_millis(1_500);
/// What was seen so long ago is looked at once more: an answer to something else took long.
const LONG_AGO: Span = Span::from_millis(200);

/// So long a look goes on behind the last answer where others speak, and so often.
const PURSUED_LOOK: Span = Span::from_secs(5);
const MOST_LOOKS: u64 = 4;
/// What takes the power away ends in 20 s, of which its first words may take 6: so long behind them no last look is begun any more.
const LAST_LOOKS: Span = Span::from_millis(11_500);

/// A look that brought no answer.
#[derive(Debug)]
pub(super) struct Lost {
    pub(super) failure: Failure,
    /// Telegrams came that were none: others speak, and may have enabled the drive.
    to_others: bool,
}

impl Motor<'_, '_> {
    /// Waits for replies that are still owed; whether there were any, and there is time to look behind them. The line is kept for so long
    /// anyway, and what is looked at behind that is seen as late as may be.
    pub async fn waits_for_what_is_owed(&mut self) -> bool {
        let Some(left) = self.session.owes_for().filter(|_| self.has_time()) else { return false };
        self.session.ends_later(left + LAST_LOOK);
        self.rest(left).await.is_ok()
    }

    /// Whether the drive was asked for its state some time ago only; then there is time to ask once more.
    pub fn looked_long_ago(&mut self) -> bool {
        let is_old =
            self.has_time() && self.shown.is_some_and(|shown| self.session.now().since(shown.asked) > LONG_AGO);
        if is_old {
            self.session.ends_later(LAST_LOOK);
        }
        is_old
    }

    /// Whether nobody is in a hurry, or has interrupted more than once, the drive still answers, and there is time for a look.
    fn has_time(&self) -> bool {
        let is_late = self.relieved_for().is_some_and(|past| past > LAST_LOOKS);
        !self.hurried && !self.unheard && !is_late && self.session.presses() < 2
    }

    /// The last looks may take so much longer, in theirs.
    fn gets_time(&mut self, looks: u64) {
        let needs = Span::from_micros(LAST_LOOK.as_micros() * looks);
        let left = self.relieved_for().map(|past| LAST_LOOKS + LAST_LOOK - past);
        self.session.ends_later(left.map_or(needs, |left| left.min(needs)));
    }

    /// How long ago what has taken the power away was said, or the shaft was seen to become slower by it.
    fn relieved_for(&self) -> Option<Span> {
        self.relieving.filter(|_| self.is_off()).map(|since| self.session.now().since(since))
    }

    /// When it answered last.
    pub fn heard_at(&self) -> Tick {
        self.heard
    }

    /// Whether others talk over the line too.
    pub fn is_beside(&self) -> bool {
        self.session.is_shared()
    }

    /// What the drive says as the program leaves. Where it says nothing more, what was seen last still tells that it was
    /// without power; `None` if nothing does, also where others speak meanwhile, who may have enabled it.
    pub async fn leave(&mut self) -> Option<Situation> {
        let status = match (self.last_status().await, self.shown) {
            (Ok(status), _) => status,
            (Err(Lost { failure, to_others: false }), Some(Shown { status, .. })) if self.is_off() => {
                self.tell_lost(&failure);
                status
            }
            _ => return None,
        };
        let state = describe::state(&self.target.family, status).slug;
        // A memory that moves on with every reading is left alone where there is no fault.
        let fault = match state.starts_with("fault") {
            true => self.role_raw("fault").await.ok().flatten(),
            false => Some(0),
        };
        let watchdog_s = self.watchdog_in_force().await;
        Some(Situation { status, state, fault, watchdog_s, ..Situation::default() })
    }

    /// The status word as the program leaves.
    async fn last_status(&mut self) -> Result<u32, Lost> {
        self.through_others(async |motor: &mut Self| motor.status().await).await
    }

    /// Looks once more where no answer comes although others were heard in this run, or the drive answers, slowly; as long as it was heard
    /// shortly before.
    pub(super) async fn through_others<T>(
        &mut self,
        mut look: impl AsyncFnMut(&mut Self) -> Result<T, Failure>,
    ) -> Result<T, Lost> {
        // A slow drive needs longer for all of it.
        let (before, mut looks) = (self.session.tally().strays, if self.first_word.is_late { 2 } else { 0 });
        if looks > 0 && self.has_time() {
            self.gets_time(looks + 1);
        }
        loop {
            looks += 1;
            let heard = self.heard;
            let failure = match look(self).await {
                Ok(seen) => return Ok(seen),
                Err(failure) => failure,
            };
            let strays = self.session.tally().strays;
            let is_there = strays > self.strays || self.heard > heard;
            let is_near = is_there && self.session.now().since(self.heard) <= PURSUED_LOOK;
            if looks == MOST_LOOKS || !failure.is_unheard() || !is_near || !self.has_time() {
                return Err(Lost { failure, to_others: strays > before });
            }
            self.gets_time(looks);
        }
    }

    /// Sends the stop once more to a drive that could not be reached before, and runs.
    ///
    /// In the way that was said last, and whoever did not wait for that is not kept waiting for this either.
    pub async fn stop_after_all(&mut self, stop: &Stop) -> Stop {
        let Stop { choice, escalated, because, .. } = *stop;
        let stop = self.stop(StopChoice::of(escalated.unwrap_or(choice)), because).await;
        let stop = Stop { choice, escalated: stop.escalated.or(escalated), ..stop };
        self.session.insist(false);
        let gives_back = self.may_give_back(Some(&stop)) && !(self.hurried && self.unheard);
        self.ends_within(if gives_back { ENDING } else { ENDING_ALONE });
        self.give_back(gives_back).await;
        stop
    }

    /// A drive that had been seen without power may have got it again while its shaft was looked at: then its stop is said once more, and
    /// what it shows a moment later counts. Whether it was said; nothing is `seen` any more where it gives no answer while others speak.
    pub async fn look_again(&mut self, seen: &mut Option<Situation>) -> bool {
        let mut is_said = false;
        if self.again.is_none() && self.lever == Lever::ControlWord {
            // What the run gave has gone back; only the word that takes the power is left.
            self.again = self.control_word().ok().map(|param| (param, 0));
        }
        for nth in 0..RETURNS {
            let status = match self.last_status().await {
                Ok(status) => status,
                Err(lost) => {
                    seen.take_if(|_| lost.to_others);
                    break;
                }
            };
            let state = describe::state(&self.target.family, status).slug;
            let is_on = state == "operation-enabled";
            if let Some(seen) = seen {
                (seen.status, seen.state) = (status, state);
            }
            if !is_on || nth + 1 == RETURNS {
                break;
            }
            if self.rest(MOMENT).await.is_err() {
                break;
            }
            match self.say_stop_again().await {
                Ok(Some(_)) => {
                    is_said = true;
                    self.notes_enabled_again();
                }
                // It went out a moment ago.
                Ok(None) => {}
                Err(_) => break,
            }
            if self.rest(MOMENT).await.is_err() {
                break;
            }
        }
        is_said
    }

    /// Gives a setpoint of 0 once more to a drive that somebody else has set going behind its standstill, and waits for that again.
    pub async fn zero_again(&mut self, param: &Param) {
        let Some(mode) = self.mode.clone() else { return };
        self.note_once(set_going_again(Relief::Zero));
        self.ends_within(ENDING);
        // What does not come of it is seen by the look behind it.
        let _ = self.relieve_setpoint(&mode, param).await;
        self.ends_within(ENDING_ALONE);
    }

    /// Somebody else has enabled a drive that had been stopped.
    pub fn notes_enabled_again(&mut self) {
        self.note_once(set_going_again(Relief::Disable));
    }

    /// Tells something at once, and notes it for the end; once, however often it happens.
    pub(super) fn note_once(&mut self, text: Text) {
        if !self.notes.contains(&text) {
            self.tell(text.clone());
            self.notes.push(text);
        }
    }

    /// The drive's watchdog as it is now; `None` if that was told at no time.
    async fn watchdog_in_force(&mut self) -> Option<Decimal> {
        let family = self.target.family.clone();
        let param = family.role("watchdog")?.id;
        let changed = self.changes.iter().find(|change| change.param == param);
        let known = changed.map(|change| if change.restored { change.old } else { change.new });
        let raw = match known.or(self.target.known_watchdog) {
            Some(raw) => Some(raw),
            None => working_raw(self.session, self.target, "watchdog").await.ok().flatten(),
        };
        self.target.known_watchdog = raw;
        raw.map(|raw| watchdog_seconds(&family, raw))
    }
}

/// That somebody else has set a drive going that had been stopped in this way.
pub fn set_going_again(act: Relief) -> Text {
    match act {
        Relief::Zero => both!(
            "it was set going again behind its setpoint of 0, by somebody else: the 0 went out again",
            "er wurde hinter seinem Sollwert 0 wieder in Gang gesetzt, von jemand anderem: die 0 ging nochmals hinaus"
        ),
        _ => both!(
            "it was enabled again behind its stop, by somebody else: the stop went out again",
            "er wurde hinter seinem Halt wieder freigegeben, von jemand anderem: der Halt ging nochmals hinaus"
        ),
    }
}
