//! How far a search is and how long it still lasts, as it is told on the way.

use super::super::ranges;
use super::*;
use crate::outcome::{Decimal, SearchNews};
use crate::text::both;

/// So often it is told where a setting is that takes long.
const EVERY: Span = Span::from_secs(1);
/// Somebody who speaks all the time is noticed within this (`exchange::survey`).
const OCCUPIED: Span = Span::from_millis(1_050);

impl Visit {
    /// What is left of it on a silent line, by how many were asked.
    fn rest(&self, asked: usize) -> Work {
        let open = self.stations.saturating_sub(asked) as u64;
        let part = |span: Span| Span::from_micros(span.as_micros() * open / self.stations.max(1) as u64);
        Work { quick: part(self.expected.quick), whole: part(self.expected.whole) }
    }

    /// How long it has gone on, without the looks at its finds.
    pub(super) fn gone(&self, now: Tick) -> Span {
        now.since(self.began) - self.looked
    }
}

impl Search<'_, '_, '_> {
    /// What is left takes about so long.
    pub(super) fn left(&self, work: Work) -> Span {
        let visited = self.searched.iter().filter(|searched| searched.rounds > 0 || searched.occupied);
        if self.searched.iter().any(|searched| searched.occupied) && visited.clone().all(|searched| searched.occupied) {
            // Whoever speaks all the time does so at every setting.
            return OCCUPIED.times((self.searched.len() - visited.count()) as u64);
        }
        self.pace.stretched(work, self.session.limits().reply_timeout)
    }

    /// What is left of a visit: those who are not asked yet, or those who are asked again, at its own pace.
    fn left_of(&self, visit: &Visit, survey: &Survey, now: Tick) -> Span {
        let (asked, gone) = (survey.attendance().len(), visit.gone(now));
        let questions: u64 = survey.attendance().values().map(|known| u64::from(known.asked)).sum();
        let again = Span::from_micros(gone.as_micros() / questions.max(1)).times(survey.pending() as u64);
        let rest = match asked < visit.stations {
            true => self.left(visit.rest(asked)).longer(again),
            false => again.longer(self.left(visit.expected) - gone),
        };
        visit.patience.limit.map_or(rest, |limit| rest.min(limit - gone))
    }

    /// What is left takes on a silent line.
    pub(super) fn expected(&self) -> Work {
        self.expected_until(self.stages.len())
    }

    /// What is left of the quick looks: the likeliest addresses at every setting.
    pub(super) fn likeliest(&self) -> Work {
        self.expected_until(self.stages.iter().filter(|stage| stage.quick).count())
    }

    fn expected_until(&self, stages: usize) -> Work {
        self.searched.iter().map(|searched| self.expected_at(searched, stages)).fold(Work::default(), Work::and)
    }

    /// What is left at a setting of the first so many rounds.
    pub(super) fn expected_at(&self, searched: &Searched, stages: usize) -> Work {
        let Tuning { protocol, line } = searched.tuning;
        let before =
            searched.rounds.checked_sub(1).and_then(|round| self.stages.get(round)).filter(|stage| !stage.quick);
        let mut settled = before.map_or(0, |stage| searched.open_of(stage.first));
        let (mut looked, mut sum) = (searched.open_of(searched.looked), Work::default());
        let Some(question) = searched.wanted.first().and_then(|&address| probe(protocol, address)) else { return sum };
        if searched.occupied {
            return sum;
        }
        for &stage in self.stages.iter().take(stages).skip(searched.rounds) {
            let open = searched.open_of(stage.first);
            let done = if stage.quick { &mut looked } else { &mut settled };
            let count = open.saturating_sub(std::mem::replace(done, open));
            let patience = self.patience(searched.tuning, stage, &question, searched.found || self.searched.len() == 1);
            sum = sum.and(work(stage, patience.lasts(protocol, line, &question, count)));
        }
        sum
    }
}

