//! Who decides a setting, and what is refused.

use super::*;

#[test]
fn flags_beat_environment_beats_files() {
    let directory = tempfile::tempdir().unwrap();
    std::fs::write(
        directory.path().join("antrieb.toml"),
        "port = \"/dev/ttyS9\"\nbaud = 9600\nlang = \"de\"\n[drives.pump]\naddress = 7\nparity = \"odd\"\n",
    )
    .unwrap();
    let mut environment = Environment { directory: directory.path().to_owned(), ..Environment::default() };
    let settings = Settings::resolve(&Globals::default(), &environment).unwrap();
    assert_eq!(settings.port, Some(Port::Serial("/dev/ttyS9".to_owned())));
    assert_eq!(settings.addresses, Addresses::Named(vec![7]));
    assert_eq!(settings.line.to_string(), "9600 8O1");
    assert_eq!(settings.lang, Lang::De);

    environment.variables.insert("ANTRIEB_PORT".to_owned(), "sim".to_owned());
    let flags = Globals { baud: Some(Auto::Is(57_600)), address: Some("3".to_owned()), ..Globals::default() };
    let settings = Settings::resolve(&flags, &environment).unwrap();
    assert_eq!(settings.port, Some(Port::Sim(None)));
    assert_eq!(settings.addresses, Addresses::Named(vec![3]));
    assert_eq!(settings.line.to_string(), "57600 8E1");
}

#[test]
fn a_gateway_speaks_modbus_tcp_and_a_serial_line_does_not() {
    let resolve = |port: &str, protocol: Option<&str>| {
        let globals =
            Globals { port: vec![port.parse().unwrap()], protocol: protocol.map(str::to_owned), ..Globals::default() };
        let settings = Settings::resolve(&globals, &Environment::default());
        settings.map(|settings| settings.protocol.name()).map_err(|failure| failure.code)
    };
    assert_eq!(resolve("mbtcp://gateway", None), Ok("mbtcp"));
    assert_eq!(resolve("mbtcp://gateway", Some("mbtcp")), Ok("mbtcp"));
    assert_eq!(resolve("tape:run.trace", Some("mbtcp")), Ok("mbtcp"));
    assert_eq!(resolve("tcp://server:4001", None), Ok("rtu"));
    for (port, protocol) in [("mbtcp://gateway", "rtu"), ("mbtcp://gateway", "auto"), ("/dev/ttyS0", "mbtcp")] {
        assert_eq!(resolve(port, Some(protocol)), Err("usage.protocol".into()), "{port} {protocol}");
    }
}

#[test]
fn who_switches_the_direction_comes_from_flags_environment_and_files() {
    let directory = tempfile::tempdir().unwrap();
    let file = "rs485 = \"kernel\"\nrs485_before = \"1ms\"\nrs485_after = \"2ms\"\n";
    std::fs::write(directory.path().join("antrieb.toml"), file).unwrap();
    let mut environment = Environment { directory: directory.path().to_owned(), ..Environment::default() };
    environment.variables.insert("ANTRIEB_RS485".to_owned(), "rts".to_owned());
    let flags = Globals { rs485_after: Some(Span::from_millis(3)), ..Globals::default() };
    let rs485 = Settings::resolve(&flags, &environment).unwrap().rs485;
    let expected = Rs485 { mode: Rs485Mode::Rts, before: Span::from_millis(1), after: Span::from_millis(3) };
    assert_eq!(rs485, expected);

    environment.variables.insert("ANTRIEB_RS485".to_owned(), "automatic".to_owned());
    let failure = Settings::resolve(&flags, &environment).unwrap_err();
    assert!(failure.to_string().contains("expected auto, kernel, rts or adapter, got 'automatic'"), "{failure}");
    environment.variables.clear();
    let flags = Globals { rs485_before: Some(Span::from_millis(101)), ..Globals::default() };
    assert!(Settings::resolve(&flags, &environment).unwrap_err().to_string().contains("at most 100ms"));
}

#[test]
fn errors_in_files_name_line_and_column() {
    let directory = tempfile::tempdir().unwrap();
    std::fs::write(directory.path().join("antrieb.toml"), "baud = 9600\nspeed = 1\n").unwrap();
    let environment = Environment { directory: directory.path().to_owned(), ..Environment::default() };
    let failure = Settings::resolve(&Globals::default(), &environment).unwrap_err();
    assert_eq!(failure.class, Class::Data);
    assert!(failure.to_string().contains("antrieb.toml:2:1: unknown field `speed`"), "{failure}");
}
