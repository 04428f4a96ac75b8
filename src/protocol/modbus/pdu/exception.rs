//! Exception codes.

use std::fmt;

/// Exception codes (MODBUS Application Protocol V1.1b3, 7; CM-485 manual 6.6 uses 1-4).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Exception {
    /// 1: function code or sub-function unknown.
    IllegalFunction,
    /// 2: address (parameter) unknown, or a wrong number of registers.
    IllegalDataAddress,
    /// 3: wrong length, or a fixed field with another value.
    IllegalDataValue,
    /// 4: reading or writing the parameter failed.
    DeviceFailure,
    /// 5: accepted, takes long.
    Acknowledge,
    /// 6: busy with a long command.
    DeviceBusy,
    /// 8: memory parity error.
    MemoryParity,
    /// 10: gateway has no path.
    GatewayPath,
    /// 11: gateway target did not answer.
    GatewayTarget,
    /// A code that the norm does not define.
    Other(u8),
}

impl Exception {
    const TABLE: [(Exception, u8, &'static str); 9] = [
        (Exception::IllegalFunction, 1, "illegal function"),
        (Exception::IllegalDataAddress, 2, "illegal data address"),
        (Exception::IllegalDataValue, 3, "illegal data value"),
        (Exception::DeviceFailure, 4, "slave device failure"),
        (Exception::Acknowledge, 5, "acknowledge"),
        (Exception::DeviceBusy, 6, "slave device busy"),
        (Exception::MemoryParity, 8, "memory parity error"),
        (Exception::GatewayPath, 10, "gateway path unavailable"),
        (Exception::GatewayTarget, 11, "gateway target failed to respond"),
    ];

    /// The exception that a code on the wire stands for.
    pub fn from_code(code: u8) -> Self {
        Self::TABLE.iter().find(|row| row.1 == code).map_or(Exception::Other(code), |row| row.0)
    }

    /// The code on the wire.
    pub fn code(self) -> u8 {
        match self {
            Exception::Other(code) => code,
            known => Self::TABLE.iter().find(|row| row.0 == known).map_or(0, |row| row.1),
        }
    }

    /// The name that the norm gives.
    pub fn name(self) -> &'static str {
        Self::TABLE.iter().find(|row| row.0 == self).map_or("undefined exception", |row| row.2)
    }
}

impl fmt::Display for Exception {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({})", self.code(), self.name())
    }
}
