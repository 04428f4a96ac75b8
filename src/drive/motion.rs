//! Everything that can turn a shaft: walking the state machine, setpoints, bounded runs, and the stop at their end.
//!
//! There is one way to run a drive, [`Motor::run`]: whatever ends the work (its end, an error, an interrupt, a panic of
//! ours), the stop that was chosen goes out, is proven by the drive's state, and what was changed for the run is given
//! back. This room decides by roles and machine data only, so it serves every family.

use super::describe;
use super::session::{AccessError, Session};
use super::transfer::{Order, Target, WriteFate};
use crate::failure::{Class, Failure};
use crate::gate::Permit;
use crate::outcome::{Change, Decimal, Event, Setpoint, State, Step, Stop};
use crate::profile::{Command, DataSets, Facts, Lang, Need, NoPlan, Param, Takes, Transition};
use crate::tick::Span;
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
/// Control by digital inputs (P.412 = 0; CM-485 manual 9).
const CONTACTS: i64 = 0;
/// A fault cannot be reset earlier (CM-485 manual 9.1.2).
const FAULT_LOCK: Span = Span::from_secs(15);
/// How often the state is looked at while waiting.
const POLL: Span = Span::from_millis(50);
/// How long a state may take that needs no ramp.
const PATIENCE: Span = Span::from_secs(3);
/// How long the stop at the end is tried on a line that does not answer.
const STOP_TRIES: u8 = 5;

/// How a run is stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StopChoice {
    /// Disable operation: transition 5, by P.392.
    Ramp,
    /// Quick stop.
    QuickStop,
    /// Disable voltage.
    Coast,
    /// Not at all.
    Keep,
}

impl StopChoice {
    /// Name, command and the state that proves it.
    fn row(self) -> (&'static str, &'static str, &'static str) {
        match self {
            StopChoice::Ramp => ("ramp", "disable", "switched-on"),
            StopChoice::QuickStop => ("quick-stop", "quick-stop", "switch-on-disabled"),
            StopChoice::Coast => ("coast", "disable-voltage", "switch-on-disabled"),
            StopChoice::Keep => ("keep", "", ""),
        }
    }
}

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

/// What a drive says that matters for moving it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Situation {
    /// Status word.
    pub status: u32,
    /// Slug of its state; `unknown` if it means none.
    pub state: String,
    /// P.412, as the drive works with it.
    pub mode: Option<i64>,
    /// Fault code.
    pub fault: Option<i64>,
    /// Digital inputs, bit by bit.
    pub inputs: Option<i64>,
    /// P.30.
    pub configuration: Option<i64>,
    /// P.413 in seconds.
    pub watchdog_s: Option<i64>,
    /// P.392.
    pub transition5: Option<i64>,
}

impl Situation {
    /// What the planner looks at. Enable and start contact are seen in the Remote bit, which tells only under P.412 = 1.
    pub fn facts(&self, has_voltage_bit: bool) -> Facts {
        let controlled = self.mode == Some(STATE_MACHINE);
        Facts {
            voltage: has_voltage_bit.then_some(self.status & VOLTAGE_BIT != 0),
            release: controlled.then_some(self.status & REMOTE_BIT != 0),
            positioning: self.configuration.map(|number| number % 100 == 40),
        }
    }
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
            Some(transition) => self.pass(&transition).await,
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

    /// Gives a setpoint.
    pub async fn give(&mut self, param: &Param, raw: i64, unit: &str) -> Result<(), Failure> {
        self.touched = true;
        self.write(param, 0, raw).await?;
        let value = Decimal { raw, decimals: crate::profile::setpoint::DECIMALS };
        let writes = self.setpoint.as_ref().map_or(0, |setpoint| setpoint.writes) + 1;
        self.setpoint =
            Some(Setpoint { param: param.id, value, unit: unit.to_owned(), writes, reached: None, actual: None });
        Ok(())
    }

    /// Gives the same setpoint again, so that a run that is held keeps saying what it wants.
    pub async fn refresh(&mut self, param: &Param, raw: i64) -> Result<(), Failure> {
        self.write(param, 0, raw).await
    }

