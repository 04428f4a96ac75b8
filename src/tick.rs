//! Time as a value: points ([`Tick`]) and lengths ([`Span`]) in whole microseconds.
//!
//! This room does arithmetic only. It never reads a clock: the link that carries the bytes also carries the time
//! (`transport`), which is virtual on the built-in bench and real on a tty.

use crate::text::{Wrong, both};
use std::fmt;
use std::ops::{Add, AddAssign, Sub};
use std::str::FromStr;
use std::time::Duration;

/// A point in time, in microseconds since the link was opened.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Tick(u64);

/// A length of time in microseconds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Span(u64);

impl Tick {
    /// The moment at which the link was opened.
    pub const ZERO: Tick = Tick(0);

    /// A point `micros` microseconds after the link was opened.
    pub const fn from_micros(micros: u64) -> Self {
        Tick(micros)
    }

    /// Microseconds since the link was opened.
    pub const fn as_micros(self) -> u64 {
        self.0
    }

    /// How long after `earlier` this is; zero if it is not after it.
    pub const fn since(self, earlier: Tick) -> Span {
        Span(self.0.saturating_sub(earlier.0))
    }
}

impl Span {
    /// No time at all.
    pub const ZERO: Span = Span(0);

    /// A length of `micros` microseconds.
    pub const fn from_micros(micros: u64) -> Self {
        Span(micros)
    }

    /// A length of `millis` milliseconds.
    pub const fn from_millis(millis: u64) -> Self {
        Span(millis.saturating_mul(1_000))
    }

    /// A length of `secs` seconds.
    pub const fn from_secs(secs: u64) -> Self {
        Span(secs.saturating_mul(1_000_000))
    }

    /// Whole microseconds.
    pub const fn as_micros(self) -> u64 {
        self.0
    }

    /// Whole milliseconds, rounded down.
    pub const fn as_millis(self) -> u64 {
        self.0 / 1_000
    }

    /// `count` times as long.
    pub const fn times(self, count: u64) -> Self {
        Span(self.0.saturating_mul(count))
    }

    /// The longer of two spans.
    pub fn longer(self, other: Span) -> Self {
        self.max(other)
    }
}

impl Add<Span> for Tick {
    type Output = Tick;
    fn add(self, span: Span) -> Tick {
        Tick(self.0.saturating_add(span.0))
    }
}

impl AddAssign<Span> for Tick {
    fn add_assign(&mut self, span: Span) {
        *self = *self + span;
    }
}

impl Add for Span {
    type Output = Span;
    fn add(self, other: Span) -> Span {
        Span(self.0.saturating_add(other.0))
    }
}

impl Sub for Span {
    type Output = Span;
    /// The difference, never below zero.
    fn sub(self, other: Span) -> Span {
        Span(self.0.saturating_sub(other.0))
    }
}

impl From<Duration> for Span {
    fn from(duration: Duration) -> Self {
        Span(u64::try_from(duration.as_micros()).unwrap_or(u64::MAX))
    }
}

impl From<Span> for Duration {
    fn from(span: Span) -> Self {
        Duration::from_micros(span.0)
    }
}

/// Reads the way people write times: `500ms`, `1.5 s`, `2m`, `750us`, up to a week.
impl FromStr for Span {
    type Err = Wrong;
    fn from_str(text: &str) -> Result<Self, Wrong> {
        let bad = || {
            Wrong(both!(
                "expected a time such as 500ms, 2s or 1m, got '{text}'",
                "erwartet: eine Zeit wie 500ms, 2s oder 1m; angegeben: '{text}'"
            ))
        };
        let typed = text.trim().replacen(',', ".", 1);
        let bare = || match typed.bytes().any(|byte| byte.is_ascii_digit()) {
            true => Wrong(both!(
                "expected a time such as 500ms, 2s or 1m, got '{text}' without a unit: {typed}s, or {typed}ms?",
                "erwartet: eine Zeit wie 500ms, 2s oder 1m; angegeben: '{text}' ohne Einheit: {typed}s oder {typed}ms?"
            )),
            false => bad(),
        };
        let end = typed.find(|c: char| !(c.is_ascii_digit() || c == '.')).ok_or_else(bare)?;
        let (number, unit) = typed.split_at(end);
        if number.trim_matches('.').is_empty() {
            return Err(bad());
        }
        let micros = match unit.trim() {
            "us" => 1,
            "ms" => 1_000,
            "s" => 1_000_000,
            "m" | "min" => 60_000_000,
            "h" => 3_600_000_000,
            _ => return Err(bad()),
        };
        let (whole, part) = number.split_once('.').unwrap_or((number, ""));
        let millionths: u64 = format!("{whole}{part:0<6}").parse().map_err(|_| bad())?;
        let exact = millionths.checked_mul(micros).filter(|time| time % 1_000_000 == 0 && part.len() <= 6);
        let span = Span(exact.ok_or_else(bad)? / 1_000_000);
        if span > WEEK {
            Err(Wrong(both!("'{typed}' is longer than a week", "'{typed}' ist länger als eine Woche")))
        } else {
            Ok(span)
        }
    }
}

/// Nothing that is waited for takes longer.
const WEEK: Span = Span(7 * 24 * 3_600_000_000);

/// Prints the span in the unit a technician would use: `750 us`, `12.5 ms`, `2 s`.
impl fmt::Display for Span {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            us if us < 1_000 => write!(f, "{us} us"),
            us if us < 1_000_000 => write!(f, "{} ms", thousandths(us, 1)),
            us => write!(f, "{} s", thousandths(us / 1_000, 2)),
        }
    }
}

/// `value / 1000` with at most `places` decimals and no trailing zeros.
fn thousandths(value: u64, places: usize) -> String {
    let text = format!("{}.{:03}", value / 1_000, value % 1_000);
    let cut = &text[..text.len() - (3 - places)];
    cut.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spans_print_in_the_unit_of_their_size() {
        let shown = |us| Span::from_micros(us).to_string();
        assert_eq!(shown(750), "750 us");
        assert_eq!(shown(12_500), "12.5 ms");
        assert_eq!(shown(500_000), "500 ms");
        assert_eq!(shown(2_000_000), "2 s");
        assert_eq!(shown(1_250_000), "1.25 s");
    }

    #[test]
    fn times_are_humane() {
        for (text, us) in
            [("500ms", 500_000), ("2s", 2_000_000), ("1.5 s", 1_500_000), ("1m", 60_000_000), ("0.5ms", 500)]
        {
            assert_eq!(text.parse(), Ok(Span::from_micros(us)), "{text}");
        }
        for text in ["", "5", "s", "-1s", "1.2.3s", "1x", "0.5us", "200h", "99999999h", "0.0000001s"] {
            assert!(text.parse::<Span>().is_err(), "{text}");
        }
    }

    #[test]
    fn differences_never_go_below_zero() {
        assert_eq!(Tick::from_micros(3).since(Tick::from_micros(5)), Span::ZERO);
        assert_eq!(Span::from_millis(1) - Span::from_secs(1), Span::ZERO);
    }
}
