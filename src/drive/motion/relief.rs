//! Acts that can only take motion away: they need nobody's word, and must work where little else does.

use super::lacking::no_control;
use super::look::working_raw;
use super::passing::Look;
use super::still::{QUICK_STOP, STILL_TURNING, STOPPED};
use super::{Lever, Motor, Shown, Situation, StopChoice, has_power};
use crate::drive::describe;
use crate::exchange::ExchangeError;
use crate::failure::{Class, Failure, unanswered_stop};
use crate::gate::Relief;
use crate::profile::{Mode, Param, Takes, Transition};
use crate::text::{Text, both};
use crate::tick::Span;

/// The command of the state machine that an act is; `None` for a setpoint.
pub(super) fn command_of(act: Relief) -> Option<&'static str> {
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

/// What only takes motion away goes out first. So long an answer to what proves it may be missing: then the end is told as
/// it is, because whoever stands beside the shaft must know.
pub const PROOF: Span = Span::from_secs(6);
/// And so long answers may come that prove nothing, unless the shaft becomes slower.
const PROVING: Span = Span::from_secs(12);

/// A drive that has answered so long ago still answers.
const ANSWERS: Span = Span::from_secs(1);

/// How often what takes motion away is done where the drive answers, but not always.
const TRIES: u8 = 3;

impl Motor<'_, '_> {
    /// The drive has answered: what takes motion away is waited for on.
    pub(super) fn goes_on(&mut self) {
        if let (Some(since), None) = (self.relieving, self.bound) {
            self.session.end_at(Some((self.session.now() + PROOF).min(since + PROVING)));
        }
    }

    /// From now on every question ends within this time, whatever comes over the line.
    pub(super) fn ends_within(&mut self, span: Span) {
        self.bound = Some(self.session.now() + span);
        self.session.end_at(self.bound);
    }

    /// The shaft becomes slower, or will not before this time is over: that is no reason to give up.
    pub(super) fn takes_time(&mut self, span: Span) {
        if self.relieving.is_some() {
            self.relieving = Some(self.session.now() + span);
            self.goes_on();
        }
    }

    /// Takes motion away by a command, whatever the state, and waits for the state and the standstill that prove it. The
    /// first word went out already ([`super::shout`]); now the one follows that fits what the drive says of itself.
    pub async fn relieve(&mut self, act: Relief) -> Result<(), Failure> {
        if command_of(act).is_none() {
            return Ok(());
        }
        self.enabled = false;
        (self.shouted, self.stopping, self.shown) = (true, true, None);
        self.sight.forget();
        self.looked_at_before();
        self.session.insist(true);
        self.session.warns(unanswered_stop());
        self.again = self.control_word().ok().zip(self.blind_word(act).map(i64::from));
        let done = self.anew(async |motor: &mut Self| motor.relieve_by(act).await).await;
        match done.map_err(|failure| self.or_disobeyed(failure)) {
            Err(failure) if self.is_off() && failure.is_unheard() => {
                self.tell_lost(&failure);
                Ok(())
            }
            Err(failure) if failure.class == Class::Interrupted => {
                // Its first word went out, also where none was needed behind it: a stronger one follows.
                self.touched = true;
                if self.lever == Lever::Setpoint {
                    self.lever = Lever::ControlWord;
                }
                Err(failure)
            }
            Err(failure) if failure.class == Class::Forbidden && self.lever == Lever::ControlWord => {
                // The first word was obeyed, so none followed it; but the shaft does not come to rest by it.
                self.touched = true;
                Err(failure)
            }
            done => done,
        }
    }

    /// What ends with the time of the stop is no silence where the drive has answered until then.
    fn or_disobeyed(&self, failure: Failure) -> Failure {
        let answers = self.session.is_over() && self.session.now().since(self.heard) < ANSWERS;
        if !failure.is_unheard() || !answers || self.is_off() {
            return failure;
        }
        let text = both!(
            "the drive answers, but was not seen to stop in the time that it may take",
            "der Antrieb antwortet, wurde aber in der Zeit, die er brauchen darf, nicht angehalten gesehen"
        );
        Failure { alarm: true, ..Failure::new(Class::Forbidden, STILL_TURNING, text) }
    }

