//! The trial of transactions: random files into drives, and every way in which that can end, at every telegram. Afterwards the
//! bench itself is asked: is the drive as it was wanted, or as it was before, or was every differing value named; and did the
//! EEPROM bear no more than was announced?

use super::ends::{Case, End, Seen};
use antrieb::outcome::{LoadEnd, WriteResult};
use antrieb::profile::{Family, Goes, Param, Registry, Sets, value};
use antrieb::simulator::{Bench, Drive};
use antrieb::tick::Span;
use antrieb::transport::witness;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

pub(super) const ENDS: &[End] = &[
    End::Wish,
    End::Twice,
    End::Pulled,
    End::Power,
    End::Silent(700),
    End::Silent(4_000),
    End::Silent(60_000),
    End::Refuses,
    End::Killed,
];

const CASES: &[Case] = &[
    Case { model: "act", keys: "", options: "", ram: false },
    Case { model: "acu", keys: "modules = [\"EM-RES-03\"]", options: "", ram: false },
    Case { model: "act", keys: "", options: "", ram: true },
    Case {
        model: "acu",
        keys: "modules = [\"EM-RES-03\"]\nprotocol = \"ascii\"",
        options: "--protocol ascii",
        ram: false,
    },
    Case { model: "act", keys: "protocol = \"vabus\"", options: "--protocol vabus", ram: false },
    Case {
        model: "acu",
        keys: "modules = [\"EM-RES-03\"]\nprotocol = \"vabus\"",
        options: "--protocol vabus",
        ram: true,
    },
    Case { model: "lxm05", keys: "", options: "", ram: false },
    Case { model: "act", keys: OTHER_RAM, options: "", ram: false },
    Case { model: "act", keys: "readings = { ram_reads = \"refused\" }", options: "", ram: false },
];

/// Somebody has written to the RAM what is not stored.
const OTHER_RAM: &str = "set = { \"30\" = 110, \"372@2ram\" = 1450, \"480@1ram\" = 7, \"424@3ram\" = 60, \"412@4ram\" = 1, \
                         \"392@1\" = 1, \"392@1ram\" = 0, \"434@2ram\" = 1 }";

/// A dice of our own: every trial is the same.
struct Dice(u64);

impl Dice {
    fn roll(&mut self, sides: u64) -> u64 {
        // Knuth, MMIX.
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % sides
    }
}

