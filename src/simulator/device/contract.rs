//! What a station asks of the device behind it.
//!
//! [`Device`] is what every device has, however it is asked: time, power, a shaft, memory. What it understands on the
//! line is a face of its own for each protocol ([`AskedByModbus`], [`AskedByVabus`], [`AskedBySdo`]); a device that is not asked by one of
//! them has no such face, and one that is asked by something else gets another. [`OnSystemBus`] is the drive as an end of virtual links.

use super::counters::Counters;
use crate::profile::Type;
use crate::protocol::line::LineSetting;
use crate::protocol::modbus::pdu::Reply as ModbusReply;
use crate::protocol::vabus::{Address, Reply as VabusReply, Request};
use crate::simulator::line::speech::Spoken;
use crate::tick::{Span, Tick};
use std::fmt;

/// How long a device is off the bus after power-on or software reset ("a few seconds", CM-485 manual 5.2.1; the same for
/// all on this bench).
pub(crate) const RESTART: Span = Span::from_secs(3);
/// Time that a device needs to switch its transmitter off (CM-485 manual 6.8).
pub(crate) const TURNAROUND: Span = Span::from_millis(2);

/// A device of the bench, without its line. What is not answered here a device has not.
pub(crate) trait Device: fmt::Debug + Send + CloneDevice {
    /// The word of a bench file for it: `act`.
    fn model(&self) -> &'static str;

    /// Lets the time pass.
    fn catch_up(&mut self, _now: Tick) {}

    /// When something will happen by itself.
    fn next(&self) -> Option<Tick> {
        None
    }

    /// Power-on (or off and on again, or software reset): not ready before `up`.
    fn power_up(&mut self, _now: Tick, _up: Tick) {}

    /// The power is gone until the next power-on.
    fn power_down(&mut self, _now: Tick) {}

    /// Whether the mains are there, if nothing else feeds its electronics.
    fn lives_by_mains(&self) -> Option<bool> {
        None
    }

    /// Something of the script happens to it.
    fn act(&mut self, _now: Tick, _action: Action) {}

    /// Where it stands on the line after power-on, if it stood at `before`.
    fn setting_at_power_on(&mut self, before: NodeSetting) -> NodeSetting {
        before
    }

    /// Where it stands on the line once a write was answered.
    fn setting_after_write(&mut self, before: NodeSetting) -> NodeSetting {
        before
    }

    /// Silence that its transmitter needs behind a telegram.
    fn switches_off_in(&self) -> Span {
        TURNAROUND
    }

    /// A telegram for it with a right check value was complete at `last`, and is known to be at `now`.
    fn heard(&mut self, _now: Tick, _last: Tick, _is_write: bool) {}

    /// The device as a slave of Modbus.
    fn modbus(&mut self) -> Option<&mut dyn AskedByModbus> {
        None
    }

    /// The device as a slave of VABus.
    fn vabus(&mut self) -> Option<&mut dyn AskedByVabus> {
        None
    }

    /// The device as a server of SDO.
    fn sdo(&mut self) -> Option<&mut dyn AskedBySdo> {
        None
    }

    /// The device as an end of virtual links.
    fn system_bus(&mut self) -> Option<&mut dyn OnSystemBus> {
        None
    }

    /// Raw value in the memory that keeps it without power.
    fn eeprom(&self, _number: u32, _set: u8) -> Option<i64> {
        None
    }

    /// Raw value that it works with.
    fn ram(&self, _number: u32, _set: u8) -> Option<i64> {
        None
    }

    /// Cells of the EEPROM written since it was built.
    fn eeprom_writes(&self) -> u64 {
        0
    }

    /// Whether a fault stands.
    fn in_fault(&self) -> bool {
        false
    }

    /// Whether its output stage feeds the motor.
    fn is_energised(&self) -> bool {
        false
    }

    /// Whether it runs, as a script means it.
    fn runs(&self) -> bool {
        false
    }

    /// Frequency of the shaft at `now`, if nobody does anything until then, 0.01 Hz, positive clockwise.
    fn shaft_speed(&self, _now: Tick) -> i64 {
        0
    }

    /// Whether the turning field is faster than this at `now`, 0.01 Hz.
    fn is_above(&self, _now: Tick, _limit: i64) -> bool {
        false
    }

    /// When [`Device::is_above`] can next become true by itself.
    fn rises_above(&self, _limit: i64) -> Option<Tick> {
        None
    }

    /// Shafts that turn: its own, and those behind it.
    fn turning(&self, now: Tick) -> u64 {
        u64::from(self.shaft_speed(now) != 0)
    }

    /// Output stages that feed a motor: its own, and those behind it.
    fn energised(&self) -> u64 {
        u64::from(self.is_energised())
    }

    /// What the shaft of a servo does.
    fn servo(&self, _now: Tick) -> Option<Servo> {
        None
    }
}

/// A slave of Modbus, whatever frames its telegrams.
pub(crate) trait AskedByModbus {
    /// Executes a request; `None` if it is not answered.
    fn answer(&mut self, counters: &mut Counters, now: Tick, pdu: &[u8]) -> Option<Response<ModbusReply>>;

    /// The PDU of a reply.
    fn encode(&self, reply: &ModbusReply) -> Vec<u8> {
        reply.encode()
    }
}

/// A slave of VABus.
pub(crate) trait AskedByVabus {
    /// Executes a request to this drive; `None` is silence.
    fn answer(&mut self, now: Tick, request: &Request) -> Option<Response<VabusReply>>;

    /// Obeys a broadcast.
    fn obey(&mut self, now: Tick, request: &Request) -> Effect;

    /// What a telegram with a wrong check character gets.
    fn garbled(&mut self, own: Address, telegram: &[u8]) -> Option<Response<VabusReply>>;

