# SPDX-License-Identifier: MIT
"""Checks that clang-format would change nothing, and that single statements bear no braces but in
tests, whose macros need them.

Usage: format.py ROOT [--mend]. Passes with a notice where clang-format of the version that
.clang-format was written for is absent, since versions disagree. Braces are those that it would
remove and, since it then breaks lines that it should not, that stay away when it formats once more;
--mend does both. Exit code: 0 well formatted, 1 not.
"""
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

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


def without_braces(program, root, folder):
    """Formats the tree's copy in a folder, twice, and gives the files that this has changed."""
    paths = [path for path in sources.files(root) if sources.is_cpp(path)]
    for path in paths:
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(Path(root) / path, folder / path)
    style = (Path(root) / ".clang-format").read_text()
    bare = [path for path in paths if path.parts[0] != "tests"]
    for text, some in ((style + "RemoveBracesLLVM: true\n", bare), (style, paths)):
        (folder / ".clang-format").write_text(text)
        subprocess.run([program, "-i", "--style=file", *map(str, some)], cwd=folder, check=True)
    return [path for path in paths
            if (folder / path).read_bytes() != (Path(root) / path).read_bytes()]


def main(root, mend):
    program = clang_format()
    if not program:
        print(f"Notice: clang-format {VERSION} is absent, so the format was not checked.")
        return 0
    with tempfile.TemporaryDirectory() as folder:
        changed = without_braces(program, root, Path(folder))
        for path in changed:
            if mend:
                shutil.copyfile(Path(folder) / path, Path(root) / path)
            print(f"{path}: {'formatted' if mend else 'format it: tests/house/format.py . --mend'}")
    return 1 if changed and not mend else 0


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3) or sys.argv[2:] not in ([], ["--mend"]):
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], sys.argv[2:] == ["--mend"]))
