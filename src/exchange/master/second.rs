//! A station that may be two drives: each question is answered by both, and the second answer is waited for.

use super::*;
use crate::exchange::job::Second;
use crate::exchange::twins::SECOND_WITHIN;

/// A question that goes out so soon after an answer meets what follows it.
const RIGHT_BEHIND: Span = Span::from_millis(20);
/// Who has asked nothing for so long is gone.
const ALONE_AFTER: Span = Span::from_secs(5);
/// Bytes of the longest answer behind which a second one is listened for: a counter in ASCII.
const MOST_SECOND: usize = 17;

impl Master {
    /// Whether two drives at the address matter to this question. A stop or a refresh goes on, and a write is proven
    /// otherwise.
    pub(super) fn is_told_apart(&self, question: &Question, limits: Limits) -> bool {
        limits.insist.is_none() && limits.witness && !question.is_write()
    }

    /// Whether an answer names what it answers, so that none to another question can be taken for it.
    pub(super) fn is_named(&self) -> bool {
        self.dialect.is_numbered() || self.dialect.names_its_question()
    }

    /// More came from a station than was asked for, or less: a second drive may be the cause, unless another master is.
    pub(super) fn suspect(&mut self, station: u8, at: Tick) {
        if self.is_alone(at) {
            self.twins.suspects(station);
        }
    }

    /// Whether nobody else was heard to ask anything on this line.
    pub(super) fn is_alone(&self, at: Tick) -> bool {
        self.others[0].is_none_or(|heard| at.since(heard) > ALONE_AFTER)
    }

    /// Whether another master asks on this line. One question may be garbage that has a right check value by chance.
    pub(super) fn is_shared(&self, at: Tick) -> bool {
        self.others[1].is_some_and(|heard| at.since(heard) <= ALONE_AFTER)
    }

    /// A question was lost: one that went out right behind an answer may have met the second one.
    pub(super) fn note_lost(&mut self, station: u8, now: Tick) {
        let (Some(job), Some((last, _, then))) = (&self.job, &self.answered) else { return };
        let Phase::Reply(waiting) = &job.phase else { return };
        if *last == station && waiting.sent_at.since(*then) < RIGHT_BEHIND && self.twins.loses(station) {
            self.heard.meets_copies(station);
            self.suspect(station, now);
        }
    }

    /// Whether a second answer is to be waited for.
    pub(super) fn is_suspected(&mut self, at: Tick) -> bool {
        let Some(job) = &self.job else { return false };
        let station = job.station;
        self.is_told_apart(&job.question, job.limits)
            && (self.twins.is_suspect(station) || self.twins.are_two(station, at))
            && job.counted != Some(Count::Once)
    }

    /// An answer of a suspect: a value is none before a fence has told how many answer, or it names its question.
    pub(super) fn count(&mut self, at: Tick, sent_end: Tick, said: Said) {
        let is_named = self.is_named();
        let Some(job) = &mut self.job else { return };
        if self.twins.are_two(job.station, at) {
            job.phase = Phase::Done(Err(ExchangeError::TwoAnswers { station: job.station }));
            return;
        }
        if !job.is_fenced() && job.counted.is_none() && !is_named {
            // Once for each question: that is no round.
            let rounds = std::mem::take(&mut job.rounds);
            self.ask_behind_fence(at, sent_end + LATEST_REPLY);
            if let Some(job) = &mut self.job {
                (job.rounds, job.kept) = (rounds, true);
            }
            return;
        }
        self.await_second(at, sent_end, said);
    }

    /// Whether a second answer is listened for although nothing speaks for one yet.
    pub(super) fn listens(&self) -> bool {
        let listens = |job: &Job| job.limits.listen > Span::ZERO && !job.is_fenced() && !job.question.is_write();
        !self.dialect.is_numbered() && self.job.as_ref().is_some_and(listens)
    }

    /// Waits behind an answer for the second one: as long as any comes, or as somebody wants to listen.
    pub(super) fn await_second(&mut self, at: Tick, sent_end: Tick, said: Said) {
        let within = if self.is_suspected(at) { SECOND_WITHIN } else { Span::ZERO };
        // Until the second one is over, on a slow line too.
        let telegram = self.dialect.duration(self.line, MOST_SECOND);
        let came = self.loose.take();
        let Some(job) = &mut self.job else { return };
        let Phase::Reply(Waiting { sent_at, .. }) = job.phase else { return };
        let until = at + within.longer(job.limits.listen + telegram);
        job.phase =
            Phase::Second(Second { said, sent: (sent_at, sent_end), at, until, came: Vec::new(), second: None });
        if !came.is_empty() {
            self.feed_second(at, &came);
        }
    }

