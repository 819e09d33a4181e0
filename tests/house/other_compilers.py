# SPDX-License-Identifier: MIT
"""The library, the command and the Python module compile with clang and libc++, as on macOS; the
library and the command compile with MinGW-w64, as on Windows, but for the files that
docs/installing.md names in its section of Windows. Only syntax and types are checked.

Usage: other_compilers.py BUILD libc++|mingw [OPTION ..]. BUILD has compile_commands.json; the options
are for the compiler, such as -isystem of another Eigen. Exit code: 77 without the compiler.
"""
import json
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
COMPILERS = {"libc++": ["clang++-16", "-stdlib=libc++"], "mingw": ["x86_64-w64-mingw32-g++-posix", "-w"]}
HEADERS = ["CLI", "fmt", "muParser*.h", "rapidjson", "Spectra", "zconf.h", "zlib.h"]  # of any system


def named_files():
    """The sources that docs/installing.md says do not compile on Windows."""
    _, section = (ROOT / "docs/installing.md").read_text().split("\n## Windows\n")
    names = re.findall(r"`([\w/]+\.cpp)`", section.split("\n## ")[0])
    return {ROOT / name for name in names}


def commands(build, which):
    """What compiles which source in which folder; examples and benchmarks apart, one of each source."""
    wanted = r"/(polydec|polydec_tools|polydec_command)\.dir/" if which == "mingw" else ""
    found = {}
    for step in json.loads((build / "compile_commands.json").read_text()):
        place = Path(step["file"])
        if not ("cmake_pch" in step["file"] or re.search(r"/(examples|benchmarks)/", step["command"])
                or not re.search(wanted, step["command"])):
            found[place] = (shlex.split(step["command"])[1:], step["directory"])
    return found


def words_for(words):
    """Without what is for the other compiler, or would write files."""
    words = iter(words)
    for word in words:
        if word in ("-o", "-include"):
            next(words)
        elif word != "-c" and not re.match("-W|-fopenmp", word):
            yield word


def without(named, source, folder):
    """A file of all files compiled together, less those named; None if that leaves nothing."""
    if source.suffix != ".cxx":
        return None if source in named else source
    lines = [line for line in source.read_text().splitlines() if line.startswith("#include")]
    kept = [line for line in lines if Path(line.split('"')[1]) not in named]
    made = Path(folder) / source.name
    made.write_text("\n".join(kept) + "\n")
    return made if kept else None


def main(build, which, *options):
    if not shutil.which(COMPILERS[which][0]):
        print("skipped: there is no", COMPILERS[which][0])
        return 77
    with tempfile.TemporaryDirectory() as folder:
        named = set()
        if which == "mingw":
            named = named_files()
            options += ("-I" + folder, "-isystem", "/usr/include/eigen3")
            for header in (each for name in HEADERS for each in Path("/usr/include").glob(name)):
                (Path(folder) / header.name).symlink_to(header)

        def compiled(step):
            source, (words, place) = step
            kept = without(named, source, folder)
            words = [str(kept) if word == str(source) else word for word in words_for(words)]
            done = kept and subprocess.run([*COMPILERS[which], *options, *words, "-fsyntax-only"],
                                           cwd=place, text=True, stderr=subprocess.PIPE)
            if done and done.returncode:
                print(f"{source}:\n{done.stderr[:4000]}", flush=True)
            return not done or done.returncode == 0

        steps = commands(build, which)
        with ThreadPoolExecutor(2) as threads:
            good = list(threads.map(compiled, steps.items()))
        print(f"{sum(good)} of {len(good)} compile")
        return 0 if steps and all(good) else 1


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    sys.exit(main(Path(sys.argv[1]), *sys.argv[2:]))
