//! What somebody at the terminal sees of a held run, and presses: a keypad like that of a drive.
//!
//! [`Keypad`] is the whole of it as a state machine without a clock: buttons and times go in, what they ask for comes out. A
//! [`Panel`] is one that the terminal and the run share. Nothing here starts anything: buttons stop a run, or move its setpoint
//! within bounds that were agreed before; once stopped, a run stays so.

use crate::failure::may_turn;
use crate::text::{Text, both};
use crate::tick::{Span, Tick};
use std::collections::VecDeque;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use tokio::sync::Notify;

/// A button of the keypad.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Button {
    /// The setpoint goes up by a step.
    More,
    /// The setpoint goes down by a step.
    Less,
    /// Only says that somebody is there, for the dead man.
    Hold,
    /// Stops; the view stays.
    Stop,
    /// Stops and ends.
    End,
}

/// What ended a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EndedBy {
    /// A button.
    Key,
    /// Nobody held a key any more.
    DeadMan,
}

/// So long the second sign of a key that is held may take: keyboards begin to repeat after 250 ms (Linux console, Windows at its
/// shortest) to 660 ms (X11 as delivered; KDE 600, GNOME and Windows 500). A choice: a single tap runs for as long.
const FIRST: Span = Span::from_millis(800);
/// And each further one: keyboards repeat every 30 to 40 ms, over a remote terminal in bursts. A choice: who lets go is
/// obeyed within this.
const NEXT: Span = Span::from_millis(300);
/// Steps that wait for the run; a flood of keys fills no more.
const MOST_STEPS: usize = 64;

/// What was pressed, and what has come of it.
#[derive(Clone, Debug, Default)]
pub struct Keypad {
    /// The run lives only while a key is held.
    dead_man: bool,
    /// When the held key must have come again.
    due: Option<Tick>,
    ended: Option<EndedBy>,
    /// Steps up and down that were not taken yet, in their order.
    steps: VecDeque<i8>,
    /// It was the button that ends.
    leaves: bool,
    /// How often anything was pressed or has repeated.
    presses: u64,
    /// The run is on its way to its end, whoever wished it: no button wishes anything more.
    over: bool,
}

impl Keypad {
    /// From now on it runs only while a key is held.
    pub fn needs_holding(&mut self) {
        self.dead_man = true;
    }

    /// A button was pressed, or has repeated. `true`: the run is to be stopped now.
    pub fn press(&mut self, button: Button, at: Tick) -> bool {
        // Who has let go does not take hold again only because nobody looked meanwhile.
        let released = self.look(at);
        self.presses += 1;
        self.leaves |= button == Button::End;
        if self.over || self.ended.is_some() {
            return released;
        }
        match button {
            Button::Stop | Button::End => return self.end(EndedBy::Key),
            Button::More | Button::Less if self.steps.len() < MOST_STEPS => {
                self.steps.push_back(if button == Button::More { 1 } else { -1 });
            }
            Button::More | Button::Less | Button::Hold => {}
        }
        if self.dead_man {
            self.due = Some(at + if self.due.is_some() { NEXT.longer(self.left(at)) } else { FIRST });
        }
        false
    }

    /// The run comes to its end: who lets go, or presses once more, asks for what is under way.
    pub fn rests(&mut self) {
        (self.over, self.due) = (true, None);
        self.steps.clear();
    }

    /// What is left of the first time, which the second sign does not shorten.
    fn left(&self, at: Tick) -> Span {
        self.due.map_or(Span::ZERO, |due| due.since(at))
    }

    /// Looks whether the key is still held. `true`: the run is to be stopped now.
    pub fn look(&mut self, at: Tick) -> bool {
        self.due.is_some_and(|due| at > due) && self.end(EndedBy::DeadMan)
    }

    /// When it has to be looked at again.
    pub fn due(&self) -> Option<Tick> {
        self.due
    }

    /// `true` for the first time.
    fn end(&mut self, by: EndedBy) -> bool {
        self.steps.clear();
        self.due = None;
        let is_first = self.ended.is_none();
        self.ended.get_or_insert(by);
        is_first
    }
}

/// A keypad that the terminal and the run share, and whether anybody looks at the run. All clones are the same one.
#[derive(Clone, Debug, Default)]
pub struct Panel {
    shared: Arc<(Mutex<Shared>, Notify)>,
}

#[derive(Debug, Default)]
struct Shared {
    keypad: Keypad,
    watched: bool,
    /// Buttons work.
    has_keys: bool,
    /// Nobody is there any more.
    left: bool,
}

impl Panel {
    /// Somebody looks at the run, so that what is shown is asked for; `keys`: by a view with a keypad.
    pub fn watch(&self, keys: bool) {
        let mut shared = self.lock();
        (shared.watched, shared.has_keys) = (true, keys);
    }

    /// Whether somebody looks.
    pub fn is_watched(&self) -> bool {
        self.lock().watched
    }

    /// Whether there are buttons.
    pub fn has_keys(&self) -> bool {
        self.lock().has_keys
    }

