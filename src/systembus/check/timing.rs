//! Times: of sending, time-outs, SYNC, and the load of the bus (EM-RES-03 manual 5.8.2, 5.11.2, 5.11.3, 5.14.3).

use super::{Remark, error, note, warning};
use crate::systembus::load::Verdict;
use crate::systembus::plan::{Drive, Plan, Rx, Trigger};
use crate::text::both;
use std::ops::RangeInclusive;

/// Of P.931, 933, 935: 7.2 prints 0 as the least, 5.11.2 prints 1, and nobody says what 0 would do.
const SEND_MS: RangeInclusive<u32> = 1..=50_000;
/// Of P.919.
const SYNC_MS: RangeInclusive<u32> = 0..=50_000;
/// Of P.939, 941, 942, 945.
const TIMEOUT_MS: RangeInclusive<u32> = 0..=60_000;

pub(super) fn check(plan: &Plan) -> Vec<Remark> {
    let mut remarks = Vec::new();
    for (name, tx, identifier, trigger) in plan.sent() {
        let Trigger::Time(ms) = trigger else { continue };
        if !SEND_MS.contains(&ms) {
            let (least, most) = (SEND_MS.start(), SEND_MS.end());
            let text = both!(
                "{name}: identifier {identifier} every {ms} ms: expected {least} to {most}",
                "{name}: Identifier {identifier} alle {ms} ms: erwartet {least} bis {most}"
            );
            remarks.extend((tx.is_some() || ms == 0).then(|| error("send_time", text)));
        }
    }
    for drive in &plan.drives {
        for rx in &drive.rx {
            remarks.extend(timeout(plan, drive, rx));
        }
        remarks.extend(numbering(drive));
    }
    remarks.extend(sync(plan));
    remarks.extend(load(plan));
    remarks
}

/// The time-out of a receiver against how often it is sent to.
fn timeout(plan: &Plan, drive: &Drive, rx: &Rx) -> Option<Remark> {
    let who = format!("{} RxPDO{}", drive.name, rx.number.number());
    let timeout = rx.timeout_ms;
    if !TIMEOUT_MS.contains(&timeout) {
        let most = TIMEOUT_MS.end();
        let text = both!(
            "{who}: a time-out of {timeout} ms: expected 0 to {most}",
            "{who}: eine Timeout-Zeit von {timeout} ms: erwartet 0 bis {most}"
        );
        return Some(error("timeout_range", text));
    }
    let sent = plan.sent().find(|row| row.2 == rx.identifier).and_then(|row| plan.every_ms(row.3));
    match (timeout, sent) {
        (0, _) => {
            let text = both!(
                "{who} is not watched: if its sender falls silent, the last values stay",
                "{who} wird nicht überwacht: verstummt der Sender, bleiben die letzten Werte stehen"
            );
            Some(note("unwatched", text))
        }
        (_, Some(every)) if timeout <= every => {
            let text = both!(
                "{who}: trips after {timeout} ms, but is sent to only every {every} ms",
                "{who}: löst nach {timeout} ms aus, bekommt aber nur alle {every} ms etwas"
            );
            Some(error("timeout_short", text))
        }
        (_, Some(every)) if timeout < every.saturating_mul(2) => {
            let text = both!(
                "{who}: trips after {timeout} ms, one lost PDO of every {every} ms is enough",
                "{who}: löst nach {timeout} ms aus, ein verlorenes PDO von alle {every} ms genügt"
            );
            Some(warning("timeout_tight", text))
        }
        _ => None,
    }
}

/// What no plan can tell: how a drive counts the functions of its RxPDOs.
fn numbering(drive: &Drive) -> Option<Remark> {
    let name = &drive.name;
    let is_open = drive.numbering.is_none() && !drive.rx.is_empty();
    is_open.then(|| {
        note(
            "rx_functions",
            both!(
                "{name}: the manual prints two numberings for P.936 to P.938; say rx-functions = \"0-1\" or \"0-2\"",
                "{name}: die Anleitung druckt für P.936 bis P.938 zwei Zählungen; rx-functions = \"0-1\" oder \"0-2\" angeben"
            ),
        )
    })
}

