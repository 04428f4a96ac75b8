//! The search of one line: round after round through its settings.

mod hearing;
mod told;

use super::look::{self, Sight};
use super::pace::{self, Pace, Visited, Work};
use super::plan::{Manner, ScanPlan};
use super::stages::{Stage, stages};
use super::{ScanResult, Searched, Tuning, Yielded, order};
use crate::drive::access::AccessError;
use crate::drive::probe::probe;
use crate::drive::session::Session;
use crate::exchange::survey::{Attendance, Patience, Sign, Survey};
use crate::exchange::{News, Question, Talk, Talker};
use crate::outcome::{Event, FoundDrive, Warning};
use crate::profile::Registry;
use crate::protocol::modbus::Framing;
use crate::tick::{Span, Tick};
use std::collections::BTreeSet;

/// The first addresses are where drives are: at the right setting they are asked twice if they are silent.
const TWICE: usize = 20;
/// Garbage at more of the settings than one in so many is the line's own, and tells nothing about any of them.
const FEW: usize = 4;

pub(super) struct Search<'p, 's, 'o> {
    session: &'s mut Session<'o>,
    plan: &'p ScanPlan,
    registry: &'p Registry,
    searched: Vec<Searched>,
    stages: Vec<Stage>,
    drives: Vec<FoundDrive>,
    warnings: Vec<Warning>,
    pace: Pace,
    /// When it ends, whatever is left; the looks at finds put it off, but not an end that was named.
    ends_at: Option<Tick>,
    /// It ended then.
    is_over_time: bool,
    /// The line was left to who speaks on it.
    yielded: Option<Yielded>,
    /// What was heard before anything was sent.
    talk: Talk,
    /// Questions of somebody else that were heard so far.
    foreign: u32,
    /// When it was last told how far it is.
    told: Tick,
    /// It was told that a setting with drives is done.
    told_whole: bool,
}

/// What is done at a setting.
struct Visit {
    index: usize,
    stage: Stage,
    patience: Patience,
    questions: Vec<(u8, Question)>,
    stations: usize,
    expected: Work,
    /// What is left besides.
    beyond: Work,
    began: Tick,
    /// Drives that were looked at, and how long that took.
    found: BTreeSet<u8>,
    looked: Span,
    /// Who answered when there was no time any more to ask him what he is.
    unlooked: BTreeSet<u8>,
    /// Who answered a quick look with garbage, each time that he was asked.
    garbled: Vec<u8>,
}

fn work(stage: Stage, span: Span) -> Work {
    if stage.quick { Work { quick: span, ..Work::default() } } else { Work { whole: span, ..Work::default() } }
}

impl<'p, 's, 'o> Search<'p, 's, 'o> {
    pub(super) fn new(session: &'s mut Session<'o>, plan: &'p ScanPlan, registry: &'p Registry) -> Self {
        let known = Tuning { protocol: session.protocol(), line: session.line() };
        let unknown = match session.can_set_line() {
            true => plan.unknown,
            false => order::Unknown { baud: false, parity: false, ..plan.unknown },
        };
        let mut warnings = Vec::new();
        if unknown != plan.unknown {
            warnings.push(look::fixed_line(session.port(), known));
        }
        let searched: Vec<_> = order::tunings(known, unknown).into_iter().map(|at| unsearched(plan, at)).collect();
        let stages = stages(plan.manner, searched.len(), plan.addresses.len());
        let (ends_at, told) = (plan.within.map(|within| session.now() + within), session.now());
        Search {
            session,
            plan,
            registry,
            searched,
            stages,
            drives: Vec::new(),
            warnings,
            pace: Pace::default(),
            ends_at,
            is_over_time: false,
            yielded: None,
            talk: Talk::default(),
            foreign: 0,
            told,
            told_whole: false,
        }
    }

    /// What came of it.
    pub(super) fn ended(mut self, cut: Option<AccessError>) -> ScanResult {
        let left = self.left(self.expected());
        self.is_over_time &= self.searched.iter().any(|searched| !searched.is_complete());
        if self.plan.within.is_none() && std::mem::take(&mut self.is_over_time) {
            // The time that it gave itself would have been enough on any line that is not disturbed all the time.
            self.searched.iter_mut().for_each(|searched| searched.disturbed |= !searched.is_complete());
        }
        // The garbage of a line on which somebody else speaks is nobody's.
        let is_quiet = self.yielded.is_none() && self.talk.verdict().is_none();
        for searched in self.searched.iter().filter(|searched| is_quiet && !searched.occupied) {
            let (garbled, at) = (searched.garbled.iter(), (self.searched.len() > 1).then_some(searched.tuning));
            self.warnings.extend(garbled.map(|&address| look::garbled(address, searched.found, at)));
        }
        let Search { drives, searched, warnings, yielded, is_over_time, .. } = self;
        ScanResult { drives, searched, warnings, yielded, is_over_time, left, unasked: None, cut }
    }

