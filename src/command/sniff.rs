//! `sniff`: listens to what others say on a line. Never sends.

use super::monitor::{POST, PRE};
use super::profibus;
use super::verb::{Flow, Verb, Working};
use super::{Context, connect, listen, named_family, offline_family, output, telegram_reader};
use crate::args::{self, Origin, Settings, Takes, parse_span};
use crate::drive::decode::dp::Cyclic;
use crate::drive::{Filter, Listening, Port, Unknown, sniff};
use crate::failure::{Class, Failure};
use crate::outcome::{Data, Document, OrPlan, Outcome, Plan, Sniff, SniffSearch};
use crate::text::{Text, both};
use crate::tick::Span;
use clap::Args as ClapArgs;
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// Listens on a line and tells every telegram. Never sends.
///
/// When it came, who speaks, the bytes, and what they say.
/// The line is not asked what is spoken on it: name `--protocol`, `--baud` and `--parity`, or let --search find them. Parameters are named as in the
/// catalogue of --drive (acu, if none is named). Every telegram is a line as it comes, with `--format ndjson` a
/// record; --json and CSV tell all at the end.
///
/// PROFIBUS-DP (--protocol dp) is told of any master; what Data_Exchange carries says --cfg. On a CAN bus (--protocol sdo, or a CAN port)
/// every frame is told; the adapter is opened to listen only, and the statistics are of SDO.
///
/// At the end, and with --statistics on the way, stands what was counted of each station: requests, replies, no answer, refusals, how often
/// it was asked again, reply times, disturbed telegrams, pauses that were too short; and how full the line is.
///
/// Times are milliseconds since the port was opened. `>` is a request, `<` a reply, `?` could be either, `!` is
/// disturbed.
///
/// Ctrl-C is the usual way to end it, and ends it with exit code 0, like --count and --duration. If nothing was heard it is
/// 4, if nothing of it is a telegram 5. The bench and recordings, whose time is virtual, end after 10 s of silence.
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    /// End after this time
    #[arg(long, visible_alias = "for", value_name = "TIME", value_parser = parse_span)]
    pub duration: Option<Span>,

    /// End after this many telegrams
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub count: Option<u64>,

    /// Find the setting of the line first, by listening
    ///
    /// For 1.25 s at each setting, the likeliest first: all of 49 take a minute. What is typed (`--baud`, `--parity`, `--protocol`) stays; `auto` in its place is
    /// looked for without --search too. Once through, or again and again until --duration is over. It finds who polls once a second or more often.
    #[arg(long)]
    pub search: bool,

    /// Keep a capture for Wireshark; - is stdout
    ///
    /// Classic pcap of link type 250 (RTAC Serial); `-d rtacser.data,mbrtu` takes its payload apart as Modbus RTU. Of a CAN bus link type 227
    /// (SocketCAN), with `-d can.subdissector,canopen`. A file that is there is left alone without --force.
    #[arg(long, value_name = "FILE")]
    pub pcap: Option<PathBuf>,

    /// Tell only such telegrams: 'address=3 !reply'
    ///
    /// Words that must all be true: request, reply, refused, disturbed, address=1,5-9, function=3,6, hex=4178 (bytes within it); a !
    /// before a word turns it around. With several --filter any of them will do. The statistics count everything.
    #[arg(long, value_name = "WORDS", value_parser = Filter::from_str)]
    pub filter: Vec<Filter>,

    /// Wait for such a telegram, tell what is near
    ///
    /// Words as of --filter. Nothing is told but what lies within --pre before it and --post behind it.
    #[arg(long, value_name = "WORDS", value_parser = Filter::from_str)]
    pub trigger: Vec<Filter>,

    /// So long before a trigger is told [default: 2s]
    #[arg(long, value_name = "TIME", value_parser = parse_span, requires = "trigger", hide_short_help = true)]
    pub pre: Option<Span>,

    /// So long behind a trigger is told [default: 5s]
    #[arg(long, value_name = "TIME", value_parser = parse_span, requires = "trigger", hide_short_help = true)]
    pub post: Option<Span>,

    /// End behind the first trigger
    #[arg(long, requires = "trigger")]
    pub once: bool,

    /// What PROFIBUS carries: basic, ppo1 to ppo5, or hex
    ///
    /// No telegram of Data_Exchange says it; Chk_Cfg and Get_Cfg do.
    #[arg(long, value_name = "CFG", hide_short_help = true, help_heading = "PROFIBUS")]
    pub cfg: Option<Cyclic>,

    /// Tell the statistics so often, not only at the end
    #[arg(long, value_name = "TIME", value_parser = parse_span)]
    pub statistics: Option<Span>,
}

/// Where time is virtual, silence would never be cut short by anybody.
const QUIET: Span = Span::from_secs(10);

