//! The simulator as judge of our master: whatever is done with drives on a normal bench, it has no remark.

use crate::agreeable::permit;
use antrieb::drive::{
    Interrupt, Manner, Opening, Order, ScanPlan, Session, Target, WriteFate, clear_counters, counters, link_test,
    recognise, scan,
};
use antrieb::gate::Writing;
use antrieb::outcome::Event;
use antrieb::profile::{DataSets, Registry, Store, Type};
use antrieb::protocol::line::{LineSetting, Parity};
use antrieb::protocol::modbus::Framing;
use antrieb::transport::Port;
use tempfile::TempDir;

/// A bench from a text, or the standard one, and everything that a session on it needs.
struct Stage {
    registry: Registry,
    port: Port,
    framing: Framing,
    line: LineSetting,
    _directory: TempDir,
}

impl Stage {
    fn standard() -> Self {
        Self::on("", "")
    }

    /// `settings` go into every drive of `bench`.
    fn on(bench: &str, settings: &str) -> Self {
        let directory = tempfile::tempdir().unwrap();
        let port = if bench.is_empty() {
            Port::Sim(None)
        } else {
            let path = directory.path().join("bench.toml");
            std::fs::write(&path, bench.replace("[[drive]]\n", &format!("[[drive]]\n{settings}\n"))).unwrap();
            Port::Sim(Some(path))
        };
        Stage {
            registry: Registry::open(&[]).unwrap(),
            port,
            framing: Framing::Rtu,
            line: LineSetting::rtu(19_200, Parity::Even),
            _directory: directory,
        }
    }

    fn at(mut self, framing: Framing, line: LineSetting) -> Self {
        (self.framing, self.line) = (framing, line);
        self
    }

