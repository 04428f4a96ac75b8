//! What ends a run from outside: signals, keys, and a reader of stdout that goes away.

use crate::drive::{Button, Interrupt, QUIET};
use crate::render::{self, Console, Key, Keys, Stream};
use crate::text::both;
use crate::tick::{Span, Tick};
use std::cell::{Cell, RefCell};
use std::time::Duration;
#[cfg(windows)]
use tokio::signal::windows;
use tokio::sync::mpsc::{UnboundedReceiver, unbounded_channel};
use tokio::time::Instant;
#[cfg(unix)]
use {
    signal_hook::consts::signal::*,
    std::ffi::c_int,
    std::sync::{Arc, Once, atomic::AtomicBool},
    tokio::signal::unix::{SignalKind, signal},
};

/// Hands the keys that are pressed to the view, those of a run to its keypad as well: for ever, or, once it is `over`, as long as one is held
/// and somebody still looks.
pub(super) async fn obey_keys(
    keys: Option<Keys>,
    stream: Option<&RefCell<Stream<'_>>>,
    interrupt: &Interrupt,
    is_run: bool,
    over: &Cell<bool>,
) {
    let (Some(mut keys), Some(stream)) = (keys, stream) else { return std::future::pending().await };
    let mut hand = Hand { begun: Instant::now(), ctrl_c: Repeated::default() };
    let mut last = None;
    loop {
        let is_quiet = last.is_none_or(|last| hand.now().since(last) >= QUIET);
        if over.get() && (is_quiet || interrupt.panel().is_left()) {
            return;
        }
        let key = tokio::select! {
            key = keys.next() => key,
            () = hand.until(interrupt.panel().due()) => {
                interrupt.look(hand.now());
                stream.borrow_mut().catch_up();
                continue;
            }
        };
        if key != Key::Redraw {
            last = Some(hand.now());
        }
        let ends = stream.borrow_mut().press(key);
        if is_run {
            hand.obey(key, interrupt);
        } else if ends {
            interrupt.raise();
        }
    }
}

/// Who presses the keys of a run, by the clock.
struct Hand {
    begun: Instant,
    ctrl_c: Repeated,
}

/// What comes so soon behind the same is no second wish: a key that repeats, or a signal that comes twice at once, as from `timeout`, which
/// signals its child and then the group of it. A choice: keyboards repeat every 30 to 100 ms.
const REPEATS: Duration = Duration::from_millis(150);

/// When the same was wished last.
#[derive(Default)]
struct Repeated(Option<Instant>);

impl Repeated {
    /// Whether a key is pressed anew: one that is held repeats for ever.
    fn is_pressed(&mut self) -> bool {
        let now = Instant::now();
        self.0.replace(now).is_none_or(|before| now - before > REPEATS)
    }

    /// Whether a signal is the same wish as the last one that counted. Only that for the end makes a stop a stronger one; and nobody sees whether
    /// somebody holds the key or presses it again and again, so that every 150 ms one counts.
    fn swallows(&mut self, wish: Wish) -> bool {
        let now = Instant::now();
        let repeats = matches!(wish, Wish::End) && self.0.is_some_and(|before| now - before <= REPEATS);
        if !repeats {
            self.0 = Some(now);
        }
        repeats
    }
}

/// So often what had to wait for the terminal is drawn.
const MOMENT: Span = Span::from_millis(100);

impl Hand {
    fn now(&self) -> Tick {
        Tick::from_micros(u64::try_from(self.begun.elapsed().as_micros()).unwrap_or(u64::MAX))
    }

    #[expect(clippy::disallowed_methods, reason = "a hand on a key; no telegram depends on this time")]
    /// Until a held key is due, or for a moment.
    async fn until(&self, due: Option<Tick>) {
        // It is over behind it, not with it.
        let wait = due.map(|due| due.since(self.now()) + Span::from_millis(1));
        tokio::time::sleep(wait.map_or(MOMENT, |wait| wait.min(MOMENT)).into()).await;
    }

    fn obey(&mut self, key: Key, interrupt: &Interrupt) {
        let now = self.now();
        let button = match key {
            Key::Up => Button::More,
            Key::Down => Button::Less,
            Key::Enter | Key::Next | Key::Previous => Button::Hold,
            Key::Stop => Button::Stop,
            Key::Quit => Button::End,
            Key::Interrupt => {
                if self.ctrl_c.is_pressed() {
                    interrupt.press();
                }
                return;
            }
            Key::Gone => return interrupt.raise(),
            Key::Diagnosis | Key::Redraw => return,
        };
        interrupt.button(button, now);
    }
}

/// Raises the interrupt when the reader of stdout has gone away, or the terminal that stderr was.
#[expect(clippy::disallowed_methods, reason = "looks at a pipe now and then; no telegram depends on this time")]
pub(super) async fn raise_on_closed_output(interrupt: Interrupt, terminal: bool) {
    while !(render::output_is_closed() || terminal && render::terminal_is_gone()) {
        tokio::time::sleep(Duration::from_millis(100)).await;
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
    #[cfg_attr(windows, expect(dead_code, reason = "nothing is suspended there"))]
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

/// What is registered stays, and each registration copies all that there are: once for a process is enough.
#[cfg(unix)]
static OUTLIVES_LIMITS: Once = Once::new();
#[cfg(unix)]
static ACTS_AS_USUAL: Once = Once::new();

/// A file that has reached its limit (`ulimit -f`) is a write that fails, as on a full disk, and whoever writes it says so: nothing
/// dies of it in the middle, up to the report at the end.
pub(super) fn outlive_limits() {
    #[cfg(unix)]
    OUTLIVES_LIMITS.call_once(|| {
        let _cannot_be_had = signal_hook::flag::register(SIGXFSZ, Arc::new(AtomicBool::new(false)));
    });
}

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
            let mut repeated = Repeated::default();
            tokio::spawn(async move {
                while signal.recv().await.is_some() && (repeated.swallows(wish) || heard.send(wish).is_ok()) {}
            });
        }
        Signals { wishes }
    }

    /// Ctrl-C, Ctrl-Break, and the window that is closed: whoever is told of that has five seconds left, and is not asked twice.
    #[cfg(windows)]
    pub(super) fn listen(_turns: bool) -> Self {
        let (heard, wishes) = unbounded_channel();
        macro_rules! hear {
            ($($event:ident: $wish:ident),*) => {$(
                if let Ok(mut event) = windows::$event() {
                    let (heard, mut repeated) = (heard.clone(), Repeated::default());
                    tokio::spawn(async move {
                        while event.recv().await.is_some() && (repeated.swallows(Wish::$wish) || heard.send(Wish::$wish).is_ok()) {}
                    });
                }
            )*};
        }
        hear!(ctrl_c: End, ctrl_break: End, ctrl_close: Hangup, ctrl_logoff: Hangup, ctrl_shutdown: Hangup);
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

/// Behind a run that nobody broke off a signal does again what it does to any program: nothing is left that it could leave turning, and a reader
/// who takes nothing holds nobody.
pub(super) fn act_as_usual() {
    #[cfg(unix)]
    ACTS_AS_USUAL.call_once(|| {
        let all = [ALWAYS, OVER_A_SHAFT].into_iter().flatten().flat_map(|row| row.1);
        for number in all.filter(|number| **number != SIGXFSZ) {
            let _cannot_be_had =
                signal_hook::flag::register_conditional_default(*number, Arc::new(AtomicBool::new(true)));
        }
    });
}
