//! Maps of registers of other makers become catalogues, and what is read by them is right.

use crate::run::{Run, antrieb};
use serde_json::{Value, json};

/// A slave that knows the norm and no drive of ours.
const BENCH: &str = "[[drive]]\nmodel = \"foreign\"\naddress = 5\nregisters = { 10 = 2305, 11 = 0, 12 = 64086, 13 = 0, 14 = 2, \
    20 = 34464, 21 = 1, 22 = 32768, 30 = 1, 31 = 34464, 40 = 750 }\n";

/// Maps of three makers in the public format, each of another shape: addresses as numbers or as hexadecimal texts, from 0 or
/// from 1, the lower half first or the upper one, access in capitals, in small letters or not at all, names of values in the
/// register or shared.
const METER: &str = r#"{ "$schema": "x", "mbmap": 2, "vendor": "Zähler & Söhne", "model": "EM 1", "protocol": "rtu", "unit_id": 1,
  "baudrate": 9600, "parity": "N", "byte_order": "big", "word_order": "little", "address_base": 0, "x_status": "official",
  "registers": [
    {"name": "Voltage", "group": "Measurements", "area": "holding", "address": "0x000A", "type": "int32", "scale": 0.1, "unit": "V", "access": "R"},
    {"name": "Energy", "group": "Measurements", "area": "holding", "address": "0x0014", "type": "uint32", "scale": 0.001, "unit": "kWh", "access": "R"},
    {"name": "Voltage", "group": "Measurements", "area": "input", "address": 40, "type": "uint16", "scale": 0.1, "unit": "V"},
    {"name": "Serial number", "area": "holding", "address": 50, "type": "string", "length": 8, "access": "R"},
    {"name": "Relay", "area": "coil", "address": 0, "type": "bool", "access": "RW"}
  ] }"#;
const DRIVE: &str = r#"{
  "mbmap": 2, "vendor": "Acme", "model": "VSD/7", "models": ["VSD/7"], "address_base": 1, "byte_order": "big", "word_order": "big",
  "enums": { "modes": {"0": "Local", "2": "Remote"} }, "sentinels": { "int16": {"0x8000": "Unavailable"} },
  "registers": [
    {"name": "Speed", "area": "holding", "address": 13, "type": "int16", "unit": "rpm", "access": "R"},
    {"name": "Mode", "area": "holding", "address": 15, "type": "uint16", "enum": "modes", "access": "R/W"},
    {"name": "Temperature", "area": "holding", "address": 23, "type": "int16", "scale": 0.1, "unit": "°C", "access": "R"},
    {"name": "Counter", "area": "holding", "address": 31, "type": "uint32", "access": "R"},
    {"name": "Limit", "area": "holding", "address": 44, "type": "uint16", "min": 5, "max": 20, "access": "RW"},
    {"name": "Ramp", "area": "holding", "address": 41, "type": "uint16", "scale": 0.01, "unit": "s", "access": "RW"},
    {"name": "Torque", "area": "holding", "address": 42, "type": "int16", "scale_register": 43, "unit": "%", "access": "R"}
  ]
}"#;
const FAN: &str = "{\"mbmap\":2,\"vendor\":\"Ventus\",\"model\":\"ECO\",\"address_base\":0,\"registers\":[{\"name\":\"Power\",\"area\":\"holding\",\
    \"address\":40,\"type\":\"uint16\",\"scale\":10,\"unit\":\"W\"},\n{\"name\":\"Status\",\"area\":\"holding\",\"address\":14,\"type\":\"uint16\",\
    \"enum\":{\"0\":\"Stopped\",\"2\":\"Running\"}},{\"name\":\"Status\",\"area\":\"holding\",\"address\":14,\"type\":\"uint16\"},\n\
    {\"name\":\"Odd\",\"area\":\"holding\",\"address\":30,\"type\":\"uint16\",\"scale\":0.5},{\"name\":\"Status\",\"area\":\"holding\",\
    \"address\":31,\"type\":\"int16\"}]}";

/// What is read by a map, once it is a catalogue.
fn by_map(map: &str, drive: &str, line: &str) -> Run {
    let catalogue = antrieb("params import {dir}/map.json").file("map.json", map).exits(0).out;
    let line = format!("--catalogue {{dir}}/map.toml --drive {drive} -a 5 {line}");
    antrieb(&line).file("map.toml", &catalogue).on(BENCH)
}

