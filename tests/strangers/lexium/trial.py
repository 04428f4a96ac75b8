"""Trials of the tool against an independent LXM05: one line a case, and the sum at the end.

    ANTRIEB=path/to/antrieb python3 trial.py [--quick] [--only WORDS] [--jobs N] [--verbose] [--list]

Every reading of the manual and every disturbance is tried with the verbs that it
can hurt. A case fails by a hang, a crash, a wrong value, a false report, a shaft
left turning, a setting not given back, or a sin of the master (see lexium05.py).
"""

import argparse
import concurrent.futures
import signal
import sys

import judge
from judge import Trial

# Values that nobody can mistake for one another, left in the drive from before.
MARKS = "RAMPacc=4321,RAMPdecel=1111,RAMPn_max=6007,PPn_target=222,JOGn_slow=33"
MARKED = {1556: 4321, 1558: 1111, 1554: 6007, 6942: 222, 10504: 33}
READ = ["read", "RAMPacc", "RAMPdecel", "RAMPn_max", "PPn_target", "JOGn_slow", "--json"]

AT_ONE = ["-a", "1"]
ASKED = [*AT_ONE, "--yes"]

# What a line may do. The numbers are times in ms or "every n-th".
LINES = {
    "none": {},
    "late 100": {"late": 100},
    "late 400": {"late": 400},
    "late 900": {"late": 900},
    "every 3rd late 900": {"late": 900, "late_every": 3},
    "every 2nd late 600": {"late": 600, "late_every": 2},
    "every 4th lost": {"lose": 4},
    "every 3rd request lost": {"lose_request": 3},
    "every 2nd doubled at once": {"double": 2, "double_after": 0},
    "every 2nd doubled after 5": {"double": 2, "double_after": 5},
    "every 1st doubled after 20": {"double": 1, "double_after": 20},
    "every 3rd doubled after 60": {"double": 3, "double_after": 60},
    "every 2nd doubled after 200": {"double": 2, "double_after": 200},
    "every 2nd doubled after 500": {"double": 2, "double_after": 500},
    "every 5th garbled": {"garble": 5},
    "every 2nd with noise before": {"noise": 2},
    "pieces 16": {"pieces": 16},
    "echo whole": {"echo": "whole"},
    "echo behind": {"echo": "behind"},
}
# Lines on which nobody can be understood for certain: the end must come, and no wrong value.
LYING = ("doubled", "twin", "late 900", "late 600")


def forgiven(name):
    """Where replies come twice, or later than the time-out, a master cannot always wait its turn."""
    return LATE_SINS if any(word in name for word in LYING) else ()


BAD_LINES = {
    "twin after": {"twin": "after"},
    "twin late after": {"twin": "after", "twin_after": 120},
    "twin garbled": {"twin": "garbled"},
    "babble": {"babble": 20},
    "other master": {"other_master": "polls"},
    "babble colliding": {"babble": 20, "collide": "yes"},
    "other master colliding": {"other_master": "polls", "collide": "yes"},
    "silent": {"mute_at": 0.001},
}

# A master cannot know that the answer to its repeated question is still to come.
LATE_SINS = ("speaks while the drive answers", "asks while a reply is owed", "too early")

EXCEPTIONS = {f"exceptions {n}": {"exceptions": str(n)} for n in (1, 2, 3, 4)}
# Readings that a reading verb can notice.
LOOKS = {
    "plain": {},
    **EXCEPTIONS,
    "no code 43": {"fc43": "refused"},
    "code 43 silent": {"fc43": "silent"},
    "other product": {"product": "other"},
    "revision 3": {"revision_id": 3},
    "low word first": {"left": MARKS + ",MBdword_order=1"},
    "high status bits": {"family_bits": "lxm32", "status_high": 0x1234},
    "fault number moves": {"fault_number": "next", "fault_left": "curable"},
}


def marked(readings):
    return readings if "left" in readings else {**readings, "left": MARKS}


# --------------------------------------------------------------------------- looking


def reading_cases():
    yield Trial("read on a quiet line", [*AT_ONE, *READ], marked({}), values=MARKED, quick=True)
    for name, look in LOOKS.items():
        yield Trial(f"read, {name}", [*AT_ONE, *READ], marked(look), values=MARKED,
                    quick=name == "low word first")
        # Without --drive the family must be found; where nothing tells it, silence is no answer.
        exits = (0,) if "product" not in look and "fc43" not in look else (0, 1, 2, 4, 5, 6, 7, 8)
        yield Trial(f"read without --drive, {name}", [*AT_ONE, *READ], marked(look), values=MARKED,
                    drive=None, exits=exits)
        for verb in (["identify"], ["diag"], ["statemachine"], ["sollwert"]):
            yield Trial(f"{verb[0]}, {name}", [*AT_ONE, *verb, "--json"], marked(look),
                        exits=(0, 9) if "fc43" in look else (0,), wants=looks_right)
        yield Trial(f"scan, {name}", ["-a", "1-4", "scan", "--json"], marked(look), drive=None,
                    limit=20, wants=scan_finds, allowed_sins=LATE_SINS)
    for name, wrong in LINES.items():
        exits = (0,) if not any(key in wrong for key in ("lose", "garble", "lose_request")) else (0, 4, 5, 9)
        slow = [] if not wrong.get("late", 0) > 400 else ["--timeout", "1500ms"]
        yield Trial(f"read, {name}", [*slow, *AT_ONE, *READ], marked({}), wrong, values=MARKED,
                    exits=exits, limit=45, quick="doubled after 20" in name, allowed_sins=forgiven(name))
        yield Trial(f"read at 500 ms, {name}", [*AT_ONE, *READ], marked({}), wrong, values=MARKED,
                    exits=(0, 4, 5, 9), limit=60, allowed_sins=LATE_SINS if wrong.get("late", 0) > 400 else ())
        for verb in (["identify"], ["diag"], ["statemachine"], ["monitor", "RAMPacc", "RAMPdecel", "--count", "4",
                                                                "--interval", "300ms"]):
            yield Trial(f"{verb[0]}, {name}", [*slow, *AT_ONE, *verb, "--json"] if verb[0] != "monitor" else
                        [*slow, *AT_ONE, *verb, "--format", "ndjson"], marked({}), wrong,
                        exits=(0, 4, 5, 9), limit=60, wants=looks_right, allowed_sins=forgiven(name))
    for name, wrong in BAD_LINES.items():
        for verb in (READ, ["identify", "--json"], ["diag", "--json"], ["statemachine", "--json"],
                     ["diag", "line", "--count", "5", "--json"],
                     ["monitor", "RAMPacc", "--duration", "3s", "--format", "ndjson"]):
            yield Trial(f"{' '.join(verb[:2])}, {name}", [*AT_ONE, *verb], marked({}), wrong,
                        values=MARKED if verb is READ else {},
                        exits=(0, 1, 3, 4, 5, 9), limit=30, wants=looks_right, allowed_sins=forgiven(name),
                        quick=name == "babble" and verb is READ)
        yield Trial(f"scan, {name}", ["-a", "1-3", "scan", "--json"], marked({}), wrong, drive=None,
                    exits=(0, 1, 3, 4, 5, 9), limit=40, allowed_sins=LATE_SINS)
    yield Trial("scan, late 400", ["-a", "1-4", "scan", "--json"], marked({}), {"late": 400}, drive=None,
                limit=30, wants=scan_finds, allowed_sins=("asks while a reply is owed", "speaks while the drive answers"))
    yield Trial("sniff beside another master", ["sniff", "--for", "2s", "--format", "ndjson"], {},
                {"other_master": "polls"}, exits=(0, 5), limit=10)
    yield Trial("sniff on babble", ["sniff", "--for", "2s", "--format", "ndjson"], {}, {"babble": 20},
                exits=(0, 4, 5), limit=10)


