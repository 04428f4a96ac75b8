//! A look at somebody who was heard, and what is odd about what was heard.

use super::{Tuning, Yielded};
use crate::drive::access::AccessError;
use crate::drive::probe::probe;
use crate::drive::route::Route;
use crate::drive::session::Session;
use crate::drive::target::Target;
use crate::drive::{describe, recognise};
use crate::exchange::survey::{Attendance, Sign, Survey};
use crate::exchange::{Answer, ExchangeError, Talker};
use crate::outcome::{FoundDrive, Warning};
use crate::profile::{Family, Registry};
use crate::protocol::Protocol;
use crate::text::{Text, both};

/// Characters of the reply to the first question, about.
pub(super) const REPLY: u64 = 8;

/// What a look brings.
pub(super) enum Sight {
    /// Somebody is there, with what is odd about him.
    Drive(Box<FoundDrive>, Option<Warning>),
    /// Somebody answered, and there was no time to ask him what he is.
    Unlooked(Box<FoundDrive>),
    /// Somebody is there, but only garbage comes when he is asked more.
    Garbled,
    /// Nobody answers any more.
    Nobody,
}

/// Asks a station that was heard what it is. A sign that came late may have been somebody else's telegram, so it must be
/// confirmed by any answer.
pub(super) async fn look(
    session: &mut Session<'_>,
    registry: &Registry,
    sign: &Sign,
    is_late: bool,
) -> Result<Sight, AccessError> {
    match describe_drive(session, registry, sign, is_late).await {
        Ok(Some(drive)) => Ok(Sight::Drive(Box::new(drive), is_late.then(|| late(sign)))),
        Ok(None) => Ok(Sight::Nobody),
        Err(AccessError::Exchange(ExchangeError::Short { bytes, .. })) => {
            Ok(Sight::Drive(Box::new(stranger(session, sign.station, short(bytes))), None))
        }
        Err(AccessError::Exchange(_)) => Ok(Sight::Garbled),
        Err(error) => Err(error),
    }
}

async fn describe_drive(
    session: &mut Session<'_>,
    registry: &Registry,
    sign: &Sign,
    is_late: bool,
) -> Result<Option<FoundDrive>, AccessError> {
    let address = sign.station;
    let first = match &sign.said {
        Some(said) => Answer::Reply { said: said.clone(), after: sign.after },
        None => match confirm(session, address).await? {
            Some(answer) => answer,
            None => return Ok(None),
        },
    };
    let finding = recognise::judge(session, registry, address, &first, false).await?;
    if finding.drive.is_none() && is_late && sign.said.is_some() && confirm(session, address).await?.is_none() {
        return Ok(None);
    }
    let mut found = FoundDrive {
        drive: finding.drive.clone().unwrap_or_else(|| "unknown".to_owned()),
        product: finding.product.clone(),
        evidence: finding.evidence.clone(),
        ..stranger(session, address, nobody_known(session))
    };
    let Some(mut target) = finding.target(address, registry) else { return Ok(Some(found)) };
    let titles = registry.drives().into_iter().find(|drive| drive.id == target.family.drive);
    found.title = titles.map_or_else(Text::default, |drive| drive.title.clone());
    let status = match status_word(&target, session, &first) {
        Some(word) => Some(word),
        None => read(&mut target, session, "status-word").await?,
    };
    found.state = status.map(|word| describe::state(&target.family, word));
    // Who is in no fault has none; a drive that takes long to answer is spared the question.
    let may_have_one = found.state.as_ref().is_none_or(|state| state.slug.contains("fault") || state.slug == "unknown");
    let fault = if may_have_one { read(&mut target, session, "fault").await? } else { None };
    let fault = fault.and_then(|code| describe::fault(&target.family, code));
    found.fault = fault.map(|fault| fault.told());
    // So do warnings show in the status word, where its family has a bit for them.
    if status.is_none_or(|word| may_warn(&target.family, word)) {
        found.warnings = warnings(&mut target, session).await?;
    }
    Ok(Some(found))
}

/// What is no drive that we know.
fn nobody_known(session: &Session<'_>) -> Text {
    match session.protocol() {
        Protocol::Sdo(_) => {
            both!("node that answers SDO, no known drive", "Knoten, der SDO beantwortet, kein bekannter Antrieb")
        }
        _ => both!("Modbus device, no known drive", "Modbus-Gerät, kein bekannter Antrieb"),
    }
}

/// Somebody of whom no more is known than that he answers.
pub(super) fn stranger(session: &Session<'_>, address: u8, title: Text) -> FoundDrive {
    FoundDrive {
        address,
        drive: "unknown".to_owned(),
        title,
        product: None,
        port: session.port().to_owned(),
        line: session.line().to_string(),
        protocol: session.protocol().name().to_owned(),
        evidence: Vec::new(),
        state: None,
        fault: None,
        warnings: None,
    }
}

