//! How far a search for settings is, in words.

use crate::outcome::{Decimal, SearchNews};
use crate::text::{Text, both};

/// Before anything is asked: how much there is to do.
pub(super) fn begun(news: &SearchNews) -> Text {
    let (settings, rounds, left, most) = (news.settings, news.rounds, time(news.left_s), time(news.at_most_s));
    let (port, rounds) = (port(news), Text::count(rounds as u64, ["round", "rounds"], ["Runde", "Runden"]));
    both!(
        "{port}{settings} settings, the likeliest first, in {rounds}: about {left}, at most {most}; Ctrl-C ends it and shows what was \
         found",
        "{port}{settings} Einstellungen, die wahrscheinlichsten zuerst, in {rounds}: etwa {left}, höchstens {most}; Strg-C beendet sie \
         und zeigt das Gefundene",
        rounds
    )
}

/// After a setting, on a line of 80 columns: its number, the round, what was asked, who was there.
pub(super) fn told(news: &SearchNews) -> Text {
    let SearchNews { setting, settings, round, rounds, line, protocol, asked_here, found, .. } = news;
    let (port, left) = (port(news), time(news.left_s));
    let count = news.found_here.len() as u64;
    let here = match (count, news.garbled) {
        (0, true) => Text::new("garbage", "Unlesbares"),
        (0, false) => Text::new("nobody", "niemand"),
        _ => Text::count(count, ["drive", "drives"], ["Antrieb", "Antriebe"]),
    };
    both!(
        "{port}{setting}/{settings}, round {round}/{rounds}: {line} {protocol}, {asked_here}: {here}; found {found}, about {left} left",
        "{port}{setting}/{settings}, Runde {round}/{rounds}: {line} {protocol}, {asked_here}: {here}; gefunden {found}, noch {left}",
        here
    )
}

/// Beside a bar, on a line of 80 columns.
pub(super) fn short(news: &SearchNews) -> Text {
    let SearchNews { setting, settings, round, rounds, line, protocol, found, .. } = news;
    let left = time(news.left_s);
    both!(
        "{setting}/{settings}, round {round}/{rounds}, {line} {protocol}, found {found}, about {left} left",
        "{setting}/{settings}, Runde {round}/{rounds}, {line} {protocol}, gefunden {found}, noch {left}"
    )
}

fn port(news: &SearchNews) -> String {
    if news.is_named { format!("{}: ", news.port) } else { String::new() }
}

/// As exactly as an estimate is meant: seconds below a minute, tens of them above.
fn time(span: Decimal) -> String {
    let seconds = span.raw.unsigned_abs().div_ceil(10u64.pow(span.decimals.into()));
    let seconds = if seconds < 60 { seconds } else { seconds.next_multiple_of(10) };
    match (seconds / 60, seconds % 60) {
        (0, seconds) => format!("{seconds} s"),
        (minutes, 0) => format!("{minutes} min"),
        (minutes, seconds) => format!("{minutes} min {seconds} s"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_told_as_exactly_as_they_are_meant() {
        let told = |raw| time(Decimal { raw, decimals: 1 });
        assert_eq!(
            [0, 1, 594, 600, 601, 4_999].map(told),
            ["0 s", "1 s", "1 min", "1 min", "1 min 10 s", "8 min 20 s"]
        );
    }
}
