//! Answers that are believed only if they are said again.
//!
//! * On a line that mixes up telegrams: a reply that was missing when a fence was answered is lost on a wire, but a radio
//!   link or a gateway may still bring it, in place of the answer to another question.
//! * From a station that has answered one question in two ways: it may be two, each with its own delay.
//! * Behind garbage as long as a telegram: two replies may have met, and the second is to something else.

use super::*;
use crate::exchange::debt::Overtaken;
use crate::exchange::limits::WITNESSES;
use crate::exchange::survey::foreign;

impl Master {
    /// How many missing replies this could be, although a later one has come.
    fn doubles(&self, job: &Job, said: &Said, at: Tick) -> usize {
        let refusable = |missing| !self.known.get(&job.station).is_some_and(|known| known.contains(missing));
        let older = |old: &Overtaken| job.limits.since.is_some_and(|since| old.since <= since);
        let alike = self.debts.overtaken(job.station, at).filter(|&old| match (&old.missing, said.is_refusal()) {
            (missing, _) if *missing == job.question => older(old),
            (missing, true) => refusable(missing) && self.dialect.refuses_alike(missing, &job.question),
            (missing, false) => self.dialect.confuses(missing, &job.question),
        });
        alike.count()
    }

    /// The answer that is to be believed; `None` if the question is asked once more.
    ///
    /// Values that never stay the same are believed at last where nothing was ever mixed up; elsewhere not before the
    /// missing ones cannot come any more.
    pub(super) fn witnessed(&mut self, at: Tick, said: Said) -> Option<Said> {
        let plain = |job: &&Job| !job.is_fenced() && !job.question.is_write() && job.limits.witness;
        let Some(job) = self.job.as_ref().filter(plain) else {
            return Some(said);
        };
        let doubles = self.doubles(job, &said, at).max(usize::from(job.doubted || self.heard.has_twins(job.station)));
        let agree = job.witnesses.iter().filter(|&witness| *witness == said).count();
        if agree >= doubles.min(WITNESSES - 1) || self.dialect.is_numbered() {
            return Some(said);
        }
        if job.witnesses.len() + 1 >= WITNESSES && !self.debts.mixes() {
            let pair = job.witnesses.windows(2).find(|pair| pair.first() == pair.last());
            return Some(pair.and_then(|pair| pair.first()).cloned().unwrap_or(said));
        }
        self.call_witness(at, said);
        None
    }

    /// The question of somebody else that ends where an answer starts.
    pub(super) fn foreign_before(&self, waiting: &Waiting, start: usize) -> Option<(u8, Question)> {
        let before = waiting.came.get(..start)?;
        let begins = (1..=before.len().min(foreign::LONGEST_QUESTION)).filter_map(|len| before.get(start - len..));
        let asked = |piece: &[u8]| foreign::question(self.protocol(), piece).filter(|_| piece != waiting.sent);
        begins.filter(|piece| piece.len() > 3).find_map(asked)
    }

    /// Somebody else asks a station: its reply is to come, and none to us.
    pub(super) fn note_foreign(&mut self, at: Tick, bytes: &[u8]) {
        let ours = self.job.as_ref().is_some_and(|job| match &job.phase {
            Phase::Reply(waiting) => waiting.sent == bytes,
            _ => false,
        });
        let Some((station, question)) = foreign::question(self.protocol(), bytes).filter(|_| !ours) else { return };
        if station == BROADCAST || question.is_write() || self.dialect.is_numbered() || self.echo == Echo::Present {
            return;
        }
        self.debts.owes(station, question, at + LATEST_REPLY, at);
    }

    fn call_witness(&mut self, at: Tick, said: Said) {
        let Some(job) = &mut self.job else { return };
        let latest = self.debts.overtaken(job.station, at).map(|old| old.since + LATEST_OF_ALL).max();
        job.witnesses.push(said);
        let lacks_one = job.witnesses.len() < WITNESSES;
        (job.parting, job.phase) = match (lacks_one, latest) {
            (false, _) if job.limits.insist.is_some() => {
                (Parting::None, Phase::Done(Err(ExchangeError::Unproven { asked: job.asked })))
            }
            (false, Some(latest)) => (Parting::Quiet(latest), Phase::Gap(at)),
            _ => (Parting::None, Phase::Gap(at)),
        };
        (job.asked, job.same_fence, job.echoed, job.patient, job.wanted) = (0, 0, false, false, at);
        job.doubted = false;
    }
}
