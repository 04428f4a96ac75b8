//! What ends a run from outside: signals, keys, and a reader of stdout that goes away.

use crate::drive::Interrupt;
use crate::render::{self, Console, Keys, Stream};
use crate::text::both;
use std::cell::RefCell;
use tokio::sync::mpsc::{UnboundedReceiver, unbounded_channel};
#[cfg(unix)]
use {
    signal_hook::consts::signal::*,
    std::ffi::c_int,
    std::sync::{Arc, atomic::AtomicBool},
    tokio::signal::unix::{SignalKind, signal},
};

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

/// What a signal asks for.
#[derive(Clone, Copy, Debug)]
enum Wish {
    /// The end, from somebody who may ask for it again.
    End,
    /// The end, of itself: the terminal is gone, and with it stdout, which is one wish and not two.
    Hangup,
    /// That we stand still, and with us the refresh and the stop of a shaft.
    Freeze,
}

/// What any verb listens to.
#[cfg(unix)]
const ALWAYS: &[(Wish, &[c_int])] = &[(Wish::End, &[SIGINT, SIGTERM]), (Wish::Hangup, &[SIGHUP])];
/// What a verb that turns a shaft listens to as well, because it would die or stand still of it: Ctrl-\, signals for other
/// programs, a time or a size that is used up; Ctrl-Z. A job in the background that reads (at the question) stands still as usual:
/// nothing turns yet.
#[cfg(unix)]
const OVER_A_SHAFT: &[(Wish, &[c_int])] = &[
    (Wish::End, &[SIGQUIT]),
    (Wish::Hangup, &[SIGUSR1, SIGUSR2, SIGALRM, SIGVTALRM, SIGPROF, SIGXCPU, SIGXFSZ, SIGIO]),
    (Wish::Freeze, &[SIGTSTP]),
];

/// The signals of a run.
pub(super) struct Signals {
    wishes: UnboundedReceiver<Wish>,
}

impl Signals {
    /// Hears them from now on; `turns`: the verb may turn a shaft. Within a runtime.
    #[cfg(unix)]
    pub(super) fn listen(turns: bool) -> Self {
        let (heard, wishes) = unbounded_channel();
        if turns {
            render::write_from_the_background();
        }
        let rows = ALWAYS.iter().chain(if turns { OVER_A_SHAFT } else { &[] });
        for (wish, number) in rows.flat_map(|(wish, numbers)| numbers.iter().map(|number| (*wish, *number))) {
            let Ok(mut signal) = signal(SignalKind::from_raw(number)) else { continue };
            let heard = heard.clone();
            tokio::spawn(async move { while signal.recv().await.is_some() && heard.send(wish).is_ok() {} });
        }
        Signals { wishes }
    }

    #[cfg(not(unix))]
    pub(super) fn listen(_turns: bool) -> Self {
        let (heard, wishes) = unbounded_channel();
        tokio::spawn(async move { while tokio::signal::ctrl_c().await.is_ok() && heard.send(Wish::End).is_ok() {} });
        Signals { wishes }
    }

    /// Hands every wish on, for ever.
    pub(super) async fn obey(mut self, interrupt: &Interrupt, console: &Console) {
        while let Some(wish) = self.wishes.recv().await {
            match wish {
                Wish::End => interrupt.press(),
                Wish::Hangup => interrupt.raise(),
                Wish::Freeze => console.note(&both!(
                    "this is not suspended while a shaft may turn: nobody would stop it; Ctrl-C does",
                    "angehalten wird hier nicht, solange sich eine Welle drehen kann: niemand stoppte sie; Strg-C stoppt"
                )),
            }
        }
        std::future::pending().await
    }
}

/// Behind a run a signal does again what it does to any program: nothing is left that it could leave turning, and a reader
/// who takes nothing holds nobody.
pub(super) fn act_as_usual() {
    #[cfg(unix)]
    for number in [ALWAYS, OVER_A_SHAFT].into_iter().flatten().flat_map(|row| row.1) {
        let _cannot_be_had = signal_hook::flag::register_conditional_default(*number, Arc::new(AtomicBool::new(true)));
    }
}
