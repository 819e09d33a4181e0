# SPDX-License-Identifier: MIT
"""Checks that no file names the place where it happened to be written.

Usage: words.py ROOT. A complaint a line, as file:line. Exit code: 0 none, 1 some.
"""
import re
import sys

import sources

# In pieces, so that this file does not hold what it looks for.
WORDS = ["/wo" + "rk/", "." + "library", ".." + "/shared", "farm" + "-", "sub" + "agent",
         "before" + "-stop"]
# A letter before the word makes another word of it.
PATTERN = re.compile("|".join(r"(?<![A-Za-z])" + re.escape(word) for word in WORDS))


def check(root):
    """All complaints about the tree below root."""
    complaints = []
    for path in sources.files(root):
        for number, line in enumerate(sources.text(root, path).splitlines(), 1):
            word = PATTERN.search(line)
            if word:
                complaints.append(f"{path}:{number}: `{word.group()}` is no part of the project")
    return complaints


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(sources.report(check(sys.argv[1]), "No such word."))
