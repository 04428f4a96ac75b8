//! A line without bias: a byte of garbage comes before each answer.

use crate::run::antrieb;

/// Whether the line echoes is learnt all the same, and so the answer to a write is told from its echo.
#[test]
fn a_byte_of_noise_before_every_reply_keeps_no_run_from_turning() {
    for (model, protocol, setpoint) in
        [("act", "rtu", "20Hz"), ("act", "ascii", "20Hz"), ("acu", "rtu", "20Hz"), ("lxm05", "rtu", "300rpm")]
    {
        let set = if model == "lxm05" { "" } else { "set = { \"412\" = 1, \"434\" = 2, \"418\" = 0 }\n" };
        let bench = format!(
            "[[drive]]\nmodel = \"{model}\"\naddress = 1\nprotocol = \"{protocol}\"\n{set}[[disturb]]\nevery = 1\nkind = \
             \"noise\"\n"
        );
        let run = format!("--protocol {protocol} -a 1 --yes sollwert {setpoint} --enable --hold --duration 100ms");
        let run = antrieb(&run).on(&bench).json();
        assert_eq!(run.exit, 0, "{model}, {protocol}: {}", run.error());
    }
}
