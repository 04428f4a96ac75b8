//! Values of an inverter, written over PKW with proof: the old one is read first, the new one afterwards.

use super::exchange::Exchange;
use super::mode::{Mode, Words};
use super::trouble;
use crate::drive::decode::dp::{Cyclic, Reader};
use crate::drive::describe;
use crate::drive::job::{self, Step};
use crate::exchange::dp::{Asked, MASTER, Place, Request, Told};
use crate::failure::{Class, Failure};
use crate::gate::{Permit, Writing};
use crate::outcome::{ErrorDoc, TelegramDoc, WriteResult, Written};
use crate::profile::value::{self, from_wire};
use crate::profile::{Family, Type};
use crate::protocol::dp::Service;
use crate::protocol::dp::pkw::Pkw;
use crate::text::both;
use crate::tick::Tick;

/// The row of a value that is to be written, with the telegram that asks for it first. Fails for a value of four bytes: none of them
/// can be written (SJ2-PB manual 5.5).
pub fn planned(address: u8, family: &Family, step: &Step, element: Option<u8>) -> Result<Written, Failure> {
    let word = word(step)?;
    let request = Request::write(Place::of(step.param.id, element), word, Tick::ZERO);
    let telegram = asking(address, request.asked(), family);
    let mut row = describe::to_write(address, family, &step.param, 0, step.raw);
    row.index = element;
    job::tell(&mut row, Some(telegram));
    Ok(row)
}

/// The telegram of a cycle with these words, and no request.
pub fn cyclic(address: u8, (stw, hsw): (u16, u16), mode: Mode, family: &Family) -> TelegramDoc {
    told(address, Pkw::default(), (Words { stw, hsw }, mode), family)
}

/// The telegram of a cycle under the stop word that asks for this.
pub(in crate::drive) fn asking(address: u8, pkw: Pkw, family: &Family) -> TelegramDoc {
    told(address, pkw, (Mode::PPO1.stop(), Mode::PPO1), family)
}

fn told(address: u8, pkw: Pkw, (words, mode): (Words, Mode), family: &Family) -> TelegramDoc {
    let telegram = Asked::service(Service::DataExchange, mode.outputs(pkw, words)).telegram(address, MASTER);
    let reader = Reader { family: Some(family), cyclic: Some(Cyclic(mode.layout())) };
    reader.telegram(&telegram)
}

/// What becomes of the mapping (5.2): it is done as another value than 0 comes behind a 0 (4.1.2.5).
const STORE: u32 = 704;

/// The value as it goes over the line.
fn word(step: &Step) -> Result<u16, Failure> {
    let kind = step.kind.unwrap_or(Type::Word);
    let bits = value::to_wire(step.raw, kind).ok().filter(|_| kind.bytes().is_none_or(|bytes| bytes <= 2));
    let bits = bits.map(|bits| bits & if step.raw < 0 { 0xFFFF } else { u32::MAX });
    bits.and_then(|bits| u16::try_from(bits).ok()).ok_or_else(|| {
        let label = step.param.label();
        let message = both!(
            "{label} does not fit into 16 bits, and no longer value can be written over PKW",
            "{label} passt nicht in 16 Bit, und längere Werte lassen sich über PKW nicht schreiben"
        );
        Failure::new(Class::Data, "data.width", message).with("param", step.param.id)
    })
}

impl Exchange<'_, '_> {
    /// Reads what stands there before; whether there is anything to do. Fails if nothing is to be written then.
    pub async fn before(&mut self, step: &Step, row: &mut Written, force: bool) -> Result<(), Failure> {
        if !step.param.access.reads() {
            return Ok(());
        }
        let raw = match self.read(Place::of(step.param.id, row.index)).await? {
            Ok(bits) => from_wire(bits, step.kind.unwrap_or(Type::Word), step.param.min),
            Err(_) if force => return Ok(()),
            Err(failure) => return Err(failure),
        };
        row.old_raw = Some(raw);
        row.old = describe::scaled(&step.param, raw);
        if raw == step.raw && !force && step.param.id != STORE {
            row.result = WriteResult::Unchanged;
        }
        Ok(())
    }

    /// Writes a value and reads it back. A missing answer is no reason to say it again: what stands there tells what came of it.
    /// Fails if it was not written, with the row told.
    pub async fn write(&mut self, step: &Step, row: &mut Written, _permit: &Permit<Writing>) -> Result<(), Failure> {
        let (at, word) = (Place::of(step.param.id, row.index), word(step)?);
        row.result = WriteResult::Unknown;
        if step.param.id == STORE
            && word != 0
            && let Err(why) = self.set(at, 0).await
        {
            row.result = if why.class == Class::Refused { WriteResult::Refused } else { WriteResult::Unknown };
            row.error = Some(ErrorDoc::from(&why));
            return Err(why);
        }
        let told = self.request(Request::write(at, word, self.line.now())).await?;
        let answered = trouble::told(self.address(), at, told);
        let reads = step.param.access.reads();
        let back = if reads { self.read(at).await?.map(Some) } else { Ok(None) };
        let (result, failure) = match (answered, back) {
            (Ok(_), Ok(None)) => (WriteResult::Written, None),
            (_, Ok(Some(bits)))
                if bits & 0xFFFF == u32::from(word) && !matches!(told, Told::Refused(_) | Told::NoRight) =>
            {
                (WriteResult::Verified, None)
            }
            (Err(why), _) if why.class == Class::Refused => (WriteResult::Refused, Some(why)),
            (Err(why), Ok(Some(_))) => (WriteResult::Differs, Some(why)),
            (Err(why), _) => (WriteResult::Unknown, Some(why)),
            (Ok(_), Ok(Some(bits))) => (WriteResult::Differs, Some(trouble::differs(self.address(), at, bits))),
            (Ok(_), Err(why)) => (WriteResult::Unknown, Some(why)),
        };
        row.result = result;
        row.error = failure.as_ref().map(ErrorDoc::from);
        failure.map_or(Ok(()), Err)
    }
}
