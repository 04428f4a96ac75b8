"""What `monitor` hands to other tools, taken by these tools themselves: node_exporter, promtool, InfluxDB, mosquitto. Each runs on
loopback, on a port that was free a moment ago, and ends by itself."""

import json
import shlex
import socket
import time
import urllib.error
import urllib.parse
import urllib.request
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from harness import BENCH_LIFE, BINARY, PATIENCE_S, Failed, Running, bench, expect, expect_text, group, run

case = group("receivers")


def free_port():
    with socket.create_server(("127.0.0.1", 0)) as listener:
        return listener.getsockname()[1]


@contextmanager
def serving(port, *words):
    """A server for the length of a `with`, from when it accepts connections on."""
    with Running(["timeout", BENCH_LIFE, *words]) as server:
        deadline = time.monotonic() + PATIENCE_S
        while True:
            try:
                socket.create_connection(("127.0.0.1", port), timeout=1).close()
                break
            except OSError:
                if server.process.poll() is not None or time.monotonic() > deadline:
                    raise Failed(f"{words[0]} does not listen: {server.output()}") from None
                time.sleep(0.02)
        yield server


def fetch(port, path, body=None):
    request = urllib.request.Request(f"http://127.0.0.1:{port}{path}", data=body)
    try:
        with urllib.request.urlopen(request, timeout=PATIENCE_S) as answer:
            return answer.read().decode()
    except urllib.error.HTTPError as error:
        raise Failed(f"{path}: {error} {error.read().decode()}") from None


def plant(directory, port):
    """A project file that gives the drive at address 2 a name; the words that take it."""
    file = directory / "antrieb.toml"
    file.write_text(f'[drives."main pump"]\naddress = 2\nport = "{port}"\n')
    return ["--config", file, "--port", port, "-a", "1,2"]


def watched(directory, port, *words):
    """Two rounds of two drives."""
    line = [BINARY, *plant(directory, port), "monitor", "--count", "2", "--interval", "0", *words]
    return run(*line).exits(0)


@contextmanager
def stage():
    """A directory and a bench."""
    with TemporaryDirectory(prefix="antrieb-peers-") as directory, bench() as served:
        yield Path(directory), served.port


@case("node_exporter shows the drives of a text file")
def _():
    with stage() as (directory, line):
        texts = directory / "texts"
        texts.mkdir()
        watched(directory, line, "--textfile", texts / "drives.prom")
        port = free_port()
        with serving(
            port,
            "prometheus-node-exporter",
            f"--web.listen-address=127.0.0.1:{port}",
            "--collector.disable-defaults",
            "--collector.textfile",
            f"--collector.textfile.directory={texts}",
        ):
            metrics = fetch(port, "/metrics")
    expect_text("metrics", metrics, "node_textfile_scrape_error 0\n", f'antrieb_reachable{{address="1",drive="",family="act",port="{line}"}} 1\n')
    expect_text("metrics", metrics, f'antrieb_reachable{{address="2",drive="main pump",family="acu",port="{line}"}} 1\n')
    values = [row for row in metrics.splitlines() if row.startswith("antrieb_value{") and 'name="stator-frequency"' in row]
    expect("frequencies", [row.rpartition(" ")[2] for row in values], ["0", "0"])


@case("promtool finds nothing wrong with a text file")
def _():
    with stage() as (directory, line):
        file = directory / "drives.prom"
        watched(directory, line, "--textfile", file)
        checked = run("sh", "-c", f"promtool check metrics < {shlex.quote(str(file))}").exits(0)
    expect("remarks", checked.out + checked.err, "")


@case("InfluxDB stores every line, with its tags and the time of its sample")
def _():
    with stage() as (directory, line):
        lines = watched(directory, line, "--format", "influx").out
        port, other = free_port(), free_port()
        config = directory / "influxdb.conf"
        config.write_text(
            f'reporting-disabled = true\nbind-address = "127.0.0.1:{other}"\n'
            f'[meta]\ndir = "{directory}/meta"\n[data]\ndir = "{directory}/data"\nwal-dir = "{directory}/wal"\n'
            f'[http]\nbind-address = "127.0.0.1:{port}"\n[monitor]\nstore-enabled = false\n'
        )
        with serving(port, "influxd", "-config", config):
            fetch(port, "/query", b"q=CREATE+DATABASE+drives")
            fetch(port, "/write?db=drives", lines.encode())
            asked = urllib.parse.urlencode({"db": "drives", "epoch": "ns", "q": "SELECT reachable, address, drive, family, port FROM antrieb"})
            found = json.loads(fetch(port, f"/query?{asked}"))
    series = found["results"][0]["series"][0]
    expect("columns", series["columns"], ["time", "reachable", "address", "drive", "family", "port"])
    rows = sorted(row[1:] for row in series["values"])
    expect("rows", rows, sorted([[True, "1", None, "act", line], [True, "2", "main pump", "acu", line]] * 2, key=lambda row: row[1]))
    told = sorted(int(text.rpartition(" ")[2]) for text in lines.splitlines())
    expect("times", [row[0] for row in series["values"]], told)


@case("mosquitto_pub sends every line as a message, and a subscriber gets them")
def _():
    with stage() as (directory, line):
        port = free_port()
        config = directory / "mosquitto.conf"
        config.write_text(f"listener {port} 127.0.0.1\nallow_anonymous true\npersistence false\nuser root\nlog_type all\n")
        place = ["-h", "127.0.0.1", "-p", str(port), "-t", "plant/line"]
        hears = ["timeout", BENCH_LIFE, "mosquitto_sub", *place, "-C", "6", "-q", "1"]
        with serving(port, "mosquitto", "-c", config) as broker, Running(hears) as subscriber:
            broker.wait_for("Sending SUBACK")
            ours = [BINARY, *plant(directory, line), "monitor", "--count", "2", "--interval", "0", "--format", "ndjson"]
            sends = ["mosquitto_pub", "-l", "-q", "1", *place]
            run("sh", "-c", f"{shlex.join(map(str, ours))} | {shlex.join(sends)}").exits(0)
            got = subscriber.end().exits(0).out
    records = [json.loads(text) for text in got.splitlines()]
    expect("records", [record["type"] for record in records], ["start", *["sample"] * 4, "end"])
    whose = [(record["address"], record["called"], record["drive"], record["port"]) for record in records[1:3]]
    expect("drives", whose, [(1, None, "act", line), (2, "main pump", "acu", line)])
