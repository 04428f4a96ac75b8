//! What comes and is nobody's answer: echoes, strays, garbage, and the reply to a question that was given up.

use super::*;

/// From the last answer on, another to the same question within this time is a second one.
const SECOND_WITHIN: Span = Span::from_secs(1);

impl Master {
    /// Takes bytes for the question that was given up; its reply settles what is owed.
    pub(super) fn feed_orphan(&mut self, at: Tick, bytes: &[u8]) -> bool {
        let Some(orphan) = &mut self.orphan else { return false };
        orphan.came.extend_from_slice(bytes);
        let Some(found) = self.dialect.find(&orphan.came, orphan.station, &orphan.question) else {
            keep(&mut orphan.came, &[]);
            return true;
        };
        let (station, came) = (orphan.station, std::mem::take(&mut orphan.came));
        self.orphan = None;
        self.debts.pays(station, &found.said, at);
        self.debts.settle(station, at, at);
        self.heard.note(at, &came, None);
        self.tally.strays += 1;
        self.record(Record { at, verdict: Verdict::Stray { station }, bytes: came });
        true
    }

    /// Takes bytes that nobody waits for.
    pub(super) fn feed_loose(&mut self, at: Tick, bytes: &[u8]) {
        if at.since(self.loose.last()) > self.dialect.straggle(self.loose.bytes()) {
            self.flush_loose();
        }
        self.loose.hears(at, bytes);
        if self.loose.bytes().len() > MOST_BYTES || self.dialect.sender(self.loose.bytes()).is_some() {
            self.flush_loose();
        }
    }

    /// The answer to a question that was given up, if it was the last that came so late. It names its question no better than any
    /// other: for what decides on a telegram that does no harm to anybody.
    pub fn came_late(&self, station: u8, question: &Question) -> Option<&Said> {
        let late = self.late.as_ref().filter(|late| (late.0, &late.1) == (station, question))?;
        Some(&late.2)
    }

    pub(super) fn flush_loose(&mut self) {
        let (at, bytes) = (self.loose.last(), self.loose.take());
        self.note_stray(at, &bytes);
    }

    /// Notes what came before an answer: an echo, noise, strays.
    pub(super) fn note_before(&mut self, at: Tick, before: &[u8], sent: &[u8]) {
        let noise = before.strip_suffix(sent);
        let is_ours = |noise: &&[u8]| noise.is_empty() || *noise == self.dialect.farewell();
        if let Some(noise) = noise.or(Some(before)).filter(|noise| !is_ours(noise)) {
            self.note_stray(at, noise);
        }
        if noise.is_some() {
            self.note_echo(at, sent);
        }
    }

    pub(super) fn note_echo(&mut self, at: Tick, sent: &[u8]) {
        self.tally.echoes += 1;
        self.echoed |= self.job.as_ref().is_some_and(|job| !job.asks().resembles_its_reply());
        self.record(Record { at, verdict: Verdict::Echo, bytes: sent.to_vec() });
    }

    /// Counts bytes that are nobody's answer; each whole reply among them for itself.
    pub(super) fn note_stray(&mut self, at: Tick, bytes: &[u8]) {
        for (piece, bytes) in ear::pieces(self.dialect, bytes) {
            let verdict = match piece {
                Piece::Stray(station, said) => {
                    self.debts.hears(station);
                    if let Some(job) = self.job.as_mut().filter(|job| job.station == station) {
                        job.heard = true;
                    }
                    // One that is too short was spoilt on its way, or is always so: it tells nothing.
                    if self.dialect.shortness(bytes).is_none() {
                        self.explain(at, station, said, bytes);
                    }
                    self.tally.strays += 1;
                    Verdict::Stray { station }
                }
                _ => {
                    self.heard.sees_trouble();
                    Verdict::Garbage
                }
            };
            self.record(Record { at, verdict, bytes: bytes.to_vec() });
        }
    }

    /// A valid telegram came that is not the answer: a copy, a reply that was missing, or one too many.
    pub(super) fn explain(&mut self, at: Tick, station: u8, said: Option<Said>, bytes: &[u8]) {
        let is_copy = self.heard.is_copy(at, bytes);
        let fits = |missing: &Question| said.as_ref().is_some_and(|said| missing.is_answered_by(said));
        let owed: Vec<_> = self.debts.missing(station).into_iter().filter(fits).collect();
        // If only one question can be meant, it is the late answer to that.
        let answered = owed.first().filter(|_| owed.len() == 1);
        self.heard.note(at, bytes, answered);
        match is_copy {
            // A copy, or what is owed: nobody knows. A reply that was spoilt has come, and does not come again.
            true if !owed.is_empty() && self.debts.is_late(station, said.as_ref()) => return,
            true => {
                self.suspect(station, at);
                return self.heard.sees_copy(station, at, bytes);
            }
            false => {}
        }
        let Some(said) = said else { return };
        if let Some(question) = answered {
            if let Some(missed) = self.debts.missed(station, question) {
                self.heard.sees_late(station, at.since(missed));
            }
            self.late = Some((station, question.clone(), said.clone()));
        }
        // One answer was doubted, and this is another one to the same question.
        let differs = |job: &Job| {
            let first = job.first.as_ref().filter(|first| first.said != said);
            job.station == station && first.is_some() && job.question.is_answered_by(&said)
        };
        if self.job.as_ref().is_some_and(differs) && !self.debts.mixes() && owed.len() < 2 {
            self.twins.marks(station, at);
        }
        if self.debts.pays(station, &said, at) {
            return;
        }
        self.heard.sees_trouble();
        let overtaken = self.debts.arrives(station, &said, at);
        let second = self.answered.as_ref().is_some_and(|(answering, question, then)| {
            *answering == station && question.is_answered_by(&said) && at.since(*then) < SECOND_WITHIN
        });
        let alone = self.job.as_ref().is_none_or(|job| job.station != station || !job.asks().is_answered_by(&said));
        if second && alone && !overtaken {
            self.heard.sees_surplus(station);
            self.twins.marks(station, at);
            if self.is_alone(at) && !self.dialect.is_numbered() {
                self.twins.contradicts(station);
            }
        } else {
            self.suspect(station, at);
        }
    }

    /// An answer that we do not believe: our doubt is no sign that more came than was asked for. Said again, it is no copy of an
    /// answer to something else, if it was the only one to what was `asked`.
    pub(super) fn discard(&mut self, at: Tick, bytes: Vec<u8>, asked: Option<&Question>) {
        self.heard.note(at, &bytes, asked);
        self.tally.strays += 1;
        let Some(station) = self.job.as_ref().map(|job| job.station) else { return };
        self.record(Record { at, verdict: Verdict::Stray { station }, bytes });
    }

    pub(super) fn record(&mut self, record: Record) {
        if matches!(record.verdict, Verdict::Reply | Verdict::Stray { .. })
            && let Some((station, Some(said))) = self.dialect.sender(&record.bytes)
        {
            self.ledger.hears(station, &said);
        }
        if self.records.len() < MOST_RECORDS {
            self.records.push(record);
        }
    }
}
