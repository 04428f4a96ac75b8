//! No answer has come: what came in its place, and whether it is asked again.

use super::*;

impl Master {
    /// The line has been silent for long enough, or the time is over: name what came, then wait on, repeat or end.
    pub(super) fn look(&mut self, now: Tick) -> Step<Outcome> {
        if let Some(step) = self.decide(now) {
            return step;
        }
        let Some(Job { phase: Phase::Reply(waiting), .. }) = &mut self.job else { return Step::Wait(now) };
        let (came, sent, deadline) = (std::mem::take(&mut waiting.came), waiting.sent.clone(), waiting.deadline);
        let restless = !came.is_empty() && now < waiting.last + self.dialect.straggle(&came);
        let (rest, is_open) = self.judge(now, &came, &sent);
        if let Some(step) = is_open.then(|| self.leaves_open(now)).flatten() {
            return step;
        }
        let Some(Job { phase: Phase::Reply(waiting), station, .. }) = &mut self.job else { return Step::Wait(now) };
        waiting.echoed |= rest.len() < came.len();
        // Garbage as long as a reply most likely was the reply.
        let mut is_spoilt = false;
        for (piece, bytes) in ear::pieces(self.dialect, rest) {
            let short = self.dialect.shortness(bytes);
            match piece {
                Piece::Stray(of, _) if of == *station && short.is_some() => {
                    is_spoilt = true;
                    waiting.short = short;
                }
                Piece::Stray(station, _) => waiting.stray = Some(station),
                _ => {
                    is_spoilt |= bytes.len() >= self.dialect.shortest_reply();
                    waiting.garbage = bytes.to_vec();
                }
            }
        }
        // Behind an echo, a stray telegram or a little noise the reply may still come.
        if now < deadline && (!is_spoilt || waiting.held.is_some()) {
            return Step::Wait(deadline);
        }
        let (stray, short, echoed) = (waiting.stray, waiting.short, waiting.echoed);
        let garbage = std::mem::take(&mut waiting.garbage);
        let due = (!is_spoilt).then_some(waiting.sent_end + LATEST_REPLY);
        let Some(job) = &mut self.job else { return Step::Wait(now) };
        job.echoed |= echoed;
        let asked = job.asked;
        let error = match (stray, short) {
            _ if restless => ExchangeError::NeverSilent { asked },
            (_, Some(bytes)) => ExchangeError::Short { asked, bytes },
            _ if !garbage.is_empty() => ExchangeError::Garbled { asked, bytes: garbage },
            (Some(station), _) => ExchangeError::Stray { station },
            (None, _) => ExchangeError::Silence { timeout: job.limits.reply_timeout, asked },
        };
        self.miss(now, due, error)
    }

    /// Notes bytes that hold no answer; what stands behind our own echo, and whether that may be the answer itself.
    fn judge<'c>(&mut self, at: Tick, came: &'c [u8], sent: &[u8]) -> (&'c [u8], bool) {
        let rest = self.dialect.behind_echo(came, sent);
        let is_open = rest.len() < came.len() && self.comes_back(at, sent) && rest.is_empty();
        self.note_stray(at, rest);
        (rest, is_open)
    }

    /// No answer came: repeat, or end. What came may have been it: then nothing is due.
    fn miss(&mut self, now: Tick, due: Option<Tick>, error: ExchangeError) -> Step<Outcome> {
        let Some(job) = &self.job else { return Step::Wait(now) };
        let station = job.station;
        if matches!(error, ExchangeError::Silence { .. }) {
            self.heard.misses(station, job.limits.reply_timeout);
        }
        let old = self.debts.due(station).map_or(now + LATEST_OF_ALL, |(_, end)| end);
        match job.is_fenced() {
            true => self.debts.owes_fence(station, job.asks().clone(), now),
            false => match due {
                Some(due) => self.debts.owes(station, job.asks().clone(), due, now),
                None => self.debts.may_owe(station, job.asks(), now),
            },
        }
        match error {
            ExchangeError::Silence { .. } => self.tally.silences += 1,
            _ => self.tally.garbled += 1,
        }
        self.note_lost(station, now);
        let Some(job) = &self.job else { return Step::Wait(now) };
        let another = job.is_fenced().then(|| self.fence(station, &job.question)).flatten();
        let another = another.filter(|fence| !self.dialect.may_stand_still(fence));
        let Some(job) = &mut self.job else { return Step::Wait(now) };
        job.phase = Phase::Gap(now);
        if let Some(another) = another {
            // Another fence each time, where there is one: its answer is told from those that are late.
            let is_the_same = *job.asks() == another;
            job.same_fence = if is_the_same { job.same_fence } else { 0 };
            job.parting = Parting::Fence(another, now);
        }
        if job.asked <= job.limits.retries {
            return self.step(now);
        }
        if !job.is_fenced() {
            return self.finish(Err(error));
        }
        if job.heard && !job.echoed && !job.patient && job.limits.insist.is_none() {
            job.patient = true; // it is there, and late
            return self.step(now);
        }
        if job.echoed || now >= old {
            // A station that cannot be parted by fences; time does it.
            (job.parting, job.asked) = (Parting::Until(old), 0);
            return self.step(now);
        }
        self.finish(Err(error))
    }
}
