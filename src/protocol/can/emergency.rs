//! Emergencies: a node has tripped, or is well again (EM-RES-03 manual 5.8.3, 5.9.3; CiA 301 7.2.7).

/// What an emergency says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Emergency {
    /// Error code of CANopen; a drive always sends [`Emergency::OF_A_DRIVE`].
    pub code: u16,
    /// Error register, object 1001h; a drive always sends 80h.
    pub register: u8,
    /// Bytes 3 to 5, which a drive leaves zero.
    pub between: [u8; 3],
    /// Bytes 6 and 7, least significant first: the fault key of a drive, as P.260 shows it.
    pub fault: u16,
}

impl Emergency {
    /// Error code of every fault of a drive: generic error (manual 5.9.3).
    pub const OF_A_DRIVE: u16 = 0x1000;
    /// Error register of every fault of a drive: the maker's own (manual 5.9.3).
    pub const REGISTER: u8 = 0x80;
    /// Every byte zero: the fault was acknowledged (manual 5.8.3).
    pub const CLEARED: Emergency = Emergency { code: 0, register: 0, between: [0; 3], fault: 0 };

    /// That a drive has tripped with this fault.
    pub fn of_a_drive(fault: u16) -> Self {
        Emergency { code: Self::OF_A_DRIVE, register: Self::REGISTER, fault, ..Self::CLEARED }
    }

    /// Whether it has what the drives send: one of their faults, or that it was acknowledged.
    pub fn is_of_a_drive(&self) -> bool {
        *self == Self::of_a_drive(self.fault) || *self == Self::CLEARED
    }

    /// `None` for anything but eight bytes.
    pub fn decode(bytes: &[u8]) -> Option<Self> {
        let &[low, high, register, a, b, c, fault_low, fault_high] = bytes else { return None };
        let code = u16::from_le_bytes([low, high]);
        Some(Emergency { code, register, between: [a, b, c], fault: u16::from_le_bytes([fault_low, fault_high]) })
    }

    /// The data of the frame.
    pub fn encode(&self) -> [u8; 8] {
        let ([low, high], [fault_low, fault_high]) = (self.code.to_le_bytes(), self.fault.to_le_bytes());
        let [a, b, c] = self.between;
        [low, high, self.register, a, b, c, fault_low, fault_high]
    }
}
