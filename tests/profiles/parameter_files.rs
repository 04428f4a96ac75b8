//! Parameter files: what is written is read, old files stay readable, and what is broken is refused with its place.

use antrieb::profile::paramfile::{
    Head, NotHeld, ParamFile, Provenance, SavedDrive, Scope, Settings, UndoSettings, print, print_undo, schema,
};
use antrieb::profile::{Family, Registry, Type};
use std::rc::Rc;

const VERSION_1: &str = include_str!("parameter-file-1.toml");
const VERSION_2: &str = include_str!("parameter-file-2.toml");

fn family(drive: &str) -> Rc<Family> {
    Registry::open(&[]).unwrap().family(drive).unwrap()
}

fn settings(text: &str) -> Settings {
    let file = ParamFile::parse("x.toml", text).unwrap();
    file.settings(&family(&file.head.drive.family)).unwrap()
}

fn rows(settings: &Settings) -> Vec<(u32, u8, i64)> {
    settings.iter().map(|one| (one.param.id, one.set, one.raw)).collect()
}

/// Where and why a text is refused.
fn refused(text: &str) -> String {
    let file = ParamFile::parse("x.toml", text);
    let settings = file.and_then(|file| file.settings(&family(&file.head.drive.family)));
    settings.unwrap_err().to_string()
}

#[test]
fn a_file_of_version_1_stays_readable() {
    let file = ParamFile::parse("old.toml", VERSION_1).unwrap();
    let settings = file.settings(&family("acu")).unwrap();
    assert_eq!(
        rows(&settings),
        [
            (30, 0, 140),
            (372, 1, 1390),
            (372, 2, 1450),
            (372, 3, 1390),
            (372, 4, 1390),
            (376, 0, 15),
            (395, 0, 1),
            (417, 0, 99_900),
            (480, 0, -1250),
            (1234, 0, -7),
        ]
    );
    let Head { drive, saved, not_held, types, .. } = &file.head;
    assert_eq!((drive.family.as_str(), drive.address, drive.evidence.len()), ("acu", Some(3), 2));
    assert_eq!((saved.scope, saved.complete), (Some(Scope::Settings), true));
    assert_eq!(not_held[&NotHeld::ActualValue], "210-213, 411");
    assert_eq!(types[&417], Type::Long);
    assert_eq!(settings.exactly(417, 0).unwrap().kind, Some(Type::Long));
    assert_eq!(saved.signature.as_deref(), Some(settings.signature("acu").to_string().as_str()));
}

#[test]
fn a_file_of_version_2_stays_readable() {
    let file = ParamFile::parse("old.undo.toml", VERSION_2).unwrap();
    let act = family("act");
    assert_eq!(rows(&file.settings(&act).unwrap()), [(480, 1, 500), (480, 2, 500), (480, 3, 500), (480, 4, 500)]);
    let coming = file.coming(&act).unwrap().unwrap();
    assert_eq!(rows(&coming), [(480, 1, 800), (480, 2, 800), (480, 3, 800), (480, 4, 800)]);
    let in_ram = file.in_ram_alone(&act).unwrap();
    assert_eq!(rows(&in_ram), [(480, 2, 700)]);
    let store = file.undo.as_ref().unwrap().store;
    let printed = print_undo(
        &file.head,
        &UndoSettings {
            old: file.settings(&act).unwrap(),
            new: coming,
            store,
            ram: in_ram.clone(),
            unproven: file.unproven(&act).unwrap(),
        },
        &act,
    );
    let below = |text: &str| text[text.find("[values]").unwrap()..].to_owned();
    assert_eq!(below(&printed), below(VERSION_2));
    assert!(file.in_ram_alone(&act).unwrap() == in_ram && printed.contains("\nantrieb = 2\n"));
    let old = ParamFile::parse("old.toml", VERSION_1).unwrap();
    assert!(old.in_ram_alone(&family("acu")).unwrap().is_empty());
}

#[test]
fn what_is_printed_is_read_back() {
    let file = ParamFile::parse("old.toml", VERSION_1).unwrap();
    let settings = file.settings(&family("acu")).unwrap();
    let printed = print(&file.head, &settings, &family("acu"));
    let again = ParamFile::parse("new.toml", &printed).unwrap();
    assert_eq!(again.head, file.head);
    assert_eq!(rows(&again.settings(&family("acu")).unwrap()), rows(&settings));
    let below = |text: &str| text[text.find("[drive]").unwrap()..].replace("# Found out by asking.\n", "");
    let below = |text: &str| below(text).replace("# What this file does not hold, and why.\n", "");
    assert_eq!(below(&printed), below(VERSION_1));
}