    pub(super) async fn run(&mut self) -> Result<(), AccessError> {
        self.overhear().await?;
        self.announce();
        let last = self.stages.len().saturating_sub(1);
        let found_before: Vec<usize> = (0..self.searched.len()).filter(|&index| self.is_found(index)).collect();
        for index in found_before {
            self.survey(index, last).await?;
        }
        for round in 0..self.stages.len() {
            for index in self.where_heard() {
                if self.has_time_for(index) {
                    self.survey(index, last).await?;
                }
            }
            for index in 0..self.searched.len() {
                self.survey(index, round).await?;
                // Who shares a line shares its setting (CM-485 manual 5.3.1, LXM05 manual 4.1): where one is, others are.
                if self.is_found(index) {
                    self.survey(index, last).await?;
                    self.tell_whole(index);
                }
            }
        }
        Ok(())
    }

    /// The end that somebody named (--within), which nothing puts off.
    fn named_end(&self) -> Option<Tick> {
        self.plan.within.and(self.ends_at)
    }

    async fn retune(&mut self, to: Tuning) -> Result<(), AccessError> {
        match (self.session.protocol(), self.session.line()) == (to.protocol, to.line) {
            true => Ok(()),
            false => self.session.retune(to.protocol, to.line).await,
        }
    }

    /// Settings at which somebody was heard whom nobody understood: they are asked to the end before anything else, unless it
    /// is the line itself that makes the garbage. Two new drives with one address are heard so.
    fn where_heard(&self) -> Vec<usize> {
        let is_heard = |searched: &Searched| searched.hint && !searched.found && !searched.occupied;
        let heard = self.searched.iter().enumerate().filter(|(_, searched)| is_heard(searched));
        let heard: Vec<usize> = heard.map(|(index, _)| index).collect();
        if heard.len() * FEW <= self.searched.len() { heard } else { Vec::new() }
    }

    /// Whether a setting can be asked to the end without costing the likeliest addresses of the others their turn by an end that was
    /// named.
    fn has_time_for(&self, index: usize) -> bool {
        let Some((at, searched)) = self.named_end().zip(self.searched.get(index)) else { return true };
        let whole = pace::limit(self.expected_at(searched, self.stages.len()).sum(), false);
        self.left(self.likeliest()) + whole <= at.since(self.session.now())
    }

    fn is_found(&self, index: usize) -> bool {
        self.searched.get(index).is_some_and(|searched| searched.found)
    }

    /// Whether what was found is enough, or the time is over.
    fn is_over(&mut self) -> bool {
        let whole = |searched: &Searched| searched.found && searched.is_complete();
        let enough = self.yielded.is_some()
            || self.is_first_found()
            || self.plan.manner == Manner::Fast && self.searched.iter().any(whole);
        self.is_over_time |= !enough && self.ends_at.is_some_and(|at| self.session.now() >= at);
        enough || self.is_over_time
    }

    /// Whether the one drive is found that was wanted.
    fn is_first_found(&self) -> bool {
        self.plan.until_first.as_ref().is_some_and(super::First::is_found)
    }

    /// Asks at one setting who has not been asked there yet, as far as a round goes.
    async fn survey(&mut self, index: usize, round: usize) -> Result<(), AccessError> {
        if self.is_over() {
            return Ok(());
        }
        let Some(mut visit) = self.visit(index, round) else { return Ok(()) };
        let Some(tuning) = self.searched.get(index).map(|searched| searched.tuning) else { return Ok(()) };
        self.retune(tuning).await?;
        let questions = std::mem::take(&mut visit.questions);
        let now = self.session.now();
        let mut survey = Survey::new(tuning.protocol, tuning.line, questions, visit.patience, now);
        self.remembers(&mut survey);
        let end = self.listen(&mut survey, &mut visit).await;
        let end = end.and(self.confirm(&survey, &mut visit).await);
        self.conclude(&survey, &visit);
        if end.is_ok() {
            let took = visit.gone(self.session.now());
            let questions = survey.attendance().values().map(|known| known.asked as usize).sum();
            let expected = std::mem::take(&mut visit.expected);
            self.pace.note(Visited { expected, took, questions, garbage: survey.garbage() });
            visit.beyond = self.expected();
            self.tell(&survey, &visit, true);
        }
        end
    }

