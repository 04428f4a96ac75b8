//! What `antrieb.toml` states of a drive is asked, because another one may stand there by now; what was typed is believed.

use crate::run::{Run, antrieb};

const ACT: &str = "[[drive]]\nmodel = \"act\"\naddress = 1\nset = { \"412\" = 1 }\n";

/// A plant in which drive 1 is said to be of this family.
fn stating(drive: &str, line: &str) -> Run {
    let project = format!("[drives.pump]\naddress = 1\ndrive = \"{drive}\"\n");
    antrieb(line).file("antrieb.toml", &project).on(ACT)
}

const TOLD: &str =
    "antrieb.toml: drives.pump says that drive 1 is of the family 'acu'; it answers as 'act', which is taken";

#[test]
fn who_reads_a_drive_that_was_exchanged_gets_its_own_words_and_is_told_so() {
    for line in
        ["read 480@3", "diag", "sollwert", "statemachine", "identify", "monitor --count 1", "diag line --count 2"]
    {
        let run = stating("acu", &format!("-a pump {line}")).exits(0);
        assert_eq!(run.err.matches(TOLD).count(), 1, "{line}: {}", run.err);
        let german = stating("acu", &format!("--lang de -a pump {line}")).exits(0).err;
        assert!(german.contains("er antwortet als 'act'"), "{line}: {german}");
    }
    let who = stating("acu", "-a pump identify").json().exits(0);
    assert_eq!(who.data("/drives/0/drive"), "act");
    assert!(who.data("/drives/0/evidence").to_string().contains("ACT"), "{:#}", who.value);
    // Bit 4 of its status word is always 0, and says nothing of its mains.
    let missing = stating("acu", "-a pump diag").exits(0).out;
    assert!(!missing.contains("bit 4"), "{missing}");
}

#[test]
fn who_writes_to_a_drive_that_was_exchanged_is_refused_before_anything_is_sent() {
    for line in [
        "write 480@3=7 --yes",
        "dataset select 2 --yes",
        "dataset copy 1 2 480 --yes",
        "line set --address 9 --yes",
        "sollwert 5Hz --jog 1s --take-control --yes",
        "statemachine enable --take-control --yes",
    ] {
        let run = stating("acu", &format!("-v -a pump {line}")).exits(7);
        let told = "expected a drive of the family 'acu', address 1 is of the family 'act'; nothing was changed";
        assert!(run.err.contains(told) && run.err.contains("hint: if this drive is meant: --drive act"), "{}", run.err);
        let asks = |sent: &String| ["01 03", "01 2B", "01 64", "01 08"].iter().any(|code| sent.starts_with(code));
        assert!(run.sent().iter().all(asks), "{line}: {:?}", run.sent());
        // Who types it knows.
        stating("acu", &format!("-a pump --drive act {line} --dry-run")).run();
    }
    stating("acu", "-a pump --drive act write 480@3=7 --yes").exits(0);
}

#[test]
fn a_backup_is_of_the_drive_that_answers_and_goes_back_into_it() {
    let saved = stating("acu", "-a pump dataset save {dir}/pump.toml").exits(0);
    let text = saved.text_of("pump.toml");
    assert!(text.contains("family = \"act\"") && !text.contains("--drive"), "{text}");
    let loaded = saved.then("-a pump -p sim:{dir}/bench.toml dataset load {dir}/pump.toml --yes").exits(0);
    assert_eq!(loaded.err.matches(TOLD).count(), 1, "{}", loaded.err);
    let checked = loaded.then("-a pump -p sim:{dir}/bench.toml dataset check {dir}/pump.toml").exits(0);
    assert!(checked.err.contains(TOLD), "{}", checked.err);
    // Of the right family it is told by what answered, and not by a --drive that nobody gave.
    let text = stating("act", "-a pump dataset save {dir}/pump.toml").exits(0).text_of("pump.toml");
    assert!(text.contains("code 100, P.484") && !text.contains("--drive"), "{text}");
    let text = stating("acu", "-a pump --drive act dataset save {dir}/pump.toml").exits(0).text_of("pump.toml");
    assert!(text.contains("--drive: act (as given)"), "{text}");
}

