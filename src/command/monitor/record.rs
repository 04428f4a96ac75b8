//! The file that `monitor --record` writes: whole lines, and nothing in the place of another file.

use crate::files::{self, FileError};
use std::fs::File;
use std::io::{self, Seek, SeekFrom, Write};
use std::path::Path;

/// A new file that takes whole lines only.
///
/// # Errors
/// It exists and may not be replaced, or the system says no.
pub fn recording(path: &Path, force: bool) -> io::Result<impl Write + 'static> {
    let named = |error: FileError| io::Error::other(format!("{}: {error}", path.display()));
    Ok(Lines { file: files::create(path, force).map_err(named)?, whole: 0 })
}

/// What is written at once is in the file, or nothing of it.
struct Lines {
    file: File,
    /// Bytes of whole lines.
    whole: u64,
}

impl Write for Lines {
    fn write(&mut self, line: &[u8]) -> io::Result<usize> {
        if let Err(error) = self.file.write_all(line) {
            // A disk that is full has perhaps taken some of it.
            self.file.set_len(self.whole)?;
            self.file.seek(SeekFrom::Start(self.whole))?;
            return Err(error);
        }
        self.whole += line.len() as u64;
        Ok(line.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Drop for Lines {
    fn drop(&mut self) {
        // Where that cannot be, nobody is left to hear of it.
        let _kept = self.file.sync_all();
    }
}
