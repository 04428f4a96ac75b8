//! A run by the words of PROFIdrive (SJ2-PB manual 4.1.2) or of the Basic block (3.2): looked at, prepared, started, measured, held. It ends by `ending` alone.

use super::exchange::{Exchange, LOST, RIGHT};
use super::mode::{Seen, Words};
use super::state;
use super::trouble;
use super::words::{FULL, Lead, SMALL, Wanted, part};
use crate::drive::trouble::time_over;
use crate::exchange::dp::{Cycle, Place};
use crate::failure::{Class, Failure};
use crate::outcome::Step;
use crate::tick::{Span, Tick};

/// How far a measured scale may be from what A004 tells, percent: P.611 has steps of 0.01 Hz.
const TOLERANCE: i64 = 4;
/// Cycles with the word that prepares, at least.
const PREPARED: u32 = 3;

/// No ramp is waited for longer: the longest from 0 to A004 is 3000 s (5.5 index 7).
const LONGEST: Span = Span::from_secs(3_000);
/// Who controls (5.3), and the setpoint, 0.01 Hz (5.3).
const WHO: u16 = 600;
const SETPOINT: u16 = 611;
/// P.703: stop by the ramp, and everything that takes motion away: coasting, the ramp, the DC brake (5.2).
pub(super) const STOPS: u16 = 2;
const STOPPING: std::ops::RangeInclusive<u32> = 1..=3;
/// P.600: setpoint and control come from the bus.
const BOTH: u32 = 3;
/// Maximum frequency of the two sets (5.5 index 15, 16), and which of them is chosen (5.3).
const MAXIMA: [u16; 2] = [15, 16];
const SECOND: u16 = 607;
/// What A004 may be, 0.01 Hz (5.5: 30 to 400 Hz), and what its raw unit may be: no source tells.
const HERTZ: std::ops::RangeInclusive<i64> = 3_000..=40_000;
const UNITS: [i64; 3] = [100, 10, 1];

/// What decides on a run, as it stands in the module before it.
#[derive(Clone, Debug)]
pub struct Rights {
    /// P.928, who has control: 1 is the bus. `None` if it was not told.
    pub right: Option<u32>,
    /// P.703, what a lost bus does: 0 keeps the last words, 1 to 3 stop the motor, 4 leaves it to A001 and A002. `None` if it was not told.
    pub lost: Option<u32>,
    /// Maximum frequencies that the raw values of those may mean that 4000h may be, 0.01 Hz; and how they are called.
    pub maxima: Vec<i64>,
    /// A004; in the second set A204 too, because the manual says A004 of both (4.1.2.3).
    pub called: &'static str,
}

/// What is changed for the time of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Lending {
    /// P.928 = 1.
    pub control: bool,
    /// P.703 = 2.
    pub stops: bool,
}

/// How a run is bounded.
#[derive(Clone, Copy, Debug)]
pub struct Bounds {
    /// How long is waited for what a word should do.
    pub wait: Span,
    /// How long it is held; `None` until somebody ends it.
    pub duration: Option<Span>,
    /// The duration begins as the setpoint is reached.
    pub until: bool,
}

impl Rights {
    /// What has to be changed for a run that takes control, or that is to stop where the connection is lost.
    pub fn lending(&self, control: bool, stops: bool) -> Lending {
        Lending { control: control && self.right != Some(1), stops: stops && !self.stops() }
    }

    /// Whether a lost connection takes motion away.
    pub fn stops(&self) -> bool {
        self.lost.is_some_and(|lost| STOPPING.contains(&lost))
    }
}

/// What a run has come to.
#[derive(Clone, Debug, Default)]
pub struct Run {
    /// Words that were sent, and what the slave said to them.
    pub steps: Vec<Step>,
    /// 4000h in 0.01 Hz, as it was measured.
    pub maximum: Option<i64>,
    /// Setpoints that were sent.
    pub setpoints: u64,
    /// Whether the setpoint was reached; `None` before it was sent.
    pub reached: Option<bool>,
    /// It was held, so that ending it by a key is its normal end.
    pub held: bool,
    /// Where the setpoint was led to last, of the unit of the run.
    pub given: Option<i64>,
    /// Frequency that was seen last before the end, of 4000h.
    pub actual: Option<i32>,
}

