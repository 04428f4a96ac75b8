//! Why a question brought no value.

use super::pump::PumpError;
use super::route::No;
use crate::exchange::ExchangeError;
use crate::profile::Family;
use crate::transport::LinkError;

/// Error register: the width of the telegram is not the one of the parameter (CM-485 manual 6.6).
const WRONG_WIDTH: u16 = 14;
/// Error register: wrong type (CM-485 manual 6.6).
const WRONG_TYPE: u16 = 10;

/// Error register: the sets have different values, so set 0 cannot be read (CM-485 manual 6.6, 7).
const SETS_DIFFER: u16 = 9;

/// The drive understood the question and said no.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// What the reply tells.
    pub no: No,
    /// The cause, read back at once from where the family keeps it: P.11 of the ACTIVE family.
    pub cause: Option<u16>,
    /// The answer that told the cause was lost, and reading had cleared it.
    pub unheard: bool,
    /// Of a write that may have been done all the same: whether its value stood there when it was read back.
    pub taken: Option<bool>,
}

impl Refusal {
    /// Whether its cause says that the drive has no such parameter, or does not tell it.
    pub fn denies(self, family: &Family) -> bool {
        if self.no.is_of_number() {
            return true;
        }
        let row = self.cause.and_then(|cause| family.error(cause.into()));
        row.is_some_and(|row| row.denies)
    }

    /// Whether a write may have been done all the same: by its cause.
    pub(super) fn leaves_open(self, family: &Family) -> bool {
        let row = self.cause.and_then(|cause| family.error(cause.into()));
        row.is_some_and(|row| row.leaves_open)
    }

    /// Whether it may be the width alone that was wrong: by its cause, or because an address is refused without one.
    pub fn is_of_width(self) -> bool {
        match (self.no, self.cause) {
            (No::Exception(_) | No::Nak, Some(WRONG_WIDTH | WRONG_TYPE)) => true,
            (no, None | Some(0)) => no.is_of_address(),
            _ => false,
        }
    }

    /// Whether it says so if it is said twice: the code of the refusal is of what was asked, and there is no cause beside it. Once, a
    /// damaged question brings it too.
    pub fn denies_if_repeated(self) -> bool {
        self.cause.is_none() && !self.unheard && self.no.is_of_what_was_asked()
    }
}

/// Why a question brought no value.
#[derive(Debug, thiserror::Error)]
pub enum AccessError {
    /// The drive said no.
    #[error("refused: {:?}", .0.no)]
    Refused(Refusal),
    /// No valid reply.
    #[error(transparent)]
    Exchange(#[from] ExchangeError),
    /// The protocol on the line, or the family, has no telegram for this.
    #[error("there is no telegram for this")]
    Unspeakable,
    /// The port is gone.
    #[error(transparent)]
    Link(#[from] LinkError),
    /// Somebody pressed Ctrl-C.
    #[error("interrupted")]
    Interrupted,
}

impl AccessError {
    /// Whether the whole session is over, not just this question.
    pub fn is_fatal(&self) -> bool {
        matches!(self, AccessError::Link(_) | AccessError::Interrupted)
    }

    /// Whether the port takes no bytes, which it may a moment later.
    pub fn is_stuck(&self) -> bool {
        matches!(self, AccessError::Link(LinkError::Stuck(_)))
    }

    /// Whether the port went away, or the other end closed the connection.
    pub fn is_lost(&self) -> bool {
        matches!(self, AccessError::Link(LinkError::Lost(_)))
    }

    /// Whether the value is not the same in all data sets, so that set 0 has none.
    pub fn sets_differ(&self) -> bool {
        matches!(self, AccessError::Refused(Refusal { cause: Some(SETS_DIFFER), .. }))
    }

    /// Whether set 0 was refused and nobody knows why: the answer that told it was lost, and the sets may differ.
    pub fn may_differ(&self) -> bool {
        matches!(self, AccessError::Refused(Refusal { unheard: true, .. }))
    }

    /// What the drive said in place of a value.
    pub fn refusal(&self) -> Option<Refusal> {
        match self {
            AccessError::Refused(refusal) => Some(*refusal),
            _ => None,
        }
    }

    /// Whether it may be otherwise a moment later: the drive is busy.
    pub fn passes(&self) -> bool {
        matches!(self, AccessError::Refused(Refusal { no, .. }) if no.passes())
    }

    /// Whether the drive said no.
    pub fn is_refused(&self) -> bool {
        matches!(self, AccessError::Refused(_))
    }
}

impl From<PumpError> for AccessError {
    fn from(error: PumpError) -> Self {
        match error {
            PumpError::Link(error) => error.into(),
            PumpError::Interrupted => AccessError::Interrupted,
            PumpError::TimeUp(error) => error.into(),
        }
    }
}
