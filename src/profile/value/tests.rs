//! Values as technicians type them and as they are shown: exact both ways, with their units, and what does not fit.

use super::*;
use proptest::prelude::*;

fn param(unit: &str, decimals: u8) -> Param {
    Param { unit: Some(unit.to_owned()), decimals: Some(decimals), ..Param::unknown(1) }
}

#[test]
fn decimals_are_exact_both_ways() {
    for (raw, decimals, text) in
        [(10_025, 2, "100.25"), (-12_000, 2, "-120.00"), (5, 3, "0.005"), (-5, 1, "-0.5"), (7, 0, "7")]
    {
        assert_eq!(format_decimal(raw, decimals), text);
        assert_eq!(parse_decimal(text, decimals), Ok(raw));
    }
}

/// What is too fine is told with the values on both sides, the smaller one first.
#[test]
fn what_is_too_fine_is_told_with_its_neighbours() {
    for (text, near) in
        [("5.001", ["5.00 Hz", "5.01 Hz"]), ("-5.001", ["-5.01 Hz", "-5.00 Hz"]), ("-0.001", ["-0.01 Hz", "0.00 Hz"])]
    {
        let Err(ValueError::Decimals { step, near: told, .. }) = parse(text, &param("Hz", 2), &[]) else {
            panic!("{text}")
        };
        assert_eq!((step.as_str(), told), ("0.01 Hz", near.map(str::to_owned)), "{text}");
    }
}

/// Of a table as many values are named as can be read at once; a raw value may be up to its largest, if nothing else tells.
#[test]
fn a_table_tells_its_first_values_and_its_largest() {
    let choices: Vec<_> = (0..9).map(|raw| (raw, ["one", "einer"])).collect();
    let told = |count: usize| may_be(&param("", 0), &choices[..count]).len();
    assert_eq!([told(7), told(8), told(9)], [7, 8, 9], "eight, and where the rest is");
    assert!(
        may_be(&param("", 0), &choices)[8].en.contains("lists all")
            && !may_be(&param("", 0), &choices[..8])[7].en.contains("lists all")
    );
    assert_eq!([8, 9].map(|raw| may_be_raw(raw, &param("", 0), &choices)), [true, false]);
}

#[test]
fn values_come_as_technicians_type_them() {
    for (text, unit, decimals, raw) in [
        ("1.5kW", "kW", 1, 15),
        ("1500 W", "kW", 1, 15),
        ("10,3 A", "A", 1, 103),
        ("-120 Hz", "Hz", 2, -12_000),
        ("0x0F", "", 0, 15),
        ("1450rpm", "1/min", 0, 1_450),
        ("2.50", "s", 1, 25),
        (".5", "s", 1, 5),
        ("250ms", "s", 2, 25),
        ("0", "Hz", 2, 0),
    ] {
        assert_eq!(parse(text, &param(unit, decimals), &[]), Ok(raw), "{text}");
    }
}

#[test]
fn what_does_not_fit_is_named() {
    let hertz = param("Hz", 2);
    assert!(matches!(parse("5 A", &hertz, &[]), Err(ValueError::Unit { .. })));
    assert!(matches!(parse("5.001", &hertz, &[]), Err(ValueError::Decimals { .. })));
    let hex = ["0xZZ", "0x", "0x+", "0x-1", "0x+1", "0x-8000000000000000", "0x8000000000000000", "0x1_0"];
    for text in ["", "abc", "-", "1.2.3", "--1", "99999999999999999999", "1e5"].into_iter().chain(hex) {
        assert!(parse(text, &hertz, &[]).is_err(), "{text}");
    }
}

