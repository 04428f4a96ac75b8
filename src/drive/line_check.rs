//! How good is the line? The adapter, the pauses that we keep, the reply times, and what to do about them.

use super::access::AccessError;
use super::diag::link_test;
use super::session::Session;
use super::target::Target;
use crate::failure::{Class, Failure};
use crate::outcome::{Adapter, AdapterErrors, Advice, CheckedDrive, ErrorDoc, LineCheck, LinkTest, Pauses};
use crate::text::{Text, both};
use crate::transport::{AdapterInfo, ErrorCounts, LowLatency};

/// More than this an adapter should not hold bytes back: FTDI's default of 16 ms nearly halves the speed of the line
/// (docs/measured.md).
const LATENCY_MS: u32 = 2;

/// Asks every drive the same harmless question `count` times and looks at what that tells of the line. Ends early if
/// the port is lost or somebody interrupts.
///
/// `missing` are drives that were to be asked, but are not even known; they are part of the result.
pub async fn check_line(
    session: &mut Session<'_>,
    targets: Vec<Target>,
    missing: &[(u8, Failure)],
    count: u64,
) -> (LineCheck, Vec<Failure>) {
    let before = session.adapter();
    session.asks_on();
    let mut drives = Vec::new();
    let mut failures = Vec::new();
    for mut target in targets {
        let (test, error) = match link_test(session, &mut target, count).await {
            Ok((test, error)) => (Some(test), error),
            Err(error) => (None, Some(error)),
        };
        let failure = error.as_ref().map(|error| error.failure(target.address, Some(&target.family)));
        let failure = failure.or_else(|| test.as_ref().and_then(|test| mute(target.address, test)));
        drives.push(CheckedDrive { address: target.address, test, error: failure.as_ref().map(ErrorDoc::from) });
        failures.extend(failure);
        if error.as_ref().is_some_and(AccessError::is_fatal) {
            break;
        }
    }
    let absent = |row: &(u8, Failure)| CheckedDrive { address: row.0, test: None, error: Some(ErrorDoc::from(&row.1)) };
    drives.extend(missing.iter().map(absent));
    failures.extend(missing.iter().map(|row| row.1.clone()));
    let after = session.adapter();
    let pauses = session.pauses();
    let mut check = LineCheck {
        port: session.port().to_owned(),
        line: session.line().to_string(),
        protocol: session.protocol().name(),
        adapter: adapter(before, &after),
        echo: session.echoes(),
        pauses: Pauses {
            required_us: pauses.required.as_micros(),
            measured: pauses.count,
            shortest_us: (pauses.count > 0).then_some(pauses.shortest.as_micros()),
            longest_us: (pauses.count > 0).then_some(pauses.longest.as_micros()),
        },
        drives,
        advice: Vec::new(),
    };
    check.advice = advice(&check);
    (check, failures)
}

/// The failure of a drive of which not one reply was understood.
fn mute(address: u8, test: &LinkTest) -> Option<Failure> {
    if test.replies > 0 {
        return None;
    }
    let (asked, garbled) = (test.asked, test.garbled);
    let message = both!(
        "address {address}: no valid reply to {asked} questions, {garbled} of them answered by garbage",
        "Adresse {address}: keine gültige Antwort auf {asked} Fragen, {garbled}-mal kam Unlesbares"
    );
    let (class, code) = match garbled {
        0 => (Class::Silence, "silence.no_reply"),
        _ => (Class::Garbled, "garbled.no_valid_reply"),
    };
    Some(Failure::new(class, code, message).with("address", address))
}

fn adapter(before: AdapterInfo, after: &AdapterInfo) -> Adapter {
    let grown = |old: ErrorCounts, new: ErrorCounts| AdapterErrors {
        frame: new.frame.wrapping_sub(old.frame),
        overrun: new.overrun.wrapping_sub(old.overrun),
        parity: new.parity.wrapping_sub(old.parity),
        brk: new.brk.wrapping_sub(old.brk),
    };
    Adapter {
        name: before.name,
        driver: before.driver,
        about: before.about,
        latency_timer_ms: after.latency_timer_ms,
        low_latency: match after.low_latency {
            LowLatency::Granted => "granted",
            LowLatency::Refused => "refused",
            LowLatency::Unsupported => "unsupported",
        },
        rs485: after.rs485.mode.name(),
        errors: before.error_counts.zip(after.error_counts).map(|(old, new)| grown(old, new)),
    }
}

/// A sign of something, and what to do about it.
struct Sign {
    code: &'static str,
    shows: fn(&LineCheck) -> bool,
    advice: fn() -> Text,
}

