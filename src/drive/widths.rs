//! Reading a parameter at the width that the drive has it in, where that is not the one of the catalogue.

use super::access::{AccessError, Refusal};
use super::route::Cell;
use super::session::Session;
use super::target::Target;
use super::transfer::{Reading, tells_width};
use crate::exchange::ExchangeError;
use crate::profile::{DataSets, Param, Type};

/// What was answered, by data sets as on the wire.
pub(super) type Rows = Vec<(u8, Result<Reading, AccessError>)>;

impl Target {
    /// Reads like [`Target::read`], and at the other width too where the drive says that it may be the right one: by a refusal, or,
    /// over VABus, where each reply carries its length, by a reply of that width and no other, twice. Ends at the first data set that was not read.
    pub(super) async fn read_as_it_is(&mut self, session: &mut Session<'_>, param: &Param, asked: &[DataSets]) -> Rows {
        let rows = self.read_all(session, param, asked).await;
        if refusal(&rows).is_some_and(Refusal::is_of_width) {
            return self.read_all(session, &doubted(param), asked).await;
        }
        let garbled = |row: &Result<_, _>| {
            matches!(row, Err(AccessError::Exchange(ExchangeError::Garbled { .. } | ExchangeError::Pieces { .. })))
        };
        let garbled = rows.iter().find(|(_, row)| garbled(row)).map(|(set, _)| *set);
        let is_open = self.known_width(param.id).is_none_or(|known| Some(known) == param.kind);
        let is_told = tells_width(session) && is_open;
        let (Some(set), Some(kind)) = (garbled.filter(|_| is_told), other_width(param)) else { return rows };
        let other = Param { kind: Some(kind), ..param.clone() };
        match self.says_twice(session, &other, Cell { number: param.id, set }, kind).await {
            Ok(true) => {
                self.set_width(param.id, kind);
                self.read_all(session, &other, asked).await
            }
            Ok(false) => rows,
            Err(error) => vec![(set, Err(error))],
        }
    }

    async fn read_all(&mut self, session: &mut Session<'_>, param: &Param, asked: &[DataSets]) -> Rows {
        let mut rows = Vec::new();
        for &sets in asked {
            rows.extend(self.read(session, param, sets).await);
            if rows.iter().any(|(_, row)| row.is_err()) {
                break;
            }
        }
        rows
    }

    /// Whether two replies have this width, and the same value.
    async fn says_twice(
        &mut self,
        session: &mut Session<'_>,
        param: &Param,
        cell: Cell,
        kind: Type,
    ) -> Result<bool, AccessError> {
        let mut last = None;
        for _ in 0..2 {
            match self.read_as(session, param, cell, kind).await {
                Ok(reading) if last.as_ref().is_none_or(|last| *last == reading) => last = Some(reading),
                Err(error) if error.is_fatal() => return Err(error),
                _ => return Ok(false),
            }
        }
        Ok(true)
    }
}

/// What the drive said in place of a value.
pub(super) fn refusal(rows: &Rows) -> Option<Refusal> {
    rows.iter().find_map(|(_, row)| row.as_ref().err()?.refusal())
}

/// A parameter whose width the drive may say otherwise.
pub(super) fn doubted(param: &Param) -> Param {
    let unconfirmed = param.unconfirmed.iter().cloned().chain(["type".to_owned()]).collect();
    Param { unconfirmed, ..param.clone() }
}

/// The width that the row of a parameter does not state; `None` where it states none.
fn other_width(param: &Param) -> Option<Type> {
    let bits = param.kind?.bits()?;
    Some(if bits == 16 { Type::Long } else { Type::Word })
}
