//! Which drive is it? Asked so that nothing in the drive changes and nothing is read away.

mod active;
mod description;
mod inverter;

use self::description::describe_yourself;
use super::access::AccessError;
use super::decode::wrong;
use super::probe::{STATUS_WORD, presumed};
use super::route::{Cell, Content, Inquiry, No, Route, no};
use super::session::Session;
use super::target::Target;
use crate::exchange::{Answer, ExchangeError, Limits, Said};
use crate::outcome::Evidence;
use crate::profile::{Registry, Role, Type};
use crate::protocol::Protocol;
use crate::protocol::modbus::Framing;
use crate::protocol::modbus::pdu::{Exception, Reply, identification};
use crate::text::{Text, both};
use crate::tick::Span;

/// A gateway that gave no word in all its time, not even that nobody answers it, has no more than this for the next one.
const MUTE: Span = Span::from_secs(1);

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
    /// It was too busy to say what it is (exceptions 5 and 6).
    pub busy: bool,
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
    if session.protocol() == Protocol::Pkw {
        return inverter::series(session, address).await;
    }
    let route = Route { node: session.node(), ..presumed(session.protocol(), address) };
    let question = route.question(Inquiry::Read(STATUS_WORD, Type::Uint)).ok_or(AccessError::Unspeakable)?;
    if let Some(family) = registry.presumed().filter(|_| route.node != 0) {
        // A NAK may come from the drive in between; its cause says so.
        session.demand(route, &family, question.clone()).await?;
    }
    let mut inquest = Inquest::new(session, registry, route);
    // Code 43 harms nobody: an ACTIVE refuses it without touching its error register, while an LXM05 would refuse the
    // status word of an ACTIVE, and forget its last synchronous error over it.
    let is_silent = matches!(route.protocol, Protocol::Modbus(_)) && inquest.introduction().await?;
    if inquest.finding.drive.is_none() {
        let mut limits = inquest.session.limits();
        if is_silent && route.protocol == Protocol::Modbus(Framing::Tcp) {
            limits.reply_timeout = limits.reply_timeout.min(MUTE);
        }
        let asks = async |session: &mut Session<'_>| session.ask_patiently(address, &question).await;
        let answer = inquest.session.within(limits, asks).await?;
        inquest.goes_on(&answer, keep_register).await?;
    }
    if inquest.finding.drive.is_none() && inquest.fell_silent {
        // Many slaves ignore codes that they do not know; who is gone answers nothing any more.
        inquest.session.ask(address, question).await?;
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
    if !matches!(session.protocol(), Protocol::Modbus(_)) {
        return Ok(Some(false)); // nobody but the ACTIVE drives is known to speak VABus, and SDO has no such question
    }
    let told = said(session.ask(address, describe_yourself(identification::VENDOR_NAME)).await)?;
    Ok(told.ok().and_then(|told| described(&told)))
}

/// The same, where the answer came when nobody waited for it any more.
pub(super) fn described_itself(session: &Session<'_>, address: u8) -> Option<bool> {
    let question = describe_yourself(identification::VENDOR_NAME).into();
    session.came_late(address, &question).and_then(|told| described(&told))
}

fn described(said: &Said) -> Option<bool> {
    match said {
        Said::Modbus(Reply::Identification(_)) => Some(true),
        Said::Modbus(Reply::Exception { code: Exception::IllegalFunction, .. }) => Some(false),
        _ => None,
    }
}

/// Whether anybody answers at an address, whatever he says.
pub async fn is_there(session: &mut Session<'_>, address: u8) -> bool {
    let route = Route { node: session.node(), ..presumed(session.protocol(), address) };
    let question = match session.protocol() {
        Protocol::Modbus(_) => Some(describe_yourself(identification::VENDOR_NAME).into()),
        _ => route.question(Inquiry::Read(STATUS_WORD, Type::Uint)),
    };
    let Some(question) = question else { return false };
    let limits = Limits { retries: 1, ..session.limits() };
    session.ask_within(address, question, limits).await.is_ok()
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
    /// It did not answer what an ACTIVE answers.
    fell_silent: bool,
}

impl<'q, 's> Inquest<'q, 's> {
    fn new(session: &'q mut Session<'s>, registry: &'q Registry, route: Route) -> Self {
        Inquest { session, registry, route, finding: Finding::default(), introduced: false, fell_silent: false }
    }

    /// Asks on from the answer for the status word.
    async fn goes_on(&mut self, answer: &Answer, keep_register: bool) -> Result<(), AccessError> {
        let status = self.status(answer);
        let speaks = match (self.route.protocol, status) {
            (Protocol::Vabus, _) => true, // nobody else is known to speak it
            // What is no drive knows no object 019Bh, or has something else there.
            (Protocol::Sdo(_), status) => status.is_some(),
            (Protocol::Pkw, _) => false,
            (Protocol::Modbus(_), Some(_)) => self.speaks_code_100().await?,
            (Protocol::Modbus(_), None) => false,
        };
        if speaks {
            return self.act_or_acu(status.unwrap_or(0), keep_register).await;
        }
        if !self.introduced && matches!(self.route.protocol, Protocol::Modbus(_)) {
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
        for family in self.registry.families().filter(|family| family.link.product.is_some()) {
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
        self.finding.busy = matches!(no(said), Some(No::Exception(Exception::Acknowledge | Exception::DeviceBusy)));
        let answered = match (no(said), status) {
            (Some(no), _) => told(no),
            (None, Some(status)) => Text::name(format!("0x{status:04X}")),
            (None, None) => Text::name("-"),
        };
        let asked = match self.route.protocol {
            Protocol::Modbus(_) => both!("code 3, P.411", "Code 3, P.411"),
            Protocol::Vabus => Text::name("ENQUIRY P.411"),
            Protocol::Sdo(_) => Text::name("SDO P.411"),
            Protocol::Pkw => Text::name("PKW P.411"),
        };
        let tells = match self.route.protocol {
            Protocol::Modbus(_) => both!("a Modbus device", "ein Modbus-Gerät"),
            Protocol::Vabus => both!("somebody speaks VABus", "jemand spricht VABus"),
            Protocol::Sdo(_) => both!("a node answers SDO", "ein Knoten beantwortet SDO"),
            Protocol::Pkw => both!("a slave answers PKW", "ein Slave beantwortet PKW"),
        };
        self.finding.note(asked, answered, tells);
        status
    }

    async fn put(&mut self, inquiry: Inquiry) -> Result<Result<Said, ExchangeError>, AccessError> {
        let question = self.route.question(inquiry).ok_or(AccessError::Unspeakable)?;
        said(self.session.ask(self.route.address, question).await)
    }
}

/// An answer, or why there is none; what ends the session is an error.
fn said(answer: Result<Answer, AccessError>) -> Result<Result<Said, ExchangeError>, AccessError> {
    match answer {
        Ok(Answer::Reply { said, .. }) => Ok(Ok(said)),
        Ok(Answer::Broadcast) => Ok(Err(ExchangeError::BroadcastRead)),
        Err(AccessError::Exchange(error)) => Ok(Err(error)),
        Err(error) => Err(error),
    }
}

fn missing(error: &ExchangeError) -> Text {
    match error {
        ExchangeError::Silence { .. } => both!("no reply", "keine Antwort"),
        _ => both!("no valid answer", "keine gültige Antwort"),
    }
}

fn told(no: No) -> Text {
    match no {
        No::Exception(code) => wrong::exception(code),
        No::Nak => Text::name("NAK"),
        No::Abort(code) => wrong::abort(code),
        No::Pkw(pwe) => super::profibus::no(pwe),
    }
}