    /// Works in a session, and lets the judge speak.
    fn play(&self, work: impl AsyncFnOnce(&mut Session<'_>, &Registry)) -> Vec<String> {
        let opening = Opening { line: self.line, protocol: self.framing.into(), ..Opening::at(&self.port) };
        let mut observe = |_: Event| {};
        let runtime = tokio::runtime::Builder::new_current_thread().build().unwrap();
        let opened = Session::open(opening, &self.registry, Interrupt::default(), &mut observe);
        let mut session = runtime.block_on(opened).unwrap();
        runtime.block_on(work(&mut session, &self.registry));
        session.bench().unwrap().remarks().iter().map(ToString::to_string).collect()
    }
}

const TWO: &str = "[[drive]]\nmodel = \"act\"\naddress = 1\n[[drive]]\nmodel = \"acu\"\naddress = 2\n";

/// A scan that gives everybody his time before it asks the next.
fn by_the_book(addresses: impl IntoIterator<Item = u8>) -> ScanPlan {
    ScanPlan { manner: Manner::Thorough, ..ScanPlan::new(addresses) }
}

/// Scan, identify, read and write everything, diagnose.
async fn everything(session: &mut Session<'_>, registry: &Registry) {
    let plan = by_the_book(1..=12);
    let found = scan(session, &plan, registry).await;
    assert_eq!(found.drives.len(), 2, "{found:?}");
    for address in [1, 2] {
        let finding = recognise(session, registry, address, false).await.unwrap();
        let mut target = finding.target(address, registry).unwrap();
        let family = target.family.clone();
        for id in family.group("all").unwrap() {
            target.read(session, family.param(id).unwrap(), DataSets::Unnamed).await;
        }
        for (id, raw, kind) in [(372, 1_450, Type::Uint), (480, -1_250, Type::Long), (376, 0, Type::Uint)] {
            let order = Order { set: 2, raw, kind, read_back: true };
            let fate = target.write(session, family.param(id).unwrap(), order, &permit::<Writing>()).await;
            assert_eq!(fate.is_ok(), id != 376, "{id}: {fate:?}");
        }
        let rows = target.read(session, family.param(372).unwrap(), DataSets::Unnamed).await;
        assert_eq!(rows.len(), 4, "the sets differ by now");
        target.read(session, family.param(480).unwrap(), DataSets::All(Store::Ram)).await;
        assert_eq!(counters(session, &mut target).await.unwrap().len(), 8);
        assert!(link_test(session, &mut target, 20).await.unwrap().1.is_none());
        assert!(clear_counters(session, &mut target, &permit()).await.unwrap());
    }
    let everybody = registry.family("acu").unwrap();
    let mut target = Target::new(0, everybody.clone());
    let order = Order { set: 5, raw: 700, kind: Type::Long, read_back: false };
    let fate = target.write(session, everybody.param(480).unwrap(), order, &permit::<Writing>()).await;
    assert!(matches!(fate, Ok(WriteFate::Broadcast)), "{fate:?}");
    assert!(recognise(session, registry, 1, false).await.is_ok(), "the line goes on behind a broadcast");
}

#[test]
fn no_remark_on_the_standard_bench() {
    assert_eq!(Stage::standard().play(everything), [""; 0]);
}

#[test]
fn no_remark_in_ascii() {
    let stage = Stage::on(TWO, "protocol = \"ascii\"").at(Framing::Ascii, LineSetting::ascii(19_200, Parity::Even));
    assert_eq!(stage.play(everything), [""; 0]);
}

#[test]
fn no_remark_at_any_speed_and_parity() {
    let settings = [(2_400, Parity::Even), (9_600, Parity::Odd), (57_600, Parity::None), (115_200, Parity::Even)];
    for (baud, parity) in settings {
        let settings = format!("baud = {baud}\nparity = \"{}\"", parity.name());
        let stage = Stage::on(TWO, &settings).at(Framing::Rtu, LineSetting::rtu(baud, parity));
        assert_eq!(stage.play(everything), [""; 0], "{settings}");
    }
}

#[test]
fn no_remark_with_strict_drives_and_uneven_replies() {
    let stage = Stage::on(TWO, "strict_silence = true\njitter = \"20ms\"\nreply_delay = \"11ms\"");
    assert_eq!(stage.play(everything), [""; 0]);
}

#[test]
fn no_remark_on_a_scan_of_the_whole_line() {
    let stage = Stage::standard();
    let remarks = stage.play(async |session, registry| {
        let plan = by_the_book(1..=247);
        let found = scan(session, &plan, registry).await;
        assert_eq!((found.drives.len(), found.searched[0].asked.len()), (2, 247));
    });
    assert_eq!(remarks, [""; 0]);
}

#[test]
fn no_remark_on_devices_that_are_no_drives() {
    let bench = "[[drive]]\nmodel = \"foreign\"\naddress = 9\nregisters = { \"0\" = 17 }\n";
    let remarks = Stage::on(bench, "").play(async |session, registry| {
        let plan = by_the_book(1..=20);
        assert_eq!(scan(session, &plan, registry).await.drives.len(), 1);
    });
    assert_eq!(remarks, [""; 0]);
}

#[test]
fn no_remark_where_replies_are_lost_or_spoilt() {
    // Whatever the line does to the replies, our patience is the manual's.
    for kind in ["lost", "garbled", "truncated", "doubled", "noise", "foreign"] {
        let bench = format!("[[drive]]\nmodel = \"act\"\n[[disturb]]\nevery = 3\nkind = \"{kind}\"\n");
        let remarks = Stage::on(&bench, "").play(async |session, registry| {
            let mut target = Target::new(1, registry.family("act").unwrap());
            let family = target.family.clone();
            for id in [372, 480, 411, 260, 1_600] {
                let rows = target.read(session, &family.param_or_unknown(id), DataSets::Unnamed).await;
                assert_eq!(rows.first().unwrap().1.is_ok(), id != 1_600, "{kind} {id}");
            }
        });
        assert_eq!(remarks, [""; 0], "{kind}");
    }
}

#[test]
fn an_unchanged_drive_after_everything_that_only_reads() {
    let stage = Stage::standard();
    let remarks = stage.play(async |session, registry| {
        let before = format!("{:?}", (session.bench().unwrap().totals().eeprom_writes, ram(session)));
        let plan = by_the_book(vec![1, 2]);
        scan(session, &plan, registry).await;
        for address in [1, 2] {
            let finding = recognise(session, registry, address, false).await.unwrap();
            let mut target = finding.target(address, registry).unwrap();
            let family = target.family.clone();
            for id in family.group("all").unwrap() {
                target.read(session, family.param(id).unwrap(), DataSets::Unnamed).await;
            }
            counters(session, &mut target).await.unwrap();
        }
        assert_eq!(format!("{:?}", (session.bench().unwrap().totals().eeprom_writes, ram(session))), before);
    });
    assert_eq!(remarks, [""; 0]);
}

/// Every cell of both drives.
fn ram(session: &mut Session<'_>) -> Vec<Option<i64>> {
    let bench = session.bench().unwrap();
    let drives: Vec<_> = bench.drives().collect();
    let cells =
        drives.iter().flat_map(|drive| (12..1600).flat_map(move |id| (0..=9).map(move |set| drive.ram(id, set))));
    cells.collect()
}

#[test]
fn the_eeprom_is_worn_by_what_goes_there_and_by_nothing_else() {
    Stage::standard().play(async |session, registry| {
        let mut target = Target::new(1, registry.family("act").unwrap());
        let speed = target.family.param(372).unwrap().clone();
        let mut worn = Vec::new();
        // RAM of set 2, EEPROM of set 2, RAM of all sets, EEPROM of all sets.
        for set in [7, 2, 5, 0] {
            let order = Order { set, raw: 1_400 + i64::from(set), kind: Type::Uint, read_back: true };
            let fate = target.write(session, &speed, order, &permit::<Writing>()).await;
            assert!(matches!(fate, Ok(WriteFate::Verified)), "{set}: {fate:?}");
            worn.push(session.bench().unwrap().totals().eeprom_writes);
        }
        assert_eq!(worn, [0, 1, 1, 5]);
        let drive = session.bench().unwrap().drive(1).unwrap();
        assert_eq!((drive.eeprom(372, 3), drive.ram(372, 3)), (Some(1_400), Some(1_400)));
    });
}