/// A drive is asked once, as if nobody had said anything.
#[test]
fn what_is_stated_costs_no_telegram_more_than_what_nobody_said() {
    for line in ["read 480@3", "diag", "identify", "write 480@3=7 --yes", "dataset show 480", "sollwert 0"] {
        let stated = stating("act", &format!("-v -a pump {line}")).run();
        let unsaid = antrieb(&format!("-v -a 1 {line}")).on(ACT).run();
        let asked_for_who = |run: &crate::run::Output| {
            run.sent().iter().filter(|sent| sent.starts_with("01 2B") || sent.starts_with("01 64 03 01 E4")).count()
        };
        assert!(asked_for_who(&stated) <= asked_for_who(&unsaid), "{line}: {:?}", stated.sent());
        assert!(!stated.err.contains("is of the family"), "{}", stated.err);
    }
}

#[test]
fn a_stop_says_its_first_word_in_the_family_that_is_stated_and_asks_behind_it() {
    for line in ["quick-stop", "disable", "disable-voltage"] {
        let first = |project: &str, drive: &str| {
            let line = format!("-v -a pump {drive} statemachine {line}");
            let run = stating(project, &line).run();
            run.sent().into_iter().next().unwrap()
        };
        assert_eq!(first("acu", ""), first("acu", "--drive acu"), "{line}");
    }
    // Without power nothing shows that the shaft stands: 8.
    let stopped = stating("acu", "-a pump statemachine quick-stop").json().exits(8);
    assert_eq!(stopped.data("/drive"), "act");
    assert!(stopped.err.contains(TOLD), "{}", stopped.err);
    // A family whose words it refuses: those of the others go out, and it is told what it is.
    let other = stating("lxm05", "-a pump statemachine quick-stop").json().exits(8);
    assert_eq!(other.data("/drive"), "act");
    // What is stated is all that is known of a stranger, and enough for a stop.
    let strange = "[[drive]]\nmodel = \"foreign\"\naddress = 1\n";
    let project = "[drives.pump]\naddress = 1\ndrive = \"acu\"\n";
    let run = antrieb("-v -a pump statemachine quick-stop").file("antrieb.toml", project).on(strange).run();
    assert!(run.sent().first().unwrap().starts_with("01 06"), "{:?}", run.sent());
    assert!(run.err.contains("MAY STILL TURN"), "{}", run.err);
}

const PUMPS: &str = "schema = 1\nfamily = \"hydra\"\ntitle = { en = \"Hydra\", de = \"Hydra\" }\n\
                     drives = [{ id = \"hydra3\", en = \"Hydra 3\", de = \"Hydra 3\" }]\n\
                     params = [{ id = 100, slug = \"speed\", en = \"Speed\", de = \"Drehzahl\", decimals = 0, type = \"int\", \
                     access = \"rw\" }]\n[link]\nroute = \"registers\"\n[groups]\nactual = [100]\n";

#[test]
fn a_family_that_no_question_tells_is_believed_unless_another_drive_says_what_it_is() {
    let project = "catalogue = [\"hydra.toml\"]\n[drives.pump]\naddress = 1\ndrive = \"hydra3\"\n";
    let hydra =
        |line: &str, bench: &str| antrieb(line).file("antrieb.toml", project).file("hydra.toml", PUMPS).on(bench);
    let own = "[[drive]]\nmodel = \"foreign\"\naddress = 1\nregisters = { 100 = 7 }\n";
    assert_eq!(hydra("-a pump read speed", own).json().exits(0).data("/values/0/drive"), "hydra3");
    hydra("-a pump write speed=8 --yes", own).exits(0);
    let who = hydra("-a pump identify", own).json().exits(0);
    assert_eq!(who.data("/drives/0/drive"), "hydra3");
    assert!(who.data("/drives/0/evidence").to_string().contains("drives.pump"), "{:#}", who.value);
    assert!(hydra("-a pump write speed=8 --yes", ACT).exits(7).err.contains("of the family 'hydra3', address 1 is"));
}

/// Who has no time to say what it is, is what the file says.
#[test]
fn a_busy_drive_is_believed() {
    let busy = "[[drive]]\nmodel = \"foreign\"\nbusy = true\n";
    let project = "[drives.pump]\naddress = 1\ndrive = \"act\"\n";
    let read = antrieb("-a pump identify").file("antrieb.toml", project).on(busy).json();
    assert_eq!(read.data("/drives/0/drive"), "act");
    antrieb("-a 1 read 372").on(busy).exits(6);
}
