//! `systembus`: a plan, and what PDOs cost the bus.

use super::page::Page;
use super::{Finding, Rows};
use crate::outcome::{BusDrive, BusLink, BusLoad, BusPlan, BusRelation, BusTotal};
use crate::render::clean;

impl Finding for BusLoad {
    fn table(&self, page: Page) -> String {
        let mut text = String::new();
        if !self.rates.is_empty() {
            let times = self
                .rates
                .iter()
                .map(|rate| vec![rate.rate_kbd.to_string(), rate.telegram_us.to_string(), rate.metres.to_string()]);
            text += &page.table(&[">kBd", ">telegram µs", ">line m"], times.collect());
            let loads = self
                .rates
                .iter()
                .map(|rate| std::iter::once(rate.rate_kbd.to_string()).chain(rate.shown.iter().cloned()).collect());
            let head =
                [">kBd", ">1 ms", ">2 ms", ">3 ms", ">4 ms", ">5 ms", ">6 ms", ">7 ms", ">8 ms", ">9 ms", ">10 ms"];
            text += &format!("\n{}\n{}", page.word("load of one TxPDO in %"), page.table(&head, loads.collect()));
        }
        let rows = self
            .pdos
            .iter()
            .enumerate()
            .map(|(nth, pdo)| vec![(nth + 1).to_string(), pdo.every_ms.to_string(), pdo.shown.clone()]);
        text += &page.table(&[">TxPDO", ">ms", ">load %"], rows.collect());
        if let Some(total) = self.total.as_ref().filter(|_| !self.pdos.is_empty()) {
            text += &format!("\n{}", page.total(total));
        }
        text
    }

    fn rows(&self) -> Rows {
        if self.pdos.is_empty() { Rows::of("rate", &self.rates) } else { Rows::of("pdo", &self.pdos) }
    }
}

impl Finding for BusPlan {
    fn table(&self, page: Page) -> String {
        let sync = match self.sync_every_ms {
            Some(ms) => format!("{} ({ms} ms)", self.sync_identifier),
            None => self.sync_identifier.to_string(),
        };
        let master = match self.master.as_deref() {
            Some("external") => page.word("external").to_owned(),
            Some(name) => clean(name),
            None => page.word("nobody").to_owned(),
        };
        let rate = format!("{} kBd", self.rate_kbd);
        let mut text = page.pairs(vec![("rate", rate), ("SYNC", sync), ("master", master)]);
        let relations = self.relations.iter().map(|relation| page.relation(relation)).collect();
        text += &section(&page.table(&[">identifier", "sender", ">ms", ">load %", "receivers"], relations));
        let links = self.links.iter().map(|link| page.bus_link(link)).collect();
        text += &section(&page.table(&[">identifier", "bytes", "sender", "receiver"], links));
        if self.shows_settings {
            text += &self.drives.iter().map(|drive| section(&page.bus_drive(drive))).collect::<String>();
        }
        text += &section(&page.total(&self.total));
        let remarks = self.remarks.iter();
        let remarks = remarks.map(|one| vec![page.word(one.level).to_owned(), page.say(&one.message)]).collect();
        text += &section(&page.table(&["", ""], remarks));
        let files = self.drives.iter().filter_map(|drive| drive.dcf.as_ref()).map(|path| ("DCF", clean(path)));
        let files: Vec<_> = files.chain(self.svg.iter().map(|path| ("picture", clean(path)))).collect();
        if files.is_empty() { text } else { text + &section(&page.pairs(files)) }
    }

    fn rows(&self) -> Rows {
        Rows::of("link", &self.links)
    }
}

/// A part of a page, behind a blank line; nothing of nothing.
fn section(part: &str) -> String {
    if part.is_empty() { String::new() } else { format!("\n{part}") }
}

impl Page {
    fn total(self, total: &BusTotal) -> String {
        let verdict = match total.verdict {
            "okay" => self.word("okay"),
            "critical" => self.word("critical"),
            _ => self.word("not feasible"),
        };
        let open = if total.incomplete { format!(", {}", self.word("incomplete")) } else { String::new() };
        self.pairs(vec![("bus load", format!("{} % ({verdict}{open})", total.shown))])
    }

    fn relation(self, relation: &BusRelation) -> Vec<String> {
        let nobody = || self.word("nobody").to_owned();
        let sender = match (&relation.sender, relation.pdo) {
            (Some(name), Some(pdo)) => format!("{name} TxPDO{pdo}"),
            (Some(name), None) => name.clone(),
            (None, _) => nobody(),
        };
        let every = match (relation.on_sync, relation.every_ms) {
            (true, Some(ms)) => format!("SYNC {ms}"),
            (true, None) => "SYNC".to_owned(),
            (false, ms) => ms.map_or_else(|| "-".to_owned(), |ms| ms.to_string()),
        };
        let receivers = relation.receivers.iter().map(|one| {
            let sync = if one.on_sync { " SYNC" } else { "" };
            let timeout = if one.timeout_ms > 0 { format!(" ({} ms)", one.timeout_ms) } else { String::new() };
            format!("{} RxPDO{}{sync}{timeout}", one.drive, one.pdo)
        });
        let receivers: Vec<String> = receivers.collect();
        let receivers = if receivers.is_empty() { nobody() } else { receivers.join(", ") };
        let load = if relation.shown.is_empty() { "-".to_owned() } else { relation.shown.clone() };
        vec![relation.identifier.to_string(), sender, every, load, receivers]
    }

    fn bus_link(self, link: &BusLink) -> Vec<String> {
        let end = |whose: &Option<String>, param: Option<u32>, source: Option<u16>, name: String| {
            let whose = whose.clone().unwrap_or_default();
            let set = param.zip(source).map(|(param, source)| format!("{whose} P.{param} = {source} {name}"));
            set.unwrap_or_else(|| "-".to_owned()).trim().to_owned()
        };
        let source = self.say_or_not(link.sender_source_name.as_ref());
        let param = self.say_or_not(link.receiver_param_name.as_ref());
        let bytes = format!("{}-{} {}", link.first_byte, link.last_byte, link.place);
        vec![
            link.identifier.to_string(),
            bytes,
            end(&link.sender, link.sender_param, link.sender_source, source),
            end(&link.receiver, link.receiver_param, link.receiver_source, param),
        ]
    }

    fn bus_drive(self, drive: &BusDrive) -> String {
        let rows = drive.settings.iter().map(|setting| {
            let value = setting.raw.map_or_else(|| "?".to_owned(), |raw| raw.to_string());
            vec![
                setting.param.to_string(),
                self.say_or_not(setting.name.as_ref()),
                value,
                self.say_or_not(setting.text.as_ref()),
            ]
        });
        let heading = format!("{} ({} {})\n", clean(&drive.name), self.word("node"), drive.node);
        heading + &self.table(&[">param", "name", ">value", "meaning"], rows.collect())
    }
}
