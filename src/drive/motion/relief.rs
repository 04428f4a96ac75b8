//! Acts that can only take motion away: they need nobody's word, and must work where little else does.

use super::look::no_control;
use super::{Lever, Motor, StopChoice};
use crate::failure::{Class, Failure};
use crate::gate::Relief;
use crate::profile::{Mode, Param, Transition};

/// The command of the state machine that an act is; `None` for a setpoint.
fn command_of(act: Relief) -> Option<&'static str> {
    match act {
        Relief::Disable => Some("disable"),
        Relief::QuickStop => Some("quick-stop"),
        Relief::DisableVoltage => Some("disable-voltage"),
        Relief::Zero => None,
    }
}

impl StopChoice {
    /// What follows where such an act was interrupted, or not obeyed.
    pub fn beyond(act: Relief) -> Self {
        match act {
            Relief::Zero => StopChoice::Ramp,
            Relief::Disable => StopChoice::QuickStop,
            Relief::QuickStop | Relief::DisableVoltage => StopChoice::Coast,
        }
    }
}

impl Motor<'_, '_> {
    /// Takes motion away by a command, whatever the state, and waits for the state and the standstill that prove it.
    pub async fn relieve(&mut self, act: Relief) -> Result<(), Failure> {
        let Some(slug) = command_of(act) else { return Ok(()) };
        self.enabled = false;
        self.session.insist(true);
        let situation = match self.look().await {
            Ok(situation) => Some(situation),
            // No contacts are closed by a word that is 0, so that one goes out unseen, into a bad line too.
            Err(failure) if failure.class == Class::Interrupted || act != Relief::DisableVoltage => {
                return Err(failure);
            }
            Err(_) => None,
        };
        let control = self.target.family.motion.control;
        if let (Some(control), Some(situation)) = (control, &situation)
            && situation.mode == Some(control.contacts)
        {
            // A command of the state machine would close virtual contacts here; all open is what stops.
            self.lever = Lever::Contacts;
            self.write_control(0).await?;
        } else if let Some(failure) = situation.as_ref().and_then(|seen| no_control(seen, self.target, self.lang)) {
            return Err(failure.hint(self.lang.pick(
                "its own contacts or its keypad stop it; --take-control takes it over for the run",
                "ihn halten seine Kontakte oder seine Bedieneinheit an; --take-control übernimmt ihn für den Lauf",
            )));
        } else {
            self.lever = Lever::ControlWord;
            self.command_from(slug, situation.as_ref().map_or("", |seen| &seen.state)).await?;
        }
        self.prove_relief(act).await
    }

    /// Gives the setpoint 0 and waits for the standstill. That it does not come is said, and ends nothing: a least
    /// frequency may hold the shaft turning.
    pub async fn relieve_setpoint(&mut self, mode: &Mode, param: &Param) -> Result<(), Failure> {
        self.session.insist(true);
        self.prepare(mode);
        self.give(param, 0, param.unit.as_deref().unwrap_or("")).await?;
        let standing = self.standstill().await?;
        if let Some(setpoint) = &mut self.setpoint {
            setpoint.reached = standing;
        }
        Ok(())
    }

    /// A drive that coasts may do so for long; whoever asked for that is told when it is without power.
    async fn prove_relief(&mut self, act: Relief) -> Result<(), Failure> {
        self.until_without_power().await?;
        if act == Relief::DisableVoltage {
            return Ok(());
        }
        self.until_still().await.map(|_| ())
    }

    /// Sends one command, whatever the state, and waits for where it leads from the present state.
    pub async fn command(&mut self, slug: &str) -> Result<(), Failure> {
        self.enabled = false;
        let situation = self.look().await?;
        self.demand_control(&situation)?;
        self.command_from(slug, &situation.state).await
    }

    async fn command_from(&mut self, slug: &str, from: &str) -> Result<(), Failure> {
        let machine = self.target.family.machine.clone();
        match machine.transition(from, slug).cloned() {
            Some(transition) => {
                self.pass(&transition).await?;
                if transition.to == "quick-stop-active" { self.end_quick_stop().await } else { Ok(()) }
            }
            // No command is obeyed there but the one that leads out.
            None if from == "quick-stop-active" => self.leave_quick_stop().await.map(|_state| ()),
            None => {
                // A stop is never refused: it goes out even if the state says that there is nothing to stop.
                let command = machine.command(slug).cloned();
                let command = command.ok_or_else(|| Failure::new(Class::Usage, "usage.command", slug.to_owned()))?;
                self.write_control(command.word).await
            }
        }
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
}
