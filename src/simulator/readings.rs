//! Where the manuals leave a question open: the readings that a drive of the bench can be built with.
//!
//! Each row names a question, the models that it concerns, and its readings; the first is the one of the standard bench.
//! What decides something has a [`Reading`] of its own, and the drive asks [`Readings::has`]. `bench.toml` tells them.

use super::setup::Model;

/// A reading that differs from the standard bench.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Reading {
    // LXM05
    ModeChangeRefused,
    ReferencesOutliveRun,
    ReferencesOutliveMode,
    SetpointsEndWithRun,
    SetpointsEndWithMode,
    Control7Brakes,
    Control7Refused,
    GuardQuickStop,
    QuickStopStays,
    GuardFedByWrites,
    ExchangeReadsFirst,
    WritesOneByOne,
    AddressAtOnce,
    BaudAtOnce,
    WordOrderAtOnce,
    FaultMemoryMovesOn,
    Exception1,
    Exception2,
    Exception3,
    Exception4,
    SaveByCommand,
    // ACT, ACU
    ControlByEdge,
    ReadsInForce,
    UnknownIsException2,
    SetAsAsked,
    LineReplyLost,
    LineReplyNew,
    ResetNeedsRemote,
    CoastShowsShaft,
    SilentAfterNak,
    SilentOnWrongCheck,
}

/// An open question.
pub(super) struct Question {
    pub(super) key: &'static str,
    pub(super) models: &'static [Model],
    /// Word, and what it changes; the first is the standard bench.
    pub(super) words: &'static [(&'static str, Option<Reading>)],
}

const SERVO: &[Model] = &[Model::Lxm05];
const ACTIVE: &[Model] = &[Model::Act, Model::Acu];

use Reading as R;
/// All of them: docs/open-points.md.
#[rustfmt::skip]
pub(super) const QUESTIONS: &[Question] = &[
    // LXM05 manual 6.3.1: a command that a running movement forbids
    row("mode_change", SERVO, &[("accepted", None), ("refused", Some(R::ModeChangeRefused))]),
    row("references_after_run", SERVO, &[("zeroed", None), ("kept", Some(R::ReferencesOutliveRun))]),
    row("references_after_mode", SERVO, &[("zeroed", None), ("kept", Some(R::ReferencesOutliveMode))]),
    row("setpoints_after_run", SERVO, &[("kept", None), ("zeroed", Some(R::SetpointsEndWithRun))]),
    row("setpoints_after_mode", SERVO, &[("kept", None), ("zeroed", Some(R::SetpointsEndWithMode))]),
    row("control_7", SERVO, &[("coasts", None), ("brakes", Some(R::Control7Brakes)), ("refused", Some(R::Control7Refused))]),
    // LXM05 manual 5.6
    row("node_guard", SERVO, &[("fault", None), ("quick-stop", Some(R::GuardQuickStop))]),
    row("node_guard_fed_by", SERVO, &[("all", None), ("writes", Some(R::GuardFedByWrites))]),
    row("quick_stop", SERVO, &[("ends", None), ("stays", Some(R::QuickStopStays))]),
    row("code_23", SERVO, &[("writes-first", None), ("reads-first", Some(R::ExchangeReadsFirst))]),
    row("code_16", SERVO, &[("whole", None), ("one-by-one", Some(R::WritesOneByOne))]),
    // LXM05 manual 4.1
    row("mbadr", SERVO, &[("power-on", None), ("at-once", Some(R::AddressAtOnce))]),
    row("mbbaud", SERVO, &[("power-on", None), ("at-once", Some(R::BaudAtOnce))]),
    row("mbdword_order", SERVO, &[("power-on", None), ("at-once", Some(R::WordOrderAtOnce))]),
    row("flt_err_num", SERVO, &[("stays", None), ("moves-on", Some(R::FaultMemoryMovesOn))]),
    // LXM05 manual 6.2
    row("exceptions", SERVO, &[("by-cause", None), ("1", Some(R::Exception1)), ("2", Some(R::Exception2)),
        ("3", Some(R::Exception3)), ("4", Some(R::Exception4))]),
    row("persistence", SERVO, &[("at-once", None), ("by-command", Some(R::SaveByCommand))]),
    // CM-485 manual 9.1.2, 10.2
    row("control_word", ACTIVE, &[("level", None), ("edge", Some(R::ControlByEdge))]),
    // CM-485 manual 7
    row("ram_reads", ACTIVE, &[("eeprom", None), ("in-force", Some(R::ReadsInForce))]),
    // CM-485 manual 6.4 against 8.1.3
    row("unknown_parameter", ACTIVE, &[("4", None), ("2", Some(R::UnknownIsException2))]),
    row("set_character", ACTIVE, &[("folded", None), ("as-asked", Some(R::SetAsAsked))]),
    // CM-485 manual 5.2.1
    row("line_reply", ACTIVE, &[("old", None), ("lost", Some(R::LineReplyLost)), ("new", Some(R::LineReplyNew))]),
    // CM-485 manual 9.1
    row("reset", ACTIVE, &[("free", None), ("needs-remote", Some(R::ResetNeedsRemote))]),
    // CM-485 manual 9.2.1: what the frequency of the stator (P.210) is while the shaft coasts
    row("coast_shows", ACTIVE, &[("nothing", None), ("shaft", Some(R::CoastShowsShaft))]),
    row("after_nak", ACTIVE, &[("nak", None), ("silence", Some(R::SilentAfterNak))]),
    row("wrong_bcc", ACTIVE, &[("nak", None), ("silence", Some(R::SilentOnWrongCheck))]),
];

const fn row(
    key: &'static str,
    models: &'static [Model],
    words: &'static [(&'static str, Option<Reading>)],
) -> Question {
    Question { key, models, words }
}

/// The readings of one drive.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Readings(u64);

impl Readings {
    pub(super) fn has(self, reading: Reading) -> bool {
        self.0 >> (reading as u8) & 1 == 1
    }

    pub(super) fn add(&mut self, reading: Reading) {
        self.0 |= 1 << (reading as u8);
    }
}

/// The question with this key, if it concerns the model.
pub(super) fn question(key: &str, model: Model) -> Option<&'static Question> {
    QUESTIONS.iter().find(|row| row.key == key && row.models.contains(&model))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_reading_is_told_by_the_help_and_the_first_is_the_standard() {
        let help = include_str!("bench.toml");
        for row in QUESTIONS {
            assert!(row.words.len() > 1 && row.words[0].1.is_none(), "{}", row.key);
            let line = help.lines().find(|line| line.contains(&format!("{} = \"{}\"", row.key, row.words[0].0)));
            let line = line.unwrap_or_else(|| panic!("{} is not told", row.key));
            assert!(row.words.iter().all(|word| line.contains(word.0)), "{line}");
        }
    }
}
