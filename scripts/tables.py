# SPDX-License-Identifier: MIT
"""Tables of docs/ that scripts make of answers of the command."""
import json
import subprocess


def ask(command, *arguments, seconds):
    """The object of an answer, or, as text, why there is none."""
    try:
        done = subprocess.run([command, *map(str, arguments), "--json"], capture_output=True,
                              text=True, timeout=seconds, check=False)
    except subprocess.TimeoutExpired:
        return f"takes more than {seconds} s"
    said = done.stderr.strip().splitlines() or [f"ends with the code {done.returncode}"]
    return json.loads(done.stdout) if done.returncode == 0 else said[-1]


def line(cells):
    return "| " + " | ".join(cells) + " |\n"


def put(page, script, text):
    """Writes a text into a page between the two lines that mark its place there. Raises ValueError if
    there are none."""
    first, last = f"<!-- table: written by scripts/{script} -->\n", "<!-- end of table -->"
    before, begin, rest = page.read_text(encoding="utf-8").partition(first)
    _, end, after = rest.partition(last)
    if not begin or not end:
        raise ValueError(f"{page} has no lines '{first.strip()}' and '{last}'")
    page.write_text(f"{before}{first}\n{text}\n{last}{after}", encoding="utf-8")
