//! Watching a shaft from look to look: does it stand, does it become slower, does it still change?

use crate::profile::Movement;
use crate::tick::{Span, Tick};
use std::collections::VecDeque;

/// What the last looks at a shaft tell.
#[derive(Debug)]
pub(super) struct Watch {
    movement: Movement,
    /// The looks of the last while.
    looks: VecDeque<(Tick, i64)>,
    /// The pace that counts as unchanged.
    steady: Option<i64>,
    /// The slowest pace so far.
    slowest: Option<i64>,
    /// The pace at the look before, of positions.
    before: Option<i64>,
    /// The slowest and the fastest pace of the last looks alone since it fell, and when it was clearly faster first.
    lowest: i64,
    peak: i64,
    faster: Option<Tick>,
    /// When it had become slower, or stood, last.
    slowed: Option<Tick>,
}

/// What a look has shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Trend {
    /// The shaft has become faster or slower.
    pub(super) changes: bool,
    /// It has become slower than it was at any time before.
    pub(super) slows: bool,
    /// For how long it has been clearly faster than before, at more than one look, and has not fallen again.
    pub(super) rises: Option<Span>,
    /// For how long it has turned and not become slower.
    pub(super) lasts: Span,
}

impl Trend {
    const UNKNOWN: Trend = Trend { changes: false, slows: false, rises: None, lasts: Span::ZERO };
    /// One place alone: it may do anything.
    const ANYTHING: Trend = Trend { changes: true, slows: true, rises: None, lasts: Span::ZERO };
}

/// A shaft that is as fast so long behind its stop does not obey it.
pub(super) const DISOBEYED: Span = Span::from_secs(1);
/// How far back looks tell, and how many do at least.
const WINDOW: Span = Span::from_secs(1);
/// So many looks tell of a shaft that wavers.
const ENOUGH: usize = 12;
/// So many looks tell whether a shaft becomes faster, where its position is looked at.
const FEW: usize = 4;
/// A pace that is no rise yet, in units of the drive: 2 Hz.
const SLIGHT: i64 = 200;
/// The same of a position, whose looks are not even: 7 1/min of 16384 increments.
const SLIGHT_PACE: i64 = 2_000;
/// A servo that holds its position may still toggle by an increment.
const JITTER: i64 = 1;

/// The way from one position to the next; they have 32 bits, and go round.
fn way(before: i64, after: i64) -> i64 {
    i64::from((after as i32).wrapping_sub(before as i32))
}

impl Watch {
    pub(super) fn new(movement: Movement) -> Self {
        Watch {
            movement,
            looks: VecDeque::new(),
            steady: None,
            slowest: None,
            before: None,
            lowest: i64::MAX,
            peak: 0,
            faster: None,
            slowed: None,
        }
    }

    /// Takes a look.
    pub(super) fn see(&mut self, now: Tick, raw: Option<i64>) -> Trend {
        let Some(raw) = raw else { return Trend::UNKNOWN };
        self.looks.push_back((now, raw));
        while self.looks.len() > ENOUGH && self.looks.front().is_some_and(|look| now.since(look.0) > WINDOW) {
            self.looks.pop_front();
        }
        let Some(pace) = self.pace(self.looks.len()) else { return Trend::ANYTHING };
        // Of positions the times at which they were read are known with their own error.
        let tolerance = |pace: i64| if self.movement == Movement::Speed { 0 } else { pace.abs() / 128 };
        let changes = self.steady.is_none_or(|steady| (pace - steady).abs() > tolerance(steady)) && !self.stands();
        // And an answer that came late makes one look slower than the shaft is: two must say so.
        let sure = pace.abs().max(self.before.map_or(0, i64::abs));
        let slows = self.slowest.is_none_or(|slowest| sure < slowest - tolerance(slowest));
        if changes {
            self.steady = Some(pace);
        }
        if slows {
            self.slowest = Some(sure);
        }
        self.before = Some(pace).filter(|_| self.movement == Movement::Position);
        if slows || self.stands() {
            self.slowed = Some(now);
        }
        let lasts = now.since(*self.slowed.get_or_insert(now));
        Trend { changes, slows, rises: self.rises(now), lasts }
    }

