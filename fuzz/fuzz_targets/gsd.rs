//! GSD files: whatever a text is, it is read or refused, and what was read fits into Set_Prm.
#![no_main]

use antrieb::protocol::dp::gsd::Gsd;
use libfuzzer_sys::fuzz_target;

/// User parameters of one Set_Prm (IEC 61158-6-3).
const MOST_USER: usize = 237;

fuzz_target!(|text: &str| {
    let plain = Gsd::parse(text);
    // A file is what follows the header, wherever that stands.
    let headed = Gsd::parse(&format!("#Profibus_DP\nIdent_Number=1\n{text}"));
    for gsd in [plain, headed].into_iter().flatten() {
        assert_ne!(gsd.ident, 0);
        let users = gsd.modules.iter().map(|module| &module.user).chain([&gsd.user]);
        assert!(users.map(Vec::len).all(|length| length <= MOST_USER));
    }
});
