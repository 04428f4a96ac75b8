//! The two ways in which a slave is led (SJ2-PB manual 2): the words of PROFIdrive behind a PKW block (4.1), and the four words of the
//! Basic block (3.2), which has no parameters beside it.

use crate::drive::decode::dp::Cyclic;
use crate::protocol::dp::cfg::Layout;
use crate::protocol::dp::module::{Content, Module, Series};
use crate::protocol::dp::pkw::{self, Pkw};
use crate::text::{Text, both};

/// How a slave is led.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// STW and HSW, in the PPO of this number. Three and four have no PKW block, and all but one and three further words, which P.915 and
    /// P.916 say (4.1).
    Profidrive(u8),
    /// The Basic block.
    Basic(Ramps),
}

/// Ramps of the Basic block, 0.1 s: 0.1 to 3000 s (3.2.2). What a 0 does is open, so none is ever sent with a word that commands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ramps {
    /// From 0 to the maximum frequency.
    pub up: u16,
    /// From there to 0.
    pub down: u16,
}

impl Default for Ramps {
    /// 10 s, the example of the manual (3.2.2).
    fn default() -> Self {
        Ramps { up: 100, down: 100 }
    }
}

/// Control word and setpoint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Words {
    /// STW (4.1.2.1), or the control word of the Basic block (3.2.2).
    pub(super) stw: u16,
    /// 4000h is 100 % of A004 (4.1.2.3); in Basic mode 0.01 Hz (3.2.2).
    pub(super) hsw: u16,
}

/// What a slave tells in every cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Seen {
    /// ZSW (4.1.2.2), or the status word of the Basic block (3.2.3).
    pub zsw: u16,
    /// Actual frequency, signed; 4000h is 100 % of A004 (4.1.2.3), in Basic mode 0.01 Hz (3.2.3).
    pub hiw: i32,
    /// Operating state of the inverter, which the Basic block alone tells (3.2.3).
    pub state: Option<u16>,
}

/// Bits of STW (4.1.2.1) and of the Basic control word (3.2.2).
const REVERSE: u16 = 1 << 11;
const RUN_FWD: u16 = 1;
const RUN_REV: u16 = 1 << 1;
/// Bits of ZSW (4.1.2.2).
const READY: u16 = 0x0031;
const RUNS: u16 = 0x0007;
const FAULT: u16 = 1 << 3;
const REACHED: u16 = 1 << 8;
const BY_BUS: u16 = 1 << 9;
/// Bits of the Basic status word (3.2.3): Net Ctrl and Net Ref, Faulted.
const NET: u16 = 0x0050;
const FAULTED: u16 = 1 << 7;
/// Operating states of the inverter (3.2.3).
const RUNNING: u16 = 1;
const COASTING: u16 = 3;
const TRIPPED: u16 = 10;
/// 2 % of A004, or of the least that A004 may be: what is left of a ramp where it ends.
const SLOW: i32 = 0x4000 / 50;
const SLOW_BASIC: i32 = 60;
/// So far from its setpoint a frequency is reached: 0.1 %, or 0.1 Hz.
const CLOSE: u32 = 16;
const CLOSE_BASIC: u32 = 10;

impl Mode {
    /// The Basic block.
    pub fn is_basic(self) -> bool {
        matches!(self, Mode::Basic(_))
    }

    /// The way of what takes no other: PKW, STW and HSW.
    pub const PPO1: Mode = Mode::Profidrive(1);

    /// How a slave with these cyclic data is led.
    pub fn of(Cyclic(layout): Cyclic, ramps: Ramps) -> Self {
        match layout {
            Layout::Basic => Mode::Basic(ramps),
            Layout::Ppo(number) => Mode::Profidrive(number),
        }
    }

    /// How it is called: `Basic`, `PPO1`.
    pub fn name(self) -> String {
        if self.is_basic() { "Basic".to_owned() } else { self.layout().name().to_uppercase() }
    }

