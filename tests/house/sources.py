# SPDX-License-Identifier: MIT
"""Which files of the checkout the checks of the house read. Needs Python 3 alone."""
import os
from pathlib import Path

GENERATED = {".git", ".cache", "build", "install", "demo-output", "__pycache__"}
SCRIPTS = {"demo", "test", ".ci/run"}


def files(root):
    """All files below root, relative and sorted, without those that some program wrote."""
    found = []
    for folder, subfolders, names in os.walk(root):
        subfolders[:] = [
            name for name in subfolders
            if name not in GENERATED and not (Path(folder) / name / "CMakeCache.txt").exists()
        ]
        found += [(Path(folder) / name).relative_to(root) for name in names]
    return sorted(found)


def is_cpp(path):
    return path.suffix in {".h", ".cpp"}


def is_source(path):
    """Written by hand in a language that has comments, so that it carries the license line."""
    return (is_cpp(path) or path.suffix in {".cmake", ".py", ".sh"}
            or path.name == "CMakeLists.txt" or path.name.endswith(".cmake.in")
            or path.as_posix() in SCRIPTS)


def text(root, path):
    return (Path(root) / path).read_text(encoding="utf-8", errors="replace")


def public_headers(root, listing):
    """The headers that CMake lists in a file, one a line, as paths from the root."""
    root = Path(root).resolve()
    return {Path(line).resolve().relative_to(root).as_posix()
            for line in Path(listing).read_text().splitlines() if line}


def report(complaints, praise):
    """Prints what was found and gives the exit code."""
    for complaint in complaints:
        print(complaint)
    print(f"{len(complaints)} complaint(s)" if complaints else praise)
    return 1 if complaints else 0
