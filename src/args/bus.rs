//! The system bus among the settings: nodes, and a CAN bus in place of a serial line.

use super::address::Addresses;
use super::globals::Auto;
use super::low::Low;
use super::wrong::bad_setting;
use crate::failure::Failure;
use crate::protocol::Protocol;
use crate::protocol::can::{LAST_DRIVE, MASTER_STATION, SdoChannel};
use crate::text::both;
use crate::transport::Port;

/// A node of the system bus lies behind a drive that passes on what it is asked.
///
/// # Errors
/// What is spoken reaches none.
pub fn check_node(node: u8, protocol: Protocol) -> Result<(), Failure> {
    if node == 0 || protocol == Protocol::Vabus {
        return Ok(());
    }
    let why = both!(
        "a node of the system bus is reached only over VABus",
        "ein Knoten des Systembusses ist nur über VABus erreichbar"
    );
    Err(bad_setting("address", why).hint(both!(
        "add --protocol vabus, or name the drive alone",
        "--protocol vabus angeben, oder nur den Antrieb nennen"
    )))
}

/// A CAN bus has nodes from 1 to 63 for its drives (EM-RES-03 manual 5.5), a station for the one that is the master, and no characters.
pub(super) fn check_bus(low: &Low<'_>, addresses: &Addresses, protocol: Protocol) -> Result<(), Failure> {
    let Protocol::Sdo(_) = protocol else {
        return if low.means_master() { Err(no_master()) } else { Ok(()) };
    };
    if let Addresses::Named(nodes) = addresses
        && let Some(node) = nodes.iter().find(|node| !(1..=MASTER_STATION).contains(*node))
    {
        let why = both!(
            "expected nodes from 1 to {LAST_DRIVE}, got {node}",
            "erwartet: Knoten von 1 bis {LAST_DRIVE}; angegeben: {node}"
        );
        let zero = both!(
            "the drive that is the master (node 0) is reached as -a master; 0 would be everybody",
            "der Umrichter, der Master ist (Knoten 0), ist als -a master erreichbar; 0 wären alle"
        );
        let failure = bad_setting("address", why);
        return Err(if *node == 0 { failure.hint(zero) } else { failure });
    }
    let flags = low.flags;
    if flags.baud == Some(Auto::Auto) {
        let why = both!(
            "auto is not found out on a CAN bus; expected its bit rate",
            "auto wird an einem CAN-Bus nicht ermittelt; erwartet: seine Bitrate"
        );
        return Err(bad_setting("baud", why));
    }
    if flags.parity.is_some() || flags.data_bits.is_some() || flags.stop_bits.is_some() {
        let why = both!(
            "a CAN bus has no parity, data bits or stop bits",
            "ein CAN-Bus hat keine Parität, Daten- oder Stoppbits"
        );
        return Err(bad_setting("parity", why));
    }
    Ok(())
}

fn no_master() -> Failure {
    let why = both!("only a CAN bus has a master as an address", "nur ein CAN-Bus hat einen Master als Adresse");
    bad_setting("address", why).hint(both!(
        "on a serial line the drive that is the master has an address like any other",
        "an einer seriellen Leitung hat der Umrichter, der Master ist, eine Adresse wie jeder andere"
    ))
}

/// Bits per second of a CAN bus. The factory setting of P.903 is in no source, so nobody but the bench has a usual one.
pub(super) fn bit_rate(named: Option<u32>, ports: &[Port]) -> Result<u32, Failure> {
    let is_bench = ports.iter().all(|port| matches!(port, Port::Sim(_)));
    named.or(is_bench.then_some(BENCH_RATE)).ok_or_else(|| {
        let why = both!("expected the bit rate of the bus", "erwartet: die Bitrate des Busses");
        bad_setting("baud", why).hint(both!(
            "P.903 of every drive tells it: -b 50000, 100000, 125000, 250000, 500000 or 1000000",
            "P.903 jedes Umrichters nennt sie: -b 50000, 100000, 125000, 250000, 500000 oder 1000000"
        ))
    })
}

/// Bits per second of the built-in bus.
const BENCH_RATE: u32 = 500_000;

/// An adapter of a CAN bus carries SDO and nothing else; nobody speaks it elsewhere.
pub(super) fn on_bus(protocol: Protocol, named: bool, ports: &[Port]) -> Result<Option<Protocol>, Failure> {
    let is_adapter = |port: &Port| matches!(port, Port::Slcan(_) | Port::Can(_));
    let is_either = |port: &Port| is_adapter(port) || matches!(port, Port::Sim(_) | Port::Tape(_));
    match protocol {
        Protocol::Sdo(_) if ports.iter().all(is_either) => Ok(Some(protocol)),
        Protocol::Sdo(_) => Err(bad_setting(
            "protocol",
            both!("{protocol} is spoken on a CAN bus", "{protocol} wird an einem CAN-Bus gesprochen"),
        )
        .hint(both!("name the adapter with -p slcan:/dev/ttyACM0", "den Adapter mit -p slcan:/dev/ttyACM0 nennen"))),
        _ if !ports.iter().any(is_adapter) => Ok(None),
        _ if !named => Ok(Some(Protocol::Sdo(SdoChannel::Two))),
        _ => Err(bad_setting(
            "protocol",
            both!(
                "a CAN adapter carries sdo or sdo1, got {protocol}",
                "ein CAN-Adapter trägt sdo oder sdo1; angegeben: {protocol}"
            ),
        )),
    }
}
