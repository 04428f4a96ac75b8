//! A record of `monitor` as curves, states and moments.

use crate::drive::describe;
use crate::drive::motion::has_power;
use crate::failure::{Class, Failure};
use crate::files;
use crate::profile::{Family, Param, Registry, Role};
use crate::scope::{Mark, MarkKind, Part, Stretch};
use crate::text::{Text, both};
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::Path;

/// What a record holds of one drive.
#[derive(Debug, Default)]
pub(super) struct Track {
    /// Family.
    pub(super) drive: String,
    pub(super) columns: Vec<Column>,
    rows: Vec<Row>,
    pub(super) marks: Vec<Mark>,
}

/// A value that was recorded.
#[derive(Debug)]
pub(super) struct Column {
    /// Slug, with its data set: `fixed-frequency-1@2`.
    pub(super) key: String,
    pub(super) number: Option<u32>,
    pub(super) name: Text,
    pub(super) unit: String,
    pub(super) part: Part,
    pub(super) points: Vec<(f64, Option<f64>)>,
}

/// A round.
#[derive(Debug)]
struct Row {
    t: f64,
    /// When the last of its values was asked for; a table has one time for all of them.
    until: f64,
    /// Its number.
    n: Option<u64>,
    state: Option<(String, Text)>,
    /// The fault, where it was asked for.
    fault: Option<Text>,
    is_gap: bool,
}

impl Row {
    fn is_fault(&self) -> Option<bool> {
        self.state.as_ref().map(|state| state.0.starts_with("fault"))
    }

    fn follows_none(&self) -> bool {
        self.state.as_ref().is_some_and(|(slug, _)| slug.starts_with("fault") || has_power(slug) == Some(false))
    }

    /// Between two triggers nothing was kept.
    fn follows(&self, before: &Row) -> bool {
        before.n.zip(self.n).is_none_or(|(before, now)| now <= before + 1)
    }
}

/// The drives of a record, by address.
pub(super) fn read(path: &Path, registry: &Registry) -> Result<BTreeMap<u8, Track>, Failure> {
    let shown = path.display();
    let wrong = |why: Text| Failure::new(Class::Data, "data.record", both!("{shown}: {why}", "{shown}: {why}", why));
    let text = files::read(path, files::RECORDING).map_err(|error| wrong(error.text()))?;
    let mut reader = Reader { registry, tracks: BTreeMap::new(), roles: BTreeMap::new() };
    let read = if text.starts_with('{') { reader.ndjson(&text) } else { reader.csv(&text) };
    let expected = |line: usize| {
        wrong(both!(
            "line {line}: expected a record of `monitor` (--record, --format ndjson or csv)",
            "Zeile {line}: erwartet wird eine Aufzeichnung von `monitor` (--record, --format ndjson oder csv)"
        ))
    };
    read.map_err(expected)?;
    reader.tracks.values_mut().for_each(Track::note_faults);
    reader.tracks.values_mut().for_each(Track::break_up);
    reader.tracks.retain(|_, track| !track.rows.is_empty());
    if reader.tracks.is_empty() {
        return Err(wrong(both!("there is no sample in it", "es steht kein Messpunkt darin")));
    }
    Ok(reader.tracks)
}

/// A record on its way in.
struct Reader<'r> {
    registry: &'r Registry,
    tracks: BTreeMap<u8, Track>,
    /// What the parameters of the drives are to them.
    roles: BTreeMap<(u8, u64), String>,
}