#[test]
fn maps_of_other_makers_are_read_watched_saved_and_written_but_never_moved() {
    let meter = by_map(METER, "zaehler-soehne-em-1", "read 10 energy").json().exits(0);
    assert_eq!((meter.data("/values/0/value"), meter.data("/values/0/unit")), (&json!(230.5), &json!("V")));
    assert_eq!(meter.data("/values/1/value"), &json!(100.0));
    by_map(METER, "zaehler-soehne-em-1", "read @measurements").exits(0);
    by_map(METER, "zaehler-soehne-em-1", "write 10=1 --yes").exits(7);

    let read = by_map(DRIVE, "acme-vsd-7", "read speed mode temperature counter ramp").json().exits(0);
    let values: Vec<&Value> = (0..5).map(|row| read.data(&format!("/values/{row}/value"))).collect();
    assert_eq!(values, [&json!(-1450), &json!(2), &json!(-3276.8), &json!(100_000), &json!(7.5)]);
    assert_eq!((read.data("/values/1/text"), read.data("/values/2/text")), (&json!("Remote"), &json!("Unavailable")));
    let written = by_map(DRIVE, "acme-vsd-7", "-v write ramp=2,5 mode=local --yes").exits(0);
    assert!(written.telegrams('>').iter().any(|sent| sent.starts_with("05 06 00 28 00 FA")), "{}", written.err);
    by_map(DRIVE, "acme-vsd-7", "write ramp=2,5").exits(8);
    let beyond = by_map(DRIVE, "acme-vsd-7", "write limit=21 --yes").exits(7);
    assert!(beyond.err.contains("5 … 20"), "{}", beyond.err);
    by_map(DRIVE, "acme-vsd-7", "monitor speed --duration 300ms").exits(0);
    let moved = by_map(DRIVE, "acme-vsd-7", "sollwert 10rpm --yes").exits(7);
    assert!(moved.sent().is_empty() && moved.err.contains("no catalogue tells how"), "{}", moved.err);

    let fan = by_map(FAN, "ventus-eco", "read power 14 31").json().exits(0);
    // 750 times 10 W is no value of ours: raw it is, and nothing else.
    assert_eq!((fan.data("/values/0/raw"), fan.data("/values/0/value")), (&json!(750), &Value::Null));
    assert_eq!(fan.data("/values/1/text"), &json!("Running"));
}

/// Maps with the facts of devices of other makers, and what their registers hold.
const OTHERS: [(&str, &str, &str, &str); 3] = [
    (
        "eastron-sdm630",
        include_str!("../../maps/eastron-sdm630.mbmap.json"),
        // 230.4 V, 5.25 A, -1209.6 W, 50.02 Hz, 12345.678 kWh
        "300001 = 17254, 300002 = 26214, 300007 = 16552, 300008 = 0, 300013 = 50327, 300014 = 13107, 300071 = 16968, \
         300072 = 5243, 300073 = 17984, 300074 = 59062",
        "[[\"230.4\",\"V\"],[\"5.25\",\"A\"],[\"-1209.6\",\"W\"],[\"50.02\",\"Hz\"],[\"12345.678\",\"kWh\"]]",
    ),
    (
        "carlo-gavazzi-em530",
        include_str!("../../maps/carlo-gavazzi-em530.mbmap.json"),
        "0 = 2304, 1 = 0, 12 = 5250, 13 = 0, 49 = 64586, 51 = 500, 52 = 34464, 53 = 1",
        "[[\"230.4\",\"V\"],[\"5.25\",\"A\"],[\"-0.95\",null],[\"50.0\",\"Hz\"],[\"10000.0\",\"kWh\"]]",
    ),
    (
        "socomec-diris-a10",
        include_str!("../../maps/socomec-diris-a10.mbmap.json"),
        "50514 = 0, 50515 = 39905, 50526 = 0, 50527 = 5002, 50528 = 0, 50529 = 5250, 50536 = 65534, 50537 = 10112, 50780 = 1, \
         50781 = 0, 51539 = 17",
        "[[\"399.05\",\"V\"],[\"50.02\",\"Hz\"],[\"5.25\",\"A\"],[\"-1209.6\",\"W\"],[\"65536\",null],[\"1.7\",\"%\"]]",
    ),
];

