//! Which drive is it? Asked so that nothing in the drive changes and nothing is read away.

use super::access::{AccessError, Refusal};
use super::probe::{STATUS_WORD, presumed};
use super::route::{Cell, Content, Inquiry, No, Route, no, register};
use super::session::Session;
use super::target::Target;
use crate::exchange::{Answer, ExchangeError, Limits, Said};
use crate::outcome::Evidence;
use crate::profile::{Family, Registry, Role, Type};
use crate::protocol::Protocol;
use crate::protocol::modbus::pdu::{Exception, Identification, Reply, Request, identification};
use crate::text::{Text, both};
use std::rc::Rc;

/// Stator frequency: 32 bits on both families, proved by telegrams (sources B), so code 100 reads it.
const STATOR_FREQUENCY: Cell = Cell { number: 210, set: 0 };
/// Frequency setpoint in RAM: write-only on the ACU (CM-485 manual 10.2.3), readable on the ACT (chapter 9).
const SETPOINT_RAM: Cell = Cell { number: 484, set: 0 };
/// Bit 4 of the status word: mains present on the ACU, always 0 on the ACT (CM-485 manual 9.1.3, 10.1).
const VOLTAGE_BIT: u32 = 1 << 4;
/// Error register: not readable (CM-485 manual 6.6).
const NOT_READABLE: u16 = 3;

/// What was found out about a device.
#[derive(Clone, Debug, Default)]
pub struct Finding {
    /// Id of the drive, if it is one that we know.
    pub drive: Option<String>,
    /// What tells so.
    pub evidence: Vec<Evidence>,
    /// What the error register held before it was overwritten by asking; an error if the answer that told it was lost.
    pub kept_register: Option<Result<u16, ExchangeError>>,
    /// It refused a question on the way, which is its last synchronous error now.
    pub refused: bool,
    /// Product code, where it told one (code 43, object 1).
    pub product: Option<String>,
}

impl Finding {
    fn note(&mut self, asked: Text, answered: Text, tells: Text) {
        self.evidence.push(Evidence { asked, answered, tells });
    }

    /// The drive as a target, if it is one that we know.
    pub fn target(&self, address: u8, registry: &Registry) -> Option<Target> {
        let mut target = Target::new(address, registry.family(self.drive.as_ref()?)?);
        target.kept_register = self.kept_register.clone();
        target.introduced = true;
        target.refused_on_the_way = self.refused;
        Some(target)
    }
}

/// Asks a device what it is. Ends with an error only if it does not answer at all.
///
/// The last question may be refused, which overwrites the error register; with `keep_register` the register is read
/// (and so cleared) before it, for a verb that shows it.
pub async fn recognise(
    session: &mut Session<'_>,
    registry: &Registry,
    address: u8,
    keep_register: bool,
) -> Result<Finding, AccessError> {
    let route = Route { node: session.node(), ..presumed(session.protocol(), address) };
    let question = route.question(Inquiry::Read(STATUS_WORD, Type::Uint)).ok_or(AccessError::Unspeakable)?;
    if let Some(family) = registry.family("acu").filter(|_| route.node != 0) {
        // A NAK may come from the drive in between; its cause says so.
        session.demand(route, &family, question.clone()).await?;
    }
    let mut inquest = Inquest::new(session, registry, route);
    // Code 43 harms nobody: an ACTIVE refuses it without touching its error register, while an LXM05 would refuse the
    // status word of an ACTIVE, and forget its last synchronous error over it.
    if matches!(route.protocol, Protocol::Modbus(_)) {
        inquest.introduction().await?;
    }
    if inquest.finding.drive.is_none() {
        let answer = inquest.session.ask(address, question).await?;
        inquest.goes_on(&answer, keep_register).await?;
    }
    Ok(inquest.finding)
}

/// Asks a device of a named family what it tells of itself; `None` if its family tells nothing, or it does not answer.
pub async fn introduce(
    session: &mut Session<'_>,
    registry: &Registry,
    target: &Target,
) -> Result<Option<Finding>, AccessError> {
    if target.family.link.product.is_none() || !matches!(session.protocol(), Protocol::Modbus(_)) {
        return Ok(None);
    }
    let route = presumed(session.protocol(), target.address);
    let mut inquest = Inquest::new(session, registry, route);
    inquest.identification().await?;
    Ok(Some(inquest.finding))
}