impl Reader<'_> {
    /// One record a line; the error is the line that is none.
    fn ndjson(&mut self, text: &str) -> Result<(), usize> {
        for (index, line) in text.lines().enumerate() {
            let record: Value = serde_json::from_str(line).map_err(|_| index + 1)?;
            self.record(&record).ok_or(index + 1)?;
        }
        Ok(())
    }

    fn record(&mut self, record: &Value) -> Option<()> {
        let address = || u8::try_from(record["address"].as_u64()?).ok();
        match record["type"].as_str()? {
            "start" => {
                for drive in record["drives"].as_array()? {
                    let address = u8::try_from(drive["address"].as_u64()?).ok()?;
                    for column in drive["columns"].as_array()? {
                        if let (Some(param), Some(role)) = (column["param"].as_u64(), column["role"].as_str()) {
                            self.roles.insert((address, param), role.to_owned());
                        }
                    }
                }
            }
            "sample" => self.sample(address()?, record)?,
            "trigger" => self.mark(address()?, record, MarkKind::Trigger, Text::name(record["trigger"].as_str()?))?,
            "trip" => {
                let fault = record["fault"].as_object();
                let drive = self.tracks.get(&address()?).map(|track| track.drive.as_str()).unwrap_or_default();
                let code = record["fault"]["code"].as_u64().and_then(|code| u32::try_from(code).ok());
                let known =
                    self.registry.family(drive).zip(code).and_then(|(family, code)| describe::fault(&family, code));
                let told = fault.and_then(|fault| {
                    Some(format!("{} {}", fault.get("key")?.as_str()?, fault.get("name")?.as_str()?))
                });
                let told = known.map(|fault| fault.told()).or(told.map(Text::name));
                self.mark(address()?, record, MarkKind::Fault, told.unwrap_or_else(fault_word))?;
            }
            "run" if record["phase"] == "stopping" => {
                let how = record["stop"].as_str().unwrap_or("-");
                self.mark(address()?, record, MarkKind::Stop, both!("stop: {how}", "Halt: {how}"))?;
                self.tracks.entry(address()?).or_default().end_setpoint(record["t"].as_f64()?);
            }
            _ => {}
        }
        Some(())
    }

    fn mark(&mut self, address: u8, record: &Value, kind: MarkKind, text: Text) -> Option<()> {
        let t = record["t"].as_f64()?;
        self.tracks.entry(address).or_default().marks.push(Mark { t, kind, text });
        Some(())
    }

    fn sample(&mut self, address: u8, record: &Value) -> Option<()> {
        let drive = record["drive"].as_str()?;
        let family = self.registry.family(drive);
        let track = self.tracks.entry(address).or_default();
        track.drive = drive.to_owned();
        let state = record["state"]["slug"].as_str().map(|slug| {
            let printed = record["state"]["name"].as_str().unwrap_or(slug);
            (slug.to_owned(), state_name(family.as_deref(), slug, printed))
        });
        let values = record["values"].as_array()?;
        let is_unheard = |told: &Value| told["error"]["code"].as_str().is_some_and(is_gap);
        let (t, is_gap) = (record["t"].as_f64()?, is_unheard(record) || values.iter().any(is_unheard));
        let until = values.iter().filter_map(|value| value["t"].as_f64()).fold(t, f64::max);
        let fault = family.as_ref().and_then(|family| {
            let asked = family.role(Role::Fault)?.id;
            let value = values.iter().find(|value| value["param"].as_u64() == Some(asked.into()))?;
            told_fault(family, value["raw"].as_u64()?)
        });
        track.rows.push(Row { t, until, n: record["n"].as_u64(), state, fault, is_gap });
        for value in values {
            let (slug, set) = (value["slug"].as_str()?, value["data_set"].as_u64()?);
            let number = value["param"].as_u64()?;
            let key = if set > 0 { format!("{slug}@{set}") } else { slug.to_owned() };
            let role = self.roles.get(&(address, number)).map(String::as_str);
            let param = family.as_ref().and_then(|family| family.param(u32::try_from(number).ok()?));
            let column = track.column(&key, || Column {
                key: key.clone(),
                number: u32::try_from(number).ok(),
                name: name(param, value["name"].as_str().unwrap_or(slug), set),
                unit: value["unit"].as_str().unwrap_or_default().to_owned(),
                part: role.map_or(Part::Other, part),
                points: Vec::new(),
            });
            column.points.push((value["t"].as_f64()?, value["value"].as_f64()));
        }
        Some(())
    }

    /// A row a sample, under a head line; the error is the line that is none.
    fn csv(&mut self, text: &str) -> Result<(), usize> {
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let head: Vec<String> = reader.headers().map_err(|_| 1usize)?.iter().map(str::to_owned).collect();
        if head.get(..5).is_none_or(|first| *first != ["t", "n", "address", "drive", "state"]) {
            return Err(1);
        }
        for (index, row) in reader.records().enumerate() {
            let row = row.map_err(|_| index + 2)?;
            self.row(&head, &row).ok_or(index + 2)?;
        }
        Ok(())
    }

    fn row(&mut self, head: &[String], row: &csv::StringRecord) -> Option<()> {
        // Behind it may stand a node, and then it stands behind all of them.
        let number = |address: &str| address.split('.').next()?.parse().ok();
        let cell = |name: &str| row.get(head.iter().position(|head| head == name)?).filter(|cell| !cell.is_empty());
        let (t, address, drive) = (cell("t")?.parse().ok()?, number(cell("address")?)?, cell("drive")?);
        let family = self.registry.family(drive);
        let track = self.tracks.entry(address).or_default();
        track.drive = drive.to_owned();
        let slug = cell("state");
        let state = slug.map(|slug| (slug.to_owned(), state_name(family.as_deref(), slug, slug)));
        let values = head.iter().zip(row).skip(5).filter(|(key, _)| !["error", "trigger"].contains(&key.as_str()));
        let is_gap = cell("error").is_some_and(is_gap);
        if let Some(trigger) = cell("trigger") {
            track.marks.push(Mark { t, kind: MarkKind::Trigger, text: Text::name(trigger) });
        }
        let fault = family.as_ref().and_then(|family| {
            let cell = cell(&family.role(Role::Fault)?.slug)?;
            told_fault(family, cell.strip_prefix("0x").map_or(cell.parse(), |hex| u64::from_str_radix(hex, 16)).ok()?)
        });
        track.rows.push(Row { t, until: t, n: cell("n").and_then(|n| n.parse().ok()), state, fault, is_gap });
        // A raw value is none in its unit, and names of bits are none at all.
        for (key, cell) in values.filter(|(key, _)| !key.ends_with(".raw") && !key.ends_with("_bits")) {
            let (slug, set) =
                key.split_once('@').map_or((key.as_str(), 0), |(slug, set)| (slug, set.parse().unwrap_or(0)));
            // Two families that call different parameters the same have their numbers in the heading.
            let is_it = |param: &&Param| {
                let rest = slug.strip_prefix(param.slug.as_str());
                rest.is_some_and(|rest| rest.is_empty() || rest.strip_prefix('.') == Some(&param.id.to_string()))
            };
            let param = family.as_ref().and_then(|family| family.params.values().find(is_it));
            if param.is_some_and(|param| !param.has_scale() || param.bits.is_some()) {
                continue;
            }
            let role = param.zip(family.as_ref()).and_then(|(param, family)| role_of(param, family));
            let column = track.column(key, || Column {
                key: key.clone(),
                number: param.map(|param| param.id),
                name: name(param, slug, set),
                unit: param.and_then(|param| param.unit.clone()).unwrap_or_default(),
                part: role.map_or(Part::Other, part),
                points: Vec::new(),
            });
            column.points.push((t, cell.parse().ok()));
        }
        Some(())
    }
}

