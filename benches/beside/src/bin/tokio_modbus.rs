//! tokio-modbus as its documentation shows it: `tokio_modbus PORT BAUD TIMEOUT_MS [STATION REGISTER]` reads one register. Without the last
//! two each line on stdin names them. The answer is a value, or `-`.

use std::error::Error;
use std::io::{self, BufRead, Write};
use std::time::Duration;
use tokio_modbus::prelude::{Reader, Slave, SlaveContext};
use tokio_serial::{SerialPortBuilderExt, StopBits};

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [port, baud, timeout, once @ ..] = words.as_slice() else { return Err("PORT BAUD TIMEOUT_MS".into()) };
    let once = (!once.is_empty()).then(|| Ok(once.join(" ")));
    let typed = once.is_none().then(|| io::stdin().lock().lines()).into_iter().flatten();
    let patience = Duration::from_millis(timeout.parse()?);
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build()?;
    runtime.block_on(async {
        let line = tokio_serial::new(port, baud.parse()?).stop_bits(StopBits::Two).open_native_async()?;
        let mut master = tokio_modbus::client::rtu::attach(line);
        for question in once.into_iter().chain(typed) {
            let question = question?;
            let (station, register) = question.split_once(' ').ok_or("STATION REGISTER")?;
            master.set_slave(Slave(station.parse()?));
            let read = master.read_holding_registers(register.parse()?, 1);
            match tokio::time::timeout(patience, read).await {
                Ok(Ok(Ok(values))) => println!("{}", values[0]),
                _ => println!("-"),
            }
            io::stdout().flush()?;
        }
        Ok(())
    })
}
