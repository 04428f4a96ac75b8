//! The file that `monitor --record` writes: whole lines, and nothing in the place of another file.

use crate::command::output::of_file;
use crate::files;
use crate::outcome::{Data, Outcome, Warning};
use crate::text::both;
use std::fs::File;
use std::io::{self, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// A new file that takes whole lines only.
///
/// # Errors
/// It exists and may not be replaced, or the system says no.
pub fn recording(path: &Path, force: bool) -> io::Result<impl Write + 'static> {
    let file = files::create(path, force).map_err(|error| of_file(path, error))?;
    Ok(Lines { file, path: path.to_owned(), whole: 0 })
}

/// What came of a watch; `waited` is its file, if that was to hold what lies around a trigger only.
pub(super) fn told(mut outcome: Outcome, waited: Option<&Path>) -> Outcome {
    let is_empty = matches!(&outcome.data, Some(Data::Monitor(done)) if done.triggers == 0);
    outcome.warnings.extend(waited.filter(|_| is_empty).map(|path| Warning {
        code: "monitor.no_trigger".to_owned(),
        message: both!(
            "no trigger came true, so {path} holds no sample",
            "kein Auslöser ist eingetreten, {path} enthält deshalb keinen Messpunkt",
            path = path.display()
        ),
    }));
    outcome
}

/// What is written at once is in the file, or nothing of it.
struct Lines {
    file: File,
    path: PathBuf,
    /// Bytes of whole lines.
    whole: u64,
}

impl Write for Lines {
    fn write(&mut self, line: &[u8]) -> io::Result<usize> {
        if let Err(error) = self.file.write_all(line) {
            // A disk that is full has perhaps taken some of it.
            let back = self.file.set_len(self.whole).and_then(|()| self.file.seek(SeekFrom::Start(self.whole)));
            return Err(of_file(&self.path, back.err().unwrap_or(error)));
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::command::file_failure;
    use crate::failure::Class;

    #[test]
    fn a_file_that_takes_no_more_is_named_and_is_no_port() {
        let directory = tempfile::tempdir().unwrap();
        let path = directory.path().join("x.ndjson");
        std::fs::write(&path, "").unwrap();
        // It can be read only, so that it takes as little as a disk that is full.
        let mut lines = Lines { file: File::open(&path).unwrap(), path: path.clone(), whole: 0 };
        let failure = file_failure(&lines.write(b"{}\n").unwrap_err()).unwrap();
        assert_eq!((failure.class, failure.code.as_str()), (Class::Data, "data.output"));
        assert!(failure.message.en.starts_with(&path.display().to_string()), "{failure:?}");
        assert!(file_failure(&io::Error::from(io::ErrorKind::StorageFull)).is_none());
    }
}
