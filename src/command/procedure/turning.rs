//! Steps that turn the shaft. Each is a run of `sollwert`, or a reset: asked, bounded, stopped and proven there.

use super::given::{Given, bad};
use super::guide::{Deed, Guide, Turn};
use super::{nameplate, record};
use crate::args::{MotionArgs, StopArg};
use crate::command::running::{self, Around, Plan};
use crate::command::sollwert::{self, Led};
use crate::drive::Reader;
use crate::drive::motion::{self, Keeps, Motor};
use crate::failure::{Class, Failure};
use crate::gate::Question;
use crate::outcome::{Change, Data, KeptStep, Outcome, ProcedureRecord, StepFate};
use crate::profile::procedure::Act;
use crate::profile::value::{self, format_decimal, written};
use crate::profile::{Family, Param, Role};
use crate::text::{Text, both};
use crate::tick::Span;
use std::cell::{Cell, RefCell};
use std::path::Path;

/// How long it turns in a test.
const TURNS: Span = Span::from_secs(3);
/// The frequency of a test, where none was given.
const TEST: &str = "5Hz";
/// The least of it at which one sees a shaft turn, in Hz, and the most, as a share of the rated frequency: no manual says what low is.
const LEAST: f64 = 1.0;
const SLOW: f64 = 0.2;
/// The most to which the ramp leads, as a multiple of the rated frequency: that bound is ours too.
const FAST: f64 = 2.0;
/// The longest that a shaft turns without anybody.
const SILENT: Span = Span::from_secs(60);
/// The time of the watchdog, where none was given.
const WATCHDOG: Span = Span::from_secs(2);
/// What the watchdog of the line trips with (CM-485 manual 6.9).
const SILENCE: i64 = 0x2010;

