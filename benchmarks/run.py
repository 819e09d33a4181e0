#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures polydec: builds the benchmarks, runs them, and writes tables and plots.

    benchmarks/run.py                 everything, about a quarter of an hour, into build/performance
    benchmarks/run.py --docs          and puts the numbers into docs/performance.md
    benchmarks/run.py --filter tets   some rows only
    benchmarks/run.py --from FOLDER   tables and plots again, from the results of an earlier run

Needs Python 3 alone. Have nothing else running. Exit code: 0, or 1 where a row failed.
"""
import argparse
import json
import os
import platform
import re
import shutil
import subprocess
import sys
import tempfile
from datetime import date
from pathlib import Path

import tables

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "performance.md"
BEGIN, END = "<!-- numbers: written by benchmarks/run.py -->", "<!-- end of numbers -->"
FRESH_ROWS = "^(sphere|sphere_shuffled|sphere_4M|torus|tets)/(chain|merging|renumbered)/"
NO_COUNTERS = {"name", "run_name", "run_type", "family_index", "per_family_instance_index",
               "repetitions", "repetition_index", "threads", "iterations", "time_unit"}


def arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build-folder", type=Path, default=ROOT / "build" / "release")
    parser.add_argument("--program", type=Path, help="instead of that of the build folder")
    parser.add_argument("--plot-program", type=Path, help="the same for polydec_benchmark_plot")
    parser.add_argument("--out", type=Path, default=ROOT / "build" / "performance")
    parser.add_argument("--from", dest="earlier", type=Path, help="results.json is there")
    parser.add_argument("--filter", default=".", help="regular expression for the rows")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--smoke", action="store_true", help="small meshes, one round")
    parser.add_argument("--docs", action="store_true", help="write into docs/")
    return parser.parse_args()


def build(options):
    """Only what is not there already, or has changed; the smoke test finds it built."""
    if options.program and options.plot_program or options.smoke:
        return
    if not (options.build_folder / "CMakeCache.txt").exists():
        subprocess.run(["cmake", "--preset", "release"], cwd=ROOT, check=True)
    subprocess.run(["cmake", "--build", options.build_folder, "--target", "polydec_benchmarks",
                    "polydec_benchmark_plot"], check=True)


def run(program, extra):
    """Runs the program, showing what it prints, and gives its results."""
    environment = dict(os.environ, OMP_WAIT_POLICY="passive", OPENBLAS_NUM_THREADS="1",
                       OMP_NUM_THREADS="1")
    with tempfile.TemporaryDirectory() as folder:
        results = Path(folder) / "results.json"
        subprocess.run([program, f"--benchmark_out={results}", "--benchmark_out_format=json",
                        *extra], env=environment, check=True)
        return json.loads(results.read_text() or "{}")


def rows_of(results):
    """Name -> counters; the rows that failed are left out."""
    rows = {}
    for entry in results.get("benchmarks", []):
        name = entry["name"].split("/iterations:")[0]
        if not entry.get("error_occurred"):
            rows[name] = {key: value for key, value in entry.items() if key not in NO_COUNTERS}
    return rows


def failures_of(results):
    return [f"{entry['name']}: {entry.get('error_message', '')}"
            for entry in results.get("benchmarks", []) if entry.get("error_occurred")]


def first_match(path, pattern):
    try:
        found = re.search(pattern, Path(path).read_text())
    except OSError:
        return None
    return found.group(1) if found else None


def machine(context):
    """What the numbers were measured on, a sentence."""
    processor = first_match("/proc/cpuinfo", r"model name\s*:\s*(.+)") or platform.processor()
    memory = first_match("/proc/meminfo", r"MemTotal:\s*(\d+)")
    memory = f", {int(memory) / 2**20:.0f} GB of memory" if memory else ""
    loads = context.get("load_avg") or [0.0]
    bandwidth = float(context["copy_bandwidth"]) / 1e9
    return (f"{processor}, {context['num_cpus']} cores at {context['mhz_per_cpu'] / 1000:.1f} GHz"
            f"{memory}; {platform.system()} {platform.machine()}; {context['compiler']}; one "
            f"thread where nothing else is said; copy bandwidth {bandwidth:.1f} GB/s (read and "
            f"written); load at the beginning {loads[0]:.2f}; {date.today().isoformat()}.")


def report(results, fresh, is_smoke):
    """The part of the page that is measured."""
    rows, fresh_rows = rows_of(results), rows_of(fresh)
    remark = "Smoke: the sizes are not those that the rows say. " if is_smoke else ""
    parts = [
        ("", remark + machine(results["context"]) + "\n"),
        ("## From a mesh to its operators", tables.chains(rows, fresh_rows)),
        ("## Stage by stage", tables.stages(rows)),
        ("## Two threads beside one", tables.threads(rows)),
        ("## Beside other codes", tables.pairs(rows)),
        ("## Poisson's problem in three dimensions", tables.solids(rows)),
        ("## Reading files", tables.files(rows)),
        ("## From file to file", tables.whole(rows)),
        ("## Cost against size", tables.sizes(rows) + "\n"
         "![Time against cells](images/performance_time.svg)\n\n"
         "![Peak memory against cells](images/performance_memory.svg)\n"),
    ]
    return "\n".join(f"{title}\n\n{text}".lstrip() for title, text in parts)


def plot(program, path, title, y, series, slope=None):
    lines = [f"title {title}", "x cells", y]
    for name, points in series.items():
        lines.append(f"series {name}")
        lines += [f"{cells!r} {value!r}" for cells, value in points]
    if slope is not None:
        lines.append(f"slope {slope} 0")
    answer = subprocess.run([program], input="\n".join(lines), capture_output=True, text=True)
    if answer.returncode:
        sys.exit(answer.stderr)
    path.write_text(answer.stdout)


def plots(program, rows, out):
    """Writes the plots for which there are rows, and gives their paths."""
    made = []
    for name, title, y, counter, slope in (
            ("performance_time.svg", "Time against size", "y seconds", "min_s", 1),
            ("performance_memory.svg", "Peak of memory against size", "linear_y bytes a cell",
             "peak_B", None)):
        series = tables.size_series(rows, counter)
        if series:
            plot(program, out / name, title, y, series, slope)
            made.append(out / name)
    return made


def write_docs(text, pictures):
    page = PAGE.read_text()
    if BEGIN not in page or END not in page:
        sys.exit(f"{PAGE} has no place for the numbers: `{BEGIN}` and `{END}`, a line each")
    before, after = page.split(BEGIN)[0], page.split(END)[1]
    PAGE.write_text(f"{before}{BEGIN}\n\n{text}\n{END}{after}")
    for picture in pictures:
        shutil.copy(picture, ROOT / "docs" / "images" / picture.name)


def measured(options):
    """Results of the rows, and of some of them again with memory that was never touched."""
    if options.earlier:
        saved = json.loads((options.earlier / "results.json").read_text())
        return saved["kept"], saved["fresh"]
    program = (options.program
               or options.build_folder / "benchmarks" / "polydec_benchmarks").resolve()
    extra = ["--smoke"] if options.smoke else [f"--rounds={options.rounds}"]
    kept = run(program, [*extra, f"--benchmark_filter={options.filter}"])
    if not kept:
        sys.exit(f"no row fits --filter {options.filter}")
    fresh = {}
    if any(re.search(FRESH_ROWS, entry["name"]) for entry in kept["benchmarks"]):
        fresh = run(program, [*extra, "--fresh-memory", f"--benchmark_filter={FRESH_ROWS}"])
    return kept, fresh


def main():
    options = arguments()
    if not options.earlier:
        build(options)
    kept, fresh = measured(options)

    options.out.mkdir(parents=True, exist_ok=True)
    (options.out / "results.json").write_text(json.dumps({"kept": kept, "fresh": fresh}, indent=1))
    plot_program = (options.plot_program
                    or options.build_folder / "benchmarks" / "polydec_benchmark_plot").resolve()
    pictures = plots(plot_program, rows_of(kept), options.out)
    text = report(kept, fresh, options.smoke)
    (options.out / "performance.md").write_text(text)
    print(f"\n{text}\nwritten: {options.out}")
    if options.docs:
        write_docs(text, pictures)

    failures = failures_of(kept) + failures_of(fresh) + tables.memory_failures(rows_of(kept))
    for failure in failures:
        print(f"failed: {failure}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
