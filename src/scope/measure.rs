//! What curves come to.

use super::Curve;

/// What a curve comes to between two markers. Mean and effective value are those of the straight lines between the samples,
/// each weighed with its time; gaps count for nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Statistics {
    /// Samples that have a value.
    pub samples: usize,
    /// Smallest value.
    pub min: f64,
    /// Largest value.
    pub max: f64,
    /// Mean over time.
    pub mean: f64,
    /// Root of the mean of the squares over time.
    pub rms: f64,
}

/// What a curve comes to from `from` to `to` seconds; `None` if there is no value.
pub fn statistics(curve: &Curve, from: f64, to: f64) -> Option<Statistics> {
    let within: Vec<_> = curve.points.iter().filter(|(t, _)| (from..=to).contains(t)).collect();
    let values = || within.iter().filter_map(|(_, value)| *value);
    let first = values().next()?;
    let (mut time, mut area, mut squares) = (0.0, 0.0, 0.0);
    for pair in within.windows(2) {
        let [(t0, Some(a)), (t1, Some(b))] = pair else { continue };
        let step = t1 - t0;
        time += step;
        area += step * (a + b) / 2.0;
        // The integral of the square of a straight line.
        squares += step * (a * a + a * b + b * b) / 3.0;
    }
    let is_moment = time <= 0.0;
    Some(Statistics {
        samples: values().count(),
        min: values().fold(first, f64::min),
        max: values().fold(first, f64::max),
        mean: if is_moment { first } else { area / time },
        rms: if is_moment { first.abs() } else { (squares / time).sqrt() },
    })
}

/// How a drive followed one change of its setpoint. What cannot be told is missing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Response {
    /// Seconds at which the setpoint was seen to change first.
    pub t: f64,
    /// The setpoint before it, in the unit of its curve.
    pub from: f64,
    /// The setpoint behind it.
    pub to: f64,
    /// The actual value at the beginning, in the unit of its curve.
    pub start: f64,
    /// The actual value at the end: before the next change, or of the record.
    pub end: f64,
    /// By how much it went beyond its end, in percent of its way.
    pub overshoot_percent: Option<f64>,
    /// Seconds from the change until the actual value stays within the band around its end.
    pub settling_s: Option<f64>,
    /// Slope between a tenth and nine tenths of its way, in units a second.
    pub slope: Option<f64>,
    /// Seconds from the change until the straight line of that slope leaves the beginning.
    pub dead_time_s: Option<f64>,
}

/// How the actual value follows the setpoint: a response for each change between two markers, until a stop ends it, and none over a
/// break, from and to which nobody can tell. `band`: how near to its end the actual value counts as settled, as a share of its way.
pub fn responses(
    setpoint: &Curve,
    actual: &Curve,
    (from, to): (f64, f64),
    band: f64,
    (stops, breaks): (&[f64], &[(f64, f64)]),
) -> Vec<Response> {
    let mut breaks = breaks.to_vec();
    breaks.sort_by(|one, other| one.0.total_cmp(&other.0));
    let (mut pieces, mut begin) = (Vec::new(), from);
    for (end, behind) in breaks.into_iter().chain([(to, to)]) {
        pieces.push((begin, end.min(to)));
        begin = behind.max(begin);
    }
    let pieces = pieces.into_iter().filter(|(begin, end)| begin < end);
    pieces.flat_map(|piece| unbroken(setpoint, actual, piece, band, stops)).collect()
}

fn unbroken(setpoint: &Curve, actual: &Curve, (from, to): (f64, f64), band: f64, stops: &[f64]) -> Vec<Response> {
    let known = |curve: &Curve| -> Vec<(f64, f64)> {
        let within = curve.points.iter().filter(|(t, _)| (from..=to).contains(t));
        let mut known: Vec<_> = within.filter_map(|(t, value)| Some((*t, (*value)?))).collect();
        // What was not asked anew is told again as of its own time.
        known.dedup_by(|next, one| next.0 <= one.0);
        known
    };
    let (setpoint, actual) = (known(setpoint), known(actual));
    let changes = changes(&setpoint);
    let ends = changes.iter().skip(1).map(|change| change.since).chain([f64::INFINITY]);
    let stopped = |t: f64| stops.iter().copied().find(|stop| *stop > t).unwrap_or(f64::INFINITY);
    let until = |change: &Change, end: f64| {
        let stop = stopped(change.t);
        let is_in = move |t: f64| t <= end && t < stop;
        actual.iter().filter(|(t, _)| is_in(*t)).copied().collect::<Vec<_>>()
    };
    changes.iter().zip(ends).filter_map(|(change, end)| response(change, &until(change, end), band)).collect()
}

