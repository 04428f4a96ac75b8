//! In which rounds the addresses of a line are asked whose setting nobody knows: few likely ones at every setting first.

use super::plan::Manner;

/// A round through the settings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Stage {
    /// So many of the addresses are asked in it, from the first on.
    pub first: usize,
    /// A quick look: whoever is silent is asked again in a later round.
    pub quick: bool,
}

/// The factory address is 1 (P.1376: CM-485 manual 5.2.2; MBadr: LXM05 manual 4.1), and who numbers his drives begins there.
/// More than 32 are on few lines: a CM-485 that speaks VABus has no address above 30 (P.394: CM-485 manual 11.2), an LXM05 bus at
/// most 31 participants (LXM05 manual 4.1), an L200 no address above 32 (C072: SJ2-PB manual, index 149).
const STAGES: [Stage; 4] = [
    Stage { first: 1, quick: true },
    Stage { first: 10, quick: true },
    Stage { first: 32, quick: false },
    Stage { first: usize::MAX, quick: false },
];

/// The rounds of a search of so many settings for so many addresses; the last asks everybody.
pub(super) fn stages(manner: Manner, settings: usize, addresses: usize) -> Vec<Stage> {
    let [.., whole] = STAGES;
    if settings == 1 {
        return vec![whole];
    }
    // Who is asked once is settled by that; only the address at which most drives are found has its look beforehand.
    let quick = |stage: Stage| stage.quick && (manner != Manner::Fast || stage.first == 1);
    let rounds = STAGES.map(|stage| Stage { first: stage.first.min(addresses), quick: quick(stage) });
    // A round that the next one repeats is none.
    let nexts = rounds.iter().skip(1).map(|next| next.first).chain([0]);
    rounds.into_iter().zip(nexts).filter(|(stage, next)| stage.first != *next).map(|(stage, _)| stage).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(manner: Manner, settings: usize, addresses: usize) -> Vec<(usize, bool)> {
        stages(manner, settings, addresses).iter().map(|stage| (stage.first, stage.quick)).collect()
    }

    #[test]
    fn likely_addresses_are_asked_at_every_setting_before_the_others() {
        assert_eq!(told(Manner::Usual, 49, 247), [(1, true), (10, true), (32, false), (247, false)]);
        assert_eq!(told(Manner::Fast, 49, 247), [(1, true), (10, false), (32, false), (247, false)]);
    }

    #[test]
    fn few_addresses_need_few_rounds_and_one_setting_needs_one() {
        assert_eq!(told(Manner::Usual, 7, 2), [(1, true), (2, false)]);
        assert_eq!(told(Manner::Usual, 7, 20), [(1, true), (10, true), (20, false)]);
        assert_eq!(told(Manner::Usual, 7, 1), [(1, false)]);
        assert_eq!(told(Manner::Usual, 1, 247), [(usize::MAX, false)]);
    }
}
