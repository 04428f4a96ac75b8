//! The trial of the way back and of a plant: `dataset undo` and `apply`, and every way in which they can end, at every telegram.
//! Afterwards the bench itself is asked: is each drive as it was wanted, or as it was before, or was every differing value named;
//! and did the EEPROM bear no more than was announced? `transactions` is the same of `dataset load`.

use super::ends::{Case, End, Ended, brought_to_end};
use super::transactions::{Cells, ENDS, cells_of, differing, stride};
use antrieb::outcome::{Data, Load, LoadEnd, Outcome, Plant, PlantState, WriteResult};
use antrieb::profile::Registry;
use antrieb::simulator::Bench;
use antrieb::tick::{Span, Tick};
use antrieb::transport::witness;
use std::path::Path;

/// What a load has left, and the undo file that it has left: the drive, its keys, the old values, the new ones.
const LEFT: &[(&str, &str, &str, &str)] = &[
    (
        "act",
        "set = { \"372@1\" = 1440, \"480@2\" = -12.5, \"419\" = 60, \"412@4\" = 1 }",
        "\"372@1\" = 1390\n\"480@2\" = 5\n419 = 50\n\"412@4\" = 44",
        "{ \"372@1\" = 1440, \"480@2\" = -12.5, 419 = 60, \"412@4\" = 1 }",
    ),
    (
        "acu",
        "protocol = \"ascii\"\nset = { \"30\" = 210, \"480\" = 7, \"372@3\" = 1450 }",
        "30 = 110\n480 = 5\n\"372@3\" = 1390",
        "{ 30 = 210, 480 = 7, \"372@3\" = 1450 }",
    ),
    (
        "acu",
        "protocol = \"vabus\"\nset = { \"481@2\" = 7, \"372@3\" = 1450 }",
        "\"481@2\" = 10\n\"372@3\" = 1390",
        "{ \"481@2\" = 7, \"372@3\" = 1450 }",
    ),
    ("lxm05", "set = { RAMPacc = 3000, HMn = 61, JOGn_slow = 30 }", SERVO_BEFORE, SERVO_AFTER),
    // What nobody can see stands in its RAM.
    (
        "act",
        "readings = { ram_reads = \"refused\" }\nset = { \"480@2ram\" = 7, \"372@1\" = 1440 }",
        "\"480@2\" = 5\n\"372@1\" = 1390",
        "{ \"480@2\" = 7, \"372@1\" = 1440 }",
    ),
];
const SERVO_BEFORE: &str = "RAMPacc = 600\nHMn = 60\nJOGn_slow = 60";
const SERVO_AFTER: &str = "{ RAMPacc = 3000, HMn = 61, JOGn_slow = 30 }";

/// Every step at which this end comes; what a drive does behind the last proof, nobody sees.
fn steps(end: End, shift: usize, stride: usize, (telegrams, sent): (usize, usize)) -> impl Iterator<Item = usize> {
    let by_drive = matches!(end, End::Power | End::Silent(_) | End::Refuses);
    let last = if by_drive { sent.saturating_sub(2) } else { telegrams + 2 };
    (1 + shift * 7 % stride..=last).step_by(stride)
}

/// Whether a row or a warning says of a cell that it may not be as it should.
fn is_named((id, set): (u32, u8), load: &Load, warnings: &str) -> bool {
    use WriteResult::{Refused, Skipped, Stored, Unknown, Unrestored};
    let is_open = |result| matches!(result, Unrestored | Stored | Unknown | Refused | Skipped);
    let rows = load.values.iter().filter(|row| row.param == id);
    rows.into_iter().any(|row| is_open(row.result) || row.error.is_some())
        || [format!("P.{id}@{}", set % 5), format!("({id})@{}", set % 5)].iter().any(|place| warnings.contains(place))
}

fn text_of(outcome: &Outcome) -> String {
    outcome.warnings.iter().map(|warning| warning.message.en.to_string()).collect()
}

