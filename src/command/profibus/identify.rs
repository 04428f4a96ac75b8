//! `identify` with PROFIBUS spoken: ident number, GSD, and what module and inverter tell of themselves.

use super::given::SlaveArgs;
use super::open;
use super::spoken::Spoken;
use super::taking::{question, whom};
use crate::command::{Context, asking};
use crate::drive::{profibus, summary};
use crate::failure::Failure;
use crate::outcome::{Data, Evidence, Identify, Identity, Outcome, Plan};
use crate::profile::{Family, Param};
use crate::text::{Text, both};

/// Identification (5.1), series (5.3), application and its version (5.4), inverter type (5.5 index 251), address by the switches (5.1).
const TOLD: [u32; 6] = [964, 624, 800, 801, 251, 918];

/// Tells what one slave is.
pub(in crate::command) async fn identify(slave: &SlaveArgs, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let whom = whom(slave, context)?;
    whom.with_pkw()?;
    let address = whom.address;
    if context.settings.dry_run {
        let notes = vec![both!(
            "station {address} is asked for Slave_Diag, taken (Set_Prm, PPO1), held by the stop word 047E, asked by PKW, and let go",
            "Station {address} wird nach Slave_Diag gefragt, übernommen (Set_Prm, PPO1), mit dem Stoppwort 047E gehalten, über PKW \
             gefragt und freigegeben"
        )];
        let telegrams = profibus::questions(Some(address));
        return Ok(Outcome::of(Data::Plan(Plan { dry_run: true, telegrams, notes })));
    }
    let why = both!("to identify it; nothing is written", "um sie zu erkennen; geschrieben wird nichts");
    let Context { settings, registry, interrupt, observe, ask, .. } = context;
    let permit = asking::off_line(interrupt, *ask, &question(address, &why, Some(Spoken::Profidrive))).await?;
    let mut line = open(slave.slot_time, (settings, registry), interrupt, *observe).await?;
    let (mut haul, mut family) = (profibus::Haul::default(), whom.presumed.clone());
    let mut exchange = whom.exchange(&mut line, &permit)?;
    let done = async {
        family = exchange.family(whom.named.clone(), registry).await?;
        for param in told(&family) {
            exchange.value(&family, &param, &mut haul).await?;
        }
        exchange.parting(&family).await
    };
    let done = done.await;
    let ident = exchange.ident();
    let left = exchange.leave().await;
    let model = whom.gsd.as_ref().map(|gsd| gsd.model.clone());
    let row = |asked: Text, answered: Text, tells: Text| Evidence { asked, answered, tells };
    let said = ident.map(|ident| {
        let tells = model.as_ref().map_or_else(
            || both!("ident number; no GSD was given", "Identnummer; keine GSD angegeben"),
            |model| both!("ident number of the GSD: {model}", "Identnummer der GSD: {model}"),
        );
        row(Text::name("Slave_Diag"), Text::name(format_args!("{ident:04X}h")), tells)
    });
    let series = match &whom.named {
        Some(_) => row(Text::name("--drive"), Text::name(&family.drive), both!("as given", "so angegeben")),
        None => row(Text::name("P.624"), Text::name(&family.drive), family.title.clone()),
    };
    let succeeded = haul.values.iter().filter(|value| value.error.is_none()).count();
    let evidence = said.into_iter().chain(done.is_ok().then_some(series)).collect();
    let title = registry.drives().into_iter().find(|drive| drive.id == family.drive);
    let drives = vec![Identity {
        node: 0,
        address,
        drive: if succeeded > 0 { family.drive.clone() } else { "unknown".to_owned() },
        title: title.map_or_else(Text::default, |drive| drive.title.clone()),
        product: model,
        evidence,
        modules: Vec::new(),
        values: haul.values,
        error: None,
    }];
    let warnings = left.warnings(done.as_ref().ok().cloned());
    let failure = left.failure.or(done.err()).or_else(|| summary(haul.failures, succeeded));
    Ok(Outcome { data: Some(Data::Identify(Identify { drives })), warnings, failure })
}

/// What is asked of a family: an array by its elements.
fn told(family: &Family) -> Vec<(Param, Option<u8>)> {
    let params = TOLD.iter().filter_map(|id| family.params.get(id));
    let each = |param: &Param| match param.elements {
        Some(count) => (1..=count).map(|element| (param.clone(), Some(element))).collect(),
        None => vec![(param.clone(), None)],
    };
    params.flat_map(each).collect()
}
