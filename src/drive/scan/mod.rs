//! Who is there, and with what setting? Surveys of one line, in the order in which drives are likely to be found.

mod look;
mod order;

use super::access::AccessError;
use super::probe::probe;
use super::route::{self, Inquiry};
use super::session::Session;
use super::trouble;
use crate::exchange::News;
use crate::exchange::survey::{Attendance, Patience, Sign, Survey};
use crate::failure::Failure;
use crate::outcome::{Event, FoundDrive, Warning};
use crate::profile::{Registry, Type};
use crate::protocol::Protocol;
use crate::protocol::line::LineSetting;
use crate::protocol::modbus::Framing;
use crate::text::both;
use crate::tick::Span;
use look::Sight;
pub use order::Unknown;
use std::cell::Cell;
use std::collections::BTreeSet;
use std::fmt;
use std::rc::Rc;

/// Status word: every Modbus device says something when its register is read, and an ACTIVE drive answers it without
/// touching its error register.
const PROBE: u32 = 411;

/// What is spoken on a line, and how.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tuning {
    /// What is spoken.
    pub protocol: Protocol,
    /// Speed and character format.
    pub line: LineSetting,
}

/// Prints as `19200 8E1 rtu`.
impl fmt::Display for Tuning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.line, self.protocol)
    }
}

/// How long stations are waited for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Manner {
    /// One time around: who is late or garbled is missed. The first setting with a drive ends the search for settings.
    Fast,
    /// The next is asked after a short window, but everybody has the full time.
    #[default]
    Usual,
    /// By the book: the full time for each before the next is asked.
    Thorough,
}

/// What to search. The setting of the session is what is known, or guessed, of the line.
#[derive(Clone, Debug)]
pub struct ScanPlan {
    /// Addresses, in the order in which they are asked.
    pub addresses: Vec<u8>,
    /// What is to be found out of the line.
    pub unknown: Unknown,
    /// How long stations are waited for.
    pub manner: Manner,
    /// The first drive ends the search, whoever finds it.
    pub until_first: Option<First>,
    /// What earlier searches have asked already.
    pub before: Vec<Asked>,
    /// Goes on beside another master.
    pub force: bool,
}

impl ScanPlan {
    /// A search at the setting of the session.
    pub fn new(addresses: impl IntoIterator<Item = u8>) -> Self {
        ScanPlan {
            addresses: addresses.into_iter().collect(),
            unknown: Unknown::default(),
            manner: Manner::Usual,
            until_first: None,
            before: Vec::new(),
            force: false,
        }
    }
}

/// Whether any of several searches has found a drive.
#[derive(Clone, Debug, Default)]
pub struct First(Rc<Cell<bool>>);

/// What was asked at one setting.
#[derive(Clone, Debug)]
pub struct Asked {
    /// The line setting as it is shown.
    pub line: String,
    /// Name of the protocol.
    pub protocol: String,
    /// Addresses.
    pub addresses: BTreeSet<u8>,
    /// A drive was found there.
    pub found: bool,
}

impl Asked {
    fn is_at(&self, tuning: Tuning) -> bool {
        self.line == tuning.line.to_string() && self.protocol == tuning.protocol.name()
    }
}

/// What a search brought.
#[derive(Debug, Default)]
pub struct ScanResult {
    /// What answered.
    pub drives: Vec<FoundDrive>,
    /// What was asked at every setting that was tried.
    pub searched: Vec<Searched>,
    /// What is odd.
    pub warnings: Vec<Warning>,
    /// Another master asks on this line, so that nothing more was sent.
    pub yielded: bool,
    /// Why it ended early.
    pub cut: Option<AccessError>,
}

impl ScanResult {
    /// The failure of a search that left addresses out because somebody spoke all the time: who is there cannot be told.
    /// A setting at which nobody answers does not matter where drives answer at another one.
    pub fn left_out(&self) -> Option<Failure> {
        let elsewhere = !self.drives.is_empty();
        let left_out = |row: &Searched| row.occupied && !row.is_complete() && (row.found || !elsewhere);
        let message = both!(
            "the line is never silent, so it was left alone",
            "die Leitung schweigt nie und wurde deshalb in Ruhe gelassen"
        );
        self.searched.iter().any(left_out).then(|| trouble::never_silent(message))
    }
}

/// The search at one setting.
#[derive(Clone, Debug)]
pub struct Searched {
    /// The setting.
    pub tuning: Tuning,
    /// How many addresses were to be asked.
    pub total: usize,
    /// Addresses that have had their time.
    pub asked: BTreeSet<u8>,
    /// Addresses where only garbage came.
    pub garbled: BTreeSet<u8>,
    /// Somebody was heard.
    hint: bool,
    /// A drive was found.
    found: bool,
    /// Somebody else has the line: it is left alone.
    occupied: bool,
}

