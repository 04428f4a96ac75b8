//! `systembus nmt`: tells nodes something as master of the network, and looks whether they obeyed.

use super::plan::CUBE;
use crate::args::Settings;
use crate::command::{Context, asking, connect, named_family, telegram_reader};
use crate::drive::{BusOrder, Reader, Session, Target};
use crate::failure::{Class, Failure};
use crate::gate::{Hazard, Motion, Question};
use crate::outcome::{BusOrdered, BusOrders, Data, ErrorDoc, Outcome, Plan, Value, Warning};
use crate::profile::{DataSets, Family};
use crate::text::{Text, both};
use clap::{Args as ClapArgs, ValueEnum};
use std::rc::Rc;

#[derive(Clone, Debug, ClapArgs)]
pub(super) struct Options {
    /// What to tell
    #[arg(value_name = "COMMAND")]
    command: Command,
    /// The node that is told, 1 to 63 [default: all]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u8).range(1..=63))]
    node: Option<u8>,
}

/// A command of network management.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Command {
    /// Operational: PDOs flow, and can turn a shaft
    Start,
    /// Stopped: neither PDOs nor SDOs
    Stop,
    /// Pre-Operational: no PDOs
    Preop,
    /// Begin anew
    Reset,
}

impl Command {
    fn order(self) -> BusOrder {
        match self {
            Command::Start => BusOrder::Start,
            Command::Stop => BusOrder::Stop,
            Command::Preop => BusOrder::PreOperational,
            Command::Reset => BusOrder::Reset,
        }
    }

    fn name(self) -> &'static str {
        match self {
            Command::Start => "start",
            Command::Stop => "stop",
            Command::Preop => "preop",
            Command::Reset => "reset",
        }
    }

    /// Whether a shaft can turn behind it: PDOs bring what releases a drive, and a node that comes back is started by a master.
    fn may_turn(self) -> bool {
        matches!(self, Command::Start | Command::Reset)
    }
}

/// P.978, and what it shows (EM-RES-03 manual 5.12).
const NODE_STATE: u32 = 978;
const PRE_OPERATIONAL: i64 = 1;
const OPERATIONAL: i64 = 2;

pub(super) async fn run(options: &Options, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let Options { command, node } = *options;
    let Context { settings, registry, interrupt, observe, ask, .. } = context;
    if !settings.is_can() {
        return Err(no_bus());
    }
    if settings.typed.names_address() {
        return Err(not_by_address());
    }
    let family = named_family(settings, registry, settings.drive.as_deref().unwrap_or(CUBE))?;
    if settings.dry_run {
        return Ok(planned(settings, &family, command.order().shown(node)));
    }
    let mut session = connect(settings, registry, interrupt, *observe).await?;
    let fatal = |error: crate::drive::AccessError| error.failure(0, None);
    if session.has_master() && !settings.force {
        return Err(other_master());
    }
    let nodes = node.map_or_else(|| session.nodes_heard(), |node| vec![node]);
    let mut rows = Vec::new();
    for &address in &nodes {
        let before = state(&mut session, address, &family).await?;
        rows.push(row(address, &family, before));
    }
    if command.may_turn() {
        asking::on_line::<Motion>(&mut session, *ask, &question(command, node, &rows)).await?;
    }
    session.tell_nodes(command.order(), node, &nodes).await.map_err(fatal)?;
    for row in &mut rows {
        let after = state(&mut session, row.address, &family).await?;
        let booted = session.has_booted(row.address);
        prove(row, command, after, booted);
    }
    let failure = verdict(command, &rows);
    let warnings = no_stop(command).into_iter().collect();
    let data = Data::BusOrders(BusOrders { command: command.name(), node, nodes: rows });
    Ok(Outcome { data: Some(data), warnings, failure })
}

/// What would be sent.
fn planned(settings: &Settings, family: &Family, frame: String) -> Outcome {
    let telegrams = telegram_reader(settings, family).frames(&frame).unwrap_or_default();
    Outcome::of(Data::Plan(Plan { dry_run: true, telegrams, notes: Vec::new() }))
}

/// What a node shows of its state.
#[derive(Default)]
struct Shown {
    raw: Option<i64>,
    text: Option<Text>,
    error: Option<ErrorDoc>,
}

/// P.978 of a node, or why it did not tell it.
async fn state(session: &mut Session<'_>, address: u8, family: &Rc<Family>) -> Result<Shown, Failure> {
    let mut target = Target::new(address, family.clone());
    let mut reader = Reader::new(session, &mut target);
    reader.lenient = true;
    let rows = reader.rows(&family.param_or_unknown(NODE_STATE), DataSets::Unnamed).await;
    match rows {
        Err(failure) if matches!(failure.class, Class::Interrupted | Class::Port) => Err(failure),
        Err(failure) => Ok(Shown { error: Some(ErrorDoc::from(&failure)), ..Shown::default() }),
        Ok(rows) => {
            let shown = |value: Value| Shown { raw: value.raw, text: value.text, error: value.error };
            Ok(rows.into_iter().next().map_or_else(Shown::default, shown))
        }
    }
}

fn row(address: u8, family: &Family, before: Shown) -> BusOrdered {
    BusOrdered {
        address,
        drive: family.drive.clone(),
        before: before.raw,
        before_text: before.text,
        after: None,
        after_text: None,
        proof: None,
        error: None,
    }
}

