//! `diag line`: what ails the line.

use super::page::Page;
use super::{Finding, Rows};
use crate::outcome::{Adapter, AdapterErrors, Bucket, LineCheck};
use crate::profile::Lang;
use crate::profile::value::format_decimal;
use crate::render::clean;

impl Finding for LineCheck {
    fn table(&self, page: Page) -> String {
        page.line_check(self)
    }

    fn rows(&self) -> Rows {
        Rows::of("drive", &self.drives)
    }
}

impl Page {
    /// The adapter and the pauses.
    pub(super) fn line_facts(self, check: &LineCheck) -> Vec<(&'static str, String)> {
        let Adapter { name, driver, about, latency_timer_ms, low_latency, rs485, errors } = &check.adapter;
        let known = [Some(name), driver.as_ref(), about.as_ref()].into_iter().flatten();
        let unknown = || self.word("unknown").to_owned();
        let micros =
            |us: Option<u64>| us.map_or_else(|| "-".to_owned(), |us| format!("{} ms", format_decimal(us as i64, 3)));
        let pauses = &check.pauses;
        let mut rows = vec![
            ("adapter", clean(&known.cloned().collect::<Vec<_>>().join(", "))),
            ("latency timer", latency_timer_ms.map_or_else(unknown, |ms| format!("{ms} ms"))),
            ("low latency", self.word(low_latency).to_owned()),
            ("RS-485 direction", (*rs485).to_owned()),
            ("echo", check.echo.map_or_else(unknown, |echo| self.word(if echo { "yes" } else { "no" }).to_owned())),
            (
                "pauses",
                format!(
                    "{} … {}, {} {}",
                    micros(pauses.shortest_us),
                    micros(pauses.longest_us),
                    self.word("required"),
                    micros(Some(pauses.required_us))
                ),
            ),
        ];
        if let Some(errors) = errors {
            let AdapterErrors { frame, overrun, parity, brk } = errors;
            let told = match self.lang {
                Lang::En => format!("frame {frame}, parity {parity}, overrun {overrun}, break {brk}"),
                Lang::De => format!("Rahmen {frame}, Parität {parity}, Überlauf {overrun}, Break {brk}"),
            };
            rows.push(("adapter errors", told));
        }
        rows
    }

    fn line_check(self, check: &LineCheck) -> String {
        let mut text =
            format!("{} {} {}\n", check.port, check.line, check.protocol) + &self.pairs(self.line_facts(check));
        for drive in &check.drives {
            text += &format!("\n{} {}\n", self.word("drive"), self.address(drive.address));
            if let Some(test) = &drive.test {
                text += &self.pairs(self.link(test));
                text += &self.histogram(&test.histogram);
            }
            if let Some(error) = &drive.error {
                text += &self.prose(error.message.get(self.lang));
            }
        }
        text + "\n" + &self.advice(check)
    }

    /// What is worth doing about a line.
    pub(super) fn advice(self, check: &LineCheck) -> String {
        let advice = check.advice.iter().map(|advice| self.prose(&format!("- {}", advice.text.get(self.lang))));
        let nothing = format!("{}\n", self.word("nothing to complain of"));
        let fine = check.drives.iter().all(|drive| drive.error.is_none());
        if check.advice.is_empty() && fine { nothing } else { advice.collect() }
    }

    /// A bar of up to 40 marks for each bucket.
    fn histogram(self, buckets: &[Bucket]) -> String {
        let most = buckets.iter().map(|bucket| bucket.count).max().unwrap_or(1).max(1);
        let row = |bucket: &Bucket| {
            let from = bucket.from_us / 1_000;
            let range =
                bucket.to_us.map_or_else(|| format!(">= {from} ms"), |to| format!("{from} - {} ms", to / 1_000));
            let marks = (bucket.count * 40).div_ceil(most) as usize;
            vec![range, bucket.count.to_string(), "#".repeat(marks)]
        };
        self.table(&[">reply times", ">count", ""], buckets.iter().map(row).collect())
    }
}
