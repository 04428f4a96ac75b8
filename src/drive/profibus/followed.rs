//! The live list as it changes: stations that come, go, or are in another state.
//!
//! Between a few addresses of which nothing is known those are asked again that were there, so that a station is missed soon, and a new one is
//! found within a round.

use super::line::Line;
use super::live::look;
use crate::failure::{Class, Failure};
use crate::outcome::{Decimal, Event, LiveList, LiveStation, Record, StationChange, StationNews};
use crate::tick::{Span, Tick};
use std::collections::BTreeMap;

/// So many addresses are tried between two looks at who is there.
const TRIED: usize = 4;
/// Nobody who is there is asked more often.
const EVERY: Span = Span::from_millis(500);
/// A station that was not heard so often is gone; each time it was asked twice.
const MISSED: u8 = 2;

/// A station, and how often it was missed.
struct Known {
    station: LiveStation,
    missed: u8,
}

/// Follows these addresses until the moment, if there is one, or until somebody ends it. Who was there at the end, and what ended it early.
pub async fn follow(line: &mut Line<'_>, addresses: &[u8], until: Option<Tick>) -> (LiveList, Option<Failure>) {
    let (begun, own) = (line.now(), line.fdl.address());
    let mut known: BTreeMap<u8, Known> = BTreeMap::new();
    let mut open = addresses.iter().copied().filter(|address| *address != own).collect::<Vec<_>>().into_iter().cycle();
    let (mut asked, mut looked) = (0, begun);
    let failure = 'follow: loop {
        let mut turn: Vec<u8> = open.by_ref().take(TRIED).filter(|address| !known.contains_key(address)).collect();
        asked += turn.len();
        if line.now().since(looked) >= EVERY {
            looked = line.now();
            turn.extend(known.keys());
        }
        if turn.is_empty() {
            let rest = line.rest(line.now() + EVERY).await;
            if let Err(failure) = rest {
                break failure;
            }
        }
        for address in turn {
            if until.is_some_and(|until| line.now() >= until) {
                break 'follow Failure::new(Class::Interrupted, "interrupted", crate::text::Text::default());
            }
            let found = match look(line, address).await {
                Ok(found) => found,
                Err(failure) => break 'follow failure,
            };
            let t = seconds(line.now().since(begun));
            if let Some((change, station)) = takes(&mut known, address, found) {
                let news = StationNews { t, change, station };
                line.tell(Event::Record(Box::new(Record::Station(Box::new(news)))));
            }
        }
    };
    let (port, setting) = line.name();
    let stations = known.into_values().map(|known| known.station).collect();
    let list =
        LiveList { port, line: setting, asked: asked.min(addresses.len()), addresses: addresses.len(), stations };
    // Time that is over, and somebody who ends it, are its usual ends.
    (list, Some(failure).filter(|failure| failure.class != Class::Interrupted))
}

/// What a look has changed.
fn takes(
    known: &mut BTreeMap<u8, Known>,
    address: u8,
    found: Option<LiveStation>,
) -> Option<(StationChange, LiveStation)> {
    match (known.get_mut(&address), found) {
        (None, None) => None,
        (None, Some(station)) => {
            known.insert(address, Known { station: station.clone(), missed: 0 });
            Some((StationChange::Came, station))
        }
        (Some(old), Some(station)) => {
            let is_new = told(&old.station) != told(&station);
            *old = Known { station: station.clone(), missed: 0 };
            is_new.then_some((StationChange::Changed, station))
        }
        (Some(old), None) => {
            old.missed += 1;
            if old.missed < MISSED {
                return None;
            }
            known.remove(&address).map(|gone| (StationChange::Went, gone.station))
        }
    }
}

/// What makes a station another one: not times and repeats.
fn told(station: &LiveStation) -> impl PartialEq + '_ {
    let LiveStation { kind, ident, state, master, flags, configuration, error, .. } = station;
    (kind, ident, state, master, flags, configuration, error.is_some())
}

fn seconds(span: Span) -> Decimal {
    Decimal { raw: i64::try_from(span.as_micros()).unwrap_or(i64::MAX), decimals: 6 }
}