impl Guide<'_> {
    /// Holds the nameplate against itself.
    pub(super) fn nameplate(&mut self, turn: Turn<'_>, deed: &mut Deed) -> Result<(), Failure> {
        self.tell(turn);
        deed.found = nameplate::Nameplate::of(self.given)?.told();
        Ok(())
    }

    /// Writes the nameplate into the data set, which must be the one in which the drive works.
    pub(super) async fn store(&mut self, turn: Turn<'_>, deed: &mut Deed) -> Result<(), Failure> {
        let mut target = self.known().await?;
        let (steps, unknown) = nameplate::steps(self.given, &target.family)?;
        self.write(turn, deed, steps).await?;
        if !unknown.is_empty() {
            let names = Text::join(&unknown, ", ");
            deed.found.push(both!(
                "to be set at the keypad, because no source tells their numbers: {names}",
                "an der Bedieneinheit einzustellen, weil keine Quelle ihre Nummern nennt: {names}",
                names
            ));
        }
        self.allow();
        let set = nameplate::data_set(self.given)?;
        let active = Reader::new(&mut self.session, &mut target).vital_role(Role::ActiveSet).await?;
        match active.and_then(|value| value.raw) {
            Some(active) if set != 0 && active != i64::from(set) => {
                let message = both!(
                    "the drive works in data set {active}, and the nameplate is in {set}: it would be tested with another motor's data",
                    "der Antrieb arbeitet in Datensatz {active}, das Typenschild steht in {set}: geprüft würde mit Daten eines \
                     anderen Motors"
                );
                let hint =
                    both!("`antrieb dataset select {set}` selects it", "`antrieb dataset select {set}` wählt ihn");
                Err(Failure::new(Class::Forbidden, "forbidden.data_set", message).hint(hint))
            }
            _ => Ok(()),
        }
    }

    /// Turns the motor one way, and the other if that is wanted, and asks each time whether that was the right way.
    pub(super) async fn direction(&mut self, turn: Turn<'_>, deed: &mut Deed) -> Result<(), Failure> {
        let test = self.test().to_owned();
        let clockwise = both!(
            "The shaft has turned and stands. Was that clockwise, and the way in which the machine must turn?",
            "Die Welle hat gedreht und steht. War das rechtsherum, und so, wie die Maschine drehen muss?"
        );
        self.one_way(turn, deed, &test, clockwise).await?;
        if !both_ways(self.given)? {
            return Ok(());
        }
        let other = both!(
            "The shaft has turned the other way and stands. Was that counter-clockwise?",
            "Die Welle hat andersherum gedreht und steht. War das linksherum?"
        );
        self.one_way(turn, deed, &format!("-{test}"), other).await
    }

    async fn one_way(&mut self, turn: Turn<'_>, deed: &mut Deed, setpoint: &str, asked: Text) -> Result<(), Failure> {
        let args = run(setpoint, StopArg::Ramp, self.given)?;
        self.turns(turn, deed, &args, async |_: &mut Motor<'_, '_>| Ok(())).await?;
        let said = self.confirm(turn, &[asked]).await;
        said.map_err(|failure| match failure.code.as_str() {
            "forbidden.not_confirmed" => {
                let message = both!("the motor turns the wrong way", "der Motor dreht falsch herum");
                Failure::new(Class::No, "no.direction", message).hint(both!(
                    "switch the inverter off, wait until it is dead, exchange two motor phases (U and V); then --again",
                    "den Umrichter ausschalten, Spannungsfreiheit abwarten, zwei Motorphasen tauschen (U und V); dann --again"
                ))
            }
            _ => failure,
        })
    }

    /// Runs up and down, and measures both.
    pub(super) async fn ramp(&mut self, turn: Turn<'_>, deed: &mut Deed) -> Result<(), Failure> {
        let family = self.known().await?.family;
        let param = family.role(Role::SetpointFrequency).cloned().ok_or_else(motion::no_control_word)?;
        let (low, high) = (raw(self.test(), &param)?, raw(&goal(self.given.get("ramp"), self.given)?, &param)?);
        let times = Cell::new([Span::ZERO; 2]);
        let top = value::written(&param, high);
        self.turns(
            turn,
            deed,
            &run(&format!("{top}Hz"), StopArg::Ramp, self.given)?,
            async |motor: &mut Motor<'_, '_>| {
                let down = slope(motor, &param, low).await?;
                let up = slope(motor, &param, high).await?;
                times.set([down, up]);
                Ok(())
            },
        )
        .await?;
        let way = (high - low).unsigned_abs();
        let shown = |span: Span| {
            let hundredths = way * 1_000_000 / span.as_micros().max(1);
            (
                format_decimal((span.as_micros() / 100_000) as i64, 1),
                format_decimal(hundredths as i64, param.decimals_or_zero()),
            )
        };
        let [(down_s, down), (up_s, up)] = times.get().map(shown);
        deed.found.push(both!("up in {up_s} s: {up} Hz/s", "hinauf in {up_s} s: {up} Hz/s"));
        deed.found.push(both!("down in {down_s} s: {down} Hz/s", "hinab in {down_s} s: {down} Hz/s"));
        Ok(())
    }

    /// Stops it by a quick stop.
    pub(super) async fn stop(&mut self, turn: Turn<'_>, deed: &mut Deed) -> Result<(), Failure> {
        self.turns(turn, deed, &run(self.test(), StopArg::QuickStop, self.given)?, async |_: &mut Motor<'_, '_>| Ok(()))
            .await
    }

    /// Says nothing until the drive must have tripped by itself.
    pub(super) async fn silence(&mut self, turn: Turn<'_>, deed: &mut Deed) -> Result<(), Failure> {
        let silent = watchdog(self.given)? + Span::from_secs(1);
        let args = run(self.test(), StopArg::Ramp, self.given)?;
        let proven = Cell::new(false);
        let ended = self
            .turns(turn, deed, &args, async |motor: &mut Motor<'_, '_>| {
                motor.say_nothing(silent).await?;
                let seen = motor.look().await?;
                proven.set(seen.state.starts_with("fault") && seen.fault == Some(SILENCE));
                if proven.get() { Ok(()) } else { Err(not_tripped(silent)) }
            })
            .await;
        match ended {
            // Its trip is what was to be seen.
            Err(failure) if proven.get() && failure.code == "forbidden.fault" => {}
            ended => return ended,
        }
        let seconds = format_decimal((silent.as_micros() / 100_000) as i64, 1);
        deed.found.push(both!(
            "after {seconds} s without a telegram: F2010, without power",
            "nach {seconds} s ohne Telegramm: F2010, ohne Strom"
        ));
        let stands = deed.motions.last().and_then(|motion| motion.standing) == Some(true);
        let unseen = || both!("whether the shaft stands was not shown", "ob die Welle steht, zeigte nichts");
        deed.found.extend((!stands).then(unseen));
        Ok(())
    }

    /// Acknowledges the fault.
    pub(super) async fn reset(&mut self, turn: Turn<'_>, deed: &mut Deed) -> Result<(), Failure> {
        self.acknowledge(turn, deed, turn.details()).await
    }

    /// The same within another step.
    pub(super) async fn acknowledge(
        &mut self,
        turn: Turn<'_>,
        deed: &mut Deed,
        details: Vec<Text>,
    ) -> Result<(), Failure> {
        let motion = bounded(StopArg::Coast, None, watchdog(self.given)?);
        let (begun, family) = (self.begin(turn), self.known().await?.family);
        let Guide { settings, registry, interrupt, ask, session, record, path, .. } = self;
        let (address, record) = (record.address, RefCell::new(record));
        let keeps = |change: &Change| lends((&record, path), &family, change);
        let plan = Plan { keeps: Some(Keeps(&keeps)), ..Plan::of("reset", turn.title(), &motion) };
        let mut around = Around { settings, registry, interrupt, ask: &mut **ask };
        let told = running::on_line(
            session,
            &mut around,
            address,
            plan,
            async |_, target, before, plan| {
                plan.details.extend(details);
                if !before.obeys(&target.family) {
                    plan.details.push(may_stay(&target.family.role_label("control-mode")));
                }
                if before.state.starts_with("fault") { Ok(()) } else { Err(motion::no_fault()) }
            },
            async |motor, ()| {
                noted(&record, path, |record| record.keep(begun))?;
                motor.reset().await
            },
        )
        .await;
        self.is_free_again();
        let ended = self.came(told?, deed);
        self.leaves_control(ended, deed)
    }

    fn test(&self) -> &str {
        self.given.get("test").unwrap_or(TEST)
    }

    /// A step of which is known that it was begun.
    fn begin(&self, turn: Turn<'_>) -> KeptStep {
        let (step, title) = (turn.step.slug.clone(), turn.step.title.clone());
        let (time, found, error) = (self.session.utc(), Vec::new(), None);
        KeptStep { step, title, turns: true, result: StepFate::Begun, time, found, error }
    }

    /// A bounded run, and something more before its stop. That it was begun is on the disk before it begins.
    pub(super) async fn turns(
        &mut self,
        turn: Turn<'_>,
        deed: &mut Deed,
        args: &sollwert::Args,
        then: impl AsyncFnOnce(&mut Motor<'_, '_>) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let question = Question { hazards: Vec::new(), title: turn.title(), details: turn.details() };
        self.leads(turn, deed, Led { args, question, settings: &[], keeps: None }, then).await
    }

    /// The same, with what is set for the run, and what is asked.
    pub(super) async fn leads(
        &mut self,
        turn: Turn<'_>,
        deed: &mut Deed,
        led: Led<'_>,
        then: impl AsyncFnOnce(&mut Motor<'_, '_>) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let (begun, family) = (self.begin(turn), self.known().await?.family);
        let Guide { settings, registry, interrupt, ask, session, record, path, .. } = self;
        let (address, record) = (record.address, RefCell::new(record));
        let mut around = Around { settings, registry, interrupt, ask: &mut **ask };
        let keeps = |change: &Change| lends((&record, path), &family, change);
        let led = Led { keeps: Some(Keeps(&keeps)), ..led };
        let told = sollwert::led(
            session,
            &mut around,
            address,
            led,
            || noted(&record, path, |record| record.keep(begun)),
            then,
        )
        .await;
        self.is_free_again();
        self.came(told?, deed)
    }

    /// What a run has come to, and given back.
    fn came(&mut self, told: Outcome, deed: &mut Deed) -> Result<(), Failure> {
        if let Some(Data::Motion(motion)) = &told.data {
            self.record.take_back(&motion.changed);
        }
        came(told, deed)
    }

    /// A control mode that stays because contacts could start the drive under its own is an end that was agreed to.
    fn leaves_control(&mut self, ended: Result<(), Failure>, deed: &Deed) -> Result<(), Failure> {
        let mode = self.target.as_ref().and_then(|target| Some(target.family.role("control-mode")?.id));
        let left = deed.motions.last().into_iter().flat_map(|motion| &motion.changed).filter(|change| !change.restored);
        let is_agreed = left.into_iter().all(|change| Some(change.param) == mode);
        match ended {
            Err(failure) if failure.code == "partial.not_given_back" && is_agreed => {
                self.record.lent.iter_mut().filter(|lent| Some(lent.param) == mode).for_each(|lent| lent.stays = true);
                Ok(())
            }
            ended => ended,
        }
    }
}

