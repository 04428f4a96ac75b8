//! A slave on its way to Data_Exchange: what ends the way, what is said again, and what only tells.

use super::*;
use crate::protocol::dp::control;

/// Bits of the second byte that are always 1.
const FIXED: u8 = 1 << 2;
const SETUP: Setup = Setup { watchdog: [10, 1], user: Vec::new(), cfg: Vec::new(), ident: None };

/// A slave that is led with two bytes of outputs, told of faults of before, and its parameters and configuration are on their way.
fn told() -> Station {
    let mut station = Station::new(3, SETUP, vec![0; 2], Tick::ZERO);
    // What it says of itself before it was told anything is no fault of this run.
    let found = diagnosed(&mut station, Tick::ZERO, [PRM_FAULT | CFG_FAULT | NOT_READY, FIXED | PRM_REQ, 0]);
    assert_eq!(found, Ok(Cycle::Prepared));
    for service in [Service::SetPrm, Service::ChkCfg] {
        assert_eq!(asks(&mut station), service);
        assert_eq!(station.answered(Tick::ZERO, Ok(Reply::Ack)), Ok(Cycle::Prepared));
    }
    station
}

fn asks(station: &mut Station) -> Service {
    station.question().1.asks()
}

fn frame(status: Status, data: Vec<u8>) -> Reply {
    Reply::Frame { station: control::Station::Slave, status, data }
}

/// It is asked for its diagnosis, and this is the status that it answers.
fn diagnosed(station: &mut Station, now: Tick, status: [u8; 3]) -> Result<Cycle, Trouble> {
    assert_eq!(asks(station), Service::SlaveDiag);
    let found = Diagnosis { status, master: diagnosis::NOBODY, ident: 0x1234, blocks: Vec::new() };
    station.answered(now, Ok(frame(Status::DataLow, found.encode())))
}

#[test]
fn what_a_slave_complains_of_behind_its_parameters_ends_the_way() {
    let now = Tick::ZERO + READY;
    for (status, expected) in [
        ([PRM_FAULT, FIXED, 0], Err(Trouble::Parameters)),
        ([CFG_FAULT, FIXED, 0], Err(Trouble::Configuration)),
        ([0, FIXED, 0], Ok(Cycle::Prepared)),
    ] {
        assert_eq!(diagnosed(&mut told(), now, status), expected, "{status:02X?}");
    }
}

/// What is no acknowledgement says that it is not ready for its parameters: its diagnosis tells more than its configuration would.
#[test]
fn parameters_that_are_not_acknowledged_are_looked_into() {
    for (reply, next) in [(Reply::Ack, Service::ChkCfg), (frame(Status::NoResource, Vec::new()), Service::SlaveDiag)] {
        let mut station = Station::new(3, SETUP, vec![0; 2], Tick::ZERO);
        assert_eq!(diagnosed(&mut station, Tick::ZERO, [0, FIXED | PRM_REQ, 0]), Ok(Cycle::Prepared));
        assert_eq!(asks(&mut station), Service::SetPrm);
        assert!(!station.is_leaving(), "it is on its way");
        assert_eq!(station.answered(Tick::ZERO, Ok(reply.clone())), Ok(Cycle::Prepared));
        assert_eq!(asks(&mut station), next, "{reply:?}");
    }
}

#[test]
fn a_slave_that_is_ready_exchanges_data() {
    let mut station = told();
    assert_eq!(diagnosed(&mut station, Tick::ZERO, [0, FIXED, 0]), Ok(Cycle::Prepared));
    assert_eq!(asks(&mut station), Service::DataExchange);
}

#[test]
fn a_slave_that_is_not_ready_is_asked_again_for_ten_seconds_and_no_longer() {
    let mut station = told();
    let last = Tick::ZERO + READY;
    for now in [Tick::ZERO, last] {
        assert_eq!(diagnosed(&mut station, now, [NOT_READY, FIXED, 0]), Ok(Cycle::Prepared));
        assert_eq!(station.waits(), now + AGAIN, "it is left in peace for a moment");
        assert_eq!(asks(&mut station), Service::SlaveDiag);
    }
    let now = last + Span::from_micros(1);
    assert_eq!(diagnosed(&mut station, now, [NOT_READY, FIXED, 0]), Err(Trouble::NotReady));
}

