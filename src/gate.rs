//! The gate before everything that can move a shaft, wear the EEPROM, or cut the line.
//!
//! Functions that do such things take a [`Permit`]; only [`ask`] makes one, and a [`Relief`], which can only take motion
//! away. So forgetting to ask does not compile:
//!
//! ```compile_fail
//! use antrieb::gate::{Motion, Permit};
//! let permit: Permit<Motion> = Permit { _of: std::marker::PhantomData };
//! ```
//!
//! ```compile_fail
//! use antrieb::drive::{Session, Target, motion::Motor};
//! fn without_asking(session: &mut Session<'_>, target: &mut Target) {
//!     let motor = Motor::new(session, target, None);
//! }
//! ```
//!
//! The same with a permit compiles:
//!
//! ```
//! use antrieb::drive::{Session, Target, motion::Motor};
//! use antrieb::gate::{Motion, Permit};
//! fn after_asking(session: &mut Session<'_>, target: &mut Target, permit: &Permit<Motion>) {
//!     let motor = Motor::new(session, target, permit, None);
//! }
//! ```
//!
//! But not with one that was given for something else:
//!
//! ```compile_fail,E0308
//! use antrieb::drive::{Session, Target, motion::Motor};
//! use antrieb::gate::{Counters, Permit};
//! fn asked_about_counters(session: &mut Session<'_>, target: &mut Target, permit: &Permit<Counters>) {
//!     let motor = Motor::new(session, target, permit, None);
//! }
//! ```
//!
//! ```compile_fail,E0277
//! use antrieb::gate::{Counters, Permit, Writes};
//! fn writes(permit: &Permit<impl Writes>) {}
//! fn asked_about_counters(permit: &Permit<Counters>) {
//!     writes(permit);
//! }
//! ```

use crate::text::Text;
use std::marker::PhantomData;
use std::pin::Pin;

/// What can happen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Hazard {
    /// A value in the drive changes.
    Write,
    /// The EEPROM wears.
    Wear,
    /// The shaft may turn.
    Motion,
    /// The line to the drive may be cut.
    Line,
    /// The drive restarts, or its faults are reset.
    Reset,
    /// What the drive has counted is lost.
    Counters,
}

/// What a permit can be for, as a type.
pub trait Kind: sealed::Sealed {
    /// What a question must name, so that a yes to it is such a permit.
    const HAZARD: Hazard;
}

/// Kinds that come with writing parameters.
pub trait Writes: Kind {}

mod sealed {
    pub trait Sealed {}
}

macro_rules! kinds {
    ($($(#[doc = $doc:literal])* $kind:ident: $hazard:ident;)*) => {$(
        $(#[doc = $doc])*
        #[derive(Debug)]
        pub enum $kind {}
        impl sealed::Sealed for $kind {}
        impl Kind for $kind {
            const HAZARD: Hazard = Hazard::$hazard;
        }
    )*};
}

kinds! {
    /// Turning a shaft, with everything that a run writes.
    Motion: Motion;
    /// Writing values.
    Writing: Write;
    /// Moving a drive to another line setting.
    Line: Line;
    /// Clearing counters.
    Counters: Counters;
}

impl Writes for Motion {}
impl Writes for Writing {}
impl Writes for Line {}

/// Proof that the user agreed to something of this kind, or that nobody needs to. Cannot be made but by [`ask`] and by a
/// [`Relief`].
#[derive(Debug)]
pub struct Permit<K: Kind> {
    _of: PhantomData<K>,
}

/// An act that can only take motion away. It needs nobody's word: its permit comes from what it is. Functions that take
/// one do nothing else with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relief {
    /// Disable operation: the drive stops as its settings say, and is without power then.
    Disable,
    /// Quick stop.
    QuickStop,
    /// Disable voltage: without power at once.
    DisableVoltage,
    /// The setpoint goes to a zero at which the shaft stands, in the mode in which the drive works.
    Zero,
}

impl Relief {
    /// The permit for this act.
    pub fn permit(self) -> Permit<Motion> {
        Permit { _of: PhantomData }
    }
}

/// What the user is asked.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Question {
    /// What can happen.
    pub hazards: Vec<Hazard>,
    /// One line that says what is going to be done.
    pub title: Text,
    /// What exactly: old and new values, where they go.
    pub details: Vec<Text>,
}

