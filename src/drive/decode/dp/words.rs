//! What the numbers of DP and PKW mean, in both languages. Names of the norm stay as they are.

use crate::protocol::dp::Service;
use crate::protocol::dp::control::{Function, Station, Status};
use crate::protocol::dp::pkw::{Answer, Task};
use crate::text::{Text, both};

pub(super) fn function(function: Function) -> Text {
    let short = function.short();
    match function {
        Function::SdaLow | Function::SdaHigh => both!("{short} (send, acknowledged)", "{short} (senden, quittiert)"),
        Function::SdnLow | Function::SdnHigh => {
            both!("{short} (send, not acknowledged)", "{short} (senden, nicht quittiert)")
        }
        Function::SrdLow | Function::SrdHigh => both!("{short} (send and request)", "{short} (senden und anfordern)"),
        Function::FdlStatus => both!("{short} (is anybody there?)", "{short} (ist jemand da?)"),
        Function::Ident => both!("{short} (who is it?)", "{short} (wer ist das?)"),
        Function::LsapStatus => both!("{short} (what is at this point?)", "{short} (was ist an diesem Punkt?)"),
        Function::Other(code) => both!("function {code:X}h, unknown", "Funktion {code:X}h, unbekannt"),
    }
}

pub(super) fn station(station: Station) -> Text {
    match station {
        Station::Slave => both!("slave", "Slave"),
        Station::NotReady => both!("master, not ready", "Master, nicht bereit"),
        Station::Ready => both!("master, ready for the ring", "Master, bereit für den Ring"),
        Station::InRing => both!("master in the ring", "Master im Ring"),
    }
}

pub(super) fn status(status: Status) -> Text {
    match status {
        Status::Ok => both!("OK", "OK"),
        Status::UserError => both!("UE (refused by the user)", "UE (vom Anwender abgelehnt)"),
        Status::NoResource => both!("RR (no room for it)", "RR (kein Platz dafür)"),
        Status::NoService => both!(
            "RS (this point is not in use; to Data_Exchange: the slave has left it)",
            "RS (Zugangspunkt nicht in Betrieb; auf Data_Exchange: der Slave hat ihn verlassen)"
        ),
        Status::DataLow => both!("DL (data)", "DL (Daten)"),
        Status::NoData => both!("NR (no data)", "NR (keine Daten)"),
        Status::DataHigh => {
            both!("DH (data; a diagnosis is there: Slave_Diag)", "DH (Daten; es gibt eine Diagnose: Slave_Diag)")
        }
        Status::DataLowNoResource => {
            both!("RDL (data; no room for yours)", "RDL (Daten; kein Platz für die gesendeten)")
        }
        Status::DataHighNoResource => both!(
            "RDH (data, high priority; no room for yours)",
            "RDH (Daten, hohe Priorität; kein Platz für die gesendeten)"
        ),
        Status::Other(code) => both!("status {code:X}h, unknown", "Status {code:X}h, unbekannt"),
    }
}

pub(super) fn service(service: Service) -> Text {
    match service {
        Service::Other(sap) => both!("access point {sap}", "Zugangspunkt {sap}"),
        named => Text::name(named.name()),
    }
}

/// An access point of a slave, or one of a master (fieldbus facts).
pub(super) fn access_point(sap: u8, is_slave: bool) -> Text {
    let of_master = || MASTER.into_iter().find(|row| row.0 == sap).map(|row| row.1);
    let of_slave = || Service::ALL.iter().find(|service| service.sap() == Some(sap)).map(|service| service.name());
    match if is_slave { of_slave() } else { of_master() } {
        Some(name) => Text::name(format_args!("{sap} ({name})")),
        None => Text::name(sap),
    }
}

/// Access points of a master.
const MASTER: [(u8, &str); 4] = [(62, "MS0"), (54, "MM"), (51, "MS1"), (50, "MS2")];

/// What a bit of the diagnosis wants to say, by the name of the norm.
pub(super) fn flag(name: &str) -> Text {
    let told = match name {
        "Station_Non_Existent" => both!("said by a master: nobody answers", "vom Master gesetzt: niemand antwortet"),
        "Station_Not_Ready" => both!("not ready for data yet", "noch nicht bereit für Daten"),
        "Cfg_Fault" => both!("another configuration than its own", "andere Konfiguration als die eigene"),
        "Ext_Diag" => both!("something is wrong in the device", "im Gerät liegt etwas vor"),
        "Not_Supported" => both!("it cannot do what was asked", "es kann nicht, was verlangt war"),
        "Invalid_Slave_Response" => {
            both!("said by a master: no sense in the answer", "vom Master gesetzt: sinnlose Antwort")
        }
        "Prm_Fault" => both!("wrong parameters or ident number", "falsche Parameter oder Identnummer"),
        "Master_Lock" => both!("another master has it", "ein anderer Master hat es"),
        "Prm_Req" => both!("wants to be parameterised", "will parametriert werden"),
        "Stat_Diag" => both!("go on asking for the diagnosis", "Diagnose weiter abfragen"),
        "WD_On" => both!("its watchdog is on", "seine Ansprechüberwachung ist an"),
        "Freeze_Mode" => both!("inputs are held", "Eingänge sind eingefroren"),
        "Sync_Mode" => both!("outputs are held", "Ausgänge sind eingefroren"),
        "Deactivated" => both!("said by a master: taken out", "vom Master gesetzt: stillgelegt"),
        _ => both!("more than fits", "mehr, als hineinpasst"),
    };
    both!("{name} ({told})", "{name} ({told})", name, told)
}

