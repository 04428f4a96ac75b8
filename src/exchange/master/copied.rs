//! What comes back once of a write whose answer is made of the same bytes, while nobody knows whether the adapter echoes: it is the
//! one or the other, until an answer that can be no echo tells.

use super::*;

/// A write of ours that came back once.
#[derive(Clone, Debug)]
pub(super) struct Copied {
    station: u8,
    question: Question,
    said: Said,
    sent_end: Tick,
    at: Tick,
}

impl Master {
    /// Whether what came back of this question last is its answer, if the line does not echo.
    pub fn may_be_answered(&self, station: u8, question: &Question) -> bool {
        self.copied.as_ref().is_some_and(|copied| (copied.station, &copied.question) == (station, question))
    }

    /// The answer that came to what [`Master::may_be_answered`] tells of, if something else that was asked since shows that the
    /// line does not echo. A line that echoes now and then may deceive here: that a word is obeyed, only the state proves.
    pub fn answered_after_all(&mut self, now: Tick) -> Option<Answer> {
        let copied = self.copied.take()?;
        if self.echo != Echo::Absent || self.echoed {
            self.tally.silences += 1;
            return None;
        }
        self.debts.pays(copied.station, &copied.said, now);
        let after = copied.at.since(copied.sent_end);
        self.tally.replies += 1;
        self.tally.waited = self.tally.waited + after;
        Some(Answer::Reply { said: copied.said, after })
    }

    /// Our telegram came back, and no answer behind it. Whether it may be the answer itself.
    pub(super) fn comes_back(&mut self, at: Tick, sent: &[u8]) -> bool {
        let copied = self.copied_by(sent);
        if copied.is_none() {
            self.echo = Echo::Present;
            self.note_echo(at, sent);
            return false;
        }
        self.copied = copied;
        self.record(Record { at, verdict: Verdict::Copy, bytes: sent.to_vec() });
        true
    }

    fn copied_by(&self, sent: &[u8]) -> Option<Copied> {
        let job = self.job.as_ref().filter(|job| !job.is_fenced() && job.question.is_write())?;
        let Phase::Reply(waiting) = &job.phase else { return None };
        let said = self.dialect.find(sent, job.station, &job.question)?.said;
        let (sent_end, at) = (waiting.sent_end, waiting.last);
        let is_echo = self.echo.is_known() || self.is_too_soon(&self.sample(job, sent_end, sent, at));
        (!is_echo).then(|| Copied { station: job.station, question: job.question.clone(), said, sent_end, at })
    }

    /// What must not wait for a busy line waits for no answer behind what may be it either: something else is asked that tells.
    pub(super) fn leaves_open(&mut self, now: Tick) -> Option<Step<Outcome>> {
        let job = self.job.as_ref().filter(|job| job.limits.insist.is_some() && job.asked > job.limits.retries)?;
        let Phase::Reply(waiting) = &job.phase else { return None };
        let (station, question, due) = (job.station, job.question.clone(), waiting.sent_end + LATEST_REPLY);
        let error = ExchangeError::Silence { timeout: job.limits.reply_timeout, asked: job.asked };
        self.debts.owes(station, question, due, now);
        Some(self.finish(Err(error)))
    }
}
