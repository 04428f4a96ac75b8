//! The error counters of a controller, and how it takes part by them (fault confinement, ISO 11898-1; P.979 shows it, EM-RES-03 manual 5.12).
//!
//! Choices where the manual is silent: a disturbed frame counts 1 for every listener, which is the least that the standard has; the
//! count at which P.979 warns is a reading.

/// The counters of one controller.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Errors {
    sent: u32,
    heard: u32,
}

/// How a frame ended for who sent it, or who listened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ended {
    Well,
    /// Nobody has acknowledged it.
    Alone,
    /// Somebody has destroyed it.
    Disturbed,
}

/// From here on a controller disturbs nobody and counts no missing acknowledgement.
const PASSIVE: u32 = 128;
/// From here on it is off the bus.
const OFF: u32 = 256;
/// What a frame that did not go out counts for its sender.
const FAILED: u32 = 8;

impl Errors {
    /// A frame of its own.
    pub(super) fn sent(&mut self, ended: Ended) {
        self.sent = match ended {
            Ended::Well => self.sent.saturating_sub(1),
            Ended::Alone if self.sent >= PASSIVE => self.sent,
            Ended::Alone | Ended::Disturbed => (self.sent + FAILED).min(OFF),
        };
    }

    /// A frame of somebody else.
    pub(super) fn heard(&mut self, ended: Ended) {
        self.heard = match ended {
            Ended::Well => self.heard.min(PASSIVE).saturating_sub(1),
            Ended::Alone => self.heard,
            Ended::Disturbed => (self.heard + 1).min(PASSIVE),
        };
    }

    pub(super) fn is_passive(self) -> bool {
        self.sent.max(self.heard) >= PASSIVE
    }

    pub(super) fn is_off(self) -> bool {
        self.sent >= OFF
    }

    /// Whether either count has reached this.
    pub(super) fn reaches(self, count: u32) -> bool {
        self.sent.max(self.heard) >= count
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// How often until it is so.
    fn until(mut errors: Errors, next: impl Fn(&mut Errors), is_so: impl Fn(Errors) -> bool) -> u32 {
        for times in 0..1_000 {
            if is_so(errors) {
                return times;
            }
            next(&mut errors);
        }
        1_000
    }

    #[test]
    fn who_is_alone_never_goes_off_and_who_is_disturbed_does() {
        let fresh = Errors::default();
        assert_eq!(until(fresh, |errors| errors.sent(Ended::Alone), Errors::is_passive), 16);
        assert_eq!(until(fresh, |errors| errors.sent(Ended::Alone), Errors::is_off), 1_000);
        assert_eq!(until(fresh, |errors| errors.sent(Ended::Disturbed), Errors::is_off), 32);
        assert_eq!(until(fresh, |errors| errors.heard(Ended::Disturbed), Errors::is_passive), 128);
        assert_eq!(until(fresh, |errors| errors.heard(Ended::Disturbed), Errors::is_off), 1_000);
        let mut warned = Errors::default();
        (0..12).for_each(|_| warned.sent(Ended::Alone));
        assert!(warned.reaches(96) && !warned.is_passive());
        warned.sent(Ended::Well);
        assert!(!warned.reaches(96));
    }
}
