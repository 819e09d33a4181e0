# SPDX-License-Identifier: MIT
"""The tarball of a commit has the same bytes when it is made again, in another place and time zone,
and an sdist holds each file that the tarball holds but for what MANIFEST.in leaves out.

Usage: tarball.py. Skipped where there is no git checkout, or no build (python3-build).
"""
import os
import re
import subprocess
import sys
import tarfile
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LEFT_OUT = re.compile(r"(\.gitignore|\.ci/.*|.*\.so)$")


def run(*words, **variables):
    return subprocess.run([str(word) for word in words], cwd=ROOT, check=True, text=True,
                          stdout=subprocess.PIPE, env={**os.environ, **variables}).stdout


def names_in(path):
    """Files, without the folder that holds them."""
    with tarfile.open(path) as tar:
        return {member.name.split("/", 1)[1] for member in tar if member.isfile()}


def main():
    if not (ROOT / ".git").exists():
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        tarballs = []
        for name, zone in (("first", "UTC"), ("second", "Asia/Tokyo")):
            place = Path(folder) / name
            place.mkdir()
            tarballs.append(Path(run("scripts/tarball.sh", place, TZ=zone).strip()))
        if tarballs[0].read_bytes() != tarballs[1].read_bytes():
            sys.exit("two tarballs of one commit differ")
        print(tarballs[0].name, tarballs[0].stat().st_size, "bytes, twice the same")

        try:
            import build  # noqa: F401
        except ImportError:
            return
        source = Path(folder) / "source"
        with tarfile.open(tarballs[0]) as tar:
            tar.extractall(source)
        tree = next(source.iterdir())
        subprocess.run([sys.executable, "-m", "build", "--sdist", "--no-isolation", "-o",
                        Path(folder) / "dist", tree], check=True, stdout=subprocess.DEVNULL)
        sdist = names_in(next((Path(folder) / "dist").iterdir()))
        missing = [name for name in names_in(tarballs[0]) - sdist if not LEFT_OUT.match(name)]
        if missing:
            sys.exit("MANIFEST.in leaves out " + ", ".join(sorted(missing)))
        print("the sdist holds", len(sdist), "files")


if __name__ == "__main__":
    main()