#[test]
fn devices_of_other_makers_are_read_by_maps_of_their_facts() {
    for (drive, map, cells, expected) in OTHERS {
        let catalogue = antrieb("params import {dir}/map.json").file("map.json", map).exits(0).out;
        assert!(catalogue.contains("rows taken, 0 left out"), "{catalogue}");
        let bench = format!("[[drive]]\nmodel = \"foreign\"\naddress = 5\nregisters = {{ {cells} }}\n");
        let run = |line: &str| {
            let line = format!("--catalogue {{dir}}/map.toml --drive {drive} -a 5 {line}");
            antrieb(&line).file("map.toml", &catalogue).on(&bench)
        };
        let read = run("read @all").json().exits(0);
        let row = |row: &Value| json!([row["value"], row["unit"]]);
        let told: Vec<Value> = read.data("/values").as_array().unwrap().iter().map(row).collect();
        let expected: Vec<(f64, Option<String>)> = serde_json::from_str::<Vec<(String, Option<String>)>>(expected)
            .unwrap()
            .into_iter()
            .map(|(number, unit)| (number.parse().unwrap(), unit))
            .collect();
        let told: Vec<(f64, Option<String>)> = serde_json::from_value(Value::from(told)).unwrap();
        assert_eq!(told, expected, "{drive}");
        run("monitor @all --duration 300ms --json").exits(0);
        let saved = run("dataset save {dir}/save.toml").exits(0);
        assert!(saved.text_of("save.toml").contains("not-held"), "only read: {}", saved.text_of("save.toml"));
        run(&format!("write {}=1 --yes", read.data("/values/0/param"))).exits(7);
    }
}

/// Floats in registers that are written as well, an input register, and what is no number.
const MIXER: &str = r#"{ "mbmap": 2, "vendor": "Acme", "model": "Mixer", "address_base": 0, "word_order": "big", "registers": [
    {"name": "Setpoint", "area": "holding", "address": 10, "type": "float32", "unit": "V", "access": "RW"},
    {"name": "Actual", "area": "input", "address": 10, "type": "float32", "unit": "V", "access": "RW"},
    {"name": "Sensor", "area": "input", "address": 12, "type": "float32", "unit": "V", "access": "R"},
    {"name": "Count", "area": "input", "address": 14, "type": "uint16"},
    {"name": "Total", "area": "holding", "address": 20, "type": "uint64", "access": "R"},
    {"name": "Scaled", "area": "holding", "address": 24, "type": "float32", "scale": 0.1, "access": "R"}
  ] }"#;
const MIXER_BENCH: &str = "[[drive]]\nmodel = \"foreign\"\naddress = 5\nregisters = { 10 = 17254, 11 = 26214, 300011 = 17254, \
    300012 = 26214, 300013 = 32704, 300014 = 0, 300015 = 7 }\n";

fn mixer(line: &str) -> Run {
    let catalogue = antrieb("params import {dir}/map.json").file("map.json", MIXER).exits(0).out;
    let line = format!("--catalogue {{dir}}/map.toml --drive acme-mixer -a 5 {line}");
    antrieb(&line).file("map.toml", &catalogue).on(MIXER_BENCH)
}

#[test]
fn a_float_is_read_written_saved_and_loaded_as_the_number_that_it_is() {
    let read = mixer("-v read setpoint actual sensor count").run();
    let told = read.telegrams('>').join("\n");
    // V1.1b3 6.3 and 6.4: the same number in another area is another register.
    assert!(told.contains("05 03 00 0A 00 02") && told.contains("05 04 00 0A 00 02"), "{told}");
    assert!(read.out.contains("230.4") && read.out.contains("no number"), "{}", read.out);
    let read = mixer("read setpoint sensor").json().exits(0);
    let row = read.data("/values/0");
    assert_eq!(
        (&row["value"], &row["raw"], &row["data_type"]),
        (&json!(230.4), &json!(0x4366_6666_u32), &json!("float"))
    );
    assert_eq!((read.data("/values/1/value"), read.data("/values/1/text")), (&Value::Null, &json!("no number")));
    // The bits of what is no number are for programs.
    let odd = mixer("--lang de read sensor").exits(0).out;
    assert!(odd.contains("keine Zahl") && !odd.contains(&0x7FC0_0000_u32.to_string()), "{odd}");
    assert_eq!(read.data("/values/1/raw"), &json!(0x7FC0_0000_u32));
    for (typed, sent, shown) in [
        ("setpoint=231,5V", "05 10 00 0A 00 02 04 43 67 80 00", "231.5"),
        ("setpoint=-0.1", "05 10 00 0A 00 02 04 BD CC CC CD", "-0.1"),
        ("setpoint -2,5kV", "05 10 00 0A 00 02 04 C5 1C 40 00", "-2500"),
    ] {
        let written = mixer(&format!("-v write {typed} --yes")).exits(0);
        assert!(written.telegrams('>').iter().any(|telegram| telegram.starts_with(sent)), "{typed}: {}", written.err);
        assert!(written.out.contains(shown) && written.out.contains("verified"), "{typed}: {}", written.out);
    }
    let asked = mixer("write setpoint=231,5").exits(8);
    assert!(asked.err.contains("230.4 -> 231.5 V"), "{}", asked.err);
    for wrong in ["setpoint=1e5", "setpoint=abc", "setpoint=5A", "actual=5", "count=5"] {
        mixer(&format!("write {wrong} --yes")).exits(7);
    }
    let saved = mixer("dataset save {dir}/mixer.toml").exits(0);
    let text = saved.text_of("mixer.toml");
    assert!(text.contains("\"10\" = \"230.4 V\""), "{text}");
    let other = text.replace("230.4 V", "12.25 V");
    let load = mixer("dataset load {dir}/other.toml --yes").file("other.toml", &other).exits(0);
    assert!(load.out.contains("230.4") && load.out.contains("12.25"), "{}", load.out);
    let differs = mixer("dataset check {dir}/other.toml").file("other.toml", &other).exits(1);
    assert!(differs.out.contains("230.4") && differs.out.contains("12.25"), "{}", differs.out);
}

