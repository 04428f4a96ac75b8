//! What a slave says no with, over PKW.

use crate::drive::decode::dp;
use crate::failure::{Class, Failure};
use crate::text::{Text, both};

/// Why a slave says no over PKW: the number stands in one half of this or the other; without one there is no right.
pub(in crate::drive) fn no(pwe: Option<u32>) -> Text {
    match pwe {
        None => both!("no right to do it over PKW", "über PKW kein Recht dazu"),
        Some(pwe) => {
            let (number, why) = dp::refused(pwe);
            both!("{number}: {why}", "{number}: {why}", number, why)
        }
    }
}

/// The same as the failure of a question that names its parameter.
pub(in crate::drive) fn refused(address: u8, pwe: Option<u32>) -> Failure {
    let why = no(pwe);
    let message = both!("station {address} refuses: {why}", "Station {address} lehnt ab: {why}", why);
    match pwe {
        Some(pwe) => Failure::new(Class::Refused, "refused.pkw", message).with("pwe", format!("{pwe:08X}")),
        None => Failure::new(Class::Refused, "refused.no_right", message).hint(locked()),
    }
}

pub(super) fn locked() -> Text {
    both!(
        "P.927 = 0 locks every other parameter: `antrieb --protocol dp write 927=1` opens them",
        "P.927 = 0 sperrt alle anderen Parameter: `antrieb --protocol dp write 927=1` öffnet sie"
    )
}
