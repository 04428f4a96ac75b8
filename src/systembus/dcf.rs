//! A drive of a plan as a device configuration file (DCF, CiA 306 1.3.0), and back.
//!
//! Index = parameter, as over SDO. The standard spells `[DeviceComissioning]` with one m; both are read. What a DCF has no room
//! for (a master that is a controller, how often it sends SYNC) is not in it.

use super::ends;
use super::load::Rate;
use super::plan::{Drive, EmergencyReaction, Plan, Rx, Trigger, Tx};
use super::settings::{SYNC, Setting, settings};
use super::standing::Standing;
use crate::profile::Family;
use crate::protocol::can::pdo::Place;
use crate::protocol::can::{LAST_DRIVE, PdoNumber, Service};
use crate::text::{Text, both};
use std::collections::BTreeMap;
use std::fmt::Write;

/// A drive as DCF, with what is left out because the plan leaves it open.
pub fn dcf(plan: &Plan, drive: &Drive, family: &Family) -> (String, Vec<u32>) {
    let (known, open): (Vec<Setting>, Vec<Setting>) =
        settings(plan, drive).into_iter().partition(|setting| setting.value.is_some());
    let name = plain(&drive.name);
    let mut out =
        format!("[FileInfo]\nFileName={name}.dcf\nFileVersion=1\nFileRevision=0\nEDSVersion=4.0\nCreatedBy=antrieb\n");
    out +=
        "Description=system bus\n\n[DeviceInfo]\nVendorName=Bonfiglioli Vectron\nProductName=ACTIVE Cube, EM-RES-03\n";
    for kbd in [10, 20, 50, 125, 250, 500, 800, 1000] {
        let is_known = u8::from(Rate::of_kbd(kbd).is_some());
        let _infallible = writeln!(out, "BaudRate_{kbd}={is_known}");
    }
    let is_master = u8::from(drive.node == 0);
    let _infallible = writeln!(
        out,
        "SimpleBootUpMaster={is_master}\nSimpleBootUpSlave={}\nGranularity=0\nDynamicChannelsSupported=0\nGroupMessaging=0\n\
         NrOfRXPDO=3\nNrOfTXPDO=3\nLSS_Supported=0\n\n[DeviceComissioning]\nNodeID={}\nNodeName={name}\nBaudrate={}\n\
         NetNumber=0\nNetworkName=\nCANopenManager={is_master}\nLSS_SerialNumber=0\n\n[MandatoryObjects]\nSupportedObjects=0\n\n\
         [OptionalObjects]\nSupportedObjects=0\n\n[ManufacturerObjects]\nSupportedObjects={}",
        1 - is_master,
        drive.node,
        plan.rate.kbd(),
        known.len(),
    );
    for (nth, setting) in known.iter().enumerate() {
        let _infallible = writeln!(out, "{}=0x{:04X}", nth + 1, setting.param);
    }
    for Setting { param, value } in &known {
        let row = family.param(*param);
        let title = row.map_or_else(|| format!("P.{param}"), |row| row.name.en.to_string());
        let is_signed = *param == ends::NODE;
        let _infallible = writeln!(
            out,
            "\n[{param:04X}]\nParameterName={title}\nObjectType=0x7\nDataType=0x{:04X}\nAccessType=rw\nPDOMapping=0\n\
             ParameterValue={}",
            if is_signed { INTEGER16 } else { UNSIGNED16 },
            value.unwrap_or_default(),
        );
    }
    (out, open.into_iter().map(|setting| setting.param).collect())
}

/// Data types of CiA 306.
const INTEGER16: u16 = 3;
const UNSIGNED16: u16 = 6;

/// A name without what would end its line.
fn plain(name: &str) -> String {
    name.chars().map(|letter| if letter.is_control() { ' ' } else { letter }).collect()
}

/// What is wrong with a DCF.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{file}: {}", why.en)]
pub struct DcfError {
    /// The file, as the user named it.
    pub file: String,
    /// What is wrong.
    pub why: Text,
}

