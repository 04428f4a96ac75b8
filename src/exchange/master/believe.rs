//! Whether what has the form of the answer is the answer.

use super::*;
use crate::exchange::job::Held;

impl Master {
    /// The answer to what was asked, if it has come and is to be believed, and when the question was out.
    pub(super) fn found(&mut self, at: Tick) -> Option<(Tick, Said)> {
        let mut from = 0;
        loop {
            let job = self.job.as_ref()?;
            let Phase::Reply(waiting) = &job.phase else { return None };
            let found = self.dialect.find(waiting.came.get(from..)?, job.station, job.asks())?;
            let (start, end) = (from + found.start, from + found.end);
            if begins_as_echo(waiting, start, end)
                || self.is_echo(waiting, start)
                || !self.proves(job, &found.said, waiting.has_echoed(start))
            {
                from = start + 1;
                continue;
            }
            let bytes = waiting.came.get(start..end)?.to_vec();
            let noise = waiting
                .came
                .get(..start)
                .is_some_and(|before| !self.dialect.behind_echo(before, &waiting.sent).is_empty());
            let noisy = noise || !waiting.garbage.is_empty();
            let doubtful = noisy && !self.is_vouched(job, at);
            let another = waiting.came.get(end..).and_then(|rest| self.dialect.find(rest, job.station, job.asks()));
            let weight = match self.weigh(job, waiting.sent_end, &bytes, at, doubtful) {
                // Two in one piece: the other is looked at first.
                Some(Weight::Answer) if another.is_some_and(|other| other.said != found.said) => {
                    Some(Weight::Wait(Span::ZERO))
                }
                weight => weight,
            };
            let is_one = matches!(weight, Some(Weight::Answer | Weight::Wait(_) | Weight::Again));
            let rivals = is_one && self.rivals(at, &bytes);
            match weight {
                Some(Weight::Answer | Weight::Again) if !rivals => {
                    let job = self.job.as_mut()?;
                    (job.again, job.noisy) = (weight == Some(Weight::Again), noisy);
                    return self.accept(at, start, end, found.said);
                }
                Some(_) if rivals => self.hold(at, start, end, found.said, Some(Weight::Answer)),
                weight => self.hold(at, start, end, found.said, weight),
            }
            from = 0;
        }
    }

    /// Whether this answer can be no older one; that matters for a fence only. `behind_echo`: our own telegram stands before
    /// it, so it is not that.
    fn proves(&self, job: &Job, said: &Said, behind_echo: bool) -> bool {
        match &job.parting {
            Parting::Fence(fence, _) => {
                let may_echo = (self.echoed || self.echo != Echo::Absent) && !behind_echo;
                self.dialect.settles(fence, said, &self.debts.missing(job.station), may_echo)
            }
            _ => true,
        }
    }

    /// Whether what stands at `from` is what we sent, and may have been given back by the adapter.
    fn is_echo(&self, waiting: &Waiting, from: usize) -> bool {
        let seen = waiting.has_echoed(from);
        let same = waiting.came.get(from..).is_some_and(|rest| rest.starts_with(&waiting.sent));
        same && !seen && self.echo != Echo::Absent
    }

    /// `None`: it cannot be the answer.
    fn weigh(&self, job: &Job, sent_end: Tick, bytes: &[u8], at: Tick, doubtful: bool) -> Option<Weight> {
        if self.dialect.is_numbered() {
            return Some(Weight::Answer);
        }
        let sample = self.sample(job, sent_end, bytes, at);
        if self.is_too_soon(&sample) {
            return None;
        }
        if job.is_fenced() {
            // Where everything that is known was answered a moment ago, there is no other fence.
            let is_copy = self.heard.is_copy(at, bytes) && self.heard.may_bring_copies(job.station);
            return (!is_copy).then_some(Weight::Answer);
        }
        Some(self.heard.weigh(&sample, doubtful))
    }

    /// Whether this came sooner than question, reply and the silence between them allow on a line of wires.
    pub(super) fn is_too_soon(&self, sample: &Sample<'_>) -> bool {
        let least = self.dialect.least_turnaround(self.line).as_micros();
        self.wired && sample.after + SLACK_US < i64::try_from(least).unwrap_or(0)
    }

