//! The ioctls of Linux serial drivers that no well-kept crate offers safely: low latency, RS-485, error counters, and
//! whether somebody has the port exclusively.
//!
//! The only file of this crate with `unsafe`. Every structure is the kernel's own, field by field; every function
//! passes one of them to the request that the kernel defines for it. All of it is optional: a pseudo terminal answers
//! ENOTTY to each, and on other systems each is "unsupported".

#[cfg(all(unix, not(target_os = "linux")))]
pub(super) use elsewhere::exclusive;
#[cfg(not(target_os = "linux"))]
pub(super) use elsewhere::{counters, rs485, serial, set_rs485, set_serial};
#[cfg(target_os = "linux")]
pub(super) use linux::{counters, exclusive, rs485, serial, set_rs485, set_serial};

/// `struct serial_struct` (Linux, include/uapi/linux/serial.h). What is not named here is given back as it was read.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub(super) struct Serial {
    head: [i32; 4],
    flags: i32,
    sizes: [i32; 3],
    close_delay: u16,
    io_type: [u8; 2],
    hub6: i32,
    closing_wait: [u16; 2],
    iomem_base: usize,
    iomem_reg_shift: u16,
    port_high: u32,
    iomap_base: usize,
}

/// `ASYNC_LOW_LATENCY` (Linux, include/uapi/linux/tty_flags.h).
const LOW_LATENCY: i32 = 1 << 13;

impl Serial {
    pub(super) fn low_latency(self) -> bool {
        self.flags & LOW_LATENCY != 0
    }

    pub(super) fn with_low_latency(self, on: bool) -> Self {
        Serial { flags: if on { self.flags | LOW_LATENCY } else { self.flags & !LOW_LATENCY }, ..self }
    }
}

/// `struct serial_rs485` (Linux, include/uapi/linux/serial.h).
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct KernelRs485 {
    flags: u32,
    /// Milliseconds.
    pub(super) delay_before_send: u32,
    /// Milliseconds.
    pub(super) delay_after_send: u32,
    padding: [u32; 5],
}

/// `SER_RS485_ENABLED`, `_RTS_ON_SEND`, `_RTS_AFTER_SEND` (Linux, include/uapi/linux/serial.h).
const ENABLED: u32 = 1;
const RTS_ON_SEND: u32 = 1 << 1;
const RTS_AFTER_SEND: u32 = 1 << 2;

impl KernelRs485 {
    pub(super) fn is_enabled(self) -> bool {
        self.flags & ENABLED != 0
    }

    /// Switched on, with these delays in milliseconds; RTS is high while sending unless it was already on with another
    /// sense.
    pub(super) fn enabled(self, delay_before_send: u32, delay_after_send: u32) -> Self {
        let sense = if self.is_enabled() { self.flags } else { (self.flags | RTS_ON_SEND) & !RTS_AFTER_SEND };
        KernelRs485 { flags: sense | ENABLED, delay_before_send, delay_after_send, ..self }
    }
}

/// `struct serial_icounter_struct` (Linux, include/uapi/linux/serial.h): counts since the driver was loaded.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub(super) struct Counters {
    modem_lines: [i32; 4],
    rx: i32,
    tx: i32,
    pub(super) frame: i32,
    pub(super) overrun: i32,
    pub(super) parity: i32,
    pub(super) brk: i32,
    buffer_overrun: i32,
    reserved: [i32; 9],
}

#[cfg(target_os = "linux")]
mod linux {
    use super::super::door::SideDoor;
    use super::{Counters, KernelRs485, Serial};
    use rustix::ioctl::{Getter, Opcode, Setter, Updater, ioctl};
    use std::io;

    const TIOCGSERIAL: Opcode = libc::TIOCGSERIAL as Opcode;
    const TIOCSSERIAL: Opcode = libc::TIOCSSERIAL as Opcode;
    const TIOCGRS485: Opcode = libc::TIOCGRS485 as Opcode;
    const TIOCSRS485: Opcode = libc::TIOCSRS485 as Opcode;
    const TIOCGICOUNT: Opcode = libc::TIOCGICOUNT as Opcode;
    const TIOCGEXCL: Opcode = libc::TIOCGEXCL as Opcode;

    // The kernel's sizes on every machine with 64-bit pointers; a wrong field would show here.
    #[cfg(target_pointer_width = "64")]
    const _: () = assert!(size_of::<Serial>() == 72);
    const _: () = assert!(size_of::<KernelRs485>() == 32 && size_of::<Counters>() == 80);

