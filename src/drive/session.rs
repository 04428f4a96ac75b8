//! An open line: asks questions, tells what goes over it, and turns what goes wrong into failures with a hint.

use super::access::AccessError;
use super::account::Account;
use super::bench;
use super::can;
use super::interrupt::Interrupt;
use super::open_line::OpenLine;
use super::opening::{Opening, is_wired, open_trace};
use super::probe::sounding;
use super::pump::PumpError;
use super::trouble;
use super::turns::Seat;
use crate::exchange::can::Traffic;
use crate::exchange::talk::Window;
use crate::exchange::{Answer, ExchangeError, INSIST, Limits, Master, News, Pauses, Question, Record, Survey, Tally};
use crate::failure::Failure;
use crate::outcome::Event;
use crate::profile::{Family, Registry};
use crate::protocol::Protocol;
use crate::protocol::line::LineSetting;
use crate::protocol::modbus::pdu::WordOrder;
use crate::simulator::Bench;
use crate::text::both;
use crate::tick::{Span, Tick};
use crate::transport::{Link, Port, Wake};
use std::cell::RefCell;
use std::collections::BTreeSet;
use std::rc::Rc;

mod beside;
mod blurting;
mod keeping;
mod limits;
mod on_bus;
mod unanswered;

/// So often something is asked that tells whether the line echoes: behind noise one reply tells nothing.
const SOUNDINGS: u8 = 2;
/// What must not wait waits no longer for an answer, however long others may have: four times what a drive may take (CM-485 manual
/// 6.8). What comes later still counts for the question behind it.
const UNHURRIED: Span = Span::from_secs(2);
/// So long a second answer is listened for where a station is asked for its first value: two drives that answer after 10 ms
/// each (docs/sources.md A2) are heard within it, whatever their adapters hold back. A choice: longer would be felt.
const LISTEN: Span = Span::from_millis(60);

/// An open line.
pub struct Session<'a> {
    port: String,
    line: Rc<RefCell<OpenLine<'a>>>,
    /// Where others talk over it too, the place among them.
    seat: Option<Seat>,
    /// The station of which notes tell, where several are talked to.
    named: Option<u8>,
    limits: Limits,
    /// How long an answer is waited for where nothing presses: as the user says, or as long as a drive may take.
    usual: Span,
    /// System-bus node behind every drive that is asked; 0 is the drive itself.
    node: u8,
    interrupt: Interrupt,
    /// Whether telegrams go out by the clock, whatever is on the line.
    insists: bool,
    /// Every question ends then, whatever has come of it.
    ends_at: Option<Tick>,
    /// No answer is believed that may be one to the same question from before.
    since: Option<Tick>,
    /// Behind the next answer a second one is listened for.
    listens: bool,
    /// Why the last question brought no answer, if it brought none.
    unanswered: Option<ExchangeError>,
    /// Stations of which more than one answer came to one question.
    twins: BTreeSet<u8>,
    /// What is told where nobody answers for long.
    warns: Option<unanswered::Warns>,
    /// What is known of the stations that are talked to.
    known: unanswered::Known,
    /// What is heard on a CAN bus, whomever it is for.
    heard: Option<can::Heard>,
    /// The same, where nobody is asked.
    ears: Option<can::Ears>,
}

impl std::fmt::Debug for Session<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Session").field("port", &self.port).field("limits", &self.limits).finish_non_exhaustive()
    }
}

impl<'a> Session<'a> {
    /// Opens the line.
    pub async fn open(
        opening: Opening<'_>,
        registry: &Registry,
        interrupt: Interrupt,
        observe: &'a mut dyn FnMut(Event),
    ) -> Result<Self, Failure> {
        let limits = opening.limits();
        let Opening { port, line, rs485, protocol, profibus, verbose, .. } = opening;
        let mut link = match (port, protocol) {
            (Port::Sim(file), _) if profibus => Link::open_profibus(bench::profibus(file.as_deref(), registry)?, line),
            (Port::Sim(file), Protocol::Sdo(_)) => Link::open_can(bench::can(file.as_deref(), registry)?),
            (Port::Sim(file), _) => Link::open_sim(bench::load(file.as_deref(), registry)?, line),
            (port, _) => tokio::select! {
                link = Link::open(port, line, rs485) => link.map_err(|error| trouble::link(&error))?,
                () = interrupt.raised() => return Err(trouble::interrupted()),
            },
        };
        if let Some(recording) = opening.trace {
            link.record_to(open_trace(recording, &format!("{line}, {}", opening.spoken()))?);
        }
        for deviation in link.deviations() {
            observe(Event::Note(both!("{port}: {deviation}", "{port}: {deviation}", deviation)));
        }
        let ears = match protocol {
            Protocol::Sdo(_) if opening.listens => Some(can::listen(&mut link, &opening, &interrupt, observe).await?),
            _ => None,
        };
        let heard = match protocol {
            Protocol::Sdo(channel) if ears.is_none() => {
                Some(can::open(&mut link, &opening, channel, &interrupt, observe).await?)
            }
            _ => None,
        };
        let wired = is_wired(port) && !line.is_can();
        let (port, mut master) = (port.to_string(), Master::new(protocol, line, limits));
        master.set_wired(wired);
        let line = OpenLine::new(link, master, Account::new(observe, verbose));
        let session = Session::on(port, Rc::new(RefCell::new(line)), (limits, interrupt));
        Ok(Session { heard, ears, ..session })
    }

