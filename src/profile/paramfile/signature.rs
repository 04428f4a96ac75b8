//! A number over family and values: two files with the same one hold the same settings.
//!
//! It is FNV-1a with 64 bits (Fowler, Noll, Vo; offset basis and prime as in draft-eastlake-fnv) over the UTF-8 text that is
//! made of the family and a line for each value, in the order of numbers and data sets: `acu`, `372@0=1450`, `480@1=500`, each
//! ended by a line feed; values are raw integers. Four data sets with one value are data set 0. So neither order nor comments nor
//! the way in which something is written change it. It tells accidents, not attacks.

use std::fmt;
use std::str::FromStr;

const BASIS: u64 = 0xCBF2_9CE4_8422_2325;
const PRIME: u64 = 0x0000_0100_0000_01B3;

/// The signature of a family's settings; written as 16 hexadecimal digits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Signature(u64);

impl Signature {
    /// Over the family and its values: number, data set, raw value; in the order of numbers and data sets.
    pub(super) fn over(family: &str, values: impl IntoIterator<Item = (u32, u8, i64)>) -> Self {
        let mut hash = absorb(BASIS, &format!("{family}\n"));
        for (param, set, raw) in values {
            hash = absorb(hash, &format!("{param}@{set}={raw}\n"));
        }
        Signature(hash)
    }
}

fn absorb(hash: u64, text: &str) -> u64 {
    text.bytes().fold(hash, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(PRIME))
}

impl fmt::Display for Signature {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:016x}", self.0)
    }
}

impl FromStr for Signature {
    type Err = ();
    fn from_str(text: &str) -> Result<Self, ()> {
        let is_hex = text.len() == 16 && text.bytes().all(|byte| byte.is_ascii_hexdigit());
        let number = is_hex.then(|| u64::from_str_radix(text, 16).ok()).flatten();
        number.map(Signature).ok_or(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hash_is_fnv_1a() {
        // draft-eastlake-fnv, test vectors.
        for (text, hash) in
            [("", 0xCBF2_9CE4_8422_2325), ("a", 0xAF63_DC4C_8601_EC8C), ("foobar", 0x8594_4171_F739_67E8)]
        {
            assert_eq!(absorb(BASIS, text), hash, "{text}");
        }
    }

    #[test]
    fn a_signature_is_read_as_it_is_written() {
        let signature = Signature::over("acu", [(372, 0, 1450), (480, 1, -500)]);
        assert_eq!(signature.to_string().parse(), Ok(signature));
        assert_ne!(signature, Signature::over("act", [(372, 0, 1450), (480, 1, -500)]));
        assert_ne!(signature, Signature::over("acu", [(372, 0, 1450), (480, 2, -500)]));
        for text in ["", "123", "00000000000000000", "+000000000000000", "000000000000000g"] {
            assert_eq!(text.parse::<Signature>(), Err(()), "{text}");
        }
    }
}
