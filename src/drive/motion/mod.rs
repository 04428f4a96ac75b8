//! Everything that can turn a shaft: walking the state machine, setpoints, bounded runs, and the stop at their end.
//!
//! There is one way to run a drive, [`Motor::run`]: whatever ends the work (its end, an error, an interrupt, a panic of
//! ours), the stop that was chosen goes out, is proven by the drive's state, and what was changed for the run is given
//! back. This room decides by roles and machine data only, so it serves every family.

use super::describe;
mod before;
mod changes;
mod foreseen;
mod held;
mod lacking;
mod leave;
mod look;
mod own;
mod passing;
mod patience;
mod relief;
mod setpoint;
mod shaft;
mod shout;
mod still;
mod stop;
mod taking;
mod walk;
mod watchdog;
mod watched;

pub use super::route::Meant;
pub use before::{
    Standing, elsewhere, is_controlled, own_setpoints, present, runs_at, standing, upon_enabling, zero_only_slows,
};
pub use changes::{Keeps, place_name, would_change};
pub use foreseen::foreseen;
pub use lacking::{in_fault, missing, no_control, no_control_word, tripped, what_stops_it};
pub use leave::{LAST_LOOK, set_going_again};
pub use look::{
    Situation, look, may_change_mode, role_raw, state_now, surroundings, turns, watchdog_raw, watchdog_seconds,
    working, working_raw,
};
pub use own::{Own, Promise, Total, demand_as_shown};
pub use relief::PROOF;
pub use shout::{Call, FirstWord, shout, shout_once, shout_round, shout_zero};
pub use still::{OPERATION, QUICK_STOP, Unseen, coasting, has_power};
pub use stop::StopChoice;
pub use taking::{goes_now, taken_over};
pub use walk::no_fault;
pub use watchdog::watchdog_words;
pub use watched::Watched;

use super::access::AccessError;
use super::interrupt::Interrupt;
use super::session::Session;
use super::target::Target;
use super::write::{Order, WriteFate};
use crate::failure::{Class, Failure};
use crate::gate::{self, Permit};
use crate::outcome::{Change, Setpoint, State, Step, Stop};
use crate::profile::{Blind, Mode, Need, Param};
use crate::text::{Text, both};
use crate::tick::{Span, Tick};
use futures_util::FutureExt as _;
use held::Clock;
use own::Course;
use std::panic::AssertUnwindSafe;
use still::Sight;
use taking::{Lever, Taken};
use watchdog::guard;

/// Whether the shaft did not become slower.
fn is_still_turning<T>(result: &Result<T, Failure>) -> bool {
    result.as_ref().is_err_and(|failure| failure.code == still::STILL_TURNING)
}

/// What comes behind the stop takes no longer, whatever the line is like: giving back, and what is reported.
const ENDING: Span = Span::from_secs(10);
/// The same where nothing is to be given back.
const ENDING_ALONE: Span = Span::from_millis(1_500);
/// What a run waits for besides its questions, as long as no shaft still changes its speed: for each state on the way up to
/// operation, for the stop, and for what comes behind it.
pub const WAITS: Span = Span::from_micros(
    5 * patience::USUAL.as_micros() + 2 * stop::PURSUED.as_micros() + ENDING.as_micros() + ENDING_ALONE.as_micros(),
);

