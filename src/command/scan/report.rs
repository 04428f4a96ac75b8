//! What came of the search: one result of all ports, and why it is not all that was asked for.

use super::Args;
use crate::args::Settings;
use crate::command::on_bus::silent;
use crate::drive::{Port, ScanResult, Searched, Talker, Yielded, ranges};
use crate::failure::{Class, Failure};
use crate::outcome::{Data, FoundDrive, Outcome, Scan, Search, Warning};
use crate::text::{Text, both};
use crate::tick::Span;

/// One result of all that the ports brought.
pub(super) fn report(
    args: &Args,
    settings: &Settings,
    ports: &[Port],
    lines: Vec<Result<ScanResult, Failure>>,
    before: Option<Scan>,
) -> Outcome {
    let (mut drives, mut searches) = before.map_or_else(Default::default, |scan| (scan.drives, scan.searches));
    let (mut sum, mut is_over_time) = (Sum { complete: true, ..Sum::default() }, false);
    let (mut warnings, mut failures): (Vec<Warning>, Vec<Failure>) = (Vec::new(), Vec::new());
    for (port, line) in ports.iter().zip(lines) {
        let result = match line {
            Ok(result) => result,
            Err(failure) => {
                sum.complete = false;
                failures.push(failure);
                continue;
            }
        };
        let left_out = result.left_out();
        // What was meant to end early leaves nothing out.
        let is_cut = result.cut.is_some() || result.is_over_time || left_out.is_some();
        is_over_time |= result.is_over_time;
        let place =
            |drive: &FoundDrive| (drive.address, drive.port.clone(), drive.line.clone(), drive.protocol.clone());
        let anew: Vec<_> = result.drives.iter().map(place).collect();
        drives.retain(|old| !anew.contains(&place(old)));
        drives.extend(result.drives);
        warnings.extend(result.warnings);
        warnings.extend(coverage(port, ports.len(), &result.searched).filter(|_| is_cut));
        failures.extend(result.unasked.or(result.yielded.map(left_to)).or(left_out));
        failures.extend(result.cut.map(|error| {
            let mut failure = error.failure(0, None);
            failure.context.clear();
            failure
        }));
        sum.left = sum.left.longer(result.left);
        for searched in &result.searched {
            sum.add(searched);
            let search = search(port, searched);
            searches.retain(|old: &Search| {
                (&old.port, &old.line, &old.protocol) != (&search.port, &search.line, &search.protocol)
            });
            searches.push(search);
        }
    }
    let is_over_time = args.within.filter(|_| is_over_time);
    let failure = verdict(settings, failures, ports.len(), drives.is_empty(), &sum);
    let failure = failure.map(|failure| match is_over_time {
        Some(within) if failure.code == NOBODY => over_time(within, settings, &sum),
        _ => failure,
    });
    let data = sum.scan(settings, ports, drives, searches);
    Outcome { data: Some(Data::Scan(data)), warnings, failure }
}

/// How much was to be asked on all ports, and how much was.
#[derive(Debug, Default)]
struct Sum {
    addresses: usize,
    asked: usize,
    /// Asked, but without the full time to answer.
    glimpsed: usize,
    settings: usize,
    done: usize,
    complete: bool,
    left: Span,
}

impl Sum {
    /// What was searched, and what it brought.
    fn scan(&self, settings: &Settings, ports: &[Port], mut drives: Vec<FoundDrive>, searches: Vec<Search>) -> Scan {
        let names: Vec<String> = ports.iter().map(ToString::to_string).collect();
        // In the order of the addresses, not of the finds, so that two scans of one line give the same document.
        drives.sort_by_key(|drive| (names.iter().position(|name| *name == drive.port), drive.address));
        let unknown = settings.unknown;
        let auto = |is_unknown: bool, known: String| if is_unknown { "auto".to_owned() } else { known };
        Scan {
            port: names.join(", "),
            line: auto(unknown.baud || unknown.parity, settings.line.to_string()),
            protocol: auto(unknown.protocol, settings.protocol.name().to_owned()),
            addresses: self.addresses,
            asked: self.asked,
            complete: self.complete,
            settings: self.settings,
            settings_done: self.done,
            left_s: if self.complete { 0 } else { self.left.as_millis().div_ceil(1_000) },
            drives,
            searches,
        }
    }

    /// How many of the addresses were asked, and how thoroughly; one at two settings counts twice.
    fn told(&self) -> Text {
        let Sum { addresses, asked, glimpsed, .. } = self;
        let looked = match glimpsed {
            0 => Text::default(),
            _ => both!(", {glimpsed} only a quick look", ", {glimpsed} nur einen kurzen Blick"),
        };
        both!(
            "{asked} of {addresses} addresses had their full time to answer{looked}",
            "{asked} von {addresses} Adressen hatten ihre volle Zeit für eine Antwort{looked}",
            looked
        )
    }