/// Whether a device describes itself, by one question; `None` if it does not tell.
pub(super) async fn describes_itself(session: &mut Session<'_>, address: u8) -> Result<Option<bool>, AccessError> {
    if session.protocol() == Protocol::Vabus {
        return Ok(Some(false)); // nobody but the ACTIVE drives is known to speak it
    }
    Ok(match said(session.ask(address, describe_yourself(identification::VENDOR_NAME)).await)? {
        Ok(Said::Modbus(Reply::Identification(_))) => Some(true),
        Ok(Said::Modbus(Reply::Exception { code: Exception::IllegalFunction, .. })) => Some(false),
        _ => None,
    })
}

/// Asks on from the answer to [`super::probe::probe`] what the device is. A survey asks everybody for the status word: any device
/// answers that somehow, but many are silent to codes that they do not know.
pub(super) async fn judge(
    session: &mut Session<'_>,
    registry: &Registry,
    address: u8,
    answer: &Answer,
    keep_register: bool,
) -> Result<Finding, AccessError> {
    let route = Route { node: session.node(), ..presumed(session.protocol(), address) };
    let mut inquest = Inquest::new(session, registry, route);
    inquest.goes_on(answer, keep_register).await?;
    Ok(inquest.finding)
}

/// Asking what a device is.
struct Inquest<'q, 's> {
    session: &'q mut Session<'s>,
    registry: &'q Registry,
    route: Route,
    finding: Finding,
    /// It has described itself, whatever it said.
    introduced: bool,
}

impl<'q, 's> Inquest<'q, 's> {
    fn new(session: &'q mut Session<'s>, registry: &'q Registry, route: Route) -> Self {
        Inquest { session, registry, route, finding: Finding::default(), introduced: false }
    }

    /// Asks on from the answer for the status word.
    async fn goes_on(&mut self, answer: &Answer, keep_register: bool) -> Result<(), AccessError> {
        let status = self.status(answer);
        let speaks = match (self.route.protocol, status) {
            (Protocol::Vabus, _) => true, // nobody else is known to speak it
            (Protocol::Modbus(_), Some(_)) => self.speaks_code_100().await?,
            (Protocol::Modbus(_), None) => false,
        };
        if speaks {
            return self.act_or_acu(status.unwrap_or(0), keep_register).await;
        }
        if !self.introduced {
            self.identification().await?;
        }
        match self.finding.drive {
            None if self.introduced => self.knows_its_address().await,
            _ => Ok(()),
        }
    }

    /// What a product code begins with is printed nowhere for some families. A device that describes itself is still known
    /// by the parameter that holds its address, where the family of the unknown product keeps one.
    async fn knows_its_address(&mut self) -> Result<(), AccessError> {
        for family in self.registry.families().into_iter().filter(|family| family.link.product.is_some()) {
            let Some(param) = family.role(Role::Address) else { continue };
            let route = Route::new(self.route.protocol, &family.link, self.route.address);
            let cell = Cell { number: param.id, set: 0 };
            let Some(question) = route.question(Inquiry::Read(cell, Type::Long)) else { continue };
            let Ok(reply) = said(self.session.ask(self.route.address, question).await)? else { continue };
            let Some(Content::Bits(bits, _)) = route.content(&reply) else { continue };
            // Which half comes first is not known yet.
            let own = u32::from(self.route.address);
            if bits == own || bits == own << 16 {
                let tells = both!("its own address: {title}", "seine eigene Adresse: {title}", title = family.title);
                self.finding.note(Text::name(param.label()), Text::name(own), tells);
                self.finding.drive = Some(family.drive.clone());
                return Ok(());
            }
        }
        Ok(())
    }

    /// The status word, if the first answer is one.
    fn status(&mut self, answer: &Answer) -> Option<u16> {
        let Answer::Reply { said, .. } = answer else { return None };
        let status = self.route.number(said);
        self.finding.refused |= no(said).is_some();
        let answered = match (no(said), status) {
            (Some(no), _) => told(no),
            (None, Some(status)) => Text::name(format!("0x{status:04X}")),
            (None, None) => Text::name("-"),
        };
        let asked = match self.route.protocol {
            Protocol::Modbus(_) => both!("code 3, P.411", "Code 3, P.411"),
            Protocol::Vabus => Text::name("ENQUIRY P.411"),
        };
        let tells = match self.route.protocol {
            Protocol::Modbus(_) => both!("a Modbus device", "ein Modbus-Gerät"),
            Protocol::Vabus => both!("somebody speaks VABus", "jemand spricht VABus"),
        };
        self.finding.note(asked, answered, tells);
        status
    }

