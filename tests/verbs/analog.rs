//! `procedure analog-input`: two voltages that somebody confirms, and P.253 that proves them.

use crate::run::antrieb;
use antrieb::transport::witness;

const LINE: &str = "-a 1 --yes procedure analog-input";

/// An input that measures beside the truth; 10 V come when the first adjustment is over.
fn bench(changes_at: &str) -> String {
    format!(
        "[[drive]]\nmodel = \"acu\"\nmodules = [\"EM-RES-03\"]\nset = {{ \"412\" = 1 }}\n\
         analog = {{ volts = 0, offset = 0.3, gain = 0.95 }}\n\
         [[drive.event]]\nat = \"{changes_at}\"\nanalog = 10\n"
    )
}

#[test]
fn both_points_are_adjusted_and_shown_to_be() {
    let told = antrieb(LINE).on(&bench("15s")).json().exits(0);
    assert!(told.data("/complete") == true, "{:#}", told.value);
    let found = |nth: usize| told.data(&format!("/steps/{nth}/found")).to_string();
    assert!(found(2).contains("30 -> 0"), "{}", found(2));
    assert!(found(3).contains("950 -> 1000"), "{}", found(3));
    let (bench, _) = witness::left().unwrap();
    assert_eq!(bench.drives().next().unwrap().ram(253, 0), Some(1_000));
    assert_eq!((bench.totals().turning, bench.totals().energised), (0, 0));
    let remarks: Vec<_> = bench.remarks().iter().map(ToString::to_string).collect();
    assert!(remarks.is_empty(), "{remarks:?}");
}

#[test]
fn a_voltage_that_never_came_is_not_called_adjusted() {
    // 0 V lie there still: they are not made to count as 10 V.
    let told = antrieb(LINE).on(&bench("900s")).json().exits(1);
    assert_eq!(told.error()["code"], "no.voltage");
    assert_eq!((told.data("/steps/2/result"), told.data("/steps/3/result")), (&"done".into(), &"failed".into()));
    assert_eq!(witness::left().unwrap().0.drives().next().unwrap().eeprom_writes(), 1, "P.568 = 1 alone");
    // 10 V lie there from the beginning, and are not made to count as 0 V.
    let told = antrieb(LINE).on(&bench("0s")).json().exits(1);
    assert_eq!((told.error()["code"].as_str(), told.data("/steps/2/result")), (Some("no.voltage"), &"failed".into()));
    assert!(told.error()["message"].to_string().contains("cannot be 0 V: nothing was written"), "{}", told.error());
    assert_eq!(witness::left().unwrap().0.drives().next().unwrap().eeprom_writes(), 0);
}

#[test]
fn a_drive_that_has_power_is_not_adjusted() {
    let enabled = bench("15s").replace("\"412\" = 1", "\"412\" = 1, \"410\" = 15");
    let told = antrieb(LINE).on(&enabled).and("-v").exits(8);
    assert!(told.err.contains("not without power"), "{}", told.err);
    let none = antrieb(LINE).on("[[drive]]\nmodel = \"acu\"\n").exits(7);
    assert!(none.err.contains("P.568") || none.err.contains("P.253"), "{}", none.err);
}
