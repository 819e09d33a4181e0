# SPDX-License-Identifier: MIT
"""Runs all code of docs/answers, which tests/house/readme.py holds to the pages, and compares what
it prints with what they show: the indented lines below `Command` and `Python` with the command and
with Python, those below `C++` with C++ and Python, and a message in quotes with any of them.
Runs what stands behind a `$` on README.md and on all pages of docs/, and compares whole answers: a
line `..` on the page stands for lines left out. Meshes come from POLYDEC_TEST_DATA.

Usage: answers.py ROOT COMMAND PROGRAMS, the folder of the C++ programs. Exit code: 0 all as shown,
1 not, 77 if there is no package for Python.
"""
import contextlib
import io
import os
import re
import runpy
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

LINES = 45
HEADINGS = ["Command", "Python", "C++"]
NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?!\w)")
SECONDS = re.compile(r"\d+\.\d\d s$")
LEFT_OUT = ".."


def same(ours, theirs):
    """Whether two lines have the same words, and numbers that differ by rounding alone; times at
    their ends may be any."""
    ours, theirs = (SECONDS.sub("s", line) for line in (ours, theirs))
    if NUMBER.sub("#", ours).split() != NUMBER.sub("#", theirs).split():
        return False
    pairs = zip(map(float, NUMBER.findall(ours)), map(float, NUMBER.findall(theirs)))
    return all(abs(a - b) <= 2e-5 * max(abs(a), abs(b)) + 1e-9 for a, b in pairs)


def unsaid(shown, said):
    """The first of the lines shown that is not said behind the line before; or None."""
    said = iter(said.splitlines())
    return next((line for line in shown if not any(same(line, each) for each in said)), None)


def sections(page):
    """By heading what stands below it; by None what stands above."""
    parts = re.split(r"^## (.*)\n", page, flags=re.MULTILINE)
    return {None: parts[0], **dict(zip(parts[1::2], parts[2::2]))}


def without_code(section):
    return re.sub(r"^```.*?^```$", "", section, flags=re.DOTALL | re.MULTILINE)


def shown(section):
    """The indented lines of a section, outside of code."""
    return [line[4:] for line in without_code(section).splitlines() if line.startswith("    ")]


def messages(section):
    return [" ".join(text.split()) for text in re.findall(r'"([^"]+)"', without_code(section))]


def sessions(page):
    """The commands behind a `$`, each with the indented lines up to the next one."""
    for block in re.findall(r"^    \$ .*\n(?:\n*    .*\n)*", without_code(page), re.MULTILINE):
        parts = re.split(r"^    \$ (.*)\n", block, flags=re.MULTILINE)
        yield from zip(parts[1::2], map(shown, parts[2::2]))


def absent(command, folder, meshes):
    """Brings the files that a command reads into a folder, from the meshes: the first not there."""
    words = command.split()
    for before, word in zip(words, words[1:]):
        is_read = re.fullmatch(r"\.[a-z]+", Path(word).suffix) and before != "-o"
        if is_read and not (folder / word).exists():
            found = next(meshes.rglob(word), None)
            if found is None:
                return word
            shutil.copy(found, folder)
    return None


def unlike(lines, said):
    """A line shown that is not said, or the other way round; or None."""
    kept = [line for line in lines if line.strip() != LEFT_OUT]
    other = None if kept != lines else unsaid(filter(str.strip, said.splitlines()), "\n".join(kept))
    return unsaid(kept, said) or other


def wrong_sessions(page, meshes, environment):
    """What is wrong with the sessions of a page, which share a folder."""
    folder = Path(folder_with([]))
    for command, lines in sessions(page):
        missing = absent(command, folder, meshes)
        if missing:
            print(f"skipped, as POLYDEC_TEST_DATA has no {missing}: {command}")
            continue
        script = folder / "session.sh"
        script.write_text(command)
        said = of_command(script, folder, environment)
        line = None if said is None else unlike(lines, said)
        if line:
            yield f"`{line}` stands on one side only of `{command}`, which prints:\n{said}"