    /// Whether parameters are told (4.1).
    pub fn has_pkw(self) -> bool {
        self.layout().has_pkw()
    }

    /// Words behind STW and HSW.
    pub fn further(self) -> usize {
        let block = if self.has_pkw() { pkw::LENGTH } else { 0 };
        if self.is_basic() { 0 } else { (self.layout().length() - block) / 2 - 2 }
    }

    /// What is configured.
    pub fn layout(self) -> Layout {
        match self {
            Mode::Profidrive(number) => Layout::Ppo(number),
            Mode::Basic(_) => Layout::Basic,
        }
    }

    const fn either(self, profidrive: u16, basic: u16) -> Words {
        Words { stw: if matches!(self, Mode::Basic(_)) { basic } else { profidrive }, hsw: 0 }
    }

    /// No start, with control kept: OFF1 (4.1.2.1), or no run bit (3.2.2).
    pub(super) fn stop(self) -> Words {
        self.either(0x047E, NET)
    }

    /// Ready, without a start: bits 1 and 2 of STW alone, with control kept.
    pub(super) fn prepare(self) -> Words {
        self.either(0x0406, NET)
    }

    /// The edge that acknowledges a fault (bit 7 of both), with control kept and no start.
    pub(super) fn acknowledge(self) -> Words {
        self.either(0x0486, NET | FAULTED)
    }

    /// OFF3 besides: the motor coasts, or by the norm stops quickly. The Basic block has nothing that is stronger than its stop.
    pub(super) fn coast(self) -> Option<Words> {
        (!self.is_basic()).then_some(Words { stw: 0x047A, hsw: 0 })
    }

    /// The start word for a signed setpoint (4.1.2.4; 3.2.2).
    pub(super) fn start(self, value: i64) -> u16 {
        let is_reverse = value < 0;
        match self {
            Mode::Profidrive(_) => 0x047F | if is_reverse { REVERSE } else { 0 },
            Mode::Basic(_) => NET | if is_reverse { RUN_REV } else { RUN_FWD },
        }
    }

    /// The setpoint of these words, with the sign that their start bit gives it.
    pub(super) fn signed(self, Words { stw, hsw }: Words) -> i64 {
        let reverse = if self.is_basic() { RUN_REV } else { REVERSE };
        if stw & reverse == 0 { hsw.into() } else { -i64::from(hsw) }
    }

    /// What a frequency may be where a ramp ends.
    pub(super) fn slow(self) -> i32 {
        if self.is_basic() { SLOW_BASIC } else { SLOW }
    }

    /// How near a frequency is to be to its setpoint.
    pub(super) fn close(self) -> u32 {
        if self.is_basic() { CLOSE_BASIC } else { CLOSE }
    }

    /// The outputs of a cycle. Outputs of zero are that, ramps too.
    pub(super) fn outputs(self, pkw: Pkw, Words { stw, hsw }: Words) -> Vec<u8> {
        let (block, ramps) = match self {
            Mode::Profidrive(_) if !self.has_pkw() => (Vec::new(), Vec::new()),
            Mode::Profidrive(_) => (pkw.encode().to_vec(), Vec::new()),
            Mode::Basic(_) if stw == 0 => (Vec::new(), vec![0; 2]),
            Mode::Basic(Ramps { up, down }) => (Vec::new(), vec![up, down]),
        };
        let words = [stw, hsw].into_iter().chain(ramps);
        let mut bytes: Vec<u8> = block.into_iter().chain(words.flat_map(u16::to_be_bytes)).collect();
        // Nothing is mapped to the further words as long as they go out (`mapped`).
        bytes.resize(self.layout().length(), 0);
        bytes
    }

