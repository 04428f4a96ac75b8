//! A raw TCP port with one client at a time.

use super::{CHUNK, Change, ServeError};
use crate::simulator::Parting;
use std::io;
use std::net::SocketAddr;
use tokio::net::{TcpListener, TcpStream};

#[derive(Debug)]
pub(super) struct Tcp {
    listener: std::net::TcpListener,
    pub(super) addr: SocketAddr,
    /// The listener as the runtime knows it.
    accepting: Option<TcpListener>,
    client: Option<TcpStream>,
}

impl Tcp {
    pub(super) fn open(addr: SocketAddr) -> Result<Self, ServeError> {
        let failed = |why| ServeError::Tcp { addr, why };
        let listener = std::net::TcpListener::bind(addr).map_err(failed)?;
        listener.set_nonblocking(true).map_err(failed)?;
        let addr = listener.local_addr().map_err(failed)?;
        Ok(Tcp { listener, addr, accepting: None, client: None })
    }

    /// Hands bytes to the client, if there is one.
    pub(super) fn write(&self, bytes: &[u8]) {
        if let Some(client) = &self.client {
            // A lost connection shows when it is read.
            let _ = client.try_write(bytes);
        }
    }

    /// Ends the connection; whether there was one. The next client may come at once.
    pub(super) fn hang_up(&mut self, parting: Parting) -> bool {
        let Some(client) = self.client.take() else { return false };
        if parting == Parting::Reset {
            // If that cannot be set it ends in order.
            let _ = client.set_zero_linger();
        }
        true
    }

    pub(super) async fn change(&mut self) -> io::Result<Change> {
        let Some(client) = &self.client else {
            if self.accepting.is_none() {
                self.accepting = Some(TcpListener::from_std(self.listener.try_clone()?)?);
            }
            let Some(accepting) = &self.accepting else { return Err(io::ErrorKind::NotConnected.into()) };
            let (client, _) = accepting.accept().await?;
            // Every byte has its time: nothing may wait for the next.
            client.set_nodelay(true)?;
            self.client = Some(client);
            return Ok(Change::Connected);
        };
        let mut buffer = vec![0; CHUNK];
        loop {
            client.readable().await?;
            match client.try_read(&mut buffer) {
                Err(error) if error.kind() == io::ErrorKind::WouldBlock => {}
                Ok(count @ 1..) => {
                    buffer.truncate(count);
                    return Ok(Change::Bytes(buffer));
                }
                Ok(0) | Err(_) => {
                    self.client = None;
                    return Ok(Change::Left);
                }
            }
        }
    }
}
