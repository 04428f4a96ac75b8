//! Which setting a line has on which others speak, found by listening alone.

use super::Reader;
use crate::drive::access::AccessError;
use crate::drive::scan::{Tuning, Unknown, tunings};
use crate::drive::session::Session;
use crate::exchange::Cutter;
use crate::exchange::talk::WINDOW;
use crate::outcome::{Event, SniffSearch};
use crate::text::{Text, both};
use crate::tick::Tick;
use crate::transport::Wake;

/// Garbage has a right check value by chance: two telegrams have not.
const CERTAIN: u64 = 2;
/// Where telegrams come, but too few to be certain, a setting is listened to for so many windows.
const LONGEST: u32 = 4;
/// Unless so much of what comes is none.
const MOST_GARBAGE: u64 = 8;

/// What came of looking for a setting.
pub(super) struct Sought {
    /// Telegrams came at one; the line is tuned to it.
    pub(super) found: bool,
    /// Why nothing more was listened to: `search` is over, `duration`, `interrupted`, `lost`.
    pub(super) because: &'static str,
    /// The port was lost.
    pub(super) cut: Option<AccessError>,
    tried: u64,
    characters: u64,
}

impl Sought {
    pub(super) fn told(&self) -> SniffSearch {
        SniffSearch { found: self.found, tried: self.tried, characters: self.characters }
    }
}

/// Tunes to the setting at which telegrams come, going through those that a line may have, the likeliest first: once, or again
/// and again until `until`. Each is listened to for [`WINDOW`], which finds who polls once a second. `reader` reads what is spoken
/// there; if nothing is found the line is tuned as before. Never sends.
pub(super) async fn search(
    session: &mut Session<'_>,
    reader: &mut Reader<'_>,
    unknown: Unknown,
    until: Option<Tick>,
) -> Sought {
    let here = Tuning { protocol: session.protocol(), line: session.line() };
    let mut sought = Sought { found: false, because: "search", cut: None, tried: 0, characters: 0 };
    let searched = through(session, reader, here, unknown, until, &mut sought).await;
    let ended = match searched {
        Ok(()) if sought.found => Ok(()),
        Ok(()) => tune(session, reader, here).await,
        Err(error) => Err(error),
    };
    match ended {
        Ok(()) => {}
        Err(AccessError::Interrupted) => sought.because = "interrupted",
        Err(error) => (sought.found, sought.because, sought.cut) = (false, "lost", Some(error)),
    }
    sought
}

/// Goes through the settings until one is found or it is over.
async fn through(
    session: &mut Session<'_>,
    reader: &mut Reader<'_>,
    here: Tuning,
    unknown: Unknown,
    until: Option<Tick>,
    sought: &mut Sought,
) -> Result<(), AccessError> {
    // The speed of a line behind a raw server is set elsewhere.
    let can = session.can_retune();
    let tries = tunings(here, Unknown { baud: unknown.baud && can, parity: unknown.parity && can, ..unknown });
    loop {
        for (done, tuning) in (0..).zip(&tries) {
            if until.is_some_and(|until| session.now() >= until) {
                sought.because = "duration";
                return Ok(());
            }
            session.tell(Event::Progress { done, total: tries.len() as u64, what: trying(tuning) });
            tune(session, reader, *tuning).await?;
            sought.tried += 1;
            if listen(session, reader, until, &mut sought.characters).await? >= CERTAIN {
                sought.found = true;
                session.tell(Event::Note(found(tuning)));
                return Ok(());
            }
        }
        if until.is_none() {
            return Ok(());
        }
    }
}

async fn tune(session: &mut Session<'_>, reader: &mut Reader<'_>, tuning: Tuning) -> Result<(), AccessError> {
    reader.protocol = tuning.protocol;
    session.retune(tuning.protocol, tuning.line).await
}

/// Listens for a window, and for more of them as long as what comes may be telegrams and leaves it open. How many came; among as
/// much garbage none, because garbage has a right check value by chance.
async fn listen(
    session: &mut Session<'_>,
    reader: &Reader<'_>,
    until: Option<Tick>,
    characters: &mut u64,
) -> Result<u64, AccessError> {
    let mut cutter = Cutter::new(reader.protocol, session.line());
    let (mut telegrams, mut garbage, mut begun) = (0, 0, false);
    for _ in 0..LONGEST {
        let window = session.now() + WINDOW;
        let end = until.map_or(window, |until| until.min(window));
        let mut pieces = Vec::new();
        while session.now() < end {
            // What is begun is over with a pause.
            let quiet = if begun { end.min(session.now() + cutter.pause()) } else { end };
            match session.hear(quiet).await? {
                Wake::Bytes(bytes) => {
                    begun = true;
                    *characters += bytes.len() as u64;
                    pieces.extend(cutter.feed(&bytes));
                }
                Wake::Silence => {
                    begun = false;
                    pieces.extend(cutter.silence());
                }
            }
        }
        let good = pieces.iter().filter(|piece| reader.telegram(piece, None).check_ok).count();
        telegrams += good as u64;
        garbage += (pieces.len() - good) as u64;
        let is_open = telegrams > 0 && telegrams <= garbage.max(CERTAIN - 1) && garbage < MOST_GARBAGE;
        if !is_open || until.is_some_and(|until| session.now() >= until) {
            break;
        }
    }
    Ok(if telegrams > garbage { telegrams } else { 0 })
}

fn trying(setting: &Tuning) -> Text {
    both!("listening at {setting}", "gelauscht wird bei {setting}")
}

fn found(setting: &Tuning) -> Text {
    let (baud, parity, protocol) = (setting.line.baud, setting.line.parity.name(), setting.protocol);
    both!(
        "telegrams come at {setting}; to listen there again: --baud {baud} --parity {parity} --protocol {protocol}",
        "Telegramme kommen bei {setting}; um dort wieder zu lauschen: --baud {baud} --parity {parity} --protocol {protocol}"
    )
}
