//! The bus as its manual has it, spoken to by hand.

use super::bus::Can;
use crate::profile::Registry;
use crate::tick::{Span, Tick};

fn bus(text: &str) -> Can {
    Can::from_toml("bus.toml", text, &Registry::open(&[]).unwrap()).unwrap()
}

/// What the adapter says until a time, when it was told this at another; the channel is open.
fn told(bus: &mut Can, at_ms: u64, words: &str, until_ms: u64) -> String {
    let at = |ms| Tick::ZERO + Span::from_millis(ms);
    bus.advance(at(at_ms));
    bus.master_sends(at(at_ms), words.replace(' ', "\r").as_bytes());
    let said = bus.advance(at(until_ms)).into_iter().map(|(_, byte)| byte).collect();
    String::from_utf8(said).unwrap().replace('\r', " ").replace('\u{7}', "!")
}

fn drive(rest: &str) -> String {
    format!("{rest}\n[[drive]]\nmodel = \"acu\"\naddress = 5\n")
}

const OPEN: &str = "C S6 O ";

#[test]
fn an_adapter_obeys_the_words_of_its_manual() {
    let mut can = bus(&drive(""));
    assert_eq!(told(&mut can, 0, "C O V S6 S6 t0000 O F O S5 L C C ", 10), "!!V0001   ! F00 !!! !");
    let mut mute = bus(&drive("[adapter]\nacknowledges = false"));
    assert_eq!(told(&mut mute, 0, OPEN, 10), "");
    assert!(mute.is_open());
}

#[test]
fn parameters_are_answered_over_both_channels_as_the_manual_prints_it() {
    let mut can = bus(&drive(""));
    told(&mut can, 0, OPEN, 10);
    // P.411 over SDO1 and SDO2, P.900 = 5, an unknown one, P.484, which an ACU does not show.
    assert_eq!(told(&mut can, 20, "t6058409B010000000000 ", 40), "z t5858429B010021000000 ".replace("21", &low(&can)));
    assert_eq!(told(&mut can, 50, "t64584084030000000000 ", 70), "z t5C584284030005000000 ");
    assert_eq!(
        told(&mut can, 80, "t645840FFFF0000000000 ", 100),
        "z t5C580FFFF00".replace("580F", "5880F") + "0B000000 "
    );
    assert_eq!(told(&mut can, 110, "t645840E4010000000000 ", 130), "z t5C5880E4010003000000 ");
    assert!(can.remarks().is_empty());
}

/// The low byte of the status word.
fn low(can: &Can) -> String {
    format!("{:02X}", can.ram(5, 411, 0).unwrap() & 0xFF)
}

#[test]
fn the_smallest_identifier_wins_and_frames_take_their_time() {
    let mut can = bus(&drive(
        "[[foreign]]\nframe = \"080#\"\nevery = \"10ms\"\n[[foreign]]\nframe = \"000#0100\"\nevery = \"10ms\"",
    ));
    told(&mut can, 0, "S6 O ", 1);
    assert_eq!(told(&mut can, 9, "", 12), "t00020100 t0800 ");
}

#[test]
fn a_stopped_node_is_silent_and_says_its_boot_up_behind_a_reset() {
    let mut can = bus(&drive(""));
    told(&mut can, 0, OPEN, 10);
    assert_eq!(told(&mut can, 20, "t00020205 t6458409B010000000000 ", 100), "z z ");
    assert_eq!(told(&mut can, 110, "t00028105 ", 300), "z t705100 ");
    assert_eq!((can.remarks().len(), can.orders().len()), (0, 2), "a tool may be the master where no drive is");
    let mut can = bus(&(drive("") + "[[drive]]\nmodel = \"acu\"\naddress = 0\n"));
    told(&mut can, 0, "S6 O t00020205 t00020277 t0001FF ", 10);
    assert_eq!((can.remarks().len(), can.ram(5, 978, 0)), (3, Some(3)), "the network is the master's");
}