    /// What was seen in passing, behind the first word.
    fn looked_at_before(&mut self) {
        for look in std::mem::take(&mut self.first_word.looks) {
            match look {
                Look::Shaft(raw) => self.sight.frequency(raw),
                Look::Status(status) => self.see(&describe::state(&self.target.family, status).slug),
            }
        }
    }

    /// Does it again where an answer was lost on the way: a line that fails now and then is no reason for another stop than the one
    /// that was asked for.
    async fn anew(&mut self, mut work: impl AsyncFnMut(&mut Self) -> Result<(), Failure>) -> Result<(), Failure> {
        let mut tries = 1;
        loop {
            let begun = self.session.now();
            match work(self).await {
                Err(failure)
                    if failure.is_unheard()
                        && tries < TRIES
                        && (self.heard > begun || (tries == 1 && self.first_word.heard))
                        && !self.is_off()
                        && !self.session.is_over() =>
                {
                    tries += 1;
                }
                done => return done,
            }
        }
    }

    /// Somebody interrupted before this drive had its turn, and its first word went out: a stronger one follows.
    pub fn breaks_off(&mut self) -> Failure {
        (self.enabled, self.shouted, self.stopping, self.shown) = (false, true, true, None);
        (self.touched, self.lever) = (true, Lever::ControlWord);
        Failure::new(Class::Interrupted, "interrupted", both!("interrupted", "unterbrochen"))
    }

    async fn relieve_by(&mut self, act: Relief) -> Result<(), Failure> {
        let mut situation = self.glance(act).await?;
        let family = self.target.family.clone();
        let contacts = family.motion.control.map(|control| control.contacts);
        let unheard = |seen: &Option<Situation>, motor: &Self| {
            let seen = seen.as_ref().filter(|seen| seen.mode.is_none() || seen.mode != contacts)?;
            no_control(seen, motor.target)
        };
        if unheard(&situation, self).is_some() {
            // What was read may be wrong: the stop is not kept back by it, and what proves it is asked anew.
            let _told_below = self.say_blindly(act).await;
            situation = self.glance(act).await?;
            if let (Some(failure), Some(seen)) = (unheard(&situation, self), &situation) {
                return Err(self.not_obeyed(failure, seen));
            }
        }
        self.lever = match &situation {
            Some(seen) if contacts.is_some() && seen.mode == contacts => Lever::Contacts,
            _ => Lever::ControlWord,
        };
        match &situation {
            // A command of the state machine would close virtual contacts here.
            Some(_) if self.lever == Lever::Contacts => self.relieve_contacts(act).await?,
            // It is under way, and saying it again would take the time in which the shaft is seen to stand.
            Some(_) if self.first_word.obeyed => self.touched = true,
            Some(seen) => {
                self.note_instead(act, seen.state != "operation-enabled");
                self.command_from(command_of(act).unwrap_or_default(), &seen.state).await?;
            }
            None => {
                self.note_instead(act, true);
                self.touched = true;
                self.say_blindly(act).await?;
            }
        }
        self.prove_relief(act).await
    }

    /// What the first word did is not what was asked for, if the drive has heard it.
    fn note_instead(&mut self, act: Relief, heard: bool) {
        if act == Relief::Disable && self.first_word.instead && heard {
            let label = self.target.family.role_label("control-mode");
            self.instead = Some(both!(
                "a quick stop in place of the ramp: {label} was not told in time",
                "Schnellhalt statt Rampe: {label} wurde nicht rechtzeitig gesagt"
            ));
        }
    }