#[test]
fn what_no_register_of_ours_holds_stays_left_out_with_its_reason() {
    let told = antrieb("params import {dir}/map.json").file("map.json", MIXER).exits(0).out;
    assert!(told.contains("left out, line 6: the type 'uint64' is none that this program shows right"), "{told}");
    assert!(told.contains("left out, line 7: a float that is scaled"), "{told}");
    let table =
        "Nr;Name;Type;Unit;Scale;Min\n1;Level;float32;bar;1;0\n2;Flow;real;l/h;0,1;\n300005;Speed;int16;1/min;1;\n";
    let told = antrieb("params import --own mixer {dir}/list.csv").file("list.csv", table).exits(0).out;
    assert!(told.contains("type = \"float\"") && told.contains("id = 300005"), "{told}");
    assert!(told.contains("left out, line 3: a float that is scaled"), "{told}");
    let bad = mixer("params").exits(0).text_of("map.toml").replace("type = \"float\"", "type = \"float\", min = 0");
    let refused = antrieb("--catalogue {dir}/bad.toml params").file("bad.toml", &bad).exits(7);
    assert!(refused.err.contains("a float has no `decimals`, `min`, `max` and `default` here"), "{}", refused.err);
}

#[test]
fn what_a_map_says_that_cannot_be_shown_right_is_left_out_with_its_line() {
    let told = |map: &str, line: &str| {
        antrieb(&format!("params import {{dir}}/map.json {line}")).file("map.json", map).exits(0).out
    };
    let meter = told(METER, "");
    for line in [
        "# the map says of the line: protocol rtu, unit_id 1, baudrate 9600, parity N",
        "id = 300041, slug = \"voltage-300041\"",
        "left out, line 7: the type 'string'",
        "left out, line 8: area 'coil' holds no register",
        "low_half_first = true",
        "title = { en = \"Zähler & Söhne EM 1\"",
    ] {
        assert!(meter.contains(line.trim_start_matches("# ")), "{line}\n{meter}");
    }
    assert!(told(METER, "--input-as-holding").contains("id = 40, slug = \"voltage-40\""));
    let drive = told(DRIVE, "--own vsd --title 'My drive'");
    assert!(
        drive.contains("left out, line 11: the key 'scale_register' is not known and may change the value"),
        "{drive}"
    );
    assert!(drive.contains("drives = [{ id = \"vsd\", en = \"My drive\""), "{drive}");
    assert!(told(DRIVE, "--ignore scale_register").contains("id = 41, slug = \"torque\""));
    let fan = told(FAN, "--lang de");
    assert!(fan.contains("ausgelassen, Zeile 2: Register 14 ist schon vergeben, aus Zeile 2"), "{fan}");
    assert!(fan.contains("ausgelassen, Zeile 3: mit dieser Skalierung"), "{fan}");
    for (from, to, why) in [
        ("\"address_base\":0,", "", "the map does not say whether its addresses begin with 0 or 1"),
        ("\"address_base\":0,", "\"address_base\":0,\"byte_order\":\"little\",", "byte_order 'little'"),
        ("\"vendor\":\"Ventus\",\"model\":\"ECO\",", "", "the map names neither vendor nor model"),
        ("\"mbmap\":2", "\"mbmap\":3", "no MBMap of version 2"),
        ("\"registers\":[", "\"rows\":[", "the list \"registers\" is missing"),
        (
            "\"vendor\":\"Ventus\",\"model\":\"ECO\"",
            "\"vendor\":\"\",\"model\":\"ACU\"",
            "the id of a drive, 'acu', is taken",
        ),
    ] {
        let map = FAN.replace(from, to);
        assert_ne!(map, FAN, "{from}");
        let refused = antrieb("params import {dir}/map.json").file("map.json", &map).exits(7);
        assert!(refused.err.contains(why), "{why}\n{}", refused.err);
        antrieb("--lang de params import {dir}/map.json").file("map.json", &map).exits(7);
    }
}

