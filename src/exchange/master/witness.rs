//! Answers that are believed only if they are said again.
//!
//! * On a line that mixes up telegrams: a reply that was missing when a fence was answered is lost on a wire, but a radio
//!   link or a gateway may still bring it, in place of the answer to another question.
//! * From a station that has answered one question in two ways: it may be two, each with its own delay.

use super::*;
use crate::exchange::debt::Overtaken;
use crate::exchange::foreign;
use crate::exchange::limits::{MOST_WITNESSES, WITNESSES};

/// So long we keep out of the way of a reply to somebody else; a drive answers in 10 ms (sources A2).
const HIS_REPLY: Span = Span::from_millis(100);

impl Master {
    /// How many missing replies this could be, although a later one has come.
    fn doubles(&self, job: &Job, said: &Said, at: Tick) -> usize {
        let refusable = |missing| !self.known.get(&job.station).is_some_and(|known| known.contains(missing));
        // On a line that keeps the order it came before the answer to the fence, or never.
        let mixes = self.debts.mixes();
        let older = |old: &Overtaken| mixes && job.limits.since.is_some_and(|since| old.since <= since);
        let alike = self.debts.overtaken(job.station, at).filter(|&old| match (&old.missing, said.is_refusal()) {
            (missing, _) if *missing == job.question => older(old),
            (missing, true) => refusable(missing) && self.dialect.refuses_alike(missing, &job.question),
            (missing, false) => self.dialect.confuses(missing, &job.question),
        });
        alike.count()
    }

    /// The same where nothing keeps replies in order: how many may come, and how many answers must agree with this one.
    fn in_disorder(&self, job: &Job, said: &Said, at: Tick) -> (usize, usize) {
        let Some(open) = job.older.filter(|&open| open > 0 && !said.is_refusal()) else { return (0, 0) };
        let same = self.ledger.in_words(self.dialect, job.station, &job.question, said, at);
        (open, same.clamp(1, open))
    }

    /// The answer that is to be believed; `None` if the question is asked once more.
    ///
    /// Values that never stay the same are believed at last where nothing was ever mixed up; elsewhere not before the
    /// missing ones cannot come any more.
    pub(super) fn witnessed(&mut self, at: Tick, said: Said) -> Option<Said> {
        let plain = |job: &&Job| !job.is_fenced() && !job.question.is_write();
        let Some(job) = self.job.as_ref().filter(plain) else {
            return Some(said);
        };
        let doubles = self.doubles(job, &said, at).max(usize::from(self.twins.is_marked(job.station)));
        let (open, alike) = self.in_disorder(job, &said, at);
        let doubles = doubles.min(WITNESSES - 1).max(alike);
        let agree = job.witnesses.iter().filter(|&witness| *witness == said).count();
        if agree >= doubles || self.dialect.is_numbered() {
            return Some(said);
        }
        if !job.limits.witness {
            if !self.debts.mixes() {
                return Some(said);
            }
            // It cannot be asked for again, and what it says may be the answer to something else.
            let error = unproven(&self.twins, job.station, job.asked);
            self.job.as_mut()?.phase = Phase::Done(Err(error));
            return None;
        }
        let more = self.heard.has_surplus(job.station) || self.twins.is_marked(job.station);
        // One value and all that is on its way make no more words than that.
        let may_stay = job.in_how_many_words(&said) <= open + 1 && open > 0;
        let mixed = self.debts.mixes() || (more || may_stay) && job.limits.insist.is_none();
        let most = if job.limits.insist.is_some() { WITNESSES } else { (open + 2).clamp(WITNESSES, MOST_WITNESSES) };
        if job.witnesses.len() + 1 >= most && !mixed {
            let pair = job.witnesses.windows(2).find(|pair| pair.first() == pair.last());
            return Some(pair.and_then(|pair| pair.first()).cloned().unwrap_or(said));
        }
        self.call_witness(at, said, most);
        None
    }

    /// Listens for questions of somebody else in everything that comes, whoever waits for it. Each ends among these bytes; it
    /// may have begun before, also before we asked, because adapters hand telegrams on in pieces.
    pub(super) fn overhear(&mut self, at: Tick, bytes: &[u8]) {
        if self.dialect.is_numbered() {
            return;
        }
        let known = self.stream.len();
        self.stream.extend_from_slice(bytes);
        for end in known + 1..=self.stream.len() {
            let question = self.stream.get(..end).and_then(|heard| {
                foreign::last(self.dialect, heard, |piece| self.sent.iter().any(|sent| sent == piece))
            });
            if let Some((station, question)) = question {
                self.note_foreign(at, station, question);
            }
        }
        let surplus = self.stream.len().saturating_sub(foreign::LONGEST_QUESTION);
        self.stream.drain(..surplus);
    }

    /// Somebody else asks a station: its reply is to come, and none to us.
    fn note_foreign(&mut self, at: Tick, station: u8, question: Question) {
        self.heard.sees_trouble();
        self.others = [Some(at), self.others[0]];
        if station != BROADCAST && !question.is_write() {
            self.debts.owes_another(station, question, at + HIS_REPLY, at);
        }
    }

    fn call_witness(&mut self, at: Tick, said: Said, most: usize) {
        let Some(job) = &mut self.job else { return };
        let latest = self.debts.overtaken(job.station, at).map(Overtaken::until).max();
        job.witnesses.push(said);
        let lacks_one = job.witnesses.len() < most;
        let (parting, phase) = match (lacks_one, latest) {
            (false, _) if job.limits.insist.is_some() || !self.debts.mixes() => {
                (Parting::None, Phase::Done(Err(unproven(&self.twins, job.station, job.asked))))
            }
            (false, Some(latest)) => (Parting::Quiet(latest), Phase::Gap(at)),
            _ => (Parting::None, Phase::Gap(at)),
        };
        job.begins_anew(parting, phase);
        job.wanted = at;
    }
}
