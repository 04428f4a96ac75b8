//! What identifiers mean: the predefined connection set of CiA 301 (table 38), and what the drives make of it (EM-RES-03 manual
//! 5.8 to 5.11, 5.14).

use std::ops::RangeInclusive;

/// Identifiers that the emergencies of the drives have; no other service may use them (manual 5.8.2, 5.9.4, 5.11.1).
pub const EMERGENCIES: RangeInclusive<u16> = 129..=191;
/// Identifiers that are advised for PDOs (manual 5.14).
pub const FOR_PDOS: RangeInclusive<u16> = 385..=1407;
/// Largest node of a drive (manual 5.5). Node 0 is the drive that is the master.
pub const LAST_DRIVE: u8 = 63;
/// Largest node of CANopen.
pub const LAST_NODE: u8 = 127;

/// One of the three PDOs that a drive has each way.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum PdoNumber {
    /// The first.
    One,
    /// The second.
    Two,
    /// The third.
    Three,
}

impl PdoNumber {
    /// All of them.
    pub const ALL: [PdoNumber; 3] = [PdoNumber::One, PdoNumber::Two, PdoNumber::Three];

    /// 1 to 3.
    pub fn new(number: u8) -> Option<Self> {
        Self::ALL.into_iter().find(|pdo| pdo.number() == number)
    }

    /// 1 to 3.
    pub fn number(self) -> u8 {
        match self {
            PdoNumber::One => 1,
            PdoNumber::Two => 2,
            PdoNumber::Three => 3,
        }
    }

    /// From 0 on.
    pub fn index(self) -> u16 {
        u16::from(self.number()) - 1
    }
}

/// One of the two SDO channels of a drive (manual 5.9.4).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum SdoChannel {
    /// For the master.
    One,
    /// For a tool that shows the bus; fixed to its identifiers.
    Two,
}

impl SdoChannel {
    /// 1 or 2.
    pub fn number(self) -> u8 {
        match self {
            SdoChannel::One => 1,
            SdoChannel::Two => 2,
        }
    }
}

/// What an identifier of the predefined connection set is for. Nodes are 0 to 127, of which the drives have 0 to 63.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Service {
    /// Starts and stops nodes.
    Nmt,
    /// Everybody's beat.
    Sync,
    /// A time of day; the drives have none (CiA 301).
    Time,
    /// A node has tripped, or is well again.
    Emergency(u8),
    /// What a node sends.
    TxPdo(PdoNumber, u8),
    /// What a node receives.
    RxPdo(PdoNumber, u8),
    /// The fourth PDOs of CANopen, which the drives do not have.
    FourthPdo {
        /// The node sends it.
        sent: bool,
        /// Node.
        node: u8,
    },
    /// A node answers about a parameter.
    SdoReply(SdoChannel, u8),
    /// A node is asked about a parameter.
    SdoRequest(SdoChannel, u8),
    /// A node is there (boot-up), or still there (heartbeat).
    BootUp(u8),
    /// Nothing of it.
    Free,
}

/// First identifier of a service with one for each node: node 0 has it, though mostly nobody uses it.
const SYNC: u16 = 0x080;
const TIME: u16 = 0x100;
/// Manual 5.11.1: TxPDO1 384, RxPDO1 512, TxPDO2 640 …; 128 behind each other.
const TX_PDO: u16 = 0x180;
const RX_PDO: u16 = 0x200;
const BETWEEN_PDOS: u16 = 0x100;
const FOURTH_TX: u16 = 0x480;
const FOURTH_RX: u16 = 0x500;
/// Manual 5.9.4: SDO1 1408 and 1536, SDO2 64 behind each of them.
const SDO_REPLY: u16 = 0x580;
const SDO_REQUEST: u16 = 0x600;
const BETWEEN_SDOS: u16 = 0x40;
/// Manual 5.9.1.1.
const BOOT_UP: u16 = 0x700;

impl Service {
    /// What an identifier is for, as long as nobody has set another one.
    pub fn of(identifier: u16) -> Self {
        let node = (identifier & u16::from(LAST_NODE)) as u8;
        let drive = (identifier & u16::from(LAST_DRIVE)) as u8;
        let channel = if node > LAST_DRIVE { SdoChannel::Two } else { SdoChannel::One };
        match identifier & !u16::from(LAST_NODE) {
            0 if identifier == 0 => Service::Nmt,
            SYNC if identifier == SYNC => Service::Sync,
            SYNC => Service::Emergency(node),
            TIME if identifier == TIME => Service::Time,
            SDO_REPLY => Service::SdoReply(channel, drive),
            SDO_REQUEST => Service::SdoRequest(channel, drive),
            BOOT_UP => Service::BootUp(node),
            FOURTH_TX => Service::FourthPdo { sent: true, node },
            FOURTH_RX => Service::FourthPdo { sent: false, node },
            base => PdoNumber::ALL
                .into_iter()
                .find_map(|pdo| match base.checked_sub(pdo.index() * BETWEEN_PDOS)? {
                    TX_PDO => Some(Service::TxPdo(pdo, node)),
                    RX_PDO => Some(Service::RxPdo(pdo, node)),
                    _ => None,
                })
                .unwrap_or(Service::Free),
        }
    }

    /// The identifier; `None` for what has none, or no such node.
    pub fn identifier(self) -> Option<u16> {
        let to = |last: u8, node: u8, base: u16| (node <= last).then_some(base + u16::from(node));
        match self {
            Service::Nmt => Some(0),
            Service::Sync => Some(SYNC),
            Service::Time => Some(TIME),
            Service::Emergency(0) | Service::Free => None,
            Service::Emergency(node) => to(LAST_NODE, node, SYNC),
            Service::TxPdo(pdo, node) => to(LAST_NODE, node, TX_PDO + pdo.index() * BETWEEN_PDOS),
            Service::RxPdo(pdo, node) => to(LAST_NODE, node, RX_PDO + pdo.index() * BETWEEN_PDOS),
            Service::FourthPdo { sent: true, node } => to(LAST_NODE, node, FOURTH_TX),
            Service::FourthPdo { sent: false, node } => to(LAST_NODE, node, FOURTH_RX),
            Service::SdoReply(SdoChannel::One, node) => to(LAST_DRIVE, node, SDO_REPLY),
            Service::SdoReply(SdoChannel::Two, node) => to(LAST_DRIVE, node, SDO_REPLY + BETWEEN_SDOS),
            Service::SdoRequest(SdoChannel::One, node) => to(LAST_DRIVE, node, SDO_REQUEST),
            Service::SdoRequest(SdoChannel::Two, node) => to(LAST_DRIVE, node, SDO_REQUEST + BETWEEN_SDOS),
            Service::BootUp(node) => to(LAST_NODE, node, BOOT_UP),
        }
    }
}