    /// See [`Keypad::needs_holding`].
    pub fn needs_holding(&self) {
        self.lock().keypad.needs_holding();
    }

    /// See [`Keypad::press`].
    pub fn press(&self, button: Button, at: Tick) -> bool {
        self.with(|keypad| keypad.press(button, at))
    }

    /// See [`Keypad::look`].
    pub fn look(&self, at: Tick) -> bool {
        self.with(|keypad| keypad.look(at))
    }

    /// See [`Keypad::rests`].
    pub fn rests(&self) {
        self.lock().keypad.rests();
    }

    /// See [`Keypad::due`].
    pub fn due(&self) -> Option<Tick> {
        self.lock().keypad.due
    }

    /// How often anything was pressed or has repeated.
    pub fn presses(&self) -> u64 {
        self.lock().keypad.presses
    }

    /// What ended the run, if that was the keypad.
    pub fn ended(&self) -> Option<EndedBy> {
        self.lock().keypad.ended
    }

    /// Steps up (1) and down (-1) that were pressed since the last call, in their order.
    pub fn take_steps(&self) -> Vec<i8> {
        self.lock().keypad.steps.drain(..).collect()
    }

    /// Somebody ends it by other means than the keypad, or has gone away.
    pub(super) fn leave(&self) {
        self.lock().left = true;
        self.shared.1.notify_waiters();
    }

    /// Whether nobody looks any more: the button that ends, Ctrl-C, a terminal that is gone.
    pub fn is_left(&self) -> bool {
        let shared = self.lock();
        shared.left || shared.keypad.leaves || !shared.has_keys
    }

    /// Whether somebody ended it by other means than the keypad, also behind that.
    pub fn is_interrupted(&self) -> bool {
        self.lock().left
    }

    /// Resolves when a key is held, where one must be, or the run was ended before it began.
    pub async fn held(&self) {
        loop {
            let pressed = self.shared.1.notified();
            let is_ready = {
                let Shared { keypad, left, .. } = &*self.lock();
                !keypad.dead_man || keypad.due.is_some() || keypad.ended.is_some() || *left
            };
            if is_ready {
                return;
            }
            pressed.await;
        }
    }

    fn with(&self, work: impl FnOnce(&mut Keypad) -> bool) -> bool {
        let ends = work(&mut self.lock().keypad);
        self.shared.1.notify_waiters();
        ends
    }

    fn lock(&self) -> MutexGuard<'_, Shared> {
        self.shared.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// How long the view of a run stays behind its end. None but the last closes while a key repeats: what is still pressed would be
/// typed into the shell, where an arrow and Enter run the same line again.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stays {
    /// Until no key repeats any more.
    UntilQuiet,
    /// A minute as well, unless somebody leaves: long enough for a diagnosis.
    AWhile,
    /// Until somebody leaves.
    UntilLeft,
}

/// So long nobody has pressed anything who holds no key.
pub const QUIET: Span = Span::from_millis(1_200);

impl Stays {
    /// `None`: for ever.
    fn least(self) -> Option<Span> {
        match self {
            Stays::UntilQuiet => Some(Span::ZERO),
            Stays::AWhile => Some(Span::from_secs(60)),
            Stays::UntilLeft => None,
        }
    }
}

/// What is told last of a run whose view stays.
pub fn last_told(stands: bool) -> Text {
    match stands {
        true => both!("the stop was acknowledged, the shaft stands", "der Halt wurde bestätigt, die Welle steht"),
        false => may_turn(),
    }
}

/// A view that stays behind the end of its run.
#[derive(Debug)]
pub(super) struct Lingering {
    panel: Panel,
    stays: Stays,
    since: Tick,
    /// When a key was seen last, and how many until then.
    pressed: (Tick, u64),
}

impl Lingering {
    /// From now on.
    pub(super) fn new(panel: Panel, stays: Stays, now: Tick) -> Self {
        let pressed = (now, panel.presses());
        Lingering { panel, stays, since: now, pressed }
    }