    /// Whether the device knows the ACTIVE family's own function code. Silence is an answer too: many slaves ignore
    /// codes that they do not know.
    async fn speaks_code_100(&mut self) -> Result<bool, AccessError> {
        let asked = both!("code 100, P.210", "Code 100, P.210");
        let stranger = both!("no ACTIVE drive: does not know code 100", "kein ACTIVE: kennt Code 100 nicht");
        let (answered, tells, known) = match self.put(Inquiry::Read(STATOR_FREQUENCY, Type::Long)).await? {
            Ok(Said::Modbus(Reply::Long(value))) => {
                let tells =
                    both!("speaks the ACTIVE family's own code 100", "spricht den eigenen Code 100 der ACTIVE-Familie");
                (Text::name(value), tells, true)
            }
            Ok(Said::Modbus(Reply::Exception { code: Exception::IllegalFunction, .. })) => {
                (told(No::Exception(Exception::IllegalFunction)), stranger, false)
            }
            Ok(Said::Modbus(Reply::Exception { code, .. })) => {
                let tells =
                    both!("knows code 100, but not this parameter", "kennt Code 100, aber nicht diesen Parameter");
                (told(No::Exception(code)), tells, true)
            }
            Ok(_) => (Text::name("-"), stranger, false),
            Err(error) => (missing(&error), stranger, false),
        };
        self.finding.note(asked, answered, tells);
        Ok(known)
    }

    async fn act_or_acu(&mut self, status: u16, keep_register: bool) -> Result<(), AccessError> {
        if u32::from(status) & VOLTAGE_BIT != 0 {
            let bit = both!("bit 4 of P.411", "Bit 4 von P.411");
            let tells = both!("voltage enabled exists on the ACU only", "Spannung freigegeben gibt es nur beim ACU");
            self.finding.note(bit, Text::name(1), tells);
            self.finding.drive = Some("acu".to_owned());
            return Ok(());
        }
        let Some(family) = self.registry.family("acu") else { return Ok(()) };
        if keep_register && let Some(question) = register(&family).and_then(|inquiry| self.route.question(inquiry)) {
            self.finding.kept_register = match said(self.session.ask_once(self.route, question).await)? {
                Ok(said) => self.route.number(&said).map(Ok),
                Err(error) => Some(Err(error)),
            };
        }
        self.reads_setpoint(&family).await
    }

    async fn reads_setpoint(&mut self, family: &Rc<Family>) -> Result<(), AccessError> {
        let asked = match self.route.protocol {
            Protocol::Modbus(_) => both!("code 100, P.484", "Code 100, P.484"),
            Protocol::Vabus => Text::name("ENQUIRY P.484"),
        };
        let Some(question) = self.route.question(Inquiry::Read(SETPOINT_RAM, Type::Long)) else { return Ok(()) };
        match self.session.demand(self.route, family, question).await {
            Ok(_) => {
                let tells = both!("the line setpoint is readable: ACT", "der Liniensollwert ist lesbar: ACT");
                self.finding.note(asked, both!("a value", "ein Wert"), tells);
                self.finding.drive = Some("act".to_owned());
            }
            Err(AccessError::Refused(Refusal { cause: Some(NOT_READABLE), .. })) => {
                let tells = both!("the line setpoint is write-only: ACU", "der Liniensollwert ist nur schreibbar: ACU");
                self.finding.note(asked, Text::name("P.11 = 3"), tells);
                self.finding.drive = Some("acu".to_owned());
            }
            Err(AccessError::Refused(refusal)) => {
                let tells =
                    both!("tells neither ACT nor ACU; name it with --drive", "weder ACT noch ACU; mit --drive angeben");
                self.finding.note(asked, told(refusal.no), tells);
            }
            Err(error) => return Err(error),
        }
        Ok(())
    }

    /// Code 43, once, before anything else: tells the drive if the answer comes. If none comes, nothing is noted, because
    /// [`Inquest::identification`] asks again where it matters.
    async fn introduction(&mut self) -> Result<(), AccessError> {
        let once = Limits { retries: 0, ..self.session.limits() };
        let answer = self.session.ask_within(self.route.address, describe_yourself(identification::VENDOR_NAME), once);
        if let Ok(Said::Modbus(Reply::Identification(first))) = said(answer.await)? {
            let told = self.rest_of(first).await?;
            self.described(&told);
        }
        Ok(())
    }

