//! `procedure`: guided work, step by step, on the bench; what it refuses, what it records, and how it goes on.

use crate::run::antrieb;

const ACT: &str = "[[drive]]\nmodel = \"act\"\n";
const NAME: &str = "procedure-first-contact-1.json";

#[test]
fn the_first_contact_ends_with_a_watchdog_that_is_read_back() {
    let told = antrieb("-a 1 --yes procedure first-contact watchdog=2s").on(ACT).json().exits(0);
    assert_eq!((told.data("/complete"), told.data("/drive")), (&true.into(), &"act".into()));
    let steps = told.data("/steps").as_array().unwrap();
    assert!(steps.iter().all(|step| step["result"] == "done" && step["earlier"] == false), "{steps:#?}");
    let found = |nth: usize| steps[nth]["found"].to_string();
    assert!(found(6).contains("P.1376 Modbus address: 1"), "{}", found(6));
    assert!(found(7).contains("100 of 100 answered"), "{}", found(7));
    assert!(found(8).contains("0 -> 2 s, written, read back"), "{}", found(8));
    // Each step was shown with its warning before anything was done.
    assert!(told.err.contains("[1/9] Inverter dead") && told.err.contains("WARNING: terminals stay"), "{}", told.err);
}

#[test]
fn without_a_time_the_watchdog_is_only_looked_at() {
    let told = antrieb("-a 1 -v --yes procedure first-contact").on(ACT).exits(0);
    assert!(told.out.contains("the drive's watchdog (P.413) is off"), "{}", told.out);
    assert!(!told.sent().iter().any(|sent| sent.starts_with("01 06")), "{:?}", told.sent());
}

#[test]
fn a_no_ends_it_and_the_same_command_goes_on_there() {
    let first = antrieb("-a 1 procedure first-contact").answered("y\ny\nn").on(ACT).exits(8);
    assert!(first.err.contains("the same command goes on with step 3 of 9"), "{}", first.err);
    assert_eq!(first.text_of(NAME).matches("\"done\"").count(), 2, "{}", first.text_of(NAME));
    assert_eq!(first.text_of(NAME).matches("said at the terminal").count(), 2, "{}", first.text_of(NAME));
    // By which family the steps are taken is no answer of a drive.
    assert!(first.out.contains("drive 1 (unknown)"), "{}", first.out);
    let then = first.then("-a 1 procedure first-contact").answered("y\ny\ny\ny").on(ACT).exits(0);
    assert!(!then.err.contains("[2/9]") && then.err.contains("[3/9] Cable and shield"), "{}", then.err);
    assert!(then.out.contains("drive 1 (act)"), "{}", then.out);
    let again = then.then("-a 1 -v procedure first-contact").on(ACT).exits(0);
    assert!(again.sent().is_empty() && again.err.contains("by its record all of it is done"), "{}", again.err);
    let anew = again.then("-a 1 --force procedure first-contact").answered("n").on(ACT).exits(8);
    assert!(anew.err.contains("[1/9]"), "{}", anew.err);
}

#[test]
fn what_was_given_holds_when_it_goes_on_and_other_values_are_another_record() {
    let first = antrieb("-a 1 procedure first-contact watchdog=3s").answered("y\nn").on(ACT).exits(8);
    let other = first.then("-a 1 --yes procedure first-contact watchdog=4s").on(ACT).exits(7);
    assert!(other.err.contains("begun with other values"), "{}", other.err);
    let given =
        other.then("-a 1 --yes procedure first-contact --given {dir}/v.toml").file("v.toml", "watchdog = \"3s\"\n");
    let given = given.on(ACT).exits(0);
    assert!(given.out.contains("0 -> 3 s"), "{}", given.out);
    let first = antrieb("-a 1 procedure first-contact watchdog=3s").answered("y\nn").on(ACT).exits(8);
    let on = first.then("-a 1 procedure first-contact").answered("y\nn").on(ACT).exits(8);
    let on = on.then("-a 1 --yes procedure first-contact").on(ACT).exits(0);
    assert!(on.out.contains("0 -> 3 s"), "{}", on.out);
}

#[test]
fn a_line_that_loses_answers_is_not_good_enough() {
    let lossy = format!("{ACT}[[disturb]]\nevery = 20\nkind = \"lost\"\n");
    let told = antrieb("-a 1 --yes procedure first-contact").on(&lossy).json().exits(1);
    assert_eq!(told.error()["code"], "no.line");
    assert_eq!((told.data("/steps/7/result"), told.data("/steps/8/result")), (&"failed".into(), &"open".into()));
}

