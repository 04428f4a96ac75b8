//! A second way into a serial port, for what tokio-serial does not offer: stripping the eighth bit, and reading back
//! what the driver accepted.

#[cfg(unix)]
#[cfg(test)]
pub(super) use unix::is_exclusive;
#[cfg(unix)]
pub(super) use unix::{claim, exclude, finish, open};

#[cfg(not(unix))]
pub(super) use elsewhere::{claim, exclude, finish, open};

#[cfg(unix)]
mod unix {
    use super::super::door::SideDoor;
    use super::super::ioctl;
    use crate::protocol::line::{LineSetting, Parity};
    use crate::text::{Text, both};
    use rustix::fs::{FlockOperation, Mode, OFlags, flock};
    use rustix::termios::{ControlModes, InputModes, OptionalActions, tcgetattr, tcsetattr};

    pub(in super::super) fn open(name: &str) -> rustix::io::Result<SideDoor> {
        rustix::fs::open(name, OFlags::RDWR | OFlags::NOCTTY | OFlags::NONBLOCK | OFlags::CLOEXEC, Mode::empty())
    }

    /// Takes the port for us, if nobody else has it; `false` if somebody has. The kernel lets root in whatever is locked,
    /// so both are asked: the lock that programs agree on (flock), and the one of the kernel (TIOCEXCL). The lock is kept
    /// as a shared one, beside which serialport's own shared one fits.
    pub(in super::super) fn claim(tty: &SideDoor, name: &str) -> bool {
        let locked = |how| flock(tty, how) != Err(rustix::io::Errno::WOULDBLOCK);
        // A pty stays exclusive behind a program that was killed, as long as its master lives.
        let exclusive = !is_pty(name) && is_exclusive(tty);
        locked(FlockOperation::NonBlockingLockExclusive) && !exclusive && locked(FlockOperation::NonBlockingLockShared)
    }

    /// From now on the kernel lets nobody else in.
    pub(in super::super) fn exclude(tty: &SideDoor) {
        let _best_effort = rustix::termios::ioctl_tiocexcl(tty);
    }

    pub(in super::super) fn is_exclusive(tty: &SideDoor) -> bool {
        ioctl::exclusive(tty).unwrap_or(false)
    }

    fn is_pty(name: &str) -> bool {
        std::fs::canonicalize(name).is_ok_and(|path| path.starts_with("/dev/pts"))
    }

    /// Sets ISTRIP for 7-bit characters and says what the driver set in place of what was asked.
    pub(in super::super) fn finish(tty: &SideDoor, name: &str, line: LineSetting) -> Vec<Text> {
        let Ok(mut termios) = tcgetattr(tty) else { return Vec::new() };
        termios.input_modes.set(InputModes::ISTRIP, line.data_bits == 7);
        let _best_effort = tcsetattr(tty, OptionalActions::Now, &termios);
        let Ok(set) = tcgetattr(tty) else { return Vec::new() };
        let mut deviations = Vec::new();
        if set.input_speed() != line.baud {
            let (asked, set) = (line.baud, set.input_speed());
            deviations.push(both!(
                "asked for {asked} baud, the driver set {set}",
                "verlangt sind {asked} Baud, der Treiber stellte {set} ein"
            ));
        }
        if is_pty(name) {
            return deviations; // the kernel masks parity and width on a pty
        }
        let modes = set.control_modes;
        let parity = match (modes.contains(ControlModes::PARENB), modes.contains(ControlModes::PARODD)) {
            (false, _) => Parity::None,
            (true, false) => Parity::Even,
            (true, true) => Parity::Odd,
        };
        if parity != line.parity {
            let (asked, set) = (line.parity.name(), parity.name());
            deviations.push(both!(
                "asked for parity {asked}, the driver set {set}",
                "verlangt ist Parität {asked}, der Treiber stellte {set} ein"
            ));
        }
        let data_bits = if modes & ControlModes::CSIZE == ControlModes::CS7 { 7 } else { 8 };
        if data_bits != line.data_bits {
            let asked = line.data_bits;
            deviations.push(both!(
                "asked for {asked} data bits, the driver set {data_bits}",
                "verlangt sind {asked} Datenbits, der Treiber stellte {data_bits} ein"
            ));
        }
        deviations
    }
}

#[cfg(not(unix))]
mod elsewhere {
    use super::super::door::SideDoor;
    use crate::protocol::line::LineSetting;
    use crate::text::Text;

    pub(in super::super) fn open(_name: &str) -> std::io::Result<SideDoor> {
        Err(std::io::ErrorKind::Unsupported.into())
    }

    pub(in super::super) fn claim(_tty: &SideDoor, _name: &str) -> bool {
        true
    }

    pub(in super::super) fn exclude(_tty: &SideDoor) {}

    pub(in super::super) fn finish(_tty: &SideDoor, _name: &str, _line: LineSetting) -> Vec<Text> {
        Vec::new()
    }
}