/// A change of a setpoint, all at once or by a ramp.
struct Change {
    /// When the setpoint before it was seen last: it came between this and `t`, and so may what the actual value did about it.
    since: f64,
    t: f64,
    from: f64,
    to: f64,
    /// When it was seen to have come to its end.
    done: f64,
    /// How long it seemed to stand on its way: its steps may be smaller than what its value shows.
    paused: f64,
    /// It was seen to stand there, and longer; what was led and is seen no longer may have been on its way.
    stands: bool,
}

/// The changes: from a value that stood to the next one that stands. A value that two samples close together tell did not stand.
fn changes(setpoint: &[(f64, f64)]) -> Vec<Change> {
    let mut changes: Vec<Change> = Vec::new();
    let close = 1.5 * usual_step(setpoint);
    for pair in setpoint.windows(2) {
        let [(before_t, before), (t, now)] = *pair else { continue };
        if before == now {
            changes
                .iter_mut()
                .last()
                .into_iter()
                .for_each(|change| change.stands |= t - change.done > 1.5 * change.paused);
            continue;
        }
        let goes_on = |change: &&mut Change| {
            before_t - change.done <= close && (now - before).signum() == (change.to - change.from).signum()
        };
        match changes.last_mut().filter(goes_on) {
            Some(change) => {
                change.paused = change.paused.max(before_t - change.done);
                (change.to, change.done, change.stands) = (now, t, false);
            }
            None => {
                let (since, from, to, done) = (before_t, before, now, t);
                changes.push(Change { since, t, from, to, done, paused: 0.0, stands: false });
            }
        }
    }
    changes
}

/// The time from one sample to the next: that in the middle of all.
fn usual_step(samples: &[(f64, f64)]) -> f64 {
    let mut steps: Vec<f64> = samples.windows(2).filter_map(|pair| Some(pair.last()?.0 - pair.first()?.0)).collect();
    steps.sort_by(f64::total_cmp);
    steps.get(steps.len() / 2).copied().unwrap_or(0.0)
}

/// Of a way that was cut off so many samples at least make a slope.
const LEAST: usize = 5;

/// How the actual value, as far as it counts, followed a change.
fn response(change: &Change, actual: &[(f64, f64)], band: f64) -> Option<Response> {
    let before = actual.iter().rfind(|(t, _)| *t <= change.since);
    let (begun, start) = *before.or(actual.first())?;
    let course: Vec<(f64, f64)> = actual.iter().filter(|(t, _)| *t >= change.t).copied().collect();
    let (last, end) = *course.last()?;
    let (way, side) = (end - start, (end - start).signum());
    let mut response = Response {
        t: change.t,
        from: change.from,
        to: change.to,
        start,
        end,
        overshoot_percent: None,
        settling_s: None,
        slope: None,
        dead_time_s: None,
    };
    let near = band * way.abs();
    // It stays near its end for the last tenth of the time in which the setpoint stands: else it is still on its way.
    let outside = course.iter().rposition(|(_, value)| (value - end).abs() > near);
    let settled = outside.map_or(course.first(), |last| course.get(last + 1)).map(|(t, _)| *t);
    let rests = settled.filter(|t| last - t >= 0.1 * (last - change.done) && last > t.max(change.done));
    let is_there = change.done <= change.t || change.stands;
    let rests = rests.filter(|_| way != 0.0 && is_there);
    if let Some(settled) = rests {
        let beyond = course.iter().map(|(_, value)| (value - end) * side).fold(0.0, f64::max);
        response.overshoot_percent = Some(100.0 * beyond / way.abs());
        response.settling_s = Some(settled - change.t);
    }
    // Cut off on its way it has the slope of a setpoint that was led, as far as that went.
    let is_led = change.done > change.t && (change.to - start) * side > 0.0;
    let way = match rests {
        Some(_) => way,
        None if is_led && course.len() >= LEAST => change.to - start,
        None => return Some(response),
    };
    // It may have left its beginning before it was seen to.
    let seen: Vec<(f64, f64)> = actual.iter().filter(|(t, _)| *t >= begun).copied().collect();
    let passes = |share: f64| crossing(&seen, start + share * way, side);
    if let (Some(early), Some(late)) = (passes(0.1), passes(0.9))
        && late > early
    {
        let slope = 0.8 * way / (late - early);
        response.slope = Some(slope);
        response.dead_time_s = Some((early - 0.1 * way / slope - change.t).max(0.0));
    }
    Some(response)
}

/// When a course first passes a level, on the straight line between two samples.
fn crossing(course: &[(f64, f64)], level: f64, side: f64) -> Option<f64> {
    course.windows(2).find_map(|pair| {
        let [(t0, a), (t1, b)] = *pair else { return None };
        let passes = (a - level) * side <= 0.0 && (b - level) * side > 0.0;
        passes.then(|| t0 + (t1 - t0) * (level - a) / (b - a))
    })
}

