//! Diagnosis of the line to a drive: its counters (code 8) and a link test.

use super::access::AccessError;
use super::route::{Cell, Inquiry};
use super::session::Session;
use super::target::Target;
use crate::exchange::{Answer, ExchangeError, Limits};
use crate::gate::{Counters, Permit};
use crate::outcome::{Bucket, Counter, Event, LinkTest};
use crate::profile::{Cause, Family, Role, Route as Way, Type};
use crate::protocol::Protocol;
use crate::text::both;

/// Reads every counter that the family defines; VABus and SDO have none.
pub async fn counters(session: &mut Session<'_>, target: &mut Target) -> Result<Vec<Counter>, AccessError> {
    let mut counters = Vec::new();
    let route = target.route(session).await?;
    if !matches!(route.protocol, Protocol::Modbus(_)) {
        return Ok(counters);
    }
    for row in &target.family.counters {
        let question = route.question(Inquiry::Counter(row.sub)).ok_or(AccessError::Unspeakable)?;
        let count = match session.ask(target.address, question).await? {
            Answer::Reply { said, .. } => route.number(&said),
            Answer::Broadcast => None,
        };
        counters.push(Counter {
            sub: row.sub,
            slug: row.slug.clone(),
            name: row.text(),
            count,
            help: row.help.clone(),
        });
    }
    Ok(counters)
}

/// Why the drive refused something last, where the family keeps it in a sub-function of code 8.
pub async fn last_refusal(session: &mut Session<'_>, target: &mut Target) -> Result<Option<u16>, AccessError> {
    let Cause::Diagnostics(sub) = target.family.link.cause else { return Ok(None) };
    let route = target.route(session).await?;
    let question = route.question(Inquiry::Counter(sub)).ok_or(AccessError::Unspeakable)?;
    session.number(route, question).await
}

/// Sets every counter to zero.
pub async fn clear_counters(
    session: &mut Session<'_>,
    target: &mut Target,
    _permit: &Permit<Counters>,
) -> Result<bool, AccessError> {
    let route = target.route(session).await?;
    let question = route.question(Inquiry::ClearCounters).ok_or(AccessError::Unspeakable)?;
    let answer = session.ask(target.address, question).await?;
    Ok(matches!(answer, Answer::Reply { said, .. } if !said.is_refusal()))
}

/// A question that changes nothing in a drive and does not touch its error register: a counter; where there is none, over
/// VABus or in a family of which only registers are known, the status word or the first value that it shows.
pub fn harmless(family: &Family, protocol: Protocol) -> Inquiry {
    let counts = matches!(protocol, Protocol::Modbus(_)) && family.link.route != Way::Registers;
    let shown = || family.group("all").and_then(|all| family.param(*all.first()?));
    match family.role(Role::StatusWord).or_else(shown).filter(|_| !counts) {
        Some(param) => Inquiry::Read(Cell { number: param.id, set: 0 }, param.kind.unwrap_or(Type::Uint)),
        None => Inquiry::Counter(family.link.echo),
    }
}

/// Asks the same harmless question `count` times, without repeats, and measures; says also what ended it early.
pub async fn link_test(
    session: &mut Session<'_>,
    target: &mut Target,
    count: u64,
) -> Result<(LinkTest, Option<AccessError>), AccessError> {
    let route = target.route(session).await?;
    let question = harmless(&target.family, route.protocol);
    let question = route.question(question).ok_or(AccessError::Unspeakable)?;
    let once = Limits { retries: 0, ..session.limits() };
    let strays = session.tally().strays;
    let (mut times, mut silent, mut garbled, mut asked) = (Vec::new(), 0u64, 0u64, 0u64);
    let mut cut = None;
    for done in 0..count {
        let address = target.address;
        let what = both!("link test, address {address}", "Leitungstest, Adresse {address}");
        session.tell(Event::Progress { done, total: count, what });
        match session.ask_within(target.address, question.clone(), once).await {
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
        histogram: histogram(&times),
    };
    Ok((test, cut))
}

/// Ends of the buckets in milliseconds: fine where drives and adapters differ, coarse beyond.
const BUCKETS_MS: [u64; 14] = [1, 2, 5, 8, 10, 12, 15, 20, 30, 50, 100, 200, 500, 1_000];

fn histogram(times_us: &[u64]) -> Vec<Bucket> {
    let ends = BUCKETS_MS.into_iter().map(|ms| Some(ms * 1_000)).chain([None]);
    let starts = [0].into_iter().chain(BUCKETS_MS.into_iter().map(|ms| ms * 1_000));
    let buckets = starts.zip(ends).map(|(from_us, to_us)| {
        let within = |us: &&u64| **us >= from_us && to_us.is_none_or(|to| **us < to);
        Bucket { from_us, to_us, count: times_us.iter().filter(within).count() as u64 }
    });
    buckets.filter(|bucket| bucket.count > 0).collect()
}
