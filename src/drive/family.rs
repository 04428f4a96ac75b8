//! Which drive is it? Asked so that nothing in the drive changes and nothing is read away.

use super::route::{self, RegisterAddress};
use super::session::{AccessError, Refusal, Session};
use super::transfer::Target;
use crate::exchange::modbus::{Answer, ExchangeError};
use crate::outcome::Evidence;
use crate::profile::{Lang, Registry, Type};
use crate::protocol::modbus::pdu::{Exception, Reply, Request};

/// Stator frequency: 32 bits on both families, proved by telegrams (facts B), so code 100 reads it.
const STATOR_FREQUENCY: u32 = 210;
/// Status word of both families (CM-485 manual 9, 10).
const STATUS_WORD: u16 = 411;
/// Frequency setpoint in RAM: write-only on the ACU (CM-485 manual 10.2.3), readable on the ACT (chapter 9).
const SETPOINT_RAM: u32 = 484;
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
    /// What the error register held before it was overwritten by asking.
    pub kept_register: Option<u16>,
}

impl Finding {
    fn note(&mut self, asked: &str, answered: impl Into<String>, tells: &str) {
        let (asked, tells) = (asked.to_owned(), tells.to_owned());
        self.evidence.push(Evidence { asked, answered: answered.into(), tells });
    }

    /// The drive as a target, if it is one that we know.
    pub fn target(&self, address: u8, registry: &Registry) -> Option<Target> {
        let mut target = Target::new(address, registry.family(self.drive.as_ref()?)?);
        target.kept_register = self.kept_register;
        Some(target)
    }
}

/// Asks a device what it is. Ends with an error only if it does not answer at all.
///
/// The last question may be refused, which overwrites the error register; with `keep_register` the register is read
/// (and so cleared) before it, for a verb that shows it.
pub async fn recognise(
    session: &mut Session<'_>,
    address: u8,
    lang: Lang,
    keep_register: bool,
) -> Result<Finding, AccessError> {
    let answer = session.ask(address, probe()).await?;
    judge(session, address, &answer, lang, keep_register).await
}

/// The question that every device is asked first: its status word. An ACTIVE drive answers it without touching its
/// error register; any other Modbus device says something too.
pub(super) fn probe() -> Request {
    Request::ReadRegisters { start: STATUS_WORD, count: 1 }
}

/// Asks on from the answer to [`probe`] what the device is.
pub(super) async fn judge(
    session: &mut Session<'_>,
    address: u8,
    answer: &Answer,
    lang: Lang,
    keep_register: bool,
) -> Result<Finding, AccessError> {
    let mut finding = Finding::default();
    let asked = lang.pick("code 3, P.411", "Code 3, P.411");
    let status = match answer {
        Answer::Reply { reply: Reply::Registers(values), .. } => values.first().copied(),
        _ => None,
    };
    let answered = match answer {
        Answer::Reply { reply: Reply::Exception { code, .. }, .. } => exception(*code, lang),
        _ => status.map_or_else(|| "-".to_owned(), |status| format!("0x{status:04X}")),
    };
    let tells = lang.pick("a Modbus device", "ein Modbus-Gerät");
    finding.note(asked, answered, tells);
    if !speaks_code_100(session, address, lang, &mut finding).await? {
        return Ok(finding);
    }
    if u32::from(status.unwrap_or(0)) & VOLTAGE_BIT != 0 {
        let bit = lang.pick("bit 4 of P.411", "Bit 4 von P.411");
        let tells = lang.pick("voltage enabled exists on the ACU only", "Spannung freigegeben gibt es nur beim ACU");
        finding.note(bit, "1", tells);
        finding.drive = Some("acu".to_owned());
        return Ok(finding);
    }
    if keep_register {
        finding.kept_register = session.error_register(address).await?;
    }
    let asked = lang.pick("code 100, P.484", "Code 100, P.484");
    let Some(at) = RegisterAddress::new(SETPOINT_RAM, 0) else { return Ok(finding) };
    match session.demand(address, route::read(at, Type::Long)).await {
        Ok(_) => {
            let tells = lang.pick("the line setpoint is readable: ACT", "der Liniensollwert ist lesbar: ACT");
            finding.note(asked, lang.pick("a value", "ein Wert"), tells);
            finding.drive = Some("act".to_owned());
        }
        Err(AccessError::Refused(Refusal { cause: Some(NOT_READABLE), .. })) => {
            let tells = lang.pick("the line setpoint is write-only: ACU", "der Liniensollwert ist nur schreibbar: ACU");
            finding.note(asked, "P.11 = 3", tells);
            finding.drive = Some("acu".to_owned());
        }
        Err(AccessError::Refused(refusal)) => {
            let tells =
                lang.pick("tells neither ACT nor ACU; name it with --drive", "weder ACT noch ACU; mit --drive angeben");
            finding.note(asked, exception(refusal.exception, lang), tells);
        }
        Err(error) => return Err(error),
    }
    Ok(finding)
}

/// Whether the device knows the family's own function code. Silence is an answer too: many slaves ignore codes that
/// they do not know.
async fn speaks_code_100(
    session: &mut Session<'_>,
    address: u8,
    lang: Lang,
    finding: &mut Finding,
) -> Result<bool, AccessError> {
    let asked = lang.pick("code 100, P.210", "Code 100, P.210");
    let Some(at) = RegisterAddress::new(STATOR_FREQUENCY, 0) else { return Ok(false) };
    let stranger = lang.pick("no ACTIVE drive: does not know code 100", "kein ACTIVE: kennt Code 100 nicht");
    let (answered, tells, known) = match session.ask(address, route::read(at, Type::Long)).await {
        Ok(Answer::Reply { reply: Reply::Long(value), .. }) => {
            let tells =
                lang.pick("speaks the ACTIVE family's own code 100", "spricht den eigenen Code 100 der ACTIVE-Familie");
            (value.to_string(), tells, true)
        }
        Ok(Answer::Reply { reply: Reply::Exception { code: Exception::IllegalFunction, .. }, .. }) => {
            (exception(Exception::IllegalFunction, lang), stranger, false)
        }
        Ok(Answer::Reply { reply: Reply::Exception { code, .. }, .. }) => {
            let tells =
                lang.pick("knows code 100, but not this parameter", "kennt Code 100, aber nicht diesen Parameter");
            (exception(code, lang), tells, true)
        }
        Ok(_) => ("-".to_owned(), stranger, false),
        Err(AccessError::Exchange(ExchangeError::Silence { .. })) => {
            (lang.pick("no reply", "keine Antwort").to_owned(), stranger, false)
        }
        Err(AccessError::Exchange(_)) => {
            (lang.pick("no valid answer", "keine gültige Antwort").to_owned(), stranger, false)
        }
        Err(error) => return Err(error),
    };
    finding.note(asked, answered, tells);
    Ok(known)
}

fn exception(code: Exception, lang: Lang) -> String {
    format!("{} {code}", lang.pick("exception", "Ausnahme"))
}
