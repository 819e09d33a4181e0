# SPDX-License-Identifier: MIT
"""Installs the commit that is checked out in empty systems, and runs there what README.md shows. A
system is a new Debian 12 by debootstrap with the packages named below; polydec is not in it before.

  packages   builds the packages of debian/ from the tarball, with their build dependencies alone,
             asks lintian, and installs them elsewhere: the command, C++ by CMake and by pkg-config, Python
  sdist      installs the sdist by pip in an empty environment, from a folder of wheels: Python
  contained  a project that fetches the tarball, with four packages of Debian: C++ by CMake

Each engine cholmod must be found where it is installed. Nothing but Debian's packages comes from the
network; what is built and run has none.

Usage: empty_systems.py [--debs FOLDER] COMMAND FOLDER [PART ..]. COMMAND is a polydec that makes a mesh,
FOLDER is made anew, DEBS holds packages that were built before. Exit code: 0 all went well, 1 not, 77
without root, debootstrap, git or network.
"""
import argparse
import os
import shutil
import subprocess
import sys
from pathlib import Path

import readme

ROOT = Path(__file__).resolve().parents[2]
MIRROR = os.environ.get("POLYDEC_MIRROR", "http://deb.debian.org/debian")
FOUR_PACKAGES = ["libeigen3-dev", "libfmt-dev", "libspectra-dev", "zlib1g-dev"]
FAST = "-O0"  # a third of the time of -O2; times are not measured here


class Failure(Exception):
    """the text says what failed, with the end of the program's output"""