impl Exchange<'_, '_> {
    /// What decides on a run.
    pub async fn rights(&mut self) -> Result<Rights, Failure> {
        let second = self.told(SECOND).await? == Some(1);
        let [main, other] = MAXIMA;
        let (indexes, called) = if second { (&[other, main][..], "A204, A004") } else { (&[main][..], "A004") };
        let mut maxima = Vec::new();
        for index in indexes {
            let raw = self.told(*index).await?.map_or(0, |raw| i64::from(raw & 0xFFFF));
            let all = UNITS.iter().map(|unit| raw * unit).filter(|maximum| HERTZ.contains(maximum));
            let new: Vec<i64> = all.filter(|maximum| !maxima.contains(maximum)).collect();
            maxima.extend(new);
        }
        Ok(Rights { right: self.told(RIGHT).await?, lost: self.told(LOST).await?, maxima, called })
    }

    /// A value, if it is told.
    async fn told(&mut self, index: u16) -> Result<Option<u32>, Failure> {
        Ok(self.read(Place { pnu: index, element: None }).await?.ok())
    }

    /// Starts the motor and holds it there until the duration is over, or until somebody interrupts, which is an error.
    pub async fn run(
        &mut self,
        lead: Lead<'_>,
        (rights, lending): (&Rights, Lending),
        bounds: Bounds,
        run: &mut Run,
    ) -> Result<(), Failure> {
        let done = self.walks(lead, (rights, lending), bounds, run).await;
        self.own_end = done.is_ok();
        done.map_err(|failure| if failure.class == Class::Interrupted { trouble::ended() } else { failure })
    }

    async fn walks(
        &mut self,
        mut lead: Lead<'_>,
        (rights, lending): (&Rights, Lending),
        Bounds { wait, duration, until }: Bounds,
        run: &mut Run,
    ) -> Result<(), Failure> {
        let (value, is_hertz) = (lead.furthest, matches!(lead.first, Wanted::Hertz(_)));
        let most = match (self.mode().is_basic(), is_hertz) {
            (true, true) => *HERTZ.end(),
            (true, false) => return Err(trouble::no_maximum(self.address())),
            (false, true) => rights.maxima.iter().copied().max().unwrap_or_default(),
            (false, false) => 10_000,
        };
        if value.abs() > most {
            return Err(trouble::beyond(self.address(), most, is_hertz, rights.called));
        }
        if lending.stops {
            self.lend(LOST, STOPS).await?;
        }
        if lending.control {
            self.lend(RIGHT, 1).await?;
        }
        self.prepare(wait, run).await?;
        let word = self.mode().start(value);
        self.lasts = duration.filter(|_| !until).map(|duration| duration + lead.takes);
        let maximum = match (self.mode().is_basic(), is_hertz) {
            // A word is 0.01 Hz there, and so 4000h is 163.84 Hz.
            (true, _) => *run.maximum.insert(FULL),
            (false, true) => self.measured(word, (value, rights), wait, run).await?,
            (false, false) => 10_000,
        };
        if !self.mode().is_basic() && value.abs() > maximum {
            return Err(trouble::beyond(self.address(), maximum, is_hertz, rights.called));
        }
        self.is_scaled(maximum);
        let first = lead.first.value();
        run.given = Some(first);
        let hsw = self.hsw(first, maximum);
        self.start(Words { stw: word, hsw }, wait, run).await?;
        self.turns(hsw, wait, run).await?;
        self.lasts = None;
        self.leads(&mut lead, (maximum, wait), run).await?;
        if until {
            self.reaches(self.words.hsw, wait, run).await?;
            self.ends = duration.map(|duration| self.line.now() + duration);
        }
        self.holds(&mut lead, maximum, run).await
    }

    /// Looks at the motor under the stop word.
    pub(super) async fn meets(&mut self) -> Result<(), Failure> {
        for _ in 0..PREPARED {
            self.look().await?;
        }
        Ok(())
    }