impl Track {
    /// The column with this key; a new one if there is none.
    fn column(&mut self, key: &str, new: impl FnOnce() -> Column) -> &mut Column {
        let at = self.columns.iter().position(|column| column.key == key).unwrap_or_else(|| {
            self.columns.push(new());
            self.columns.len() - 1
        });
        &mut self.columns[at]
    }

    /// From a stop on there is no setpoint that the drive follows, whatever it was told before.
    fn end_setpoint(&mut self, t: f64) {
        for column in self.columns.iter_mut().filter(|column| column.part == Part::Setpoint) {
            column.points.push((t, None));
        }
    }

    /// A fault that the states show and that no record of its own tells: a held run ends at it.
    fn note_faults(&mut self) {
        let (mut before, mut since) = (None, 0.0);
        for (index, row) in self.rows.iter().enumerate() {
            let now = row.is_fault();
            let is_told = self.marks.iter().any(|mark| mark.kind == MarkKind::Fault && mark.t >= since);
            if before == Some(false) && now == Some(true) && !is_told {
                let at = self.marks.iter().position(|mark| mark.t >= row.t).unwrap_or(self.marks.len());
                // It may have been asked for in a round behind the one that shows it.
                let lasts = self.rows.iter().skip(index).take_while(|row| row.is_fault() != Some(false));
                let text = lasts.filter_map(|row| row.fault.clone()).next().unwrap_or_else(fault_word);
                self.marks.insert(at, Mark { t: row.t, kind: MarkKind::Fault, text });
            }
            before = now.or(before);
            if now == Some(false) {
                since = row.t;
            }
        }
    }

