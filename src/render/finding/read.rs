//! `read`: values.

use super::page::Page;
use super::{Finding, Rows};
use crate::outcome::Read;

impl Finding for Read {
    fn table(&self, page: Page) -> String {
        page.values(&self.values)
    }

    fn rows(&self) -> Rows {
        Rows::of("value", &self.values)
    }
}