    /// Takes bytes behind the first answer.
    pub(super) fn feed_second(&mut self, at: Tick, bytes: &[u8]) {
        let Some(job) = &mut self.job else { return };
        let (station, question) = (job.station, job.asks().clone());
        let may_be_older = job.asked > 1 || self.debts.may_come(station, &question, at);
        let Phase::Second(second) = &mut job.phase else { return };
        keep(&mut second.came, bytes);
        while let Some(found) = self.dialect.find(&second.came, station, &question) {
            let telegram: Vec<u8> = second.came.drain(..found.end).collect();
            let reply = telegram.get(found.start..).unwrap_or_default().to_vec();
            // An older fence of the same kind was counted lower; what an adapter gives back late is our own.
            if may_be_older && self.dialect.is_older(&found.said, &second.said) || self.sent.contains(&reply) {
                continue;
            }
            (second.second, second.until) = (Some(found.said), at);
            self.heard.note(at, &reply, None);
            self.tally.strays += 1;
            self.record(Record { at, verdict: Verdict::Stray { station }, bytes: reply });
            if let Some(before) = telegram.get(..found.start).filter(|before| !before.is_empty()) {
                self.note_stray(at, before);
            }
            return;
        }
        // Nobody speaks behind an answer but a second drive, whatever it answers: it is asked about at once.
        let is_another = self.dialect.sender(&second.came).is_some() && !self.sent.contains(&second.came);
        if is_another && !self.twins.is_suspect(station) {
            second.until = at;
            let came = std::mem::take(&mut second.came);
            self.note_stray(at, &came);
        }
    }

    /// The second answer has come, or none comes.
    pub(super) fn counted(&mut self, now: Tick) -> Step<Outcome> {
        let is_named = self.is_named();
        let Some(job) = &mut self.job else { return Step::Wait(now) };
        let Phase::Second(Second { said, sent: (sent_at, sent_end), at, came, second, .. }) =
            std::mem::replace(&mut job.phase, Phase::Gap(now))
        else {
            return Step::Wait(now);
        };
        let (station, is_fenced) = (job.station, job.is_fenced());
        // A counter that was asked for once has one count, and copies do not differ.
        let asked = if is_fenced { job.same_fence } else { job.asked };
        let fence = job.asks().clone();
        let is_due = self.debts.may_come(station, &fence, now);
        let two_counts = is_fenced && asked == 1 && !is_due && second.as_ref().is_some_and(|second| *second != said);
        // What was asked twice is answered twice, late.
        let is_answered_late = !is_fenced && second.is_some() && (asked > 1 || is_due);
        match is_fenced || is_named {
            true if is_answered_late => {}
            true => self.twins.counts(station, second.is_some()),
            false if second.is_some() => self.suspect(station, now),
            false => {}
        }
        let Some(job) = &mut self.job else { return Step::Wait(now) };
        if is_fenced {
            job.counted = Some(if second.is_some() { Count::Twice } else { Count::Once });
        }
        if two_counts || !is_fenced && second.is_some_and(|second| second != said) {
            self.twins.proves(station, now);
            return self.finish(Err(ExchangeError::TwoAnswers { station }));
        }
        job.phase = Phase::Reply(Waiting::new(Vec::new(), sent_at, sent_end, Span::ZERO));
        if !came.is_empty() {
            self.loose.hears(now, &came);
        }
        match !is_fenced && !is_named && self.is_suspected(now) && self.is_uncounted() {
            // It became a suspect only now: how many answer is found out before this is believed.
            true => self.count(at, sent_end, said),
            false => self.settle(at, sent_end, said),
        }
        if let Some(Job { phase: Phase::Gap(since), .. }) = &mut self.job {
            // The line did not keep it waiting while a second answer was listened for.
            *since = now;
        }
        self.step(now)
    }

    fn is_uncounted(&self) -> bool {
        self.job.as_ref().is_some_and(|job| job.counted.is_none())
    }
}
