//! The state machine of an ACT or ACU: its ways, its stops, and what it does not obey.

use super::*;

const RAMP: Ramps = Ramps::all(500);

fn inputs(acu: bool, word: u16) -> Inputs {
    Inputs {
        acu,
        control: Control::StateMachine,
        word,
        enable: true,
        right: true,
        left: false,
        mains: true,
        positioning: false,
        strict_remote: false,
        edge: false,
        reset_needs_remote: false,
        goal: 1_000,
        ramps: RAMP,
        quick_ramps: Ramps::all(1_000),
        transition5: 2,
        threshold: 50,
        holding: Span::from_secs(1),
        braking: Span::from_secs(3),
        motor: Motor::default(),
        follows: Follows::Setpoint,
    }
}

fn millis(count: u64) -> Tick {
    Tick::ZERO + Span::from_millis(count)
}

/// A drive that is up, in switch-on inhibit.
fn machine() -> Automaton {
    let mut machine = Automaton::new(Tick::ZERO);
    machine.restart(Tick::ZERO, Some(Tick::ZERO));
    machine.settle(Tick::ZERO, &inputs(false, 0));
    machine
}

/// Goes through control words, one a second, and returns bits 0-6 after each.
fn walk(acu: bool, words: &[u16]) -> Vec<u16> {
    let mut machine = machine();
    let mut states = Vec::new();
    for (second, &word) in (0..).zip(words) {
        machine.react(millis(second * 1_000), &inputs(acu, word));
        states.push(machine.state.bits());
    }
    states
}

/// Runs at 10 Hz.
fn running(inputs: &Inputs) -> Automaton {
    let mut machine = machine();
    machine.react(Tick::ZERO, &Inputs { word: 0xF, ..*inputs });
    machine.settle(millis(2_000), &Inputs { word: 0xF, ..*inputs });
    assert_eq!((machine.state, machine.shaft.speed()), (State::Enabled, 1_000));
    machine
}

#[test]
fn the_long_way_and_the_short_cut() {
    assert_eq!(walk(false, &[0, 6, 7, 0xF, 0]), [0x40, 0x21, 0x23, 0x27, 0x40]);
    assert_eq!(walk(true, &[0xF, 6, 0xF, 6]), [0x27, 0x21, 0x27, 0x21]);
    assert_eq!(walk(false, &[7]), [0x40]);
    assert_eq!(walk(true, &[6, 2]), [0x21, 0x40]);
    assert_eq!(walk(false, &[6, 2]), [0x21, 0x21]);
}

#[test]
fn not_ready_comes_before_everything_and_obeys_nothing() {
    let mut machine = Automaton::new(Tick::ZERO);
    machine.restart(Tick::ZERO, Some(millis(3_000)));
    let contacts = Inputs { control: Control::Contacts, ..inputs(true, 0) };
    machine.react(millis(1_000), &contacts);
    assert_eq!((machine.state.bits(), machine.next()), (0x00, Some(millis(3_000))));
    machine.settle(millis(3_000), &contacts);
    assert_eq!(machine.state, State::Enabled);
    // Without power nothing begins, and nothing can go wrong.
    machine.restart(millis(5_000), None);
    machine.trip(millis(5_000), 0x0500);
    machine.react(millis(9_000), &contacts);
    assert_eq!((machine.state, machine.fault, machine.shaft.powered()), (State::NotReady, 0, false));
    assert_eq!(machine.shaft.speed(), 0);
}

#[test]
fn a_restart_does_not_stop_the_shaft() {
    let mut machine = running(&inputs(true, 0));
    machine.restart(millis(2_000), Some(millis(5_000)));
    machine.settle(millis(2_500), &inputs(true, 0));
    assert_eq!((machine.shaft.speed(), machine.shaft.powered()), (500, false));
}

#[test]
fn quick_stop_ends_in_switch_on_inhibit_after_the_holding_time() {
    let mut machine = running(&inputs(true, 0));
    machine.react(millis(2_000), &inputs(true, 2));
    assert_eq!(machine.state, State::QuickStop);
    // 10.00 Hz down to 0.50 Hz with 10.00 Hz/s, then 1 s.
    assert_eq!(machine.next(), Some(millis(3_950)));
    machine.settle(millis(3_949), &inputs(true, 2));
    assert_eq!((machine.state, machine.shaft.speed(), machine.shaft.powered()), (State::QuickStop, 0, true));
    machine.settle(millis(3_950), &inputs(true, 2));
    assert_eq!((machine.state, machine.shaft.powered()), (State::SwitchOnInhibit, false));
}