def looks_right(outcome):
    """Any parameter that the document names must have the drive's value."""
    truth = {**MARKED, 5640: 1, 5638: 19200, 5644: 0}
    found, stack = [], [outcome.document]
    if "monitor" in outcome.trial.args:
        import json
        for row in outcome.out.splitlines():
            try:
                stack.append(json.loads(row))
            except ValueError:
                yield f"a line is not JSON: {row[:60]}"
    while stack:
        item = stack.pop()
        if isinstance(item, list):
            stack += item
        elif isinstance(item, dict):
            stack += item.values()
            if item.get("param") in truth and isinstance(item.get("raw"), int):
                found.append((item["param"], item["raw"]))
            word = item.get("status")
            if isinstance(word, dict) and isinstance(word.get("raw"), int):
                seen = word["raw"] & 0x6F
                if seen not in (0x40, 0x08 if outcome.trial.readings.get("fault_left", "none") != "none" else 0x40):
                    yield f"WRONG VALUE: status {word['raw']:04X}, the drive is in {outcome.device.state}"
            if isinstance(item.get("fault_code"), int) and item["fault_code"] and not outcome.device.faults:
                yield f"WRONG VALUE: fault {item['fault_code']:04X}, the drive has none"
    for param, raw in found:
        if raw != truth[param]:
            yield f"WRONG VALUE: {param} shown as {raw}, is {truth[param]}"


def scan_finds(outcome):
    drives = outcome.document["data"].get("drives", []) if outcome.document else []
    if [row.get("address") for row in drives] != [1]:
        yield f"scan shows addresses {[row.get('address') for row in drives]}, there is 1"
    elif outcome.trial.readings.get("product") is None and outcome.trial.readings.get("fc43") is None:
        if drives[0].get("drive") != "lxm05":
            yield f"scan calls it {drives[0].get('drive')}"


# --------------------------------------------------------------------------- writing


def writing_cases():
    two = ["write", "RAMPacc=2000", "RAMPdecel=3000", "--json"]
    for name, wrong in {"quiet": {}, **LINES, **BAD_LINES,
                        "every 2nd reply to a write lost": {"lose_write_reply": 2}}.items():
        bad = name in BAD_LINES
        slow = [] if not wrong.get("late", 0) > 400 else ["--timeout", "1500ms"]
        yield Trial(f"write, {name}", [*slow, *ASKED, *two], {}, wrong, back=False, limit=45,
                    exits=(0, 4, 5, 6, 8, 9) if bad or name.startswith("every") else (0,), wants=written,
                    allowed_sins=forgiven(name),
                    quick=name in ("quiet", "every 2nd reply to a write lost"))
    for name, look in {"low word first": {"left": "MBdword_order=1"}, "FC23 reads first": {"fc23_first": "reads"},
                       "FC16 before": {"fc16_refused": "before"}, "setpoints act after 300 ms": {"setpoint_lag": 300},
                       **EXCEPTIONS}.items():
        yield Trial(f"write, {name}", [*ASKED, *two], look, back=False, wants=written)
        yield Trial(f"write without --drive, {name}", [*ASKED, *two], look, back=False, wants=written, drive=None)
    for order in ("power-on", "at-once"):
        yield Trial(f"write MBdword_order=1, {order}", [*ASKED, "write", "MBdword_order=1", "--json"],
                    {"order_when": order}, back=False, exits=(0,), wants=order_stands)
        yield Trial(f"write MBdword_order and more, {order}",
                    [*ASKED, "write", "MBdword_order=1", "RAMPacc=2000", "--json"],
                    {"order_when": order}, back=False, exits=(0, 9), wants=ramp_never_swapped)
    yield Trial("write refuses 0", [*ASKED, "write", "PPn_target=0", "--json"], {}, exits=(6, 7), quick=True)
    yield Trial("write read-only", [*ASKED, "write", "_p_act=5", "--json"], {}, exits=(6, 7))
    yield Trial("write without --yes", [*AT_ONE, "write", "RAMPacc=2000", "--json"], {}, exits=(8,))
    yield Trial("write while the shaft turns", [*ASKED, "write", "RAMPacc=2000", "--json"],
                {"turning": 500.0, "ramps_turning": "refused"}, exits=(6, 8, 9),
                allowed_sins=("ramp changed while turning",), keeps=True)


