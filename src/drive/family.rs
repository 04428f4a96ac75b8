//! Which drive is it? Asked so that nothing in the drive changes and nothing is read away.

use super::route::{self, RegisterAddress};
use super::session::{AccessError, Refusal, Session};
use super::transfer::Target;
use crate::outcome::Evidence;
use crate::profile::{Lang, Registry, Type};
use crate::protocol::modbus::pdu::{Exception, Reply, Request};

/// Stator frequency: 32 bits on both families, proved by telegrams (facts B), so code 100 reads it.
const STATOR_FREQUENCY: u32 = 210;
/// Status word of both families (CM-485 manual 9, 10).
const STATUS_WORD: u32 = 411;
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
    let text = |en: &'static str, de: &'static str| if lang == Lang::De { de } else { en };
    let mut finding = Finding::default();
    let code_100 = text("code 100, P.210", "Code 100, P.210");
    match ask(session, address, STATOR_FREQUENCY, Type::Long).await? {
        Ok(Reply::Long(value)) => {
            finding.note(
                code_100,
                value.to_string(),
                text("speaks the ACTIVE family's own code 100", "spricht den eigenen Code 100 der ACTIVE-Familie"),
            );
        }
        Err(Exception::IllegalFunction) => {
            let tells = text("no ACTIVE drive: does not know code 100", "kein ACTIVE: kennt Code 100 nicht");
            finding.note(code_100, Exception::IllegalFunction.to_string(), tells);
            registers(session, address, &mut finding, lang).await?;
            return Ok(finding);
        }
        Err(exception) => {
            let tells = text("knows code 100, but not this parameter", "kennt Code 100, aber nicht diesen Parameter");
            finding.note(code_100, exception.to_string(), tells);
        }
        Ok(other) => {
            let tells = text("no ACTIVE drive", "kein ACTIVE");
            finding.note(code_100, format!("{other:?}"), tells);
            return Ok(finding);
        }
    }
    let asked = text("code 3, P.411", "Code 3, P.411");
    match ask(session, address, STATUS_WORD, Type::Uint).await? {
        Ok(Reply::Registers(values)) => {
            let status = u32::from(values.first().copied().unwrap_or(0));
            let shown = format!("0x{status:04X}");
            if status & VOLTAGE_BIT != 0 {
                let tells = text(
                    "bit 4 (voltage enabled) exists on the ACU only",
                    "Bit 4 (Spannung freigegeben) hat nur der ACU",
                );
                finding.note(asked, shown, tells);
                finding.drive = Some("acu".to_owned());
                return Ok(finding);
            }
            let tells = text("bit 4 is 0: an ACT, or an ACU without mains", "Bit 4 ist 0: ACT, oder ACU ohne Netz");
            finding.note(asked, shown, tells);
        }
        Ok(other) => finding.note(asked, format!("{other:?}"), text("no status word", "kein Zustandswort")),
        Err(exception) => finding.note(asked, exception.to_string(), text("no status word", "kein Zustandswort")),
    }
    if keep_register {
        finding.kept_register = session.error_register(address).await?;
    }
    let asked = text("code 100, P.484", "Code 100, P.484");
    let Some(at) = RegisterAddress::new(SETPOINT_RAM, 0) else { return Ok(finding) };
    match session.demand(address, route::read(at, Type::Long)).await {
        Ok(_) => {
            let tells = text("the line setpoint is readable: ACT", "der Liniensollwert ist lesbar: ACT");
            finding.note(asked, text("a value", "ein Wert"), tells);
            finding.drive = Some("act".to_owned());
        }
        Err(AccessError::Refused(Refusal { cause: Some(NOT_READABLE), .. })) => {
            let tells = text("the line setpoint is write-only: ACU", "der Liniensollwert ist nur schreibbar: ACU");
            finding.note(asked, "P.11 = 3", tells);
            finding.drive = Some("acu".to_owned());
        }
        Err(AccessError::Refused(refusal)) => {
            let tells =
                text("tells neither ACT nor ACU; name it with --drive", "weder ACT noch ACU; mit --drive angeben");
            finding.note(asked, refusal.exception.to_string(), tells);
        }
        Err(error) => return Err(error),
    }
    Ok(finding)
}

/// What a device that is no ACTIVE drive says to an ordinary read.
async fn registers(
    session: &mut Session<'_>,
    address: u8,
    finding: &mut Finding,
    lang: Lang,
) -> Result<(), AccessError> {
    let request = Request::ReadRegisters { start: 0, count: 1 };
    let answered = match session.ask(address, request).await {
        Ok(crate::exchange::modbus::Answer::Reply { reply: Reply::Registers(values), .. }) => {
            values.first().map_or_else(String::new, |value| format!("{value} (0x{value:04X})"))
        }
        Ok(crate::exchange::modbus::Answer::Reply { reply: Reply::Exception { code, .. }, .. }) => code.to_string(),
        Ok(_) => return Ok(()),
        Err(AccessError::Exchange(_)) => "-".to_owned(),
        Err(error) => return Err(error),
    };
    let (asked, tells) = match lang {
        Lang::En => ("code 3, register 0", "a Modbus device"),
        Lang::De => ("Code 3, Register 0", "ein Modbus-Gerät"),
    };
    finding.note(asked, answered, tells);
    Ok(())
}

/// A read whose refusal is an answer too, and whose cause is left in the error register.
async fn ask(
    session: &mut Session<'_>,
    address: u8,
    param: u32,
    kind: Type,
) -> Result<Result<Reply, Exception>, AccessError> {
    let Some(at) = RegisterAddress::new(param, 0) else { return Ok(Err(Exception::IllegalDataAddress)) };
    match session.ask(address, route::read(at, kind)).await? {
        crate::exchange::modbus::Answer::Reply { reply: Reply::Exception { code, .. }, .. } => Ok(Err(code)),
        crate::exchange::modbus::Answer::Reply { reply, .. } => Ok(Ok(reply)),
        crate::exchange::modbus::Answer::Broadcast => Ok(Err(Exception::Other(0))),
    }
}
