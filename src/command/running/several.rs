//! A stop of several drives: each hears it before any of them is looked at, and then all are proven side by side, as if each were alone.

use self::behind::{Came, Others, look_behind, were_left};
use super::{Around, Plan, Said, kept_back, meant, on_drive, said_of, stop_harder, unsent, unstopped};
use crate::args::{Settings, called};
use crate::command::lines::{Nobody, side_by_side};
use crate::command::{Context, connect};
use crate::drive::motion::{Call, Meant, Motor, Situation, shout_round};
use crate::drive::{AccessError, Interrupt, Session, Target, is_there, summary};
use crate::failure::{Class, Failure};
use crate::gate::Relief;
use crate::outcome::{Data, ErrorDoc, Event, Outcome, Stopped, Stops};
use crate::profile::Registry;
use crate::text::{Text, both};
use crate::tick::Span;
use std::cell::{Cell, RefCell};
use std::cmp::Reverse;
use std::collections::BTreeMap;

mod behind;

/// So often the lines of a port are looked at once more, one behind the other, until the other ports are through: for 900 s at least.
const MOST_PASSES: u16 = 3_000;

/// A drive among several: its name, where the drives lie on several lines, and its address.
type Who = (Option<String>, u8);

/// The lines over which the drives of these settings lie, and what holds on each.
pub(in crate::command) fn lines(settings: &Settings) -> &[Settings] {
    if settings.lines.is_empty() { std::slice::from_ref(settings) } else { &settings.lines }
}

/// Stops every drive by `act` and proves it of each, the lines side by side. `plan`: that of one, which can do nothing else; `check` and
/// `work` as those of [`super::run`].
///
/// Fails only where the only line cannot be opened: what is not proven stands beside its drive.
pub(in crate::command) async fn stop_each<'p, C>(
    context: &mut Context<'_>,
    act: Relief,
    plan: impl Fn() -> Plan<'p>,
    check: impl AsyncFn(&mut Session<'_>, &mut Target, &Situation, &mut Plan<'p>) -> Result<C, Failure>,
    work: impl AsyncFn(&mut Motor<'_, '_>, C) -> Result<(), Failure>,
) -> Result<Outcome, Failure> {
    let Context { settings, registry, interrupt, observe, .. } = context;
    interrupt.hear_only_keys();
    let (registry, interrupt, what) = (*registry, &*interrupt, (act, &plan, &check, &work));
    let (busy, stops) = (Cell::new(0), Cell::new(0));
    if settings.lines.is_empty() {
        let alone = Others { busy: &busy, counts: Cell::new(false), waits: false, stops: &stops };
        let stopped = stop_line((settings, registry, interrupt), *observe, &alone, None, what).await?;
        return Ok(told(settings.addresses.named().iter().map(|&address| (None, address)).zip(stopped.came)));
    }
    // One file holds one line, and a second one would not be opened.
    let unrecorded = |line: &Settings| Settings { trace: None, ..line.clone() };
    let lines: Vec<Settings> = settings.lines.iter().map(unrecorded).collect();
    if settings.trace.is_some() {
        let note = both!("not recorded: one file holds one line", "nicht aufgezeichnet: eine Datei fasst eine Leitung");
        (observe)(Event::Note(note));
    }
    let ports: Vec<&[Settings]> = lines.chunk_by(|one, other| one.port == other.port).collect();
    busy.set(ports.len());
    let came = RefCell::new(BTreeMap::new());
    let stop = async |line: &Settings, tell: &mut dyn FnMut(Event)| {
        let at = lines.iter().position(|other| std::ptr::eq(other, line)).unwrap_or_default();
        let is_last = ports.iter().filter_map(|lines| lines.last()).any(|last| std::ptr::eq(last, line));
        let is_alone = lines.iter().filter(|other| other.port == line.port).count() < 2;
        let port = Others { busy: &busy, counts: Cell::new(is_last), waits: true, stops: &stops };
        let passing = || Others { busy: &busy, counts: Cell::new(false), waits: false, stops: &stops };
        if is_alone {
            let stopped = stop_line((line, registry, interrupt), tell, &port, None, what).await;
            came.borrow_mut().insert(at, stopped);
            return port.is_done();
        }
        let stopped = stop_line((line, registry, interrupt), tell, &passing(), None, what).await;
        came.borrow_mut().insert(at, stopped);
        if !is_last {
            return;
        }
        // While a line of a port is stopped or looked at, nobody sees the drives of its others: those that take long are looked at first, and
        // all until the other ports are through.
        for _ in 0..MOST_PASSES {
            port.is_busy();
            let is_here = |at: &usize| lines.get(*at).is_some_and(|other| other.port == line.port);
            let mut again: Vec<(Reverse<Span>, usize)> = (came.borrow().iter())
                .filter(|(at, _)| is_here(at))
                .filter_map(|(at, stopped)| Some((Reverse(stopped.as_ref().ok()?.slowest), *at)))
                .collect();
            again.sort();
            for (_, at) in again {
                let done = match came.borrow_mut().get_mut(&at) {
                    Some(Ok(stopped)) => std::mem::take(&mut stopped.came),
                    _ => continue,
                };
                let Some(line) = lines.get(at) else { continue };
                let stopped = stop_line((line, registry, interrupt), tell, &passing(), Some(done), what).await;
                came.borrow_mut().insert(at, stopped);
            }
            port.is_done();
            if !port.are_busy() {
                break;
            }
            tokio::task::yield_now().await;
        }
    };
    side_by_side(&lines, *observe, stop).await;
    let mut each = Vec::new();
    for (at, line) in settings.lines.iter().enumerate() {
        let Some(stopped) = came.borrow_mut().remove(&at) else { continue };
        let (names, addresses) = (called(line)?, line.addresses.named());
        let came = match stopped {
            Ok(LineStopped { mut came, seen, .. }) => {
                if stops.get() > seen {
                    were_left(&mut came);
                }
                came
            }
            Err(failure) => addresses.iter().map(|_| Err(failure.clone())).collect(),
        };
        each.extend(addresses.iter().map(|address| (names.get(address).cloned(), *address)).zip(came));
    }
    Ok(told(each.into_iter()))
}

