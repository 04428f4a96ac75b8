//! How long a verb takes at most, whatever comes over the line: the one place for it. The help prints it, what reads is
//! held to it ([`Session::allow`]), and a test holds every verb to it on lines of every kind of badness.

use super::session::Session;
use crate::exchange::Limits;
use crate::protocol::Protocol;
use crate::protocol::line::{LineSetting, Parity};
use crate::protocol::modbus::Framing;
use crate::tick::{Span, Tick};

/// What questions take at most, as a function of the time-outs and of the line.
#[derive(Clone, Copy, Debug)]
pub struct Price {
    /// All tries of one.
    tries: Span,
    /// One of which it is in doubt whose answer comes.
    longest: Span,
}

impl Price {
    /// Within these limits.
    pub fn of(limits: &Limits, protocol: Protocol, line: LineSetting) -> Self {
        Price { tries: limits.tries(protocol, line), longest: limits.longest(protocol, line) }
    }

    /// With the usual time-outs on the usual line.
    pub fn usual() -> Self {
        Price::of(&Limits::default(), Framing::Rtu.into(), LineSetting::rtu(19_200, Parity::Even))
    }

    /// So many questions, of which one may be in doubt: a line that makes all of them doubtful is given up.
    pub fn of_questions(self, count: u64) -> Span {
        self.tries.times(count) + self.longest
    }
}

/// The longest that a verb takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Upper {
    /// Questions to each drive.
    pub drive: u64,
    /// Further ones for each of these.
    pub each: u64,
    /// What they are, in words.
    pub of: &'static str,
    /// What is waited for besides: states, stops, proofs.
    pub besides: Span,
    /// What may take longer, and how that ends, in words.
    pub unless: &'static str,
}

impl Upper {
    /// Nothing is asked.
    pub const OFFLINE: Upper = Upper { drive: 0, each: 0, of: "", besides: Span::ZERO, unless: "" };

    /// So many questions to each drive.
    pub const fn drive(drive: u64) -> Self {
        Upper { drive, ..Upper::OFFLINE }
    }

    /// And so many for each of something.
    pub const fn each(self, each: u64, of: &'static str) -> Self {
        Upper { each, of, ..self }
    }

    /// And so long besides.
    pub const fn besides(self, besides: Span) -> Self {
        Upper { besides, ..self }
    }

    /// But for this.
    pub const fn unless(self, unless: &'static str) -> Self {
        Upper { unless, ..self }
    }

    /// Questions to a drive of which so many things are wanted.
    pub const fn questions(&self, count: u64) -> u64 {
        self.drive + self.each * count
    }

    /// The longest that it takes with one drive of which so many things are wanted.
    pub fn span(&self, price: Price, count: u64) -> Span {
        price.of_questions(self.questions(count)) + self.besides
    }

    /// What the help says of it; `None` where nothing is asked.
    pub fn told(&self) -> Option<String> {
        if self.drive == 0 {
            return None;
        }
        let (price, of) = (Price::usual(), self.of);
        let (mut more, mut questions) = (String::new(), String::new());
        if self.each > 0 {
            more = format!(" and {} for each {of}", rounded(price.tries.times(self.each)));
            questions = format!(" and {} for each {of}", self.each);
        }
        let besides = rounded(self.besides);
        let waits =
            if self.besides == Span::ZERO { String::new() } else { format!(", {besides} for what it waits for") };
        let unless = if self.unless.is_empty() { String::new() } else { format!(" {}", self.unless) };
        Some(format!(
            "Upper time, whatever comes over the line: {} for each drive{more}, with --timeout 500ms, --retries 2 and 19200 \
             Bd. That is {} questions{questions}, each (retries + 1) x (timeout + {} ms), once {} for finding out whose answer \
             came{waits}.{unless}",
            rounded(self.span(price, 0)),
            self.drive,
            beside_timeout_ms(price),
            rounded(price.longest),
        ))
    }
}

/// Full seconds, and minutes where there are some; never less than it is.
fn rounded(span: Span) -> String {
    let seconds = span.as_micros().div_ceil(1_000_000);
    match (seconds / 60, seconds % 60) {
        (0, seconds) => format!("{seconds} s"),
        (minutes, 0) => format!("{minutes} min"),
        (minutes, seconds) => format!("{minutes} min {seconds} s"),
    }
}

/// What a try takes beside its time-out.
fn beside_timeout_ms(price: Price) -> u64 {
    let Limits { reply_timeout, retries, .. } = Limits::default();
    let one_try = price.tries.as_millis() / (u64::from(retries) + 1);
    (one_try - reply_timeout.as_millis()).next_multiple_of(10)
}

impl Session<'_> {
    /// What questions on this line take at most.
    pub fn price(&self) -> Price {
        Price::of(&self.limits(), self.protocol(), self.line())
    }

    /// Since then there is time for so many questions, and none for any that comes later.
    pub fn allow(&mut self, since: Tick, questions: u64) {
        self.end_at(Some(since + self.price().of_questions(questions)));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_upper_time_is_the_sum_of_its_questions_and_of_its_waits() {
        let price = Price { tries: Span::from_secs(2), longest: Span::from_secs(40) };
        let upper = Upper::drive(10).each(3, "value").besides(Span::from_secs(7));
        assert_eq!((upper.questions(0), upper.questions(4)), (10, 22));
        assert_eq!((upper.span(price, 0), upper.span(price, 4)), (Span::from_secs(67), Span::from_secs(91)));
        assert_eq!(Upper::OFFLINE.told(), None);
    }

    #[test]
    fn the_help_tells_the_formula_with_its_numbers() {
        let told = Upper::drive(10).each(3, "value").besides(Span::from_secs(7)).unless("Ctrl-C ends it.").told();
        let told = told.unwrap();
        // 3 x (500 ms + 50 ms + 256 characters of 11 bits at 19200 Bd); 42.6 s is the longest question.
        for part in
            ["1 min 11 s for each drive", "7 s for each value", "10 questions and 3 for each value", "200 ms", "43 s"]
        {
            assert!(told.contains(part), "{part}: {told}");
        }
        assert!(told.ends_with("7 s for what it waits for. Ctrl-C ends it."), "{told}");
        assert_eq!(
            ["59 s", "1 min", "2 min 1 s"],
            [58_100_000, 60_000_000, 120_000_001].map(|us| rounded(Span::from_micros(us)))
        );
    }
}