#[test]
fn a_quick_stop_obeys_only_disable_voltage_and_the_enable() {
    for (word, enable, state) in [
        (0x0F, true, State::QuickStop),
        (0x07, true, State::QuickStop),
        (0x06, true, State::QuickStop),
        (0x00, true, State::SwitchOnInhibit),
        (0x02, false, State::SwitchOnInhibit),
    ] {
        let mut machine = running(&inputs(true, 0));
        machine.react(millis(2_000), &inputs(true, 2));
        machine.react(millis(2_100), &Inputs { enable, ..inputs(true, word) });
        assert_eq!((machine.state, machine.shaft.powered()), (state, state == State::QuickStop), "{word:#x}");
        assert!(machine.shaft.speed() > 800);
    }
}

#[test]
fn the_ramp_of_transition_5_can_be_called_back() {
    let mut machine = running(&inputs(true, 0));
    machine.react(millis(2_000), &inputs(true, 7));
    assert_eq!(machine.state, State::Enabled);
    machine.settle(millis(3_000), &inputs(true, 7));
    assert_eq!(machine.shaft.speed(), 500);
    machine.react(millis(3_000), &inputs(true, 0xF));
    machine.settle(millis(4_000), &inputs(true, 0xF));
    assert_eq!((machine.state, machine.shaft.speed(), machine.next()), (State::Enabled, 1_000, None));
}

#[test]
fn the_ramp_of_transition_5_ends_in_switched_on_after_the_holding_time() {
    let mut machine = running(&inputs(false, 0));
    machine.react(millis(2_000), &inputs(false, 7));
    // 10.00 Hz down to 0.50 Hz with 5.00 Hz/s, then 1 s.
    assert_eq!(machine.next(), Some(millis(4_900)));
    machine.settle(millis(4_899), &inputs(false, 7));
    assert_eq!((machine.state, machine.shaft.speed(), machine.shaft.powered()), (State::Enabled, 0, true));
    machine.settle(millis(4_900), &inputs(false, 7));
    assert_eq!((machine.state, machine.shaft.powered()), (State::SwitchedOn, false));
}

#[test]
fn transition_5_can_coast() {
    let coasting = Inputs { transition5: 0, ..inputs(true, 7) };
    let mut machine = running(&coasting);
    machine.react(millis(2_000), &coasting);
    assert_eq!((machine.state, machine.shaft.powered(), machine.shaft.speed()), (State::SwitchedOn, false, 1_000));
    machine.settle(millis(3_000), &coasting);
    assert_eq!(machine.shaft.speed(), 0);
}

#[test]
fn the_dc_brake_takes_its_time_and_no_word() {
    let braking = Inputs { transition5: 1, ..inputs(true, 7) };
    let mut machine = running(&braking);
    machine.react(millis(2_000), &braking);
    for word in [0xF, 0, 2, 6] {
        machine.react(millis(2_100), &Inputs { word, ..braking });
        assert_eq!((machine.state, machine.next()), (State::Enabled, Some(millis(5_000))), "{word:#x}");
    }
    machine.settle(millis(2_400), &braking);
    assert_eq!((machine.shaft.speed(), machine.shaft.powered(), machine.shaft.stator()), (0, true, 0));
    // Then the word that stands is obeyed.
    let mut other = machine.clone();
    machine.settle(millis(5_000), &braking);
    assert_eq!((machine.state, machine.shaft.powered()), (State::SwitchedOn, false));
    other.settle(millis(5_000), &Inputs { word: 0, ..braking });
    assert_eq!(other.state, State::SwitchOnInhibit);
    // The enable is stronger than the brake.
    let mut machine = running(&braking);
    machine.react(millis(2_000), &braking);
    machine.react(millis(2_100), &Inputs { enable: false, ..braking });
    assert_eq!((machine.state, machine.shaft.powered()), (State::SwitchedOn, false));
}

#[test]
fn without_enable_or_mains_nothing_starts() {
    let mut machine = machine();
    machine.react(Tick::ZERO, &Inputs { enable: false, ..inputs(false, 0xF) });
    machine.react(Tick::ZERO, &Inputs { right: false, ..inputs(false, 0xF) });
    machine.react(Tick::ZERO, &Inputs { mains: false, ..inputs(true, 0xF) });
    assert_eq!(machine.state, State::SwitchOnInhibit);
    machine.react(Tick::ZERO, &Inputs { mains: false, ..inputs(true, 6) });
    machine.react(Tick::ZERO, &Inputs { mains: false, ..inputs(true, 7) });
    machine.react(Tick::ZERO, &Inputs { mains: false, ..inputs(true, 0xF) });
    assert_eq!(machine.state, State::Ready);
    machine.react(Tick::ZERO, &inputs(true, 7));
    machine.react(Tick::ZERO, &Inputs { mains: false, ..inputs(true, 0xF) });
    machine.react(Tick::ZERO, &Inputs { enable: false, ..inputs(true, 0xF) });
    assert_eq!(machine.state, State::SwitchedOn);
    machine.react(Tick::ZERO, &inputs(true, 0xF));
    assert_eq!(machine.state, State::Enabled);
}

