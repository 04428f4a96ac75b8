//! Looks at all once more behind the last proof, and stops anew who moves or does not say: who was proven early may be set going again while
//! the others are, and while that one is stopped; so may all behind a look that took long.

use super::super::verdict;
use super::in_turns;
use super::ports::Port;
use crate::drive::motion::{LAST_LOOK, Meant, OPERATION, QUICK_STOP, set_going_again, state_now, turns};
use crate::drive::{AccessError, Session, Target};
use crate::failure::{Class, Failure};
use crate::gate::Relief;
use crate::outcome::{Data, Outcome};
use crate::profile::Registry;
use crate::text::{Text, both};
use crate::tick::Span;
use std::cell::Cell;
use std::cmp::Reverse;

/// So often all are looked at once more where one of them was set going again, and so often where all are at rest and something is owed.
const MOST_ROUNDS: u8 = 4;
/// So long, and so often, is waited between rounds until the other ports are at rest as well; and so long for them in all.
const BEAT: Span = Span::from_millis(20);
const BEATS: u8 = 5;
/// A stop may be waited for as long as a shaft becomes slower, 600 s.
const LONGEST_WAIT: Span = Span::from_secs(900);
/// Who took longer for an answer is looked at alone, before the others: behind him they would be unseen for as long.
const SLOW: Span = Span::from_millis(60);

/// What came of one drive.
pub(super) type Came = Result<Outcome, Failure>;

/// What a drive does behind its proof.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Now {
    /// As it was told; nothing was proven of it otherwise.
    Stopped,
    /// Somebody else has set it going.
    Moves,
    /// Somebody else has had it in hand: it is in another state.
    Differs,
    /// It does not say.
    Silent,
}

/// A drive behind its proof.
struct Behind<'a> {
    drive: &'a Meant,
    came: &'a mut Came,
    /// Nothing where nothing of it was proven.
    proven: Cell<Option<Proven>>,
    /// What it did in the last round.
    now: Now,
    /// It was to be stopped anew since it had said nothing.
    was_silent: bool,
    /// In so many rounds since it left a reply owed.
    owed: u8,
    /// It is not asked any more: whenever it is, a reply is owed behind it, for which the line is kept, and nobody seen meanwhile.
    left_out: bool,
}

/// Looks at all of a line until each is at rest, and was seen so a moment ago. How often drives of any port had been stopped anew as the last
/// look at these began.
pub(super) async fn look_behind<'a>(
    session: &mut Session<'a>,
    (registry, act): (&Registry, Relief),
    port: &Port<'_>,
    (drives, came): (&[Meant], &mut [Came]),
    stop: impl AsyncFn(&mut Session<'a>, &Meant) -> Came,
) -> u32 {
    let end = session.now() + LONGEST_WAIT;
    session.hastens();
    // Whoever has interrupted meant the stops that are through by now: what he waits for is that all stand.
    session.note_interrupts();
    let mut each = Vec::new();
    for (drive, came) in drives.iter().zip(came) {
        let proven = Cell::new(proven(session, registry, came).await);
        each.push(Behind { drive, came, proven, now: Now::Stopped, was_silent: false, owed: 0, left_out: false });
    }
    let (mut calm, mut restless, mut cut_off, mut seen) = (0, 0, 0_u8, port.stops());
    while restless < MOST_ROUNDS && cut_off < MOST_ROUNDS {
        if !waits_for_what_is_owed(session, &mut cut_off).await {
            cut_off = MOST_ROUNDS;
            break;
        }
        seen = port.stops();
        port.is_busy();
        let unseen = look_around(session, act, &mut each).await;
        if session.is_interrupted() {
            // Nobody knows whom that has cut off: once more, from the beginning.
            session.note_interrupts();
            cut_off += 1;
            continue;
        }
        if each.iter().any(|one| one.now != Now::Stopped) {
            port.begins_anew();
            stop_again(session, act, &mut each, &stop).await;
            port.counts_a_stop();
            session.note_interrupts();
            let is_early = port.others_are_busy() && session.now() < end;
            (calm, restless) = (0, restless + u8::from(!is_early));
            continue;
        }
        let is_owed = session.owes_for().is_some() && each.iter().any(|one| !one.left_out);
        let is_fresh = calm + 1 >= MOST_ROUNDS || unseen <= usual_round(each.len());
        if is_fresh && (!is_owed || cut_off > 0) {
            port.is_done();
            if session.now() < end && !beat(session, port, seen).await {
                calm = 0;
                continue;
            }
            if is_owed {
                // The line is kept for it, and nobody seen meanwhile.
                cut_off = MOST_ROUNDS;
            }
            break;
        }
        calm += 1;
        for one in each.iter_mut().filter(|one| session.is_owed_by(one.drive.address)) {
            one.owed += 1;
            one.left_out |= calm + 1 >= MOST_ROUNDS && one.owed > 1;
        }
    }
    // Whoever leaves before the others sees nobody while they are stopped.
    let is_through = !port.others_are_busy();
    port.is_done();
    let stopped_last = each.iter().filter(|one| one.now != Now::Stopped).count();
    for one in &mut each {
        // Of those that were stopped together the first to stand was seen as long ago as the last one took.
        let was_seen = match stopped_last {
            0 => is_through,
            1 => is_through && one.now != Now::Stopped,
            _ => false,
        };
        if cut_off >= MOST_ROUNDS {
            one.ends(broken_off());
        } else if !was_seen {
            one.ends(unseen());
        } else if one.left_out {
            one.ends(late());
        }
    }
    seen
}

