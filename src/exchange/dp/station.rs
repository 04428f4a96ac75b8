//! A slave, led from Slave_Diag to Data_Exchange and let go again (IEC 61158-6-3: master of class 1). Says what to ask next, and
//! takes the answer; who carries both is not known here.

use super::MASTER;
use super::fdl::{Asked, Reply, Unanswered};
use crate::protocol::dp::control::Status;
use crate::protocol::dp::prm::{LOCK, UNLOCK, WATCHDOG};
use crate::protocol::dp::{Diagnosis, EVERYBODY, Parameters, Service, diagnosis};
use crate::tick::{Span, Tick};

/// What a slave is told before data are exchanged. Its ident number is the one that it says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Setup {
    /// Factors of the watchdog, x 10 ms each.
    pub watchdog: [u8; 2],
    /// User parameters of Set_Prm.
    pub user: Vec<u8>,
    /// Bytes of Chk_Cfg.
    pub cfg: Vec<u8>,
    /// The ident number that it must tell, where one is known.
    pub ident: Option<u16>,
}

/// Why a slave does not exchange data.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Trouble {
    /// No answer.
    #[error(transparent)]
    Unanswered(#[from] Unanswered),
    /// Another master has it.
    #[error("master {0} has the slave")]
    Locked(u8),
    /// It is another one than its GSD says.
    #[error("ident number {found:04X}h in place of {expected:04X}h")]
    Other {
        /// The ident number of the GSD.
        expected: u16,
        /// The one that it tells.
        found: u16,
    },
    /// It refuses Set_Prm.
    #[error("Prm_Fault")]
    Parameters,
    /// It refuses Chk_Cfg.
    #[error("Cfg_Fault")]
    Configuration,
    /// It stays not ready.
    #[error("Station_Not_Ready")]
    NotReady,
    /// It answers what is no answer to the service.
    #[error("{} is answered by what is no answer to it", .0.name())]
    Strange(Service),
}

/// What an exchange has brought.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Cycle {
    /// A step on the way to Data_Exchange, or away from it.
    Prepared,
    /// Inputs came.
    Inputs(Vec<u8>),
    /// The slave left Data_Exchange by itself, and is led there anew.
    Left,
    /// The slave is let go.
    Released,
}

/// Where the lead is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    Look,
    Parameterise,
    Configure,
    Verify,
    Exchange,
    Diagnose,
    Clear,
    Unlock,
}

/// How long a slave may be not ready: an SJ2-PB reads its inverter first (SJ2-PB manual 3.1; how long is in no source).
const READY: Span = Span::from_secs(10);
/// Pause before a slave that is not ready is asked again.
const AGAIN: Span = Span::from_millis(20);
/// Least pause of the slave before its answer, bit times (IEC 61158-4-3: min T_SDR).
const MIN_TSDR: u8 = 11;
/// Global_Control: outputs to zero.
const CLEAR: u8 = 0x02;
/// Bits of the first two bytes of Slave_Diag.
const NOT_READY: u8 = 1 << 1;
const CFG_FAULT: u8 = 1 << 2;
const PRM_FAULT: u8 = 1 << 6;
const PRM_REQ: u8 = 1;

/// The lead of one slave: [`Station::question`], then [`Station::answered`], again and again, not before [`Station::waits`].
#[derive(Debug)]
pub struct Station {
    address: u8,
    setup: Setup,
    /// Goes out in every cycle.
    outputs: Vec<u8>,
    stage: Stage,
    ident: u16,
    since: Tick,
    waits: Tick,
    owned: bool,
}

impl Station {
    /// The lead of the slave at an address, with outputs that have as many bytes as its inputs.
    pub fn new(address: u8, setup: Setup, outputs: Vec<u8>, now: Tick) -> Self {
        Station { address, setup, outputs, stage: Stage::Look, ident: 0, since: now, waits: now, owned: false }
    }

    /// What goes out from the next cycle on.
    pub fn outputs(&mut self) -> &mut [u8] {
        &mut self.outputs
    }

    /// The ident number that it told, once it was asked.
    pub fn ident(&self) -> Option<u16> {
        (self.stage != Stage::Look || self.owned).then_some(self.ident)
    }

    /// Whether the slave may be ours, and must be let go.
    pub fn is_owned(&self) -> bool {
        self.owned
    }

    /// Whether it is being let go.
    pub fn is_leaving(&self) -> bool {
        matches!(self.stage, Stage::Clear | Stage::Unlock)
    }

