//! Diagnostic counters of a Modbus slave: the station counts, the device tells (CM-485 manual 6.4.5; LXM05 manual 5.2).

/// Diagnostic counters by their sub-function (CM-485 manual 6.4.5). They are 16 bits wide and start over.
#[derive(Clone, Debug, Default)]
pub(crate) struct Counters([u16; 8]);

impl Counters {
    /// Valid telegrams, for any address.
    pub(crate) const MESSAGES: u16 = 0x0B;
    /// Telegrams with a wrong check value, parity or framing, or too many bytes.
    pub(crate) const ERRORS: u16 = 0x0C;
    /// Exception replies sent.
    pub(crate) const EXCEPTIONS: u16 = 0x0D;
    /// Telegrams for this drive.
    pub(crate) const OWN: u16 = 0x0E;
    /// Broadcasts.
    pub(crate) const BROADCASTS: u16 = 0x0F;
    /// Telegrams with characters lost.
    pub(crate) const OVERRUNS: u16 = 0x12;

    /// Counts one more.
    pub(crate) fn count(&mut self, sub: u16) {
        if let Some(counter) = self.0.get_mut(usize::from(sub.wrapping_sub(Self::MESSAGES))) {
            *counter = counter.wrapping_add(1);
        }
    }

    /// Present value of a counter.
    pub(crate) fn get(&self, sub: u16) -> u16 {
        self.0.get(usize::from(sub.wrapping_sub(Self::MESSAGES))).copied().unwrap_or(0)
    }
}
