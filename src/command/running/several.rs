//! A stop of several drives: each hears it before any of them is looked at, and then all are proven side by side, as if each were alone.

use self::behind::{Came, look_behind, were_left};
use self::ports::{Port, Ports};
use super::{Around, Plan, Said, kept_back, meant, on_drive, said_of, stop_harder, unsent, unstopped};
use crate::args::{Settings, called};
use crate::command::lines::{Nobody, by_port, ports_side_by_side};
use crate::command::{Context, connect};
use crate::drive::motion::{Call, Meant, Motor, Situation, shout_round};
use crate::drive::{AccessError, Interrupt, Session, Target, is_there, summary};
use crate::failure::{Class, Failure};
use crate::gate::Relief;
use crate::outcome::{Data, ErrorDoc, Event, Outcome, Stopped, Stops};
use crate::profile::Registry;
use crate::text::{Text, both};
use crate::tick::Span;
use std::cell::RefCell;
use std::cmp::Reverse;

mod behind;
mod ports;

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
    if settings.lines.is_empty() {
        let alone = Ports::default();
        let stopped =
            stop_line((settings, registry, interrupt), *observe, &alone.one_of_several_lines(), None, what).await?;
        return Ok(told(settings.addresses.named().iter().map(|&address| (None, address)).zip(stopped.came)));
    }
    // One file holds one line, and a second one would not be opened.
    let unrecorded = |line: &Settings| Settings { trace: None, ..line.clone() };
    let lines: Vec<Settings> = settings.lines.iter().map(unrecorded).collect();
    if settings.trace.is_some() {
        let note = both!("not recorded: one file holds one line", "nicht aufgezeichnet: eine Datei fasst eine Leitung");
        (observe)(Event::Note(note));
    }
    let ports = Ports::new(by_port(&lines).count());
    let stop = async |lines: &[Settings], tell: &mut dyn FnMut(Event)| {
        let line = async |line: &Settings, port: &Port<'_>, done: Option<Vec<Came>>| {
            stop_line((line, registry, interrupt), tell, port, done, what).await
        };
        stop_port(lines, &ports, line).await
    };
    let stopped = ports_side_by_side(&lines, *observe, stop).await;
    let mut each = Vec::new();
    for (line, stopped) in lines.iter().zip(stopped) {
        let (names, addresses) = (called(line)?, line.addresses.named());
        let came = match stopped {
            Ok(LineStopped { mut came, seen, .. }) => {
                if ports.stops() > seen {
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

/// Stops the drives of a port. While one of its lines is stopped or looked at, nobody sees the drives of its others: so those that take long
/// are looked at once more first, and all until the other ports are through.
async fn stop_port(
    lines: &[Settings],
    ports: &Ports,
    mut stop: impl AsyncFnMut(&Settings, &Port<'_>, Option<Vec<Came>>) -> Result<LineStopped, Failure>,
) -> Vec<Result<LineStopped, Failure>> {
    let (port, of_several) = (ports.port(), ports.one_of_several_lines());
    if let [line] = lines {
        let stopped = stop(line, &port, None).await;
        port.is_done();
        return vec![stopped];
    }
    let mut came = Vec::new();
    for line in lines {
        came.push(stop(line, &of_several, None).await);
    }
    for _ in 0..MOST_PASSES {
        port.is_busy();
        let mut again: Vec<usize> = (0..came.len()).collect();
        let slowest = |at: &usize| Some(came.get(*at)?.as_ref().ok()?.slowest);
        again.sort_by_key(|at| Reverse(slowest(at)));
        for at in again {
            let (Some(line), Some(stopped)) = (lines.get(at), came.get_mut(at)) else { continue };
            if let Ok(done) = stopped {
                let done = std::mem::take(&mut done.came);
                *stopped = stop(line, &of_several, Some(done)).await;
            }
        }
        port.is_done();
        if !port.others_are_busy() {
            break;
        }
        tokio::task::yield_now().await;
    }
    came
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
    port: &Port<'_>,
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
    // Who interrupted on a line before this one is in a hurry here as well, where nobody has heard his stop yet.
    let mut interrupt = interrupt.clone();
    let hurries = interrupt.is_raised();
    if hurries {
        interrupt.note();
    }
    let interrupt = &interrupt;
    let mut session = match connect(settings, registry, interrupt, observe).await {
        Ok(session) => session,
        Err(failure) => {
            let mut came = done.ok_or_else(|| unsent(failure))?;
            were_left(&mut came);
            return Ok(LineStopped { came, seen: port.stops(), slowest: Span::ZERO });
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
                stop(session, drive, call, pressed || hurries).await
            };
            in_turns(&mut session, &drives.iter().collect::<Vec<_>>(), one, &again).await
        }
    };
    let seen = look_behind(&mut session, (registry, act), port, (&drives, &mut came), again).await;
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
