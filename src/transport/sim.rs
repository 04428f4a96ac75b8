//! The built-in bench as a link, in virtual time: waiting costs nothing and every run is the same.
//!
//! A verb that watches or holds has the bench paced: its time is still virtual, so that a run tells the same times
//! whatever the machine does, but waiting takes as long as it would on a line.

use super::{LinkError, Wake};
use crate::protocol::line::LineSetting;
use crate::simulator::{Bench, Can, Profibus, Served};
use crate::tick::{Span, Tick};
use std::time::{Duration, Instant};

#[derive(Debug)]
pub(super) struct SimLink {
    bus: Bus,
    line: LineSetting,
    now: Tick,
    pace: Option<Pace>,
    /// Its adapter is out, for a test.
    is_pulled: bool,
    /// The connection was ended by the other side.
    hung_up: bool,
}

/// What stands behind it.
#[derive(Debug)]
enum Bus {
    Bench(Box<Bench>),
    Profibus(Box<Profibus>),
    Can(Box<Can>),
}

impl Bus {
    fn served(&mut self) -> &mut dyn Served {
        match self {
            Bus::Bench(bench) => &mut **bench,
            Bus::Profibus(line) => &mut **line,
            Bus::Can(bus) => &mut **bus,
        }
    }
}

/// A moment of the bench, and the same one by the wall clock.
#[derive(Clone, Copy, Debug)]
struct Pace {
    tick: Tick,
    wall: Instant,
}

/// The bench may be so much ahead of the wall clock: a sleep for every character would only cost.
const AHEAD: Duration = Duration::from_millis(2);

/// A telegram that was not taken for so long is given up.
const STUCK: Span = Span::from_millis(500);

impl SimLink {
    pub(super) fn new(bench: Bench, line: LineSetting) -> Self {
        let (mut bench, now) = witness::standing().unwrap_or((bench, Tick::ZERO));
        bench.listens(line);
        SimLink::of(Bus::Bench(Box::new(bench)), line, now)
    }

    pub(super) fn profibus(bus: Profibus, line: LineSetting) -> Self {
        SimLink::of(Bus::Profibus(Box::new(bus)), line, Tick::ZERO)
    }

    pub(super) fn can(bus: Can, line: LineSetting) -> Self {
        SimLink::of(Bus::Can(Box::new(bus)), line, Tick::ZERO)
    }

    fn of(bus: Bus, line: LineSetting, now: Tick) -> Self {
        SimLink { bus, line, now, pace: None, is_pulled: false, hung_up: false }
    }

    pub(super) fn now(&self) -> Tick {
        self.now
    }

    /// Connects anew, to a bench that goes on as it does.
    pub(super) fn reopen(&mut self) {
        self.hung_up = false;
    }

    /// An error once the other side has ended the connection.
    fn is_connected(&mut self) -> Result<(), LinkError> {
        self.hung_up |= self.bus.served().hangs_up().is_some();
        if self.hung_up { Err(LinkError::Lost("sim".to_owned())) } else { Ok(()) }
    }

    pub(super) fn bench(&mut self) -> Option<&mut Bench> {
        match &mut self.bus {
            Bus::Bench(bench) => Some(&mut **bench),
            Bus::Profibus(_) | Bus::Can(_) => None,
        }
    }

    #[expect(clippy::disallowed_methods, reason = "a paced bench follows the real clock")]
    pub(super) fn pace(&mut self) {
        if witness::is_called() {
            return;
        }
        self.pace = Some(Pace { tick: self.now, wall: Instant::now() });
    }

    pub(super) fn is_paced(&self) -> bool {
        self.pace.is_some() || witness::lets_time_pass()
    }

    /// The setting of what is sent and heard from now on.
    pub(super) fn set_line(&mut self, line: LineSetting) {
        self.bus.served().listens(line);
        self.line = line;
    }

    pub(super) fn send(&mut self, bytes: &[u8]) -> Result<(), LinkError> {
        witness::holds_adapter(true, &mut self.is_pulled)?;
        self.is_connected()?;
        let (free, gives_up) = (self.bus.served().stuck_until(), self.now + STUCK);
        self.now = self.now.max(free.min(gives_up));
        if free > gives_up {
            return Err(LinkError::Stuck("sim".to_owned()));
        }
        self.bus.served().master_sends(self.now, self.line, bytes);
        Ok(())
    }

    /// Goes from event to event of the bench until a drive has put bytes on the wire or the time is over. May be
    /// dropped at any time: the bench stands at the last event that was waited for.
    pub(super) async fn wait(&mut self, until: Tick) -> Result<Wake, LinkError> {
        witness::holds_adapter(false, &mut self.is_pulled)?;
        self.is_connected()?;
        loop {
            let next = self.bus.served().next_event().map_or(until, |event| event.min(until)).max(self.now);
            if let Some(pace) = self.pace {
                pace.reach(next).await;
            }
            let bytes: Vec<u8> = self.bus.served().advance(next).into_iter().map(|(_, byte)| byte).collect();
            let is_still_there = |event: Tick| event <= next;
            let stuck = next == self.now
                && next < until
                && bytes.is_empty()
                && self.bus.served().next_event().is_some_and(is_still_there);
            self.now = next;
            if !bytes.is_empty() {
                return Ok(Wake::Bytes(bytes));
            }
            self.is_connected()?;
            if stuck {
                // An event that does not go away by advancing must not hang the program.
                self.now = until;
                self.bus.served().advance(until);
            }
            if self.now >= until {
                return Ok(Wake::Silence);
            }
        }
    }
}

