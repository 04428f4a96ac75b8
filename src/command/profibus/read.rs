//! `profibus read`: parameters of an inverter over PKW, with us as the master of its slave.

use super::{addresses, open};
use crate::command::read::select_failure;
use crate::command::{Context, asking, check_number, named_family};
use crate::drive::{profibus, summary};
use crate::failure::{Class, Failure};
use crate::gate::{Hazard, Motion, Permit, Question};
use crate::outcome::{Data, Outcome, Plan, Read, Warning};
use crate::profile::{Family, Param, Selector};
use crate::text::{Text, both};
use crate::tick::Span;

/// What is to be read.
pub(super) struct Wanted<'w> {
    pub(super) parameters: &'w [String],
    pub(super) user: &'w [u8],
    pub(super) slot_time: Option<Span>,
}

/// The family whose names hold as long as nobody has asked the inverter (P.624).
const PRESUMED: &str = "l200";

/// Reads the parameters of one inverter.
pub(super) async fn read(wanted: Wanted<'_>, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let &[address] = &addresses(context.settings)?[..] else { return Err(one_address()) };
    let selectors: Result<Vec<Selector>, Failure> =
        wanted.parameters.iter().map(|text| text.parse().map_err(|error| select_failure(&error))).collect();
    let selectors = selectors?;
    let drive = context.settings.drive.as_deref();
    let presumed = named_family(context.settings, context.registry, drive.unwrap_or(PRESUMED))?;
    let count = params(&selectors, &presumed)?.len();
    if context.settings.dry_run {
        let notes = vec![both!(
            "station {address} is taken (Set_Prm, PPO1) and held by the stop word 047E; {count} parameter(s) are asked for by PKW; \
             then zero outputs, Clear, Unlock",
            "Station {address} wird übernommen (Set_Prm, PPO1) und mit dem Stoppwort 047E gehalten; {count} Parameter werden über \
             PKW gelesen; dann Ausgänge auf null, Clear, Unlock"
        )];
        return Ok(Outcome::of(Data::Plan(Plan { dry_run: true, telegrams: Vec::new(), notes })));
    }
    let permit: Permit<Motion> = asking::off_line(&context.interrupt, context.ask, &question(address)).await?;
    let named = drive.is_some().then(|| presumed.clone());
    let registry = context.registry;
    let mut line = open(wanted.slot_time, context).await?;
    let mut haul = profibus::Haul::default();
    let mut exchange = profibus::Exchange::new(&mut line, address, wanted.user.to_vec(), &permit);
    let done = async {
        let family = exchange.family(named, registry).await?;
        for param in params(&selectors, &family)? {
            exchange.value(&family, &param, &mut haul).await?;
        }
        exchange.parting(&family).await
    };
    let done = done.await;
    let left = exchange.leave().await;
    let told = done.as_ref().ok().cloned();
    let warnings = told.map(|message| Warning { code: "profibus.let_go".to_owned(), message }).into_iter().collect();
    let succeeded = haul.values.iter().filter(|value| value.error.is_none()).count();
    // What ended it counts before what is missing, and a slave that was not let go before both.
    let failure = left.err().or(done.err()).or_else(|| summary(haul.failures, succeeded));
    Ok(Outcome { data: Some(Data::Read(Read { values: haul.values })), warnings, failure })
}

fn params(selectors: &[Selector], family: &Family) -> Result<Vec<Param>, Failure> {
    let mut params = Vec::new();
    for selector in selectors {
        let found = selector.resolve(family).map_err(|error| select_failure(&error))?;
        params.extend(found.into_iter().map(|selection| selection.param).filter(|param| param.access.reads()));
    }
    params.iter().try_for_each(|param| check_number(family, param))?;
    Ok(params)
}

fn one_address() -> Failure {
    let message = both!(
        "one slave is taken at a time: expected one address",
        "es wird ein Slave auf einmal übernommen: erwartet wird eine Adresse"
    );
    Failure::new(Class::Usage, "usage.one_address", message)
        .hint(both!("`antrieb profibus live` finds it", "`antrieb profibus live` findet sie"))
}

/// To read is to take the slave: whoever exchanges data with it commands it.
fn question(address: u8) -> Question {
    let details: Vec<Text> = vec![
        both!(
            "an SJ2-PB tells its parameters only to a master that exchanges data with it, and such a master commands the motor",
            "ein SJ2-PB nennt seine Parameter nur einem Master, der mit ihm Daten austauscht, und ein solcher Master befiehlt dem \
             Motor"
        ),
        both!(
            "meanwhile it gets the stop word 047E: where P.928 is 1, a motor that is running stops by its ramp",
            "solange bekommt es das Stoppwort 047E: wo P.928 gleich 1 ist, hält ein laufender Motor an der Rampe an"
        ),
        both!(
            "afterwards it is let go: P.703 says what happens then, and where A002 lets the terminals start, a closed contact starts \
             the motor",
            "danach wird es freigegeben: was dann geschieht, sagt P.703, und wo A002 die Klemmen starten lässt, startet ein \
             geschlossener Kontakt den Motor"
        ),
        both!("nothing is written to a parameter", "in keinen Parameter wird geschrieben"),
    ];
    let title = both!(
        "station {address} on PROFIBUS is taken over, to read its parameters",
        "Station {address} am PROFIBUS wird übernommen, um ihre Parameter zu lesen"
    );
    Question { hazards: vec![Hazard::Motion], title, details }
}
