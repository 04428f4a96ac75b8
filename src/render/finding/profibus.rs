//! `profibus`: a module by name and by bytes.

use super::page::Page;
use super::{Finding, Row, list};
use crate::outcome::BasicModule;

impl Finding for BasicModule {
    fn table(&self, page: Page) -> String {
        page.module(self)
    }

    fn rows(&self) -> Vec<Row> {
        list("module", &[self])
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
