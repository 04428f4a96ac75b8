//! An LXM05 in a bench file.

use super::reader::{BenchFile, Model, PARITIES, decimal, from_to, one_of, quoted};
use super::tables::{DriveTable, EventTable, ServoTable};
use crate::profile::Broken;
use crate::protocol::line::{LineSetting, Parity};
use crate::simulator::device::contract::{Action, Fault, NodeSetting};
use crate::simulator::device::lexium::Lexium;
use crate::simulator::device::lexium::params::{BAUD_RATES, Row, named};
use crate::simulator::device::lexium::setup::Setup;
use crate::simulator::line::speech::Spoken;
use crate::simulator::station::script::Event;
use crate::simulator::station::{Drive, setup};
use crate::text::{Text, both};
use crate::tick::Span;
use toml::{Spanned, Value};

/// Earliest reply: a choice of the bench, the manual tells no time.
const REPLY_DELAY: Span = Span::from_millis(3);
/// Class of an error if the file names none: power off at once.
const CLASS: u8 = 3;
/// Most user units that a position wavers by.
const MOST_WAVER: i64 = 1_000_000;
/// Fastest setpoint from elsewhere, 1/min.
const MOST_ANALOG: i64 = 100_000;
/// Longest text of an object of code 43.
const MOST_TEXT: usize = 60;

