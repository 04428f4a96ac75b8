//! A recording that is played back in virtual time: whoever sends what was sent then hears what came then.

use super::trace::{TraceLine, read_trace, recorded_line};
use super::{LinkError, Wake};
use crate::files;
use crate::protocol::line::LineSetting;
use crate::text::{Text, both};
use crate::tick::{Span, Tick};
use std::collections::VecDeque;
use std::path::{Path, PathBuf};

/// Between the moment at which bytes were recorded and the one at which the conversation took them, which the next wait
/// was reckoned from, some time had gone by: so much at most. Behind a telegram of ours there is no such doubt.
const SLACK: Span = Span::from_micros(200);

#[derive(Debug)]
pub(super) struct TapeLink {
    file: PathBuf,
    now: Tick,
    /// How much later than a wait ends bytes are still taken.
    slack: Span,
    /// What comes next, and when.
    coming: VecDeque<(Tick, Vec<u8>)>,
    /// What was recorded from the next telegram of ours on.
    rest: VecDeque<TraceLine>,
    deviations: Vec<Text>,
}

impl TapeLink {
    pub(super) fn open(file: &Path, line: LineSetting) -> Result<Self, LinkError> {
        let bad = |message| LinkError::Recording { file: file.to_owned(), message };
        let text = files::read(file, files::RECORDING).map_err(|error| bad(error.text()))?;
        let rest = read_trace(&text).map_err(bad)?.into();
        let (coming, deviations) = (VecDeque::new(), Vec::new());
        let mut link = TapeLink { file: file.to_owned(), now: Tick::ZERO, slack: Span::ZERO, coming, rest, deviations };
        if let Some(recorded) = recorded_line(&text).filter(|recorded| *recorded != line.to_string()) {
            link.deviations.push(both!(
                "recorded at {recorded}, played back at {line}",
                "aufgezeichnet mit {recorded}, abgespielt mit {line}"
            ));
        }
        link.play(0);
        Ok(link)
    }

    pub(super) fn now(&self) -> Tick {
        self.now
    }

    pub(super) fn deviations(&self) -> &[Text] {
        &self.deviations
    }

    /// Compares with what was sent next. Behind the end of the recording nobody answers.
    pub(super) fn send(&mut self, bytes: &[u8]) -> Result<(), LinkError> {
        let Some(recorded) = self.rest.pop_front() else { return Ok(()) };
        if recorded.bytes != bytes {
            let TraceLine { number, bytes: expected, .. } = recorded;
            return Err(LinkError::OffTape { file: self.file.clone(), line: number, expected, sent: bytes.to_vec() });
        }
        self.slack = Span::ZERO;
        self.play(recorded.at_us);
        Ok(())
    }

    pub(super) fn wait(&mut self, until: Tick) -> Wake {
        if self.coming.front().is_some_and(|(due, _)| *due <= until + self.slack)
            && let Some((due, bytes)) = self.coming.pop_front()
        {
            (self.now, self.slack) = (self.now.max(due), SLACK);
            return Wake::Bytes(bytes);
        }
        self.now = self.now.max(until);
        Wake::Silence
    }

    /// Lets what was received before our next telegram come as long after now as it came after `recorded_us`.
    fn play(&mut self, recorded_us: u64) {
        let received = self.rest.iter().take_while(|line| !line.sent).count();
        for line in self.rest.drain(..received) {
            let after = Span::from_micros(line.at_us.saturating_sub(recorded_us));
            self.coming.push_back((self.now + after, line.bytes));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::line::Parity;
    use std::io::Write;

    const LINE: LineSetting = LineSetting::rtu(19_200, Parity::Even);

    fn tape(text: &str) -> Result<TapeLink, LinkError> {
        let mut file = tempfile::NamedTempFile::new().unwrap();
        file.write_all(text.as_bytes()).unwrap();
        TapeLink::open(file.path(), LINE)
    }

    fn at(us: u64) -> Tick {
        Tick::from_micros(us)
    }

    #[test]
    fn what_came_then_comes_as_long_after_what_is_sent() {
        let mut link = tape("# antrieb trace 1, 19200 8E1, rtu\n100 > 01 02\n150 < 03\n170 < 04\n200 > 05\n").unwrap();
        assert_eq!(link.wait(at(1_000)), Wake::Silence);
        link.send(&[1, 2]).unwrap();
        assert_eq!(link.wait(at(1_040)), Wake::Silence);
        assert_eq!((link.wait(at(2_000)), link.now()), (Wake::Bytes(vec![3]), at(1_050)));
        // Sent earlier than then: what was still on its way comes nevertheless.
        link.send(&[5]).unwrap();
        assert_eq!((link.wait(at(2_000)), link.now()), (Wake::Bytes(vec![4]), at(1_070)));
        assert_eq!((link.wait(at(2_000)), link.now()), (Wake::Silence, at(2_000)));
        link.send(b"behind the end").unwrap();
        assert_eq!((link.wait(at(3_000)), link.now()), (Wake::Silence, at(3_000)));
    }

    #[test]
    fn another_telegram_than_the_recorded_one_is_told_with_its_line() {
        let mut link = tape("# antrieb trace 1, 19200 8E1, rtu\n\n100 > 01 02\n").unwrap();
        let error = link.send(&[1, 3]).unwrap_err().to_string();
        assert!(error.ends_with("line 3: recorded was 01 02, sent was 01 03"), "{error}");
    }

    #[test]
    fn a_file_that_is_no_recording_is_told_with_its_line() {
        let error = tape("# antrieb trace 1\nhello\n").unwrap_err().to_string();
        assert!(error.contains("line 2: expected"), "{error}");
        assert!(TapeLink::open(Path::new("/nowhere"), LINE).is_err());
    }

    #[test]
    fn another_line_setting_than_the_recorded_one_is_told() {
        assert!(tape("# antrieb trace 1, 19200 8E1, rtu\n").unwrap().deviations().is_empty());
        let other = tape("# antrieb trace 1, 9600 8N2, rtu\n").unwrap();
        let told: Vec<_> = other.deviations().iter().map(|text| text.en.clone()).collect();
        assert_eq!(told, ["recorded at 9600 8N2, played back at 19200 8E1"]);
    }
}
