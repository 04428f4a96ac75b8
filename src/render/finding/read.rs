//! `read`: values.

use super::page::Page;
use super::{Finding, Row, list};
use crate::outcome::Read;

impl Finding for Read {
    fn table(&self, page: Page) -> String {
        page.values(&self.values)
    }

    fn rows(&self) -> Vec<Row> {
        list("value", &self.values)
    }
}