/// What is wrong with how an undo ended.
fn judge(outcome: &Outcome, (before, wanted, now): (&Cells, &Cells, &Cells), worn: u64) -> Vec<String> {
    let mut sins = Vec::new();
    let exit = outcome.failure.as_ref().map_or(0, |failure| failure.class.exit());
    let unlike = differing(wanted, now);
    let Some(Data::Load(load)) = &outcome.data else {
        let changed = differing(before, now);
        return if exit == 0 || !changed.is_empty() { vec![format!("no report: {changed:?}")] } else { sins };
    };
    if worn > load.eeprom_writes {
        sins.push(format!("EEPROM written {worn} times, announced were {}", load.eeprom_writes));
    }
    let is_right = match load.ended {
        Some(LoadEnd::Done) => exit == 0 && unlike.is_empty(),
        Some(LoadEnd::Untouched) | None => exit != 0 && differing(before, now).is_empty(),
        Some(LoadEnd::Torn | LoadEnd::Stored) => {
            let told = text_of(outcome);
            exit == 9 && unlike.iter().all(|cell| is_named(*cell, load, &told))
        }
        Some(LoadEnd::Back) => false,
    };
    if !is_right {
        let why = outcome.failure.as_ref().map(|failure| failure.message.en.to_string());
        sins.push(format!("ended {:?}, exit {exit}, differs from what was wanted: {unlike:?} ({why:?})", load.ended));
    }
    sins
}

#[test]
fn no_end_at_any_telegram_of_an_undo_is_called_done_and_is_not() {
    let registry = Registry::open(&[]).unwrap();
    let (stride, mut runs, mut sins) = (stride(11), 0, Vec::new());
    let mut seen = std::collections::BTreeSet::new();
    for (nth, &(model, keys, old, new)) in LEFT.iter().enumerate() {
        let family = registry.family(model).unwrap();
        let protocol = keys.split('"').nth(1).filter(|_| keys.starts_with("protocol")).unwrap_or("rtu");
        let options = format!("--protocol {protocol}").leak();
        let case = Case { model, keys, options, ram: false };
        let undo = format!(
            "antrieb = 1\n[drive]\nfamily = \"{model}\"\n[values]\n{old}\n[undo]\nmemory = \"eeprom\"\nvalues = {new}\n"
        );
        let run = |end, step, victim| {
            let dir = tempfile::tempdir().unwrap();
            std::fs::write(dir.path().join("bench.toml"), case.bench(end, step, victim)).unwrap();
            std::fs::write(dir.path().join("u.toml"), &undo).unwrap();
            (undone(dir.path(), &case, &registry, end, step), dir)
        };
        let fresh = Bench::from_toml("bench", &case.bench(End::Whole, 0, (0, 0)), &registry).unwrap();
        let before = cells_of(fresh.drives().next().unwrap(), &family);
        let ((whole, bench, _), _) = run(End::Whole, 0, (0, 0));
        assert!(whole.outcome.failure.is_none(), "{model}: {:?}", whole.outcome.failure);
        let wanted = cells_of(bench.drives().next().unwrap(), &family);
        let victims = differing(&before, &wanted);
        assert!(victims.len() > 1, "{model}: {victims:?}");
        for (shift, &end) in ENDS.iter().enumerate() {
            // What stands in a RAM alone goes with the power by itself.
            if end == End::Power && keys.contains("ram\"") {
                continue;
            }
            for step in steps(end, shift + nth, stride, (whole.telegrams, whole.sent)) {
                runs += 1;
                let (id, set) = victims[step % victims.len()];
                let ((ended, bench, at), dir) = run(end, step, (id, set % 5));
                let now = cells_of(bench.drives().next().unwrap(), &family);
                let mut found: Vec<String> = bench.remarks().iter().map(ToString::to_string).collect();
                if !ended.killed {
                    found.extend(judge(&ended.outcome, (&before, &wanted, &now), bench.totals().eeprom_writes));
                }
                seen.insert(ended.outcome.failure.as_ref().map(|failure| failure.class.exit()));
                // Once more, when everything is well again.
                if end != End::Refuses {
                    let again = |bench, at| {
                        later(bench, at);
                        undone(dir.path(), &case, &registry, End::Whole, 0)
                    };
                    let (mut again_ended, mut bench, at) = again(bench, at);
                    // What the drive was to do may have been left for it.
                    if again_ended.outcome.failure.is_some() {
                        (again_ended, bench, _) = again(bench, at);
                    }
                    let again = again_ended;
                    let unlike = differing(&wanted, &cells_of(bench.drives().next().unwrap(), &family));
                    if again.outcome.failure.is_some() || !unlike.is_empty() {
                        found.push(format!("undone again, differs: {unlike:?} ({:?})", again.outcome.failure));
                    }
                }
                sins.extend(found.into_iter().map(|sin| format!("{model} {keys}: {end:?} at {step}: {sin}")));
            }
        }
    }
    assert!(sins.is_empty(), "{runs} ends, {} wrong\n{}", sins.len(), sins.join("\n"));
    assert!([None, Some(9), Some(130)].iter().all(|exit| seen.contains(exit)), "{seen:?}");
}

