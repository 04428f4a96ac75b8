//! Which commands of the pages end otherwise than with 0, say something that is worth a look, or cannot be run here, and why.

use crate::files;

/// How a command is to end.
#[derive(Clone, Copy)]
pub(crate) enum How {
    /// With this code.
    Exits(i32),
    /// With 0, where this program is installed.
    Needs(&'static str),
    /// It is not run, for this reason.
    Left(#[expect(dead_code, reason = "whoever reads the table reads it")] &'static str),
}

/// What is to be known of a command.
#[derive(Clone, Copy)]
pub(crate) struct Row<'t> {
    pub(crate) page: &'t str,
    /// The end of its line, as far as no other line of the page ends so.
    pub(crate) typed: &'t str,
    pub(crate) how: How,
    /// What is said by it. Of a command that goes on beside the next one: the file that shows that it is there.
    pub(crate) tells: &'static str,
    /// What stands here in place of what is typed: a port, or a time, where it is that of the wall clock.
    pub(crate) but: &'static [(&'static str, &'static str)],
    /// What stands behind it here: an end for what has none.
    pub(crate) more: &'static str,
    /// Files that are written before.
    pub(crate) files: &'static [(&'static str, &'static str)],
}

impl<'t> Row<'t> {
    /// A command that ends with 0.
    pub(crate) const fn new(page: &'t str, typed: &'t str) -> Self {
        Row { page, typed, how: How::Exits(0), tells: "", but: &[], more: "", files: &[] }
    }

    const fn exits(self, code: i32) -> Self {
        Row { how: How::Exits(code), ..self }
    }

    const fn needs(self, program: &'static str) -> Self {
        Row { how: How::Needs(program), ..self }
    }

    const fn left(self, why: &'static str) -> Self {
        Row { how: How::Left(why), ..self }
    }

    const fn tells(self, tells: &'static str) -> Self {
        Row { tells, ..self }
    }

    const fn but(self, but: &'static [(&'static str, &'static str)]) -> Self {
        Row { but, ..self }
    }

    const fn more(self, more: &'static str) -> Self {
        Row { more, ..self }
    }

