//! The answer has come: whether it is taken for what it says, or asked for once more.

use super::*;

/// Harmless questions that are remembered of every station, to part replies by.
const MOST_KNOWN: usize = 4;

impl Master {
    /// The answer has come: to the fence, then the question goes out; or to the question, then it is over.
    pub(super) fn take(&mut self, at: Tick, sent_end: Tick, said: Said) {
        self.tally.replies += 1;
        self.tally.waited = self.tally.waited + at.since(sent_end);
        self.tally.exceptions += u64::from(said.is_refusal());
        if let Some(job) = self.job.as_ref().filter(|job| job.doubted && !job.is_fenced()) {
            // Two telegrams came: the second may be another's who answered just now.
            let last = self.answered.as_ref().filter(|(_, _, then)| at.since(*then) < COPY_WITHIN);
            let stations = [Some(job.station), last.map(|last| last.0)];
            stations.into_iter().flatten().for_each(|station| self.suspect(station, at));
        }
        if self.may_be_old(&said, at) {
            return self.ask_behind_fence(at, sent_end + LATEST_REPLY);
        }
        let is_again = self.is_said_again(&said, at);
        if self.is_doubted(&said, at) && !is_again {
            self.doubt(said, at);
            let due = if self.is_suspected(at) { sent_end + LATEST_REPLY } else { at };
            return self.ask_behind_fence(at, due);
        }
        if let Some(job) = self.job.as_ref().filter(|job| !job.is_fenced())
            && let Some(first) = &job.first
        {
            // Behind the fence it was answered once: what was doubted is no reply that is still to come.
            self.debts.forgives(job.station, &job.question, first.since);
        }
        if self.is_suspected(at) {
            return self.count(at, sent_end, said);
        }
        if self.listens() {
            return self.await_second(at, sent_end, said);
        }
        self.settle(at, sent_end, said);
    }

    /// Whether this answer could be a late one to something else.
    fn may_be_old(&self, said: &Said, at: Tick) -> bool {
        let Some(job) = self.job.as_ref().filter(|job| !job.is_fenced()) else { return false };
        let since = job.limits.since.filter(|_| !job.question.is_write() && !self.dialect.is_numbered());
        if since.is_some_and(|since| self.debts.is_missing(job.station, &job.question, since, at)) {
            return true;
        }
        // What was answered by a value before is not refused.
        let refusable = |missing| !self.known.get(&job.station).is_some_and(|known| known.contains(missing));
        let missing = self.debts.missing(job.station);
        missing.iter().any(|missing| match said.is_refusal() {
            true => refusable(missing) && self.dialect.refuses_alike(missing, &job.question),
            false => self.dialect.confuses(missing, &job.question),
        })
    }

    /// Whether the answer came behind garbage as long as a telegram, and does not name what it answers.
    fn is_doubted(&self, said: &Said, at: Tick) -> bool {
        let names = self.dialect.names_its_question() && !said.is_refusal();
        let garbled = |job: &Job| job.doubted && !names && !job.question.is_write() && !self.is_vouched(job, at);
        let doubted = |job: &Job| !job.is_fenced() && (job.again || garbled(job));
        !self.dialect.is_numbered() && self.job.as_ref().is_some_and(doubted)
    }

    /// Whether garbage before an answer is known to be only garbage. Who may be two drives is not believed by that, but where
    /// what is asked must go on. Beside another master it may be his question, which met ours.
    pub(super) fn is_vouched(&self, job: &Job, at: Tick) -> bool {
        let is_vouched = match job.limits.insist {
            Some(_) => self.twins.has_vouched(job.station),
            None => self.twins.is_vouched(job.station),
        };
        is_vouched && !self.is_shared(at)
    }

