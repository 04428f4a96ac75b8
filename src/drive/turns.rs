//! Several conversations on one line take turns. Each is written as if it had the line to itself; whenever it rests, or waits for
//! an answer in vain, it is the turn of another.
//!
//! Who is silent or slow costs the others little: he gets a question when everybody else had his turn, and no more than half of the
//! time.

use super::interrupt::Interrupt;
use crate::tick::{Span, Tick};
use std::cell::RefCell;
use std::rc::Rc;
use std::task::{Poll, Waker};

/// Who has asked for so long gives way to whoever waits: two or three questions at 19200 Bd, which is one look at a shaft.
const TURN: Span = Span::from_millis(100);
/// Whose turn lasts so long answers slowly: it is more than a turn and its last question take with a drive that answers at once.
const SLOW: Span = Span::from_millis(250);

/// A look at a shaft that proves something: its state before and behind it.
const LOOK: u8 = 3;

/// A place at the line. Whoever leaves it gives it up.
#[derive(Debug)]
pub(super) struct Seat {
    table: Rc<RefCell<Table>>,
    at: usize,
}

#[derive(Debug, Default)]
struct Table {
    places: Vec<Place>,
    /// Whose turn it is.
    holder: Option<usize>,
    /// When it began, and how many answers came in it.
    begun: Tick,
    answers: u8,
    now: Tick,
    /// Who is silent or slow does not get the line again before that, as long as somebody answers at once.
    held_until: Tick,
}

#[derive(Debug, Default)]
struct Place {
    /// From when on he wants the line, if he waits for it.
    wants: Option<Tick>,
    /// He has not answered.
    quiet: bool,
    /// His turns are long ones: his last two, or all that he had.
    slow: bool,
    /// How many of the last ones were long, and whether any was not.
    long: u8,
    prompt: bool,
    /// He had a turn since a slow one had his.
    served: bool,
    gone: bool,
    waker: Option<Waker>,
}

/// So many places at a line.
pub(super) fn seats(count: usize, now: Tick) -> Vec<Seat> {
    let places = (0..count).map(|_| Place { wants: Some(now), ..Place::default() }).collect();
    let table = Table { places, now, ..Table::default() };
    let table = Rc::new(RefCell::new(table));
    table.borrow_mut().call();
    (0..count).map(|at| Seat { table: table.clone(), at }).collect()
}

impl Seat {
    /// Waits for the first turn.
    pub(super) async fn begin(&self) {
        self.called().await;
    }

    /// Gives the turn away and waits for the next one, which is not wanted before `due`; whoever interrupts wants it at once.
    /// It may come earlier, if nobody else wants it: then the rest is to be waited for on the line.
    pub(super) async fn give_way(&self, now: Tick, due: Tick, interrupt: &Interrupt) {
        {
            let mut table = self.table.borrow_mut();
            table.give_way(self.at, now, due);
        }
        tokio::select! {
            biased;
            () = self.called() => return,
            () = interrupt.raised() => {}
        }
        if let Some(place) = self.table.borrow_mut().places.get_mut(self.at) {
            place.wants = Some(Tick::ZERO);
        }
        self.called().await;
    }

    /// Whether the turn is to be given away before another question.
    pub(super) fn is_over(&self, now: Tick) -> bool {
        let table = self.table.borrow();
        !table.is_alone(self.at) && (table.is_quiet(self.at) || table.lasts(now))
    }

    /// Whether the last question brought no answer.
    pub(super) fn is_quiet(&self) -> bool {
        self.table.borrow().is_quiet(self.at)
    }

    /// Whether nobody else is at the line any more.
    pub(super) fn is_alone(&self) -> bool {
        self.table.borrow().is_alone(self.at)
    }

    /// Takes note of an answer, or of none.
    pub(super) fn was_answered(&self, answered: bool) {
        let mut table = self.table.borrow_mut();
        table.answers = table.answers.saturating_add(answered.into());
        if let Some(place) = table.places.get_mut(self.at) {
            place.quiet = !answered;
        }
    }

    async fn called(&self) {
        std::future::poll_fn(|context| {
            let mut table = self.table.borrow_mut();
            if table.holder == Some(self.at) {
                return Poll::Ready(());
            }
            if let Some(place) = table.places.get_mut(self.at) {
                place.waker = Some(context.waker().clone());
            }
            Poll::Pending
        })
        .await;
    }
}

