//! Telegrams: of `sniff`, and of `--dry-run`.

use super::page::{Page, shown};
use super::{Finding, Rows};
use crate::outcome::{Plan, Sniff, SniffCount, SniffedStation, TelegramDoc};
use crate::profile::value::format_decimal;
use crate::text::both;

impl Finding for Plan {
    fn table(&self, page: Page) -> String {
        page.plan(self)
    }

    fn rows(&self) -> Rows {
        Rows::of("telegram", &self.telegrams)
    }
}

impl Finding for Sniff {
    fn table(&self, page: Page) -> String {
        page.telegrams(&self.telegrams) + "\n" + &page.sniffed(&self.summary.count)
    }

    fn rows(&self) -> Rows {
        Rows::of("telegram", &self.telegrams)
    }
}

impl Page {
    /// What was counted of each station, and of the line.
    pub(in crate::render) fn sniffed(self, count: &SniffCount) -> String {
        let millis =
            |us: Option<u64>| us.map_or_else(|| "-".to_owned(), |us| format_decimal(us.div_ceil(100) as i64, 1));
        let doubted = count.stations.iter().any(|station| station.either > 0);
        let counted = count.stations.iter().map(|station| {
            let again = station.repeats.iter().map(|row| format!("{}x: {}", row.times, row.questions));
            let again = again.collect::<Vec<_>>().join(", ");
            let SniffedStation { address, requests, replies, unanswered, either, exceptions, .. } = station;
            let counts = [u64::from(*address), *requests, *replies, *unanswered];
            let counts = counts.into_iter().chain(doubted.then_some(*either)).chain([*exceptions]);
            let again = if again.is_empty() { "-".to_owned() } else { again };
            counts.map(|count| count.to_string()).chain([again]).collect()
        });
        let timed = count.stations.iter().map(|station| {
            let times = [station.fastest_us, station.median_us, station.slowest_us].map(millis);
            let bad = [station.check_errors, station.short_pauses].map(|count| count.to_string());
            [station.address.to_string()].into_iter().chain(times).chain(bad).collect()
        });
        // On a screen of 80 columns all of it has no room side by side.
        let head = [">addr", ">asked", ">replies", ">silent"].into_iter().chain(doubted.then_some(">either"));
        let head: Vec<_> = head.chain([">refused", "again"]).collect();
        let mut counted = self.table(&head, counted.collect());
        if doubted {
            counted += &self.prose(&self.say(&both!(
                "either: a reply, late, or the same request again; they look alike, so it is counted neither way",
                "unklar: eine späte Antwort oder dieselbe Anfrage noch einmal; sie sehen gleich aus, gezählt ist es als keines von beiden"
            )));
        }
        let head = [">addr", ">min ms", ">median ms", ">max ms", ">garbled", ">short pauses"];
        let timed = self.table(&head, timed.collect());
        let load = format!("{} %", shown(count.load_percent, false));
        counted + "\n" + &timed + "\n" + &self.pairs(vec![("bus load", load)])
    }

    fn plan(self, plan: &Plan) -> String {
        let notes: String = plan.notes.iter().map(|note| self.prose(&format!("- {}", note.get(self.lang)))).collect();
        let gap = if notes.is_empty() { "" } else { "\n" };
        self.telegrams(&plan.telegrams) + gap + &notes
    }

    pub(super) fn telegrams(self, docs: &[TelegramDoc]) -> String {
        let rows = docs.iter().map(|doc| {
            let at = doc.at_us.map_or_else(String::new, |us| format_decimal(us as i64, 3));
            vec![at, direction(doc).to_owned(), doc.hex.clone(), self.say(&doc.meaning)]
        });
        self.table(&[">ms", "", "telegram", "meaning"], rows.collect())
    }
}

/// Sign of who speaks: `>` the master, `<` a drive, `?` either, `!` nobody who can be understood.
pub(in crate::render) fn direction(doc: &TelegramDoc) -> &'static str {
    match doc.direction {
        _ if !doc.check_ok => "!",
        Some("request") => ">",
        Some(_) => "<",
        None => "?",
    }
}