impl Verb for Args {
    const NAME: &'static str = "sniff";
    const TAKES: Takes = Takes::LISTENS;
    const PROFIBUS: bool = true;
    const SDO: bool = true;
    const EXAMPLES: &'static [&'static str] = &[
        "antrieb --port /dev/ttyUSB0 --baud 19200 sniff --duration 1m",
        "antrieb --port tape:line.txt sniff --drive act --format ndjson",
        "antrieb -p /dev/ttyUSB0 --protocol dp --baud 93750 sniff --cfg ppo1",
        "antrieb -p /dev/ttyUSB0 sniff --pcap line.pcap --filter 'address=3'",
        "antrieb -p slcan:/dev/ttyACM0 -b 500000 sniff --duration 1m",
    ];
    type Prints = Document<OrPlan<Sniff>>;

    fn streams(&self) -> Option<Flow> {
        Some(Flow::Telegrams { capture: self.pcap.clone() })
    }

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(run(self, context))
    }
}

/// Listens until the time or the count is over, or somebody ends it.
pub async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let Context { settings, registry, interrupt, observe, .. } = context;
    let cyclic = settings.profibus.then_some(args.cfg);
    match cyclic {
        None if args.cfg.is_some() => return Err(only_on_profibus()),
        None => {}
        Some(_) => profibus::refuse(&[("--search", args.search)])?,
    }
    if settings.is_can() {
        fits_bus(args)?;
    }
    let usual = match (settings.profibus, settings.is_can()) {
        (true, _) => Some(INVERTER),
        (_, true) => Some(CUBE),
        _ => None,
    };
    let family = match usual {
        Some(usual) => named_family(settings, registry, settings.drive.as_deref().unwrap_or(usual))?,
        None => offline_family(settings, registry)?,
    };
    if settings.dry_run {
        return Ok(Outcome::of(Data::Plan(Plan { dry_run: true, telegrams: Vec::new(), notes: Vec::new() })));
    }
    if matches!(settings.port, Some(Port::Mbtcp(_))) {
        return Err(no_line());
    }
    if let Some(path) = args.pcap.as_deref().filter(|path| *path != Path::new("-")) {
        output::check(path, settings.force)?;
    }
    let unknown = unknown(args, settings);
    if unknown.any() && matches!(settings.port, Some(Port::Tape(_))) {
        return Err(recorded());
    }
    let is_virtual = matches!(settings.port, Some(Port::Sim(_) | Port::Tape(_)));
    // A bus is never quiet where somebody beats its time.
    let endless = is_virtual && settings.is_can() && args.count.is_none();
    let plan = Listening {
        duration: args.duration.or(endless.then_some(QUIET)),
        quiet: (is_virtual && args.duration.is_none()).then_some(QUIET),
        count: args.count,
        keep: settings.tells_at_the_end(),
        unknown,
        statistics: args.statistics,
        filters: args.filter.clone(),
        triggers: args.trigger.clone(),
        pre: args.pre.unwrap_or(PRE),
        post: args.post.unwrap_or(POST),
        once: args.once,
        profibus: cyclic,
    };
    // What is looked for is known to nobody yet.
    let settings = &Settings { unknown: args::Unknown::default(), ..(*settings).clone() };
    let mut session = match settings.is_can() {
        true => listen(settings, registry, interrupt, *observe).await?,
        false => connect(settings, registry, interrupt, *observe).await?,
    };
    let (heard, failure) = sniff(&mut session, &telegram_reader(settings, &family), plan).await;
    let failure = failure.or_else(|| unheard(&heard));
    let failure = match settings.port {
        Some(Port::Tape(_)) if settings.is_can() => failure.map(|failure| failure.hint(of_a_tape())),
        _ => failure,
    };
    Ok(Outcome { data: Some(Data::Sniff(heard)), warnings: Vec::new(), failure })
}

/// By whose names PROFIBUS is told where no inverter is named, and CAN where no drive is.
const INVERTER: &str = "l200";
const CUBE: &str = "acu";

/// Refuses what means nothing on a CAN bus.
fn fits_bus(args: &Args) -> Result<(), Failure> {
    let words = args.filter.iter().chain(&args.trigger);
    let (what, hint) = match (args.search, words.into_iter().any(Filter::names_function)) {
        (true, _) => (
            both!(
                "--search finds baud, parity and protocol of a serial line; a CAN bus has a bit rate alone, and at another one the adapter \
                 tells errors",
                "--search findet Baud, Parität und Protokoll einer seriellen Leitung; ein CAN-Bus hat nur eine Bitrate, und bei einer anderen \
                 meldet der Adapter Fehler"
            ),
            both!("name the bit rate with -b: it is P.903", "die Bitrate mit -b angeben: sie steht in P.903"),
        ),
        (_, true) => (
            both!("a frame of CAN has no function code", "ein CAN-Frame hat keinen Funktionscode"),
            both!(
                "expected words such as request, reply, refused, disturbed, address=1,5-9 (nodes), hex=4178",
                "erwartet: Wörter wie request, reply, refused, disturbed, address=1,5-9 (Knoten), hex=4178"
            ),
        ),
        _ => return Ok(()),
    };
    Err(Failure::new(Class::Usage, "usage.sdo", what).hint(hint))
}

/// What a recording of a bus is for.
fn of_a_tape() -> Text {
    both!(
        "only a recording of `sniff` or `systembus monitor` plays back here; `antrieb decode trace FILE` reads any",
        "hier läuft nur eine Aufzeichnung von `sniff` oder `systembus monitor` ab; `antrieb decode trace DATEI` liest jede"
    )
}

