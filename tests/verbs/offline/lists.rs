//! Lists of others become catalogues: tables as Excel writes them; and what is refused.

use crate::run::{Run, antrieb};
use serde_json::{Value, json};

/// What a site keeps in Excel: a title, German headings, decimal commas, quoted cells, headings of sections, a sum at the end.
const SITE: &str = "\u{FEFF}Antriebe Halle 3;;;;;;Stand 12.03.\r\n\
    Nr.;Bezeichnung;Einheit;NK;Min;Max;Zugriff;Ort\r\n\
    Motor;;;;;;;\r\n\
    P.370;Bemessungsspannung;V;1;0,0;1.000,0;r/w;Schrank 1\r\n\
    P.371;\"Strom; \"\"Motor\"\"\";A;1;0,5;10,3;lesen;Schrank 1\r\n\
    ;;;;;;;\r\n\
    420;Förderhöhe;m;2;\u{2212}0,5;999,99;rw;\r\n\
    siehe Blatt 2;;;;;;;\r\n";

fn site(line: &str) -> Run {
    antrieb(line).file("site.csv", SITE)
}

/// A list in other bytes.
fn bytes(line: &str, name: &str, bytes: &[u8]) -> Run {
    let run = antrieb(line);
    std::fs::write(run.directory().join(name), bytes).unwrap();
    run
}

const TAKEN: [(&str, &str, &str, &str); 3] = [
    ("370", "Bemessungsspannung", "V", "0.0 … 1000.0"),
    ("371", "Strom; \"Motor\"", "A", "0.5 … 10.3"),
    ("420", "Förderhöhe", "m", "-0.50 … 999.99"),
];

#[track_caller]
fn holds(catalogue: &str) {
    for (number, name, unit, range) in TAKEN {
        let one = antrieb(&format!("--catalogue {{dir}}/mine.toml params {number}")).file("mine.toml", catalogue);
        let told = one.exits(0).out;
        assert!([name, unit, range].iter().all(|part| told.contains(part)), "{number}\n{told}\n{catalogue}");
    }
}

#[test]
fn a_list_of_excel_is_a_catalogue_at_once() {
    let told = site("params import {dir}/site.csv").exits(0);
    holds(&told.out);
    for line in [
        "3 rows taken, 2 left out, for the family 'active'",
        "# read as UTF-8, cells parted by ;, headings in line 2:",
        "#   id = column 1 'Nr.'",
        "#   decimals = column 4 'NK'",
        "#   not taken: Ort",
        "# left out, line 3: 'Motor' is no number of a parameter",
        "# left out, line 8: 'siehe Blatt 2' is no number of a parameter",
    ] {
        assert!(told.out.contains(line), "{line}\n{}", told.out);
    }
    let document = site("params import {dir}/site.csv").json().exits(0);
    assert_eq!(document.data("/rows/2/line"), &json!(7));
    assert_eq!(document.data("/rows/0/access"), &json!("rw"));
    assert_eq!(document.data("/rows/1/access"), &json!("r"));
    assert_eq!(document.data("/left_out/0/line"), &json!(3));
    site("--lang de params import {dir}/site.csv").exits(0);
    site("--lang de params import {dir}/site.csv --output {dir}/mine.toml").exits(0);
    assert!(site("--format csv params import {dir}/site.csv").exits(0).out.lines().count() > 5);
}

/// A row that cites nothing tells the file that it stands in, and no empty place before it.
#[test]
fn a_row_without_a_source_tells_its_file() {
    let list = site("params import {dir}/site.csv").exits(0).out;
    let told = antrieb("--catalogue {dir}/mine.toml --drive act params 420").file("mine.toml", &list).exits(0).out;
    let source = told.lines().find_map(|line| line.trim_start().strip_prefix("source ")).unwrap();
    assert!(source.trim().ends_with("mine.toml") && !source.contains('('), "{told}");
}

/// As printed lists have it.
#[test]
fn access_is_known_in_its_short_words() {
    let list = "Address,Name,Type,Access\n10,One,uint,RD\n11,Two,uint,RD/WR\n";
    let told = antrieb("params import --own meter {dir}/a.csv").file("a.csv", list).exits(0).out;
    assert!(told.contains("id = 10") && told.contains("access = \"r\"") && told.contains("access = \"rw\""), "{told}");
}

