//! An open line: asks questions, tells what goes over it, and turns what goes wrong into failures with a hint.

use super::interrupt::Interrupt;
use super::pump::{self, PumpError};
use super::route::{No, Route, no};
use super::{decode, trouble};
use crate::exchange::{
    Answer, ExchangeError, INSIST, Limits, Master, News, Pauses, Question, Record, Said, Survey, Tally, Verdict,
};
use crate::failure::{Class, Failure};
use crate::files::{self, FileError};
use crate::outcome::Event;
use crate::profile::{Cause, Family, Lang, Registry};
use crate::protocol::Protocol;
use crate::protocol::line::LineSetting;
use crate::protocol::modbus::pdu::WordOrder;
use crate::protocol::modbus::{Framing, Hex};
use crate::simulator::Bench;
use crate::tick::{Span, Tick};
use crate::transport::{Link, LinkError, Port, Rs485, Trace, Wake, list_ports};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::rc::Rc;

/// A gateway waits for its stations itself and then says so; many wait for a second or more.
const GATEWAY_PATIENCE: Span = Span::from_secs(3);
/// TCP loses nothing, and a gateway says itself when a station is silent: one that says nothing is asked once.
const GATEWAY_REPEATS: u8 = 0;

/// Strange telegrams that are kept until somebody asks for them.
const MOST_OVERHEARD: usize = 4_096;

/// How to open a line.
#[derive(Debug)]
pub struct Opening<'a> {
    /// Where the drives are.
    pub port: &'a Port,
    /// Speed and character format.
    pub line: LineSetting,
    /// Who switches the direction of an RS-485 line.
    pub rs485: Rs485,
    /// What is spoken.
    pub protocol: Protocol,
    /// How long to wait for a reply; `None` for the manual's time.
    pub timeout: Option<Span>,
    /// How often to repeat a question; `None` for the usual number.
    pub retries: Option<u8>,
    /// File to record the line to, if anybody wants that.
    pub trace: Option<Recording<'a>>,
    /// Whether every telegram is told as an event.
    pub verbose: bool,
    /// Language of what is told.
    pub lang: Lang,
}

/// Where a line is recorded to.
#[derive(Clone, Copy, Debug)]
pub struct Recording<'a> {
    /// The file.
    pub path: &'a Path,
    /// Whether one that exists is replaced.
    pub overwrite: bool,
}

/// An open line.
pub struct Session<'a> {
    port: String,
    link: Link,
    master: Master,
    /// System-bus node behind every drive that is asked; 0 is the drive itself.
    node: u8,
    observe: &'a mut dyn FnMut(Event),
    interrupt: Interrupt,
    /// Whether telegrams go out by the clock, whatever is on the line.
    insists: bool,
    /// Every question ends then, whatever has come of it.
    ends_at: Option<Tick>,
    /// No answer is believed that may be one to the same question from before.
    since: Option<Tick>,
    /// Why the last question brought no answer.
    unanswered: Option<ExchangeError>,
    /// Telegrams and garbage that were not for the master, if anybody wants them.
    overheard: Option<Vec<Record>>,
    /// What is known of the drives by address, to name what goes over the line.
    known: BTreeMap<u8, Known>,
    /// Drives of which it was told that they answer twice.
    twice: BTreeSet<u8>,
    verbose: bool,
    lang: Lang,
}

/// A drive whose telegrams can be told in the words of its family.
struct Known {
    family: Rc<Family>,
    /// The upper half of a value in two registers comes first.
    order: WordOrder,
}

impl std::fmt::Debug for Session<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Session").field("link", &self.link).field("master", &self.master).finish_non_exhaustive()
    }
}

/// The drive understood the question and said no.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// What the reply tells.
    pub no: No,
    /// The cause, read back at once from where the family keeps it: P.11 of the ACTIVE family.
    pub cause: Option<u16>,
    /// The answer that told the cause was lost, and reading had cleared it.
    pub unheard: bool,
}

