//! The files that a user names: configuration, catalogues, benches, recordings, results. The only place that opens them.
//!
//! What is no regular file is refused before it is opened: a pipe would wait for ever for somebody who writes, a device has
//! no end, and merely opening a serial port moves its control lines. Every file is read with a limit. Nothing is ever
//! overwritten unasked, and never through a link, which may lead anywhere.

use crate::text::{Text, both};
use std::fs::{File, Metadata, OpenOptions};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

/// Longest configuration, catalogue, bench, setpoint file or saved result in bytes; ours have some ten thousand. What reads
/// them may have a lower limit of its own.
pub const TEXT: u64 = 16 << 20;
/// Longest recording in bytes: three hours of a line that is asked without a pause.
pub const RECORDING: u64 = 64 << 20;

/// How a file begins that is packed with gzip (RFC 1952, 2.3.1).
const GZIP: [u8; 2] = [0x1F, 0x8B];

/// How editors of Windows begin a text in UTF-8; it is none of the text.
pub const BYTE_ORDER_MARK: [u8; 3] = [0xEF, 0xBB, 0xBF];

/// So many files that earlier crashes have left are gone past.
const MOST_LEFT_OVER: u32 = 99;

/// Why a file cannot be read or written. Shown by itself it speaks English.
#[derive(Debug, thiserror::Error)]
pub enum FileError {
    /// A directory, pipe, device or socket.
    #[error("{}", self.text().en)]
    NoFile(Text),
    /// Longer than anything that is read.
    #[error("{}", self.text().en)]
    TooLong(u64),
    /// Bytes that are no text: the line and column of the first.
    #[error("{}", self.text().en)]
    NoText(usize, usize),
    /// Packed with gzip.
    #[error("{}", self.text().en)]
    Packed,
    /// Something is there and may not be overwritten.
    #[error("{}", self.text().en)]
    Exists,
    /// A link is never written through.
    #[error("{}", self.text().en)]
    Link,
    /// What the system said.
    #[error(transparent)]
    System(#[from] io::Error),
}

impl FileError {
    /// In words for people.
    pub fn text(&self) -> Text {
        match self {
            FileError::NoFile(found) => {
                both!(
                    "expected a regular file, this is {found}",
                    "erwartet wird eine gewöhnliche Datei, dies ist {found}",
                    found
                )
            }
            FileError::TooLong(limit) => both!(
                "expected at most {limit} MiB, the file is longer",
                "erwartet werden höchstens {limit} MiB, die Datei ist länger",
                limit = limit >> 20
            ),
            FileError::NoText(line, column) => {
                both!("line {line}, column {column}: {why}", "Zeile {line}, Spalte {column}: {why}", why = no_text())
            }
            FileError::Packed => both!(
                "the file is packed with gzip; `gunzip --keep FILE` unpacks it",
                "die Datei ist mit gzip gepackt; `gunzip --keep DATEI` packt sie aus"
            ),
            FileError::Exists => both!("the file exists already", "die Datei gibt es schon"),
            FileError::Link => both!(
                "expected a regular file, this is a symbolic link",
                "erwartet wird eine gewöhnliche Datei, dies ist eine symbolische Verknüpfung"
            ),
            FileError::System(error) => of_system(error),
        }
    }

    /// The same of a file with this path: `FILE: …`, or `FILE:LINE:COLUMN: …` where it has a place.
    pub fn of(&self, path: &Path) -> Text {
        let file = path.display();
        match self {
            FileError::NoText(line, column) => {
                both!("{file}:{line}:{column}: {why}", "{file}:{line}:{column}: {why}", why = no_text())
            }
            _ => match path
                .parent()
                .filter(|folder| self.is_missing() && !folder.as_os_str().is_empty() && !folder.exists())
            {
                Some(folder) => both!(
                    "{file}: there is no directory {folder}",
                    "{file}: es gibt kein Verzeichnis {folder}",
                    folder = folder.display()
                ),
                None => both!("{file}: {why}", "{file}: {why}", why = self.text()),
            },
        }
    }