/// C calls 16 bits short and 32 int, others call 16 int: a list that has both words does not tell.
#[test]
fn int_beside_short_stays_open_until_somebody_says_what_it_means() {
    let list = "Address,Name,Type,Access\n10,One,short,r\n11,Two,int,r\n13,Three,unsigned,r\n15,Four,long,r\n";
    let open = antrieb("params import --own meter {dir}/a.csv").file("a.csv", list).exits(0).out;
    let row =
        |told: &str, id: &str| told.lines().find(|line| line.contains(&format!("{{ id = {id}, "))).unwrap().to_owned();
    assert!(row(&open, "10").contains("type = \"int\"") && row(&open, "15").contains("type = \"long\""), "{open}");
    assert!(!row(&open, "11").contains("type =") && !row(&open, "13").contains("type ="), "{open}");
    assert!(open.contains("note: lines 3-4, 2 cells ('int', 'unsigned'): beside 'short'"), "{open}");
    let said = "params import --own meter {dir}/a.csv --set type.int=int32 --set type.unsigned=uint16";
    let said = antrieb(said).file("a.csv", list).exits(0).out;
    assert!(row(&said, "11").contains("type = \"long\"") && row(&said, "13").contains("type = \"uint\""), "{said}");
    // Without that word int has 16 bits, as everywhere.
    let plain = list.replace("short", "int16");
    let plain = antrieb("params import --own meter {dir}/a.csv").file("a.csv", &plain).exits(0).out;
    assert!(row(&plain, "11").contains("type = \"int\""), "{plain}");
}

#[test]
fn a_row_that_is_shifted_and_a_type_that_its_limits_do_not_fit_are_told() {
    let list = "Nr,Name,Type,Decimals,Min,Max,Access\n1470,Rampe,int,2,0,00,9999,99,rw\n1471,Druck,uint,0,0,70000,rw\n\
                1472,Weg,int,1,-3276.8,3276.7,rw\n1473,Lage,int,1,0,3276.8,rw\n";
    let told = antrieb("params import --drive acu {dir}/a.csv").file("a.csv", list).exits(0).out;
    assert!(told.contains("left out, line 2: 9 cells under 7 headings"), "{told}");
    assert!(told.contains("note: lines 3, 5, 2 cells ('uint', 'int'): the limits do not fit"), "{told}");
    let is_typed = |id: &str| told.lines().any(|line| line.contains(&format!("id = {id},")) && line.contains("type ="));
    assert_eq!([is_typed("1471"), is_typed("1472"), is_typed("1473")], [false, true, false], "{told}");
}

/// Numbers are written one way in a list: a decimal comma anywhere says that points part thousands.
#[test]
fn points_part_thousands_where_a_comma_says_so_and_a_default_lies_within_its_limits() {
    let list = "Nr;Name;Decimals;Min;Max;Default\n1470;Eins;2;1.000;12.000;2.000\n1471;Zwei;2;0;1.000,5;70\n\
                1473;Vier;0;0;50;70\n";
    let told = antrieb("params import --drive acu {dir}/a.csv").file("a.csv", list).exits(0).out;
    let row = |id: &str| told.lines().find(|line| line.contains(&format!("id = {id},"))).unwrap_or_default().to_owned();
    for (id, limits) in [
        ("1470", "access = \"r\", min = 1000, max = 12000, default = 2000, decimals"),
        ("1471", "access = \"r\", min = 0, max = \"1000.5\", default = 70, decimals"),
        ("1473", "access = \"r\", min = 0, max = 50, decimals"),
    ] {
        assert!(row(id).contains(limits), "{id}: {told}");
    }
    assert!(told.contains("line 4: '70': this default lies beyond"), "{told}");
}

#[test]
fn a_single_row_and_a_word_are_corrected() {
    let list = "Nr;Name;Typ;Zugriff\nP.1470;Eins;int;nie\n1471;Zwei;int;r\n";
    let line = "params import --drive acu {dir}/a.csv --set P.1470.type=long --set 1471.name=Mine --set access.nie=w";
    let told = antrieb(line).file("a.csv", list).exits(0).out;
    assert!(told.contains("en = \"Eins\", de = \"Eins\", type = \"long\", access = \"w\""), "{told}");
    assert!(told.contains("en = \"Mine\", de = \"Mine\", type = \"int\", access = \"r\""), "{told}");
    for (set, why) in [
        ("1472.type=long", "no such row"),
        ("type.itn=long", "no such word"),
        ("kind.int=long", "there is no field 'kind.int'"),
    ] {
        let told =
            antrieb(&format!("params import --drive acu {{dir}}/a.csv --set {set}")).file("a.csv", list).exits(7);
        assert!(told.err.contains(why), "{set}: {}", told.err);
    }
    // What a map says of itself is not corrected in silence.
    let map = r#"{"mbmap": 2, "vendor": "a", "model": "b", "registers": []}"#;
    let told = antrieb("params import {dir}/m.json --set access=rw").file("m.json", map).exits(7);
    assert!(told.err.contains("--set and --column are for tables"), "{}", told.err);
}

