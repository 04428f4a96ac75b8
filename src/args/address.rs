//! Which drives are meant: `1`, `1,2,5-9`, `3.17`.

use super::wrong::bad_setting;
use crate::failure::Failure;
use crate::profile::nearest;
use crate::protocol::modbus::LAST_STATION;
use crate::text::{Text, both};

/// Which drives are meant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Addresses {
    /// None was named.
    Unnamed,
    /// These, in this order.
    Named(Vec<u8>),
}

impl Addresses {
    /// Those that were named.
    pub fn named(&self) -> &[u8] {
        match self {
            Addresses::Unnamed => &[],
            Addresses::Named(list) => list,
        }
    }
}

/// Reads the node of `3.17`: drive 3, and node 17 of the system bus behind it (EM-RES-03 manual 5.10.2.2).
pub(super) fn parse_node(drive: &str, node: &str) -> Result<u8, Failure> {
    let number = node.trim().parse().ok().filter(|node| (1..=LAST_NODE).contains(node));
    let one = drive.trim().parse::<u8>().is_ok();
    number.filter(|_| one).ok_or_else(|| {
        bad_setting("address", both!(
            "expected one drive and a node 1 to {LAST_NODE} behind it, such as 3.17; got '{drive}.{node}'",
            "erwartet: ein Antrieb und ein Knoten 1 bis {LAST_NODE} dahinter, etwa 3.17; angegeben: '{drive}.{node}'"
        ))
    })
}

/// Reads `3`, `3.17`: the address of one drive on a serial line, and the node behind it, 0 if it is the drive itself.
pub fn parse_place(text: &str) -> Option<(u8, u8)> {
    let (drive, node) = text.split_once('.').map_or((text, None), |(drive, node)| (drive, Some(node)));
    let address = drive.parse().ok().filter(|address| (1..=LAST_STATION).contains(address))?;
    Some((address, node.map_or(Some(0), |node| parse_node(drive, node).ok())?))
}

/// Highest node of the system bus (EM-RES-03 manual 5.10.2.2).
const LAST_NODE: u8 = 63;

/// Reads `1`, `1,2,5-9`; `names` are those that could stand there too.
pub fn parse_addresses(text: &str, names: &[&str]) -> Result<Vec<u8>, Failure> {
    let mut list = Vec::new();
    for part in text.split(',').map(str::trim) {
        let (first, last) = part.split_once('-').unwrap_or((part, part));
        let first: u32 = first.trim().parse().map_err(|_| not_one(text, names))?;
        let last: u32 = last.trim().parse().map_err(|_| not_one(text, names))?;
        check_address(first, text)?;
        check_address(last, text)?;
        if first > last {
            return Err(not_one(text, names));
        }
        for address in first..=last {
            let address = u8::try_from(address).map_err(|_| not_one(text, names))?;
            if !list.contains(&address) {
                list.push(address);
            }
        }
    }
    Ok(list)
}

/// The failure of what is no list of addresses, and no name either.
fn not_one(text: &str, names: &[&str]) -> Failure {
    let known = match names.is_empty() {
        true => Text::default(),
        false => both!(", or one of: {names}", ", oder einer von: {names}", names = names.join(", ")),
    };
    let failure = bad_setting(
        "address",
        both!(
            "expected addresses such as 1 or 1,2,5-9{known}; got '{text}'",
            "erwartet: Adressen wie 1 oder 1,2,5-9{known}; angegeben: '{text}'",
            known
        ),
    );
    match nearest(names, text).as_slice() {
        [] if names.is_empty() && text.starts_with(char::is_alphabetic) => failure.hint(both!(
            "names of drives come from an antrieb.toml, and none is known here",
            "Namen von Antrieben kommen aus einer antrieb.toml, und hier ist keiner bekannt"
        )),
        [] => failure,
        near => {
            failure.hint(both!("did you mean '{near}'?", "gemeint ist vielleicht '{near}'", near = near.join("', '")))
        }
    }
}

fn check_address(address: u32, text: &str) -> Result<(), Failure> {
    if address > LAST_STATION.into() {
        return Err(bad_setting(
            "address",
            both!(
                "expected 0 to {LAST_STATION}, got {address} in '{text}'",
                "erwartet: 0 bis {LAST_STATION}; angegeben: {address} in '{text}'"
            ),
        ));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(text: &str) -> Result<Vec<u8>, String> {
        parse_addresses(text, &[]).map_err(|failure| failure.to_string())
    }

    #[test]
    fn a_name_that_is_nearly_one_is_told() {
        let hint = |text| parse_addresses(text, &["fan", "pump"]).unwrap_err().hint.map(|hint| hint.en.clone());
        assert_eq!(hint("fann").as_deref(), Some("did you mean 'fan'?"));
        assert_eq!(hint("pmp").as_deref(), Some("did you mean 'pump'?"));
        assert_eq!((hint("belt"), hint("5-2")), (None, None));
    }

    #[test]
    fn address_lists() {
        assert_eq!(parsed("1"), Ok(vec![1]));
        assert_eq!(parsed("1,2, 5-7,2"), Ok(vec![1, 2, 5, 6, 7]));
        for text in ["", "248", "5-2", "a", "1,,2", "-1"] {
            assert!(parsed(text).is_err(), "{text}");
        }
    }
}