/// Why a question brought no value.
#[derive(Debug, thiserror::Error)]
pub enum AccessError {
    /// The drive said no.
    #[error("refused: {:?}", .0.no)]
    Refused(Refusal),
    /// No valid reply.
    #[error(transparent)]
    Exchange(#[from] ExchangeError),
    /// The protocol on the line, or the family, has no telegram for this.
    #[error("there is no telegram for this")]
    Unspeakable,
    /// The port is gone.
    #[error(transparent)]
    Link(#[from] LinkError),
    /// Somebody pressed Ctrl-C.
    #[error("interrupted")]
    Interrupted,
}

impl<'a> Session<'a> {
    /// Opens the line.
    pub async fn open(
        opening: Opening<'_>,
        registry: &Registry,
        interrupt: Interrupt,
        observe: &'a mut dyn FnMut(Event),
    ) -> Result<Self, Failure> {
        let Opening { port, line, rs485, protocol, timeout, retries, trace, verbose, lang } = opening;
        let usual = Limits::default();
        let (patience, repeats) = match protocol == Framing::Tcp.into() {
            true => (GATEWAY_PATIENCE, GATEWAY_REPEATS),
            false => (usual.reply_timeout, usual.retries),
        };
        let limits =
            Limits { reply_timeout: timeout.unwrap_or(patience), retries: retries.unwrap_or(repeats), ..usual };
        let mut link = match port {
            Port::Sim(file) => Link::open_sim(super::bench::load(file.as_deref(), registry)?, line),
            port => tokio::select! {
                link = Link::open(port, line, rs485) => link.map_err(|error| trouble::link(&error, lang))?,
                () = interrupt.raised() => return Err(trouble::interrupted(lang)),
            },
        };
        if let Some(recording) = trace {
            link.record_to(open_trace(recording, &format!("{line}, {protocol}"), lang)?);
        }
        for deviation in link.deviations() {
            observe(Event::Note(format!("{port}: {deviation}")));
        }
        let wired = is_wired(port);
        let (port, mut master) = (port.to_string(), Master::new(protocol, line, limits));
        master.set_wired(wired);
        Ok(Session {
            port,
            link,
            master,
            node: 0,
            observe,
            interrupt,
            insists: false,
            ends_at: None,
            since: None,
            unanswered: None,
            overheard: None,
            known: BTreeMap::new(),
            twice: BTreeSet::new(),
            verbose,
            lang,
        })
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

    /// From now on every question ends at this time, whatever has come of it, and none is asked any more; `None`: each has
    /// the time that it needs. For what ends by the clock, and for what must not be pursued for ever.
    pub fn end_at(&mut self, at: Option<Tick>) {
        self.ends_at = at;
    }

    /// From now on no answer is believed that may be one to the same question from before this moment: for what proves that
    /// a write has been obeyed; the first of several counts. `None`: an older answer will do.
    pub fn believe_since(&mut self, since: Option<Tick>) {
        self.since = since.map(|since| self.since.unwrap_or(since));
    }

    /// Whether that time is over.
    pub fn is_over(&self) -> bool {
        self.ends_at.is_some_and(|at| self.link.now() >= at)
    }

    /// The longest that one question takes, whatever comes over the line.
    pub fn longest(&self) -> Span {
        self.master.limits().longest(self.protocol(), self.line())
    }

    /// Asks a station and waits for the answer. Where the echo of the question would pass for its answer, and nobody
    /// knows yet whether the adapter echoes, something else is asked first that tells.
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
        if self.master.needs_sounding(station, &question) {
            self.put(station, super::family::sounding().into(), limits).await?;
        }
        self.put(station, question, limits).await
    }

    /// Asks for what is gone once it has been read: once, because asked again it would say that nothing has happened, and
    /// as patiently as one repeat would be, for a slow drive. What comes later still is an older answer as likely as this
    /// one. An answer that is lost, or may be another's, is an error: what was there then is not known.
    pub(super) async fn ask_once(&mut self, route: Route, question: Question) -> Result<Answer, AccessError> {
        let limits = self.limits();
        let reply_timeout = limits.reply_timeout.times(u64::from(limits.retries.min(1)) + 1);
        self.ask_within(route.address, question, Limits { witness: false, retries: 0, reply_timeout, ..limits }).await
    }

    /// Asks a station although the line may echo: for a stop, which must not wait until that is known. What comes back may be
    /// its own echo, and proves nothing.
    pub(super) async fn blurt(&mut self, station: u8, question: Question) -> Result<Answer, AccessError> {
        self.put(station, question, self.limits()).await
    }

    /// Asks a station although the line may echo, once, for an answer that nobody believes: a sign of who is there.
    pub(super) async fn hail(&mut self, station: u8, question: Question) -> Result<Answer, AccessError> {
        self.put(station, question, Limits { retries: 0, ..self.limits() }).await
    }

    async fn put(&mut self, station: u8, question: Question, limits: Limits) -> Result<Answer, AccessError> {
        if self.is_over() {
            return Err(self.too_late());
        }
        pump::drain(&mut self.master, &mut self.link).await?;
        let limits = Limits { insist: self.insists.then_some(INSIST), since: self.since, ..limits };
        self.master.ask_within(station, question, limits, self.link.now());
        let outcome = pump::run(&mut self.master, &mut self.link, &self.interrupt, self.ends_at).await;
        let records = self.master.take_records();
        self.show(&records, Some(station));
        if let Some(overheard) = &mut self.overheard {
            let strange = |record: &Record| matches!(record.verdict, Verdict::Stray { .. } | Verdict::Garbage);
            let room = MOST_OVERHEARD.saturating_sub(overheard.len());
            overheard.extend(records.into_iter().filter(strange).take(room));
        }
        self.tell_twice(station);
        match outcome {
            Err(PumpError::TimeUp) => return Err(self.too_late()),
            Ok(Err(ref error)) => self.unanswered = Some(error.clone()),
            _ => {}
        }
        Ok(outcome??)
    }

    /// The language in which things are told.
    pub fn lang(&self) -> Lang {
        self.lang
    }

    /// Fails where two answers to one question differed: whatever is started there could be started twice.
    pub fn demand_one_drive(&self, station: u8) -> Result<(), AccessError> {
        if self.master.differs(station) { Err(ExchangeError::TwoAnswers { station }.into()) } else { Ok(()) }
    }

    /// Tells once that everything is answered twice: what is read may come from either of two drives.
    fn tell_twice(&mut self, station: u8) {
        if self.master.answers_twice(station) && self.twice.insert(station) {
            let note = match self.lang {
                Lang::En => format!(
                    "address {station}: every question is answered twice: two drives with one address, or a repeater"
                ),
                Lang::De => format!(
                    "Adresse {station}: jede Frage wird zweimal beantwortet: zwei Antriebe mit einer Adresse, oder ein \
                     Repeater"
                ),
            };
            (self.observe)(Event::Note(note));
        }
    }

    /// What a question ends with that has no time left: with what the line was like before.
    pub(super) fn too_late(&self) -> AccessError {
        self.unanswered.clone().unwrap_or(ExchangeError::Unproven { asked: 0 }).into()
    }

    /// Carries a survey on until it has something to tell.
    pub(super) async fn survey(&mut self, survey: &mut Survey) -> Result<News, AccessError> {
        let outcome = pump::run(survey, &mut self.link, &self.interrupt, None).await;
        self.show(&survey.take_records(), None);
        Ok(outcome?)
    }

    /// What came since the last call and was no answer to a question; kept from the first call on.
    pub(super) fn overheard(&mut self) -> Vec<Record> {
        std::mem::take(self.overheard.get_or_insert_default())
    }

    /// A station was asked this otherwise, and its reply may still come.
    pub(super) fn expect(&mut self, station: u8, question: Question) {
        self.master.expect(station, question, self.link.now());
    }

    /// Remembers what a drive is, for what is told of its telegrams from now on.
    pub(super) fn knows(&mut self, address: u8, family: &Rc<Family>, order: WordOrder) {
        self.master.has_counters(address, family.counters.iter().map(|row| row.sub));
        if self.verbose {
            self.known.insert(address, Known { family: family.clone(), order });
        }
    }

    /// Tells what went over the line while `asked` was asked.
    fn show(&mut self, records: &[Record], asked: Option<u8>) {
        if !self.verbose {
            return;
        }
        for record in records {
            let station = match record.verdict {
                Verdict::Stray { station } => Some(station),
                _ => asked,
            };
            let known = station.and_then(|station| self.known.get(&station));
            (self.observe)(telegram_event(self.master.protocol(), self.lang, known, record));
        }
    }

    /// Asks a drive for an answer that is no refusal; after one asks for the cause at once, because anything else could
    /// overwrite it. A broadcast answers nothing.
    pub async fn demand(
        &mut self,
        route: Route,
        family: &Family,
        question: Question,
    ) -> Result<Option<(Said, Span)>, AccessError> {
        self.demand_within(route, family, question, self.limits()).await
    }

    /// Like [`Session::demand`], within time limits of its own; the cause has the usual ones.
    pub async fn demand_within(
        &mut self,
        route: Route,
        family: &Family,
        question: Question,
        limits: Limits,
    ) -> Result<Option<(Said, Span)>, AccessError> {
        let (said, after) = match self.ask_within(route.address, question, limits).await? {
            Answer::Broadcast => return Ok(None),
            Answer::Reply { said, after } => (said, after),
        };
        let Some(no) = no(&said) else { return Ok(Some((said, after))) };
        let (cause, unheard) = match route.cause(family, no) {
            Some(question) => self.cause(route, family, question).await?,
            None => (None, false),
        };
        // 0 is "nothing was refused": the register belongs to something else, or there is none.
        Err(AccessError::Refused(Refusal { no, cause: cause.filter(|&cause| cause != 0), unheard }))
    }

    /// Asks why the drive said no, and tells whether the answer was lost.
    async fn cause(
        &mut self,
        route: Route,
        family: &Family,
        question: Question,
    ) -> Result<(Option<u16>, bool), AccessError> {
        let answer = match family.link.cause {
            Cause::ErrorRegister => self.ask_once(route, question).await,
            // It stands until the next one. A witness may be refused, and be the next one.
            Cause::Diagnostics(_) => {
                let limits = Limits { witness: false, ..self.limits() };
                self.ask_within(route.address, question, limits).await
            }
        };
        match answer {
            Ok(Answer::Reply { said, .. }) => Ok((route.number(&said), false)),
            Ok(Answer::Broadcast) => Ok((None, false)),
            Err(AccessError::Exchange(_)) => Ok((None, true)),
            Err(error) => Err(error),
        }
    }

    /// Asks for a 16-bit number; `None` if the station answers with something else.
    pub(super) async fn number(&mut self, route: Route, question: Question) -> Result<Option<u16>, AccessError> {
        match self.ask(route.address, question).await {
            Ok(Answer::Reply { said, .. }) => Ok(route.number(&said)),
            Ok(Answer::Broadcast) | Err(AccessError::Exchange(_)) => Ok(None),
            Err(error) => Err(error),
        }
    }

    /// Other speed, format or protocol from now on.
    pub async fn retune(&mut self, protocol: Protocol, line: LineSetting) -> Result<(), AccessError> {
        self.link.set_line(line).await?;
        self.master.retune(protocol, line, self.link.now());
        Ok(())
    }

    /// Whether [`Session::retune`] can set another speed or format.
    pub fn can_retune(&self) -> bool {
        self.link.can_set_line()
    }

    /// Whether speed and format can be changed from here; behind a raw TCP port they are set by other means.
    pub(super) fn can_set_line(&self) -> bool {
        self.link.can_set_line()
    }

    /// Waits without asking anything; ends early with an error if somebody interrupts or the port is lost.
    pub async fn rest(&mut self, span: Span) -> Result<(), AccessError> {
        Ok(pump::rest(&mut self.master, &mut self.link, &self.interrupt, span).await?)
    }

    /// Waits until bytes come or the time is over; they go to nobody else.
    pub(super) async fn hear(&mut self, until: Tick) -> Result<Wake, AccessError> {
        Ok(pump::hear(&mut self.link, &self.interrupt, until).await?)
    }

    /// Waits for something that is not on the line, such as the answer to a question, and keeps the line meanwhile: what
    /// comes is nobody's answer. Ends early with an error if somebody interrupts, also in the same moment, or if the port
    /// is lost. The time of the bench stands still.
    pub async fn during<T>(&mut self, wait: impl Future<Output = T>) -> Result<T, AccessError> {
        let interrupt = self.interrupt.clone();
        let virtual_time = self.bench().is_some();
        let keep = async {
            loop {
                match virtual_time {
                    true => interrupt.raised().await,
                    false => self.rest(Span::from_secs(60)).await?,
                }
                if interrupt.is_raised() {
                    return Err(AccessError::Interrupted);
                }
            }
        };
        let waited = tokio::select! {
            biased;
            waited = wait => waited,
            failed = keep => failed?,
        };
        if self.interrupt.is_raised() { Err(AccessError::Interrupted) } else { Ok(waited) }
    }

    /// From now on the line is used whether somebody interrupts or not: for what must not be left half done.
    pub fn ignore_interrupts(&mut self) {
        self.interrupt = Interrupt::default();
    }

    /// Takes note of who interrupted so far: the line is used on, for the stop that must still go out, until somebody
    /// does so again.
    pub fn note_interrupts(&mut self) {
        self.interrupt.note();
    }

    /// Opens a port that was lost anew; its clock goes on. Then listens for as long as a reply may take, so that what
    /// was on its way to a lost question is nobody's answer.
    pub async fn reopen(&mut self) -> Result<(), AccessError> {
        let interrupt = self.interrupt.clone();
        tokio::select! {
            reopened = self.link.reopen() => reopened?,
            () = interrupt.raised() => return Err(AccessError::Interrupted),
        }
        if let Some(name) = self.link.name() {
            name.clone_into(&mut self.port);
        }
        self.rest(self.limits().reply_timeout).await
    }

    /// Lets the time of the bench follow the wall clock from now on, for verbs that watch or hold.
    pub fn pace(&mut self) {
        self.link.pace();
    }

    /// The time of the link.
    pub fn now(&self) -> Tick {
        self.link.now()
    }

    /// Tells an event to whoever watches.
    pub fn tell(&mut self, event: Event) {
        (self.observe)(event);
    }

    /// Counts of what happened on the line.
    pub fn tally(&self) -> Tally {
        self.master.tally()
    }

    /// Time limits.
    pub fn limits(&self) -> Limits {
        self.master.limits()
    }

    /// Other time limits from now on.
    pub fn set_limits(&mut self, limits: Limits) {
        self.master.set_limits(limits);
    }

    /// Works within these time limits; afterwards those from before hold again.
    pub(super) async fn within<T>(&mut self, limits: Limits, work: impl AsyncFnOnce(&mut Self) -> T) -> T {
        let before = self.limits();
        self.set_limits(limits);
        let done = work(self).await;
        self.set_limits(before);
        done
    }

    /// Other number of repeats from now on; returns the one that held until now.
    pub fn set_retries(&mut self, retries: u8) -> u8 {
        let limits = self.limits();
        self.set_limits(Limits { retries, ..limits });
        limits.retries
    }

    /// Name of the port.
    pub fn port(&self) -> &str {
        &self.port
    }

    /// What is spoken.
    pub fn protocol(&self) -> Protocol {
        self.master.protocol()
    }

    /// What is between us and the wire.
    pub fn adapter(&self) -> crate::transport::AdapterInfo {
        self.link.adapter()
    }

    /// Pauses that were kept between replies and the next questions.
    pub fn pauses(&self) -> Pauses {
        self.master.pauses()
    }

    /// Whether the adapter gives back what we send; `None` as long as nothing was asked that tells.
    pub fn echoes(&self) -> Option<bool> {
        self.master.echoes()
    }

    /// Setting of the line.
    pub fn line(&self) -> LineSetting {
        self.master.line()
    }

    /// The bench behind the line, if it is the simulator.
    pub fn bench(&mut self) -> Option<&mut Bench> {
        self.link.bench()
    }
}

/// A drive that answers late may still owe a reply. Nobody else gets the line before it has come or cannot come any
/// more: the next program would take it for the answer to its own question. Costs nothing unless a reply is missing.
impl Drop for Session<'_> {
    fn drop(&mut self) {
        if let Some(until) = self.master.owes_until(self.link.now()) {
            self.link.outlast(until);
        }
    }
}

/// Whether every character takes its time on the way: on the bench and on a serial port, but not on a pty, which hands over
/// what it gets at once, nor behind a network.
fn is_wired(port: &Port) -> bool {
    match port {
        Port::Sim(_) => true,
        Port::Serial(name) => {
            let real = std::fs::canonicalize(name).unwrap_or_else(|_| name.into());
            !(real.starts_with("/dev/pts") || real.starts_with("/dev/ttys"))
        }
        _ => false,
    }
}

/// The port that was named, or the one USB serial adapter that is plugged in, which is said.
pub fn open_port(named: Option<&Port>, lang: Lang, observe: &mut dyn FnMut(Event)) -> Result<Port, Failure> {
    if let Some(port) = named {
        return Ok(port.clone());
    }
    let ports = list_ports();
    let adapters: Vec<_> = ports.iter().filter(|port| port.usb).collect();
    if let [only] = adapters.as_slice() {
        let taking = lang.pick("no port given, taking", "kein Anschluss angegeben, es wird genommen:");
        observe(Event::Note(format!("{taking} {only}")));
        return Ok(Port::Serial(only.name.clone()));
    }
    let message = match (adapters.len(), lang) {
        (0, Lang::En) => "no port given, and no USB serial adapter is plugged in",
        (0, Lang::De) => "kein Anschluss angegeben, und kein USB-Adapter ist eingesteckt",
        (_, Lang::En) => "no port given, and more than one USB serial adapter is plugged in",
        (_, Lang::De) => "kein Anschluss angegeben, und mehr als ein USB-Adapter ist eingesteckt",
    };
    let hint = format!("{} -p; {}", lang.pick("name it with", "angeben mit"), trouble::found_ports(lang));
    Err(Failure::new(Class::Port, "port.none", message).hint(hint))
}

fn open_trace(recording: Recording<'_>, about: &str, lang: Lang) -> Result<Trace, Failure> {
    let Recording { path, overwrite } = recording;
    let trace = files::create(path, overwrite).and_then(|file| Ok(Trace::new(Box::new(file), about)?));
    trace.map_err(|error| {
        let failure = Failure::new(Class::Data, "data.trace", format!("{}: {error}", path.display()));
        match error {
            FileError::Exists => failure.hint(lang.pick(
                "name another file; --force replaces this one, and forces whatever else the verb would refuse",
                "eine andere Datei nennen; --force ersetzt diese und erzwingt auch, was der Befehl sonst ablehnte",
            )),
            _ => failure,
        }
    })
}

fn telegram_event(protocol: Protocol, lang: Lang, known: Option<&Known>, record: &Record) -> Event {
    let (direction, is_request) = match record.verdict {
        Verdict::Request | Verdict::Fence | Verdict::Farewell => ('>', Some(true)),
        Verdict::Reply => ('<', Some(false)),
        Verdict::Echo => ('~', Some(true)),
        Verdict::Stray { .. } | Verdict::Garbage => ('~', Some(false)),
    };
    let family = known.map(|known| &*known.family);
    let order = known.map_or_else(WordOrder::default, |known| known.order);
    let reader = decode::Reader { protocol, node: 0, family, order, lang };
    let told = reader.telegram(&record.bytes, is_request);
    let meaning = match record.verdict {
        Verdict::Fence => format!("fence: {}", told.meaning),
        Verdict::Echo => format!("{}: {}", lang.pick("echo of the adapter", "Echo des Adapters"), told.meaning),
        Verdict::Stray { station } => format!("not the answer, from address {station}: {}", told.meaning),
        _ => told.meaning,
    };
    Event::Telegram { at_us: record.at.as_micros(), direction, hex: Hex(&record.bytes).to_string(), meaning }
}

impl From<PumpError> for AccessError {
    fn from(error: PumpError) -> Self {
        match error {
            PumpError::Link(error) => error.into(),
            PumpError::Interrupted => AccessError::Interrupted,
            PumpError::TimeUp => ExchangeError::Unproven { asked: 0 }.into(),
        }
    }
}

impl AccessError {
    /// Whether the whole session is over, not just this question.
    pub fn is_fatal(&self) -> bool {
        matches!(self, AccessError::Link(_) | AccessError::Interrupted)
    }

    /// Whether the drive said no.
    pub fn is_refused(&self) -> bool {
        matches!(self, AccessError::Refused(_))
    }
}
