//! Function codes and sub-functions, and how much one telegram carries.

/// Function code 3: read holding registers (CM-485 manual 6.4.1: one 16-bit parameter).
pub const READ_REGISTERS: u8 = 3;
/// Function code 4: read input registers (V1.1b3, 6.4).
pub const READ_INPUTS: u8 = 4;
/// Function code 6: write a single register (CM-485 manual 6.4.2: one 16-bit parameter).
pub const WRITE_REGISTER: u8 = 6;
/// Function code 8: diagnostics (CM-485 manual 6.4.5).
pub const DIAGNOSTICS: u8 = 8;
/// Function code 16: write multiple registers (LXM05 manual 5.2.3).
pub const WRITE_REGISTERS: u8 = 16;
/// Function code 23: write multiple registers, then read others (LXM05 manual 5.2.4).
pub const EXCHANGE_REGISTERS: u8 = 23;
/// Function code 43: encapsulated interface; its type says what is inside (LXM05 manual 5.2.5).
pub const ENCAPSULATED: u8 = 43;
/// Type 14 of code 43: read device identification (LXM05 manual 5.2.5).
pub const IDENTIFICATION: u8 = 14;
/// Function code 100: read one 32-bit parameter, vendor code (CM-485 manual 6.4.3).
pub const READ_LONG: u8 = 100;
/// Function code 101: write one 32-bit parameter, vendor code (CM-485 manual 6.4.4).
pub const WRITE_LONG: u8 = 101;
/// Bit of the function code that marks an exception reply (CM-485 manual 6.5).
pub const EXCEPTION_BIT: u8 = 0x80;

/// Most registers that one telegram of code 3, 4 or 23 reads (V1.1b3, 6.3, 6.4, 6.17).
pub const MOST_READ: u16 = 125;
/// Most registers that one telegram of code 16 writes (V1.1b3, 6.12).
pub const MOST_WRITTEN: u16 = 123;
/// Most registers that one telegram of code 23 writes (V1.1b3, 6.17).
pub const MOST_EXCHANGED: u16 = 121;

/// Sub-function of code 8 that sends the data field back (LXM05 manual, table 5.2).
pub const ECHO: u16 = 0x00;
/// Sub-function of code 8 that starts the port anew, which ends "listen only" (LXM05 manual, table 5.2).
pub const RESTART_COMMUNICATION: u16 = 0x01;
/// Sub-function of code 8 that returns the diagnostic register: the number of the last synchronous error of an LXM05
/// (LXM05 manual, table 5.2).
pub const DIAGNOSTIC_REGISTER: u16 = 0x02;
/// Sub-function of code 8 that silences the slave; it does not answer (LXM05 manual, table 5.2; V1.1b3, 6.8.1).
pub const LISTEN_ONLY: u16 = 0x04;
/// Sub-function of code 8 that sets every counter to zero (CM-485 manual 6.4.5).
pub const CLEAR_COUNTERS: u16 = 0x0A;
/// Sub-functions of code 8 that return a counter (CM-485 manual 6.4.5).
pub const COUNTERS: std::ops::RangeInclusive<u16> = 0x0B..=0x12;