/// Notes something on the disk, before a run changes what it is about.
fn noted(
    record: &RefCell<&mut ProcedureRecord>,
    path: &Path,
    note: impl FnOnce(&mut ProcedureRecord),
) -> Result<(), Failure> {
    let mut record = record.borrow_mut();
    note(&mut record);
    record::save(path, &record)
}

/// Keeps in the record what a run is about to change, with its value as it is typed.
fn lends(
    (record, path): (&RefCell<&mut ProcedureRecord>, &Path),
    family: &Family,
    change: &Change,
) -> Result<(), Failure> {
    let stood = written(&family.param_or_unknown(change.param), change.old);
    noted(record, path, |record| record.lend(change, stood))
}

fn may_stay(label: &str) -> Text {
    both!(
        "Where contacts that are closed could start the drive under its own {label}, that stays as it is set now, in RAM: such an end \
         is agreed to here.",
        "Wo geschlossene Kontakte den Antrieb unter seinem eigenen {label} starten könnten, bleibt es im RAM, wie es jetzt gesetzt wird: \
         ein solches Ende ist hiermit vereinbart."
    )
}

/// What a run has come to.
fn came(told: Outcome, deed: &mut Deed) -> Result<(), Failure> {
    if let Some(Data::Motion(motion)) = told.data {
        deed.found.extend(motion.setpoint.iter().filter_map(|setpoint| {
            let actual = setpoint.actual?;
            let actual = format_decimal(actual.raw, actual.decimals);
            let value = format_decimal(setpoint.value.raw, setpoint.value.decimals);
            let unit = &setpoint.unit;
            Some(both!(
                "setpoint {value} {unit}, actual value {actual} {unit}",
                "Sollwert {value} {unit}, Istwert {actual} {unit}"
            ))
        }));
        deed.found.extend(motion.stop.iter().filter(|stop| stop.acknowledged && stop.standing == Some(true)).map(
            |stop| {
                let choice = stop.choice;
                both!("stop ({choice}) proven, at standstill", "Halt ({choice}) belegt, im Stillstand")
            },
        ));
        deed.motions.push(motion);
    }
    told.failure.map_or(Ok(()), Err)
}

