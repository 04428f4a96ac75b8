//! What is heard on a bus: who asks there, whether there is a master, and which nodes show themselves.

use crate::protocol::can::emergency::Emergency;
use crate::protocol::can::{Frame, Identifier, SdoChannel, Service, station};
use std::collections::{BTreeMap, BTreeSet};

/// What was heard. That nobody was proves nothing: a drive that is the master may be silent for 50 s (EM-RES-03 manual 5.8.1).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Traffic {
    /// Frames.
    pub frames: u64,
    /// Somebody commands the network, or beats its time.
    pub has_master: bool,
    /// Stations of nodes, and what of them was heard.
    pub nodes: BTreeMap<u8, BTreeSet<Sign>>,
    /// What nodes told of faults, the first that were heard, with their stations.
    pub emergencies: Vec<(u8, Emergency)>,
    asks: [bool; 2],
}

/// Emergencies that are kept.
const MOST: usize = 64;

/// What was heard of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Sign {
    /// Its boot-up, or a heartbeat.
    BootUp,
    /// An emergency.
    Emergency,
    /// An answer over SDO.
    Answer,
    /// A PDO under one of its identifiers of the predefined connection set, which anybody may have been given.
    Pdo,
}

impl Traffic {
    /// A frame was heard.
    pub fn hears(&mut self, frame: &Frame) {
        self.frames += 1;
        let Identifier::Standard(identifier) = frame.identifier else { return };
        match Service::of(identifier) {
            Service::Nmt | Service::Sync => self.has_master = true,
            Service::SdoRequest(SdoChannel::One, _) => self.asks[0] = true,
            Service::SdoRequest(SdoChannel::Two, _) => self.asks[1] = true,
            Service::BootUp(node) => self.shows(node, Sign::BootUp),
            Service::Emergency(node) => {
                self.shows(node, Sign::Emergency);
                let told = Emergency::decode(frame.bytes()).filter(|_| self.emergencies.len() < MOST);
                self.emergencies.extend(told.map(|told| (station(node), told)));
            }
            Service::SdoReply(_, node) => self.shows(node, Sign::Answer),
            Service::TxPdo(_, node) => self.shows(node, Sign::Pdo),
            _ => {}
        }
    }

    fn shows(&mut self, node: u8, sign: Sign) {
        self.nodes.entry(station(node)).or_default().insert(sign);
    }

    /// Whether somebody asks nodes for parameters over a channel.
    pub fn asks(&self, channel: SdoChannel) -> bool {
        let [one, two] = self.asks;
        match channel {
            SdoChannel::One => one,
            SdoChannel::Two => two,
        }
    }
}
