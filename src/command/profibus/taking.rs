//! Taking a slave: whom, what is asked before, and what is known of it.

use super::addresses;
use super::given::SlaveArgs;
use super::spoken::{Choice, Spoken};
use crate::command::{Context, named_family};
use crate::drive::profibus::{
    Exchange, Gsd, LOCKED, Line, Mode, OTHER_SERIES, Taking, WATCHDOG, basic_block, described, of_gsd,
};
use crate::failure::{Class, Failure};
use crate::gate::{Hazard, Motion, Permit, Question};
use crate::outcome::Event;
use crate::profile::{Family, Registry};
use crate::text::{Text, both};
use crate::tick::Span;
use std::rc::Rc;

/// The family whose names hold as long as nobody has asked the inverter (P.624).
pub const PRESUMED: &str = "l200";

/// Whom to take.
pub(super) struct Whom<'s> {
    pub(super) address: u8,
    /// The family by whose names was typed.
    pub(super) presumed: Rc<Family>,
    /// The one that was named.
    pub(super) named: Option<Rc<Family>>,
    pub(super) slave: &'s SlaveArgs,
    /// Its GSD, if one was given.
    pub(super) gsd: Option<Gsd>,
}

/// Whom the settings name: one slave.
pub(super) fn whom<'s>(slave: &'s SlaveArgs, context: &Context<'_>) -> Result<Whom<'s>, Failure> {
    let &[address] = &addresses(context.settings)?[..] else { return Err(one_address()) };
    let drive = context.settings.drive.as_deref();
    let presumed = named_family(context.settings, context.registry, drive.unwrap_or(PRESUMED))?;
    let named = drive.is_some().then(|| presumed.clone());
    let gsd = slave.gsd.as_deref().map(described).transpose()?;
    Ok(Whom { address, presumed, named, slave, gsd })
}

impl Whom<'_> {
    /// The family of the inverter. Where everything but P.927 is locked nothing tells it, and it may be another one than was named: whoever only
    /// stops or resets it does without.
    pub(super) async fn family(
        &self,
        exchange: &mut Exchange<'_, '_>,
        registry: &Registry,
        does_without: bool,
    ) -> Result<Rc<Family>, Failure> {
        match exchange.family(self.named.clone(), registry).await {
            Err(failure) if does_without && [LOCKED, OTHER_SERIES].contains(&&*failure.code) => {
                let hint = failure.hint.as_deref().cloned().unwrap_or_default();
                exchange.tell(Event::Note(Text::join([&failure.message, &hint], "; ")));
                Ok(self.presumed.clone())
            }
            told => told,
        }
    }

    /// Begins to exchange data with it for its parameters, which ProfiDrive mode alone has.
    pub(super) fn exchange<'l, 'a>(
        &self,
        line: &'l mut Line<'a>,
        permit: &Permit<Motion>,
    ) -> Result<Exchange<'l, 'a>, Failure> {
        Ok(Exchange::new(line, self.address, self.taken(self.with_pkw()?, WATCHDOG)?, permit))
    }

    /// The mode for its parameters: PPO1, or what was named and has them. Further words are no use for that, and may be mapped.
    pub(super) fn with_pkw(&self) -> Result<Mode, Failure> {
        let mode = self.planned(Choice::default());
        if mode.has_pkw() && mode.further() == 0 {
            return Ok(mode);
        }
        let message = both!("parameters go by PKW, in PPO1", "Parameter gehen über PKW, in PPO1");
        Err(Failure::new(Class::Usage, "usage.cfg", message)
            .hint(both!("leave --cfg out, or --cfg ppo1", "--cfg weglassen, oder --cfg ppo1")))
    }

    /// How it is taken in a mode, with what its GSD says, or what was typed.
    pub(super) fn taken(&self, mode: Mode, watchdog: Span) -> Result<Taking, Failure> {
        let user = match (&self.gsd, mode) {
            (Some(gsd), _) => of_gsd(gsd, mode, self.series().as_deref())?,
            (None, Mode::Basic(_)) => self.block().unwrap_or_default(),
            (None, Mode::Profidrive(_)) => self.slave.user(),
        };
        Ok(Taking { mode, user, watchdog, ident: self.gsd.as_ref().map(|gsd| gsd.ident) })
    }

    /// User parameters of the Basic block: those that were given, or the block of the series that was named.
    pub(super) fn block(&self) -> Option<Vec<u8>> {
        let given = Some(self.slave.user()).filter(|user| !user.is_empty());
        given.or_else(|| self.series())
    }

    fn series(&self) -> Option<Vec<u8>> {
        basic_block(&self.named.as_ref()?.drive)
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

/// To ask a slave for anything is to take it: whoever exchanges data with it commands it. `spoken` is the mode, if it is known.
pub(super) fn question(address: u8, why: &Text, spoken: Option<Spoken>) -> Question {
    let profidrive = || {
        both!(
            "meanwhile it gets the stop word 047E: where P.928 is 1, a motor that is running stops by its ramp",
            "solange bekommt es das Stoppwort 047E: wo P.928 gleich 1 ist, hält ein laufender Motor an der Rampe an"
        )
    };
    let basic = || {
        both!(
            "in Basic mode it gets 0050: start and setpoint come from the bus, and a motor that is running stops, by a ramp of 10 s to \
             the maximum frequency unless --set F003 names another",
            "im Basic-Modus bekommt es 0050: Start und Sollwert kommen vom Bus, und ein laufender Motor hält an, an einer Rampe von 10 s \
             bis zur Maximalfrequenz, wenn --set F003 keine andere nennt"
        )
    };
    let is_known = spoken == Some(Spoken::Profidrive);
    let details = [
        Some(master(is_known)),
        (spoken != Some(Spoken::Basic)).then(profidrive),
        (!is_known).then(basic),
        Some(parting(is_known)),
    ];
    let details = details.into_iter().flatten().collect();
    let title = both!(
        "station {address} on PROFIBUS is taken over, {why}",
        "Station {address} am PROFIBUS wird übernommen, {why}",
        why
    );
    Question { hazards: vec![Hazard::Motion], title, details }
}

/// Why a slave has to be taken; `is_profidrive` where nothing else is possible.
fn master(is_profidrive: bool) -> Text {
    if is_profidrive {
        return both!(
            "an SJ2-PB tells its parameters only to a master that exchanges data with it, and such a master commands the motor",
            "ein SJ2-PB nennt seine Parameter nur einem Master, der mit ihm Daten austauscht, und ein solcher Master befiehlt dem \
             Motor"
        );
    }
    both!(
        "an SJ2-PB tells of its motor only to a master that exchanges data with it, and such a master commands the motor",
        "ein SJ2-PB berichtet von seinem Motor nur einem Master, der mit ihm Daten austauscht, und ein solcher Master befiehlt dem \
         Motor"
    )
}

fn parting(is_profidrive: bool) -> Text {
    let lost = if is_profidrive { Text::name("P.703") } else { both!("P.703 (Basic: P.620)", "P.703 (Basic: P.620)") };
    both!(
        "afterwards it is let go: {lost} says what happens then, and where A002 lets the terminals start, a closed contact starts \
         the motor",
        "danach wird es freigegeben: was dann geschieht, sagt {lost}, und wo A002 die Klemmen starten lässt, startet ein \
         geschlossener Kontakt den Motor",
        lost
    )
}
