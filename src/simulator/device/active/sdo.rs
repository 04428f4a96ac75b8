//! SDO of an ACT or ACU: index = parameter, sub-index = data set (EM-RES-03 manual 5.10.1).
//!
//! Choices where the manual is silent: a refusal says its cause itself and leaves nothing in P.11.

use super::access::Width;
use super::drive::Drive;
use crate::profile::Type;
use crate::protocol::modbus::pdu::ParamAddress;
use crate::simulator::device::contract::{AskedBySdo, Effect, Object};
use crate::tick::Tick;

impl AskedBySdo for Drive {
    fn upload(&mut self, now: Tick, object: Object) -> Result<(u32, Type), u8> {
        let (at, kind) = self.at(object)?;
        let bits = self.active.fetch(now, at, width(kind)).map_err(|cause| cause as u8)?;
        Ok((bits, kind))
    }

    fn download(&mut self, now: Tick, object: Object, bits: u32) -> Result<Effect, u8> {
        let (at, kind) = self.at(object)?;
        let bits = if kind == Type::Long { bits } else { bits & 0xFFFF };
        self.active.put(now, at, width(kind), bits).map_err(|cause| cause as u8)
    }
}

impl Drive {
    fn at(&self, object: Object) -> Result<(ParamAddress, Type), u8> {
        let at = ParamAddress::new(object.set, object.number).ok_or(UNKNOWN)?;
        let kind = self.active.kind(object.number).map_err(|cause| cause as u8)?;
        Ok((at, kind))
    }
}

/// Unknown parameter (manual 5.10.1).
const UNKNOWN: u8 = 11;

fn width(kind: Type) -> Width {
    if kind == Type::Long { Width::Long } else { Width::Word }
}
