//! (placeholder until stage 2 lands)
use crate::simulator::Bench;
use crate::tick::Span;
use std::future::Future;
use std::net::SocketAddr;
use std::path::PathBuf;
/// x
#[derive(Debug)]
pub enum Place {
    /// x
    Pty {
        /// x
        link: Option<PathBuf>,
    },
    /// x
    Tcp {
        /// x
        addr: SocketAddr,
    },
}
/// x
#[derive(Debug, PartialEq, Eq)]
pub enum Note {
    /// x
    Connected,
    /// x
    Left,
}
/// x
#[derive(Debug)]
pub struct Server;
impl Server {
    /// x
    pub fn open(_p: Place) -> Result<Server, String> {
        Err("later".into())
    }
    /// x
    pub fn name(&self) -> String {
        String::new()
    }
    /// x
    pub async fn pause(_s: Span) {}
    /// x
    pub async fn run(
        &mut self,
        _b: &mut Bench,
        _stop: impl Future<Output = ()>,
        _n: impl FnMut(Note),
    ) -> Result<(), String> {
        Ok(())
    }
}
