//! `scan` with PROFIBUS spoken: the live list, as the drives of a line, at a speed that is known or sought.

use super::{addresses, nobody, open};
use crate::command::Context;
use crate::drive::profibus::{self, RATES, Round, found};
use crate::drive::ranges;
use crate::failure::{Class, Failure};
use crate::outcome::{Data, LiveList, Outcome, Plan, Scan, Search, Warning};
use crate::text::{Text, both};
use crate::tick::Span;

/// What ends it early.
#[derive(Clone, Copy, Debug)]
pub(in crate::command) struct Ends {
    pub(in crate::command) until_first: bool,
    pub(in crate::command) within: Option<Span>,
}

/// Searches the line.
pub(in crate::command) async fn scan(ends: Ends, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let addresses = addresses(context.settings)?;
    let is_sought = context.settings.unknown.baud;
    if context.settings.dry_run {
        let rates = if is_sought { RATES.len() } else { 1 };
        let notes = vec![both!(
            "{count} address(es) are asked so, at {rates} speed(s); slaves for Slave_Diag and Get_Cfg as well",
            "{count} Adresse(n) werden auf diese Weise gefragt, bei {rates} Baudrate(n); Slaves dazu nach Slave_Diag und Get_Cfg",
            count = addresses.len()
        )];
        let telegrams = profibus::questions(addresses.first().copied());
        return Ok(Outcome::of(Data::Plan(Plan { dry_run: true, telegrams, notes })));
    }
    let Context { settings, registry, interrupt, observe, .. } = context;
    // An adapter may stand at any speed before.
    let baud = if is_sought { RATES[0] } else { settings.line.baud };
    let rates: &[u32] = if is_sought { &RATES } else { std::slice::from_ref(&baud) };
    let settings = &settings.at_speed(baud);
    let mut line = open(None, (settings, registry), interrupt, *observe).await?;
    let until = ends.within.map(|within| line.now() + within);
    let round = Round { addresses: &addresses, questions: 0, until_first: ends.until_first, until };
    let (lists, ended) = profibus::search(&mut line, rates, round).await;
    let is_cut = ended.is_some();
    let searches: Vec<Search> = lists.iter().map(|list| searched(list, &addresses)).collect();
    let drives = lists.iter().flat_map(|list| {
        let of = |station| found(station, (&list.port, &list.line), settings.drive.as_deref());
        list.stations.iter().map(of).collect::<Vec<_>>()
    });
    let drives: Vec<_> = drives.collect();
    let last = lists.last();
    let asked = lists.iter().map(|list| list.asked).sum();
    let is_met = !drives.is_empty();
    let complete = !is_cut && searches.iter().all(|search| search.complete) && (is_met || lists.len() == rates.len());
    let failure = ended.or_else(|| nobody_there(&lists).filter(|_| !is_met)).or_else(|| {
        let is_open = !complete && !ends.until_first;
        is_open.then(|| left_open(&searches))
    });
    let scan = Scan {
        port: last.map_or_else(String::new, |list| list.port.clone()),
        line: if is_sought { "auto".to_owned() } else { last.map_or_else(String::new, |list| list.line.clone()) },
        protocol: "dp".to_owned(),
        addresses: addresses.len() * if is_met { lists.len() } else { rates.len() },
        asked,
        complete,
        settings: if is_met { lists.len() } else { rates.len() },
        settings_done: searches.iter().filter(|search| search.complete).count(),
        left_s: 0,
        drives,
        searches,
    };
    let warnings = lists.iter().flat_map(|list| &list.stations).filter_map(|station| {
        let error = station.error.as_ref()?;
        Some(Warning { code: error.code.clone(), message: error.message.clone() })
    });
    Ok(Outcome { warnings: warnings.collect(), data: Some(Data::Scan(scan)), failure })
}

/// What was asked at one speed.
fn searched(list: &LiveList, addresses: &[u8]) -> Search {
    let (asked, open) = addresses.split_at(list.asked.min(addresses.len()));
    let told = |addresses: &[u8]| ranges(&addresses.iter().copied().collect());
    Search {
        port: list.port.clone(),
        line: list.line.clone(),
        protocol: "dp".to_owned(),
        asked: told(asked),
        open: told(open),
        complete: open.is_empty(),
        garbled: list
            .stations
            .iter()
            .filter(|station| station.kind.is_empty())
            .map(|station| station.address)
            .collect(),
    }
}

fn nobody_there(lists: &[LiveList]) -> Option<Failure> {
    let failure = nobody(lists.last()?)?;
    if lists.len() < 2 {
        return Some(failure);
    }
    let lines: Vec<Text> = lists.iter().map(|list| Text::name(&list.line)).collect();
    let lines = Text::join(&lines, ", ");
    Some(Failure { message: both!("nobody answers at {lines}", "bei {lines} antwortet niemand", lines), ..failure })
}

fn left_open(searches: &[Search]) -> Failure {
    let open = searches.iter().filter(|search| !search.complete);
    let open: Vec<Text> = open.map(|search| Text::name(format_args!("{}: {}", search.line, search.open))).collect();
    let open = Text::join(&open, "; ");
    let message = both!("not all of it was asked; left open: {open}", "nicht alles wurde gefragt; offen: {open}", open);
    Failure::new(Class::Partial, "partial", message)
}