    pub(super) fn sample<'a>(&self, job: &'a Job, sent_end: Tick, bytes: &'a [u8], at: Tick) -> Sample<'a> {
        let micros = |tick: Tick| i64::try_from(tick.as_micros()).unwrap_or(i64::MAX);
        let reply = i64::try_from(self.dialect.duration(self.line, bytes.len()).as_micros()).unwrap_or(0);
        let (question, function) = (job.asks(), job.asks().function());
        let again = job.limits.witness && !question.is_write();
        let hastens = job.limits.hastens || job.limits.gives_way || job.limits.insist.is_some();
        let named = self.dialect.names_its_question();
        let after = micros(at) - micros(sent_end) - reply;
        let confused = self.answered.as_ref().is_some_and(|(station, last, then)| {
            *station == job.station && at.since(*then) < COPY_WITHIN && self.dialect.confuses(last, question)
        });
        Sample { station: job.station, function, question, bytes, at, after, again, confused, hastens, named }
    }

    /// Whether another answer to the same question came before, in other words, and was no copy.
    fn rivals(&mut self, at: Tick, bytes: &[u8]) -> bool {
        let Some(Job { phase: Phase::Reply(waiting), station, .. }) = &mut self.job else { return false };
        let Some(held) = waiting.held.as_mut().filter(|held| held.bytes != bytes) else { return false };
        if matches!(held.weight, Weight::Copy(_) | Weight::Rival | Weight::Stale(_)) {
            return false;
        }
        (held.weight, held.until) = (Weight::Rival, waiting.deadline);
        // One of the two may have been overtaken: that makes no second drive.
        match self.debts.arrives(*station, &held.said, held.at) {
            true => self.twins.suspects(*station),
            false => self.twins.marks(*station, at),
        }
        self.heard.sees_surplus(*station);
        true
    }

    /// Takes the answer out of what has come; what stands before it is an echo or nobody's, and so is what follows.
    fn accept(&mut self, at: Tick, start: usize, end: usize, said: Said) -> Option<(Tick, Said)> {
        let Some(Job { phase: Phase::Reply(waiting), .. }) = &mut self.job else { return None };
        let (came, sent, sent_end) = (std::mem::take(&mut waiting.came), waiting.sent.clone(), waiting.sent_end);
        let (held, echoed, garbage) = (waiting.held.take(), waiting.echoed, std::mem::take(&mut waiting.garbage));
        let (before, rest) = came.split_at_checked(start)?;
        let (reply, behind) = rest.split_at_checked(end - start)?;
        if !echoed {
            self.echo.learn(&sent, before);
        }
        let doubted = self.is_doubtful(at, before, &garbage, &sent);
        if let Some(job) = &mut self.job {
            job.doubted = doubted;
        }
        self.note_before(at, before, &sent);
        if let Some(held) = held {
            self.note_stray(held.at, &held.bytes);
        }
        let is_sure = self.job.as_ref().is_some_and(|job| !job.again);
        self.reply(at, sent_end, reply, is_sure);
        if !behind.is_empty() {
            // Nothing follows an answer but what somebody else says.
            if let Some(station) = self.job.as_ref().map(|job| job.station) {
                self.suspect(station, at);
            }
            self.loose.hears(at, behind);
        }
        Some((sent_end, said))
    }

    /// Whether garbage as long as a telegram came before an answer: two telegrams may have met, and the one that came whole is
    /// to something else. What is left of ours and another master's may be shorter.
    fn is_doubtful(&self, at: Tick, before: &[u8], garbage: &[u8], sent: &[u8]) -> bool {
        let noise = before.strip_suffix(sent).unwrap_or(before);
        let noise = if self.dialect.sender(noise).is_some() { 0 } else { noise.len() };
        let least = if self.is_alone(at) { self.dialect.shortest_reply() } else { 1 };
        noise.max(garbage.len()) >= least
    }

    fn reply(&mut self, at: Tick, sent_end: Tick, bytes: &[u8], is_sure: bool) {
        if let Some(job) = self.job.take() {
            let sample = self.sample(&job, sent_end, bytes, at);
            self.heard.note(at, bytes, Some(sample.question));
            self.heard.awaits_copy(sample.station, at);
            if is_sure && !job.is_fenced() {
                self.heard.learn(sample.station, sample.function, sample.after);
            }
            self.job = Some(job);
        }
        self.replied_at = Some(at);
        self.record(Record { at, verdict: Verdict::Reply, bytes: bytes.to_vec() });
    }

