//! Everything that makes an LXM05 before it is switched on.

use super::axis::USR_PER_TURN;
use super::motion::World;
use super::readings::Readings;

/// What a bench file says of an LXM05.
#[derive(Clone, Debug)]
pub(crate) struct Setup {
    pub(crate) world: World,
    pub(crate) identity: Identity,
    /// What it makes of questions that the manual leaves open.
    pub(crate) readings: Readings,
    /// Address and raw value.
    pub(crate) values: Vec<(u32, i64)>,
}

/// What code 43 tells.
#[derive(Clone, Debug)]
pub(crate) struct Identity {
    pub(crate) vendor: String,
    pub(crate) product: String,
    pub(crate) revision: String,
    /// Number of the object with the revision: 3 by the manual, 2 by the norm.
    pub(crate) revision_object: u8,
    /// One object in a telegram, and "more follows".
    pub(crate) in_pieces: bool,
}

impl Default for Setup {
    /// Limit switches 5 turns away that only homing looks for, no guide signal, and texts that are plainly the bench's:
    /// the manual prints only the shape of the revision.
    fn default() -> Self {
        let turns = 5 * USR_PER_TURN;
        let world = World {
            limn: -turns,
            limp: turns,
            limits: false,
            guide: 0,
            analog: 0,
            waver: 0,
            bit6_absolute: false,
            dragged: false,
        };
        let identity = Identity {
            vendor: "antrieb bench".to_owned(),
            product: "LXM05-SIM".to_owned(),
            revision: "V02.001".to_owned(),
            revision_object: 3,
            in_pieces: false,
        };
        Setup { world, identity, readings: Readings::default(), values: Vec::new() }
    }
}