def written(outcome):
    """Exit 0 only if both stand in the drive; a row that says written must be true."""
    value = outcome.device.value
    both = value["RAMPacc"] == 2000 and value["RAMPdecel"] == 3000
    if outcome.code == 0 and not both:
        yield f"exit 0, but RAMPacc {value['RAMPacc']}, RAMPdecel {value['RAMPdecel']}"
    for name, wanted, before in (("RAMPacc", 2000, 600), ("RAMPdecel", 3000, 750)):
        if value[name] not in (wanted, before):
            yield f"WRONG VALUE WRITTEN: {name} {value[name]}"


def order_stands(outcome):
    if outcome.device.value["MBdword_order"] != 1:
        yield "exit 0, but MBdword_order does not stand"


def ramp_never_swapped(outcome):
    if outcome.device.value["RAMPacc"] not in (600, 2000):
        yield f"WRONG VALUE WRITTEN: RAMPacc {outcome.device.value['RAMPacc']}"
    if outcome.code == 0 and outcome.device.value["RAMPacc"] != 2000:
        yield f"exit 0, but RAMPacc {outcome.device.value['RAMPacc']}"


# --------------------------------------------------------------------------- moving

MOVES = {
    "velocity": (["300rpm"], 300),
    "velocity backwards": (["--", "-300rpm"], 300),
    "speed": (["300", "--mode", "speed"], 300),
    "jog": (["1", "--mode", "jog"], 60),
    "gear": (["1/2", "--mode", "gear"], 300),
    "current": (["2A"], 1300),
    "position": (["8192usr"], 60),
    "homing": (["17", "--mode", "homing"], 60),
}

MOTION_READINGS = {
    "plain": {},
    "mode change accepted": {"mode_change_turning": "accepted"},
    "mode change brakes first": {"mode_change_turning": "brakes-first"},
    "mode waits for enable": {"mode_before_enable": "waits"},
    "mode refused before enable": {"mode_before_enable": "refused"},
    "setpoints zeroed": {"setpoints": "zeroed"},
    "control 7 brakes": {"control7": "brakes"},
    "control 7 refused": {"control7": "refused"},
    "guard faults": {"guard_state": "fault"},
    "guard fed by writes": {"guard_fed_by": "writes"},
    "guard acts always": {"guard_acts": "always", "guard_fed_by": "writes", "guard_state": "fault"},
    "guard not written enabled": {"guard_write": "not-enabled"},
    "bit 6 relative": {"bit6": "relative"},
    "FC23 reads first": {"fc23_first": "reads"},
    "FC16 before": {"fc16_refused": "before"},
    **EXCEPTIONS,
    "low word first": {"left": "MBdword_order=1"},
    "high status bits": {"family_bits": "lxm32", "status_high": 0x1234},
    "quick stop ends by itself": {"quick_stop_ends": "by-itself"},
    "quick stop can return": {"quick_stop_enable": "returns"},
    "short cut refused": {"short_cut": "refused"},
    "enable one by one": {"enable_steps": "one-by-one"},
    "enable takes 900 ms": {"enable_delay": 900},
    "stop takes 300 ms": {"disable_delay": 300},
    "setpoints act after 40 ms": {"setpoint_lag": 40},
    "ramps refused turning": {"ramps_turning": "refused"},
    "halt ignored": {"halt": "ignored"},
    "reached while disabled": {"reached_disabled": "1"},
    "wavers by 3": {"dither": 3},
    "speed mode ramps": {"speed_ramps": "ramps"},
    "fault number moves": {"fault_number": "next"},
    "PVn_target 900 left": {"left": "PVn_target=900,DCOMopmode=3"},
    "PVn_target 900 left, mode waits": {"left": "PVn_target=900,DCOMopmode=3", "mode_before_enable": "waits"},
    "GEARreference 1 left": {"left": "GEARreference=1,DCOMopmode=-2"},
    "GEARreference 1 left, mode 3": {"left": "GEARreference=1,DCOMopmode=3"},
    "SPEEDn_target 700 left": {"left": "SPEEDn_target=700,SPEEDreference=2,DCOMopmode=-4"},
    "analog 400": {"left": "SPEEDreference=1,DCOMopmode=-4", "analog": 400.0},
    "CUR_I_target left": {"left": "CUR_I_target=300,CURreference=2,DCOMopmode=-3"},
    "JOGactivate left": {"left": "JOGactivate=5,DCOMopmode=-1"},
}


def motion_cases():
    for move, (words, top) in MOVES.items():
        for name, readings in MOTION_READINGS.items():
            yield Trial(f"run {move}, {name}", run_words(words, "1s"), readings, stands=True,
                        exits=(0, 8) if "left" in name or "analog" in name or "one by one" in name else (0,), limit=25,
                        peak=top * 1.05 + 5, quick=name in ("plain", "low word first"), wants=moved(move))
    words = MOVES["velocity"][0]
    for move in ("velocity", "speed", "jog", "gear", "current", "position"):
        for stop in ("quick-stop", "coast"):
            for name in ("plain", "quick stop ends by itself", "control 7 refused", "setpoints zeroed",
                         "mode waits for enable", "stop takes 300 ms", "wavers by 3"):
                yield Trial(f"run {move}, {stop}, {name}", [*run_words(MOVES[move][0], "1s"), "--on-exit", stop],
                            MOTION_READINGS[name], stands=True, limit=25, quick=name == "plain" and move == "velocity")
    yield Trial("run velocity, keep", [*run_words(words, "1s"), "--on-exit", "keep"], {}, keeps=True, back=False)
    for move in ("velocity", "position", "speed", "homing"):
        for name in ("plain", "setpoints act after 40 ms", "reached while disabled", "quick stop can return"):
            yield Trial(f"until reached {move}, {name}", [*run_words(MOVES[move][0], "1s"), "--until", "reached"],
                        MOTION_READINGS[name], stands=True, limit=30, wants=reached(move),
                        exits=(0, 2) if move == "speed" else (0,))
    yield Trial("until reached, two targets", [*run_words(["32768usr"], "6s"), "--until", "reached"],
                {"left": "PPn_target=600"}, stands=True, limit=30, wants=reached("position", 2.0))
    yield Trial("relative position", [*run_words(["8192usr", "--start", "relative"], "2s"), "--until", "reached"],
                {"bit6": "relative"}, stands=True, wants=reached("position", 0.5))


