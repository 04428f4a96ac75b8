//! Moving a drive to other line settings: on a good line, on a bad one, and with the cable cut at every moment.

use crate::agreeable::permit;
use antrieb::drive::relocate::{Wish, course};
use antrieb::drive::{Interrupt, Opening, Session, Target};
use antrieb::failure::{Class, Failure};
use antrieb::outcome::{Event, Relocation, RelocationResult, StepResult};
use antrieb::profile::Registry;
use antrieb::protocol::Protocol;
use antrieb::protocol::line::Parity;
use antrieb::protocol::modbus::Framing;
use antrieb::transport::Port;

const RTU: Protocol = Protocol::Modbus(Framing::Rtu);

/// A factory-fresh drive, and what else the bench file says.
fn fresh(more: &str) -> String {
    format!("[[drive]]\nmodel = \"acu\"\nprotocol = \"vabus\"\n{more}")
}

/// A drive that speaks RTU at address 1.
fn modbus(more: &str) -> String {
    format!("[[drive]]\nmodel = \"acu\"\n{more}")
}

/// How a bench was left.
struct Left {
    told: Vec<Result<(Relocation, Option<Failure>), Failure>>,
    /// Where the first drive is, in the words of the documents.
    drive: String,
    /// P.10 and P.1375 in its EEPROM.
    stored: [Option<i64>; 2],
    remarks: Vec<String>,
}

impl Left {
    fn only(&self) -> (&Relocation, Option<&Failure>) {
        let (relocation, failure) = self.told[0].as_ref().unwrap();
        (relocation, failure.as_ref())
    }
}

/// Opens the bench and moves its first drive, wish by wish, each from where the last left it.
fn play(bench: &str, protocol: Protocol, wishes: &[Wish]) -> Left {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("bench.toml");
    std::fs::write(&path, bench).unwrap();
    let registry = Registry::open(&[]).unwrap();
    let port = Port::Sim(Some(path));
    let opening = Opening { line: protocol.line(19_200, Parity::Even), protocol, ..Opening::at(&port) };
    let mut observe = |_: Event| {};
    let runtime = tokio::runtime::Builder::new_current_thread().build().unwrap();
    runtime.block_on(async {
        let mut session = Session::open(opening, &registry, Interrupt::default(), &mut observe).await.unwrap();
        let mut address = 1;
        let mut told = Vec::new();
        for wish in wishes {
            let moved = one_move(&mut session, &registry, address, wish).await;
            if let Ok((relocation, _)) = &moved {
                address = relocation.to.address;
            }
            told.push(moved);
        }
        let bench = session.bench().unwrap();
        let remarks = bench.remarks().iter().map(ToString::to_string).collect();
        let drive = bench.drives().next().unwrap();
        let stored = [10, 1_375].map(|number| drive.eeprom(number, 0));
        let place = format!("{} {}, address {}", drive.protocol(), drive.line(), drive.address());
        Left { told, drive: place, stored, remarks }
    })
}

async fn one_move(
    session: &mut Session<'_>,
    registry: &Registry,
    address: u8,
    wish: &Wish,
) -> Result<(Relocation, Option<Failure>), Failure> {
    let mut target = Target::new(address, registry.family("acu").unwrap());
    let course = course(session, &mut target, wish).await?;
    course.check_free(session, &mut target).await?;
    Ok(course.go(session, &mut target, &permit()).await)
}

fn line(baud: u32, parity: Parity, address: u8) -> Wish {
    Wish { baud: Some(baud), parity: Some(parity), address: Some(address.into()), ..Wish::default() }
}

