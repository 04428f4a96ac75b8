//! What a GSD says of a slave that a master has to say to it: ident number, user parameters of Set_Prm, modules for Chk_Cfg (EN 50170-2,
//! GSD revisions 1 to 5). Everything else in it is passed over.
//!
//! The crate gsd-parser stops the program on types and references that it does not know, so this is read here.

use std::collections::BTreeMap;

/// What a GSD says.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Gsd {
    /// `Model_Name`.
    pub model: String,
    /// `Ident_Number`.
    pub ident: u16,
    /// User parameters in front of those of modules.
    pub user: Vec<u8>,
    /// Modules, in the order of the file.
    pub modules: Vec<Module>,
}

/// A module of a GSD.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Module {
    /// Its name.
    pub name: String,
    /// Its bytes in Chk_Cfg.
    pub cfg: Vec<u8>,
    /// Its user parameters.
    pub user: Vec<u8>,
}

/// A line that says what is no GSD.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: {text}")]
pub struct Broken {
    /// From 1; 0: something is missing in the whole.
    pub line: usize,
    /// What stands there, or the keyword that is missing.
    pub text: String,
}

/// User parameters of one Set_Prm (IEC 61158-6-3).
const MOST_USER: usize = 237;
const HEADER: &str = "#Profibus_DP";
/// So much of a line that makes no sense is shown.
const SHOWN: usize = 80;

/// A value that is put among the user parameters: how many bits from which, and which value.
#[derive(Clone, Copy, Debug)]
struct Field {
    bytes: usize,
    first: u32,
    bits: u32,
    value: i64,
}

/// What is read of a file so far.
#[derive(Debug, Default)]
struct Reader {
    gsd: Gsd,
    /// `User_Prm_Data` of the first revisions, which counts where there is nothing newer.
    old: Vec<u8>,
    fields: BTreeMap<i64, Field>,
    /// The definition that is being read, before its type has come.
    defines: Option<i64>,
    in_module: bool,
}

impl Gsd {
    /// Reads a GSD.
    pub fn parse(text: &str) -> Result<Self, Broken> {
        let mut reader = Reader::default();
        let mut lines = text.lines().enumerate().map(|(at, line)| (at + 1, bare(line)));
        if !lines.by_ref().any(|(_, line)| line.eq_ignore_ascii_case(HEADER)) {
            return Err(Broken { line: 0, text: HEADER.to_owned() });
        }
        while let Some((at, line)) = lines.next() {
            let mut whole = line.to_owned();
            while whole.ends_with('\\') {
                whole.pop();
                whole.truncate(whole.trim_end().len());
                whole.push_str(lines.next().map_or("", |(_, line)| line));
            }
            reader.line(&whole).ok_or_else(|| Broken { line: at, text: whole.chars().take(SHOWN).collect() })?;
        }
        let Reader { mut gsd, old, .. } = reader;
        if gsd.ident == 0 {
            return Err(Broken { line: 0, text: "Ident_Number".to_owned() });
        }
        if gsd.user.is_empty() {
            gsd.user = old;
        }
        Ok(gsd)
    }
}

impl Reader {
    /// Takes a line; `None` if it is broken.
    fn line(&mut self, line: &str) -> Option<()> {
        if let Some(id) = self.defines.filter(|_| !line.is_empty()) {
            self.defines = None;
            self.fields.extend(field(line).map(|field| (id, field)));
            return Some(());
        }
        let (key, value) = line.split_once('=').unwrap_or((line, ""));
        let (key, place) = key.split_once('(').unwrap_or((key, ""));
        let place = || number(place.trim().strip_suffix(')')?);
        let value = value.trim();
        match key.trim().to_ascii_lowercase().as_str() {
            "ident_number" => self.gsd.ident = u16::try_from(number(value)?).ok()?,
            "model_name" => self.gsd.model = quoted(value)?.0,
            "user_prm_data" => self.old = bytes(value).filter(|user| user.len() <= MOST_USER)?,
            "extuserprmdata" => self.defines = Some(number(value.split(['"', ' ', '\t']).next()?)?),
            "module" => {
                let (name, rest) = quoted(value)?;
                self.gsd.modules.push(Module { name, cfg: bytes(rest)?, user: Vec::new() });
                self.in_module = true;
            }
            "endmodule" => self.in_module = false,
            "ext_user_prm_data_const" => put(self.user(), usize::try_from(place()?).ok()?, &bytes(value)?)?,
            "ext_user_prm_data_ref" => {
                // What is of no type that is known is left to the constants.
                let field = self.fields.get(&number(value)?).copied();
                let at = usize::try_from(place()?).ok()?;
                field.map_or(Some(()), |field| field.put(self.user(), at))?;
            }
            _ => {}
        }
        Some(())
    }

