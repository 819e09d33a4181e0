# SPDX-License-Identifier: MIT
"""Tables of docs/performance.md from what the benchmarks counted."""
import math

# name of the row, what it is, target for the time in seconds (or None)
CHAINS = [
    ("sphere/chain", "sphere, 1.0 M triangles: all operators", 0.1),
    ("sphere_shuffled/chain", "the same, vertices and triangles shuffled", 0.22),
    ("sphere_shuffled/renumbered", "the same, renumbered along Morton's curve first", 0.22),
    ("sphere_4M/chain", "sphere, 4.0 M triangles", 0.42),
    ("torus/chain", "torus of split quads, 1.0 M triangles", 0.1),
    ("tets/chain", "box of Kuhn's tetrahedra, 1.57 M", 0.34),
    ("pentatopes/chain", "box of Kuhn's simplices in four dimensions, 0.5 M", 0.3),
    ("sphere/merging", "merging on top: sphere, nothing to merge", 0.025),
    ("torus/merging", "merging on top: torus", 0.09),
    ("tets/merging", "merging on top: box", 0.275),
    ("sphere/discretize", "discretize, with checks and merging: sphere", 0.14),
    ("torus/discretize", "discretize: torus", 0.2),
    ("tets/discretize", "discretize: box", None),
    ("sphere_rough/flips", "intrinsic flips and merging on top: rough sphere, 10 % of the duals "
                           "negative", 0.19),
]
STAGES = [("complex", "complex, d_k included"), ("volumes", "volumes"), ("stars", "stars"),
          ("laplacian", "Laplacian of 0-forms"), ("merging", "merging"),
          ("betti", "Betti numbers"),
          ("derivatives", "d_k as matrices of doubles, when asked for")]
STAGED = [("sphere", "sphere"), ("torus", "torus"), ("tets", "box of tetrahedra")]
PAIRS = [
    ("product/sphere/d0", "d of a 0-form, sphere, beside Eigen's product", 0.5),
    ("product/sphere/d1", "d of a 1-form, sphere", 0.5),
    ("product/tets/d0", "d of a 0-form, tetrahedra", 0.5),
    ("product/tets/d1", "d of a 1-form, tetrahedra", 0.5),
    ("product/tets/d2", "d of a 2-form, tetrahedra", 0.5),
    ("product/sphere/laplacian", "Laplacian, sphere, beside Eigen's triple product", 0.25),
    ("product/tets/laplacian", "Laplacian, tetrahedra", 0.25),
    ("product/sphere_shuffled/renumbered", "Laplacian times vector, shuffled sphere renumbered "
                                           "along Morton's curve, beside the sphere as it was",
     None),
    ("engine/cholmod", "engine cholmod, 500 k unknowns, beside CHOLMOD on the same matrix", 1.05),
    ("engine/eigen.ldlt", "engine eigen.ldlt, 50 k unknowns, beside Eigen", 1.05),
    ("engine/petsc.cg-hypre", "engine petsc.cg-hypre, 238 k unknowns of a box, beside hypre on the "
                              "same matrix", 1.05),
    ("engine/cholmod_8", "engine cholmod, 8 right-hand sides at once, beside one after the other: "
                         "time of each", None),
    ("poisson2d/cholmod", "2D Poisson problem, 500 k unknowns, assembled too, beside CHOLMOD", 1.05),
    ("poisson3d/petsc.cg-hypre", "3D Poisson problem, 1 M unknowns, assembled too, beside hypre",
     1.1),
    ("spectrum/50", "50 smallest eigenpairs, 164 k vertices, certified, beside Spectra and "
                    "CHOLMOD, uncertified", 0.4),
    ("spectrum/torus", "the same, torus of 40 k vertices", 0.6),
    ("spectrum/tets", "the same, 27 k vertices of tetrahedra", 0.6),
]
THREADS = [("sphere", "sphere", 1.6), ("tets", "box of tetrahedra", 1.6)]
THREADED = [("", "all operators"), ("/complex", "complex"), ("/volumes", "volumes"),
            ("/laplacian", "Laplacian of 0-forms")]
MEMORY_TARGETS = {"sphere/chain": (130, 250), "sphere_shuffled/chain": (130, 250),
                  "sphere_shuffled/renumbered": (130, 250),
                  "sphere_4M/chain": (130, 250), "torus/chain": (130, 250),
                  "tets/chain": (190, 350)}
MEMORY_SLACK = 1.1
BOUND_TARGETS = {"sphere/chain": 10, "torus/chain": 10, "sphere_4M/chain": 10, "tets/chain": 15}


def memory_failures(rows):
    """Bytes beyond the targets and what the allocator and small meshes may add."""
    return [f"{name}: {number(rows[name][counter])} bytes a cell, {counter}, where the target "
            f"is {target}"
            for name, targets in MEMORY_TARGETS.items() if name in rows
            for counter, target in zip(("result_B", "peak_B"), targets)
            if target is not None and rows[name][counter] > target * MEMORY_SLACK]


def seconds(value):
    """A time for people, three digits."""
    if value is None:
        return "-"
    for unit, size in (("s", 1.0), ("ms", 1e-3)):
        if value >= 0.9995 * size:
            break
    else:
        unit, size = "us", 1e-6
    scaled = value / size
    return f"{scaled:.{max(0, 2 - math.floor(math.log10(scaled)))}f} {unit}" if scaled else "0"


def number(value, digits=0):
    return "-" if value is None else f"{value:,.{digits}f}"


