//! What a slave answers to Slave_Diag (IEC 61158-6-3; fieldbus facts, "Slave_Diag").

/// Six bytes that every slave has, and blocks behind them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnosis {
    /// Bytes 0 to 2, bit by bit: [`FLAGS`].
    pub status: [u8; 3],
    /// Master that parameterised the slave; [`NOBODY`] if none did.
    pub master: u8,
    /// Ident number.
    pub ident: u16,
    /// What the device says beyond.
    pub blocks: Vec<Block>,
}

/// No master has parameterised the slave.
pub const NOBODY: u8 = 0xFF;

/// The bits that have a name: byte, bit, name of the norm. Byte 1 bit 2 is always 1.
pub const FLAGS: [(usize, u8, &str); 15] = [
    (0, 0, "Station_Non_Existent"),
    (0, 1, "Station_Not_Ready"),
    (0, 2, "Cfg_Fault"),
    (0, 3, "Ext_Diag"),
    (0, 4, "Not_Supported"),
    (0, 5, "Invalid_Slave_Response"),
    (0, 6, "Prm_Fault"),
    (0, 7, "Master_Lock"),
    (1, 0, "Prm_Req"),
    (1, 1, "Stat_Diag"),
    (1, 3, "WD_On"),
    (1, 4, "Freeze_Mode"),
    (1, 5, "Sync_Mode"),
    (1, 7, "Deactivated"),
    (2, 7, "Ext_Diag_Overflow"),
];

/// A block behind the first six bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Block {
    /// Of the maker; its layout is his.
    Device(Vec<u8>),
    /// A bit for each identifier of the configuration that has something to say.
    Identifier(Vec<u8>),
    /// One channel of one identifier.
    Channel([u8; 3]),
    /// What is no block, or is cut off.
    Rest(Vec<u8>),
}

impl Diagnosis {
    /// Reads the answer; `None` if it has fewer than six bytes.
    pub fn decode(bytes: &[u8]) -> Option<Self> {
        let &[first, second, third, master, high, low, ref blocks @ ..] = bytes else { return None };
        let ident = u16::from_be_bytes([high, low]);
        Some(Diagnosis { status: [first, second, third], master, ident, blocks: self::blocks(blocks) })
    }

    /// The bytes that say this.
    pub fn encode(&self) -> Vec<u8> {
        let mut bytes = self.status.to_vec();
        bytes.push(self.master);
        bytes.extend(self.ident.to_be_bytes());
        bytes.extend(self.blocks.iter().flat_map(Block::bytes));
        bytes
    }

    /// Names of the bits that are set.
    pub fn flags(&self) -> impl Iterator<Item = &'static str> {
        let is_set = |byte: usize, bit: u8| self.status.get(byte).is_some_and(|status| status & (1 << bit) != 0);
        FLAGS.into_iter().filter(move |row| is_set(row.0, row.1)).map(|row| row.2)
    }
}

impl Block {
    /// Its bytes, header and all.
    pub fn bytes(&self) -> Vec<u8> {
        match self {
            Block::Device(bytes) | Block::Identifier(bytes) | Block::Rest(bytes) => bytes.clone(),
            Block::Channel(bytes) => bytes.to_vec(),
        }
    }
}

/// Bits 7 and 6 of the header say what a block is; the rest is its length with the header, but for a channel, which has three
/// bytes and the number of its identifier there.
fn blocks(mut bytes: &[u8]) -> Vec<Block> {
    let mut blocks = Vec::new();
    while let Some(&header) = bytes.first() {
        let kind = header >> 6;
        let length = if kind == 2 { 3 } else { usize::from(header & 0x3F) };
        let block = bytes.split_at_checked(length).filter(|_| length > 0 && kind != 3);
        let Some((block, rest)) = block else {
            blocks.push(Block::Rest(bytes.to_vec()));
            break;
        };
        blocks.push(match (kind, block) {
            (0, block) => Block::Device(block.to_vec()),
            (1, block) => Block::Identifier(block.to_vec()),
            (_, &[first, second, third]) => Block::Channel([first, second, third]),
            (_, block) => Block::Rest(block.to_vec()),
        });
        bytes = rest;
    }
    blocks
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_answers_of_the_facts() {
        let new = Diagnosis::decode(&[2, 5, 0, 0xFF, 0x0A, 0x35]).unwrap();
        assert_eq!((new.master, new.ident), (NOBODY, 0x0A35));
        assert_eq!(new.flags().collect::<Vec<_>>(), ["Station_Not_Ready", "Prm_Req"]);
        let running = Diagnosis::decode(&[0, 0x0C, 0, 2, 0x0A, 0x35]).unwrap();
        assert_eq!(running.flags().collect::<Vec<_>>(), ["WD_On"]);
        assert_eq!(running.master, 2);
    }

    #[test]
    fn blocks_are_told_apart() {
        let bytes = [8, 0x0C, 0, 2, 1, 2, 0x04, 0xAA, 0xBB, 0xCC, 0x42, 0x01, 0x81, 0x40, 0x29, 0xC1, 0, 0];
        let found = Diagnosis::decode(&bytes).unwrap();
        let blocks = [
            Block::Device(vec![4, 0xAA, 0xBB, 0xCC]),
            Block::Identifier(vec![0x42, 1]),
            Block::Channel([0x81, 0x40, 0x29]),
            Block::Rest(vec![0xC1, 0, 0]),
        ];
        assert_eq!(found.blocks, blocks);
    }

    proptest! {
        #[test]
        fn every_answer_comes_back_as_it_was(bytes in proptest::collection::vec(any::<u8>(), 0..244)) {
            match Diagnosis::decode(&bytes) {
                Some(found) => prop_assert_eq!(found.encode(), bytes),
                None => prop_assert!(bytes.len() < 6),
            }
        }
    }
}