impl Searched {
    /// Whether every address has had its time.
    pub fn is_complete(&self) -> bool {
        self.asked.len() == self.total
    }
}

/// The question that every address is asked first.
pub fn probe_question() -> Inquiry {
    Inquiry::Read(route::Cell { number: PROBE, set: 0 }, Type::Uint)
}

/// Searches a line. Tells progress and finds as they come; what was found stays when it is interrupted.
pub async fn scan(session: &mut Session<'_>, plan: &ScanPlan, registry: &Registry) -> ScanResult {
    let mut search = Search::new(session, plan, registry);
    let cut = search.run().await.err();
    let Search { drives, searched, mut warnings, yielded, .. } = search;
    // The garbage of a line that is never silent is nobody's.
    for searched in searched.iter().filter(|searched| !searched.occupied) {
        let garbled = searched.garbled.iter();
        warnings.extend(garbled.map(|&address| look::garbled(address, searched.found)));
    }
    ScanResult { drives, searched, warnings, yielded, cut }
}

/// How many of the addresses are asked at every setting before it goes deeper at any of them: the factory address 1 and
/// the first addresses are the likely ones.
const DEPTHS: [Depth; 3] =
    [Depth { first: 1, glance: true }, Depth { first: 10, glance: false }, Depth { first: usize::MAX, glance: false }];

#[derive(Clone, Copy, Debug)]
struct Depth {
    first: usize,
    /// A short look; whoever is silent is asked again.
    glance: bool,
}

const TO_THE_END: Depth = DEPTHS[2];

/// The first addresses are where drives are: at the right setting they are asked twice if they are silent.
const TWICE: usize = 20;

struct Search<'p, 's, 'o> {
    session: &'s mut Session<'o>,
    plan: &'p ScanPlan,
    registry: &'p Registry,
    searched: Vec<Searched>,
    drives: Vec<FoundDrive>,
    warnings: Vec<Warning>,
    /// The line was left to another master.
    yielded: bool,
}

impl<'p, 's, 'o> Search<'p, 's, 'o> {
    fn new(session: &'s mut Session<'o>, plan: &'p ScanPlan, registry: &'p Registry) -> Self {
        let known = Tuning { protocol: session.protocol(), line: session.line() };
        let unknown = match session.can_set_line() {
            true => plan.unknown,
            false => Unknown { baud: false, parity: false, ..plan.unknown },
        };
        let mut warnings = Vec::new();
        if unknown != plan.unknown {
            warnings.push(look::fixed_line(session.port(), known));
        }
        let searched = order::tunings(known, unknown).into_iter().map(|tuning| {
            let before = || plan.before.iter().filter(|row| row.is_at(tuning));
            let askable = |address: &&u8| probe(tuning.protocol, **address).is_some();
            let asked = before().flat_map(|row| &row.addresses).copied();
            let asked = asked.filter(|address| plan.addresses.contains(address)).collect();
            let total = plan.addresses.iter().filter(askable).count();
            let found = before().any(|row| row.found);
            Searched { tuning, total, asked, garbled: BTreeSet::new(), hint: false, found, occupied: false }
        });
        let searched = searched.collect();
        Search { session, plan, registry, searched, drives: Vec::new(), warnings, yielded: false }
    }

    async fn run(&mut self) -> Result<(), AccessError> {
        let depths = if self.searched.len() == 1 { &[TO_THE_END][..] } else { &DEPTHS };
        let found_before: Vec<usize> = (0..self.searched.len()).filter(|&index| self.is_found(index)).collect();
        for index in found_before {
            self.survey(index, TO_THE_END).await?;
        }
        for depth in depths {
            for index in self.likely_first() {
                if self.is_over() {
                    return Ok(());
                }
                self.survey(index, *depth).await?;
                // Who shares a line shares its setting: where one is, others are.
                if self.is_found(index) && !self.is_over() {
                    self.survey(index, TO_THE_END).await?;
                }
            }
        }
        Ok(())
    }

