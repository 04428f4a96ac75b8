//! The catalogue of the LXM05 against its Modbus manual.
//!
//! Addresses and names are copied from the project's fact base (facts/lexium05_params.csv), which is not part of the clone.

use antrieb::profile::{Access, Cause, Effective, Facts, Family, HazardKind, Lang, Registry, Route, Selector};
use std::rc::Rc;

/// Every address of the manual with the name that it prints.
const PRINTED: [(u32, &str); 36] = [
    (1284, "IOposInterfac"),
    (1544, "SPVswLimPusr"),
    (1546, "SPVswLimNusr"),
    (1554, "RAMPn_max"),
    (1556, "RAMPacc"),
    (1558, "RAMPdecel"),
    (5638, "MBbaud"),
    (5640, "MBadr"),
    (5642, "MBformat"),
    (5644, "MBnode_guard"),
    (5646, "MBdword_order"),
    (6914, "DCOMcontrol"),
    (6916, "DCOMstatus"),
    (6918, "DCOMopmode"),
    (6920, "_DCOMopmd_act"),
    (6930, "JOGactivate"),
    (6936, "HMmethod"),
    (6938, "PVn_target"),
    (6940, "PPp_targetusr"),
    (6942, "PPn_target"),
    (6944, "CURreference"),
    (6946, "SPEEDreference"),
    (6948, "GEARreference"),
    (7700, "_p_act"),
    (8200, "CUR_I_target"),
    (8456, "SPEEDn_target"),
    (9734, "GEARdenom"),
    (9736, "GEARnum"),
    (10248, "HMn"),
    (10250, "HMn_out"),
    (10504, "JOGn_slow"),
    (10506, "JOGn_fast"),
    (15362, "FLT_err_num"),
    (15364, "FLT_class"),
    (15366, "FLT_Time"),
    (15368, "FLT_Qual"),
];

fn family() -> Rc<Family> {
    Registry::open(&[]).unwrap().family("lxm05").unwrap()
}

#[test]
fn every_address_of_the_manual_is_there_and_nothing_else() {
    let family = family();
    let told: Vec<_> = family.params.values().map(|param| (param.id, param.short.as_deref().unwrap())).collect();
    assert_eq!(told, PRINTED);
}

#[test]
fn a_parameter_goes_by_address_short_name_slug_and_both_languages() {
    let family = family();
    let named = |text: &str| text.parse::<Selector>().unwrap().resolve(&family).unwrap()[0].param.id;
    for (id, short) in PRINTED {
        let param = family.param(id).unwrap();
        for name in [id.to_string(), short.to_owned(), short.to_uppercase(), param.slug.clone()] {
            assert_eq!(named(&name), id, "{name}");
        }
        for lang in [Lang::En, Lang::De] {
            assert_eq!(named(param.name(lang)), id, "{}", param.name(lang));
        }
    }
    // As the manual also prints it.
    assert_eq!([named("PpP_targetusr"), named("PPP_targetusr")], [6940, 6940]);
    assert_eq!(family.param(5644).unwrap().label(), "MBnode_guard (5644)");
}

#[test]
fn an_address_that_the_manual_does_not_name_works_raw() {
    let family = family();
    let selection = "1550".parse::<Selector>().unwrap().resolve(&family).unwrap();
    assert_eq!((selection[0].param.id, selection[0].param.is_known()), (1550, false));
    assert!(family.link.carries(1550) && !family.link.carries(65_535));
}

#[test]
fn ranges_are_printed_for_the_settings_of_the_line_only() {
    let family = family();
    let told: Vec<_> = family.params.values().filter(|param| param.min.is_some() || param.default.is_some()).collect();
    let told: Vec<_> = told.iter().map(|param| (param.id, param.min, param.max, param.default)).collect();
    let row = |id, min, max, default| (id, Some(min), Some(max), Some(default));
    let printed = [
        row(5638, 9_600, 38_400, 19_200),
        row(5640, 1, 247, 1),
        row(5642, 1, 4, 2),
        row(5644, 0, 10_000, 0),
        row(5646, 0, 1, 0),
    ];
    assert_eq!(told, printed);
}

#[test]
fn speed_and_format_act_after_power_up_and_all_of_the_line_is_marked() {
    let family = family();
    for (id, effective) in [(5638, Effective::Reset), (5640, Effective::AtOnce), (5642, Effective::Reset)] {
        assert_eq!(family.param(id).unwrap().effective, effective, "{id}");
        assert_eq!(family.param(id).unwrap().hazard, Some(HazardKind::Line), "{id}");
    }
    assert!(family.param(5644).unwrap().volatile, "not persistent, 4.1");
    for param in family.params.values().filter(|param| param.access.writes()) {
        assert!(param.hazard.is_some(), "{}: writing to a servo is never harmless", param.label());
    }
}