/// A run at a setpoint, that ends with this stop.
fn run(setpoint: &str, stop: StopArg, given: &Given) -> Result<sollwert::Args, Failure> {
    Ok(sollwert::Args::run_at(setpoint, bounded(stop, Some(TURNS), watchdog(given)?)))
}

/// Whether the other direction is tried too.
fn both_ways(given: &Given) -> Result<bool, Failure> {
    match given.get("reverse") {
        None | Some("no") => Ok(false),
        Some("yes") => Ok(true),
        Some(other) => Err(bad(
            "reverse",
            &both!("expected yes or no, got '{other}'", "erwartet: yes oder no; angegeben: '{other}'"),
        )),
    }
}

/// The time of the drive's watchdog in every run.
pub(super) fn watchdog(given: &Given) -> Result<Span, Failure> {
    Ok(given.span("watchdog")?.unwrap_or(WATCHDOG))
}

/// Bounds of a run that takes control, with a watchdog that stops the drive if the line breaks.
pub(super) fn bounded(on_exit: StopArg, duration: Option<Span>, watchdog: Span) -> MotionArgs {
    let (hold, take_control, wait, view, dead_man) = (true, true, None, false, false);
    MotionArgs { hold, duration, on_exit, watchdog: Some(watchdog), take_control, wait, view, dead_man }
}

