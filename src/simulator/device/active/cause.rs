//! Why an access to a parameter is refused.

/// Causes that P.11 tells (CM-485 manual 6.6; 20 and 21: EM-RES-03 manual 5.10.1).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Cause {
    Value = 1,
    Set = 2,
    WriteOnly = 3,
    ReadOnly = 4,
    Eeprom = 6,
    Running = 8,
    SetsDiffer = 9,
    Type = 10,
    Unknown = 11,
    Check = 12,
    Syntax = 13,
    Width = 14,
    Other = 15,
    NotReachable = 20,
    StringOnBus = 21,
}
