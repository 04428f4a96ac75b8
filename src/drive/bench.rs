//! The built-in bench: loaded from its file, or the standard one.

use super::Interrupt;
use crate::failure::{Class, Failure};
use crate::files;
use crate::outcome::{Event, GapStatistics, Simulate};
use crate::profile::{Broken, Registry};
use crate::simulator::{Bench, Can, Profibus, Served};
use crate::text::{Text, both};
use crate::tick::Span;
use crate::transport::serve::{Note, ServeError, Server};
use std::path::Path;

pub use crate::transport::serve::Place;

/// The format of a bench file, by example.
pub const FILE_HELP: &str = concat!(
    "A bench file, by example:\n\n",
    include_str!("../simulator/bench.toml"),
    "\nA file for --profibus, by example:\n\n",
    include_str!("../simulator/profibus.toml"),
    "\nA file for --can, by example:\n\n",
    include_str!("../simulator/can.toml")
);

/// The bench that a file describes, or the standard one: an ACT at 1, an ACU at 2. A file that cannot be read or is wrong is `data.bench`.
pub fn load(file: Option<&Path>, registry: &Registry) -> Result<Bench, Failure> {
    let Some(file) = file else { return Ok(Bench::standard(registry)) };
    read(file, |path, text| Bench::from_toml(path, text, registry))
}

/// The PROFIBUS line that a file describes, or the standard one: an L200 behind an SJ2-PB at 3, an SJ200 at 5; `data.bench` as [`load`].
pub fn profibus(file: Option<&Path>, registry: &Registry) -> Result<Profibus, Failure> {
    let Some(file) = file else { return Ok(Profibus::standard(registry)) };
    read(file, |path, text| Profibus::from_toml(path, text, registry))
}

/// The CAN bus that a file describes, or the standard one: ACUs as nodes 1 and 2, 500 kbit/s, no master; `data.bench` as [`load`].
pub fn can(file: Option<&Path>, registry: &Registry) -> Result<Can, Failure> {
    let Some(file) = file else { return Ok(Can::standard(registry)) };
    read(file, |path, text| Can::from_toml(path, text, registry))
}

fn read<B>(file: &Path, build: impl Fn(&str, &str) -> Result<B, Broken>) -> Result<B, Failure> {
    let path = file.display().to_string();
    let text = files::read(file, files::TEXT)
        .map_err(|error| both!("bench file {why}", "Prüfstanddatei {why}", why = error.of(file)));
    let bench = text.and_then(|text| build(&path, &text).map_err(|error| error.text()));
    bench.map_err(|why| {
        Failure::new(Class::Data, "data.bench", why).hint(both!(
            "the format is described in `antrieb simulate --help`",
            "das Format beschreibt `antrieb simulate --help`"
        ))
    })
}

/// Serves a bench in real time until the interrupt is raised or the time is over, and counts.
pub async fn serve(
    bench: &mut Bench,
    place: Place,
    duration: Option<Span>,
    interrupt: &Interrupt,
    observe: &mut dyn FnMut(Event),
) -> Result<Simulate, Failure> {
    let there = bench.drives().map(|drive| {
        let (address, model, line, framing) = (drive.address(), drive.model(), drive.line(), drive.protocol());
        both!("{model} at address {address}, {line}, {framing}", "{model} unter Adresse {address}, {line}, {framing}")
    });
    let there = there.collect();
    let (port, clients) = carry(bench, there, place, duration, interrupt, observe).await?;
    let totals = bench.totals();
    Ok(Simulate {
        port,
        clients,
        received: totals.received,
        answered: totals.answered,
        exceptions: totals.exceptions,
        eeprom_writes: totals.eeprom_writes,
        turning: totals.turning,
        energised: totals.energised,
        gaps: GapStatistics {
            count: totals.gaps.count,
            early: totals.gaps.early,
            least_us: totals.gaps.least.map(Span::as_micros),
            median_us: totals.gaps.median.map(Span::as_micros),
        },
        remarks: bench.remarks().iter().map(ToString::to_string).collect(),
    })
}