/// Where the ramp leads: as given, or half of the rated frequency.
fn goal(given: Option<&str>, all: &Given) -> Result<String, Failure> {
    match given {
        Some(given) => Ok(given.to_owned()),
        None => Ok(format!("{:.2}Hz", nameplate::Nameplate::of(all)?.frequency / 2.0)),
    }
}

fn raw(text: &str, param: &Param) -> Result<i64, Failure> {
    value::parse(text, param, &[]).map_err(|error| bad("test, ramp", &error.text()))
}

/// Gives a setpoint and takes the time until it is reached.
async fn slope(motor: &mut Motor<'_, '_>, param: &Param, raw: i64) -> Result<Span, Failure> {
    let begun = motor.now();
    motor.expects = Some((raw, raw));
    motor.give(param, raw, param.unit.as_deref().unwrap_or("")).await?;
    motor.until_reached().await?;
    Ok(motor.now().since(begun))
}

fn not_tripped(silent: Span) -> Failure {
    let seconds = format_decimal((silent.as_micros() / 100_000) as i64, 1);
    let message = both!(
        "nobody talked to the drive for {seconds} s, and it ran on: its watchdog does not act",
        "{seconds} s lang sprach niemand mit dem Antrieb, und er lief weiter: sein Watchdog wirkt nicht"
    );
    Failure::new(Class::No, "no.watchdog", message)
}

/// Refuses what cannot be run, before anything is opened.
///
/// # Errors
/// A nameplate that cannot be so, or a setpoint that is none.
pub(super) fn fit(given: &Given, family: &Family) -> Result<(), Failure> {
    nameplate::steps(given, family)?;
    both_ways(given)?;
    let Some(param) = family.role(Role::SetpointFrequency) else { return Ok(()) };
    let text = given.get("test").unwrap_or(TEST);
    let (test, most) = (raw(text, param)?, nameplate::Nameplate::of(given)?.frequency * SLOW);
    let hertz = |raw: i64| raw as f64 / 10f64.powi(param.decimals_or_zero().into());
    if !(LEAST..=most).contains(&hertz(test)) {
        return Err(bad(
            "test",
            &both!(
                "expected a low speed that can be seen, {LEAST} to {most} Hz (a fifth of the rated frequency), got '{text}'",
                "erwartet wird eine kleine Drehzahl, die man sieht: {LEAST} bis {most} Hz (ein Fünftel der Bemessungsfrequenz); \
                 angegeben: '{text}'"
            ),
        ));
    }
    let (text, rated) = (goal(given.get("ramp"), given)?, nameplate::Nameplate::of(given)?.frequency);
    let ramp = raw(&text, param)?;
    value::check_range(ramp, param).map_err(|error| bad("ramp", &error.text()))?;
    if hertz(ramp) > rated * FAST {
        let most = rated * FAST;
        return Err(bad(
            "ramp",
            &both!(
                "expected at most {most} Hz (twice the rated frequency), got '{text}'",
                "erwartet werden höchstens {most} Hz (das Doppelte der Bemessungsfrequenz); angegeben: '{text}'"
            ),
        ));
    }
    let silent = watchdog(given)?;
    if silent > SILENT {
        return Err(bad(
            "watchdog",
            &both!(
                "expected at most {SILENT}, as the shaft turns unattended for so long; got {silent}",
                "erwartet werden höchstens {SILENT}, denn so lange dreht die Welle unbeaufsichtigt; angegeben: {silent}"
            ),
        ));
    }
    if ramp <= test {
        return Err(bad(
            "ramp",
            &both!(
                "expected more than the frequency of the tests, got '{text}'",
                "erwartet wird mehr als die Frequenz der Prüfungen; angegeben: '{text}'"
            ),
        ));
    }
    Ok(())
}

/// What a step would run.
pub(super) fn rehearsed(act: Act, given: &Given) -> Option<sollwert::Args> {
    let test = given.get("test").unwrap_or(TEST);
    match act {
        Act::Ramp => run(&goal(given.get("ramp"), given).ok()?, StopArg::Ramp, given).ok(),
        Act::Stop => run(test, StopArg::QuickStop, given).ok(),
        _ => run(test, StopArg::Ramp, given).ok(),
    }
}