    /// Opens virtual contacts: for a ramp the start contacts first. There is no quick stop by contacts.
    async fn relieve_contacts(&mut self, act: Relief) -> Result<(), Failure> {
        let starts = self.target.family.motion.control.map_or(0, |control| control.start_contacts);
        let stands = self.role_raw("control-word").await?;
        self.word = stands.and_then(|word| u16::try_from(word).ok()).unwrap_or(0);
        let keeps_power = self.word & !starts != 0;
        let why = match act {
            Relief::QuickStop => {
                Some(both!("and contacts know no quick stop", "und Kontakte kennen keinen Schnellhalt"))
            }
            Relief::Disable if self.first_word.instead && !keeps_power => {
                Some(both!("which was not told in time", "was nicht rechtzeitig gesagt wurde"))
            }
            _ => None,
        };
        self.instead = why.map(|why| self.opened_instead(&why));
        let way = if act == Relief::Disable { StopChoice::Ramp } else { StopChoice::Coast };
        self.open_contacts(way, false).await.map(|_state| ())
    }

    /// What opening all contacts is in place of the stop that was asked for.
    fn opened_instead(&self, why: &Text) -> Text {
        let label = self.target.family.role_label("control-mode");
        both!(
            "{label} is 2, {why}: all contacts were opened, and a shaft that was turning coasts",
            "{label} ist 2, {why}: alle Kontakte wurden geöffnet, eine drehende Welle läuft aus",
            why
        )
    }

    /// What proves the stop, and what decides on the word that follows: state and control mode, if both are told. All else
    /// is for the report. Only what ends the session is an error.
    async fn glance(&mut self, act: Relief) -> Result<Option<Situation>, Failure> {
        match self.state_and_mode(act).await {
            Ok(seen) => {
                self.first_seen.get_or_insert_with(|| seen.clone());
                Ok(Some(seen))
            }
            Err(failure) if matches!(failure.class, Class::Interrupted | Class::Port) && !failure.is_unheard() => {
                Err(failure)
            }
            Err(_) => Ok(None),
        }
    }

    async fn state_and_mode(&mut self, act: Relief) -> Result<Situation, Failure> {
        let passes = self.session.is_shared() || self.first_word.is_late;
        let passes = passes && self.target.family.motion.stator.is_some();
        let late = passes && self.first_word.is_late && self.first_word.heard;
        if late && act != Relief::DisableVoltage && !self.sight.must_look() {
            self.looks_on().await?;
        }
        let status = self.status().await?;
        let state = describe::state(&self.target.family, status).slug;
        if passes && self.sight.standing() != Some(true) {
            // Where others wait, or every answer takes long, a standstill under power may be over before the next look.
            self.first_word.obeyed |= self.looks_on().await? && self.commands(act);
        }
        if passes && self.sight.must_look() {
            self.status().await?;
        }
        let control = self.target.family.motion.control;
        // Who is in a quick stop obeys, and so does who becomes slower by the word that only a command is.
        let obeyed = control.filter(|_| self.first_word.obeyed || (passes && state == QUICK_STOP));
        let mode = match obeyed {
            Some(control) => Some(control.obeys),
            None => working_raw(self.session, self.target, "control-mode").await?,
        };
        Ok(Situation { status, state, mode, ..Situation::default() })
    }

    /// Looks at the shaft; of a slow drive as long as it becomes slower under power. Whether it did.
    async fn looks_on(&mut self) -> Result<bool, Failure> {
        let mut before = None;
        loop {
            let pace = self.shaft().await?.map(i64::unsigned_abs);
            let slows = before.zip(pace).is_some_and(|(before, pace)| pace < before);
            let goes_on = self.first_word.is_late && (slows || before.is_none()) && self.sight.on != Some(false);
            if !goes_on || pace.is_none_or(|pace| pace == 0) {
                return Ok(slows);
            }
            if slows {
                self.takes_time(Span::ZERO);
            }
            before = pace;
        }
    }

    /// Whether the first word was heard, and was the command that was asked for.
    pub(super) fn commands(&self, act: Relief) -> bool {
        let command = command_of(act).and_then(|slug| self.target.family.machine.command(slug));
        self.first_word.heard && command.is_some_and(|command| self.first_word.word == Some(command.word))
    }

    /// Whether one question was answered in two ways: most likely by two drives with one address.
    pub fn differs(&self) -> bool {
        self.session.differs(self.target.address)
    }

