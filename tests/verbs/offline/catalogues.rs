//! Catalogues of the user: rows that join and rows that replace; hostile ones are refused with their place.

use crate::run::{Document, antrieb};

const HEAD: &str = "schema = 1\nfamily = \"active\"\n";

fn rows(rows: &str) -> String {
    format!("{HEAD}params = [\n{rows}\n]\n")
}

/// A catalogue must be refused, at this place, for this reason, whatever the verb.
#[track_caller]
fn refused(text: &str, place: &str, why: &str) -> Document {
    antrieb("--catalogue {dir}/mine.toml -p sim -a 1 read 372").file("mine.toml", text).json().exits(7);
    let document = antrieb("--catalogue {dir}/mine.toml params 372").file("mine.toml", text).json().exits(7);
    let message = document.error()["message"].as_str().unwrap();
    assert_eq!(document.error()["code"], "data.catalogue");
    assert!(message.contains(&format!("mine.toml:{place}")), "{place}: {message}");
    assert!(message.contains(why), "{why}: {message}");
    assert!(message.len() < 1_000 && !message.chars().any(char::is_control), "{message:?}");
    document
}

#[test]
fn a_row_of_the_user_is_known_to_every_verb() {
    let text = rows(
        "{ id = 1500, slug = \"pump-head\", de = \"Förderhöhe\", en = \"Pump head\", unit = \"m\", decimals = 2, \
         type = \"uint\", min = 0, max = 99.99, access = \"rw\" },",
    );
    let run = |line: &str| antrieb(&format!("--catalogue mine.toml {line}")).file("mine.toml", &text);
    let doc = run("params pump-head").json().exits(0);
    assert_eq!((doc.data("/params/0/max"), doc.data("/params/0/unit")), (&99.99.into(), &"m".into()));
    assert!(doc.data("/params/0/origin").as_str().unwrap().ends_with("mine.toml"));
    assert_eq!(run("-p sim -a 1 read forderhohe").json().exits(0).data("/values/0/param"), 1500);
    assert_eq!(run("-p sim -a 1 --yes write 1500=100").json().exits(7).error()["code"], "data.range");
    let decoded = run("--lang de decode telegram 01 03 05 DC 00 01 45 3C").json().exits(0);
    assert!(decoded.data("/telegrams/0/meaning").as_str().unwrap().contains("P.1500@0 Förderhöhe"));
    let planned = run("-a 1 --dry-run write pump-head@0='12,5 m'").json().exits(0);
    assert_eq!(planned.data("/values/0/raw"), 1250);
}

#[test]
fn a_row_replaces_only_when_it_says_so() {
    let row = |rest: &str| {
        rows(&format!(
            "{{ id = 372, slug = \"rated-speed\", de = \"Neu\", en = \"New\", type = \"uint\", access = \"rw\"{rest} }},"
        ))
    };
    refused(&row(""), "4:1", "add `replace = true`");
    let document = antrieb("--catalogue {dir}/mine.toml -p sim -a 1 read 372")
        .file("mine.toml", &row(", replace = true"))
        .json()
        .exits(0);
    assert_eq!(document.data("/values/0/name"), "New");
    assert!(document.data("/values/0/origin").as_str().unwrap().ends_with("mine.toml"));
}

#[test]
fn later_catalogues_win_and_the_users_directory_comes_first() {
    let named = |name: &str| {
        rows(&format!(
            "{{ id = 372, slug = \"rated-speed\", de = \"x\", en = \"{name}\", access = \"rw\", replace = true }},"
        ))
    };
    let run = |line: &str| {
        antrieb(&format!("-p sim -a 1 {line} read 372"))
            .user_file("catalogues/a.toml", &named("user"))
            .file("one.toml", &named("one"))
            .file("two.toml", &named("two"))
    };
    let name = |line: &str| run(line).json().exits(0).data("/values/0/name").as_str().unwrap().to_owned();
    assert_eq!(name(""), "user");
    assert_eq!(name("--catalogue one.toml"), "one");
    assert_eq!(name("--catalogue one.toml --catalogue two.toml"), "two");
    assert_eq!(name("--no-config"), "Rated Speed");
    let project = run("").file("antrieb.toml", "catalogue = [\"two.toml\"]\n").json().exits(0);
    assert_eq!(project.data("/values/0/name"), "two");
}