def run(*words, cwd=None):
    done = subprocess.run([str(word) for word in words], cwd=cwd, text=True, stdin=subprocess.DEVNULL,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode:
        raise Failure(f"exit code {done.returncode} of {' '.join(map(str, words))}\n{done.stdout[-4000:]}")
    return done.stdout


class System:
    """An empty system with these packages, whose folder /srv they work in."""
    def __init__(self, base, name, *packages):
        self.root = base.with_name(name)
        run("cp", "-a", base, self.root)
        shutil.copy("/etc/resolv.conf", self.root / "etc/resolv.conf")
        self.work = self.root / "srv"
        self.install(*packages)

    def run(self, script, network=False):
        first = "".join(f"mount --bind /{name} {self.root}/{name}; " for name in ("proc", "dev"))
        if not network:
            first += "ip link set lo up; " # without it MPI complains, which CMake takes for options
        return run("unshare", "-m" if network else "-mn", "sh", "-ec", first + 'exec chroot "$@"', "sh",
                   self.root, "env", "-i", "HOME=/root", "LC_ALL=C.UTF-8", "PATH=/usr/sbin:/usr/bin:/sbin:/bin",
                   "DEBIAN_FRONTEND=noninteractive", "sh", "-ec", f"cd /srv; {script}")

    def install(self, *words, command="install"):
        self.run(f"apt-get update -q && apt-get {command} -qy --no-install-recommends " + " ".join(words),
                 network=True)

    def put(self, name, text):
        (self.work / name).write_text(text)


def empty_system(folder):
    """The system that all others are copies of."""
    if os.geteuid() != 0 or not (ROOT / ".git").exists():
        skip("this needs root, and a git checkout")
    if not shutil.which("debootstrap"):
        skip("there is no debootstrap")
    base = folder / "base"
    try:
        run("debootstrap", "--variant=minbase", "bookworm", base, MIRROR)
    except Failure as failure:
        skip(f"debootstrap gets nothing from {MIRROR}: {failure}")
    return base


def skip(why):
    print("skipped:", why)
    sys.exit(77)


def door(language):
    """The block of README.md in a language."""
    (_, text), *_ = readme.blocks((ROOT / "README.md").read_text(), language)
    return text


# The programs of README.md and of tests/house/consumer, which ends well if it has the engines named.
PROJECT = """cmake_minimum_required(VERSION 3.25)
project(reader LANGUAGES CXX)
%s
add_executable(readme readme.cpp)
target_link_libraries(readme PRIVATE polydec::polydec)
add_executable(engines engines.cpp between.cpp)
target_link_libraries(engines PRIVATE polydec::polydec)
"""
CHECK_PYTHON = """
assert {engine.name: engine.available for engine in polydec.backends()}["cholmod"]
assert modes.linear_solver == "cholmod", modes.linear_solver
"""
CHECK_PAGE = "test -s modes.html; rm modes.html"


def put_program(system, command, how):
    for name in ("engines.cpp", "between.cpp"):
        shutil.copy(ROOT / "tests/house/consumer" / name, system.work)
    system.put("readme.cpp", door("cpp"))
    system.put("CMakeLists.txt", PROJECT % how)
    run(command, "generate", "flange", "--segments", 48, "-o", system.work / "part.off")


def packages(options, base):
    debs = options.debs or build_packages(options, base)
    system = System(base, "packages", "g++", "cmake", "make", "pkg-config")
    for deb in Path(debs).glob("*.deb"):
        if "-dbgsym_" not in deb.name:
            shutil.copy(deb, system.work)
    system.install("./*.deb")
    system.run("rm *.deb")

    system.run(f"{door('sh')}{CHECK_PAGE}\n"
               "polydec backends --json | tr -d ' \\n' | grep -q '\"name\":\"cholmod\",[^{}]*\"available\":true'\n"
               "test -s /usr/share/man/man1/polydec-spectrum.1.gz")
    system.put("readme.py", door("python") + CHECK_PYTHON)
    system.run(f"python3 readme.py; {CHECK_PAGE}")
    put_program(system, options.command, "find_package(polydec REQUIRED)")
    system.run(f"cmake -B build; cmake --build build; build/readme; {CHECK_PAGE}; build/engines cholmod")
    for source in ("readme.cpp", "engines.cpp between.cpp"):
        system.run(f"g++ -std=c++20 {source} $(pkg-config --cflags --libs polydec) -o {source.split('.')[0]}")
    system.run(f"./readme; {CHECK_PAGE}; ./engines cholmod")


def build_packages(options, base):
    system = System(base, "build", "build-essential", "lintian")
    run("tar", "-xzf", options.tarball, "-C", system.work)
    tree = next(system.work.iterdir()).name
    system.install(f"./{tree}", command="build-dep")
    system.run(f"cd {tree}; DEB_BUILD_OPTIONS='noopt noautodbgsym' DEB_CXXFLAGS_STRIP=-g dpkg-buildpackage -us -uc -b")
    system.run("lintian --allow-root --fail-on error,warning *.changes")
    return system.work


# From Debian's packages, where nothing better is at hand.
MAKE_WHEELS = """
import importlib.metadata, os, sys, zipfile
place = "/usr/lib/python3/dist-packages"
for name in sys.argv[1:]:
    version = importlib.metadata.version(name)
    info = f"{name}-{version}.dist-info"
    with zipfile.ZipFile(f"wheels/{name}-{version}-py3-none-any.whl", "w") as wheel:
        for folder, _, files in os.walk(f"{place}/{name}", followlinks=True):
            for file in files:
                wheel.write(f"{folder}/{file}", os.path.relpath(f"{folder}/{file}", place))
        wheel.writestr(f"{info}/METADATA", f"Metadata-Version: 2.1\\nName: {name}\\nVersion: {version}\\n")
        wheel.writestr(f"{info}/WHEEL", "Wheel-Version: 1.0\\nRoot-Is-Purelib: false\\nTag: py3-none-any\\n")
        wheel.writestr(f"{info}/RECORD", "".join(f"{each},,\\n" for each in wheel.namelist()))
"""


def sdist(options, base):
    system = System(base, "sdist", *FOUR_PACKAGES, "g++", "cmake", "ninja-build", "rapidjson-dev",
                    "libsuitesparse-dev", "python3-dev", "python3-venv", "python3-pip-whl",
                    "python3-setuptools-whl", "python3-wheel-whl", "python3-numpy", "python3-scipy",
                    "python3-pybind11")
    run("tar", "-xzf", options.tarball, "-C", system.work)
    run(sys.executable, "-m", "build", "--sdist", "--no-isolation", "-o", system.work,
        next(system.work.glob("polydec-*/")))
    system.put("make_wheels.py", MAKE_WHEELS)
    system.run("mkdir wheels; cp /usr/share/python-wheels/*.whl wheels; python3 make_wheels.py numpy scipy pybind11")
    system.run("python3 -m venv empty; export CMAKE_ARGS='-DPOLYDEC_CHOLMOD=ON "
               f"-DCMAKE_CXX_FLAGS_RELEASE={FAST}'; empty/bin/pip install --no-index --find-links wheels *.tar.gz")
    system.put("readme.py", door("python") + CHECK_PYTHON)
    system.run(f"empty/bin/python readme.py; {CHECK_PAGE}")


def contained(options, base):
    system = System(base, "contained", *FOUR_PACKAGES, "g++", "cmake", "ninja-build")
    shutil.copy(options.tarball, system.work)
    put_program(system, options.command, "include(FetchContent)\n"
                f"FetchContent_Declare(polydec URL /srv/{options.tarball.name})\n"
                "FetchContent_MakeAvailable(polydec)")
    system.run("cmake -B build -G Ninja -DPOLYDEC_COMPILE_BY_MODULE=ON -DCMAKE_BUILD_TYPE=Release "
               f"-DCMAKE_CXX_FLAGS_RELEASE={FAST}; cmake --build build -j2")
    system.run(f"build/readme; {CHECK_PAGE}; ! build/engines cholmod")
    system.install("libsuitesparse-dev")
    system.run(f"cmake build; cmake --build build -j2; build/readme; {CHECK_PAGE}; build/engines cholmod")


PARTS = {part.__name__: part for part in (contained, sdist, packages)}


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("command", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--debs", type=Path)
    parser.add_argument("parts", nargs="*", default=list(PARTS))
    options = parser.parse_args()
    folder = options.folder.resolve()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    base = empty_system(folder)
    options.tarball = Path(run(ROOT / "scripts/tarball.sh", folder).strip())
    for part in options.parts:
        PARTS[part](options, base)
        print(part, "passed", flush=True)
    shutil.rmtree(folder)


if __name__ == "__main__":
    try:
        main()
    except Failure as failure:
        sys.exit(str(failure))