    /// Whether somebody still looks, and it has not stayed long enough.
    pub(super) fn goes_on(&mut self, now: Tick) -> bool {
        if self.pressed.1 != self.panel.presses() {
            self.pressed = (now, self.panel.presses());
        }
        let has_stayed = self.stays.least().is_some_and(|least| now.since(self.since) >= least);
        let is_quiet = now.since(self.pressed.0) >= QUIET;
        !(self.panel.is_left() || has_stayed && is_quiet)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(ms: u64) -> Tick {
        Tick::ZERO + Span::from_millis(ms)
    }

    fn with_dead_man() -> Keypad {
        let mut keypad = Keypad::default();
        keypad.needs_holding();
        keypad
    }

    #[test]
    fn arrows_are_steps_in_their_order_and_a_flood_of_them_ends_somewhere() {
        let mut keypad = Keypad::default();
        for button in [Button::More, Button::Hold, Button::Less, Button::More] {
            assert!(!keypad.press(button, at(0)));
        }
        assert_eq!(keypad.steps, [1, -1, 1]);
        (0..10_000).for_each(|ms| assert!(!keypad.press(Button::More, at(ms))));
        assert_eq!((keypad.steps.len(), keypad.due, keypad.ended), (MOST_STEPS, None, None));
    }

    #[test]
    fn a_stop_is_said_once_and_takes_away_what_was_pressed_before_and_after_it() {
        for (button, leaves) in [(Button::Stop, false), (Button::End, true)] {
            let mut keypad = Keypad::default();
            keypad.press(Button::More, at(0));
            assert!(keypad.press(button, at(1)));
            for again in [button, Button::More, Button::Hold, Button::Stop] {
                assert!(!keypad.press(again, at(2)), "who leans on a key does not ask for a harder stop");
            }
            assert_eq!((keypad.steps.len(), keypad.ended, keypad.leaves), (0, Some(EndedBy::Key), leaves));
        }
    }

    #[test]
    fn a_key_that_repeats_is_held_from_the_first_delay_of_any_keyboard_on() {
        for (delay, pace) in [(250, 33), (500, 30), (660, 40), (800, 300)] {
            let mut keypad = with_dead_man();
            assert!(!keypad.press(Button::Hold, at(0)));
            let mut last = delay;
            for nth in 0..50 {
                last = delay + nth * pace;
                assert!(!keypad.look(at(last)) && !keypad.press(Button::Hold, at(last)), "{delay} {pace} {nth}");
            }
            assert!(!keypad.look(at(last + 300)));
            assert!(keypad.look(at(last + 301)) && !keypad.look(at(last + 302)), "said once");
            assert_eq!(keypad.ended, Some(EndedBy::DeadMan));
        }
    }

    #[test]
    fn a_tap_runs_no_longer_than_a_keyboard_may_take_to_repeat() {
        let mut keypad = with_dead_man();
        assert_eq!((keypad.due(), keypad.look(at(9_000))), (None, false), "nothing runs yet");
        keypad.press(Button::More, at(9_000));
        assert_eq!(keypad.due(), Some(at(9_800)));
        assert!(keypad.look(at(9_801)));
    }

    #[test]
    fn a_press_behind_the_release_is_too_late() {
        let mut keypad = with_dead_man();
        keypad.press(Button::Hold, at(0));
        assert!(keypad.press(Button::Hold, at(801)), "nobody had looked");
        assert_eq!((keypad.ended, keypad.due()), (Some(EndedBy::DeadMan), None));
        assert!(!keypad.press(Button::Hold, at(802)) && keypad.due().is_none(), "it does not come to life again");
    }

    #[test]
    fn who_lets_go_or_presses_while_it_ends_anyway_asks_for_nothing_more() {
        let mut keypad = with_dead_man();
        keypad.press(Button::Hold, at(0));
        keypad.rests();
        assert!(!keypad.look(at(5_000)) && keypad.due().is_none());
        assert!(!keypad.press(Button::Stop, at(5_001)) && !keypad.press(Button::More, at(5_002)));
        assert!(!keypad.press(Button::End, at(5_003)), "it leaves, and wishes no second stop");
        assert_eq!((keypad.ended, keypad.leaves, keypad.steps.len()), (None, true, 0));
    }

    #[test]
    fn without_a_dead_man_nothing_is_due() {
        let mut keypad = Keypad::default();
        keypad.press(Button::Hold, at(0));
        assert_eq!((keypad.due(), keypad.look(at(1_000_000))), (None, false));
    }

    /// A key that is held on where the view closes goes to the shell.
    #[test]
    fn no_view_closes_by_itself_while_a_key_repeats() {
        for (stays, least) in [(Stays::UntilQuiet, 1_200), (Stays::AWhile, 60_000), (Stays::UntilLeft, u64::MAX)] {
            for held in [0, 5_000, 90_000] {
                let panel = Panel::default();
                panel.watch(true);
                let mut view = Lingering::new(panel.clone(), stays, at(0));
                let closes = (0..200_000).step_by(50).find(|ms| {
                    if *ms < held {
                        panel.press(Button::Hold, at(*ms));
                    }
                    !view.goes_on(at(*ms))
                });
                let quiet = held.saturating_sub(50) + 1_200;
                assert_eq!(closes, Some(least.max(quiet)).filter(|ms| *ms < 200_000), "{stays:?} {held}");
                panel.press(Button::End, at(200_000));
                assert!(!view.goes_on(at(200_000)), "{stays:?}");
            }
        }
    }

    #[test]
    fn who_has_no_keys_has_left() {
        let panel = Panel::default();
        assert!(panel.is_left() && !panel.is_watched());
        panel.watch(true);
        assert!(!panel.is_left() && panel.is_watched() && panel.has_keys());
        assert!(panel.press(Button::Stop, at(0)) && !panel.is_left());
        assert!(!panel.press(Button::End, at(0)) && panel.is_left());
    }
}