    /// Whether an answer was doubted for how it came, and this is the same once more: then it is the answer, and so late does
    /// the station answer. Who asks the same again and again beside us is answered the same again and again.
    fn is_said_again(&mut self, said: &Said, at: Tick) -> bool {
        let is_shared = self.is_shared(at);
        let Some(job) = self.job.as_ref().filter(|job| !(job.is_fenced() || is_shared && job.doubted)) else {
            return false;
        };
        let Some(first) = job.first.as_ref().filter(|first| first.said == *said) else { return false };
        self.heard.learn(job.station, job.question.function(), first.after);
        if first.noisy {
            self.twins.vouches(job.station);
        }
        if first.again {
            self.heard.vouches(job.station);
        }
        true
    }

    /// Remembers an answer that is doubted for how it came, and how late that was.
    fn doubt(&mut self, said: Said, since: Tick) {
        let Some(job) = &mut self.job else { return };
        let Phase::Reply(Waiting { sent_end, last, .. }) = &job.phase else { return };
        let after = i64::try_from(last.since(*sent_end).as_micros()).unwrap_or(i64::MAX);
        job.first = Some(Doubted { said, since, after, noisy: job.noisy || job.doubted, again: job.again });
    }

    /// The answer is the only one that comes, or the second one has come as well.
    pub(super) fn settle(&mut self, at: Tick, sent_end: Tick, said: Said) {
        let Some(said) = self.witnessed(at, said) else { return };
        let Some(job) = &mut self.job else { return };
        self.debts.hears(job.station);
        match std::mem::replace(&mut job.parting, Parting::None) {
            Parting::Fence(fence, _) => self.pass(&fence, at, sent_end),
            _ => self.end(at, sent_end, said),
        }
    }

    /// Behind the fence: everything older has come, and the question itself goes out.
    fn pass(&mut self, fence: &Question, at: Tick, sent_end: Tick) {
        let Some(job) = &mut self.job else { return };
        let Phase::Reply(Waiting { sent_at, .. }) = job.phase else { return };
        self.debts.settle(job.station, sent_at, at);
        // Of a fence that was asked more than once further replies may come.
        for _ in 1..job.same_fence {
            self.debts.owes(job.station, fence.clone(), sent_end + LATEST_REPLY, at);
        }
        (job.kept, job.asked, job.patient) = (false, 0, false);
        job.phase = Phase::Gap(at);
        let (station, question, since) = (job.station, job.question.clone(), job.limits.since);
        // Somebody else may have asked it since.
        let parting = self.parting(station, &question, since, at);
        if let Some(job) = &mut self.job {
            job.parting = parting;
        }
    }

    /// The question is answered.
    fn end(&mut self, at: Tick, sent_end: Tick, said: Said) {
        let Some(job) = &mut self.job else { return };
        if said.is_unreached() {
            self.tally.silences += 1;
            let again = self.reached.contains(&job.station) && !job.asks().is_write() && job.asked <= UNREACHED_REPEATS;
            job.phase = if again { Phase::Gap(at) } else { Phase::Done(Err(ExchangeError::Unreached)) };
            return;
        }
        self.reached.insert(job.station);
        if job.asked == 1 && at.since(sent_end) < job.limits.reply_timeout.min(LATEST_REPLY) {
            self.heard.sees_prompt(job.station);
        }
        if !said.is_refusal() && job.question.is_harmless() {
            let known = self.known.entry(job.station).or_default();
            known.retain(|known| *known != job.question);
            // The first of all stays: in a long reading the others were answered a moment ago.
            if known.len() == MOST_KNOWN {
                known.remove(MOST_KNOWN - 2);
            }
            known.insert(0, job.question.clone());
        }
        self.ledger.is_told(job.station, &job.question, &said);
        self.answered = Some((job.station, job.question.clone(), at));
        let outcome = Ok(Answer::Reply { said, after: at.since(sent_end) });
        let by = at + self.dialect.gap(self.line, job.limits.pause).times(2);
        job.phase =
            if self.dialect.farewell().is_empty() { Phase::Done(outcome) } else { Phase::Farewell(outcome, by) };
    }
}