#[test]
fn the_least_that_a_hand_writes_is_a_file() {
    let text = "antrieb = 1\ndrive.family = \"act\"\nvalues = { rated-speed = 1450, \"Festfrequenz 1@2\" = \"12,5\", P.376 = 1.5 }\n";
    assert!(ParamFile::parse("x.toml", text).is_err(), "a dotted key is a table of TOML");
    let text = text.replace("P.376", "\"P.376\"");
    assert_eq!(rows(&settings(&text)), [(372, 0, 1450), (376, 0, 15), (480, 2, 1250)]);
    let lexium = "antrieb = 1\n[drive]\nfamily = \"lxm05\"\n[values]\nRAMPacc = 600\n\"0x1E14\" = 3\n";
    assert_eq!(rows(&settings(lexium)), [(1556, 0, 600), (7700, 0, 3)]);
}

#[test]
fn neither_order_nor_comments_nor_spelling_change_the_signature() {
    let head = "antrieb = 1\n[drive]\nfamily = \"acu\"\n[values]\n";
    let of = |lines: &str| settings(&format!("{head}{lines}")).signature("acu").to_string();
    let first = of("372 = \"1450 1/min\"\n480 = \"5 Hz\"\n");
    assert_eq!(first, of("# a remark\n\"480@all\" = 5.00  # Hz\n\nrated-speed = \"1450\"\n"));
    assert_eq!(first, of("\"480@4\"=5\n\"480@2\"=5\n\"480@1\"=5\n\"480@3\"=\"0.005 kHz\"\n\"P.372\"=\"1450 rpm\"\n"));
    assert_ne!(first, of("372 = 1451\n480 = 5\n"));
    assert_ne!(first, of("372 = 1450\n480 = 5\n\"480@2\" = 6\n"));
}

#[test]
fn what_is_broken_is_refused_with_line_and_column() {
    let head = "antrieb = 1\n[drive]\nfamily = \"acu\"\n[values]\n";
    for (lines, told) in [
        ("372 = ", "x.toml:5:7: "),
        ("372 = 1\n372 = 2\n", "x.toml:6:1: duplicate key"),
        ("372 = true\n", "x.toml:5:7: expected a value such as \"1450 1/min\""),
        ("372 = { raw = 1 }\n", "x.toml:5:7: expected a value"),
        ("372 = 1\n\"rated-speed\" = 2\n", "x.toml:6:1: P.372 in this data set has its value in line 5 already"),
        ("rated-sped = 2\n", "x.toml:5:1: no parameter is called 'rated-sped'"),
        ("\"372@2ram\" = 2\n", "x.toml:5:1: '372@2ram': a parameter file names what is stored"),
        ("\"480-482\" = 2\n", "x.toml:5:1: '480-482': a line names one parameter"),
        ("\"372@7x\" = 2\n", "x.toml:5:1: '7x' is no data set"),
        ("4097 = 2\n", "x.toml:5:1: there is no parameter 4097"),
        ("\"480@2\" = \"5 A\"\n", "x.toml:5:11: the unit 'A' does not fit: this parameter is in Hz"),
        ("480 = \"fast\"\n", "x.toml:5:7: 'fast' is no number"),
        ("480 = 5.123\n", "x.toml:5:7: '5.123' has more decimals"),
        (
            "417 = \"5 Hz\"\n",
            "x.toml:5:7: no source tells the decimals of this parameter in Hz; `raw 1234` is the integer",
        ),
        ("395 = 70000\n", "x.toml:5:7: 70000 does not fit into a uint"),
        ("480 = \"a\\u0007\"\n", "x.toml:5:7: expected at most 200 printable characters"),
        ("[saved]\nwhen = 1\n", "x.toml:6:1: unknown field `when`"),
        ("[saved]\nsignature = \"12\"\n", "the signature '12' is none: expected 16 hexadecimal digits"),
        ("[not-held]\nrefused = \"all\"\n", "x.toml:6:11: expected numbers of parameters such as"),
        ("[not-held]\nlazy = \"1\"\n", "unknown word `lazy`"),
        ("[types]\n417 = \"string\"\n", "x.toml:6:1: expected the number of a parameter and uint, int, word or long"),
    ] {
        let refused = refused(&format!("{head}{lines}"));
        assert!(refused.starts_with("x.toml:") && refused.contains(told), "{lines:?}: {refused}");
    }
    for (text, told) in [
        ("", "x.toml:1:1: this is no parameter file: expected `antrieb = 1` at its beginning"),
        ("drives = 3\n", "x.toml:1:1: this is no parameter file"),
        ("antrieb = 0\n", "x.toml:1:11: expected the version of the format, 1 to 2"),
        ("antrieb = \"1\"\n", "x.toml:1:11: expected the version"),
        ("# x\nantrieb = 3\nnew = 1\n", "x.toml:2:11: format 3 is newer than this program"),
        ("antrieb = 1\n[values]\n", "missing field `drive`"),
        ("antrieb = 1\n[drive]\nfamily = \"acu\"\n", "missing field `values`"),
        (
            "antrieb = 1\n[drive]\nfamily = \"lxm05\"\n[values]\n\"5640@2\" = 1\n",
            "x.toml:5:1: this family has no data sets",
        ),
    ] {
        let refused = refused(text);
        assert!(refused.contains(told), "{text:?}: {refused}");
    }
    assert!(ParamFile::parse("x", "antrieb = 99").unwrap_err().newer);
    assert!(!ParamFile::parse("x", "antrieb = 0").unwrap_err().newer);
}

