//! The file of a bench: TOML. Unknown keys are refused, with line and column.
//!
//! Times are written with their unit: `"750us"`, `"10ms"`, `"2s"`. Times of scripts count from the start of the bench.
//!
//! ```toml
#![doc = include_str!("../bench.toml")]
//! ```

mod active;
mod can;
mod drive;
mod line;
mod module;
mod profibus;
mod reader;
mod servo;
mod station;
mod tables;

use crate::profile::{Broken, Registry, stumbled};
use crate::protocol::line::{LineSetting, Parity};
use crate::simulator::bench::Bench;
use crate::simulator::device;
use crate::simulator::device::contract::NodeSetting;
use crate::simulator::line::disturb::Disturber;
use crate::simulator::line::speech::Spoken;
use crate::simulator::station::Drive;
use crate::simulator::station::setup::Setup;
use crate::text::both;
use reader::{BenchFile, Model};
use tables::File;

/// Longest bench file that is read.
const MAX_FILE: usize = 1 << 20;

impl Bench {
    /// An ACT at address 1 and an ACU with EM-RES-03 at address 2, both Modbus RTU, 19200 8E1.
    pub fn standard(registry: &Registry) -> Bench {
        let drive = |model: Model, address, modules: &[&str]| {
            let mut setup = device::active::setup::Setup::plain(model == Model::Acu);
            setup.modules = modules.iter().map(|&module| module.to_owned()).collect();
            let place = NodeSetting { address, spoken: Spoken::RTU, line: LineSetting::rtu(19_200, Parity::Even) };
            let family = registry.family(model.name());
            let device = device::active::Drive::new(&setup, place, Vec::new(), family.as_deref());
            Drive::new(Setup::plain(place), Box::new(device))
        };
        let drives = vec![drive(Model::Act, 1, &[]), drive(Model::Acu, 2, &["EM-RES-03"])];
        Bench::new(drives, Disturber::new(Vec::new(), false, 0))
    }

    /// The standard bench with the built-in catalogue, for the tests of rooms that know no catalogue.
    #[cfg(test)]
    pub(crate) fn built_in() -> Bench {
        Bench::standard(&Registry::open(&[]).unwrap())
    }

    /// The bench of a file. `path` is only for the messages; see [`mod@crate::simulator::file`] for the format.
    pub fn from_toml(path: &str, text: &str, registry: &Registry) -> Result<Bench, Broken> {
        read(path, text, registry)
    }
}

