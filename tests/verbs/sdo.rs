//! Parameters over the system bus, behind an adapter that speaks SLCAN: under every reading of the manual, with every kind of adapter, and
//! beside others; the bus itself is asked.

use crate::run::antrieb;
use antrieb::simulator::Can;
use antrieb::transport::witness;

/// An ACU as node 5, with more on the bus.
fn bus(more: &str) -> String {
    format!("{more}\n[[drive]]\nmodel = \"acu\"\naddress = 5\nset = {{ \"382\" = -12.5 }}\n")
}

/// The bus as it was left.
fn left() -> Can {
    witness::left_can().unwrap()
}

/// Nobody was disturbed, and the adapter takes no part any more.
fn is_clean(bus: &Can) -> bool {
    bus.remarks().is_empty() && bus.orders().is_empty() && !bus.is_open()
}

const MASTER: &str = "[[drive]]\nmodel = \"acu\"\naddress = 0\nset = { \"919\" = 100 }\n";

/// Every reading, and every kind of adapter.
const BUSES: [&str; 17] = [
    "",
    "[readings]\nbelow_zero = \"extended\"",
    "[readings]\nword_tail = \"abort-1\"",
    "[readings]\nsegments = \"silence\"",
    "[readings]\nsegments = \"abort-10\"",
    "[readings]\nset_of_none = \"taken\"",
    "[readings]\nplace = \"at-once\"",
    "[readings]\nplace = \"reset-node\"",
    "[readings]\nmaster_boots_up = \"yes\"\nmaster_sdo1 = \"served\"",
    "[bus]\nlosses = 100",
    "[adapter]\nacknowledges = false",
    "[adapter]\nlistens = false",
    "[adapter]\nbell = \"40ms\"",
    "[adapter]\nlatency = \"16ms\"",
    "[[foreign]]\nframe = \"185#0102030405060708\"\nevery = \"1ms\"",
    "[[foreign]]\nframe = \"00000123#01\"\nevery = \"3ms\"",
    "[[foreign]]\nframe = \"605#409B010000000000\"\nevery = \"40ms\"",
];

#[test]
fn values_come_whatever_the_bus_and_the_adapter_are_like() {
    for more in BUSES {
        let run = antrieb("--protocol sdo -a 5 read 900 382@1 480 413").on(&bus(more)).json().exits(0);
        let raw: Vec<_> = run.data("/values").as_array().unwrap().iter().map(|value| value["raw"].clone()).collect();
        assert_eq!(raw, [5, -125, 500, 0], "{more}");
        assert!(is_clean(&left()), "{more}: {:?}", left_remarks(more));
    }
}

fn left_remarks(more: &str) -> Vec<String> {
    antrieb("--protocol sdo -a 5 read 900").on(&bus(more)).run();
    left().remarks().to_vec()
}

#[test]
fn what_is_written_is_read_back() {
    for more in BUSES {
        let typed = "--protocol sdo -a 5 --yes write 382@1=-7.5 480@2=6Hz 413=2";
        let run = antrieb(typed).on(&bus(more)).json().exits(0);
        (0..3).for_each(|row| assert_eq!(run.data(&format!("/values/{row}/result")), "verified", "{more}"));
        let bus = left();
        let raw = [bus.eeprom(5, 382, 1), bus.eeprom(5, 480, 2), bus.eeprom(5, 413, 0)];
        assert_eq!(raw, [Some(-75), Some(600), Some(2)], "{more}");
        assert!(is_clean(&bus), "{more}: {:?}", bus.remarks());
        assert_eq!(bus.counts()[2], 3, "{more}: no cell is written twice");
    }
}

#[test]
fn an_abort_is_told_with_its_cause() {
    for (more, what, code) in [
        ("", "1234", "unknown_parameter"),
        ("", "484", "not_readable"),
        ("", "904@2", "data_set_not_permitted"),
        ("[readings]\nram_sets = \"abort-2\"", "480@1ram", "data_set_not_permitted"),
        ("[readings]\nown_parameters = \"abort-11\"", "904", "unknown_parameter"),
    ] {
        let run = antrieb(&format!("--protocol sdo --drive acu -a 5 read {what}")).on(&bus(more)).json().exits(6);
        assert_eq!(run.error()["code"], format!("refused.{code}"), "{what}");
        assert!(run.error()["message"].as_str().unwrap().contains("SDO abort"));
        assert!(is_clean(&left()));
    }
}

