//! `monitor`: watches parameters of one or several drives until somebody ends it. Never writes.
//!
//! A round asks every drive for every parameter. What a drive does not answer is a gap in its sample, and the round
//! goes on with the next drive. What is sampled goes out as records at once; only the first round is held back until
//! it is known what there is to watch.

mod over_profibus;
mod record;
mod trigger;

pub use record::recording;

use super::lines::OverLines;
use super::output::of_file;
use super::profibus::{ModeArg, SlaveArgs};
use super::verb::{Flow, Verb, Working};
use super::{Context, addresses_to_read, check_number, connect, offline, output, plan, read_question, terms};
use crate::args::{Settings, Takes, Template, called, parse_span, templates};
use crate::drive::{Calls, Chosen, Item, Place, Rounds, Signal, Upper, When, Window, watch};
use crate::failure::{Class, Failure};
use crate::files::{self, FileError};
use crate::outcome::{Outcome, Record};
use crate::profile::{DataSets, Family, Param, Selection, Selector};
use crate::text::{Wrong, both};
use crate::tick::Span;
use clap::Args as ClapArgs;
use std::io;
use std::path::{Path, PathBuf};

/// Watches drives: state, setpoint, actual value, current, fault.
///
/// Warnings too, or parameters of your choice. On a terminal a live view with a chart; into a pipe or a file one line a sample. `--format ndjson` (or --json: a
/// stream has no end to wait for) and `--format csv` are for programs; `--format influx` (InfluxDB line protocol) and
/// `--format openmetrics` feed Telegraf, Prometheus and their like. Nothing is ever written to a drive.
///
/// A drive that does not answer is a gap in the data, and the watch goes on. Ctrl-C is the usual way to end it, and
/// ends it with exit code 0, like --count, --duration and the end of stdin (--gather). If nothing ever answered it is 4; a lost port is 3, unless
/// --reconnect waits for it.
///
/// Parameters are named as for `read`.
///
/// Over PROFIBUS (--protocol dp) a slave is taken for it, held by the stop word, and let go. Status word, setpoint and frequency come with
/// every exchange, with --interval 0 at the speed of the bus; other parameters are asked for, over PKW.
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    /// 210, 480@2, rated-speed, @actual
    ///
    /// Named as for `read`. [default: state, setpoint, actual frequency, current, fault, warnings; of LXM05 state, mode, target speed,
    /// position]
    #[arg(value_name = "PARAMETER")]
    pub params: Vec<String>,

    /// Time from round to round
    ///
    /// 0 is as fast as the line allows.
    #[arg(long, value_name = "TIME", default_value = "1s", value_parser = interval)]
    pub interval: Span,

    /// Take a round for each line on stdin
    ///
    /// In place of --interval: as Telegraf's execd asks with signal = "STDIN", or Enter on a terminal. What the line says does not matter; lines that
    /// come faster than rounds wait for their turn. The end of stdin ends the watch, with exit code 0.
    #[arg(long, value_name = "stdin", value_parser = ["stdin"], ignore_case = true, conflicts_with = "interval", hide_short_help = true)]
    pub gather: Option<String>,

    /// End after this time
    #[arg(long, visible_alias = "for", value_name = "TIME", value_parser = parse_span)]
    pub duration: Option<Span>,

    /// End after this many rounds
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub count: Option<u64>,

    /// Wait for a port that is lost, and go on
    ///
    /// Such as an adapter that was unplugged. A USB adapter is known by its serial number: it is found under another name, and another adapter under its old name
    /// is left alone. One without a serial number is known by its socket, or by its name.
    #[arg(long)]
    pub reconnect: bool,

    /// One line that is refreshed, in place of the live view
    #[arg(long)]
    pub line: bool,

    /// Keep a file with the last round, for Prometheus
    ///
    /// In Prometheus' text format, for node_exporter's textfile collector and whatever reads such files: written anew after each round, whole, and renamed. A file with anything
    /// else in it is left alone.
    #[arg(long, value_name = "FILE")]
    pub textfile: Option<PathBuf>,

    /// Keep what comes in a file
    ///
    /// CSV if it ends with .csv, or with anything but .ndjson under --format csv; else NDJSON. Each line is written whole. A file that exists is replaced only
    /// with --force. With --trigger only what lies around a trigger is kept.
    #[arg(long, value_name = "FILE")]
    pub record: Option<PathBuf>,

    /// Wait for something: 'current > 12A'
    ///
    /// 'state -> fault', 'frequency rising 10Hz' or falling, 'status-word:fault rising'; or the name of one of `[triggers]` in antrieb.toml.
    /// A comparison triggers when it becomes true; of several triggers any will do. Names are those of `read`, or setpoint, actual, current,
    /// voltage, fault, warnings. What a trigger looks at is watched too.
    #[arg(long, value_name = "WHEN")]
    pub trigger: Vec<String>,

    /// So long before a trigger is recorded [default: 2s]
    #[arg(long, value_name = "TIME", value_parser = parse_span, requires = "trigger", hide_short_help = true)]
    pub pre: Option<Span>,

    /// So long behind a trigger is recorded [default: 5s]
    #[arg(long, value_name = "TIME", value_parser = parse_span, requires = "trigger", hide_short_help = true)]
    pub post: Option<Span>,

    /// End behind the first trigger
    #[arg(long, requires = "trigger")]
    pub once: bool,

    /// On the bench: do not follow the wall clock
    ///
    /// Minutes of the bench take milliseconds.
    #[arg(long, hide_short_help = true)]
    pub unpaced: bool,

    /// How a slave is taken.
    #[command(flatten)]
    pub slave: SlaveArgs,
    /// How it is led.
    #[command(flatten)]
    pub mode: ModeArg,
}

