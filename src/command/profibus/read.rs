//! Parameters of an inverter over PKW, with us as the master of its slave: `profibus read`, and `read --protocol dp`.

use super::given::{SlaveArgs, params};
use super::open;
use super::spoken::Spoken;
use super::taking::{question, whom};
use crate::command::{Context, asking};
use crate::drive::{profibus, summary};
use crate::failure::Failure;
use crate::outcome::{Data, Outcome, Plan, Read};
use crate::text::both;

/// Reads the parameters of one inverter.
pub(in crate::command) async fn read(
    typed: &[String],
    slave: &SlaveArgs,
    context: &mut Context<'_>,
) -> Result<Outcome, Failure> {
    let whom = whom(slave, context)?;
    whom.with_pkw()?;
    let presumed = params(typed, &whom.presumed)?;
    let (address, count) = (whom.address, presumed.len());
    let is_lock = presumed.iter().all(|(param, _)| param.id == profibus::UNLOCKS);
    if context.settings.dry_run {
        let notes = vec![both!(
            "station {address} is taken (Set_Prm, PPO1) and held by the stop word 047E; {count} parameter(s) are asked for by PKW; \
             then zero outputs, Clear, Unlock",
            "Station {address} wird übernommen (Set_Prm, PPO1) und mit dem Stoppwort 047E gehalten; {count} Parameter werden über \
             PKW gelesen; dann Ausgänge auf null, Clear, Unlock"
        )];
        return Ok(Outcome::of(Data::Plan(Plan { dry_run: true, telegrams: Vec::new(), notes })));
    }
    let why =
        both!("to read its parameters; nothing is written", "um ihre Parameter zu lesen; geschrieben wird nichts");
    let Context { settings, registry, interrupt, observe, ask, .. } = context;
    let permit = asking::off_line(interrupt, *ask, &question(address, &why, Some(Spoken::Profidrive))).await?;
    let mut line = open(slave.slot_time, (settings, registry), interrupt, *observe).await?;
    let mut haul = profibus::Haul::default();
    let mut exchange = whom.exchange(&mut line, &permit)?;
    let done = async {
        let family = whom.family(&mut exchange, registry, is_lock).await?;
        for param in params(typed, &family)? {
            exchange.value(&family, &param, &mut haul).await?;
        }
        exchange.parting(&family).await
    };
    let done = done.await;
    let left = exchange.leave().await;
    let warnings = left.warnings(done.as_ref().ok().cloned());
    let succeeded = haul.values.iter().filter(|value| value.error.is_none()).count();
    // What ended it counts before what is missing, and a slave that was not let go before both.
    let failure = left.failure.or(done.err()).or_else(|| summary(haul.failures, succeeded));
    Ok(Outcome { data: Some(Data::Read(Read { values: haul.values })), warnings, failure })
}
