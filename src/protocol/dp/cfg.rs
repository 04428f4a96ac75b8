//! Identifiers of Chk_Cfg and Get_Cfg, and the configurations of an SJ2-PB (IEC 61158-6-3; fieldbus facts; SJ2-PB manual 3.1, 4.1).

/// One identifier of a configuration: what it adds to the inputs and outputs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Identifier {
    /// Its bytes.
    pub bytes: Vec<u8>,
    /// Inputs to the master.
    pub inputs: Option<Extent>,
    /// Outputs to the slave.
    pub outputs: Option<Extent>,
}

/// How much is carried in one direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extent {
    /// Words, or bytes.
    pub count: u8,
    /// Whether `count` is in words.
    pub is_words: bool,
    /// Consistent over the whole, not only over each byte or word.
    pub is_consistent: bool,
}

/// Bit 7: consistent over the whole.
const WHOLE: u8 = 0x80;
/// Bit 6: words.
const WORDS: u8 = 0x40;
/// Bits 5 and 4 of the usual form: inputs, outputs. Neither: the special form.
const INPUT: u8 = 0x10;
const OUTPUT: u8 = 0x20;

impl Extent {
    /// Bytes that are carried.
    pub fn bytes(self) -> usize {
        usize::from(self.count) * if self.is_words { 2 } else { 1 }
    }

    fn of(byte: u8, mask: u8) -> Self {
        Extent { count: (byte & mask) + 1, is_words: byte & WORDS != 0, is_consistent: byte & WHOLE != 0 }
    }

    fn bits(self) -> u8 {
        let bit = |is: bool, bit: u8| if is { bit } else { 0 };
        bit(self.is_consistent, WHOLE) | bit(self.is_words, WORDS) | self.count.saturating_sub(1)
    }
}

/// Reads the identifiers of a configuration; the last may be cut off, and then carries nothing.
pub fn identifiers(mut bytes: &[u8]) -> Vec<Identifier> {
    let mut all = Vec::new();
    while let Some(&header) = bytes.first() {
        let length = if header & (INPUT | OUTPUT) == 0 { special_length(header) } else { 1 };
        let (own, rest) = bytes.split_at_checked(length).unwrap_or((bytes, &[]));
        let (inputs, outputs) = match own {
            own if own.len() < length => (None, None),
            &[header] => {
                let extent = Extent::of(header, 0x0F);
                ((header & INPUT != 0).then_some(extent), (header & OUTPUT != 0).then_some(extent))
            }
            own => special(own),
        };
        all.push(Identifier { bytes: own.to_vec(), inputs, outputs });
        bytes = rest;
    }
    all
}

/// The special form: bits 7 and 6 tell whether a byte follows for the outputs and for the inputs, bits 3 to 0 how many of the
/// maker stand behind (15: none, and no data either).
fn special_length(header: u8) -> usize {
    let own = usize::from(header & 0x0F);
    1 + usize::from(header & 0x80 != 0) + usize::from(header & 0x40 != 0) + if own == 15 { 0 } else { own }
}

fn special(own: &[u8]) -> (Option<Extent>, Option<Extent>) {
    let mut rest = own.iter().copied();
    let header = rest.next().unwrap_or_default();
    let mut next = |is: bool| is.then(|| rest.next()).flatten().map(|byte| Extent::of(byte, 0x3F));
    // Where both are there, that of the outputs stands first (IEC 61158-6-3).
    let outputs = next(header & 0x80 != 0);
    (next(header & 0x40 != 0), outputs)
}

/// The identifier of a module of so many words in one direction (SJ2-PB manual 3.1.1: 50h in, 60h out).
pub fn of_words(count: u8, is_output: bool) -> u8 {
    let extent = Extent { count: count.clamp(1, 16), is_words: true, is_consistent: false };
    extent.bits() | if is_output { OUTPUT } else { INPUT }
}

/// What the cyclic data of an SJ2-PB are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layout {
    /// The four words of the Basic block (manual 3.2).
    Basic,
    /// Process data, with or without a PKW block in front of them (manual 4.1).
    Ppo(u8),
}

/// Word on the command line, layout, and its bytes in Chk_Cfg (fieldbus facts; Basic: manual 3.1.1).
const LAYOUTS: [(&str, Layout, &[u8]); 6] = [
    ("basic", Layout::Basic, &[0xF3]),
    ("ppo1", Layout::Ppo(1), &[0xF3, 0xF1]),
    ("ppo2", Layout::Ppo(2), &[0xF3, 0xF5]),
    ("ppo3", Layout::Ppo(3), &[0xF1]),
    ("ppo4", Layout::Ppo(4), &[0xF5]),
    ("ppo5", Layout::Ppo(5), &[0xF3, 0xF9]),
];

