//! What Slave_Diag, Set_Prm, Chk_Cfg, Get_Cfg and Global_Control carry, in words.

use super::super::{field, field16};
use super::{Said, bytes_of, words};
use crate::outcome::Field;
use crate::protocol::dp::cfg::{Extent, Identifier, Layout, identifiers};
use crate::protocol::dp::diagnosis::{Block, Diagnosis, FLAGS, NOBODY};
use crate::protocol::dp::{Parameters, prm};
use crate::text::{Text, both};

/// The answer to Slave_Diag; `None` if it is too short.
pub(super) fn diagnosis(data: &[u8]) -> Option<Said> {
    let found = Diagnosis::decode(data)?;
    let master = match found.master {
        NOBODY => both!("no master has parameterised it", "kein Master hat sie parametriert"),
        master => both!("master {master}", "Master {master}"),
    };
    let ident = Text::name(format_args!("{:04X}h", found.ident));
    let flags: Vec<_> = found.flags().collect();
    let flags = match flags.is_empty() {
        true => both!("nothing to report", "nichts zu melden"),
        false => Text::name(flags.join(", ")),
    };
    let blocks = found.blocks.len() as u64;
    let more = (blocks > 0).then(|| Text::count(blocks, ["block more", "blocks more"], ["Block mehr", "Blöcke mehr"]));
    let ident_is = both!("ident {ident}", "Ident {ident}", ident);
    let meaning: Vec<_> = [flags, master.clone(), ident_is].into_iter().chain(more).collect();
    let mut fields: Vec<_> = found.status.into_iter().enumerate().map(|(nth, byte)| status(nth, byte)).collect();
    fields.push(field(&[found.master], both!("master", "Master"), master));
    fields.push(field16(found.ident, both!("ident number", "Identnummer"), ident));
    fields.extend(found.blocks.iter().map(block));
    Some((Text::join(&meaning, "; "), fields))
}

/// One of the three status bytes, with every bit that is set.
fn status(nth: usize, byte: u8) -> Field {
    let is_set = |row: &&(usize, u8, &str)| row.0 == nth && byte & (1 << row.1) != 0;
    let told: Vec<_> = FLAGS.iter().filter(is_set).map(|row| words::flag(row.2)).collect();
    let value = if told.is_empty() { Text::name("-") } else { Text::join(&told, "; ") };
    let number = nth + 1;
    field(&[byte], both!("station status {number}", "Stationsstatus {number}"), value)
}

fn block(block: &Block) -> Field {
    let bytes = block.bytes();
    match block {
        Block::Device(own) => field(
            &bytes,
            both!("of the device", "gerätebezogen"),
            both!(
                "{own}; the maker alone knows the layout",
                "{own}; den Aufbau kennt nur der Hersteller",
                own = { bytes_of(own.get(1..).unwrap_or_default()) }
            ),
        ),
        Block::Identifier(own) => {
            let marked = own.iter().skip(1).enumerate().flat_map(|(nth, byte)| {
                (0..8).filter(move |bit| byte & (1 << bit) != 0).map(move |bit| (nth * 8 + bit).to_string())
            });
            let marked = marked.collect::<Vec<_>>().join(", ");
            field(
                &bytes,
                both!("of identifiers", "kennungsbezogen"),
                both!("identifiers {marked}", "Kennungen {marked}"),
            )
        }
        Block::Channel([header, channel, kind]) => {
            let (identifier, number) = (header & 0x3F, channel & 0x3F);
            let (width, error) = (kind >> 5, kind & 0x1F);
            field(
                &bytes,
                both!("of a channel", "kanalbezogen"),
                both!(
                    "identifier {identifier}, channel {number}, type {width}, error {error}",
                    "Kennung {identifier}, Kanal {number}, Typ {width}, Fehler {error}"
                ),
            )
        }
        Block::Rest(own) => field(&bytes, both!("no block", "kein Block"), bytes_of(own)),
    }
}

