//! Who is on a PROFIBUS line: the live list, and what each slave tells of itself without being taken.
//!
//! FDL status, Slave_Diag and Get_Cfg are answered before and beside any parameterisation; nothing is changed by them.

use super::ending::INSISTED;
use super::exchange::Exchange;
use super::line::Line;
use super::trouble;
use crate::drive::decode::dp::{Reader, configuration, diagnosed, station};
use crate::exchange::dp::{Asked, MASTER, Reply, Unanswered};
use crate::failure::{Class, Failure};
use crate::outcome::{Answers, ErrorDoc, Event, Field, LiveList, LiveStation, TelegramDoc};
use crate::protocol::dp::cfg::Layout;
use crate::protocol::dp::control::Station;
use crate::protocol::dp::{Diagnosis, LAST_STATION, Service, diagnosis};
use crate::protocol::modbus::Hex;
use crate::text::both;
use crate::tick::{Span, Tick};

/// Repeats of the question whether anybody is there: one more than none, so that a lost byte hides nobody.
const REPEATS: u8 = 1;

/// Every address that a station can have.
pub fn everybody() -> Vec<u8> {
    (0..LAST_STATION).collect()
}

/// The questions to one address, as they go out first.
pub fn questions(address: Option<u8>) -> Vec<TelegramDoc> {
    let asked = [Service::SlaveDiag, Service::GetCfg].map(|service| Asked::service(service, Vec::new()));
    let reader = Reader { family: None, cyclic: None };
    let of = |address: u8| {
        [Asked::STATUS].into_iter().chain(asked.clone()).map(move |asked| asked.telegram(address, MASTER))
    };
    address.into_iter().flat_map(of).map(|bytes| reader.telegram(&bytes)).collect()
}

/// A round over a line.
#[derive(Clone, Copy, Debug)]
pub struct Round<'r> {
    /// Whom to ask.
    pub addresses: &'r [u8],
    /// Each station is asked so often how it is.
    pub questions: u32,
    /// The first station ends it.
    pub until_first: bool,
    /// So does this moment.
    pub until: Option<Tick>,
}

/// Asks every address who is there, and the slaves what they are. Also what ended it early.
pub async fn live(line: &mut Line<'_>, round: Round<'_>) -> (LiveList, Option<Failure>) {
    let Round { addresses, questions, until_first, until } = round;
    let (port, setting) = line.name();
    let mut list = LiveList { port, line: setting, asked: 0, addresses: addresses.len(), stations: Vec::new() };
    let total = addresses.len() as u64;
    for (done, &address) in (0..).zip(addresses) {
        if until_first && !list.stations.is_empty() || until.is_some_and(|until| line.now() >= until) {
            break;
        }
        // Our own address is nobody's.
        let what = both!("address {address}", "Adresse {address}");
        line.tell(Event::Progress { done, total, what });
        if address != line.fdl.address() {
            match look(line, address).await {
                Ok(found) => list.stations.extend(found),
                Err(failure) => return (list, Some(failure)),
            }
        }
        list.asked += 1;
    }
    for station in list.stations.iter_mut().filter(|_| questions > 0) {
        match answers(line, station.address, questions).await {
            Ok(answers) => station.answers = Some(answers),
            Err(failure) => return (list, Some(failure)),
        }
    }
    (list, None)
}

/// Asks a station the same many times.
async fn answers(line: &mut Line<'_>, address: u8, questions: u32) -> Result<Answers, Failure> {
    let mut answers = Answers { asked: questions.into(), ..Answers::default() };
    let mut times = Vec::new();
    for done in 0..questions {
        let what = both!("questions to station {address}", "Fragen an Station {address}");
        line.tell(Event::Progress { done: done.into(), total: questions.into(), what });
        let before = line.fdl.repeats(address);
        match line.ask(address, Asked::STATUS, None).await? {
            Ok(_) => {
                let repeats = usize::try_from(line.fdl.repeats(address) - before).unwrap_or(usize::MAX);
                answers.repeats.resize(answers.repeats.len().max(repeats + 1), 0);
                answers.repeats.iter_mut().skip(repeats).take(1).for_each(|count| *count += 1);
                times.extend(line.fdl.answered_after().map(Span::as_micros));
            }
            Err(Unanswered::Silence { .. }) => answers.silences += 1,
            Err(Unanswered::Garbled { .. }) => answers.garbled += 1,
            Err(why @ Unanswered::OtherMaster(_)) => return Err(trouble::unanswered(address, &why)),
        }
    }
    times.sort_unstable();
    answers.least_us = times.first().copied();
    answers.median_us = times.get(times.len() / 2).copied();
    answers.most_us = times.last().copied();
    Ok(answers)
}

