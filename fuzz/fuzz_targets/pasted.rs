//! What somebody pastes behind `decode telegram`, and recordings of any kind.
#![no_main]

use antrieb::drive::decode::Reader;
use antrieb::profile::Registry;
use antrieb::protocol::Protocol;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    thread_local!(static REGISTRY: Registry = Registry::open(&[]).expect("the built-in catalogues are right"));
    REGISTRY.with(|registry| {
        let families: Vec<_> = registry.families().collect();
        for (at, protocol) in Protocol::ALL.into_iter().enumerate() {
            let family = families.get(at % families.len()).map(|family| &**family);
            let reader = Reader { protocol, node: 0, family, order: None };
            let _ = (reader.typed(text), reader.recording(text));
        }
    });
});
