//! Everything that can turn a shaft: walking the state machine, setpoints, bounded runs, and the stop at their end.
//!
//! There is one way to run a drive, [`Motor::run`]: whatever ends the work (its end, an error, an interrupt, a panic of
//! ours), the stop that was chosen goes out, is proven by the drive's state, and what was changed for the run is given
//! back. This room decides by roles and machine data only, so it serves every family.

use super::describe;
mod look;
mod setpoint;
mod shaft;
mod stop;

pub use look::{Situation, look, missing, no_control, role_raw, watchdog_raw, watchdog_seconds, working, working_raw};
pub use stop::{StopChoice, watchdog_words};

use super::session::{AccessError, Session};
use super::transfer::{Order, Target, WriteFate};
use crate::failure::{Class, Failure};
use crate::gate::Permit;
use crate::outcome::{Change, Event, Setpoint, State, Step, Stop};
use crate::profile::{Command, Lang, Mode, Need, Param, Takes, Transition};
use crate::tick::Span;
use look::{no_plan, state_name};
use shaft::Watch;
use std::future::poll_fn;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::pin::pin;
use std::task::Poll;

/// How often the state is looked at while waiting.
const POLL: Span = Span::from_millis(50);
/// How long a state may take that needs no ramp.
const PATIENCE: Span = Span::from_secs(3);

/// What a run has its hand on; the stop must use the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Lever {
    /// The control word commands the state machine.
    ControlWord,
    /// The control word stands for contacts: all open is the stop. A command of the state machine would close contacts
    /// here and could start the drive.
    Contacts,
    /// Somebody else starts and stops the drive; ours is the setpoint, and zero is the stop.
    Setpoint,
}