/// `1.450` is one thousand to a German, and `1,450` to an Englishman.
#[test]
fn a_separator_before_three_digits_is_a_decimal_point_only_where_there_are_so_many_decimals() {
    for (text, unit, decimals) in
        [("3.000", "1/min", 0), ("3,000rpm", "1/min", 0), ("-1.450", "Hz", 2), ("1.500 kW", "kW", 1)]
    {
        let refused = parse(text, &param(unit, decimals), &[]);
        assert!(matches!(refused, Err(ValueError::Thousands { .. })), "{text}: {refused:?}");
    }
    for (text, unit, decimals, raw) in [
        ("1.450", "s", 3, 1_450),
        ("1.500 s", "ms", 0, 1_500),
        ("0.500", "Hz", 2, 50),
        ("3000.000", "Hz", 2, 300_000),
        ("1.50", "Hz", 2, 150),
    ] {
        assert_eq!(parse(text, &param(unit, decimals), &[]), Ok(raw), "{text}");
    }
    let told = parse("1.450", &param("Hz", 2), &[]).unwrap_err().text().en;
    assert!(told.starts_with("'1.450' may mean 1.45 or 1450"), "{told}");
}

#[test]
fn texts_of_the_table_are_values() {
    let choices = [(0, ["Even", "Gerade"]), (1, ["Odd", "Ungerade"]), (10, ["19200 Bd", "19200 Bd"])];
    let parity = param("", 0);
    assert_eq!(parse("even", &parity, &choices), Ok(0));
    assert_eq!(parse("unger", &parity, &choices), Ok(1));
    let protocols = [(2, ["Modbus RTU", "Modbus RTU"]), (3, ["Modbus ASCII", "Modbus ASCII"])];
    assert_eq!(parse("rtu", &parity, &protocols), Ok(2));
    assert!(parse("modbus", &parity, &protocols).is_err());
    for baud in ["19200 Bd", "19200Bd", "19200"] {
        assert_eq!(parse(baud, &parity, &choices), Ok(10), "{baud}");
    }
    assert!(
        matches!(parse("mark", &parity, &choices), Err(ValueError::NotANumber { choices, .. }) if choices.len() == 3)
    );
}

#[test]
fn every_unit_is_converted_by_its_power() {
    for (text, unit, decimals, raw) in [
        ("1450 min-1", "1/min", 0, 1_450),
        ("90 deg", "°", 0, 90),
        ("250000 mW", "kW", 3, 250),
        ("20 mA", "A", 2, 2),
        ("1500 mV", "V", 1, 15),
        ("2 kV", "V", 1, 20_000),
        ("3s", "ms", 0, 3_000),
        ("0.5 kHz", "Hz", 2, 50_000),
    ] {
        assert_eq!(parse(text, &param(unit, decimals), &[]), Ok(raw), "{text}");
        assert!(carries_unit(text, Some(unit)), "{text}");
    }
    assert!(!carries_unit("5 A", Some("Hz")) && !carries_unit("5 Hz", None));
}

#[test]
fn a_large_unit_ends_where_no_drive_has_such_a_number() {
    let hertz = param("Hz", 9);
    assert_eq!(parse("9 kHz", &hertz, &[]), Ok(9_000_000_000_000));
    assert_eq!(parse_decimal("0", 200), Ok(0), "no zeros are written down for nothing");
    assert!(matches!(parse_decimal("1", 20), Err(ValueError::TooLarge { .. })), "20 zeros are a number still");
    assert!(matches!(parse_decimal("1", 21), Err(ValueError::NotANumber { .. })));
}

#[test]
fn what_would_have_been_right_is_listed() {
    let choices = [(0, ["Even", "Gerade"]), (1, ["Odd", "Ungerade"])];
    let told = parse("mark", &param("", 0), &choices).unwrap_err().to_string();
    let expected = "'mark' is neither a number nor one of the values of this parameter (expected: 0 = Even, 1 = Odd)";
    assert_eq!(told, expected);
    let bare = parse("mark", &param("", 0), &[]).unwrap_err().to_string();
    assert_eq!(bare, "'mark' is no number");
    let range = Param { min: Some(1), max: Some(80), ..param("kHz", 1) };
    let range = parse("mark", &range, &[]).unwrap_err().to_string();
    assert_eq!(range, "'mark' is no number (expected: 0.1 … 8.0)");
    let many: Vec<_> = (0..9).map(|raw| (raw, ["One", "Eins"])).collect();
    let many = parse("mark", &param("", 0), &many).unwrap_err().to_string();
    assert!(many.contains(", 7 = One, … (`antrieb params ") && many.ends_with(" lists all))"), "{many}");
}

