"""Types answers, one a second, at a terminal of its own: answers.py "j,^C" antrieb …; prints the end of what was seen and the exit code."""
import os
import pty
import select
import sys

answers = sys.argv[1].split(",")
child, terminal = pty.fork()
if child == 0:
    os.execvp(sys.argv[2], sys.argv[2:])
seen, given = b"", 0
while True:
    try:
        ready, _, _ = select.select([terminal], [], [], 1.0)
        if ready:
            came = os.read(terminal, 65536)
            if not came:
                break
            seen += came
        elif given < len(answers):
            answer = answers[given]
            given += 1
            keys = {"^C": b"\x03", "^D": b"\x04"}
            os.write(terminal, keys.get(answer, (answer + "\n").encode()))
    except OSError:
        break
_, status = os.waitpid(child, 0)
sys.stdout.write(seen.decode(errors="replace")[-2500:])
print("rc", os.waitstatus_to_exitcode(status))