/// A drive that is to be moved.
#[derive(Debug)]
pub struct Motor<'a, 's> {
    session: &'a mut Session<'s>,
    target: &'a mut Target,
    permit: &'a Permit,
    lang: Lang,
    patience: Span,
    /// A command or setpoint went out, so there is something to stop.
    touched: bool,
    lever: Lever,
    /// What is set, once that is known.
    pub mode: Option<Mode>,
    /// Pause between looks: short enough for the drive's watchdog.
    beat: Span,
    /// Transitions that were walked.
    pub steps: Vec<Step>,
    /// Settings that were changed.
    pub changes: Vec<Change>,
    /// The setpoint that was given.
    pub setpoint: Option<Setpoint>,
    /// What is worth knowing besides.
    pub notes: Vec<String>,
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
        permit: &'a Permit,
        lang: Lang,
        patience: Option<Span>,
    ) -> Self {
        let patience = patience.unwrap_or(PATIENCE);
        let (steps, changes) = (Vec::new(), Vec::new());
        let lever = Lever::Setpoint;
        let beat = beat(target, target.known_watchdog);
        Motor {
            session,
            target,
            permit,
            lang,
            patience,
            touched: false,
            lever,
            mode: None,
            beat,
            steps,
            changes,
            setpoint: None,
            notes: Vec::new(),
        }
    }

    /// Takes the state machine as what the stop acts on, if the drive is controlled by it already.
    pub fn controls(&mut self, situation: &Situation) {
        if situation.obeys(&self.target.family) {
            self.lever = Lever::ControlWord;
        }
    }

    /// Does `work`, then stops the drive as chosen if `hold` bounds the run or the work failed, and gives back what was
    /// changed. The stop goes out whatever ended the work, a panic included.
    pub async fn run<T>(
        &mut self,
        hold: bool,
        choice: StopChoice,
        work: impl AsyncFnOnce(&mut Self) -> Result<T, Failure>,
    ) -> Ended<T> {
        let result = catching(work(self)).await.unwrap_or_else(|| {
            Err(Failure::new(Class::Bug, "bug.panic", "a bug of ours ended the run; the drive was stopped as chosen"))
        });
        let because = match &result {
            Ok(_) => "end",
            Err(failure) if failure.class == Class::Interrupted => "interrupted",
            Err(_) => "error",
        };
        self.session.ignore_interrupts();
        let must_stop = self.touched && (hold || result.is_err());
        let stop = if must_stop { Some(self.stop(choice, because).await) } else { None };
        if hold || result.is_err() {
            let proven = stop.as_ref().is_none_or(|stop| stop.acknowledged && choice != StopChoice::Keep);
            self.give_back(proven).await;
        }
        Ended { result, stop }
    }

    /// What the drive says now.
    pub async fn look(&mut self) -> Result<Situation, Failure> {
        look(self.session, self.target, self.lang).await
    }

    /// Walks to a state, step by step, each proven. A fault is never reset on the way.
    pub async fn walk(&mut self, goal: &str) -> Result<(), Failure> {
        let situation = self.look().await?;
        self.demand_control(&situation)?;
        if situation.state.starts_with("fault") {
            // A fault is reset only when somebody says so.
            return Err(self.fault_failure().await);
        }
        let family = self.target.family.clone();
        let mut from = situation.state.clone();
        if goal == "operation-enabled" && from != goal {
            from = self.begin(&from).await?;
        }
        let facts = situation.facts(&family);
        let way = family.machine.plan(&from, goal, &facts).map_err(|why| no_plan(&why, &family, self.lang))?;
        for transition in way {
            self.pass(transition).await?;
        }
        Ok(())
    }

    /// Sends the command that the family wants before it is walked up; returns the state that it leads to.
    async fn begin(&mut self, from: &str) -> Result<String, Failure> {
        let family = self.target.family.clone();
        let command = family.motion.begin.as_ref().and_then(|slug| family.machine.command(slug));
        let Some(command) = command else { return Ok(from.to_owned()) };
        match family.machine.transition(from, &command.slug) {
            Some(transition) => {
                self.pass(transition).await?;
                Ok(transition.to.clone())
            }
            None => {
                self.write_control(command.word).await?;
                Ok(from.to_owned())
            }
        }
    }

    /// Sends one command, whatever the state, and waits for where it leads from the present state.
    pub async fn command(&mut self, slug: &str) -> Result<(), Failure> {
        let situation = self.look().await?;
        self.demand_control(&situation)?;
        let machine = self.target.family.machine.clone();
        match machine.transition(&situation.state, slug).cloned() {
            Some(transition) => {
                self.pass(&transition).await?;
                if transition.to == "quick-stop-active" { self.end_quick_stop().await } else { Ok(()) }
            }
            None => {
                // A stop is never refused: it goes out even if the state says that there is nothing to stop.
                let command = machine.command(slug).cloned();
                let command = command.ok_or_else(|| Failure::new(Class::Usage, "usage.command", slug.to_owned()))?;
                self.write_control(command.word).await
            }
        }
    }

    /// Resets a fault: once, by a rising edge, after the drive's lock has passed.
    pub async fn reset(&mut self) -> Result<(), Failure> {
        let situation = self.look().await?;
        if situation.state != "fault" {
            let text = self.lang.pick("there is no fault to reset", "es steht keine Störung an");
            return Err(Failure::new(Class::Forbidden, "forbidden.no_fault", text));
        }
        let machine = self.target.family.machine.clone();
        match machine.transition("fault", "reset").cloned() {
            Some(transition) => {
                self.pass(&transition).await?;
                // The numbers of the fault memory are in no source, so this is all there is to show of it.
                let was = describe::fault(&self.target.family, situation.fault.unwrap_or(0) as u32, self.lang);
                let now = self.look().await?.fault.unwrap_or(0);
                let now = describe::fault(&self.target.family, now as u32, self.lang);
                let told = |fault: Option<crate::outcome::Fault>| {
                    fault.map_or_else(|| "-".to_owned(), |fault| format!("{} {}", fault.key, fault.name))
                };
                let label = self.target.family.role("fault").map_or_else(String::new, Param::label);
                self.notes.push(format!("{label}: {} -> {}", told(was), told(now)));
                Ok(())
            }
            None => Err(Failure::new(Class::Data, "data.machine", "this drive has no reset")),
        }
    }

    /// Goes through one transition.
    async fn pass(&mut self, transition: &Transition) -> Result<(), Failure> {
        let begun = self.session.now();
        let command = transition.command.as_ref().and_then(|slug| self.target.family.machine.command(slug).cloned());
        if transition.needs.contains(&Need::Lock) {
            self.count_down(self.target.family.motion.fault_lock_s).await?;
        }
        if let Some(command) = &command {
            self.trigger(command).await?;
        }
        let leaves_fault = transition.from == "fault";
        let state = self.until(&transition.to, transition.takes, leaves_fault).await?;
        if let Some(command) = command.as_ref().filter(|command| command.edge) {
            self.write_control(command.word & !command.mask).await?;
        }
        self.steps.push(Step {
            transition: transition.number.clone(),
            control: command.as_ref().map(|command| format!("0x{:04X}", command.word)),
            command: command.map(|command| command.slug),
            state,
            took_ms: self.session.now().since(begun).as_millis(),
        });
        Ok(())
    }

    /// Waits for the end of a quick stop. A drive that does not leave it by itself is led out once its shaft stands.
    async fn end_quick_stop(&mut self) -> Result<(), Failure> {
        let family = self.target.family.clone();
        let from_here = |row: &&Transition| row.from == "quick-stop-active";
        let by_itself = family.machine.transitions.iter().filter(from_here).find(|row| row.command.is_none());
        let way = by_itself.or_else(|| family.machine.transitions.iter().find(from_here));
        let Some(way) = way else { return Ok(()) };
        if way.command.is_some() {
            self.until_still().await?;
        }
        self.pass(way).await
    }

    async fn trigger(&mut self, command: &Command) -> Result<(), Failure> {
        if command.edge {
            self.write_control(command.word & !command.mask).await?;
        }
        self.write_control(command.word).await
    }

    /// Tells how long the drive still refuses a reset.
    async fn count_down(&mut self, total: u64) -> Result<(), Failure> {
        for done in 0..total {
            let what = match self.lang {
                Lang::En => format!("the drive refuses a reset for another {} s", total - done),
                Lang::De => format!("der Antrieb lässt {} s lang noch keine Quittierung zu", total - done),
            };
            self.session.tell(Event::Progress { done, total, what });
            self.rest(Span::from_secs(1)).await?;
        }
        Ok(())
    }

    /// Looks at the state until it is `goal`. What ramps or holds gets the time that it needs: patience begins anew
    /// while the shaft still slows down.
    async fn until(&mut self, goal: &str, takes: Option<Takes>, fault_is_fine: bool) -> Result<State, Failure> {
        let patience = self.patience + self.braking(takes).await?;
        let mut watch = Watch::new(self.target.family.motion.movement);
        let mut seen = 0;
        let mut since = self.session.now();
        loop {
            let status = self.status().await?;
            let state = describe::state(&self.target.family, status, self.lang);
            if state.slug == goal {
                return Ok(state);
            }
            if state.slug.starts_with("fault") && !fault_is_fine {
                return Err(self.fault_failure().await);
            }
            let changed = takes.is_some() && {
                let raw = self.movement().await?;
                watch.see(self.session.now(), raw)
            };
            if changed || seen != status {
                seen = status;
                since = self.session.now();
            }
            if self.session.now().since(since) > patience {
                return Err(self.stuck(&state, goal).await);
            }
            self.rest(self.beat).await?;
        }
    }

    /// How long the drive may hold or brake besides its ramp.
    async fn braking(&mut self, takes: Option<Takes>) -> Result<Span, Failure> {
        let mut sum = Span::ZERO;
        if !matches!(takes, Some(Takes::Transition5 | Takes::QuickStop)) {
            return Ok(sum);
        }
        let family = self.target.family.clone();
        for param in family.motion.patience.iter().filter_map(|role| family.role(role)) {
            let raw = look::raw(self.session, self.target, param, 0, self.lang).await?.unwrap_or(0);
            let ms = raw * 1_000 / 10i64.pow(param.decimals_or_zero().into());
            sum = sum + Span::from_millis(u64::try_from(ms).unwrap_or(0));
        }
        Ok(sum)
    }

    fn demand_control(&mut self, situation: &Situation) -> Result<(), Failure> {
        match no_control(situation, self.target, self.lang) {
            Some(failure) => Err(failure),
            None => {
                self.lever = Lever::ControlWord;
                Ok(())
            }
        }
    }

    /// Why a state does not come.
    async fn stuck(&mut self, state: &State, goal: &str) -> Failure {
        let goal = state_name(&self.target.family, goal, self.lang).to_owned();
        let text = match self.lang {
            Lang::En => format!("the drive stays in '{}' and does not go to '{goal}'", state.name),
            Lang::De => format!("der Antrieb bleibt in '{}' und geht nicht nach '{goal}'", state.name),
        };
        let missing = match self.look().await {
            Ok(situation) => missing(&situation, self.target, self.lang),
            Err(_) => Vec::new(),
        };
        let failure = Failure::new(Class::Forbidden, "forbidden.interlock", text);
        if missing.is_empty() { failure } else { failure.hint(missing.join("; ")) }
    }

    async fn fault_failure(&mut self) -> Failure {
        let code = self.role_raw("fault").await.ok().flatten().unwrap_or(0);
        let fault = describe::fault(&self.target.family, code as u32, self.lang);
        let told = fault.as_ref().map_or_else(String::new, |fault| format!(": {} {}", fault.key, fault.name));
        let text = self.lang.pick("the drive has tripped", "der Antrieb hat abgeschaltet");
        let failure = Failure::new(Class::Forbidden, "forbidden.fault", format!("{text}{told}"));
        match fault.and_then(|fault| fault.remedy) {
            Some(remedy) => failure.hint(remedy),
            None => failure,
        }
    }

    async fn status(&mut self) -> Result<u32, Failure> {
        Ok(self.role_raw("status-word").await?.unwrap_or(0) as u32)
    }

    /// What tells whether the shaft moves.
    async fn movement(&mut self) -> Result<Option<i64>, Failure> {
        self.role_raw("movement").await
    }

    async fn role_raw(&mut self, role: &str) -> Result<Option<i64>, Failure> {
        role_raw(self.session, self.target, role, self.lang).await
    }

    async fn write_control(&mut self, word: u16) -> Result<(), Failure> {
        let Some(param) = self.target.family.role("control-word").cloned() else {
            return Err(Failure::new(Class::Data, "data.role", "this drive has no control word"));
        };
        self.touched = true;
        self.write(&param, 0, word.into()).await
    }

    /// Writes to RAM, where nothing wears out. What is not echoed is not done.
    async fn write(&mut self, param: &Param, set: u8, raw: i64) -> Result<(), Failure> {
        let kind = match param.kind {
            Some(kind) => kind,
            None => self.target.width(self.session, param, set).await.map_err(|error| self.failure(&error))?,
        };
        let order = Order { set, raw, kind, read_back: false };
        match self.target.write(self.session, param, order, self.permit).await {
            Ok(WriteFate::Unknown(error)) | Err(error) => Err(self.failure(&error)),
            Ok(_) => Ok(()),
        }
    }

    async fn rest(&mut self, span: Span) -> Result<(), Failure> {
        let result = self.session.rest(span).await;
        result.map_err(|error| self.failure(&error))
    }

    fn failure(&self, error: &AccessError) -> Failure {
        error.failure(self.target.address, Some(&self.target.family), self.lang)
    }
}

/// A round of holding a run, in looks.
const ROUND: u64 = 5;

/// A pause between looks that leaves the drive's watchdog room for the telegrams between.
fn beat(target: &Target, watchdog: Option<i64>) -> Span {
    let watchdog = watchdog.map(|raw| watchdog_seconds(&target.family, raw)).filter(|span| span.raw > 0);
    let ms = watchdog.map(|span| span.raw.unsigned_abs() * 1_000 / 10u64.pow(span.decimals.into()));
    ms.map_or(POLL, |ms| Span::from_millis((ms / 10).clamp(1, POLL.as_millis())))
}

/// Runs a future; `None` if it panics.
async fn catching<T>(future: impl Future<Output = T>) -> Option<T> {
    let mut future = pin!(future);
    poll_fn(|context| match catch_unwind(AssertUnwindSafe(|| future.as_mut().poll(context))) {
        Ok(Poll::Ready(value)) => Poll::Ready(Some(value)),
        Ok(Poll::Pending) => Poll::Pending,
        Err(_panic) => Poll::Ready(None),
    })
    .await
}