#[test]
fn a_master_drive_starts_everybody_again_and_again() {
    let text = drive("") + "[[drive]]\nmodel = \"acu\"\naddress = 0\nset = { \"904\" = 4000, \"919\" = 1000 }\n";
    let mut can = bus(&text);
    told(&mut can, 0, OPEN, 10);
    assert_eq!(told(&mut can, 3_990, "", 6_500), "t00020100 t0800 t0800 t0800 ");
    assert_eq!(can.ram(5, 978, 0), Some(2));
}

#[test]
fn a_fault_is_an_emergency() {
    let mut can = bus(&(drive("") + "[[drive.event]]\nat = \"1s\"\nfault = \"F0500\"\n"));
    told(&mut can, 0, OPEN, 10);
    assert_eq!(told(&mut can, 900, "", 1_100), "t0858001080000000".to_owned() + "0005 ");
}

#[test]
fn another_bit_rate_is_heard_as_errors_and_disturbs_who_takes_part() {
    let mut can = bus(&drive("[[foreign]]\nframe = \"080#\"\nevery = \"10ms\""));
    assert_eq!(told(&mut can, 0, "S5 L ", 50), "  ");
    assert_eq!(told(&mut can, 60, "F ", 70), "F84 ");
    assert!(can.remarks().is_empty(), "who listens disturbs nobody");
    told(&mut can, 80, "C O ", 100);
    assert!(!can.remarks().is_empty());
}

/// A drive alone on the bus with an adapter that only listens: nobody acknowledges, so it says the same again until somebody does.
#[test]
fn what_nobody_acknowledges_is_said_again() {
    let mut can = bus(&(drive("") + "[[drive.event]]\nat = \"1s\"\nfault = \"F0500\"\n"));
    told(&mut can, 0, "S6 L ", 10);
    let heard = told(&mut can, 900, "", 1_100);
    assert!(heard.matches("t0858001080000000").count() > 200 && can.ram(5, 979, 0) == Some(2), "{heard}");
    assert_eq!(told(&mut can, 1_100, "F ", 1_101).matches("F84").count(), 1, "its first sixteen had error flags");
    // Somebody who takes part ends it.
    let heard = told(&mut can, 1_110, "C O ", 1_200);
    assert!(heard.matches("t085").count() < 10, "{heard}");
    assert_eq!(told(&mut can, 1_200, "", 1_300), "");
    // One answer more counts one error less; 128 is no warning where 128 is the mark.
    (0..40).for_each(|nth| drop(told(&mut can, 1_300 + nth * 5, "t6458409B010000000000 ", 1_304 + nth * 5)));
    assert_eq!(can.ram(5, 979, 0), Some(1));
    // Another node acknowledges as well, and with nobody to hear it nothing is repeated for nothing.
    let two = drive("") + "[[drive.event]]\nat = \"1s\"\nfault = \"F0500\"\n[[drive]]\nmodel = \"acu\"\naddress = 6\n";
    let mut can = bus(&two);
    told(&mut can, 0, "S6 L ", 10);
    assert_eq!(told(&mut can, 900, "", 1_100).matches("t085").count(), 1);
    assert_eq!(can.ram(5, 979, 0), Some(1));
}

/// Its error flags make the sender go off the bus: F2210 (5.12). Who sends nothing is not hurt.
#[test]
fn an_adapter_at_another_bit_rate_takes_who_sends_off_the_bus() {
    let mut can = bus(&(drive("") + "[[drive]]\nmodel = \"acu\"\naddress = 0\n"));
    told(&mut can, 0, "S5 O ", 10);
    // The first Start of the master.
    can.advance(at(3_520));
    assert_eq!([260, 979].map(|param| can.ram(0, param, 0)), [Some(0x2210), Some(3)]);
    assert_eq!([260, 979].map(|param| can.ram(5, param, 0)), [Some(0), Some(1)]);
    assert_eq!(can.remarks().len(), 32);
}

