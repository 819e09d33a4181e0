# SPDX-License-Identifier: MIT
"""Checks that no file names the place where it happened to be written, or has a phrase that reads
like a translation.

Usage: words.py ROOT. A complaint a line, as file:line. Exit code: 0 none, 1 some.
"""
import re
import sys

import sources

# In pieces, so that this file does not hold what it looks for.
WORDS = ["/wo" + "rk/", "." + "library", ".." + "/shared", "farm" + "-", "sub" + "agent",
         "before" + "-stop"]
PHRASES = ["to be" + " had", "gone on" + " with", "makes nothing" + " of", "made it" + " so",
           "beyond the" + " doubles"]
# A letter before the word makes another word of it.
PATTERN = re.compile("|".join(r"(?<![A-Za-z])" + re.escape(word) for word in WORDS))
# A phrase may continue on the next line of a comment, a string or a page.
PHRASE = re.compile("|".join(r"\b" + r"[\s\"/#*]+".join(phrase.split()) + r"\b"
                             for phrase in PHRASES))


def check(root):
    """All complaints about the tree below root."""
    complaints = []
    for path in sources.files(root):
        text = sources.text(root, path)
        for number, line in enumerate(text.splitlines(), 1):
            word = PATTERN.search(line)
            if word:
                complaints.append(f"{path}:{number}: `{word.group()}` is no part of the project")
        for phrase in PHRASE.finditer(text):
            number = text.count("\n", 0, phrase.start()) + 1
            words = " ".join(re.findall(r"\w+", phrase.group()))
            complaints.append(f"{path}:{number}: `{words}` reads like a translation")
    return complaints


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(sources.report(check(sys.argv[1]), "No such word."))