#[test]
fn a_strict_drive_obeys_nothing_without_the_remote_bit() {
    let strict = Inputs { strict_remote: true, ..inputs(false, 6) };
    let mut machine = machine();
    machine.react(Tick::ZERO, &Inputs { enable: false, ..strict });
    assert_eq!(machine.state, State::SwitchOnInhibit);
    machine.react(Tick::ZERO, &strict);
    assert_eq!(machine.state, State::Ready);
    machine.trip(Tick::ZERO, 0x0500);
    machine.settle(millis(16_000), &strict);
    machine.react(millis(16_000), &Inputs { word: 0x80, enable: false, ..strict });
    assert_eq!(machine.state, State::Fault);
}

#[test]
fn losing_the_enable_coasts_to_switched_on() {
    let mut machine = running(&inputs(true, 0));
    machine.react(millis(2_000), &Inputs { enable: false, ..inputs(true, 0xF) });
    assert_eq!((machine.state, machine.shaft.powered(), machine.shaft.speed()), (State::SwitchedOn, false, 1_000));
    // The word still stands.
    machine.react(millis(2_500), &inputs(true, 0xF));
    assert_eq!((machine.state, machine.shaft.ramp()), (State::Enabled, 500));
}

#[test]
fn losing_the_mains_while_running_is_a_fault_of_the_acu() {
    let mut machine = running(&inputs(true, 0));
    machine.react(millis(2_000), &Inputs { mains: false, ..inputs(true, 0xF) });
    assert_eq!((machine.state, machine.fault), (State::FaultReaction, 0x0702));
}

#[test]
fn a_fault_is_locked_for_15_seconds_and_needs_an_edge() {
    let mut machine = running(&inputs(true, 0));
    machine.trip(millis(2_000), 0x0500);
    machine.trip(millis(2_000), 0x0501);
    assert_eq!((machine.state, machine.shaft.powered(), machine.shaft.speed()), (State::FaultReaction, false, 1_000));
    machine.settle(millis(2_100), &inputs(true, 0));
    assert_eq!((machine.state, machine.shaft.speed()), (State::Fault, 900));
    machine.react(millis(16_999), &inputs(true, 0x80));
    machine.react(millis(18_000), &inputs(true, 0x80));
    assert_eq!((machine.state, machine.fault), (State::Fault, 0x0500));
    machine.react(millis(18_001), &inputs(true, 0));
    machine.react(millis(18_002), &inputs(true, 0x80));
    assert_eq!((machine.state, machine.fault), (State::SwitchOnInhibit, 0));
}

#[test]
fn a_reset_with_a_start_command_starts() {
    let mut machine = machine();
    machine.trip(Tick::ZERO, 0x0500);
    machine.settle(millis(15_000), &inputs(true, 0));
    machine.react(millis(15_000), &inputs(true, 0x8F));
    assert_eq!(machine.state, State::Enabled);
}

#[test]
fn positioning_has_no_short_cut_and_needs_no_start_contact() {
    let positioning = Inputs { positioning: true, right: false, ..inputs(true, 0) };
    let mut machine = machine();
    for (word, state) in
        [(0xF, State::SwitchOnInhibit), (6, State::Ready), (7, State::SwitchedOn), (0xF, State::Enabled)]
    {
        machine.react(Tick::ZERO, &Inputs { word, ..positioning });
        assert_eq!(machine.state, state);
    }
    // Contacts know no positioning (CM-485 manual 10.1).
    machine.react(Tick::ZERO, &Inputs { control: Control::Contacts, ..positioning });
    machine.settle(millis(60_000), &Inputs { control: Control::Contacts, ..positioning });
    assert_eq!(machine.state, State::SwitchedOn);
}

#[test]
fn contacts_show_three_states_only() {
    let mut machine = machine();
    let contacts = Inputs { control: Control::Contacts, ..inputs(false, 0) };
    machine.react(Tick::ZERO, &contacts);
    assert_eq!(machine.state, State::Enabled);
    machine.react(millis(1_000), &Inputs { right: false, ..contacts });
    machine.settle(millis(60_000), &Inputs { right: false, ..contacts });
    assert_eq!(machine.state, State::SwitchedOn);
    machine.react(millis(60_000), &Inputs { control: Control::Keypad, ..contacts });
    assert_eq!(machine.state, State::SwitchedOn);
}

#[test]
fn an_overload_takes_the_speed_away() {
    let heavy = Inputs { motor: Motor::new(5_000, 1_390, 2, 8, 200, false), ..inputs(true, 0xF) };
    let mut machine = running(&inputs(true, 0));
    machine.react(millis(2_000), &heavy);
    machine.settle(millis(4_000), &heavy);
    assert_eq!((machine.state, machine.shaft.ramp()), (State::Enabled, 0));
    machine.react(millis(4_000), &inputs(true, 0xF));
    machine.settle(millis(6_000), &inputs(true, 0xF));
    assert_eq!(machine.shaft.speed(), 1_000);
}