    /// The settings in their order, those first where somebody was heard.
    fn likely_first(&self) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.searched.len()).collect();
        order.sort_by_key(|&index| !self.searched.get(index).is_some_and(|searched| searched.hint));
        order
    }

    fn is_found(&self, index: usize) -> bool {
        self.searched.get(index).is_some_and(|searched| searched.found)
    }

    /// Whether what was found is enough.
    fn is_over(&self) -> bool {
        let whole = |searched: &Searched| searched.found && searched.is_complete();
        self.yielded || self.is_first_found() || self.plan.manner == Manner::Fast && self.searched.iter().any(whole)
    }

    /// Whether the one drive is found that was wanted.
    fn is_first_found(&self) -> bool {
        self.plan.until_first.as_ref().is_some_and(|first| first.0.get())
    }

    /// Asks at one setting who has not been asked there yet.
    async fn survey(&mut self, index: usize, depth: Depth) -> Result<(), AccessError> {
        let Some(searched) = self.searched.get(index).filter(|searched| !searched.occupied) else { return Ok(()) };
        let tuning = searched.tuning;
        let addresses =
            self.plan.addresses.iter().take(depth.first).filter(|&address| !searched.asked.contains(address));
        let questions = addresses.filter_map(|&address| Some((address, probe(tuning.protocol, address)?)));
        let questions: Vec<_> = questions.collect();
        let Some((_, question)) = questions.first() else { return Ok(()) };
        let patience = self.patience(tuning, depth, question);
        if (self.session.protocol(), self.session.line()) != (tuning.protocol, tuning.line) {
            self.session.retune(tuning.protocol, tuning.line).await?;
        }
        let mut survey = Survey::new(tuning.protocol, tuning.line, questions, patience, self.session.now());
        let end = self.listen(&mut survey, index, patience.window).await;
        self.conclude(&survey, index, depth);
        end
    }

    fn patience(&self, tuning: Tuning, depth: Depth, question: &crate::exchange::Question) -> Patience {
        let full = self.session.limits().reply_timeout;
        let brief = Patience::brief(tuning.protocol, tuning.line, question, full);
        let is_sure = self.searched.len() == 1 || self.searched.iter().any(|row| row.found && row.tuning == tuning);
        let patience = match self.plan.manner {
            // A gateway waits for its drives itself.
            _ if tuning.protocol == Framing::Tcp.into() => Patience::by_the_book(full),
            _ if depth.glance => Patience::glance(tuning.protocol, tuning.line, full),
            Manner::Fast => Patience { thorough: false, ..brief },
            Manner::Usual if is_sure => Patience { twice: TWICE, ..brief },
            Manner::Usual => brief,
            Manner::Thorough => Patience::by_the_book(full),
        };
        Patience { yields: !self.plan.force, ..patience }
    }

    /// Carries a survey through and looks at everybody who is heard.
    async fn listen(&mut self, survey: &mut Survey, index: usize, window: Span) -> Result<(), AccessError> {
        loop {
            match self.session.survey(survey).await? {
                News::Over => return Ok(()),
                News::Asked(address) => self.tell_progress(index, survey, address),
                News::Heard(sign) => {
                    self.session.overheard();
                    let sight = self.look(survey, &sign, window).await;
                    for record in self.session.overheard() {
                        survey.overhear(&record);
                    }
                    survey.resume(self.session.now());
                    self.take(index, &sign, sight?);
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
        look::look(self.session, self.registry, sign, is_late).await
    }

    fn take(&mut self, index: usize, sign: &Sign, sight: Sight) {
        let Some(searched) = self.searched.get_mut(index) else { return };
        searched.hint = true;
        match sight {
            Sight::Drive(drive, remark) => {
                searched.found = true;
                if let Some(first) = &self.plan.until_first {
                    first.0.set(true);
                }
                self.warnings.extend(remark);
                self.session.tell(Event::Found(drive.clone()));
                self.drives.push(*drive);
            }
            Sight::Garbled => _ = searched.garbled.insert(sign.station),
            Sight::Nobody => self.warnings.push(look::gone(sign.station)),
        }
    }

    fn tell_progress(&mut self, index: usize, survey: &Survey, address: u8) {
        let before: usize = self.searched.iter().map(|searched| searched.asked.len()).sum();
        let total: usize = self.searched.iter().map(|searched| searched.total).sum();
        let Some(searched) = self.searched.get(index) else { return };
        let tuning = if self.searched.len() == 1 { String::new() } else { format!("{}, ", searched.tuning) };
        let what = both!("{tuning}address {address}", "{tuning}Adresse {address}");
        let done = before + survey.settled(self.session.now()).count();
        self.session.tell(Event::Progress { done: done as u64, total: total as u64, what });
    }

    /// Notes what a survey leaves, also when it was cut short.
    fn conclude(&mut self, survey: &Survey, index: usize, depth: Depth) {
        let now = self.session.now();
        let Some(searched) = self.searched.get_mut(index) else { return };
        searched.hint |= survey.is_garbled() || !survey.strangers().is_empty();
        searched.occupied |= survey.is_occupied();
        self.yielded |= survey.is_shared() && !self.plan.force;
        match self.plan.manner {
            Manner::Fast if !depth.glance => searched.asked.extend(survey.attendance().keys()),
            _ => searched.asked.extend(survey.settled(now)),
        }
        searched.garbled.extend(survey.garbled());
        if !depth.glance {
            self.warnings.extend(look::remarks(survey, searched.tuning));
        }
    }
}