fn undone(dir: &Path, case: &Case, registry: &Registry, end: End, step: usize) -> (Ended, Bench, Tick) {
    let line = format!(
        "-p sim:{{dir}}/bench.toml --drive {} -a 1 --yes {} dataset undo {{dir}}/u.toml",
        case.model, case.options
    );
    let ended = brought_to_end(dir, &line, registry, end, step);
    let (bench, at) = witness::left().unwrap();
    (ended, bench, at)
}

/// The bench stands there when everything is well again.
fn later(mut bench: Bench, at: Tick) {
    let at = at + Span::from_secs(90);
    bench.advance(at);
    witness::stands(bench, at);
}

/// Three drives of one line, by their addresses, with what each shall have.
const MODELS: [&str; 3] = ["act", "acu", "lxm05"];
const WANTED: [&str; 3] = [
    "\"372@1\" = 1440\n480 = -12.5\n\"412@4\" = 1",
    "30 = 210\n\"480@2\" = 7\n\"372@3\" = 1450",
    "RAMPacc = 3000\nHMn = 61",
];

fn bench_of(end: End, step: usize) -> String {
    let event = match end {
        End::Power => "power_cycle = true".to_owned(),
        End::Silent(ms) => format!("silent = \"{ms}ms\""),
        End::Refuses => format!("refuses = {}", [1 << 12 | 480, 2 << 12 | 480, 1556][step % 3]),
        _ => String::new(),
    };
    let drive = |nth: usize| {
        let event = if event.is_empty() || nth != step % 3 {
            String::new()
        } else {
            format!("[[drive.event]]\nafter_telegrams = {}\n{event}\n", 1 + step / 3)
        };
        format!("[[drive]]\nmodel = \"{}\"\naddress = {}\n{event}", MODELS[nth], nth + 1)
    };
    (0..3).map(drive).collect()
}

/// What is wrong with how an `apply` ended.
fn judge_plant(plant: &Plant, outcome: &Outcome, [before, after, now]: [&[Cells]; 3], atomic: bool) -> Vec<String> {
    let mut sins = Vec::new();
    let told = text_of(outcome);
    for (nth, row) in plant.drives.iter().enumerate() {
        let unlike = differing(&before[nth], &now[nth]);
        let is_right = match row.state {
            PlantState::Done | PlantState::Same => differing(&after[nth], &now[nth]).is_empty(),
            PlantState::Torn | PlantState::Stored => unlike.iter().all(|cell| is_named(*cell, &row.load, &told)),
            _ => unlike.is_empty(),
        };
        let is_whole = outcome.failure.is_some() || row.state == PlantState::Done;
        // All of them or none, but for what could not be taken back.
        let is_one = !atomic || outcome.failure.is_none() || row.state != PlantState::Done;
        if !(is_right && is_whole && is_one) {
            sins.push(format!("{}: {:?}, differs from before: {unlike:?}", row.called, row.state));
        }
    }
    sins
}