/// Somebody who answered when the time of the search was over.
pub(super) fn unlooked(session: &Session<'_>, address: u8) -> Sight {
    let title = both!(
        "answered; the time was over before it was asked what it is",
        "hat geantwortet; die Zeit war um, bevor gefragt war, was es ist"
    );
    Sight::Unlooked(Box::new(stranger(session, address, title)))
}

/// The status word, if the first answer is that of this family.
fn status_word(target: &Target, session: &Session<'_>, first: &Answer) -> Option<u32> {
    target.family.role("status-word").filter(|param| param.id == super::PROBE)?;
    let Answer::Reply { said, .. } = first else { return None };
    Route::new(session.protocol(), &target.family.link, target.address).number(said).map(u32::from)
}

/// Whether the status word does not rule warnings out.
fn may_warn(family: &Family, status: u32) -> bool {
    let Some(param) = family.role("status-word") else { return true };
    let word = describe::word(family, param, status, &|_| None);
    let mut signs = word.bits.iter().filter(|bit| bit.slug.as_ref().is_some_and(|slug| slug.starts_with("warning")));
    signs.clone().next().is_none() || signs.any(|bit| bit.set)
}

/// The warnings that are present, by their names.
async fn warnings(target: &mut Target, session: &mut Session<'_>) -> Result<Option<Text>, AccessError> {
    let Some(raw) = read(target, session, "warnings").await? else { return Ok(None) };
    let Some(param) = target.family.role("warnings") else { return Ok(None) };
    let word = describe::word(&target.family, param, raw, &|_| None);
    let set = word.bits.iter().filter(|bit| bit.set);
    let names: Vec<_> = set.map(|bit| bit.name.clone().unwrap_or_else(|| Text::name(bit.bit))).collect();
    Ok((!names.is_empty()).then(|| Text::join(&names, ", ")))
}

/// The parameter that plays a role; `None` if there is none or the drive does not tell.
async fn read(target: &mut Target, session: &mut Session<'_>, role: &str) -> Result<Option<u32>, AccessError> {
    let Some(param) = target.family.role(role).cloned() else { return Ok(None) };
    match target.read_set(session, &param, 0).await {
        Ok(reading) => Ok(Some(reading.raw as u32)),
        Err(error) if error.is_fatal() => Err(error),
        Err(_) => Ok(None),
    }
}

/// Asks once more; `None` if there is no answer.
async fn confirm(session: &mut Session<'_>, address: u8) -> Result<Option<Answer>, AccessError> {
    let Some(question) = probe(session.protocol(), address) else { return Ok(None) };
    match session.ask(address, question).await {
        Ok(answer) => Ok(Some(answer)),
        Err(error @ AccessError::Exchange(ExchangeError::Short { .. })) => Err(error),
        Err(AccessError::Exchange(_)) => Ok(None),
        Err(error) => Err(error),
    }
}

/// Whose answers are no SDO.
fn short(bytes: u8) -> Text {
    both!(
        "node that answers SDO with {came} in place of 8: no drive, or it is disturbed",
        "Knoten, der SDO mit {came} statt mit 8 beantwortet: kein Umrichter, oder gestört",
        came = Text::count(bytes.into(), ["byte", "bytes"], ["Byte", "Bytes"])
    )
}

fn late(sign: &Sign) -> Warning {
    let (address, after) = (sign.station, sign.after);
    let message = both!(
        "address {address} answered only after {after}; a reply as late as that can be lost behind another \
             question: --thorough leaves nobody out",
        "Adresse {address} antwortete erst nach {after}; eine so späte Antwort kann hinter einer anderen Frage \
             verloren gehen: --thorough lässt niemanden aus"
    );
    Warning { code: "scan.late".to_owned(), message }
}

/// The warning about somebody who was heard once and is gone.
pub(super) fn gone(address: u8) -> Warning {
    let message = both!(
        "address {address} was heard once and does not answer any more",
        "Adresse {address} war einmal zu hören und antwortet nicht mehr"
    );
    Warning { code: "scan.gone".to_owned(), message }
}

/// The warning about an address where only garbage came. `is_clear`: others are understood at this setting, which is named where
/// there are several.
pub(super) fn garbled(address: u8, is_clear: bool, at: Option<Tuning>) -> Warning {
    let (code, message) = match is_clear {
        true => ("scan.same_address", same_address(address)),
        false => ("scan.garbage", garbage(address)),
    };
    Warning { code: code.to_owned(), message: placed(message, at) }
}

fn placed(message: Text, at: Option<Tuning>) -> Text {
    match at {
        Some(at) => both!("{at}: {message}", "{at}: {message}", message),
        None => message,
    }
}

/// The warning about somebody who speaks on a line that is searched all the same.
pub(super) fn beside(yielded: Yielded) -> Warning {
    let Yielded { bursts, listened, .. } = yielded;
    let (code, message) = match yielded.to {
        Talker::Master => (
            "scan.other_master",
            both!(
                "another master asks on this line; what both ask at once is lost for both, and a drive that is not listed may be there",
                "ein anderer Master fragt auf dieser Leitung; was beide zugleich fragen, geht beiden verloren, und ein Antrieb, der \
                 nicht in der Liste steht, kann da sein"
            ),
        ),
        Talker::Somebody => (
            "scan.talker",
            both!(
                "somebody spoke {bursts} times in {listened} before anything was sent; what is garbled tells nothing of who is there",
                "jemand sprach {bursts}-mal in {listened}, bevor etwas gesendet war; was unlesbar ist, sagt nichts darüber, wer da ist"
            ),
        ),
    };
    Warning { code: code.to_owned(), message }
}

