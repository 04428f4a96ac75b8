//! `simulate`: what was asked of the bench.

use super::page::Page;
use super::{Finding, Rows};
use crate::outcome::Simulate;
use crate::profile::Lang;

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
        self.remarks.iter().for_each(|told| text += &page.prose(&format!("{remark}: {told}")));
        text
    }

    fn rows(&self) -> Rows {
        Rows::of("end", &[self])
    }
}