#[test]
fn of_a_pdo_that_waits_the_newest_goes_out() {
    let mut can = bus("[[drive]]\nmodel = \"acu\"\nset = { \"930\" = 1, \"931\" = 10, \"950\" = 740 }\n\
         [[drive.event]]\nat = \"1s\"\nset = { \"410\" = 6 }\n");
    told(&mut can, 0, "S6 O t00020100 ", 5);
    told(&mut can, 5, "C ", 1_000);
    assert!(told(&mut can, 1_500, "O ", 1_505).matches("t1818").count() <= 2, "the one that waits, and the next");
    assert!(told(&mut can, 1_505, "", 1_520).contains("t18180600"));
}

/// A drive that sends at its node, and one that takes it; both are started by hand.
fn pair(sends: &str, takes: &str, more: &str) -> Can {
    let row = |address: u8, set: &str| {
        format!("[[drive]]\nmodel = \"acu\"\naddress = {address}\nsources = {{ \"27\" = -2 }}\nset = {{ {set} }}\n")
    };
    bus(&format!("{more}\n{}{}", row(1, sends), row(2, takes)))
}

const STARTED: &str = "S6 O t00020100 ";

fn at(ms: u64) -> Tick {
    Tick::ZERO + Span::from_millis(ms)
}

#[test]
fn a_pdo_by_time_brings_its_sources_to_those_of_who_takes_it() {
    let mut can = pair("\"930\" = 1, \"931\" = 10, \"950\" = 741, \"948\" = 6, \"953\" = 27", "\"924\" = 385", "");
    let said = told(&mut can, 0, STARTED, 25);
    assert_eq!(said.matches("t1818").count(), 2, "{said}");
    let status = can.ram(1, 411, 0).unwrap();
    let of = |can: &mut Can, source| can.source(2, source).unwrap();
    assert_eq!([704, 702, 706, 707].map(|source| of(&mut can, source)), [status, 1, 1, 0xFFFE]);
    // Bytes 4 to 7 as a long, the least significant first.
    assert_eq!((of(&mut can, 709), of(&mut can, 730)), (-131_071, 0));
    // Nothing flows outside Operational, and what came stays.
    told(&mut can, 35, "t00028002 ", 36);
    assert_eq!((told(&mut can, 36, "t00020201 ", 90).matches("t181").count(), of(&mut can, 704)), (0, status));
    let mut zeroed = pair("\"930\" = 1, \"950\" = 6", "\"924\" = 385", "[readings]\nleft_operational = \"zeroed\"");
    told(&mut zeroed, 0, STARTED, 25);
    assert_eq!(of(&mut zeroed, 704), 1);
    told(&mut zeroed, 30, "t00028002 ", 31);
    assert_eq!(of(&mut zeroed, 704), 0);
}

#[test]
fn sync_sends_and_hands_on() {
    let sync = "[[foreign]]\nframe = \"080#\"\nevery = \"20ms\"";
    let set = ["\"930\" = 2, \"950\" = 27", "\"924\" = 385, \"936\" = 1"];
    let mut can = pair(set[0], set[1], sync);
    assert_eq!(told(&mut can, 0, STARTED, 35).matches("t1818").count(), 1);
    assert_eq!(can.source(2, 704), Some(0), "the next SYNC hands it on");
    can.advance(at(45));
    assert_eq!(can.source(2, 704), Some(0xFFFE));
    // 1 is by time where 0 is off.
    let mut other = pair(set[0], set[1], &format!("{sync}\n[readings]\nrx_functions = \"0-2\""));
    told(&mut other, 0, STARTED, 35);
    assert_eq!(other.source(2, 704), Some(0xFFFE));
    let with_data = sync.replace("080#", "080#00");
    let mut deaf = pair(set[0], set[1], &format!("[readings]\nsync_with_data = \"ignored\"\n{with_data}"));
    assert_eq!(told(&mut deaf, 0, STARTED, 100).matches("t1818").count(), 0);
}