#[test]
fn whatever_bytes_and_separators_it_comes_in() {
    let western: Vec<u8> =
        SITE.trim_start_matches('\u{FEFF}').replace('\u{2212}', "-").chars().map(|letter| letter as u8).collect();
    let told = bytes("params import {dir}/site.csv", "site.csv", &western).exits(0).out;
    assert!(told.contains("read as Windows-1252"), "{told}");
    holds(&told);
    let wide: Vec<u8> = SITE.replace(';', "\t").encode_utf16().flat_map(u16::to_le_bytes).collect();
    // A quoted cell had the separator in it.
    let told = bytes("params import {dir}/site.csv", "site.csv", &wide).exits(0).out;
    assert!(told.contains("read as UTF-16, cells parted by tabs"), "{told}");
    let english = "Parameter,Name,Unit,Decimals,Minimum,Maximum,Access\n370,Bemessungsspannung,V,1,0.0,1000.0,RW\n\
        371,\"Strom; \"\"Motor\"\"\",A,1,0.5,10.3,RO\n420,Förderhöhe,m,2,-0.5,999.99,rw\n";
    holds(&antrieb("params import {dir}/english.csv").file("english.csv", english).exits(0).out);
}

#[test]
fn what_nobody_said_stays_open_or_is_asked() {
    let bare = "Nr;Name;Einheit;Max;Typ\n1500;Druck;bar;16,0;Zahl\n1501;Temperatur;;5;DOUBLE\n";
    let told = antrieb("params import {dir}/bare.csv").file("bare.csv", bare).exits(0).out;
    for part in [
        "note: line 2: 'Zahl': this type is not known, so it stays open",
        "'16,0': not taken, because nothing tells the decimals (--set decimals=N)",
        "so every row is read only (r); --set access=rw says otherwise",
        "left out, line 3: the type 'DOUBLE' is none that this program shows right",
        "unit = \"bar\", access = \"r\" }",
    ] {
        assert!(told.contains(part), "{part}\n{told}");
    }
    let line = "params import {dir}/bare.csv --set access=rw --set decimals=1 --column type=";
    let told = antrieb(line).file("bare.csv", bare).exits(0).out;
    assert!(told.contains("access = \"rw\", max = 16, decimals = 1"), "{told}");
    // Neither a type that is not known nor a float is taken for something.
    assert!(told.contains("id = 1501") && !told.contains("type ="), "{told}");
}

/// A list with the headings of a German maker: places behind the comma, whether a parameter can be written.
const MAKER: &str = "\u{FEFF}P-Nr.;Parametername;Dim.;Format;Komma;Minimum;Maximum;Werkseinst.;Schreibbar\r\n\
    P.370;\"Motor, kalt\";Ohm;int;2;0,00;99,99;1,50;ja\r\n\
    P.371;Streufaktor;%;uint;1;0,0;200,0;;nein\r\n\
    P.420;Beschl. rechts;Hz/s;long;2;0,01;1.000,00;5,00;ja\r\n\
    P.421;Verz. rechts;Hz/s;long;2;0,01;1.000,00;5,00;-\r\n\
    Summe;4;;;;;;;\r\n";

#[test]
fn the_headings_of_a_german_maker_are_known() {
    let told = antrieb("--lang de params import {dir}/a.csv").file("a.csv", MAKER).exits(0).out;
    assert!(!told.contains("nicht genommen") && !told.contains("Anmerkung"), "{told}");
    for row in [
        r#"{ id = 370, slug = "motor-kalt", en = "Motor, kalt", de = "Motor, kalt", unit = "Ohm", type = "int", access = "rw", min = 0, max = "99.99", default = "1.5", decimals = 2 }"#,
        r#"type = "uint", access = "r", min = 0, max = 200, decimals = 1 }"#,
        r#"access = "rw", min = "0.01", max = 1000, default = 5, decimals = 2 }"#,
        r#"access = "r", min = "0.01", max = 1000, default = 5, decimals = 2 }"#,
    ] {
        assert!(told.contains(row), "{row}\n{told}");
    }
    // A yes is an access only where the heading asks whether it can be written.
    let asked = MAKER.replace("Schreibbar", "Zugriff");
    let told = antrieb("params import {dir}/a.csv").file("a.csv", &asked).exits(0).out;
    assert!(told.contains("note: lines 2-5, 4 cells ('ja', 'nein', '-'): this access is not known"), "{told}");
}

