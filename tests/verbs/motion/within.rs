//! Whoever answers within the 500 ms of the manual (CM-485 manual 6.8), everything once and in order, is never called unproven: by no
//! stop, in no family and protocol, named or not.

use crate::run::antrieb;

const VERBS: [&str; 4] =
    ["statemachine quick-stop", "statemachine disable", "statemachine disable-voltage", "sollwert 0"];

/// A drive that is at 20 Hz within 50 ms, or a servo, and answers after so many ms. It slows down by `ramp` hertz a second, and holds its
/// shaft for 1 s (P.638, the factory's).
fn bench(model: &str, protocol: &str, delay: u32, ramp: u32) -> String {
    let of_its_own = match model {
        "lxm05" => "set = { RAMPacc = 3000, RAMPdecel = 3000 }".to_owned(),
        _ => format!(
            "set = {{ \"410\" = 15, \"412\" = 1, \"434\" = 2, \"484\" = 20, \"418\" = 0, \"638\" = 1, \"424\" = {ramp}, \"425\" = {ramp} }}\n\
             ramps = {{ up_right = 400, down_right = {ramp}, up_left = 400, down_left = {ramp} }}"
        ),
    };
    format!(
        "[[drive]]\nmodel = \"{model}\"\nbaud = 19200\nprotocol = \"{protocol}\"\nreply_delay = \"{delay}ms\"\n{of_its_own}\n"
    )
}

/// Every stop of one kind of drive, at every delay.
fn sins(model: &str, protocol: &str) -> Vec<String> {
    let mut sins = Vec::new();
    for named in [format!("--drive {model}"), String::new()] {
        for verb in VERBS {
            for (delay, ramp) in [(100, 50), (200, 8), (300, 50), (400, 20), (450, 8)] {
                let line = format!("-v --protocol {protocol} -b 19200 {named} -a 1 {verb}");
                let run = antrieb(&line).on(&bench(model, protocol, delay, ramp)).run();
                if run.exit != 0 {
                    sins.push(format!("{model} {delay} ms, {ramp} Hz/s {line}: exit {}\n{}", run.exit, run.err));
                }
            }
        }
    }
    sins
}

#[test]
fn a_slow_drive_over_rtu_is_proven_to_stand() {
    let sins = [sins("acu", "rtu"), sins("act", "rtu")].concat();
    assert!(sins.is_empty(), "{} {}", sins.len(), sins.join("\n"));
}

#[test]
fn a_slow_drive_over_ascii_is_proven_to_stand() {
    let sins = sins("acu", "ascii");
    assert!(sins.is_empty(), "{} {}", sins.len(), sins.join("\n"));
}

#[test]
fn a_slow_drive_over_vabus_is_proven_to_stand() {
    let sins = sins("act", "vabus");
    assert!(sins.is_empty(), "{} {}", sins.len(), sins.join("\n"));
}

#[test]
fn a_slow_servo_is_proven_to_stand() {
    let sins = sins("lxm05", "rtu");
    assert!(sins.is_empty(), "{} {}", sins.len(), sins.join("\n"));
}

/// A ramp of 0.4 s behind replies of 0.3 to 0.45 s: few looks fall into the time in which the drive still has power.
#[test]
fn a_short_ramp_behind_slow_replies_is_proven() {
    let mut sins = Vec::new();
    for (model, protocol) in [("acu", "ascii"), ("acu", "rtu"), ("act", "vabus")] {
        for named in [format!("--drive {model}"), String::new()] {
            for verb in ["statemachine quick-stop", "statemachine disable"] {
                for delay in (300..=450).step_by(50).chain([445, 470]) {
                    let line = format!("-v --protocol {protocol} -b 19200 {named} -a 1 {verb}");
                    let run = antrieb(&line).on(&bench(model, protocol, delay, 50)).run();
                    if run.exit != 0 {
                        sins.push(format!("{model} {delay} ms {line}: exit {}\n{}", run.exit, run.err));
                    }
                }
            }
        }
    }
    assert!(sins.is_empty(), "{} {}", sins.len(), sins.join("\n"));
}
