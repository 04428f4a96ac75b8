//! Check values of telegrams: CRC-16 of Modbus RTU and LRC of Modbus ASCII.

/// CRC-16 of Modbus RTU: start 0xFFFF, polynomial 0xA001, bits shifted right (CM-485 manual 6.7.1.4).
///
/// On the wire the low byte comes first.
pub fn crc16(bytes: &[u8]) -> u16 {
    bytes.iter().fold(0xFFFF, |crc, &byte| {
        (0..8).fold(crc ^ u16::from(byte), |crc, _| if crc & 1 == 1 { (crc >> 1) ^ 0xA001 } else { crc >> 1 })
    })
}

/// LRC of Modbus ASCII: two's complement of the sum of the binary bytes (CM-485 manual 6.7.2.3).
pub fn lrc(bytes: &[u8]) -> u8 {
    bytes.iter().fold(0u8, |sum, &byte| sum.wrapping_add(byte)).wrapping_neg()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn crc_example_of_the_manual() {
        assert_eq!(crc16(&[0x02, 0x07]), 0x1241); // CM-485 manual 6.7.1.4
    }

    #[test]
    fn lrc_example_of_the_manual() {
        assert_eq!(lrc(&[0x01, 0x83, 0x02]), 0x7A); // CM-485 manual 6.7.2.3
    }
}
