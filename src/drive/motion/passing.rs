//! A look at a drive in passing, while others wait to be told to stop: of what it is worth, the proof of the stop decides.

/// What a drive showed when it was looked at in passing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Look {
    /// What shows its movement, raw.
    Shaft(i64),
    /// Its status word.
    Status(u32),
}
