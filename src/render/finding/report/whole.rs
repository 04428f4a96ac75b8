//! A report from its head to the lines for signatures.

use super::OVERVIEW;
use super::paper::{Block, Cell, Paper, Table};
use crate::outcome::{LineCheck, LinkTest, Plot, Report};
use crate::profile::value::format_decimal;
use crate::render::finding::page::Page;
use crate::render::finding::plot::number;
use crate::text::both;

impl Page {
    pub(super) fn paper(self, report: &Report) -> Paper {
        let title = match &report.plant {
            Some(plant) => both!("Commissioning report: {plant}", "Inbetriebnahmebericht: {plant}"),
            None => both!("Commissioning report", "Inbetriebnahmebericht"),
        };
        let tool = env!("CARGO_PKG_VERSION");
        let foot = both!(
            "Read and written by antrieb {tool}. Nothing in a drive was changed.",
            "Gelesen und geschrieben von antrieb {tool}. In keinem Antrieb wurde etwas geändert."
        );
        let mut blocks = self.head(report);
        if let Some(check) = &report.line {
            blocks.extend(self.line_part(check));
        }
        report.drives.iter().for_each(|drive| blocks.extend(self.drive_part(drive, report.changed_only)));
        report.procedures.iter().for_each(|done| blocks.extend(self.procedure_part(done)));
        for (plot, picture) in report.records.iter().zip(&report.pictures) {
            blocks.extend(self.record_part(plot, picture));
        }
        blocks.extend(self.signing());
        for block in &mut blocks {
            if let Block::Heading(_, text) = block {
                *text = capital(text);
            }
        }
        let lang = self.lang.pick("en", "de");
        Paper { lang, title: self.say(&title), logo: report.logo.clone(), blocks, foot: self.say(&foot) }
    }

    /// For whom, of what, when, and every drive in a line.
    fn head(self, report: &Report) -> Vec<Block> {
        let unknown = || self.word("unknown").to_owned();
        let mut facts = Vec::new();
        facts.extend(report.customer.clone().map(|customer| self.fact("customer", customer)));
        facts.push(self.fact("time (UTC)", report.time.clone().unwrap_or_else(unknown)));
        if let Some(check) = &report.line {
            let line = format!("{} {} {}", check.port, check.line, check.protocol);
            facts.push(self.fact("line", line));
        }
        let rows = report.drives.iter().map(|drive| self.in_a_line(drive));
        vec![Block::Facts(facts), self.grid(&OVERVIEW, rows)]
    }

    pub(super) fn fact(self, name: &str, text: String) -> (String, String) {
        (self.word(name).to_owned(), text)
    }

    /// A table of plain cells; columns whose name starts with `>` are aligned to the right.
    pub(super) fn grid(self, head: &[&str], rows: impl Iterator<Item = Vec<String>>) -> Block {
        let head = head.iter().map(|name| (self.word(name.trim_start_matches('>')).to_owned(), name.starts_with('>')));
        let rows = rows.map(|row| row.into_iter().map(Cell::from).collect());
        Block::Table(Table { head: head.collect(), rows: rows.collect() })
    }

    fn line_part(self, check: &LineCheck) -> Vec<Block> {
        let facts = self.line_facts(check).into_iter().map(|(name, text)| self.fact(name, text));
        let rows = check.drives.iter().map(|drive| {
            let mut row = vec![self.address(drive.address)];
            match (&drive.test, &drive.error) {
                (Some(test), _) => row.extend(self.tested(test)),
                (None, error) => {
                    row.push(error.as_ref().map_or_else(String::new, |error| self.say(&error.message)));
                    row.extend((0..9).map(|_| String::new()));
                }
            }
            row
        });
        let head = [
            ">addr",
            ">asked",
            ">replies",
            ">silent",
            ">garbled",
            ">strays",
            ">error rate",
            ">min ms",
            ">median ms",
            ">95 % ms",
            ">max ms",
        ];
        let mut table = self.grid(&head, rows);
        if let Block::Table(table) = &mut table {
            // Why nothing was measured needs room.
            for (row, _) in table.rows.iter_mut().zip(&check.drives).filter(|(_, drive)| drive.test.is_none()) {
                row.truncate(2);
                row.iter_mut().skip(1).for_each(|cell| cell.span = head.len() - 1);
            }
        }
        let advice: Vec<String> = check.advice.iter().map(|advice| self.say(&advice.text)).collect();
        let fine = check.advice.is_empty() && check.drives.iter().all(|drive| drive.error.is_none());
        let nothing = || Block::Text(self.word("nothing to complain of").to_owned());
        let mut blocks = vec![
            Block::Heading(1, self.word("line").to_owned()),
            Block::Facts(facts.collect()),
            Block::Heading(2, self.word("link test").to_owned()),
            table,
        ];
        if !advice.is_empty() {
            blocks.push(Block::List(advice));
        } else if fine {
            blocks.push(nothing());
        }
        blocks
    }

    /// A link test in cells.
    fn tested(self, test: &LinkTest) -> Vec<String> {
        let LinkTest { asked, replies, silent, garbled, strays, error_rate_percent, .. } = test;
        let counts = [asked, replies, silent, garbled, strays].map(u64::to_string);
        let millis = |us: Option<u64>| us.map_or_else(|| "-".to_owned(), |us| format_decimal(us as i64, 3));
        let times = [test.fastest_us, test.median_us, test.p95_us, test.slowest_us].map(millis);
        counts.into_iter().chain([format!("{error_rate_percent} %")]).chain(times).collect()
    }

    fn record_part(self, plot: &Plot, picture: &str) -> Vec<Block> {
        let name = both!("Record: drive {address}", "Aufzeichnung: Antrieb {address}", address = plot.address);
        let told = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), number);
        let curves = plot.curves.iter().map(|curve| {
            let measured = [curve.min, curve.max, curve.mean, curve.rms].map(told);
            let unit = curve.unit.clone().unwrap_or_default();
            [self.say(&curve.name), unit].into_iter().chain(measured).collect()
        });
        let responses = plot.responses.iter().flatten().map(|one| {
            let way = format!("{} → {}", number(one.from), number(one.to));
            let measured = [one.overshoot_percent, one.settling_s, one.slope, one.dead_time_s].map(told);
            [number(one.t), way, one.unit.clone().unwrap_or_default()].into_iter().chain(measured).collect()
        });
        let mut blocks = vec![
            Block::Heading(1, self.say(&name)),
            Block::Picture(picture.to_owned(), plot.file.clone()),
            self.grid(&["name", "unit", ">min", ">max", ">mean", ">RMS"], curves),
        ];
        let head = [">t [s]", ">setpoint", "unit", ">overshoot %", ">settling s", ">slope /s", ">dead time s"];
        let table = self.grid(&head, responses);
        if matches!(&table, Block::Table(table) if !table.rows.is_empty()) {
            blocks.push(table);
        }
        blocks.extend(
            (!plot.notes.is_empty()).then(|| Block::List(plot.notes.iter().map(|note| self.say(note)).collect())),
        );
        blocks
    }

    /// Room for who did the work, and who takes it over.
    fn signing(self) -> Vec<Block> {
        let line = |who: &str| [who, "place, date", "signature (by hand)"].map(|name| self.word(name).to_owned());
        vec![
            Block::Heading(1, self.word("remarks, signatures").to_owned()),
            Block::Lines(vec![["", "", ""].map(str::to_owned), ["", "", ""].map(str::to_owned)]),
            Block::Lines(vec![line("commissioned by"), line("accepted by")]),
        ]
    }
}

/// As a heading is written.
fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
