//! The built-in bench: loaded from its file, or the standard one.

use super::Interrupt;
use crate::failure::{Class, Failure};
use crate::files;
use crate::outcome::{Event, GapStatistics, Simulate};
use crate::profile::Registry;
use crate::simulator::Bench;
use crate::text::both;
use crate::tick::Span;
use crate::transport::serve::{Note, ServeError, Server};
use std::path::Path;

pub use crate::transport::serve::Place;

/// The format of a bench file, by example.
pub const FILE_HELP: &str = concat!("A bench file, by example:\n\n", include_str!("../simulator/bench.toml"));

/// The bench that a file describes, or the standard one: an ACT at 1, an ACU at 2.
pub fn load(file: Option<&Path>, registry: &Registry) -> Result<Bench, Failure> {
    let Some(file) = file else { return Ok(Bench::standard(registry)) };
    let path = file.display().to_string();
    let text = files::read(file, files::TEXT)
        .map_err(|error| both!("bench file {path}: {why}", "Benchdatei {path}: {why}", why = error.text()));
    let bench = text.and_then(|text| Bench::from_toml(&path, &text, registry).map_err(|error| error.text()));
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
    let failure = |error: &ServeError| Failure::new(Class::Port, "port.serve", error.text());
    let mut server = Server::open(place).map_err(|error| failure(&error))?;
    let port = server.name();
    for drive in bench.drives() {
        let (address, model, line, framing) = (drive.address(), drive.model(), drive.line(), drive.protocol());
        observe(Event::Note(both!(
            "{model} at address {address}, {line}, {framing}",
            "{model} unter Adresse {address}, {line}, {framing}"
        )));
    }
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
