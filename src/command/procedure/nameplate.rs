//! The nameplate of a motor: whether it can be so, and what of it goes into the drive.
//!
//! No manual of ours tells how a nameplate is judged; the bounds here are ours, wide enough for any motor that is built.

use super::given::{Given, bad};
use crate::drive::job;
use crate::failure::{Class, Failure};
use crate::profile::value::{self, parse_decimal};
use crate::profile::{Family, Param, Role, Sets};
use crate::text::{Text, both};

/// More slip than that has no motor at its rated speed.
const MOST_SLIP: f64 = 0.2;
/// Less of what it takes gives no motor at its rated power.
const LEAST_YIELD: f64 = 0.2;

/// A nameplate, in kW, V, A, Hz and 1/min.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Nameplate {
    power: f64,
    voltage: f64,
    current: f64,
    /// Rated frequency.
    pub(super) frequency: f64,
    speed: f64,
    cos_phi: Option<f64>,
    /// As it tells them, or as speed and frequency do.
    pub(super) pole_pairs: i64,
}

impl Nameplate {
    /// As it was given.
    ///
    /// # Errors
    /// A value is no number of its unit, or the values contradict each other.
    pub(super) fn of(given: &Given) -> Result<Self, Failure> {
        let must = |key: &str, units: &[&str]| number(given, key, units).map(Option::unwrap_or_default);
        let frequency = must("frequency", &["Hz"])?;
        let speed = must("speed", &["rpm", "1/min"])?;
        let told = whole(given, "pole-pairs")?;
        let turns = (60.0 * frequency / speed + 1e-9).floor() as i64;
        let plate = Nameplate {
            power: must("power", &["kW", "W"])?,
            voltage: must("voltage", &["V"])?,
            current: must("current", &["A"])?,
            frequency,
            speed,
            cos_phi: number(given, "cos-phi", &[""])?,
            pole_pairs: turns,
        };
        plate.turns(told)?;
        plate.yields()?;
        Ok(plate)
    }

    /// Speed, frequency and pole pairs.
    fn turns(&self, told: Option<i64>) -> Result<(), Failure> {
        let Nameplate { frequency, speed, pole_pairs, .. } = *self;
        if pole_pairs < 1 {
            let most = (60.0 * frequency).round();
            return Err(implausible(both!(
                "at {frequency} Hz no motor turns faster than {most} 1/min, but its speed is to be {speed}",
                "bei {frequency} Hz dreht kein Motor schneller als {most} 1/min, seine Drehzahl soll aber {speed} sein"
            )));
        }
        if let Some(told) = told.filter(|&told| told != pole_pairs) {
            return Err(implausible(both!(
                "{speed} 1/min at {frequency} Hz is a motor of {pole_pairs} pole pairs, not of {told}",
                "{speed} 1/min bei {frequency} Hz ist ein Motor mit {pole_pairs} Polpaaren, nicht mit {told}"
            )));
        }
        if self.slip() > MOST_SLIP {
            let percent = percent(self.slip());
            return Err(implausible(both!(
                "{speed} 1/min at {frequency} Hz would be a slip of {percent} %: is it the rated speed at this frequency?",
                "{speed} 1/min bei {frequency} Hz wären {percent} % Schlupf: ist das die Bemessungsdrehzahl bei dieser Frequenz?"
            )));
        }
        Ok(())
    }

    /// Power, voltage and current.
    fn yields(&self) -> Result<(), Failure> {
        let Nameplate { power, voltage, current, .. } = *self;
        let (most, share) = (format!("{:.2}", self.taken()), self.share());
        if self.cos_phi.is_some_and(|cos| cos > 1.0) {
            return Err(implausible(both!("a cos phi is at most 1", "ein cos phi ist höchstens 1")));
        }
        if share > 1.0 {
            return Err(implausible(both!(
                "{power} kW is more than the motor takes: {voltage} V and {current} A are {most} kW at most (star or delta?)",
                "{power} kW ist mehr, als der Motor aufnimmt: {voltage} V und {current} A sind höchstens {most} kW (Stern oder \
                 Dreieck?)"
            )));
        }
        if share < LEAST_YIELD {
            let percent = percent(share);
            return Err(implausible(both!(
                "{power} kW is only {percent} % of the {most} kW that {voltage} V and {current} A are (star or delta?)",
                "{power} kW sind nur {percent} % der {most} kW, die {voltage} V und {current} A ergeben (Stern oder Dreieck?)"
            )));
        }
        Ok(())
    }

    fn slip(&self) -> f64 {
        1.0 - self.speed * self.pole_pairs as f64 / (60.0 * self.frequency)
    }

    /// What it takes at most, kW.
    fn taken(&self) -> f64 {
        3f64.sqrt() * self.voltage * self.current * self.cos_phi.unwrap_or(1.0) / 1_000.0
    }

    /// How much of it comes out.
    fn share(&self) -> f64 {
        self.power / self.taken()
    }