    #[expect(unsafe_code, reason = "no well-kept crate has TIOCGSERIAL")]
    pub(in super::super) fn serial(tty: &SideDoor) -> io::Result<Serial> {
        // SAFETY: TIOCGSERIAL writes one `struct serial_struct`, which `Serial` is, field by field; any bytes are
        // valid for it.
        Ok(unsafe { ioctl(tty, Getter::<TIOCGSERIAL, Serial>::new()) }?)
    }

    #[expect(unsafe_code, reason = "no well-kept crate has TIOCSSERIAL")]
    pub(in super::super) fn set_serial(tty: &SideDoor, serial: Serial) -> io::Result<()> {
        // SAFETY: TIOCSSERIAL reads one `struct serial_struct` and keeps no pointer to it.
        Ok(unsafe { ioctl(tty, Setter::<TIOCSSERIAL, Serial>::new(serial)) }?)
    }

    #[expect(unsafe_code, reason = "no well-kept crate has TIOCGRS485")]
    pub(in super::super) fn rs485(tty: &SideDoor) -> io::Result<KernelRs485> {
        // SAFETY: TIOCGRS485 writes one `struct serial_rs485`, which `KernelRs485` is; any bytes are valid for it.
        Ok(unsafe { ioctl(tty, Getter::<TIOCGRS485, KernelRs485>::new()) }?)
    }

    /// Returns what the driver made of it.
    #[expect(unsafe_code, reason = "no well-kept crate has TIOCSRS485")]
    pub(in super::super) fn set_rs485(tty: &SideDoor, mut config: KernelRs485) -> io::Result<KernelRs485> {
        // SAFETY: TIOCSRS485 reads one `struct serial_rs485`, writes what it made of it to the same place, and keeps
        // no pointer to it.
        unsafe { ioctl(tty, Updater::<TIOCSRS485, KernelRs485>::new(&mut config)) }?;
        Ok(config)
    }

    #[expect(unsafe_code, reason = "no well-kept crate has TIOCGICOUNT")]
    pub(in super::super) fn counters(tty: &SideDoor) -> io::Result<Counters> {
        // SAFETY: TIOCGICOUNT writes one `struct serial_icounter_struct`, which `Counters` is; any bytes are valid
        // for it.
        Ok(unsafe { ioctl(tty, Getter::<TIOCGICOUNT, Counters>::new()) }?)
    }

    /// Whether somebody has taken the port exclusively.
    #[expect(unsafe_code, reason = "no well-kept crate has TIOCGEXCL")]
    pub(in super::super) fn exclusive(tty: &SideDoor) -> io::Result<bool> {
        // SAFETY: TIOCGEXCL writes one `int`; any bytes are valid for it.
        let exclusive: libc::c_int = unsafe { ioctl(tty, Getter::<TIOCGEXCL, libc::c_int>::new()) }?;
        Ok(exclusive != 0)
    }
}

#[cfg(not(target_os = "linux"))]
mod elsewhere {
    use super::super::door::SideDoor;
    use super::{Counters, KernelRs485, Serial};
    use std::io;

    fn unsupported<T>() -> io::Result<T> {
        Err(io::ErrorKind::Unsupported.into())
    }

    pub(in super::super) fn serial(_tty: &SideDoor) -> io::Result<Serial> {
        unsupported()
    }

    pub(in super::super) fn set_serial(_tty: &SideDoor, _serial: Serial) -> io::Result<()> {
        unsupported()
    }

    pub(in super::super) fn rs485(_tty: &SideDoor) -> io::Result<KernelRs485> {
        unsupported()
    }

    pub(in super::super) fn set_rs485(_tty: &SideDoor, _config: KernelRs485) -> io::Result<KernelRs485> {
        unsupported()
    }

    pub(in super::super) fn counters(_tty: &SideDoor) -> io::Result<Counters> {
        unsupported()
    }

    #[cfg(unix)]
    pub(in super::super) fn exclusive(_tty: &SideDoor) -> io::Result<bool> {
        unsupported()
    }
}

#[cfg(target_os = "linux")]
#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn switching_on_raises_rts_while_sending_unless_it_was_on_otherwise() {
        let set = KernelRs485 { flags: RTS_AFTER_SEND, ..KernelRs485::default() }.enabled(1, 2);
        assert_eq!((set.flags, set.delay_before_send, set.delay_after_send), (ENABLED | RTS_ON_SEND, 1, 2));
        let inverted = KernelRs485 { flags: ENABLED | RTS_AFTER_SEND, ..KernelRs485::default() };
        assert_eq!(inverted.enabled(0, 0), inverted);
    }

    #[test]
    fn a_pseudo_terminal_has_none_of_this() {
        let tty = rustix::pty::openpt(rustix::pty::OpenptFlags::RDWR | rustix::pty::OpenptFlags::NOCTTY).unwrap();
        assert!(serial(&tty).is_err() && rs485(&tty).is_err() && counters(&tty).is_err());
    }
}