    /// Waits until the drive says that the setpoint is reached, as long as the actual value still moves.
    pub async fn until_reached(&mut self) -> Result<(), Failure> {
        let mut seen = None;
        let mut since = self.session.now();
        loop {
            let status = self.status().await?;
            let speed = self.speed().await?;
            let decimals = crate::profile::setpoint::DECIMALS;
            if let Some(setpoint) = &mut self.setpoint {
                setpoint.actual = speed.map(|raw| Decimal { raw, decimals });
                setpoint.reached = Some(status & REACHED_BIT != 0);
            }
            if status & REACHED_BIT != 0 {
                return Ok(());
            }
            if describe::state(&self.target.family, status, self.lang).slug.starts_with("fault") {
                return Err(self.fault_failure().await);
            }
            if seen != Some((status, speed)) {
                seen = Some((status, speed));
                since = self.session.now();
            }
            if self.session.now().since(since) > self.patience {
                let text = self.lang.pick(
                    "the setpoint is not reached and the actual value does not move any more",
                    "der Sollwert wird nicht erreicht und der Istwert bewegt sich nicht mehr",
                );
                return Err(Failure::new(Class::No, "no.not_reached", text).hint(self.lang.pick(
                    "a limit (status bit 11), P.434, P.418/P.419 or P.549 can be the reason",
                    "Ursache kann ein Grenzwert (Statusbit 11), P.434, P.418/P.419 oder P.549 sein",
                )));
            }
            self.rest(POLL).await?;
        }
    }

    /// Keeps the run alive for a time, or until something ends it: looks at the state, which also feeds the drive's
    /// watchdog, and ends with an error if the drive trips or, having been enabled, is so no longer. `each` is called in every round.
    pub async fn hold(
        &mut self,
        duration: Option<Span>,
        mut each: impl AsyncFnMut(&mut Self, Span) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let begun = self.session.now();
        let mut was_enabled = false;
        loop {
            let gone = self.session.now().since(begun);
            if duration.is_some_and(|duration| gone >= duration) {
                return Ok(());
            }
            each(self, gone).await?;
            let status = self.status().await?;
            let state = describe::state(&self.target.family, status, self.lang);
            match state.slug.as_str() {
                "operation-enabled" => was_enabled = true,
                _ if !was_enabled && !state.slug.starts_with("fault") => {}
                slug if slug.starts_with("fault") => return Err(self.fault_failure().await),
                _ => {
                    let text = self.lang.pick(
                        "the drive left the run by itself; it is now",
                        "der Antrieb ist von selbst ausgestiegen, jetzt:",
                    );
                    return Err(Failure::new(Class::Forbidden, "forbidden.left_run", format!("{text} {}", state.name)));
                }
            }
            let rest = duration.map_or(ROUND, |duration| ROUND.min(duration - gone));
            self.rest(rest.max(POLL)).await?;
        }
    }

    /// Writes virtual contacts.
    pub async fn contacts(&mut self, word: u16) -> Result<(), Failure> {
        self.lever = Lever::Contacts;
        self.write_control(word).await
    }

    /// Keeps virtual contacts closed for a time; ends with an error if the drive trips.
    pub async fn hold_contacts(&mut self, duration: Option<Span>) -> Result<(), Failure> {
        let begun = self.session.now();
        loop {
            let gone = self.session.now().since(begun);
            if duration.is_some_and(|duration| gone >= duration) {
                return Ok(());
            }
            let status = self.status().await?;
            if describe::state(&self.target.family, status, self.lang).slug.starts_with("fault") {
                return Err(self.fault_failure().await);
            }
            let rest = duration.map_or(ROUND, |duration| ROUND.min(duration - gone));
            self.rest(rest.max(POLL)).await?;
        }
    }

    /// Changes a setting for the run, in RAM of the data set that the drive works with; it is given back at the end.
    pub async fn change(&mut self, role: &str, new: i64) -> Result<(), Failure> {
        let Some(param) = self.target.family.role(role).cloned() else { return Ok(()) };
        let set = ram_set(self.session, self.target, &param, self.lang).await?;
        let reading = self.target.read_set(self.session, &param, set).await;
        let old = reading.map_err(|error| self.failure(&error))?.raw;
        if old == new {
            return Ok(());
        }
        let (data_set, _) = describe::place(set);
        self.changes.push(Change { param: param.id, data_set, old, new, restored: false });
        self.write(&param, set, new).await
    }

