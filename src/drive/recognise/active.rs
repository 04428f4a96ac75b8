//! ACT or ACU? What only a drive of the ACTIVE family does (sources A2).

use super::{Inquest, missing, said, told};
use crate::drive::access::{AccessError, Refusal};
use crate::drive::route::{Cell, Inquiry, No, register};
use crate::exchange::Said;
use crate::profile::{Family, Type};
use crate::protocol::Protocol;
use crate::protocol::modbus::pdu::{Exception, Reply};
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

impl Inquest<'_, '_> {
    /// Whether the device knows the ACTIVE family's own function code. Silence is an answer too: many slaves ignore
    /// codes that they do not know.
    pub(super) async fn speaks_code_100(&mut self) -> Result<bool, AccessError> {
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
            Err(error) => {
                self.fell_silent = true;
                let tells = both!(
                    "most likely no ACTIVE drive: no answer to code 100",
                    "wohl kein ACTIVE: keine Antwort auf Code 100"
                );
                (missing(&error), tells, false)
            }
        };
        self.finding.note(asked, answered, tells);
        Ok(known)
    }

    pub(super) async fn act_or_acu(&mut self, status: u16, keep_register: bool) -> Result<(), AccessError> {
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
            Protocol::Sdo(_) => Text::name("SDO P.484"),
            Protocol::Pkw => Text::name("PKW P.484"),
        };
        let Some(question) = self.route.question(Inquiry::Read(SETPOINT_RAM, Type::Long)) else { return Ok(()) };
        let mut tries = 0;
        let answer = loop {
            tries += 1;
            let answer = self.session.demand(self.route, family, question.clone()).await;
            match &answer {
                Err(error) if self.session.bears(error, tries).await? => {}
                _ => break answer,
            }
        };
        match answer {
            Ok(_) => {
                let tells = both!("the line setpoint is readable: ACT", "der Liniensollwert ist lesbar: ACT");
                self.finding.note(asked, both!("a value", "ein Wert"), tells);
                self.finding.drive = Some("act".to_owned());
            }
            Err(AccessError::Refused(refusal @ Refusal { cause: Some(NOT_READABLE), .. })) => {
                let tells = both!("the line setpoint is write-only: ACU", "der Liniensollwert ist nur schreibbar: ACU");
                let answered = match refusal.no {
                    No::Abort(_) | No::Pkw(_) => told(refusal.no),
                    No::Exception(_) | No::Nak => Text::name("P.11 = 3"),
                };
                self.finding.note(asked, answered, tells);
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
}
