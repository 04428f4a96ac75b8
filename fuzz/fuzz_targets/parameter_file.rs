//! A parameter file: refused, or its settings printed are the same settings again.
#![no_main]

use antrieb::profile::Registry;
use antrieb::profile::paramfile::ParamFile;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    thread_local!(static REGISTRY: Registry = Registry::open(&[]).expect("the built-in catalogues are right"));
    let Ok(file) = ParamFile::parse("drive.toml", text) else { return };
    REGISTRY.with(|registry| {
        for family in registry.families() {
            if let Ok(settings) = file.settings(&family) {
                assert!(settings.shortest().len() <= settings.len());
                settings.signature(&family.family);
            }
        }
    });
});
