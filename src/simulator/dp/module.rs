//! An SJ2-PB: what it makes of its configuration and of the words that are exchanged (manual 3, 4).

use super::channel::Channel;
use super::inverter::{Inverter, Kind, Order, Trip};
use super::readings::{Reading, Readings};
use super::words::{CONTROL, Machine, Seen, TERMINALS_SETPOINT, TERMINALS_START};
use crate::protocol::dp::cfg::Layout;
use crate::protocol::dp::module::{Content, Module as Said, Series};
use crate::protocol::dp::pkw::{self, Pkw};
use crate::tick::{Span, Tick};

/// Why a connection ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum End {
    /// The watchdog.
    Watchdog,
    /// The master lets go.
    Unlock,
    /// Global_Control: outputs to zero.
    Clear,
}

/// Who has the motor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Hand {
    /// A001 and A002.
    Local,
    /// The words of the master.
    Words,
    /// Nobody: the bus was lost, and this was done about it.
    Lost,
}

#[derive(Clone, Debug)]
pub(crate) struct Module {
    pub(crate) inverter: Inverter,
    pub(crate) readings: Readings,
    pub(crate) address: u8,
    pub(crate) layout: Option<Layout>,
    hand: Hand,
    pub(crate) machine: Machine,
    channel: Channel,
    /// Words of the Basic block as they came last.
    basic: [u16; 4],
    /// P.915 and P.916.
    pub(crate) written: [u16; 8],
    pub(crate) read: [u16; 8],
    /// PZD3 to PZD10 as they came last.
    words: [u16; 8],
    pub(crate) read_out: Trip,
}

/// Gateway parameters of which the module makes something (5.1 to 5.3).
pub(crate) const BUS_LOST_BASIC: u32 = 620;
pub(crate) const BUS_LOST: u32 = 703;
pub(crate) const LOCK: u32 = 927;
pub(crate) const RIGHT: u32 = 928;
/// What a parameter of the inverter takes by PKW: longer than one of the module (4.1.1; how long is in no source).
const PKW_DELAY: Span = Span::from_millis(30);
/// The first index that is the module's own.
const GATEWAY: u16 = 600;

/// Bits of the Basic control word (3.2.2).
const RUN_FWD: u16 = 1;
const RUN_REV: u16 = 1 << 1;
const NET_CTRL: u16 = 1 << 4;
const INV_REF: u16 = 1 << 5;
const NET_REF: u16 = 1 << 6;
const RESET: u16 = 1 << 7;
const CONN_STA: u16 = 1 << 14;

impl Module {
    pub(crate) fn new(address: u8, inverter: Inverter, readings: Readings) -> Self {
        let mut module = Module {
            inverter,
            readings,
            address,
            layout: None,
            hand: Hand::Local,
            machine: Machine::default(),
            channel: Channel::default(),
            basic: [0; 4],
            written: [0; 8],
            read: [0; 8],
            words: [0; 8],
            read_out: Trip::default(),
        };
        // No factory setting is printed: the worst, which keeps the motor running; and PKW may be used.
        for (index, raw) in [(BUS_LOST, 0), (BUS_LOST_BASIC, 1), (LOCK, 1), (RIGHT, 0)] {
            module.inverter.store(index, raw);
        }
        module
    }

    /// Takes a configuration with the user parameters of Set_Prm; `None` if it fits neither mode nor series.
    pub(crate) fn configure(&mut self, cfg: &[u8], user: &[u8]) -> Option<Layout> {
        let layout = Layout::of("", cfg)?;
        if layout == Layout::Basic {
            let length = if self.inverter.kind == Kind::X200 { 2 } else { 3 };
            let own = user.split_at_checked(user.len().checked_sub(length)?)?.1;
            let said = Said::decode(own).ok().filter(|said| said.content == Content::Basic)?;
            let series = match self.inverter.kind {
                Kind::Sj200 => Series::Sj200,
                Kind::L200 => Series::L200,
                Kind::X200 => Series::X200,
            };
            (said.series == series).then_some(())?;
        }
        self.layout = Some(layout);
        self.channel = Channel::default();
        Some(layout)
    }

    /// Whether P.928 gives the words the right to control.
    fn has_right(&self) -> bool {
        self.inverter.stored(RIGHT) == 1
    }

    /// One cycle: outputs in, inputs out.
    pub(crate) fn exchange(&mut self, now: Tick, outputs: &[u8]) -> Vec<u8> {
        let Some(layout) = self.layout else { return Vec::new() };
        let (pkw, words) = outputs.split_at(if layout.has_pkw() { pkw::LENGTH } else { 0 });
        let words: Vec<u16> = words.as_chunks().0.iter().map(|pair| u16::from_be_bytes(*pair)).collect();
        self.hand = Hand::Words;
        let mut inputs = match pkw.try_into() {
            Ok(bytes) => self.pkw(now, Pkw::decode(bytes)).encode().to_vec(),
            Err(_) => Vec::new(),
        };
        if layout == Layout::Basic {
            self.take_basic(now, &words);
            inputs.extend(self.tell_basic(now).iter().flat_map(|word| word.to_be_bytes()));
        } else {
            self.take_words(now, &words);
            inputs.extend(self.tell_words(now, words.len()).iter().flat_map(|word| word.to_be_bytes()));
        }
        inputs
    }

