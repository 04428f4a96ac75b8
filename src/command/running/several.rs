//! A stop of several drives: each hears it before any of them is looked at, and then all are proven side by side, as if each were alone.

use super::{Around, Plan, Said, meant, on_drive, said_of, stop_harder, unsent, unstopped, verdict};
use crate::args::{Settings, called};
use crate::command::lines::{Nobody, side_by_side};
use crate::command::{Context, connect};
use crate::drive::motion::{
    Call, LAST_LOOK, Meant, Motor, OPERATION, QUICK_STOP, Situation, set_going_again, shout_round, state_now, turns,
};
use crate::drive::{AccessError, Interrupt, Session, Target, is_there, summary};
use crate::failure::{Class, Failure};
use crate::gate::Relief;
use crate::outcome::{Data, ErrorDoc, Event, Outcome, Stopped, Stops};
use crate::profile::Registry;
use crate::text::{Text, both};
use crate::tick::{Span, Tick};
use std::cell::{Cell, RefCell};

/// So often all are looked at once more where one of them was set going again, and so often where all are at rest and something is owed.
const MOST_ROUNDS: u8 = 4;
/// Who was seen so lately is not looked at again for another one's sake.
const SEEN_LATELY: Span = Span::from_millis(100);
/// So long is waited between rounds while other ports are not through, and for them.
const BEAT: Span = Span::from_millis(100);
const LONGEST_WAIT: Span = Span::from_secs(120);

/// What came of one drive.
type Came = Result<Outcome, Failure>;

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
        let alone = Others { busy: &Cell::new(0), counts: Cell::new(false), waits: false };
        let came = stop_line((settings, registry, interrupt), *observe, &alone, what).await?;
        return Ok(told(settings.addresses.named().iter().map(|&address| (None, address)).zip(came)));
    }
    // One file holds one line, and a second one would not be opened.
    let unrecorded = |line: &Settings| Settings { trace: None, ..line.clone() };
    let lines: Vec<Settings> = settings.lines.iter().map(unrecorded).collect();
    if settings.trace.is_some() {
        let note = both!("not recorded: one file holds one line", "nicht aufgezeichnet: eine Datei fasst eine Leitung");
        (observe)(Event::Note(note));
    }
    let ports = lines.chunk_by(|one, other| one.port == other.port);
    let last: Vec<*const Settings> = ports.filter_map(<[Settings]>::last).map(std::ptr::from_ref).collect();
    let busy = Cell::new(last.len());
    let stop = async |line: &Settings, tell: &mut dyn FnMut(Event)| {
        let is_last = last.contains(&std::ptr::from_ref(line));
        let others = Others { busy: &busy, counts: Cell::new(is_last), waits: is_last };
        let came = stop_line((line, registry, interrupt), tell, &others, what).await;
        others.is_done();
        came
    };
    let came = side_by_side(&lines, *observe, stop).await;
    let mut each = Vec::new();
    for (line, came) in settings.lines.iter().zip(came) {
        let (names, addresses) = (called(line)?, line.addresses.named());
        let came = came.unwrap_or_else(|failure| addresses.iter().map(|_| Err(failure.clone())).collect());
        each.extend(addresses.iter().map(|address| (names.get(address).cloned(), *address)).zip(came));
    }
    Ok(told(each.into_iter()))
}

/// Stops the drives of a line.
async fn stop_line<'p, C>(
    (settings, registry, interrupt): (&Settings, &Registry, &Interrupt),
    observe: &mut dyn FnMut(Event),
    others: &Others<'_>,
    (act, plan, check, work): (
        Relief,
        &impl Fn() -> Plan<'p>,
        &impl AsyncFn(&mut Session<'_>, &mut Target, &Situation, &mut Plan<'p>) -> Result<C, Failure>,
        &impl AsyncFn(&mut Motor<'_, '_>, C) -> Result<(), Failure>,
    ),
) -> Result<Vec<Came>, Failure> {
    spoken(settings)?;
    let addresses = settings.addresses.named();
    let mut session = connect(settings, registry, interrupt, observe).await.map_err(unsent)?;
    let drives = meant(settings, registry, addresses)?;
    let (calls, pressed) = shout_round(&mut session, registry, &drives, act).await;
    let calls: RefCell<Vec<Option<Call<'_>>>> = RefCell::new(calls.into_iter().map(Some).collect());
    let stop = async |session: &mut Session<'_>, drive: &Meant, call: Option<Call<'_>>, pressed: bool| {
        let mut around = Around { settings, registry, interrupt, ask: &mut Nobody };
        stop_one(session, &mut around, (drive, call, pressed), (act, plan()), check, work).await
    };
    let one = async |session: &mut Session<'_>, at: usize| {
        let call = calls.borrow_mut().get_mut(at).and_then(Option::take);
        let Some(drive) = drives.get(at) else { return Ok(Outcome::default()) };
        stop(session, drive, call, pressed).await
    };
    let mut came: Vec<Came> = session.side_by_side(addresses, one).await;
    for (drive, came) in drives.iter().zip(&mut came) {
        // Somebody slow says nothing in turns that are short.
        if session.is_interrupted() || !is_unheard(came) {
            continue;
        }
        session.speaks_of(Some(drive.address));
        if is_there(&mut session, drive.address).await {
            *came = stop(&mut session, drive, None, false).await;
        }
    }
    others.is_done();
    let again = async |session: &mut Session<'_>, drive: &Meant| stop(session, drive, None, false).await;
    look_behind(&mut session, (registry, act), others, (&drives, &mut came), again).await;
    Ok(came)
}

