//! The cells of a drive: a copy in the EEPROM, and a copy in the RAM that the drive works with
//! (CM-485 manual 7).

use crate::simulator::device::contract::CellFault;
use std::collections::BTreeMap;

/// Number of a parameter and data set: 0 where it exists once, 1-4 where it is switchable.
pub(crate) type Cell = (u32, u8);

/// EEPROM and RAM, raw values.
#[derive(Clone, Debug, Default)]
pub(crate) struct Store {
    eeprom: BTreeMap<Cell, i64>,
    ram: BTreeMap<Cell, i64>,
    /// What lives in the RAM only, with its value at power-on.
    volatile: BTreeMap<Cell, i64>,
    /// Cells that do not take a write as they should.
    faulty: BTreeMap<Cell, CellFault>,
    writes: u64,
}

impl Store {
    /// Puts a value into the EEPROM as the factory does, without counting.
    pub(crate) fn equip(&mut self, cell: Cell, value: i64) {
        self.eeprom.insert(cell, value);
    }

    /// Makes a cell that lives in the RAM only.
    pub(crate) fn equip_volatile(&mut self, cell: Cell, value: i64) {
        self.volatile.insert(cell, value);
    }

    /// Power-on: the RAM gets what the EEPROM holds.
    pub(crate) fn power_up(&mut self) {
        self.ram = self.eeprom.clone();
        self.ram.extend(self.volatile.iter().map(|(cell, value)| (*cell, *value)));
    }

    /// Writes the EEPROM and, with it, the RAM. Every write wears the cell, also one of the same value.
    pub(crate) fn write_eeprom(&mut self, cell: Cell, value: i64) {
        let fault = self.faulty.get(&cell);
        if matches!(fault, None | Some(CellFault::NotInForce)) {
            self.eeprom.insert(cell, value);
        }
        if fault != Some(&CellFault::NotInForce) {
            self.ram.insert(cell, value);
        }
        self.writes = self.writes.saturating_add(1);
    }

    /// From now on a cell takes writes so; as it should where there is nothing.
    pub(crate) fn spoil(&mut self, cell: Cell, fault: Option<CellFault>) {
        match fault {
            Some(fault) => self.faulty.insert(cell, fault),
            None => self.faulty.remove(&cell),
        };
    }

    /// Whether the drive says that the EEPROM did not take a write.
    pub(crate) fn refuses(&self, cell: Cell) -> bool {
        self.faulty.get(&cell) == Some(&CellFault::Refuses)
    }

    /// Writes the RAM only.
    pub(crate) fn write_ram(&mut self, cell: Cell, value: i64) {
        self.ram.insert(cell, value);
    }

    pub(crate) fn eeprom(&self, cell: Cell) -> Option<i64> {
        self.eeprom.get(&cell).copied()
    }

    pub(crate) fn ram(&self, cell: Cell) -> Option<i64> {
        self.ram.get(&cell).copied()
    }

    /// EEPROM cells written since the drive was built.
    pub(crate) fn writes(&self) -> u64 {
        self.writes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn power_up_forgets_what_is_in_the_ram_only() {
        let mut store = Store::default();
        store.equip((480, 1), 500);
        store.equip_volatile((410, 0), 0);
        store.power_up();
        store.write_ram((480, 1), 700);
        store.write_ram((410, 0), 15);
        assert_eq!((store.eeprom((480, 1)), store.ram((480, 1)), store.writes()), (Some(500), Some(700), 0));
        store.power_up();
        assert_eq!((store.ram((480, 1)), store.ram((410, 0)), store.eeprom((410, 0))), (Some(500), Some(0), None));
        store.write_eeprom((480, 1), 800);
        assert_eq!((store.ram((480, 1)), store.writes()), (Some(800), 1));
    }
}
