//! A text with its mutants in it, asleep.

use crate::found::{Change, Mutant};

/// Where mutants are: an expression of which there are some, or a place in the text.
struct Spot<'a> {
    from: usize,
    to: usize,
    /// With their numbers.
    mutants: Vec<(usize, &'a Mutant)>,
}

/// Puts the mutants into a text, numbered from `first`, but those that are left out. Tells for each where it stands in the new text: its
/// own words, or what it is in.
pub fn planted(
    text: &str,
    mutants: &[Mutant],
    first: usize,
    is_left_out: impl Fn(usize) -> bool,
) -> (String, Vec<Vec<[usize; 2]>>) {
    let mut spots: Vec<Spot> = Vec::new();
    for (nth, mutant) in mutants.iter().enumerate().filter(|(nth, _)| !is_left_out(*nth)) {
        let is_its = |spot: &&mut Spot| {
            let same = |a: &Change, b: &Change| std::mem::discriminant(a) == std::mem::discriminant(b);
            (spot.from, spot.to) == (mutant.from, mutant.to) && same(&spot.mutants[0].1.change, &mutant.change)
        };
        match spots.iter_mut().find(is_its) {
            Some(spot) => spot.mutants.push((nth, mutant)),
            None => spots.push(Spot { from: mutant.from, to: mutant.to, mutants: vec![(nth, mutant)] }),
        }
    }
    // A place before what begins there, the outer before the inner, and the guard before the expression that it is.
    let is_instead = |spot: &Spot| matches!(spot.mutants[0].1.change, Change::Instead(_));
    spots.sort_by_key(|spot| (spot.from, spot.to != spot.from, std::cmp::Reverse(spot.to), is_instead(spot)));
    let mut writer = Writer { text, first, new: String::new(), places: vec![Vec::new(); mutants.len()] };
    writer.write(0, text.len(), &spots);
    (writer.new, writer.places)
}

struct Writer<'a> {
    text: &'a str,
    first: usize,
    new: String,
    places: Vec<Vec<[usize; 2]>>,
}

impl Writer<'_> {
    /// Writes the text from byte to byte, with all spots that are in it.
    fn write(&mut self, from: usize, to: usize, spots: &[Spot]) {
        let (mut at, mut rest) = (from, spots);
        while let [spot, behind @ ..] = rest {
            self.new.push_str(&self.text[at..spot.from]);
            let inner = behind.iter().take_while(|other| other.from < spot.to).count();
            let begun = self.new.len();
            self.spot(spot, &behind[..inner]);
            let end = self.new.len();
            spot.mutants.iter().for_each(|(nth, _)| self.places[*nth].push([begun, end]));
            (at, rest) = (spot.to, &behind[inner..]);
        }
        self.new.push_str(&self.text[at..to]);
    }

    fn spot(&mut self, spot: &Spot, inner: &[Spot]) {
        let is_guard = matches!(spot.mutants[0].1.change, Change::Guard(_));
        let is_instead = matches!(spot.mutants[0].1.change, Change::Instead(_));
        if is_guard || is_instead {
            self.new.push('(');
        }
        for (nth, mutant) in &spot.mutants {
            let awake = format!("crate::mutant({})", self.first + nth);
            match &mutant.change {
                Change::Instead(other) => {
                    self.new.push_str(&format!("if {awake} {{ "));
                    let begun = self.new.len();
                    self.new.push_str(other);
                    self.places[*nth].push([begun, self.new.len()]);
                    self.new.push_str(" } else ");
                }
                Change::Return(plain) => self.new.push_str(&format!(" if {awake} {{ return {plain}; }} ")),
                Change::Guard(true) => self.new.push_str(&format!("{awake} || ")),
                Change::Guard(false) => self.new.push_str(&format!("!{awake} && ")),
                Change::NoArm => self.new.push_str(&format!(" if !{awake}")),
            }
        }
        if is_guard || is_instead {
            self.new.push_str(if is_instead { "{ " } else { "(" });
            self.write(spot.from, spot.to, inner);
            self.new.push_str(if is_instead { " })" } else { "))" });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::found::mutants;

    #[test]
    fn every_change_is_put_in_asleep_and_told() {
        let text = "fn f(a: u8) -> bool { match a { 1 => !b(), x if x < 2 => true, _ => false } }";
        let mutants = mutants(text).unwrap();
        let told: Vec<_> = mutants.iter().map(|mutant| (mutant.was.as_str(), mutant.becomes.as_str())).collect();
        assert_eq!(told[..2], [("f()", "{ true }"), ("f()", "{ false }")]);
        assert_eq!(told[2..5], [("1 =>", "no such arm"), ("x if x < 2", "if true"), ("x if x < 2", "if false")]);
        assert_eq!(told[5..], [("!b()", "b()"), ("x < 2", "(x) > (2)"), ("x < 2", "(x) <= (2)")]);
        let (new, places) = planted(text, &mutants, 1, |nth| nth == 1);
        let expected = "fn f(a: u8) -> bool { if crate::mutant(1) { return true; }  match a { 1 if !crate::mutant(3) => \
                        (if crate::mutant(6) { b() } else { !b() }), x if (crate::mutant(4) || !crate::mutant(5) && \
                        ((if crate::mutant(7) { (x) > (2) } else if crate::mutant(8) { (x) <= (2) } else { x < 2 }))) => true, \
                        _ => false } }";
        assert_eq!(new, expected);
        assert!(places[1].is_empty(), "what is left out stands nowhere");
        let [begun, end] = places[6][0];
        assert_eq!(&new[begun..end], "(x) > (2)");
    }

    #[test]
    fn constants_tests_and_lets_are_left_alone() {
        let text =
            "const A: u8 = 1 + 2; #[cfg(test)] mod tests { fn f() -> u8 { 1 + 2 } } const fn g() -> bool { 1 < 2 }";
        assert!(mutants(text).unwrap().is_empty());
        let text = "fn f(a: Option<u8>) { if let Some(b) = a && b < 3 { g(); } }";
        let all = mutants(text).unwrap();
        let told: Vec<_> = all.iter().map(|mutant| mutant.was.as_str()).collect();
        assert_eq!(told, ["f()", "b < 3", "b < 3"]);
    }
}