#[test]
fn a_bus_with_a_master_hears_nothing_but_what_was_asked_for() {
    let text = bus("") + MASTER;
    antrieb("--protocol sdo -a 5 read 411").on(&text).exits(0);
    let bus = left();
    assert!(is_clean(&bus) && bus.counts()[0] > 0, "{:?}", bus.remarks());
    // SDO1 is the master's, as soon as he is heard.
    let run = antrieb("--protocol sdo1 -a 5 read 411").on(&text.replace("919\" = 100", "919\" = 0")).run();
    assert!([0, 8].contains(&run.exit), "a master that was silent for so long is not known");
    let beats = "[[foreign]]\nframe = \"080#\"\nevery = \"100ms\"";
    for more in [beats, "[[foreign]]\nframe = \"605#409B010000000000\"\nevery = \"500ms\""] {
        let run = antrieb("--protocol sdo1 -a 5 read 411").on(&self::bus(more)).json().exits(8);
        assert_eq!(run.error()["code"], "forbidden.other_master");
        assert_eq!(left().counts()[0], 0, "nothing was sent");
    }
}

#[test]
fn another_tool_on_its_channel_is_left_alone() {
    let text = bus("[[foreign]]\nframe = \"647#409B010000000000\"\nevery = \"1s\"");
    let run = antrieb("--protocol sdo -a 5 read 411").on(&text).json().exits(8);
    assert_eq!(run.error()["code"], "forbidden.other_tool");
    let end = left();
    assert!(end.counts()[0] == 0 && !end.is_open());
    antrieb("--protocol sdo1 -a 5 read 411").on(&text).exits(0);
}

/// Another tool that begins when the bus was listened to already: each of its frames is told as what it is, and none as garbage.
#[test]
fn what_another_tool_says_on_our_channel_is_no_garbage() {
    let row = |frame: &str| format!("[[foreign]]\nframe = \"{frame}\"\nevery = \"2s\"\n");
    let text = bus(&(row("646#40F4010000000000") + &row("5C6#80F401000B000000")));
    let run = antrieb("--protocol sdo -a 6 --timeout 1s -v read 411").on(&text).exits(5);
    assert!(run.err.contains("does not fit the question") && !run.err.contains("garbage"), "{}", run.err);
    assert!(run.err.contains("somebody else asks: SDO2 node 6"), "{}", run.err);
    assert!(run.err.contains("not the answer, from address 6: SDO2 node 6"), "{}", run.err);
}

#[test]
fn another_bit_rate_is_told_before_anything_is_sent() {
    let busy = bus("[bus]\nrate = 250000\n[[foreign]]\nframe = \"185#01\"\nevery = \"100ms\"");
    let run = antrieb("--protocol sdo -a 5 read 411").on(&busy).json().exits(5);
    assert_eq!(run.error()["code"], "garbled.bit_rate");
    let end = left();
    assert!(!end.is_open(), "the channel is closed again");
    assert!(end.remarks().is_empty() && left_counts(&busy) == 0, "who only listens disturbs nobody");
    antrieb("--protocol sdo -b 250000 -a 5 read 411").on(&busy).exits(0);
    // A silent bus shows it only when something was sent.
    let silent = bus("[bus]\nrate = 250000");
    let run = antrieb("--protocol sdo -a 5 read 411").on(&silent).json().exits(4);
    assert_eq!(run.error()["code"], "silence.no_acknowledge");
}

fn left_counts(text: &str) -> u64 {
    antrieb("--protocol sdo -a 5 read 411").on(text).run();
    left().counts()[0]
}

#[test]
fn an_adapter_that_does_not_do_it_is_told() {
    let run = antrieb("--protocol sdo -a 5 read 411").on(&bus("[adapter]\nlacks = 6")).json().exits(3);
    assert_eq!(run.error()["code"], "port.can_rate");
    let run = antrieb("--protocol sdo -b 600000 -a 5 read 411").on(&bus("")).json().exits(2);
    assert_eq!(run.error()["code"], "usage.baud");
}

#[test]
fn a_port_that_is_lost_is_told_at_every_telegram() {
    for telegrams in 0..24 {
        witness::pull_after(Some(telegrams));
        let run = antrieb("--protocol sdo -a 5 read 411 900").on(&bus("")).run();
        witness::pull_after(None);
        assert!([0, 3].contains(&run.exit), "{telegrams}: {}", run.err);
    }
}

