//! The further words of a PPO: what P.915 and P.916 map to them (SJ2-PB manual 4.1.2.5, 5.1).
//!
//! A parameter that P.915 names is written by its word in every cycle, and zeros are a value too. So a slave is taken with such words only where
//! nothing is mapped to them; PPO1, which has none, looks first. What P.916 names comes with every cycle and changes nothing.

use super::exchange::{Exchange, Taking};
use super::line::Line;
use super::trouble;
use crate::drive::watch::Chosen;
use crate::exchange::dp::{Cycle, Place};
use crate::failure::Failure;
use crate::gate::{Motion, Permit};
use crate::profile::{Param, value};

/// Mappings (5.1): of the words that are written, of those that are read.
const WRITTEN: u16 = 915;
const READ: u16 = 916;
/// Cycles until a word tells what is mapped to it since.
const SETTLES: usize = 3;

/// Fails where a further word would write a parameter. The slave is taken as given, without such words, and let go again.
pub async fn unmapped(
    line: &mut Line<'_>,
    address: u8,
    (taking, further): (Taking, usize),
    permit: &Permit<Motion>,
) -> Result<(), Failure> {
    let mut exchange = Exchange::new(line, address, taking, permit);
    let done = async {
        for element in (1..=8_u8).take(further) {
            let index = exchange.read(Place { pnu: WRITTEN, element: Some(element) }).await??;
            if index & 0xFFFF != 0 {
                return Err(trouble::mapped(address, element, index & 0xFFFF));
            }
        }
        Ok(())
    };
    let done = done.await;
    let left = exchange.leave().await.failure;
    left.map_or(done, Err)
}

impl Exchange<'_, '_> {
    /// Has what is watched come with every cycle, as far as there are words for it; the rest is asked for.
    pub(super) async fn map(&mut self, chosen: &Chosen) -> Result<(), Failure> {
        let free = self.mode().further();
        let fits = |param: &&Param| {
            param.element().is_none() && param.kind.is_some_and(|kind| kind.bytes().is_none_or(|bytes| bytes <= 2))
        };
        let params = chosen.items.iter().map(|item| item.param()).filter(fits);
        let indexes: Vec<u16> = params
            .filter(|param| self.word(param.id).is_none())
            .filter_map(|param| u16::try_from(param.id).ok())
            .collect();
        for (element, index) in (1..=8_u8).zip(indexes).take(free) {
            self.lend_place(Place { pnu: READ, element: Some(element) }, index).await?;
            self.mapped.push(index);
        }
        for _ in 0..SETTLES {
            while !matches!(self.cycle().await?, Cycle::Inputs(_)) {}
        }
        Ok(())
    }

    /// What the word told to which a parameter is mapped.
    pub(super) fn mapped_word(&self, param: &Param) -> Option<i64> {
        let place = self.mapped.iter().position(|index| u32::from(*index) == param.id)?;
        Some(value::from_wire((*self.more.get(place)?).into(), param.kind?, param.min))
    }
}