#[test]
fn what_is_missing_is_the_fault_of_the_manual() {
    let sender = "\"930\" = 1, \"931\" = 10";
    let faults = |takes: &str, more: &str| {
        let mut can = pair(sender, takes, more);
        told(&mut can, 0, STARTED, 1_000);
        (can.ram(2, 260, 0).unwrap(), can.ram(1, 260, 0).unwrap())
    };
    assert_eq!(faults("\"924\" = 385, \"941\" = 40", ""), (0, 0));
    assert_eq!(faults("\"941\" = 40", "").0, 0x2201);
    assert_eq!(faults("\"942\" = 40", "").0, 0x2202);
    assert_eq!(faults("\"945\" = 40", "").0, 0x2203);
    assert_eq!(faults("\"939\" = 40", "").0, 0, "no PDO waits for SYNC (5.11.3)");
    assert_eq!(faults("\"939\" = 40, \"932\" = 2", "").0, 0x2200);
    assert_eq!(faults("\"942\" = 40", "[readings]\nwatch_begins = \"first-telegram\"").0, 0);
    // It came, and then no more: 40 ms later.
    let script = "[[drive.event]]\nat = \"500ms\"\nsilent = \"10s\"\n";
    let text = format!(
        "[[drive]]\nmodel = \"acu\"\naddress = 2\nset = {{ \"924\" = 385, \"941\" = 40 }}\n\
        [[drive]]\nmodel = \"acu\"\nset = {{ {sender} }}\n{script}"
    );
    let mut can = bus(&text);
    told(&mut can, 0, STARTED, 500);
    assert_eq!(told(&mut can, 500, "", 600), "t0828001080000000".to_owned() + "0122 ");
    // Outside Operational nobody waits, or he does.
    let stopped = |more: &str| {
        let mut can = pair(sender, "\"924\" = 385, \"941\" = 40", more);
        told(&mut can, 0, STARTED, 100);
        told(&mut can, 100, "t00028000 ", 500);
        can.ram(2, 260, 0).unwrap()
    };
    assert_eq!((stopped(""), stopped("[readings]\nwatched = \"always\"")), (0, 0x2201));
}

#[test]
fn a_master_drive_answers_an_emergency_as_p_989_says() {
    let text = |reaction: u8, more: &str| {
        format!(
            "{more}\n[[drive]]\nmodel = \"acu\"\naddress = 0\nset = {{ \"989\" = {reaction} }}\n[[drive]]\nmodel = \"acu\"\n\
             address = 26\nset = {{ \"412\" = 1 }}\n[[drive.event]]\nat = \"1s\"\nfault = \"F0500\"\n[[drive.event]]\nat = \"20s\"\n\
             set = {{ \"410\" = 128 }}\n"
        )
    };
    let told = |text: &str| {
        let mut can = bus(text);
        [900, 2_000, 21_000].map(|ms| {
            can.advance(at(ms));
            [can.ram(0, 260, 0).unwrap(), can.ram(0, 270, 0).unwrap(), can.source(0, 730).unwrap()]
        })
    };
    assert_eq!(told(&text(0, "")), [[0, 0, 0], [0x211A, 0x2000, 1], [0x211A, 0, 1]]);
    assert_eq!(told(&text(1, "")), [[0, 0, 0], [0, 0x2000, 1], [0, 0, 0]]);
    let ends = "[readings]\nemergency_ends = \"master\"";
    assert_eq!(told(&text(0, ends))[2], [0x211A, 0x2000, 1]);
}

