//! A drive that is given up, and answers again behind that: what it gets then.

use super::by_chance::Trial;
use antrieb::profile::Registry;

const ACU: &str = "[[drive]]\nmodel = \"acu\"\nset = { \"412\" = 1, \"434\" = 3, \"228\" = 0, \"418\" = 0 }\n";
const LINE: &str = "-a 1 --drive acu sollwert 10Hz --source line --enable --hold --duration 60s";

/// Three presses on a line that went dead: it is given up, and answers a moment later.
#[test]
fn a_drive_that_comes_back_behind_a_hurried_stop_gets_its_settings_back() {
    let registry = Registry::open(&[]).unwrap();
    let mut stopped = 0;
    for tenths in (20..160).step_by(5) {
        let silent = format!("[[drive.event]]\nafter_telegrams = 60\nsilent = \"{}ms\"\n", tenths * 100);
        let seen = Trial::on_bench(LINE, &format!("{ACU}{silent}"), &registry, (&[121, 122, 123], None));
        if seen.bench.totals().energised == 0 {
            stopped += 1;
            let source = seen.bench.drive(1).unwrap().ram(434, 6);
            assert_eq!(source, Some(3), "{tenths}: {:?} {}", seen.failure, seen.log.join("\n"));
        }
    }
    assert!(stopped > 3, "{stopped}");
}
