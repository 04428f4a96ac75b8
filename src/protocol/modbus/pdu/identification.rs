//! The reply to "read device identification": a list of objects, and where it ends.
//!
//! MODBUS Application Protocol V1.1b3, 6.21; LXM05 manual 5.2.5.

use super::{ENCAPSULATED, IDENTIFICATION, PduError};

/// Object 0: name of the vendor.
pub const VENDOR_NAME: u8 = 0;
/// Object 1: product code.
pub const PRODUCT_CODE: u8 = 1;
/// Object 2: revision, by the norm (V1.1b3, 6.21).
pub const REVISION: u8 = 2;
/// Object 3: revision, as the LXM05 manual prints it (5.2.5); in the norm it is the address of the vendor.
pub const REVISION_LEXIUM: u8 = 3;

/// Category 1: the basic objects 0 to 2, as a stream.
pub const BASIC: u8 = 1;
/// Category 4: one object.
pub const SINGLE: u8 = 4;

/// Bytes before the objects: function code, MEI type, category, conformity, more follows, next object, count.
const HEAD: usize = 7;
/// "More follows".
const MORE: u8 = 0xFF;

/// What a slave tells of itself in one telegram.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Identification {
    /// Category, echoed: 1 basic, 2 regular, 3 extended, 4 one object.
    pub category: u8,
    /// Conformity level; bit 7: single objects can be read.
    pub conformity: u8,
    /// Object with which to go on, if not all fitted into this telegram.
    pub next: Option<u8>,
    /// Objects in the order of the telegram, at most 255.
    pub objects: Vec<Object>,
}

/// One object of an [`Identification`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Object {
    /// Number of the object.
    pub id: u8,
    /// Its text, at most 255 bytes, as they came: ASCII by the norm.
    pub value: Vec<u8>,
}

impl Identification {
    /// The object with this number.
    pub fn object(&self, id: u8) -> Option<&[u8]> {
        self.objects.iter().find(|object| object.id == id).map(|object| object.value.as_slice())
    }

    /// Everything behind the function code.
    pub(super) fn encode(&self) -> Vec<u8> {
        let count = |length: usize| u8::try_from(length).unwrap_or(u8::MAX);
        let (more, next) = self.next.map_or((0, 0), |next| (MORE, next));
        let mut data = vec![IDENTIFICATION, self.category, self.conformity, more, next, count(self.objects.len())];
        for object in &self.objects {
            data.extend([object.id, count(object.value.len())]);
            data.extend(&object.value);
        }
        data
    }

    /// Reads everything behind the function code.
    pub(super) fn decode(data: &[u8]) -> Result<Self, PduError> {
        let length = |expected| PduError::Length { function: ENCAPSULATED, len: data.len(), expected };
        let &[_, category, conformity, more, next, count, ref rest @ ..] = data else {
            return Err(length(HEAD - 1));
        };
        let mut rest = rest;
        let mut objects = Vec::new();
        for _ in 0..count {
            let (&[id, size], after) = rest.split_first_chunk::<2>().ok_or(length(data.len() + 2))?;
            let missing = usize::from(size).saturating_sub(after.len());
            let (value, after) = after.split_at_checked(size.into()).ok_or(length(data.len() + missing))?;
            objects.push(Object { id, value: value.to_vec() });
            rest = after;
        }
        if !rest.is_empty() {
            return Err(length(data.len() - rest.len()));
        }
        Ok(Identification { category, conformity, next: (more != 0).then_some(next), objects })
    }
}

/// Length of the reply PDU whose first bytes are `start`: nothing counts its bytes, so its objects have to be walked.
/// `None` until the length of the last object is there.
pub(super) fn length(start: &[u8]) -> Option<usize> {
    let &count = start.get(HEAD - 1)?;
    (0..count).try_fold(HEAD, |at, _| start.get(at + 1).map(|&size| at + 2 + usize::from(size)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lexium() -> Identification {
        let object = |id, text: &str| Object { id, value: text.into() };
        let objects = vec![object(VENDOR_NAME, "V"), object(PRODUCT_CODE, ""), object(REVISION_LEXIUM, "V02.001")];
        Identification { category: BASIC, conformity: 2, next: None, objects }
    }

    #[test]
    fn the_end_is_known_with_the_length_of_the_last_object() {
        let pdu = [vec![ENCAPSULATED], lexium().encode()].concat();
        assert_eq!(pdu[..7], [43, 14, 1, 2, 0, 0, 3]);
        // The last object's length stands 8 bytes before the end, its 7 characters not counted.
        for end in 0..=pdu.len() {
            assert_eq!(length(&pdu[..end]), (end >= pdu.len() - 7).then_some(pdu.len()), "{end}");
        }
        assert_eq!(length(&[43, 14, 1, 2, 0, 0, 0]), Some(7));
    }

    #[test]
    fn too_short_and_too_long_is_no_identification() {
        let data = lexium().encode();
        assert_eq!(Identification::decode(&data), Ok(lexium()));
        for end in 0..data.len() {
            assert!(Identification::decode(&data[..end]).is_err(), "{end}");
        }
        assert!(Identification::decode(&[data.as_slice(), &[0]].concat()).is_err());
    }

    #[test]
    fn what_follows_is_named() {
        let first = Identification { next: Some(2), ..lexium() };
        let data = first.encode();
        assert_eq!(data[3..5], [0xFF, 2]);
        assert_eq!(Identification::decode(&data), Ok(first));
    }
}