    /// Nothing is to be asked before.
    pub fn waits(&self) -> Tick {
        self.waits
    }

    /// From now on the slave is let go: Clear, where its outputs may be zero, then Unlock.
    pub fn release(&mut self, clears: bool) {
        self.stage = if clears { Stage::Clear } else { Stage::Unlock };
    }

    /// Whom to ask what.
    pub fn question(&mut self) -> (u8, Asked) {
        let of = |service, data| (self.address, Asked::service(service, data));
        let prm = |status, user: &[u8]| Parameters {
            status,
            watchdog: self.setup.watchdog,
            min_tsdr: MIN_TSDR,
            ident: self.ident,
            groups: 0,
            user: user.to_vec(),
        };
        match self.stage {
            Stage::Look | Stage::Verify | Stage::Diagnose => of(Service::SlaveDiag, Vec::new()),
            Stage::Parameterise => {
                let question = of(Service::SetPrm, prm(LOCK | WATCHDOG, &self.setup.user).encode());
                self.owned = true; // whatever becomes of it
                question
            }
            Stage::Configure => of(Service::ChkCfg, self.setup.cfg.clone()),
            Stage::Exchange => of(Service::DataExchange, self.outputs.clone()),
            Stage::Clear => (EVERYBODY, Asked::service(Service::GlobalControl, vec![CLEAR, 0])),
            Stage::Unlock => of(Service::SetPrm, prm(UNLOCK, &[]).encode()),
        }
    }

    /// Takes the answer.
    pub fn answered(&mut self, now: Tick, reply: Result<Reply, Unanswered>) -> Result<Cycle, Trouble> {
        let reply = reply?;
        match self.stage {
            Stage::Look | Stage::Verify | Stage::Diagnose => self.diagnosed(now, &reply)?,
            // Where it is not ready for it yet, Slave_Diag tells.
            Stage::Parameterise if reply == Reply::Ack => self.stage = Stage::Configure,
            Stage::Parameterise | Stage::Configure => self.stage = Stage::Verify,
            Stage::Exchange => return self.exchanged(now, reply),
            Stage::Clear => self.stage = Stage::Unlock,
            Stage::Unlock => {
                self.owned = false;
                return Ok(Cycle::Released);
            }
        }
        Ok(Cycle::Prepared)
    }

    fn diagnosed(&mut self, now: Tick, reply: &Reply) -> Result<(), Trouble> {
        let found = match reply {
            Reply::Frame { data, .. } => Diagnosis::decode(data),
            Reply::Ack | Reply::Sent => None,
        };
        let found = found.ok_or(Trouble::Strange(Service::SlaveDiag))?;
        self.ident = found.ident;
        if ![diagnosis::NOBODY, MASTER].contains(&found.master) {
            self.owned = false;
            return Err(Trouble::Locked(found.master));
        }
        if let Some(expected) = self.setup.ident.filter(|ident| *ident != found.ident) {
            return Err(Trouble::Other { expected, found: found.ident });
        }
        let [first, second, _] = found.status;
        match self.stage {
            Stage::Look => self.stage = Stage::Parameterise,
            Stage::Diagnose => self.stage = Stage::Exchange,
            _ if first & PRM_FAULT != 0 => return Err(Trouble::Parameters),
            _ if first & CFG_FAULT != 0 => return Err(Trouble::Configuration),
            _ if now.since(self.since) > READY => return Err(Trouble::NotReady),
            _ if second & PRM_REQ != 0 => (self.stage, self.waits) = (Stage::Parameterise, now + AGAIN),
            _ if first & NOT_READY != 0 => self.waits = now + AGAIN,
            _ => self.stage = Stage::Exchange,
        }
        Ok(())
    }

    fn exchanged(&mut self, now: Tick, reply: Reply) -> Result<Cycle, Trouble> {
        match reply {
            Reply::Frame { status: Status::NoService, .. } => {
                (self.stage, self.since) = (Stage::Look, now);
                Ok(Cycle::Left)
            }
            Reply::Frame { status, data, .. } if data.len() == self.outputs.len() => {
                if status == Status::DataHigh {
                    self.stage = Stage::Diagnose;
                }
                Ok(Cycle::Inputs(data))
            }
            _ => Err(Trouble::Strange(Service::DataExchange)),
        }
    }
}

#[cfg(test)]
mod tests;
