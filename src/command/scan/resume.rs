//! What a search has asked, as it is written, and going on from there.

use crate::args::{Settings, parse_addresses};
use crate::drive::{Asked, Port};
use crate::failure::{Class, Failure};
use crate::files;
use crate::outcome::{Scan, Search};
use crate::profile::stumbled_json;
use crate::text::{Text, both};
use serde::Deserialize;
use std::collections::BTreeSet;
use std::path::Path;

/// The document of an earlier scan, as far as it matters here.
#[derive(Deserialize)]
struct Saved {
    schema: u32,
    command: String,
    data: Option<Scan>,
}

/// Reads the result of an earlier scan of these ports.
pub(super) fn earlier(path: &Path, ports: &[Port]) -> Result<Scan, Failure> {
    let shown = path.display();
    let bad = |why: Text| {
        Failure::new(Class::Data, "data.resume", both!("{shown}: {why}", "{shown}: {why}", why)).hint(both!(
            "expected what `antrieb scan --json > RESULT.json` has written",
            "erwartet wird, was `antrieb scan --json > RESULT.json` geschrieben hat"
        ))
    };
    let text = files::read(path, files::TEXT).map_err(|error| bad(error.text()))?;
    let document: Saved = serde_json::from_str(&text)
        .map_err(|error| stumbled_json(&error))
        .map_err(|why| bad(both!("no result of a scan: {why}", "kein Ergebnis einer Suche: {why}", why)))?;
    let version = crate::outcome::SCHEMA_VERSION;
    if document.schema != version {
        return Err(bad(both!(
            "schema {got}; expected {version}",
            "Schema {got}; erwartet: {version}",
            got = document.schema
        )));
    }
    if document.command != "scan" {
        return Err(bad(both!(
            "the result of `{verb}`; expected that of `scan`",
            "das Ergebnis von `{verb}`; erwartet: das von `scan`",
            verb = document.command
        )));
    }
    let scan = document.data.ok_or_else(|| {
        bad(both!("it holds no data; nothing was asked", "es enthält keine Daten; es wurde nichts gefragt"))
    })?;
    let names: Vec<String> = ports.iter().map(ToString::to_string).collect();
    if !scan.searches.iter().any(|search| names.contains(&search.port)) {
        return Err(bad(both!(
            "a search of {port}; expected one of {ports}",
            "eine Suche an {port}; erwartet: eine an {ports}",
            port = scan.port,
            ports = names.join(", ")
        )));
    }
    for search in &scan.searches {
        asked_at(search).map_err(|failure| bad(failure.message))?;
    }
    Ok(scan)
}

/// What an earlier search has left open at other settings must be sought again, or this one would call it done.
pub(super) fn goes_on(before: &Scan, settings: &Settings) -> Result<(), Failure> {
    let (now, spoken) = (settings.line.to_string(), settings.protocol.name());
    let (baud, parity) = halves(&now);
    let open = before.searches.iter().filter(|search| !search.complete);
    let of_open = |is_another: &dyn Fn(&Search) -> bool| open.clone().any(is_another);
    let other_baud = of_open(&|search| halves(&search.line).0 != baud);
    let other_parity = of_open(&|search| halves(&search.line).1 != parity);
    let missing = [
        (other_baud && !settings.unknown.baud, "--baud auto"),
        (other_parity && !settings.unknown.parity, "--parity auto"),
        (of_open(&|search| search.protocol != spoken) && !settings.unknown.protocol, "--protocol auto"),
    ];
    let missing: Vec<_> = missing.iter().filter(|row| row.0).map(|row| row.1).collect();
    if missing.is_empty() {
        return Ok(());
    }
    let text = both!(
        "that search has left open what is at other settings, and only {now}, {spoken} is to be asked now",
        "jene Suche hat offen gelassen, was mit anderen Einstellungen da ist, und jetzt soll nur {now}, {spoken} gefragt werden"
    );
    let hint = both!("repeat {missing}", "{missing} wiederholen", missing = missing.join(" "));
    Err(Failure::new(Class::Usage, "usage.resume", text).hint(hint))
}

/// Baud rate and parity of a line such as `19200 8E1`; how many bits there are follows from the protocol.
fn halves(line: &str) -> (&str, Option<char>) {
    let (baud, form) = line.split_once(' ').unwrap_or((line, ""));
    (baud, form.chars().nth(1))
}

/// What was asked of a port before.
pub(super) fn asked_before(scan: &Scan, port: &str) -> Result<Vec<Asked>, Failure> {
    let of_port = scan.searches.iter().filter(|search| search.port == port);
    let asked = of_port.map(|search| {
        let place = (&search.port, &search.line, &search.protocol);
        Ok(Asked {
            line: search.line.clone(),
            protocol: search.protocol.clone(),
            addresses: asked_at(search)?,
            found: scan.drives.iter().any(|drive| (&drive.port, &drive.line, &drive.protocol) == place),
        })
    });
    asked.collect()
}

fn asked_at(search: &Search) -> Result<BTreeSet<u8>, Failure> {
    if search.asked.is_empty() {
        return Ok(BTreeSet::new());
    }
    Ok(parse_addresses(&search.asked, &[])?.into_iter().collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drive::ranges;

    #[test]
    fn addresses_are_written_as_they_are_read() {
        let set: BTreeSet<u8> = [1, 2, 3, 17, 246, 247, 255].into();
        assert_eq!(ranges(&set), "1-3,17,246-247,255");
        assert_eq!(ranges(&BTreeSet::new()), "");
        let few: BTreeSet<u8> = [1, 2, 9].into();
        assert_eq!(parse_addresses(&ranges(&few), &[]).unwrap(), [1, 2, 9]);
    }
}