/// What a slave says that it is configured for, and whether that is the Basic block; `None` where it says nothing. Whoever `insists` is
/// not kept from it by an interrupt.
pub async fn configured(line: &mut Line<'_>, address: u8, insists: bool) -> Result<Option<(String, bool)>, Failure> {
    let until = line.now() + INSISTED;
    loop {
        let answer = line.ask(address, Asked::service(Service::GetCfg, Vec::new()), Some(REPEATS)).await;
        return match answer {
            Err(failure) if insists && failure.class == Class::Interrupted => {
                line.note_interrupts();
                continue;
            }
            Err(failure) if insists && failure.is_unheard() && line.now() < until => continue,
            Ok(Ok(Reply::Frame { data, .. })) if !data.is_empty() => {
                Ok(Some((Hex(&data).to_string(), is_basic(&data))))
            }
            Ok(Err(why @ Unanswered::OtherMaster(_))) => Err(trouble::unanswered(address, &why)),
            answer => answer.map(|_| None),
        };
    }
}

/// The answer to Slave_Diag, field by field; nothing where none came.
pub async fn slave_diag(line: &mut Line<'_>, address: u8) -> Result<Vec<Field>, Failure> {
    let answer = line.ask(address, Asked::service(Service::SlaveDiag, Vec::new()), None).await?;
    Ok(match answer {
        Ok(Reply::Frame { data, .. }) => diagnosed(&data).fields,
        _ => Vec::new(),
    })
}

impl Exchange<'_, '_> {
    /// The same while data are exchanged.
    pub async fn slave_diag(&mut self) -> Result<Vec<Field>, Failure> {
        let address = self.address();
        slave_diag(self.line, address).await
    }
}

/// The Basic block alone, or with modules behind it that are no process data.
fn is_basic(cfg: &[u8]) -> bool {
    match Layout::of("", cfg) {
        Some(layout) => layout == Layout::Basic,
        None => cfg.starts_with(Layout::Basic.bytes()),
    }
}

/// What stands at an address, if anything does.
pub(super) async fn look(line: &mut Line<'_>, address: u8) -> Result<Option<LiveStation>, Failure> {
    let mut found = LiveStation { address, ..LiveStation::default() };
    match line.ask(address, Asked::STATUS, Some(REPEATS)).await? {
        Ok(Reply::Frame { station: kind, .. }) => {
            (found.kind, found.is) = (word(kind), station(kind));
            found.answered_us = line.fdl.answered_after().map(Span::as_micros);
            if kind != Station::Slave {
                return Ok(Some(found));
            }
        }
        Ok(_) => return Ok(None),
        Err(Unanswered::Silence { .. }) => return Ok(None),
        Err(why) => {
            let failure = trouble::unanswered(address, &why);
            if matches!(why, Unanswered::OtherMaster(_)) {
                return Err(failure);
            }
            found.error = Some(ErrorDoc::from(&failure));
            return Ok(Some(found));
        }
    }
    for service in [Service::SlaveDiag, Service::GetCfg] {
        let answer = line.ask(address, Asked::service(service, Vec::new()), None).await?;
        match (service, answer) {
            (Service::SlaveDiag, Ok(Reply::Frame { data, .. })) => diagnose(&mut found, &data),
            (_, Ok(Reply::Frame { data, .. })) if !data.is_empty() => configure(&mut found, &data),
            (_, Ok(_)) => {}
            (_, Err(why)) => found.error = Some(ErrorDoc::from(&trouble::unanswered(address, &why))),
        }
    }
    found.repeats = line.fdl.repeats(address);
    Ok(Some(found))
}

fn diagnose(station: &mut LiveStation, data: &[u8]) {
    let Some(told) = Diagnosis::decode(data) else { return };
    let [first, second, _] = told.status;
    // Bits of the norm: Prm_Req, Station_Not_Ready (IEC 61158-6-3).
    station.state = Some(match (second & 1 != 0, first & 2 != 0) {
        (true, _) => "wait-prm",
        (false, true) => "wait-cfg",
        (false, false) => "data-exchange",
    });
    station.ident = Some(format!("{:04X}", told.ident));
    station.master = Some(told.master).filter(|master| *master != diagnosis::NOBODY);
    station.flags = told.flags().map(str::to_owned).collect();
    station.diagnosis = diagnosed(data).fields;
}

fn configure(station: &mut LiveStation, data: &[u8]) {
    station.configuration = Some(Hex(data).to_string());
    station.layout = Layout::of("", data).map(Layout::name);
    station.identifiers = configuration(data).fields;
}

/// The word of a kind of station.
fn word(kind: Station) -> &'static str {
    match kind {
        Station::Slave => "slave",
        Station::NotReady => "master-not-ready",
        Station::Ready => "master-ready",
        Station::InRing => "master-in-ring",
    }
}
