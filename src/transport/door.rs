//! A handle of our own on a serial port, beside the one that tokio-serial has.

#[cfg(unix)]
pub(super) type SideDoor = std::os::fd::OwnedFd;

/// There is none.
#[cfg(not(unix))]
#[derive(Debug)]
pub(super) struct SideDoor;
