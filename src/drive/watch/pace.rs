//! How fast the rounds of a watch come, against how fast they were wanted.

use super::decimal;
use crate::outcome::{Decimal, Monitor, Warning};
use crate::text::both;
use crate::tick::{Span, Tick};

/// When rounds began.
#[derive(Debug, Default)]
pub(super) struct Pace {
    first: Option<Tick>,
    last: Option<Tick>,
    begun: u64,
    late: u64,
}

impl Pace {
    /// When the round before began.
    pub(super) fn last(&self) -> Option<Tick> {
        self.last
    }

    /// A round begins; `interval` is what was asked for, on a grid from `begin`.
    pub(super) fn begins(&mut self, now: Tick, begin: Tick, interval: Option<Span>) {
        if let (Some(last), Some(step)) = (self.last, interval.map(Span::as_micros).filter(|step| *step > 0)) {
            let slot = |tick: Tick| tick.since(begin).as_micros() / step;
            self.late += u64::from(slot(now) > slot(last) + 1);
        }
        self.first.get_or_insert(now);
        (self.last, self.begun) = (Some(now), self.begun + 1);
    }

    /// From round to round on average; nothing before the second one.
    fn mean(&self) -> Option<Span> {
        let whole = self.last?.since(self.first?).as_micros();
        whole.checked_div(self.begun.saturating_sub(1)).map(Span::from_micros)
    }

    /// What is told of it at the end.
    pub(super) fn tell(&self, tally: &mut Monitor, interval: Option<Span>) {
        let rounded = |span: Span| Decimal { raw: i64::try_from(span.as_millis()).unwrap_or(i64::MAX), decimals: 3 };
        tally.interval = interval.map(decimal);
        (tally.interval_kept, tally.late) = (self.mean().map(rounded), self.late);
    }

    /// Rounds came clearly slower than they were asked for: 5 % and more is no hiccup.
    pub(super) fn warning(&self, interval: Option<Span>, gaps: u64) -> Option<Warning> {
        let (wanted, kept) = interval.filter(|wanted| *wanted > Span::ZERO).zip(self.mean())?;
        let is_slow = kept.times(20) > wanted.times(21);
        let kept = Span::from_millis(kept.as_millis());
        let why = match gaps {
            0 => both!(
                "because the line takes so long for what is asked",
                "weil die Leitung für das Gefragte so lange braucht"
            ),
            1 => both!(
                "and one of the samples is a gap: who does not answer is waited for",
                "und einer der Werte ist eine Lücke: wer nicht antwortet, auf den wird gewartet"
            ),
            gaps => both!(
                "and {gaps} of the samples are gaps: who does not answer is waited for",
                "und {gaps} der Werte sind Lücken: wer nicht antwortet, auf den wird gewartet"
            ),
        };
        is_slow.then(|| Warning {
            code: "monitor.interval".to_owned(),
            message: both!(
                "the interval of {wanted} was not kept: a round came every {kept} on average, {why}",
                "der Abstand von {wanted} wurde nicht eingehalten: im Mittel kam alle {kept} eine Runde, {why}",
                why
            ),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_gap_is_told_as_one() {
        let mut pace = Pace::default();
        let wanted = Some(Span::from_millis(100));
        (0..3).for_each(|nth| pace.begins(Tick::ZERO + Span::from_millis(nth * 400), Tick::ZERO, wanted));
        let told = |gaps: u64| pace.warning(wanted, gaps).unwrap().message;
        assert!(
            told(1).en.ends_with("one of the samples is a gap: who does not answer is waited for"),
            "{}",
            told(1).en
        );
        assert!(
            told(1).de.contains("einer der Werte ist eine L\u{fc}cke")
                && told(2).en.contains("2 of the samples are gaps")
        );
    }
}