/// What came of the drives of a line.
struct LineStopped {
    came: Vec<Came>,
    /// So often drives of any port had been stopped anew as the last look at these began.
    seen: u32,
    /// The longest that one of them took for an answer.
    slowest: Span,
}

/// Stops the drives of a line; or, where that is `done`, looks at them once more.
async fn stop_line<'p, C>(
    (settings, registry, interrupt): (&Settings, &Registry, &Interrupt),
    observe: &mut dyn FnMut(Event),
    others: &Others<'_>,
    done: Option<Vec<Came>>,
    (act, plan, check, work): (
        Relief,
        &impl Fn() -> Plan<'p>,
        &impl AsyncFn(&mut Session<'_>, &mut Target, &Situation, &mut Plan<'p>) -> Result<C, Failure>,
        &impl AsyncFn(&mut Motor<'_, '_>, C) -> Result<(), Failure>,
    ),
) -> Result<LineStopped, Failure> {
    spoken(settings)?;
    let addresses = settings.addresses.named();
    let drives = meant(settings, registry, addresses)?;
    let mut session = match connect(settings, registry, interrupt, observe).await {
        Ok(session) => session,
        Err(failure) => {
            let mut came = done.ok_or_else(|| unsent(failure))?;
            were_left(&mut came);
            return Ok(LineStopped { came, seen: others.stops.get(), slowest: Span::ZERO });
        }
    };
    let stop = async |session: &mut Session<'_>, drive: &Meant, call: Option<Call<'_>>, pressed: bool| {
        let mut around = Around { settings, registry, interrupt, ask: &mut Nobody };
        stop_one(session, &mut around, (drive, call, pressed), (act, plan()), check, work).await
    };
    let again = async |session: &mut Session<'_>, drive: &Meant| stop(session, drive, None, false).await;
    let mut came = match done {
        Some(came) => came,
        None => {
            let (calls, pressed) = shout_round(&mut session, registry, &drives, act).await;
            let calls: RefCell<Vec<Option<Call<'_>>>> = RefCell::new(calls.into_iter().map(Some).collect());
            let one = async |session: &mut Session<'_>, at: usize| {
                let call = calls.borrow_mut().get_mut(at).and_then(Option::take);
                let Some(drive) = drives.get(at) else { return Ok(Outcome::default()) };
                stop(session, drive, call, pressed).await
            };
            in_turns(&mut session, &drives.iter().collect::<Vec<_>>(), one, &again).await
        }
    };
    let seen = look_behind(&mut session, (registry, act), others, (&drives, &mut came), again).await;
    let slowest = drives.iter().map(|drive| session.slowest_answer(drive.address)).max().unwrap_or(Span::ZERO);
    Ok(LineStopped { came, seen, slowest })
}