    /// What a write gets that is refused without a cause; `None` is silence.
    fn refuse(&mut self, own: Address) -> Option<Response<VabusReply>>;
}

/// A server of SDO, whatever frames carry it.
pub(crate) trait AskedBySdo {
    /// The bits of a value, and its type; or the code of a refusal.
    fn upload(&mut self, now: Tick, object: Object) -> Result<(u32, Type), u8>;

    /// Takes a value, or tells the code of a refusal.
    fn download(&mut self, now: Tick, object: Object, bits: u32) -> Result<Effect, u8>;
}

/// A drive as an end of virtual links: what its sources tell, and what comes over the system bus (EM-RES-03 manual 5.11.5).
pub(crate) trait OnSystemBus {
    /// What a source tells now.
    fn source(&self, number: u16) -> i64;

    /// What came for these sources.
    fn receive(&mut self, now: Tick, values: &[(u16, i64)]);

    /// A slave is in fault, or is not any more (manual 5.8.3).
    fn emergency(&mut self, now: Tick, stands: bool);
}

/// A parameter in a data set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Object {
    pub(crate) number: u16,
    pub(crate) set: u8,
}

/// What a request gets.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Response<R> {
    pub(crate) reply: R,
    pub(crate) effect: Effect,
    pub(crate) goes: Goes,
}

impl<R> Response<R> {
    /// A reply that changes nothing.
    pub(crate) fn plain(reply: R) -> Self {
        Response { reply, effect: Effect::None, goes: Goes::AsItStands }
    }
}

/// What follows a request once the reply is out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Effect {
    None,
    /// Software reset.
    Reset,
}

/// How a reply goes out, if its request changed the line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Goes {
    /// With the setting that the request came with.
    AsItStands,
    /// With the new one.
    Anew,
    /// It is lost.
    Nowhere,
}

/// Where a station stands on its line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct NodeSetting {
    /// Address in the protocol that it speaks.
    pub(crate) address: u8,
    pub(crate) spoken: Spoken,
    pub(crate) line: LineSetting,
}

/// A fault as a drive keeps it. A drive that knows no classes makes use of the number alone.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Fault {
    pub(crate) number: u16,
    /// 0 to 4.
    pub(crate) class: u8,
    pub(crate) qualifier: u16,
}

/// How a cell takes a write to the EEPROM that is worn out, or not in force yet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum CellFault {
    /// The RAM takes it, the EEPROM does not, and the drive says so (P.11 = 6, CM-485 manual 6.6).
    Refuses,
    /// The same, and the drive says nothing.
    Keeps,
    /// The EEPROM takes it, and the drive goes on working with what it had.
    NotInForce,
}

/// What a script can let happen. A device takes what it knows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Action {
    Fault(Fault),
    /// The warning word P.270.
    Warning(u16),
    PowerCycle,
    /// Off the bus for so long.
    Silent(Span),
    /// The controller of its CAN bus gives up, and begins anew behind this time.
    BusOff(Span),
    /// Somebody else sets this parameter, in this data set (0-9), to this raw value.
    Set(u32, u8, i64),
    /// This cell of the EEPROM takes writes so from now on; as it should where there is nothing.
    Eeprom(u32, u8, Option<CellFault>),
    /// Writes to this parameter or register are refused from now on.
    Refuses(u16),
    /// Writes to it are acknowledged from now on, and nothing comes of them.
    Ignores(u16),
    Mains(bool),
    /// S1IND: STOA of an ACU.
    StoA(bool),
    /// STOB of an ACU.
    StoB(bool),
    StartRight(bool),
    StartLeft(bool),
    /// Load at the shaft, percent of the rated torque.
    Torque(i64),
    /// Two phases of the motor are exchanged.
    ExchangePhases,
    /// A hand turns the shaft so fast, 0.01 Hz, positive clockwise; 0 lets it go.
    Hand(i64),
    /// So much lies at the analog input, 0.001 V.
    Analog(i64),
    /// What hangs at the shaft is stronger than the drive: while that feeds the motor it does not become slower.
    Dragged(bool),
}

impl Action {
    /// What undoes it, if that is a thing to do.
    pub(crate) fn opposite(self) -> Option<Action> {
        Some(match self {
            Action::Mains(on) => Action::Mains(!on),
            Action::StoA(on) => Action::StoA(!on),
            Action::StoB(on) => Action::StoB(!on),
            Action::StartRight(on) => Action::StartRight(!on),
            Action::StartLeft(on) => Action::StartLeft(!on),
            Action::Dragged(on) => Action::Dragged(!on),
            _ => return None,
        })
    }
}

/// What stands at the shaft of an LXM05, as an eye would see it, whatever the drive shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Servo {
    /// Bits 0-3, 5 and 6 of DCOMstatus: 27h is "operation enabled" (CiA 402).
    pub state: u16,
    /// Active mode of operation as _DCOMopmd_act shows it; 0 before the first one.
    pub mode: i64,
    /// Position, user units of 1/16384 turn, from the reference point or from power-on.
    pub position_usr: i64,
    /// Speed, 0.001 1/min, positive clockwise.
    pub speed_milli_rpm: i64,
    /// Whether a homing has found the reference point.
    pub referenced: bool,
}

/// A bench can be copied, and so can all that stands on it.
pub(crate) trait CloneDevice {
    fn cloned(&self) -> Box<dyn Device>;
}

impl<D: Device + Clone + 'static> CloneDevice for D {
    fn cloned(&self) -> Box<dyn Device> {
        Box::new(self.clone())
    }
}

impl Clone for Box<dyn Device> {
    fn clone(&self) -> Self {
        (**self).cloned()
    }
}