#[test]
fn no_end_at_any_telegram_of_a_plant_leaves_a_drive_unlike_its_row() {
    let registry = Registry::open(&[]).unwrap();
    let families = MODELS.map(|model| registry.family(model).unwrap());
    let cells = |bench: &Bench| -> Vec<Cells> {
        (1..).zip(&families).map(|(address, family)| cells_of(bench.drive(address).unwrap(), family)).collect()
    };
    let run = |end, step, atomic: bool| {
        let dir = tempfile::tempdir().unwrap();
        let at = |name: &str| dir.path().join(name);
        std::fs::write(at("bench.toml"), bench_of(end, step)).unwrap();
        let mut project = format!("port = \"sim:{}\"\n", at("bench.toml").display());
        for (nth, (model, values)) in MODELS.iter().zip(WANTED).enumerate() {
            let text = format!("antrieb = 1\n[drive]\nfamily = \"{model}\"\n[values]\n{values}\n");
            std::fs::write(at(&format!("f{nth}.toml")), text).unwrap();
            project += &format!("[drives.d{nth}]\naddress = {}\nfiles = [\"f{nth}.toml\"]\n", nth + 1);
        }
        std::fs::write(at("antrieb.toml"), project).unwrap();
        let ended = brought_to_end(
            dir.path(),
            if atomic { "apply --yes --atomic" } else { "apply --yes" },
            &registry,
            end,
            step,
        );
        (ended, witness::left().unwrap(), dir)
    };
    let before = cells(&Bench::from_toml("bench", &bench_of(End::Whole, 0), &registry).unwrap());
    let (whole, (bench, _), _) = run(End::Whole, 0, false);
    assert!(whole.outcome.failure.is_none(), "{:?}", whole.outcome.failure);
    let after = cells(&bench);
    let (stride, mut runs, mut sins) = (stride(23), 0, Vec::new());
    let mut seen = std::collections::BTreeSet::new();
    for (shift, &end) in ENDS.iter().enumerate() {
        for step in steps(end, shift, stride, (whole.telegrams, whole.sent)) {
            let atomic = step % 2 == 1;
            runs += 1;
            let (ended, (bench, at), dir) = run(end, step, atomic);
            let now = cells(&bench);
            let mut found: Vec<String> = bench.remarks().iter().map(ToString::to_string).collect();
            if let Some(Data::Plant(plant)) = &ended.outcome.data {
                let most: u64 =
                    plant.drives.iter().map(|row| row.load.eeprom_writes + row.load.eeprom_writes_back).sum();
                if bench.totals().eeprom_writes > most {
                    found.push(format!("EEPROM written {} times of {most}", bench.totals().eeprom_writes));
                }
                found.extend(judge_plant(plant, &ended.outcome, [&before, &after, &now], atomic));
                seen.extend(plant.drives.iter().map(|row| format!("{:?}", row.state)));
            } else if !ended.killed && now != before {
                found.push(format!("changed without a report: {:?}", ended.outcome.failure));
            }
            // Whoever was not done can be taken back, one after the other.
            let (mut bench, mut at) = (bench, at);
            for nth in (0..3).filter(|nth| now[*nth] != before[*nth] && end != End::Refuses) {
                let undo = dir.path().join(format!("d{nth}.undo.toml"));
                if !undo.exists() {
                    found.push(format!("d{nth} is not as before, and has no undo file"));
                    continue;
                }
                let line = format!("-a d{nth} --yes dataset undo {{dir}}/d{nth}.undo.toml");
                let mut undone;
                // What the drive was to do may have been left for the undo.
                let mut tries = 0..2;
                loop {
                    later(bench, at);
                    undone = brought_to_end(dir.path(), &line, &registry, End::Whole, 0);
                    (bench, at) = witness::left().unwrap();
                    if undone.outcome.failure.is_none() || tries.next().is_none() {
                        break;
                    }
                }
                let unlike = differing(&before[nth], &cells(&bench)[nth]);
                if undone.outcome.failure.is_some() || !unlike.is_empty() {
                    found.push(format!("d{nth} taken back, differs: {unlike:?} ({:?})", undone.outcome.failure));
                }
            }
            sins.extend(found.into_iter().map(|sin| format!("{end:?} at {step}, atomic {atomic}: {sin}")));
        }
    }
    assert!(sins.is_empty(), "{runs} ends, {} wrong\n{}", sins.len(), sins.join("\n"));
    assert!(["Done", "Back", "Torn", "Skipped"].iter().all(|state| seen.contains(*state)), "{seen:?}");
}
