//! The modes of operation: what the shaft does while the output stage is on (LXM05 manual 5.4, 5.5).
//!
//! Choices where the manual is silent:
//! - a new mode becomes active 10 ms after it was written, and not before the shaft stands; in "operation enabled" the
//!   shaft is brought to rest for that;
//! - control word: a movement or a homing starts with the rising edge of bit 4 in "operation enabled" only; bit 5 takes
//!   a new target at once, else it waits for the end of the movement before; bit 6 makes a target relative to the last
//!   one (CiA 402, sources G4), unless the bench file turns it round; bit 8 holds the shaft. Homing is broken off when bit 4
//!   falls;
//! - status word: bit 10 in point-to-point, profile velocity, speed control, homing; bit 12 is in point-to-point the
//!   acknowledge of the start bit and in profile velocity "speed 0" (CiA 402), in homing the valid reference point;
//! - homing knows methods 17 and 18 (to the switch, back off it, zero where it lets go) and 35 (zero where the shaft
//!   stands), numbered as CiA 402 does; 17 is the one that the manual prints;
//! - the sources of current, speed and gear (CURreference …), the jog and every movement end when "operation enabled" or
//!   the mode is left; the setpoints stay;
//! - CURreference and SPEEDreference: 2 is the parameter (manual 5.5.1, 5.5.2), 0 is none, and any other number stands for a setpoint
//!   that comes from elsewhere, as the bench file says;
//! - in current control 0.01 A turns the unloaded shaft at 1 1/min, speeding up as the ramps allow;
//! - a gear factor holds from the write of its numerator on; one increment of the guide signal is one user unit; the
//!   signal is there if IOposInterfac is 1, the setting of the worked sequence;
//! - JOGactivate: bit 0 clockwise, bit 1 anticlockwise, bit 2 fast; both directions at once stand still;
//! - all of them follow RAMPacc and RAMPdecel, inside RAMPn_max; the quick stop has a ramp of its own.

use super::axis::{Axis, PARTS, PER_RPM, Ramps, USR_PER_TURN};
use super::machine::Power;
use super::params::{self, Values};
use super::readings::{Reading, Readings};
use crate::tick::{Span, Tick};

/// Until a written mode is active.
const CHANGE: Span = Span::from_millis(10);
/// Ramp of the quick stop, 1/min in a second.
const QUICK_STOP: i64 = 10_000;

/// Bits of the control word beside the state machine (CiA 402).
const START: u16 = 1 << 4;
const AT_ONCE: u16 = 1 << 5;
const RELATIVE: u16 = 1 << 6;
const HALT: u16 = 1 << 8;

/// Modes of operation by their number in DCOMopmode.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mode {
    PointToPoint,
    Velocity,
    Homing,
    Jog,
    Gear,
    Current,
    Speed,
}

impl Mode {
    const TABLE: [(i64, Mode); 7] = [
        (1, Mode::PointToPoint),
        (3, Mode::Velocity),
        (6, Mode::Homing),
        (-1, Mode::Jog),
        (-2, Mode::Gear),
        (-3, Mode::Current),
        (-4, Mode::Speed),
    ];

    pub(crate) fn of(number: i64) -> Option<Mode> {
        Self::TABLE.iter().find(|row| row.0 == number).map(|row| row.1)
    }

    fn number(self) -> i64 {
        Self::TABLE.iter().find(|row| row.1 == self).map_or(0, |row| row.0)
    }
}

/// What stands around the shaft.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct World {
    /// The negative limit switch is pressed below this position; user units from where the shaft stood at the start.
    pub(crate) limn: i64,
    /// The positive limit switch is pressed above it.
    pub(crate) limp: i64,
    /// The switches also stop a shaft that does not look for them.
    pub(crate) limits: bool,
    /// Increments per second at the position interface.
    pub(crate) guide: i64,
    /// What every source of the set speed or current but the parameter asks for, 1/min.
    pub(crate) analog: i64,
    /// A position that is read wavers by so many user units to either side.
    pub(crate) waver: i64,
    /// Bit 6 of the control word set means absolute, as manual 5.4.1 words its example.
    pub(crate) bit6_absolute: bool,
    /// What hangs at the shaft is stronger than the drive: while the output stage is on it does not become slower.
    pub(crate) dragged: bool,
}

