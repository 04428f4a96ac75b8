//! profirust as its examples show it, with one SJ2-PB (PPO1): `profirust PORT BAUD ADDRESS IDENT SECONDS`. Prints the cycles of data exchange
//! a second. The pauses between two polls are those that its documentation recommends for adapters, or with SPIN set the shortest.
//! Its own access to a serial port wants the low latency of a UART, which a pseudo terminal refuses; so it gets a port of ours.

use profirust::{Baudrate, dp, fdl, phy, time};
use serialport::{Parity, SerialPort, TTYPort};
use std::error::Error;
use std::io::{Read, Write};
use std::time::{Duration, Instant};

const MASTER: u8 = 2;
/// It gives up where no exchange begins.
const PATIENCE: Duration = Duration::from_secs(20);
/// OFF1 behind an empty parameter channel: the motor stays off.
const OUTPUTS: [u8; 12] = [0, 0, 0, 0, 0, 0, 0, 0, 0x04, 0x7E, 0, 0];

struct Line {
    port: TTYPort,
    received: Vec<u8>,
}

impl phy::ProfibusPhy for Line {
    fn poll_transmission(&mut self, _: time::Instant) -> bool {
        self.port.bytes_to_write().is_ok_and(|left| left > 0)
    }

    fn transmit_data<F, R>(&mut self, _: time::Instant, f: F) -> R
    where
        F: FnOnce(&mut [u8]) -> (usize, R),
    {
        let mut telegram = [0; 256];
        let (length, result) = f(&mut telegram);
        self.port.write_all(&telegram[..length]).expect("the line takes what is sent");
        result
    }

    fn receive_data<F, R>(&mut self, _: time::Instant, f: F) -> R
    where
        F: FnOnce(&[u8]) -> (usize, R),
    {
        let came = self.port.bytes_to_read().expect("the line is there") as usize;
        let held = self.received.len();
        self.received.resize(held + came, 0);
        self.port.read_exact(&mut self.received[held..]).expect("what has come can be read");
        let (taken, result) = f(&self.received);
        self.received.drain(..taken);
        result
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [port, baud, address, ident, seconds] = words.as_slice() else {
        return Err("PORT BAUD ADDRESS IDENT SECONDS".into());
    };
    // Its table: the pause between two polls, and the slot time in bits.
    let (baud, pause, slot) = match baud.as_str() {
        "9600" => (Baudrate::B9600, 10_000, 576),
        "19200" => (Baudrate::B19200, 10_000, 576),
        "93750" => (Baudrate::B93750, 3_500, 750),
        "187500" => (Baudrate::B187500, 3_500, 1_500),
        "500000" => (Baudrate::B500000, 3_500, 4_000),
        _ => return Err("a speed that its documentation has no pause for".into()),
    };
    let pause = Duration::from_micros(if std::env::var_os("SPIN").is_some() { 50 } else { pause });
    let options = dp::PeripheralOptions {
        ident_number: u16::from_str_radix(ident.trim_start_matches("0x"), 16)?,
        user_parameters: Some(&[]),
        config: Some(&[0xF3, 0xF1]),
        max_tsdr: 60,
        ..Default::default()
    };
    let (mut inputs, mut outputs) = ([0; 12], OUTPUTS);
    let slave = dp::Peripheral::new(address.parse()?, options, &mut inputs[..], &mut outputs[..]);
    let mut master = dp::DpMaster::new(vec![]);
    let slave = master.add(slave);
    let parameters = fdl::ParametersBuilder::new(MASTER, baud)
        .slot_bits(slot)
        .max_retry_limit(3)
        .watchdog_timeout(time::Duration::from_secs(1))
        .build_verified(&master);
    let mut station = fdl::FdlActiveStation::new(parameters);
    let speed = u32::try_from(station.parameters().baudrate.to_rate())?;
    let port = serialport::new(port, speed).parity(Parity::Even).open_native()?;
    let mut line = Line { port, received: Vec::new() };
    station.set_online();
    master.enter_operate();

    let begun = Instant::now();
    let lasts: u64 = seconds.parse()?;
    let (mut running, mut cycles) = (None, 0_u64);
    loop {
        station.poll(time::Instant::now(), &mut line, &mut master);
        let events = master.take_last_events();
        if master.get_mut(slave).is_running() && events.cycle_completed {
            running.get_or_insert_with(Instant::now);
            cycles += 1;
        }
        match running {
            None if begun.elapsed() > PATIENCE => return Err("no exchange of data".into()),
            Some(since) if since.elapsed() >= Duration::from_secs(lasts) => {
                println!("{:.1}", (cycles - 1) as f64 / since.elapsed().as_secs_f64());
                return Ok(());
            }
            _ => std::thread::sleep(pause),
        }
    }
}
