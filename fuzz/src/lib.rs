//! A line whose bytes and pauses are the fuzzer's, and what carries a conversation over it.

use antrieb::exchange::{Conversation, Step};
use antrieb::tick::{Span, Tick};

/// Steps at one and the same time after which a conversation runs in circles.
const MOST_AT_ONCE: u32 = 200;

/// What comes: a byte for the pause before it (0 to 1275 ms), one for how many bytes there are, and these. Behind its end: silence.
pub struct Line {
    said: std::vec::IntoIter<u8>,
    next: Option<(Tick, Vec<u8>)>,
}

impl Line {
    /// A line that says this.
    pub fn new(said: Vec<u8>) -> Self {
        Line { said: said.into_iter(), next: None }
    }

    /// What comes next, if it comes by then.
    fn speaks(&mut self, now: Tick, until: Tick) -> Option<(Tick, Vec<u8>)> {
        if self.next.is_none() {
            let pause = Span::from_millis(5).times(u64::from(self.said.next()?));
            let count = usize::from(self.said.next()?) % 48;
            self.next = Some((now + pause, self.said.by_ref().take(count).collect()));
        }
        self.next.take_if(|next| next.0 <= until).map(|(at, bytes)| (at.max(now), bytes))
    }
}

/// Carries it on until it has something to tell, within `longest` of now.
pub fn carry<C: Conversation>(talk: &mut C, line: &mut Line, now: &mut Tick, longest: Span) -> C::End {
    let by = *now + longest;
    let mut at_once = 0;
    loop {
        let before = *now;
        match talk.step(*now) {
            Step::Done(end) => return end,
            Step::Send(_) => {}
            Step::Wait(until) => match line.speaks(*now, until) {
                Some((at, bytes)) => {
                    *now = at;
                    talk.feed(at, &bytes);
                }
                None => *now = until.max(*now),
            },
        }
        at_once = if *now > before { 0 } else { at_once + 1 };
        assert!(at_once < MOST_AT_ONCE, "it runs in circles at {now:?}");
        assert!(*now <= by, "it is {} late", now.since(by));
    }
}