#[test]
fn a_factory_fresh_drive_comes_to_modbus_and_moves_on_without_a_remark() {
    let to_rtu = Wish::to_protocol("rtu").unwrap();
    let left = play(&fresh(""), Protocol::Vabus, &[to_rtu, line(115_200, Parity::Odd, 5)]);
    assert_eq!(left.remarks, [""; 0]);
    assert_eq!(left.drive, "rtu 115200 8O1, address 5");
    for (told, place) in left.told.iter().zip(["rtu 19200 8E1, address 1", "rtu 115200 8O1, address 5"]) {
        let (relocation, failure) = told.as_ref().unwrap();
        assert_eq!((relocation.result, failure), (RelocationResult::Moved, &None));
        assert_eq!(relocation.now.as_ref().unwrap().text.en, place);
        assert!(relocation.steps.iter().all(|step| step.result == StepResult::Proven));
    }
    let (relocation, _) = left.told[1].as_ref().unwrap();
    let way_back = relocation.way_back.as_ref().unwrap();
    assert!(
        way_back
            .ends_with("--protocol rtu -b 115200 --parity odd -a 5 line set --baud 19200 --parity even --address 1"),
        "{way_back}"
    );
}

#[test]
fn every_protocol_to_every_other_and_back() {
    let all = [Protocol::Vabus, RTU, Protocol::Modbus(Framing::Ascii)];
    for from in all {
        for to in all.into_iter().filter(|to| *to != from) {
            let bench =
                format!("[[drive]]\nmodel = \"acu\"\nprotocol = \"{from}\"\nset = {{ \"394\" = 1, \"1376\" = 1 }}");
            let there = Wish { protocol: Some(to), ..Wish::default() };
            let back = Wish { protocol: Some(from), ..Wish::default() };
            let left = play(&bench, from, &[there, back]);
            for told in &left.told {
                assert_eq!(told.as_ref().unwrap().0.result, RelocationResult::Moved, "{from} {to}");
            }
            assert!(left.drive.starts_with(&format!("{from} 19200")), "{from} {to}: {}", left.drive);
            assert_eq!(left.remarks, [""; 0], "{from} {to}");
        }
    }
}

#[test]
fn an_address_of_vabus_is_another_parameter() {
    let left = play(&fresh(""), Protocol::Vabus, &[Wish { address: Some(9), ..Wish::default() }]);
    assert_eq!(left.drive, "vabus 19200 7E1, address 9");
    assert_eq!(left.only().0.steps[0].param, 394);
    let refused = play(&fresh(""), Protocol::Vabus, &[Wish { address: Some(31), ..Wish::default() }]);
    assert_eq!(refused.told[0].as_ref().unwrap_err().code, "data.range");
    let refused = play(&fresh(""), Protocol::Vabus, &[Wish { baud: Some(38_400), ..Wish::default() }]);
    assert_eq!(refused.told[0].as_ref().unwrap_err().code, "data.range");
}

#[test]
fn what_is_there_already_costs_nothing() {
    let left = play(&modbus(""), RTU, &[line(19_200, Parity::Even, 1)]);
    assert_eq!((left.only().0.result, left.only().0.steps.len()), (RelocationResult::Unchanged, 0));
}

#[test]
fn a_place_that_somebody_has_is_not_taken() {
    let neighbour = modbus("[[drive]]\nmodel = \"act\"\naddress = 5\n");
    let left = play(&neighbour, RTU, &[Wish { address: Some(5), ..Wish::default() }]);
    let failure = left.told[0].as_ref().unwrap_err();
    assert_eq!((failure.class, failure.code.as_str()), (Class::Forbidden, "forbidden.occupied"));
    assert_eq!(left.drive, "rtu 19200 8E1, address 1");
    let other_speed = modbus("[[drive]]\nmodel = \"acu\"\nbaud = 115200\n");
    let left = play(&other_speed, RTU, &[Wish { baud: Some(115_200), ..Wish::default() }]);
    assert_eq!(left.told[0].as_ref().unwrap_err().code, "forbidden.occupied");
    assert_eq!((left.drive.as_str(), left.stored[0]), ("rtu 19200 8E1, address 1", Some(4)));
}

#[test]
fn a_parity_that_waits_for_a_restart_is_looked_for() {
    // P.1375 was written, but the drive has not restarted since: Modbus still has the old parity.
    let bench = fresh("parity = \"even\"\nset = { \"1375\" = 1 }\n[[drive.event]]\nat = \"0s\"\nwarning = 0\n");
    let left = play(&bench, Protocol::Vabus, &[Wish::to_protocol("rtu").unwrap()]);
    assert_eq!((left.only().0.result, left.drive.as_str()), (RelocationResult::Moved, "rtu 19200 8O1, address 1"));
}