def run_words(words, time):
    front = [word for word in words if word != "--"]
    options = ["--enable", "--hold", "--duration", time, "--watchdog", "1500ms", "--json"]
    return [*ASKED, "sollwert", *options, *words] if "--" in words else [*ASKED, "sollwert", *front, *options]


def moved(move):
    def look(outcome):
        if outcome.code == 0 and outcome.device.peak < 5 and outcome.device.axis.turns == 0:
            yield "exit 0, but the shaft never moved"
        if move.endswith("backwards") and outcome.code == 0 and outcome.at_end["turns"] > 0:
            yield f"the shaft went the other way: {outcome.at_end['turns']:.2f} turns"
    return look


def reached(move, turns=0.5):
    def look(outcome):
        said = (outcome.data.get("setpoint") or {}).get("reached")
        if move == "position" and said and abs(outcome.at_end["turns"] - turns) > 0.01:
            yield f"FALSE: reached, but at {outcome.at_end['turns']:.3f} turns instead of {turns}"
        if move in ("velocity", "speed") and said and outcome.device.peak < 285:
            yield f"FALSE: reached, but never faster than {outcome.device.peak:.0f} 1/min"
        if not said and outcome.code == 0:
            yield "exit 0 without reached"
    return look


# --------------------------------------------------------------------------- moving on a bad line


def rough_cases():
    words = MOVES["velocity"][0]
    for name, wrong in {**LINES, **BAD_LINES}.items():
        bad = name in BAD_LINES
        for guard in ("--watchdog", "off"):
            options = ["--watchdog", "3s"] if guard != "off" else []
            late = ["--timeout", "1500ms"] if wrong.get("late", 0) > 400 else []
            args = [*late, *ASKED, "sollwert", *words, "--enable", "--hold", "--duration", "2s", *options, "--json"]
            yield Trial(f"run on {name}, watchdog {guard}", args, {}, wrong, stands=True, limit=60,
                        exits=(0, 3, 4, 5, 6, 8, 9) if bad or "lost" in name or "garbled" in name else (0,),
                        peak=320, quick=name == "every 4th lost" and guard != "off", allowed_sins=forgiven(name))
    for name, wrong in {"babble": {"babble": 20, "babble_from": 2.5},
                        "other master": {"other_master": "polls", "babble_from": 2.5}}.items():
        for stop in ("ramp", "quick-stop", "coast"):
            args = [*ASKED, "sollwert", *words, "--enable", "--hold", "--duration", "3s", "--on-exit", stop, "--json"]
            yield Trial(f"{name} begins in the run, {stop}", args, {}, wrong, exits=(0, 3, 4, 5, 8, 9), stands=True,
                        limit=40, peak=320, after=5.0, quick=stop == "ramp" and name == "babble")
    for name, wrong in {"1 s": {"mute_enabled": 900, "mute_for": 1.0},
                        "3 s": {"mute_enabled": 900, "mute_for": 3.0},
                        "for ever": {"mute_enabled": 900}}.items():
        for cut in ("no", "yes"):
            for guard in (["--watchdog", "1s"], []):
                args = [*ASKED, "sollwert", *words, "--enable", "--hold", "--duration", "6s", *guard, "--json"]
                known = name == "for ever" and cut == "yes" and not guard
                yield Trial(f"silent {name} in the run, requests cut {cut}, {' '.join(guard) or 'no watchdog'}",
                            args, {}, {**wrong, "cut_requests": cut}, exits=(0, 3, 4, 5, 8, 9), limit=60, peak=320,
                            stands=not known, back=name != "for ever", after=3.0, wants=warned if known else None)
    for error_class in (2, 3):
        for at in (50, 300, 1200, 2050):
            args = [*ASKED, "sollwert", *words, "--enable", "--hold", "--duration", "2s", "--watchdog", "1s", "--json"]
            yield Trial(f"fault of class {error_class} {at} ms after enabling", args, {},
                        {"fault_enabled": at, "fault_class": error_class}, stands=True, limit=40, peak=320,
                        exits=(1, 6, 8, 9), after=4.0)
    for at in (0.9, 1.5, 2.5):
        args = [*ASKED, "sollwert", *words, "--enable", "--hold", "--duration", "3s", "--json"]
        yield Trial(f"power stage switched off by hand at {at}", args, {}, {"disable_at": at}, stands=True,
                    limit=40, peak=320, exits=(1, 4, 6, 8, 9), after=3.0)
    for guard in (["--watchdog", "1s"], []):
        args = [*ASKED, "sollwert", *words, "--enable", "--hold", "--duration", "6s", *guard, "--json"]
        yield Trial(f"mains fail in the run, {' '.join(guard) or 'no watchdog'}", args, {}, {"power_cycle_at": 2.0},
                    stands=True, limit=40, peak=320, exits=(1, 4, 6, 8, 9), after=5.0)
    args = [*ASKED, "sollwert", *words, "--enable", "--hold", "--duration", "8s", "--json"]
    yield Trial("adapter pulled in the run", args, {}, {"unplug_at": 2.0}, exits=(3,), limit=30, back=False,
                wants=warned)


def warned(outcome):
    if not judge.re.search("may still turn", outcome.err, judge.re.I):
        yield "stderr does not say that the shaft may still turn"


# --------------------------------------------------------------------------- stopping

STOPS = {
    "quick-stop": ["statemachine", "quick-stop"],
    "disable": ["statemachine", "disable"],
    "disable-voltage": ["statemachine", "disable-voltage"],
    "sollwert 0": ["sollwert", "0rpm"],
}