#[test]
fn what_is_said_of_many_cells_is_said_once() {
    let open = MAKER.replace("Komma", "Platz");
    let told = antrieb("--lang de params import {dir}/a.csv").file("a.csv", &open).exits(0).out;
    assert_eq!(told.matches("Anmerkung").count(), 1, "{told}");
    let note = "Anmerkung: Zeilen 2-5, 11 Zellen ('0,00', '99,99', '1,50', …): nicht übernommen, denn nichts nennt die Nachkommastellen";
    assert!(told.contains(note), "{told}");
}

#[test]
fn two_columns_that_fit_are_an_error_that_names_the_option() {
    let list = "Nr;Parameter;Bezeichnung;Beschreibung\n1;1500;Druck;am Eingang\n2;1501;Fluss;am Ausgang\n";
    let told = antrieb("params import {dir}/a.csv").file("a.csv", list).exits(7);
    assert!(told.err.contains("a.csv:1: several columns can be the field id: 'Nr', 'Parameter'"), "{}", told.err);
    assert!(told.err.contains("--column 'id=Nr'"), "{}", told.err);
    let told = antrieb("params import {dir}/a.csv --column id=Parameter").file("a.csv", list).exits(0).out;
    assert!(told.contains("id = column 2 'Parameter' (said by --column)"), "{told}");
    assert!(told.contains("id = 1501") && told.contains("note = { en = \"am Ausgang\""), "{told}");
    antrieb("--lang de params import {dir}/a.csv").file("a.csv", list).exits(7);
    for (option, why) in [
        ("--column id=Nummer", "there is no heading 'Nummer' (found: Nr, Parameter, Bezeichnung, Beschreibung)"),
        ("--column colour=Nr", "there is no field 'colour' (expected: id, slug"),
        ("--separator |", "no line of headings was found"),
    ] {
        let told = antrieb(&format!("params import {{dir}}/a.csv {option}")).file("a.csv", list).exits(7);
        assert!(told.err.contains(why), "{option}\n{}", told.err);
    }
}

#[test]
fn a_list_is_refused_with_its_line() {
    for (list, why) in [
        ("Nr;Name\n1500;a\n1501;b\n1500;c\n", "a.csv:4: parameter 1500 stands twice, first in line 2"),
        ("Nr;Name\n\n372;a\n", "a.csv:3: parameter 372 is already in built-in active.toml"),
        ("Nr;Name;Min;Max\n1500;a;5;1\n", "a.csv:2: parameter 1500: `min` is above `max`"),
        ("Nr;Name;Nachkommastellen\n1500;a;40\n", "a.csv:2: parameter 1500: 40 decimals; expected at most 9"),
        ("Nr;Name\nx;a\n", "no column has the numbers of parameters"),
        ("Nr;Name\n", "no column has the numbers of parameters"),
        ("", "no table"),
        ("one\ntwo\n", "no table"),
        ("{ \"mbmap\": 1 }", "no MBMap of version 2"),
        ("{", "a.csv:1: no JSON"),
    ] {
        let told = antrieb("params import {dir}/a.csv").file("a.csv", list).exits(7);
        assert!(told.err.contains(why), "{why}\n{}", told.err);
        antrieb("--lang de params import {dir}/a.csv").file("a.csv", list).exits(7);
    }
    let told = antrieb("params import {dir}/a.csv --replace").file("a.csv", "Nr;Name\n372;a\n").exits(0);
    assert!(told.out.contains("replace = true"), "{}", told.out);
    let long = "Nr;Name\n1500;".to_owned() + &"a".repeat(3000) + "\n";
    let told = antrieb("params import {dir}/a.csv").file("a.csv", &long).exits(7);
    assert!(told.err.contains("a.csv:2:") && told.err.contains("at most 2000"), "{}", told.err);
}