#[test]
fn behind_a_bus_off_a_node_boots_up_and_tells_of_it() {
    let script = "[[drive.event]]\nat = \"1s\"\nbus_off = \"200ms\"\n";
    let mut can = bus(&(drive("") + script));
    told(&mut can, 0, STARTED, 10);
    assert_eq!(told(&mut can, 900, "t6458409B010000000000 ", 1_000).matches("t5C5").count(), 1);
    assert_eq!(told(&mut can, 1_100, "t6458409B010000000000 ", 1_190), "z ");
    assert_eq!((can.ram(5, 979, 0), can.ram(5, 978, 0), can.ram(5, 260, 0)), (Some(3), Some(1), Some(0x2210)));
    let emergency = "t0858001080000000".to_owned() + "1022 ";
    assert_eq!(told(&mut can, 1_190, "", 1_300), "t705100 ".to_owned() + &emergency);
    assert_eq!(can.ram(5, 979, 0), Some(1));
    let mut other =
        bus(&(drive("[readings]\nback_from_bus_off = \"emergency-first\"\nafter_bus_off = \"bus-off\"") + script));
    told(&mut other, 0, STARTED, 10);
    assert_eq!(told(&mut other, 900, "", 1_300), emergency + "t705100 ");
    assert_eq!(other.ram(5, 979, 0), Some(3));
}

/// A drive that stands in a fault already tells of BUS-OFF all the same (5.12); what it shows stays the first fault.
#[test]
fn who_is_in_a_fault_tells_of_a_bus_off_too() {
    let script =
        "[[drive.event]]\nat = \"500ms\"\nfault = \"F0500\"\n[[drive.event]]\nat = \"1s\"\nbus_off = \"200ms\"\n";
    let mut can = bus(&(drive("") + script));
    told(&mut can, 0, STARTED, 10);
    assert_eq!(told(&mut can, 400, "", 900), "t0858001080000000".to_owned() + "0005 ");
    assert_eq!(told(&mut can, 900, "", 1_300), "t705100 t0858001080000000".to_owned() + "1022 ");
    assert_eq!((can.ram(5, 979, 0), can.ram(5, 260, 0)), (Some(1), Some(0x0500)));
}

#[test]
fn what_no_drive_takes_is_refused() {
    let refused = |more: &str, words: &str| {
        let mut can = bus(&drive(more));
        told(&mut can, 0, OPEN, 10);
        told(&mut can, 20, words, 60).contains("t5C5880")
    };
    // P.936 = 2, P.931 = 0, P.918 = 130; P.954 = 5 beside P.950 = 740.
    for (words, more) in
        [("t645822A8030002000000 ", "rx_functions = \"0-2\""), ("t645822A3030000000000 ", "tx_time_0 = \"silent\"")]
    {
        assert!(refused("", words) && !refused(&format!("[readings]\n{more}"), words), "{words}");
    }
    for (words, more) in [
        ("t64582296030082000000 ", "reserved_identifiers = \"abort-1\""),
        ("t645822B60300E4020000 t645822BA030005000000 ", "shared_byte = \"abort-1\""),
    ] {
        assert!(!refused("", words) && refused(&format!("[readings]\n{more}"), words), "{words}");
    }
}

#[test]
fn a_control_word_and_a_setpoint_over_the_bus_turn_a_shaft() {
    let text = "[[drive]]\nmodel = \"acu\"\nset = { \"930\" = 1, \"950\" = 740, \"955\" = 62, \"228\" = 10 }\n[[drive.event]]\n\
        at = \"1s\"\nset = { \"410\" = 15 }\n[[drive]]\nmodel = \"acu\"\naddress = 2\n\
        set = { \"412\" = 1, \"924\" = 385, \"99\" = 704, \"137\" = 709, \"228\" = 0 }\n";
    let mut can = bus(text);
    told(&mut can, 0, STARTED, 900);
    assert_eq!(can.turning(), [0, 0]);
    can.advance(at(10_000));
    assert_eq!((can.ram(2, 283, 0), can.ram(2, 411, 0).unwrap() & 0x6F), (Some(1_000), 0x27));
}