/// A drive that is to be moved.
#[derive(Debug)]
pub struct Motor<'a, 's> {
    session: &'a mut Session<'s>,
    target: &'a mut Target,
    permit: &'a Permit<gate::Motion>,
    patience: Span,
    /// A command or setpoint went out, so there is something to stop.
    touched: bool,
    /// How the run is stopped; told once, as soon as it is held.
    stops: Option<StopChoice>,
    /// The drive was seen to be enabled, so anything else ends the run.
    enabled: bool,
    /// It was in operation at the last look at its state.
    works: bool,
    /// It was seen to have power, or was told to take it: its shaft may turn.
    pub powered: bool,
    /// It was stopped before anybody looked: it may have been turning.
    pub shouted: bool,
    /// The word that went out then.
    pub first_word: FirstWord,
    /// Another stop was given than was asked for: which, and why.
    pub instead: Option<Text>,
    /// What looks tell of the shaft of a drive that shows the frequency of its stator.
    sight: Sight,
    /// The encoder that tells without power too, once it was looked for.
    encoder: Option<Option<Param>>,
    /// How the drive is set to end a ramp stop, if its frequency does not show that; once it was asked.
    ending: Option<Option<Blind>>,
    /// Answers that were doubted when the stop began.
    doubts: u64,
    /// Telegrams that were no answers, before the run.
    strays: u64,
    /// The stop is under way: every telegram of it is tried anew as a whole.
    stopping: bool,
    /// A quick stop went out in it.
    said_quick_stop: bool,
    /// The drive was enabled as the stop began.
    had_power: bool,
    /// The drive has shown the mode that was set.
    entered: bool,
    lever: Lever,
    /// The drive was seen to obey the control word in this run.
    remote: bool,
    /// How it was when control over it was taken.
    taken: Taken,
    /// Control word as last written.
    word: u16,
    /// Slug of the state that was seen last, if no control word was written since.
    seen: Option<String>,
    /// The status word that was told last.
    shown: Option<Shown>,
    /// Whether the shaft stood when that was last waited for, and nothing was written since.
    still: Option<Option<bool>>,
    /// When the drive answered last.
    heard: Tick,
    /// The longest time of a held run, or of its stop, in which nothing came from it.
    gap: Span,
    /// When it was last looked at who has control.
    minded: Tick,
    /// Nothing but motion is taken away, which was said at this time: it is given up if nothing proves anything in time.
    pub relieving: Option<Tick>,
    /// The stop was given up because it answered no more.
    pub unheard: bool,
    /// Somebody did not wait for the stop.
    hurried: bool,
    /// So many presses of Ctrl-C have had the stop that they ask for.
    pub heeded: u32,
    /// Every question ends then, whatever has come of it.
    bound: Option<Tick>,
    /// The time of a run that is held.
    clock: Clock,
    /// When it was written to last, and what can be written to it again without changing anything.
    fed: Tick,
    again: Option<(Param, i64)>,
    /// So often its stop was said again, because it had become faster.
    insisted: u8,
    /// What is set, once that is known.
    pub mode: Option<Mode>,
    /// The drive's watchdog, if it is on.
    guard: Option<Span>,
    /// What the drive said first, where nobody looked before; what takes motion away had gone out already.
    pub first_seen: Option<Situation>,
    /// Transitions that were walked.
    pub steps: Vec<Step>,
    /// Settings that were changed.
    pub changes: Vec<Change>,
    /// Who keeps what is changed, before it is.
    pub keeps: Option<Keeps<'a>>,
    /// Parameters, and their data sets, of which it is known whether they are to be given back.
    settled: Vec<(u32, u8)>,
    /// Nothing runs on afterwards, so what was changed goes back; a setpoint is part of it too.
    bounded: bool,
    /// The setpoint that was given.
    pub setpoint: Option<Setpoint>,
    /// A setpoint, and what the drive makes of it by its own settings, if that is known; raw.
    pub expects: Option<(i64, i64)>,
    /// What somebody was shown of its own settings.
    pub promises: Vec<Promise>,
    course: Course,
    /// Setpoint of the mode that the drive shows; the stop sets it to 0.
    zeroes: Option<u32>,
    /// Setpoint that the stop has set to 0 before it asked for that mode.
    zeroed: Option<u32>,
    /// What is worth knowing besides.
    pub notes: Vec<Text>,
    /// What is shown of the run while it goes on, if anybody looks.
    pub watched: Option<Watched>,
}

/// A status word that was told.
#[derive(Clone, Copy, Debug)]
struct Shown {
    status: u32,
    asked: Tick,
    told: Tick,
}

/// How a run ended.
#[derive(Debug)]
pub struct Ended<T> {
    /// What the work brought.
    pub result: Result<T, Failure>,
    /// The stop, if one was needed.
    pub stop: Option<Stop>,
}

impl<'a, 's> Motor<'a, 's> {
    /// A drive that may be moved: the permit says that somebody agreed.
    pub fn new(
        session: &'a mut Session<'s>,
        target: &'a mut Target,
        permit: &'a Permit<gate::Motion>,
        patience: Option<Span>,
    ) -> Self {
        let patience = patience.unwrap_or(patience::USUAL);
        session.hastens();
        let (steps, changes) = (Vec::new(), Vec::new());
        let lever = Lever::Setpoint;
        let guard = guard(target, target.known_watchdog);
        let (now, heeded, strays) = (session.now(), session.presses(), session.tally().strays);
        Motor {
            session,
            target,
            permit,
            patience,
            touched: false,
            stops: None,
            enabled: false,
            works: false,
            powered: false,
            shouted: false,
            first_word: FirstWord::default(),
            instead: None,
            sight: Sight::default(),
            encoder: None,
            ending: None,
            doubts: 0,
            strays,
            stopping: false,
            said_quick_stop: false,
            had_power: false,
            entered: false,
            lever,
            remote: false,
            taken: Taken::default(),
            word: 0,
            seen: None,
            shown: None,
            still: None,
            heard: now,
            gap: Span::ZERO,
            minded: now,
            relieving: None,
            unheard: false,
            hurried: false,
            heeded,
            bound: None,
            clock: Clock::default(),
            fed: now,
            again: None,
            insisted: 0,
            mode: None,
            guard,
            first_seen: None,
            steps,
            changes,
            keeps: None,
            settled: Vec::new(),
            bounded: false,
            setpoint: None,
            expects: None,
            promises: Vec::new(),
            course: Course::default(),
            zeroes: None,
            zeroed: None,
            notes: Vec::new(),
            watched: None,
        }
    }

