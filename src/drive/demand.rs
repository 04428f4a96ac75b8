//! Asking for an answer that is no refusal; after one, for its cause. What tells the cause is cleared by reading.

use super::access::{AccessError, Refusal};
use super::route::{No, Route, no};
use super::session::Session;
use crate::exchange::{Answer, Limits, Question, Said};
use crate::profile::{Cause, Family};
use crate::tick::Span;

/// How long a drive that is busy is left alone before it is asked once more: no source says. A choice.
const BUSY: Span = Span::from_millis(100);

impl Session<'_> {
    /// Asks a drive for an answer that is no refusal; after one asks for the cause at once, because anything else could
    /// overwrite it. A broadcast answers nothing.
    pub async fn demand(
        &mut self,
        route: Route,
        family: &Family,
        question: Question,
    ) -> Result<Option<(Said, Span)>, AccessError> {
        self.demand_within(route, family, question, self.limits()).await
    }

    /// Like [`Session::demand`], within time limits of its own; the cause has the usual ones.
    pub async fn demand_within(
        &mut self,
        route: Route,
        family: &Family,
        question: Question,
        limits: Limits,
    ) -> Result<Option<(Said, Span)>, AccessError> {
        let (said, after) = match self.ask_within(route.address, question, limits).await? {
            Answer::Broadcast => return Ok(None),
            Answer::Reply { said, after } => (said, after),
        };
        let Some(no) = no(&said) else { return Ok(Some((said, after))) };
        let (cause, unheard) = match route.cause(family, no) {
            Some(question) => self.cause(route, family, question).await?,
            None => (no.cause(), false),
        };
        // 0 is "nothing was refused": the register belongs to something else, or there is none.
        Err(AccessError::Refused(Refusal { no, cause: cause.filter(|&cause| cause != 0), unheard, taken: None }))
    }

    /// Before the first write to a station, what an earlier master has left there: a drive that has refused takes no write until it
    /// was asked why (VABus; facts: seed 002), and would give that old cause for ours. What must not wait finds it out itself.
    pub(super) async fn unlock(&mut self, route: Route, family: &Family) -> Result<(), AccessError> {
        let Some(question) = route.unlocks(family).filter(|_| !self.is_insisting()) else { return Ok(()) };
        if self.is_unlocked(route.address) {
            return Ok(());
        }
        match self.ask_once(route, question).await {
            Ok(_) => self.notes_unlocked(route.address),
            // It may have been lost: the next write asks again.
            Err(AccessError::Exchange(_)) => {}
            Err(error) => return Err(error),
        }
        Ok(())
    }

    /// Asks why the drive said no, and tells whether the answer was lost.
    async fn cause(
        &mut self,
        route: Route,
        family: &Family,
        question: Question,
    ) -> Result<(Option<u16>, bool), AccessError> {
        let answer = match family.link.cause {
            Cause::ErrorRegister => match self.ask_once(route, question.clone()).await {
                Ok(Answer::Reply { said, .. }) if no(&said).is_some() => {
                    return self.cause_again(route, question).await;
                }
                answer => answer,
            },
            // It stands until the next one. A witness may be refused, and be the next one.
            Cause::Diagnostics(_) => {
                let limits = Limits { witness: false, ..self.limits() };
                self.ask_within(route.address, question, limits).await
            }
        };
        match answer {
            Ok(Answer::Reply { said, .. }) => Ok((route.number(&said), false)),
            Ok(Answer::Broadcast) => Ok((None, false)),
            Err(AccessError::Exchange(_)) => Ok((None, true)),
            Err(error) => Err(error),
        }
    }

    /// The register was refused, or what was refused is something older. Asked once more it tells which: whoever answers then
    /// has it, and has cleared it.
    async fn cause_again(&mut self, route: Route, question: Question) -> Result<(Option<u16>, bool), AccessError> {
        match self.ask_once(route, question).await {
            Ok(Answer::Reply { said, .. }) if no(&said).is_none() => {
                let cause = route.number(&said).filter(|&cause| cause != 0);
                Ok((cause, cause.is_none()))
            }
            Ok(_) => Ok((None, false)),
            Err(AccessError::Exchange(_)) => Ok((None, true)),
            Err(error) => Err(error),
        }
    }

    /// Leaves a drive that is busy alone for a moment, and tells whether it is to be asked once more: that says nothing of what it was
    /// asked (V1.1b3 7). Not for ever, and not where every telegram goes out by the clock.
    pub(super) async fn bears(&mut self, error: &AccessError, asked: u8) -> Result<bool, AccessError> {
        self.waits(error.passes(), asked).await
    }

    /// Asks a station that may be busy, like [`Session::ask`].
    pub(super) async fn ask_patiently(&mut self, station: u8, question: &Question) -> Result<Answer, AccessError> {
        let mut asked = 0;
        loop {
            asked += 1;
            let answer = self.ask(station, question.clone()).await?;
            let is_busy = matches!(&answer, Answer::Reply { said, .. } if no(said).is_some_and(No::passes));
            if !self.waits(is_busy, asked).await? {
                return Ok(answer);
            }
        }
    }

    async fn waits(&mut self, is_busy: bool, asked: u8) -> Result<bool, AccessError> {
        let is_borne = is_busy && asked <= self.limits().retries && !self.is_insisting() && !self.is_over();
        if is_borne {
            // Seldom, and asked for in every read: on the heap it makes none of them larger.
            Box::pin(self.rest(BUSY)).await?;
        }
        Ok(is_borne)
    }

    /// Asks for a 16-bit number; `None` if the station answers with something else.
    pub(super) async fn number(&mut self, route: Route, question: Question) -> Result<Option<u16>, AccessError> {
        match self.ask(route.address, question).await {
            Ok(Answer::Reply { said, .. }) => Ok(route.number(&said)),
            Ok(Answer::Broadcast) | Err(AccessError::Exchange(_)) => Ok(None),
            Err(error) => Err(error),
        }
    }

    /// Asks for what is gone once it has been read: once, because asked again it would say that nothing has happened, and
    /// as patiently as one repeat would be, for a slow drive. What comes later still is an older answer as likely as this
    /// one. An answer that is lost, or may be another's, is an error: what was there then is not known.
    pub(super) async fn ask_once(&mut self, route: Route, question: Question) -> Result<Answer, AccessError> {
        let limits = self.limits();
        let reply_timeout = limits.reply_timeout.times(u64::from(limits.retries.min(1)) + 1);
        self.ask_within(route.address, question, Limits { witness: false, retries: 0, reply_timeout, ..limits }).await
    }
}
