//! `systembus check` and `systembus apply`: the drives of a plan, each where it is reached, with all that the plan decides of it.

use super::plan;
use crate::args::{Place, Settings, check_node, in_directory, parse_place, place};
use crate::command::dataset::opened::Opened;
use crate::command::plant::lines::{Said, Wanted, by_line};
use crate::command::{Context, named_family, on_bus};
use crate::drive::plant::Line;
use crate::drive::transaction::{Choice, UndoPlace};
use crate::drive::{Port, Reader, Session, Target, Upper, cut_by, open_port};
use crate::failure::{Class, Failure};
use crate::profile::paramfile::{At, Setting, Settings as Values};
use crate::profile::{DataSets, Family, Type};
use crate::systembus::{self, Drive, Level, Numbering, Plan, Standing};
use crate::text::{Text, both};
use clap::Args as ClapArgs;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::rc::Rc;

/// A plan, and which of its drives are meant.
#[derive(Clone, Debug, ClapArgs)]
pub(super) struct Options {
    /// The plan (TOML)
    #[arg(value_name = "FILE")]
    pub(super) file: PathBuf,
    /// Drives of the plan, all of them if none: NAME, or NAME=ADDRESS
    ///
    /// Over VABus 3.17 is node 17 behind drive 3. Without an address a drive is reached as `antrieb.toml` says of its name; on a CAN bus at its node.
    #[arg(value_name = "DRIVE")]
    drives: Vec<String>,
}

/// The drives that are meant, with what they shall have.
pub(super) struct Seated {
    plan: Plan,
    family: Rc<Family>,
    places: Vec<(usize, Place)>,
}

impl Options {
    /// Reads the plan, which must break no rule, and finds where its drives are reached. Nothing is opened.
    pub(super) fn seated(&self, context: &mut Context<'_>) -> Result<Seated, Failure> {
        let settings = context.settings;
        if settings.typed.names_address() {
            return Err(address_elsewhere());
        }
        let name = settings.drive.as_deref().unwrap_or(plan::CUBE);
        let family = named_family(settings, context.registry, name)?;
        let plan = plan::read(std::slice::from_ref(&self.file))?;
        let remarks = systembus::check(&plan, &family);
        if let Some(first) = remarks.iter().find(|remark| remark.level == Level::Error) {
            return Err(broken(&self.file, &first.text));
        }
        let mut port: Option<Port> = None;
        let mut places = Vec::new();
        for (index, address) in self.meant(&plan)? {
            let Some(drive) = plan.drives.get(index) else { continue };
            let (address, node) = address.map_or((None, 0), |(address, node)| (Some(address), node));
            check_node(node, settings.protocol)?;
            let found = match address {
                None if !settings.is_can() => Some(place(settings, &drive.name)?.ok_or_else(|| nowhere(drive))?),
                _ => None,
            };
            let on_bus = settings.is_can().then(|| drive.station());
            let mut found = found.unwrap_or_else(|| Place {
                name: drive.name.clone(),
                address: address.or(on_bus).unwrap_or_default(),
                product: None,
                files: Vec::new(),
                settings: Settings { node, ..settings.clone() },
            });
            if found.settings.port.is_none() {
                let port = port.take().map_or_else(|| open_port(None, context.observe), Ok)?;
                found.settings = Settings { port: Some(port.clone()), ports: vec![port], ..found.settings };
            }
            port.clone_from(&found.settings.port);
            found.settings.check_one_line()?;
            found.files = vec![self.file.clone()];
            places.push((index, found));
        }
        Ok(Seated { plan, family, places })
    }

    /// Which drives of the plan, and at which address if that was said.
    fn meant(&self, plan: &Plan) -> Result<Vec<Meant>, Failure> {
        if self.drives.is_empty() {
            return Ok((0..plan.drives.len()).map(|index| (index, None)).collect());
        }
        let mut meant: Vec<Meant> = Vec::new();
        for word in &self.drives {
            let (name, address) = word.split_once('=').map_or((word.as_str(), None), |(name, at)| (name, Some(at)));
            let index = plan.drives.iter().position(|drive| drive.name == name).ok_or_else(|| stranger(name, plan))?;
            let address = address.map(parse_place);
            if address == Some(None) || meant.iter().any(|row| row.0 == index) {
                return Err(no_address(word));
            }
            meant.push((index, address.flatten()));
        }
        Ok(meant)
    }
}

/// A drive of the plan, and at which address, and behind it which node, if that was said.
type Meant = (usize, Option<(u8, u8)>);