#[test]
fn nothing_of_a_cell_breaks_out_of_the_catalogue() {
    let list =
        "Nr;Name;\"Note\nschema = 9\"\n1500;\"a\"\"\n[motion]\nx = 1 \\ \u{1b}[31m\";\"b\"\n1501;\u{202e}c\u{200b};\n";
    let told = antrieb("params import {dir}/a.csv").file("a.csv", list).exits(0).out;
    assert!(!told.lines().any(|line| line.starts_with('[') || line.starts_with("schema = 9")), "{told}");
    let read = antrieb("--catalogue {dir}/mine.toml params 1501").file("mine.toml", &told).exits(0).out;
    assert!(read.contains("name       c\n"), "{read}");
}

#[test]
fn what_is_no_small_file_is_refused_at_once() {
    let run = antrieb("params import {dir}/large.csv");
    std::fs::File::create(run.directory().join("large.csv")).unwrap().set_len(300 << 20).unwrap();
    let told = run.exits(7);
    assert!(told.err.contains("expected at most 16 MiB"), "{}", told.err);
    let run = antrieb("params import {dir}/pipe");
    let pipe = run.directory().join("pipe");
    rustix::fs::mknodat(rustix::fs::CWD, pipe, rustix::fs::FileType::Fifo, 0o600.into(), 0).unwrap();
    assert!(run.exits(7).err.contains("expected a regular file, this is a pipe"));
    assert!(antrieb("params import {dir}").exits(7).err.contains("this is a directory"));
    assert!(antrieb("params import {dir}/nothing").exits(7).err.contains("nothing: No such file"));
}

#[test]
fn a_file_is_written_whole_and_never_over_another_unasked() {
    let line = "params import {dir}/site.csv --output {dir}/mine.toml";
    let told = site(line).exits(0);
    let written = std::fs::read_to_string(told.directory().join("mine.toml")).unwrap();
    assert!(told.out.contains("3 rows taken, 2 left out"), "{}", told.out);
    holds(&written);
    let again = site(line).file("mine.toml", "precious").exits(7);
    assert!(
        again.err.contains("the file exists already") && again.err.contains("--force replaces it"),
        "{}",
        again.err
    );
    assert_eq!(std::fs::read_to_string(again.directory().join("mine.toml")).unwrap(), "precious");
    // Also when the old one is loaded, because it stands among the catalogues.
    let old = antrieb(&format!("--catalogue {{dir}}/mine.toml --force {line}"))
        .file("site.csv", SITE)
        .file("mine.toml", &written);
    holds(&std::fs::read_to_string(old.exits(0).directory().join("mine.toml")).unwrap());
    // What is refused leaves what was there.
    let bad =
        antrieb(&format!("{line} --force")).file("site.csv", "Nr;Name\n372;a\n").file("mine.toml", "precious").exits(7);
    assert_eq!(std::fs::read_to_string(bad.directory().join("mine.toml")).unwrap(), "precious");
}

/// Every row of every family comes back as it went, in both dialects of CSV.
#[test]
fn what_is_exported_comes_back_the_same() {
    for (drive, excel) in [("acu", "--excel"), ("lxm05", "")] {
        let rows = |catalogue: Option<&str>| -> Vec<Value> {
            let line = format!("--drive {drive} params --json");
            let run = match catalogue {
                Some(text) => antrieb(&format!("--catalogue {{dir}}/mine.toml {line}")).file("mine.toml", text),
                None => antrieb(&line),
            };
            let out: Value = serde_json::from_str(&run.exits(0).out).unwrap();
            let mut rows = out["data"]["params"].as_array().unwrap().clone();
            rows.iter_mut().for_each(|row| drop(row.as_object_mut().unwrap().remove("origin")));
            rows
        };
        let list = antrieb(&format!("--drive {drive} params export {excel}")).exits(0).out;
        let line = format!("--drive {drive} params import {{dir}}/list.csv --replace");
        let catalogue = antrieb(&line).file("list.csv", &list).exits(0).out;
        assert!(catalogue.contains(" 0 left out") && !catalogue.contains("# note"), "{}", &catalogue[..2000]);
        let (before, after) = (rows(None), rows(Some(&catalogue)));
        assert_eq!(before.len(), after.len());
        before.iter().zip(&after).for_each(|pair| assert_eq!(pair.0, pair.1));
    }
}