/// A drive behind its proof.
struct Behind<'a> {
    drive: &'a Meant,
    came: &'a mut Came,
    /// Nothing where nothing of it was proven.
    proven: Cell<Option<Proven>>,
    /// When it was seen to be as it was told.
    seen: Option<Tick>,
    /// It is looked at in this round.
    is_due: bool,
    /// It was stopped anew in this round.
    is_stopped: bool,
}

/// Looks at all once more behind the last proof, and stops anew who moves or does not say: who was proven early may be set going again while
/// the others are, and while that one is stopped; so may all behind a look that took long. Behind such a round those are looked at again that
/// were not seen lately: beside somebody slow the others are.
async fn look_behind(
    session: &mut Session<'_>,
    (registry, act): (&Registry, Relief),
    others: &Others<'_>,
    (drives, came): (&[Meant], &mut [Came]),
    stop: impl AsyncFn(&mut Session<'_>, &Meant) -> Came,
) {
    let (end, usual) = (session.now() + LONGEST_WAIT, usual_round(drives.len()));
    session.hastens();
    let mut each = Vec::new();
    for (drive, came) in drives.iter().zip(came) {
        let proven = Cell::new(proven(session, registry, came).await);
        each.push(Behind { drive, came, proven, seen: None, is_due: true, is_stopped: false });
    }
    let (mut calm, mut restless, mut all) = (0, 0, true);
    while calm < MOST_ROUNDS && restless < MOST_ROUNDS {
        let is_early = others.are_busy() && session.now() < end;
        if !waits_for_what_is_owed(session).await {
            break;
        }
        let now = session.now();
        let is_stale = |one: &Behind<'_>| one.seen.is_none_or(|seen| now.since(seen) > SEEN_LATELY);
        each.iter_mut().for_each(|one| one.is_due = all || is_stale(one));
        look_around(session, act, &mut each, &stop).await;
        let now = session.now();
        if is_early {
            session.end_at(None);
            if session.rest(BEAT).await.is_err() {
                break;
            }
            tokio::task::yield_now().await;
        } else if each.iter().any(|one| one.is_stopped) {
            (calm, restless, all) = (0, restless + 1, true);
        } else {
            calm += 1;
            let unseen = each.iter().filter_map(|one| one.seen).min().map_or(Span::ZERO, |oldest| now.since(oldest));
            // Who is slow was seen last, and is not asked again for the sake of the others.
            let is_fresh = unseen <= usual || each.iter().any(|one| !one.is_due);
            if is_fresh && (session.is_shared() || session.owes_for().is_none()) {
                break;
            }
            all = false;
        }
    }
    if each.iter().any(|one| one.is_stopped) {
        each.iter_mut().filter(|one| !one.is_stopped).for_each(|one| unseen_since(one.came));
    }
}

/// A round: in turns, so that each is seen last as late as all of them allow, for a position takes several looks.
async fn look_around(
    session: &mut Session<'_>,
    act: Relief,
    each: &mut [Behind<'_>],
    stop: &impl AsyncFn(&mut Session<'_>, &Meant) -> Came,
) {
    each.iter_mut().for_each(|one| one.is_stopped = false);
    let due: Vec<_> = each.iter_mut().filter(|one| one.is_due).collect();
    let whom: Vec<u8> = due.iter().map(|one| one.drive.address).collect();
    let look =
        async |session: &mut Session<'_>, at: usize| now_of(session, act, due.get(at).map(|one| &one.proven)).await;
    let looked = session.side_by_side(&whom, look).await;
    for (one, now) in due.into_iter().zip(looked) {
        let now = match now {
            // Somebody slow says nothing in turns that are short.
            Now::Unknown => now_of(session, act, Some(&one.proven)).await,
            now => now,
        };
        if let Now::Stopped(seen) = now {
            one.seen = seen;
            continue;
        }
        one.is_stopped = true;
        *one.came = stop(session, one.drive).await;
        if let Ok(Outcome { data: Some(Data::Motion(motion)), .. }) = one.came
            && now == Now::Moves
        {
            motion.notes.push(set_going_again(act));
        }
        let again = one.proven.take().and_then(|proven| Proven::of(one.came, proven.target));
        one.proven.set(again);
    }
}

/// Somebody was stopped anew, and nobody has looked at this one since.
fn unseen_since(came: &mut Came) {
    let Ok(Outcome { data: Some(Data::Motion(motion)), failure: failure @ None, .. }) = came else { return };
    motion.standing = None;
    if let Some(setpoint) = &mut motion.setpoint {
        setpoint.reached = None;
    }
    let text = both!(
        "somebody else sets drives of the group going again; since the last of them was stopped nobody has looked at this one",
        "jemand anderes setzt Antriebe der Gruppe wieder in Gang; seit dem Halt des letzten hat diesen niemand angesehen"
    );
    let unseen = Failure::new(Class::Forbidden, verdict::STANDSTILL_UNPROVEN, text);
    *failure = Some(verdict::warned(unseen).hint(both!(
        "stop that, and say the stop again; or the enable input, the emergency stop, the mains",
        "das abstellen, und den Halt noch einmal geben; oder Freigabeeingang, Not-Halt, Netz"
    )));
}

/// Behind a look at so many drives, each was seen as lately as this, unless an answer was late.
fn usual_round(drives: usize) -> Span {
    const EACH: Span = Span::from_millis(40);
    Span::from_micros(EACH.as_micros() * drives as u64).longer(Span::from_millis(200))
}

/// The other ports, whose drives are stopped at the same time.
struct Others<'a> {
    /// So many ports are not through yet.
    busy: &'a Cell<usize>,
    /// This one is counted among them.
    counts: Cell<bool>,
    /// Its drives are looked at until all are through: it is the last line of its port.
    waits: bool,
}

impl Others<'_> {
    /// The drives of this line are proven, or were not reached.
    fn is_done(&self) {
        if self.counts.replace(false) {
            self.busy.set(self.busy.get().saturating_sub(1));
        }
    }

    fn are_busy(&self) -> bool {
        self.waits && self.busy.get() > 0
    }
}

/// Waits for replies that are still owed, if nobody else has the line: it is kept for so long anyway. Whether there is time to look once more;
/// who interrupts has none.
async fn waits_for_what_is_owed(session: &mut Session<'_>) -> bool {
    if session.is_interrupted() || session.presses() > 0 {
        return false;
    }
    let left = session.owes_for().filter(|_| !session.is_shared()).unwrap_or(Span::ZERO);
    session.end_at(None);
    session.rest(left).await.is_ok()
}

/// What a drive does behind its proof.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Now {
    /// As it was told, and seen so then; without a time nothing was proven of it anyway.
    Stopped(Option<Tick>),
    /// Somebody else has set it going.
    Moves,
    /// It does not say.
    Unknown,
}

