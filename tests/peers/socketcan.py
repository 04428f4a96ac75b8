"""CAN interfaces of a kernel: vcan, and the kernel's own driver for adapters that speak SLCAN with our simulated adapter behind it, beside
can-utils.

The kernel of the machine may have no CAN, so Debian's is started for it in QEMU, without KVM and without a disk: our program and the tools are
all that there is. `.ci/run` puts the kernel below target/peers; where it or QEMU is missing these cases are left out with a word.
"""

import functools
import json
import platform
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

from harness import BINARY, TARGET, Done, Failed, LeftOut, expect, expect_in, expect_text, group

KERNEL = TARGET / "peers/kernel"
QEMU = "qemu-system-x86_64"
TOOLS = ("busybox", "ip", "candump", "cansend", "slcand")
# In the order in which they need each other.
MODULES = ("can", "can-raw", "can-dev", "vcan", "slcan")
# What the machine may take until the guest is over; it needs ten seconds on a quiet one. A step that hangs is ended in the guest, and fails.
PATIENCE_S = 140

# What runs in the guest, one after the other: a name, and the words of a shell. What goes on beside others ends with the machine.
ASKS = "antrieb --no-config --json --port"
STEPS = {
    "missing": f"{ASKS} can:can7 -b 500000 -a 1 read 411",
    "ethernet": f"{ASKS} can:lo -b 500000 -a 1 read 411",
    "down": f"{ASKS} can:vcan0 -b 500000 -a 1 read 411",
    "up": "ip link set vcan0 up && (candump -L vcan0 >vcan.log &) && sleep 1",
    "nobody": f"{ASKS} can:vcan0 -b 500000 --drive acu -a 5 --retries 0 read 411",
    "log of a question": "sleep 0.2; cat vcan.log",
    "talk": "(for i in $(seq 12); do for frame in $TALK; do cansend vcan0 $frame; done; sleep 0.5; done) & "
    f"{ASKS} can:vcan0 -b 500000 systembus monitor --duration 4s",
    "log of listening": "cat vcan.log",
    "adapter": "(antrieb --no-config --json simulate --can --link adapter --for 120s bench.toml >served 2>&1 &); "
    "for i in $(seq 50); do test -e adapter && break; sleep 0.1; done; "
    "slcand -o -c -s6 $(readlink adapter) slcan0; sleep 1; ip link set slcan0 up && (candump -L slcan0 >slcan.log &) && sleep 0.5",
    "reads": f"{ASKS} can:slcan0 -b 500000 -a 1 read 411 480@1",
    "writes": f"{ASKS} can:slcan0 -b 500000 -a 1 --yes write 480@1=6.5Hz",
    "scans": f"{ASKS} can:slcan0 -b 500000 scan",
    "decodes": "antrieb --no-config --json decode trace slcan.log",
    "log of the bus": "cat slcan.log",
    "taken away": "(sleep 5; ip link set slcan0 down) & antrieb --no-config --port can:slcan0 -b 500000 -a 1 "
    "--format ndjson monitor 411 --duration 30s",
    "another rate": "/bin/ip link set slcan0 type can bitrate 250000; /bin/ip link set slcan0 up; "
    f"{ASKS} can:slcan0 -b 500000 -a 1 read 411",
}
# What others say on vcan0: a boot-up, a PDO, an emergency, a frame of 29 bits.
TALK = ("705#00", "185#0102030405060708", "085#0010801022000000", "12345678#01")
BENCH = """
[[drive]]
model = "acu"
address = 1

[[drive]]
model = "acu"
address = 2
"""

INIT = """#!/bin/busybox sh
/bin/busybox --install -s /bin
export PATH=/bin HOME=/ LC_ALL=C.UTF-8 TALK="{talk}"
mount -t proc proc /proc; mount -t sysfs sys /sys; mount -t devtmpfs dev /dev; mkdir -p /dev/pts /tmp; mount -t devpts pts /dev/pts
for module in {modules}; do insmod /modules/$module.ko; done
ip link add vcan0 type vcan
cd /tmp; cp /bench.toml .
{steps}
poweroff -f
"""
STEP = """timeout 60 sh -c '{words}' >/out 2>/err; code=$?
(echo "@@ {name}"; cat /out; echo "@@ err"; cat /err; echo "@@ code $code") >/dev/ttyS1
"""


def missing():
    """What is not there of what the guest needs, in a word."""
    if platform.machine() != "x86_64":
        return "a machine with x86_64"
    tools = [tool for tool in (QEMU, "cpio", *TOOLS) if not shutil.which(tool)]
    if tools:
        return ", ".join(tools)
    modules = [f"{name}.ko" for name in MODULES if not module(name)]
    return None if kernel() and not modules else f"a kernel below {KERNEL}, with {', '.join(modules) or 'its image'}"


def kernel():
    return next(iter(sorted(KERNEL.glob("boot/vmlinuz-*"))), None)


def module(name):
    return next(KERNEL.glob(f"**/{name}.ko"), None)


