//! PROFIBUS: telegrams and what they carry, there and back.
#![no_main]

use antrieb::protocol::dp::{Control, Diagnosis, Parameters, Service, Telegram, cfg, frame, module, pkw};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    for piece in frame::cut(bytes) {
        let Ok(telegram) = Telegram::decode(piece) else { continue };
        assert_eq!(Telegram::decode(&telegram.encode()).as_ref(), Ok(&telegram));
        if let Telegram::Frame(frame) = &telegram {
            let _ = Service::of(frame);
        }
    }
    if let Some(diagnosis) = Diagnosis::decode(bytes) {
        assert_eq!(diagnosis.encode(), bytes);
    }
    if let Some(parameters) = Parameters::decode(bytes) {
        assert_eq!(Parameters::decode(&parameters.encode()), Some(parameters));
    }
    if let Ok(said) = module::Module::decode(bytes)
        && let Ok(encoded) = said.encode()
    {
        assert_eq!(module::Module::decode(&encoded), Ok(said));
    }
    if let Some(block) = bytes.first_chunk::<{ pkw::LENGTH }>() {
        assert_eq!(pkw::Pkw::decode(block).encode(), *block);
    }
    if let Some(control) = bytes.first().copied().and_then(Control::decode) {
        assert_eq!(Control::decode(control.encode()), Some(control));
    }
    cfg::identifiers(bytes);
});
