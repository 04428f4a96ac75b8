//! How long the master paused between a reply and its next telegram.

use crate::tick::Span;

/// Longer pauses are somebody's rest, not a gap between telegrams.
const LONGEST: Span = Span::from_millis(100);
/// Gaps that are kept for the median, the last ones.
const KEPT: usize = 4_096;

/// Pauses between a reply and the next telegram of the master.
#[derive(Clone, Debug, Default)]
pub(crate) struct GapLog {
    count: u64,
    early: u64,
    least: Option<Span>,
    last: Vec<Span>,
}

/// What was measured of the pauses between a reply and the next telegram of the master, up to 100 ms.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Gaps {
    /// How many.
    pub count: u64,
    /// Of these, shorter than the station wants.
    pub early: u64,
    /// The shortest.
    pub least: Option<Span>,
    /// The median of the last 4096.
    pub median: Option<Span>,
}

impl GapLog {
    /// A telegram began so long after the end of a reply, behind which `rest` must pass.
    pub(crate) fn note(&mut self, gap: Span, rest: Span) {
        if gap > LONGEST {
            return;
        }
        let slot = (self.count % KEPT as u64) as usize;
        match self.last.get_mut(slot) {
            Some(old) => *old = gap,
            None => self.last.push(gap),
        }
        self.count += 1;
        self.early += u64::from(gap < rest);
        self.least = Some(self.least.map_or(gap, |least| least.min(gap)));
    }

    pub(crate) fn gaps(&self) -> Gaps {
        let mut sorted = self.last.clone();
        sorted.sort_unstable();
        let median = sorted.get(sorted.len() / 2).copied();
        Gaps { count: self.count, early: self.early, least: self.least, median }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_gaps_are_counted_and_rests_are_not() {
        let mut log = GapLog::default();
        for us in [2_006, 1_000, 2_100, 500_000] {
            log.note(Span::from_micros(us), Span::from_micros(2_006));
        }
        let gaps = log.gaps();
        assert_eq!((gaps.count, gaps.early), (3, 1));
        assert_eq!((gaps.least, gaps.median), (Some(Span::from_micros(1_000)), Some(Span::from_micros(2_006))));
    }
}