    /// The user parameters that are being filled.
    fn user(&mut self) -> &mut Vec<u8> {
        let module = self.gsd.modules.last_mut().filter(|_| self.in_module);
        module.map_or(&mut self.gsd.user, |module| &mut module.user)
    }
}

impl Field {
    fn put(self, user: &mut Vec<u8>, at: usize) -> Option<()> {
        let Field { bytes, first, bits, value } = self;
        if bytes == 1 && bits < 8 {
            let mask = u8::try_from((1_u32 << bits) - 1).ok()?;
            let old = user.get(at).copied().unwrap_or_default();
            let value = u8::try_from(value).ok().filter(|value| *value <= mask)?;
            return put(user, at, &[old & !(mask << first) | value << first]);
        }
        put(user, at, value.to_be_bytes().get(8_usize.checked_sub(bytes)?..)?)
    }
}

/// Puts bytes at a place, with zeros before it where nothing stands yet.
fn put(user: &mut Vec<u8>, at: usize, bytes: &[u8]) -> Option<()> {
    let end = at.checked_add(bytes.len()).filter(|end| *end <= MOST_USER)?;
    user.resize(user.len().max(end), 0);
    user.get_mut(at..end)?.copy_from_slice(bytes);
    Some(())
}

/// A line without its comment.
fn bare(line: &str) -> &str {
    let mut is_text = false;
    let end = line.find(|letter| {
        is_text ^= letter == '"';
        letter == ';' && !is_text
    });
    line.get(..end.unwrap_or(line.len())).unwrap_or_default().trim()
}

/// A type and its usual value: `Unsigned8 3 0-7`, `BitArea(1-2) 0 0-3`.
fn field(line: &str) -> Option<Field> {
    let (kind, rest) = line.split_at(line.find(|letter: char| letter == '(' || letter.is_whitespace())?);
    let whole = |bytes: usize| Some((bytes, 0, 8, rest));
    let (bytes, first, bits, rest) = match kind.to_ascii_lowercase().as_str() {
        "unsigned8" | "signed8" => whole(1),
        "unsigned16" | "signed16" => whole(2),
        "unsigned32" | "signed32" => whole(4),
        "bit" | "bitarea" => {
            let (area, rest) = rest.strip_prefix('(')?.split_once(')')?;
            let (first, last) = area.split_once('-').unwrap_or((area, area));
            let [first, last] = [first, last].map(|bit| u32::try_from(number(bit)?).ok().filter(|bit| *bit < 8));
            Some((1, first?, (last? + 1).checked_sub(first?)?, rest))
        }
        _ => None,
    }?;
    let usual = rest.split_whitespace().next()?;
    Some(Field { bytes, first, bits, value: number(usual)? })
}

/// A text in quotation marks, and what stands behind it.
fn quoted(text: &str) -> Option<(String, &str)> {
    let (name, rest) = text.strip_prefix('"')?.split_once('"')?;
    Some((name.trim().to_owned(), rest))
}

/// Bytes that commas part.
fn bytes(text: &str) -> Option<Vec<u8>> {
    let numbers = text.split(',').map(str::trim).filter(|number| !number.is_empty());
    numbers.map(|text| u8::try_from(number(text)?).ok()).collect()
}