/// Set_Prm; `None` if it is too short.
pub(super) fn parameters(data: &[u8]) -> Option<Said> {
    let said = Parameters::decode(data)?;
    let rows = [
        (prm::LOCK, "Lock_Req"),
        (prm::UNLOCK, "Unlock_Req"),
        (prm::SYNC, "Sync_Req"),
        (prm::FREEZE, "Freeze_Req"),
        (prm::WATCHDOG, "WD_On"),
    ];
    let flags = rows.iter().filter(|row| said.status & row.0 != 0).map(|row| row.1).collect::<Vec<_>>().join(", ");
    let watchdog = match said.watchdog_time() {
        Some(time) => both!("watchdog {time}", "Überwachungszeit {time}"),
        None => both!("no watchdog", "keine Überwachung"),
    };
    let ident = Text::name(format_args!("{:04X}h", said.ident));
    let mut meaning =
        vec![Text::name(&flags), watchdog.clone(), both!("ident {ident}", "Ident {ident}", ident = ident.clone())];
    let (tsdr, groups) = (said.min_tsdr, said.groups);
    let mut fields = vec![
        field(&[said.status], both!("station status", "Stationsstatus"), Text::name(&flags)),
        field(&said.watchdog, both!("watchdog factors", "Faktoren der Überwachung"), watchdog),
        field(
            &[tsdr],
            both!("least pause before an answer", "kleinste Pause vor einer Antwort"),
            both!("{tsdr} bit times", "{tsdr} Bitzeiten"),
        ),
        field16(said.ident, both!("ident number", "Identnummer"), ident),
        field(&[groups], both!("groups", "Gruppen"), Text::name(format_args!("{groups:08b}"))),
    ];
    if !said.user.is_empty() {
        let own = bytes_of(&said.user);
        meaning.push(both!("{own} of the GSD", "{own} der GSD", own));
        fields.push(field(&said.user, both!("as the GSD asks", "wie es die GSD verlangt"), bytes_of(&said.user)));
    }
    Some((Text::join(&meaning, "; "), fields))
}

/// Chk_Cfg, or the answer to Get_Cfg.
pub(super) fn configuration(data: &[u8]) -> Said {
    let all = identifiers(data);
    let known = Layout::of("", data).map(|layout| match layout {
        Layout::Basic => both!("Basic block of an SJ2-PB", "Basic-Block eines SJ2-PB"),
        Layout::Ppo(number) => both!("PPO{number} of an SJ2-PB", "PPO{number} eines SJ2-PB"),
    });
    let count = Text::count(all.len() as u64, ["identifier", "identifiers"], ["Kennung", "Kennungen"]);
    let total =
        |pick: fn(&Identifier) -> Option<Extent>| -> usize { all.iter().filter_map(pick).map(Extent::bytes).sum() };
    let (inputs, outputs) = (total(|one| one.inputs), total(|one| one.outputs));
    let sizes = both!("{inputs} bytes in, {outputs} bytes out", "{inputs} Bytes Eingänge, {outputs} Bytes Ausgänge");
    let meaning: Vec<_> = [count, sizes].into_iter().chain(known).collect();
    let fields = all.iter().map(|one| field(&one.bytes, both!("identifier", "Kennung"), identifier(one)));
    (Text::join(&meaning, "; "), fields.collect())
}

/// How much an identifier carries, and where to.
pub(super) fn identifier(one: &Identifier) -> Text {
    let extent = |extent: Extent, en: &str, de: &str| {
        let Extent { count, is_words, is_consistent } = extent;
        let units = match is_words {
            true => Text::count(count.into(), ["word", "words"], ["Wort", "Wörter"]),
            false => Text::count(count.into(), ["byte", "bytes"], ["Byte", "Bytes"]),
        };
        let whole = if is_consistent { both!(", consistent", ", konsistent") } else { Text::default() };
        both!("{units} {en}{whole}", "{units} {de}{whole}", units, whole)
    };
    let inputs = one.inputs.map(|inputs| extent(inputs, "in", "ein"));
    let outputs = one.outputs.map(|outputs| extent(outputs, "out", "aus"));
    let told: Vec<_> = inputs.into_iter().chain(outputs).collect();
    if told.is_empty() { both!("nothing", "nichts") } else { Text::join(&told, "; ") }
}

/// Global_Control; `None` if it is too short.
pub(super) fn global(data: &[u8]) -> Option<Said> {
    let &[command, group, ref rest @ ..] = data else { return None };
    let rows = [(0x02, "Clear"), (0x04, "Unfreeze"), (0x08, "Freeze"), (0x10, "Unsync"), (0x20, "Sync")];
    let told = rows.iter().filter(|row| command & row.0 != 0).map(|row| row.1).collect::<Vec<_>>().join(", ");
    let told = if told.is_empty() { Text::name("Operate") } else { Text::name(told) };
    let groups = match group {
        0 => both!("every group", "alle Gruppen"),
        group => both!("groups {groups}", "Gruppen {groups}", groups = Text::name(format_args!("{group:08b}"))),
    };
    let mut fields = vec![
        field(&[command], both!("command", "Befehl"), told.clone()),
        field(&[group], both!("groups", "Gruppen"), groups.clone()),
    ];
    fields.extend(super::raw(rest));
    Some((Text::join([&told, &groups], "; "), fields))
}
