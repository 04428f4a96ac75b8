//! `sollwert` with PROFIBUS spoken: a run that this program holds and leads, or a stop.

use super::Args;
use super::told::begins_later;
use super::wanted::{Spoken, spoken, way};
use crate::command::profibus::job::{Action, Job, run_on, wanted};
use crate::command::profibus::run::run as run_one;
use crate::command::profibus::spoken::{Choice, ramps};
use crate::command::running::keys::{Keys, bad, other_unit};
use crate::command::running::leads::Way;
use crate::command::{Context, profibus};
use crate::drive::profibus::Wanted;
use crate::failure::{Class, Failure};
use crate::gate::Relief;
use crate::outcome::Outcome;
use crate::text::{Wrong, both};

pub(super) async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    profibus::refuse(&[("--start", args.start.is_some()), ("--source", args.source.is_some())])?;
    let mode = args.mode.as_deref().map(str::parse).transpose();
    let mode = mode.map_err(|Wrong(why)| Failure::new(Class::Usage, "usage.mode", why))?;
    let choice = Choice { spoken: mode, ramps: ramps(&args.options)? };
    // Here --mode says how the slave is led, and is no setpoint.
    let said = spoken(&Args { mode: None, ..args.clone() })?;
    let Some(said) = said else {
        let message = both!("expected a setpoint such as 20Hz, got none", "Sollwert fehlt, zum Beispiel 20Hz");
        return Err(Failure::new(Class::Usage, "usage.setpoint", message).hint(both!(
            "`antrieb --protocol dp read 700 701 611 614` shows setpoint and actual value",
            "`antrieb --protocol dp read 700 701 611 614` zeigt Soll- und Istwert"
        )));
    };
    let (first, way) = understand(args, &said)?;
    let mut motion = args.motion.clone();
    let enable = args.enable || args.jog.is_some();
    if args.jog.is_some() {
        (motion.hold, motion.duration) = (true, args.jog);
    }
    let is_zero = args.value.is_some() && way.schedule.values().all(|value| value == 0);
    let action = match is_zero && !enable {
        true => Action::Stop(Relief::Zero),
        false if enable => run_on(first, &way)?,
        false => {
            let message = both!(
                "over PROFIBUS a setpoint alone turns nothing: the slave is held by a stop word before and behind it",
                "am PROFIBUS dreht ein Sollwert allein nichts: davor und danach hält ein Stoppwort den Slave"
            );
            return Err(Failure::new(Class::Usage, "usage.enable", message)
                .hint(both!("add --enable --hold", "--enable --hold angeben")));
        }
    };
    if matches!(action, Action::Stop(_)) {
        motion = motion.of_a_stop();
    }
    let job = Job {
        action,
        word: "sollwert",
        motion: &motion,
        slave: &args.slave,
        choice,
        way: Some(way),
        until: args.until.map(|_| begins_later()),
    };
    run_one(&job, context).await
}

/// The first setpoint with its unit, where it goes, and what the arrows do there.
fn understand(args: &Args, said: &Spoken) -> Result<(Wanted, Way), Failure> {
    let parse = |text: &str| wanted(text).map(|wanted| (wanted.value(), wanted.at(0)));
    let (schedule, unit) = way(said, parse)?;
    let raw = |flag: &str, text: &str| {
        let value = wanted(text).map_err(|why| bad(both!("{flag}: {why}", "{flag}: {why}", why = why.message)))?;
        (value.at(0) == unit).then_some(value.value()).ok_or_else(|| other_unit(flag, text))
    };
    let keys = Keys::of(&args.keypad, raw, &schedule, args.motion.wants_keys())?;
    Ok((unit.at(schedule.at(0)), Way { schedule, keys }))
}