def stopping_cases():
    for verb, words in STOPS.items():
        for name in ("plain", "control 7 brakes", "control 7 refused", "quick stop ends by itself",
                     "stop takes 300 ms", "wavers by 3", "exceptions 1", "low word first"):
            exits = (0,) if not (verb == "disable" and name == "control 7 refused") else (0, 6, 8)
            yield Trial(f"{verb} on a turning shaft, {name}", [*AT_ONE, *words, "--json"],
                        {**MOTION_READINGS[name], "turning": 857.0}, exits=exits, limit=30, back=False,
                        wants=really_stopped, after=0.3, quick=name == "plain")
        for name, wrong in BAD_LINES.items():
            yield Trial(f"{verb} on a turning shaft, {name}", [*AT_ONE, *words, "--json"], {"turning": 857.0}, wrong,
                        exits=(0, 3, 4, 5, 8, 9), limit=40, back=False, wants=told_to_stop, after=3.0,
                        quick=name == "babble", allowed_sins=forgiven(name))
        for name in ("every 4th lost", "late 900", "every 1st doubled after 20", "echo whole"):
            yield Trial(f"{verb} on a turning shaft, {name}", [*AT_ONE, *words, "--json"], {"turning": 857.0},
                        LINES[name], exits=(0, 4, 5, 9), limit=40, back=False, wants=really_stopped, after=0.3,
                        allowed_sins=forgiven(name))
    for sig in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        for move in ("velocity", "gear", "position", "current"):
            args = [*run_words(MOVES[move][0], "20s")]
            yield Trial(f"{sig.name} in a run of {move}", args, {}, stands=True, exits=(130,), limit=20,
                        signals=((1.0, sig),), quick=move == "velocity" and sig == signal.SIGINT)
        args = run_words(MOVES["velocity"][0], "20s")
        for at in (0.0, 0.03, 0.1, 0.3):
            yield Trial(f"{sig.name} {at} s after enabling", args, {}, stands=True, exits=(130,), limit=20,
                        signals=((at, sig),))
        for at in (0.1, 0.25, 0.4, 0.5):
            yield Trial(f"{sig.name} {at} s after the start", args, {}, stands=True, exits=(130, 0), limit=20,
                        signals=((at, sig),), signal_from="start")
    for times in ((1.0, 1.2), (1.0, 1.2, 1.4)):
        args = run_words(["3000rpm"], "20s")
        yield Trial(f"{len(times)} times Ctrl-C", args, {"left": "RAMPacc=6000,RAMPdecel=300"}, stands=True,
                    exits=(130,), limit=25, signals=tuple((at, signal.SIGINT) for at in times), after=3.0)
    for state in ("quick-stop", "fault"):
        for fed in ("all", "writes"):
            args = [*ASKED, "sollwert", "300rpm", "--enable", "--hold", "--duration", "6s", "--watchdog", "1s", "--json"]
            yield Trial(f"tool frozen 3 s, guard {state}, fed by {fed}", args,
                        {"guard_state": state, "guard_fed_by": fed}, stands=True, exits=(1, 4, 6, 8, 9), limit=30,
                        signals=((1.0, signal.SIGSTOP), (4.0, signal.SIGCONT)), quick=fed == "all")
    run = ["sollwert", "300rpm", "--enable", "--hold", "--duration", "1s"]
    for words in (["write", "RAMPacc=2000"], run):
        for sig in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            yield Trial(f"{sig.name} at the question of {words[0]}, then y", [*AT_ONE, *words], {}, exits=(130,),
                        limit=10, typed=((3.0, "y\n"),), signals=((1.5, sig),), signal_from="start", wants=untouched,
                        quick=sig == signal.SIGINT)
        yield Trial(f"n to the question of {words[0]}", [*AT_ONE, *words], {}, exits=(8,), limit=10,
                    typed=((1.0, "n\n"),), wants=untouched)
        yield Trial(f"y to the question of {words[0]}", [*AT_ONE, *words], {}, limit=10, typed=((1.0, "y\n"),),
                    stands=True, back=False)
    for name in ("quick-stop", "disable", "disable-voltage", "sollwert 0"):
        yield Trial(f"{name} on a terminal asks nothing", [*AT_ONE, *STOPS[name]], {"turning": 857.0}, limit=15,
                    typed=(), back=False, wants=really_stopped)
    yield Trial("enable --hold on a running drive", [*ASKED, "statemachine", "enable", "--hold", "--duration", "1s",
                                                     "--json"], {"turning": 300.0}, stands=True, limit=20, back=False,
                exits=(0,), quick=True)
    yield Trial("goto --hold on a running drive", [*ASKED, "statemachine", "goto", "operation-enabled", "--hold",
                                                   "--duration", "1s", "--json"], {"turning": 300.0}, stands=True,
                limit=20, back=False, exits=(0,))
    for name, left in {"velocity": "PVn_target=900,DCOMopmode=3", "gear": "GEARreference=1,DCOMopmode=-2",
                       "jog": "JOGactivate=5,DCOMopmode=-1", "current": "CUR_I_target=300,CURreference=2,DCOMopmode=-3",
                       "speed": "SPEEDn_target=700,SPEEDreference=2,DCOMopmode=-4",
                       "analog": "SPEEDreference=1,DCOMopmode=-4"}.items():
        for before in ("acts", "waits"):
            yield Trial(f"enable with {name} left, mode {before}",
                        [*ASKED, "statemachine", "enable", "--hold", "--duration", "1s", "--json"],
                        {"left": left, "analog": 400.0, "mode_before_enable": before}, stands=True, exits=(0, 8),
                        limit=20, peak=5)
            yield Trial(f"enable without hold, {name} left, mode {before}", [*ASKED, "statemachine", "enable", "--json"],
                        {"left": left, "analog": 400.0, "mode_before_enable": before}, exits=(0, 8), limit=20, peak=5)
    for fault in ("curable", "lasting"):
        for code in ("fitting", "1"):
            yield Trial(f"reset of a {fault} fault, exceptions {code}", [*ASKED, "statemachine", "reset", "--json"],
                        {"fault_left": fault, "exceptions": code}, exits=(0,) if fault == "curable" else (1, 6, 8, 9),
                        limit=30, wants=reset_true)


def untouched(outcome):
    if outcome.seconds > 2.6 and 130 in outcome.trial.exits:
        yield f"ended only after {outcome.seconds:.1f} s"
    if outcome.device.peak > 0 or outcome.later["changed"] or outcome.later["state"] != "switch-on disabled":
        yield f"something was sent: {outcome.later}"


def really_stopped(outcome):
    told = outcome.at_end["state"] != "enabled" and outcome.tells("still turns|turns on by itself|coasts? on")
    if outcome.code == 0 and abs(outcome.at_end["speed"]) > 5 and not told:
        yield f"exit 0 while the shaft turns at {outcome.at_end['speed']:.0f} 1/min ({outcome.at_end['state']})"
    if outcome.code == 8 and outcome.at_end["state"] == "enabled":
        yield "a stop was refused or asked for"