impl Verb for Args {
    const NAME: &'static str = "monitor";
    const TAKES: Takes = Takes::READS;
    const PROFIBUS: bool = true;
    const SDO: bool = true;
    const EXAMPLES: &'static [&'static str] = &[
        "antrieb --port sim -a 1,2 monitor --count 3 --interval 500ms",
        "antrieb --port sim -a 1 monitor @actual --duration 1m --unpaced --format csv",
        "antrieb --port sim --protocol dp -a 3 monitor --interval 0 --count 9 --yes",
        "antrieb -p sim monitor --count 9 --record run.csv --trigger 'current > 12A'",
    ];
    const UPPER: Upper = Upper::drive(30).each(12, "parameter in each round").unless(
        "It goes on until Ctrl-C, which is its normal end, --duration, --count or the end of stdin (--gather).",
    );
    type Prints = Record;

    fn over_lines(&self) -> OverLines {
        OverLines::One(Some(both!(
            "a watch is of one line: one for each, with its port behind -p, such as in terminals side by side",
            "beobachtet wird eine Leitung: ein Aufruf für jede, mit ihrem Anschluss hinter -p, etwa in mehreren Terminals"
        )))
    }

    fn streams(&self) -> Option<Flow> {
        let (textfile, record) = (self.textfile.clone(), self.record.clone());
        Some(Flow::Samples { line: self.line, gather: self.gather.is_some(), textfile, record })
    }

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(run(self, context))
    }
}

/// What keeps the last round in a file, as a text that is whole at any time. A file that holds anything else is left alone.
pub fn keeper(path: PathBuf) -> io::Result<impl FnMut(&str) -> io::Result<()>> {
    let is_ours = |text: String| text.is_empty() || text.starts_with("# TYPE antrieb_");
    match files::read(&path, files::TEXT).map(is_ours) {
        Ok(true) => {}
        Ok(false) => return Err(of_file(&path, FileError::Exists)),
        Err(error) if error.is_missing() => {}
        Err(error) => return Err(of_file(&path, error)),
    }
    files::check(&path, true).map_err(|error| of_file(&path, error))?;
    Ok(move |text: &str| files::write_whole(&path, text, true).map_err(|error| of_file(&path, error)))
}

/// Watches until the count or the time is over, the port is lost, or somebody ends it.
pub async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let wanted = Wanted::of(args, context.settings)?;
    if args.mode.is_meant(&args.slave, context.settings)? {
        return over_profibus::run(args, wanted, context).await;
    }
    let Context { settings, registry, interrupt, observe, calls, .. } = context;
    let addresses = addresses_to_read(settings, *observe)?;
    // Names are checked before the port is opened: some drive must know all of them.
    let (family, chosen) = offline(settings, registry, |family| wanted.chosen(family))?;
    if settings.dry_run {
        let items = chosen.items;
        let sets = items.iter().flat_map(|item| item.sets().wire().into_iter().map(move |set| (item.param(), set)));
        let questions: Vec<_> = sets.map(|(param, set)| read_question(param, set)).collect();
        return plan(context, &family, &questions);
    }
    if let Some(path) = &args.record {
        output::check_in_place(path, settings.force)?;
    }
    let mut session = connect(settings, registry, interrupt, *observe).await?;
    if !args.unpaced {
        session.pace();
    }
    let select = |family: &Family| wanted.chosen(family);
    let rounds = rounds(args, &wanted, calls.take());
    let mut names = called(settings)?;
    let places: Vec<_> =
        addresses.into_iter().map(|address| Place { address, called: names.remove(&address) }).collect();
    let waited = wanted.waits_for(args);
    let outcome = watch(&mut session, &terms(settings, registry)?, rounds, &places, &chosen, &select).await;
    Ok(record::told(outcome, waited))
}