impl Seated {
    /// The same on open lines: what a drive shows decides what nobody else knows. `writes` is whether it is to be written.
    pub(super) async fn settled(
        mut self,
        lines: &mut [Line<'_>],
        settings: &Settings,
        writes: bool,
    ) -> Result<Vec<Wanted>, Failure> {
        let mut unsettled = BTreeMap::new();
        for line in lines {
            let Some(session) = &mut line.session else { continue };
            for member in &line.members {
                session.allow(session.now(), QUESTIONS.questions(LOOKED.len() as u64));
                let Ok(seen) = member.identify(session).await else { continue };
                let found = look(session, seen.target).await;
                let Some(drive) = self.plan.drives.iter_mut().find(|drive| drive.name == member.name) else { continue };
                let why = settle(drive, &found);
                let own = if writes { cut_by(settings.protocol) } else { &[] };
                let why = why.or_else(|| cuts(&self.plan, &member.name, &found, own));
                unsettled.extend(why.map(|why| (member.name.clone(), why)));
            }
        }
        let mut wanted = self.listed(settings)?;
        for one in &mut wanted {
            one.unsettled = unsettled.remove(&one.place.name);
        }
        Ok(wanted)
    }

    /// What each drive shall have, as far as that is known without asking.
    pub(super) fn listed(&self, settings: &Settings) -> Result<Vec<Wanted>, Failure> {
        let file = self.places.first().and_then(|(_, place)| place.files.first()).cloned().unwrap_or_default();
        let path = file.display().to_string();
        let mut list = Vec::new();
        for (index, place) in &self.places {
            let Some(drive) = self.plan.drives.get(*index) else { continue };
            let values = values(&self.plan, drive, &self.family, (&path, settings.is_can()));
            // Settings of a bus go into a drive only if they are named.
            let only = values.iter().map(|one| one.param.id.to_string()).collect();
            let choice = Choice { only, families: vec![self.family.clone()], ..Choice::everything() };
            let opened = Opened::planned(&path, self.family.clone(), values, settings.lang);
            let (steps, left_out) = choice.steps(&opened.settings, &opened.family)?;
            let (place, said) = (place.clone(), Said::Plan(path.clone()));
            let undo = UndoPlace::Beside(beside(&in_directory(settings, &file), &drive.name));
            list.push(Wanted { place, said, opened, steps, left_out, undo, unsettled: None });
        }
        by_line(settings, &mut list)?;
        Ok(list)
    }
}

/// What the plan decides of a drive, as a file would hold it.
fn values(plan: &Plan, drive: &Drive, family: &Family, (path, is_can): (&str, bool)) -> Values {
    let mut values = Values::default();
    for setting in systembus::settings(plan, drive) {
        let Some(raw) = setting.value else { continue };
        let param = family.param_or_unknown(setting.param);
        // A drive that is written to over SDO takes what it needs of four bytes (manual 5.10.1), and no source has more than two.
        let kind = param.kind.or(is_can.then_some(Type::Uint));
        let at = At { path: path.into(), line: 0, column: 0 };
        values.insert(Setting { param, set: 0, raw, kind, at });
    }
    values
}

/// `bus-pump.toml` beside `bus.toml`.
fn beside(file: &Path, name: &str) -> PathBuf {
    let stem = file.file_stem().unwrap_or_default().to_string_lossy();
    let is_plain = |letter: char| letter.is_alphanumeric() || matches!(letter, '-' | '_' | ' ');
    let name: String = name.chars().map(|letter| if is_plain(letter) { letter } else { '_' }).collect();
    file.with_file_name(format!("{stem}-{name}.toml"))
}

/// What is looked at before anything else: the place on the bus, and how the functions of RxPDOs are counted.
const LOOKED: [u32; 8] = [900, 903, 921, 922, 923, 936, 937, 938];
const QUESTIONS: Upper = Upper::drive(30).each(12, "parameter");

async fn look(session: &mut Session<'_>, mut target: Target) -> BTreeMap<u32, i64> {
    let family = target.family.clone();
    let mut reader = Reader::new(session, &mut target);
    reader.lenient = true;
    let mut found = BTreeMap::new();
    for id in LOOKED {
        let rows = reader.rows(&family.param_or_unknown(id), DataSets::Unnamed).await.unwrap_or_default();
        found.extend(rows.into_iter().filter_map(|row| Some((id, row.raw?))));
    }
    found
}

/// Takes over how a drive counts the functions of its RxPDOs; why that does not do.
fn settle(drive: &mut Drive, found: &BTreeMap<u32, i64>) -> Option<Failure> {
    if found.is_empty() {
        return None;
    }
    match (drive.numbering, Standing::new(found).numbering()) {
        (Some(Numbering::FromTime), Some(Numbering::FromOff)) => Some(contradicts(drive)),
        (None, None) => (!drive.rx.is_empty()).then(|| uncounted(drive)),
        (said, shown) => {
            drive.numbering = said.or(shown);
            None
        }
    }
}

/// Why its place on the bus cannot be changed over that bus, if the plan would.
fn cuts(plan: &Plan, name: &str, found: &BTreeMap<u32, i64>, own: &[u32]) -> Option<Failure> {
    let drive = plan.drives.iter().find(|drive| drive.name == name)?;
    let settings = systembus::settings(plan, drive);
    let is_other = |param: u32, value: i64| found.get(&param).is_some_and(|stands| *stands != value);
    let differs = |one: &&systembus::Setting| one.value.is_some_and(|value| is_other(one.param, value));
    let own = settings.iter().filter(|one| own.contains(&one.param)).find(differs)?;
    Some(on_bus::own_line(own.param, &format!("P.{}", own.param)))
}

fn uncounted(drive: &Drive) -> Failure {
    let name = &drive.name;
    let message = both!(
        "{name} does not show how it counts the functions of its RxPDOs (P.936 to P.938), and the plan does not say: 1 is SYNC in one \
         numbering and time in the other",
        "{name} zeigt nicht, wie er die Funktionen seiner RxPDOs zählt (P.936 bis P.938), und der Plan sagt es nicht: 1 ist in der einen \
         Zählung SYNC und in der anderen die Zeit"
    );
    Failure::new(Class::Forbidden, "forbidden.rx_functions", message).hint(both!(
        "rx-functions = \"0-2\" in [drives.{name}] if its keypad offers \"off\" for P.936, \"0-1\" if not",
        "rx-functions = \"0-2\" in [drives.{name}], wenn die Bedieneinheit zu P.936 \"aus\" anbietet, sonst \"0-1\""
    ))
}

fn contradicts(drive: &Drive) -> Failure {
    let name = &drive.name;
    let message = both!(
        "{name} counts the functions of its RxPDOs from 0 to 2, because a 2 stands there; the plan says 0-1",
        "{name} zählt die Funktionen seiner RxPDOs von 0 bis 2, denn dort steht eine 2; der Plan sagt 0-1"
    );
    Failure::new(Class::Forbidden, "forbidden.rx_functions", message)
        .hint(both!("rx-functions = \"0-2\" in [drives.{name}]", "rx-functions = \"0-2\" in [drives.{name}]"))
}

fn broken(file: &Path, why: &Text) -> Failure {
    let path = file.display();
    let message = both!("{path} breaks a rule: {why}", "{path} verletzt eine Regel: {why}", why);
    Failure::new(Class::Data, "data.plan", message).hint(both!(
        "nothing was sent; `antrieb systembus plan` shows all that is wrong with it",
        "es wurde nichts gesendet; `antrieb systembus plan` zeigt alles, was daran nicht stimmt"
    ))
}

fn address_elsewhere() -> Failure {
    let message = both!(
        "the plan says which drives are meant; expected no -a",
        "der Plan sagt, welche Antriebe gemeint sind; erwartet: kein -a"
    );
    Failure::new(Class::Usage, "usage.address", message).hint(both!(
        "the address of a drive stands behind its name: drive-1=3",
        "die Adresse eines Antriebs steht hinter seinem Namen: antrieb-1=3"
    ))
}

fn nowhere(drive: &Drive) -> Failure {
    let name = &drive.name;
    let message = both!(
        "where is {name} reached? No project file has a drive of this name",
        "wo ist {name} zu erreichen? Keine Projektdatei hat einen Antrieb dieses Namens"
    );
    Failure::new(Class::Usage, "usage.address", message).hint(both!(
        "name its address behind the plan, such as {name}=1, or say it in antrieb.toml: [drives.{name}]",
        "seine Adresse hinter dem Plan nennen, etwa {name}=1, oder sie in antrieb.toml sagen: [drives.{name}]"
    ))
}

fn stranger(name: &str, plan: &Plan) -> Failure {
    let known = plan.drives.iter().map(|drive| drive.name.as_str()).collect::<Vec<_>>().join(", ");
    let message = both!(
        "expected drives of the plan ({known}), got '{name}'",
        "erwartet: Antriebe des Plans ({known}); angegeben: '{name}'"
    );
    Failure::new(Class::Usage, "usage.address", message)
}

fn no_address(word: &str) -> Failure {
    let message = both!(
        "expected each drive once, as NAME or NAME=ADDRESS with an address from 1 to 247, or 3.17 for a node behind a drive, got '{word}'",
        "erwartet: jeder Antrieb einmal, als NAME oder NAME=ADRESSE mit einer Adresse von 1 bis 247, oder 3.17 für einen Knoten hinter einem Antrieb; angegeben: '{word}'"
    );
    Failure::new(Class::Usage, "usage.address", message)
}
