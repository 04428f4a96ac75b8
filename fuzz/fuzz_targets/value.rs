//! A value as it is typed: what is taken is the same again when it is shown.
#![no_main]

use antrieb::profile::{Registry, value};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|typed: (u16, &str)| {
    thread_local!(static REGISTRY: Registry = Registry::open(&[]).expect("the built-in catalogues are right"));
    let (which, text) = typed;
    REGISTRY.with(|registry| {
        for family in registry.families() {
            let found = family.search("");
            let Some(param) = found.get(usize::from(which) % found.len().max(1)) else { continue };
            let Some(kind) = param.kind else { continue };
            let Ok(raw) = value::parse(text, param, &family.choices(param)) else { continue };
            if value::check_range(raw, param).is_err() || value::check_type(raw, kind, param).is_err() {
                continue;
            }
            let bits = value::to_wire(raw, kind).expect("its type was checked");
            assert_eq!(value::from_wire(bits, kind, param.min), raw, "{} {text}", param.id);
            // Where no source tells the point, it is shown as "raw", and taken in bits alone.
            let is_raw = param.unit.is_some() && !param.has_scale();
            let shown = if is_raw { format!("0x{raw:X}") } else { value::written(param, raw) };
            assert_eq!(value::parse(&shown, param, &[]), Ok(raw), "{} {text} {shown}", param.id);
        }
    });
});
