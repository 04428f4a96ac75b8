//! Whether the drive's own bounds let every run of a procedure reach its setpoint: looked at before anything is written or turns.

use super::aim::{self, Aim, Params};
use super::guide::Guide;
use super::turning;
use crate::args::StopArg;
use crate::command::sollwert;
use crate::drive::Target;
use crate::drive::motion::working;
use crate::failure::Failure;
use crate::profile::procedure::Act;
use crate::text::both;

impl Guide<'_> {
    /// Refuses what the drive would refuse once the shaft has turned.
    pub(super) async fn fits_its_limits(&mut self) -> Result<(), Failure> {
        let steps = self.procedure.steps_of(&self.record.drive);
        let does = |act: Act| steps.iter().any(|step| step.act == act);
        let (ramps, seeks) = (does(Act::Ramp), does(Act::Offset));
        let mut target = self.known().await?;
        // No other test is as fast as the ramp.
        let mut runs: Vec<_> = turning::rehearsed(Act::Ramp, self.given).filter(|_| ramps).into_iter().collect();
        if seeks {
            runs.extend(self.tries(&mut target).await?);
        }
        for args in runs {
            let fits = sollwert::fits(&mut self.session, &mut target, &args).await;
            fits.map_err(|failure| match failure.code.as_str() {
                "data.range" => Failure { hint: None, ..failure }.hint(both!(
                    "raise that limit first, if motor and machine bear it; or begin anew with other values (--force)",
                    "zuerst diese Grenze anheben, wenn Motor und Maschine das aushalten; oder mit anderen Werten von vorn beginnen (--force)"
                )),
                _ => failure,
            })?;
        }
        Ok(())
    }

    /// The runs of the search: slow ones, and one at half of the rated frequency.
    async fn tries(&mut self, target: &mut Target) -> Result<Vec<sollwert::Args>, Failure> {
        let params = Params::of(&target.family)?;
        let slow = Aim::of(self.given, &params)?.setpoint;
        let rated = working(&mut self.session, target, &params.rated).await?;
        let raws = [slow].into_iter().chain(rated.map(|rated| rated / 2));
        raws.map(|raw| aim::run(raw, &params, StopArg::Coast, self.given)).collect()
    }
}