/// What is told on the way.
impl Search<'_, '_, '_> {
    /// Says before it begins how long it lasts, and sets the end that it keeps to.
    pub(super) fn announce(&mut self) {
        if self.searched.len() == 1 || self.yielded.is_some() {
            return;
        }
        let expected = self.expected().sum();
        // An end that was named holds from the moment it was named.
        if self.plan.within.is_none() {
            self.ends_at = Some(self.session.now() + pace::at_most(expected));
        }
        let news = self.news(None, expected);
        self.session.tell(Event::Sought(Box::new(news)));
    }

    /// Says once that who has found what he looked for need not wait.
    pub(super) fn tell_whole(&mut self, index: usize) {
        let Some(searched) = self.searched.get(index).filter(|searched| searched.is_complete()) else { return };
        let goes_on = self.searched.iter().any(|searched| !searched.is_complete());
        if self.told_whole || !goes_on || self.plan.manner == Manner::Fast || self.is_first_found() {
            return;
        }
        self.told_whole = true;
        let tuning = searched.tuning;
        self.session.tell(Event::Note(both!(
            "all addresses at {tuning} had their turn, and drives of one line have one setting; the search goes on for others, \
             Ctrl-C ends it",
            "alle Adressen mit {tuning} waren an der Reihe, und Antriebe einer Leitung haben eine Einstellung; die Suche geht nach \
             anderen weiter, Strg-C beendet sie"
        )));
    }

    /// How far it is, after a setting and every second.
    pub(super) fn tell(&mut self, survey: &Survey, visit: &Visit, is_over: bool) {
        if self.searched.len() == 1 {
            return;
        }
        self.told = self.session.now();
        let asked: BTreeSet<u8> = survey.attendance().keys().copied().collect();
        let here = if is_over { Span::ZERO } else { self.left_of(visit, survey, self.told) };
        let news = self.news(Some(visit), here + self.left(visit.beyond));
        let news = SearchNews { asked_here: ranges(&asked), garbled: survey.garbage() > 0, is_over, ..news };
        self.session.tell(Event::Sought(Box::new(news)));
    }

    pub(super) fn tell_progress(&mut self, visit: &Visit, survey: &Survey, address: u8) {
        if self.searched.len() > 1 {
            if self.session.now().since(self.told) >= EVERY {
                self.tell(survey, visit, false);
            }
            return;
        }
        let Some(searched) = self.searched.get(visit.index) else { return };
        let done = searched.asked.len() + survey.settled(self.session.now()).count();
        let what = both!("address {address}", "Adresse {address}");
        self.session.tell(Event::Progress { done: done as u64, total: searched.wanted.len() as u64, what });
    }

    /// How far it is; before anything was asked, without a visit.
    fn news(&self, visit: Option<&Visit>, left: Span) -> SearchNews {
        let now = self.session.now();
        let index = visit.map_or(0, |visit| visit.index);
        let tuning = self.searched.get(index).map(|searched| searched.tuning);
        let most = self.ends_at.map_or(Span::ZERO, |at| at.since(now));
        SearchNews {
            t: seconds(now.since(Tick::ZERO)),
            port: self.session.port().to_owned(),
            line: tuning.map_or_else(String::new, |tuning| tuning.line.to_string()),
            protocol: tuning.map_or("", |tuning| tuning.protocol.name()),
            setting: visit.map_or(0, |visit| visit.index + 1),
            settings: self.searched.len(),
            round: visit
                .map_or(0, |visit| self.stages.iter().position(|stage| *stage == visit.stage).map_or(0, |at| at + 1)),
            rounds: self.stages.len(),
            asked_here: String::new(),
            found_here: visit.map_or_else(Vec::new, |visit| visit.found.iter().copied().collect()),
            garbled: false,
            found: self.drives.len(),
            asked: self.searched.iter().map(|searched| searched.asked.len()).sum(),
            addresses: self.searched.iter().map(|searched| searched.wanted.len()).sum(),
            left_s: seconds(left.min(most)),
            at_most_s: seconds(most),
            is_over: false,
            is_named: false,
        }
    }
}

/// Tenths of a second, rounded up.
fn seconds(span: Span) -> Decimal {
    Decimal { raw: span.as_micros().div_ceil(100_000) as i64, decimals: 1 }
}