impl BenchFile<'_> {
    pub(crate) fn servo(&self, table: &Spanned<DriveTable>, address: u8, seed: u64) -> Result<Drive, Broken> {
        let row = table.get_ref();
        if let Some(key) = foreign_key(row) {
            let message = both!("{key} is not for model lxm05", "{key} gehört nicht zu model lxm05");
            return Err(self.error(table.span(), message));
        }
        if let Some(protocol) = row.protocol.as_ref().filter(|protocol| protocol.get_ref() != "rtu") {
            let message = both!("an LXM05 speaks rtu only", "ein LXM05 spricht nur rtu");
            return Err(self.error(protocol.span(), message));
        }
        let place = NodeSetting { address, spoken: Spoken::RTU, line: self.servo_line(row)? };
        let mut station = setup::Setup::plain(place);
        station.delay = match (&row.slow, &row.load, &row.reply_delay) {
            (None, None, None) => REPLY_DELAY,
            _ => self.delay(row)?,
        };
        station.jitter = self.time_or("jitter", row.jitter.as_ref(), Span::ZERO)?;
        station.strict_silence = row.strict_silence;
        station.seed = seed;
        let mut setup = Setup { readings: self.readings(row, Model::Lxm05)?, ..Setup::default() };
        if let Some(servo) = &row.servo {
            self.surroundings(servo.get_ref(), &mut setup)?;
        }
        for (key, value) in &row.set {
            setup.values.push(self.servo_value(key, value, Row::is_settable)?);
        }
        for event in &row.event {
            let trigger = self.trigger(event)?;
            let actions = self.servo_actions(event)?.into_iter();
            station.script.extend(actions.map(|action| Event { trigger, action, lasts: None }));
        }
        Ok(Drive::new(station, Box::new(Lexium::new(&setup, place))))
    }

    /// Baud rate, parity and stop bits as MBbaud and MBformat can have them (LXM05 manual 4.1).
    fn servo_line(&self, row: &DriveTable) -> Result<LineSetting, Broken> {
        let mut line = LineSetting::rtu(19_200, Parity::Even);
        if let Some(got) = &row.baud {
            let known = BAUD_RATES.iter().find(|&&rate| i64::from(rate) == *got.get_ref());
            let expected = one_of(&BAUD_RATES.map(|rate| rate.to_string()).join(", "));
            let known = known.ok_or_else(|| self.unfit("baud", got.span(), got.get_ref(), &expected))?;
            line.baud = known.unsigned_abs();
        }
        if let Some(got) = &row.parity {
            let parity = self.word("parity", got, &PARITIES.map(|parity| (parity.name(), parity)))?;
            line = LineSetting::rtu(line.baud, parity);
        }
        match row.stop_bits.as_ref().map(|got| (*got.get_ref(), got)) {
            Some((1, _)) => line.stop_bits = 1,
            Some((2, _)) if line.parity == Parity::None => {}
            Some((_, got)) => {
                let message = both!(
                    "stop_bits: expected 1, or 2 with parity \"none\"",
                    "stop_bits: erwartet wird 1, oder 2 mit parity \"none\""
                );
                return Err(self.error(got.span(), message));
            }
            None => {}
        }
        Ok(line)
    }

    /// What stands around it, and what it tells of itself.
    fn surroundings(&self, servo: &ServoTable, setup: &mut Setup) -> Result<(), Broken> {
        let Setup { world, identity, .. } = setup;
        world.limn = servo.limn.unwrap_or(world.limn);
        world.limp = servo.limp.unwrap_or(world.limp);
        world.limits = servo.limits.unwrap_or(world.limits);
        world.guide = servo.guide.unwrap_or(world.guide);
        world.analog = servo.analog.map_or(world.analog, |speed| speed.clamp(-MOST_ANALOG, MOST_ANALOG));
        world.waver = servo.waver.map_or(world.waver, |units| units.clamp(0, MOST_WAVER));
        if let Some(bit6) = &servo.bit6 {
            world.bit6_absolute = self.word("bit6", bit6, &[("relative", false), ("absolute", true)])?;
        }
        for (got, text) in [
            (&servo.vendor, &mut identity.vendor),
            (&servo.product, &mut identity.product),
            (&servo.revision, &mut identity.revision),
        ] {
            let Some(got) = got else { continue };
            if got.get_ref().len() > MOST_TEXT {
                let message = both!(
                    "expected a text of at most {MOST_TEXT} bytes",
                    "erwartet wird ein Text von höchstens {MOST_TEXT} Byte"
                );
                return Err(self.error(got.span(), message));
            }
            text.clone_from(got.get_ref());
        }
        if let Some(object) = &servo.revision_object {
            if !(2..=3).contains(object.get_ref()) {
                let message = both!("revision_object: expected 2 or 3", "revision_object: erwartet wird 2 oder 3");
                return Err(self.error(object.span(), message));
            }
            identity.revision_object = *object.get_ref();
        }
        identity.in_pieces = servo.in_pieces.unwrap_or(identity.in_pieces);
        Ok(())
    }

    /// Address and raw value of a row of `set`, if that one `is_taken` there.
    fn servo_value(&self, key: &str, value: &Spanned<Value>, is_taken: fn(&Row) -> bool) -> Result<(u32, i64), Broken> {
        let refuse = |why: Text| self.error(value.span(), both!("set \"{key}\": {why}", "set \"{key}\": {why}", why));
        let row = named(key).ok_or_else(|| {
            refuse(both!(
                "an LXM05 of this bench has no such parameter; expected its name or address",
                "diesen Parameter hat ein LXM05 dieses Prüfstands nicht; erwartet wird sein Name oder seine Adresse"
            ))
        })?;
        if !is_taken(row) {
            return Err(refuse(both!(
                "cannot be given; it is what the drive does",
                "lässt sich nicht vorgeben; es ist, was der Antrieb tut"
            )));
        }
        let raw = match value.get_ref().as_str().and_then(|text| text.strip_prefix("0x")) {
            Some(hex) => u32::from_str_radix(hex, 16)
                .map(|bits| i64::from(bits as i32))
                .map_err(|_| refuse(both!("expected hexadecimal digits", "erwartet werden Hexadezimalziffern")))?,
            None => decimal(value.get_ref(), row.decimals).map_err(refuse)?,
        };
        let fits = i32::try_from(raw).is_ok_and(|raw| row.takes(raw));
        fits.then_some((row.address.into(), raw)).ok_or_else(|| {
            refuse(both!("out of the range of this parameter", "außerhalb des Bereichs dieses Parameters"))
        })
    }

    /// What an event does to an LXM05.
    pub(crate) fn servo_actions(&self, table: &Spanned<EventTable>) -> Result<Vec<Action>, Broken> {
        let row = table.get_ref();
        let mut actions = Vec::new();
        if let Some(fault) = &row.fault {
            actions.push(Action::Fault(self.servo_fault(row, fault)?));
        }
        if let Some(silent) = &row.silent {
            actions.push(Action::Silent(self.time("silent", silent)?));
        }
        for (key, value) in &row.set {
            let (address, raw) = self.servo_value(key, value, Row::is_set_by_others)?;
            actions.push(Action::Set(address, 0, raw));
        }
        actions.extend(row.dragged.map(Action::Dragged));
        actions.extend(row.refuses.map(Action::Refuses));
        actions.extend(row.ignores.map(Action::Ignores));
        actions.extend(row.power_cycle.filter(|&cycle| cycle).map(|_| Action::PowerCycle));
        let others = [row.mains, row.enable, row.start_right, row.start_left].into_iter().any(|key| key.is_some());
        let others =
            others || row.stoa.is_some() || row.stob.is_some() || row.torque.is_some() || row.warning.is_some();
        let others = others || row.exchange_phases || row.hand.is_some() || row.analog.is_some();
        let others = others || row.lasts.is_some() || !row.eeprom.is_empty();
        let lonely = row.fault.is_none() && (row.class.is_some() || row.qualifier.is_some());
        if actions.is_empty() || others || lonely {
            let message = both!(
                "expected fault (with class and qualifier), set, dragged, power_cycle, silent, refuses or ignores, as an LXM05 knows them",
                "erwartet wird fault (mit class und qualifier), set, dragged, power_cycle, silent, refuses oder ignores, wie ein LXM05 sie kennt"
            );
            return Err(self.error(table.span(), message));
        }
        Ok(actions)
    }

    fn servo_fault(&self, row: &EventTable, got: &Spanned<String>) -> Result<Fault, Broken> {
        let digits = got.get_ref().strip_prefix('E').filter(|digits| digits.len() == 4);
        let number = digits.and_then(|digits| u16::from_str_radix(digits, 16).ok()).filter(|&number| number != 0);
        let expected = both!("E and 4 digits, such as \"E2300\"", "E und 4 Ziffern wie \"E2300\"");
        let number = number.ok_or_else(|| self.unfit("fault", got.span(), &quoted(got), &expected))?;
        let class = row.class.unwrap_or(CLASS);
        if class > 4 {
            return Err(self.unfit("class", got.span(), &class, &from_to(0, 4)));
        }
        Ok(Fault { number, class, qualifier: row.qualifier.unwrap_or(0) })
    }
}

