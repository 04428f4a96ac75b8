//! What a bench file says of the line: disturbances, and who speaks unasked.

use super::reader::{BenchFile, quoted};
use super::tables::DisturbTable;
use crate::profile::Broken;
use crate::simulator::line::babble::{Babbler, Pattern};
use crate::simulator::line::disturb::{Kind, Parting, Rule, When};
use crate::simulator::line::speech::Spoken;
use crate::text::both;
use crate::tick::{Span, Tick};
use toml::Spanned;

impl BenchFile<'_> {
    /// Somebody who speaks unasked; `None` if the table is about replies.
    pub(crate) fn babbler(&self, table: &Spanned<DisturbTable>, spoken: Spoken) -> Result<Option<Babbler>, Broken> {
        let row = table.get_ref();
        if row.kind.get_ref() != "babble" {
            return Ok(None);
        }
        if row.every.is_some() || row.once.is_some() || row.byte.is_some() || row.address.is_some() {
            let message = both!(
                "babble goes only with at, by, for, pattern, baud, parity and reply_delay",
                "zu babble gehören nur at, by, for, pattern, baud, parity und reply_delay"
            );
            return Err(self.error(table.span(), message));
        }
        let pattern = match row.pattern.as_ref() {
            None => Pattern::Bytes(vec![0x55]),
            Some(got) => pattern(got.get_ref(), spoken).ok_or_else(|| {
                let expected = both!(
                    "random, digits, master, or bytes in hex such as \"55 AA\"",
                    "random, digits, master oder Bytes in Hex wie \"55 AA\""
                );
                self.unfit("pattern", got.span(), &quoted(got), &expected)
            })?,
        };
        let from = Tick::ZERO + self.time_or("at", row.at.as_ref(), Span::ZERO)?;
        let pause = self.time_or("by", row.by.as_ref(), BABBLE_PAUSE)?;
        let lasts = row.lasts.as_ref().map(|got| self.time("for", got)).transpose()?;
        let reply_delay = row.reply_delay.as_ref().map(|got| self.time("reply_delay", got)).transpose()?;
        let is_set = row.baud.is_some() || row.parity.is_some();
        let line = is_set.then(|| self.setting(row.baud.as_ref(), row.parity.as_ref(), spoken)).transpose()?;
        Ok(Some(Babbler::new(pattern, from, pause, lasts).at(line, reply_delay)))
    }

    pub(crate) fn rule(&self, table: &Spanned<DisturbTable>) -> Result<Rule, Broken> {
        let row = table.get_ref();
        let when = match (&row.every, &row.once, &row.at) {
            (Some(every), None, None) => When::Every(self.count(every)?),
            (None, Some(once), None) => When::Once(self.count(once)?),
            (None, None, Some(at)) => When::From(Tick::ZERO + self.time("at", at)?),
            _ => {
                let message =
                    both!("expected exactly one of: every, once, at", "erwartet wird genau eines von: every, once, at");
                return Err(self.error(table.span(), message));
            }
        };
        let by = self.time_or("by", row.by.as_ref(), Span::from_millis(150))?;
        let kinds = [
            ("late", Kind::Late(by)),
            ("lost", Kind::Lost),
            ("garbled", Kind::Garbled),
            ("truncated", Kind::Truncated),
            ("noise", Kind::Noise(row.byte.unwrap_or(0))),
            ("echo", Kind::Echo(row.by.as_ref().map_or(Span::ZERO, |_| by))),
            ("doubled", Kind::Doubled(row.by.as_ref().map(|_| by))),
            ("foreign", Kind::Foreign),
            ("exception", Kind::Exception(row.byte.unwrap_or(BUSY))),
            ("twin", Kind::Twin(row.by.as_ref().map_or(TWIN_PAUSE, |_| by))),
            ("hang-up", Kind::HangsUp(Parting::Closed)),
            ("reset", Kind::HangsUp(Parting::Reset)),
            ("stuck", Kind::Stuck(by)),
        ];
        let kind = self.word("kind", &row.kind, &kinds)?;
        if let Some(by) = row.by.as_ref().filter(|_| {
            !matches!(kind, Kind::Late(_) | Kind::Echo(_) | Kind::Doubled(_) | Kind::Twin(_) | Kind::Stuck(_))
        }) {
            let message = both!(
                "by goes only with kind = \"late\", \"echo\", \"doubled\", \"twin\", \"stuck\" or \"babble\"",
                "by gehört nur zu kind = \"late\", \"echo\", \"doubled\", \"twin\", \"stuck\" oder \"babble\""
            );
            return Err(self.error(by.span(), message));
        }
        if row.byte.is_some() && !matches!(kind, Kind::Noise(_) | Kind::Exception(_)) {
            let message = both!(
                "byte goes only with kind = \"noise\" or \"exception\"",
                "byte gehört nur zu kind = \"noise\" oder \"exception\""
            );
            return Err(self.error(table.span(), message));
        }
        let words = [&row.pattern, &row.lasts, &row.parity, &row.reply_delay];
        let spans = words.into_iter().flatten().map(Spanned::span).chain(row.baud.as_ref().map(Spanned::span));
        if let Some(got) = spans.into_iter().next() {
            let message = both!(
                "pattern, for, baud, parity and reply_delay go only with kind = \"babble\"",
                "pattern, for, baud, parity und reply_delay gehören nur zu kind = \"babble\""
            );
            return Err(self.error(got, message));
        }
        let station = row.address.as_ref().map(|got| self.station(got)).transpose()?;
        Ok(Rule::new(when, kind, station))
    }
}

/// The drive is busy: exception 6 (V1.1b3 7).
const BUSY: u8 = 6;
/// A second drive answers so long after the first, as one does that is set the same and a little slower.
const TWIN_PAUSE: Span = Span::from_millis(5);
/// An adapter with a wrong rate delivers a byte every 20 ms (docs/open-points.md).
const BABBLE_PAUSE: Span = Span::from_millis(20);
/// Longest pattern of bytes.
const MOST_PATTERN: usize = 256;

/// Reads `random`, `digits`, `master`, `55 AA`.
fn pattern(text: &str, spoken: Spoken) -> Option<Pattern> {
    match text {
        "random" => return Some(Pattern::Random),
        "digits" => return Some(Pattern::Digits),
        "master" => return Some(Pattern::Master(spoken)),
        _ => {}
    }
    let byte = |word: &str| u8::from_str_radix(word, 16).ok().filter(|_| word.len() == 2);
    let bytes: Vec<u8> = text.split_whitespace().map(byte).collect::<Option<_>>()?;
    (1..=MOST_PATTERN).contains(&bytes.len()).then_some(Pattern::Bytes(bytes))
}