    /// Takes the state machine as what the stop acts on, if the drive is controlled by it already; and notes whether it is
    /// enabled.
    pub fn controls(&mut self, situation: &Situation) {
        self.enabled = situation.state == "operation-enabled";
        self.see(&situation.state);
        if situation.obeys(&self.target.family) {
            self.lever = Lever::ControlWord;
        } else if has_power(&situation.state) == Some(true) {
            self.taken = Taken::Running;
        }
    }

    /// Does `work`, then stops the drive as chosen if `hold` bounds the run, also one in which nothing had to be done, or
    /// if the work failed; and gives back what was changed. The stop goes out whatever ended the work, a panic included.
    pub async fn run<T>(
        &mut self,
        hold: bool,
        choice: StopChoice,
        work: impl AsyncFnOnce(&mut Self) -> Result<T, Failure>,
    ) -> Ended<T> {
        (self.stops, self.bounded) = (Some(choice), hold);
        let result = AssertUnwindSafe(work(self)).catch_unwind().await.unwrap_or_else(|_panic| {
            let text = both!(
                "a bug of ours ended the run; the drive was stopped as chosen",
                "ein Fehler dieses Programms beendete den Lauf; der Antrieb wurde wie gewählt angehalten"
            );
            Err(Failure::new(Class::Bug, "bug.panic", text))
        });
        let result = self.stops_the_clock(result);
        // What goes on is looked at once more before it is left; what ends, behind its stop.
        let result = if hold { result } else { self.kept(result).await };
        let because = match &result {
            Ok(_) => "end",
            Err(failure) if failure.class == Class::Interrupted => "interrupted",
            Err(_) => "error",
        };
        self.session.note_interrupts();
        let has_hand_on = self.touched || (hold && self.lever == Lever::ControlWord);
        // A proof once made stays one: what is without power needs no other stop, unless its shaft shows that it has some.
        let is_done = self.relieving.is_some() && self.is_off() && !is_still_turning(&result);
        let must_stop = has_hand_on && (hold || result.is_err()) && !is_done;
        let stop = if must_stop { Some(self.stop(choice, because).await) } else { None };
        self.session.heed(Interrupt::default());
        self.session.warns_no_more();
        self.session.insist(false);
        if self.relieving.is_some() || self.unheard {
            // What is left unanswered holds the line as long as it is waited for.
            self.session.wait_briefly();
        }
        let gives_back = self.relieving.is_none() && self.may_give_back(stop.as_ref());
        let gives_back = gives_back && !(self.hurried && self.unheard);
        self.ends_within(if gives_back { ENDING } else { ENDING_ALONE });
        let result = if hold { self.kept(result).await } else { result };
        let result = match result {
            Err(failure) => Err(self.explained(failure).await),
            done => done,
        };
        self.session.believe_since(None);
        if hold && (result.is_err() || stop.as_ref().is_some_and(|stop| !stop.acknowledged)) {
            self.notes_restart().await;
        }
        // A stop that took control for itself needs it no more.
        if self.bounded || result.is_err() || (self.stopping && !self.changes.is_empty()) {
            self.give_back(self.may_give_back(stop.as_ref())).await;
        }
        Ended { result, stop }
    }

    /// What the drive says now.
    pub async fn look(&mut self) -> Result<Situation, Failure> {
        let situation = look(self.session, self.target).await?;
        self.see(&situation.state);
        Ok(situation)
    }

    async fn status(&mut self) -> Result<u32, Failure> {
        let asked = self.session.now();
        let status = self.bear(async |motor: &mut Self| motor.status_word().await).await?;
        self.shown = Some(Shown { status, asked, told: self.session.now() });
        self.sees_status(status);
        self.notes_contacts(status);
        let state = describe::state(&self.target.family, status).slug;
        let enabled = state == "operation-enabled" && !(self.remote && self.is_remote(status) == Some(false));
        self.see(&state);
        self.seen = Some(state);
        self.feed(enabled).await?;
        Ok(status)
    }