/// A file with so many random values for a drive, and what it wants, by number and data set.
fn random_file(family: &Family, fresh: &Drive, dice: &mut Dice, count: usize) -> (String, Vec<(u32, u8)>) {
    let fitted = |param: &Param| param.module.is_none() || family.drive == "acu";
    let brings = |param: &Param| family.files.goes(param) == Goes::Always && fitted(param);
    let goes = |id: &u32| family.param(*id).is_some_and(brings);
    let known: Vec<u32> = family.params.keys().copied().filter(goes).collect();
    let mut text = format!("antrieb = 1\n[drive]\nfamily = \"{}\"\n[values]\n", family.drive);
    let mut lines: BTreeMap<(u32, u8), i64> = BTreeMap::new();
    if family.param(30).is_some() && dice.roll(2) == 0 {
        lines.insert((30, 0), [110, 210, 410][dice.roll(3) as usize]);
    }
    let differs = |id: &u32| (1..=4).any(|set| fresh.ram(*id, set) != fresh.eeprom(*id, set));
    for id in [372, 480, 424, 412, 392].into_iter().filter(differs) {
        lines.insert((id, 0), if id == 392 { 2 } else { 2 + i64::try_from(dice.roll(9)).unwrap() });
    }
    for _ in 0..count {
        let param = family.param(known[dice.roll(known.len() as u64) as usize]).unwrap();
        let (low, high) = (param.min.unwrap_or(0), param.max.unwrap_or(200));
        // What the bench takes: 16 bits, where no source tells the width, and no power of 0.
        let (low, high) = (low.max(-999).max(i64::from(param.id == 376)), high.min(9_999));
        let raw = low + i64::try_from(dice.roll(u64::try_from(high - low + 1).unwrap())).unwrap();
        let raw = if param.id == 375 { raw.max(1_000) } else { raw };
        // 1 is taken by some configurations only.
        let raw = if param.id == 392 { [0, 2][dice.roll(2) as usize] } else { raw };
        let raw = match (family.drive.as_str(), param.id) {
            ("lxm05", 1_284) => 1,
            // Its ranges stand in no source; near to what the bench has it takes everything.
            ("lxm05", id) => {
                let (stands, by) = (fresh.ram(id, 0).unwrap(), 1 + i64::try_from(dice.roll(9)).unwrap());
                if stands > 9_999 { stands - by } else { stands + by }
            }
            _ => raw,
        };
        let set = if param.sets == Some(Sets::Four) { dice.roll(5) as u8 } else { 0 };
        lines.insert((param.id, set), raw);
    }
    for (&(id, set), &raw) in &lines {
        let param = family.param(id).unwrap();
        let key = if set == 0 { id.to_string() } else { format!("{id}@{set}") };
        match param.unit.is_some() && !param.has_scale() {
            true => writeln!(text, "\"{key}\" = \"raw {raw}\"").unwrap(),
            false => {
                writeln!(text, "\"{key}\" = \"{}\"", value::format_decimal(raw, param.decimals_or_zero())).unwrap();
            }
        }
    }
    (text, lines.into_keys().collect())
}

/// Cells of a drive: what stands at each number and data set as on the wire.
pub(super) type Cells = BTreeMap<(u32, u8), i64>;

/// Every cell of the only drive.
fn cells(bench: &Bench, family: &Family) -> Cells {
    cells_of(bench.drives().next().unwrap(), family)
}

/// Every cell of a drive that a file can reach.
pub(super) fn cells_of(drive: &Drive, family: &Family) -> Cells {
    let settings = family.params.values().filter(|param| family.files.goes(param) <= Goes::IfAsked);
    let mut cells = BTreeMap::new();
    for param in settings {
        let sets = if param.sets == Some(Sets::Four) { 1..=4 } else { 0..=0 };
        for set in sets {
            cells.extend(drive.eeprom(param.id, set).map(|raw| ((param.id, set), raw)));
            cells.extend(drive.ram(param.id, set).map(|raw| ((param.id, set + 5), raw)));
        }
    }
    cells
}

/// Cells that differ.
pub(super) fn differing(one: &Cells, other: &Cells) -> Vec<(u32, u8)> {
    one.iter().filter(|(cell, raw)| other.get(cell) != Some(raw)).map(|(cell, _)| *cell).collect()
}

struct Trial<'t> {
    case: Case,
    registry: &'t Registry,
    family: &'t Family,
    file: String,
    wanted: Vec<(u32, u8)>,
    before: Cells,
    after: Cells,
    most: u64,
    sins: Vec<String>,
}