#[test]
fn a_table_can_bring_a_family_of_its_own() {
    let list = "Register;Name;Type;Unit;Scale;Access\n40011;Voltage;UINT32;V;0,1;RO\n40013;Speed;INT16;rpm;1;RO\n40041;Ramp;UINT16;s;0,01;RW\n";
    let refused = antrieb("params import {dir}/a.csv --own meter").file("a.csv", list).exits(7);
    assert!(refused.err.contains("--base 40001, or --base 0"), "{}", refused.err);
    let line = "params import {dir}/a.csv --own meter --base 40001 --low-half-first";
    let catalogue = antrieb(line).file("a.csv", list).exits(0).out;
    let line = "--catalogue {dir}/a.toml --drive meter -a 5 read voltage speed ramp";
    let read = antrieb(line).file("a.toml", &catalogue).on(BENCH).json().exits(0);
    let values: Vec<&Value> = (0..3).map(|row| read.data(&format!("/values/{row}/value"))).collect();
    assert_eq!(values, [&json!(230.5), &json!(-1450), &json!(7.5)]);
    // The round trip of a family of its own.
    let export =
        antrieb("--catalogue {dir}/a.toml --drive meter params export").file("a.toml", &catalogue).exits(0).out;
    let line = "params import {dir}/b.csv --own meter --low-half-first";
    let again = antrieb(line).file("b.csv", &export).exits(0).out;
    let rows = |text: &str| text.lines().filter(|line| line.starts_with("  {")).map(str::to_owned).collect::<Vec<_>>();
    assert_eq!(rows(&again), rows(&catalogue));
}

/// 40001 and 30005 in one list: nobody but the maker knows whether they are registers or the printed names of two areas.
#[test]
fn printed_names_of_holding_and_of_input_registers_are_asked_for_and_told_apart() {
    let list = "Adresse;Name;Typ\n40001;A;UINT16\n40003;B;UINT32\n30005;C;INT16\n";
    let refused = antrieb("params import {dir}/a.csv --own meter").file("a.csv", list).exits(7);
    assert!(refused.err.contains("--base 40001 takes those above 30001 as input registers"), "{}", refused.err);
    let ids = |list: &str, base: u32| {
        let line = format!("params import {{dir}}/a.csv --own meter --low-half-first --base {base}");
        let catalogue = antrieb(&line).file("a.csv", list).exits(0).out;
        let rows = catalogue
            .lines()
            .filter_map(|line| line.trim().strip_prefix("{ id = "))
            .map(|row| row.split(',').next().unwrap_or_default().to_owned());
        rows.filter(|id| id.bytes().all(|byte| byte.is_ascii_digit())).collect::<Vec<_>>()
    };
    assert_eq!(ids(list, 40_001), ["0", "2", "300005"]);
    assert_eq!(ids(list, 0), ["40001", "40003", "30005"]);
    let six = "Register;Name;Type\n400011;A;UINT16\n300002;B;UINT16\n";
    antrieb("params import {dir}/a.csv --own meter").file("a.csv", six).exits(7);
    assert_eq!(ids(six, 400_001), ["10", "300002"]);
    let inputs = "Register;Name;Type\n30001;A;UINT16\n30002;B;UINT16\n";
    let refused = antrieb("params import {dir}/a.csv --own meter").file("a.csv", inputs).exits(7);
    assert!(refused.err.contains("--base 30001"), "{}", refused.err);
    assert_eq!(ids(inputs, 30_001), ["300001", "300002"]);
    // Six digits with a 3 in front are our own way to name an input register.
    assert_eq!(ids("Register;Name;Type\n300001;A;UINT16\n5;B;UINT16\n", 0), ["300001", "5"]);
}