    /// For how long the last looks have shown a shaft that is clearly faster than it was.
    fn rises(&mut self, now: Tick) -> Option<Span> {
        let few = if self.movement == Movement::Speed { 1 } else { FEW };
        let pace = self.pace(few)?.saturating_abs();
        if pace < self.peak - self.peak / 16 {
            // It falls: what it was before that is over.
            (self.lowest, self.peak, self.faster) = (pace, pace, None);
        }
        (self.lowest, self.peak) = (self.lowest.min(pace), self.peak.max(pace));
        let slight = if self.movement == Movement::Speed { SLIGHT } else { SLIGHT_PACE };
        if pace <= self.lowest + (self.lowest / 4).max(slight) {
            return None;
        }
        let first = self.faster.is_none();
        let since = *self.faster.get_or_insert(now);
        (!first).then(|| now.since(since))
    }

    /// Speed of the shaft; of positions the mean change in a second, over so many looks.
    fn pace(&self, looks: usize) -> Option<i64> {
        let first = self.looks.len().checked_sub(looks)?;
        let ((then, before), (now, after)) = (*self.looks.get(first)?, *self.looks.back()?);
        match self.movement {
            Movement::Speed => Some(after),
            Movement::Position if now <= then => None,
            Movement::Position => {
                let span = i128::from(now.since(then).as_micros());
                i64::try_from(i128::from(way(before, after)) * 1_000_000 / span).ok()
            }
        }
    }

    /// Whether a speed that goes on falling as it did between the last looks will be 0 within a time.
    pub(super) fn rests_within(&self, span: Span) -> bool {
        let mut last = self.looks.iter().rev();
        let (Some(&(now, pace)), Some(&(then, before))) = (last.next(), last.next()) else { return false };
        let [pace, before] = [pace, before].map(|pace| i128::from(pace.unsigned_abs()));
        let took = i128::from(now.since(then).as_micros());
        self.movement == Movement::Speed && pace * took <= (before - pace) * i128::from(span.as_micros())
    }

    /// Whether the shaft stands; one look at a position does not tell.
    pub(super) fn stands(&self) -> bool {
        let mut last = self.looks.iter().rev();
        match (self.movement, last.next(), last.next()) {
            (Movement::Speed, Some(&(_, raw)), _) => raw == 0,
            (Movement::Position, Some(&(_, now)), Some(&(_, before))) => {
                way(before, now).abs() <= JITTER || self.wavers()
            }
            _ => false,
        }
    }

    /// Whether the looks tell: of a shaft that neither stands nor has been watched for a while they do not.
    pub(super) fn tells(&self) -> bool {
        self.stands() || self.looks.len() >= if self.movement == Movement::Speed { 1 } else { ENOUGH }
    }

