#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""How large pages are, how soon they are there, and how many frames a second they draw, in Debian's
chromium without a graphics card, all by software.

    benchmarks/pages.py build/release/tools/polydec

Needs chromium-driver and python3-selenium.
"""
import sys
import tempfile
import time
from pathlib import Path
from subprocess import run

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "pages"))

from browser import Browser, skip_if_missing  # noqa: E402

# title, lines of the command, page, what is moved
PAGES = (
    ("a million triangles, 3 modes",
     ("generate icosphere --frequency 224 -o a.off",
      "spectrum a.off --side primal --degree 0 --count 3 -o page.html"), "turn"),
    ("97 336 cubes of 584 016 tetrahedra, cut",
     ("generate kuhn --dimension 3 --cells 46 -o b.mesh", "view b.mesh -o page.html"), "cut"),
    ("13 824 cubes of 82 944 tetrahedra, cut",
     ("generate kuhn --dimension 3 --cells 24 -o c.mesh", "view c.mesh -o page.html"), "cut"),
)
FRAMES = 10
# Draws a frame after each change, and gives the seconds that all took.
MOVE = """
const [what, frames] = arguments, done = arguments[arguments.length - 1];
const canvas = document.getElementById("canvas"), gl = canvas.getContext("webgl2");
const pixel = new Uint8Array(4), begin = performance.now();
let frame = 0;
const next = () => {
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel); // waits for the drawing
    if (frame++ === frames)
        return done((performance.now() - begin) / 1000);
    if (what === "cut") {
        const cut = document.getElementById("cut");
        cut.value = 20 + 60 * frame / frames;
        cut.dispatchEvent(new Event("input", {bubbles: true}));
    } else {
        canvas.dispatchEvent(new KeyboardEvent("keydown", {key: "ArrowLeft", bubbles: true}));
    }
    requestAnimationFrame(next);
};
requestAnimationFrame(next);
"""


def main(polydec):
    skip_if_missing()
    print("| page | MB | made in s | ready in s | frames a second |")
    print("|---|---|---|---|---|")
    for title, lines, moved in PAGES:
        with tempfile.TemporaryDirectory() as folder:
            begin = time.monotonic()
            for line in lines:
                begin = time.monotonic()
                run([polydec, *line.split()], cwd=folder, check=True, capture_output=True)
            made = time.monotonic() - begin
            page = Path(folder) / "page.html"
            with Browser(width=1280, height=720) as browser:
                browser.driver.set_script_timeout(600)
                begin = time.monotonic()
                browser.open(page, seconds=300)
                browser.frames()
                ready = time.monotonic() - begin
                if moved == "cut":
                    browser.set(axis=0, cut=50)
                seconds = browser.driver.execute_async_script(MOVE, moved, FRAMES)
            print(f"| {title} | {page.stat().st_size / 1e6:.1f} | {made:.1f} | {ready:.1f} | "
                  f"{FRAMES / seconds:.1f} |", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main(*(str(Path(word).resolve()) for word in sys.argv[1:2])))