def table(header, rows):
    lines = [header, ["---"] * len(header), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def verdict(is_met):
    return "met" if is_met else "missed"


def chains(rows, fresh):
    lines = []
    for name, what, goal in CHAINS:
        row = rows.get(name)
        if not row:
            continue
        bound = BOUND_TARGETS.get(name)
        result, peak = MEMORY_TARGETS.get(name, (None, None))
        lines.append([
            what, f"<= {seconds(goal)}" if goal else "-", seconds(row["min_s"]),
            seconds(row["median_s"]), seconds(fresh.get(name, {}).get("min_s")),
            number(row["over_bound"], 1) + (f" (<= {bound})" if bound else ""),
            number(row.get("result_B")) + (f" (<= {result})" if result else ""),
            number(row.get("peak_B")) + (f" (<= {peak})" if peak else ""),
            verdict(row["min_s"] <= goal) if goal else "-",
        ])
    return table(["row", "target", "minimum", "median", "fresh memory", "times the bound",
                  "result, bytes a cell", "peak, bytes a cell", "time"], lines)


def stages(rows):
    lines = []
    for stage, title in STAGES:
        line = [title]
        for mesh, _ in STAGED:
            row = rows.get(f"{mesh}/{stage}")
            line += [seconds(row["min_s"]), number(row["over_bound"], 1),
                     number(row.get("peak_B"))] if row else ["-"] * 3
        lines.append(line)
    header = ["stage"]
    for _, title in STAGED:
        header += [title, "times its bound", "peak, bytes a cell"]
    return table(header, lines)


def judged(row, target):
    """What a pair is worth; a row without a target is there to be read."""
    words = [] if target is None else [verdict(row["ratio"] <= target)]
    if row.get("rival_missing"):
        words.append(f"they lack {row['rival_missing']:.0f} eigenvalues")
    return "; ".join(words) or "-"


def pairs(rows):
    lines = []
    for name, what, target in PAIRS:
        row = rows.get(name)
        if row:
            lines.append([what, seconds(row["min_s"]), seconds(row["median_s"]),
                          seconds(row["rival_min_s"]), seconds(row["rival_median_s"]),
                          number(row["ratio"], 2), f"<= {target}" if target else "-",
                          judged(row, target)])
    return table(["row", "ours, minimum", "median", "theirs, minimum", "median",
                  "ratio (median)", "target", ""], lines)


def threads(rows):
    """Two threads beside one, both on the same mesh in turns."""
    lines = []
    for mesh, mesh_title, target in THREADS:
        for work, title in THREADED:
            row = rows.get(f"threads/{mesh}{work}")
            if row:
                speed_up = 1 / row["ratio"]
                goal = None if work else target
                lines.append([f"{mesh_title}: {title}", seconds(row["rival_min_s"]),
                              seconds(row["rival_median_s"]), seconds(row["min_s"]),
                              seconds(row["median_s"]), number(speed_up, 2),
                              f">= {goal}" if goal else "-",
                              verdict(speed_up >= goal) if goal else "-"])
    return table(["row", "one thread, minimum", "median", "two threads, minimum", "median",
                  "speed-up (median)", "target", ""], lines)


def solids(rows):
    lines = [[name.split("/")[1], number(row["cells"]), seconds(row["min_s"]),
              seconds(row["median_s"]), number(row.get("peak_B"))]
             for name, row in rows.items() if name.startswith("poisson3d/")]
    return table(["engine", "unknowns", "minimum", "median", "peak, bytes an unknown"], lines)


def files(rows):
    lines = []
    for name, what in (("read/obj", "OBJ, 2.0 M triangles"),
                       ("read/ply", "binary PLY, 4.0 M triangles")):
        row = rows.get(name)
        if row:
            lines.append([what, number(row["file_B"] / 1e6), seconds(row["min_s"]),
                          seconds(row["median_s"]), number(row["file_B_per_s"] / 1e6),
                          number(row["over_bound"], 1)])
    return table(["file", "MB", "minimum", "median", "MB/s", "times the bound"], lines)


def whole(rows):
    row = rows.get("whole/4M", {})
    lines = [[key.split("_", 2)[2], seconds(row[key])]
             for key in sorted(row) if key.startswith("stage_")]
    if row:
        lines.append(["all (<= 9 s)", seconds(row["median_s"])])
        if "peak_B" in row:
            lines.append(["peak of memory, bytes a triangle", number(row["peak_B"])])
    return table(["stage", "median"], lines)


def size_series(rows, counter):
    """The counter against the cells, for every mesh and kind of work: title -> [(cells, value)]."""
    titles = {"torus/chain": "triangles: all operators", "torus/merged": "triangles: merged",
              "tets/chain": "tetrahedra: all operators", "tets/merged": "tetrahedra: merged"}
    found = {}
    for key, title in titles.items():
        points = [(row["cells"], row[counter]) for name, row in rows.items()
                  if name.startswith(f"size/{key}/") and counter in row]
        if points:
            found[title] = sorted(points)
    return found


def slope(points):
    """Of the line through the logarithms that is best in the sense of least squares."""
    x = [math.log(cells) for cells, _ in points]
    y = [math.log(value) for _, value in points]
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    spread = sum((a - mean_x) ** 2 for a in x)
    return sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / spread if spread else math.nan


def sizes(rows):
    times, peaks = size_series(rows, "min_s"), size_series(rows, "peak_B")
    lines = []
    for title, points in times.items():
        per_cell = [value / cells * 1e9 for cells, value in points]
        lines.append([title, f"{points[0][0]:,.0f} .. {points[-1][0]:,.0f}",
                      number(slope(points), 2), f"{per_cell[0]:,.0f} .. {per_cell[-1]:,.0f}",
                      " .. ".join(number(peaks[title][i][1]) for i in (0, -1))
                      if title in peaks else "-"])
    return table(["work", "cells", "slope of the time", "ns a cell", "peak, bytes a cell"], lines)