    /// Asks those again from whom garbage seems to have come at a quick look: whoever is there says it again, noise does not. Where
    /// it was heard before anything was sent, it must be said once more.
    async fn confirm(&mut self, survey: &Survey, visit: &mut Visit) -> Result<(), AccessError> {
        // Beside somebody who speaks all the time garbage tells nothing.
        let is_asked = visit.stage.quick && self.talk.verdict().is_none();
        let suspects: Vec<u8> = if is_asked { survey.garbled().collect() } else { Vec::new() };
        let Some(tuning) = self.searched.get(visit.index).map(|searched| searched.tuning) else { return Ok(()) };
        let times = if self.talk.is_silent() { 1 } else { 2 };
        let ask = |station: u8| Some((station, probe(tuning.protocol, station)?));
        visit.garbled = suspects;
        for _ in 0..times {
            if visit.garbled.is_empty() {
                break;
            }
            let questions = visit.garbled.iter().filter_map(|&station| ask(station));
            let now = self.session.now();
            let limit = self.ends_at.map(|at| at.since(now));
            let patience = Patience { limit, ..visit.patience };
            let mut again = Survey::new(tuning.protocol, tuning.line, questions, patience, now);
            self.remembers(&mut again);
            self.listen(&mut again, visit).await?;
            self.foreign = again.foreign();
            visit.garbled = again.garbled().filter(|station| visit.garbled.contains(station)).collect();
        }
        Ok(())
    }

    /// Questions of another master count, at whatever setting they were heard: three tell that he is there.
    fn remembers(&self, survey: &mut Survey) {
        if !self.plan.force {
            survey.remembers(self.foreign);
        }
    }

    /// What there is to do at a setting; `None` if nothing is.
    fn visit(&mut self, index: usize, round: usize) -> Option<Visit> {
        let stage = *self.stages.get(round)?;
        let before = self.searched.get(index).filter(|searched| !searched.occupied && searched.rounds <= round)?;
        let (tuning, is_sure) = (before.tuning, before.found || self.searched.len() == 1);
        let skipped = if stage.quick { before.looked } else { 0 };
        let addresses = before.wanted.iter().take(stage.first).skip(skipped);
        let open = addresses.filter(|address| !before.asked.contains(address));
        let questions: Vec<_> = open.filter_map(|&address| Some((address, probe(tuning.protocol, address)?))).collect();
        let searched = self.searched.get_mut(index)?;
        searched.rounds = round + 1;
        searched.looked = stage.first;
        let (_, question) = questions.first()?;
        let patience = self.patience(tuning, stage, question, is_sure);
        let expected = patience.lasts(tuning.protocol, tuning.line, question, questions.len());
        let (began, beyond) = (self.session.now(), self.expected());
        let own = (self.searched.len() > 1).then(|| pace::limit(expected, is_sure));
        let expected = work(stage, expected);
        let whole = self.ends_at.map(|at| at.since(began));
        let limit = own.into_iter().chain(whole).min();
        let (found, looked, unlooked) = (BTreeSet::new(), Span::ZERO, BTreeSet::new());
        let patience = Patience { limit, ..patience };
        let stations = questions.len();
        let garbled = Vec::new();
        Some(Visit {
            index,
            stage,
            patience,
            stations,
            questions,
            expected,
            beyond,
            began,
            found,
            looked,
            unlooked,
            garbled,
        })
    }

    fn patience(&self, tuning: Tuning, stage: Stage, question: &Question, is_sure: bool) -> Patience {
        let (Tuning { protocol, line }, full) = (tuning, self.session.limits().reply_timeout);
        let brief = Patience::brief(protocol, line, question, full);
        let patience = match self.plan.manner {
            // A gateway waits for its drives itself.
            _ if protocol == Framing::Tcp.into() => Patience::by_the_book(full),
            _ if stage.quick => Patience::quick(protocol, line, question, full),
            Manner::Fast => brief.once(),
            Manner::Usual if is_sure => Patience { twice: TWICE, ..brief },
            Manner::Usual => brief,
            Manner::Thorough => Patience::by_the_book(full),
        };
        Patience { yields: !self.plan.force, ..patience }
    }

