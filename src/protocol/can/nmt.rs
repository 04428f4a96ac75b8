//! Network management: commands (identifier 0), boot-up and heartbeat (EM-RES-03 manual 5.8.1, 5.9.1; CiA 301 7.2.8).

/// What a node is told.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Command {
    /// Start Remote Node: PDOs begin. A drive can be released by them.
    Start,
    /// Stop Remote Node: no PDOs, no SDOs. It is no stop of a shaft.
    Stop,
    /// Enter Pre-Operational: no PDOs.
    PreOperational,
    /// Reset Node.
    ResetNode,
    /// Reset Communication.
    ResetCommunication,
    /// Not in the manual, nor in CiA 301.
    Unknown(u8),
}

impl Command {
    /// The commands that are known, with their specifiers.
    pub const ALL: [(u8, Command); 5] = [
        (1, Command::Start),
        (2, Command::Stop),
        (128, Command::PreOperational),
        (129, Command::ResetNode),
        (130, Command::ResetCommunication),
    ];

    /// The command with this specifier.
    pub fn new(specifier: u8) -> Self {
        let known = Self::ALL.into_iter().find(|row| row.0 == specifier);
        known.map_or(Command::Unknown(specifier), |row| row.1)
    }

    /// Its specifier.
    pub fn specifier(self) -> u8 {
        match self {
            Command::Unknown(specifier) => specifier,
            known => Self::ALL.into_iter().find(|row| row.1 == known).map_or(0, |row| row.0),
        }
    }
}

/// A command to a node; node 0 is everybody.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Order {
    /// What is told.
    pub command: Command,
    /// To whom.
    pub node: u8,
}

impl Order {
    /// `None` for anything but two bytes.
    pub fn decode(bytes: &[u8]) -> Option<Self> {
        match bytes {
            [specifier, node] => Some(Order { command: Command::new(*specifier), node: *node }),
            _ => None,
        }
    }

    /// The data of the frame.
    pub fn encode(self) -> [u8; 2] {
        [self.command.specifier(), self.node]
    }

    /// Its frame as bytes: the identifier, which is 0, and the data.
    pub fn telegram(self) -> [u8; 4] {
        let [specifier, node] = self.encode();
        [0, 0, specifier, node]
    }
}

/// What a node tells of itself. The drives only ever tell [`Life::BootUp`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Life {
    /// Boot-up: it has begun anew.
    BootUp,
    /// Stopped.
    Stopped,
    /// Operational.
    Operational,
    /// Pre-Operational.
    PreOperational,
    /// None of these.
    Unknown(u8),
}

impl Life {
    const ALL: [(u8, Life); 4] =
        [(0, Life::BootUp), (4, Life::Stopped), (5, Life::Operational), (127, Life::PreOperational)];

    /// `None` for anything but one byte. Its top bit toggles in answers to node guarding, and says nothing.
    pub fn decode(bytes: &[u8]) -> Option<Self> {
        let [state] = bytes else { return None };
        let known = Self::ALL.into_iter().find(|row| row.0 == state & 0x7F);
        Some(known.map_or(Life::Unknown(*state), |row| row.1))
    }

    /// The data of the frame.
    pub fn encode(self) -> [u8; 1] {
        match self {
            Life::Unknown(state) => [state],
            known => [Self::ALL.into_iter().find(|row| row.1 == known).map_or(0, |row| row.0)],
        }
    }
}
