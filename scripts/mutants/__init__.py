# SPDX-License-Identifier: MIT
"""The flaws that mutate.py plants, from the files of each folder beside this one.

Below the path of a source file stands a line for each of its flaws: the name and a text that occurs
once in that file, in which «old→new» is the change and ⏎ a line break. Behind # stands a test that fails
with the flaw: mutate.py runs it first, and all tests if it passes or none is named."""
import re
from pathlib import Path

FLAW = re.compile(r"  (\w+): (.*?)«(.*?)→(.*?)»(.*?)(?:\s+# (.*))?$")


def flaws(text):
    """{name: (file, old text, new text, test if any)}."""
    found = {}
    for entry in re.split(r"\n(?! {4}#)", text):
        if not entry.startswith(" "):
            path = entry
        else:
            name, before, old, new, behind, test = FLAW.match(entry).groups()
            texts = ((before + each + behind).replace("⏎", "\n") for each in (old, new))
            found[name] = (path, *texts, *([test] if test else []))
    return found


MUTANTS = {name: flaw for path in sorted(Path(__file__).parent.glob("*.txt"))
           for name, flaw in flaws(path.read_text(encoding="utf-8").rstrip()).items()}
