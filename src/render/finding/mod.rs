//! Findings, one file a kind: its page for people, and its rows for NDJSON and CSV.

mod bus_watch;
mod dataset;
mod decode;
mod diag;
mod identify;
mod import;
mod line;
mod load;
mod monitor;
mod motion;
mod narrow;
mod over_lines;
mod page;
mod paramfile;
mod params;
mod plant;
mod plot;
mod procedure;
mod profibus;
mod read;
mod relocation;
mod report;
mod rows;
mod scan;
mod simulate;
mod sollwert;
mod statemachine;
mod systembus;
mod systembus_show;
mod telegrams;
mod write;

pub(super) use page::Page;
pub use report::sheet;
pub(super) use rows::{Column, Rows};
pub(super) use telegrams::direction;

use crate::outcome::Data;

/// A kind of finding, in the forms that are no JSON document.
pub(super) trait Finding {
    /// For people.
    fn table(&self, page: Page) -> String;
    /// The list that it is in the main.
    fn rows(&self) -> Rows;
}

/// What was found, whatever it is.
pub(super) fn of(data: &Data) -> &dyn Finding {
    match data {
        Data::Scan(found) => found,
        Data::Identify(found) => found,
        Data::Read(found) => found,
        Data::Write(found) => found,
        Data::Dataset(found) => found.as_ref(),
        Data::Datasets(found) => found,
        Data::Load(found) => found,
        Data::Saves(found) => found,
        Data::Comparisons(found) => found,
        Data::Plant(found) => found,
        Data::PlantCheck(found) => found,
        Data::Init(found) => found,
        Data::Diag(found) => found,
        Data::LineCheck(found) => found,
        Data::Statemachine(found) => found,
        Data::Sollwert(found) => found,
        Data::Params(found) => found,
        Data::Import(found) => found.as_ref(),
        Data::Export(found) => found,
        Data::LiveList(found) => found,
        Data::BasicModule(found) => found,
        Data::Decode(found) => found,
        Data::Sniff(found) => found,
        Data::Simulate(found) => found,
        Data::Plot(found) => found,
        Data::Report(found) => found.as_ref(),
        Data::Procedure(found) => found.as_ref(),
        Data::Procedures(found) => found,
        Data::BusPlan(found) => found.as_ref(),
        Data::BusLoad(found) => found,
        Data::BusShow(found) => found,
        Data::BusMonitor(found) => found.as_ref(),
        Data::BusOrders(found) => found,
        Data::Monitor(found) => found,
        Data::Plan(found) => found,
        Data::Motion(found) => found,
        Data::Stops(found) => found,
        Data::Relocation(found) => found,
        Data::OverLines(found) => found,
    }
}
