//! A hand at the drive: what a master does to one station, in steps of 50 ms, and what an eye at the shaft sees.

use super::*;

/// One exchange takes this long.
const STEP: Span = Span::from_millis(50);

pub(crate) struct Hand {
    pub(crate) bench: Bench,
    now: Tick,
}

impl Hand {
    /// A drive at address 1 under the state machine, without load, with quick ramps and a holding time of 0.2 s, as far
    /// as `keys` and `set` say nothing else.
    pub(crate) fn on(model: &str, keys: &str, set: &str) -> Self {
        let usual = ["\"412\" = 1", "\"434\" = 3", "\"424\" = 100", "\"425\" = 80", "\"637\" = 1", "\"638\" = \"0.2\""];
        let kept = usual.iter().filter(|row| !set.contains(&row[..5])).map(|row| format!("{row}, "));
        let torque = if keys.contains("torque =") && !keys.starts_with("[[") { "" } else { "torque = 0" };
        Self::with(&format!(
            "[[drive]]\nmodel = \"{model}\"\n{torque}\n\
             ramps = {{ up_right = 50, down_right = 25, up_left = 40, down_left = 20 }}\n\
             set = {{ {}{set} }}\n{keys}\n",
            kept.collect::<String>()
        ))
    }

    pub(crate) fn with(text: &str) -> Self {
        Hand { bench: bench(text), now: Tick::ZERO }
    }

    fn ask(&mut self, station: u8, pdu: &[u8]) -> Option<Vec<u8>> {
        self.bench.master_sends(self.now, LINE, &Framing::Rtu.encode(station, pdu));
        self.now += STEP;
        let heard = bytes(&self.bench.advance(self.now));
        Framing::Rtu.decode(&heard).ok().map(|adu| adu.pdu)
    }

    pub(crate) fn wait(&mut self, millis: u64) {
        self.now += Span::from_millis(millis);
        assert_eq!(self.bench.advance(self.now), []);
    }

    /// Tells whether the drive took it.
    pub(crate) fn write_word(&mut self, number: u16, value: u16) -> bool {
        let ([a, b], [c, d]) = (number.to_be_bytes(), value.to_be_bytes());
        self.ask(1, &[6, a, b, c, d]) == Some(vec![6, a, b, c, d])
    }

    pub(crate) fn write_long(&mut self, number: u16, value: i32) -> bool {
        let ([a, b], [c, d, e, f]) = (number.to_be_bytes(), value.to_be_bytes());
        self.ask(1, &[101, a, b, c, d, e, f]) == Some(vec![101, a, b, c, d, e, f])
    }

    pub(crate) fn read_word(&mut self, number: u16) -> Option<u16> {
        let [a, b] = number.to_be_bytes();
        match self.ask(1, &[3, a, b, 0, 1])?[..] {
            [3, 2, high, low] => Some(u16::from_be_bytes([high, low])),
            _ => None,
        }
    }

    pub(crate) fn read_long(&mut self, number: u16) -> Option<i32> {
        let [a, b] = number.to_be_bytes();
        match self.ask(1, &[100, a, b])?[..] {
            [100, c, d, e, f] => Some(i32::from_be_bytes([c, d, e, f])),
            _ => None,
        }
    }

    pub(crate) fn status(&mut self) -> u16 {
        self.read_word(411).unwrap()
    }

    pub(crate) fn bit(&mut self, number: u8) -> bool {
        self.status() >> number & 1 == 1
    }

    /// Writes the control word and returns bits 0-3, 5 and 6 of the status word.
    pub(crate) fn command(&mut self, word: u16) -> u16 {
        assert!(self.write_word(410, word));
        self.state()
    }

    pub(crate) fn state(&mut self) -> u16 {
        self.status() & 0x6F
    }

    pub(crate) fn drive(&self) -> &Drive {
        self.bench.drive(1).unwrap()
    }

    /// What the eye sees, 0.01 Hz.
    pub(crate) fn shaft(&self) -> i64 {
        self.drive().shaft_speed(self.now)
    }

    pub(crate) fn energised(&self) -> bool {
        self.drive().is_energised()
    }

    /// Runs at 10 Hz clockwise by setpoint 484.
    pub(crate) fn run(&mut self) {
        assert!(self.write_long(484, 1_000));
        assert_eq!(self.command(0x0F), 0x27);
        self.wait(500);
        assert_eq!((self.shaft(), self.energised()), (1_000, true));
    }
}