#[test]
fn who_is_not_there_is_silent_and_the_hint_says_what_may_be() {
    let run = antrieb("--protocol sdo -a 6 read 411").on(&bus("")).json().exits(4);
    assert_eq!(run.error()["code"], "silence.no_reply");
    assert!(run.error()["hint"].as_str().unwrap().contains("P.923"));
    let off = bus("").replace("\"382\" = -12.5", "\"923\" = 0");
    antrieb("--protocol sdo -a 5 read 411").on(&off).exits(4);
    antrieb("--protocol sdo1 -a 5 read 411").on(&off).exits(0);
    let factory = bus("").replace("\"382\" = -12.5", "\"900\" = -1");
    let run = antrieb("--protocol sdo -a 5 read 411").on(&factory).json().exits(4);
    assert_eq!(run.error()["code"], "silence.no_acknowledge");
}

#[test]
fn what_cannot_be_meant_is_refused_before_the_adapter_is_opened() {
    for (typed, exit) in [
        ("--protocol sdo read 411", 2),
        ("--protocol sdo -a 0 read 411", 2),
        ("--protocol sdo -a 65 read 411", 2),
        ("--protocol sdo -a 5 --parity even read 411", 2),
        ("--protocol sdo -b auto scan", 2),
        ("--protocol sdo -a 5 --yes dataset copy 1 2 480", 2),
        ("--protocol sdo -a 5 --yes sollwert 5Hz", 2),
        ("--protocol sdo -a 5 --yes write 900=7", 8),
        ("--protocol sdo -a 5 --yes write 923=0", 8),
        ("--protocol sdo -a 5 --yes write 1234=7", 7),
    ] {
        antrieb(typed).on(&bus("")).exits(exit);
        assert!(witness::left_can().is_none(), "{typed}");
    }
    for typed in [
        "-p slcan:/dev/ttyACM0 --protocol rtu -b 500000 -a 5 read 411",
        "-p slcan:/dev/ttyACM0 -a 5 read 411",
        "-p /dev/ttyUSB0 --protocol sdo -b 500000 -a 5 read 411",
        "-p slcan:mbtcp://host -b 500000 -a 5 read 411",
    ] {
        antrieb(typed).exits(2);
    }
}

#[test]
fn the_other_verbs_that_speak_it_do() {
    let run = antrieb("--protocol sdo -a 5 identify").on(&bus("")).json().exits(0);
    assert_eq!(run.data("/drives/0/drive"), "acu");
    antrieb("--protocol sdo -a 5 diag").on(&bus("")).exits(0);
    // The bus tells more of it: state of node and controller, and what it says of its fault while it is asked.
    let trips = bus("") + "[[drive.event]]\nat = \"1s\"\nfault = \"F0503\"\n";
    let run = antrieb("--protocol sdo -a 5 diag").on(&trips).json().exits(0);
    let states: Vec<_> =
        run.data("/drives/0/bus/values").as_array().unwrap().iter().map(|row| row["param"].clone()).collect();
    assert_eq!(states, [978, 979]);
    assert!(run.data("/drives/0/bus/emergencies/0").as_str().unwrap().contains("F0503"));
    let page = antrieb("--protocol sdo -a 5 diag").on(&trips).exits(0).out;
    assert!(page.contains("EM-S1IND 0") && page.contains("Node state") && page.contains("emergency"), "{page}");
    antrieb("--protocol sdo -a 5 monitor --count 2 411").on(&bus("")).exits(0);
    let run = antrieb("--protocol sdo -a 5 read 411 --dry-run").on(&bus("")).json().exits(0);
    assert_eq!(run.data("/telegrams/0/hex"), "645#40 9B 01 00 00 00 00 00");
}

#[test]
fn a_bus_without_a_master_is_asked_node_by_node() {
    for more in BUSES.into_iter().filter(|more| !more.contains("losses")) {
        let text = bus(more) + "[[drive]]\nmodel = \"act\"\naddress = 63\n";
        let run = antrieb("--protocol sdo scan").on(&text).json().exits(0);
        let drives = run.data("/drives").as_array().unwrap();
        let found: Vec<_> = drives.iter().map(|drive| (drive["address"].clone(), drive["drive"].clone())).collect();
        assert_eq!(found, [(5.into(), "acu".into()), (63.into(), "act".into())], "{more}");
        assert!(run.warnings().contains(&"scan.no_master_heard"), "{more}");
        assert!(is_clean(&left()), "{more}");
    }
}

#[test]
fn a_bus_with_a_master_is_only_listened_to() {
    let shows = "[[foreign]]\nframe = \"185#01\"\nevery = \"200ms\"\n[[foreign]]\nframe = \"707#00\"\nevery = \"2s\"\n";
    let text = bus(&(shows.to_owned() + "[[foreign]]\nframe = \"080#\"\nevery = \"100ms\""));
    let run = antrieb("--protocol sdo scan").on(&text).json().exits(8);
    assert_eq!(run.error()["code"], "forbidden.other_master");
    let drives = run.data("/drives").as_array().unwrap();
    let told: Vec<_> =
        drives.iter().map(|drive| (drive["address"].clone(), drive["evidence"][0]["answered"].clone())).collect();
    assert_eq!(told, [(5.into(), "PDO".into()), (7.into(), "boot-up".into())]);
    assert_eq!(left().counts()[0], 0, "nothing was sent");
    let run = antrieb("--protocol sdo --force scan").on(&text).json().exits(0);
    assert_eq!(run.data("/drives/0/drive"), "acu");
    assert!(left().remarks().is_empty());
}