impl Drop for Seat {
    fn drop(&mut self) {
        let mut table = self.table.borrow_mut();
        if let Some(place) = table.places.get_mut(self.at) {
            (place.gone, place.wants) = (true, None);
        }
        if table.holder == Some(self.at) {
            table.holder = None;
            table.call();
        }
    }
}

impl Place {
    /// He had a turn, long or not; whether he is slow. One answer that was lost makes nobody so.
    fn had(&mut self, is_long: bool) -> bool {
        self.prompt |= !is_long;
        self.long = if is_long { self.long.saturating_add(1) } else { 0 };
        self.slow = is_long && (self.long > 1 || !self.prompt);
        self.slow
    }
}

impl Table {
    fn is_alone(&self, at: usize) -> bool {
        self.places.iter().enumerate().all(|(other, place)| place.gone || other == at)
    }

    /// Whether the present turn was long enough. What was owed to somebody else is waited for in it, so it holds a look all the same.
    fn lasts(&self, now: Tick) -> bool {
        let since = now.since(self.begun);
        since > SLOW || (since > TURN && self.answers >= LOOK)
    }

    fn is_quiet(&self, at: usize) -> bool {
        self.places.get(at).is_some_and(|place| place.quiet)
    }

    fn give_way(&mut self, at: usize, now: Tick, due: Tick) {
        let took = now.since(self.begun);
        let is_long = self.is_quiet(at) || took >= SLOW;
        let lost_one = self.is_quiet(at) && self.answers > 0;
        let slow = self.places.get_mut(at).is_some_and(|place| {
            place.prompt |= lost_one;
            place.had(is_long)
        });
        self.now = now;
        if slow {
            self.held_until = now + took;
            self.places.iter_mut().for_each(|place| place.served = false);
        }
        if let Some(place) = self.places.get_mut(at) {
            (place.wants, place.served) = (Some(due), !slow);
        }
        self.holder = None;
        self.call();
    }

    /// Calls who is next.
    fn call(&mut self) {
        let Some(next) = self.next() else { return };
        (self.holder, self.begun, self.answers) = (Some(next), self.now, 0);
        let place = self.places.get_mut(next);
        if let Some(place) = place {
            place.wants = None;
            place.waker.take().into_iter().for_each(Waker::wake);
        }
    }