#[cfg(test)]
mod tests {
    use super::super::Part;
    use super::*;
    use crate::text::Text;

    fn curve(part: Part, points: impl Iterator<Item = (f64, Option<f64>)>) -> Curve {
        Curve { name: Text::name("x"), unit: "Hz".to_owned(), part, points: points.collect() }
    }

    fn near(told: f64, true_one: f64, by: f64) {
        assert!((told - true_one).abs() <= by, "{told}, not {true_one} within {by}");
    }

    #[test]
    fn mean_and_effective_value_are_those_of_the_curve_and_not_of_its_samples() {
        // A sine of three whole turns, sampled unevenly: 5 + 2 sin.
        let times =
            (0..=3_000).map(|n| f64::from(n) / 1_000.0).filter(|t| *t < 1.0 || (t * 1_000.0) % 7.0 < 1.0 || *t == 3.0);
        let sine = curve(Part::Other, times.map(|t| (t, Some(5.0 + 2.0 * (t * std::f64::consts::TAU).sin()))));
        let told = statistics(&sine, 0.0, 3.0).unwrap();
        near(told.mean, 5.0, 0.001);
        near(told.rms, 27f64.sqrt(), 0.001);
        near(told.max, 7.0, 0.001);
        near(told.min, 3.0, 0.001);
        // A gap is no time at all.
        let gap = curve(
            Part::Other,
            [(0.0, Some(1.0)), (1.0, Some(1.0)), (2.0, None), (9.0, Some(3.0)), (10.0, Some(3.0))].into_iter(),
        );
        near(statistics(&gap, 0.0, 10.0).unwrap().mean, 2.0, 1e-9);
        assert_eq!(statistics(&gap, 1.5, 5.0), None);
    }

    /// A step answered by a system of second order behind a dead time, whose overshoot and whose course a formula tells.
    #[test]
    fn a_step_is_measured_as_the_formula_of_its_system_tells() {
        let (damping, natural, dead, step): (f64, f64, f64, f64) = (0.4, 5.0, 0.3, 0.01);
        let turns = natural * (1.0 - damping * damping).sqrt();
        let answer = |t: f64| {
            let decay = (-damping * natural * t).exp();
            20.0 * (1.0 - decay * ((turns * t).cos() + damping * natural / turns * (turns * t).sin()))
        };
        let times = || (0..1_000).map(|n| f64::from(n) * step);
        let setpoint = curve(Part::Setpoint, times().map(|t| (t, Some(if t < 1.0 { 0.0 } else { 20.0 }))));
        let actual =
            curve(Part::Actual, times().map(|t| (t, Some(if t < 1.0 + dead { 0.0 } else { answer(t - 1.0 - dead) }))));
        let [told] = responses(&setpoint, &actual, (0.0, 20.0), 0.02, (&[], &[]))[..] else { panic!() };
        near(told.t, 1.0, step);
        let formula = 100.0 * (-std::f64::consts::PI * damping / (1.0 - damping * damping).sqrt()).exp();
        near(told.overshoot_percent.unwrap(), formula, 0.1);
        let last_outside = (0..100_000).map(|n| f64::from(n) * 1e-4).rfind(|t| (answer(*t) - 20.0).abs() > 0.4);
        near(told.settling_s.unwrap(), last_outside.unwrap() + dead, step);
        assert!(told.dead_time_s.unwrap() > dead, "the tangent leaves behind the dead time");
    }

    /// Two values of a round are asked one after the other: an actual value may tell of a change before the setpoint does.
    #[test]
    fn what_the_setpoint_was_not_seen_to_ask_for_yet_is_no_end_of_what_it_asked_before() {
        let (setpoint, actual): (Vec<_>, Vec<_>) = (0..200)
            .map(|n| f64::from(n) * 0.1)
            .map(|t| {
                let at =
                    |t: f64| if (2.0..12.05).contains(&t) { (25.0, (5.0 * (t - 2.0)).min(25.0)) } else { (0.0, 0.0) };
                ((t, Some(at(t).0)), (t + 0.06, Some(at(t + 0.06).1)))
            })
            .unzip();
        let setpoint = curve(Part::Setpoint, setpoint.into_iter());
        let told = responses(&setpoint, &curve(Part::Actual, actual.into_iter()), (0.0, 20.0), 0.02, (&[], &[]));
        let [up, down] = told[..] else { panic!("{told:?}") };
        assert_eq!((up.start, up.end, down.start, down.end), (0.0, 25.0, 25.0, 0.0));
        near(up.slope.unwrap(), 5.0, 0.01);
        near(up.settling_s.unwrap(), 4.9, 0.11);
    }

