//! Diagnosis of the line to a drive: its counters (code 8) and a link test.

use super::session::{AccessError, Session};
use super::transfer::Target;
use crate::exchange::modbus::{Answer, ExchangeError, Limits};
use crate::gate::Permit;
use crate::outcome::{Counter, Event, LinkTest};
use crate::profile::Lang;
use crate::protocol::modbus::pdu::{CLEAR_COUNTERS, Reply, Request};

/// Sub-function for link tests: the number of messages to this slave (CM-485 manual 6.4.5). Changes nothing in the
/// drive and does not touch its error register.
const SLAVE_MESSAGES: u16 = 0x0E;

/// Reads every counter that the family defines.
pub async fn counters(session: &mut Session<'_>, target: &Target, lang: Lang) -> Result<Vec<Counter>, AccessError> {
    let mut counters = Vec::new();
    for row in &target.family.counters {
        let request = Request::Diagnostics { sub: row.sub, data: 0 };
        let count = match session.ask(target.address, request).await? {
            Answer::Reply { reply: Reply::Diagnostics { data, .. }, .. } => Some(data),
            _ => None,
        };
        counters.push(Counter {
            sub: row.sub,
            slug: row.slug.clone(),
            name: row.name(lang).to_owned(),
            count,
            help: row.help.get(lang).to_owned(),
        });
    }
    Ok(counters)
}

/// Sets every counter to zero.
pub async fn clear_counters(session: &mut Session<'_>, target: &Target, _permit: &Permit) -> Result<bool, AccessError> {
    let request = Request::Diagnostics { sub: CLEAR_COUNTERS, data: 0 };
    let answer = session.ask(target.address, request).await?;
    Ok(matches!(answer, Answer::Reply { reply: Reply::Diagnostics { .. }, .. }))
}

/// Asks the same harmless question `count` times, without repeats, and measures; says also what ended it early.
pub async fn link_test(session: &mut Session<'_>, target: &Target, count: u64) -> (LinkTest, Option<AccessError>) {
    let limits = session.limits();
    session.set_limits(Limits { retries: 0, ..limits });
    let strays = session.tally().strays;
    let (mut times, mut silent, mut garbled, mut asked) = (Vec::new(), 0u64, 0u64, 0u64);
    let mut cut = None;
    for done in 0..count {
        session.tell(Event::Progress { done, total: count, what: format!("link test, address {}", target.address) });
        let request = Request::Diagnostics { sub: SLAVE_MESSAGES, data: 0 };
        match session.ask(target.address, request).await {
            Ok(Answer::Reply { after, .. }) => times.push(after.as_micros()),
            Ok(Answer::Broadcast) => {}
            Err(AccessError::Exchange(ExchangeError::Silence { .. })) => silent += 1,
            Err(AccessError::Exchange(_)) => garbled += 1,
            Err(error) => {
                cut = Some(error);
                break;
            }
        }
        asked += 1;
    }
    session.set_limits(limits);
    times.sort_unstable();
    let rank = |percent: usize| times.get((times.len().saturating_sub(1)) * percent / 100).copied();
    let failed = silent + garbled;
    let test = LinkTest {
        asked,
        replies: times.len() as u64,
        silent,
        garbled,
        strays: session.tally().strays - strays,
        error_rate_percent: (failed * 10_000u64).checked_div(asked).unwrap_or(0) as f64 / 100.0,
        fastest_us: times.first().copied(),
        median_us: rank(50),
        p95_us: rank(95),
        slowest_us: times.last().copied(),
    };
    (test, cut)
}
