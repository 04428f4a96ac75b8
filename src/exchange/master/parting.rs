//! How a question is kept apart from replies that its station still owes.

use super::*;

impl Master {
    /// How a new question is kept apart from what the station may still say.
    pub(super) fn first_parting(&self, station: u8, question: &Question, limits: Limits, now: Tick) -> Parting {
        let parting = self.parting(station, question, limits.since, now);
        let counts = self.is_told_apart(question, limits) && self.twins.is_suspect(station) && !self.is_named();
        match parting {
            Parting::None if counts => {
                self.fence(station, question).map_or(Parting::None, |fence| Parting::Fence(fence, now))
            }
            parting => parting,
        }
    }

    /// How the question is kept apart from replies that the station still owes.
    pub(super) fn parting(&self, station: u8, question: &Question, since: Option<Tick>, now: Tick) -> Parting {
        let missing = self.debts.missing(station);
        let confused = missing.iter().any(|missing| self.dialect.confuses(missing, question))
            || since.is_some_and(|since| self.debts.is_missing(station, question, since, now));
        // A stop must go out at once. Writes set values, so one whose answer may be an old one is sent again.
        if question.is_write() || !confused { Parting::None } else { self.part(station, question) }
    }

    /// Keeps everything that the station still owes away from the question.
    pub(super) fn part(&self, station: u8, question: &Question) -> Parting {
        let Some((due, end)) = self.debts.due(station) else { return Parting::None };
        self.fence(station, question).map_or(Parting::Until(end), |fence| Parting::Fence(fence, due))
    }

    /// A question whose answer can be taken for none that the station owes; first one whose answer is so old that the next can be no copy.
    pub(super) fn fence(&self, station: u8, question: &Question) -> Option<Question> {
        let missing = self.debts.missing(station);
        let counters = self.counters.get(&station).map(Vec::as_slice);
        let mut known = self.known.get(&station).cloned().unwrap_or_default();
        known.sort_by_key(|known| self.heard.has_answer_to(known));
        self.dialect.fence(&Old { missing: &missing, question, known: &known, counters })
    }

    /// Asks once more, with everything old kept away: the answer that has come may be nobody's, and ours may be to come.
    pub(super) fn ask_behind_fence(&mut self, at: Tick, due: Tick) {
        let Some((station, question)) = self.job.as_ref().map(|job| (job.station, job.question.clone())) else {
            return;
        };
        self.debts.owes(station, question.clone(), due, at);
        let parting = self.part(station, &question);
        let Some(job) = &mut self.job else { return };
        let phase = match job.may_ask_anew() {
            true => Phase::Gap(at),
            false => Phase::Done(Err(unproven(&self.twins, station, job.asked))),
        };
        job.begins_anew(parting, phase);
        (job.rounds, job.wanted) = (job.rounds.saturating_add(1), at);
    }

    /// Asks once more, kept apart in this way.
    pub(super) fn ask_anew(&mut self, now: Tick, parting: Parting) -> Step<Outcome> {
        let Some(job) = &mut self.job else { return Step::Wait(now) };
        if !job.may_ask_anew() {
            let error = unproven(&self.twins, job.station, job.asked);
            return self.finish(Err(error));
        }
        job.begins_anew(parting, Phase::Gap(now));
        job.rounds += 1;
        self.step(now)
    }
}