fn sync(plan: &Plan) -> Vec<Remark> {
    let mut remarks = Vec::new();
    let every = plan.sync_every_ms;
    if every.is_some_and(|ms| !SYNC_MS.contains(&ms)) {
        let most = SYNC_MS.end();
        let text = both!("sync-every: expected 0 to {most} ms (P.919)", "sync-every: erwartet 0 bis {most} ms (P.919)");
        remarks.push(error("sync_time", text));
    }
    if plan.uses_sync() && every.is_none_or(|ms| ms == 0) {
        let text = both!(
            "PDOs wait for SYNC, but nobody says how often it comes (sync-every)",
            "PDOs warten auf SYNC, aber niemand sagt, wie oft es kommt (sync-every)"
        );
        let is_known = plan.master().is_some() || every == Some(0);
        remarks.push(if is_known { error("no_sync", text) } else { warning("no_sync", text) });
    }
    for drive in plan.drives.iter().filter(|drive| drive.sync_timeout_ms > 0) {
        let (name, timeout) = (&drive.name, drive.sync_timeout_ms);
        if !TIMEOUT_MS.contains(&timeout) {
            let text =
                both!("{name}: sync-timeout: expected 0 to 60000 ms", "{name}: sync-timeout: erwartet 0 bis 60000 ms");
            remarks.push(error("timeout_range", text));
        } else if !drive.uses_sync() {
            let text = both!(
                "{name}: sync-timeout has no effect, none of its PDOs waits for SYNC",
                "{name}: sync-timeout wirkt nicht, keines seiner PDOs wartet auf SYNC"
            );
            remarks.push(warning("sync_timeout_idle", text));
        } else if every.is_some_and(|every| every > 0 && timeout <= every) {
            let text = both!(
                "{name}: trips {timeout} ms behind a SYNC, but it comes only every {every} ms",
                "{name}: löst {timeout} ms nach einem SYNC aus, es kommt aber nur alle {every} ms",
                every = every.unwrap_or_default()
            );
            remarks.push(error("timeout_short", text));
        }
    }
    remarks
}

fn load(plan: &Plan) -> Vec<Remark> {
    let budget = plan.budget();
    let mut remarks = Vec::new();
    for ((name, _, identifier, _), charge) in plan.sent().zip(&budget.charges) {
        if let Some(load) = charge.load.filter(|load| load.exceeds(100)) {
            let text = both!(
                "{name}: identifier {identifier} alone takes {load} % of the bus: it is not out before it is due again",
                "{name}: Identifier {identifier} belegt allein {load} % des Busses: er ist nicht draußen, bevor er wieder fällig ist"
            );
            remarks.push(error("pdo_load", text));
        }
    }
    let total = match budget.total.verdict() {
        Verdict::NotFeasible => budget.total.beyond(90),
        Verdict::Critical | Verdict::Okay => budget.total.beyond(80),
    };
    match budget.total.verdict() {
        Verdict::NotFeasible => remarks.push(error(
            "bus_load",
            both!(
                "a bus load of {total} %: above 90 % is not feasible",
                "eine Buslast von {total} %: über 90 % ist nicht realisierbar"
            ),
        )),
        Verdict::Critical => remarks.push(warning(
            "bus_load",
            both!(
                "a bus load of {total} %: above 80 % is critical",
                "eine Buslast von {total} %: über 80 % ist kritisch"
            ),
        )),
        Verdict::Okay => {}
    }
    if budget.is_open() {
        remarks.push(note(
            "load_open",
            both!(
                "the bus load lacks PDOs of which nobody says how often they are sent",
                "der Buslast fehlen PDOs, von denen niemand sagt, wie oft sie gesendet werden"
            ),
        ));
    }
    remarks
}