fn number(text: &str) -> Option<i64> {
    let text = text.trim();
    match text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")) {
        Some(digits) => i64::from_str_radix(digits, 16).ok(),
        None => text.parse().ok(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "; a slave that is in no source\n#Profibus_DP\nGSD_Revision=3\nModel_Name = \"SOME; DRIVE\" ; its name\n\
        Ident_Number=0x1337\nUser_Prm_Data = \\\n 0x01, 0x02\nPrmText=1\nText(0)=\"off\"\nEndPrmText\n\
        ExtUserPrmData=1 \"bit\"\nBit(0) 1 0-1\nEndExtUserPrmData\nExtUserPrmData = 2 \"two\"\nBitArea(1-2) 2 0-3\nEndExtUserPrmData\n\
        ExtUserPrmData=3 \"word\"\nUnsigned16 0x07D0 0-10000\nEndExtUserPrmData\nExtUserPrmData=4 \"other\"\nFloat32 1.5\nEndExtUserPrmData\n\
        Max_User_Prm_Data_Len=9\nExt_User_Prm_Data_Const(0)=0x00,0x40,0x00\nExt_User_Prm_Data_Ref(1)=1\nExt_User_Prm_Data_Ref(1)=2\n\
        Module=\"PPO 1\" 0xF3,0xF1\n1\nEndModule\nModule = \"Basic\" 0xF3\n2\nExt_Module_Prm_Data_Len=3\n\
        Ext_User_Prm_Data_Const(0)=0xC7,0xFF,0xFF\nExt_User_Prm_Data_Ref(3)=3\nExt_User_Prm_Data_Ref(0)=4\nEndModule\n";

    #[test]
    fn what_a_master_says_is_read() {
        let gsd = Gsd::parse(TEXT).unwrap();
        assert_eq!((gsd.ident, gsd.model.as_str()), (0x1337, "SOME; DRIVE"));
        assert_eq!(gsd.user, [0x00, 0x45, 0x00]);
        let modules: Vec<_> = gsd.modules.iter().map(|one| (one.name.as_str(), &one.cfg[..], &one.user[..])).collect();
        assert_eq!(modules[0], ("PPO 1", &[0xF3, 0xF1][..], &[][..]));
        assert_eq!(modules[1], ("Basic", &[0xF3][..], &[0xC7, 0xFF, 0xFF, 0x07, 0xD0][..]));
    }

    #[test]
    fn values_are_as_wide_as_their_type() {
        for (kind, user) in [
            ("Unsigned8 7", &[7][..]),
            ("Signed8 -2", &[0xFE]),
            ("Unsigned16 7", &[0, 7]),
            ("Signed32 -2", &[0xFF, 0xFF, 0xFF, 0xFE]),
            ("BitArea(0-7) 0xA5", &[0xA5]),
            ("BitArea(1-7) 0x52", &[0xA4]),
            ("BitArea(1-2) 4", &[]), // more than two bits hold
            ("BitArea(0-8) 1", &[]),
        ] {
            let text = format!(
                "#Profibus_DP\nIdent_Number=1\nExtUserPrmData=1 \"a\"\n{kind} 0-1\nExt_User_Prm_Data_Ref(0)=1\n"
            );
            assert_eq!(Gsd::parse(&text).map(|gsd| gsd.user).unwrap_or_default(), user, "{kind}");
        }
    }

    #[test]
    fn behind_a_module_comes_what_is_of_the_whole_device() {
        let text = [TEXT, "Ext_User_Prm_Data_Const(3)=0x77\n"].concat();
        let gsd = Gsd::parse(&text).unwrap();
        assert_eq!((gsd.user, gsd.modules[1].user.len()), (vec![0x00, 0x45, 0x00, 0x77], 5));
    }

    #[test]
    fn user_parameters_may_be_as_long_as_they_fit() {
        let most = "1,".repeat(MOST_USER - 1) + "1";
        let old = "#Profibus_DP\nIdent_Number=1\nUser_Prm_Data=";
        assert_eq!(Gsd::parse(&format!("{old}{most}")).unwrap().user.len(), MOST_USER);
        let at = |place| format!("#Profibus_DP\nIdent_Number=1\nExt_User_Prm_Data_Const({place})=1\n");
        assert_eq!(Gsd::parse(&at(MOST_USER - 1)).unwrap().user.len(), MOST_USER);
        assert!(Gsd::parse(&at(MOST_USER)).is_err());
    }

    #[test]
    fn old_user_parameters_count_where_there_are_no_others() {
        let text = TEXT.replace("Ext_User_Prm_Data_Const(0)=0x00,0x40,0x00\n", "");
        let text = text.replace("Ext_User_Prm_Data_Ref(1)=1\nExt_User_Prm_Data_Ref(1)=2\n", "");
        assert_eq!(Gsd::parse(&text).unwrap().user, [1, 2]);
    }

    #[test]
    fn broken_files_name_the_line_and_none_stops_the_program() {
        for (from, to, line) in [
            ("#Profibus_DP", "", 0),
            ("Ident_Number=0x1337", "", 0),
            ("Ident_Number=0x1337", "Ident_Number=0x12345", 5),
            ("0xF3,0xF1", "0xF3,0x1F1", 27),
            ("Const(0)=0xC7", "Const(999)=0xC7", 33),
        ] {
            let broken = Gsd::parse(&TEXT.replace(from, to)).unwrap_err();
            assert_eq!(broken.line, line, "{broken}");
        }
        let long = "1,".repeat(MOST_USER + 1);
        assert_eq!(Gsd::parse(&TEXT.replace("0x01, 0x02", &long)).unwrap_err().line, 6);
        for end in 0..TEXT.len() {
            let _any = Gsd::parse(&TEXT[..end]);
            let _any = Gsd::parse(&[&TEXT[..end], "(9999999999999999999)=-1-"].concat());
        }
    }
}
