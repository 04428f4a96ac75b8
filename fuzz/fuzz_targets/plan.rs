//! A plan of the system bus, as TOML and as DCF: its relations, checks, load and picture, whatever it says.
#![no_main]

use antrieb::profile::Registry;
use antrieb::systembus::{check, from_dcf, links, picture, read, relations};
use antrieb::text::Lang;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    thread_local!(static REGISTRY: Registry = Registry::open(&[]).expect("the built-in catalogues are right"));
    let files = [("drive.dcf".to_owned(), text.to_owned())];
    let family = REGISTRY.with(|registry| registry.family("acu")).expect("the drive with a system bus");
    for plan in [read(text).ok(), from_dcf(&files).ok()].into_iter().flatten() {
        let _ =
            (check(&plan, &family), relations(&plan), links(&plan), plan.budget(), picture(&plan, &family, Lang::En));
    }
});