#[test]
fn who_answers_must_be_who_was_meant() {
    let told = antrieb("-a 1 --yes procedure first-contact").on("[[drive]]\nmodel = \"lxm05\"\n").json().exits(7);
    assert_eq!(told.error()["code"], "data.other_drive");
    let servo = antrieb("-a 1 --yes --drive lxm05 procedure first-contact watchdog=2s");
    let told = servo.on("[[drive]]\nmodel = \"lxm05\"\n").json().exits(0);
    assert!(told.data("/steps/5/found").to_string().contains("MBnode_guard"), "{:#}", told.value);
}

/// Until the drive has told who it is, the steps are those of a family that is taken for granted, and say so.
#[test]
fn before_anybody_has_asked_the_steps_name_the_family_that_they_are_for() {
    let told = antrieb("-a 1 procedure first-contact").answered("n").on("[[drive]]\nmodel = \"lxm05\"\n").exits(8);
    assert!(told.err.contains("This is the step for act, acu") && told.err.contains("--drive"), "{}", told.err);
    let named =
        antrieb("-a 1 --drive lxm05 procedure first-contact").answered("n").on("[[drive]]\nmodel = \"lxm05\"\n");
    assert!(!named.exits(8).err.contains("This is the step for"));
}

#[test]
fn what_stands_in_the_way_is_told_before_anything_is_sent() {
    let kept = antrieb("-a 1 procedure first-contact").answered("y\nn").on(ACT).exits(8).text_of(NAME);
    for (code, line, word) in [
        (2, "-a 1 --yes procedure nothing", "expected: first-contact"),
        (2, "--yes procedure first-contact", "address of the drive"),
        (2, "-a 1,2 --yes procedure first-contact", "several"),
        (2, "-a 0 --yes procedure first-contact", "everybody"),
        (2, "-a 1 --yes procedure first-contact watchdog", "KEY=VALUE"),
        (2, "-a 1 --yes procedure first-contact power=1", "knows no value 'power'"),
        (7, "-a 1 --yes procedure first-contact watchdog=30000s", "P.413"),
        (7, "-a 1 --yes procedure first-contact watchdog=0s", "no watchdog"),
        (7, "-a 1 --yes --drive x200 procedure first-contact", "no manual describes"),
        (7, "-a 1 --yes procedure first-contact --record {dir}/bench.toml", "no record of a procedure"),
        (7, "-a 2 --yes procedure first-contact --record {dir}/kept.json", "with drive 1"),
        (7, "-a 1 --yes procedure first-contact --record {dir}/no/such.json", "such.json"),
        (8, "-a 1 procedure first-contact", "no terminal"),
    ] {
        let told = antrieb(line).file("kept.json", &kept).on(ACT).and("-v").exits(code);
        assert!(told.err.contains(word), "{line}: {}", told.err);
        assert!(told.sent().is_empty(), "{line}: {}", told.err);
    }
}

#[test]
fn a_dry_run_opens_nothing_and_keeps_nothing() {
    let told = antrieb("-a 1 --dry-run procedure first-contact watchdog=2s").on(ACT).and("-v").exits(0);
    assert!(told.sent().is_empty() && told.out.contains("write P.413@0"), "{}\n{}", told.out, told.err);
    assert!(!told.directory().join(NAME).exists());
}

#[test]
fn a_report_shows_what_was_done_in_either_language() {
    for (lang, words) in [
        ("en", ["Procedure: First contact", "9/9", "watchdog = 2s", "written, read back"]),
        ("de", ["Prozedur: Erster Kontakt", "9/9", "watchdog = 2s", "geschrieben, zurückgelesen"]),
    ] {
        let done = antrieb("-a 1 --yes procedure first-contact watchdog=2s").on(ACT).exits(0);
        let line =
            format!("-a 1 --lang {lang} report --count 5 {{dir}}/r.html {{dir}}/r.md --procedure {{dir}}/{NAME}");
        let told = done.then(&line).on(ACT).exits(0);
        for word in words {
            assert!(told.text_of("r.html").contains(word) && told.text_of("r.md").contains(word), "{lang}: {word}");
        }
    }
}