/// How often, and until when.
fn rounds(args: &Args, wanted: &Wanted, calls: Option<Calls>) -> Rounds {
    let Args { interval, duration, count, reconnect, .. } = *args;
    let when = calls.map_or(When::Every(interval), When::Called);
    Rounds { when, duration, count, reconnect, window: wanted.window }
}

/// What is watched and waited for, in words.
struct Wanted {
    selectors: Vec<Selector>,
    triggers: Vec<String>,
    window: Window,
}

/// So much around a trigger is recorded, or told of, if nobody says otherwise.
pub(super) const PRE: Span = Span::from_secs(2);
pub(super) const POST: Span = Span::from_secs(5);
/// What lies before a trigger is kept in memory until it comes.
const LONGEST_PRE: Span = Span::from_secs(600);

impl Wanted {
    /// What was typed, and what the project file says of triggers that were called by their names.
    fn of(args: &Args, settings: &Settings) -> Result<Self, Failure> {
        let known = templates(settings)?;
        let mut params = args.params.clone();
        let (mut pre, mut post, mut triggers) = (args.pre, args.post, Vec::new());
        // What one of several wants keeps none of the others from being waited for.
        let ends = |text: &String| known.get(text.trim()).is_some_and(|template| template.once);
        let once = args.once || !args.trigger.is_empty() && args.trigger.iter().all(ends);
        for text in &args.trigger {
            let Some(template) = known.get(text.trim()) else {
                triggers.push(text.clone());
                continue;
            };
            let Template { when, watch, .. } = template;
            triggers.push(when.clone());
            params.extend(watch.iter().filter(|_| args.params.is_empty()).cloned());
            pre = pre.or(time(text, template.pre.as_deref())?);
            post = post.or(time(text, template.post.as_deref())?);
        }
        if let Some(stranger) = triggers.iter().find(|text| !trigger::is_condition(text)) {
            let names = known.keys().cloned().collect::<Vec<_>>().join(", ");
            let message = match names.is_empty() {
                true => both!(
                    "there is no trigger '{stranger}', and no `[triggers]` in antrieb.toml",
                    "es gibt keinen Auslöser '{stranger}' und keine `[triggers]` in antrieb.toml"
                ),
                false => both!(
                    "there is no trigger '{stranger}' (`[triggers]` has: {names})",
                    "es gibt keinen Auslöser '{stranger}' (`[triggers]` hat: {names})"
                ),
            };
            return Err(Failure::new(Class::Usage, "usage.trigger", message).hint(trigger::shapes()));
        }
        let window = Window { pre: pre.unwrap_or(PRE), post: post.unwrap_or(POST), once };
        if window.pre > LONGEST_PRE {
            let message = both!("--pre: expected at most {LONGEST_PRE}", "--pre: erwartet: höchstens {LONGEST_PRE}");
            return Err(Failure::new(Class::Usage, "usage.pre", message));
        }
        let selectors = params.iter().map(|text| text.parse().map_err(|error| super::read::select_failure(&error)));
        Ok(Wanted { selectors: selectors.collect::<Result<_, _>>()?, triggers, window })
    }

    /// The file that holds nothing but what lies around a trigger.
    fn waits_for<'a>(&self, args: &'a Args) -> Option<&'a Path> {
        (!self.triggers.is_empty()).then_some(args.record.as_deref()).flatten()
    }

    /// What that is in a family; what a trigger looks at comes last, unless it is watched anyway.
    fn chosen(&self, family: &Family) -> Result<Chosen, Failure> {
        let mut items = items(&self.selectors, family)?;
        let waited_for = self.triggers.iter().map(|text| trigger::condition(text, family));
        let waited_for = waited_for.collect::<Result<Vec<_>, _>>()?;
        for condition in &waited_for {
            let looked_at = match &condition.signal {
                Signal::Value(item, _) => Some(Item::clone(item)),
                Signal::State => family.role("status-word").map(|param| named(param.clone())),
            };
            let known = |item: &Item| {
                items.iter().any(|known| known.param().id == item.param().id && known.sets() == item.sets())
            };
            if let Some(item) = looked_at.filter(|item| !known(item)) {
                items.push(item);
            }
        }
        if items.is_empty() {
            return Err(nothing_usual(family));
        }
        Ok(Chosen { items, waited_for })
    }
}

