//! A line whose speed nobody knows, and stations as a scan of any line tells them.

use super::line::Line;
use super::live::{Round, live};
use crate::failure::Failure;
use crate::outcome::{ErrorDoc, Evidence, FoundDrive, LiveList, LiveStation, State};
use crate::text::{Text, both};

/// Speeds of PROFIBUS that adapters reach (IEC 61158-3-3), the bench's usual one first. A slave finds the speed by itself, so the order costs
/// time and nothing else.
pub const RATES: [u32; 6] = [19_200, 9_600, 93_750, 187_500, 500_000, 1_500_000];

/// Goes through the speeds until somebody answers: all stations of a line have one. A list for each speed that was tried, and what ended it
/// early. Whoever speaks at the first speed, understood or not, is a master at one of them, and nothing is sent.
pub async fn search(line: &mut Line<'_>, rates: &[u32], round: Round<'_>) -> (Vec<LiveList>, Option<Failure>) {
    let mut lists: Vec<LiveList> = Vec::new();
    for (nth, rate) in rates.iter().enumerate() {
        if round.until.is_some_and(|until| line.now() >= until) {
            break;
        }
        if nth > 0
            && let Err(failure) = line.retune(*rate).await
        {
            return (lists, Some(failure));
        }
        let (list, failure) = live(line, round).await;
        let is_found = !list.stations.is_empty();
        lists.push(list);
        if failure.is_some() || is_found {
            return (lists, failure);
        }
    }
    (lists, None)
}

/// A station as a scan tells it; `drive` is what was said of its inverter.
pub fn found(station: &LiveStation, (port, line): (&str, &str), drive: Option<&str>) -> FoundDrive {
    let row = |asked: &str, answered: &str, tells: Text| Evidence {
        asked: Text::name(asked),
        answered: Text::name(answered),
        tells,
    };
    let is = station.is.clone();
    let ident = station.ident.as_deref().map(|ident| row("Slave_Diag", ident, both!("ident number", "Identnummer")));
    let layout = station.layout.map_or_else(|| both!("configuration", "Konfiguration"), Text::name);
    let cfg = station.configuration.as_deref().map(|bytes| row("Get_Cfg", bytes, layout));
    let title = match &station.ident {
        Some(ident) => both!("{is}, ident {ident}", "{is}, Ident {ident}", is),
        None => is.clone(),
    };
    let is_named = station.kind == "slave";
    FoundDrive {
        address: station.address,
        drive: drive.filter(|_| is_named).unwrap_or("unknown").to_owned(),
        title,
        product: station.ident.clone(),
        port: port.to_owned(),
        line: line.to_owned(),
        protocol: crate::protocol::dp::NAME.to_owned(),
        evidence: [Some(row("FDL status", station.kind, is)), cfg, ident].into_iter().flatten().collect(),
        state: station.state.zip(station.does()).map(|(slug, name)| State { slug: slug.to_owned(), name }),
        fault: None,
        warnings: station.error.as_ref().map(|ErrorDoc { message, .. }| message.clone()),
    }
}
