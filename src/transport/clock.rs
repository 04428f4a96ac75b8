//! The real clock of a line, and waiting that is exact to a fraction of a character.
//!
//! tokio's timers are 1-2 ms late, so the end of a wait is slept by the thread and the very last of it is spun
//! (docs/measured.md, measured).

use super::Wake;
use crate::tick::{Span, Tick};
use std::io;
use std::time::{Duration, Instant, SystemTime};
use tokio::io::{AsyncRead, AsyncReadExt};

/// Tells the time since a port was first opened.
#[derive(Clone, Copy, Debug)]
pub(super) struct Clock {
    opened: Instant,
}

/// tokio's timers are 1-2 ms late (docs/measured.md): what is nearer is slept by the thread.
pub(super) const THREAD_SLEEPS_FROM: Span = Span::from_millis(3);
const SPIN_FROM: Duration = Duration::from_micros(150);
/// Longest piece that is read at once.
const CHUNK: usize = 512;

#[expect(clippy::disallowed_methods, reason = "this is the room's clock")]
impl Clock {
    pub(super) fn start() -> Self {
        Clock { opened: Instant::now() }
    }

    pub(super) fn now(self) -> Tick {
        Tick::ZERO + Span::from(self.opened.elapsed())
    }

    /// Waits exactly until a moment, without giving way to anybody.
    pub(super) fn sleep_until(self, until: Tick) {
        loop {
            let rest = Duration::from(until.since(self.now()));
            match rest.checked_sub(SPIN_FROM) {
                _ if rest.is_zero() => return,
                Some(sleep) if !sleep.is_zero() => std::thread::sleep(sleep),
                _ => std::hint::spin_loop(),
            }
        }
    }

    /// Waits exactly until a moment; others go on until shortly before it.
    pub(super) async fn rest_until(self, until: Tick) {
        let coarse = self.coarse(until);
        if !coarse.is_zero() {
            tokio::time::sleep(coarse).await;
        }
        self.sleep_until(until);
    }

    /// Waits until bytes come or the time is over; an end of the stream is an error, whatever it is called.
    pub(super) async fn listen(self, stream: &mut (impl AsyncRead + Unpin), until: Tick) -> io::Result<Wake> {
        let mut buffer = [0; CHUNK];
        let coarse = self.coarse(until);
        if !coarse.is_zero()
            && let Ok(read) = tokio::time::timeout(coarse, stream.read(&mut buffer)).await
        {
            return took(read?, &buffer);
        }
        self.sleep_until(until);
        // A time-out of zero would cost a millisecond; one turn of the reactor and one look do not.
        tokio::task::yield_now().await;
        tokio::select! {
            biased;
            read = stream.read(&mut buffer) => took(read?, &buffer),
            () = std::future::ready(()) => Ok(Wake::Silence),
        }
    }

    /// What of the time until a moment tokio may sleep.
    fn coarse(self, until: Tick) -> Duration {
        Duration::from(until.since(self.now()) - THREAD_SLEEPS_FROM)
    }
}

/// The time of day, since the beginning of 1970.
#[expect(clippy::disallowed_methods, reason = "this is the room's clock")]
pub(super) fn since_1970() -> Span {
    Span::from(SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default())
}

/// A time of day in UTC: `2026-11-22T14:03:07Z`.
pub(super) fn utc(since_1970: Span) -> String {
    date(since_1970.as_millis() / 1_000)
}

/// The date and time of so many seconds since the beginning of 1970 (RFC 3339), by the Gregorian calendar.
fn date(seconds: u64) -> String {
    let (days, second) = (seconds / 86_400, seconds % 86_400);
    // Years begin in March, so that the leap day is the last one; eras have 400 of them.
    let day = days + 719_468;
    let (era, day) = (day / 146_097, day % 146_097);
    let year = (day - day / 1_460 + day / 36_524 - day / 146_096) / 365;
    let day = day - (365 * year + year / 4 - year / 100);
    let month = (5 * day + 2) / 153;
    let (day, month) = (day - (153 * month + 2) / 5 + 1, if month < 10 { month + 3 } else { month - 9 });
    let year = era * 400 + year + u64::from(month <= 2);
    let (hour, minute, second) = (second / 3_600, second / 60 % 60, second % 60);
    format!("{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}Z")
}

/// A tty that was hung up reads as end of file for ever, and so does a connection that the other end has closed.
fn took(count: usize, buffer: &[u8]) -> io::Result<Wake> {
    match buffer.get(..count) {
        Some(bytes @ [_, ..]) => Ok(Wake::Bytes(bytes.to_vec())),
        _ => Err(io::ErrorKind::UnexpectedEof.into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seconds_are_a_date() {
        for (seconds, told) in [
            (0, "1970-01-01T00:00:00Z"),
            (951_782_399, "2000-02-28T23:59:59Z"),
            (951_782_400, "2000-02-29T00:00:00Z"),
            (951_868_800, "2000-03-01T00:00:00Z"),
            (1_795_356_187, "2026-11-22T14:03:07Z"),
            (4_107_542_400, "2100-03-01T00:00:00Z"),
        ] {
            assert_eq!(date(seconds), told);
        }
    }
}
