//! As many points as a picture can show.

/// The points of a line, of each column of the picture only its ends and its extremes, so that no peak is lost.
pub(super) fn thin(points: &[(f64, f64)], column: f64) -> Vec<(f64, f64)> {
    let mut kept: Vec<(f64, f64)> = Vec::new();
    let mut rest = points;
    while let Some((first, _)) = rest.split_first() {
        let nth = (first.0 / column).floor();
        let count = rest.iter().take_while(|(x, _)| (x / column).floor() == nth).count().max(1);
        let (here, behind) = rest.split_at(count);
        rest = behind;
        let by = |pick: fn(f64, f64) -> bool| {
            here.iter().copied().reduce(|best, point| if pick(point.1, best.1) { point } else { best })
        };
        let mut some: Vec<_> =
            [Some(*first), by(|a, b| a < b), by(|a, b| a > b), here.last().copied()].into_iter().flatten().collect();
        some.sort_by(|a, b| a.0.total_cmp(&b.0));
        some.dedup();
        kept.extend(some);
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hundred_thousand_points_become_few_and_no_peak_is_lost() {
        let value = |n: i32| if n == 54_321 { 99.0 } else { f64::from(n % 10) };
        let points: Vec<_> = (0..100_000).map(|n| (f64::from(n) / 100.0, value(n))).collect();
        let kept = thin(&points, 1.0);
        assert!(kept.len() <= 4_000, "{}", kept.len());
        assert!(kept.iter().any(|point| point.1 == 99.0));
        assert_eq!((kept.first(), kept.last()), (points.first(), points.last()));
        assert!(kept.windows(2).all(|pair| pair[0].0 <= pair[1].0));
        assert_eq!(thin(&points[..3], 0.001), points[..3]);
    }
}
