# SPDX-License-Identifier: MIT
"""What takes more memory than allowed is refused, before it is begun or as soon as it is seen."""
import os
import shutil
import subprocess
import time

import command
import ladder
from command import TestCase, golden


class Cost(TestCase):
    def simplex(self, n):
        """One n-simplex, in a file of a few hundred bytes."""
        rows = [" ".join("0" * n), *(" ".join("1" if i == j else "0" for j in range(n))
                                     for i in range(n))]
        return self.write(f"simplex{n}.nsc", "\n".join(
            [f"{n} {n} {n + 1} 1", *rows, " ".join(map(str, range(n + 1)))]) + "\n")

    def refuse(self, *arguments):
        started = time.monotonic()
        message = self.fail_with(4, *arguments, limit=True)
        self.assertLess(time.monotonic() - started, 5)
        return message

    def test_a_simplex_of_high_dimension_is_refused_at_once(self):
        self.assertSays(
            self.refuse("info", self.simplex(20), "--max-memory", "500M"),
            f"polydec: {self.path('simplex20.nsc')}: ", "1 simplex", "dimension 20",
            "2.1e+06 cells", "795 MB", "500 MB", "--max-memory")
        for arguments in (("merge", "-o", "a.vtu"), ("operators", "--out", "out"),
                          ("spectrum", "--side", "primal", "--degree", "0"),
                          ("poisson", "--side", "primal", "--rhs", "1")):
            self.assertSays(self.refuse(arguments[0], self.simplex(20), *arguments[1:],
                                        "--max-memory", "0.5G"), "simplex20.nsc", "795 MB",
                            "500 MB")

    def test_few_machines_have_memory_for_a_simplex_of_dimension_28(self):
        self.assertSays(self.refuse("info", self.simplex(28), "--max-memory", "64G"), "1 simplex",
                        "dimension 28", "5.4e+08 cells", "64 GB")

    def test_what_fits_is_done(self):
        for n in (5, 12):
            cells = self.ask("info", self.simplex(n), "--max-memory", "100M",
                             "--no-merge")["cells"]["input"]
            self.assertEqual(sum(cells), 2**(n + 1) - 1)
        self.ask("info", golden("kuhn4.nsc"), "--max-memory", "10M")

    def test_generators_are_bounded(self):
        for arguments in (("kuhn", "--dimension", "12", "--cells", "1"),
                          ("grid", "--nx", "20000", "--ny", "20000"),
                          ("icosphere", "--frequency", "5000"), ("fcc", "--cells", "200"),
                          ("clusters", "--dimension", "6", "--cells", "6")):
            message = self.refuse("generate", *arguments, "-o", "a.nsc", "--max-memory", "1G")
            self.assertSays(message, "memory", "1 GB")
        self.assertSays(self.fail_with(2, "generate", "kuhn", "--dimension", "25", "-o", "a.nsc"),
                        "--dimension 25", "1 .. 12")

    def test_reading_is_bounded(self):
        self.write("long.off", "OFF\n3 1 0\n" + "#" * 20000000)
        self.assertSays(self.refuse("info", "long.off", "--max-memory", "10M"), "long.off", "40 MB",
                        "10 MB", "--max-memory")

    def test_a_spectrum_with_a_giant_count_is_refused(self):
        self.succeed("generate", "grid", "--nx", "200", "--ny", "200", "-o", "grid.nsc")
        self.assertSays(
            self.refuse("spectrum", "grid.nsc", "--side", "primal", "--degree", "0", "--count",
                        "40000", "--max-memory", "400M"),
            "40000 eigenpairs", "40401 values", "38.8 GB", "400 MB", "--max-memory")

    def test_stars_and_laplacians_of_giant_cells_are_refused(self):
        """A polygon of many corners, a fan and tetrahedra around one edge: where cells have many
        faces, or are around one, matrices are full."""
        self.write("polygon.off", ladder.polygon(3000))
        said = self.refuse("poisson", "polygon.off", "--side", "dual", "--rhs", 1, "--star",
                           "galerkin", "--max-memory", "100M")
        self.assertSays(said, "polygon.off", "2998 simplices", "2-cell", "288 MB", "100 MB")
        self.write("fan.off", ladder.fan(4000))
        said = self.refuse("operators", "fan.off", "--out", "out", "--max-memory", "50M")
        self.assertSays(said, "Laplacians of 1-cells", "50 MB")
        self.assertNotIn("out", os.listdir(self.folder))
        self.write("edge.nsc", ladder.around_edge(5000, digits=9))
        for line in (("poisson", "edge.nsc", "--side", "dual", "--rhs", 1),
                     ("hodge", "edge.nsc", "--side", "primal", "--form", "x;y;z")):
            said = self.refuse(*line, "--max-memory", "1G")
            self.assertSays(said, "edge.nsc", "Galerkin", "1 GB")

    def test_a_limit_of_the_process_counts(self):
        if not command.limited:
            self.skipTest("sanitizers reserve more addresses than any limit allows")
        self.assertSays(self.fail_with(4, "info", self.simplex(22), limit=True), "simplex22.nsc",
                        "1 simplex", "memory", "MB")

    def test_lifts_to_giant_cells_are_refused_before_they_take_minutes(self):
        for corners in (5000, 20000):
            self.write("polygon.off", ladder.polygon(corners))
            for side in ("primal", "dual"):
                started = time.monotonic()
                said = self.fail_with(2, "poisson", "polygon.off", "--side", side, "--rhs", 1,
                                      "--star", "galerkin", "--max-memory", "200G")
                self.assertLess(time.monotonic() - started, command.patience(20))
                self.assertSays(said, "polygon.off", "2-cell 0", f"{corners - 2} simplices", "2000",
                                "--star circumcentric")
                self.succeed("poisson", "polygon.off", "--side", side, "--rhs", 1)

    # what commands need beside a mesh; none of these have a mesh of their own
    ARGUMENTS = {
        "info": (), "operators": ("--out", "out"), "merge": ("-o", "a.vtu"),
        "view": ("-o", "a.html"), "draw": ("-o", "a.svg"),
        "spectrum": ("--side", "primal", "--degree", "0"),
        "poisson": ("--side", "primal", "--rhs", "1"),
        "hodge": ("--side", "primal", "--degree", "1", "--form", "x;y"),
        "heat": ("--side", "primal", "--initial", "x", "--until", "1e-3"),
        "wave": ("--side", "primal", "--degree", "0", "--initial", "x", "--until", "1e-3"),
        "maxwell": ("--initial", "y;x", "--until", "1e-3"),
        "flow": ("--vorticity", "x", "--until", "1e-3"),
        "distance": ("--from", "0")}
    WATCHED = {"spectrum", "operators", "draw", "distance", "merge"}
    WITHOUT_MESH = {"generate", "reproduce", "backends"}

    def test_every_command_that_takes_a_mesh_is_bounded(self):
        listed = self.succeed("--help").out.split("Commands:\n")[1].splitlines()
        names = {line.split()[0] for line in listed if line.startswith("  ") and line[2] != " "}
        self.assertEqual(names, set(self.ARGUMENTS) | self.WITHOUT_MESH)
        self.succeed("generate", "grid", "--nx", 200, "--ny", 200, "-o", "grid.nsc")
        for name, arguments in self.ARGUMENTS.items():
            # the last is passed by what is made of the mesh, if at all
            for most in (1, 20, 50) if name in self.WATCHED else (1, 20):
                with self.subTest(name, most=most):
                    with command.start(name, "grid.nsc", *arguments, "--max-memory", f"{most}M",
                                       cwd=self.folder, stdout=subprocess.DEVNULL,
                                       stderr=subprocess.PIPE, text=True) as process:
                        said = process.stderr.read()
                        _, status, used = os.wait4(process.pid, 0)
                        process.returncode = os.waitstatus_to_exitcode(status)
                    if most < 50 or process.returncode != 0:
                        self.assertEqual(process.returncode, 4, said)
                        self.assertSays(said, f"{most} MB", "--max-memory")
                        self.assertEqual(os.listdir(self.folder), ["grid.nsc"])
                    if command.limited:  # 20 MB are those of the program and the text of the mesh
                        late = 50 if most == 50 else 0  # until it is seen on a busy machine
                        self.assertLess(used.ru_maxrss * 1024, (20 + most + late) * 10**6)
            for name in set(os.listdir(self.folder)) - {"grid.nsc"}:
                (shutil.rmtree if name == "out" else os.remove)(os.path.join(self.folder, name))
