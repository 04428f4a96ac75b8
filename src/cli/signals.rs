//! What ends a run from outside: signals, keys, and a reader of stdout that goes away.

use crate::drive::Interrupt;
use crate::render::{self, Keys, Stream};
use std::cell::RefCell;

/// Hands the keys that are pressed to the view, for ever.
pub(super) async fn obey_keys(keys: Option<Keys>, stream: Option<&RefCell<Stream<'_>>>, interrupt: &Interrupt) {
    let (Some(mut keys), Some(stream)) = (keys, stream) else { return std::future::pending().await };
    loop {
        let key = keys.next().await;
        if stream.borrow_mut().press(key) {
            interrupt.raise();
        }
    }
}

/// Raises the interrupt when the reader of stdout has gone away.
#[expect(clippy::disallowed_methods, reason = "looks at a pipe now and then; no telegram depends on this time")]
pub(super) async fn raise_on_closed_output(interrupt: Interrupt) {
    while !render::output_is_closed() {
        tokio::time::sleep(std::time::Duration::from_millis(100)).await;
    }
    interrupt.raise();
}

/// Hands every Ctrl-C and SIGTERM on, so that a second one counts too, and a SIGHUP.
#[cfg(unix)]
pub(super) async fn raise_on_signal(interrupt: Interrupt) {
    use tokio::signal::unix::{SignalKind, signal};
    let (Ok(mut term), Ok(mut hangup)) = (signal(SignalKind::terminate()), signal(SignalKind::hangup())) else {
        return;
    };
    loop {
        tokio::select! {
            pressed = tokio::signal::ctrl_c() => match pressed {
                Ok(()) => interrupt.press(),
                Err(_) => return,
            },
            _ = term.recv() => interrupt.press(),
            // The terminal is gone, and with it stdout: that is one wish, not two.
            _ = hangup.recv() => interrupt.raise(),
        }
    }
}

#[cfg(not(unix))]
pub(super) async fn raise_on_signal(interrupt: Interrupt) {
    while tokio::signal::ctrl_c().await.is_ok() {
        interrupt.press();
    }
}