impl Trial<'_> {
    fn at(&mut self, end: End, step: usize) {
        let dir = tempfile::tempdir().unwrap();
        let victim = self.wanted[step % self.wanted.len()];
        std::fs::write(dir.path().join("bench.toml"), self.case.bench(end, step, victim)).unwrap();
        std::fs::write(dir.path().join("f.toml"), &self.file).unwrap();
        let words = if self.case.ram { "load {dir}/f.toml --ram" } else { "load {dir}/f.toml" };
        let seen = self.case.run(self.registry, dir.path(), words, end, step);
        let mut found = self.judge(&seen);
        let undo = dir.path().join("f.undo.toml");
        let now = cells(&seen.bench, self.family);
        let unlike = differing(&self.before, &now);
        if seen.killed && !unlike.is_empty() && !undo.exists() {
            found.push(format!("killed, and no undo file: {unlike:?}"));
        }
        if undo.exists() && (seen.killed || seen.failure.is_some()) {
            found.extend(self.take_back(dir.path(), seen));
        }
        let name = format!("{} {} ram {}", self.case.model, self.case.keys, self.case.ram);
        self.sins.extend(found.into_iter().map(|sin| format!("{name}: {end:?} at {step}: {sin}")));
    }

    /// What is wrong with how a load ended.
    fn judge(&self, seen: &Seen) -> Vec<String> {
        let mut sins = Vec::new();
        let now = cells(&seen.bench, self.family);
        let worn = seen.bench.totals().eeprom_writes;
        if worn > self.most {
            sins.push(format!("EEPROM written {worn} times, announced were {}", self.most));
        }
        if !seen.bench.remarks().is_empty() {
            sins.push(format!("remarks: {:?}", seen.bench.remarks().first().map(ToString::to_string)));
        }
        if seen.killed {
            return sins;
        }
        let ended = seen.load.as_ref().and_then(|load| load.ended);
        if seen.failure.is_none() {
            let unlike = differing(&self.after, &now);
            if !unlike.is_empty() || ended != Some(LoadEnd::Done) {
                sins.push(format!(
                    "said to be done ({ended:?}), but differs: {unlike:?}; {} sent, {:?}",
                    seen.sent, seen.at
                ));
            }
            return sins;
        }
        let exit = seen.failure.as_ref().map_or(0, |failure| failure.class.exit());
        let unlike = differing(&self.before, &now);
        for row in seen.load.iter().flat_map(|load| &load.values) {
            // A row names a value as it was before; only what may not be so says otherwise.
            let says_before = matches!(row.result, WriteResult::Restored | WriteResult::Unchanged);
            let cell = (row.param, row.data_set + if row.store == "ram" { 5 } else { 0 });
            if says_before && unlike.contains(&cell) {
                sins.push(format!("P.{}@{} is said to be {:?}, but is not as before", cell.0, cell.1, row.result));
            }
        }
        let named = |cell: &(u32, u8)| {
            let rows = seen.load.iter().flat_map(|load| &load.values);
            let row = rows.filter(|row| row.result == WriteResult::Unrestored).any(|row| row.param == cell.0);
            row || seen.warnings.contains(&format!("P.{}@", cell.0))
                || seen.warnings.contains(&format!("({})@", cell.0))
        };
        match ended {
            Some(LoadEnd::Torn) if unlike.iter().all(named) && exit == 9 => {}
            Some(LoadEnd::Back) if unlike.is_empty() && exit == 9 => {}
            Some(LoadEnd::Untouched) | None if unlike.is_empty() => {}
            _ => {
                let why = seen.failure.as_ref().map(|failure| failure.message.en.to_string());
                sins.push(format!("ended {ended:?}, exit {exit}, but differs from before: {unlike:?} ({why:?})"));
            }
        }
        sins
    }

    /// Takes it back when everything is well again.
    fn take_back(&self, dir: &Path, seen: Seen) -> Vec<String> {
        let mut bench = seen.bench;
        let at = seen.at + Span::from_secs(90);
        bench.advance(at);
        let before = bench.totals().eeprom_writes;
        witness::stands(bench, at);
        let undone = self.case.run(self.registry, dir, "undo {dir}/f.undo.toml", End::Whole, 0);
        let mut sins = Vec::new();
        let mut unlike = differing(&self.before, &cells(&undone.bench, self.family));
        // What was in force only is not in an undo file; the question said so.
        unlike.retain(|(id, set)| *set < 5 || self.before.get(&(*id, set - 5)) == self.before.get(&(*id, *set)));
        let refused = undone.failure.is_some();
        let named = |cell: &(u32, u8)| {
            let rows = undone.load.iter().flat_map(|load| &load.values);
            rows.filter(|row| row.error.is_some()).any(|row| row.param == cell.0)
        };
        let is_told = refused && unlike.iter().all(named);
        if !unlike.is_empty() && !is_told {
            sins.push(format!("taken back, but differs: {unlike:?} ({:?})", undone.failure));
        }
        let Some(load) = undone.load else { return vec![format!("undo: {:?}", undone.failure)] };
        let worn = undone.bench.totals().eeprom_writes - before;
        if worn > load.eeprom_writes {
            sins.push(format!("undo wrote {worn} cells, announced were {}", load.eeprom_writes));
        }
        sins
    }
}