def told_to_stop(outcome):
    """Whatever the line says: the stop went out, once at least."""
    if outcome.later["state"] == "enabled" and abs(outcome.later["speed"]) > 800:
        yield f"no stop reached the drive: {outcome.later['speed']:.0f} 1/min, enabled"
    yield from really_stopped(outcome)


def reset_true(outcome):
    if outcome.code == 0 and outcome.at_end["state"] == "fault":
        yield "exit 0, but the fault stands"


# --------------------------------------------------------------------------- the line settings


def line_cases():
    for when in ("power-on", "at-once"):
        for restart in ("keeps", "applies"):
            for words, name, value in ((["--address", "5"], "MBadr", 5), (["--baud", "9600"], "MBbaud", 9600),
                                       (["--baud", "38400"], "MBbaud", 38400), (["--parity", "odd"], "MBformat", 3),
                                       (["--parity", "none"], "MBformat", 4)):
                yield Trial(f"line set {' '.join(words)}, {when}, restart {restart}",
                            [*ASKED, "line", "set", *words, "--json"],
                            {"line_when": when, "fc8_restart": restart}, exits=(0, 8, 9), limit=30, back=False,
                            wants=line_true(name, value), quick=restart == "keeps" and name == "MBadr",
                            allowed_sins=("communication restarted",))
    yield Trial("line set --baud 57600", [*ASKED, "line", "set", "--baud", "57600", "--json"], {}, exits=(2, 6, 7),
                limit=30)
    yield Trial("line show", [*AT_ONE, "line", "show", "--json"], {}, wants=looks_right)


def line_true(name, value):
    def look(outcome):
        stands = outcome.device.value[name]
        if outcome.code == 0 and stands != value:
            yield f"exit 0, but {name} is {stands}"
        if outcome.tells("lost|no longer answers|nobody answers") and stands == value:
            yield f"calls it lost, but {name} stands as {stands} (in force {outcome.device.in_force[name]})"
    return look


# --------------------------------------------------------------------------- all of it

# --------------------------------------------------------------------------- traps