    /// Keeps an answer that is not sure, or throws one away that is none.
    fn hold(&mut self, at: Tick, start: usize, end: usize, said: Said, weight: Option<Weight>) {
        let Some(Job { phase: Phase::Reply(waiting), .. }) = &mut self.job else { return };
        let bytes: Vec<u8> = waiting.came.drain(..end).collect();
        let (before, reply) = bytes.split_at(start.min(bytes.len()));
        let (sent, echoed, garbage) = (waiting.sent.clone(), waiting.echoed, waiting.garbage.clone());
        waiting.echoed |= before.ends_with(&sent);
        let doubted = self.is_doubtful(at, before, &garbage, &sent);
        let Some(Job { phase: Phase::Reply(waiting), limits, .. }) = &mut self.job else { return };
        let length = self.dialect.duration(self.line, reply.len());
        let usual = |span| (waiting.sent_end + span + length).min(waiting.deadline).max(at);
        let until = match weight {
            Some(Weight::Wait(span) | Weight::Stale(span)) => usual(span),
            // Others wait: as long as the true one usually takes.
            Some(Weight::Copy(span)) if limits.gives_way => usual(span),
            _ => waiting.deadline,
        };
        let held = weight.map(|weight| Held { said, bytes: reply.to_vec(), at, weight, doubted, until });
        let other = match (&held, &waiting.held) {
            // The same once more: the first stays.
            (Some(new), Some(old)) if old.bytes == new.bytes || new.weight == Weight::Answer => None,
            // What was heard before does not take the place of what is new.
            (Some(_), Some(Held { weight: Weight::Wait(_), .. })) => None,
            (Some(_), _) => std::mem::replace(&mut waiting.held, held),
            (None, _) => None,
        };
        let kept = waiting.held.as_ref().is_some_and(|kept| kept.at == at && kept.bytes == reply);
        if !echoed {
            self.note_before(at, before, &sent);
        }
        if let Some(other) = other {
            self.note_stray(other.at, &other.bytes);
        }
        if !kept {
            self.note_stray(at, reply);
        }
    }

    /// The time is over for an answer that was not sure: it is believed, or the question is asked anew when no copy of anything
    /// can come any more.
    pub(super) fn decide(&mut self, now: Tick) -> Option<Step<Outcome>> {
        let job = self.job.as_mut()?;
        let Phase::Reply(waiting) = &mut job.phase else { return None };
        let held = waiting.held.take_if(|held| now >= held.until)?;
        let (sent_end, station, question) = (waiting.sent_end, job.station, job.question.clone());
        // What came behind it and is no telegram may have been the other one.
        let behind = std::mem::take(&mut waiting.came);
        let is_left = !behind.is_empty() || !waiting.garbage.is_empty();
        let spoilt = behind.len() >= self.dialect.shortest_reply();
        if !behind.is_empty() {
            self.loose.hears(waiting.last, &behind);
        }
        let is_sure = matches!(held.weight, Weight::Wait(_));
        // Sooner than ever, on a line that is known to bring more than was asked for, or as another answer, with pieces beside it that may be
        // what an adapter has handed over of the true one: once more, then it is believed.
        let is_anothers = self.heard.is_anothers(held.at, &held.bytes, job.asks());
        let is_doubted = is_sure && (self.heard.has_surplus(station) || is_left && is_anothers) && job.rounds == 0;
        let is_stale = matches!(held.weight, Weight::Stale(_));
        if !is_doubted && (is_sure || is_stale) {
            (job.doubted, job.noisy) = (held.doubted || spoilt, false);
            if is_sure && is_anothers {
                self.heard.comes_alone(station);
            }
            let copies = self.heard.has_surplus(station);
            self.reply(held.at, sent_end, &held.bytes, is_sure || !copies);
            self.take(held.at, sent_end, held.said);
            if !is_sure {
                let due = if copies { sent_end + LATEST_REPLY } else { now };
                self.debts.doubts(station, question, due, now);
            }
            return Some(self.step(now));
        }
        let (gives_way, asked) = (job.limits.gives_way, job.asked);
        self.discard(held.at, held.bytes, Some(&question).filter(|_| held.weight != Weight::Rival));
        self.debts.owes(station, question, sent_end + LATEST_REPLY, now);
        self.tally.garbled += 1;
        if gives_way {
            return Some(self.finish(Err(unproven(&self.twins, station, asked))));
        }
        Some(self.ask_anew(now, Parting::Quiet(self.heard.quiet_at(now))))
    }
}

/// Whether a longer telegram begins with all of what was sent: an RTU telegram with two zeros behind it has a right check
/// value once more (the remainder of a CRC and itself is 0), so an echo and a little noise look like the reply of code 100.
fn begins_as_echo(waiting: &Waiting, start: usize, end: usize) -> bool {
    let telegram = waiting.came.get(start..end).unwrap_or_default();
    telegram.len() > waiting.sent.len() && telegram.starts_with(&waiting.sent)
}

/// Clocks of adapters and drives differ a little, in microseconds.
const SLACK_US: i64 = 200;
