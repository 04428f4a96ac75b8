//! A bench of somebody's own.
#![no_main]

use antrieb::profile::Registry;
use antrieb::simulator::Bench;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    thread_local!(static REGISTRY: Registry = Registry::open(&[]).expect("the built-in catalogues are right"));
    REGISTRY.with(|registry| {
        let _ = Bench::from_toml("bench.toml", text, registry);
    });
});