#[test]
fn a_number_that_is_a_raw_value_is_that_value() {
    // 19200 is the text of 10, and no raw value itself; 1 is one, and the first word of another's text as well.
    let choices = [(10, ["19200 Bd", "19200 Bd"]), (1, ["Odd", "Ungerade"]), (7, ["1 stop bit", "1 Stoppbit"])];
    let param = param("", 0);
    assert_eq!(parse("19200", &param, &choices), Ok(10));
    assert_eq!(parse("1", &param, &choices), Ok(1));
    assert_eq!(parse("3", &param, &choices), Ok(3), "a gap in a table is the range's business");
    // P.570: the sources name 11 to 15 only, and 1 is a word of the text of 13.
    let times = [(11, ["Warning", "Warnung"]), (13, ["Fault after 1 min", "Störung nach 1 min"])];
    assert_eq!(parse("1", &param, &times), Ok(1));
}

#[test]
fn a_value_without_a_known_scale_is_not_guessed() {
    let unscaled = Param { decimals: None, ..param("Hz", 0) };
    assert_eq!(parse("5", &unscaled, &[]), Err(ValueError::NoScale { unit: "Hz".to_owned() }));
    assert_eq!(parse("0x5", &unscaled, &[]), Ok(5), "raw is raw");
}

#[test]
fn the_ends_of_a_range_belong_to_it() {
    let limited = Param { min: Some(-5), max: Some(10), ..param("Hz", 1) };
    assert_eq!([-6, -5, 0, 10, 11].map(|raw| check_range(raw, &limited).is_ok()), [false, true, true, true, false]);
    let told = check_range(11, &limited).unwrap_err().to_string();
    assert_eq!(told, "1.1 is out of the range -0.5 … 1.0");
    let open = Param { min: None, ..limited };
    assert_eq!(check_range(11, &open).unwrap_err().to_string(), "1.1 is out of the range … … 1.0");
    for (kind, min, max) in [(Type::Uint, 0, 65_535), (Type::Int, -32_768, 32_767)] {
        let fits = [min - 1, min, max, max + 1].map(|raw| check_width(raw, kind, 0).is_ok());
        assert_eq!(fits, [false, true, true, false], "{kind:?}");
    }
    assert_eq!(check_width(70_000, Type::Uint, 2).unwrap_err().to_string(), "700.00 does not fit into a uint");
}

#[test]
fn a_value_on_the_wire_is_shown_in_its_type_and_unit() {
    let signed = Param { kind: Some(Type::Int), ..param("A", 1) };
    assert_eq!(format_value(&signed, 0xFFFF_FFF6, false), "-1.0 A");
    assert_eq!(format_value(&signed, 0xFFFF_FFF6, true), "-1.0 A");
    assert_eq!(format_value(&signed, 0x0001_0000, true), "6553.6 A", "two registers are a Long, whatever the row says");
    let long = Param { kind: Some(Type::Long), unit: None, ..param("", 0) };
    assert_eq!(format_value(&long, 0x0001_FFFF, false), "65535", "one register holds 16 bits");
    assert_eq!(from_wire(0x0001_0005, Type::Uint, None), 5);
    assert_eq!(from_wire(0x0001_0005, Type::Word, None), 5);
    assert_eq!(from_wire(0xFFFF, Type::Word, Some(0)), 65_535, "a range from 0 has no sign");
}

#[test]
fn wire_width_and_sign() {
    assert_eq!(from_wire(0xFFFF_D120, Type::Long, None), -12_000);
    assert_eq!(from_wire(3_000_000_000, Type::Long, Some(0)), 3_000_000_000, "what is never below 0 has no sign");
    assert_eq!(to_wire(-12_000, Type::Long), Ok(0xFFFF_D120));
    assert_eq!(from_wire(0xFFFF, Type::Word, None), 65_535);
    assert_eq!(from_wire(0xFFFF, Type::Word, Some(-100)), -1);
    assert_eq!(to_wire(-1, Type::Int), Ok(0xFFFF));
    assert!(to_wire(65_536, Type::Uint).is_err());
}