/// Serves a PROFIBUS line in real time until the interrupt is raised or the time is over, and counts.
pub async fn serve_profibus(
    bus: &mut Profibus,
    place: Place,
    duration: Option<Span>,
    interrupt: &Interrupt,
    observe: &mut dyn FnMut(Event),
) -> Result<Simulate, Failure> {
    let line = bus.line();
    let there = bus.modules().map(|(model, address)| {
        both!(
            "{model} behind an SJ2-PB at address {address}, {line}, PROFIBUS-DP",
            "{model} am SJ2-PB unter Adresse {address}, {line}, PROFIBUS-DP"
        )
    });
    let there = there.collect();
    let (port, clients) = carry(bus, there, place, duration, interrupt, observe).await?;
    let [received, answered, ..] = bus.counts();
    let [turning, energised] = bus.turning();
    let gaps = GapStatistics { count: 0, early: 0, least_us: None, median_us: None };
    let remarks = bus.remarks().to_vec();
    Ok(Simulate {
        port,
        clients,
        received,
        answered,
        exceptions: 0,
        eeprom_writes: 0,
        turning,
        energised,
        gaps,
        remarks,
    })
}

/// Serves a CAN bus behind its adapter in real time until the interrupt is raised or the time is over, and counts.
pub async fn serve_can(
    bus: &mut Can,
    place: Place,
    duration: Option<Span>,
    interrupt: &Interrupt,
    observe: &mut dyn FnMut(Event),
) -> Result<Simulate, Failure> {
    let there = bus.nodes().map(|(model, node, rate)| {
        let kbit = rate / 1_000;
        match node {
            Some(0) => both!("{model} as the master, {kbit} kbit/s", "{model} als Master, {kbit} kbit/s"),
            Some(node) => both!("{model} as node {node}, {kbit} kbit/s", "{model} als Knoten {node}, {kbit} kbit/s"),
            None => both!("{model}, off the bus", "{model}, nicht am Bus"),
        }
    });
    let there = there.collect();
    let (port, clients) = carry(bus, there, place, duration, interrupt, observe).await?;
    let [received, answered, eeprom_writes] = bus.counts();
    let [turning, energised] = bus.turning();
    let gaps = GapStatistics { count: 0, early: 0, least_us: None, median_us: None };
    let remarks = bus.remarks().to_vec();
    Ok(Simulate { port, clients, received, answered, exceptions: 0, eeprom_writes, turning, energised, gaps, remarks })
}

/// Carries the bytes of a line; the name of its port, and how many clients came.
async fn carry(
    bench: &mut impl Served,
    there: Vec<Text>,
    place: Place,
    duration: Option<Span>,
    interrupt: &Interrupt,
    observe: &mut dyn FnMut(Event),
) -> Result<(String, u64), Failure> {
    let failure = |error: &ServeError| Failure::new(Class::Port, "port.serve", error.text());
    let mut server = Server::open(place).map_err(|error| failure(&error))?;
    let port = server.name();
    there.into_iter().for_each(|told| observe(Event::Note(told)));
    observe(Event::Note(both!("serving on {port}; Ctrl-C ends it", "bedient {port}; Strg-C beendet es")));
    let mut clients = 0;
    let stop = async {
        match duration {
            Some(duration) => tokio::select! {
                () = interrupt.raised() => {}
                () = Server::pause(duration) => {}
            },
            None => interrupt.raised().await,
        }
    };
    let served = server
        .run(bench, stop, |note| {
            clients += u64::from(note == Note::Connected);
            observe(Event::Note(match note == Note::Connected {
                true => both!("a client connected", "ein Client ist verbunden"),
                false => both!("the client left", "der Client hat getrennt"),
            }));
        })
        .await;
    served.map_err(|error| failure(&error))?;
    Ok((port, clients))
}