    /// Gives back what was changed; settings that decide whether the drive still obeys only once it stands.
    async fn give_back(&mut self, stands: bool) {
        if stands && self.setpoint.as_ref().is_some_and(|setpoint| setpoint.value.raw != 0) {
            let param = self.setpoint.as_ref().and_then(|setpoint| self.target.family.param(setpoint.param).cloned());
            if let Some(param) = param {
                // So that nobody is surprised by it at the next enable.
                let _best_effort = self.write(&param, 0, 0).await;
            }
        }
        if !stands {
            return;
        }
        for index in (0..self.changes.len()).rev() {
            let Some(change) = self.changes.get(index).cloned() else { continue };
            let param = self.target.family.param_or_unknown(change.param);
            if self.target.family.role("control-mode").is_some_and(|mode| mode.id == param.id)
                && !self.may_give_control_back(change.old).await
            {
                continue;
            }
            let mut restored = false;
            for _ in 0..STOP_TRIES {
                restored =
                    restored || self.write(&param, change.data_set + DataSets::RAM_OFFSET, change.old).await.is_ok();
            }
            if let Some(change) = self.changes.get_mut(index) {
                change.restored = restored;
            }
        }
    }

    /// Whether the drive stays where it is when P.412 goes back. The control word of the stop would close contacts under
    /// P.412 = 2, so it is cleared first; and contacts that are closed now would start the drive under P.412 = 0.
    async fn may_give_control_back(&mut self, old: i64) -> bool {
        if self.write_control(0).await.is_err() {
            return false;
        }
        let Ok(status) = self.status().await else { return false };
        if old != CONTACTS || status & REMOTE_BIT == 0 {
            return true;
        }
        let note = self.lang.pick(
            "P.412 stays 1: enable and start contact are closed and would start the drive under P.412 = 0",
            "P.412 bleibt 1: Freigabe und Startkontakt sind geschlossen und würden den Antrieb unter P.412 = 0 starten",
        );
        self.notes.push(note.to_owned());
        false
    }

    /// Sends the stop and waits for the state that proves it. Never fails: it reports.
    async fn stop(&mut self, choice: StopChoice, because: &'static str) -> Stop {
        let (name, command, goal) = choice.row();
        let mut stop = Stop { choice: name, because, acknowledged: false, state: None, note: None };
        if choice == StopChoice::Keep {
            stop.note = Some(
                self.lang
                    .pick("the drive keeps running, as asked for", "der Antrieb läuft weiter, wie verlangt")
                    .to_owned(),
            );
            return stop;
        }
        let word = match self.lever {
            Lever::ControlWord => self.target.family.machine.command(command).map_or(0, |command| command.word),
            Lever::Contacts | Lever::Setpoint => 0,
        };
        let goal = if self.lever == Lever::ControlWord { goal } else { "switched-on" };
        for _ in 0..STOP_TRIES {
            let sent = match (self.lever, self.setpoint.as_ref().map(|setpoint| setpoint.param)) {
                (Lever::Setpoint, Some(param)) => {
                    let param = self.target.family.param_or_unknown(param);
                    self.write(&param, 0, 0).await
                }
                _ => self.write_control(word).await,
            };
            if sent.is_err() {
                continue;
            }
            let stopped = match self.lever {
                Lever::Setpoint => self.until_still().await,
                Lever::ControlWord | Lever::Contacts => self.until_stopped(goal).await,
            };
            match stopped {
                Ok(state) => {
                    stop.acknowledged = true;
                    stop.state = Some(state);
                    return stop;
                }
                Err(failure) if failure.class == Class::Port => break,
                Err(_) => {}
            }
        }
        if let (Ok(status), true) = (self.status().await, self.lever != Lever::Setpoint) {
            let state = describe::state(&self.target.family, status, self.lang);
            stop.acknowledged = stopped_states(goal).contains(&state.slug.as_str());
            stop.state = Some(state);
        }
        if !stop.acknowledged {
            stop.note = Some(self.watchdog_note().await);
        }
        stop
    }

    /// A drive that tripped, or that lies in a state below the goal, does not turn either.
    async fn until_stopped(&mut self, goal: &str) -> Result<State, Failure> {
        let status = self.status().await?;
        let state = describe::state(&self.target.family, status, self.lang);
        if stopped_states(goal).contains(&state.slug.as_str()) {
            return Ok(state);
        }
        let takes = if goal == "switched-on" { Takes::Transition5 } else { Takes::QuickStop };
        self.until(goal, Some(takes), true).await
    }

    /// Waits until the shaft stands; patience begins anew while it still slows down.
    async fn until_still(&mut self) -> Result<State, Failure> {
        let mut seen = None;
        let mut since = self.session.now();
        loop {
            let status = self.status().await?;
            let state = describe::state(&self.target.family, status, self.lang);
            let speed = self.speed().await?;
            if speed == Some(0) || state.slug != "operation-enabled" {
                return Ok(state);
            }
            if seen != Some(speed) {
                seen = Some(speed);
                since = self.session.now();
            }
            if self.session.now().since(since) > self.patience {
                return Err(self.stuck(&state, "switched-on").await);
            }
            self.rest(POLL).await?;
        }
    }