    /// Whether the position goes to and fro around a place: a servo holds it. The mean of the later looks is where the
    /// mean of the earlier ones was, compared with how far they lie apart; of an even turning both are the same.
    fn wavers(&self) -> bool {
        if self.looks.len() < ENOUGH {
            return false;
        }
        let places: Vec<i128> = self.looks.iter().map(|look| i128::from(look.1)).collect();
        let ways = places.windows(2).filter_map(|pair| Some((pair.get(1)? - pair.first()?).signum()));
        let ways: Vec<i128> = ways.filter(|&way| way != 0).collect();
        let turns = ways.windows(2).filter(|pair| **pair == [1, -1]).count();
        let (early, late) = places.split_at(places.len() / 2);
        let mean = |places: &[i128]| places.iter().sum::<i128>() * 16 / (places.len().max(1) as i128);
        let width = |places: &[i128]| places.iter().max().zip(places.iter().min()).map_or(0, |(max, min)| max - min);
        let moved = (mean(late) - mean(early)).abs();
        turns >= 2 && moved * 3 <= width(early).max(width(late)) * 16
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn looks(movement: Movement, values: &[i64]) -> (Vec<bool>, bool) {
        let mut watch = Watch::new(movement);
        let at = |index: usize| Tick::ZERO + Span::from_millis(50 * index as u64);
        let see = |(index, &value): (usize, &i64)| watch.see(at(index), Some(value)).slows;
        let seen = values.iter().enumerate().map(see).collect();
        (seen, watch.stands())
    }

    #[test]
    fn a_speed_tells_by_itself() {
        assert_eq!(looks(Movement::Speed, &[500, 400, 400, 450, 399]), (vec![true, true, false, false, true], false));
        assert!(looks(Movement::Speed, &[0]).1);
    }

    #[test]
    fn a_speed_that_falls_is_0_soon_or_later() {
        let mut watch = Watch::new(Movement::Speed);
        let mut soon = |at: u64, raw: i64| {
            watch.see(Tick::ZERO + Span::from_millis(at), Some(raw));
            watch.rests_within(Span::from_secs(2))
        };
        assert_eq!(
            [soon(0, -2_000), soon(400, -1_800), soon(800, -1_200), soon(1_200, -1_200)],
            [false, false, true, false]
        );
    }

    #[test]
    fn a_position_tells_by_its_change() {
        let (slows, stands) = looks(Movement::Position, &[0, 100, 200, 260, 261, 260]);
        assert_eq!((slows, stands), (vec![true, true, false, false, true, true], true));
        assert!(!looks(Movement::Position, &[7]).1, "one look is not enough");
    }

    #[test]
    fn a_shaft_that_wavers_stands_and_one_that_turns_does_not() {
        let waver = |index: i64, width: i64| (index * 7_919 + index * index * 104_729) % (2 * width + 1) - width;
        for width in [2, 3, 10, 300, 5_000] {
            // At rest, at some look of a while; turning, slowly or fast, at none.
            let stood = |pace: i64| {
                let mut watch = Watch::new(Movement::Position);
                (0..80).any(|index| {
                    let place = pace * index + waver(index, width);
                    watch.see(Tick::ZERO + Span::from_millis(60 * index as u64), Some(place));
                    index > 1 && watch.stands()
                })
            };
            assert!(stood(0), "{width}");
            assert!(!stood(3 * width) && !stood(-200 * width), "{width}");
        }
        let mut swing = Watch::new(Movement::Position);
        let swings = (0..40).any(|index: i64| {
            // To one side and back again, once.
            swing.see(Tick::ZERO + Span::from_millis(60 * index as u64), Some(-(index - 20) * (index - 20)));
            swing.wavers()
        });
        assert!(!swings);
    }

    #[test]
    fn a_dozen_places_tell_that_a_shaft_wavers_and_how_far_it_may_move_meanwhile() {
        // To and fro by 3, and between the halves on by so much: a third of that is still the same place.
        for (moved, stands) in [(0, true), (1, true), (-1, true), (2, false), (-2, false)] {
            let places: Vec<i64> = (0..12).map(|look| look % 2 * 3 + if look < 6 { 0 } else { moved }).collect();
            assert_eq!(looks(Movement::Position, &places).1, stands, "{moved}");
            assert!(!looks(Movement::Position, &places[1..]).1, "{moved}: eleven are too few");
        }
        // It turns back twice; once is no waver.
        assert!(looks(Movement::Position, &[0, 2, 4, 6, 4, 2, 0, 2, 4, 6, 4, 2]).1);
        assert!(!looks(Movement::Position, &[0, 2, 4, 6, 8, 10, 9, 8, 7, 5, 3, 1]).1);
        // With a rest between to and fro, which is no turn of its own.
        let rests = [0, 3, 3, 0, 0, 3, 3, 0, 0, 3, 3, 0, 3, 0];
        assert!(looks(Movement::Position, &rests).1);
    }

    #[test]
    fn a_shaft_that_creeps_under_its_waver_does_not_stand() {
        let stood = |creep: i64| {
            let mut watch = Watch::new(Movement::Position);
            (0..40).any(|index: i64| {
                let waver = if index % 2 == 0 { 30 } else { -30 };
                watch.see(Tick::ZERO + Span::from_millis(60 * index as u64), Some(creep * index + waver));
                index > 1 && watch.stands()
            })
        };
        assert!(stood(0) && stood(1), "the servo holds it");
        assert!(!stood(10) && !stood(-10), "it goes on by 10 at every look");
    }

    #[test]
    fn an_answer_that_comes_late_does_not_hide_a_ramp() {
        // 3000 1/min, 30 1/min slower a second; every 61st answer comes 80 ms late, while the shaft turns on.
        let mut watch = Watch::new(Movement::Position);
        let (mut seen, mut longest) = (0, 0);
        for index in 0i64..1_800 {
            let ms = index * 50;
            let turned = 3_000 * ms - 15 * ms * ms / 1_000;
            let late = if index % 61 == 0 { 80 } else { 0 };
            let at = Tick::ZERO + Span::from_millis((ms + late).unsigned_abs());
            if watch.see(at, Some(turned * 16_384 / 60_000)).slows {
                (longest, seen) = (longest.max(ms - seen), ms);
            }
        }
        assert!(longest < 2_500, "{longest}");
    }

    #[test]
    fn a_ramp_that_lasts_is_seen_to_become_slower() {
        // 3000 1/min at 16384 a turn, 30 1/min slower a second: anew in every second.
        let mut watch = Watch::new(Movement::Position);
        let mut seen = 0;
        for index in 0i64..2_000 {
            let ms = index * 50;
            let turned = 3_000 * ms - 15 * ms * ms / 1_000;
            let slows = watch.see(Tick::ZERO + Span::from_millis(ms as u64), Some(turned * 16_384 / 60_000)).slows;
            assert!(slows || ms - seen < 2_000 || ms > 97_000, "{ms}");
            seen = if slows { ms } else { seen };
        }
    }

    fn at(ms: u64) -> Tick {
        Tick::ZERO + Span::from_millis(ms)
    }

    /// For how long it was seen to rise at the last of these speeds, a look each 50 ms.
    fn risen(movement: Movement, speeds: &[i64]) -> Option<Span> {
        let (mut watch, mut place, mut last) = (Watch::new(movement), i64::from(i32::MAX) - 20_000, None);
        for (index, speed) in speeds.iter().enumerate() {
            place += speed / 20;
            let raw = if movement == Movement::Speed { *speed } else { i64::from(place as i32) };
            last = watch.see(at(50 * index as u64), Some(raw)).rises;
        }
        last
    }

    #[test]
    fn a_shaft_that_becomes_faster_again_is_told_from_one_that_wavers() {
        let ramp = |from: i64, by: i64, looks: i64| (0..looks).map(move |look| from + by * look);
        for (movement, unit) in [(Movement::Speed, 1), (Movement::Position, 40)] {
            let told = |speeds: Vec<i64>| risen(movement, &speeds.iter().map(|speed| speed * unit).collect::<Vec<_>>());
            // Down all the way, over the end of 32 bits too, and standing then.
            assert_eq!(told(ramp(2_000, -50, 40).collect()), None);
            assert_eq!(told(ramp(2_000, -50, 40).chain([0; 10]).collect()), None);
            // Evenly, and with a twentieth to and fro.
            assert_eq!(told(vec![1_000; 30]), None);
            assert_eq!(told((0..30).map(|look| 1_000 + if look % 2 == 0 { 50 } else { -50 }).collect()), None);
            // Up again: seen for a while; and down once more: over.
            let up: Vec<_> = ramp(2_000, -50, 20).chain(ramp(1_000, 50, 20)).collect();
            assert!(told(up.clone()).is_some_and(|since| (300..1_000).contains(&since.as_millis())), "{movement:?}");
            assert_eq!(told(up.into_iter().chain(ramp(1_900, -100, 8)).collect()), None, "{movement:?}");
        }
    }

    #[test]
    fn a_speed_rises_by_more_than_a_quarter_and_falls_by_more_than_a_sixteenth() {
        let told = |speeds: &[i64]| risen(Movement::Speed, speeds).map(|since| since.as_millis());
        assert_eq!(told(&[1_000, 1_250, 1_250]), None);
        assert_eq!(told(&[1_000, 1_251, 1_251]), Some(50));
        // From 0 on it is 2 Hz.
        assert_eq!([told(&[0, 200, 200]), told(&[0, 201, 201])], [None, Some(50)]);
        assert_eq!([told(&[1_000, 1_600, 1_500]), told(&[1_000, 1_600, 1_499])], [Some(50), None]);
        assert_eq!(told(&[1_000, 1_600]), None, "one look alone");
    }

    #[test]
    fn an_even_shaft_lasts_since_it_last_became_slower() {
        let lasts = |movement, speeds: &[i64]| {
            let (mut watch, mut place, mut last) = (Watch::new(movement), 0, Span::ZERO);
            for (index, speed) in speeds.iter().enumerate() {
                place += speed / 20;
                let raw = if movement == Movement::Speed { *speed } else { place };
                last = watch.see(at(50 * index as u64), Some(raw)).lasts;
            }
            last.as_millis()
        };
        let [even, stands] = [[4_000; 31], [0; 31]];
        let slows = [5_000, 4_500].into_iter().chain([4_000; 29]).collect::<Vec<_>>();
        assert_eq!([&even[..], &slows, &stands].map(|speeds| lasts(Movement::Speed, speeds)), [1_500, 1_400, 0]);
        // Of a position the first two looks make one pace.
        assert!((1_300..=1_450).contains(&lasts(Movement::Position, &even)) && lasts(Movement::Position, &stands) == 0);
    }

    #[test]
    fn a_first_look_and_no_look_tell_nothing_of_a_trend() {
        for movement in [Movement::Speed, Movement::Position] {
            let mut watch = Watch::new(movement);
            assert_eq!(watch.see(at(0), None), Trend::UNKNOWN);
            assert!(!watch.stands() && !watch.tells());
        }
        let mut watch = Watch::new(Movement::Position);
        // One place, and a second one at the same moment, show no pace: it may do anything.
        assert_eq!(watch.see(at(5), Some(100)), Trend::ANYTHING);
        assert_eq!(watch.see(at(5), Some(300)), Trend::ANYTHING);
    }

    #[test]
    fn a_speed_changes_by_any_difference_and_not_at_rest() {
        let mut watch = Watch::new(Movement::Speed);
        let changes = [500, 500, 501, 501, 500, 0, 0, -3].map(|raw| watch.see(at(0), Some(raw)).changes);
        assert_eq!(changes, [true, false, true, false, true, false, false, true]);
    }

    #[test]
    fn a_position_has_its_error_of_reading() {
        // A mean of 12800 a second, then one that is up to a 128th off, or more.
        for (place, changes, slows) in [
            (25_600, false, false),
            (25_800, false, false),
            (25_802, true, false),
            (25_400, false, false),
            (25_398, true, true),
        ] {
            for sign in [1, -1] {
                let mut watch = Watch::new(Movement::Position);
                watch.see(at(0), Some(0));
                assert_eq!(watch.see(at(1_000), Some(sign * 12_800)), Trend::ANYTHING);
                let second = watch.see(at(2_000), Some(sign * place));
                assert_eq!(
                    (second.changes, second.slows, second.rises),
                    (changes, false, None),
                    "{}: one look may have come late",
                    sign * place
                );
                assert_eq!(watch.see(at(3_000), Some(sign * place * 3 / 2)).slows, slows, "{}", sign * place);
            }
        }
    }

    #[test]
    fn looks_of_the_last_second_tell_and_a_dozen_at_least() {
        let pace = |beat: u64, count: u64| {
            let mut watch = Watch::new(Movement::Position);
            for index in 0..count {
                let ms = index * beat;
                watch.see(at(ms), Some((ms * ms) as i64));
            }
            watch.pace(watch.looks.len()).unwrap()
        };
        // Of a place that is the square of the time in ms, the mean pace is the sum of both ends of the window.
        assert_eq!(pace(50, 41), (2_000 + 1_000) * 1_000, "the last second, both ends of it");
        assert_eq!(pace(50, 10), 450 * 1_000, "no more than there is");
        assert_eq!(pace(200, 41), (8_000 + 5_800) * 1_000, "twelve looks, however long they took");
    }

    #[test]
    fn a_position_that_toggles_by_one_stands() {
        for (places, stands) in [([100, 101], true), ([101, 100], true), ([100, 102], false), ([102, 100], false)] {
            assert_eq!(looks(Movement::Position, &places).1, stands, "{places:?}");
        }
    }

    #[test]
    fn an_even_turning_is_told_after_a_dozen_places_and_after_one_speed() {
        let mut watch = Watch::new(Movement::Position);
        let told: Vec<_> = (0..13)
            .map(|index| {
                watch.see(at(50 * index), Some(1_000 * index as i64));
                watch.tells()
            })
            .collect();
        assert_eq!(told.iter().position(|told| *told), Some(11), "{told:?}");
        assert!(!watch.stands());
        let mut speed = Watch::new(Movement::Speed);
        speed.see(at(0), Some(700));
        assert!(speed.tells() && !speed.stands());
    }

    #[test]
    fn a_falling_speed_is_extended_to_its_end() {
        let within = |movement, looks: &[(u64, i64)], ms: u64| {
            let mut watch = Watch::new(movement);
            for &(then, raw) in looks {
                watch.see(at(then), Some(raw));
            }
            watch.rests_within(Span::from_millis(ms))
        };
        let falls = [(0, 300), (100, 200)];
        assert_eq!([199, 200, 201].map(|ms| within(Movement::Speed, &falls, ms)), [false, true, true]);
        let backwards = [(0, -300), (100, -200)];
        assert_eq!([199, 200].map(|ms| within(Movement::Speed, &backwards, ms)), [false, true]);
        assert!(!within(Movement::Speed, &[(0, 200), (100, 300)], 10_000), "it rises");
        assert!(!within(Movement::Speed, &[(0, 200)], 10_000), "one look");
        assert!(!within(Movement::Position, &falls, 10_000), "a place is no speed");
    }
}
