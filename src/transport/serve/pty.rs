//! A pseudo terminal, seen from its master side. No slave side is kept open, so that the master sees clients come
//! and go.

use super::{CHUNK, Change, ServeError};
use crate::protocol::line::{LineSetting, Parity};
use crate::text::{Text, both};
use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::fs::{Mode, OFlags};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{ControlModes, InputModes, OptionalActions, tcgetattr, tcsetattr};
use std::io;
use std::os::fd::{AsFd, OwnedFd};
use std::path::{Path, PathBuf};
use std::time::Duration;
use tokio::io::Interest;
use tokio::io::unix::AsyncFd;

/// How often it is looked whether a client has come.
const LOOK: Duration = Duration::from_millis(5);
/// Speed between two clients. Tools that set everything at once fail on a pseudo terminal that already has their
/// speed (docs/measured.md).
const IDLE_BAUD: u32 = 38_400;

#[derive(Debug)]
pub(super) struct Pty {
    master: OwnedFd,
    slave: String,
    link: Option<PathBuf>,
    /// The master side as the runtime knows it, while a client is there. A new one for every client, because the
    /// runtime never forgets that a side was closed.
    client: Option<AsyncFd<OwnedFd>>,
}

impl Pty {
    pub(super) fn open(link: Option<PathBuf>) -> Result<Self, ServeError> {
        let (master, slave) = pair().map_err(|error| ServeError::Pty(error.into()))?;
        let mut pty = Pty { master, slave, link: None, client: None };
        if let Some(link) = link {
            make_link(&pty.slave, &link)?;
            pty.link = Some(link);
        }
        Ok(pty)
    }

    pub(super) fn name(&self) -> String {
        self.link.as_ref().map_or_else(|| self.slave.clone(), |link| link.display().to_string())
    }

    #[expect(clippy::disallowed_methods, reason = "nothing tells that a client opens the other side")]
    pub(super) async fn change(&mut self) -> io::Result<Change> {
        let Some(client) = &self.client else {
            while !is_open(&self.master)? {
                tokio::time::sleep(LOOK).await;
            }
            self.client = Some(self.register()?);
            return Ok(Change::Connected);
        };
        let mut buffer = vec![0; CHUNK];
        let mut guard = client.readable().await?;
        let read = guard.try_io(|fd| rustix::io::read(fd, &mut buffer[..]).map_err(io::Error::from));
        match read {
            Ok(Ok(count @ 1..)) => {
                buffer.truncate(count);
                Ok(Change::Bytes(buffer))
            }
            // EIO: nobody has the slave side open.
            Ok(Ok(0) | Err(_)) => {
                self.client = None;
                set_idle(&self.master)?;
                Ok(Change::Left)
            }
            Err(_) => {
                if guard.ready().is_read_closed() {
                    // Closed and opened again before anybody looked.
                    drop(guard);
                    self.client = Some(self.register()?);
                }
                Ok(Change::Bytes(Vec::new()))
            }
        }
    }

    fn register(&self) -> io::Result<AsyncFd<OwnedFd>> {
        #[expect(
            deprecated,
            reason = "its successor is unsafe, for types that may close or swap their descriptor; an OwnedFd does not"
        )]
        AsyncFd::with_interest(self.master.try_clone()?, Interest::READABLE)
    }

    pub(super) fn write(&self, bytes: &[u8]) {
        if self.client.is_some() {
            // Full or closed: the bytes are lost, as on a wire that nobody listens to.
            let _ = rustix::io::write(&self.master, bytes);
        }
    }

    /// What the client has set.
    pub(super) fn line(&self) -> LineSetting {
        let Ok(set) = tcgetattr(&self.master) else {
            return LineSetting { baud: 0, data_bits: 8, parity: Parity::None, stop_bits: 1 };
        };
        let input = |mode| set.input_modes.contains(mode);
        let control = |mode| set.control_modes.contains(mode);
        let parity = match (input(InputModes::INPCK), control(ControlModes::PARODD)) {
            (false, _) => Parity::None,
            (true, false) => Parity::Even,
            (true, true) => Parity::Odd,
        };
        LineSetting {
            baud: set.output_speed(),
            data_bits: if input(InputModes::ISTRIP) { 7 } else { 8 },
            parity,
            stop_bits: if control(ControlModes::CSTOPB) { 2 } else { 1 },
        }
    }
}

