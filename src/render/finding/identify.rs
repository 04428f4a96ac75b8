//! `identify`: who a drive is, and by what that is told.

use super::page::Page;
use super::{Finding, Rows};
use crate::outcome::{Identify, Identity};
use crate::render::clean;

impl Finding for Identify {
    fn table(&self, page: Page) -> String {
        page.each(&self.drives, Page::identity)
    }

    fn rows(&self) -> Rows {
        Rows::of("drive", &self.drives)
    }
}

impl Page {
    fn identity(self, identity: &Identity) -> String {
        let mut text = self.heading(identity.address, &identity.drive);
        if let Some(error) = &identity.error {
            return text + &self.prose(error.message.get(self.lang));
        }
        let product = identity.product.as_ref().map_or_else(String::new, |product| format!(", {product}"));
        text += &format!("{}\n", clean(&(identity.title.get(self.lang).to_owned() + &product)));
        let rows = identity.modules.iter().map(|module| {
            let present = if module.present { "present" } else { "not fitted" };
            vec![module.name.clone(), self.word(present).to_owned(), module.evidence.get(self.lang).to_owned()]
        });
        let modules = self.table(&["module", "", "evidence"], rows.collect());
        let rows = identity.evidence.iter();
        let rows = rows
            .map(|row| [&row.asked, &row.answered, &row.tells].map(|text| text.get(self.lang).to_owned()).to_vec())
            .collect();
        let evidence = self.table(&["asked", "value", "tells"], rows);
        let parts = [self.values(&identity.values), modules, evidence].into_iter().filter(|part| !part.is_empty());
        text + &parts.map(|part| format!("\n{part}")).collect::<String>()
    }
}