/// A key that this table has and an LXM05 has not.
fn foreign_key(row: &DriveTable) -> Option<&'static str> {
    [
        ("data_bits", row.data_bits.is_some()),
        ("strict_remote", row.strict_remote),
        ("enable", !row.enable),
        ("stoa", row.stoa.is_some()),
        ("stob", row.stob.is_some()),
        ("start_right", row.start_right.is_some()),
        ("start_left", row.start_left.is_some()),
        ("mains", row.mains.is_some()),
        ("torque", row.torque.is_some()),
        ("ramps", row.ramps.is_some()),
        ("resolver", row.resolver.is_some()),
        ("analog", row.analog.is_some()),
        ("modules", !row.modules.is_empty()),
        ("eeprom", !row.eeprom.is_empty()),
        ("four", !row.four.is_empty()),
        ("other_width", !row.other_width.is_empty()),
        ("registers", !row.registers.is_empty()),
        ("busy", row.busy),
        ("nodes", !row.nodes.is_empty()),
    ]
    .into_iter()
    .find_map(|(key, given)| given.then_some(key))
}

#[cfg(test)]
mod tests {
    use super::super::read;
    use crate::profile::Registry;

    fn refused(rest: &str) -> String {
        let text = format!("[[drive]]\nmodel = \"lxm05\"\n{rest}\n");
        read("bench.toml", &text, &Registry::open(&[]).unwrap()).unwrap_err().message.en.into_owned()
    }

