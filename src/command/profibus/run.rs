//! `sollwert` and `statemachine` with PROFIBUS spoken: a motor is run, stopped, reset and looked at by the words of PROFIdrive or of
//! the Basic block, and every end is the same: the stop word until the frequency is 0, then zero outputs, Clear, Unlock.

use super::job::{Action, DECIMALS, Job, spoken};
use super::open;
use super::spoken::usage;
use super::taking::{Whom, question, whom};
use super::told::{Told, report};
use crate::args::{MotionArgs, StopArg};
use crate::command::running::leads::{Leads, Way};
use crate::command::running::{keypad, unsent};
use crate::command::{Context, asking};
use crate::drive::Panel;
use crate::drive::profibus::{self, Bounds, Course, Exchange, Lead, Lending, Mode, Ramps, Rights, WATCHDOG, Wanted};
use crate::failure::{Class, Failure};
use crate::gate::{self, Ask, Hazard, Motion, Permit, Question, Relief};
use crate::outcome::{Data, Event, Outcome, Plan};
use crate::profile::Family;
use crate::profile::setpoint::Schedule;
use crate::profile::value::format_decimal;
use crate::text::{Text, both};
use crate::tick::Span;
use std::rc::Rc;

/// How long is waited for a state, where nothing else was asked for.
const WAIT: Span = Span::from_secs(3);
/// The watchdog of a slave: its least and its longest here.
const SHORTEST: Span = Span::from_millis(100);
const LONGEST: Span = Span::from_secs(60);

/// Does it with one inverter.
pub(in crate::command) async fn run(job: &Job<'_>, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let whom = whom(job.slave, context)?;
    let watchdog = watchdog(job.motion)?;
    match job.action {
        Action::Run(wanted) => {
            demands(job.motion, wanted)?;
            keypad::is_there(job.motion, context.interrupt.panel())?;
        }
        Action::Stop(_) | Action::Reset => super::refuse(&[("--take-control", job.motion.take_control)])?,
    }
    whom.knows(job.choice)?;
    if context.settings.dry_run {
        return Ok(Outcome::of(Data::Plan(dry_run(job, &whom))));
    }
    let Context { settings, registry, interrupt, observe, ask, .. } = context;
    let permit = match job.action {
        Action::Stop(act) => {
            // A stop goes out and is proven whether or not somebody reads what comes of it.
            interrupt.hear_only_keys();
            act.permit()
        }
        Action::Reset | Action::Run(_) => {
            asking::off_line(interrupt, *ask, &question(whom.address, &job.why(), job.choice.spoken)).await?
        }
    };
    let line = open(job.slave.slot_time, (settings, registry), interrupt, *observe).await;
    let mut line = line.map_err(|failure| if job.is_stop() { unsent(failure) } else { failure })?;
    if let Action::Run(_) = job.action {
        line.pace();
    }
    let taking = whom
        .taking(&mut line, job.choice, (watchdog, job.is_stop()), &permit)
        .await
        .and_then(|taking| knows(job, taking.mode).map(|()| taking));
    let taking = taking.map_err(|failure| if job.is_stop() { unsent(failure) } else { failure })?;
    let stop = job.stop(taking.mode);
    let mut exchange = Exchange::new(&mut line, whom.address, taking, &permit);
    let (mut told, mut family) = (Told::default(), whom.presumed.clone());
    let done = async {
        if let Action::Stop(act) = job.action {
            exchange.stops(act == Relief::DisableVoltage).await?;
        }
        let is_run = matches!(job.action, Action::Run(_));
        family = whom.family(&mut exchange, registry, !is_run).await?;
        told.parting = Some(exchange.parting(&family).await?);
        told.from = exchange.seen();
        match job.action {
            Action::Stop(_) => Ok(()),
            Action::Reset => exchange.reset(WAIT, &mut told.run).await,
            Action::Run(wanted) => {
                run_it(&mut exchange, job, (&whom, &family), wanted, (*ask, interrupt.panel()), &mut told).await
            }
        }
    };
    let done = done.await;
    let panel = interrupt.panel();
    panel.rests();
    let done = match done {
        // A run that was held and ended by its keypad came to its normal end, unless somebody interrupted as well.
        Err(failure) if failure.class == Class::Interrupted && told.run.held && !panel.is_interrupted() => {
            told.by = panel.ended();
            if told.by.is_some() { Ok(()) } else { Err(failure) }
        }
        done => done,
    };
    if stop == "coast" {
        exchange.coasts();
    }
    if let Some(stays) = keypad::stays(panel, done.is_ok(), told.run.held) {
        exchange.stays(panel.clone(), stays, done.as_ref().err().map(Failure::told));
    }
    let ending = exchange.leave().await;
    Ok(report((job, stop), (whom.address, &family), told, done, ending))
}