/// A plan of the DCFs of its drives: what each is called, and its text.
///
/// # Errors
/// No node, no rate or another one than before, values that are none.
pub fn from_dcf(files: &[(String, String)]) -> Result<Plan, DcfError> {
    let mut plan: Option<Plan> = None;
    for (file, text) in files {
        let wrong = |why: Text| DcfError { file: file.clone(), why };
        let device = Device::read(text).map_err(wrong)?;
        let rate = device.rate().map_err(wrong)?;
        let plan = plan.get_or_insert_with(|| Plan {
            rate,
            sync_identifier: device.identifier(ends::SYNC_IDENTIFIER).unwrap_or(SYNC),
            sync_every_ms: None,
            has_external_master: false,
            drives: Vec::new(),
            foreign: Vec::new(),
        });
        if plan.rate != rate {
            let (one, other) = (plan.rate.kbd(), rate.kbd());
            return Err(wrong(both!(
                "{other} kBd, but the drives before have {one}",
                "{other} kBd, aber die Antriebe davor haben {one}"
            )));
        }
        if device.identifier(ends::SYNC_IDENTIFIER).unwrap_or(SYNC) != plan.sync_identifier {
            let why = both!("P.918 differs from the drives before", "P.918 weicht von den Antrieben davor ab");
            return Err(wrong(why));
        }
        let drive = device.drive(file).map_err(wrong)?;
        if drive.node == 0 {
            plan.sync_every_ms = device.number(ends::SYNC_TIME);
        }
        plan.drives.push(drive);
    }
    plan.ok_or_else(|| DcfError { file: String::new(), why: both!("no DCF", "keine DCF") })
}

/// What a DCF says of a device.
struct Device {
    name: Option<String>,
    node: Option<i64>,
    kbd: Option<i64>,
    /// By parameter.
    values: BTreeMap<u32, i64>,
}

