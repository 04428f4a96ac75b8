//! ACTIVE: ACT and ACU of Bonfiglioli Vectron, asked over Modbus, VABus and SDO (CM-485 and EM-RES-03 manuals).
//!
//! From the ground up: `store` and `spec` (parameters), `machine` (state machine), `state` (all that a drive holds),
//! `links` (what came over the system bus), `linked` and `values` (what it makes of that), `life` (time and power), `access` (reading and writing), `modbus`, `vabus` and `sdo` (what
//! it answers), `line` (where it stands on its line), `drive` (all of it behind the contract).

mod access;
pub(crate) mod analog;
mod cause;
mod drive;
mod life;
pub(crate) mod line;
mod linked;
mod links;
mod machine;
mod modbus;
pub(crate) mod readings;
pub(crate) mod resolver;
mod sdo;
pub(crate) mod setup;
mod spec;
mod state;
pub(crate) mod store;
mod vabus;
mod values;

pub(crate) use drive::Drive;
pub(crate) use state::Active;
pub(crate) use vabus::Node;
