# SPDX-License-Identifier: MIT
"""Checks the order of the house: who includes whom, license lines, lengths, dimension branches.

Usage: layering.py ROOT PUBLIC_HEADERS COMPONENT_HEADERS; the last two are files with a public
header's path a line, and of those the headers of components, which the umbrella leaves out.
A complaint a line, as file:line: what is wrong. Exit code: 0 none, 1 some.
"""
import re
import sys
from pathlib import Path

import sources

CHAIN = ["base", "system", "backends", "complex", "meshes", "dec", "shape", "solvers", "io", "distributed",
         "polydec.h", "python", "examples", "tools"]
LAST = {"tests", "benchmarks"}
WITHOUT_DIMENSION = {"complex", "dec"}
UMBRELLA = "polydec.h"
LIBRARY = set(CHAIN[:CHAIN.index("polydec.h")])
MAX_LINES = 400

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
STANDARD = re.compile(r"[a-z_]+[0-9]*$")
ENGINE = re.compile(
    r"Spectra/|suitesparse/|(sundials|cvode|nvector|sunnonlinsol)/"
    r"|(cholmod|umfpack|klu|amd|colamd|petsc|slepc|tetgen|mpi)\w*\.(h|hpp)$"
    r"|Eigen/(\w+Support|SparseCholesky|SparseLU|IterativeLinearSolvers)$")
OVER_RANKS = re.compile(r"(petsc|slepc|mpi)\w*\.h$")
PETSC_HEADER = "distributed/petsc.h"  # for who works with its matrices

# What precompiled headers bring to the library, where a file that leaves an include out compiles.
PRECOMPILED = {
    "fmt/format.h": re.compile(r"\bfmt::"),
    "base/errors.h": re.compile(r"\b(?:InvalidInput|SolverFailure|BackendUnavailable|IoError)\b"),
    "base/types.h": re.compile(r"\b(?:Vector|DenseMatrix|SparseMatrix)\b"),
}

DIMENSION = r"\b(?:\w*_)?dim(?:ension)?(?:\(\))?"
BRANCH = re.compile(
    rf"{DIMENSION}\s*==\s*\d|\b\d+\s*==\s*(?:\w+(?:\.|->))*{DIMENSION}"
    rf"|\bswitch\s*\(\s*(?:\w+(?:\.|->))*{DIMENSION}"
    r"|\bn\s*==\s*[1-9]|\bswitch\s*\(\s*n\s*\)")
COMMENT_OR_STRING = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.S)

# A function of a test's file. It is in a named namespace, so that no compiler warns of an unused one.
HELPER = re.compile(r"^\w[\w:<>,&* ]*[ &*](?!PrintTo\b)(\w+)\([^;{}]*\) \{", re.M)
COMMENT = re.compile(r'("(?:\\.|[^"\\\n])*")|//[^\n]*|/\*.*?\*/', re.S)
STRING = re.compile(r'"((?:\\.|[^"\\\n])*)"')
OPTION = re.compile(r"(?<![\w}-])(?:--[a-z][a-z-]*|-[a-z](?![\w-]))")


def place(path):
    """The top folder, or the umbrella header, that stands for a path in the chain."""
    return Path(path).parts[0]


def may_include(here, there):
    if here == there:
        return True
    if there in LAST:
        return False
    return here in LAST or (here in CHAIN and CHAIN.index(there) < CHAIN.index(here))


def include_complaint(path, delimiter, target, public):
    """What is wrong with one #include line, or None."""
    here, there = place(path), place(target)
    ours = there in CHAIN or there in LAST
    if ours and not may_include(here, there):
        return f"{here} must not include {target}: {there} is not to its left in the chain"
    if not ours and delimiter == '"':
        return f'"{target}" is no path from the repository root (third-party headers go in <>)'

    in_backends = "backends" in path.parts[:2]
    over_ranks = here in LAST | {"distributed", "examples"}
    may_have = in_backends or (over_ranks and OVER_RANKS.match(target))
    in_test = here in LAST | {"examples"} and target.startswith("Eigen/")
    if not may_have and not in_test and ENGINE.match(target):
        return f"the engine header <{target}> belongs into backends/"

    if path.as_posix() in public:
        if ours and target not in public:
            return f"this public header includes {target}, which is not installed"
        if (not ours and not target.startswith("Eigen/") and not STANDARD.match(target)
                and not (path.as_posix() == PETSC_HEADER and OVER_RANKS.match(target))):
            return f"a public header includes Eigen and std alone, not <{target}>"
    return None


def without_comments(code):
    """The same lines, with comments and strings emptied."""
    return COMMENT_OR_STRING.sub(lambda match: "\n" * match.group().count("\n"), code)


def without_plain_comments(code):
    """The same characters, with those of comments blank; strings stay."""
    return COMMENT.sub(lambda match: match.group(1) or re.sub(r"[^\n]", " ", match.group()), code)


