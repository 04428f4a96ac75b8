//! `sniff` on a PROFIBUS line: telegrams of any master, as real devices have sent them.

use crate::run::antrieb;

/// FDL status; Slave_Diag of a slave that waits for parameters; Set_Prm, acknowledged; the same exchange asked twice, and answered; garbage.
const TAPE: &str = "# antrieb trace 1, 19200 8E1, dp\n\
    0 < 10 08 02 49 53 16\n8000 < 10 02 08 00 0A 16\n\
    20000 < 68 05 05 68 88 82 6D 3C 3E F1 16\n30000 < 68 0B 0B 68 82 88 08 3E 3C 02 05\n31000 < 00 FF 0A 35 D1 16\n\
    50000 < 68 0C 0C 68 88 82 5D 3D 3E 88 C8 01 0B 0A 35 00 7D 16\n60000 < E5\n\
    80000 < 68 07 07 68 08 02 5D 04 7E 00 00 E9 16\n100000 < 68 07 07 68 08 02 5D 04 7E 00 00 E9 16\n\
    110000 < 68 07 07 68 02 08 08 00 31 00 00 43 16\n200000 < 55 AA\n300000 < 10 08 02 49 53 16\n";

#[test]
fn every_telegram_of_any_master_is_told() {
    let run = antrieb("-p tape:{dir}/t --protocol dp sniff --cfg ppo3 --duration 1s").file("t", TAPE).json().exits(0);
    let telegrams = run.data("/telegrams").as_array().unwrap();
    let told = |at: usize, key: &str| telegrams[at][key].as_str().unwrap_or("-").to_owned();
    let directions: Vec<_> = (0..telegrams.len()).map(|at| told(at, "direction")).collect();
    let [ask, answer] = ["request", "reply"];
    assert_eq!(directions, [ask, answer, ask, answer, ask, answer, ask, ask, answer, "-", ask]);
    assert!(told(3, "meaning").contains("Station_Not_Ready") && told(4, "meaning").contains("ident 0A35h"));
    assert!(told(6, "meaning").contains("047Eh") && told(8, "meaning").contains("0031h"));
    assert_eq!((told(9, "hex"), &telegrams[9]["check_ok"]), ("55 AA".to_owned(), &false.into()));
    assert_eq!(telegrams[5]["address"], 8, "SC is of whoever was asked");
    assert_eq!(
        (run.data("/protocol"), run.data("/heard"), run.data("/garbled")),
        (&"dp".into(), &11.into(), &1.into())
    );
    let station = run.data("/stations/0");
    let counted = ["address", "requests", "replies", "unanswered"].map(|key| station[key].as_u64().unwrap());
    assert_eq!(counted, [8, 6, 4, 2], "the last one too");
    assert_eq!(station["repeats"][0]["times"], 1);
}

/// The bench is a PROFIBUS line for who listens there, and a recording of that says what was spoken, or `decode` takes it for Modbus.
#[test]
fn the_bench_is_listened_to_and_recorded() {
    let bench = "[[module]]\ndrive = \"l200\"\naddress = 3\n[[master]]\naddress = 2\nat = \"100ms\"\nby = \"5s\"\nevery = \"50ms\"\n";
    let run = antrieb("--protocol dp --trace {dir}/t sniff --duration 1s").on(bench).exits(0);
    assert!(run.out.contains("token"), "{}", run.out);
    assert!(run.text_of("t").starts_with("# antrieb trace 1, 19200 8E1, dp\n"), "{}", run.text_of("t"));
    let decoded = run.then("decode trace {dir}/t").exits(0);
    assert!(decoded.out.contains("token"), "{}", decoded.out);
}

#[test]
fn filters_count_and_the_setting_are_those_of_every_line() {
    let only = "-p tape:{dir}/t --protocol dp --baud 19200 sniff --filter 'address=8 reply' --count 2";
    let run = antrieb(only).file("t", TAPE).json().exits(0);
    assert_eq!(run.data("/telegrams").as_array().unwrap().len(), 2);
    let run = antrieb("-p tape:{dir}/t --protocol dp sniff").file("t", "# antrieb trace 1, 19200 8E1, dp\n").exits(4);
    assert!(run.err.contains("profibus live"), "{}", run.err);
    for typed in ["--protocol dp sniff --search", "sniff --cfg ppo1"] {
        antrieb(&format!("-p tape:{{dir}}/t {typed}")).file("t", TAPE).exits(2);
    }
}
