//! Everything that can turn a shaft: walking the state machine, setpoints, bounded runs, and the stop at their end.
//!
//! There is one way to run a drive, [`Motor::run`]: whatever ends the work (its end, an error, an interrupt, a panic of
//! ours), the stop that was chosen goes out, is proven by the drive's state, and what was changed for the run is given
//! back. This room decides by roles and machine data only, so it serves every family.

use super::describe;
mod look;
mod setpoint;
mod stop;

pub use look::{Situation, look, missing, role_raw, working_raw};
pub use stop::StopChoice;

use super::session::{AccessError, Session};
use super::transfer::{Order, Target, WriteFate};
use crate::failure::{Class, Failure};
use crate::gate::Permit;
use crate::outcome::{Change, Event, Setpoint, State, Step, Stop};
use crate::profile::{Command, Lang, Need, Param, Takes, Transition};
use crate::tick::Span;
use look::{has_voltage_bit, no_plan};
use std::future::poll_fn;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::pin::pin;
use std::task::Poll;

/// Bits of the status word that the machine data do not name (CM-485 manual 9.1.2, 10.2).
const VOLTAGE_BIT: u32 = 1 << 4;
const REMOTE_BIT: u32 = 1 << 9;
const REACHED_BIT: u32 = 1 << 10;
/// Control by the control word (P.412 = 1; CM-485 manual 9).
const STATE_MACHINE: i64 = 1;
/// A fault cannot be reset earlier (CM-485 manual 9.1.2).
const FAULT_LOCK: Span = Span::from_secs(15);
/// How often the state is looked at while waiting.
const POLL: Span = Span::from_millis(50);
/// How long a state may take that needs no ramp.
const PATIENCE: Span = Span::from_secs(3);

/// What a run has its hand on; the stop must use the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Lever {
    /// The control word commands the state machine (P.412 = 1).
    ControlWord,
    /// The control word stands for contacts (P.412 = 2): all open is the stop. A command of the state machine would
    /// close contacts here and could start the drive.
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
        Motor {
            session,
            target,
            permit,
            lang,
            patience,
            touched: false,
            lever,
            steps,
            changes,
            setpoint: None,
            notes: Vec::new(),
        }
    }

    /// Takes the state machine as what the stop acts on, if the drive is controlled by it already.
    pub fn controls(&mut self, situation: &Situation) {
        if situation.mode == Some(STATE_MACHINE) {
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
        let facts = situation.facts(has_voltage_bit(self.target));
        let machine = self.target.family.machine.clone();
        let way = machine.plan(&situation.state, goal, facts).map_err(|why| no_plan(&why, self.target, self.lang))?;
        for transition in way {
            self.pass(transition).await?;
        }
        Ok(())
    }

    /// Sends one command, whatever the state, and waits for where it leads from the present state.
    pub async fn command(&mut self, slug: &str) -> Result<(), Failure> {
        let situation = self.look().await?;
        self.demand_control(&situation)?;
        let machine = self.target.family.machine.clone();
        match machine.transition(&situation.state, slug).cloned() {
            Some(transition) => {
                self.pass(&transition).await?;
                if transition.to == "quick-stop-active" {
                    return self.pass_by_itself("quick-stop-active", "switch-on-disabled", Takes::QuickStop).await;
                }
                Ok(())
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
                let now = self.role_raw("fault").await?.unwrap_or(0);
                let now = describe::fault(&self.target.family, now as u32, self.lang);
                let told = |fault: Option<crate::outcome::Fault>| {
                    fault.map_or_else(|| "-".to_owned(), |fault| format!("{} {}", fault.key, fault.name))
                };
                self.notes.push(format!("P.260: {} -> {}", told(was), told(now)));
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
            self.count_down(FAULT_LOCK).await?;
        }
        if let Some(command) = &command {
            self.trigger(command).await?;
        }
        let goal = if transition.takes == Some(Takes::Lock) { None } else { Some(transition.to.as_str()) };
        let state = self.until(&transition.to, transition.takes, goal.is_none()).await?;
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

    /// Waits for a transition that the drive makes by itself.
    async fn pass_by_itself(&mut self, from: &str, to: &str, takes: Takes) -> Result<(), Failure> {
        let begun = self.session.now();
        let state = self.until(to, Some(takes), false).await?;
        let machine = &self.target.family.machine;
        let number = machine.transitions.iter().find(|row| row.from == from && row.to == to);
        self.steps.push(Step {
            transition: number.map_or_else(String::new, |row| row.number.clone()),
            command: None,
            control: None,
            state,
            took_ms: self.session.now().since(begun).as_millis(),
        });
        Ok(())
    }

    async fn trigger(&mut self, command: &Command) -> Result<(), Failure> {
        if command.edge {
            self.write_control(command.word & !command.mask).await?;
        }
        self.write_control(command.word).await
    }

    /// Tells how long the drive still refuses a reset.
    async fn count_down(&mut self, lock: Span) -> Result<(), Failure> {
        let total = lock.as_millis() / 1_000;
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
        let mut patience = self.patience;
        if matches!(takes, Some(Takes::Transition5 | Takes::QuickStop)) {
            for role in ["holding-time", "braking-time"] {
                let tenths = self.role_raw(role).await?.unwrap_or(0);
                patience = patience + Span::from_millis(u64::try_from(tenths * 100).unwrap_or(0));
            }
        }
        let mut seen = (0, None);
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
            let speed = if takes.is_some() { self.speed().await? } else { None };
            if seen != (status, speed) {
                seen = (status, speed);
                since = self.session.now();
            }
            if self.session.now().since(since) > patience {
                return Err(self.stuck(&state, goal).await);
            }
            self.rest(POLL).await?;
        }
    }

    fn demand_control(&mut self, situation: &Situation) -> Result<(), Failure> {
        if situation.mode.is_none_or(|mode| mode == STATE_MACHINE) {
            self.lever = Lever::ControlWord;
            return Ok(());
        }
        let mode = situation.mode.unwrap_or_default();
        let text = match self.lang {
            Lang::En => format!("the drive is not controlled by the control word: P.412 is {mode}, it must be 1"),
            Lang::De => format!("der Antrieb hört nicht auf das Steuerwort: P.412 ist {mode}, nötig ist 1"),
        };
        Err(Failure::new(Class::Forbidden, "forbidden.control_mode", text).hint(self.lang.pick(
            "--take-control sets it in RAM for the run and gives it back",
            "--take-control stellt es für den Lauf im RAM um und danach zurück",
        )))
    }

    /// Why a state does not come.
    async fn stuck(&mut self, state: &State, goal: &str) -> Failure {
        let goal =
            self.target.family.states.iter().find(|row| row.slug == goal).map_or(goal, |row| row.name(self.lang));
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

    /// Actual frequency in 0.01 Hz: the stator frequency, whose decimals are proved.
    async fn speed(&mut self) -> Result<Option<i64>, Failure> {
        self.role_raw("stator-frequency").await
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

/// A round of holding a run: well below the shortest watchdog, 1 s (P.413 counts in seconds).
const ROUND: Span = Span::from_millis(250);

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