#[test]
fn bad_toml_and_unknown_keys_are_refused_with_their_place() {
    refused("schema = 1\nfamily = \"active\n", "2:", "");
    refused(&rows("{ id = 1500, de = \"x\", en = \"x\", access = \"r\", colour = 1 },"), "4:", "colour");
    refused(&rows("{ id = 1500, de = \"x\", en = \"x\", access = \"x\" },"), "4:43", "expected one of `r`, `w`, `rw`");
    refused(&rows("{ de = \"x\", en = \"x\", access = \"r\" },"), "4:1", "missing field");
    refused(
        &rows("{ id = 1500, de = \"x\", en = \"x\", access = \"r\", min = 2, max = 1 },"),
        "4:1",
        "`min` is above `max`",
    );
    refused("schema = 2\nfamily = \"active\"\n", "1:", "schema 2");
    // A role that nobody asks for is a slip of the pen.
    refused(&format!("{HEAD}[roles]\nstatus-wrod = 411\n"), "4:1", "there is no role `status-wrod`");
    refused("schema = 1\nfamily = \"toaster\"\n", "1:1", "unknown family");
    refused("\u{0}", "1:", "");
    refused(&"[".repeat(100_000), "1:", "");
}

#[test]
fn duplicate_ids_and_slugs_are_refused() {
    let row =
        |id: u32, slug: &str| format!("{{ id = {id}, slug = \"{slug}\", de = \"x\", en = \"x\", access = \"r\" }},\n");
    refused(&rows(&(row(1500, "a") + &row(1500, "b"))), "5:1", "stands twice");
    refused(&rows(&(row(1500, "a") + &row(1501, "a"))), "5:1", "slug 'a'");
    refused(&rows(&row(1500, "rated-speed")), "4:1", "rated-speed");
}

#[test]
fn names_with_control_characters_or_a_megabyte_are_refused() {
    let row = |name: &str| rows(&format!("{{ id = 1500, de = \"x\", en = \"{name}\", access = \"r\" }},"));
    refused(&row("\\u001b[31mred"), "4:1", "control character U+001B");
    refused(&row("a\\nb"), "4:1", "control character U+000A");
    refused(&row(&"a".repeat(1 << 20)), "4:1", "at most 2000");
    refused(&format!("{HEAD}#{}", "x".repeat(5 << 20)), "1:1", "at most");
    let unit = "{ id = 1500, de = \"x\", en = \"x\", unit = \"\\u0007\", access = \"r\" },";
    refused(&rows(unit), "4:1", "control character U+0007");
}

#[test]
fn hostile_texts_that_may_stand_are_escaped_in_every_human_format() {
    let text = format!(
        "{}[enums.mine]\n0 = {{ en = \"red\\u202eder\", de = \"x\" }}\n",
        rows(
            "{ id = 372, slug = \"rated-speed\", de = \"x\", en = \"x\", type = \"word\", access = \"rw\", enum = \"mine\", replace = true },"
        )
    );
    let run = |line: &str| antrieb(&format!("--catalogue {{dir}}/mine.toml {line}")).file("mine.toml", &text);
    let bench = "[[drive]]\nmodel = \"act\"\nset = { \"372\" = 0 }\n";
    for line in
        ["-a 1 read 372", "-a 1 --format csv read 372", "params 372", "-a 1 dataset show 372", "-a 1 --yes write 372=1"]
    {
        let run = run(line).on(bench).run();
        for stream in [&run.out, &run.err] {
            assert!(!stream.contains('\u{202e}'), "{line}: {stream:?}");
        }
    }
    let table = run("-a 1 read 372").on(bench).exits(0);
    assert!(table.out.contains("red\\u{202e}der"), "{}", table.out);
    // In JSON the text is what it is.
    let document = run("-a 1 read 372").on(bench).json().exits(0);
    assert_eq!(document.data("/values/0/text"), "red\u{202e}der");
}

#[test]
fn a_catalogue_that_is_not_there_is_named() {
    let document = antrieb("--catalogue none.toml params 372").json().exits(7);
    assert!(document.error()["message"].as_str().unwrap().contains("none.toml"));
}
