//! The bit rate that a CAN interface was set to, as the kernel tells it over netlink (linux/rtnetlink.h, linux/if_link.h,
//! linux/can/netlink.h). A virtual interface has none, and one whose adapter was set by somebody else tells none.

use rustix::net::{AddressFamily, RecvFlags, SendFlags, SocketFlags, SocketType, recv, send, socket_with};

/// Kinds of messages: who asks for an interface, and what tells of one.
const GET_LINK: u16 = 18;
const NEW_LINK: u16 = 16;
const REQUEST: u16 = 1;
/// Attributes of an interface: its name; what it is, and of that what its kind tells; of CAN the bit timing.
const NAME: u16 = 3;
const LINK_INFO: u16 = 18;
const INFO_DATA: u16 = 2;
const BIT_TIMING: u16 = 1;
/// Flags in the kind of an attribute.
const KIND: u16 = 0x3FFF;
/// Bytes of a message's head, and of what describes an interface before its attributes.
const HEAD: usize = 16;
const INTERFACE: usize = 16;
/// Bytes of an attribute's head; each begins at a multiple of it.
const ATTRIBUTE: usize = 4;
/// More than the kernel tells of an interface.
const MOST: usize = 32_768;
/// What stands there where nobody has set a rate (CAN_BITRATE_UNKNOWN).
const UNKNOWN: u32 = u32::MAX;

/// Bits per second of an interface; `None` where the kernel tells none.
pub(super) fn bit_rate(interface: &str) -> Option<u32> {
    let socket = socket_with(AddressFamily::NETLINK, SocketType::RAW, SocketFlags::CLOEXEC, None).ok()?;
    send(&socket, &question(interface), SendFlags::empty()).ok()?;
    let mut told = vec![0; MOST];
    // The kernel has answered before a question is sent.
    let (count, _) = recv(&socket, told.as_mut_slice(), RecvFlags::DONTWAIT).ok()?;
    answer(told.get(..count)?)
}

/// What the kernel is asked.
fn question(interface: &str) -> Vec<u8> {
    let name: Vec<u8> = interface.bytes().chain([0]).collect();
    let attribute = ATTRIBUTE + name.len();
    let length = HEAD + INTERFACE + attribute.next_multiple_of(ATTRIBUTE);
    let mut asked = Vec::with_capacity(length);
    asked.extend((length as u32).to_ne_bytes());
    asked.extend(GET_LINK.to_ne_bytes());
    asked.extend(REQUEST.to_ne_bytes());
    // Number and sender of the message, and which interface: by its name.
    asked.extend([0; 8 + INTERFACE]);
    asked.extend((attribute as u16).to_ne_bytes());
    asked.extend(NAME.to_ne_bytes());
    asked.extend(name);
    asked.resize(length, 0);
    asked
}

/// The rate in what it answers.
fn answer(told: &[u8]) -> Option<u32> {
    let kind = u16::from_ne_bytes(*told.get(4..)?.first_chunk()?);
    if kind != NEW_LINK {
        return None;
    }
    let info = attribute(told.get(HEAD + INTERFACE..)?, LINK_INFO)?;
    let timing = attribute(attribute(info, INFO_DATA)?, BIT_TIMING)?;
    let rate = u32::from_ne_bytes(*timing.first_chunk()?);
    (rate != 0 && rate != UNKNOWN).then_some(rate)
}

/// What stands in an attribute of a kind.
fn attribute(mut told: &[u8], kind: u16) -> Option<&[u8]> {
    loop {
        let ([a, b, c, d], _) = told.split_first_chunk()?;
        let length = usize::from(u16::from_ne_bytes([*a, *b]));
        let whole = told.get(..length).filter(|whole| whole.len() >= ATTRIBUTE)?;
        if u16::from_ne_bytes([*c, *d]) & KIND == kind {
            return whole.get(ATTRIBUTE..);
        }
        told = told.get(length.next_multiple_of(ATTRIBUTE)..)?;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An attribute with what stands in it.
    fn put(kind: u16, what: &[u8]) -> Vec<u8> {
        let mut bytes = (((ATTRIBUTE + what.len()) as u16).to_ne_bytes()).to_vec();
        bytes.extend(kind.to_ne_bytes());
        bytes.extend(what);
        bytes.resize(bytes.len().next_multiple_of(ATTRIBUTE), 0);
        bytes
    }

    /// An interface as the kernel tells of it.
    fn told(data: &[u8]) -> Vec<u8> {
        let info = [put(1, b"can\0"), put(INFO_DATA | 1 << 15, data)].concat();
        let mut bytes = vec![0; HEAD + INTERFACE];
        bytes[4..6].copy_from_slice(&NEW_LINK.to_ne_bytes());
        bytes.extend([put(NAME, b"can0\0"), put(LINK_INFO, &info)].concat());
        bytes
    }

    #[test]
    fn the_rate_stands_where_the_kernel_puts_it() {
        let timing = [500_000_u32.to_ne_bytes().as_slice(), &[0; 28]].concat();
        let data = [put(2, &[7; 48]), put(BIT_TIMING, &timing)].concat();
        assert_eq!(answer(&told(&data)), Some(500_000));
        for unset in [0, UNKNOWN] {
            assert_eq!(answer(&told(&put(BIT_TIMING, &unset.to_ne_bytes()))), None);
        }
        assert_eq!(answer(&told(&[])), None);
        assert_eq!(answer(&[]), None);
        // Cut anywhere, it tells nothing or the same.
        let whole = told(&data);
        assert!((0..whole.len()).all(|end| answer(&whole[..end]).is_none_or(|rate| rate == 500_000)));
    }

    #[test]
    fn an_interface_that_is_none_of_can_has_no_rate() {
        assert_eq!(bit_rate("lo"), None);
        assert_eq!(bit_rate("no such interface"), None);
    }
}