impl Device {
    fn read(text: &str) -> Result<Self, Text> {
        let mut device = Device { name: None, node: None, kbd: None, values: BTreeMap::new() };
        let mut section = String::new();
        let mut relative = Vec::new();
        for (nth, line) in text.lines().map(str::trim).enumerate() {
            if let Some(name) = line.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
                section = name.to_ascii_lowercase();
                continue;
            }
            let Some((key, value)) = line.split_once('=').filter(|_| !line.starts_with(';')) else { continue };
            let (key, value) = (key.trim().to_ascii_lowercase(), value.trim());
            let wrong = || {
                let line = nth + 1;
                both!("line {line}: '{value}' is no number", "Zeile {line}: '{value}' ist keine Zahl")
            };
            match (section.as_str(), key.as_str()) {
                ("devicecomissioning" | "devicecommissioning", "nodeid") => {
                    device.node = Some(number(value).ok_or_else(wrong)?);
                }
                ("devicecomissioning" | "devicecommissioning", "baudrate") => {
                    device.kbd = Some(number(value).ok_or_else(wrong)?);
                }
                ("devicecomissioning" | "devicecommissioning", "nodename") if !value.is_empty() => {
                    device.name = Some(value.to_owned());
                }
                (index, "parametervalue") if !value.is_empty() => {
                    let Some(param) = parameter(index) else { continue };
                    match value.to_ascii_uppercase().strip_prefix("$NODEID+") {
                        Some(rest) => relative.push((param, number(rest).ok_or_else(wrong)?)),
                        None => {
                            device.values.insert(param, number(value).ok_or_else(wrong)?);
                        }
                    }
                }
                _ => {}
            }
        }
        let node = device.node.or(device.values.get(&ends::NODE).copied()).unwrap_or_default();
        device.values.extend(relative.into_iter().map(|(param, number)| (param, node.saturating_add(number))));
        Ok(device)
    }

    fn standing(&self) -> Standing<'_> {
        Standing::new(&self.values)
    }

    fn number(&self, param: u32) -> Option<u32> {
        self.standing().number(param)
    }

    fn identifier(&self, param: u32) -> Option<u16> {
        self.standing().own_identifier(param)
    }

    fn rate(&self) -> Result<Rate, Text> {
        let of_code = self.values.get(&ends::RATE).and_then(|code| Rate::of_code(*code));
        let of_kbd = self.kbd.and_then(|kbd| Rate::of_kbd(u32::try_from(kbd).ok()?));
        of_code.or(of_kbd).ok_or_else(|| {
            both!(
                "expected P.903 or Baudrate, one of 50, 100, 125, 250, 500, 1000 kBd",
                "erwartet: P.903 oder Baudrate, eine von 50, 100, 125, 250, 500, 1000 kBd"
            )
        })
    }

    fn drive(&self, file: &str) -> Result<Drive, Text> {
        let node = self.values.get(&ends::NODE).copied().or(self.node);
        let node =
            node.and_then(|node| u8::try_from(node).ok()).filter(|node| *node <= LAST_DRIVE).ok_or_else(|| {
                both!("expected P.900 or NodeID from 0 to 63", "erwartet: P.900 oder NodeID von 0 bis 63")
            })?;
        Ok(Drive {
            name: self.name.clone().unwrap_or_else(|| file.to_owned()),
            node,
            sync_timeout_ms: self.number(ends::SYNC_TIMEOUT).unwrap_or_default(),
            boot_up_delay_ms: self.number(ends::BOOT_UP_DELAY),
            emergency_reaction: self.number(ends::EMERGENCY_REACTION).map(|reaction| match reaction {
                0 => EmergencyReaction::Fault,
                _ => EmergencyReaction::Warning,
            }),
            sdo2: self.number(ends::SDO2).map(|sdo2| sdo2 != 0),
            rx_sdo1: self.identifier(ends::RX_SDO1),
            tx_sdo1: self.identifier(ends::TX_SDO1),
            numbering: self.standing().numbering(),
            tx: PdoNumber::ALL.iter().filter_map(|pdo| self.tx(*pdo, node)).collect(),
            rx: PdoNumber::ALL.iter().filter_map(|pdo| self.rx(*pdo, node)).collect(),
        })
    }

    /// A PDO that is sent: its function says so.
    fn tx(&self, pdo: PdoNumber, node: u8) -> Option<Tx> {
        /// Printed factory setting of P.931, 933, 935 (manual 5.11.2).
        const USUAL_MS: u32 = 8;
        let trigger = match self.number(ends::tx_function(pdo))? {
            1 => Trigger::Time(self.number(ends::tx_time(pdo)).unwrap_or(USUAL_MS)),
            2 => Trigger::Sync,
            _ => return None,
        };
        let identifier =
            self.identifier(ends::tx_identifier(pdo)).or_else(|| Service::TxPdo(pdo, node).identifier())?;
        let input = |place: Place| {
            let source = self.number(ends::input(pdo, place)).and_then(|source| u16::try_from(source).ok())?;
            (source != ends::unused(place.kind())).then_some((place, source))
        };
        Some(Tx { number: pdo, identifier, trigger, inputs: Place::all().filter_map(input).collect() })
    }

    /// A PDO that is received: a parameter takes one of its sources, or it has an identifier of its own.
    fn rx(&self, pdo: PdoNumber, node: u8) -> Option<Rx> {
        let taking = |place: Place| {
            let source = i64::from(ends::source(pdo, place));
            let of_bus = |param: &u32| (ends::NODE..=ends::EMERGENCY_REACTION).contains(param);
            let each = self.values.iter().filter(move |row| *row.1 == source && !of_bus(row.0));
            each.map(move |row| (place, *row.0))
        };
        let outputs: Vec<(Place, u32)> = Place::all().flat_map(taking).collect();
        let own = self.identifier(ends::rx_identifier(pdo));
        let identifier = match outputs.is_empty() {
            true => own?,
            false => own.or_else(|| Service::RxPdo(pdo, node).identifier())?,
        };
        let timeout_ms = self.number(ends::rx_timeout(pdo)).unwrap_or_default();
        let on_sync = self.number(ends::rx_function(pdo)) == Some(2);
        Some(Rx { number: pdo, identifier, on_sync, timeout_ms, outputs })
    }
}

/// The parameter of a section `[0384]` or `[0384sub0]`.
fn parameter(section: &str) -> Option<u32> {
    let index = section.strip_suffix("sub0").unwrap_or(section);
    let is_index = index.len() == 4 && index.bytes().all(|digit| digit.is_ascii_hexdigit());
    is_index.then(|| u32::from_str_radix(index, 16).ok()).flatten()
}

/// A number as CiA 306 has it: decimal, or `0x` and hex.
fn number(text: &str) -> Option<i64> {
    match text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")) {
        Some(digits) if digits.bytes().all(|digit| digit.is_ascii_hexdigit()) => i64::from_str_radix(digits, 16).ok(),
        Some(_) => None,
        None => text.parse().ok(),
    }
}