/// The warning about a port whose line cannot be set from here.
pub(super) fn fixed_line(port: &str, known: Tuning) -> Warning {
    let line = known.line;
    let message = both!(
        "{port}: speed and parity are set at the other end, so only {line} was searched; rfc2217:// can set them",
        "{port}: Baudrate und Parität werden am anderen Ende eingestellt, deshalb wurde nur {line} abgesucht; \
             rfc2217:// kann sie einstellen"
    );
    Warning { code: "scan.fixed_line".to_owned(), message }
}

/// What is odd about what a survey heard.
pub(super) fn remarks(survey: &Survey, tuning: Tuning) -> Vec<Warning> {
    let mut warnings = Vec::new();
    let mut warn = |code: &str, message: Text| warnings.push(Warning { code: format!("scan.{code}"), message });
    if survey.is_shared() {
        warn("other_master", other_master(tuning));
    } else if survey.is_occupied() {
        warn("occupied", occupied(tuning));
    } else if survey.is_noisy() {
        warn("noise", noise(tuning));
    }
    // Beside another master replies are too many because he asked too.
    let surplus = |known: &Attendance| known.surplus() > 0 && !survey.is_shared();
    for (&address, known) in survey.attendance().iter().filter(|(_, known)| surplus(known)) {
        let (asked, replies) = (known.asked, known.replies.len());
        match known.differ() {
            true => warn("same_address", two_voices(address, asked, replies)),
            false => warn("doubled", doubled(address, asked, replies)),
        }
    }
    for &address in survey.strangers() {
        warn("stranger", intruder(address));
    }
    warnings
}

fn other_master(tuning: Tuning) -> Text {
    both!(
        "{tuning}: somebody else asks drives on this line; what both ask at once is lost for both, and a drive that \
             is not listed may be there",
        "{tuning}: jemand anderes fragt Antriebe auf dieser Leitung; was beide zugleich fragen, geht beiden \
             verloren, und ein Antrieb, der nicht in der Liste steht, kann da sein"
    )
}

fn occupied(tuning: Tuning) -> Text {
    both!(
        "{tuning}: the line is never silent, somebody else speaks on it all the time, so it was left alone; \
             disconnect the other master",
        "{tuning}: die Leitung ist nie still, jemand anderes spricht ununterbrochen, deshalb wurde sie in Ruhe \
             gelassen; den anderen Master abklemmen"
    )
}

fn noise(tuning: Tuning) -> Text {
    both!(
        "{tuning}: garbage came after most questions, so it is the line's own: check termination, bias resistors, \
             shield, and whether another master speaks",
        "{tuning}: nach den meisten Fragen kam Unlesbares, es kommt also von der Leitung selbst: Abschluss, \
             Ruhepegel-Widerstände und Schirm prüfen, und ob ein anderer Master spricht"
    )
}

fn garbage(address: u8) -> Text {
    both!(
        "address {address}: only garbage came; another baud rate or parity, or two devices with this address",
        "Adresse {address}: es kam nur Unlesbares; andere Baudrate oder Parität, oder zwei Geräte mit dieser Adresse"
    )
}

fn same_address(address: u8) -> Text {
    both!(
        "address {address}: every reply is garbage, while others are understood at this setting: two drives with \
             one address?",
        "Adresse {address}: jede Antwort ist unlesbar, während andere bei dieser Einstellung verstanden werden: \
             zwei Antriebe mit derselben Adresse?"
    )
}

fn two_voices(address: u8, asked: u32, replies: usize) -> Text {
    both!(
        "address {address}: {replies} different replies to {asked} question(s): two drives with one address?",
        "Adresse {address}: {replies} verschiedene Antworten auf {asked} Frage(n): zwei Antriebe mit derselben Adresse?"
    )
}

fn doubled(address: u8, asked: u32, replies: usize) -> Text {
    both!(
        "address {address}: {replies} equal replies to {asked} question(s): the line doubles them, or two drives of \
             the same kind have one address",
        "Adresse {address}: {replies} gleiche Antworten auf {asked} Frage(n): die Leitung verdoppelt sie, oder zwei \
             gleiche Antriebe haben dieselbe Adresse"
    )
}

fn intruder(address: u8) -> Text {
    both!(
        "a telegram of address {address} came that nobody here had asked for: another master on the line, or a \
             telegram that the line changed",
        "es kam ein Telegramm der Adresse {address}, die hier niemand gefragt hat: ein anderer Master an der \
             Leitung, oder ein Telegramm, das die Leitung verändert hat"
    )
}