impl Layout {
    /// Every layout.
    pub fn all() -> impl Iterator<Item = Layout> {
        LAYOUTS.into_iter().map(|row| row.1)
    }

    /// The layout of a word, such as `ppo1`, or of the bytes of a configuration.
    pub fn of(word: &str, bytes: &[u8]) -> Option<Self> {
        LAYOUTS.iter().find(|row| row.0.eq_ignore_ascii_case(word) || row.2 == bytes).map(|row| row.1)
    }

    /// The word that names it.
    pub fn name(self) -> &'static str {
        self.row().0
    }

    /// Its bytes in Chk_Cfg.
    pub fn bytes(self) -> &'static [u8] {
        self.row().2
    }

    /// Whether a PKW block of eight bytes stands in front.
    pub fn has_pkw(self) -> bool {
        matches!(self, Layout::Ppo(1 | 2 | 5))
    }

    /// Bytes in each direction.
    pub fn length(self) -> usize {
        identifiers(self.bytes()).iter().filter_map(|identifier| identifier.inputs).map(Extent::bytes).sum()
    }

    fn row(self) -> (&'static str, Layout, &'static [u8]) {
        LAYOUTS.into_iter().find(|row| row.1 == self).unwrap_or(("", self, &[]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn configurations_of_the_manual() {
        // 4.1: PKW is four words, and PPO1 to PPO5 have 2, 6, 2, 6, 10 words of process data.
        let words = |layout: Layout| layout.length() / 2;
        assert_eq!(Layout::all().map(words).collect::<Vec<_>>(), [4, 6, 10, 2, 6, 14]);
        for layout in Layout::all() {
            assert_eq!(Layout::of(layout.name(), &[]), Some(layout));
            assert_eq!(Layout::of("", layout.bytes()), Some(layout));
        }
        assert_eq!((of_words(1, false), of_words(1, true)), (0x50, 0x60)); // 3.1.1
    }

    /// The last one may be cut off, and then carries nothing; a byte that stands alone has both directions, or none.
    #[test]
    fn identifiers_tell_what_they_carry() {
        let carried = |bytes: &[u8]| {
            let count = |extent: Option<Extent>| extent.map(|extent| extent.count);
            identifiers(bytes).iter().map(|one| (count(one.inputs), count(one.outputs))).collect::<Vec<_>>()
        };
        assert_eq!(carried(&[0x73, 0x12, 0x24]), [(Some(4), Some(4)), (Some(3), None), (None, Some(5))]);
        assert_eq!(carried(&[0xC0, 0x41, 0x42]), [(Some(3), Some(2))]);
        assert_eq!(carried(&[0x40, 0x43, 0x80, 0x44]), [(Some(4), None), (None, Some(5))]);
        assert_eq!(carried(&[0xC0, 0x41]), [(None, None)], "cut off");
        assert_eq!(carried(&[0x02, 7, 8, 0x10]), [(None, None), (Some(1), None)], "bytes of the maker");
        assert_eq!(carried(&[0x0F, 0x10]), [(None, None), (Some(1), None)]);
    }

    #[test]
    fn identifiers_of_both_forms() {
        let found = identifiers(&[0xF3, 0x10, 0xC2, 0x41, 0x80, 0xAA, 0xBB, 0x00, 0x41]);
        let of = |count, is_words, is_consistent| Some(Extent { count, is_words, is_consistent });
        assert_eq!((found[0].inputs, found[0].outputs), (of(4, true, true), of(4, true, true)));
        assert_eq!((found[1].inputs, found[1].outputs), (of(1, false, false), None));
        assert_eq!((found[2].outputs, found[2].inputs), (of(2, true, false), of(1, false, true)));
        assert_eq!(found[2].bytes.len(), 5);
        assert_eq!((found[3].inputs, found[3].outputs), (None, None), "an empty place");
        assert_eq!((&found[4].bytes[..], found[4].inputs), (&[0x41][..], None), "cut off");
    }

    #[test]
    fn an_identifier_of_the_special_form_may_carry_one_direction_alone() {
        let of = |header| identifiers(&[header, 0x03]).first().map(|one| (one.inputs.is_some(), one.outputs.is_some()));
        assert_eq!([0x40, 0x80].map(of), [Some((true, false)), Some((false, true))]);
    }

    proptest! {
        #[test]
        fn every_byte_is_in_one_identifier(bytes in proptest::collection::vec(any::<u8>(), 0..64)) {
            let all = identifiers(&bytes);
            prop_assert_eq!(all.iter().flat_map(|one| one.bytes.clone()).collect::<Vec<_>>(), bytes);
        }
    }
}