#[test]
fn a_slave_that_asks_for_its_parameters_gets_them_again_a_moment_later() {
    let mut station = told();
    let now = Tick::ZERO + Span::from_secs(1);
    assert_eq!(diagnosed(&mut station, now, [NOT_READY, FIXED | PRM_REQ, 0]), Ok(Cycle::Prepared));
    assert_eq!((asks(&mut station), station.waits()), (Service::SetPrm, now + AGAIN));
}

/// Behind inputs of high priority the diagnosis is read once, and only tells: faults in it do not end the exchange.
#[test]
fn a_diagnosis_beside_the_exchange_only_tells() {
    let mut station = told();
    assert_eq!(diagnosed(&mut station, Tick::ZERO, [0, FIXED, 0]), Ok(Cycle::Prepared));
    let inputs = vec![0xAB, 0xCD];
    let cycle = station.answered(Tick::ZERO, Ok(frame(Status::DataHigh, inputs.clone())));
    assert_eq!(cycle, Ok(Cycle::Inputs(inputs)));
    let late = Tick::ZERO + READY.times(2);
    assert_eq!(diagnosed(&mut station, late, [PRM_FAULT | CFG_FAULT, FIXED | PRM_REQ, 0]), Ok(Cycle::Prepared));
    assert_eq!(asks(&mut station), Service::DataExchange);
}

/// No service: it has left the exchange, and has all its time again for the way back. Data that say so are no inputs.
#[test]
fn a_slave_that_leaves_the_exchange_is_led_there_anew() {
    let mut station = told();
    assert_eq!(diagnosed(&mut station, Tick::ZERO, [0, FIXED, 0]), Ok(Cycle::Prepared));
    let now = Tick::ZERO + READY.times(3);
    assert_eq!(station.answered(now, Ok(frame(Status::NoService, vec![0; 2]))), Ok(Cycle::Left));
    assert_eq!(diagnosed(&mut station, now, [NOT_READY, FIXED | PRM_REQ, 0]), Ok(Cycle::Prepared));
    for service in [Service::SetPrm, Service::ChkCfg] {
        assert_eq!(asks(&mut station), service);
        assert_eq!(station.answered(now, Ok(Reply::Ack)), Ok(Cycle::Prepared));
    }
    assert_eq!(diagnosed(&mut station, now + READY, [NOT_READY, FIXED, 0]), Ok(Cycle::Prepared));
}

#[test]
fn inputs_that_are_more_or_less_than_the_outputs_are_no_inputs() {
    for data in [vec![0; 1], vec![0; 3]] {
        let mut station = told();
        assert_eq!(diagnosed(&mut station, Tick::ZERO, [0, FIXED, 0]), Ok(Cycle::Prepared));
        let cycle = station.answered(Tick::ZERO, Ok(frame(Status::DataLow, data)));
        assert_eq!(cycle, Err(Trouble::Strange(Service::DataExchange)));
    }
}

/// Who has told Set_Prm may have been heard, whatever came of it; whom another master has is not ours any more.
#[test]
fn a_slave_is_ours_from_set_prm_until_it_is_let_go_or_taken() {
    let mut station = Station::new(3, SETUP, vec![0; 2], Tick::ZERO);
    assert_eq!((station.is_owned(), station.ident()), (false, None));
    assert_eq!(diagnosed(&mut station, Tick::ZERO, [0, FIXED, 0]), Ok(Cycle::Prepared));
    assert_eq!((station.is_owned(), station.ident()), (false, Some(0x1234)));
    assert_eq!(asks(&mut station), Service::SetPrm);
    assert!(station.is_owned());
    station.release(true);
    assert!(station.is_leaving());
    for service in [Service::GlobalControl, Service::SetPrm] {
        assert!(station.is_owned(), "{service:?}");
        assert_eq!(asks(&mut station), service);
        station.answered(Tick::ZERO, Ok(Reply::Sent)).unwrap();
    }
    assert!(!station.is_owned());

    let mut station = told();
    assert_eq!(asks(&mut station), Service::SlaveDiag);
    let found = Diagnosis { status: [0, FIXED, 0], master: 5, ident: 0x1234, blocks: Vec::new() };
    let said = station.answered(Tick::ZERO, Ok(frame(Status::DataLow, found.encode())));
    assert_eq!((said, station.is_owned()), (Err(Trouble::Locked(5)), false));
}
