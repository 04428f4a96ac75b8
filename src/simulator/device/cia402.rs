//! States and commands of CiA 402, as far as the drives of this bench share them (CM-485 manual 9.1.2, 10.2; LXM05
//! manual 6.3: docs/sources.md).

/// States of the drive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum State {
    NotReady,
    SwitchOnInhibit,
    Ready,
    SwitchedOn,
    Enabled,
    QuickStop,
    FaultReaction,
    Fault,
}

impl State {
    /// Bits 0-6 of the status word (CM-485 manual 9.1.2, 10.2).
    pub(crate) fn bits(self) -> u16 {
        match self {
            State::NotReady => 0x00,
            State::SwitchOnInhibit => 0x40,
            State::Ready => 0x21,
            State::SwitchedOn => 0x23,
            State::Enabled => 0x27,
            State::QuickStop => 0x07,
            State::FaultReaction => 0x0F,
            State::Fault => 0x08,
        }
    }
}

/// Commands of the control word (CM-485 manual 9.1.2, 10.2).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Command {
    DisableVoltage,
    QuickStop,
    ShutDown,
    SwitchOn,
    EnableOperation,
}

impl Command {
    pub(crate) fn of(word: u16) -> Self {
        match (word & 2 != 0, word & 4 != 0, word & 1 != 0, word & 8 != 0) {
            (false, ..) => Command::DisableVoltage,
            (_, false, ..) => Command::QuickStop,
            (_, _, false, _) => Command::ShutDown,
            (_, _, _, false) => Command::SwitchOn,
            (_, _, _, true) => Command::EnableOperation,
        }
    }
}