    /// Asks the device for its own description, code 43: the family whose product code it begins with. A lost reply is
    /// asked for again, and a garbled one tells nothing: neither makes a stranger of a drive.
    async fn identification(&mut self) -> Result<(), AccessError> {
        let answered = match self.ask_for(identification::VENDOR_NAME).await? {
            Ok(Said::Modbus(Reply::Identification(first))) => {
                let told = self.rest_of(first).await?;
                self.described(&told);
                return Ok(());
            }
            Ok(said) => no(&said).map_or_else(|| Text::name("-"), told),
            Err(error @ ExchangeError::Silence { .. }) => missing(&error),
            Err(error) => return Err(AccessError::Exchange(error)),
        };
        let tells = both!("does not describe itself", "beschreibt sich nicht");
        self.finding.note(asked_for_itself(), answered, tells);
        Ok(())
    }

    /// What the description tells.
    fn described(&mut self, described: &Identification) {
        let product = text(described, identification::PRODUCT_CODE);
        let mut families = self.registry.families().into_iter();
        let family = families
            .find(|family| family.link.product.as_ref().is_some_and(|start| product.starts_with(start.as_str())));
        let tells = match &family {
            Some(family) => family.title.clone(),
            None => both!("a product that we do not know", "ein Produkt, das wir nicht kennen"),
        };
        let objects = described.objects.iter().filter(|object| !object.value.is_empty());
        let words: Vec<_> = objects.map(|object| String::from_utf8_lossy(&object.value)).collect();
        let mut answered = Text::name(if words.is_empty() { "-".to_owned() } else { words.join(", ") });
        if described.next.is_some() {
            answered = both!(
                "{answered} … (cut off: it says again and again that more follows)",
                "{answered} … (abgebrochen: es meldet immer wieder, dass noch etwas folgt)",
                answered
            );
        }
        self.finding.note(asked_for_itself(), answered, tells);
        self.finding.drive = family.map(|family| family.drive.clone());
        self.finding.product = Some(product).filter(|product| !product.is_empty());
        self.introduced = true;
    }

    /// What the device tells of itself, in several telegrams if it takes them: every one names a later object to go on
    /// with. Where it would go on without end, `next` stays set.
    async fn rest_of(&mut self, first: Identification) -> Result<Identification, AccessError> {
        let mut described = first;
        let mut asked = identification::VENDOR_NAME;
        for _ in 0..MOST_PIECES {
            let Some(next) = described.next.filter(|next| *next > asked) else { break };
            asked = next;
            match self.ask_for(next).await? {
                Ok(Said::Modbus(Reply::Identification(more))) => {
                    described.next = more.next;
                    described.objects.extend(more.objects);
                }
                // Without its product code nobody knows what it is.
                Err(error) if described.object(identification::PRODUCT_CODE).is_none() => {
                    return Err(AccessError::Exchange(error));
                }
                // What came before the missing piece counts.
                _ => {
                    described.next = None;
                    break;
                }
            }
        }
        Ok(described)
    }

    async fn ask_for(&mut self, object: u8) -> Result<Result<Said, ExchangeError>, AccessError> {
        said(self.session.ask(self.route.address, describe_yourself(object)).await)
    }

    async fn put(&mut self, inquiry: Inquiry) -> Result<Result<Said, ExchangeError>, AccessError> {
        let question = self.route.question(inquiry).ok_or(AccessError::Unspeakable)?;
        said(self.session.ask(self.route.address, question).await)
    }
}

/// Code 43: asks for the basic objects from this one on.
fn describe_yourself(object: u8) -> Request {
    Request::ReadIdentification { category: identification::BASIC, object }
}

/// Telegrams that a description may take behind the first. The basic objects are three (V1.1b3, 6.21), so that each may
/// come alone, with room for a maker's own.
const MOST_PIECES: usize = 8;

/// An answer, or why there is none; what ends the session is an error.
fn said(answer: Result<Answer, AccessError>) -> Result<Result<Said, ExchangeError>, AccessError> {
    match answer {
        Ok(Answer::Reply { said, .. }) => Ok(Ok(said)),
        Ok(Answer::Broadcast) => Ok(Err(ExchangeError::BroadcastRead)),
        Err(AccessError::Exchange(error)) => Ok(Err(error)),
        Err(error) => Err(error),
    }
}

fn asked_for_itself() -> Text {
    both!("code 43, identification", "Code 43, Identifikation")
}

fn text(described: &Identification, object: u8) -> String {
    described.object(object).map_or_else(String::new, |value| String::from_utf8_lossy(value).into_owned())
}

fn missing(error: &ExchangeError) -> Text {
    match error {
        ExchangeError::Silence { .. } => both!("no reply", "keine Antwort"),
        _ => both!("no valid answer", "keine gültige Antwort"),
    }
}

fn told(no: No) -> Text {
    match no {
        No::Exception(code) => both!("exception {code}", "Ausnahme {code}"),
        No::Nak => Text::name("NAK"),
    }
}
