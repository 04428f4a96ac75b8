//! Drives of the bench that hear anything: they stand it, and time goes on.
#![no_main]

use antrieb::profile::Registry;
use antrieb::protocol::{Protocol, line::Parity};
use antrieb::simulator::Bench;
use antrieb::tick::{Span, Tick};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|said: Vec<Vec<u8>>| {
    thread_local!(static REGISTRY: Registry = Registry::open(&[]).expect("the built-in catalogues are right"));
    let mut bench = REGISTRY.with(Bench::standard);
    let line = Protocol::ALL[0].line(19_200, Parity::Even);
    let mut now = Tick::ZERO;
    for bytes in said {
        bench.master_sends(now, line, &bytes);
        now = now + line.chars(bytes.len() as u64) + Span::from_millis(600);
        bench.advance(now);
    }
});
