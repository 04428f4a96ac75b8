//! Work on a plant: several lines at once, the drives of one line in turn.
//!
//! First every drive is looked at ([`Line::look`]): is it there, is it the one that was meant, what would change? Then each gets
//! its values as a transaction of its own ([`Line::apply`]); what goes wrong with one is put back and stops the others only if
//! that is wanted ([`Together`]), and then those that are done are taken back too ([`Line::take_back`]). Nothing here asks for
//! permission, and nothing prints.

use super::job::Step;
use super::paramfile::head;
use super::transaction::{self, Applied, Plan, UndoFile, UndoPlace};
use super::{Interrupt, Recognised, Session, Terms, Upper, is_over};
use crate::failure::{Class, Failure};
use crate::gate::{Permit, Writing};
use crate::outcome::{LoadEnd, WriteResult};
use crate::profile::Family;
use crate::profile::paramfile::{At, Head};
use crate::text::{Lang, Text, both};
use std::cell::Cell;
use std::rc::Rc;

/// A drive of a plant: who it shall be, what it shall have, and what became of that.
#[derive(Debug)]
pub struct Member<'a> {
    /// Its name.
    pub name: String,
    /// Its address, 1 to 247.
    pub address: u8,
    /// The family that it shall be of.
    pub family: Rc<Family>,
    /// Where its parameter file states that.
    pub family_at: At,
    /// What it shall call itself, if somebody said.
    pub product: Option<String>,
    /// What is known of it without asking.
    pub terms: Terms<'a>,
    /// The values that it shall have, in their order; the plan has them once it was looked at.
    pub steps: Vec<Step>,
    /// Where its undo file is left.
    pub undo: UndoPlace,
    /// The language of its comments.
    pub lang: Lang,
    /// What to do where that place does not take it.
    pub elsewhere: Text,
    /// What to do where another drive stands at its address.
    pub another: Text,
    /// What there is to do, once it was looked at.
    pub found: Option<Found>,
    /// Why nothing was begun with it.
    pub left: Option<Failure>,
    /// What became of its transaction.
    pub applied: Option<Done>,
}

/// A drive that was looked at.
#[derive(Debug)]
pub struct Found {
    /// What there is to do.
    pub plan: Plan,
    head: Head,
}

/// A transaction that is over.
#[derive(Debug)]
pub struct Done {
    /// How it ended.
    pub applied: Applied,
    /// Its undo file, unless nothing was written.
    pub undo_file: Option<UndoFile>,
    /// It was taken back, because another drive failed: a failure for each value that did not come back.
    pub taken_back: Option<Vec<Failure>>,
}

/// What all drives of a plant have in common while they get their values.
#[derive(Debug)]
pub struct Together {
    /// Somebody wishes the end.
    pub interrupt: Interrupt,
    /// All drives, or none.
    pub atomic: bool,
    /// One of them failed, and with it all.
    pub failed: Cell<bool>,
}

/// A line with its drives.
#[derive(Debug)]
pub struct Line<'a> {
    /// The open line; `None` if it could not be opened, and then every drive is left out.
    pub session: Option<Session<'a>>,
    /// Its drives.
    pub members: Vec<Member<'a>>,
}

impl Line<'_> {
    /// Looks at every drive, in turn; each has time for so many questions.
    pub async fn look(&mut self, upper: Upper) {
        let Some(session) = &mut self.session else { return };
        let mut over: Option<Failure> = None;
        for member in &mut self.members {
            let questions = upper.questions(member.steps.len() as u64);
            session.allow(session.now(), questions);
            let looked = match &over {
                Some(failure) => Err(failure.clone()),
                None => member.look(session).await,
            };
            if let Err(failure) = looked {
                over = over.or_else(|| Some(failure.clone()).filter(is_over));
                member.left = Some(failure);
            }
        }
        session.end_at(None);
    }

    /// Looks behind the question at every drive once more, before anything is begun with any; one that may not be written to any
    /// more is left out.
    pub async fn look_again(&mut self) {
        let Some(session) = &mut self.session else { return };
        for member in self.members.iter_mut().filter(|member| member.is_due()) {
            member.turn_to(session);
            let Some(found) = &mut member.found else { continue };
            if let Err(failure) = transaction::still_may(session, &mut found.plan).await {
                member.leave(failure);
            }
        }
    }

    /// Gives every drive its values, in turn. Whatever ends a transaction early, its drive is put back.
    pub async fn apply(&mut self, permit: &Permit<Writing>, together: &Together) {
        let Some(session) = &mut self.session else { return };
        let mut lost: Option<Failure> = None;
        for member in self.members.iter_mut().filter(|member| member.is_due()) {
            let in_the_way = lost.clone().or_else(|| together.in_the_way());
            let begun = match in_the_way {
                Some(failure) => Err(failure),
                None => member.apply(session, permit).await,
            };
            let why = match begun {
                Ok(failures) => failures,
                Err(failure) => {
                    member.leave(failure.clone());
                    vec![failure]
                }
            };
            if let Some(first) = why.into_iter().next() {
                lost = lost.or_else(|| Some(first).filter(|failure| failure.class == Class::Port));
                together.failed.set(true);
            }
        }
    }

    /// Takes back what was done, the last first.
    pub async fn take_back(&mut self, permit: &Permit<Writing>) {
        let Some(session) = &mut self.session else { return };
        session.note_interrupts();
        for member in self.members.iter_mut().rev() {
            member.turn_to(session);
            if let (Some(found), Some(done)) = (&mut member.found, &mut member.applied)
                && matches!(done.applied.ended, LoadEnd::Done | LoadEnd::Stored)
                && let Some(left) = &done.undo_file
            {
                done.taken_back = Some(transaction::take_back(session, &mut found.plan, permit, left).await);
            }
        }
    }
}