fn only_on_profibus() -> Failure {
    let message = both!("--cfg means something on PROFIBUS alone", "--cfg bedeutet nur am PROFIBUS etwas");
    Failure::new(Class::Usage, "usage.profibus", message)
        .hint(both!("add --protocol dp, or leave it out", "--protocol dp angeben oder es weglassen"))
}

/// What is to be found: whatever was said to be auto, and with --search whatever was not typed.
fn unknown(args: &Args, settings: &Settings) -> Unknown {
    let args::Unknown { baud, parity, protocol } = settings.unknown;
    let sought = |name| args.search && !matches!(settings.origin(name), Origin::Flag);
    Unknown {
        baud: baud || sought("baud"),
        parity: parity || sought("parity"),
        protocol: protocol || sought("protocol"),
    }
}

/// Why no setting was found.
fn unfound(port: &str, search: SniffSearch) -> Failure {
    let SniffSearch { tried, characters, .. } = search;
    let again = both!(
        "`antrieb sniff --search --duration 10m` goes through them again and again",
        "`antrieb sniff --search --duration 10m` geht sie immer wieder durch"
    );
    if characters == 0 {
        let text = both!(
            "nothing was heard on {port}, at {tried} settings",
            "auf {port} war nichts zu hören, bei {tried} Einstellungen"
        );
        return Failure::new(Class::Silence, "silence.nothing_heard", text).hint(both!(
            "sniff never sends: is a master asking on this line, once a second? Check A and B; {again}",
            "sniff sendet nie: Fragt ein Master auf dieser Leitung, jede Sekunde? A und B prüfen; {again}",
            again
        ));
    }
    let text = both!(
        "somebody speaks on {port}, but at {tried} settings no two telegrams came ({characters} characters)",
        "auf {port} spricht jemand, aber bei {tried} Einstellungen kamen keine zwei Telegramme ({characters} Zeichen)"
    );
    Failure::new(Class::Garbled, "garbled.nothing_valid", text).hint(both!(
        "is another protocol spoken there? Check A and B, termination and bias; {again}",
        "Wird dort ein anderes Protokoll gesprochen? A und B, Abschluss und Ruhepegel prüfen; {again}",
        again
    ))
}

/// Why it was of no use to listen.
fn unheard(sniff: &Sniff) -> Option<Failure> {
    let summary = &sniff.summary;
    match summary.search {
        Some(search) if !search.found => return Some(unfound(&summary.port, search)),
        // The telegrams by which it was found were heard.
        Some(_) if summary.count.heard == 0 => return None,
        _ => {}
    }
    let (line, protocol, heard) = (&summary.line, summary.protocol, summary.count.heard);
    let asks = if protocol == "dp" { "profibus live" } else { "scan" };
    let failure = match (heard, heard - summary.count.garbled) {
        (0, _) => Failure::new(
            Class::Silence,
            "silence.nothing_heard",
            both!(
                "nothing was heard on {port} at {line}",
                "auf {port} war bei {line} nichts zu hören",
                port = summary.port
            ),
        )
        .hint(both!(
            "sniff never sends: is a master asking on this line? Check A and B; `antrieb {asks}` asks itself, and \
             `antrieb decode trace FILE` reads a recording with what was sent",
            "sniff sendet nie: Fragt ein Master auf dieser Leitung? A und B prüfen; `antrieb {asks}` fragt selbst, und \
             `antrieb decode trace DATEI` liest eine Aufzeichnung mit dem, was gesendet wurde"
        )),
        (_, 0) => Failure::new(
            Class::Garbled,
            "garbled.nothing_valid",
            both!(
                "nothing that was heard is a telegram of {protocol} at {line}",
                "nichts des Gehörten ist ein Telegramm von {protocol} bei {line}"
            ),
        )
        .hint(both!(
            "`antrieb sniff --search` finds the setting of the line",
            "`antrieb sniff --search` findet die Einstellung der Leitung"
        )),
        _ => return None,
    };
    Some(failure)
}

fn recorded() -> Failure {
    let text = both!(
        "a recording has the setting at which it was made: there is none to look for",
        "eine Aufzeichnung hat die Einstellung, bei der sie entstand: es gibt keine zu suchen"
    );
    Failure::new(Class::Usage, "usage.search", text)
        .hint(both!("its first line names the setting", "ihre erste Zeile nennt die Einstellung"))
}

fn no_line() -> Failure {
    let text = both!(
        "behind a Modbus/TCP gateway there is nothing to listen to: it passes on only answers to our own questions",
        "hinter einem Modbus/TCP-Gateway gibt es nichts zu hören: es gibt nur Antworten auf eigene Fragen weiter"
    );
    let hint = both!(
        "expected a serial port, tcp://HOST:PORT or rfc2217://HOST:PORT",
        "erwartet: ein serieller Anschluss, tcp://HOST:PORT oder rfc2217://HOST:PORT"
    );
    Failure::new(Class::Usage, "usage.no_line", text).hint(hint)
}
