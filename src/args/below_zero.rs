//! Values below zero as words of their own: `write 480 -12,5Hz`. To clap such a word is an option, because `-12` and `-12.5`
//! are all the numbers that it knows. No option of ours begins with a digit, so before clap sees the words the sign of such a
//! one becomes the minus sign of typesetting, and [`word`] takes that back.

use clap::Command;
use std::convert::Infallible;
use std::ffi::OsString;

/// The minus sign of typesetting; values that were pasted have it anyway.
pub const SIGN: char = '−';

/// The words as clap can read them, if a command of this tree takes values below zero: one with an argument without a name
/// that allows negative numbers.
pub fn shielded(words: &[OsString], tree: &Command) -> Vec<OsString> {
    let takes = |command: &Command| command.get_positionals().any(clap::Arg::is_allow_negative_numbers_set);
    let takes = tree.get_subcommands().any(takes);
    words.iter().map(|word| below_zero(word).filter(|_| takes).unwrap_or_else(|| word.clone())).collect()
}

/// A typed word as it was.
pub fn word(text: &str) -> Result<String, Infallible> {
    Ok(text.strip_prefix(SIGN).map_or_else(|| text.to_owned(), |rest| format!("-{rest}")))
}

/// The word with the other sign, if it is a number below zero, with or without a unit.
fn below_zero(word: &OsString) -> Option<OsString> {
    let number = word.to_str()?.strip_prefix('-')?;
    let digits = number.strip_prefix(['.', ',']).unwrap_or(number);
    digits.starts_with(|letter: char| letter.is_ascii_digit()).then(|| format!("{SIGN}{number}").into())
}
