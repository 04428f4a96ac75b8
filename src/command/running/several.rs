//! A stop of several drives: each hears it before any of them is looked at.

use super::{Around, Plan, on_drive, stop_first};
use crate::command::{Context, connect};
use crate::drive::motion::Motor;
use crate::drive::summary;
use crate::failure::Failure;
use crate::gate::Relief;
use crate::outcome::{Data, ErrorDoc, Outcome, Stopped, Stops};
use crate::text::{Text, both};

/// Says `act` to every drive, then proves it of one after the other. `plan`: that of one, which can do nothing else.
///
/// Fails only where the line cannot be opened: what is not proven stands beside its drive. A drive whose turn comes when it has
/// lost its power already shows no standstill any more (its stator tells nothing then), and that is said.
pub(in crate::command) async fn stop_each<'p>(
    context: &mut Context<'_>,
    addresses: &[u8],
    act: Relief,
    plan: impl Fn() -> Plan<'p>,
) -> Result<Outcome, Failure> {
    let Context { settings, registry, interrupt, observe, ask } = context;
    interrupt.hear_only_keys();
    let mut session = connect(settings, registry, interrupt, *observe).await?;
    let said = stop_first(&mut session, (settings, registry), addresses, act, None).await?;
    let mut around = Around { settings, registry, interrupt, ask: *ask };
    let (mut drives, mut failures, mut succeeded) = (Vec::new(), Vec::new(), 0);
    for (&address, first) in addresses.iter().zip(said) {
        let outcome = match first {
            Ok((said, first_word)) => {
                let plan = Plan { said, ..plan() };
                let work = async |motor: &mut Motor<'_, '_>, ()| motor.relieve(act).await;
                on_drive(&mut session, &mut around, (address, first_word), plan, async |_, _, _, _| Ok(()), work).await
            }
            Err(failure) => Err(failure),
        };
        let (motion, failure) = match outcome {
            Ok(Outcome { data: Some(Data::Motion(motion)), failure, .. }) => (Some(motion), failure),
            Ok(Outcome { failure, .. }) => (None, failure),
            Err(failure) => (None, Some(failure)),
        };
        drives.push(Stopped { address, motion, error: failure.as_ref().map(ErrorDoc::from) });
        match failure {
            Some(failure) => failures.push((address, failure)),
            None => succeeded += 1,
        }
    }
    let failure = told(failures, succeeded);
    Ok(Outcome { data: Some(Data::Stops(Stops { drives })), warnings: Vec::new(), failure })
}

/// Names every drive that is not proven to stand; who reads only the last line must not miss one.
fn told(failures: Vec<(u8, Failure)>, succeeded: usize) -> Option<Failure> {
    let named = |(address, failure): &(u8, Failure)| {
        both!("address {address}: {why}", "Adresse {address}: {why}", address, why = failure.message)
    };
    let message = Text::join(&failures.iter().map(named).collect::<Vec<_>>(), "; ");
    let addresses = failures.iter().map(|(address, _)| address.to_string()).collect::<Vec<_>>().join(", ");
    let failures = failures.into_iter().map(|(_, failure)| failure).collect();
    summary(failures, succeeded).map(|failure| Failure { message, ..failure }.with("addresses", addresses))
}
