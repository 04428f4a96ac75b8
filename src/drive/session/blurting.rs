//! What is said before anybody knows what the line gives back: a stop, which waits for nothing.

use super::Session;
use crate::drive::access::AccessError;
use crate::drive::probe::sounding;
use crate::exchange::{Answer, INSIST, Question, Said};

impl Session<'_> {
    /// Asks a station although the line may echo: for a stop, which must not wait until that is known. Where what comes back
    /// may be the answer or the echo, `tells` asks something else at once whose echo is no answer; it proves nothing all the same.
    pub(in crate::drive) async fn blurt(
        &mut self,
        station: u8,
        question: Question,
        tells: impl AsyncFnOnce(&mut Self) -> Result<(), AccessError>,
    ) -> Result<Answer, AccessError> {
        let said = self.put(station, question.clone(), self.limits()).await;
        let is_open = said.as_ref().is_err_and(|error| !error.is_fatal());
        if !(is_open && self.line.borrow().master.may_be_answered(station, &question)) {
            return said;
        }
        let patient = self.patient();
        self.end_at(Some(self.now() + patient.reply_timeout + INSIST));
        let told = self.within(patient, tells).await;
        let now = self.now();
        match (self.line.borrow_mut().master.answered_after_all(now), told) {
            (Some(answer), _) => Ok(answer),
            (None, Err(error)) if error.is_fatal() => Err(error),
            (None, _) => said,
        }
    }

    /// Asks what tells whether the line echoes.
    pub(in crate::drive) async fn sound(&mut self, station: u8) -> Result<(), AccessError> {
        self.put(station, sounding().into(), self.limits()).await.map(|_| ())
    }

    /// The answer to a question that had been given up, if it was the last of these that came.
    pub(in crate::drive) fn came_late(&self, station: u8, question: &Question) -> Option<Said> {
        self.line.borrow().master.came_late(station, question).cloned()
    }
}