    /// Carries a survey through and looks at everybody who is heard.
    async fn listen(&mut self, survey: &mut Survey, visit: &mut Visit) -> Result<(), AccessError> {
        loop {
            match self.session.survey(survey).await? {
                News::Over => return Ok(()),
                News::Asked(address) => self.tell_progress(visit, survey, address),
                News::Heard(sign) => {
                    self.session.overheard();
                    let began = self.session.now();
                    let sight = self.look(survey, &sign, visit.patience.window).await;
                    for record in self.session.overheard() {
                        survey.overhear(&record);
                    }
                    let now = self.session.now();
                    survey.resume(now);
                    visit.looked = visit.looked + now.since(began);
                    match self.named_end() {
                        Some(at) => survey.end_by(at),
                        None => self.ends_at = self.ends_at.map(|at| at + now.since(began)),
                    }
                    self.take(visit, &sign, sight?);
                }
            }
            if self.is_first_found() {
                return Ok(());
            }
        }
    }

    async fn look(&mut self, survey: &Survey, sign: &Sign, window: Span) -> Result<Sight, AccessError> {
        let Some(question) = probe(self.session.protocol(), sign.station) else { return Ok(Sight::Nobody) };
        if survey.attendance().get(&sign.station).is_some_and(Attendance::owes) {
            self.session.expect(sign.station, question);
        }
        let is_late = sign.after > window + self.session.line().chars(look::REPLY);
        let Some(at) = self.named_end() else {
            return look::look(self.session, self.registry, sign, is_late).await;
        };
        self.session.end_at(Some(at));
        let sight = match self.session.is_over() {
            true => Ok(Sight::Nobody),
            false => look::look(self.session, self.registry, sign, is_late).await,
        };
        // What was cut short tells nothing: neither silence nor a refusal.
        let sight =
            if self.session.is_over() { sight.map(|_| look::unlooked(self.session, sign.station)) } else { sight };
        self.session.end_at(None);
        sight
    }

    fn take(&mut self, visit: &mut Visit, sign: &Sign, sight: Sight) {
        let Some(searched) = self.searched.get_mut(visit.index) else { return };
        searched.hint = true;
        match sight {
            Sight::Drive(drive, remark) => {
                searched.found = true;
                visit.found.insert(drive.address);
                if let Some(first) = &self.plan.until_first {
                    first.found();
                }
                self.warnings.extend(remark);
                self.session.tell(Event::Found(drive.clone()));
                self.drives.push(*drive);
            }
            Sight::Unlooked(drive) => {
                searched.found = true;
                visit.unlooked.insert(drive.address);
                self.session.tell(Event::Found(drive.clone()));
                self.drives.push(*drive);
            }
            Sight::Garbled => _ = searched.garbled.insert(sign.station),
            Sight::Nobody => self.warnings.push(look::gone(sign.station)),
        }
    }

    /// Notes what a survey leaves, also when it was cut short.
    fn conclude(&mut self, survey: &Survey, visit: &Visit) {
        let now = self.session.now();
        self.foreign = self.foreign.max(survey.foreign());
        self.yields_to(survey.is_shared().then_some(Talker::Master));
        let garbled: Vec<u8> = if visit.stage.quick { visit.garbled.clone() } else { survey.garbled().collect() };
        let Some(searched) = self.searched.get_mut(visit.index) else { return };
        searched.seen.extend(survey.attendance().keys());
        searched.hint |= !garbled.is_empty() || !survey.strangers().is_empty();
        searched.occupied |= survey.is_occupied();
        let is_over = self.ends_at.is_some_and(|at| now >= at);
        self.is_over_time |= survey.is_cut() && is_over;
        searched.disturbed |= survey.is_cut() && !is_over;
        match self.plan.manner {
            Manner::Fast if !visit.stage.quick => searched.asked.extend(survey.attendance().keys()),
            _ => searched.asked.extend(survey.settled(now)),
        }
        searched.asked.retain(|address| !visit.unlooked.contains(address));
        if !visit.stage.quick {
            searched.garbled.retain(|address| !survey.attendance().contains_key(address));
            self.warnings.extend(look::remarks(survey, searched.tuning));
        }
        searched.garbled.extend(garbled);
    }
}

/// A setting at which nothing was asked yet, but for what earlier searches did.
pub(super) fn unsearched(plan: &ScanPlan, tuning: Tuning) -> Searched {
    let before = || plan.before.iter().filter(|row| row.is_at(tuning));
    let wanted: Vec<u8> =
        plan.addresses.iter().filter(|&&address| probe(tuning.protocol, address).is_some()).copied().collect();
    let asked = before().flat_map(|row| &row.addresses).copied().filter(|address| wanted.contains(address)).collect();
    let found = before().any(|row| row.found);
    Searched {
        tuning,
        wanted,
        asked,
        seen: BTreeSet::new(),
        garbled: BTreeSet::new(),
        rounds: 0,
        looked: 0,
        hint: false,
        found,
        occupied: false,
        disturbed: false,
    }
}