    /// A conversation of its own on a line.
    fn on(port: String, line: Rc<RefCell<OpenLine<'a>>>, (limits, interrupt): (Limits, Interrupt)) -> Self {
        Session {
            port,
            line,
            seat: None,
            named: None,
            limits,
            usual: limits.reply_timeout.longer(Limits::default().reply_timeout),
            node: 0,
            interrupt,
            insists: false,
            ends_at: None,
            since: None,
            listens: false,
            unanswered: None,
            twins: BTreeSet::new(),
            warns: None,
            known: unanswered::Known::default(),
            heard: None,
            ears: None,
        }
    }

    /// Works on the line, which nobody else does meanwhile.
    #[expect(clippy::await_holding_refcell_ref, reason = "whoever shares the line waits for his turn")]
    async fn on_line<T>(&self, work: impl AsyncFnOnce(&mut OpenLine<'a>) -> T) -> T {
        work(&mut self.line.borrow_mut()).await
    }

    /// From now on everything is asked of this node of the system bus, through the drive that is its master; 0 asks the
    /// drive itself (EM-RES-03 manual 5.10.2.2).
    pub fn reach_node(&mut self, node: u8) {
        self.node = node;
    }

    /// System-bus node behind every drive that is asked; 0 is the drive itself.
    pub fn node(&self) -> u8 {
        self.node
    }

    /// From now on every telegram goes out by the clock: a silent line, or a reply that is still owed, is waited for at most
    /// [`INSIST`] before it, then it goes out even into a busy line. For the stop, the refresh and the look of a held run,
    /// which nobody else's talking may put off. The pauses between telegrams of our own are kept.
    pub fn insist(&mut self, on: bool) {
        self.insists = on;
    }

    /// Whether every telegram goes out by the clock.
    pub(super) fn is_insisting(&self) -> bool {
        self.insists
    }

    /// From now on no answer is believed that may be one to the same question from before this moment: for what proves that
    /// a write has been obeyed; the first of several counts. `None`: an older answer will do.
    pub fn believe_since(&mut self, since: Option<Tick>) {
        self.since = since.map(|since| self.since.unwrap_or(since));
    }

    /// Whether that time is over.
    pub fn is_over(&self) -> bool {
        self.ends_at.is_some_and(|at| self.now() >= at)
    }

    /// The longest that one question takes, whatever comes over the line.
    pub fn longest(&self) -> Span {
        self.limits.longest(self.protocol(), self.line())
    }

    /// Asks a station and waits for the answer. Where the echo of the question would pass for its answer, and nobody
    /// knows yet whether the adapter echoes, something else is asked first that tells. A refusal is an answer; an error is that none came
    /// (silence, garbage), that the port is lost, or that somebody interrupted.
    pub async fn ask(&mut self, station: u8, question: impl Into<Question>) -> Result<Answer, AccessError> {
        self.ask_within(station, question, self.limits()).await
    }

    /// Like [`Session::ask`], within time limits of its own.
    pub async fn ask_within(
        &mut self,
        station: u8,
        question: impl Into<Question>,
        limits: Limits,
    ) -> Result<Answer, AccessError> {
        let question = question.into();
        for _ in 0..SOUNDINGS {
            if self.line.borrow().master.needs_sounding(station, &question) {
                self.put(station, sounding().into(), limits).await?;
            }
        }
        self.put(station, question, limits).await
    }

    /// Asks a station although the line may echo, once, for an answer that nobody believes: a sign of who is there.
    pub(super) async fn hail(&mut self, station: u8, question: Question) -> Result<Answer, AccessError> {
        self.put(station, question, Limits { retries: 0, ..self.limits() }).await
    }

    /// Behind the next answer a second one is listened for: what a second drive said before may have met our question.
    pub(super) fn listen(&mut self) {
        self.listens = true;
    }

    async fn put(&mut self, station: u8, question: Question, limits: Limits) -> Result<Answer, AccessError> {
        // What must not wait listens for nobody.
        let listen = if std::mem::take(&mut self.listens) && !self.insists { LISTEN } else { Span::ZERO };
        let insist = self.insists.then_some(INSIST);
        let reply_timeout = if self.insists { limits.reply_timeout.min(UNHURRIED) } else { limits.reply_timeout };
        let limits = Limits { insist, reply_timeout, since: self.since, listen, ..limits };
        let mut asked = 0;
        loop {
            if self.is_over() {
                return Err(self.too_late());
            }
            if let Some(silence) = self.is_mute(station) {
                return Err(silence.into());
            }
            let ends_at = self.take_turn().await;
            let tries = self.tries(limits.retries.saturating_sub(asked));
            let once = (question.clone(), Limits { retries: tries, gives_way: self.gives_way(), ..limits });
            let put = async |line: &mut OpenLine<'a>| line.put(station, once, &self.interrupt, ends_at).await;
            let outcome = self.on_line(put).await;
            self.hear_of(&outcome);
            self.heeds(matches!(outcome, Ok(Ok(_))));
            if let Ok(outcome) = &outcome {
                self.notes_mute(station, &question, outcome);
            }
            if matches!(outcome, Ok(Err(ExchangeError::TwoAnswers { .. }))) {
                self.twins.insert(station);
            }
            match outcome {
                Err(PumpError::TimeUp(error)) => {
                    return Err(self.unanswered.clone().unwrap_or(error.behind(asked)).into());
                }
                Ok(Err(error)) => {
                    let error = error.behind(asked);
                    self.unanswered = Some(error.clone());
                    asked += tries + 1;
                    if asked > limits.retries || !error.is_missing() {
                        return Err(error.into());
                    }
                }
                outcome => {
                    self.unanswered = None;
                    return Ok(outcome??);
                }
            }
        }
    }

    /// Fails where two answers to one question differed: whatever is started there could be started twice.
    pub fn demand_one_drive(&self, station: u8) -> Result<(), AccessError> {
        if self.line.borrow().master.differs(station) {
            Err(ExchangeError::TwoAnswers { station }.into())
        } else {
            Ok(())
        }
    }

    /// What a question ends with that has no time left: with what the line was like before.
    pub(super) fn too_late(&self) -> AccessError {
        self.unanswered.clone().unwrap_or(ExchangeError::NoTime { asked: 0 }).into()
    }

    /// Carries a survey on until it has something to tell.
    pub(super) async fn survey(&mut self, survey: &mut Survey) -> Result<News, AccessError> {
        let survey = async |line: &mut OpenLine<'a>| line.carry(survey, Survey::take_records, &self.interrupt).await;
        Ok(self.on_line(survey).await?)
    }

    /// Listens as long as a window lasts.
    pub(super) async fn eavesdrop(&mut self, window: &mut Window) -> Result<(), AccessError> {
        let listen = async |line: &mut OpenLine<'a>| line.carry(window, Window::take_records, &self.interrupt).await;
        Ok(self.on_line(listen).await?)
    }

    /// What came since the last call and was no answer to a question, and what was sent; kept from the first call on.
    pub(super) fn overheard(&mut self) -> Vec<Record> {
        self.line.borrow_mut().overheard()
    }

    /// A station was asked this otherwise, and its reply may still come.
    pub(super) fn expect(&mut self, station: u8, question: Question) {
        let now = self.now();
        self.line.borrow_mut().master.expect(station, question, now);
    }

    /// Remembers what a drive is, for what is told of its telegrams from now on.
    pub(super) fn knows(&mut self, address: u8, family: &Rc<Family>, order: WordOrder) {
        let mut line = self.line.borrow_mut();
        line.master.has_counters(address, family.counters.iter().map(|row| row.sub));
        line.account.knows(address, family, order);
    }

    /// What was heard on a CAN bus so far, whomever it was for.
    pub(super) fn traffic(&self) -> Option<Traffic> {
        self.heard.as_ref().map(|heard| heard.borrow().clone())
    }

    /// Whether [`Session::retune`] can set another speed or format.
    pub fn can_retune(&self) -> bool {
        let line = self.line.borrow();
        if line.master.line().is_can() { line.link.can_set_bit_rate() } else { line.link.can_set_line() }
    }

    /// Whether speed and format can be changed from here; behind a raw TCP port they are set by other means.
    pub(super) fn can_set_line(&self) -> bool {
        self.line.borrow().link.can_set_line()
    }

    /// Waits without asking anything; ends early with an error if somebody interrupts or the port is lost.
    pub async fn rest(&mut self, span: Span) -> Result<(), AccessError> {
        let until = self.now() + span;
        self.give_way(until).await;
        let rest = async |line: &mut OpenLine<'a>| line.rest(until, &self.interrupt).await;
        Ok(self.on_line(rest).await?)
    }

    /// Waits until bytes come or the time is over; they go to nobody else.
    pub(super) async fn hear(&mut self, until: Tick) -> Result<Wake, AccessError> {
        let hear = async |line: &mut OpenLine<'a>| line.hear(until, &self.interrupt).await;
        Ok(self.on_line(hear).await?)
    }

    /// From now on only these wishes end a question. Fresh ones are nobody's: for what must not be left half done.
    pub fn heed(&mut self, interrupt: Interrupt) {
        self.interrupt = interrupt;
    }

    /// Takes note of who interrupted so far: the line is used on, for the stop that must still go out, until somebody
    /// does so again.
    pub fn note_interrupts(&mut self) {
        self.interrupt.note();
    }

    /// How often somebody has pressed since this program began, as far as note was taken of it.
    pub fn presses(&self) -> u32 {
        self.interrupt.presses()
    }

    /// Whether somebody interrupts, of which no note was taken.
    pub fn is_interrupted(&self) -> bool {
        self.interrupt.is_raised()
    }

    /// Lets the time of the bench follow the wall clock from now on, for verbs that watch or hold.
    pub fn pace(&mut self) {
        self.line.borrow_mut().link.pace();
    }

    /// The time of the link.
    pub fn now(&self) -> Tick {
        self.line.borrow().link.now()
    }

    /// The time of day in UTC (RFC 3339); the bench has none.
    pub fn utc(&self) -> Option<String> {
        self.line.borrow().link.utc()
    }

    /// The time of day, since the beginning of 1970; the bench has none.
    pub fn since_1970(&self) -> Option<Span> {
        self.line.borrow().link.since_1970()
    }

    /// Tells an event to whoever watches.
    pub fn tell(&mut self, event: Event) {
        let event = self.addressed(event);
        self.line.borrow_mut().account.tell(event);
    }

    /// Whether somebody wants to know everything.
    pub fn is_verbose(&self) -> bool {
        self.line.borrow().account.is_verbose()
    }

    /// Whether a drive has answered one question in two ways: most likely they are two with one address.
    pub fn differs(&self, address: u8) -> bool {
        self.line.borrow().master.differs(address)
    }

    /// Whether more than one answer came from an address to one question since this line was opened.
    pub(super) fn answered_twice(&self, address: u8) -> bool {
        self.twins.contains(&address) || self.line.borrow().master.is_contradicted(address)
    }

    /// Counts of what happened on the line.
    pub fn tally(&self) -> Tally {
        self.line.borrow().master.tally()
    }

    /// Name of the port.
    pub fn port(&self) -> &str {
        &self.port
    }

    /// What is spoken.
    pub fn protocol(&self) -> Protocol {
        self.line.borrow().master.protocol()
    }

    /// What is between us and the wire.
    pub fn adapter(&self) -> crate::transport::AdapterInfo {
        self.line.borrow().link.adapter()
    }

    /// Pauses that were kept between replies and the next questions.
    pub fn pauses(&self) -> Pauses {
        self.line.borrow().master.pauses()
    }

    /// Whether the adapter gives back what we send; `None` as long as nothing was asked that tells.
    pub fn echoes(&self) -> Option<bool> {
        self.line.borrow().master.echoes()
    }

    /// Setting of the line.
    pub fn line(&self) -> LineSetting {
        self.line.borrow().master.line()
    }

    /// The bench behind the line, if it is the simulator.
    pub fn bench(&mut self) -> Option<&mut Bench> {
        Rc::get_mut(&mut self.line)?.get_mut().link.bench()
    }
}