#[test]
fn the_json_schema_fits_what_is_read_and_what_is_written() {
    let schema = serde_json::to_value(schema()).unwrap();
    let schema = jsonschema::validator_for(&schema).unwrap();
    let json = |text: &str| toml::from_str::<serde_json::Value>(text).unwrap();
    let file = ParamFile::parse("old.toml", VERSION_1).unwrap();
    let settings = file.settings(&family("acu")).unwrap();
    let head = Head {
        drive: SavedDrive { family: "acu".to_owned(), ..SavedDrive::default() },
        saved: Provenance { complete: false, ..Provenance::default() },
        not_held: NotHeld::ALL.iter().map(|&reason| (reason, "1-3, 5".to_owned())).collect(),
        types: [(1, Type::Uint), (2, Type::Int), (3, Type::Word), (4, Type::Long)].into(),
        lang: antrieb::text::Lang::De,
    };
    for text in
        [VERSION_1, VERSION_2, &print(&file.head, &settings, &family("acu")), &print(&head, &settings, &family("acu"))]
    {
        let errors: Vec<_> = schema.iter_errors(&json(text)).map(|error| error.to_string()).collect();
        assert_eq!(errors, [""; 0], "{text}");
        ParamFile::parse("x", text).unwrap();
    }
    for text in ["antrieb = 3\nvalues = {}\ndrive.family = \"acu\"", "antrieb = 1\nvalues = {}", "antrieb = 1"] {
        assert!(!schema.is_valid(&json(text)), "{text}");
    }
}

/// Tables do not name every value: what is none of their rows must not be read as one that has it as a word.
#[test]
fn every_raw_value_of_every_parameter_is_read_as_it_was_written() {
    for drive in ["act", "acu", "lxm05"] {
        let family = family(drive);
        let read = |lines: &str| {
            let text = format!("antrieb = 1\n[drive]\nfamily = \"{drive}\"\n[values]\n{lines}");
            let file = ParamFile::parse("x.toml", &text)?;
            file.settings(&family).map(|settings| (file.head, settings))
        };
        let line = |id: u32, raw: i64| format!("{id} = \"raw {raw}\"\n");
        let ids: Vec<u32> = family.params.keys().copied().filter(|id| read(&line(*id, 1)).is_ok()).collect();
        assert!(ids.len() > 30, "{drive}: {}", ids.len());
        for raw in (0..200).chain([510, 4_800, 9_600, 19_200]) {
            let (head, before) = read(&ids.iter().map(|id| line(*id, raw)).collect::<String>()).unwrap();
            assert_eq!(rows(&settings(&print(&head, &before, &family))), rows(&before), "{drive} {raw}");
        }
    }
}