def trap_cases():
    """What does not fit into a matrix."""
    for waver in (3, 10, 40, 400):
        for stop in ("ramp", "quick-stop"):
            yield Trial(f"position wavers by {waver}, {stop}", [*run_words(["300rpm"], "1s"), "--on-exit", stop],
                        {"dither": waver}, stands=True, exits=(0, 8), limit=40)
    for fed in ("all", "writes"):
        for left in ("RAMPacc=60", "RAMPdecel=60", "RAMPacc=60,RAMPdecel=60"):
            for state in ("quick-stop", "fault"):
                yield Trial(f"long ramps {left}, guard 1 s fed by {fed}, then {state}",
                            [*ASKED, "sollwert", "240rpm", "--enable", "--hold", "--duration", "1s", "--until",
                             "reached", "--watchdog", "1s", "--json"],
                            {"guard_fed_by": fed, "left": left, "guard_state": state}, stands=True, limit=40, peak=250,
                            wants=guard_kept_quiet)
        for move, (words, top) in MOVES.items():
            yield Trial(f"{move} for 4 s, guard 700 ms fed by {fed}",
                        [*ASKED, "sollwert", "--enable", "--hold", "--duration", "4s", "--watchdog", "700ms", "--json",
                         *words], {"guard_fed_by": fed, "left": "RAMPacc=200,RAMPdecel=200"}, stands=True, limit=60,
                        wants=guard_kept_quiet)
    for times, what in (((1.0,), "once"), ((1.0, 2.0), "twice"), ((1.0, 2.0, 3.0), "three times")):
        yield Trial(f"a ramp of 100 s, Ctrl-C {what}", run_words(["3000rpm"], "30s"),
                    {"left": "RAMPacc=6000,RAMPdecel=30"}, exits=(130,), limit=150 if what == "once" else 60,
                    signals=tuple((at, signal.SIGINT) for at in times), stands=what != "three times", after=2.0)
    for lag in (100, 300):
        for move in ("velocity", "speed", "position"):
            yield Trial(f"until reached {move}, setpoints act after {lag} ms",
                        [*run_words(MOVES[move][0], "1s"), "--until", "reached"],
                        {"setpoint_lag": lag, "left": "RAMPacc=200", "speed_ramps": "ramps"}, stands=True, limit=30,
                        exits=(0, 2) if move == "speed" else (0,),
                        wants=reached(move))
    yield Trial("until reached, the load holds it at 200", [*run_words(["300rpm"], "1s"), "--until", "reached"],
                {"load_limit": 200.0}, stands=True, limit=60, exits=(1, 4, 8), wants=never_reached)
    yield Trial("until reached, the speed is clipped at 200", [*run_words(["300rpm"], "1s"), "--until", "reached",
                                                               "--force"],
                {"left": "RAMPn_max=200", "limits": "clipped"}, stands=True, limit=60, exits=(1, 4, 8),
                wants=never_reached)
    for order in ("high", "low"):
        for stored in (0, 1):
            left = f"{MARKS},MBdword_order={stored}"
            yield Trial(f"word order {order} in force, {stored} stored, read", [*AT_ONE, *READ],
                        {"left": left, "order_in_force": order}, values=MARKED)
            yield Trial(f"word order {order} in force, {stored} stored, write",
                        [*ASKED, "write", "RAMPacc=2000", "RAMPdecel=3000", "--json"],
                        {"left": f"MBdword_order={stored}", "order_in_force": order}, back=False, wants=written)
            yield Trial(f"word order {order} in force, {stored} stored, run", run_words(["300rpm"], "1s"),
                        {"left": f"MBdword_order={stored}", "order_in_force": order}, stands=True, peak=320)
    for timeout in ("5ms", "15ms", "20ms", "25ms"):
        yield Trial(f"read with a time-out of {timeout}", ["--timeout", timeout, *AT_ONE, *READ], marked({}),
                    values=MARKED, exits=(0, 2, 4, 5, 9), allowed_sins=LATE_SINS)
        yield Trial(f"run with a time-out of {timeout}", ["--timeout", timeout, *run_words(["300rpm"], "1s")], {},
                    stands=True, peak=320, exits=(0, 2, 4, 5, 8, 9), allowed_sins=LATE_SINS, limit=40)
    for late in (450, 700, 900):
        yield Trial(f"run at 500 ms, late {late}", run_words(["300rpm"], "2s"), {}, {"late": late}, stands=True,
                    peak=320, exits=(0, 4, 5, 8, 9), allowed_sins=LATE_SINS, limit=60, after=4.0)
        yield Trial(f"run at 500 ms, every 5th late {late}", run_words(["300rpm"], "3s"), {},
                    {"late": late, "late_every": 5}, stands=True, peak=320, exits=(0, 4, 5, 8, 9),
                    allowed_sins=LATE_SINS, limit=60, after=4.0)
    for begin in ("ready", "switched on", "enabled", "quick stop"):
        for ends in ("stays", "by-itself"):
            yield Trial(f"run from {begin}, quick stop {ends}", run_words(["300rpm"], "1s"),
                        {"begin": begin, "quick_stop_ends": ends}, stands=True, peak=320, limit=30)
        for verb in STOPS:
            yield Trial(f"{verb} in {begin}", [*AT_ONE, *STOPS[verb], "--json"], {"begin": begin}, limit=20,
                        exits=(0, 8), back=False)
    for begin, left in (("enabled", "DCOMopmode=-4"), ("enabled", "DCOMopmode=1"), ("enabled", "DCOMopmode=-2")):
        yield Trial(f"run velocity on an enabled drive, {left}", run_words(["300rpm"], "1s"),
                    {"begin": begin, "left": left}, stands=True, peak=320)
    for kind in ("refused", "accepted", "brakes-first"):
        yield Trial(f"run speed on a shaft that turns in mode 3, {kind}",
                    run_words(["300", "--mode", "speed"], "1s"), {"turning": 600.0, "mode_change_turning": kind},
                    exits=(0, 6, 8), stands=kind != "refused", back=False,
                    allowed_sins=() if kind != "refused" else ("mode change while turning",), wants=really_stopped)
        yield Trial(f"position on a shaft that turns in mode 3, {kind}", run_words(["8192usr"], "1s"),
                    {"turning": 600.0, "mode_change_turning": kind}, exits=(0, 6, 8), back=False, wants=really_stopped)
    yield Trial("velocity on a shaft that turns in mode 3", run_words(["300rpm"], "2s"), {"turning": 600.0},
                stands=True, back=False)
    for friction in (5.0, 60.0):
        yield Trial(f"current, friction {friction}", run_words(["2A"], "1s"), {"friction": friction}, stands=True,
                    limit=40, after=3.0)
        yield Trial(f"coast, friction {friction}", [*run_words(["300rpm"], "1s"), "--on-exit", "coast"],
                    {"friction": friction}, exits=(0, 8), limit=40)
    for guard, exits in (("30ms", (0, 1, 2, 4, 7, 8, 9)), ("100ms", (0, 1, 2, 4, 7, 8, 9)), ("10s", (0,)),
                         ("20s", (2, 7, 8))):
        yield Trial(f"watchdog of {guard}", [*ASKED, "sollwert", "300rpm", "--enable", "--hold", "--duration", "2s",
                                             "--watchdog", guard, "--json"], {}, exits=exits, stands=True, limit=30)
    yield Trial("speed beyond RAMPn_max", run_words(["5000rpm"], "1s"), {"left": "RAMPn_max=1000"}, exits=(7, 8),
                peak=5)
    yield Trial("speed beyond RAMPn_max, forced", [*run_words(["5000rpm"], "1s"), "--force"],
                {"left": "RAMPn_max=1000"}, exits=(6,), stands=True)
    yield Trial("jog 100", run_words(["100", "--mode", "jog"], "1s"), {}, exits=(2, 7), peak=5)
    yield Trial("jog 3", run_words(["3", "--mode", "jog"], "1s"), {}, exits=(2, 7), peak=5)
    yield Trial("homing by a method that is none", run_words(["99", "--mode", "homing"], "1s"), {}, exits=(2, 6, 7),
                peak=5)
    yield Trial("gear 2/0", run_words(["2/0", "--mode", "gear"], "1s"), {}, exits=(2, 7), peak=5)
    yield Trial("jog 5, fast", run_words(["5", "--mode", "jog"], "1s"), {}, stands=True, peak=190)
    yield Trial("jog 2, backwards", run_words(["2", "--mode", "jog"], "1s"), {}, stands=True, peak=65)
    for stop in ("ramp", "quick-stop", "coast"):
        for name, readings in {"plain": {}, "ramps refused turning": {"ramps_turning": "refused"}}.items():
            yield Trial(f"--set RAMPdecel, {stop}, {name}",
                        [*run_words(["600rpm"], "2s"), "--set", "RAMPdecel=500", "--on-exit", stop], readings,
                        stands=True, limit=30, peak=620)
    yield Trial("setpoint without --enable on a drive without power", [*ASKED, "sollwert", "300rpm", "--json"], {},
                exits=(0, 8), back=False)
    yield Trial("broadcast of a setpoint", ["-a", "0", "--yes", "sollwert", "300rpm", "--enable", "--json"], {},
                exits=(2, 8), peak=5)
    yield Trial("two addresses, one is nobody", ["-a", "1,2", *READ], marked({}), values=MARKED, exits=(4, 9))
    yield Trial("no mains", run_words(["300rpm"], "1s"), {"no_mains": "no-mains"}, exits=(6, 8), peak=5)
    for code in ("1", "3"):
        yield Trial(f"no mains, exceptions {code}", run_words(["300rpm"], "1s"),
                    {"no_mains": "no-mains", "exceptions": code}, exits=(6, 8), peak=5)
    for number in ("stays", "next"):
        yield Trial(f"diag with three faults, number {number}", [*AT_ONE, "diag", "--json"],
                    {"faults_stored": 3, "fault_number": number}, wants=faults_true)
        yield Trial(f"diag --check with a fault, number {number}", [*AT_ONE, "diag", "--check", "--json"],
                    {"faults_stored": 2, "fault_number": number, "fault_left": "curable"}, exits=(1,))
        for verb in ("statemachine", "diag", "monitor"):
            args = [verb, "--json"] if verb != "monitor" else [verb, "--count", "3", "--interval", "100ms", "--format", "ndjson"]
            yield Trial(f"{verb} names the fault that is present, number {number}", [*AT_ONE, *args],
                        {"faults_stored": 2, "fault_number": number, "fault_left": "curable"}, wants=names_fault)
    yield Trial("diag --clear", [*ASKED, "diag", "--clear", "--json"], {})
    yield Trial("diag --link-test", [*AT_ONE, "diag", "--link-test", "20", "--json"], {})
    yield Trial("profile by --ramp", [*ASKED, "sollwert", "--ramp", "0rpm:600rpm:2s", "--enable", "--hold",
                                      "--duration", "3s", "--watchdog", "1s", "--json"], {}, stands=True, peak=620, limit=30)
    yield Trial("keep in mode 1", [*run_words(["8192usr"], "2s"), "--on-exit", "keep"], {}, back=False)