/// Where a homing is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Homing {
    /// On the way to the switch.
    Search,
    /// On the way back off it.
    BackOff,
    /// The reference point is found, the shaft comes to rest.
    Found,
}

/// Mode, shaft, and what is under way.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Modes {
    axis: Axis,
    world: World,
    readings: Readings,
    /// The output stage did what the mode says.
    drives: bool,
    mode: Option<Mode>,
    /// Mode that was written, and when it may become active.
    wanted: Option<(Mode, Tick)>,
    /// Position of the shaft where _p_act shows 0, user units.
    zero: i64,
    referenced: bool,
    /// Target of the movement, as _p_act counts.
    target: Option<i64>,
    queued: Option<i64>,
    arrived: bool,
    homing: Option<Homing>,
    /// Numerator and denominator of the gear.
    ratio: (i64, i64),
}

impl Modes {
    pub(crate) fn new(world: World, readings: Readings) -> Self {
        Modes {
            axis: Axis::default(),
            world,
            readings,
            drives: false,
            mode: None,
            wanted: None,
            zero: 0,
            referenced: false,
            target: None,
            queued: None,
            arrived: false,
            homing: None,
            ratio: (1, 1),
        }
    }

    /// Power-on: the shaft stays or coasts where it is, and nobody knows where that is.
    pub(crate) fn power_up(&mut self) {
        *self = Modes { axis: self.axis, zero: self.place(), ..Modes::new(self.world, self.readings) };
    }

    /// Speed of the shaft, 0.001 1/min.
    pub(crate) fn speed(&self) -> i64 {
        self.axis.speed()
    }

    pub(crate) fn stands(&self) -> bool {
        self.axis.speed() == 0
    }

    /// _p_act, user units.
    pub(crate) fn position(&self) -> i64 {
        self.place() - self.zero
    }

    /// How far off a position is read at `now`: a saw that takes a step every 7 ms.
    pub(crate) fn waver(&self, now: Tick) -> i64 {
        let step = i64::try_from(now.as_micros() / 7_000).unwrap_or(0);
        step.rem_euclid(2 * self.world.waver + 1) - self.world.waver
    }

    pub(crate) fn referenced(&self) -> bool {
        self.referenced
    }

    /// _DCOMopmd_act: 0 before the first mode.
    pub(crate) fn mode_number(&self) -> i64 {
        self.mode.map_or(0, Mode::number)
    }

    pub(crate) fn mode(&self) -> Option<Mode> {
        self.mode
    }

    /// When a mode that was written may become active.
    pub(crate) fn next(&self) -> Option<Tick> {
        self.wanted.map(|wanted| wanted.1)
    }

    /// Bits 10 and 12 of the status word.
    pub(crate) fn status(&self, values: &Values, word: u16, power: Power) -> u16 {
        let (reached, special) = match self.mode {
            Some(Mode::PointToPoint) => (self.arrived, word & START != 0 && power == Power::Drives),
            Some(Mode::Velocity) => (self.speed() == self.goal(values, Mode::Velocity), self.stands()),
            Some(Mode::Speed) => (self.speed() == self.goal(values, Mode::Speed), false),
            Some(Mode::Homing) => (self.homing.is_none() && self.stands(), self.referenced),
            _ => (false, false),
        };
        u16::from(reached) << 10 | u16::from(special) << 12
    }

    /// What hangs at the shaft keeps it from becoming slower, or lets it go.
    pub(crate) fn drag(&mut self, on: bool) {
        self.world.dragged = on;
    }

    /// A mode was written.
    pub(crate) fn want(&mut self, now: Tick, mode: Mode) {
        self.wanted = Some((mode, now + CHANGE));
    }

