//! The mode of a setpoint, where its unit tells it; and what is recommended where it does not.

use crate::failure::{Class, Failure};
use crate::profile::{Family, Mode, Registry, setpoint};
use crate::text::{Text, both};

/// The mode that the unit tells.
pub(super) fn unit_mode<'f>(text: &str, family: &'f Family) -> Result<&'f Mode, Text> {
    let modes = modes(family);
    setpoint::mode_of(family, text).ok_or_else(|| {
        // Nothing is recommended that this drive refuses.
        match EXAMPLES.iter().find(|example| setpoint::mode_of(family, example).is_some()) {
            Some(such) => both!(
                "expected a setpoint with its unit, such as {such}, or --mode ({modes}), got '{text}'",
                "erwartet: Sollwert mit Einheit, etwa {such}, oder --mode ({modes}); erhalten: '{text}'"
            ),
            None => both!(
                "expected --mode ({modes}) before the setpoint, because no unit tells it here; got '{text}'",
                "erwartet: --mode ({modes}) vor dem Sollwert, denn hier sagt es keine Einheit; erhalten: '{text}'"
            ),
        }
    })
}

/// Setpoints whose unit tells a mode, of one family or another.
const EXAMPLES: &[&str] = &["25Hz", "600rpm", "50%"];

/// The words of the modes of a family.
pub(super) fn modes(family: &Family) -> String {
    family.modes.iter().map(|mode| mode.slug.as_str()).collect::<Vec<_>>().join(", ")
}

/// No drive was asked, so its modes may be others than those of the usual one: the hint tells those of each.
pub(super) fn of_whom(failure: Failure, (is_named, typed): (bool, &str), registry: &Registry) -> Failure {
    if failure.class != Class::Usage
        || !["usage.mode", "usage.unit"].contains(&&*failure.code)
        || failure.hint.is_some()
        || is_named
    {
        return failure;
    }
    let families = registry.families().filter(|family| !family.modes.is_empty());
    let told = families.map(|family| format!("{}: {}", family.drive, modes(&family))).collect::<Vec<_>>().join("; ");
    let message = match failure.code.as_str() {
        "usage.mode" => both!("no family has a mode '{typed}'", "keine Familie hat eine Betriebsart '{typed}'"),
        _ => failure.message.clone(),
    };
    Failure { message, ..failure }.hint(both!(
        "no drive was asked yet; --mode takes, by the family: {told}",
        "noch wurde kein Antrieb gefragt; --mode nimmt, je nach Familie: {told}"
    ))
}