/// Nobody knows how one ends: with the failure that it has, or with this one; what was proven before tells nothing of the end.
fn ends(came: &mut Came, failure: Failure) {
    let Ok(Outcome { data: Some(Data::Motion(motion)), failure: why, .. }) = came else { return };
    motion.standing = None;
    if let Some(setpoint) = &mut motion.setpoint {
        setpoint.reached = None;
    }
    *why = Some(verdict::warned(why.take().unwrap_or(failure)));
}

/// Drives of other lines were stopped anew since anybody has looked at these.
pub(super) fn were_left(came: &mut [Came]) {
    came.iter_mut().for_each(|came| ends(came, unseen()));
}

impl Behind<'_> {
    fn ends(&mut self, failure: Failure) {
        ends(self.came, failure);
    }

    fn has_failed(&self) -> bool {
        !matches!(self.came, Ok(Outcome { failure: None, .. }))
    }

    /// Takes note of what came of another stop.
    fn is_stopped(&mut self, act: Relief, came: Came) {
        *self.came = came;
        if let Ok(Outcome { data: Some(Data::Motion(motion)), .. }) = self.came
            && self.now == Now::Moves
        {
            motion.notes.push(set_going_again(act));
        }
        let again = self.proven.take().and_then(|proven| Proven::of(self.came, proven.target));
        self.proven.set(again);
        (self.owed, self.left_out) = (0, false);
    }
}

/// A round: who is slow alone, the slowest first, then the others in turns, so that each is seen last as late as all of them allow, for a
/// position takes several looks. Returns for how long one of those was not seen that answered at once.
async fn look_around(session: &mut Session<'_>, act: Relief, each: &mut [Behind<'_>]) -> Span {
    each.iter_mut().for_each(|one| one.now = Now::Stopped);
    let due = each.iter_mut().filter(|one| !one.left_out);
    let (mut slow, prompt): (Vec<_>, Vec<_>) = due.partition(|one| session.slowest_answer(one.drive.address) > SLOW);
    slow.sort_by_key(|one| Reverse(session.slowest_answer(one.drive.address)));
    let mut first = None;
    for one in &mut slow {
        let begun = session.now();
        one.now = now_of(session, act, &one.proven).await;
        if session.now().since(begun) <= SLOW + SLOW {
            // It is not slow now.
            first = first.or(Some(session.now()));
        }
    }
    let whom: Vec<u8> = prompt.iter().map(|one| one.drive.address).collect();
    let look = async |session: &mut Session<'_>, at: usize| match prompt.get(at) {
        Some(one) => (now_of(session, act, &one.proven).await, session.now()),
        None => (Now::Stopped, session.now()),
    };
    let looked = session.side_by_side(&whom, look).await;
    let first = first.or_else(|| looked.iter().map(|(_, seen)| *seen).min());
    for (one, (now, _)) in prompt.into_iter().zip(looked) {
        one.now = match now {
            // Somebody slow says nothing in turns that are short.
            Now::Silent => now_of(session, act, &one.proven).await,
            now => now,
        };
    }
    first.map_or(Span::ZERO, |first| session.now().since(first))
}

/// Stops those anew that were not as they had been told. Who says nothing again, although he was stopped for that, or failed before, is told
/// so.
async fn stop_again<'a>(
    session: &mut Session<'a>,
    act: Relief,
    each: &mut [Behind<'_>],
    stop: &impl AsyncFn(&mut Session<'a>, &Meant) -> Came,
) {
    for one in each.iter_mut().filter(|one| one.now == Now::Silent) {
        if std::mem::replace(&mut one.was_silent, true) || one.has_failed() {
            (one.now, one.proven) = (Now::Stopped, Cell::new(None));
            one.ends(silent_again());
        }
    }
    let whom: Vec<_> = each.iter_mut().filter(|one| one.now != Now::Stopped).collect();
    let drives: Vec<&Meant> = whom.iter().map(|one| one.drive).collect();
    let one = async |session: &mut Session<'a>, at: usize| match drives.get(at) {
        Some(drive) => stop(session, drive).await,
        None => Ok(Outcome::default()),
    };
    let came = in_turns(session, &drives, one, stop).await;
    whom.into_iter().zip(came).for_each(|(one, came)| one.is_stopped(act, came));
}

/// Nobody has looked at this one since somebody was stopped anew.
fn unseen() -> Failure {
    let text = both!(
        "somebody else sets drives of the group going again; since the last of them was stopped nobody has looked at this one",
        "jemand anderes setzt Antriebe der Gruppe wieder in Gang; seit dem Halt des letzten hat diesen niemand angesehen"
    );
    Failure::new(Class::Forbidden, verdict::STANDSTILL_UNPROVEN, text).hint(both!(
        "stop that, and say the stop again; or the enable input, the emergency stop, the mains",
        "das abstellen, und den Halt noch einmal geben; oder Freigabeeingang, Not-Halt, Netz"
    ))
}