def never_reached(outcome):
    if (outcome.data.get("setpoint") or {}).get("reached"):
        yield f"FALSE: reached, but never faster than {outcome.device.peak:.0f} 1/min"


def guard_kept_quiet(outcome):
    acted = [when for when, text in outcome.device.events if "guarding acts" in text]
    if acted:
        yield f"node guarding acted at {acted[0]} s although the tool was there"


def names_fault(outcome):
    """2300h is present; 3200h and 3201h are history."""
    for other in (0x3200, 0x3201):
        if outcome.tells(rf"\b{other}\b|{other:04X}"):
            yield f"names {other:04X}, which is history, beside a present fault 2300"
    if not outcome.tells(r"\b8960\b|2300"):
        yield "does not name the present fault 2300"


def dice_cases():
    """Lost, late, doubled, garbled by chance: no wrong value, no shaft left, an end in time."""
    for seed in range(1, 13):
        wrong = {"dice": seed}
        yield Trial(f"read, seed {seed}", [*AT_ONE, *READ], marked({}), wrong, values=MARKED, exits=(0, 4, 5, 9),
                    limit=60, allowed_sins=LATE_SINS, quick=seed == 1)
        yield Trial(f"monitor, seed {seed}", [*AT_ONE, "monitor", "RAMPacc", "RAMPdecel", "--count", "8", "--interval",
                                              "50ms", "--format", "ndjson"], marked({}), wrong, exits=(0, 4, 5, 9),
                    limit=90, allowed_sins=LATE_SINS, wants=looks_right)
        yield Trial(f"diag, seed {seed}", [*AT_ONE, "diag", "--json"], marked({}), wrong, exits=(0, 4, 5, 9),
                    limit=60, allowed_sins=LATE_SINS, wants=looks_right)
        yield Trial(f"write, seed {seed}", [*ASKED, "write", "RAMPacc=2000", "RAMPdecel=3000", "--json"], {}, wrong,
                    exits=(0, 4, 5, 6, 8, 9), limit=60, back=False, allowed_sins=LATE_SINS, wants=written)
        yield Trial(f"run, seed {seed}", [*ASKED, "sollwert", "300rpm", "--enable", "--hold", "--duration", "3s",
                                          "--watchdog", "3s", "--json"], {}, wrong, exits=(0, 4, 5, 8, 9), limit=90,
                    stands=True, peak=320, allowed_sins=LATE_SINS, after=4.0)
        for verb in ("quick-stop", "sollwert 0"):
            yield Trial(f"{verb}, seed {seed}", [*AT_ONE, *STOPS[verb], "--json"], {"turning": 857.0}, wrong,
                        exits=(0, 4, 5, 8, 9), limit=60, back=False, wants=told_to_stop, after=3.0,
                        allowed_sins=LATE_SINS)


def faults_true(outcome):
    """Number, class, time and qualifier that are shown together belong together."""
    rows = {}
    stack = [outcome.document]
    while stack:
        item = stack.pop()
        if isinstance(item, list):
            stack += item
        elif isinstance(item, dict):
            stack += item.values()
            if item.get("param") in (15362, 15364, 15366, 15368):
                rows.setdefault(item["param"], []).append(item.get("raw"))
    shown = tuple(rows.get(param, [None])[0] for param in (15362, 15364, 15366, 15368))
    if shown != tuple(outcome.device.faults[-1]):
        yield f"WRONG VALUE: fault memory shown as {shown}, the newest entry is {outcome.device.faults[-1]}"


GROUPS = {"trap": trap_cases, "dice": dice_cases, "reading": reading_cases, "writing": writing_cases, "motion": motion_cases, "rough": rough_cases,
          "stopping": stopping_cases, "line": line_cases}


def play(trial):
    try:
        outcome = judge.run(trial)
        return trial, outcome, judge.verdict(outcome)
    except Exception as error:  # a harness that breaks must show up as a failure
        return trial, None, [f"HARNESS: {type(error).__name__}: {error}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true", help="some two dozen cases, one of every kind")
    parser.add_argument("--only", default="", help="cases whose name (group: case) contains all these words")
    parser.add_argument("--jobs", type=int, default=3)
    parser.add_argument("--verbose", action="store_true", help="failures with the tool's words")
    parser.add_argument("--list", action="store_true")
    options = parser.parse_args()
    cases = []
    for group, make in GROUPS.items():
        for trial in make():
            trial.name = f"{group}: {trial.name}"
            if (trial.quick or not options.quick) and all(word in trial.name for word in options.only.split(" ")):
                cases.append(trial)
    if options.list:
        print("\n".join(trial.name for trial in cases))
        return 0
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for trial, outcome, complaints in pool.map(play, cases):
            failed += bool(complaints)
            seconds = f"{outcome.seconds:5.1f} s" if outcome else "       "
            print(f"{'FAIL' if complaints else 'ok  '} {seconds} {trial.name}" +
                  "".join(f"\n       - {text}" for text in complaints), flush=True)
            if complaints and options.verbose and outcome:
                print("       args: " + " ".join(trial.args))
                print("       readings: " + str(trial.readings) + " line: " + str(trial.wrong))
                print("       " + (outcome.err.strip() + "\n" + outcome.out.strip()[:1500]).replace("\n", "\n       "))
    print(f"{len(cases) - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
