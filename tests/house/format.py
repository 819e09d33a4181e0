# SPDX-License-Identifier: MIT
"""Checks that clang-format would change nothing.

Usage: format.py ROOT. Passes with a notice where clang-format of the version that .clang-format
was written for is absent, since versions disagree. Exit code: 0 well formatted, 1 not.
"""
import re
import shutil
import subprocess
import sys

import sources

VERSION = "14"


def clang_format():
    """The program of the right version, or None."""
    for name in (f"clang-format-{VERSION}", "clang-format"):
        program = shutil.which(name)
        if program:
            answer = subprocess.run([program, "--version"], capture_output=True, text=True)
            version = re.search(r"version (\d+)", answer.stdout)
            if version and version.group(1) == VERSION:
                return program
    return None


def main(root):
    program = clang_format()
    if not program:
        print(f"Notice: clang-format {VERSION} is absent, so the format was not checked.")
        return 0
    paths = [str(path) for path in sources.files(root) if sources.is_cpp(path)]
    run = subprocess.run([program, "--dry-run", "-Werror", "--style=file", *paths], cwd=root)
    if run.returncode:
        print(f"Format them with: {program} -i FILES")
    return 1 if run.returncode else 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1]))
