//! `systembus show`: what drives are set to on the bus.

use super::page::Page;
use super::{Finding, Rows};
use crate::outcome::{BusChannel, BusNode, BusPlace, BusShow};
use crate::text::Text;

impl Finding for BusShow {
    fn table(&self, page: Page) -> String {
        page.each(&self.drives, Page::bus_node)
    }

    fn rows(&self) -> Rows {
        let of = |drive: &BusNode| match drive.values.is_empty() {
            true => Rows::of("drive", &[drive]).without_lists(),
            false => Rows::of("value", &drive.values),
        };
        self.drives.iter().map(of).fold(Rows::default(), Rows::and)
    }
}

impl Page {
    fn bus_node(self, node: &BusNode) -> String {
        let heading = self.heading(node.address, &node.drive);
        if let Some(error) = &node.error {
            return heading + &self.prose(error.message.get(self.lang));
        }
        let mut text = heading + &self.pairs(self.bus_settings(node));
        let sent = node.sent.iter().map(|one| self.bus_channel("TxPDO", one));
        let received = node.received.iter().map(|one| self.bus_channel("RxPDO", one));
        let head = ["", ">identifier", "function", ">ms"];
        text += &format!("\n{}", self.table(&head, sent.chain(received).collect()));
        let sent = node.sent.iter().flat_map(|one| self.bus_places("TxPDO", one));
        let received = node.received.iter().flat_map(|one| self.bus_places("RxPDO", one));
        let rows: Vec<_> = sent.chain(received).collect();
        if !rows.is_empty() {
            text += &format!("\n{}", self.table(&["", "bytes", "param", "source"], rows));
        }
        let untold: Vec<_> = node.values.iter().filter(|value| value.error.is_some()).cloned().collect();
        if untold.is_empty() { text } else { text + &format!("\n{}", self.values(&untold)) }
    }

    fn bus_settings(self, node: &BusNode) -> Vec<(&'static str, String)> {
        let number = |number: Option<u32>| number.map_or_else(|| "?".to_owned(), |number| number.to_string());
        let identifier = |of: Option<u16>| number(of.map(u32::from));
        let coded = |code: Option<i64>, text: Option<&Text>| match text {
            Some(text) => self.say(text),
            None => code.map_or_else(|| "?".to_owned(), |code| code.to_string()),
        };
        let place = match node.node {
            Some(-1) => self.word("off").to_owned(),
            Some(0) => format!("0 ({})", self.word("master")),
            Some(node) => node.to_string(),
            None => "?".to_owned(),
        };
        let sdo2 = node.sdo2.map_or("?", |is_on| if is_on { self.word("on") } else { self.word("off") });
        let timeout = format!("{} {} ms", self.word("timeout"), number(node.sync_timeout_ms));
        let mut rows = vec![
            ("node", place),
            ("rate", format!("{} kBd", identifier(node.rate_kbd))),
            ("state", coded(node.node_state, node.node_state_text.as_ref())),
            ("bus state", coded(node.can_state, node.can_state_text.as_ref())),
            ("SYNC", format!("{}, {timeout}", identifier(node.sync_identifier))),
            ("SDO1", format!("{} -> {}", identifier(node.rx_sdo1), identifier(node.tx_sdo1))),
            ("SDO2", sdo2.to_owned()),
        ];
        if node.node == Some(0) {
            rows.extend([
                ("boot-up delay", format!("{} ms", number(node.boot_up_delay_ms))),
                ("SYNC time", format!("{} ms", number(node.sync_every_ms))),
                ("emergency reaction", coded(None, node.emergency_reaction.as_ref())),
            ]);
        }
        rows
    }

    fn bus_channel(self, name: &str, one: &BusChannel) -> Vec<String> {
        let function = match one.function {
            Some("off") => self.word("off").to_owned(),
            Some("time") => self.word("by time").to_owned(),
            Some(_) => "SYNC".to_owned(),
            None => one.code.map_or_else(|| "?".to_owned(), |code| format!("? ({code})")),
        };
        let number = |number: Option<u32>| number.map_or_else(|| "?".to_owned(), |number| number.to_string());
        vec![format!("{name}{}", one.pdo), number(one.identifier.map(u32::from)), function, number(one.ms)]
    }

    fn bus_places(self, name: &str, one: &BusChannel) -> Vec<Vec<String>> {
        let row = |place: &BusPlace| {
            vec![
                format!("{name}{}", one.pdo),
                format!("{}-{} {}", place.first_byte, place.last_byte, place.place),
                format!("{} {}", place.param, self.say_or_not(place.param_name.as_ref())),
                format!("{} {}", place.source, self.say_or_not(place.source_name.as_ref())).trim().to_owned(),
            ]
        };
        one.places.iter().map(row).collect()
    }
}
