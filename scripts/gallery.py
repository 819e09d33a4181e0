#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the gallery: pages by the command and by the examples, bound into one.

    scripts/gallery.py build/release                      pages, in demo-output/gallery
    scripts/gallery.py build/release --pictures           and the pictures of docs/gallery.md
    scripts/gallery.py --docs                             docs/gallery.md itself
    scripts/gallery.py build/release --check              whether it is the one that would be written

Pictures are taken by chromium with chromium-driver and python3-selenium, from the pages, after the
keys and choices that gallery_entries.py names. Exit code: 0 done, 1 something failed.
"""
import argparse
import shlex
import subprocess
import sys
import time
from pathlib import Path

from gallery_entries import ENTRIES

ROOT = Path(__file__).resolve().parent.parent
HEAD = """# Gallery

Each picture shows a [page](pages.md) for any browser. There you can turn it, cut it and read off
values. This command makes all of them, and binds them into
`demo-output/gallery/gallery.html`:

    scripts/gallery.py build/release
"""


def run(line, programs, folder):
    """A line of an entry: the command `polydec`, or an example by its name."""
    words = shlex.split(line)
    program = programs["polydec" if words[0] == "polydec" else "examples"] / words[0]
    done = subprocess.run([program, *words[1:]], cwd=folder, capture_output=True, text=True,
                          check=False)
    if done.returncode != 0:
        sys.exit(f"gallery: `{line}` ended with {done.returncode}\n{done.stderr}")


def make_pages(programs, folder):
    folder.mkdir(parents=True, exist_ok=True)
    for entry in ENTRIES:
        for line in entry.lines:
            run(line, programs, folder)
        if not (folder / entry.page).is_file():
            sys.exit(f"gallery: {entry.page} was not made by {'; '.join(entry.lines)}")
    pages = " ".join(entry.page for entry in ENTRIES)
    run(f"polydec view {pages} -o gallery.html", programs, folder)


def browser():
    from selenium import webdriver
    from selenium.webdriver.chrome.options import Options
    from selenium.webdriver.chrome.service import Service
    options = Options()
    for word in ("--headless=new", "--no-sandbox", "--hide-scrollbars", "--use-angle=swiftshader",
                 "--enable-unsafe-swiftshader", "--window-size=780,900"):
        options.add_argument(word)
    return webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)


def take_picture(driver, page, entry, file):
    driver.get(page.resolve().as_uri())
    deadline = time.monotonic() + 60
    while driver.execute_script("return document.body.dataset.state") != "ready":
        if time.monotonic() > deadline:
            sys.exit(f"gallery: {page} does not become ready")
        time.sleep(0.05)
    driver.execute_script("""
        document.querySelector("main").style.gridTemplateColumns = "minmax(0, 1fr)";
        document.querySelector("#view").style.height = "430px";
        const choose = ([id, value]) => {
            const control = document.getElementById(id);
            if (control.type === "checkbox") control.checked = value; else control.value = value;
            control.dispatchEvent(new Event("input", {bubbles: true}));
        };
        arguments[0].forEach(choose);
        const canvas = document.getElementById("canvas");
        for (const key of arguments[1])
            canvas.dispatchEvent(new KeyboardEvent("keydown", {key}));""",
                          list(entry.choices.items()), list(entry.keys))
    time.sleep(0.5)
    driver.find_element("id", "stage").screenshot(str(file))


def take_pictures(folder, pictures):
    pictures.mkdir(parents=True, exist_ok=True)
    driver = browser()
    try:
        for entry in ENTRIES:
            take_picture(driver, folder / entry.page, entry, pictures / f"{entry.name}.png")
    finally:
        driver.quit()


def docs():
    """The text of docs/gallery.md."""
    text = HEAD
    for entry in ENTRIES:
        lines = "\n".join(f"    {line}" for line in entry.lines)
        text += (f"\n## {entry.title}\n\n![{entry.title}](images/gallery/{entry.name}.png)\n\n"
                 f"{entry.words}\n\n{lines}\n")
    return text


def flaw(text):
    """What is wrong with the text of docs/gallery.md; empty if nothing is."""
    wanted, found = docs().splitlines(), text.splitlines()
    differing = [i for i, pair in enumerate(zip(wanted, found)) if pair[0] != pair[1]]
    if not differing and len(wanted) == len(found):
        return ""
    line = differing[0] if differing else min(len(wanted), len(found))
    return f"docs/gallery.md:{line + 1}: not what scripts/gallery.py --docs writes"


def check():
    text = (ROOT / "docs/gallery.md").read_text(encoding="utf-8")
    assert flaw(text + "more\n") and flaw(text.replace("polydec view", "polydec see", 1))
    if flaw(text):
        sys.exit(flaw(text))


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", nargs="?", type=Path, help="folder that polydec was built in")
    parser.add_argument("--examples", type=Path, help="folder of the examples, if it is another")
    parser.add_argument("--out", type=Path, default=ROOT / "demo-output/gallery")
    parser.add_argument("--pictures", action="store_true", help="take docs/images/gallery anew")
    parser.add_argument("--docs", action="store_true", help="write docs/gallery.md anew")
    parser.add_argument("--check", action="store_true", help="fail if docs/gallery.md is old")
    arguments = parser.parse_args()
    if arguments.check:
        check()
    if arguments.docs:
        (ROOT / "docs/gallery.md").write_text(docs(), encoding="utf-8")
    if arguments.build:
        build = arguments.build.resolve()
        examples = (arguments.examples or build / "examples").resolve()
        make_pages({"polydec": build / "tools", "examples": examples}, arguments.out)
        if arguments.pictures:
            take_pictures(arguments.out, ROOT / "docs/images/gallery")
        print(arguments.out / "gallery.html")
    elif not arguments.docs and not arguments.check:
        parser.error("name the folder that polydec was built in, such as build/release")


if __name__ == "__main__":
    main()