/// What a master asks in a PKW block (manual 4.1.1).
pub(super) fn task(task: Task) -> Text {
    let told = match task {
        Task::None => both!("no request", "kein Auftrag"),
        Task::Read => both!("read", "lesen"),
        Task::WriteWord => both!("write, 16 bit", "schreiben, 16 Bit"),
        Task::WriteDouble => both!("write, 32 bit", "schreiben, 32 Bit"),
        Task::ReadDescription => both!("read the description", "Beschreibung lesen"),
        Task::WriteDescription => both!("write the description", "Beschreibung schreiben"),
        Task::ReadElement => both!("read an element", "Element lesen"),
        Task::WriteElementWord => both!("write an element, 16 bit", "Element schreiben, 16 Bit"),
        Task::WriteElementDouble => both!("write an element, 32 bit", "Element schreiben, 32 Bit"),
        Task::CountElements => both!("ask for the number of elements", "Anzahl der Elemente erfragen"),
        Task::Other(code) => both!("request {code}, of the maker", "Auftrag {code}, herstellerspezifisch"),
    };
    match task.is_unsupported() {
        true => both!("{told} (an SJ2-PB does not support it)", "{told} (ein SJ2-PB unterstützt das nicht)", told),
        false => told,
    }
}

/// What a slave answers in a PKW block (manual 4.1.1).
pub(super) fn answer(answer: Answer) -> Text {
    match answer {
        Answer::None => both!("no request", "kein Auftrag"),
        Answer::Word => both!("value, 16 bit", "Wert, 16 Bit"),
        Answer::Double => both!("value, 32 bit", "Wert, 32 Bit"),
        Answer::Description => both!("element of the description", "Element der Beschreibung"),
        Answer::ElementWord => both!("element, 16 bit", "Element, 16 Bit"),
        Answer::ElementDouble => both!("element, 32 bit", "Element, 32 Bit"),
        Answer::Count => both!("number of elements", "Anzahl der Elemente"),
        Answer::Refused => both!("refused", "abgelehnt"),
        Answer::NoRight => both!("no right to change it over PKW", "kein Recht zum Ändern über PKW"),
        Answer::Other(code) => both!("answer {code}, of the maker", "Antwort {code}, herstellerspezifisch"),
    }
}

/// Why the SJ2-PB refuses a request (manual 4.1.1); the names of those that only the profile has say so (facts F).
pub(super) fn refusal(number: u32) -> Text {
    match number {
        0 => both!("no such parameter", "Parameternummer unzulässig"),
        1 => both!("the value cannot be changed", "Wert nicht änderbar"),
        2 => both!("beyond its limits", "Grenze überschritten"),
        3 => both!("wrong sub-index", "falscher Subindex"),
        4 => both!("no array", "kein Feld"),
        5 => both!("wrong data type", "falscher Datentyp"),
        7 => both!("the description cannot be changed", "Beschreibung nicht änderbar"),
        9 => both!("no description", "keine Beschreibung vorhanden"),
        11 => both!("no right to change it (P.927)", "kein Recht zum Ändern (P.927)"),
        17 => both!("not in this operating state", "in diesem Betriebszustand nicht möglich"),
        22 => both!("address not permitted", "Adresse unzulässig"),
        24 => both!("the value is not consistent", "Wert nicht konsistent"),
        101 => both!("the module does not reach the inverter", "das Modul erreicht den Umrichter nicht"),
        _ => both!("in no source", "in keiner Quelle"),
    }
}

/// Causes of a trip, bits 13 to 8 of the Basic status word (manual 3.2.3).
pub(super) fn trip_cause(cause: u8) -> Text {
    match cause {
        0x00 => both!("overcurrent at constant speed", "Überstrom bei konstanter Drehzahl"),
        0x01 => both!("overcurrent during deceleration", "Überstrom beim Bremsen"),
        0x02 => both!("overcurrent during acceleration", "Überstrom beim Beschleunigen"),
        0x03 => both!("DC-link overvoltage", "Überspannung im Zwischenkreis"),
        0x04 => both!("undervoltage", "Unterspannung"),
        0x05 => both!("overload", "Überlast"),
        0x06 => both!("EEPROM error", "EEPROM-Fehler"),
        0x08 | 0x0E => both!("CPU error", "CPU-Fehler"),
        0x0A => both!("thermal fault", "Temperaturfehler"),
        0x0D => both!("earth fault", "Erdschluss"),
        0x0F => both!("mains overvoltage", "Netzüberspannung"),
        0x20 => both!("overload while braking", "Überlast während des Bremsens"),
        0x21 => both!("restart error (USP)", "Wiederanlauffehler (USP)"),
        0x22 => both!("PTC fault", "PTC-Störung"),
        0x25 => both!("external fault", "externe Störung"),
        0x28 => both!("CPU error (gate array)", "CPU-Fehler (Gate-Array)"),
        _ => both!("in no source", "in keiner Quelle"),
    }
}