/// What a node shows behind a command, and whether that proves that it obeyed.
fn prove(row: &mut BusOrdered, command: Command, after: Shown, booted: bool) {
    (row.after, row.after_text) = (after.raw, after.text.clone());
    let is_silent = after.error.as_ref().is_some_and(|error| error.code.starts_with("silence"));
    row.proof = match command {
        Command::Start => (after.raw == Some(OPERATIONAL)).then_some("state"),
        Command::Preop => (after.raw == Some(PRE_OPERATIONAL)).then_some("state"),
        // A node that was silent before tells nothing by being silent.
        Command::Stop => (row.before.is_some() && is_silent).then_some("silence"),
        Command::Reset => booted.then_some("boot_up"),
    };
    row.error = after.error.filter(|_| row.proof.is_none());
}

fn question(command: Command, node: Option<u8>, rows: &[BusOrdered]) -> Question {
    let whom = node.map_or_else(
        || both!("all nodes of this bus", "allen Knoten dieses Busses"),
        |node| both!("node {node}", "Knoten {node}"),
    );
    let told = |row: &BusOrdered| {
        let (address, drive) = (row.address, &row.drive);
        let silent = both!("does not answer", "antwortet nicht");
        let state = row.before_text.as_ref().unwrap_or(&silent);
        both!("node {address} ({drive}): {state}", "Knoten {address} ({drive}): {state}", state)
    };
    let flows = match command {
        Command::Start => both!(
            "PDOs flow behind it: what they bring, such as control words and setpoints, is obeyed at once, also by drives that did not show \
             themselves here",
            "danach fließen PDOs: was sie bringen, etwa Steuerworte und Sollwerte, wird sofort befolgt, auch von Umrichtern, die sich hier \
             nicht zeigten"
        ),
        _ => both!(
            "it begins anew on the bus, and a master starts it again: what PDOs bring then is obeyed at once",
            "er beginnt am Bus von vorn, und ein Master startet ihn wieder: was PDOs dann bringen, wird sofort befolgt"
        ),
    };
    let name = command.name();
    Question {
        hazards: vec![Hazard::Motion],
        title: both!("tell {whom}: {name}", "{name} an {whom}", whom),
        details: rows.iter().map(told).chain([flows]).collect(),
    }
}

/// That it is no stop of a shaft.
fn no_stop(command: Command) -> Option<Warning> {
    let message = both!(
        "this is no stop of a shaft: what PDOs brought may stay in force, a drive that waits for them may trip, and a master starts the nodes \
         again; a drive is stopped over its serial plug (statemachine quick-stop)",
        "das ist kein Halt einer Welle: was PDOs gebracht haben, kann gültig bleiben, ein Umrichter, der auf sie wartet, kann auf Störung \
         gehen, und ein Master startet die Knoten wieder; angehalten wird ein Umrichter über seinen seriellen Anschluss (statemachine quick-stop)"
    );
    (!command.may_turn()).then(|| Warning { code: "bus.no_stop".to_owned(), message })
}

/// Why it is not proven that all obeyed.
fn verdict(command: Command, rows: &[BusOrdered]) -> Option<Failure> {
    let unproven: Vec<_> = rows.iter().filter(|row| row.proof.is_none()).map(|row| row.address.to_string()).collect();
    let name = command.name();
    if rows.is_empty() {
        let message = both!(
            "{name} went out, and no node is known that could show whether it was obeyed",
            "{name} ging hinaus, und es ist kein Knoten bekannt, der zeigen könnte, ob es befolgt wurde"
        );
        let hint = both!("--node names one, which is asked then", "--node nennt einen, der dann gefragt wird");
        return Some(Failure::new(Class::Silence, "silence.unproven", message).hint(hint));
    }
    if unproven.is_empty() {
        return None;
    }
    let nodes = unproven.join(", ");
    let message = both!(
        "{name} went out, but nothing proves that it was obeyed: node {nodes}",
        "{name} ging hinaus, aber nichts beweist, dass es befolgt wurde: Knoten {nodes}"
    );
    let class = if unproven.len() < rows.len() {
        Class::Partial
    } else if rows.iter().any(|row| row.after.is_some()) {
        Class::No
    } else {
        Class::Silence
    };
    let code = match class {
        Class::Partial => "partial.unproven",
        Class::No => "no.unproven",
        _ => "silence.unproven",
    };
    Some(Failure::new(class, code, message))
}

/// What goes over a CAN bus alone.
pub(super) fn no_bus() -> Failure {
    let message = both!("this goes over a CAN bus alone", "das geht nur über einen CAN-Bus");
    Failure::new(Class::Usage, "usage.no_can", message).hint(both!(
        "name the adapter with -p slcan:/dev/ttyACM0; on the bench --protocol sdo",
        "den Adapter mit -p slcan:/dev/ttyACM0 nennen; am Prüfstand --protocol sdo"
    ))
}

fn not_by_address() -> Failure {
    let message = both!("-a is not used here", "-a gilt hier nicht");
    let hint = both!("--node names the node that is told", "--node nennt den Knoten, dem es gesagt wird");
    Failure::new(Class::Usage, "usage.address", message).hint(hint)
}

fn other_master() -> Failure {
    let message = both!(
        "a master is active on this bus, and the network is his; nothing was sent",
        "an diesem Bus ist ein Master aktiv, und das Netzwerk gehört ihm; es wurde nichts gesendet"
    );
    Failure::new(Class::Forbidden, "forbidden.other_master", message).hint(both!(
        "--force sends it all the same; a master undoes it, a drive at the latest behind its boot-up delay (P.904)",
        "--force sendet es trotzdem; ein Master macht es rückgängig, ein Umrichter spätestens nach seinem Boot-Up Delay (P.904)"
    ))
}
