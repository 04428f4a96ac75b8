//! `scan`: who is on the line?

use super::{Context, connect};
use crate::args::Addresses;
use crate::drive::{ScanPlan, open_port, scan};
use crate::failure::{Class, Failure};
use crate::outcome::{Data, Outcome, Plan, Scan, Warning};
use clap::Args as ClapArgs;

/// Finds every drive on a line with a known setting.
///
/// Asks address after address (1-247, or those given with -a) for its status word and recognises the family from what
/// comes back. Nothing in a drive is changed. Other Modbus devices are listed as unknown, with what they answered.
/// Ctrl-C ends the search and shows what was found so far.
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {}

/// Searches the line.
pub async fn run(_args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let Context { settings, registry, interrupt, observe, .. } = context;
    let addresses = match &settings.addresses {
        Addresses::Named(list) if list.contains(&0) => {
            let message = "address 0 is everybody and nobody answers it; expected addresses from 1 to 247";
            return Err(Failure::new(Class::Usage, "usage.broadcast_read", message));
        }
        Addresses::Named(list) => list.clone(),
        Addresses::Unnamed => (1..=crate::drive::LAST_STATION).collect(),
    };
    if settings.dry_run {
        let family = super::offline_family(settings, registry)?;
        let reader = super::telegram_reader(settings, &family);
        let probe = crate::drive::probe_question();
        let telegrams = addresses.iter().map(|&address| reader.question(address, probe)).collect();
        return Ok(Outcome::of(Data::Plan(Plan { dry_run: true, telegrams })));
    }
    let port = open_port(settings.port.as_ref(), settings.lang, *observe)?;
    let mut session = connect(settings, registry, interrupt, *observe)?;
    let plan = ScanPlan { addresses, lang: settings.lang };
    let found = scan(&mut session, &plan, registry).await;
    let complete = found.cut.is_none();
    let warnings = found
        .garbled
        .iter()
        .map(|address| Warning {
            code: "scan.garbage".to_owned(),
            message: format!(
                "address {address}: only garbage came; another baud rate or parity, or two devices with this address"
            ),
        })
        .collect();
    let none = Failure::new(Class::No, "no.drive_found", "no drive answered").hint(
        "check baud rate, parity and protocol (a drive leaves the factory speaking VABus, P.395 = 0), whether A and B \
         are swapped, and termination",
    );
    let failure = match &found.cut {
        Some(error) => {
            let mut failure = error.failure(0, None, settings.lang);
            failure.message =
                format!("{}; {} of {} addresses were asked", failure.message, found.asked, plan.addresses.len());
            failure.context.clear();
            Some(failure)
        }
        None => found.drives.is_empty().then_some(none),
    };
    let data = Scan {
        port: port.to_string(),
        line: settings.line.to_string(),
        protocol: settings.framing.name(),
        addresses: plan.addresses.len(),
        asked: found.asked,
        complete,
        drives: found.drives,
    };
    Ok(Outcome { data: Some(Data::Scan(data)), warnings, failure })
}