fn read(path: &str, text: &str, registry: &Registry) -> Result<Bench, Broken> {
    let reader = BenchFile { path, text, registry };
    if text.len() > MAX_FILE {
        let message = both!(
            "{bytes} bytes; a bench file has at most {MAX_FILE}",
            "{bytes} Byte; eine Prüfstanddatei hat höchstens {MAX_FILE}",
            bytes = text.len()
        );
        return Err(reader.error(0..0, message));
    }
    let file: File = toml::from_str(text).map_err(|error| {
        let (at, why) = stumbled(&error);
        reader.error(at..at, why)
    })?;
    if file.drive.is_empty() {
        let message = both!("no [[drive]]; expected at least one", "kein [[drive]]; erwartet wird mindestens eines");
        return Err(reader.error(0..0, message));
    }
    let drives = file.drive.iter().map(|table| reader.drive(table, file.line.seed));
    let drives: Vec<Drive> = drives.collect::<Result<_, _>>()?;
    let spoken = drives.first().map_or(Spoken::RTU, Drive::spoken);
    let (mut rules, mut babblers) = (Vec::new(), Vec::new());
    for table in &file.disturb {
        match reader.babbler(table, spoken)? {
            Some(babbler) => babblers.push(babbler),
            None => rules.push(reader.rule(table)?),
        }
    }
    let mut disturber = Disturber::new(rules, file.line.echo, file.line.seed);
    disturber.babblers = babblers;
    Ok(Bench::new(drives, disturber))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bench(text: &str) -> Result<Bench, Broken> {
        read("bench.toml", text, &Registry::open(&[]).unwrap())
    }

    fn refused(text: &str) -> String {
        bench(text).unwrap_err().to_string()
    }

    #[test]
    fn the_example_of_the_manual_page_is_a_bench() {
        let bench = bench(include_str!("../bench.toml")).unwrap();
        let models: Vec<_> = bench.drives().map(|drive| (drive.model(), drive.address())).collect();
        assert_eq!(models, [("acu", 2), ("lxm05", 3), ("foreign", 9)]);
        let acu = bench.drive(2).unwrap();
        assert_eq!((acu.ram(376, 3), acu.ram(412, 0), acu.eeprom_writes()), (Some(15), Some(1), 0));
    }

    #[test]
    fn settings_of_the_line_are_those_of_the_parameters() {
        let text = "[[drive]]\nmodel = \"act\"\naddress = 7\nprotocol = \"ascii\"\nbaud = 9600\nparity = \"none\"";
        let bench = bench(text).unwrap();
        let drive = bench.drive(7).unwrap();
        assert_eq!(drive.line().to_string(), "9600 7N2");
        assert_eq!((drive.ram(10, 0), drive.ram(1375, 0), drive.ram(395, 0)), (Some(3), Some(2), Some(3)));
    }

    #[test]
    fn refusals_say_where_and_what_was_expected() {
        let drive = |rest: &str| refused(&format!("[[drive]]\nmodel = \"act\"\n{rest}\n"));
        assert_eq!(drive("address = 248"), "bench.toml:3:11: address = 248; expected 1 to 247");
        assert_eq!(drive("parity = \"mark\""), "bench.toml:3:10: parity = \"mark\"; expected one of: even, odd, none");
        assert!(drive("colour = 1").starts_with("bench.toml:3:1: unknown field `colour`"), "{}", drive("colour = 1"));
        assert!(drive("set = { \"372@5\" = 1 }").contains("expected data set 1 to 4"));
        assert!(drive("set = { \"1\" = 1 }").contains("no such parameter"));
        assert!(drive("set = { \"376\" = \"1.55\" }").contains("more decimals"));
        assert!(drive("set = { \"900\" = 1 }").contains("no such parameter"));
        assert!(drive("modules = [\"X\"]").contains("expected one of: EM-RES-03"));
        assert!(drive("reply_delay = \"10\"").contains("a time with unit"));
        assert!(drive("[[drive.event]]\nat = \"1s\"").contains("nothing happens"));
        for fault in ["500", "F50", "F0000", "F-123"] {
            let text = format!("[[drive.event]]\nat = \"1s\"\nfault = \"{fault}\"");
            assert!(drive(&text).contains("F and 4 digits"), "{fault}");
        }
        assert!(drive("[[drive.event]]\nfault = \"F0500\"").contains("exactly one of: at, when, after_writes"));
        assert!(drive("[[drive.event]]\nat = \"1s\"\nwhen = \"running\"\nmains = false").contains("exactly one of"));
        for when in ["standing", "above", "above Hz", "above -3Hz", "above 20"] {
            let text = format!("[[drive.event]]\nwhen = \"{when}\"\nmains = false");
            assert!(drive(&text).contains("\"above 20Hz\""), "{when}");
        }
        assert!(drive("[[drive.event]]\nafter_writes = 0\nmains = false").contains("1 or more"));
        assert!(drive("[[drive.event]]\nat = \"1s\"\nstob = false").contains("only an ACU"));
        assert!(drive("stoa = false").contains("only an ACU"));
        assert!(drive("torque = 1001").contains("expected 0 to 1000"));
        assert!(drive("ramps = { up_right = 0 }").contains("0.01 to 9999.99"));
        assert!(drive("ramps = { up_right = 1.234 }").contains("more decimals"));
        assert!(drive("ramps = { up = 1 }").contains("unknown field `up`"));
        assert!(drive("[[disturb]]\nkind = \"lost\"").contains("exactly one of"));
        assert!(drive("[[disturb]]\nkind = \"babble\"\nevery = 3").contains("only with at, by"));
        assert!(drive("[[disturb]]\nkind = \"babble\"\npattern = \"5\"").contains("bytes in hex"));
        assert!(drive("[[disturb]]\nevery = 1\nkind = \"twin\"\nfor = \"1s\"").contains("only with kind = \"babble\""));
        assert!(refused("").contains("at least one"));
    }
}