    /// The last round before a time of which nothing was kept, and the first one behind it.
    fn holes(&self) -> impl Iterator<Item = (&Row, &Row)> {
        self.rows.windows(2).filter_map(|pair| match pair {
            [one, next] if !next.follows(one) => Some((one, next)),
            _ => None,
        })
    }

    /// No line goes over such a time.
    fn break_up(&mut self) {
        let ends: Vec<f64> = self.holes().map(|(_, next)| next.t).collect();
        for end in ends {
            for column in &mut self.columns {
                let at = column.points.partition_point(|point| point.0 < end);
                column.points.insert(at, (end, None));
            }
        }
    }

    /// Over these times nobody can tell how the drive followed its setpoint: nothing was kept, several rounds were not answered, or
    /// it followed none, in a fault or without power, which may show in the values of a round whose state does not show it yet. They
    /// begin behind the last value that counts, and end a round before the power shows: a state that was read before it came stands
    /// beside values that were read behind it.
    pub(super) fn breaks(&self) -> Vec<(f64, f64)> {
        let mut breaks: Vec<_> = self.holes().map(|(one, next)| (one.until, next.t)).collect();
        let mut ends = |ends: &dyn Fn(&Row) -> bool, least: usize, doubted: bool| {
            let (mut last, mut count, first) = (None, 0, self.rows.first().map_or(0.0, |row| row.t));
            for (index, row) in self.rows.iter().enumerate() {
                count = if ends(row) { count + 1 } else { 0 };
                let before = || index.checked_sub(1).and_then(|before| self.rows.get(before)).map(|row| row.until);
                match (count, last) {
                    (0, _) if doubted => last = before().or(Some(row.t)),
                    (0, _) => last = Some(row.until),
                    // The round before may still show what a coast did to the setpoint, the first of a record does not.
                    (count, from)
                        if doubted && self.is_next(index, ends) && count > 1 + usize::from(from.is_some()) => {}
                    (count, from) if count >= least => breaks.push((from.unwrap_or(first), row.t)),
                    _ => {}
                }
            }
        };
        ends(&|row| row.is_gap, 3, false);
        ends(&Row::follows_none, 1, true);
        breaks
    }

    /// Whether a round is the last of its kind, kept between two others.
    fn is_next(&self, index: usize, ends: &dyn Fn(&Row) -> bool) -> bool {
        let before = index.checked_sub(1).and_then(|before| self.rows.get(before));
        let (Some(before), Some(row), Some(next)) = (before, self.rows.get(index), self.rows.get(index + 1)) else {
            return false;
        };
        !ends(next) && !next.is_gap && next.follows(row) && row.follows(before)
    }

    /// When the drive got power: from the last moment of which nothing is measured (`breaks`), to the end of the round that shows it.
    pub(super) fn starts(&self, breaks: &[(f64, f64)]) -> Vec<(f64, f64)> {
        let begins =
            |off: &Row| breaks.iter().map(|found| found.1).filter(|end| *end <= off.t).fold(off.t.min(0.0), f64::max);
        let starts = self.rows.windows(2).filter_map(|pair| match pair {
            [off, on] if off.follows_none() && on.state.is_some() && !on.follows_none() => {
                Some((begins(off), on.until))
            }
            _ => None,
        });
        starts.collect()
    }

    /// From its first moment to its last one.
    pub(super) fn ends(&self) -> (f64, f64) {
        let times = || self.columns.iter().flat_map(|column| column.points.iter().map(|point| point.0));
        let first = self.rows.first().map_or(0.0, |row| row.t);
        (first, times().chain(self.rows.iter().map(|row| row.t)).fold(first, f64::max))
    }

    /// Whether the drive's state, or the end of a run, stands in it.
    pub(super) fn has_state(&self) -> bool {
        self.rows.iter().any(|row| row.state.is_some()) || self.marks.iter().any(|mark| mark.kind == MarkKind::Stop)
    }

    /// How long each state was seen.
    pub(super) fn states(&self) -> Vec<Stretch> {
        let mut states: Vec<Stretch> = Vec::new();
        let mut now: Option<&str> = None;
        let before = [None].into_iter().chain(self.rows.iter().map(Some));
        for (before, row) in before.zip(&self.rows) {
            now = now.filter(|_| before.is_none_or(|before| row.follows(before)));
            let state = row.state.as_ref();
            // In a round that was not answered nobody knows whether it still was so.
            if let Some(last) = states.last_mut().filter(|_| now.is_some() && (state.is_some() || !row.is_gap)) {
                last.to = row.t;
            }
            if let Some((slug, name)) = state.filter(|(slug, _)| now != Some(slug)) {
                let is_fault = slug.starts_with("fault");
                states.push(Stretch { from: row.t, to: row.t, name: name.clone(), is_fault });
            }
            now = state.map(|(slug, _)| slug.as_str());
        }
        if let Some(last) = states.last_mut().filter(|_| now.is_some()) {
            last.to = self.ends().1;
        }
        states
    }

