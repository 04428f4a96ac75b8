//! Frames of CAN as bytes, and as the texts of SLCAN adapters and of candump.
#![no_main]

use antrieb::protocol::can::candump::{self, Entry};
use antrieb::protocol::can::slcan::{self, Word};
use antrieb::protocol::can::{Telegram, emergency::Emergency, nmt, sdo};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    if let Some(telegram) = Telegram::decode(bytes) {
        assert_eq!(Telegram::decode(&telegram.encode()).as_ref(), Some(&telegram));
        let _ = (telegram.service(), telegram.frame().to_string());
    }
    if let Some(eight) = bytes.first_chunk::<8>() {
        let (asked, told) = (sdo::Request::decode(*eight), sdo::Reply::decode(*eight));
        assert_eq!(sdo::Request::decode(asked.encode()), asked);
        assert_eq!(sdo::Reply::decode(told.encode()), told);
    }
    let _ = (Emergency::decode(bytes), nmt::Order::decode(bytes), nmt::Life::decode(bytes));
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    for word in slcan::cut(text) {
        if let Ok(word) = Word::read(word) {
            assert_eq!(Word::read(&word.to_string()), Ok(word));
        }
    }
    for line in text.lines().filter(|line| candump::is_line(line)) {
        if let Ok(entry) = Entry::read(line) {
            // Who has no time is logged at 0.
            assert_eq!(Entry::read(&entry.to_string()).map(|again| again.what), Ok(entry.what));
        }
    }
});