impl Drop for Pty {
    fn drop(&mut self) {
        let Some(link) = &self.link else { return };
        // Only what is still ours.
        if std::fs::read_link(link).is_ok_and(|target| target == Path::new(&self.slave)) {
            let _ = std::fs::remove_file(link);
        }
    }
}

/// A master side that does not block, and the name of its slave side.
fn pair() -> rustix::io::Result<(OwnedFd, String)> {
    let master = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY)?;
    grantpt(&master)?;
    unlockpt(&master)?;
    rustix::io::fcntl_setfd(&master, rustix::io::FdFlags::CLOEXEC)?;
    let slave = ptsname(&master, Vec::new())?.to_string_lossy().into_owned();
    // Opened and closed once: only from then on the master sees that nobody is there.
    let side = rustix::fs::open(slave.as_str(), OFlags::RDWR | OFlags::NOCTTY | OFlags::CLOEXEC, Mode::empty())?;
    set_idle(&side)?;
    drop(side);
    let flags = rustix::fs::fcntl_getfl(&master)?;
    rustix::fs::fcntl_setfl(&master, flags | OFlags::NONBLOCK)?;
    Ok((master, slave))
}

/// Raw, at the speed between two clients, without parity.
fn set_idle(side: &impl AsFd) -> rustix::io::Result<()> {
    let mut set = tcgetattr(side)?;
    set.make_raw();
    set.input_modes.remove(InputModes::INPCK | InputModes::ISTRIP);
    set.control_modes.remove(ControlModes::CSTOPB | ControlModes::PARODD);
    set.set_speed(IDLE_BAUD)?;
    tcsetattr(side, OptionalActions::Now, &set)
}

/// Whether a client has the slave side open.
fn is_open(master: &OwnedFd) -> rustix::io::Result<bool> {
    let mut polled = [PollFd::new(master, PollFlags::IN)];
    poll(&mut polled, Some(&Timespec { tv_sec: 0, tv_nsec: 0 }))?;
    let [polled] = polled;
    Ok(!polled.revents().contains(PollFlags::HUP))
}

fn make_link(slave: &str, link: &Path) -> Result<(), ServeError> {
    let failed = |why: Text| ServeError::Link { path: link.to_owned(), why };
    // The number of a terminal is given again: a link that leads to ours, or to a terminal that is gone, was left over.
    let target = std::fs::read_link(link).ok().map(|target| link.with_file_name(target));
    let is_left_over = |target: &PathBuf| target.parent() == Path::new(slave).parent() && !target.exists();
    if let Some(target) = target.filter(|target| target != Path::new(slave) && !is_left_over(target)) {
        let shown = target.display();
        return Err(failed(match target.exists() {
            true => both!(
                "it leads to {shown}, which is in use; another name, or remove it if nobody serves it any more",
                "er führt zu {shown}, und das ist in Gebrauch; einen anderen Namen nehmen, oder ihn löschen, wenn ihn niemand \
                 mehr bedient"
            ),
            false => both!(
                "it leads to {shown}, which is not there now; another name, or remove it if nobody needs it",
                "er führt zu {shown}, und das gibt es gerade nicht; einen anderen Namen nehmen, oder ihn löschen, wenn ihn \
                 niemand braucht"
            ),
        }));
    }
    match std::fs::symlink_metadata(link) {
        Ok(found) if !found.file_type().is_symlink() => {
            return Err(failed(both!(
                "a file that is no symbolic link is in its place",
                "an seiner Stelle steht eine Datei, die kein symbolischer Link ist"
            )));
        }
        Ok(_) => std::fs::remove_file(link).map_err(|error| failed(Text::name(error)))?,
        Err(error) if error.kind() == io::ErrorKind::NotFound => {}
        Err(error) => return Err(failed(Text::name(error))),
    }
    std::os::unix::fs::symlink(slave, link).map_err(|error| failed(Text::name(error)))
}
