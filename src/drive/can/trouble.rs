//! What goes wrong with a CAN adapter and the bus behind it, said in both languages, with what to do next.

use crate::exchange::can::Unopened;
use crate::failure::{Class, Failure};
use crate::protocol::can::slcan::RATES;
use crate::text::{Text, both};

/// A bit rate that SLCAN has no number for.
pub(super) fn bit_rate(bit_rate: u32) -> Failure {
    let known = RATES.map(|rate| (u32::from(rate) * 1_000).to_string()).join(", ");
    let message = both!(
        "{bit_rate} bit/s is no bit rate that an SLCAN adapter has; expected {known}",
        "{bit_rate} bit/s ist keine Bitrate, die ein SLCAN-Adapter hat; erwartet: {known}"
    );
    Failure::new(Class::Usage, "usage.baud", message)
}

/// The channel was not opened.
pub(in crate::drive) fn unopened(port: &str, bit_rate: u32, why: &Unopened) -> Failure {
    let kbit = bit_rate / 1_000;
    match why {
        Unopened::NoAdapter(bytes) => Failure::new(
            Class::Port,
            "port.no_slcan",
            both!(
                "{port} speaks no SLCAN: what came is no word of it ({came})",
                "{port} spricht kein SLCAN: was kam, gehört nicht dazu ({came})",
                came = Text::count(*bytes, ["byte", "bytes"], ["Byte", "Bytes"])
            ),
        )
        .hint(both!(
            "is it the port of the CAN adapter? A firmware for another protocol (gs_usb, candleLight) has no serial port",
            "Ist es der Anschluss des CAN-Adapters? Firmware für ein anderes Protokoll (gs_usb, candleLight) hat keinen \
             seriellen Anschluss"
        )),
        Unopened::Rate => Failure::new(
            Class::Port,
            "port.can_rate",
            both!(
                "the CAN adapter at {port} refuses {kbit} kbit/s",
                "der CAN-Adapter an {port} lehnt {kbit} kbit/s ab"
            ),
        )
        .hint(both!(
            "its manual tells which rates it has; P.903 of the drives takes 50, 100, 125, 250, 500 and 1000 kbit/s",
            "seine Anleitung nennt seine Bitraten; P.903 der Umrichter kennt 50, 100, 125, 250, 500 und 1000 kbit/s"
        )),
        Unopened::Refused => Failure::new(
            Class::Port,
            "port.can_open",
            both!(
                "the CAN adapter at {port} refuses to open its channel",
                "der CAN-Adapter an {port} lehnt es ab, seinen Kanal zu öffnen"
            ),
        )
        .hint(both!("unplug it and plug it in again", "abziehen und wieder einstecken")),
        Unopened::Errors(flags) => Failure::new(
            Class::Garbled,
            "garbled.bit_rate",
            both!(
                "at {kbit} kbit/s the adapter at {port} hears errors and no frame (status flags {flags:02X}h); nothing was sent",
                "mit {kbit} kbit/s hört der Adapter an {port} Fehler und keinen Frame (Statusbits {flags:02X}h); es wurde nichts \
                 gesendet"
            ),
        )
        .hint(match port.strip_prefix("can:") {
            Some(name) => both!(
                "most likely {name} was set to another bit rate than the bus has (P.903 of every drive): `ip -details link show {name}` \
                 tells it; or the terminations are missing",
                "wahrscheinlich ist {name} auf eine andere Bitrate eingestellt, als der Bus hat (P.903 jedes Umrichters): \
                 `ip -details link show {name}` nennt sie; oder die Abschlüsse fehlen"
            ),
            None => both!(
                "most likely the bus has another bit rate (-b; P.903 of every drive), or its terminations are missing",
                "wahrscheinlich hat der Bus eine andere Bitrate (-b; P.903 jedes Umrichters), oder die Abschlüsse fehlen"
            ),
        }),
    }
}

/// Nothing was heard; the status flags of the adapter, if they tell of errors.
pub(in crate::drive) fn unheard(port: &str, bit_rate: u32, flags: Option<u8>) -> Failure {
    if let Some(flags) = flags {
        return unopened(port, bit_rate, &Unopened::Errors(flags));
    }
    let kbit = bit_rate / 1_000;
    let message =
        both!("nothing was heard on {port} at {kbit} kbit/s", "auf {port} war mit {kbit} kbit/s nichts zu hören");
    Failure::new(Class::Silence, "silence.nothing_heard", message).hint(both!(
        "a bus where no node is Operational and no master beats the time is silent; `antrieb scan` asks the nodes",
        "ein Bus, an dem kein Knoten Operational ist und kein Master den Takt gibt, ist still; `antrieb scan` fragt die Knoten"
    ))
}

/// Somebody asks over SDO2.
pub(super) fn other_tool() -> Failure {
    let message = both!(
        "somebody else asks nodes over SDO2, which is one tool's alone; nothing was sent",
        "jemand anders fragt Knoten über SDO2, das einem einzigen Werkzeug gehört; es wurde nichts gesendet"
    );
    Failure::new(Class::Forbidden, "forbidden.other_tool", message).hint(both!(
        "close the other tool (VPlus over CAN?), or go over the serial plug of a drive",
        "das andere Werkzeug schließen (VPlus über CAN?), oder über den seriellen Anschluss eines Umrichters gehen"
    ))
}

/// There is a master, and SDO1 is his.
pub(in crate::drive) fn other_master() -> Failure {
    let message = both!(
        "a master is active on this bus, and SDO1 is his; nothing was sent",
        "an diesem Bus ist ein Master aktiv, und SDO1 gehört ihm; es wurde nichts gesendet"
    );
    Failure::new(Class::Forbidden, "forbidden.other_master", message)
        .hint(both!("SDO2 is there for tools: --protocol sdo", "für Werkzeuge ist SDO2 da: --protocol sdo"))
}