    const fn files(self, files: &'static [(&'static str, &'static str)]) -> Self {
        Row { files, ..self }
    }
}

const fn readme(typed: &'static str) -> Row<'static> {
    Row::new("README.md", typed)
}

const fn can(typed: &'static str) -> Row<'static> {
    Row::new("docs/can.md", typed)
}

const fn stored(typed: &'static str) -> Row<'static> {
    Row::new("docs/parameter-files.md", typed)
}

const fn plant(typed: &'static str) -> Row<'static> {
    Row::new("docs/plant.md", typed)
}

const fn dp(typed: &'static str) -> Row<'static> {
    Row::new("docs/profibus.md", typed)
}

const fn sniffing(typed: &'static str) -> Row<'static> {
    Row::new("docs/sniffing.md", typed)
}

const fn bus(typed: &'static str) -> Row<'static> {
    Row::new("docs/system-bus.md", typed)
}

/// What runs for ever gets an end; what a run lasts is time of the wall, and need not be waited for here.
const SHORT: &[(&str, &str)] = &[("5s", "300ms")];

/// Pages that another test runs as a whole.
pub(crate) const ELSEWHERE: &[(&str, &str)] = &[("docs/scripting.md", "tests/peers/scripts.py")];

/// Each command begins with its bench as it is, so nothing that one has written is there for the next one but its files.
pub(crate) const ROWS: &[Row<'static>] = &[
    readme("cargo install --path .").left("it builds and installs the program"),
    readme("-p /dev/ttyUSB0 scan --baud auto --parity auto --protocol auto --until-first")
        .but(&[("/dev/ttyUSB0", "sim:fresh.bench")])
        .tells("19200 7E1  vabus        1  act"),
    readme("scan --baud auto --parity auto --protocol auto")
        .but(&[("/dev/ttyUSB0", "sim:factory.bench")])
        .tells("19200 8E1  rtu          1  act"),
    readme("read 372@2 481 @actual").tells("Stator frequency"),
    readme("376@4=1.5kW").tells("verified"),
    readme("--json diag --check").tells("\"ok\": true"),
    readme("25Hz --enable --until reached --hold --on-exit quick-stop --watchdog 2s")
        .more(" --duration 300ms")
        .tells("quick-stop (end), acknowledged"),
    readme("monitor --interval 200ms").more(" --count 2").tells("4 samples in 2 rounds"),
    readme("decode fault F0700 --lang de").tells("Abhilfe"),
    readme("protocol set rtu").but(&[("/dev/ttyUSB0", "sim:fresh.bench")]).tells("moved"),
    readme("line set --baud 115200 --parity odd --address 5")
        .but(&[("/dev/ttyUSB0", "sim:factory.bench")])
        .tells("answers at  rtu 115200 8O1, address 5"),
    readme("antrieb plan").files(&[("antrieb.toml", files::PLANT)]).exits(1).tells("1390"),
    readme("antrieb apply").tells("done"),
    readme("antrieb check").exits(1).tells("different"),
    readme("-a @pumps diag").tells("drive 3 (act)"),
    readme("-a 3 identify").but(SERVO).tells("Lexium"),
    readme("--until reached --duration 1s").but(SERVO).tells("16384"),
    readme("--duration 5s --on-exit ramp").but(SERVO_SHORT).tells("ramp (end), acknowledged"),
    readme("--view --step 0.5Hz --min 0Hz --max 25Hz").exits(8).tells("--view needs a terminal"),
    readme("--dead-man").exits(8).tells("--dead-man needs a terminal"),
    readme("--output ~/.config/antrieb/catalogues/mine.toml"),
    readme("-a pump read 370 371 420-423")
        .but(&[("antrieb -a pump", "cp project.toml antrieb.toml; antrieb -a pump")])
        .tells("Bemessungsspannung"),
    can("-a 5 read 411 @actual").tells("Switched on"),
    can("write 480@1=6Hz").tells("verified"),
    can("-a master read 411")
        .but(&[("can:can0", "sim:master.bench --protocol sdo")])
        .files(&[("master.bench", files::MASTER)])
        .tells("Status word"),
    can("line set --address 9").tells("address 9"),
    can("line set --baud 250000").tells("250 kbit/s"),
    can("protocol set sdo1").tells("sdo1"),
    can("sniff --duration 1m").but(HEARD_CAN).files(&[("asked.bench", files::ASKED)]).tells("SDO2 node 5"),
    can("--pcap bus.pcap").but(HEARD_CAN).more(" --duration 10s").tells("P.1599@0: error 11"),
    can("decode trace bus.txt --candump bus.log").tells("SDO2 node 5"),
    can("sudo ip link set can0 up type can bitrate 500000").left("a CAN interface, and root"),
    can("-b 500000 scan").tells("found acu at 5"),
    can("simulate --can --link adapter &").but(&[("adapter &", "adapter --duration 1m &")]).tells("adapter"),
    can("-p slcan:adapter -b 500000 -a 1 read 411").tells("Status word"),
    Row::new("docs/first-day.md", "dataset save pump.toml").tells("pump.toml"),
    Row::new("docs/first-day.md", "report pump.html").tells("file: pump.html"),
    stored("dataset save pump.toml").tells("pump.toml"),
    stored("dataset save 'drive-{address}.toml'").tells("drive-2.toml"),
    stored("dataset check pump.toml").tells("different  0"),
    stored("dataset diff pump.toml drive").tells("different  0"),
    stored("dataset diff old.toml new.toml").exits(1).tells("1400"),
    stored("dataset diff factory 2").exits(1).tells("1 value differs"),
    stored("dataset diff drive:3 drive:4 --unified").exits(1).tells("+\"480@2\" = \"4.00 Hz\""),
    stored("dataset diff 1 2 --unified").exits(1).tells("+\"480\" = \"3.00 Hz\""),
    stored("dataset load base.toml pump.toml").tells("done"),
    stored("dataset load base.toml --only motor,ramps --sets 1,2").tells("done"),
    stored("dataset load base.toml --ram").tells("done"),
    stored("dataset undo base.undo.toml").tells("done"),
    stored("dataset load base.toml").tells("done"),
    stored("-a all dataset load 'drive-{address}.toml'").files(&[("antrieb.toml", files::NAMES)]),
    plant("-p sim init").tells("antrieb.toml"),
    plant("-a act-1 dataset save act-1.toml").tells("act-1.toml"),
    plant("-a act-1 read 411").tells("Status word"),
    plant("-a all diag").tells("2  acu    Switched on"),
    plant("antrieb plan").but(&[("antrieb plan", "cp plant.toml antrieb.toml; antrieb plan")]).exits(1).tells("1390"),
    plant("-a pump plan --only motor,ramps").exits(1).tells("1390"),
    plant("antrieb apply --yes").tells("done"),
    plant("-a pump dataset undo pump.undo.toml --yes").tells("undo"),
    plant("antrieb check").exits(1).tells("different"),
    Row::new("docs/packages.md", "sudo apt install ./antrieb_0.1.0-1_amd64.deb")
        .left("root, and a package: packaging/try"),
    Row::new("docs/packages.md", "/etc/udev/rules.d/").left("root, and a package: packaging/try"),
    Row::new("docs/packages.md", "\"$USER\"").left("root"),
    Row::new("docs/procedures.md", "procedure list").tells("first-contact"),
    Row::new("docs/procedures.md", "first-contact --dry-run").tells("a dry run"),
    Row::new("docs/procedures.md", "watchdog=2s").tells("procedure-first-contact-1.json"),
    Row::new("docs/procedures.md", "--procedure procedure-first-contact-1.json").tells("file: pump.html"),
    dp("--baud 19200 profibus live").tells("3     slave  0BE7"),
    dp("-a 3 profibus live").tells("Get_Cfg"),
    dp("profibus live --follow").more(" --duration 2s").tells("came"),
    dp("--baud auto scan").tells("19200 8E1  dp           3"),
    dp("identify --gsd HITA0BE7.GSD").tells("0BE7"),
    dp("sniff --cfg ppo1").but(HEARD_DP).tells("Data_Exchange"),
    dp("sniff --filter 'address=3' --duration 1m").but(HEARD_DP).tells("station 3"),
    dp("--cfg ppo2 --interval 0").more(" --count 3 --unpaced").tells("3 samples in 3 rounds"),
    dp("read F002 --gsd HITA0BE7.GSD").tells("Acceleration time 1"),
    dp("write F002=5s 915.1=34").tells("verified"),
    dp("read F002 614 703 915.1").tells("PZD mapping, written"),
    dp("--cfg ppo2").tells("control mode  P.928"),
    dp("--protocol dp statemachine").tells("control mode  P.928"),
    dp("--drive l200 statemachine --mode basic").tells("state  Stop"),
    dp("dataset save mixer.toml").tells("not in the file"),
    dp("dataset check mixer.toml").tells("different  0"),
    dp("dataset load mixer.toml").tells("done"),
    dp("dataset undo mixer.undo.toml").files(&[("mixer.undo.toml", files::UNDO)]).tells("done"),
    dp("dataset diff 1 2").exits(1).tells("differ in 6 parameters"),
    dp("--hold --duration 5s --take-control --watchdog 2s").but(SHORT).tells("(end), acknowledged"),
    dp("-30% --jog 5s --take-control").but(SHORT).tells("(end), acknowledged"),
    dp("--protocol dp statemachine disable").tells("ramp (end), acknowledged"),
    dp("--protocol dp statemachine reset").but(TRIPPED).tells("Fault -> Ready to switch on"),
    dp("--jog 5s --mode basic --set F002=5s --set F003=5s").but(&[("--jog 5s", "--jog 300ms")]),
    dp("--mode basic reset").but(TRIPPED).tells("Fault -> Stop"),
    dp("--mode basic disable").tells("ramp (end), acknowledged"),
    dp("--protocol dp diag").tells("LED3, trip      green: no trip"),
    dp("diag --mode basic --check").tells("LED3, trip      green: no trip"),
    dp("--protocol dp monitor --interval 0").more(" --count 3 --unpaced").tells("3 samples in 3 rounds"),
    dp("--record run.csv").more(" --count 3 --unpaced").tells("3 samples in 3 rounds"),
    dp("--trigger 'actual > 20Hz'").more(" --count 3 --unpaced").tells("3 samples in 3 rounds"),
    dp("simulate --profibus --link drive --duration 1m")
        .but(&[("1m", "100ms")])
        .tells("l200 behind an SJ2-PB at address 3"),
    Row::new("docs/feeding.md", "--gather stdin --reconnect --format influx")
        .files(&[("rounds", "\n\n")])
        .more(" < rounds")
        .tells("antrieb,address=2,family=acu"),
    Row::new("docs/feeding.md", "--gather stdin --unpaced --format csv").tells("2,2,acu,switched-on"),
    Row::new("docs/feeding.md", "--textfile drives.prom --count 3 --unpaced").tells("6 samples in 3 rounds"),
    Row::new("docs/recording.md", "--record run.ndjson").tells("81 samples"),
    Row::new("docs/recording.md", "--trigger 'state -> fault' --once").tells("no trigger came true"),
    Row::new("docs/recording.md", "plot docs/examples/record.csv").tells("411 > 8"),
    Row::new("docs/recording.md", "--svg ramp.svg").tells("picture: ramp.svg"),
    Row::new("docs/report.md", "--record ramp.ndjson").tells("file: plant.md"),
    Row::new("docs/report.md", "--changed --lang de").tells("Datei: pump.html"),
    sniffing("--statistics 10s").tells("addr  asked  replies"),
    sniffing("sniff --search").but(&[("/dev/ttyUSB0", "sim:busy.bench")]).more(" --duration 2s").tells("8E1"),
    sniffing("'address=3 !reply'").tells("4 telegrams"),
    sniffing("--trigger refused --pre 1s --post 1s --once").tells("refused"),
    sniffing("wireshark -k -i - -d rtacser.data,mbrtu")
        .but(&[("| wireshark -k -i - -d rtacser.data,mbrtu", "> line.pcap")]),
    sniffing("tshark -r line.pcap -d rtacser.data,mbrtu").needs("tshark").tells("Modbus"),
    bus("systembus plan bus.toml").tells("385  drive-1 TxPDO1"),
    bus("--settings").tells("TxPDO3 Long2"),
    bus("--dcf . --svg bus.svg").tells("picture  bus.svg"),
    bus("drive-1.dcf drive-2.dcf").tells("385  drive-1 TxPDO1"),
    bus("-a 1,2 systembus show").tells("TxPDO1"),
    bus("systembus check bus.toml").exits(1).tells("values differ"),
    bus("apply bus.toml drive-2=3").tells("done"),
    bus("monitor bus.toml")
        .but(&[("slcan:/dev/ttyACM0", "sim:pdo.bench --protocol sdo")])
        .more(" --duration 1s")
        .tells("drive-1 TxPDO1"),
    bus("nmt start --node 5").tells("Operational"),
    bus("systembus load").tells("load of one TxPDO in %"),
    bus("-a 1 dataset save drive.toml").tells("drive.toml"),
    bus("plot drive.toml").tells("%"),
    bus("--svg input.svg").tells("picture: input.svg"),
];

const SERVO: &[(&str, &str)] = &[("/dev/ttyUSB0", "sim:servo.bench")];
const SERVO_SHORT: &[(&str, &str)] = &[("/dev/ttyUSB0", "sim:servo.bench"), ("--duration 5s", "--duration 300ms")];
const TRIPPED: &[(&str, &str)] = &[("/dev/ttyUSB0", "sim:tripped.bench")];
const HEARD_DP: &[(&str, &str)] = &[("/dev/ttyUSB0", "tape:heard.txt")];
const HEARD_CAN: &[(&str, &str)] = &[("slcan:/dev/ttyACM0", "sim:asked.bench --protocol sdo")];