    #[test]
    fn keys_of_other_models_are_refused() {
        for key in [
            "data_bits = 8",
            "strict_remote = true",
            "enable = false",
            "start_right = true",
            "start_left = false",
            "mains = true",
            "torque = 3",
            "ramps = { }",
            "modules = [\"X\"]",
            "registers = { \"1\" = 2 }",
            "nodes = [{ id = 1, model = \"act\" }]",
            "stoa = true",
            "stob = true",
        ] {
            let name = key.split(' ').next().unwrap_or_default();
            assert_eq!(refused(key), format!("{name} is not for model lxm05"));
        }
        assert!(refused("protocol = \"ascii\"").contains("rtu only"));
        let act = |rest: &str| {
            let text = format!("[[drive]]\nmodel = \"act\"\n{rest}\n");
            read("bench.toml", &text, &Registry::open(&[]).unwrap()).unwrap_err().message.en.into_owned()
        };
        assert!(act("stop_bits = 1").contains("for model lxm05"));
        assert!(act("servo = { }").contains("for model lxm05"));
        assert!(act("[[drive.event]]\nat = \"1s\"\nfault = \"F0500\"\nclass = 2").contains("for model lxm05"));
    }

    #[test]
    fn refusals_say_what_was_expected() {
        assert!(refused("baud = 57600").contains("9600, 19200, 38400"));
        assert!(refused("parity = \"even\"\nstop_bits = 2").contains("2 with parity"));
        assert!(refused("set = { X = 1 }").contains("its name or address"));
        assert!(refused("set = { DCOMcontrol = 15 }").contains("what the drive does"));
        assert!(refused("set = { MBformat = 5 }").contains("out of the range"));
        assert!(refused("set = { CUR_I_target = \"1.555\" }").contains("more decimals"));
        assert!(refused("set = { RAMPacc = \"0xG\" }").contains("hexadecimal"));
        assert!(refused("servo = { bit6 = \"on\" }").contains("relative, absolute"));
        assert!(refused("servo = { revision_object = 4 }").contains("2 or 3"));
        assert!(refused(&format!("servo = {{ vendor = \"{}\" }}", "x".repeat(61))).contains("at most 60"));
        for event in ["", "mains = false", "class = 2", "silent = \"1s\"\nclass = 2", "warning = 1", "torque = 5"] {
            assert!(
                refused(&format!("[[drive.event]]\nat = \"1s\"\n{event}")).contains("as an LXM05 knows"),
                "{event}"
            );
        }
        assert!(refused("[[drive.event]]\nat = \"1s\"\nfault = \"F2300\"").contains("E and 4 digits"));
        assert!(refused("[[drive.event]]\nat = \"1s\"\nfault = \"E2300\"\nclass = 5").contains("0 to 4"));
    }

    #[test]
    fn what_a_file_says_is_what_the_drive_has() {
        let text = "[[drive]]\nmodel = \"lxm05\"\naddress = 9\nbaud = 38400\nparity = \"none\"\nstop_bits = 1\n\
                    set = { rampacc = 700, \"6940\" = \"0xFFFFFFFE\", CUR_I_target = \"1.5\", FLT_class = 2 }\n";
        let bench = read("bench.toml", text, &Registry::open(&[]).unwrap()).unwrap();
        let drive = bench.drive(9).unwrap();
        assert_eq!(drive.line().to_string(), "38400 8N1");
        let values = [5_638, 5_640, 5_642, 1_556, 6_940, 8_200, 15_364].map(|address| drive.ram(address, 0));
        assert_eq!(values, [38_400, 9, 1, 700, -2, 150, 2].map(Some));
        assert_eq!((drive.eeprom(1_556, 0), drive.eeprom(6_940, 0), drive.ram(1_557, 0)), (Some(700), None, None));
    }
}
