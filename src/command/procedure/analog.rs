//! The adjustment of the analog input EM-S1INA (EM-RES-03 manual 6.1.7): 0 V, then 10 V, each confirmed by somebody who has measured it,
//! and proven by what P.253 shows behind it.

use super::guide::{Deed, Guide, Turn};
use crate::drive::motion::working;
use crate::drive::{Target, job};
use crate::failure::{Class, Failure};
use crate::profile::{Family, Param};
use crate::text::{Text, both};
use crate::tick::Span;

/// The filter of the input may take 5 s (EM-RES-03 manual 6.1.8): so long it must not change, and so long that is waited for.
const STILL: Span = Span::from_secs(6);
const PATIENCE: Span = Span::from_secs(30);
const LOOKS: Span = Span::from_millis(500);
/// Full scale in volts, and how far off it may be behind the adjustment: 1 %.
const FULL: i64 = 10;
const PERCENT: i64 = 100;
/// What counts as 0 behind the adjustment, in the digits of P.253.
const ZERO: i64 = 5;

/// One of the two voltages: what P.568 is set to for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Point {
    Zero,
    Full,
}

impl Point {
    /// P.568 (EM-RES-03 manual 6.1.7).
    pub(super) fn mode(self) -> i64 {
        match self {
            Point::Zero => 1,
            Point::Full => 2,
        }
    }

    /// Whether P.253 shows it. How many decimals it has is in no source, so 10 V may be 10, 100, 1000 or 10000.
    fn is_shown(self, raw: i64, decimals: Option<u8>) -> bool {
        let full = |decimals: u8| FULL * 10i64.pow(decimals.into());
        let near = |full: i64| (raw - full).abs() * PERCENT <= full;
        match (self, decimals) {
            (Point::Zero, _) => raw.abs() <= ZERO,
            (Point::Full, Some(decimals)) => near(full(decimals)),
            (Point::Full, None) => (0..=3).any(|decimals| near(full(decimals))),
        }
    }
}

impl Point {
    /// Whether P.253 can be the input at that voltage before it is adjusted: at 0 V within a tenth of what 10 V are in hundredths, or
    /// in the decimals that a catalogue tells; at 10 V within a fifth of what that is in any of them.
    fn can_be(self, raw: i64, decimals: Option<u8>) -> bool {
        let full = |decimals: u8| FULL * 10i64.pow(decimals.into());
        let is_about = |full: i64| (raw - full).abs() * 5 <= full;
        match (self, decimals) {
            (Point::Zero, decimals) => raw.abs() * 10 <= full(decimals.unwrap_or(2)),
            (Point::Full, Some(decimals)) => is_about(full(decimals)),
            (Point::Full, None) => (0..=3).any(|decimals| is_about(full(decimals))),
        }
    }

    /// In volts, and what to do so that it lies at the input.
    fn told(self) -> (i64, Text) {
        match self {
            Point::Zero => (
                0,
                both!(
                    "bridge X410A.6 to X210B.7 (GND), measure it",
                    "X410A.6 mit X210B.7 (GND) brücken und nachmessen"
                ),
            ),
            Point::Full => (
                FULL,
                both!(
                    "bridge X410A.6 to X210B.5 (10 V), measure it",
                    "X410A.6 mit X210B.5 (10 V) brücken und nachmessen"
                ),
            ),
        }
    }
}

/// P.568 and P.253.
pub(super) fn params(family: &Family) -> Option<(Param, Param)> {
    let slug = |slug: &str| family.params.values().find(|param| param.slug == slug).cloned();
    Some((slug("em-s1ina-calibration")?, slug("analog-input-em-s1ina")?))
}

