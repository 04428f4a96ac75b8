//! A plan as an SVG: the drives as boxes, every virtual link as a line from source to parameter; black on white, for print.

use super::plan::{Drive, Plan, Trigger};
use super::relations::{Link, links, relations};
use crate::profile::Family;
use crate::text::{Lang, both};
use std::fmt::Write;

/// In units of the picture.
const WIDTH: u32 = 1000;
const MARGIN: u32 = 30;
const LINE: u32 = 20;
/// Columns: sender, PDO, receiver.
const SENDER: u32 = 30;
const PDO: u32 = 370;
const RECEIVER: u32 = 640;

/// The picture, as the text of an SVG file.
pub fn picture(plan: &Plan, family: &Family, lang: Lang) -> String {
    let (mut body, mut y) = (String::new(), MARGIN);
    let rate = plan.rate.kbd();
    let title = both!("System bus, {rate} kBd", "Systembus, {rate} kBd");
    text(&mut body, SENDER, y, " font-size=\"18\" font-weight=\"bold\"", title.get(lang));
    y += LINE + LINE / 2;
    for drive in &plan.drives {
        text(&mut body, SENDER, y, "", &of_a_drive(drive, lang));
        y += LINE;
    }
    let links = links(plan);
    for relation in relations(plan) {
        y += LINE;
        let when = match relation.trigger {
            Some(Trigger::Time(ms)) => format!(", {ms} ms"),
            Some(Trigger::Sync) => ", SYNC".to_owned(),
            None => String::new(),
        };
        let load = relation.load.map_or_else(String::new, |load| format!(", {load} %"));
        let own: Vec<&Link<'_>> = links.iter().filter(|link| link.identifier == relation.identifier).collect();
        let rows = (own.len().max(relation.receivers.len()).max(1) as u32) + 1;
        let (top, height) = (y, rows * LINE + LINE / 2);
        for (x, width) in [(SENDER, 300), (PDO, 210), (RECEIVER, 330)] {
            let _infallible = writeln!(
                body,
                "<rect x=\"{x}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" fill=\"none\" stroke=\"#000\"/>"
            );
        }
        y += LINE - 4;
        let pdo = relation.tx.map_or_else(String::new, |tx| format!(" TxPDO{}", tx.number.number()));
        let bold = " font-weight=\"bold\"";
        let nobody = both!("nobody", "niemand");
        let sender = relation.sender.unwrap_or(nobody.get(lang));
        text(&mut body, SENDER + 8, y, bold, &format!("{sender}{pdo}"));
        text(&mut body, PDO + 8, y, bold, &format!("{}{when}{load}", relation.identifier));
        let receivers: Vec<String> =
            relation.receivers.iter().map(|one| format!("{} RxPDO{}", one.drive, one.rx.number.number())).collect();
        text(&mut body, RECEIVER + 8, y, bold, &receivers.join(", "));
        for link in own {
            y += LINE;
            row(&mut body, y, link, family, lang);
        }
        y = top + height;
    }
    let height = y + MARGIN;
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\" width=\"277mm\" lang=\"{lang}\" role=\"img\" \
         font-family=\"sans-serif\" font-size=\"13\" fill=\"#000\">\n<title>{title}</title>\n\
         <rect width=\"{WIDTH}\" height=\"{height}\" fill=\"#fff\"/>\n{body}</svg>\n",
        lang = lang.pick("en", "de"),
        title = title.get(lang),
    )
}

fn of_a_drive(drive: &Drive, lang: Lang) -> String {
    let (name, node) = (&drive.name, drive.node);
    let told = match node {
        0 => both!("{name}: node 0, master", "{name}: Knoten 0, Master"),
        _ => both!("{name}: node {node}", "{name}: Knoten {node}"),
    };
    told.get(lang).to_owned()
}

/// A virtual link: source -> bytes -> parameter.
fn row(out: &mut String, y: u32, link: &Link<'_>, family: &Family, lang: Lang) {
    if let Some((param, source)) = link.input {
        let name = family.param(param).and_then(|row| family.text_of(row, source.into()));
        let name = name.map_or("", |name| name.get(lang));
        text(out, SENDER + 8, y, "", &format!("P.{param} = {source} {name}"));
        arrow(out, SENDER + 300, PDO, y - 4);
    }
    let bytes = link.place.bytes();
    text(out, PDO + 8, y, "", &format!("{} (Byte {}-{})", link.place, bytes.start, bytes.end - 1));
    if let Some((param, source)) = link.output {
        let name = family.param(param).map_or("", |row| row.name.get(lang));
        let whose = link.receiver.unwrap_or_default();
        text(out, RECEIVER + 8, y, "", &format!("{whose}: P.{param} = {source} {name}"));
        arrow(out, PDO + 210, RECEIVER, y - 4);
    }
}

fn arrow(out: &mut String, from: u32, to: u32, y: u32) {
    let head = to - 7;
    let _infallible = writeln!(
        out,
        "<path d=\"M{from} {y}H{to}M{head} {}L{to} {y}L{head} {}\" fill=\"none\" stroke=\"#000\"/>",
        y - 4,
        y + 4
    );
}

fn text(out: &mut String, x: u32, y: u32, style: &str, words: &str) {
    let words = words.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    let printable: String = words.chars().filter(|letter| !letter.is_control()).collect();
    let _infallible = writeln!(out, "<text x=\"{x}\" y=\"{y}\"{style}>{printable}</text>");
}