    /// However small its steps are, and whatever cuts it off: what was led and was not seen to stand has not settled.
    #[test]
    fn a_way_that_was_led_and_is_cut_off_has_a_slope_and_no_settling_time() {
        for (step, digits) in [(0.02, 100.0), (0.06, 100.0), (0.25, 100.0)] {
            let times = || (0..).map(|n| f64::from(n) * step).take_while(|t| *t < 16.99);
            let led = |t: f64| ((t - 2.0).clamp(0.0, 15.0) * digits).floor() / digits;
            let setpoint = curve(Part::Setpoint, times().map(|t| (t, Some(led(t)))));
            let actual = curve(Part::Actual, times().map(|t| (t + 0.02, Some(led(t)))));
            let told = responses(&setpoint, &actual, (0.0, 17.0), 0.02, (&[], &[]));
            let [cut] = told[..] else { panic!("{told:?}") };
            assert_eq!((cut.settling_s, cut.overshoot_percent), (None, None), "{step}: {cut:?}");
            near(cut.slope.unwrap(), 1.0, 0.01);
            // And one that was seen to stand has.
            let times = || (0..).map(|n| f64::from(n) * step).take_while(|t| *t < 22.0);
            let setpoint = curve(Part::Setpoint, times().map(|t| (t, Some(led(t)))));
            let actual = curve(Part::Actual, times().map(|t| (t + 0.02, Some(led(t)))));
            let told = responses(&setpoint, &actual, (0.0, 22.0), 0.02, (&[], &[]));
            near(told[0].settling_s.unwrap(), 14.7, 0.3);
        }
    }

    #[test]
    fn a_ramp_has_its_slope_and_no_overshoot_up_and_down() {
        let times = || (0..400).map(|n| f64::from(n) * 0.05);
        let ramp = |t: f64| (5.0 * (t - 2.0)).clamp(0.0, 25.0) - (10.0 * (t - 12.0)).clamp(0.0, 25.0);
        let setpoint =
            curve(Part::Setpoint, times().map(|t| (t, Some(if (2.0..12.0).contains(&t) { 25.0 } else { 0.0 }))));
        let actual = curve(Part::Actual, times().map(|t| (t, Some(ramp(t)))));
        let [up, down] = responses(&setpoint, &actual, (0.0, 20.0), 0.02, (&[], &[]))[..] else { panic!() };
        near(up.slope.unwrap(), 5.0, 0.01);
        near(down.slope.unwrap(), -10.0, 0.01);
        near(up.settling_s.unwrap(), 4.9, 0.051);
        near(down.settling_s.unwrap(), 2.45, 0.051);
        for told in [up, down] {
            near(told.overshoot_percent.unwrap(), 0.0, 1e-9);
            near(told.dead_time_s.unwrap(), 0.0, 0.01);
        }
        // Cut off on its way it has not settled, and nothing is made up.
        let [cut] = responses(&setpoint, &actual, (0.0, 5.0), 0.02, (&[], &[]))[..] else { panic!() };
        assert_eq!((cut.overshoot_percent, cut.settling_s, cut.slope), (None, None, None));
        // A setpoint that is led, seen twice in a moment, up to a stop as it arrives: one way, and its slope.
        let led = |t: f64| (10.0 * (t - 2.0)).clamp(0.0, 25.0);
        let asked = || times().chain([3.01]).map(|t| (t, Some(led(if t > 3.0 && t < 3.04 { 3.0 } else { t }))));
        let mut asked: Vec<_> = asked().collect();
        asked.sort_by(|a, b| a.0.total_cmp(&b.0));
        let lagging = |t: f64| led(t - 0.02);
        let told = responses(
            &curve(Part::Setpoint, asked.into_iter()),
            &curve(Part::Actual, times().map(|t| (t, Some(lagging(t))))),
            (0.0, 20.0),
            0.02,
            (&[4.48], &[]),
        );
        let [cut] = told[..] else { panic!("{told:?}") };
        assert_eq!((cut.overshoot_percent, cut.settling_s), (None, None));
        near(cut.slope.unwrap(), 10.0, 0.1);
        // A stop that the record tells ends it, and what comes behind it counts for nothing.
        let [held] = responses(
            &curve(Part::Setpoint, times().map(|t| (t, Some(if t < 2.0 { 0.0 } else { 25.0 })))),
            &actual,
            (0.0, 20.0),
            0.02,
            (&[11.0], &[]),
        )[..] else {
            panic!()
        };
        near(held.slope.unwrap(), 5.0, 0.01);
        near(held.end, 25.0, 1e-9);
        // Of a change within a break nobody knows when it was; what lies before and behind it is measured as ever.
        let [only] = responses(&setpoint, &actual, (0.0, 20.0), 0.02, (&[], &[(11.0, 13.0)]))[..] else { panic!() };
        near(only.slope.unwrap(), 5.0, 0.01);
    }
}
