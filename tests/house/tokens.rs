//! The words of a source file: comments, texts and everything behind `#[cfg(test)]` left out.

/// An identifier, `::`, or one other character.
pub(crate) type Token = String;

/// All words of `text` that the shipped program is made of.
pub(crate) fn code(text: &str) -> Vec<Token> {
    without_inline(without_tests(&split(text)))
}

/// Modules inside a file are that file: what they call `super` is the file itself, or what lies around it.
fn without_inline(tokens: Vec<Token>) -> Vec<Token> {
    let (mut kept, mut braces, mut inline): (Vec<Token>, usize, Vec<usize>) = (Vec::new(), 0, Vec::new());
    let mut supers = 0;
    for (at, token) in tokens.iter().enumerate() {
        match token.as_str() {
            "{" => {
                braces += 1;
                if at >= 2 && tokens[at - 2] == "mod" {
                    inline.push(braces);
                }
            }
            "}" => {
                inline.pop_if(|depth| *depth == braces);
                braces = braces.saturating_sub(1);
            }
            _ => {}
        }
        supers = match token.as_str() {
            "super" => supers + 1,
            "::" => supers,
            _ => 0,
        };
        let replaced = token == "super" && supers <= inline.len();
        if token == "super" && supers > 1 && supers <= inline.len() + 1 {
            // What stands before it said `self ::` already.
            kept.truncate(kept.len().saturating_sub(2));
        }
        kept.push(if replaced { "self".to_owned() } else { token.clone() });
    }
    kept
}

fn split(text: &str) -> Vec<Token> {
    let chars: Vec<char> = text.chars().collect();
    let mut tokens = Vec::new();
    let mut at = 0;
    while let Some(&c) = chars.get(at) {
        let next = chars.get(at + 1).copied().unwrap_or(' ');
        if c == '/' && next == '/' {
            at += chars[at..].iter().position(|&c| c == '\n').unwrap_or(chars.len() - at);
        } else if c == '/' && next == '*' {
            at = behind_comment(&chars, at + 2);
        } else if let Some(hashes) = raw_text(&chars[at..]) {
            at = behind_raw(&chars, at, hashes);
        } else if c == '"' {
            at = behind_quoted(&chars, at + 1, '"');
        } else if c == '\'' && (next == '\\' || chars.get(at + 2) == Some(&'\'')) {
            at = behind_quoted(&chars, at + 1, '\'');
        } else if c == '\'' {
            at += 1 + word(&chars[at + 1..]);
        } else if c.is_alphanumeric() || c == '_' {
            let length = word(&chars[at..]);
            tokens.push(chars[at..at + length].iter().collect());
            at += length;
        } else if c == ':' && next == ':' {
            tokens.push("::".to_owned());
            at += 2;
        } else {
            if !c.is_whitespace() {
                tokens.push(c.to_string());
            }
            at += 1;
        }
    }
    tokens
}

fn word(chars: &[char]) -> usize {
    chars.iter().take_while(|c| c.is_alphanumeric() || **c == '_').count()
}

/// The number of `#` of a raw text that begins here.
fn raw_text(chars: &[char]) -> Option<usize> {
    let letters = chars.iter().take_while(|c| matches!(c, 'b' | 'c' | 'r')).count();
    let rest = chars.get(letters..)?;
    let hashes = rest.iter().take_while(|&&c| c == '#').count();
    (letters > 0 && chars.get(letters - 1) == Some(&'r') && rest.get(hashes) == Some(&'"')).then_some(hashes)
}

fn behind_raw(chars: &[char], at: usize, hashes: usize) -> usize {
    let begin = at + chars[at..].iter().position(|&c| c == '"').unwrap() + 1;
    let ends = |place: &usize| chars[*place] == '"' && chars[place + 1..].iter().take(hashes).all(|&c| c == '#');
    (begin..chars.len()).find(ends).map_or(chars.len(), |place| place + 1 + hashes)
}

fn behind_quoted(chars: &[char], mut at: usize, end: char) -> usize {
    while at < chars.len() && chars[at] != end {
        at += if chars[at] == '\\' { 2 } else { 1 };
    }
    at + 1
}

fn behind_comment(chars: &[char], mut at: usize) -> usize {
    let mut depth = 1;
    while at < chars.len() && depth > 0 {
        match (chars[at], chars.get(at + 1)) {
            ('/', Some('*')) => (depth, at) = (depth + 1, at + 2),
            ('*', Some('/')) => (depth, at) = (depth - 1, at + 2),
            _ => at += 1,
        }
    }
    at
}

/// Leaves out every item behind `#[cfg(test)]`.
fn without_tests(tokens: &[Token]) -> Vec<Token> {
    const MARK: [&str; 7] = ["#", "[", "cfg", "(", "test", ")", "]"];
    let mut kept = Vec::new();
    let mut at = 0;
    while at < tokens.len() {
        if tokens[at..].iter().take(MARK.len()).eq(MARK.iter()) {
            at = behind_item(tokens, at + MARK.len());
        } else {
            kept.push(tokens[at].clone());
            at += 1;
        }
    }
    kept
}

/// The place behind the item that begins at `at`: its `;`, or the end of its braces.
fn behind_item(tokens: &[Token], mut at: usize) -> usize {
    let (mut depth, mut is_import, mut in_attribute) = (0, false, false);
    while at < tokens.len() {
        match tokens[at].as_str() {
            "use" if depth == 0 => is_import = true,
            "#" if depth == 0 => in_attribute = true,
            "(" | "[" | "{" => depth += 1,
            ")" | "]" => depth -= 1,
            "}" => {
                depth -= 1;
                if depth == 0 && !is_import {
                    return at + 1;
                }
            }
            ";" if depth == 0 => return at + 1,
            _ => {}
        }
        if tokens[at] == "]" && depth == 0 {
            in_attribute = false;
        }
        // A field or a row of a table ends with its comma.
        if tokens[at] == "," && depth == 0 && !in_attribute {
            return at + 1;
        }
        at += 1;
    }
    at
}

#[test]
fn comments_texts_and_tests_say_nothing() {
    let text = "use a::b; // use c;\n/* use /* d */ e */ let x = \"use f\"; let y = r#\"use \"g\"#; let z = '\"';
        #[cfg(test)]\nmod tests { use h; }\n#[cfg(test)]\nuse i::{j, k};\nfn m<'l>() {}";
    let said = code(text).join(" ");
    assert_eq!(said, "use a :: b ; let x = ; let y = ; let z = ; fn m < > ( ) { }");
}

#[test]
fn a_module_inside_a_file_is_that_file() {
    let text = "mod a { use super::b; use super::super::c; mod d { use super::super::super::e; } } use super::f;";
    let said = code(text).join(" ");
    let inner = "mod d { use super :: e ; }";
    assert_eq!(said, format!("mod a {{ use self :: b ; use super :: c ; {inner} }} use super :: f ;"));
}
