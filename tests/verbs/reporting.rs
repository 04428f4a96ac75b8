//! `report`: drives and their line on paper.

use crate::run::antrieb;

/// An ACT whose data sets differ, and an ACU with a fault.
const BENCH: &str = "\
[[drive]]
model = \"act\"
address = 1
set = { \"372@2\" = 1450, \"480@3\" = -12.5 }
[[drive]]
model = \"acu\"
address = 2
modules = [\"EM-RES-03\"]
[[drive.event]]
at = \"0s\"
fault = \"F0500\"
";
const RECORD: &str = include_str!("../../docs/examples/record.csv");
/// The names in it are what a mean plant could call itself.
const PROJECT: &str = "\
[drives.\"<b>pump\"]
address = 1
[report]
customer = \"M\u{fc}ller & <script>alert(1)</script>\"
plant = \"Halle \\\"3\\\" | *Pumpe* \u{202e}\"
logo = \"logo.svg\"
";
const LOGO: &str = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 2 1\"><path d=\"M0 0h2v1z\"/></svg>";

#[test]
fn a_page_has_everything_in_it_in_either_language() {
    for (lang, words) in [
        (
            "en",
            [
                "Commissioning report: Halle",
                "Link test",
                "F0500 Output current overload",
                "Deviations from the factory settings",
                "<strong>-12.50</strong>",
                "Stator frequency (left)",
                "silent",
                "accepted by",
            ],
        ),
        (
            "de",
            [
                "Inbetriebnahmebericht: Halle",
                "Leitungstest",
                "F0500 Ausgangsstrom",
                "Abweichungen von der Werkseinstellung",
                "<strong>-12.50</strong>",
                "Ständerfrequenz (links)",
                "stumm",
                "abgenommen von",
            ],
        ),
    ] {
        let line = format!(
            "-a 1,2,7 --lang {lang} report {{dir}}/page.html {{dir}}/page.md --record {{dir}}/record.csv --record {{dir}}/record.csv"
        );
        let run = antrieb(&line).file("record.csv", RECORD).file("antrieb.toml", PROJECT).file("logo.svg", LOGO);
        let told = run.on(BENCH).exits(9);
        let [page, markdown] = ["page.html", "page.md"].map(|name| told.text_of(name));
        for word in words {
            assert!(page.to_lowercase().contains(&word.to_lowercase()), "{lang}: no {word} in {page}");
        }
        // Names are no markup, nothing is hidden, and nothing is loaded.
        assert!(page.contains("Müller &amp; &lt;script&gt;alert(1)") && page.contains("&lt;b&gt;pump"), "{page}");
        assert!(page.contains("\\u{202e}") && !page.contains('\u{202e}'), "{page}");
        assert!(!page.contains("<script") && !page.contains("<link") && !page.contains("@import"), "{page}");
        let outside =
            page.match_indices("http").filter(|(at, _)| !page[*at..].starts_with("http://www.w3.org/2000/svg"));
        assert_eq!(outside.filter(|(at, _)| !page[*at..].starts_with("http-equiv")).count(), 0, "{page}");
        assert!(page.contains("src=\"data:image/svg+xml;base64,PHN2Zy"), "{page}");
        // Each picture has names of its own.
        assert_eq!(
            (
                page.matches("<svg ").count(),
                page.matches("id=\"hatch-0\"").count(),
                page.matches("id=\"hatch-1\"").count()
            ),
            (2, 1, 1)
        );
        assert!(
            markdown.contains("Müller \\& \\<script\\>alert(1)") && markdown.contains("\\| \\*Pumpe\\*"),
            "{markdown}"
        );
        assert!(markdown.contains("(data:image/svg+xml;base64,") && markdown.contains("**-12.50**"), "{markdown}");
    }
}

/// Looked at in print: a table of few rows stays whole and with its picture, and nothing holds it to what comes behind it.
#[test]
fn in_print_a_short_table_stays_whole_and_with_its_picture() {
    let told = antrieb("-a 1 report {dir}/page.html {dir}/page.md --count 5").on(BENCH).exits(0);
    let page = told.text_of("page.html");
    assert!(page.contains("table:not(:has(tbody tr:nth-child(5))) { break-inside: avoid; }"), "{page}");
    assert!(!page.contains("tr:first-child") && !page.contains("figure + table"), "{page}");
    // A line without a name is a line.
    let text = told.text_of("page.md");
    assert!(text.contains("\n______________________ ______") && !text.contains("\n: ___"), "{text}");
}

#[test]
fn the_signature_is_that_of_the_saved_settings() {
    let saved = antrieb("-a 1 dataset save {dir}/saved.toml").on(BENCH).json().exits(0);
    let report = antrieb("-a 1 report --count 5").on(BENCH).json().exits(0);
    assert_eq!(saved.data("/saved/0/signature"), report.data("/drives/0/signature"));
    assert_eq!(saved.data("/saved/0/values"), report.data("/drives/0/values"));
    let differs = antrieb("-a 1 dataset diff factory drive").on(BENCH).json().exits(1);
    let [a, b] = [differs.data("/comparisons/0/differences"), report.data("/drives/0/differences")];
    assert_eq!(a, b);
}

#[test]
fn what_stands_in_the_way_is_told_before_anything_is_asked() {
    for (line, code, word) in [
        ("-a 1 report {dir}/page.pdf", 2, ".html or .md"),
        ("-a 1 report {dir}/old.html", 7, "--force"),
        ("-a 1 report {dir}/new.html --record {dir}/none.csv", 7, "none.csv"),
    ] {
        let told = antrieb(line).file("old.html", "precious").on(BENCH).and("-v").exits(code);
        assert!(told.err.contains(word), "{}", told.err);
        assert!(told.sent().is_empty(), "{}", told.err);
        assert_eq!(told.text_of("old.html"), "precious");
    }
    // What is no record of a procedure is told in the language that was asked for, with nothing that `report` lacks.
    for (file, lang, words) in [
        ("{\"a\": 1}", "en", "line 1, column 4: unknown field `a`"),
        ("{\"a\": 1}", "de", "Zeile 1, Spalte 4: unbekannter Schl\u{fc}ssel `a`"),
        ("t,n\n", "de", "Zeile 1, Spalte 2: das ist kein JSON"),
        ("{\"title\":", "de", "sie endet, bevor sie vollst\u{e4}ndig ist"),
    ] {
        let line = format!("-a 1 --lang {lang} report {{dir}}/new.html --procedure {{dir}}/p.json");
        let told = antrieb(&line).file("p.json", file).on(BENCH).exits(7);
        assert!(told.err.contains(words) && !told.err.contains("--force"), "{}", told.err);
        assert!(lang == "en" || !told.err.contains("expected"), "{}", told.err);
    }
    let project = "[report]\nlogo = \"logo.svg\"\n";
    let told = antrieb("-a 1 report {dir}/new.html").file("antrieb.toml", project).file("logo.svg", "a text").on(BENCH);
    assert!(told.exits(7).err.contains("PNG, JPEG"));
}