/// What came back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answer {
    /// Go on.
    Yes,
    /// Do not.
    No,
    /// There is nobody to ask: no terminal, and no `--yes`.
    Nobody,
}

/// An answer that is waited for. Whoever no longer wants it drops it; nothing that is typed afterwards counts.
pub type Reply<'a> = Pin<Box<dyn Future<Output = Answer> + 'a>>;

/// Somebody who can be asked: the terminal, `--yes`, or a test.
pub trait Ask {
    /// Puts the question and waits for the answer, without holding up the line or a signal.
    fn ask<'a>(&'a mut self, question: &'a Question) -> Reply<'a>;

    /// Whether anybody can answer; if not, nothing needs to be opened to find that out.
    fn is_there(&self) -> bool;

    /// Whether the answer takes its time, in which what was shown may change.
    fn takes_time(&self) -> bool {
        true
    }
}

/// Why there is no permit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Denied {
    /// The user said no.
    Refused,
    /// There was nobody to ask.
    Nobody,
}

/// Whether there is anybody to ask at all.
pub fn somebody(ask: &dyn Ask) -> Result<(), Denied> {
    if ask.is_there() { Ok(()) } else { Err(Denied::Nobody) }
}

/// Asks, and hands out the key if the answer is yes. A question that does not name the hazard of this kind is not put: nobody
/// could agree to it.
pub async fn ask<K: Kind>(somebody: &mut dyn Ask, question: &Question) -> Result<Permit<K>, Denied> {
    if !question.hazards.contains(&K::HAZARD) {
        return Err(Denied::Refused);
    }
    match somebody.ask(question).await {
        Answer::Yes => Ok(Permit { _of: PhantomData }),
        Answer::No => Err(Denied::Refused),
        Answer::Nobody => Err(Denied::Nobody),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::pin::pin;
    use std::task::{Context, Poll, Waker};

    struct Says(Answer);

    impl Ask for Says {
        fn ask<'a>(&'a mut self, _: &'a Question) -> Reply<'a> {
            Box::pin(async { self.0 })
        }
        fn is_there(&self) -> bool {
            self.0 != Answer::Nobody
        }
    }

    fn asked<K: Kind>(answer: Answer, hazards: &[Hazard]) -> Option<Denied> {
        let question = Question { hazards: hazards.to_vec(), title: Text::default(), details: Vec::new() };
        let mut says = Says(answer);
        let mut asked = pin!(ask::<K>(&mut says, &question));
        let Poll::Ready(permit) = asked.as_mut().poll(&mut Context::from_waker(Waker::noop())) else {
            unreachable!("the answer is there at once")
        };
        permit.err()
    }

    #[test]
    fn only_a_yes_is_a_permit() {
        for (answer, denied) in
            [(Answer::Yes, None), (Answer::No, Some(Denied::Refused)), (Answer::Nobody, Some(Denied::Nobody))]
        {
            assert_eq!(asked::<Motion>(answer, &[Hazard::Motion]), denied, "{answer:?}");
        }
    }

    #[test]
    fn a_yes_is_a_permit_for_what_was_asked_about_only() {
        use Hazard::{Line as Cut, Motion as Turn, Reset, Wear, Write};
        assert_eq!(asked::<Writing>(Answer::Yes, &[Write, Wear]), None);
        assert_eq!(asked::<Line>(Answer::Yes, &[Write, Cut, Reset]), None);
        assert_eq!(asked::<Counters>(Answer::Yes, &[Hazard::Counters]), None);
        for hazards in [&[][..], &[Write, Wear, Cut, Reset], &[Hazard::Counters]] {
            assert_eq!(asked::<Motion>(Answer::Yes, hazards), Some(Denied::Refused), "{hazards:?}");
        }
        assert_eq!(asked::<Counters>(Answer::Yes, &[Turn, Write]), Some(Denied::Refused));
    }

    #[test]
    fn where_nobody_can_answer_nothing_needs_to_be_opened_to_find_that_out() {
        assert_eq!(somebody(&Says(Answer::Nobody)), Err(Denied::Nobody));
        assert_eq!(somebody(&Says(Answer::No)), Ok(()));
    }
}