    /// Who answers at once and has waited longest, then who is slow; if nobody wants it yet, who does first.
    fn next(&self) -> Option<usize> {
        let first = |is: &dyn Fn(&Place) -> bool| {
            let waiting = self.places.iter().enumerate().filter(|(_, place)| is(place));
            let waiting = waiting.filter_map(|(at, place)| Some((place.wants?, at)));
            waiting.min().map(|(_, at)| at)
        };
        let is_due = |place: &Place| place.wants.is_some_and(|wants| wants <= self.now);
        let is_held_back = self.now < self.held_until;
        first(&|place| is_due(place) && !place.slow && !place.served)
            .or_else(|| first(&|place| is_due(place) && place.slow && !is_held_back))
            .or_else(|| first(&|place| is_due(place) && !place.slow))
            .or_else(|| first(&|place| !place.slow && place.wants.is_some_and(|wants| wants < self.held_until)))
            .or_else(|| first(&|_| true))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use futures_util::future::join_all;
    use std::cell::Cell;

    fn at(ms: u64) -> Tick {
        Tick::ZERO + Span::from_millis(ms)
    }

    /// Who is called when these wait, each from when on and whether slow, and the present one gives way.
    fn called(places: &[(u64, bool)], now: u64, held_until: u64) -> Option<usize> {
        let place = |&(wants, slow): &(u64, bool)| Place { wants: Some(at(wants)), slow, ..Place::default() };
        let places = places.iter().map(place).collect();
        Table { places, now: at(now), held_until: at(held_until), ..Table::default() }.next()
    }

    #[test]
    fn who_answers_comes_before_who_is_silent_and_who_waited_before_who_came() {
        for (places, held_until, next) in [
            (&[(5, false), (3, false)][..], 0, Some(1)),
            (&[(3, true), (5, false)], 0, Some(1)),
            (&[(3, true), (50, false)], 0, Some(0)),
            // He had half of the time.
            (&[(3, true), (50, false)], 60, Some(1)),
            (&[(3, true), (50, false)], 40, Some(0)),
            (&[(3, true), (4, true)], 60, Some(0)),
            (&[(50, false), (40, true)], 0, Some(1)),
            // At the moment from which on he wants it, and no sooner.
            (&[(3, true), (10, false)], 0, Some(1)),
            (&[(3, true), (60, false)], 60, Some(0)),
            (&[], 0, None),
        ] {
            assert_eq!(called(places, 10, held_until), next, "{places:?} {held_until}");
        }
    }

    #[test]
    fn a_silent_one_waits_until_everybody_had_his_turn_and_no_longer() {
        let place = |slow, served| Place { wants: Some(at(1)), slow, served, ..Place::default() };
        let next = |places| Table { places, now: at(10), held_until: at(10), ..Table::default() }.next();
        assert_eq!(next(vec![place(true, false), place(false, true), place(false, false)]), Some(2));
        assert_eq!(next(vec![place(false, true), place(true, false), place(false, true)]), Some(1));
    }

    #[test]
    fn a_turn_is_over_when_nothing_was_answered_or_it_lasts_and_somebody_waits() {
        let seats = seats(2, at(0));
        let [first, second] = &seats[..] else { unreachable!() };
        (0..LOOK).for_each(|_| first.was_answered(true));
        assert!(!first.is_over(at(100)) && first.is_over(at(101)) && !first.is_alone());
        first.was_answered(false);
        assert!(first.is_over(at(0)) && first.is_quiet() && !second.is_quiet());
        first.table.borrow_mut().give_way(0, at(50), at(50));
        assert_eq!(first.table.borrow().holder, Some(1));
        assert!(!second.is_over(at(300)) && second.is_over(at(301)), "it began at 50, and is no whole look yet");
        (0..LOOK).for_each(|_| second.was_answered(true));
        assert!(!second.is_over(at(150)) && second.is_over(at(151)), "now it is");
    }

    #[test]
    fn one_answer_that_was_lost_makes_nobody_slow_who_answers_at_once() {
        let had = |turns: &[bool]| {
            let mut place = Place::default();
            turns.iter().map(|&is_long| place.had(is_long)).collect::<Vec<_>>()
        };
        assert_eq!(had(&[true, true]), [true, true]);
        assert_eq!(had(&[false, true, false, true, true, false]), [false, false, false, false, true, false]);
    }

    #[test]
    fn who_answers_slowly_has_no_more_than_half_of_the_time_either() {
        let seats = seats(2, at(0));
        let table = seats[0].table.clone();
        seats[0].was_answered(true);
        table.borrow_mut().give_way(0, at(450), at(450));
        assert_eq!((table.borrow().holder, table.borrow().held_until), (Some(1), at(900)));
        table.borrow_mut().give_way(1, at(470), at(520));
        assert_eq!(table.borrow().holder, Some(1), "it rests, and the line waits for it");
    }

    #[test]
    fn who_leaves_gives_it_to_the_next_and_the_last_has_it_to_himself() {
        let mut seats = seats(3, at(0));
        let table = seats[0].table.clone();
        drop(seats.remove(0));
        assert_eq!(table.borrow().holder, Some(1));
        drop(seats.remove(1));
        assert_eq!(table.borrow().holder, Some(1), "it was not the turn of who left");
        assert!(seats[0].is_alone() && !seats[0].is_over(at(1_000)));
    }

    /// Whose turn it was, where these work side by side for so long: each asks once in a turn of 10 ms, and answers or not.
    fn turns(answers: [bool; 3], ms: u64) -> Vec<usize> {
        let (log, now) = (RefCell::new(Vec::new()), Cell::new(at(0)));
        let works = seats(3, at(0)).into_iter().zip(answers).enumerate().map(async |(place, (seat, answers))| {
            seat.begin().await;
            while now.get() < at(ms) {
                log.borrow_mut().push(place);
                now.set(now.get() + Span::from_millis(10));
                seat.was_answered(answers);
                seat.give_way(now.get(), now.get(), &Interrupt::default()).await;
            }
        });
        // Whoever is called first was not the first to wait.
        tokio::runtime::Builder::new_current_thread().build().unwrap().block_on(join_all(works.rev()));
        log.into_inner()
    }

    #[test]
    fn everybody_has_his_turn_and_who_is_silent_when_all_others_had_theirs() {
        assert_eq!(turns([true; 3], 60), [0, 1, 2, 0, 1, 2]);
        assert_eq!(turns([true, false, true], 90), [0, 1, 2, 0, 1, 2, 0, 1, 2]);
        assert_eq!(turns([false; 3], 60), [0, 1, 2, 0, 1, 2]);
    }
}