def check_cpp(path, code, public):
    for number, line in enumerate(code.splitlines(), 1):
        include = INCLUDE.match(line)
        complaint = include and include_complaint(path, *include.groups(), public)
        if complaint:
            yield f"{path}:{number}: {complaint}"
    if place(path) in LIBRARY:
        yield from check_texts(path, code)
    if place(path) in WITHOUT_DIMENSION:
        for number, line in enumerate(without_comments(code).splitlines(), 1):
            if BRANCH.search(line):
                yield f"{path}:{number}: a branch on the dimension; write it for every dimension"
    if path.match("tests/**/*.cpp") and "::in_" in code:
        bare = without_comments(code)
        for helper in HELPER.finditer(bare):
            if len(re.findall(rf"\b{helper[1]}\b", bare)) == 1:
                number = bare.count("\n", 0, helper.start()) + 1
                yield f"{path}:{number}: {helper[1]} is never called"


def check_texts(path, code):
    """Texts of the library tell C++ names; options are the command's."""
    for match in STRING.finditer(without_plain_comments(code)):
        option = OPTION.search(match.group(1))
        if option:
            number = code.count("\n", 0, match.start()) + 1
            yield f"{path}:{number}: `{option.group()}` is an option of the command"


def check_source(path, code):
    lines = code.splitlines()
    first = 1 if lines and lines[0].startswith("#!") else 0
    if "SPDX-License-Identifier: MIT" not in "".join(lines[first:first + 1]):
        yield f"{path}:{first + 1}: the line `SPDX-License-Identifier: MIT` is missing"
    if len(lines) > MAX_LINES:
        yield f"{path}:{len(lines)}: longer than {MAX_LINES} lines; divide it by concepts"


def room(path):
    """The folder of a file of the library: the rooms of one floor do not look back."""
    return Path(path).parent.as_posix()


def circles(root, paths):
    """Rooms of one folder that include each other, in one step or in several."""
    arrows = {}
    for path in paths:
        for target in included(root, path):
            if place(target) == place(path) and room(target) != room(path):
                arrows.setdefault(room(path), {}).setdefault(room(target), path)

    def reached(start):
        found, ahead = set(), [start]
        while ahead:
            new = arrows.get(ahead.pop(), {}).keys() - found
            found |= new
            ahead += new
        return found

    for here, targets in sorted(arrows.items()):
        for there, path in sorted(targets.items()):
            if here in reached(there):
                yield f"{path}:1: {here} and {there} include each other"


def included(root, path):
    """What a file includes by its path from the root."""
    lines = sources.text(root, path).splitlines()
    return [match.group(2) for match in map(INCLUDE.match, lines)
            if match and match.group(1) == '"']


def unsaid(root, library):
    """Files that use what only a precompiled header gives them, as none of their includes does."""
    known = {}

    def reach(path):
        if path not in known:
            known[path] = set()  # also ends a circle
            lines = sources.text(root, path).splitlines()
            for _, target in (match.groups() for match in map(INCLUDE.match, lines) if match):
                known[path].add(target)
                if place(target) in LIBRARY and (Path(root) / target).is_file():
                    known[path] |= reach(Path(target))
        return known[path]

    for path in library:
        code = without_comments(sources.text(root, path))
        for header, use in PRECOMPILED.items():
            brings = {header} if header != "fmt/format.h" else {header, "fmt/ranges.h"}
            used = use.search(code)
            if used and not brings & (reach(path) | {path.as_posix()}):
                number = code.count("\n", 0, used.start()) + 1
                yield f"{path}:{number}: uses {used.group()} and includes no {header}"


def not_reached(root, public):
    """Installed headers that who includes the umbrella does not see."""
    found, ahead = {UMBRELLA}, [UMBRELLA]
    while ahead:
        new = set(included(root, ahead.pop())) & public - found
        found |= new
        ahead += new
    for header in sorted(public - found):
        yield f"{header}:1: installed, but not reached from {UMBRELLA}"


def check(root, public, components=frozenset()):
    """All complaints about the tree below root; public is the set of the installed headers, of
    which those of components are included one by one."""
    library = [path for path in sources.files(root)
               if sources.is_cpp(path) and place(path) in LIBRARY]
    complaints = [*circles(root, library), *unsaid(root, library),
                  *not_reached(root, public - components)]
    for path in filter(sources.is_source, sources.files(root)):
        code = sources.text(root, path)
        complaints += check_source(path, code)
        if sources.is_cpp(path):
            complaints += check_cpp(path, code, public)
    return complaints


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    headers = sources.public_headers(sys.argv[1], sys.argv[2])
    components = sources.public_headers(sys.argv[1], sys.argv[3])
    sys.exit(sources.report(check(sys.argv[1], headers, components), "Every folder keeps to its place."))