    /// What was found of it.
    pub(super) fn told(&self) -> Vec<Text> {
        let (pairs, slip, share, taken) =
            (self.pole_pairs, percent(self.slip()), percent(self.share()), format!("{:.2}", self.taken()));
        let of = if self.cos_phi.is_some() { "kW" } else { "kVA" };
        vec![
            both!("{pairs} pole pairs, slip {slip} %", "{pairs} Polpaare, Schlupf {slip} %"),
            both!(
                "power is {share} % of the {taken} {of} that it takes",
                "die Leistung sind {share} % der aufgenommenen {taken} {of}"
            ),
        ]
    }
}

fn percent(share: f64) -> String {
    format!("{:.1}", share * 100.0)
}

fn implausible(why: Text) -> Failure {
    let text = both!("this nameplate cannot be so: {why}", "dieses Typenschild kann nicht stimmen: {why}", why);
    Failure::new(Class::Data, "data.nameplate", text)
}

/// A number in its unit, above 0; in the first of the units, which may be left out.
pub(super) fn number(given: &Given, key: &str, units: &[&str]) -> Result<Option<f64>, Failure> {
    let Some(text) = given.get(key) else { return Ok(None) };
    let digits = text.trim_end_matches(|letter: char| !letter.is_ascii_digit());
    let unit = text.get(digits.len()..).unwrap_or_default().trim();
    let named = if unit.is_empty() { Some(0) } else { units.iter().position(|known| known.eq_ignore_ascii_case(unit)) };
    // 1/min ends with letters that follow a digit.
    let (digits, named) = match text.strip_suffix("1/min") {
        Some(rest) if units.contains(&"1/min") => (rest.trim(), Some(0)),
        _ => (digits, named),
    };
    let number = parse_decimal(digits.trim(), 3).ok().filter(|&raw| raw > 0).map(|raw| raw as f64 / 1_000.0);
    match (number, named) {
        (Some(number), Some(nth)) => Ok(Some(if units.get(nth) == Some(&"W") { number / 1_000.0 } else { number })),
        _ => {
            let unit = units.first().copied().unwrap_or_default();
            Err(bad(
                key,
                &both!(
                    "expected a number above 0 {unit}, got '{text}'",
                    "erwartet wird eine Zahl über 0 {unit}; angegeben: '{text}'"
                ),
            ))
        }
    }
}

/// A whole number without a unit, above 0.
pub(super) fn whole(given: &Given, key: &str) -> Result<Option<i64>, Failure> {
    let number = number(given, key, &[""])?;
    match number.filter(|number| number.fract() != 0.0) {
        None => Ok(number.map(|number| number as i64)),
        Some(number) => Err(bad(
            key,
            &both!("expected a whole number, got {number}", "erwartet wird eine ganze Zahl; angegeben: {number}"),
        )),
    }
}

/// Which data set is meant; 0 is all four.
///
/// # Errors
/// There is no such set.
pub(super) fn data_set(given: &Given) -> Result<u8, Failure> {
    let Some(text) = given.get("data-set") else { return Ok(0) };
    text.parse().ok().filter(|set| *set <= 4).ok_or_else(|| {
        bad("data-set", &both!("expected 0 to 4, got '{text}'", "erwartet: 0 bis 4; angegeben: '{text}'"))
    })
}

/// What goes into the drive, parameter by parameter; and what a catalogue does not know.
///
/// # Errors
/// A value that its parameter cannot hold.
pub(super) fn steps(given: &Given, family: &Family) -> Result<(Vec<job::Step>, Vec<Text>), Failure> {
    let (plate, set) = (Nameplate::of(given)?, data_set(given)?);
    let place = |param: &Param| if param.sets == Some(Sets::Four) { set } else { 0 };
    let (mut steps, mut unknown) = (Vec::new(), Vec::new());
    for (key, slug, name) in KEPT {
        let Some(text) = given.get(key) else { continue };
        let Some(param) = family.params.values().find(|param| param.slug == slug) else {
            unknown.push(name);
            continue;
        };
        let raw = value::parse(text, param, &[]).map_err(|error| bad(key, &error.text()))?;
        value::check_range(raw, param).map_err(|error| bad(key, &error.text()))?;
        steps.push(job::Step { param: param.clone(), set: place(param), raw, kind: param.kind, at: None });
    }
    if let Some(param) = family.role(Role::PolePairs) {
        let raw = plate.pole_pairs;
        steps.push(job::Step { param: param.clone(), set: place(param), raw, kind: param.kind, at: None });
    }
    Ok((steps, unknown))
}

/// What stands on a nameplate, and its parameter where a catalogue has one.
const KEPT: [(&str, &str, Text); 6] = [
    ("speed", "rated-speed", Text::new("speed", "Drehzahl")),
    ("frequency", "rated-frequency", Text::new("frequency", "Frequenz")),
    ("power", "rated-mechanical-power", Text::new("power", "Leistung")),
    ("voltage", "rated-voltage", Text::new("voltage", "Spannung")),
    ("current", "rated-current", Text::new("current", "Strom")),
    ("cos-phi", "rated-cos-phi", Text::new("cos phi", "cos phi")),
];
