//! What the search for the offset of a resolver goes by: the parameters that the manual names (EM-RES-03 6.4.1), and what was given.

use super::given::{Given, bad};
use super::nameplate::{number, whole};
use super::turning::{bounded, watchdog};
use crate::args::StopArg;
use crate::command::sollwert;
use crate::failure::{Class, Failure};
use crate::profile::{Family, Param, Role, value};
use crate::text::{Text, both};

/// The switch-off limit while it is sought, where none was given; and the highest that may be, in Hz.
const LIMIT: &str = "5Hz";
const HIGHEST: f64 = 10.0;
/// Share of the rated current that P.728 lets through meanwhile (EM-RES-03 manual 6.4.1).
const SHARE: f64 = 0.1;

/// The parameters that the manual names.
pub(super) struct Params {
    pub(super) resolver_pairs: Param,
    pub(super) motor_pairs: Param,
    pub(super) source: Param,
    pub(super) resolver: Param,
    pub(super) offset: Param,
    pub(super) voltage: Param,
    pub(super) limit: Param,
    pub(super) current: Param,
    pub(super) rated: Param,
    pub(super) stator: Param,
    pub(super) setpoint: Param,
}

impl Params {
    /// As a catalogue has them.
    ///
    /// # Errors
    /// It lacks one.
    pub(super) fn of(family: &Family) -> Result<Self, Failure> {
        let slug =
            |slug: &str| family.params.values().find(|param| param.slug == slug).cloned().ok_or_else(|| lacks(slug));
        let role = |role: Role| family.role(role).cloned().ok_or_else(|| lacks(role.name()));
        Ok(Params {
            resolver_pairs: slug("resolver-pole-pairs")?,
            motor_pairs: role(Role::PolePairs)?,
            source: slug("actual-speed-source")?,
            resolver: slug("encoder-2-frequency")?,
            offset: slug("resolver-offset")?,
            voltage: slug("flux-forming-voltage")?,
            limit: slug("frequency-switch-off-limit")?,
            current: slug("current-limit")?,
            rated: slug("rated-frequency")?,
            stator: role(Role::StatorFrequency)?,
            setpoint: role(Role::SetpointFrequency)?,
        })
    }
}

fn lacks(what: &str) -> Failure {
    let message = both!("the catalogue has no {what}", "der Katalog hat kein {what}");
    Failure::new(Class::Data, "data.procedure", message)
}

/// What was given for it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Aim {
    pub(super) resolver_pairs: i64,
    /// P.417 and P.728 while it is sought, raw.
    pub(super) limit: i64,
    pub(super) current: i64,
    /// The setpoint, raw.
    pub(super) setpoint: i64,
}

impl Aim {
    /// As it was given.
    ///
    /// # Errors
    /// A value is none, or too large.
    pub(super) fn of(given: &Given, params: &Params) -> Result<Self, Failure> {
        let text = given.get("limit").unwrap_or(LIMIT);
        let unfit = |why: Text| bad("limit", &why);
        let limit = value::parse(text, &params.setpoint, &[]).map_err(|error| unfit(error.text()))?;
        let decimals = params.setpoint.decimals_or_zero();
        let most = (HIGHEST * 10f64.powi(decimals.into())) as i64;
        if !(10..=most).contains(&limit) {
            return Err(unfit(both!(
                "a low frequency above 0 is needed, at most {HIGHEST} Hz; got '{text}'",
                "gebraucht wird eine kleine Frequenz über 0, höchstens {HIGHEST} Hz; angegeben: '{text}'"
            )));
        }
        fits(&params.limit, limit).map_err(|error| unfit(error.text()))?;
        let rated = number(given, "current", &["A"])?.unwrap_or_default();
        let current = rated * SHARE * 10f64.powi(current_decimals(params).into());
        let current = (current.round() as i64).max(1);
        fits(&params.current, current).map_err(|error| bad("current", &error.text()))?;
        let pairs = whole(given, "resolver-pairs")?.unwrap_or_default();
        value::check_range(pairs, &params.resolver_pairs).map_err(|error| bad("resolver-pairs", &error.text()))?;
        // About 10 % below the limit.
        Ok(Aim { resolver_pairs: pairs, limit, current, setpoint: limit * 9 / 10 })
    }
}

/// Range and width, as far as a source tells them.
pub(super) fn fits(param: &Param, raw: i64) -> Result<(), value::ValueError> {
    value::check_range(raw, param)?;
    param.kind.map_or(Ok(()), |kind| value::check_type(raw, kind, param))
}

/// The decimals of P.728: no manual prints them, and R.m.s. current P.211 has one.
pub(super) fn current_decimals(params: &Params) -> u8 {
    params.current.decimals.unwrap_or(1)
}

/// Refuses what cannot be sought, before anything is opened.
///
/// # Errors
/// A value that does not do.
pub(super) fn fit(given: &Given, family: &Family) -> Result<(), Failure> {
    Aim::of(given, &Params::of(family)?).map(|_| ())
}

/// What a try would run, for a dry run.
pub(super) fn rehearsed(given: &Given, family: &Family) -> Option<sollwert::Args> {
    let params = Params::of(family).ok()?;
    run(Aim::of(given, &params).ok()?.setpoint, &params, StopArg::Coast, given).ok()
}

/// A run that a try holds itself.
pub(super) fn run(raw: i64, params: &Params, stop: StopArg, given: &Given) -> Result<sollwert::Args, Failure> {
    let setpoint = format!("{}Hz", value::written(&params.setpoint, raw));
    Ok(sollwert::Args { until: None, ..sollwert::Args::run_at(&setpoint, bounded(stop, None, watchdog(given)?)) })
}