proptest! {
    /// Whatever is typed: a value or a word why not, never a panic.
    #[test]
    fn nothing_that_is_typed_panics(text in ".{0,24}", decimals in 0u8..=9, number in "[-+−0-9.,x ]{0,40}[A-Za-z/%]{0,3}") {
        for unit in ["Hz", "ms", "s", "kW", "A", "1/min", ""] {
            for text in [&text, &number] {
                let param = param(unit, decimals);
                if let Ok(raw) = parse(text, &param, &[(1, ["One", "Eins"])]) {
                    let _either = (check_range(raw, &param), to_wire(raw, Type::Long), format_decimal(raw, decimals));
                }
            }
        }
    }

    /// A number is that number exactly, or refused: it never wraps.
    #[test]
    fn a_number_is_exact_or_refused(minus: bool, whole in "[0-9]{1,30}", places in 0usize..6, decimals in 0u8..=6) {
        let fraction = "1".repeat(places);
        let text = format!("{}{whole}{}{fraction}", if minus { "-" } else { "" }, if places > 0 { "." } else { "" });
        let exact = format!("{whole}{fraction}{}", "0".repeat(usize::from(decimals).saturating_sub(places)));
        let exact = exact.parse::<i128>().ok().map(|raw| if minus { -raw } else { raw });
        let fits = exact.filter(|_| places <= usize::from(decimals)).and_then(|raw| i64::try_from(raw).ok());
        let told = parse(&text, &param("Hz", decimals), &[]).ok();
        prop_assert_eq!(told, fits.filter(|&raw| raw != i64::MIN));
    }

    /// What goes on the wire comes back as it was, or does not go.
    #[test]
    fn the_wire_keeps_every_value(raw: i64, kind in prop::sample::select(vec![Type::Uint, Type::Int, Type::Word, Type::Long])) {
        if let Ok(bits) = to_wire(raw, kind) {
            prop_assert_eq!(from_wire(bits, kind, Some(raw.min(0))), raw);
        }
    }
}

#[test]
fn zero_has_no_sign() {
    assert_eq!([0, -1, 1].map(|raw| format_decimal(raw, 2)), ["0.00", "-0.01", "0.01"]);
}

#[test]
fn mega_is_no_milli() {
    let power = |typed| unit_power(typed, Some("kW"));
    assert_eq!((power("kw"), power("KW"), power("W")), (Some(0), Some(0), unit_power("w", Some("kW"))));
    assert_eq!((power("MW"), unit_power("MV", Some("mV")), unit_power("MIN", Some("min"))), (None, None, Some(0)));
}

#[test]
fn a_word_carries_a_sign_only_where_its_range_has_one() {
    let plain = Param::unknown(1);
    let signed = Param { min: Some(-100), ..Param::unknown(1) };
    for (raw, param, fits) in [
        (-5, &plain, false),
        (0xFFFF, &plain, true),
        (-5, &signed, true),
        (0xFFFF, &signed, false),
        (0x1_0000, &plain, false),
    ] {
        assert_eq!(check_type(raw, Type::Word, param).is_ok(), fits, "{raw}");
    }
    assert!(check_type(-5, Type::Int, &plain).is_ok() && check_type(-5, Type::Uint, &plain).is_err());
}

#[test]
fn every_float_that_is_shown_is_written_back_as_it_was() {
    let mut seed = 1_u32;
    for _ in 0..200_000 {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let Some((raw, places)) = float::decimal(seed) else { continue };
        let text = format_decimal(raw, places);
        let back = float::bits(&text, 0).unwrap();
        assert!(back == seed || (raw, seed) == (0, 0x8000_0000), "{seed:08X} {text}");
    }
}
