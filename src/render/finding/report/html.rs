//! Paper as one page of HTML that prints on A4. Nothing is loaded from anywhere, and the page forbids it.

use super::paper::{Block, Cell, Paper, Table};
use crate::outcome::Logo;
use crate::render::clean;
use std::fmt::Write;

pub(super) fn print(paper: &Paper) -> String {
    let mut body = String::new();
    for block in &paper.blocks {
        print_block(&mut body, block);
    }
    let logo = paper
        .logo
        .as_ref()
        .map_or_else(String::new, |logo| format!("<img class=\"logo\" src=\"{}\" alt=\"\">\n", data(logo)));
    format!(
        "<!DOCTYPE html>\n<html lang=\"{lang}\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src 'unsafe-inline'\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{title}</title>\n\
         <style>\n{STYLE}</style>\n</head>\n<body>\n<header>\n<h1>{title}</h1>\n{logo}</header>\n<main>\n{body}</main>\n\
         <footer>{foot}</footer>\n</body>\n</html>\n",
        lang = paper.lang,
        title = escaped(&paper.title),
        foot = escaped(&paper.foot),
    )
}

const STYLE: &str = include_str!("page.css");

fn print_block(out: &mut String, block: &Block) {
    let _infallible = match block {
        Block::Heading(level, text) => {
            writeln!(out, "<h{level}>{text}</h{level}>", level = level + 1, text = escaped(text))
        }
        Block::Text(text) => writeln!(out, "<p>{}</p>", escaped(text)),
        Block::Alarm(text) => writeln!(out, "<p class=\"alarm\">{}</p>", escaped(text)),
        Block::List(items) => {
            let items: String = items.iter().map(|item| format!("<li>{}</li>\n", escaped(item))).collect();
            writeln!(out, "<ul>\n{items}</ul>")
        }
        Block::Facts(facts) => {
            let row = |(name, text): &(String, String)| {
                format!("<tr><th scope=\"row\">{}</th><td>{}</td></tr>\n", escaped(name), escaped(text))
            };
            writeln!(
                out,
                "<table class=\"facts\">\n<tbody>\n{}</tbody>\n</table>",
                facts.iter().map(row).collect::<String>()
            )
        }
        Block::Table(table) => writeln!(out, "{}", print_table(table)),
        // What is drawn is our own, and escapes what it names.
        Block::Picture(picture, what) => {
            writeln!(out, "<figure>\n{picture}<figcaption>{}</figcaption>\n</figure>", escaped(what))
        }
        Block::Lines(lines) => {
            let row = |cells: &[String; 3]| {
                let cells: String = cells.iter().map(|cell| format!("<td>{}</td>", escaped(cell))).collect();
                format!("<tr>{cells}</tr>\n")
            };
            writeln!(
                out,
                "<table class=\"lines\">\n<tbody>\n{}</tbody>\n</table>",
                lines.iter().map(row).collect::<String>()
            )
        }
    };
}

fn print_table(table: &Table) -> String {
    let class = |is_right: bool| if is_right { " class=\"r\"" } else { "" };
    let head =
        |(name, is_right): &(String, bool)| format!("<th scope=\"col\"{}>{}</th>", class(*is_right), escaped(name));
    let row = |cells: &Vec<Cell>| {
        let (mut column, mut row) = (0, String::new());
        for cell in cells {
            let span = if cell.span > 1 { format!(" colspan=\"{}\"", cell.span) } else { String::new() };
            let is_right = table.head.get(column).is_some_and(|head| head.1);
            let text = escaped(&cell.text);
            let text = if cell.is_marked { format!("<strong>{text}</strong>") } else { text };
            row += &format!("<td{span}{}>{text}</td>", class(is_right));
            column += cell.span;
        }
        format!("<tr>{row}</tr>\n")
    };
    format!(
        "<table>\n<thead>\n<tr>{}</tr>\n</thead>\n<tbody>\n{}</tbody>\n</table>",
        table.head.iter().map(head).collect::<String>(),
        table.rows.iter().map(row).collect::<String>()
    )
}

/// A picture as a part of the page: in an image nothing runs, and nothing is loaded.
pub(super) fn data(logo: &Logo) -> String {
    format!("data:{};base64,{}", logo.kind, base64(&logo.bytes))
}

/// RFC 4648, 4.
fn base64(bytes: &[u8]) -> String {
    const SIGNS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for group in bytes.chunks(3) {
        let byte = |nth: usize| u32::from(group.get(nth).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for nth in 0..4 {
            let sign = SIGNS.get((bits >> (18 - 6 * nth) & 0x3F) as usize).copied().unwrap_or(b'=');
            text.push(if nth > group.len() { '=' } else { sign.into() });
        }
    }
    text
}

/// What a device or a file is called is no markup.
fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for letter in clean(text).chars() {
        match letter {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            letter => safe.push(letter),
        }
    }
    safe
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_becomes_text_by_the_examples_of_rfc_4648() {
        for (bytes, text) in [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("fooba", "Zm9vYmE="),
            ("foobar", "Zm9vYmFy"),
        ] {
            assert_eq!(base64(bytes.as_bytes()), text);
        }
    }

    #[test]
    fn a_name_is_no_markup() {
        assert_eq!(
            escaped("<b a=\"1\">&\u{1b}\u{202e}</b>"),
            "&lt;b a=&quot;1&quot;&gt;&amp;\\u{1b}\\u{202e}&lt;/b&gt;"
        );
    }
}
