# SPDX-License-Identifier: MIT
"""Installs a build tree, moves it, and builds and runs a project outside of polydec against it.

Usage: install.py CMAKE BUILD CONSUMER PUBLIC_HEADERS COMPILER MODULE_FOLDER [COMPONENT ..]. The
header list is the one of layering.py. Exit code: 0 all went well, 1 not.
"""
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import sources

ROOT = Path(__file__).resolve().parents[2]


class Failure(Exception):
    """the text says what failed, with the program's output"""


def run(*command, cwd, expect_success=True, **variables):
    """Runs with nothing in the environment that could point to the build tree; gives the output."""
    environment = {"PATH": os.environ["PATH"], "HOME": str(cwd), "LC_ALL": "C", **variables}
    done = subprocess.run([str(word) for word in command], cwd=cwd, env=environment, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if (done.returncode == 0) != expect_success:
        raise Failure(f"exit code {done.returncode} of {' '.join(map(str, command))}\n"
                      + done.stdout)
    return done.stdout


def check_tree(prefix, build, headers):
    """Every public header and the license are there, and nothing names the build tree."""
    wanted = [*(f"include/polydec/{header}" for header in headers), "share/doc/polydec/LICENSE"]
    if (prefix / "bin" / "polydec").exists():
        wanted += ["share/man/man1/polydec-spectrum.1", "share/bash-completion/completions/polydec"]
    missing = [name for name in wanted if not (prefix / name).is_file()]
    if missing:
        raise Failure("not installed: " + ", ".join(missing))
    for path in [*prefix.rglob("*.cmake"), *prefix.rglob("*.pc")]:
        text = path.read_text()
        if str(build) in text or str(ROOT) in text:
            raise Failure(f"{path.relative_to(prefix)} holds a path of the tree it was built in")


def configure(options, consumer, prefix, binary, components, expect_success=True):
    """For all that this processor can, which the library was not compiled for."""
    return run(options.cmake, "-S", consumer, "-B", binary, "-G", "Ninja",
               f"-DCMAKE_CXX_COMPILER={options.compiler}", f"-DCMAKE_PREFIX_PATH={prefix}",
               f"-DCOMPONENTS={components}", "-DCMAKE_CXX_FLAGS=-march=native",
               cwd=prefix.parent, expect_success=expect_success)


ENGINES = {"cholmod": "cholmod", "mumps": "mumps", "petsc": "petsc.cg-gamg", "slepc": "slepc",
           "cvode": "cvode"}
LINKED = {"": [], "cholmod": ["cholmod"], "petsc": ["petsc"], "slepc": ["slepc", "petsc"]}


def use(options, consumer, prefix, component):
    """Configures, builds and runs the consumer: it has the engines of what it links, and no others,
    though it registers none."""
    binary = prefix.parent / f"consumer-{component or 'core'}"
    configure(options, consumer, prefix, binary, component)
    run(options.cmake, "--build", binary, cwd=prefix.parent)
    answer = run(binary / "consumer", cwd=prefix.parent, POLYDEC_ENGINES="").strip()
    if component == "cholmod" and "factorized by cholmod" not in answer:
        raise Failure(f"cholmod is linked, but not what factorizes:\n{answer}")
    for name, engine in ENGINES.items():
        run(binary / "engines", engine, cwd=prefix.parent, POLYDEC_ENGINES="",
            expect_success=name in LINKED[component])
    print(f"[{component or 'core'}]", answer)


PYTHON = """
import sys, polydec
there = {engine.name for engine in polydec.backends() if engine.available}
sys.exit(", ".join(set(sys.argv[1:]) - there) or 0)
"""


def load(options, prefix):
    """Programs that link no component, by CMake or by pkg-config, the command and the package for
    Python each find the modules that are installed, with nothing said of where these are."""
    wanted = [ENGINES[component] for component in options.components]
    run(prefix.parent / "consumer-core" / "engines", *wanted, cwd=prefix.parent)

    package = next(prefix.rglob("polydec.pc")).parent
    flags = run("pkg-config", "--cflags", "--libs", "polydec", cwd=prefix,
                PKG_CONFIG_PATH=str(package)).split()
    program = prefix.parent / "by-pkg-config"
    run(options.compiler, "-std=c++20", options.consumer / "engines.cpp",
        options.consumer / "between.cpp", *flags, "-o", program, cwd=prefix)
    run(program, *wanted, cwd=prefix.parent)

    if python := next(prefix.rglob("polydec/__init__.py"), None):
        run(sys.executable, "-c", PYTHON, *wanted, cwd=prefix.parent,
            PYTHONPATH=str(python.parent.parent))
    command = prefix / "bin" / "polydec"
    if command.exists():
        answer = json.loads(run(command, "backends", "--json", cwd=prefix.parent))
        there = {engine["name"] for engine in answer["backends"] if engine["available"]}
        missing = {ENGINES[component] for component in options.components} - there
        if missing:
            raise Failure(f"the installed command does not find {', '.join(sorted(missing))}")


def refuse(options, consumer, prefix, component):
    """A component that is not there is an error that names it."""
    binary = prefix.parent / f"consumer-without-{component}"
    answer = configure(options, consumer, prefix, binary, component, expect_success=False)
    if component not in answer:
        raise Failure(f"the missing component {component} is not named in\n{answer}")


def main(options):
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder).resolve()
        first = folder / "first"
        run(options.cmake, "--install", options.build, "--prefix", first, cwd=folder)
        check_tree(first, options.build, options.headers)
        prefix = first.rename(folder / "moved")

        use(options, options.consumer, prefix, "")
        load(options, prefix)
        for component in set(options.components) & set(LINKED):
            use(options, options.consumer, prefix, component)
        for component in {"nosuch", "cholmod"} - set(options.components):
            refuse(options, options.consumer, prefix, component)

        command = prefix / "bin" / "polydec"
        if command.exists():
            run(command, "--help", cwd=folder)


class Options:
    """The words of the command line."""
    def __init__(self, cmake, build, consumer, headers, compiler, modules, *components):
        self.cmake, self.build, self.consumer = cmake, Path(build), Path(consumer)
        self.headers = sorted(sources.public_headers(ROOT, headers))
        self.compiler, self.modules, self.components = compiler, modules, components


if __name__ == "__main__":
    if len(sys.argv) < 7:
        sys.exit(__doc__)
    try:
        main(Options(*sys.argv[1:]))
    except Failure as failure:
        sys.exit(str(failure))