    /// The outputs become zero (Global_Control, Clear).
    pub(crate) fn clear(&mut self, now: Tick) {
        match self.layout {
            Some(Layout::Basic) => self.take_basic(now, &[0; 4]),
            Some(layout) => {
                let count = (layout.length() - if layout.has_pkw() { pkw::LENGTH } else { 0 }) / 2;
                self.take_words(now, &vec![0; count]);
            }
            None => {}
        }
    }

    /// The connection ends so.
    pub(crate) fn ends(&mut self, now: Tick, end: End) {
        let is_loss = match end {
            End::Watchdog => true,
            End::Unlock => !self.readings.has(Reading::UnlockIsNoLoss),
            End::Clear => self.readings.has(Reading::ClearIsLoss),
        };
        match (is_loss, end) {
            (true, _) => self.loses(now),
            (false, End::Clear) => self.clear(now),
            (false, _) => {}
        }
    }

    /// The bus is lost: Conn Sta or P.620 in Basic mode, P.703 in ProfiDrive mode (3.2.2, 5.2, 5.3).
    fn loses(&mut self, now: Tick) {
        let by_bus = self.hand == Hand::Words;
        let order = match self.layout {
            Some(Layout::Basic) if self.readings.has(Reading::BasicEndsLocal) => {
                self.hand = Hand::Local;
                return self.local(now);
            }
            Some(Layout::Basic) if self.keeps_running() => Order::Keep,
            Some(Layout::Basic) => Order::Stop,
            _ => match self.inverter.stored(BUS_LOST) {
                1 => Order::Coast,
                2 => Order::Stop,
                3 => Order::Brake,
                4 => {
                    // P.928 must be set to 1 again (5.2).
                    self.inverter.store(RIGHT, 0);
                    self.hand = Hand::Local;
                    return self.local(now);
                }
                _ => Order::Keep,
            },
        };
        if by_bus {
            self.hand = Hand::Lost;
            self.inverter.obey(now, order);
        }
    }

    /// Whether a motor that loses its master in Basic mode runs on: by Conn Sta of the last word, or by P.620.
    fn keeps_running(&self) -> bool {
        let by_word = self.basic[0] & CONN_STA != 0;
        let by_parameter = self.inverter.stored(BUS_LOST_BASIC) == 1;
        let has = |reading| self.readings.has(reading);
        by_word && !has(Reading::GatewayAlone) || by_parameter && !has(Reading::ConnStaAlone)
    }

    /// Time passes: who has the motor goes on having it.
    pub(crate) fn catch_up(&mut self, now: Tick) {
        match self.hand {
            Hand::Local => self.local(now),
            Hand::Lost if !self.inverter.ordered => self.inverter.motor.rests(now),
            Hand::Lost | Hand::Words => {}
        }
    }

    fn local(&mut self, now: Tick) {
        let order = self.inverter.terminals();
        self.inverter.obey(now, order);
    }

    /// Somebody opens or closes the start contact.
    pub(crate) fn contact(&mut self, now: Tick, is_closed: bool) {
        self.inverter.contact = is_closed;
        self.steer(now);
    }

    /// The inverter trips.
    pub(crate) fn trips(&mut self, now: Tick, cause: u8) {
        self.inverter.trips(now, cause);
        self.machine.trips();
    }

    /// The motor gets what whoever has it wants now.
    pub(crate) fn steer(&mut self, now: Tick) {
        match (self.hand, self.layout) {
            (Hand::Lost, _) => {}
            (Hand::Local, _) | (Hand::Words, None) => self.local(now),
            (Hand::Words, Some(Layout::Basic)) => self.steer_basic(now),
            (Hand::Words, Some(_)) => self.steer_words(now),
        }
    }

    fn take_basic(&mut self, now: Tick, words: &[u16]) {
        let before = self.basic[0];
        for (own, word) in self.basic.iter_mut().zip(words) {
            *own = *word;
        }
        let [control, _, up, down] = self.basic;
        // 0.1 to 3000.0 s; anything else is not taken (6.2), or held at the limit.
        for (ramp, tenths) in self.inverter.ramps.iter_mut().zip([up, down]) {
            let held = tenths.clamp(1, 30_000);
            if held == tenths || self.readings.has(Reading::LimitsHold) {
                *ramp = Some(Span::from_millis(u64::from(held) * 100));
            }
        }
        if control & RESET != 0 && before & RESET == 0 {
            self.inverter.trip = None;
        }
        self.steer_basic(now);
    }

    fn steer_basic(&mut self, now: Tick) {
        let [control, setpoint, ..] = self.basic;
        let to = if control & NET_REF != 0 { i64::from(setpoint) } else { super::inverter::TERMINALS };
        let order = match (control & NET_CTRL != 0, control & (RUN_FWD | RUN_REV)) {
            (false, _) => match self.inverter.terminals() {
                Order::Run(_) => Order::Run(to),
                other => other,
            },
            (true, RUN_FWD) => Order::Run(to),
            (true, RUN_REV) => Order::Run(-to),
            (true, _) => Order::Stop,
        };
        self.inverter.obey(now, order);
    }

