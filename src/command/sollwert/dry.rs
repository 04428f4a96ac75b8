//! `sollwert --dry-run`: every telegram that would go out.

use super::wanted::{Spoken, Wanted, understand};
use super::{Args, in_hertz, zero};
use crate::args::Settings;
use crate::command::rehearse::Rehearsal;
use crate::command::{Context, offline, running};
use crate::failure::{Class, Failure};
use crate::outcome::Outcome;
use crate::profile::Family;
use crate::text::both;

/// What a run would send, in the order of [`carry_out`].
pub(super) fn run(
    args: &Args,
    spoken: &Spoken,
    (family, wanted): (&Family, &Wanted),
    context: &Context<'_>,
) -> Result<Outcome, Failure> {
    if wanted.by_speed {
        let message = both!(
            "a speed needs the drive's pole pairs (P.373), and a dry run asks no drive",
            "eine Drehzahl braucht die Polpaarzahl des Antriebs (P.373), und ein Probelauf fragt keinen Antrieb"
        );
        return Err(Failure::new(Class::Usage, "usage.dry_run", message).hint(in_hertz()));
    }
    let several = running::several(context.settings).filter(|addresses| !addresses.contains(&0));
    if several.is_none_or(|_| !zero::is_meant(args, wanted)) {
        let address = running::single_address(context)?;
        return Ok(one(args, family, wanted, (context.settings, address))?.told());
    }
    let mut told = Vec::new();
    for line in running::lines(context.settings) {
        let (family, wanted) = offline(line, context.registry, |family| understand(args, spoken, family))?;
        for &address in line.addresses.named() {
            told.push(one(args, &family, &wanted, (line, address))?.planned());
        }
    }
    Ok(Rehearsal::of_all(context.settings, told))
}

pub(super) fn one<'r>(
    args: &Args,
    family: &'r Family,
    wanted: &Wanted,
    (settings, address): (&Settings, u8),
) -> Result<Rehearsal<'r>, Failure> {
    let enable = args.enable || args.jog.is_some();
    let mut motion = args.motion.clone();
    motion.hold |= args.jog.is_some();
    let mut told = match zero::goes_first(args, wanted) {
        true => Rehearsal::zeroing(settings, family, address, &wanted.param, wanted.mode.source.is_some()),
        false => Rehearsal::new(settings, family, address),
    };
    told.bounds(&motion, enable)?;
    wanted.settings.iter().for_each(|(param, raw)| told.change(param, *raw));
    if wanted.mode.zero && (enable || wanted.mode.value.is_some()) {
        told.write(&wanted.param, 0, 0);
    }
    if enable {
        told.walk("operation-enabled");
    }
    if let (Some(value), Some(param)) = (wanted.mode.value, family.role("mode")) {
        told.write(param, 0, value);
        family.role("mode-active").into_iter().for_each(|param| told.read(param, 0));
    }
    wanted.mode.engage.iter().for_each(|preset| told.write(&family.param_or_unknown(preset.param), 0, preset.value));
    wanted.denominator.iter().for_each(|(param, raw)| told.change(param, *raw));
    if motion.hold && !wanted.mode.zero {
        told.given_back(&wanted.param);
    }
    // What stays as it is, is given once.
    let mut given = None;
    wanted
        .schedule
        .values()
        .filter(|&raw| given.replace(raw) != Some(raw))
        .for_each(|raw| told.write(&wanted.param, 0, raw));
    if let Some(start) = &wanted.start {
        told.control(start.word);
        told.command("enable");
    }
    told.end(&motion, Some(&wanted.param).filter(|_| wanted.mode.zero_stops()), zero::is_aim(args, wanted));
    Ok(told)
}
