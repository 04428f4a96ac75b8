//! A catalogue of somebody's own.
#![no_main]

use antrieb::profile::{CatalogueFile, Registry};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    let file = CatalogueFile { path: "own.toml".to_owned(), text: text.to_owned() };
    let _ = Registry::open(&[file]);
});