/// The line was lost in the last looks, or somebody has interrupted each of them.
fn broken_off() -> Failure {
    let text = both!(
        "the last look at it was broken off, so nobody knows whether it was set going again",
        "der letzte Blick auf ihn wurde abgebrochen, daher weiß niemand, ob er wieder in Gang gesetzt wurde"
    );
    Failure::new(Class::Interrupted, "interrupted", text).hint(go_there())
}

/// Each look at it left a reply owed.
fn late() -> Failure {
    let text = both!(
        "its answers come late again and again, so it was not among those that were looked at last",
        "seine Antworten kommen immer wieder zu spät, daher gehörte er nicht zu denen, die zuletzt angesehen wurden"
    );
    Failure::new(Class::Silence, "silence.stop", text).hint(go_there())
}

/// It was stopped anew since it said nothing, and says nothing again.
fn silent_again() -> Failure {
    let text = both!(
        "it stood behind its stop, and does not answer any more",
        "er stand hinter seinem Halt und antwortet nicht mehr"
    );
    Failure::new(Class::Silence, "silence.stop", text).hint(go_there())
}

fn go_there() -> Text {
    both!(
        "look at the shaft; the enable input, the emergency stop, the mains stop it whatever the line does",
        "nach der Welle sehen; Freigabeeingang, Not-Halt, Netz halten sie an, was immer die Leitung tut"
    )
}

/// Behind a look at so many drives, each was seen as lately as this, unless an answer was late.
fn usual_round(drives: usize) -> Span {
    const EACH: Span = Span::from_millis(40);
    Span::from_micros(EACH.as_micros() * drives as u64).longer(Span::from_millis(200))
}

/// Waits for replies that are still owed: the line is kept for so long anyway. Who interrupts that is in a hurry. Whether the line is still there.
async fn waits_for_what_is_owed(session: &mut Session<'_>, cut_off: &mut u8) -> bool {
    session.end_at(None);
    let left = session.owes_for().filter(|_| *cut_off == 0).unwrap_or(Span::ZERO);
    match session.rest(left).await {
        Err(AccessError::Interrupted) => {
            session.note_interrupts();
            *cut_off += 1;
            true
        }
        rested => rested.is_ok(),
    }
}

/// Leaves the others some time, and tells whether all are at rest at once, and none was stopped anew since these were seen.
async fn beat(session: &mut Session<'_>, port: &Port<'_>, seen: u32) -> bool {
    let are_through = || !port.others_are_busy() && port.stops() == seen;
    for _ in 0..BEATS {
        if are_through() {
            return true;
        }
        session.end_at(None);
        // Without a line the next look ends it.
        let _ = session.rest(BEAT).await;
        tokio::task::yield_now().await;
    }
    are_through()
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
        // Whatever went wrong before, and whether or not the shaft was seen to stand: that it has power again can be seen.
        if failure.is_some() && motion.running != Some(false) {
            return None;
        }
        let state = motion.to.as_ref().map(|state| state.slug.clone());
        Some(Proven { target, stands: motion.standing == Some(true), state })
    }

    /// Whether somebody has had it in hand since: it is enabled, its shaft turns, or it is in another state. A quick stop ends by itself.
    async fn now(&mut self, session: &mut Session<'_>) -> Result<Now, Failure> {
        if self.stands && turns(session, &mut self.target).await? {
            return Ok(Now::Moves);
        }
        let state = state_now(session, &mut self.target).await?;
        let known = self.state.as_deref().filter(|known| *known != QUICK_STOP);
        Ok(match state.as_str() {
            OPERATION => Now::Moves,
            state if known.is_some_and(|known| known != state) => Now::Differs,
            _ => Now::Stopped,
        })
    }
}

/// The same of what came of it, if that is one.
async fn proven(session: &mut Session<'_>, registry: &Registry, came: &Came) -> Option<Proven> {
    let Ok(Outcome { data: Some(Data::Motion(motion)), .. }) = came else { return None };
    let mut proven = Proven::of(came, Target::new(motion.address, registry.family(&motion.asked_as)?).greeted())?;
    session.speaks_of(Some(motion.address));
    session.end_at(Some(session.now() + LAST_LOOK));
    // Without an answer the look is told that, too.
    let _ = proven.target.route(session).await;
    Some(proven)
}

/// What a drive does now of which a stop was proven, if this is one.
async fn now_of(session: &mut Session<'_>, act: Relief, place: &Cell<Option<Proven>>) -> Now {
    let Some(mut proven) = place.take() else { return Now::Stopped };
    session.speaks_of(Some(proven.target.address));
    session.end_at(Some(session.now() + LAST_LOOK));
    let now = match act {
        Relief::Zero => {
            turns(session, &mut proven.target).await.map(|turns| if turns { Now::Moves } else { Now::Stopped })
        }
        _ => proven.now(session).await,
    };
    place.set(Some(proven));
    now.unwrap_or(Now::Silent)
}