/// What a check can show, in the order in which it is told.
const SIGNS: &[Sign] = &[
    Sign {
        code: "latency_timer",
        shows: |check| check.adapter.latency_timer_ms.is_some_and(|ms| ms > LATENCY_MS),
        advice: || {
            both!(
                "the adapter holds bytes back: set its latency timer to 1 ms (Linux, FTDI: echo 1 | sudo tee \
             /sys/bus/usb-serial/devices/ttyUSB0/latency_timer; Windows: port settings, advanced, or the registry value LatencyTimer \
             of the port below HKLM\\SYSTEM\\CurrentControlSet\\Enum\\FTDIBUS)",
                "der Adapter hält Bytes zurück: seine Latenzzeit auf 1 ms stellen (Linux, FTDI: echo 1 | sudo tee \
             /sys/bus/usb-serial/devices/ttyUSB0/latency_timer; Windows: Anschlusseinstellungen, Erweitert, oder der Registrierungswert \
             LatencyTimer des Anschlusses unter HKLM\\SYSTEM\\CurrentControlSet\\Enum\\FTDIBUS)"
            )
        },
    },
    Sign {
        code: "echo",
        shows: |check| check.echo == Some(true),
        advice: || {
            both!(
                "the adapter hears itself; the echo is taken away, but switch it off at the adapter if it can do that",
                "der Adapter hört sich selbst; das Echo wird entfernt, besser ist, es am Adapter abzuschalten"
            )
        },
    },
    Sign {
        code: "frame_errors",
        shows: |check| errors(check, |errors| errors.frame),
        advice: || {
            both!(
                "characters without a stop bit: another baud rate or format on the line, or no bias resistors",
                "Zeichen ohne Stoppbit: andere Baudrate oder anderes Format auf der Leitung, oder fehlende \
                 Ruhepegelwiderstände"
            )
        },
    },
    Sign {
        code: "parity_errors",
        shows: |check| errors(check, |errors| errors.parity),
        advice: || {
            both!(
                "characters with wrong parity: check the parity setting, shielding and termination",
                "Zeichen mit falscher Parität: Paritätseinstellung, Schirmung und Abschluss prüfen"
            )
        },
    },
    Sign {
        code: "overruns",
        shows: |check| errors(check, |errors| errors.overrun),
        advice: || {
            both!(
                "the computer fetched characters too late: another adapter or less load",
                "der Rechner holte Zeichen zu spät ab: anderer Adapter oder weniger Last"
            )
        },
    },
    Sign {
        code: "garbled",
        shows: |check| tests(check).any(|test| test.garbled > 0),
        advice: || {
            both!(
                "disturbed replies: 120 ohm at both ends, bias at one place, shield on one side, A and B twisted; two drives \
             with one address look like this too",
                "gestörte Antworten: 120 Ohm an beiden Enden, Ruhepegel an einer Stelle, Schirm einseitig, A und B verdrillt; \
             zwei Antriebe mit einer Adresse sehen auch so aus"
            )
        },
    },
    Sign {
        code: "no_reply",
        shows: |check| check.drives.iter().any(is_absent),
        advice: || {
            both!(
                "a drive does not answer at all: check its supply, address, baud rate, parity and protocol (P.395 leaves the \
             factory as VABus), A and B swapped, the cable up to it; `antrieb scan` asks every address",
                "ein Antrieb antwortet gar nicht: Versorgung, Adresse, Baudrate, Parität und Protokoll prüfen (P.395 ist ab \
             Werk VABus), vertauschte Adern A und B, das Kabel bis zu ihm; `antrieb scan` fragt alle Adressen"
            )
        },
    },
    Sign {
        code: "lost_replies",
        shows: |check| tests(check).any(|test| test.silent > 0 && test.replies > 0),
        advice: || {
            both!(
                "some replies did not come: a loose contact, a second master, or a drive under load (over 500 ms)",
                "manche Antworten kamen nicht: Wackelkontakt, ein zweiter Master oder ein Antrieb unter Last (über \
                 500 ms)"
            )
        },
    },
    Sign {
        code: "strays",
        shows: |check| tests(check).any(|test| test.strays > 0),
        advice: || {
            both!(
                "telegrams that nobody asked for: a second master on the bus, or replies later than the time-out",
                "Telegramme, nach denen niemand fragte: ein zweiter Master am Bus, oder Antworten nach der Wartezeit"
            )
        },
    },
];

fn tests(check: &LineCheck) -> impl Iterator<Item = &LinkTest> {
    check.drives.iter().filter_map(|drive| drive.test.as_ref())
}

fn errors(check: &LineCheck, of: fn(&AdapterErrors) -> u32) -> bool {
    check.adapter.errors.as_ref().is_some_and(|errors| of(errors) > 0)
}

fn advice(check: &LineCheck) -> Vec<Advice> {
    let seen = SIGNS.iter().filter(|sign| (sign.shows)(check));
    seen.map(|sign| Advice { code: sign.code, text: (sign.advice)() }).collect()
}

/// Whether a drive was asked and never answered.
fn is_absent(drive: &CheckedDrive) -> bool {
    let silent = drive.error.as_ref().is_some_and(|error| error.class == Class::Silence);
    silent || drive.test.as_ref().is_some_and(|test| test.asked > 0 && test.silent == test.asked)
}