/// A time of a template.
fn time(name: &str, text: Option<&str>) -> Result<Option<Span>, Failure> {
    let wrong = |why: Wrong| {
        let message = both!("triggers.{name}: {why}", "triggers.{name}: {why}", why = why.0);
        Failure::new(Class::Data, "data.config", message)
    };
    text.map(|text| parse_span(text).map_err(wrong)).transpose()
}

fn named(param: Param) -> Item {
    Item::new(Selection { param, sets: DataSets::Unnamed, of_group: true, lenient: true })
}

/// What it is to do; of a servo drive the speed that the bus gives it.
const SETPOINT: &[&str] = &["setpoint-ramp", "setpoint-bus", "setpoint-velocity"];

/// What a drive does, in the order in which one of it is taken: of a servo no source tells the address of its speed.
const ACTUAL: &[&str] = &["actual-frequency", "stator-frequency", "encoder-frequency", "actual-speed", "position"];

/// Roles of the default view; of several actual values one will do, and only if its decimals are known.
const DEFAULT: [&[&str]; 8] = [
    &["status-word"],
    &["mode-active"],
    SETPOINT,
    ACTUAL,
    &["current"],
    &["dc-link-voltage"],
    &["fault"],
    &["warnings"],
];

/// What is shown of a drive where nobody names anything.
pub(super) fn usual(family: &Family) -> Vec<Item> {
    let mut usual: Vec<Param> = DEFAULT.iter().filter_map(|roles| one_of(roles, family)).collect();
    // A catalogue of one's own may name them in a group instead.
    let actual = Selector::group("actual").resolve(family).unwrap_or_default();
    let is_told = ACTUAL.iter().any(|role| family.role(role).is_some());
    for Selection { param, .. } in actual.into_iter().filter(|_| !is_told) {
        if usual.iter().all(|known| known.id != param.id) {
            usual.push(param);
        }
    }
    usual.into_iter().filter(|param| !moves_on(family, param)).map(named).collect()
}

/// The same for a run: with the parameter that takes its setpoint, where a drive tells no other one.
pub(super) fn usual_of_run(family: &Family, setpoint: Option<&Param>) -> Vec<Item> {
    let mut items = usual(family);
    let tells_one = ["setpoint-ramp", "setpoint-bus"].iter().any(|role| family.role(role).is_some());
    let is_shown = |param: &&Param| tells_one || items.iter().any(|item| item.param().id == param.id);
    if let Some(setpoint) = setpoint.filter(|param| !is_shown(param)) {
        let place = items.len().min(1);
        items.insert(place, named(setpoint.clone()));
    }
    items
}

/// The first parameter with one of these roles; rather one of which a source tells the decimals.
fn one_of(roles: &[&str], family: &Family) -> Option<Param> {
    let mut known = roles.iter().filter_map(|role| family.role(role));
    known.clone().find(|param| param.has_scale()).or_else(|| known.next()).cloned()
}

/// What the selectors mean in this family; without any, the roles of the default view.
fn items(selectors: &[Selector], family: &Family) -> Result<Vec<Item>, Failure> {
    if selectors.is_empty() {
        return Ok(usual(family));
    }
    let mut items = Vec::new();
    for selector in selectors {
        if let Some(item) = trigger::short(&selector.to_string(), family) {
            items.push(item?);
            continue;
        }
        let selections = selector.resolve(family).map_err(|error| super::read::select_failure(&error))?;
        for selection in selections {
            // Whoever names it alone wants it so.
            if selection.of_group && moves_on(family, &selection.param) {
                continue;
            }
            check_number(family, &selection.param)?;
            items.push(Item::new(selection));
        }
    }
    Ok(items)
}

/// Nobody knows which of the parameters of a family of one's own are its actual values.
fn nothing_usual(family: &Family) -> Failure {
    let drive = &family.drive;
    let message = both!(
        "the catalogue of '{drive}' does not say what its actual values are: name the parameters to be watched",
        "der Katalog von '{drive}' sagt nicht, was die Istwerte sind: zu beobachtende Parameter nennen"
    );
    Failure::new(Class::Usage, "usage.params", message)
        .hint(both!("`antrieb params` lists them", "`antrieb params` listet sie auf"))
}

/// Whether reading a parameter again and again may change what it shows: an entry of the fault memory, of which the next
/// may be read the next time. The state tells of a fault as well, and `diag` shows the memory once.
fn moves_on(family: &Family, param: &Param) -> bool {
    family.fault_codes.memory && family.role("fault").is_some_and(|fault| fault.id == param.id)
}

/// Like any other time, but 0 needs no unit.
fn interval(text: &str) -> Result<Span, Wrong> {
    if text.trim() == "0" { Ok(Span::ZERO) } else { parse_span(text) }
}