    /// Whether the status word says that the control word is obeyed; `None` if this family's does not tell.
    fn is_remote(&self, status: u32) -> Option<bool> {
        let row = self.target.family.motion.interlock(Need::Release).filter(|row| row.controlled)?;
        Some(status >> row.bit? & 1 == 1)
    }

    async fn state(&mut self) -> Result<State, Failure> {
        let status = self.status().await?;
        Ok(describe::state(&self.target.family, status))
    }

    /// What tells whether the shaft moves.
    async fn movement(&mut self) -> Result<Option<i64>, Failure> {
        let raw = self.bear(async |motor: &mut Self| motor.role_raw("movement").await).await?;
        self.feed(false).await?;
        Ok(raw)
    }

    async fn status_word(&mut self) -> Result<u32, Failure> {
        let status = look::status_word(self.session, self.target).await;
        let status = status.inspect_err(|failure| self.misses(failure))?;
        self.hears();
        Ok(status)
    }

    async fn role_raw(&mut self, role: &str) -> Result<Option<i64>, Failure> {
        let Some(param) = self.target.family.role(role).cloned() else { return Ok(None) };
        self.raw(&param).await
    }

    /// The raw value of a parameter; `None` if the drive refuses it.
    async fn raw(&mut self, param: &Param) -> Result<Option<i64>, Failure> {
        let raw = look::raw(self.session, self.target, param, 0).await;
        let raw = raw.inspect_err(|failure| self.misses(failure))?;
        self.hears();
        if let Some(raw) = raw {
            self.sees(param, raw);
            self.shows();
        }
        Ok(raw)
    }

    /// The drive has answered.
    fn hears(&mut self) {
        self.heard_now();
        self.goes_on();
    }

    fn heard_now(&mut self) -> Tick {
        let now = self.session.now();
        self.gap = self.gap.longer(now.since(std::mem::replace(&mut self.heard, now)));
        now
    }

    async fn write_control(&mut self, word: u16) -> Result<(), Failure> {
        let param = self.control_word()?;
        (self.touched, self.seen, self.still, self.word) = (true, None, None, word);
        if self.enables(word.into()) || (self.lever == Lever::Contacts && word != 0) {
            // What was seen before it tells no more that the drive is without power.
            (self.powered, self.shown) = (true, None);
            self.may_turn();
        }
        self.again = Some((param.clone(), word.into()));
        self.write(&param, 0, word.into()).await
    }

    fn control_word(&self) -> Result<Param, Failure> {
        let param = self.target.family.role("control-word").cloned();
        param.ok_or_else(no_control_word)
    }

    /// Writes to RAM, where nothing wears out. What is not echoed is written again, which changes nothing, as long as
    /// that can be borne.
    async fn write(&mut self, param: &Param, set: u8, raw: i64) -> Result<(), Failure> {
        self.bear(async |motor: &mut Self| motor.write_once(param, set, raw).await).await
    }

    /// The only place that writes: what is not taken back by the stop itself is remembered before.
    async fn write_once(&mut self, param: &Param, set: u8, raw: i64) -> Result<(), Failure> {
        if !self.stopping && !self.ends_with_the_run(param, raw) {
            self.remember(param, set, raw).await?;
        }
        let kind = match param.kind {
            Some(kind) => kind,
            None => self.target.width(self.session, param, set).await.map_err(|error| self.failure(&error))?,
        };
        let order = Order { set, raw, kind, read_back: false };
        let fate = self.target.write(self.session, param, order, self.permit).await;
        if self.stopping {
            // What was asked before it proves nothing of it.
            self.session.believe_since(Some(self.session.now()));
        }
        match fate {
            Ok(WriteFate::Unknown(error)) | Err(error) => {
                let failure = self.failure(&error);
                self.misses(&failure);
                Err(failure)
            }
            Ok(_) => {
                self.fed = self.heard_now();
                Ok(())
            }
        }
    }

    async fn rest(&mut self, span: Span) -> Result<(), Failure> {
        self.session.rest(span).await.map_err(|error| match error {
            // No answer was waited for.
            AccessError::Interrupted => {
                Failure::new(Class::Interrupted, "interrupted", both!("interrupted", "unterbrochen"))
            }
            error => {
                let failure = self.failure(&error);
                self.misses(&failure);
                failure
            }
        })
    }

    fn failure(&self, error: &AccessError) -> Failure {
        error.failure(self.target.address, Some(&self.target.family))
    }
}