impl Drop for SimLink {
    fn drop(&mut self) {
        match &self.bus {
            Bus::Bench(bench) => witness::take(bench, self.now),
            Bus::Profibus(line) => witness::take_profibus(line),
            Bus::Can(bus) => witness::take_can(bus),
        }
    }
}

/// For tests that ask the bench itself what a verb left behind: whoever calls a witness on a thread gets the bench of the
/// last line that was closed there, and no bench is paced.
pub mod witness {
    use super::LinkError;
    use crate::simulator::{Bench, Can, Profibus};
    use crate::tick::Tick;
    use std::cell::{Cell, RefCell};

    thread_local! {
        static CALLED: Cell<bool> = const { Cell::new(false) };
        static ADAPTER: Cell<Option<u64>> = const { Cell::new(None) };
        static ALONE: Cell<bool> = const { Cell::new(false) };
        static PASSES: Cell<bool> = const { Cell::new(false) };
        static LEFT: RefCell<Vec<(Bench, Tick)>> = const { RefCell::new(Vec::new()) };
        static CAN: RefCell<Option<Can>> = const { RefCell::new(None) };
        static PROFIBUS: RefCell<Option<Profibus>> = const { RefCell::new(None) };
        static STANDS: RefCell<Option<(Bench, Tick)>> = const { RefCell::new(None) };
    }

    /// Calls the witness on this thread, or sends him home. While he is there no bench follows the wall clock.
    pub fn call(attends: bool) {
        CALLED.set(attends);
        LEFT.take();
        CAN.take();
    }

    /// Time of a bench passes at a question, as it does on a line: whoever answers looks at the telegrams to know when.
    pub fn time_passes(at_questions: bool) {
        PASSES.set(at_questions);
    }

    pub(super) fn lets_time_pass() -> bool {
        PASSES.get()
    }

    /// Pulls the adapter once so many telegrams have gone out on this thread; `None` leaves it in.
    pub fn pull_after(telegrams: Option<u64>) {
        ADAPTER.set(telegrams);
        ALONE.set(false);
    }

    /// The same for the adapter that sends the last of them; others on this thread stay in.
    pub fn pull_one_after(telegrams: u64) {
        ADAPTER.set(Some(telegrams));
        ALONE.set(true);
    }

    /// An error if the adapter is pulled; counts what goes out.
    pub(super) fn holds_adapter(sends: bool, is_pulled: &mut bool) -> Result<(), LinkError> {
        if *is_pulled {
            return Err(LinkError::Lost("sim".to_owned()));
        }
        match ADAPTER.get() {
            Some(0) => {
                if ALONE.get() {
                    *is_pulled = true;
                    ADAPTER.set(None);
                }
                Err(LinkError::Lost("sim".to_owned()))
            }
            Some(left) => {
                ADAPTER.set(Some(left - u64::from(sends)));
                Ok(())
            }
            None => Ok(()),
        }
    }

    /// The bench that was left behind last, and when.
    pub fn left() -> Option<(Bench, Tick)> {
        LEFT.take().pop()
    }

    /// Every bench that was left behind since the witness was called, in the order of leaving.
    pub fn all_left() -> Vec<(Bench, Tick)> {
        LEFT.take()
    }

    /// The next line that is opened on this thread finds this bench, at this time, whatever its port names: a verb that comes
    /// behind another one.
    pub fn stands(bench: Bench, at: Tick) {
        STANDS.set(Some((bench, at)));
    }

    pub(super) fn standing() -> Option<(Bench, Tick)> {
        STANDS.take()
    }

    pub(super) fn is_called() -> bool {
        CALLED.get()
    }

    /// The PROFIBUS line that was left behind last.
    pub fn left_profibus() -> Option<Profibus> {
        PROFIBUS.take()
    }

    /// The CAN bus that was left behind last.
    pub fn left_can() -> Option<Can> {
        CAN.take()
    }

    /// Looks at it, and leaves it there.
    pub fn look_at_can<T>(look: impl FnOnce(&Can) -> T) -> Option<T> {
        CAN.with_borrow(|bus| bus.as_ref().map(look))
    }

    pub(super) fn take_can(bus: &Can) {
        if is_called() {
            CAN.set(Some(bus.clone()));
        }
    }

    pub(super) fn take_profibus(line: &Profibus) {
        if is_called() {
            PROFIBUS.set(Some(line.clone()));
        }
    }

    pub(super) fn take(bench: &Bench, now: Tick) {
        if is_called() {
            LEFT.with_borrow_mut(|left| left.push((bench.clone(), now)));
        }
    }
}

impl Pace {
    /// Sleeps until the wall clock has come to a moment of the bench, or nearly.
    #[expect(clippy::disallowed_methods, reason = "a paced bench follows the real clock")]
    async fn reach(self, tick: Tick) {
        let due = Duration::from(tick.since(self.tick)).saturating_sub(self.wall.elapsed());
        if due > AHEAD {
            tokio::time::sleep(due).await;
        }
    }
}
