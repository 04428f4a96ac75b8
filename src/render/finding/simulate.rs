//! `simulate`: what was asked of the bench.

use super::page::Page;
use super::{Finding, Rows};
use crate::outcome::Simulate;
use crate::profile::Lang;
use std::collections::BTreeMap;

/// So many remarks of a kind are shown one by one: a scan that is not by the book brings one for each empty address.
const SHOWN: usize = 3;

/// What is remarked, which stands behind it in brackets.
fn kind(told: &str) -> &str {
    told.rsplit_once('(').map_or(told, |(_, kind)| kind.trim_end_matches(')'))
}

impl Finding for Simulate {
    fn table(&self, page: Page) -> String {
        let Simulate { port, clients, received, answered, exceptions, eeprom_writes, turning, energised, .. } = self;
        let remarks = self.remarks.len();
        let mut text = match page.lang {
            Lang::En => format!(
                "{port}: {clients} clients, {received} telegrams received, {answered} answered ({exceptions} exceptions), \
                 {eeprom_writes} EEPROM writes, {turning} shafts turning, {energised} motors powered, {remarks} remarks\n"
            ),
            Lang::De => format!(
                "{port}: {clients} Clients, {received} Telegramme empfangen, {answered} beantwortet ({exceptions} \
                 Exceptions), {eeprom_writes} EEPROM-Schreibzugriffe, {turning} Wellen drehen, {energised} Motoren unter \
                 Strom, {remarks} Anmerkungen\n"
            ),
        };
        let remark = page.lang.pick("remark", "Anmerkung");
        let mut seen = BTreeMap::<&str, usize>::new();
        for told in &self.remarks {
            let count = seen.entry(kind(told)).or_default();
            *count += 1;
            if *count <= SHOWN {
                text += &page.prose(&format!("{remark}: {told}"));
            }
        }
        let more = page.lang.pick("more of", "weitere der Art");
        for (kind, count) in seen.into_iter().filter(|(_, count)| *count > SHOWN) {
            text += &page.prose(&format!("{remark}: {} {more} ({kind})", count - SHOWN));
        }
        text
    }

    fn rows(&self) -> Rows {
        Rows::of("end", &[self])
    }
}
