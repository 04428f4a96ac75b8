//! Walking the state machine, each step proven, and why a step does not come.

use super::lacking::{missing, no_control, tripped};
use super::look::{no_plan, state_name};
use super::still::QUICK_STOP;
use super::taking::Taken;
use super::{Lever, Motor, Situation};
use crate::drive::describe;
use crate::failure::{Class, Failure};
use crate::outcome::{Event, Fault, State, Step};
use crate::profile::{Command, Need, Transition};
use crate::text::{Text, both};
use crate::tick::Span;

/// The drive does not go where it is told to.
pub(super) const NOT_OBEYED: &str = "forbidden.interlock";

impl Motor<'_, '_> {
    /// Walks to a state, step by step, each proven. A fault is never reset on the way.
    pub async fn walk(&mut self, goal: &str) -> Result<(), Failure> {
        self.enabled = false;
        self.sight.forget();
        let situation = self.look().await?;
        self.demand_control(&situation)?;
        if situation.state.starts_with("fault") {
            // A fault is reset only when somebody says so.
            return Err(self.fault_failure().await);
        }
        let family = self.target.family.clone();
        let mut from = situation.state.clone();
        if goal == "operation-enabled" && from != goal {
            self.demand_one_drive()?;
            self.clear().await?;
            from = self.begin(&from).await?;
        }
        let facts = situation.facts(&family);
        let way = family.machine.plan(&from, goal, &facts);
        let way = way.map_err(|why| no_plan(&why, &situation, &family))?;
        if goal != "operation-enabled" && way.iter().any(|transition| transition.to == "operation-enabled") {
            return Err(self.detour(goal));
        }
        for transition in way {
            if transition.to == "operation-enabled" {
                self.demand_one_drive()?;
            }
            self.pass(transition).await?;
        }
        self.enabled = goal == "operation-enabled";
        Ok(())
    }

    /// Two drives at one address would both start.
    fn demand_one_drive(&self) -> Result<(), Failure> {
        self.session.demand_one_drive(self.target.address).map_err(|error| self.failure(&error))
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

    /// Resets a fault: once, by a rising edge, after the drive's lock has passed.
    pub async fn reset(&mut self) -> Result<(), Failure> {
        self.enabled = false;
        let situation = self.look().await?;
        if situation.state != "fault" {
            return Err(no_fault());
        }
        let machine = self.target.family.machine.clone();
        // Contacts that did not start a drive in a fault may start it behind it.
        (self.bounded, self.taken) = (true, Taken::Tripped);
        match machine.transition("fault", "reset").cloned() {
            Some(transition) => {
                self.pass(&transition).await?;
                // The numbers of the fault memory are in no source, so this is all there is to show of it.
                let was = describe::fault(&self.target.family, situation.fault.unwrap_or(0) as u32);
                let now = self.look().await?.fault.unwrap_or(0);
                let now = describe::fault(&self.target.family, now as u32);
                let told = |fault: Option<Fault>| fault.map_or_else(|| Text::name("-"), |fault| fault.told());
                let label = self.target.family.role_label("fault");
                self.notes.push(both!(
                    "{label}: {was} -> {now}",
                    "{label}: {was} -> {now}",
                    was = told(was),
                    now = told(now)
                ));
                Ok(())
            }
            None => Err(Failure::new(
                Class::Data,
                "data.machine",
                both!("this drive has no reset", "dieser Antrieb hat keine Quittierung"),
            )),
        }
    }

    /// Goes through one transition.
    pub(super) async fn pass(&mut self, transition: &Transition) -> Result<(), Failure> {
        let begun = self.session.now();
        let command = transition.command.as_ref().and_then(|slug| self.target.family.machine.command(slug).cloned());
        if transition.needs.contains(&Need::Lock) {
            self.count_down(self.target.family.motion.fault_lock_s).await?;
        }
        if let Some(command) = &command {
            self.trigger(command).await?;
        }
        let leaves_fault = transition.from == "fault";
        let family = self.target.family.clone();
        // A quick stop may be over before anybody looks, and some drives leave it by themselves.
        let on = family.machine.transitions.iter().filter(|row| row.from == transition.to && row.from == QUICK_STOP);
        let goals: Vec<_> = [&transition.to].into_iter().chain(on.map(|row| &row.to)).map(String::as_str).collect();
        let came = self.until(&goals, transition.takes, leaves_fault).await;
        if let Some(command) = command.as_ref().filter(|command| command.edge) {
            // Also where it led nowhere: an edge that stands is none the next time.
            self.write_control(command.word & !command.mask).await?;
        }
        let state = came?;
        self.steps.push(Step {
            transition: transition.number.clone(),
            control: command.as_ref().map(|command| format!("0x{:04X}", command.word)),
            command: command.map(|command| command.slug),
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
    async fn count_down(&mut self, total: u64) -> Result<(), Failure> {
        for done in 0..total {
            let what = both!(
                "the drive refuses a reset for another {left} s",
                "der Antrieb lässt {left} s lang noch keine Quittierung zu",
                left = total - done
            );
            self.session.tell(Event::Progress { done, total, what });
            self.rest(Span::from_secs(1)).await?;
        }
        Ok(())
    }

    pub(super) fn demand_control(&mut self, situation: &Situation) -> Result<(), Failure> {
        match no_control(situation, self.target) {
            Some(failure) => Err(failure),
            None => {
                self.lever = Lever::ControlWord;
                Ok(())
            }
        }
    }

    /// Nobody powers a motor only to stop it.
    fn detour(&self, goal: &str) -> Failure {
        let text = both!(
            "'{goal}' is reached only from 'operation enabled', and the drive is not enabled",
            "'{goal}' geht nur aus 'Betrieb freigegeben', und der Antrieb ist nicht freigegeben",
            goal = state_name(&self.target.family, goal)
        );
        Failure::new(Class::Forbidden, "forbidden.detour", text)
    }

    /// Why a state does not come.
    pub(super) async fn stuck(&mut self, state: &State, goal: &str) -> Failure {
        let text = both!(
            "the drive stays in '{state}' and does not go to '{goal}'",
            "der Antrieb bleibt in '{state}' und geht nicht nach '{goal}'",
            state = state.name,
            goal = state_name(&self.target.family, goal)
        );
        let failure = Failure::new(Class::Forbidden, NOT_OBEYED, text);
        // A stronger stop does not wait for the reasons.
        if self.stopping { failure } else { self.with_what_is_missing(failure).await }
    }

    /// Adds to a failure what keeps the drive from running.
    pub(super) async fn with_what_is_missing(&mut self, failure: Failure) -> Failure {
        let missing = self.missing_now().await;
        if missing.is_empty() { failure } else { failure.hint(Text::join(&missing, "; ")) }
    }

    /// What keeps the drive from running, as far as it can be asked.
    async fn missing_now(&mut self) -> Vec<Text> {
        match self.look().await {
            Ok(situation) => missing(&situation, self.target),
            Err(_) => Vec::new(),
        }
    }

    pub(super) async fn fault_failure(&mut self) -> Failure {
        let code = self.role_raw("fault").await.ok().flatten().unwrap_or(0);
        tripped(&self.target.family, code as u32)
    }
}

/// Where nothing is to be reset.
pub fn no_fault() -> Failure {
    let text = both!("there is no fault to reset", "es steht keine Störung an");
    Failure::new(Class::Forbidden, "forbidden.no_fault", text)
}
