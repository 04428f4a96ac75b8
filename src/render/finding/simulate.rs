//! `simulate`: what was asked of the bench.

use super::page::Page;
use super::{Finding, Row, list};
use crate::outcome::Simulate;
use crate::render::clean;

impl Finding for Simulate {
    fn table(&self, _page: Page) -> String {
        let mut text = format!(
            "{}: {} clients, {} telegrams received, {} answered ({} exceptions), {} EEPROM writes, {} shafts turning, \
             {} motors powered, {} remarks\n",
            self.port,
            self.clients,
            self.received,
            self.answered,
            self.exceptions,
            self.eeprom_writes,
            self.turning,
            self.energised,
            self.remarks.len()
        );
        self.remarks.iter().for_each(|remark| text += &format!("remark: {}\n", clean(remark)));
        text
    }

    fn rows(&self) -> Vec<Row> {
        list("end", &[self])
    }
}