#[test]
fn a_drive_that_runs_refuses_the_restart_and_is_left_as_it_was() {
    let running = modbus("set = { \"412\" = 0 }\nstart_right = true\n");
    let left = play(&running, RTU, &[line(115_200, Parity::Odd, 5)]);
    let (relocation, failure) = left.only();
    assert_eq!(failure.unwrap().class, Class::Refused, "{failure:?}");
    assert_eq!(relocation.result, RelocationResult::Restored);
    assert_eq!((left.drive.as_str(), left.stored), ("rtu 19200 8E1, address 1", [Some(4), Some(0)]));
}

/// One reply that is lost, whichever it is, keeps nothing from being done.
#[test]
fn any_lost_reply_is_made_up_for() {
    for once in 1..=24 {
        let lost = format!("[[disturb]]\nonce = {once}\nkind = \"lost\"\n");
        for (bench, protocol, wish) in [
            (fresh(&lost), Protocol::Vabus, Wish::to_protocol("rtu").unwrap()),
            (modbus(&lost), RTU, line(115_200, Parity::Odd, 5)),
            (modbus(&lost), RTU, Wish::to_protocol("vabus").unwrap()),
        ] {
            let left = play(&bench, protocol, &[wish]);
            let (relocation, failure) = left.only();
            assert_eq!(relocation.result, RelocationResult::Moved, "{once} {wish:?} {failure:?}");
            assert_eq!(relocation.now.as_ref().unwrap().text.en, left.drive);
        }
    }
}

/// The cable is cut for good at any moment: what the tool says last is true.
#[test]
fn wherever_the_cable_is_cut_the_last_word_tells_where_the_drive_is() {
    let mut seen = Vec::new();
    for (bench, protocol, wish, until) in [
        (fresh as fn(&str) -> String, Protocol::Vabus, Wish::to_protocol("rtu").unwrap(), 1_400),
        (modbus, RTU, line(115_200, Parity::Odd, 5), 7_000),
        (modbus, RTU, Wish::to_protocol("vabus").unwrap(), 1_400),
    ] {
        for millis in (0..until).step_by(13) {
            let cut = format!("[[drive.event]]\nat = \"{millis}ms\"\nsilent = \"1000s\"\n");
            let left = play(&bench(&cut), protocol, &[wish]);
            let Ok((relocation, failure)) = &left.told[0] else { continue };
            seen.push(relocation.result);
            let drive = &left.drive;
            let text = |place: &antrieb::outcome::Place| place.text.clone();
            match &relocation.now {
                Some(now) => assert_eq!(now.text.en, *drive, "{millis} {relocation:?}"),
                None => assert!(
                    relocation.perhaps.iter().any(|place| place.text.en == *drive),
                    "{millis} ms: {drive}, told {relocation:?}"
                ),
            }
            assert_eq!(failure.is_none(), relocation.result == RelocationResult::Moved, "{failure:?}");
            let waits = protocol == RTU && left.stored != [Some(4), Some(0)] && drive.contains("19200");
            if waits {
                assert_eq!(relocation.after_restart.as_ref().map(text), Some(relocation.to.text.clone()), "{millis}");
            }
        }
    }
    assert!(seen.contains(&RelocationResult::Lost) && seen.contains(&RelocationResult::Moved), "{seen:?}");
}

/// The cable is cut and comes back while the tool is still at it: it ends at one of the two places, and says at which.
#[test]
fn a_cable_that_comes_back_leaves_the_drive_at_a_known_place() {
    for millis in (500..6_000).step_by(97) {
        let cut = format!("[[drive.event]]\nat = \"{millis}ms\"\nsilent = \"2s\"\n");
        let left = play(&modbus(&cut), RTU, &[line(115_200, Parity::Odd, 5)]);
        let Ok((relocation, _)) = &left.told[0] else { continue };
        if let Some(now) = &relocation.now {
            assert_eq!(now.text.en, left.drive, "{millis} {relocation:?}");
        }
        if relocation.result == RelocationResult::Restored {
            assert_eq!(left.stored, [Some(4), Some(0)], "{millis}");
        }
    }
}
