//! In which mode a slave is taken: as it was typed, else as the slave says that it is configured, else PPO1.

use super::spoken::{Choice, Spoken};
use super::taking::Whom;
use crate::drive::profibus::{self, Course, Line, Mode, Taking, WATCHDOG, configured};
use crate::failure::{Class, Failure};
use crate::gate::{Motion, Permit};
use crate::outcome::{Data, Event, Outcome, Plan};
use crate::text::{Text, both};
use crate::tick::Span;

impl Whom<'_> {
    /// Refuses what needs no slave to be known as wrong.
    pub(super) fn knows(&self, choice: Choice) -> Result<(), Failure> {
        match choice.spoken {
            _ if self.slave.cfg.is_some() && self.contradicts(choice) => Err(contradicts()),
            None if self.slave.cfg.is_some() => self.is_leadable(self.planned(choice)),
            Some(Spoken::Basic) if self.gsd.is_none() => self.block().map(|_| ()).ok_or_else(no_series),
            Some(Spoken::Profidrive) if choice.ramps.is_some() => Err(no_ramps()),
            Some(spoken) => self.taken(mode(choice, spoken == Spoken::Basic), WATCHDOG).map(|_| ()),
            None => Ok(()),
        }
    }

    /// How the slave is taken. Says which mode it is, and why. A stop is led on by nobody's interrupt.
    pub(super) async fn taking(
        &self,
        line: &mut Line<'_>,
        choice: Choice,
        (watchdog, is_stop): (Span, bool),
        permit: &Permit<Motion>,
    ) -> Result<Taking, Failure> {
        let planned = self.planned(choice);
        let (is_basic, why) = match choice.spoken {
            _ if self.slave.cfg.is_some() => (planned.is_basic(), Text::name("--cfg")),
            Some(spoken) => (spoken == Spoken::Basic, Text::name("--mode")),
            None => told(configured(line, self.address, is_stop).await?, self.gsd.is_some() || self.block().is_some()),
        };
        if !is_basic && choice.ramps.is_some() {
            return Err(no_ramps());
        }
        let mode = match self.slave.cfg {
            // A stop needs no further words, and waits for no look at what is mapped to them.
            Some(_) if is_stop && planned.further() > 0 => Mode::PPO1,
            Some(_) => planned,
            None => mode(choice, is_basic),
        };
        let address = self.address;
        let name = if is_basic { mode.name() } else { format!("ProfiDrive ({})", mode.name()) };
        line.tell(Event::Note(both!(
            "station {address}: mode {name}: {why}",
            "Station {address}: Modus {name}: {why}",
            why
        )));
        if mode.further() > 0 {
            let first = self.taken(Mode::PPO1, watchdog)?;
            profibus::unmapped(line, self.address, (first, mode.further()), permit).await?;
        }
        self.taken(mode, watchdog)
    }

    /// The mode for a plan, where no slave is asked.
    pub(super) fn planned(&self, choice: Choice) -> Mode {
        let ramps = choice.ramps.unwrap_or_default();
        self.slave.cfg.map_or_else(|| mode(choice, choice.spoken == Some(Spoken::Basic)), |cfg| Mode::of(cfg, ramps))
    }

    fn contradicts(&self, choice: Choice) -> bool {
        choice.spoken.is_some_and(|spoken| self.planned(choice).is_basic() != (spoken == Spoken::Basic))
    }

    /// Whether all is known that a configuration needs.
    fn is_leadable(&self, mode: Mode) -> Result<(), Failure> {
        if mode.is_basic() && self.gsd.is_none() {
            return self.block().map(|_| ()).ok_or_else(no_series);
        }
        self.taken(mode, WATCHDOG).map(|_| ())
    }
}

fn contradicts() -> Failure {
    let message = both!("--mode and --cfg name different modes", "--mode und --cfg nennen verschiedene Modi");
    Failure::new(Class::Usage, "usage.cfg", message)
}

/// Whether Get_Cfg has told the Basic block, and it may be taken.
fn told(found: Option<(String, bool)>, has_series: bool) -> (bool, Text) {
    match found {
        Some((bytes, true)) if !has_series => (
            false,
            both!(
                "Get_Cfg tells {bytes}, the Basic block, but not which series (--drive)",
                "Get_Cfg nennt {bytes}, den Basic-Block, aber nicht die Serie (--drive)"
            ),
        ),
        Some((bytes, is_basic)) => (is_basic, both!("Get_Cfg tells {bytes}", "Get_Cfg nennt {bytes}")),
        None => (false, both!("Get_Cfg tells nothing", "Get_Cfg nennt nichts")),
    }
}

fn no_series() -> Failure {
    let message = both!(
        "--mode basic names the inverter in Set_Prm, and nothing tells which it is",
        "--mode basic nennt in Set_Prm den Umrichter, und nichts sagt, welcher es ist"
    );
    Failure::new(Class::Usage, "usage.series", message).hint(both!(
        "--drive l200, sj200 or x200; or --gsd, or --user-prm with its bytes",
        "--drive l200, sj200 oder x200; oder --gsd, oder --user-prm mit deren Bytes"
    ))
}

fn no_ramps() -> Failure {
    let message = both!(
        "--set: in ProfiDrive mode ramps are parameters of the inverter",
        "--set: im ProfiDrive-Modus sind Rampen Parameter des Umrichters"
    );
    Failure::new(Class::Usage, "usage.ramps", message).hint(both!(
        "`antrieb --protocol dp write F002=5s F003=5s`, or --mode basic",
        "`antrieb --protocol dp write F002=5s F003=5s`, oder --mode basic"
    ))
}

/// The plan of a slave that is only held while it is looked at.
pub(super) fn held(whom: &Whom<'_>, choice: Choice) -> Outcome {
    let (address, mode) = (whom.address, whom.planned(choice));
    let words = profibus::words(Course::Stop(false), mode).into_iter();
    let telegrams = words.map(|words| profibus::cyclic(address, words, mode, &whom.presumed)).collect();
    let notes = vec![both!(
        "station {address} is asked for Slave_Diag, taken (Set_Prm, Chk_Cfg), held by the stop word, asked, and let go",
        "Station {address} wird nach Slave_Diag gefragt, übernommen (Set_Prm, Chk_Cfg), mit dem Stoppwort gehalten, gefragt und \
         freigegeben"
    )];
    Outcome::of(Data::Plan(Plan { dry_run: true, telegrams, notes }))
}

fn mode(choice: Choice, is_basic: bool) -> Mode {
    if is_basic { Mode::Basic(choice.ramps.unwrap_or_default()) } else { Mode::PPO1 }
}
