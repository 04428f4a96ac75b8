//! `systembus load`: the capacity of the bus.

use crate::failure::{Class, Failure};
use crate::outcome::{BusCharge, BusLoad, BusRate, BusTotal, Data, Outcome};
use crate::systembus::{Budget, Rate, Verdict};
use crate::text::both;
use clap::Args as ClapArgs;

#[derive(Clone, Debug, ClapArgs)]
pub(super) struct Options {
    /// Bit rate in kBd: 50, 100, 125, 250, 500 or 1000 [default: all]
    #[arg(value_name = "RATE", value_parser = rate)]
    rate: Option<Rate>,
    /// Send time of each TxPDO in ms, from 1 to 50000
    #[arg(value_name = "MS", value_parser = clap::value_parser!(u32).range(1..=50_000))]
    every_ms: Vec<u32>,
}

/// A rate as it is typed.
fn rate(text: &str) -> Result<Rate, crate::text::Wrong> {
    text.parse().ok().and_then(Rate::of_kbd).ok_or_else(|| {
        let known = Rate::ALL.map(|rate| rate.kbd().to_string()).join(", ");
        crate::text::Wrong(both!("expected {known}, got '{text}'", "erwartet: {known}; angegeben: '{text}'"))
    })
}

pub(super) fn run(options: &Options) -> Result<Outcome, Failure> {
    let Some(rate) = options.rate else {
        let rates = Rate::ALL.into_iter().map(row).collect();
        return Ok(Outcome::of(Data::BusLoad(BusLoad { rates, rate_kbd: None, pdos: Vec::new(), total: None })));
    };
    let budget = Budget::new(rate, options.every_ms.iter().copied().map(Some));
    let charge = |charge: &crate::systembus::Charge| {
        let load = charge.load?;
        Some(BusCharge { every_ms: charge.every_ms?, load_percent: load.rounded(), shown: load.to_string() })
    };
    let pdos = budget.charges.iter().filter_map(charge).collect();
    let total = total(&budget);
    let failure = (budget.total.verdict() == Verdict::NotFeasible).then(|| {
        let shown = budget.total.beyond(90);
        Failure::new(
            Class::No,
            "no.bus_load",
            both!(
                "a bus load of {shown} %: above 90 % is not feasible",
                "eine Buslast von {shown} %: über 90 % ist nicht realisierbar"
            ),
        )
        .hint(both!(
            "send less often, with SYNC, or at a higher rate on a shorter line",
            "seltener senden, mit SYNC, oder mit höherer Rate auf kürzerer Leitung"
        ))
    });
    let rates = if options.every_ms.is_empty() { vec![row(rate)] } else { Vec::new() };
    let data = Data::BusLoad(BusLoad { rates, rate_kbd: Some(rate.kbd()), pdos, total: Some(total) });
    Ok(Outcome { data: Some(data), warnings: Vec::new(), failure })
}

/// The sum, and what the manual says of it.
pub(super) fn total(budget: &Budget) -> BusTotal {
    BusTotal {
        load_percent: budget.total.rounded(),
        verdict: budget.total.verdict().name(),
        incomplete: budget.is_open(),
        shown: budget.total.to_string(),
    }
}

/// A row of the tables of the manual.
fn row(rate: Rate) -> BusRate {
    /// Columns of the printed table.
    const LAST_MS: u32 = 10;
    let loads: Vec<_> = (1..=LAST_MS).filter_map(|ms| rate.load(ms)).collect();
    BusRate {
        rate_kbd: rate.kbd(),
        metres: rate.metres(),
        telegram_us: rate.telegram_us(),
        load_percent: loads.iter().map(|load| load.rounded()).collect(),
        shown: loads.iter().map(ToString::to_string).collect(),
    }
}
