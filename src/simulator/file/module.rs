//! What a bench file says of what hangs at an EM-RES-03: a motor with its resolver, and a voltage at the analog input.

use super::reader::{BenchFile, decimal};
use super::tables::{AnalogTable, EventTable, ResolverTable};
use crate::profile::Broken;
use crate::simulator::device::active::analog::Analog;
use crate::simulator::device::active::resolver::Resolver;
use crate::simulator::device::contract::Action;
use crate::text::both;
use toml::{Spanned, Value};

/// What P.382 can be, 0.1° (EM-RES-03 manual 6.4.1).
const TURN: i64 = 3_600;
/// Fastest hand, 0.01 Hz.
const HAND: i64 = 2_000;
/// What may lie at the input (EM-RES-03 manual 7.1), and how far off it may measure, 0.001 V.
const VOLTS: i64 = 10_000;
const ASTRAY: i64 = 2_000;

impl BenchFile<'_> {
    pub(super) fn resolver(&self, table: &ResolverTable) -> Result<Resolver, Broken> {
        let offset = self.bounded("offset", &table.offset, 1, (-TURN, TURN))?;
        Ok(Resolver { offset, swapped: table.swapped, inverted: table.inverted })
    }

    pub(super) fn analog(&self, table: &AnalogTable) -> Result<Analog, Broken> {
        let or = |key, got: &Option<Spanned<Value>>, bounds, usual| {
            got.as_ref().map_or(Ok(usual), |got| self.bounded(key, got, 3, bounds))
        };
        let applied = or("volts", &table.volts, (-VOLTS, VOLTS), 0)?;
        let offset = or("offset", &table.offset, (-ASTRAY, ASTRAY), 0)?;
        Ok(Analog::new(applied, offset, or("gain", &table.gain, (500, 2_000), 1_000)?))
    }

    /// What an event does there.
    pub(super) fn module_actions(&self, row: &EventTable) -> Result<Vec<Action>, Broken> {
        let mut actions = Vec::new();
        actions.extend(row.exchange_phases.then_some(Action::ExchangePhases));
        if let Some(got) = &row.hand {
            actions.push(Action::Hand(self.bounded("hand", got, 2, (-HAND, HAND))?));
        }
        if let Some(got) = &row.analog {
            actions.push(Action::Analog(self.bounded("analog", got, 3, (-VOLTS, VOLTS))?));
        }
        Ok(actions)
    }

    fn bounded(&self, key: &str, got: &Spanned<Value>, decimals: u8, (least, most): (i64, i64)) -> Result<i64, Broken> {
        let raw = decimal(got.get_ref(), decimals).map_err(|message| self.error(got.span(), message))?;
        let shown = |raw| crate::profile::value::format_decimal(raw, decimals);
        let (least_shown, most_shown) = (shown(least), shown(most));
        let expected = both!("{least_shown} to {most_shown}", "{least_shown} bis {most_shown}");
        let fits = (least..=most).contains(&raw);
        if fits { Ok(raw) } else { Err(self.unfit(key, got.span(), got.get_ref(), &expected)) }
    }
}
