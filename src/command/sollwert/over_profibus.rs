//! `sollwert` with PROFIBUS spoken: a run that this program holds, or a stop.

use super::Args;
use super::told::begins_later;
use crate::command::profibus::job::{Action, Job, is_zero, wanted};
use crate::command::profibus::run::run as run_one;
use crate::command::profibus::spoken::{Choice, ramps};
use crate::command::{Context, profibus};
use crate::failure::{Class, Failure};
use crate::gate::Relief;
use crate::outcome::Outcome;
use crate::text::{Wrong, both};

pub(super) async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let keypad = &args.keypad;
    let another = both!(
        "the setpoint stands for the whole run: end it, and `antrieb sollwert 25Hz --enable --hold` gives another one",
        "der Sollwert gilt für den ganzen Lauf: ihn beenden; `antrieb sollwert 25Hz --enable --hold` gibt einen anderen"
    );
    let own_ramps = both!(
        "the inverter leads its own ramps: `antrieb write F002=5s F003=5s` sets them",
        "der Umrichter führt seine eigenen Rampen: `antrieb write F002=5s F003=5s` stellt sie"
    );
    let refused = [
        ("--ramp", args.ramp.is_some(), Some(own_ramps)),
        ("--profile", args.profile.is_some(), Some(another.clone())),
        ("--start", args.start.is_some(), None),
        ("--source", args.source.is_some(), None),
        ("--step", keypad.step.is_some(), Some(another)),
    ];
    for (option, is_given, hint) in refused {
        let refused = profibus::refuse(&[(option, is_given)]);
        refused.map_err(|failure| hint.map_or(failure.clone(), |hint| failure.hint(hint)))?;
    }
    let spoken = args.mode.as_deref().map(str::parse).transpose();
    let spoken = spoken.map_err(|Wrong(why)| Failure::new(Class::Usage, "usage.mode", why))?;
    let choice = Choice { spoken, ramps: ramps(&args.options)? };
    let Some(value) = &args.value else {
        let message = both!("expected a setpoint such as 20Hz, got none", "Sollwert fehlt, zum Beispiel 20Hz");
        return Err(Failure::new(Class::Usage, "usage.setpoint", message).hint(both!(
            "`antrieb --protocol dp read 700 701 611 614` shows setpoint and actual value",
            "`antrieb --protocol dp read 700 701 611 614` zeigt Soll- und Istwert"
        )));
    };
    let wanted = wanted(value)?;
    let mut motion = args.motion.clone();
    let enable = args.enable || args.jog.is_some();
    if args.jog.is_some() {
        (motion.hold, motion.duration) = (true, args.jog);
    }
    let action = match is_zero(wanted) && !enable {
        true => Action::Stop(Relief::Zero),
        false if enable => Action::Run(wanted),
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
        until: args.until.map(|_| begins_later()),
    };
    run_one(&job, context).await
}