    /// From the last round before a gap to the first one behind it, whether nothing was answered or nothing was kept.
    pub(super) fn gaps(&self) -> Vec<(f64, f64)> {
        let mut gaps: Vec<(f64, f64)> = Vec::new();
        let (mut last, mut open) = (None, false);
        for Row { t, is_gap, .. } in &self.rows {
            if let Some(gap) = gaps.last_mut().filter(|_| open) {
                gap.1 = *t;
            }
            if *is_gap && !open {
                gaps.push((last.unwrap_or(*t), *t));
            }
            open = *is_gap;
            last = Some(*t);
        }
        gaps.extend(self.holes().map(|(one, next)| (one.t, next.t)));
        gaps.sort_by(|one, other| one.0.total_cmp(&other.0));
        gaps
    }
}

/// Whether an error tells that something was not answered; a refusal is an answer.
fn is_gap(code: &str) -> bool {
    ["silence", "garbled", "port"].iter().any(|class| code.starts_with(class))
}

/// What a parameter is to a drive.
fn part(role: &str) -> Part {
    match role {
        "setpoint-ramp" | "setpoint-bus" | "setpoint-velocity" => Part::Setpoint,
        "actual-frequency" | "stator-frequency" | "encoder-frequency" | "actual-speed" | "position" => Part::Actual,
        "current" => Part::Current,
        _ => Part::Other,
    }
}

const ROLES: [&str; 9] = [
    "setpoint-ramp",
    "setpoint-bus",
    "actual-frequency",
    "stator-frequency",
    "encoder-frequency",
    "actual-speed",
    "current",
    "setpoint-velocity",
    "position",
];

fn role_of(param: &Param, family: &Family) -> Option<&'static str> {
    ROLES.into_iter().find(|role| family.role(role).is_some_and(|known| known.id == param.id))
}

/// The name that the catalogue has in both languages, else the one that stands in the record.
fn name(param: Option<&Param>, printed: &str, set: u64) -> Text {
    let name = param.map_or_else(|| Text::name(printed), |param| param.name.clone());
    if set > 0 { both!("{name} @{set}", "{name} @{set}", name) } else { name }
}

fn state_name(family: Option<&Family>, slug: &str, printed: &str) -> Text {
    let known = family.and_then(|family| family.states.iter().find(|state| state.slug == slug));
    known.map_or_else(|| Text::name(printed), |state| Text { en: state.en.clone().into(), de: state.de.clone().into() })
}

fn told_fault(family: &Family, code: u64) -> Option<Text> {
    describe::fault(family, u32::try_from(code).ok()?).map(|fault| fault.told())
}

fn fault_word() -> Text {
    both!("fault", "Störung")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A question that nobody answers takes its time: the state is known up to the last answer before it, and no longer.
    #[test]
    fn the_band_of_a_state_ends_before_a_gap() {
        let rows = [(9.0, "operation-enabled", ""), (9.7, "operation-enabled", ""), (11.6, "", "silence.no_reply")];
        let rows = rows.into_iter().chain([(13.2, "operation-enabled", ""), (14.0, "operation-enabled", "")]);
        let rows = rows.map(|(t, state, error)| format!("{t},0,1,act,{state},{error}\n"));
        let directory = tempfile::tempdir().unwrap();
        let file = directory.path().join("record.csv");
        std::fs::write(&file, "t,n,address,drive,state,error\n".to_owned() + &rows.collect::<String>()).unwrap();
        let tracks = read(&file, &Registry::open(&[]).unwrap()).unwrap();
        let track = tracks.values().next().unwrap();
        let bands: Vec<_> = track.states().iter().map(|band| (band.from, band.to)).collect();
        assert_eq!((bands, track.gaps()), (vec![(9.0, 9.7), (13.2, 14.0)], vec![(9.7, 13.2)]));
    }
}