/// Every SDO has eight bytes (EM-RES-03 manual 5.10.1): who answers with fewer is there, and disturbed.
#[test]
fn who_answers_with_frames_that_are_too_short_is_told_as_that() {
    let text = bus("[[foreign]]\nframe = \"5C6#429B0100\"\nevery = \"60ms\"");
    let run = antrieb("--protocol sdo -a 6 read 411").on(&text).json().exits(5);
    assert_eq!(run.error()["code"], "garbled.short", "{:#}", run.value);
    assert!(run.error()["message"].as_str().unwrap().contains("4 bytes"), "{}", run.error());
    assert!(is_clean(&left()));
    let one = text.replace("5C6#429B0100", "5C6#42");
    let run = antrieb("--protocol sdo -a 6 read 411").on(&one).json().exits(5);
    assert!(run.error()["message"].as_str().unwrap().contains("1 byte,"), "{}", run.error());
    let shown = antrieb("--protocol sdo -a 6 -v read 411").on(&text).exits(5);
    assert!(shown.err.contains("5C6#42 9B 01 00"), "{}", shown.err);
    let found = antrieb("--protocol sdo -a 1-10 scan").on(&text).json().exits(0);
    let drives = found.data("/drives").as_array().unwrap();
    let rows: Vec<_> = drives.iter().map(|row| (row["address"].as_u64(), row["drive"].as_str())).collect();
    assert_eq!(rows, [(Some(5), Some("acu")), (Some(6), Some("unknown"))], "{:#}", found.value);
    assert!(found.value.to_string().contains("4 bytes in place of 8"), "{:#}", found.value);
    // Others are understood beside it.
    antrieb("--protocol sdo -a 5 read 480").on(&text).exits(0);
}

/// An EEPROM that fails may have taken it, or the RAM alone (manual 5.10.1, code 6; CM-485 manual 7).
#[test]
fn what_a_refusal_leaves_open_is_read_back() {
    for (reading, stands, result) in
        [("", "does not stand there", "refused"), ("ram_reads = \"in-force\"", "stands there all the same", "unknown")]
    {
        let drive = format!("eeprom = {{ \"480@2\" = \"refuses\" }}\nreadings = {{ {reading} }}\n");
        let over_sdo = format!("{}{drive}", bus(""));
        let over_modbus = format!("[[drive]]\nmodel = \"acu\"\naddress = 5\n{drive}");
        for (typed, bench) in [("--protocol sdo", over_sdo), ("", over_modbus)] {
            let run = antrieb(&format!("{typed} -a 5 --yes write 480@2=6Hz")).on(&bench).json().exits(6);
            assert_eq!(run.error()["code"], "refused.eeprom_write_error");
            let message = run.error()["message"].as_str().unwrap();
            assert!(message.contains(stands), "{typed}: {message}");
            assert_eq!(*run.data("/values/0/result"), result, "{typed}: {message}");
        }
    }
}

/// The drive that answers as 64 is the master: nothing else is said of a master then.
#[test]
fn a_scan_that_finds_the_master_drive_says_so() {
    let quiet = bus("") + &MASTER.replace("\"919\" = 100", "\"919\" = 0, \"904\" = 50000");
    let run = antrieb("--protocol sdo scan").on(&quiet).json().exits(0);
    let codes: Vec<_> = run.value["warnings"].as_array().unwrap().iter().map(|row| row["code"].clone()).collect();
    assert_eq!(codes, ["scan.master_drive"]);
    let told = run.value["warnings"][0]["message"].as_str().unwrap();
    assert!(told.contains("64 is node 0") && told.contains("-a master"), "{told}");
    let both = antrieb("--protocol sdo -a master,5 read 900").on(&quiet).json().exits(0);
    let raw: Vec<_> = both.data("/values").as_array().unwrap().iter().map(|row| row["raw"].clone()).collect();
    assert_eq!(raw, [0, 5]);
    let serial = antrieb("-a 1,master read 900").on("[[drive]]\nmodel = \"acu\"\n").exits(2).err;
    assert!(serial.contains("CAN bus"), "{serial}");
}