    /// A new control word came in "operation enabled", or led to it.
    pub(crate) fn command(&mut self, values: &Values, word: u16, before: u16) {
        let rising = word & !before;
        match self.mode {
            Some(Mode::PointToPoint) if rising & START != 0 => self.start(values, word),
            Some(Mode::Homing) if rising & START != 0 => self.home(values),
            Some(Mode::Homing) if word & START == 0 => self.homing = None,
            _ => {}
        }
    }

    /// A new gear factor.
    pub(crate) fn take_ratio(&mut self, values: &Values) {
        self.ratio = (values.get(params::GEAR_NUMERATOR), values.get(params::GEAR_DENOMINATOR).max(1));
    }

    /// Whether the shaft has run onto a limit switch that it was not looking for.
    pub(crate) fn off_limits(&self) -> bool {
        let beyond = (self.speed() < 0 && self.on_switch(-1)) || (self.speed() > 0 && self.on_switch(1));
        self.world.limits && self.homing.is_none() && beyond
    }

    /// Lets a millisecond pass that ends `now`.
    pub(crate) fn tick(&mut self, now: Tick, values: &mut Values, word: u16, power: Power) {
        if power != Power::Drives {
            self.end();
            self.release(values, Reading::ReferencesOutliveRun);
        }
        if self.drives && power != Power::Drives && self.readings.has(Reading::SetpointsEndWithRun) {
            forget_setpoints(values);
        }
        self.drives = power == Power::Drives;
        if self.wanted.is_some_and(|wanted| wanted.1 <= now) && self.stands() {
            self.end();
            self.release(values, Reading::ReferencesOutliveMode);
            if self.readings.has(Reading::SetpointsEndWithMode) {
                forget_setpoints(values);
            }
            self.mode = self.wanted.take().map(|wanted| wanted.0);
        }
        let ramps = Ramps { up: values.get(params::ACCELERATION), down: values.get(params::DECELERATION) };
        let held = word & HALT != 0 || self.wanted.is_some();
        let before = self.axis;
        match (power, self.mode) {
            (Power::Off, _) => self.axis.coast(),
            (Power::Ramps, _) => self.axis.accelerate_to(0, ramps),
            (Power::Stops, _) => self.axis.accelerate_to(0, Ramps { up: QUICK_STOP, down: QUICK_STOP }),
            (Power::Drives, Some(mode)) if !held => self.drive(mode, values, ramps),
            (Power::Drives, _) => self.axis.accelerate_to(0, ramps),
        }
        if self.world.dragged && power != Power::Off {
            self.axis.keep_pace(before);
        }
    }

    /// One step of a mode.
    fn drive(&mut self, mode: Mode, values: &Values, ramps: Ramps) {
        match (mode, self.homing, self.target) {
            (Mode::PointToPoint, _, Some(target)) => {
                let top = values.get(params::TARGET_SPEED).min(values.get(params::SPEED_LIMIT));
                let goal = (target + self.zero).saturating_mul(PARTS);
                self.arrived = self.axis.move_to(goal, top * PER_RPM, ramps);
                if let Some(next) = self.queued.filter(|_| self.arrived) {
                    (self.target, self.queued, self.arrived) = (Some(next), None, false);
                }
            }
            (Mode::Homing, Some(homing), _) => self.seek(homing, values, ramps),
            (mode, ..) => self.axis.accelerate_to(self.goal(values, mode), ramps),
        }
    }