/// A drive of which a stop was proven, or that it has no power any more.
struct Proven {
    /// In its word order, so that each look is one question.
    target: Target,
    /// It was seen to stand.
    stands: bool,
    /// The state in which it was left.
    state: Option<String>,
}

impl Proven {
    fn of(came: &Came, target: Target) -> Option<Self> {
        let Ok(Outcome { data: Some(Data::Motion(motion)), failure, .. }) = came else { return None };
        // Without power nothing may tell whether the shaft stands; that it has power again can be seen.
        if failure.as_ref().is_some_and(|failure| failure.code != verdict::STANDSTILL_UNPROVEN) {
            return None;
        }
        let state = motion.to.as_ref().map(|state| state.slug.clone());
        Some(Proven { target, stands: motion.standing == Some(true), state })
    }

    /// Whether somebody has had it in hand since: it is enabled, its shaft turns, or it is in another state. A quick stop ends by itself.
    async fn is_touched(&mut self, session: &mut Session<'_>) -> Result<Option<Now>, Failure> {
        if self.stands && turns(session, &mut self.target).await? {
            return Ok(Some(Now::Moves));
        }
        let state = state_now(session, &mut self.target).await?;
        let known = self.state.as_deref().filter(|known| *known != QUICK_STOP);
        Ok(match state.as_str() {
            OPERATION => Some(Now::Moves),
            state if known.is_some_and(|known| known != state) => Some(Now::Unknown),
            _ => None,
        })
    }
}

/// The same of what came of it, if that is one.
async fn proven(session: &mut Session<'_>, registry: &Registry, came: &Came) -> Option<Proven> {
    let Ok(Outcome { data: Some(Data::Motion(motion)), .. }) = came else { return None };
    let mut proven = Proven::of(came, Target::new(motion.address, registry.family(&motion.drive)?).greeted())?;
    if session.is_interrupted() {
        return None;
    }
    session.speaks_of(Some(motion.address));
    session.end_at(Some(session.now() + LAST_LOOK));
    // Without an answer the look is told that, too.
    let _ = proven.target.route(session).await;
    Some(proven)
}

/// What a drive does now of which a stop was proven, if this is one.
async fn now_of(session: &mut Session<'_>, act: Relief, place: Option<&Cell<Option<Proven>>>) -> Now {
    let Some((place, mut proven)) = place.and_then(|place| Some((place, place.take()?))) else {
        return Now::Stopped(None);
    };
    session.speaks_of(Some(proven.target.address));
    session.end_at(Some(session.now() + LAST_LOOK));
    let now = match act {
        Relief::Zero => turns(session, &mut proven.target).await.map(|turns| turns.then_some(Now::Moves)),
        _ => proven.is_touched(session).await,
    };
    place.set(Some(proven));
    now.map_or(Now::Unknown, |now| now.unwrap_or(Now::Stopped(Some(session.now()))))
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
    Err(unsent(Failure::new(Class::Usage, "usage.protocol", message)))
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