#[test]
fn what_is_read_only_is() {
    let family = family();
    let read_only: Vec<_> = family.params.values().filter(|param| param.access == Access::Read).collect();
    let read_only: Vec<_> = read_only.iter().map(|param| param.id).collect();
    assert_eq!(read_only, [6916, 6920, 7700, 15362, 15364, 15366, 15368]);
}

#[test]
fn every_row_and_text_is_there_in_both_languages() {
    let family = family();
    for param in family.params.values() {
        assert!(param.name.both().iter().all(|name| !name.is_empty()) && !param.source.is_empty(), "{}", param.id);
    }
    for row in &family.counters {
        assert!([&*row.en, &*row.de, &*row.help.en, &*row.help.de].iter().all(|text| !text.is_empty()), "{}", row.slug);
    }
    let subs: Vec<_> = family.counters.iter().map(|row| row.sub).collect();
    assert_eq!(subs, [11, 12, 13, 16, 17, 18]);
    for name in ["actual", "modbus", "faults", "setpoints", "motion", "all"] {
        assert!(!family.group(name).unwrap().is_empty(), "@{name}");
    }
}

#[test]
fn telegrams_carry_two_registers_a_parameter() {
    let link = &family().link;
    assert_eq!((link.route, link.cause, link.echo), (Route::Registers32, Cause::Diagnostics(2), 0));
    assert_eq!((link.route.neighbour(15_362), link.route.most()), (Some(15_364), 62));
    assert!(!link.route.has_data_sets());
}

#[test]
fn states_are_those_of_cia_402() {
    let family = family();
    for (status, state) in [
        (0x00, "not-ready"),
        (0x40, "switch-on-disabled"),
        (0x21, "ready-to-switch-on"),
        (0x23, "switched-on"),
        (0x27, "operation-enabled"),
        (0x1437, "operation-enabled"),
        (0x07, "quick-stop-active"),
        (0x0F, "fault-reaction-active"),
        (0x08, "fault"),
    ] {
        assert_eq!(family.state(status).unwrap().slug, state, "{status:04X}");
    }
}

#[test]
fn the_way_up_is_the_one_of_the_examples_and_has_no_short_cut() {
    let family = family();
    let machine = &family.machine;
    let words = |from: &str, goal: &str| {
        let way = machine.plan(from, goal, &Facts::default()).unwrap();
        let commands = way.iter().filter_map(|row| machine.command(row.command.as_deref()?));
        commands.map(|command| command.word).collect::<Vec<_>>()
    };
    assert_eq!(words("switch-on-disabled", "operation-enabled"), [0x06, 0x0F]);
    assert_eq!(words("fault", "operation-enabled"), [0x80, 0x06, 0x0F]);
    assert_eq!(words("operation-enabled", "switch-on-disabled"), [0x00]);
    assert_eq!(words("quick-stop-active", "switch-on-disabled"), [0x00]);
    assert!(machine.transition("switch-on-disabled", "enable").is_none(), "short cut 4'");
    assert_eq!(family.motion.begin.as_deref(), Some("disable-voltage"));
}

#[test]
fn the_seven_modes_are_those_of_the_examples() {
    let family = family();
    let rows: Vec<_> = family.modes.iter().map(|mode| (mode.value.unwrap(), mode.setpoint, mode.reached)).collect();
    let printed = [
        (3, 6938, None),
        (1, 6940, None),
        (6, 6936, Some(12)),
        (-3, 8200, None),
        (-4, 8456, None),
        (-2, 9736, None),
        (-1, 6930, None),
    ];
    assert_eq!(rows, printed);
    let (mode, active) = (family.role("mode").unwrap(), family.role("mode-active").unwrap());
    for (value, ..) in rows {
        assert!([mode, active].iter().all(|param| family.text_of(param, value).is_some()), "{value}");
    }
    let starts = |slug: &str| family.mode(slug).unwrap().starts.iter().map(|start| start.word).collect::<Vec<_>>();
    assert_eq!((starts("position"), starts("homing")), (vec![0x1F, 0x5F], vec![0x1F]));
}

#[test]
fn an_entry_of_the_fault_memory_counts_only_in_a_fault() {
    let family = family();
    assert_eq!(family.present_fault(Some(0x27), 0xA300), None);
    assert_eq!(family.present_fault(Some(0x08), 0xA300), Some(0xA300));
    let act = Registry::open(&[]).unwrap().family("act").unwrap();
    assert_eq!((act.present_fault(Some(0x27), 0x0500), act.present_fault(Some(0x27), 0)), (Some(0x0500), None));
}
