//! Lists of registers as others write them: tables, and maps in MBMap.
#![no_main]

use antrieb::profile::import::{Wishes, mbmap, table};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    for own in [false, true] {
        let wishes = Wishes { own, ..Wishes::default() };
        let _ = (table(bytes, &wishes), mbmap(bytes, &wishes));
    }
});
