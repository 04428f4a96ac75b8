//! Sessions of the long form in which a wrong value was once believed. By their seeds, so that none of them is again.

use super::thrown::{MANNERS, replay};
use antrieb::protocol::Protocol;
use antrieb::protocol::modbus::Framing;

const RTU: Protocol = Protocol::Modbus(Framing::Rtu);
const ASCII: Protocol = Protocol::Modbus(Framing::Ascii);

/// Protocol, manner, seed.
const FOOLED: [(Protocol, &str, u64); 10] = [
    // An answer that was kept back paid what the station owed another master, who had not asked yet.
    (RTU, "another master alone", 7_000_315),
    (ASCII, "another master, same stations", 7_000_344),
    // The first copy that ever came, in place of an answer that was lost or late.
    (RTU, "another master, same stations", 7_000_258),
    (ASCII, "gateway", 7_000_102),
    (ASCII, "gateway", 7_000_309),
    // The first copy of all, sooner than ever, and of the true answer only its beginning in time: the adapter held the rest back.
    (RTU, "faults", 1_004_003_012),
    // The first copy of all, sooner than ever, and the true answer was lost.
    (RTU, "faults", 1_000_003_030),
    // The first copy of all, when an answer usually comes, on a line on which nothing had gone wrong before.
    (RTU, "faults", 1_007_003_025),
    // Another master's question met ours and was answered; of the two less was left than a telegram.
    (ASCII, "another master alone", 1_006_003_033),
    // Another master's question met ours and was answered, twice the same.
    (ASCII, "another master, same stations", 7_000_233),
];

#[test]
fn a_session_that_was_fooled_once_is_not_fooled_again() {
    for (protocol, name, seed) in FOOLED {
        let manner = MANNERS.iter().find(|manner| manner.name == name).unwrap();
        let score = replay(protocol, manner, seed);
        assert!(score.found.is_empty() && score.right > 0, "{}", score.found.join("\n"));
    }
}