    fn tell_basic(&self, now: Tick) -> [u16; 4] {
        let (inverter, control) = (&self.inverter, self.basic[0]);
        let frequency = inverter.motor.frequency(now);
        let trip = inverter.trip.map_or(0, |trip| u16::from(trip.cause & 0x3F) << 8 | RESET);
        let run = match (self.readings.has(Reading::RunIsCommand), frequency.signum()) {
            (true, _) if inverter.ordered => control & (RUN_FWD | RUN_REV),
            (false, 1) => RUN_FWD,
            (false, -1) => RUN_REV,
            _ => 0,
        };
        let status = control & (CONN_STA | NET_REF | INV_REF | NET_CTRL) | trip | run;
        [status, word(frequency.abs()), word(inverter.current(now)), inverter.state(now)]
    }

    fn take_words(&mut self, now: Tick, words: &[u16]) {
        let &[stw, hsw, ref mapped @ ..] = words else { return };
        let (right, readings) = (self.has_right(), self.readings);
        if self.machine.take(stw, hsw.cast_signed(), right, readings) {
            self.inverter.trip = None;
            self.machine.trips();
        }
        for (place, word) in mapped.iter().enumerate() {
            let before = self.words.get_mut(place).map(|own| std::mem::replace(own, *word));
            let index = self.written.get(place).copied().unwrap_or(0);
            if index != 0 && before != Some(*word) {
                let _refused = self.write(now, index, 0, (*word).into(), false);
            }
        }
        self.steer_words(now);
    }

    fn steer_words(&mut self, now: Tick) {
        let machine = &self.machine;
        if !self.has_right() {
            return self.local(now);
        }
        let order = match machine.stw & CONTROL != 0 {
            true if machine.stw & TERMINALS_START != 0 => self.inverter.terminals(),
            true => match machine.order(self.inverter.motor.full, self.inverter.jog(), self.readings) {
                Order::Run(_) if machine.stw & TERMINALS_SETPOINT != 0 => Order::Run(super::inverter::TERMINALS),
                order => order,
            },
            false if self.readings.has(Reading::WithoutControlRamps) => Order::Stop,
            false if self.readings.has(Reading::WithoutControlIsLocal) => self.inverter.terminals(),
            false => Order::Keep,
        };
        self.inverter.obey(now, order);
    }

    fn tell_words(&self, now: Tick, count: usize) -> Vec<u16> {
        let mapped = (0..count.saturating_sub(2)).map(|place| {
            // What nobody reads shows what is written there, as the example of 4.1 has it.
            let of = |map: &[u16; 8]| map.get(place).copied().filter(|index| *index != 0);
            let index = of(&self.read).or(of(&self.written));
            index.map_or(0, |index| word(self.value(now, index.into()).unwrap_or(0)))
        });
        [self.status(now), self.actual(now).cast_unsigned()].into_iter().chain(mapped).collect()
    }

    /// ZSW.
    pub(crate) fn status(&self, now: Tick) -> u16 {
        let full = self.inverter.motor.full;
        let seen = Seen {
            trip: self.inverter.trip.is_some(),
            frequency: self.inverter.motor.frequency(now),
            setpoint: self.machine.setpoint(full, self.readings),
            right: self.has_right(),
        };
        self.machine.status(seen, self.readings)
    }

    /// HIW: 4000h is A004 (4.1.2.3).
    pub(crate) fn actual(&self, now: Tick) -> i16 {
        let motor = &self.inverter.motor;
        i16::try_from(motor.frequency(now) * 0x4000 / motor.full.max(1)).unwrap_or(0)
    }

    /// What has the motor, as P.600 tells: bit 0 the setpoint, bit 1 the start.
    pub(crate) fn who(&self) -> i64 {
        let stw = self.machine.stw;
        let by_words = self.hand == Hand::Words && self.has_right() && stw & CONTROL != 0;
        let (start, setpoint) = match (self.hand == Hand::Words, self.layout) {
            (true, Some(Layout::Basic)) => (self.basic[0] & NET_CTRL != 0, self.basic[0] & NET_REF != 0),
            _ => (by_words && stw & TERMINALS_START == 0, by_words && stw & TERMINALS_SETPOINT == 0),
        };
        i64::from(setpoint) | i64::from(start) << 1
    }

    fn pkw(&mut self, now: Tick, request: Pkw) -> Pkw {
        if let Some(asked) = self.channel.due(now) {
            let answer = self.answer(now, asked);
            self.channel.show(answer);
        }
        let takes = if request.ak == 0 || request.pnu >= GATEWAY { Span::ZERO } else { PKW_DELAY };
        self.channel.exchange(now, request, takes, self.readings)
    }
}

/// The low sixteen bits, as they go over the line.
fn word(raw: i64) -> u16 {
    (raw & 0xFFFF) as u16
}