    /// Whether there is nothing at that path.
    pub fn is_missing(&self) -> bool {
        matches!(self, FileError::System(error) if error.kind() == io::ErrorKind::NotFound)
    }
}

fn no_text() -> Text {
    both!(
        "expected a text in UTF-8; an editor can save the file so",
        "erwartet wird ein Text in UTF-8; ein Editor kann die Datei so speichern"
    )
}

/// How the standard library begins what it says of a name that leads to no address.
const NO_HOST: &str = "failed to lookup address information";

/// What the operating system said, as far as it is one of the usual things; else in its own words.
pub fn of_system(error: &io::Error) -> Text {
    use io::ErrorKind as Kind;
    let german = match error.kind() {
        Kind::NotFound => "Datei oder Verzeichnis nicht gefunden",
        Kind::PermissionDenied => "Zugriff verweigert",
        Kind::AlreadyExists => "die Datei gibt es schon",
        Kind::AddrInUse => "die Adresse wird schon benutzt",
        Kind::AddrNotAvailable => "die Adresse gibt es auf diesem Rechner nicht",
        Kind::ConnectionRefused => "Verbindung abgewiesen",
        Kind::ConnectionReset => "Verbindung von der Gegenseite abgebrochen",
        Kind::ConnectionAborted => "Verbindung abgebrochen",
        Kind::NotConnected => "keine Verbindung",
        Kind::HostUnreachable => "der Rechner ist nicht erreichbar",
        Kind::NetworkUnreachable => "das Netz ist nicht erreichbar",
        Kind::TimedOut => "Zeitüberschreitung",
        Kind::BrokenPipe => "die Gegenseite hat geschlossen",
        Kind::StorageFull => "kein Platz mehr auf dem Datenträger",
        Kind::ReadOnlyFilesystem => "der Datenträger ist schreibgeschützt",
        Kind::IsADirectory => "das ist ein Verzeichnis",
        Kind::NotADirectory => "das ist kein Verzeichnis",
        Kind::UnexpectedEof => "unerwartetes Ende",
        Kind::Interrupted => "unterbrochen",
        Kind::ResourceBusy => "das Gerät ist belegt",
        Kind::FileTooLarge => "die Datei wird zu groß",
        Kind::QuotaExceeded => "das Kontingent auf dem Datenträger ist erschöpft",
        Kind::InvalidInput => "das wird hier nicht angenommen",
        Kind::Unsupported => "das gibt es hier nicht",
        Kind::OutOfMemory => "der Speicher reicht nicht",
        // It has no kind of its own.
        _ if error.to_string().starts_with(NO_HOST) => "diesen Rechnernamen kennt niemand",
        _ => return Text::quoted(error),
    };
    let code = error.raw_os_error().map_or_else(String::new, |code| format!(" (Systemfehler {code})"));
    Text { en: error.to_string().into(), de: format!("{german}{code}").into() }
}

/// The text of a regular file of at most `limit` bytes.
pub fn read(path: &Path, limit: u64) -> Result<String, FileError> {
    let mut bytes = read_bytes(path, limit)?;
    if bytes.starts_with(&BYTE_ORDER_MARK) {
        bytes.drain(..BYTE_ORDER_MARK.len());
    }
    if bytes.starts_with(&GZIP) {
        return Err(FileError::Packed);
    }
    String::from_utf8(bytes).map_err(|error| {
        let text = error.as_bytes().get(..error.utf8_error().valid_up_to()).map(String::from_utf8_lossy);
        let text = text.unwrap_or_default();
        let last = text.rsplit('\n').next().unwrap_or_default();
        FileError::NoText(text.matches('\n').count() + 1, last.chars().count() + 1)
    })
}

/// The bytes of a regular file of at most `limit` of them.
pub fn read_bytes(path: &Path, limit: u64) -> Result<Vec<u8>, FileError> {
    must_be_regular(&std::fs::metadata(path)?)?;
    let file = unhurried(OpenOptions::new().read(true), true).open(path)?;
    // Looked at again: somebody may have put something else in its place.
    must_be_regular(&file.metadata()?)?;
    let mut bytes = Vec::new();
    file.take(limit + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > limit {
        return Err(FileError::TooLong(limit));
    }
    Ok(bytes)
}

/// Writes a whole file, or nothing of it: what stands there is replaced only with `overwrite`, and only by all of the text.
pub fn write_whole(path: &Path, text: &str, overwrite: bool) -> Result<(), FileError> {
    let ready = Ready::write(path, text)?;
    if overwrite {
        return ready.replace();
    }
    place_new(&ready.beside, path, |from, to| std::fs::hard_link(from, to))?;
    Ok(keep_directory(path)?)
}

/// A whole text on the disk, beside the file that it may take the place of; dropped before, it is gone.
#[derive(Debug)]
pub struct Ready {
    beside: PathBuf,
    path: PathBuf,
}

impl Ready {
    /// Writes it.
    pub fn write(path: &Path, text: &str) -> Result<Self, FileError> {
        may_be_written(path)?;
        let (beside, mut file) = beside(path)?;
        let ready = Ready { beside, path: path.to_owned() };
        file.write_all(text.as_bytes()).and_then(|()| file.sync_all())?;
        Ok(ready)
    }

    /// Takes the place of what stands there, which needs no room.
    pub fn replace(self) -> Result<(), FileError> {
        may_be_written(&self.path)?;
        self.keeps_owner_and_mode();
        std::fs::rename(&self.beside, &self.path)?;
        Ok(keep_directory(&self.path)?)
    }
}

#[cfg(unix)]
impl Ready {
    /// Whose file it was, and who may read it, as far as the system lets us.
    fn keeps_owner_and_mode(&self) {
        use std::os::unix::fs::{MetadataExt, chown};
        let Ok(old) = std::fs::metadata(&self.path) else { return };
        let _not_ours = chown(&self.beside, Some(old.uid()), Some(old.gid()));
        let _not_ours = std::fs::set_permissions(&self.beside, old.permissions());
    }
}

#[cfg(not(unix))]
impl Ready {
    fn keeps_owner_and_mode(&self) {}
}

impl Drop for Ready {
    fn drop(&mut self) {
        let _gone = std::fs::remove_file(&self.beside);
    }
}

/// Whether a file can be written at a path: nothing is there, or a regular file and no link.
pub fn may_be_written(path: &Path) -> Result<(), FileError> {
    match std::fs::symlink_metadata(path) {
        Ok(found) if found.file_type().is_symlink() => Err(FileError::Link),
        Ok(found) => must_be_regular(&found),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
        Err(error) => Err(error.into()),
    }
}

/// Whether [`write_whole`] would take a path now: the folder is there and takes a new file, and the name is free or may be replaced.
pub fn check(path: &Path, overwrite: bool) -> Result<(), FileError> {
    may_be_written(path)?;
    if !overwrite && found(path).is_some() {
        return Err(FileError::Exists);
    }
    let (beside, file) = beside(path)?;
    drop(file);
    Ok(std::fs::remove_file(beside)?)
}

/// A new file beside the one that is to be. What an earlier crash has left there is nobody's, and stays.
fn beside(path: &Path) -> io::Result<(PathBuf, File)> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let mut taken = io::Error::from(io::ErrorKind::NotFound);
    for count in 0..MOST_LEFT_OVER {
        let beside = path.with_file_name(format!(".{name}.{}-{count}.new", std::process::id()));
        match OpenOptions::new().write(true).create_new(true).open(&beside) {
            Ok(file) => return Ok((beside, file)),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => taken = error,
            Err(error) => return Err(error),
        }
    }
    Err(taken)
}

/// Gives a file its name, which must be free. A link is made only where nothing is yet; file systems without links (FAT, exFAT)
/// take a name that is reserved first, so that nobody else's file is replaced.
fn place_new(beside: &Path, path: &Path, link: impl FnOnce(&Path, &Path) -> io::Result<()>) -> Result<(), FileError> {
    let taken = |error: &io::Error| error.kind() == io::ErrorKind::AlreadyExists;
    match link(beside, path) {
        Ok(()) => return Ok(()),
        Err(error) if taken(&error) => return Err(FileError::Exists),
        Err(_) => {}
    }
    match OpenOptions::new().write(true).create_new(true).open(path) {
        Ok(_reserved) => {}
        Err(error) if taken(&error) => return Err(FileError::Exists),
        Err(error) => return Err(error.into()),
    }
    std::fs::rename(beside, path).inspect_err(|_| {
        let _gone = std::fs::remove_file(path);
    })?;
    Ok(())
}

/// A new name is on the disk only when its directory is.
#[cfg(unix)]
fn keep_directory(path: &Path) -> io::Result<()> {
    use io::ErrorKind::{InvalidInput, PermissionDenied, Unsupported};
    let directory = path.parent().filter(|directory| !directory.as_os_str().is_empty()).unwrap_or(Path::new("."));
    match File::open(directory).and_then(|directory| directory.sync_all()) {
        // Not every file system can, and not every directory may be read.
        Err(error) if matches!(error.kind(), InvalidInput | PermissionDenied | Unsupported) => Ok(()),
        kept => kept,
    }
}

#[cfg(not(unix))]
fn keep_directory(_path: &Path) -> io::Result<()> {
    Ok(())
}

/// Takes a file of ours away, if it is there.
pub fn remove(path: &Path) -> Result<(), FileError> {
    match std::fs::symlink_metadata(path) {
        Ok(found) => must_be_regular(&found)?,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(()),
        Err(error) => return Err(error.into()),
    }
    Ok(std::fs::remove_file(path)?)
}

/// Where a link leads, if it is one that a user made.
pub fn leads_to(path: &Path) -> Option<PathBuf> {
    let is_ours = ["/dev", "/proc"].iter().all(|folder| !path.starts_with(folder));
    let target = is_ours.then(|| std::fs::read_link(path).ok())??;
    Some(path.parent().unwrap_or(Path::new("")).join(target))
}

/// Whether something stands at a path, and if so whether it is a directory.
pub fn found(path: &Path) -> Option<bool> {
    std::fs::symlink_metadata(path).ok()?;
    Some(path.is_dir())
}

/// A new file to write to. One that exists is only replaced with `overwrite`, and only if it is a regular file and no
/// link.
pub fn create(path: &Path, overwrite: bool) -> Result<File, FileError> {
    let found = match std::fs::symlink_metadata(path) {
        Ok(found) => found,
        // `create_new` follows no link and takes nothing that has come meanwhile.
        Err(error) if error.kind() == io::ErrorKind::NotFound => {
            return Ok(OpenOptions::new().write(true).create_new(true).open(path)?);
        }
        Err(error) => return Err(error.into()),
    };
    if found.file_type().is_symlink() {
        return Err(FileError::Link);
    }
    must_be_regular(&found)?;
    if !overwrite {
        return Err(FileError::Exists);
    }
    let file = unhurried(OpenOptions::new().write(true), false).open(path)?;
    must_be_regular(&file.metadata()?)?;
    file.set_len(0)?;
    Ok(file)
}

fn must_be_regular(found: &Metadata) -> Result<(), FileError> {
    let kind = found.file_type();
    if kind.is_file() { Ok(()) } else { Err(FileError::NoFile(name(kind))) }
}

#[cfg(unix)]
fn name(kind: std::fs::FileType) -> Text {
    use std::os::unix::fs::FileTypeExt;
    match kind {
        kind if kind.is_dir() => both!("a directory", "ein Verzeichnis"),
        kind if kind.is_fifo() => both!("a pipe", "eine Pipe"),
        kind if kind.is_char_device() || kind.is_block_device() => both!("a device", "eine Gerätedatei"),
        kind if kind.is_socket() => both!("a socket", "ein Socket"),
        _ => both!("something else", "etwas anderes"),
    }
}

#[cfg(not(unix))]
fn name(kind: std::fs::FileType) -> Text {
    if kind.is_dir() { both!("a directory", "ein Verzeichnis") } else { both!("something else", "etwas anderes") }
}

/// Opening waits for nobody: what was put in the place of the file that was looked at may be a pipe.
#[cfg(unix)]
fn unhurried(options: &mut OpenOptions, follows: bool) -> &mut OpenOptions {
    use rustix::fs::OFlags;
    use std::os::unix::fs::OpenOptionsExt;
    let link = if follows { OFlags::empty() } else { OFlags::NOFOLLOW };
    options.custom_flags((OFlags::NONBLOCK | OFlags::NOCTTY | link).bits().cast_signed())
}

#[cfg(not(unix))]
fn unhurried(options: &mut OpenOptions, _follows: bool) -> &mut OpenOptions {
    options
}

#[cfg(target_os = "linux")]
#[cfg(test)]
mod tests;
