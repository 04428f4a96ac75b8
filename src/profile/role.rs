//! What parameters are to a drive: by its role a verb finds the parameter that it needs, whatever its number.
//!
//! The set is closed: a catalogue that names another role is refused, with the place.

use super::broken::in_both;
use crate::text::both;
use serde::{Deserialize, Deserializer};

/// Rows: name in Rust, name in a catalogue, what it is.
macro_rules! roles {
    ($($role:ident $name:literal $what:literal,)*) => {
        /// What a parameter is to its drive.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Role {
            $(#[doc = $what] $role,)*
        }

        impl Role {
            /// Every role, by name.
            pub const ALL: &[Role] = &[$(Role::$role),*];

            /// What it is called in a catalogue.
            pub const fn name(self) -> &'static str {
                match self { $(Role::$role => $name),* }
            }
        }
    };
}

roles! {
    ActiveSet "active-set" "Data set in which the drive works.",
    ActualFrequency "actual-frequency" "Frequency that the regulation takes for the actual one.",
    Address "address" "Its own address on the line.",
    BaudRate "baud-rate" "Speed of the line.",
    BrakingTime "braking-time" "How long it brakes by direct current behind a stop.",
    BusNode "bus-node" "Its address on the system bus.",
    BusRate "bus-rate" "Bit rate of the system bus.",
    BusTool "bus-tool" "Whether it has the channel of the system bus that is meant for tools.",
    Configuration "configuration" "Kind of regulation, and where functions take their input from.",
    ControlDeviation "control-deviation" "How far the actual value may be from the setpoint and still be reached.",
    ControlMode "control-mode" "Who is obeyed: contacts, control word.",
    ControlWord "control-word" "What is commanded.",
    Current "current" "Current in the motor.",
    DataFormat "data-format" "Character format of the line, where one setting holds all of it.",
    DcLinkVoltage "dc-link-voltage" "Voltage of the DC link.",
    DigitalInputs "digital-inputs" "State of the contacts.",
    EncoderFrequency "encoder-frequency" "Frequency by the encoder.",
    EncoderSpeed "encoder-speed" "Speed by the encoder.",
    ErrorRegister "error-register" "Why something was refused last; reading clears it.",
    Fault "fault" "The fault that is present, or the newest in the memory.",
    FrequencySource "frequency-source" "Where the frequency setpoint comes from.",
    HoldingTime "holding-time" "How long it holds the shaft behind a stop.",
    MaxFrequency "max-frequency" "Highest frequency.",
    MinFrequency "min-frequency" "Lowest frequency.",
    Mode "mode" "Kind of setpoint that is wanted.",
    ModeActive "mode-active" "Kind of setpoint that is obeyed.",
    Movement "movement" "What tells whether the shaft turns.",
    NodeId "node-id" "Its address over the other protocol: VABus.",
    Parity "parity" "Parity of the line.",
    PercentReference "percent-reference" "What 100 % of a setpoint is.",
    PercentSource "percent-source" "Where the percentage comes from.",
    PolePairs "pole-pairs" "Pairs of poles of the motor.",
    Position "position" "Position of the shaft.",
    Power "power" "Power of the motor.",
    Protocol "protocol" "What it speaks on the line.",
    RampSetpoint "ramp-setpoint" "What the ramp starts from: bus, internal setpoint, or both.",
    Reset "reset" "Restarts the drive.",
    SetSelection "set-selection" "Who selects the data set.",
    SetpointBus "setpoint-bus" "Setpoint from the line, as the drive has it.",
    SetpointCurrent "setpoint-current" "Setpoint of a current.",
    SetpointFrequency "setpoint-frequency" "Setpoint of a frequency from the line.",
    SetpointInternal "setpoint-internal" "Setpoint that the drive forms itself.",
    SetpointPercent "setpoint-percent" "Setpoint of a percentage from the line.",
    SetpointPosition "setpoint-position" "Setpoint of a position.",
    SetpointRamp "setpoint-ramp" "Setpoint behind the ramp.",
    SetpointSpeed "setpoint-speed" "Setpoint of a speed in a profile.",
    SetpointVelocity "setpoint-velocity" "Setpoint of a speed.",
    SpeedLimit "speed-limit" "Highest speed.",
    StatorFrequency "stator-frequency" "Frequency that is put out to the motor.",
    StatusWord "status-word" "What is told of the state.",
    Transition5 "transition-5" "What transition 5 of the state machine does.",
    Warnings "warnings" "Warnings that are present.",
    Watchdog "watchdog" "How long it waits for a telegram until it stops by itself.",
    WordOrder "word-order" "Which half of a value in two registers goes first.",
}

impl Role {
    /// The role of this name.
    pub fn of(name: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|role| role.name() == name)
    }
}

impl AsRef<str> for Role {
    fn as_ref(&self) -> &str {
        self.name()
    }
}

impl std::fmt::Display for Role {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

impl<'de> Deserialize<'de> for Role {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = String::deserialize(deserializer)?;
        Role::of(&name).ok_or_else(|| {
            let names: Vec<_> = Role::ALL.iter().map(|role| role.name()).collect();
            let why = both!(
                "there is no role `{name}`, expected one of `{names}`",
                "es gibt keine Rolle `{name}`; erwartet wird eine von `{names}`",
                names = names.join("`, `")
            );
            in_both(&why)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::profile::Registry;

    #[test]
    fn every_role_has_its_name_and_some_drive_plays_it() {
        let registry = Registry::open(&[]).unwrap();
        for &role in Role::ALL {
            assert_eq!(Role::of(role.name()), Some(role));
            // Of the voltage of the DC link no manual that we have names the number: catalogues of users do.
            let is_theirs = role == Role::DcLinkVoltage;
            assert!(is_theirs || registry.families().any(|family| family.role(role).is_some()), "{role}");
        }
        assert_eq!(Role::of("actual-sped"), None);
    }
}
