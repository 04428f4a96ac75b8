//! Who is there? Every address is asked by the book, one after the other.

use super::session::{AccessError, Session};
use super::{describe, family::judge, route::Inquiry, route::RegisterAddress};
use crate::exchange::modbus::Limits;
use crate::outcome::{Event, FoundDrive};
use crate::profile::{Lang, Registry, Type};

/// Status word: every Modbus device says something when its register is read, and an ACTIVE drive answers it without
/// touching its error register.
const PROBE: u16 = 411;

/// What to search.
#[derive(Clone, Debug)]
pub struct ScanPlan {
    /// Addresses, in the order in which they are asked.
    pub addresses: Vec<u8>,
    /// Language of texts.
    pub lang: Lang,
}

/// What a search brought.
#[derive(Debug, Default)]
pub struct ScanResult {
    /// What answered.
    pub drives: Vec<FoundDrive>,
    /// Addresses that were asked.
    pub asked: usize,
    /// Addresses where only garbage came: a wrong setting, or two devices with one address.
    pub garbled: Vec<u8>,
    /// Why it ended early.
    pub cut: Option<AccessError>,
}

/// The question that every address is asked first.
pub fn probe_question() -> Inquiry {
    Inquiry::Read(RegisterAddress { number: PROBE, set: 0 }, Type::Uint)
}

/// Asks every address. Tells progress and finds as they come; what was found stays when it is interrupted.
pub async fn scan(session: &mut Session<'_>, plan: &ScanPlan, registry: &Registry) -> ScanResult {
    let mut result = ScanResult::default();
    for (done, &address) in plan.addresses.iter().enumerate() {
        session.tell(Event::Progress {
            done: done as u64,
            total: plan.addresses.len() as u64,
            what: format!("address {address}"),
        });
        match look(session, address, plan.lang, registry).await {
            Ok(Some(drive)) => {
                session.tell(Event::Found(drive.clone()));
                result.drives.push(drive);
            }
            Ok(None) => {}
            Err(AccessError::Exchange(_)) => result.garbled.push(address),
            Err(error) => {
                result.cut = Some(error);
                return result;
            }
        }
        result.asked += 1;
    }
    result
}

/// Looks whether somebody is at an address; garbage is an error, silence is not.
async fn look(
    session: &mut Session<'_>,
    address: u8,
    lang: Lang,
    registry: &Registry,
) -> Result<Option<FoundDrive>, AccessError> {
    use crate::exchange::modbus::ExchangeError::{Silence, Stray};
    let probe = probe_question().request();
    let limits = session.limits();
    session.set_limits(Limits { retries: 0, ..limits });
    let answer = session.ask(address, probe.clone()).await;
    session.set_limits(limits);
    let answer = match answer {
        Ok(answer) => answer,
        Err(AccessError::Exchange(Silence { .. } | Stray { .. })) => return Ok(None),
        // A disturbed reply: somebody is there, so ask by the book.
        Err(AccessError::Exchange(_)) => session.ask(address, probe).await?,
        Err(error) => return Err(error),
    };
    let finding = judge(session, address, &answer, lang, false).await?;
    let title = |en: &str, de: &str| if lang == Lang::De { de.to_owned() } else { en.to_owned() };
    let mut found = FoundDrive {
        address,
        drive: finding.drive.clone().unwrap_or_else(|| "unknown".to_owned()),
        title: title("Modbus device, no known drive", "Modbus-Gerät, kein bekannter Antrieb"),
        evidence: finding.evidence.clone(),
        state: None,
        fault: None,
    };
    let Some(mut target) = finding.target(address, registry) else { return Ok(Some(found)) };
    let titles = registry.drives().into_iter().find(|drive| drive.id == target.family.drive);
    found.title = titles.map_or_else(String::new, |drive| drive.title.get(lang).to_owned());
    for role in ["status-word", "fault"] {
        let Some(param) = target.family.role(role).cloned() else { continue };
        match target.read_set(session, &param, 0).await {
            Ok(reading) if role == "fault" => {
                let fault = describe::fault(&target.family, reading.raw as u32, lang);
                found.fault = fault.map(|fault| format!("{} {}", fault.key, fault.name));
            }
            Ok(reading) => found.state = Some(describe::state(&target.family, reading.raw as u32, lang)),
            Err(error) if error.is_fatal() => return Err(error),
            Err(_) => {}
        }
    }
    Ok(Some(found))
}