/// Stops these side by side, and those that were not heard in it alone.
async fn in_turns<'a>(
    session: &mut Session<'a>,
    drives: &[&Meant],
    one: impl AsyncFn(&mut Session<'a>, usize) -> Came,
    alone: impl AsyncFn(&mut Session<'a>, &Meant) -> Came,
) -> Vec<Came> {
    let whom: Vec<u8> = drives.iter().map(|drive| drive.address).collect();
    let mut came = session.side_by_side(&whom, one).await;
    for (drive, came) in drives.iter().zip(&mut came) {
        // Somebody slow says nothing in turns that are short.
        if session.is_interrupted() || !is_unheard(came) {
            continue;
        }
        session.speaks_of(Some(drive.address));
        if is_there(session, drive.address).await {
            *came = alone(session, drive).await;
        }
    }
    came
}

/// Refuses a line of another kind among several: nothing is sent on it, and the others are stopped.
fn spoken(settings: &Settings) -> Result<(), Failure> {
    if !settings.profibus && !settings.is_can() {
        return Ok(());
    }
    let message = both!(
        "nothing was sent: a stop of several goes over Modbus and VABus alone",
        "es wurde nichts gesendet: ein Halt mehrerer geht nur über Modbus und VABus"
    );
    Err(kept_back(Failure::new(Class::Usage, "usage.protocol", message)))
}

/// Goes on saying it to one of them, and proves it.
async fn stop_one<'p, C>(
    session: &mut Session<'_>,
    around: &mut Around<'_>,
    (drive, call, pressed): (&Meant, Option<Call<'_>>, bool),
    (act, plan): (Relief, Plan<'p>),
    check: &impl AsyncFn(&mut Session<'_>, &mut Target, &Situation, &mut Plan<'p>) -> Result<C, Failure>,
    work: &impl AsyncFn(&mut Motor<'_, '_>, C) -> Result<(), Failure>,
) -> Came {
    let mut plan = plan;
    let first_word = match call.filter(|_| plan.zero.is_none()) {
        Some(call) => {
            plan.said = true;
            match call.go_on(session, around.registry).await {
                Ok(first_word) => first_word,
                // Who does not answer may hear: the stronger word goes out to him, too, and he is stopped on.
                Err(AccessError::Interrupted) => {
                    stop_harder(session, (around.settings, around.registry), drive.address, Some(act)).await?
                }
                Err(error) => return Err(unstopped(error.failure(drive.address, None), act, true)),
            }
        }
        None => said_of(session, around.registry, drive, act, &mut plan).await?,
    };
    let pressed = pressed || first_word.pressed;
    let said = Said { address: drive.address, first_word, pressed };
    on_drive(session, around, said, plan, check, work).await
}

/// Whether a drive was not heard at all.
fn is_unheard(came: &Came) -> bool {
    came.as_ref().is_err_and(|failure| failure.is_unheard())
}

/// What came of all.
fn told(each: impl Iterator<Item = (Who, Came)>) -> Outcome {
    let (mut drives, mut failures) = (Vec::new(), Vec::new());
    for ((called, address), came) in each {
        let (motion, failure) = match came {
            Ok(Outcome { data: Some(Data::Motion(motion)), failure, .. }) => (Some(motion), failure),
            Ok(Outcome { failure, .. }) => (None, failure),
            Err(failure) => (None, Some(failure)),
        };
        drives.push(Stopped { called: called.clone(), address, motion, error: failure.as_ref().map(ErrorDoc::from) });
        failures.extend(failure.map(|failure| ((called, address), failure)));
    }
    let succeeded = drives.len().saturating_sub(failures.len());
    let failure = summed_up(failures, succeeded);
    Outcome { data: Some(Data::Stops(Stops { drives })), warnings: Vec::new(), failure }
}

/// Names every drive that is not proven to stand; who reads only the last line must not miss one. Where some stand it is 9; where
/// none was proven, that of which least is known counts, whatever the order of the addresses.
fn summed_up(failures: Vec<(Who, Failure)>, succeeded: usize) -> Option<Failure> {
    let message = Text::join(&failures.iter().map(named).collect::<Vec<_>>(), "; ");
    let who = |((called, address), _): &(Who, Failure)| called.clone().unwrap_or_else(|| address.to_string());
    let addresses = failures.iter().map(who).collect::<Vec<_>>().join(", ");
    // Who stands on another line stands all the same.
    let is_of_a_line = |((called, _), failure): &(Who, Failure)| called.is_some() && failure.class == Class::Port;
    let a_line_failed = succeeded > 0 && failures.iter().any(is_of_a_line);
    let mut failures: Vec<Failure> = failures.into_iter().map(|(_, failure)| failure).collect();
    failures.sort_by_key(|failure| LEAST_KNOWN.iter().position(|class| *class == failure.class));
    let partial = |failure| Failure { class: Class::Partial, code: "partial".to_owned(), ..failure };
    let summed = match a_line_failed {
        true => failures.into_iter().next().map(partial),
        false => summary(failures, succeeded),
    };
    summed.map(|failure| Failure { message, alarm: false, of: None, ..failure }.with("addresses", addresses))
}

/// What is told of a drive, with its name or address once.
fn named(((called, address), failure): &(Who, Failure)) -> Text {
    let why = Failure { of: None, ..failure.clone() }.told();
    match called {
        Some(called) => both!("{called}: {why}", "{called}: {why}", why),
        None => both!("address {address}: {why}", "Adresse {address}: {why}", why),
    }
}

/// From what tells nothing of a drive to what tells most.
const LEAST_KNOWN: [Class; 11] = [
    Class::Bug,
    Class::Port,
    Class::Interrupted,
    Class::Silence,
    Class::Garbled,
    Class::Refused,
    Class::Forbidden,
    Class::No,
    Class::Partial,
    Class::Data,
    Class::Usage,
];