/// Runs random files through every end with a stride.
fn trial(files: u64, stride: usize) -> String {
    let registry = Registry::open(&[]).unwrap();
    let (mut runs, mut sins) = (0, Vec::new());
    for (nth, case) in CASES.iter().enumerate() {
        let family = registry.family(case.model).unwrap();
        for seed in 0..files {
            let mut dice = Dice(seed * 1_000 + nth as u64);
            let fresh = Bench::from_toml("bench", &case.bench(End::Whole, 0, (0, 0)), &registry).unwrap();
            let (file, wanted) = random_file(&family, fresh.drives().next().unwrap(), &mut dice, 3 + nth);
            let dir = tempfile::tempdir().unwrap();
            std::fs::write(dir.path().join("bench.toml"), case.bench(End::Whole, 0, (0, 0))).unwrap();
            std::fs::write(dir.path().join("f.toml"), &file).unwrap();
            let words = if case.ram { "load {dir}/f.toml --ram" } else { "load {dir}/f.toml" };
            let whole = case.run(&registry, dir.path(), words, End::Whole, 0);
            let load = whole.load.as_ref().unwrap_or_else(|| panic!("{file}\n{:?}", whole.failure));
            if whole.failure.is_some() {
                sins.push(format!(
                    "{} {}: does not end well by itself: {:?}\n{file}",
                    case.model, case.keys, whole.failure
                ));
                continue;
            }
            let mut trial = Trial {
                case: *case,
                registry: &registry,
                family: &family,
                wanted,
                before: cells(&fresh, &family),
                after: cells(&whole.bench, &family),
                most: load.eeprom_writes + load.eeprom_writes_back,
                file,
                sins: Vec::new(),
            };
            if whole.bench.totals().eeprom_writes > load.eeprom_writes {
                trial.sins.push("a load by itself wears more than it said".to_owned());
            }
            for (shift, &end) in ENDS.iter().enumerate() {
                // Its own RAM a drive loses by itself.
                if case.keys == OTHER_RAM && end == End::Power {
                    continue;
                }
                // What a drive does behind the last proof, nobody sees.
                let by_drive = matches!(end, End::Power | End::Silent(_) | End::Refuses);
                let last = if by_drive { whole.sent - 2 } else { whole.telegrams + 2 };
                for step in (1 + (shift + nth) * 7 % stride..=last).step_by(stride) {
                    runs += 1;
                    trial.at(end, step);
                }
            }
            sins.extend(trial.sins);
        }
    }
    let text = format!("{runs} ends, {} of them wrong", sins.len());
    assert!(sins.is_empty(), "{text}\n{}", sins.join("\n"));
    text
}

#[expect(clippy::disallowed_methods, reason = "how long a trial is its caller says")]
fn number(name: &str) -> Option<u64> {
    std::env::var(name).ok()?.parse().ok()
}

/// Every how many telegrams an end comes.
pub(super) fn stride(usual: u64) -> usize {
    number("LOADS_STRIDE").unwrap_or(usual) as usize
}

/// LOADS_STRIDE=1 takes every telegram (the long form), LOADS_FILES so many random files.
#[test]
fn no_end_at_any_telegram_leaves_a_drive_unlike_before_without_naming_it() {
    println!("{}", trial(number("LOADS_FILES").unwrap_or(1), stride(29)));
}
