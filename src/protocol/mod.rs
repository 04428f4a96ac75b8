//! Pure codecs: bytes to telegrams and back, for the master and for the slave side.
//!
//! This room knows wire formats and their norms. It knows no drive, no clock and no I/O, and it never panics on any
//! input: there is no indexing here, only checked access.

pub mod check;
pub mod line;
pub mod modbus;