impl Together {
    /// Why nothing more is begun.
    fn in_the_way(&self) -> Option<Failure> {
        if self.interrupt.is_raised() {
            let text = both!("interrupted before it was begun", "unterbrochen, bevor er an der Reihe war");
            return Some(Failure::new(Class::Interrupted, "interrupted", text));
        }
        (self.atomic && self.failed.get()).then(|| {
            let text = both!("another drive failed (--atomic)", "ein anderer Antrieb ist gescheitert (--atomic)");
            Failure::new(Class::Forbidden, "forbidden.atomic", text)
        })
    }
}

impl Member<'_> {
    /// Whether there is something to write.
    pub fn is_due(&self) -> bool {
        self.left.is_none() && self.found.as_ref().is_some_and(|found| found.plan.todo() > 0)
    }

    /// Tries whether its undo file can be left: without one nothing may be written.
    ///
    /// # Errors
    /// The folder does not take it.
    pub fn try_undo(&self) -> Result<(), Failure> {
        self.undo.check().map_err(|failure| failure.hint(self.elsewhere.clone()))
    }

    /// Leaves it out: nothing is begun with it.
    pub fn leave(&mut self, why: Failure) {
        let rows = self.found.iter_mut().flat_map(|found| &mut found.plan.job.rows);
        for row in rows.filter(|row| row.result == WriteResult::Planned) {
            row.result = WriteResult::Skipped;
        }
        self.left = Some(why);
    }

    /// From now on the session asks this drive, or the node behind it.
    fn turn_to(&self, session: &mut Session<'_>) {
        session.reach_node(self.terms.speech.node);
    }

    /// The drive at its address, if it is the one that was meant.
    ///
    /// # Errors
    /// Nobody answers, or another drive.
    pub async fn identify(&self, session: &mut Session<'_>) -> Result<Recognised, Failure> {
        self.turn_to(session);
        let mut drive = self.terms.asked(session, self.address, &self.family).await?;
        if self.product.is_some() {
            drive.product = self.terms.product(session, &drive).await?;
        }
        self.must_be_meant(&drive)?;
        Ok(drive)
    }

    async fn look(&mut self, session: &mut Session<'_>) -> Result<(), Failure> {
        let drive = self.identify(session).await?;
        let head = Head { lang: self.lang, ..head(session, &drive) };
        let plan = transaction::plan(session, drive.target, &self.terms, std::mem::take(&mut self.steps)).await?;
        self.found = Some(Found { plan, head });
        Ok(())
    }

    /// Refuses another drive than the one that was meant.
    fn must_be_meant(&self, drive: &Recognised) -> Result<(), Failure> {
        let (address, found) = (self.address, &drive.target.family.drive);
        let failure = |code: &str, message| {
            let failure = Failure::new(Class::Data, code, message).with("address", address).of_family(found);
            failure.hint(self.another.clone())
        };
        let of = &self.family;
        if of.drive != *found {
            let message = both!(
                "{at}: expected a drive of the family {of}, address {address} is of the family {found}",
                "{at}: erwartet wird ein Antrieb der Familie {of}, Adresse {address} ist von der Familie {found}",
                at = self.family_at,
                of = of.drive
            );
            return Err(failure("data.other_family", message));
        }
        let Some(expected) = self.product.as_ref().filter(|of| drive.product.as_ref() != Some(*of)) else {
            return Ok(());
        };
        let message = match &drive.product {
            Some(found) => both!(
                "expected a drive that calls itself '{expected}', address {address} calls itself '{found}'",
                "erwartet wird ein Antrieb, der sich '{expected}' nennt, an Adresse {address} nennt er sich '{found}'"
            ),
            None => both!(
                "expected a drive that calls itself '{expected}', address {address} does not tell what it is",
                "erwartet wird ein Antrieb, der sich '{expected}' nennt, an Adresse {address} nennt er nichts"
            ),
        };
        Err(failure("data.other_drive", message))
    }

    /// Writes what is planned; why it did not end well.
    async fn apply(&mut self, session: &mut Session<'_>, permit: &Permit<Writing>) -> Result<Vec<Failure>, Failure> {
        if self.found.is_some() {
            // While the question stood another drive may have come to its address.
            self.identify(session).await?;
        }
        let Some(Found { plan, head }) = &mut self.found else { return Ok(Vec::new()) };
        let undo_file = self.undo.leave(head, plan).map_err(|failure| failure.hint(self.elsewhere.clone()))?;
        let applied = transaction::apply(session, plan, &self.terms, permit, &undo_file).await;
        let failures = applied.failures.clone();
        let undo_file = undo_file.unless(applied.ended == LoadEnd::Untouched);
        self.applied = Some(Done { applied, undo_file, taken_back: None });
        Ok(failures)
    }
}