/// Where every number has a group of three, nobody knows what its mark parts: that is said, and an option tells it.
#[test]
fn a_list_that_does_not_tell_its_decimal_mark_says_so() {
    const LIST: &str =
        "Nr;Bezeichnung;Typ;Nachkommastellen;Max;Werk\n7001;A;long;3;1.000;1.000\n7002;B;long;3;2.500;1,250\n";
    let import = |options: &str, list: &str| {
        antrieb(&format!("--drive acu params import {{dir}}/a.csv {options}")).file("a.csv", list).exits(0).out
    };
    let open = "lines 2-3, 4 cells ('1.000', '2.500', '1,250'): nothing tells whether these have thousands or decimals";
    let told = import("", LIST);
    assert!(told.contains(open) && told.contains("max = \"2.5\""), "{told}");
    for (options, max, default) in
        [("--decimal ,", "max = 2500", "default = \"1.25\""), ("--decimal .", "max = \"2.5\"", "")]
    {
        let told = import(options, LIST);
        assert!(!told.contains("nothing tells whether") && told.contains(max) && told.contains(default), "{told}");
    }
    for certain in ["7003;C;long;3;0,5;0", "7003;C;long;3;0.5;0"] {
        let told = import("", &format!("{LIST}{certain}\n"));
        assert!(!told.contains("nothing tells whether"), "{told}");
    }
    // One that has both says nothing either.
    assert!(import("", &format!("{LIST}7003;C;long;3;0,5;0.5\n")).contains("4 cells"));
    antrieb("--drive acu params import {dir}/a.csv --decimal ;").file("a.csv", LIST).exits(2);
}

/// What a list says of data sets, of when a value counts and of what it can do is known in people's words, or told.
#[test]
fn words_of_a_row_are_known_or_told() {
    let row = |field: &str, word: &str| {
        let list = format!("Nr;Bezeichnung;{field}\n7001;A;{word}\n");
        antrieb("--drive acu params import {dir}/a.csv").file("a.csv", &list).exits(0).out
    };
    for (word, sets) in [
        ("1-4", "sets = \"four\""),
        ("1..4", "sets = \"four\""),
        ("1/2/3/4", "sets = \"four\""),
        ("vier", "sets = \"four\""),
        ("ja", "sets = \"four\""),
        ("4", "sets = \"four\""),
        ("1", "sets = \"one\""),
        ("nein", ""),
        ("-", ""),
    ] {
        let told = row("Datensätze", word);
        assert!(told.contains(sets) && !told.contains("not known"), "{word}: {told}");
        assert_eq!(told.contains("sets = \""), !sets.is_empty(), "{word}: {told}");
    }
    for (field, word, what) in [
        ("Datensätze", "quatsch", "this word for data sets is not known"),
        ("effective", "later", "when this takes effect is not known"),
        ("hazard", "fire", "this hazard is not known"),
    ] {
        let told = row(field, word);
        assert!(told.contains(&format!("line 2: '{word}': {what}")), "{told}");
    }
}

#[test]
fn export_is_csv_in_every_form() {
    let told = antrieb("params export ramp").exits(0).out;
    assert!(told.starts_with("id,slug,short,en,de,unit,type,decimals,min,max,default,access"), "{told}");
    assert_eq!(antrieb("--format csv params export ramp").exits(0).out, told);
    let document = antrieb("params export 372").json().exits(0);
    assert_eq!(document.data("/params/0/slug"), &json!("rated-speed"));
    antrieb("params export nonsense").exits(1);
    let told = antrieb("--lang de params export 372 --excel --output {dir}/list.csv").exits(0);
    let list = std::fs::read_to_string(told.directory().join("list.csv")).unwrap();
    assert!(list.starts_with("\u{FEFF}id;slug;"), "{list}");
    assert!(told.out.starts_with("1 Parameter geschrieben nach"), "{}", told.out);
    // A word that is no subcommand is still looked for, and one that is can be.
    antrieb("params -- import").exits(1);
    antrieb("params ramp").exits(0);
}

#[test]
fn a_list_that_is_too_large_is_refused_before_it_is_looked_through() {
    let rows: String = (0..50_001).map(|row| format!("{row};x\n")).collect();
    for (text, told) in [
        (format!("Nr;Name\n{rows}"), "a.csv:50001: a list has at most 50000 lines"),
        (format!("Nr;Name\n{}\n", ";".repeat(1_000) + "x"), "a.csv:2: 1001 cells in a line; a list has at most 1000"),
    ] {
        let refused = antrieb("params import {dir}/a.csv").file("a.csv", &text).exits(7).err;
        assert!(refused.contains(told), "{refused}");
    }
}