    fn add(&mut self, searched: &Searched) {
        self.addresses += searched.wanted.len();
        self.asked += searched.asked.len();
        self.glimpsed += searched.glimpsed().len();
        self.settings += 1;
        self.done += usize::from(searched.is_complete());
        self.complete &= searched.is_complete();
    }
}

/// What a search that ended early has covered, and what it has not; settings with the same addresses in one.
fn coverage(port: &Port, ports: usize, searched: &[Searched]) -> Option<Warning> {
    if searched.iter().all(Searched::is_complete) {
        return None;
    }
    let port = if ports > 1 { format!("{port}: ") } else { String::new() };
    let [asked, glimpsed, open] =
        [Searched::asked, Searched::glimpsed, Searched::open].map(|of| grouped(searched, |row| ranges(&of(row))));
    let none = || Text::new("nobody", "niemand");
    let asked = asked.unwrap_or_else(none);
    let glimpsed = glimpsed.map_or_else(Text::default, |told| {
        both!("; only a quick look at: {told}", "; nur ein kurzer Blick auf: {told}", told)
    });
    let open = open.unwrap_or_else(none);
    let message = both!(
        "{port}asked to the end: {asked}{glimpsed}; left open: {open}",
        "{port}zu Ende gefragt: {asked}{glimpsed}; offen: {open}",
        asked,
        glimpsed,
        open
    );
    Some(Warning { code: "scan.open".to_owned(), message })
}

/// `1-247 at 19200 8E1 rtu, 1-32 at 48 settings (9600 8E1 rtu … 2400 7O1 ascii)`; nothing where there are no addresses.
fn grouped(searched: &[Searched], addresses: impl Fn(&Searched) -> String) -> Option<Text> {
    let mut groups: Vec<(String, Vec<String>)> = Vec::new();
    for row in searched {
        let (of, setting) = (few(addresses(row)), row.tuning.to_string());
        match groups.iter_mut().find(|group| group.0 == of) {
            Some((_, settings)) => settings.push(setting),
            None => groups.push((of, vec![setting])),
        }
    }
    groups.retain(|(of, _)| !of.is_empty());
    let told = groups.iter().take(MOST_GROUPS).map(|(of, settings)| {
        let settings = named(settings);
        both!("{of} at {settings}", "{of} mit {settings}", settings)
    });
    let rest: Vec<String> = groups.iter().skip(MOST_GROUPS).flat_map(|(_, settings)| settings.clone()).collect();
    let rest = (!rest.is_empty()).then(|| {
        let settings = named(&rest);
        both!("some at {settings}", "einige mit {settings}", settings)
    });
    let told: Vec<Text> = told.chain(rest).collect();
    (!told.is_empty()).then(|| Text::join(&told, ", "))
}

/// Settings by their names; of many the first and the last, in the order of their likelihood.
fn named(settings: &[String]) -> Text {
    match settings {
        [one] => Text::name(one),
        [one, other] => both!("{one} and {other}", "{one} und {other}"),
        [first, .., last] => {
            let count = settings.len();
            both!("{count} settings ({first} … {last})", "{count} Einstellungen ({first} … {last})")
        }
        [] => Text::default(),
    }
}

/// A list with many gaps tells nobody anything.
fn few(ranges: String) -> String {
    let parts = ranges.split(',').count();
    let last = ranges.rsplit(['-', ',']).next().unwrap_or_default();
    let first = ranges.split(['-', ',']).next().unwrap_or_default();
    if parts > MOST_GROUPS { format!("{first}…{last}") } else { ranges }
}

/// What is told of in words; the document has all of it.
const MOST_GROUPS: usize = 3;

/// What was asked at one setting.
fn search(port: &Port, searched: &Searched) -> Search {
    Search {
        port: port.to_string(),
        line: searched.tuning.line.to_string(),
        protocol: searched.tuning.protocol.name().to_owned(),
        asked: ranges(&searched.asked),
        open: ranges(&searched.open()),
        complete: searched.is_complete(),
        garbled: searched.garbled.iter().copied().collect(),
    }
}