    /// Stops the motor from now on, as soon as data are exchanged: OFF1, or OFF3. [`Exchange::leave`] proves it.
    pub async fn stops(&mut self, coasts: bool) -> Result<(), Failure> {
        self.ours = true;
        self.insists();
        if coasts {
            self.coasts();
        }
        self.look().await.map(|_| ())
    }

    /// The end of what was started will be OFF3.
    pub fn coasts(&mut self) {
        if self.ours {
            self.take_power();
        }
    }

    /// Acknowledges a fault: no start bit first, then the edge of bit 7, with control kept.
    pub async fn reset(&mut self, wait: Span, run: &mut Run) -> Result<(), Failure> {
        self.words = self.mode().prepare();
        self.meets().await?;
        let mut seen = self.look().await?;
        if !seen.is_faulted() {
            return Err(trouble::no_fault(self.address()));
        }
        let begun = self.line.now();
        self.words = self.mode().acknowledge();
        while seen.is_faulted() {
            if self.line.now().since(begun) > wait {
                return Err(trouble::still_faulted(self.address()));
            }
            seen = self.look().await?;
        }
        run.steps.push(step("acknowledge", self.words, seen, self.line.now().since(begun)));
        self.words = self.mode().prepare();
        self.look().await.map(|_| ())
    }

    /// 0406 or 0050: ready, without a start, so that the start bit has an edge behind it. A motor that turned before comes down by its
    /// ramp meanwhile: that is waited for as long as it falls.
    async fn prepare(&mut self, wait: Span, run: &mut Run) -> Result<(), Failure> {
        let begun = self.line.now();
        self.words = self.mode().prepare();
        let (mut cycles, mut lowest) = (0, (i32::MAX, begun));
        loop {
            let seen = self.look().await?;
            let now = self.line.now();
            cycles += 1;
            if seen.hiw.abs() < lowest.0 {
                lowest = (seen.hiw.abs(), now);
            }
            if seen.is_faulted() {
                return Err(trouble::faulted(self.address()));
            }
            if cycles > PREPARED && seen.is_ready() && self.still.is_dark(self.line.now()) {
                run.steps.push(step(self.called("OFF1", "stop"), self.words, seen, self.line.now().since(begun)));
                return Ok(());
            }
            if now.since(lowest.1) > wait || now.since(begun) > LONGEST {
                return Err(trouble::not_ready(self.address(), seen, self.still.is_dark(self.line.now())));
            }
        }
    }

    /// Gives a start word, and waits until it is obeyed.
    async fn start(&mut self, words: Words, wait: Span, run: &mut Run) -> Result<(), Failure> {
        let begun = self.line.now();
        let starts = !self.ours;
        // From here on the motor may turn, whatever becomes of it.
        (self.ours, self.started) = (true, true);
        self.words = words;
        if self.ends.is_none() {
            self.turns_from(begun);
        }
        run.setpoints += 1;
        run.reached = Some(false);
        loop {
            self.demand_time()?;
            let seen = self.obeying().await?;
            if seen.has_started() {
                if starts {
                    run.steps.push(step(self.called("ON1", "run"), words, seen, self.line.now().since(begun)));
                }
                return Ok(());
            }
            if self.line.now().since(begun) > wait {
                return Err(trouble::not_started(self.address(), seen));
            }
        }
    }

    /// 4000h in 0.01 Hz, measured at a small setpoint: no source tells the raw unit of A004, and every setpoint rests on it.
    async fn measured(
        &mut self,
        word: u16,
        (value, Rights { maxima, called, .. }): (i64, &Rights),
        wait: Span,
        run: &mut Run,
    ) -> Result<i64, Failure> {
        let most = maxima.iter().copied().max().unwrap_or_default();
        // Whatever the scale is, no more than what was asked for.
        let hsw = SMALL.min(part(value, most));
        if hsw == 0 {
            return Ok(most);
        }
        self.start(Words { stw: word, hsw }, wait, run).await?;
        let begun = self.line.now();
        let told = loop {
            self.demand_time()?;
            self.obeying().await?;
            let told = self.told(SETPOINT).await?.map_or(0, |told| i64::from(told & 0xFFFF));
            if told != 0 || self.line.now().since(begun) > wait {
                break told;
            }
        };
        let is_near = |maximum: &&i64| {
            let expected = i64::from(hsw) * **maximum / FULL;
            (told - expected).abs() <= (expected * TOLERANCE / 100).max(2)
        };
        let found = maxima.iter().find(is_near).copied();
        run.maximum = found;
        found.ok_or_else(|| trouble::scale(self.address(), (hsw, told), (maxima, called)))
    }