    /// What the inputs of a cycle tell, and the PKW block in front of it.
    pub(super) fn inputs(self, data: &[u8]) -> Option<(Pkw, Seen)> {
        let pkw = data.first_chunk::<{ pkw::LENGTH }>().filter(|_| self.has_pkw());
        let words = if pkw.is_some() { data.get(pkw::LENGTH..)? } else { data };
        let mut words = words.as_chunks().0.iter().map(|pair| u16::from_be_bytes(*pair));
        let (zsw, frequency) = (words.next()?, words.next()?);
        let seen = match self {
            Mode::Profidrive(_) => Seen { zsw, hiw: frequency.cast_signed().into(), state: None },
            // The frequency has no sign there.
            Mode::Basic(_) => {
                let sign = if zsw & (RUN_FWD | RUN_REV) == RUN_REV { -1 } else { 1 };
                Seen { zsw, hiw: i32::from(frequency) * sign, state: Some(words.nth(1)?) }
            }
        };
        Some((pkw.map_or(Pkw::default(), Pkw::decode), seen))
    }

    /// The further words of the inputs, from PZD3 on.
    pub(super) fn more(self, data: &[u8]) -> Vec<u16> {
        let words = data.as_chunks().0.iter().map(|pair| u16::from_be_bytes(*pair));
        let all: Vec<u16> = words.collect();
        all.get(all.len().saturating_sub(self.further())..).unwrap_or_default().to_vec()
    }
}

impl Seen {
    /// A trip.
    pub fn is_faulted(self) -> bool {
        match self.state {
            None => self.zsw & FAULT != 0,
            Some(state) => self.zsw & FAULTED != 0 || state == TRIPPED,
        }
    }

    /// Ready for a start that comes from the bus.
    pub(super) fn is_ready(self) -> bool {
        self.is_by_bus() && (self.state.is_some() || self.zsw & READY == READY)
    }

    /// Start and setpoint come from the bus.
    pub fn is_by_bus(self) -> bool {
        match self.state {
            None => self.zsw & BY_BUS != 0,
            Some(_) => self.zsw & NET == NET,
        }
    }

    /// The start word was taken. The bits say what was commanded, so they prove no run.
    pub(super) fn has_started(self) -> bool {
        match self.state {
            None => self.zsw & RUNS == RUNS,
            Some(state) => state == RUNNING || self.zsw & (RUN_FWD | RUN_REV) != 0,
        }
    }

    /// The slave says that the setpoint is reached; the Basic block has no bit for it.
    pub(super) fn is_reached(self) -> bool {
        self.state.is_none() && self.zsw & REACHED != 0
    }

    /// Somebody has the motor turn, or would, were its setpoint not 0.
    pub(super) fn is_driven(self) -> bool {
        self.hiw != 0 || self.state == Some(RUNNING)
    }

    /// How its status word is called.
    pub(super) fn named(self) -> Text {
        let zsw = self.zsw;
        match self.state {
            None => both!("ZSW is {zsw:04X}h", "ZSW ist {zsw:04X}h"),
            Some(_) => both!("the status word is {zsw:04X}h", "das Statuswort ist {zsw:04X}h"),
        }
    }

    /// The shaft turns on without power, so that the frequency tells nothing of it.
    pub(super) fn is_free(self) -> bool {
        self.is_faulted() || self.state == Some(COASTING)
    }
}