impl Guide<'_> {
    /// Adjusts it at 0 V.
    pub(super) async fn zero(&mut self, turn: Turn<'_>, deed: &mut Deed) -> Result<(), Failure> {
        self.adjust(turn, deed, Point::Zero).await
    }

    /// Adjusts it at 10 V.
    pub(super) async fn full(&mut self, turn: Turn<'_>, deed: &mut Deed) -> Result<(), Failure> {
        self.adjust(turn, deed, Point::Full).await
    }

    async fn adjust(&mut self, turn: Turn<'_>, deed: &mut Deed, point: Point) -> Result<(), Failure> {
        let mut target = self.known().await?;
        self.allow();
        self.is_dead(&mut target).await?;
        let Some((mode, shows)) = params(&target.family) else { return Err(no_input()) };
        self.session.end_at(None);
        self.confirm(turn, &[]).await?;
        let before = self.settled(&mut target, &shows).await?;
        if !point.can_be(before, shows.decimals) {
            return Err(elsewhere(&shows.label(), before, point));
        }
        let step = job::Step { param: mode.clone(), set: 0, raw: point.mode(), kind: mode.kind, at: None };
        // It may go back by itself: then it does not read back, and what is shown of the input is the proof.
        match self.write_anyway(turn, deed, vec![step]).await {
            Err(failure) if failure.code != "refused.reads_back_differently" => return Err(failure),
            _ => {}
        }
        let after = self.settled(&mut target, &shows).await?;
        let (label, name) = (shows.label(), &shows.name);
        deed.found.push(both!("{label} {name}: {before} -> {after}", "{label} {name}: {before} -> {after}", name));
        let stands = working(&mut self.session, &mut target, &mode).await?;
        deed.found.extend(stands.map(|raw| {
            let label = mode.label();
            both!("{label} shows {raw} now", "{label} zeigt jetzt {raw}")
        }));
        if point.is_shown(after, shows.decimals) { Ok(()) } else { Err(not_shown(&label, after, point)) }
    }

    /// What P.253 shows, once it changes no more.
    async fn settled(&mut self, target: &mut Target, shows: &Param) -> Result<i64, Failure> {
        self.allow();
        let begun = self.session.now();
        let (mut since, mut held) = (begun, None);
        loop {
            let now = self.session.now();
            let raw = working(&mut self.session, target, shows).await?.ok_or_else(no_input)?;
            let is_same = held.is_some_and(|held: i64| (raw - held).abs() <= 1 + held.abs() / PERCENT);
            if !is_same {
                (since, held) = (now, Some(raw));
            }
            if is_same && now.since(since) >= STILL {
                return Ok(raw);
            }
            if now.since(begun) >= PATIENCE {
                return Err(unsteady(&shows.label(), raw));
            }
            let rested = self.session.rest(LOOKS).await;
            rested.map_err(|error| error.failure(target.address, Some(&target.family)))?;
        }
    }
}

fn no_input() -> Failure {
    let message = both!(
        "the drive has no analog input of an EM-RES-03 (P.568, P.253)",
        "der Antrieb hat keinen Analogeingang eines EM-RES-03 (P.568, P.253)"
    );
    Failure::new(Class::Data, "data.no_input", message)
}

fn unsteady(label: &str, raw: i64) -> Failure {
    let message = both!("{label} does not come to rest (last {raw})", "{label} kommt nicht zur Ruhe (zuletzt {raw})");
    Failure::new(Class::No, "no.steady", message).hint(both!(
        "check the voltage at the input, its wires and shield",
        "Spannung am Eingang, Leitung und Schirm prüfen"
    ))
}

/// It is another voltage that lies there.
fn elsewhere(label: &str, raw: i64, point: Point) -> Failure {
    let (volts, hint) = point.told();
    let message = both!(
        "{label} shows {raw}, which cannot be {volts} V: nothing was written",
        "{label} zeigt {raw}, das können nicht {volts} V sein: es wurde nichts geschrieben"
    );
    Failure::new(Class::No, "no.voltage", message).hint(hint)
}

fn not_shown(label: &str, raw: i64, point: Point) -> Failure {
    let (volts, hint) = point.told();
    let message = both!(
        "behind the adjustment at {volts} V {label} shows {raw}",
        "nach dem Abgleich bei {volts} V zeigt {label} {raw}"
    );
    Failure::new(Class::No, "no.adjusted", message).hint(hint)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ten_volts_are_known_by_their_digits() {
        for (raw, is_shown) in [
            (10, true),
            (100, true),
            (1_000, true),
            (9_950, true),
            (990, true),
            (980, false),
            (0, false),
            (-1_000, false),
        ] {
            assert_eq!(Point::Full.is_shown(raw, None), is_shown, "{raw}");
        }
        assert!(Point::Full.is_shown(1_000, Some(2)) && !Point::Full.is_shown(1_000, Some(1)));
        for (raw, zero, full) in
            [(30, true, false), (980, false, true), (-980, false, false), (0, true, false), (95, true, true)]
        {
            assert_eq!((Point::Zero.can_be(raw, None), Point::Full.can_be(raw, None)), (zero, full), "{raw}");
        }
        assert!(Point::Zero.is_shown(-5, None) && !Point::Zero.is_shown(6, None));
    }
}