def libraries(program):
    """The files that a program loads, by the linker's own word."""
    told = subprocess.run(["ldd", program], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout
    return set(re.findall(r"(/\S+)", told))


def machine(root):
    """What the guest finds: our program, the tools, modules of the kernel, and what to do."""
    for folder in ("bin", "modules", "proc", "sys", "dev", "tmp"):
        (root / folder).mkdir()
    for program in (BINARY, *map(shutil.which, TOOLS)):
        place = root / "bin" / Path(program).name
        shutil.copy(program, place)
        for library in libraries(program):
            (root / library[1:]).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(library, root / library[1:])
    shutil.move(root / "bin" / BINARY.name, root / "bin/antrieb") if BINARY.name != "antrieb" else None
    for name in MODULES:
        shutil.copy(module(name), root / "modules")
    (root / "bench.toml").write_text(BENCH)
    steps = "".join(STEP.format(name=name, words=words) for name, words in STEPS.items())
    (root / "init").write_text(INIT.format(modules=" ".join(MODULES), talk=" ".join(TALK), steps=steps))
    (root / "init").chmod(0o755)


@functools.cache
def told():
    """Runs the guest, once; how each step ended, by its name."""
    with tempfile.TemporaryDirectory(prefix="antrieb-peers-") as folder:
        root, image, said = (Path(folder) / name for name in ("root", "image", "said"))
        root.mkdir()
        machine(root)
        names = "\n".join(str(path.relative_to(root)) for path in sorted(root.rglob("*")))
        with image.open("wb") as out:
            subprocess.run(["cpio", "-o", "-H", "newc", "--quiet"], input=names.encode(), stdout=out, cwd=root, check=True)
        words = [QEMU, "-m", "1024", "-display", "none", "-no-reboot", "-nic", "none", "-kernel", kernel(), "-initrd", image]
        words += ["-append", "console=ttyS0 quiet panic=-1", "-serial", "stdio", "-serial", f"file:{said}"]
        try:
            guest = subprocess.run(words, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, timeout=PATIENCE_S)
            console, late = guest.stdout.decode(errors="replace"), False
        except subprocess.TimeoutExpired as error:
            console = (error.stdout or b"").decode(errors="replace")
            late = True
        text = said.read_text(errors="replace").replace("\r", "") if said.exists() else ""
    steps = re.findall(r"@@ (.*)\n([\s\S]*?)@@ err\n([\s\S]*?)@@ code (\d+)\n", text)
    return {name: (out, err, int(code)) for name, out, err, code in steps} | {"": (console, "", int(late))}


def step(name):
    """How a step of the guest ended."""
    ended = told()
    console, _, late = ended[""]
    if name not in ended and late:
        raise LeftOut(f"this machine is too slow for the guest, which was not over after {PATIENCE_S} s")
    if name not in ended:
        raise Failed(f"the guest never came to '{name}':\n{console[-4000:]}")
    out, err, code = ended[name]
    return Done(["guest:", STEPS[name]], code, out, err, 0.0)


def frames(log):
    """What stands in a log of candump."""
    return [line.split()[2] for line in log.splitlines()]


MISSING = missing()
if MISSING is None:
    case = group("SocketCAN")
else:
    print(f"SocketCAN: left out, without {MISSING}", flush=True)

    def case(_title):
        return lambda function: function


@case("an interface that is missing, none of CAN, or down: each is told as what it is")
def _():
    codes = [step(name).exits(3).error["code"] for name in ("missing", "ethernet", "down")]
    expect("codes", codes, ["port.not_found", "port.no_can", "port.can_down"])


@case("vcan: a question is one frame on the bus, and nothing else goes out")
def _():
    expect("whom nobody answers", step("nobody").exits(4).error["code"], "silence.no_reply")
    expect("frames that candump saw", frames(step("log of a question").out), ["645#409B010000000000"])


@case("vcan: who listens hears everybody and says nothing")
def _():
    heard = step("talk").exits(0).data["heard"]
    wanted = sorted(int(frame.split("#")[0], 16) for frame in TALK)
    expect("identifiers that were heard", sorted(row["identifier"] for row in heard), wanted)
    said = set(frames(step("log of listening").out)) - {"645#409B010000000000"}
    expect("what candump saw besides", said, set(TALK))


@case("our simulated drives behind the kernel's driver for SLCAN: read, written, found")
def _():
    expect("P.480", step("reads").exits(0).data["values"][1]["raw"], 500)
    expect("a write", step("writes").exits(0).data["values"][0]["result"], "verified")
    drives = step("scans").exits(0).data["drives"]
    expect("drives", [(row["address"], row["drive"]) for row in drives], [(1, "acu"), (2, "acu")])


@case("what candump recorded of it is nothing but SDO2, and is taken apart")
def _():
    services = {int(frame.split("#")[0], 16) & ~0x3F for frame in frames(step("log of the bus").out)}
    expect("services", services, {0x640, 0x5C0})
    expect_text("what is told of it", step("decodes").exits(0).out, "P.480@1 Fixed Frequency 1")


@case("an interface that is shut down under way is told as down")
def _():
    last = json.loads(step("taken away").exits(3).out.splitlines()[-1])
    expect_in("how it ended", last["error"]["code"], ("port.can_down", "port.lost"))


@case("an interface that was opened with another bit rate than is meant: nothing is sent")
def _():
    error = step("another rate").exits(3).error
    expect("code", error["code"], "port.can_rate")
    expect_text("what is told", error["message"], "250000 bit/s", "500000 bit/s")