    /// That more than one answer came to one question: what was proven may be of one drive, and another one runs.
    pub fn twins(&self) -> Option<Failure> {
        let station = self.target.address;
        let two = self.session.answered_twice(station);
        two.then(|| self.failure(&ExchangeError::TwoAnswers { station }.into()))
    }

    /// Whether the drive was seen without power at the last look since its stop began.
    pub(super) fn is_off(&self) -> bool {
        let slug = |status| describe::state(&self.target.family, status).slug;
        self.stopping && self.shown.is_some_and(|shown| has_power(&slug(shown.status)) == Some(false))
    }

    /// The stop is proven; what was asked behind it brought no answer.
    pub(super) fn tell_lost(&mut self, failure: &Failure) {
        // What was seen may be of another one.
        let Some(Shown { told: at, .. }) = self.shown.filter(|_| self.twins().is_none()) else { return };
        let ago = self.session.now().since(at).as_millis();
        self.notes.push(both!(
            "seen without power {ago} ms before the end; not read after that: {why}",
            "{ago} ms vor dem Ende ohne Strom gesehen; danach nicht gelesen: {why}",
            why = failure.told()
        ));
    }

    /// The word that can only stop, whatever the drive takes it for.
    fn blind_word(&self, act: Relief) -> Option<u16> {
        let family = &self.target.family;
        // As contacts 07h, "disable operation", could start something (see `shout`).
        let slug = match act {
            Relief::Disable if family.motion.control.is_some() => Some("quick-stop"),
            act => command_of(act),
        };
        let usual = slug.and_then(|slug| family.machine.command(slug)).map(|command| command.word);
        self.first_word.word.or(usual)
    }

    async fn say_blindly(&mut self, act: Relief) -> Result<(), Failure> {
        let (Some(word), param) = (self.blind_word(act), self.control_word()?) else { return Ok(()) };
        self.write(&param, 0, word.into()).await
    }

    /// The stop went out, to a drive that others start and stop.
    fn not_obeyed(&self, failure: Failure, seen: &Situation) -> Failure {
        let mut failure = failure;
        failure.message = both!(
            "{why}; the stop was sent all the same, but it is not obeyed",
            "{why}; der Halt wurde trotzdem gesendet, aber nicht befolgt",
            why = failure.message
        );
        if ["operation-enabled", "quick-stop-active", "unknown"].contains(&seen.state.as_str()) {
            failure.alarm = true;
        }
        failure.hint(both!(
            "its enable or start contact, its keypad or the mains stop it; --take-control takes it over for the run",
            "ihn halten Freigabe oder Startkontakt, seine Bedieneinheit oder das Netz an; --take-control übernimmt ihn für \
             den Lauf"
        ))
    }

    /// Gives the setpoint 0 and waits for the standstill. That it does not come is said, and ends nothing: a least
    /// frequency may hold the shaft turning.
    pub async fn relieve_setpoint(&mut self, mode: &Mode, param: &Param) -> Result<(), Failure> {
        self.stopping = true;
        self.session.insist(true);
        self.prepare(mode);
        self.anew(async |motor: &mut Self| {
            motor.give(param, 0, param.unit.as_deref().unwrap_or("")).await?;
            motor.standstill().await.map(|_| ())
        })
        .await?;
        let standing = self.still.flatten();
        if let Some(setpoint) = &mut self.setpoint {
            setpoint.reached = standing;
        }
        Ok(())
    }

    /// A drive that coasts may do so for long; whoever asked for that is told when it is without power.
    async fn prove_relief(&mut self, act: Relief) -> Result<(), Failure> {
        let takes = if act == Relief::Disable { Takes::Transition5 } else { Takes::QuickStop };
        self.until(STOPPED, Some(takes), true).await?;
        if act != Relief::DisableVoltage {
            self.until_still().await?;
        }
        Ok(())
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
                let command = command.ok_or_else(|| Failure::new(Class::Usage, "usage.command", Text::name(slug)))?;
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