/// Looks at what decides on a run, asks with all of that, and runs.
async fn run_it(
    exchange: &mut Exchange<'_, '_>,
    job: &Job<'_>,
    (whom, family): (&Whom<'_>, &Rc<Family>),
    wanted: Wanted,
    (ask, panel): (&mut dyn Ask, &Panel),
    told: &mut Told,
) -> Result<(), Failure> {
    let rights = exchange.rights().await?;
    let mode = exchange.mode();
    // There is nothing to lend in Basic mode: every word of it takes control, and it has no parameters.
    let lending = if mode.is_basic() {
        Lending::default()
    } else {
        rights.lending(job.motion.take_control, job.motion.watchdog.is_some())
    };
    let still = Schedule::ramp(wanted.value(), wanted.value(), 0);
    let way = job.way.clone().unwrap_or(Way { schedule: still, keys: None });
    let question = asks((job, mode), whom, (wanted, &way), (&rights, lending), told);
    let agreed = exchange.during(gate::ask(ask, &question)).await;
    let agreed = agreed.map_err(|failure| match failure.class {
        Class::Interrupted => asking::interrupted(),
        _ => failure,
    });
    let _agreed: Permit<Motion> = agreed?.map_err(asking::denied)?;
    let wait = job.motion.wait.unwrap_or(WAIT);
    if job.motion.dead_man {
        panel.needs_holding();
    }
    let (first, unit) = (wanted.at(way.schedule.at(0)), wanted.unit());
    let (shown, refused) =
        (way.keys.map(|keys| keys.shown(DECIMALS, unit)), way.keys.map(|keys| keys.refused(DECIMALS, unit)));
    exchange.show(family, job.verb(), (first, job.stop(mode), shown));
    if job.motion.dead_man {
        exchange.tell(Event::Note(keypad::hold_a_key()));
        // The slave is kept going meanwhile, by the stop word.
        exchange.during(panel.held()).await.map_err(|failure| match failure.class {
            Class::Interrupted => asking::left_before_start(),
            _ => failure,
        })?;
    }
    exchange.starts();
    let bounds = Bounds { wait, duration: job.motion.duration, until: job.until.is_some() };
    let mut leads = Leads::new(&way.schedule, (way.keys, refused), panel);
    let takes = leads.takes();
    let mut is_on_its_way = true;
    let mut next = |gone: Option<Span>| match gone {
        Some(gone) => leads.on_its_way(gone),
        // What was pressed on the way meant nothing yet.
        None if std::mem::take(&mut is_on_its_way) => (leads.arrives(), None),
        None => leads.by_arrows(),
    };
    let lead = Lead { first, furthest: wanted.value(), takes, next: &mut next };
    exchange.run(lead, (&rights, lending), bounds, &mut told.run).await
}

/// What a run over PROFIBUS needs, and what it does not know.
fn demands(motion: &MotionArgs, wanted: Wanted) -> Result<(), Failure> {
    let is_beyond = |value: i64, most: i64| value.abs() > most;
    let (is_wrong, most) = match wanted {
        Wanted::Hertz(value) => (is_beyond(value, 40_000), "400Hz"),
        Wanted::Percent(value) => (is_beyond(value, 10_000), "100%"),
    };
    if is_wrong {
        return Err(usage(both!("expected at most {most}", "erwartet: höchstens {most}")));
    }
    super::refuse(&[
        ("--on-exit quick-stop", motion.on_exit == StopArg::QuickStop),
        ("--on-exit keep", motion.on_exit == StopArg::Keep),
    ])?;
    if motion.hold {
        return Ok(());
    }
    let message = both!(
        "over PROFIBUS a motor runs only while this program exchanges data: --hold is missing",
        "am PROFIBUS läuft ein Motor nur, solange dieses Programm Daten austauscht: --hold fehlt"
    );
    Err(Failure::new(Class::Usage, "usage.hold", message)
        .hint(both!("add --enable --hold, and --duration 5s", "--enable --hold angeben, und --duration 5s")))
}

fn watchdog(motion: &MotionArgs) -> Result<Span, Failure> {
    let Some(span) = motion.watchdog else { return Ok(WATCHDOG) };
    if (SHORTEST..=LONGEST).contains(&span) {
        return Ok(span);
    }
    let message = both!(
        "--watchdog: expected {SHORTEST} to {LONGEST} over PROFIBUS, got {span}",
        "--watchdog: am PROFIBUS {SHORTEST} bis {LONGEST}; angegeben: {span}"
    );
    Err(Failure::new(Class::Usage, "usage.watchdog", message))
}

/// The question before a motor runs, with everything that is changed for it.
fn asks(
    (job, mode): (&Job<'_>, Mode),
    whom: &Whom<'_>,
    (wanted, way): (Wanted, &Way),
    (rights, lending): (&Rights, Lending),
    told: &Told,
) -> Question {
    let (address, setpoint) = (whom.address, goes(wanted, way));
    let mut details: Vec<Text> = told.parting.clone().into_iter().collect();
    details.extend(match mode {
        Mode::Profidrive(_) => by_profidrive(wanted, rights, lending),
        Mode::Basic(ramps) => by_basic(ramps),
    });
    details.extend(way.keys.map(|keys| keys.told(|raw| Text::name(spoken(wanted.at(raw))))));
    details.extend(job.until.clone());
    details.extend(job.motion.dead_man.then(only_held));
    let stop = match job.motion.on_exit {
        _ if mode.is_basic() => both!("no run bit (0050): the ramp", "kein Startbit (0050): die Rampe"),
        StopArg::Coast => {
            both!("OFF3: it coasts (by the norm: a quick stop)", "OFF3: er läuft aus (nach Norm: Schnellhalt)")
        }
        _ => both!("OFF1: the ramp F003", "OFF1: die Rampe F003"),
    };
    details.push(both!(
        "it is stopped when this program ends ({stop})",
        "er wird angehalten, wenn dieses Programm endet ({stop})",
        stop
    ));
    let title = match wanted.value() {
        0 => both!(
            "station {address} on PROFIBUS: the motor is enabled, setpoint {setpoint}",
            "Station {address} am PROFIBUS: der Motor wird freigegeben, Sollwert {setpoint}"
        ),
        _ => both!(
            "station {address} on PROFIBUS: the motor runs, setpoint {setpoint}",
            "Station {address} am PROFIBUS: der Motor läuft, Sollwert {setpoint}"
        ),
    };
    let mut hazards = vec![Hazard::Motion];
    if lending != Lending::default() {
        hazards.insert(0, Hazard::Write);
    }
    Question { hazards, title, details }
}

/// Where a setpoint goes, as it is said.
fn goes(wanted: Wanted, way: &Way) -> String {
    let places: Vec<String> = way.schedule.turns().into_iter().map(|raw| spoken(wanted.at(raw))).collect();
    places.join(" … ")
}

/// What a dead man is.
fn only_held() -> Text {
    both!(
        "it starts when a key is held, and is stopped as soon as that is let go (--dead-man)",
        "er startet, wenn eine Taste gehalten wird, und wird angehalten, sobald sie losgelassen wird (--dead-man)"
    )
}

/// What is changed for a run in ProfiDrive mode, and what is not known of it.
fn by_profidrive(wanted: Wanted, rights: &Rights, lending: Lending) -> Vec<Text> {
    let raw = |value: Option<u32>| value.map_or_else(|| "?".to_owned(), |value| value.to_string());
    let mut details = Vec::new();
    if lending.control {
        details.push(both!(
            "P.928 {old} -> 1 for the run (control from the bus), given back afterwards",
            "P.928 {old} -> 1 für den Lauf (Steuern über den Bus), danach zurückgegeben",
            old = raw(rights.right)
        ));
    }
    if lending.stops {
        details.push(both!(
            "P.703 {old} -> 2 for the run (a lost bus stops the motor), given back afterwards",
            "P.703 {old} -> 2 für den Lauf (verlorener Bus hält den Motor an), danach zurückgegeben",
            old = raw(rights.lost)
        ));
    } else if !rights.stops() {
        details.push(both!(
            "P.703 = {old}: if this program dies, a lost bus may not stop the motor; --watchdog 2s makes it",
            "P.703 = {old}: stirbt dieses Programm, hält der verlorene Bus den Motor vielleicht nicht an; --watchdog 2s sorgt dafür",
            old = raw(rights.lost)
        ));
    }
    // A motor that is held enabled at 0 is measured at nothing.
    if let Wanted::Hertz(value) = wanted
        && value != 0
    {
        let maxima = rights.maxima.iter().map(|maximum| format_decimal(*maximum, 2)).collect::<Vec<_>>().join(", ");
        details.push(both!(
            "the setpoint is a part of {called} ({maxima} Hz by its raw value): it is measured at a small setpoint first",
            "der Sollwert ist ein Teil von {called} (nach dem Rohwert {maxima} Hz): gemessen wird zuerst bei kleinem Sollwert",
            called = rights.called
        ));
    }
    details
}

/// What a run in Basic mode sets, and what it does not know.
fn by_basic(ramps: Ramps) -> Vec<Text> {
    let [up, down] = [ramps.up, ramps.down].map(|tenths| format_decimal(tenths.into(), 1));
    vec![
        both!(
            "ramps: {up} s up, {down} s down (--set F002=…, F003=…), in the place of those that stand in the inverter",
            "Rampen: {up} s hoch, {down} s herunter (--set F002=…, F003=…), statt der im Umrichter eingestellten"
        ),
        both!(
            "if this program dies, the watchdog of the slave stops the motor (Conn Sta = 0), unless P.620 = 1 keeps it running",
            "stirbt dieses Programm, hält die Überwachung des Slaves den Motor an (Conn Sta = 0), wenn ihn nicht P.620 = 1 weiterlaufen \
             lässt"
        ),
    ]
}

/// Refuses what a mode has no word for.
fn knows(job: &Job<'_>, mode: Mode) -> Result<(), Failure> {
    if mode.is_basic() && matches!(job.action, Action::Run(_)) {
        super::refuse(&[("--on-exit coast (--mode basic)", job.motion.on_exit == StopArg::Coast)])?;
        if let Action::Run(Wanted::Percent(_)) = job.action {
            return Err(usage(both!(
                "expected a setpoint in Hz: Basic mode does not tell the maximum frequency (A004), which is 100 %",
                "erwartet: ein Sollwert in Hz; der Basic-Modus nennt die Maximalfrequenz (A004), also 100 %, nicht"
            )));
        }
    }
    if !mode.is_basic() && !mode.has_pkw() && !job.is_stop() {
        let name = mode.name();
        return Err(usage(both!(
            "{name} has no PKW: who controls (P.928), and what a lost master means (P.703), could not be read",
            "{name} hat kein PKW: wer steuert (P.928) und was ein verlorener Master bedeutet (P.703), ließe sich nicht lesen"
        )));
    }
    Ok(())
}

fn dry_run(job: &Job<'_>, whom: &Whom<'_>) -> Plan {
    let (address, mode) = (whom.address, whom.planned(job.choice));
    let coasts = job.stop(mode) == "coast";
    let words = profibus::words(
        match job.action {
            Action::Run(wanted) => Course::Run(wanted, coasts),
            Action::Stop(_) => Course::Stop(coasts),
            Action::Reset => Course::Reset,
        },
        mode,
    );
    let telegrams = words.iter().map(|words| profibus::cyclic(address, *words, mode, &whom.presumed)).collect();
    let configured = mode.name();
    let mut notes = vec![both!(
        "station {address} is taken (Set_Prm with a watchdog, {configured}); these words follow one another; then zero outputs, Clear, \
         Unlock",
        "Station {address} wird übernommen (Set_Prm mit Überwachung, {configured}); diese Wörter folgen aufeinander; dann Ausgänge auf \
         null, Clear, Unlock"
    )];
    if let (Action::Run(wanted), Some(way)) = (job.action, job.way.as_ref().filter(|way| way.schedule.end_us() > 0)) {
        let (way, takes) = (goes(wanted, way), Span::from_micros(way.schedule.end_us()));
        notes.push(both!(
            "the setpoint is led in {takes}: {way}; the word shown is that of the furthest",
            "der Sollwert wird in {takes} geführt: {way}; gezeigt ist das Wort des äußersten"
        ));
    }
    if job.choice.spoken.is_none() {
        notes.push(both!(
            "where Get_Cfg tells the Basic block, and --drive the series, its words go out instead: --mode basic shows them",
            "wo Get_Cfg den Basic-Block nennt und --drive die Serie, gehen dessen Wörter hinaus: --mode basic zeigt sie"
        ));
    }
    if mode.is_basic() {
        return Plan { dry_run: true, telegrams, notes };
    }
    if job.motion.take_control {
        notes.push(both!(
            "P.928 is set to 1 first, where it is not, and given back behind the stop word",
            "P.928 wird zuerst auf 1 gesetzt, wo es das nicht ist, und nach dem Stoppwort zurückgegeben"
        ));
    }
    if job.motion.watchdog.is_some() {
        notes.push(both!(
            "P.703 is set to 2 first, where a lost bus would not stop the motor, and given back behind the stop word",
            "P.703 wird zuerst auf 2 gesetzt, wo ein verlorener Bus den Motor nicht anhielte, und nach dem Stoppwort zurückgegeben"
        ));
    }
    if let Action::Run(Wanted::Hertz(value)) = job.action
        && value != 0
    {
        notes.push(both!(
            "the setpoint shown is the one at which the scale is measured; that of the run follows from A004 and P.611",
            "der gezeigte Sollwert ist der, bei dem der Maßstab gemessen wird; der des Laufs folgt aus A004 und P.611"
        ));
    }
    Plan { dry_run: true, telegrams, notes }
}

/// Tells what the stop is that goes out, where another one was asked for.
pub(in crate::command) fn no_quick_stop(observe: &mut dyn FnMut(Event)) {
    observe(Event::Note(both!(
        "no source knows a quick stop by the control word of an SJ2-PB: OFF1 goes out, the ramp F003",
        "keine Quelle kennt einen Schnellhalt im Steuerwort eines SJ2-PB: hinaus geht OFF1, die Rampe F003"
    )));
}
