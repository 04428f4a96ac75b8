//! `profibus`: a module by name and by bytes, and who is on a line.

use super::page::Page;
use super::{Finding, Rows};
use crate::outcome::{Answers, BasicModule, LiveList, LiveStation};

impl Finding for BasicModule {
    fn table(&self, page: Page) -> String {
        page.module(self)
    }

    fn rows(&self) -> Rows {
        Rows::of("module", &[self])
    }
}

impl Page {
    fn module(self, module: &BasicModule) -> String {
        let cfg = module.cfg.as_deref().unwrap_or("?").to_owned();
        let mut text = self.say(&module.meaning) + "\n";
        let services = [("Set_Prm", module.parameters.clone()), ("Chk_Cfg", cfg)];
        let rows = services.map(|(service, bytes)| vec![service.to_owned(), bytes]);
        text += &self.table(&["", ""], rows.into());
        text += &self.fields(&module.fields);
        for note in &module.notes {
            text += &self.prose(&format!("- {}", note.get(self.lang)));
        }
        text
    }
}

impl Finding for LiveList {
    fn table(&self, page: Page) -> String {
        page.live(self)
    }

    fn rows(&self) -> Rows {
        Rows::of("station", &self.stations)
    }
}

impl Page {
    /// How each station answers, where it was asked many times.
    fn answers(self, live: &LiveList) -> String {
        let ms =
            |us: Option<u64>| us.map_or_else(|| "-".to_owned(), |us| format!("{}.{:02}", us / 1_000, us % 1_000 / 10));
        let row = |address: u8, answers: &Answers| {
            let repeats = answers.repeats.iter().enumerate().map(|(again, count)| format!("{again}: {count}"));
            let counts = [answers.silences, answers.garbled].map(|count| count.to_string());
            let times = [answers.least_us, answers.median_us, answers.most_us].map(ms);
            let first = [address.to_string(), answers.asked.to_string(), repeats.collect::<Vec<_>>().join(", ")];
            first.into_iter().chain(counts).chain(times).collect()
        };
        let asked = live.stations.iter().filter_map(|station| Some(row(station.address, station.answers.as_ref()?)));
        let rows: Vec<Vec<String>> = asked.collect();
        let head = ["addr", "asked", "=repeats", "no answer", "garbled", "min ms", "median ms", "max ms"];
        if rows.is_empty() { String::new() } else { format!("\n{}", self.table(&head, rows)) }
    }

    fn live(self, live: &LiveList) -> String {
        let row = |station: &LiveStation| {
            let or_none = |told: Option<&str>| told.unwrap_or("-").to_owned();
            vec![
                station.address.to_string(),
                self.say(&station.is),
                or_none(station.ident.as_deref()),
                station.master.map_or_else(|| "-".to_owned(), |master| master.to_string()),
                or_none(station.does().map(|does| self.say(&does)).as_deref()),
                or_none(station.layout.or(station.configuration.as_deref())),
                station
                    .answered_us
                    .map_or_else(|| "-".to_owned(), |us| format!("{}.{} ms", us / 1_000, us % 1_000 / 100)),
                station.repeats.to_string(),
            ]
        };
        let head = ["addr", "", "ident", "master", "state", "data", "reply", "repeats"];
        let mut text = self.table(&head, live.stations.iter().map(row).collect());
        text += &self.answers(live);
        // One station alone is told in full.
        if let [station] = &live.stations[..] {
            for (title, fields) in [("Slave_Diag", &station.diagnosis), ("Get_Cfg", &station.identifiers)] {
                if !fields.is_empty() {
                    text += &format!("\n{title}{}", self.fields(fields));
                }
            }
        }
        for error in live.stations.iter().filter_map(|station| station.error.as_ref()) {
            text += &self.prose(error.message.get(self.lang));
        }
        text
    }
}