    /// The motor may turn from this moment on, so the time of the run begins.
    fn turns_from(&mut self, at: Tick) {
        if let Some(lasts) = self.lasts {
            self.ends = Some(at + lasts);
        }
    }

    /// Fails where the time of the run is over.
    fn demand_time(&self) -> Result<(), Failure> {
        if self.is_over() { Err(time_over().with("address", self.address())) } else { Ok(()) }
    }

    /// A run is proven by who controls, and by the frequency; the bits of the status word say what was commanded.
    pub(super) async fn turns(&mut self, hsw: u16, wait: Span, run: &mut Run) -> Result<(), Failure> {
        if let Some(who) = self.told(WHO).await?.filter(|who| who & BOTH != BOTH) {
            let seen = self.look().await?;
            return Err(trouble::others(self.address(), who, seen));
        }
        let begun = self.line.now();
        loop {
            self.demand_time()?;
            let asked = self.line.now();
            let seen = self.obeying().await?;
            run.actual = Some(seen.hiw);
            if seen.hiw != 0 || hsw == 0 {
                return Ok(());
            }
            self.turns_from(asked);
            if self.line.now().since(begun) > wait {
                return Err(trouble::turns_not(self.address()));
            }
        }
    }

    /// Waits until the frequency is the setpoint: that alone tells, because a bit may still mean the setpoint before. A frequency that
    /// stays somewhere else for so long is no ramp.
    async fn reaches(&mut self, hsw: u16, wait: Span, run: &mut Run) -> Result<(), Failure> {
        let begun = self.line.now();
        let mut moved = (0, begun);
        loop {
            let seen = self.obeying().await?;
            let now = self.line.now();
            run.actual = Some(seen.hiw);
            if self.is_near(seen, hsw) {
                return Ok(());
            }
            if moved.0 != seen.hiw {
                moved = (seen.hiw, now);
            }
            if now.since(moved.1) > wait || now.since(begun) > LONGEST {
                return Err(trouble::not_reached(self.address()));
            }
        }
    }

    pub(super) fn is_near(&self, seen: Seen, hsw: u16) -> bool {
        seen.hiw.unsigned_abs().abs_diff(hsw.into()) <= self.mode().close()
    }

    /// What a word is called in each mode.
    fn called(&self, profidrive: &'static str, basic: &'static str) -> &'static str {
        if self.mode().is_basic() { basic } else { profidrive }
    }

    /// What comes in one cycle. A slave that has left Data_Exchange is not started anew by what stands in its outputs.
    async fn look(&mut self) -> Result<Seen, Failure> {
        loop {
            match self.cycle().await? {
                Cycle::Left => return Err(trouble::left(self.address())),
                Cycle::Inputs(_) => {}
                Cycle::Prepared | Cycle::Released => continue,
            }
            if let Some(seen) = self.seen {
                return Ok(seen);
            }
        }
    }

    /// What comes in one cycle of a motor that was started.
    pub(super) async fn obeying(&mut self) -> Result<Seen, Failure> {
        let seen = self.look().await?;
        if seen.is_faulted() {
            return Err(trouble::tripped(self.address()));
        }
        if !seen.is_by_bus() {
            return Err(trouble::lost_control(self.address(), seen));
        }
        Ok(seen)
    }
}

fn step(command: &str, words: Words, seen: Seen, took: Span) -> Step {
    Step {
        transition: "STW".to_owned(),
        command: Some(command.to_owned()),
        control: Some(format!("0x{:04X}", words.stw)),
        state: state::or_untold(seen),
        took_ms: took.as_millis(),
    }
}