    async fn watchdog_note(&mut self) -> String {
        let changed = self.target.family.role("watchdog").map(|param| param.id);
        let set = self.changes.iter().find(|change| Some(change.param) == changed).map(|change| change.new);
        let seconds = match set {
            Some(seconds) => Some(seconds),
            None => self.role_raw("watchdog").await.ok().flatten().or(self.target.known_watchdog),
        };
        match (seconds, self.lang) {
            (Some(0), Lang::En) => "the drive's watchdog (P.413) is off: THE SHAFT MAY STILL TURN".to_owned(),
            (Some(0), Lang::De) => "der Watchdog (P.413) ist aus: DIE WELLE KANN NOCH DREHEN".to_owned(),
            (Some(s), Lang::En) => format!("the drive's watchdog (P.413) trips it {s} s after the last telegram"),
            (Some(s), Lang::De) => format!("der Watchdog (P.413) schaltet {s} s nach dem letzten Telegramm ab"),
            (None, Lang::En) => {
                "whether the drive's watchdog stops it is not known: THE SHAFT MAY STILL TURN".to_owned()
            }
            (None, Lang::De) => "ob der Watchdog abschaltet, ist unbekannt: DIE WELLE KANN NOCH DREHEN".to_owned(),
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

/// States in which a stop that leads to `goal` has done its work.
fn stopped_states(goal: &str) -> &'static [&'static str] {
    match goal {
        "switched-on" => &["switched-on", "ready-to-switch-on", "switch-on-disabled", "fault", "not-ready"],
        _ => &["switch-on-disabled", "ready-to-switch-on", "switched-on", "fault", "not-ready"],
    }
}

fn has_voltage_bit(target: &Target) -> bool {
    target.family.machine.transitions.iter().any(|transition| transition.needs.contains(&Need::Voltage))
}

/// What the drive says that matters for moving it.
pub async fn look(session: &mut Session<'_>, target: &mut Target, lang: Lang) -> Result<Situation, Failure> {
    let status = role_raw(session, target, "status-word", lang).await?.unwrap_or(0) as u32;
    let watchdog_s = role_raw(session, target, "watchdog", lang).await?;
    target.known_watchdog = watchdog_s;
    Ok(Situation {
        status,
        state: describe::state(&target.family, status, lang).slug,
        mode: working_raw(session, target, "control-mode", lang).await?,
        fault: role_raw(session, target, "fault", lang).await?,
        inputs: role_raw(session, target, "digital-inputs", lang).await?,
        configuration: role_raw(session, target, "configuration", lang).await?,
        watchdog_s,
        transition5: working_raw(session, target, "transition-5", lang).await?,
    })
}

/// What keeps the drive from running, in words, and how one sees it.
pub fn missing(situation: &Situation, target: &Target, lang: Lang) -> Vec<String> {
    let mut missing = Vec::new();
    let is_acu = has_voltage_bit(target);
    if let Some(mode) = situation.mode.filter(|&mode| mode != STATE_MACHINE) {
        missing.push(match lang {
            Lang::En => format!("P.412 is {mode}: the control word is obeyed only with 1 (--take-control)"),
            Lang::De => format!("P.412 ist {mode}: auf das Steuerwort hört der Antrieb nur bei 1 (--take-control)"),
        });
    }
    let input = |bit: u8| situation.inputs.map(|word| word >> bit & 1 == 1);
    if situation.mode == Some(STATE_MACHINE) && situation.status & REMOTE_BIT == 0 {
        let enable = match (is_acu, lang) {
            (false, Lang::En) => "external enable S1IND (terminal X210A.3)",
            (false, Lang::De) => "externe Freigabe S1IND (Klemme X210A.3)",
            (true, Lang::En) => "external enable STOA and STOB (terminals X210A.3 and X210B.2)",
            (true, Lang::De) => "externe Freigabe STOA und STOB (Klemmen X210A.3 und X210B.2)",
        };
        let start = lang.pick(
            "start contact S2IND or S3IND, or P.68/P.69 set to on",
            "Startkontakt S2IND oder S3IND, oder P.68/P.69 auf Ein",
        );
        let seen = lang.pick("P.250 shows the inputs", "P.250 zeigt die Eingänge");
        let what = match (input(0), input(1).zip(input(2))) {
            (Some(true), Some((false, false))) => start.to_owned(),
            (Some(false), Some((right, left))) if right || left => enable.to_owned(),
            _ => format!("{enable}; {start}"),
        };
        missing.push(format!("{}: {what} ({seen})", lang.pick("Remote bit 9 is 0", "Remote-Bit 9 ist 0")));
    }
    if is_acu && situation.status & VOLTAGE_BIT == 0 {
        missing.push(
            lang.pick(
                "status bit 4 is 0: no mains voltage, only the 24 V supply",
                "Statusbit 4 ist 0: keine Netzspannung, nur die 24-V-Versorgung",
            )
            .to_owned(),
        );
    }
    if let Some(fault) = situation.fault.and_then(|code| describe::fault(&target.family, code as u32, lang)) {
        missing.push(format!("{} {}", fault.key, fault.name));
    }
    missing
}

fn no_plan(why: &NoPlan, target: &Target, lang: Lang) -> Failure {
    match why {
        NoPlan::Unreachable { from, goal } => {
            let name = |slug: &str| {
                target
                    .family
                    .states
                    .iter()
                    .find(|row| row.slug == slug)
                    .map_or(slug.to_owned(), |row| row.name(lang).to_owned())
            };
            let text = match lang {
                Lang::En => format!("no command leads from '{}' to '{}'", name(from), name(goal)),
                Lang::De => format!("kein Befehl führt von '{}' nach '{}'", name(from), name(goal)),
            };
            Failure::new(Class::Forbidden, "forbidden.unreachable", text)
        }
        NoPlan::Missing(needs) => {
            let word = |need: &Need| match need {
                Need::Voltage => lang.pick("mains voltage (status bit 4)", "Netzspannung (Statusbit 4)"),
                Need::Release => lang.pick(
                    "external enable and start contact (Remote bit 9)",
                    "externe Freigabe und Startkontakt (Remote-Bit 9)",
                ),
                Need::NoPositioning => lang.pick(
                    "a configuration without positioning (P.30)",
                    "eine Konfiguration ohne Positionierung (P.30)",
                ),
                Need::Lock => lang.pick("15 s since the fault", "15 s seit der Störung"),
            };
            let words: Vec<_> = needs.iter().map(word).collect();
            let text = format!(
                "{}: {}",
                lang.pick("the drive cannot be enabled, missing", "der Antrieb ist nicht freizugeben, es fehlt"),
                words.join(", ")
            );
            let slugs = needs.iter().map(|need| format!("{need:?}").to_lowercase()).collect::<Vec<_>>();
            Failure::new(Class::Forbidden, "forbidden.interlock", text).with("missing", slugs.join(","))
        }
    }
}

/// The raw value of the parameter with a role; `None` if the drive refuses it.
pub async fn role_raw(
    session: &mut Session<'_>,
    target: &mut Target,
    role: &str,
    lang: Lang,
) -> Result<Option<i64>, Failure> {
    let Some(param) = target.family.role(role).cloned() else { return Ok(None) };
    raw(session, target, &param, 0, lang).await
}

/// The raw value that the drive works with: RAM of the active data set.
pub async fn working_raw(
    session: &mut Session<'_>,
    target: &mut Target,
    role: &str,
    lang: Lang,
) -> Result<Option<i64>, Failure> {
    let Some(param) = target.family.role(role).cloned() else { return Ok(None) };
    let set = ram_set(session, target, &param, lang).await?;
    raw(session, target, &param, set, lang).await
}

async fn raw(
    session: &mut Session<'_>,
    target: &mut Target,
    param: &Param,
    set: u8,
    lang: Lang,
) -> Result<Option<i64>, Failure> {
    match target.read_set(session, param, set).await {
        Ok(reading) => Ok(Some(reading.raw)),
        Err(AccessError::Refused(_)) => Ok(None),
        Err(error) => Err(error.failure(target.address, Some(&target.family), lang)),
    }
}

/// The RAM data set in which the drive works with a parameter.
async fn ram_set(session: &mut Session<'_>, target: &mut Target, param: &Param, lang: Lang) -> Result<u8, Failure> {
    if param.sets != Some(crate::profile::Sets::Four) {
        return Ok(DataSets::RAM_OFFSET);
    }
    let active = role_raw(session, target, "active-set", lang).await?.unwrap_or(1);
    Ok(DataSets::RAM_OFFSET + u8::try_from(active).unwrap_or(1).clamp(1, 4))
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
