#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Plants one flaw at a time in a copy of a source file and checks that a test fails.

    scripts/mutate.py build/release build/tests [--only NAME ..] [--jobs N]
    scripts/mutate.py --texts     asks only whether the text of each flaw is in its file once

The folders are a shared release build of polydec and a build of the tests; neither is changed. Only
the mutated file is compiled (1 to 8 s) and preloaded. A copy of the library, linked without
-Bsymbolic-functions, then calls the mutated functions too. A mutant is `caught` if a test fails or
crashes, `survived` if all pass, `stale` if its source line changed. Exit code: 0 all were caught, 1 one
survived, 2 one is stale.

Flaws in templates and inline functions cannot be preloaded and are not listed.
"""
import argparse
import concurrent.futures
import fnmatch
import itertools
import json
import os
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from mutants import MUTANTS

ROOT = Path(__file__).resolve().parent.parent

# The test programs that each folder's flaws are asked of, one after the other.
PROGRAMS = {folder: (f"{folder}/test_{folder}",) for folder in ("distributed", "io", "shape")}
for lower in ("base", "complex", "meshes"):
    PROGRAMS[lower] = (f"{lower}/test_{lower}", "dec/test_dec", "solvers/test_solvers")
PROGRAMS["dec"] = ("dec/test_dec", "shape/test_shape", "solvers/test_solvers")
PROGRAMS["backends"] = ("backends/test_backends", "solvers/test_solvers")
PROGRAMS["solvers"] = ("solvers/test_solvers", "io/test_io")
SECONDS = 600
CLANG = shutil.which("clang++")
WITH_COMPONENTS = "cholmod.*:slepc.*:*UninstantiatedParameterizedTestSuite*" # there are none beside a flaw


def flags(build, work, path):
    """Compiler command of the file, or of its module's unity file, up to -o, but with the headers in
    `work` precompiled; working directory."""
    unity = f"/unity_{path.split('/', 1)[0]}_0_cxx.cxx"
    entries = json.loads((build / "compile_commands.json").read_text())
    entry = next((entry for wanted in ("/" + path, unity) for entry in entries
                  if entry["file"].endswith(wanted)), None)
    if entry is None:
        sys.exit(f"{path}: no command in {build}/compile_commands.json compiles it")
    words = shlex.split(entry["command"])
    words = words[:words.index("-o")]
    if "-include" in words:
        words[words.index("-include") + 1] = work / "headers.h"
    if CLANG: # takes half the time, and has no OpenMP of g++
        words = [CLANG, *(word for word in words[1:] if word != "-fopenmp")]
    return [*words, "-O0", "-w"], entry["directory"]


def precompile(build, work):
    """What files of all folders read, which takes half the time of compiling most of them."""
    headers = work / "headers.h"
    headers.write_text("#include <Eigen/Dense>\n#include <Eigen/Sparse>\n#include <fmt/format.h>\n"
                       '#include "polydec.h"\n')
    command, where = flags(build, work, "dec/discretization/discretization.cpp")
    command[command.index(headers) - 1:command.index(headers)] = "-x", "c++-header"
    subprocess.run([*command, "-o", f"{headers}.gch"], cwd=where, check=True)


def open_library(build, folder):
    """Links a copy of the library without -Bsymbolic-functions, so that preloaded functions replace
    its own."""
    name = next(build.glob("lib/libpolydec.so.*.*")).relative_to(build)
    commands = subprocess.run(["ninja", "-C", build, "-t", "commands", name], check=True,
                              capture_output=True, text=True).stdout.splitlines()
    link = commands[-1].replace("-Wl,-Bsymbolic-functions", "")
    subprocess.run(link.replace(f"-o {name}", f"-o {folder}/libpolydec.so.0"), shell=True, check=True,
                   cwd=build)


def stale(name):
    """Why the flaw cannot be planted; "" if it can."""
    path, old, _, *known = MUTANTS[name]
    if any(fnmatch.fnmatch(test, only) for test in known for only in WITH_COMPONENTS.split(":")):
        return "the test that it names needs a component, so it always fails here"
    count = (ROOT / path).read_text().count(old)
    return "" if count == 1 else f"text occurs {count} times in {path}, expected once"


def compiled(build, work, name):
    """Path of the shared object with the flaw, or None and the reason."""
    path, old, new = MUTANTS[name][:3]
    if stale(name):
        return None, stale(name)
    source = (ROOT / path).read_text()
    mutated, shared = work / f"{name}.cpp", work / f"{name}.so"
    mutated.write_text(f'#line 1 "{path}"\n' + source.replace(old, new))
    command, where = flags(build, work, path)
    run = subprocess.run([*command, "-shared", "-o", shared, mutated], cwd=where,
                         capture_output=True, text=True)
    return (shared, "") if run.returncode == 0 else (None, "does not compile: " + run.stderr[-400:])


def verdict(tests, work, name, shared):
    """Name of the first failing test; "" if all pass. The test named in the table runs first."""
    path, _, _, *known = MUTANTS[name]
    programs = PROGRAMS[path.split("/")[0]]
    for choice, program in itertools.product(known + ["-" + WITH_COMPONENTS], programs):
        run = subprocess.run([tests / program, "--gtest_brief=1", "--gtest_fail_fast",
                              "--gtest_filter=" + choice],
                             env=dict(os.environ, LD_PRELOAD=str(shared), LD_LIBRARY_PATH=str(work),
                                      POLYDEC_ENGINES="", RC_PARAMS="seed=1", OMP_NUM_THREADS="1"),
                             capture_output=True, text=True, errors="replace", timeout=SECONDS)
        failed = [line.split("]")[1].split(" (")[0].strip() for line in run.stdout.splitlines()
                  if "[  FAILED  ]" in line]
        if run.returncode != 0:
            return failed[0] if failed else f"ended with {run.returncode}"
    return ""


def ask(build, tests, work, name):
    """The verdict, one of caught, survived and stale, and its details."""
    begin = time.monotonic()
    shared, flaw = compiled(build, work, name)
    if shared is None:
        return "stale", flaw
    try:
        seen = verdict(tests, work, name, shared)
    except subprocess.TimeoutExpired:
        seen = f"took more than {SECONDS} s"
    shared.unlink()
    return "caught" if seen else "survived", f"{time.monotonic() - begin:.1f} s  {seen}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=Path, nargs="?", help="release build of polydec, its library shared")
    parser.add_argument("tests", type=Path, nargs="?", help="build of the tests")
    parser.add_argument("--texts", action="store_true", help="ask only whether each text is there once")
    parser.add_argument("--only", nargs="+", choices=sorted(MUTANTS), default=list(MUTANTS),
                        metavar="NAME", help="these flaws alone")
    parser.add_argument("--jobs", type=int, default=min(2, os.cpu_count() or 1))
    arguments = parser.parse_args()
    if arguments.texts:
        found = [f"{name}: {stale(name)}" for name in arguments.only if stale(name)]
        print("\n".join(found) or "every text is there once")
        return 2 if found else 0
    if arguments.tests is None:
        parser.error("expected the folders of both builds, or --texts")
    build, tests = arguments.build.resolve(), arguments.tests.resolve()
    ended = {"caught": 0, "survived": 0, "stale": 0}
    with tempfile.TemporaryDirectory() as folder, \
            concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        work = Path(folder)
        open_library(build, work)
        precompile(build, work)
        asked = {pool.submit(ask, build, tests, work, name): name for name in arguments.only}
        for done in concurrent.futures.as_completed(asked):
            how, what = done.result()
            ended[how] += 1
            print(f"{how:8}  {asked[done]}  {what}", flush=True)
    print(", ".join(f"{count} {how}" for how, count in ended.items()))
    return 2 if ended["stale"] else 1 if ended["survived"] else 0


if __name__ == "__main__":
    sys.exit(main())