/// User parameters of the Basic block alone, for a series (3.1.1, 3.1.2); what a GSD may want in front of them is in no source.
pub fn basic_block(drive: &str) -> Option<Vec<u8>> {
    let series =
        [Series::L200, Series::Sj200, Series::X200].into_iter().find(|series| super::word(*series) == drive)?;
    Module { series, content: Content::Basic, swapped: false }.encode().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    const BASIC: Mode = Mode::Basic(Ramps { up: 50, down: 70 });

    #[test]
    fn the_words_of_the_basic_block_are_those_of_the_manual() {
        // 3.2.2: 1388h is 50 Hz, 64h is 10 s.
        let words = Words { stw: BASIC.start(1), hsw: 0x1388 };
        let ramps = Mode::Basic(Ramps::default());
        assert_eq!(ramps.outputs(Pkw::default(), words), [0x00, 0x51, 0x13, 0x88, 0x00, 0x64, 0x00, 0x64]);
        assert_eq!((BASIC.start(-1), BASIC.stop().stw, BASIC.acknowledge().stw), (0x0052, 0x0050, 0x00D0));
        assert_eq!(BASIC.outputs(Pkw::default(), BASIC.stop()), [0, 0x50, 0, 0, 0, 50, 0, 70]);
        assert_eq!(BASIC.outputs(Pkw::default(), Words { stw: 0, hsw: 0 }), [0; 8]);
        // Conn Sta, EEp Wri and Inv Ref in no word of ours, and Net Ctrl in each.
        for word in [BASIC.stop(), BASIC.prepare(), BASIC.acknowledge()].map(|words| words.stw) {
            assert_eq!((word & 0xC020, word & 0x0013), (0, 0x0010), "{word:04X}");
        }
    }

    #[test]
    fn what_comes_is_read_in_both_modes() {
        // 3.2.3: 7D0h is 20 Hz.
        let (_, seen) = BASIC.inputs(&[0x00, 0x52, 0x07, 0xD0, 0, 0x32, 0, 1]).unwrap();
        assert_eq!((seen.hiw, seen.state), (-2_000, Some(1)));
        assert!(seen.is_by_bus() && seen.has_started() && !seen.is_faulted() && !seen.is_reached());
        let (_, tripped) = BASIC.inputs(&[0x0D, 0xD0, 0, 0, 0, 0, 0, 10]).unwrap();
        assert!(tripped.is_faulted() && tripped.is_free());
        let (_, coasts) = BASIC.inputs(&[0x00, 0x50, 0, 0, 0, 0, 0, 3]).unwrap();
        assert!(!coasts.is_faulted() && coasts.is_free());
        let (_, ours) = BASIC.inputs(&[0x00, 0x10, 0, 0, 0, 0, 0, 0]).unwrap();
        assert!(!ours.is_by_bus(), "Net Ref is missing");
        let data = [[0; 8].as_slice(), &[0x07, 0x37, 0xE0, 0x00]].concat();
        let (_, seen) = Mode::PPO1.inputs(&data).unwrap();
        assert_eq!((seen.hiw, seen.state), (-0x2000, None));
        assert!(seen.is_by_bus() && seen.is_ready() && seen.has_started() && seen.is_reached());
        assert_eq!(BASIC.inputs(&[0; 4]), None);
    }

    #[test]
    fn every_ppo_carries_as_much_as_the_manual_says() {
        // 4.1: words behind STW and HSW, and whether a PKW block stands in front.
        for (number, further, has_pkw) in [(1, 0, true), (2, 4, true), (3, 0, false), (4, 4, false), (5, 8, true)] {
            let mode = Mode::Profidrive(number);
            assert_eq!((mode.further(), mode.has_pkw()), (further, has_pkw), "PPO{number}");
            let outputs = mode.outputs(Pkw::default(), mode.stop());
            assert_eq!(outputs.len(), mode.layout().length());
            let at = if has_pkw { 8 } else { 0 };
            assert_eq!(outputs[at..at + 4], [0x04, 0x7E, 0, 0]);
            let mut inputs = vec![0; mode.layout().length()];
            inputs[at..at + 2].copy_from_slice(&[0x02, 0x31]);
            inputs.iter_mut().skip(at + 4).for_each(|byte| *byte = 1);
            assert_eq!(mode.inputs(&inputs).unwrap().1.zsw, 0x0231);
            assert_eq!(mode.more(&inputs), vec![0x0101; further]);
        }
    }

    #[test]
    fn the_block_of_a_series_is_that_of_the_manual() {
        for (drive, bytes) in
            [("l200", &[0xC7, 0xFF, 0xFF][..]), ("sj200", &[0x47, 0xFF, 0xFF]), ("x200", &[0x8F, 0xFF])]
        {
            assert_eq!(basic_block(drive).as_deref(), Some(bytes), "{drive}");
        }
        assert_eq!(basic_block("act"), None);
    }
}