/// Why it is not all that was asked for: interrupted, a port that failed, or nobody there.
fn verdict(settings: &Settings, failures: Vec<Failure>, ports: usize, found_none: bool, sum: &Sum) -> Option<Failure> {
    let count = failures.len();
    let interrupted = failures.iter().position(|failure| failure.class == Class::Interrupted);
    let Some(first) = failures.into_iter().nth(interrupted.unwrap_or(0)) else {
        return found_none.then(|| nobody(settings));
    };
    let why = if interrupted.is_some() { Text::new("interrupted", "unterbrochen") } else { first.message.clone() };
    let so_far = both!("{why}; {told}", "{why}; {told}", why, told = sum.told());
    if interrupted.is_some() {
        let left = sum.left.as_millis().div_ceil(1_000);
        let message =
            both!("{so_far}; what is left takes about {left} s", "{so_far}; der Rest dauert etwa {left} s", so_far);
        let message = if sum.settings > 1 { message } else { so_far };
        return Some(Failure { message, ..first }.hint(go_on(settings)));
    }
    if ports == 1 || count == ports {
        return Some(if sum.addresses > 0 { Failure { message: so_far, ..first } } else { first });
    }
    let said = first.within(|why| {
        both!(
            "{count} of {ports} ports failed; the first: {why}",
            "{count} von {ports} Anschlüssen gescheitert; zuerst: {why}",
            why
        )
    });
    Some(Failure { class: Class::Partial, code: "partial".to_owned(), ..said })
}

/// The line belongs to somebody else.
fn left_to(yielded: Yielded) -> Failure {
    let Yielded { to, bursts, listened, unasked } = yielded;
    let sent = if unasked { Text::new("nothing", "nichts") } else { Text::new("nothing more", "nichts mehr") };
    let (code, message) = match to {
        Talker::Master => (
            "forbidden.other_master",
            both!(
                "another master asks on this line, so {sent} was sent",
                "ein anderer Master fragt auf dieser Leitung, deshalb wurde {sent} gesendet",
                sent
            ),
        ),
        Talker::Somebody => (
            "forbidden.talker",
            both!(
                "somebody spoke on this line {bursts} times in {listened}, unasked and in no telegram that is known here; it can be another \
                 master, so {sent} was sent",
                "jemand sprach auf dieser Leitung {bursts}-mal in {listened}, ungefragt und in keinem hier bekannten Telegramm; es kann ein \
                 anderer Master sein, deshalb wurde {sent} gesendet",
                sent
            ),
        ),
    };
    let hint = both!(
        "disconnect whoever speaks; `antrieb sniff` shows what goes over the line; --force searches beside it and may disturb it: what \
         both send at once is lost for both",
        "abklemmen, wer spricht; `antrieb sniff` zeigt, was über die Leitung geht; --force sucht daneben und kann stören: was beide \
         zugleich senden, geht beiden verloren"
    );
    Failure::new(Class::Forbidden, code, message).hint(hint)
}

/// The time that the user gave it was not enough to find anybody.
fn over_time(within: Span, settings: &Settings, sum: &Sum) -> Failure {
    let message = both!(
        "no drive answered within {within}; {told}",
        "kein Antrieb hat innerhalb von {within} geantwortet; {told}",
        told = sum.told()
    );
    Failure::new(Class::No, NOBODY, message).hint(go_on(settings))
}

/// How to go on later: from this result, if it is one that can be read, with what was sought.
fn go_on(settings: &Settings) -> Text {
    let crate::args::Unknown { baud, parity, protocol } = settings.unknown;
    let sought = [(baud, "--baud auto "), (parity, "--parity auto "), (protocol, "--protocol auto ")];
    let sought: String = sought.iter().filter(|row| row.0).map(|row| row.1).collect();
    match settings.is_json() {
        true => both!(
            "this result, saved to a file, can be gone on with: {sought}scan --resume RESULT.json",
            "dieses Ergebnis, in eine Datei gesichert, lässt sich fortsetzen: {sought}scan --resume ERGEBNIS.json"
        ),
        false => both!(
            "what was asked is not kept; a search with --json > RESULT.json can be gone on with by --resume",
            "was gefragt war, ist nicht gesichert; eine Suche mit --json > ERGEBNIS.json lässt sich mit --resume fortsetzen"
        ),
    }
}

const NOBODY: &str = "no.drive_found";

fn nobody(settings: &Settings) -> Failure {
    let hint = if settings.line.is_can() {
        silent()
    } else if settings.unknown == crate::args::Unknown::default() {
        both!(
            "if the setting of the line is not known: --baud auto --parity auto --protocol auto (a drive leaves the \
             factory speaking VABus, P.395 = 0); else check whether A and B are swapped, and termination",
            "falls die Einstellung der Leitung unbekannt ist: --baud auto --parity auto --protocol auto (ein Antrieb \
             spricht ab Werk VABus, P.395 = 0); sonst prüfen, ob A und B vertauscht sind, und den Abschluss"
        )
    } else {
        both!(
            "no setting brought an answer: check supply, whether A and B are swapped, termination, and the adapter",
            "keine Einstellung brachte eine Antwort: Versorgung, Vertauschung von A und B, Abschluss und Adapter prüfen"
        )
    };
    Failure::new(Class::No, NOBODY, both!("no drive answered", "kein Antrieb hat geantwortet")).hint(hint)
}