    /// The speed that a mode asks for, 0.001 1/min.
    fn goal(&self, values: &Values, mode: Mode) -> i64 {
        let chosen = |source, setpoint| match values.get(source) {
            2 => values.get(setpoint) * PER_RPM,
            0 => 0,
            _ => self.world.analog * PER_RPM,
        };
        let speed = match mode {
            Mode::Velocity => values.get(params::VELOCITY) * PER_RPM,
            Mode::Current => chosen(params::CURRENT_SOURCE, params::CURRENT),
            Mode::Speed => chosen(params::SPEED_SOURCE, params::SPEED),
            Mode::Gear if values.get(params::GEAR_SOURCE) != 0 && values.get(params::POSITION_INTERFACE) == 1 => {
                let (numerator, denominator) = self.ratio;
                let per_minute = i128::from(self.world.guide) * 60 * i128::from(PER_RPM) * i128::from(numerator);
                let speed = per_minute / (i128::from(denominator) * i128::from(USR_PER_TURN));
                i64::try_from(speed).unwrap_or(0)
            }
            Mode::Jog => {
                let jog = values.get(params::JOG);
                let speed = if jog & 4 == 0 { params::JOG_SLOW } else { params::JOG_FAST };
                ((jog & 1) - (jog >> 1 & 1)) * values.get(speed) * PER_RPM
            }
            _ => 0,
        };
        let limit = values.get(params::SPEED_LIMIT) * PER_RPM;
        speed.clamp(-limit, limit)
    }

    /// Takes a target.
    fn start(&mut self, values: &Values, word: u16) {
        let relative = (word & RELATIVE != 0) != self.world.bit6_absolute;
        let before = self.queued.or(self.target).unwrap_or_else(|| self.position());
        let base = if relative { before } else { 0 };
        let target = (base + values.get(params::TARGET)).clamp(i32::MIN.into(), i32::MAX.into());
        if self.target.is_some() && !self.arrived && word & AT_ONCE == 0 {
            self.queued = Some(target);
        } else {
            (self.target, self.queued, self.arrived) = (Some(target), None, false);
        }
    }

    fn home(&mut self, values: &Values) {
        self.referenced = false;
        self.homing = Some(Homing::Search);
        if values.get(params::HOMING_METHOD) == 35 {
            self.zero = self.place();
            (self.homing, self.referenced) = (None, true);
        }
    }

    /// One step of a homing.
    fn seek(&mut self, homing: Homing, values: &Values, ramps: Ramps) {
        let side = if values.get(params::HOMING_METHOD) == 18 { 1 } else { -1 };
        let (speed, next) = match homing {
            Homing::Search if self.on_switch(side) => (0, self.stands().then_some(Some(Homing::BackOff))),
            Homing::Search => (side * values.get(params::HOMING_SPEED), None),
            Homing::BackOff if !self.on_switch(side) => {
                self.zero = self.edge(side);
                self.referenced = true;
                (0, Some(Some(Homing::Found)))
            }
            Homing::BackOff => (-side * values.get(params::HOMING_SPEED_OUT), None),
            Homing::Found => (0, self.stands().then_some(None)),
        };
        self.axis.accelerate_to(speed * PER_RPM, ramps);
        self.homing = next.unwrap_or(Some(homing));
    }

    /// Ends everything that was under way.
    fn end(&mut self) {
        (self.target, self.queued, self.arrived, self.homing) = (None, None, false, None);
    }

    /// Takes back the jog and the sources of current, speed and gear, unless they outlive this.
    fn release(&self, values: &mut Values, outlive: Reading) {
        if self.readings.has(outlive) {
            return;
        }
        for action in [params::JOG, params::CURRENT_SOURCE, params::SPEED_SOURCE, params::GEAR_SOURCE] {
            values.put(action, 0);
        }
    }

    /// Whether the limit switch on this side (-1 or 1) is pressed.
    fn on_switch(&self, side: i64) -> bool {
        if side < 0 { self.place() < self.world.limn } else { self.place() > self.world.limp }
    }

    /// Where the switch on this side lets go.
    fn edge(&self, side: i64) -> i64 {
        if side < 0 { self.world.limn } else { self.world.limp }
    }

    /// Position of the shaft since the bench was built, user units.
    fn place(&self) -> i64 {
        self.axis.position().div_euclid(PARTS)
    }
}

/// Setpoints that stand still at 0.
fn forget_setpoints(values: &mut Values) {
    for setpoint in [params::VELOCITY, params::CURRENT, params::SPEED] {
        values.put(setpoint, 0);
    }
}
