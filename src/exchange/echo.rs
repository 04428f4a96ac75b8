//! Adapters that hear themselves: what we sent comes back in front of the reply.
//!
//! Some replies are identical to their questions (writes, code 8), so on such a line the echo of a question to a drive
//! that is off would pass for its reply. Whether the line echoes is learnt from questions whose echo cannot be a reply.

/// So many replies in a row behind so little noise that our telegram cannot be in it.
const SHORT: u8 = 2;

/// Whether the line gives back what we send.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Echo {
    /// Nothing was asked yet that tells; so many of the last replies came behind a little noise only.
    Unknown(u8),
    /// Replies came without an echo before them.
    Absent,
    /// An echo came.
    Present,
}

impl Default for Echo {
    fn default() -> Self {
        Echo::Unknown(0)
    }
}

impl Echo {
    /// What a reply that came behind `before` tells. In noise as long as our telegram an echo may have been spoilt, so that
    /// tells nothing; a line without bias that brings a byte before every reply shall be learnt all the same.
    pub(super) fn learn(&mut self, sent: &[u8], before: &[u8]) {
        let holds_sent = before.windows(sent.len().max(1)).any(|window| window == sent);
        *self = match (*self, before) {
            (_, []) => Echo::Absent,
            _ if holds_sent => Echo::Present,
            (Echo::Unknown(short), _) if before.len() * 2 < sent.len() => match short + 1 {
                SHORT.. => Echo::Absent,
                short => Echo::Unknown(short),
            },
            (Echo::Unknown(_), _) => Echo::Unknown(0),
            (known, _) => known,
        };
    }

    /// Whether it is known.
    pub(super) fn is_known(self) -> bool {
        !matches!(self, Echo::Unknown(_))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SENT: [u8; 8] = [1, 3, 0, 9, 0, 1, 2, 3];

    fn learnt(before: &[&[u8]]) -> Echo {
        let mut echo = Echo::default();
        before.iter().for_each(|before| echo.learn(&SENT, before));
        echo
    }

    #[test]
    fn two_replies_behind_a_byte_of_noise_tell_that_nothing_comes_back() {
        assert_eq!(learnt(&[&[0]]), Echo::Unknown(1));
        assert_eq!(learnt(&[&[0], &[0xFF, 0, 1]]), Echo::Absent);
        assert_eq!(learnt(&[&[0; 4], &[0; 7]]), Echo::Unknown(0), "an echo that was spoilt, perhaps");
        assert_eq!(learnt(&[&[0], &[0; 8], &[0]]), Echo::Unknown(1), "in a row");
        assert_eq!(learnt(&[&[0; 4]]), Echo::Unknown(0), "half of it is no little noise");
        assert_eq!(learnt(&[&[]]), Echo::Absent);
    }

    #[test]
    fn an_echo_is_one_with_noise_before_and_behind_it() {
        let noisy = [&[0][..], &SENT, &[0, 7]].concat();
        assert_eq!([learnt(&[&SENT]), learnt(&[&noisy]), learnt(&[&[0], &noisy])], [Echo::Present; 3]);
        assert_eq!(learnt(&[&SENT, &[0], &[0], &[0]]), Echo::Present, "noise alone unlearns nothing");
    }
}
