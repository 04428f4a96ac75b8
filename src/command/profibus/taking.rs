//! Taking a slave: whom, what is asked before, and what is known of it.

use super::addresses;
use super::given::SlaveArgs;
use crate::command::{Context, named_family};
use crate::drive::profibus::{Exchange, Line, WATCHDOG};
use crate::failure::{Class, Failure};
use crate::gate::{Hazard, Motion, Permit, Question};
use crate::profile::Family;
use crate::text::{Text, both};
use std::rc::Rc;

/// The family whose names hold as long as nobody has asked the inverter (P.624).
const PRESUMED: &str = "l200";

/// Whom to take.
pub(super) struct Whom<'s> {
    pub(super) address: u8,
    /// The family by whose names was typed.
    pub(super) presumed: Rc<Family>,
    /// The one that was named.
    pub(super) named: Option<Rc<Family>>,
    pub(super) slave: &'s SlaveArgs,
}

/// Whom the settings name: one slave.
pub(super) fn whom<'s>(slave: &'s SlaveArgs, context: &Context<'_>) -> Result<Whom<'s>, Failure> {
    let &[address] = &addresses(context.settings)?[..] else { return Err(one_address()) };
    let drive = context.settings.drive.as_deref();
    let presumed = named_family(context.settings, context.registry, drive.unwrap_or(PRESUMED))?;
    let named = drive.is_some().then(|| presumed.clone());
    Ok(Whom { address, presumed, named, slave })
}

impl Whom<'_> {
    /// Begins to exchange data with it.
    pub(super) fn exchange<'l, 'a>(&self, line: &'l mut Line<'a>, permit: &Permit<Motion>) -> Exchange<'l, 'a> {
        Exchange::new(line, self.address, self.slave.user(), WATCHDOG, permit)
    }
}

/// Refuses options that mean nothing on PROFIBUS.
pub(in crate::command) fn refuse(options: &[(&str, bool)]) -> Result<(), Failure> {
    let Some((option, _)) = options.iter().find(|(_, is_given)| *is_given) else { return Ok(()) };
    let message = both!("{option} means nothing over PROFIBUS-DP", "{option} bedeutet über PROFIBUS-DP nichts");
    Err(Failure::new(Class::Usage, "usage.profibus", message))
}

fn one_address() -> Failure {
    let message = both!(
        "one slave is taken at a time: expected one address",
        "es wird ein Slave auf einmal übernommen: erwartet wird eine Adresse"
    );
    Failure::new(Class::Usage, "usage.one_address", message)
        .hint(both!("`antrieb profibus live` finds it", "`antrieb profibus live` findet sie"))
}

/// To ask a slave for anything is to take it: whoever exchanges data with it commands it.
pub(super) fn question(address: u8, why: &Text) -> Question {
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
    ];
    let title = both!(
        "station {address} on PROFIBUS is taken over, {why}",
        "Station {address} am PROFIBUS wird übernommen, {why}",
        why
    );
    Question { hazards: vec![Hazard::Motion], title, details }
}