def of_command(path, folder, environment):
    """What a script prints; None if it needs what is not there."""
    if "mpirun" in path.read_text() and not (shutil.which("mpirun") and shutil.which(
            "polydec-mpi", path=environment["PATH"])):
        return None
    answer = subprocess.run(["sh", "-e", path], cwd=folder, env=environment, text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if answer.returncode:
        sys.exit(f"{path.name} ends with {answer.returncode}:\n{answer.stdout}")
    return answer.stdout


def of_python(path, folder):
    said = io.StringIO()
    os.chdir(folder)
    with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
        runpy.run_path(str(path), run_name="__main__")
    return said.getvalue()


def of_programs(programs, files):
    """What each answer prints in C++, by its name."""
    told = {}
    for program in sorted(programs.glob("answers_*")):
        if not program.is_file() or not os.access(program, os.X_OK):
            continue
        answer = subprocess.run([program], cwd=folder_with(files), text=True,
                                stdout=subprocess.PIPE)
        if answer.returncode:
            sys.exit(f"{program.name} ends with {answer.returncode}:\n{answer.stdout}")
        parts = re.split(r"^== (.*)\n", answer.stdout, flags=re.MULTILINE)
        told |= dict(zip(parts[1::2], parts[2::2]))
    return told


def folder_with(files):
    folder = tempfile.mkdtemp(dir=tempfile.gettempdir())
    for file in files:
        shutil.copy(file, folder)
    return folder


def complaints(page, said):
    """What is wrong with a page, given what its code says in each language, None if nothing."""
    parts = sections(page)
    if list(parts)[1:] != HEADINGS:
        yield f"its headings are not {', '.join(HEADINGS)}"
        return
    if page.count("\n") > LINES:
        yield f"it has more than {LINES} lines"
    for heading, languages in (("Command", ["sh"]), ("Python", ["py"]), ("C++", ["py", "cpp"])):
        for language in languages:
            if said.get(language) is None:
                continue
            line = unsaid(shown(parts[heading]), said[language])
            if line is not None:
                yield f"{language} does not print `{line}`, but:\n{said[language]}"
    everything = " ".join(" ".join(filter(None, said.values())).split())
    for message in messages(parts["C++"]):
        if message not in everything and said.get("sh", "") is not None:
            yield f"no code prints `{message}`:\n{said}"
    if not messages(parts["C++"]):
        yield "it quotes no message"


def check_itself():
    """The check must be able to fail."""
    page = '# A\n## Command\n    a 1\n    b\n## Python\n## C++\n```cpp\n    "x"\n```\n    c\nIt says "d e".\n'
    good = {"sh": "a 1.00001\nz\nb\n", "py": "c\nd\n e", "cpp": "c\n"}
    assert not list(complaints(page, good)), list(complaints(page, good))
    for language, text in (("sh", "b\na 1\n"), ("sh", "a 1.1\nb"), ("py", "c\n"), ("cpp", "")):
        assert len(list(complaints(page, {**good, language: text}))) == 1, text
    assert list(complaints(page.replace("## Python\n", ""), good))
    assert list(complaints(page + "\n" * LINES, good))
    page = "    no\n\n    $ a\n    1\n\n    2\n    $ b\nText\n    no\n```\n    $ no\n```\n    $ c\n"
    assert list(sessions(page)) == [("a", ["1", "2"]), ("b", []), ("c", [])]
    assert not unlike(["x 1", "0.03 s"], "x 1\n\n0.51 s\n") and not unlike(["a", ".."], "a\nb\n")
    for lines in (["x 1"], ["x 1", "y", "z"], ["x 2", "y"], ["z", ".."], ["y", "x 1"]):
        assert unlike(lines, "x 1\ny\n"), lines
    assert absent("polydec info a.off -o b.off", Path("none"), Path("none")) == "a.off"


def main():
    root, command, programs = Path(sys.argv[1]), Path(sys.argv[2]), Path(sys.argv[3])
    code = root / "examples" / "answers"
    files = [path for path in code.iterdir() if path.suffix in (".off", ".msh")]
    environment = {**os.environ, "PATH": f"{command.parent}:{os.environ['PATH']}",
                   "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    tempfile.tempdir = tempfile.mkdtemp()
    pages = {path.stem: path.read_text() for path in sorted((root / "docs/answers").glob("*.md"))}
    index = pages.pop("README")
    told = of_programs(programs, files)
    wrong = [f"{name} is an answer without a page" for name in
             {path.stem for path in code.glob("*.py")} | {path.stem for path in code.glob("*.sh")}
             | set(told) if name not in pages]
    for name, page in pages.items():
        said = {"cpp": told.get(name)}
        script, python = code / f"{name}.sh", code / f"{name}.py"
        if script.is_file():
            said["sh"] = of_command(script, folder_with(files), environment)
        if python.is_file():
            said["py"] = of_python(python, folder_with(files))
        wrong += [f"{name}.md: {text}" for text in complaints(page, said)]
        if f"({name}.md)" not in index:
            wrong.append(f"README.md does not link to {name}.md")
    meshes = Path(os.environ.get("POLYDEC_TEST_DATA", "none")) / "meshes"
    for path in [root / "README.md", *sorted((root / "docs").rglob("*.md"))]:
        wrong += [f"{path.relative_to(root)}: {text}" for text in
                  wrong_sessions(path.read_text(), meshes, environment)]
    os.chdir(root)
    shutil.rmtree(tempfile.tempdir)
    print("\n".join(wrong) or f"{len(pages)} answers and all sessions show what is printed.")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    check_itself()
    try:
        import polydec  # noqa: F401
    except ImportError:
        sys.exit(77)
    main()
