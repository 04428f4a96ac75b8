//! What is said where somebody looks for it: in the chosen language, in the document, and once.

use crate::run::antrieb;

const ACT: &str = "[[drive]]\nmodel = \"act\"\naddress = 1\n";

#[test]
fn a_parameter_file_has_comments_of_the_chosen_language_and_says_the_same() {
    let save = |lang: &str| {
        let run = antrieb(&format!("-a 1 --lang {lang} dataset save {{dir}}/f.toml")).on(ACT).exits(0);
        run.text_of("f.toml")
    };
    let (en, de) = (save("en"), save("de"));
    assert!(de.starts_with("# Parameter eines Antriebs"), "{de}");
    assert!(de.contains("# rated-speed, Bemessungsdrehzahl") && de.contains("# Was diese Datei nicht"), "{de}");
    assert!(en.starts_with("# Parameters of a drive") && !en.contains("Bemessungs"), "{en}");
    let signature = |text: &str| text.lines().find(|line| line.starts_with("signature")).map(str::to_owned);
    assert_eq!(signature(&en), signature(&de));
    antrieb("-a 1 --lang de dataset check {dir}/f.toml").on(ACT).file("f.toml", &de).exits(0);
    let load = |lang: &str| {
        let line = format!("-a 1 --yes --lang {lang} dataset load {{dir}}/g.toml");
        let values = "antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n372 = 1440\n";
        antrieb(&line).on(ACT).file("g.toml", values).exits(0).text_of("g.undo.toml")
    };
    assert!(load("de").contains("# Was kommen sollte"));
    assert!(load("en").contains("# What was to come"));
}

#[test]
fn a_refusal_names_the_parameter_in_the_chosen_language() {
    for (lang, name) in [("en", "fixed-frequency-1"), ("de", "Festfrequenz 1")] {
        let refused = antrieb(&format!("-a 1 --lang {lang} --yes write 480=99999")).on(ACT).exits(7).err;
        assert!(refused.contains(name), "{refused}");
        let values = "antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n480 = 99999\n";
        let line = format!("-a 1 --lang {lang} --yes dataset load {{dir}}/f.toml");
        let refused = antrieb(&line).on(ACT).file("f.toml", values).exits(7).err;
        assert!(refused.contains(name), "{refused}");
    }
    // And that name can be typed.
    antrieb("-a 1 --lang de read 'Festfrequenz 1'").on(ACT).exits(0);
}

#[test]
fn a_family_that_is_stated_and_is_not_there_is_a_warning_of_the_document() {
    let project = "[drives.pump]\naddress = 1\ndrive = \"acu\"\n";
    let stating = |line: &str| antrieb(line).file("antrieb.toml", project).on(ACT);
    for line in ["identify", "diag", "read 411", "dataset save {dir}/f.toml", "dataset show 372"] {
        let told = stating(&format!("-a pump {line}")).json().exits(0);
        assert!(told.warnings().contains(&"drive.other_family"), "{line}: {}", told.value);
    }
    let people = stating("-a pump read 411").exits(0).err;
    assert_eq!(people.matches("is of the family").count(), 1, "{people}");
}

#[test]
fn equal_data_sets_stand_in_one_line_of_a_question() {
    let values = "antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n372 = 1440\n480 = 7\n";
    let asked = |line: &str, bench: &str| antrieb(line).on(bench).file("f.toml", values).answered("n").exits(8).err;
    let alike = asked("-a 1 dataset load {dir}/f.toml", ACT);
    assert_eq!(alike.matches("P.372@").count(), 1, "{alike}");
    assert!(alike.contains("P.372@1-4") && alike.contains("P.480@1-4") && alike.contains("write 8 values"), "{alike}");
    let other = asked("-a 1 dataset load {dir}/f.toml", &format!("{ACT}set = {{ \"372@2\" = 1450 }}\n"));
    assert_eq!(other.matches("P.372@").count(), 3, "{other}");
    assert!(other.contains("1450 -> 1440"), "{other}");
    // Of a plant the consequences stand behind the values of all.
    let project = "[drives.pump]\naddress = 1\nfiles = [\"f.toml\"]\n";
    let plant =
        antrieb("apply").on(ACT).file("antrieb.toml", project).file("f.toml", values).answered("n").exits(8).err;
    assert_eq!(plant.matches("P.372@1-4").count(), 1, "{plant}");
    let told: Vec<usize> = ["P.480@1-4", "EEPROM: each"].iter().map(|word| plant.find(word).unwrap()).collect();
    assert!(told.is_sorted() && plant.matches("EEPROM: each").count() == 1, "{plant}");
}

#[test]
fn a_hint_in_a_row_can_be_typed_as_it_stands_there() {
    let rows = antrieb("-a 1,7 read 372").on(ACT).json().exits(9);
    let hint = rows.data("/values/1/error/hint").as_str().unwrap();
    assert!(hint.contains("`antrieb -p sim:") && hint.contains(" scan`"), "{hint}");
    let project = "[drives.pump]\naddress = 1\nfiles = [\"f.toml\"]\n";
    let values = "antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n372 = 1440\n480 = 7\n";
    let plan =
        antrieb("plan --only 480 --sets 1-2").on(ACT).file("antrieb.toml", project).file("f.toml", values).exits(1).err;
    assert!(plan.contains("apply --only 480 --sets 1-2`"), "{plan}");
}
