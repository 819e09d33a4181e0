# SPDX-License-Identifier: MIT
"""What would take more memory than allowed is refused before it is begun."""
import time

import command
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
        self.assertEqual(
            self.refuse("info", self.simplex(20), "--max-memory", "500M"),
            f"polydec: {self.path('simplex20.nsc')}: a complex of 1 simplex of dimension 20, of about "
            "2.1e+06 cells of all degrees, takes about 795 MB of memory, but only 500 MB may be used: "
            "take fewer or simpler cells, or allow more (--max-memory)")
        for arguments in (("merge", "-o", "a.vtu"), ("operators", "--out", "out"),
                          ("spectrum", "--side", "primal", "--degree", "0"),
                          ("poisson", "--side", "primal", "--rhs", "1")):
            self.assertIn("takes about 795 MB",
                          self.refuse(arguments[0], self.simplex(20), *arguments[1:],
                                      "--max-memory", "0.5G"))

    def test_few_machines_have_memory_for_a_simplex_of_dimension_28(self):
        self.assertIn("a complex of 1 simplex of dimension 28, of about 5.4e+08 cells",
                      self.refuse("info", self.simplex(28), "--max-memory", "64G"))

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
            self.assertIn("of memory, but only 1 GB may be used", message)
        self.assertEqual(self.fail_with(2, "generate", "kuhn", "--dimension", "25", "-o", "a.nsc"),
                         "polydec: --dimension 25 is outside 1 .. 12")

    def test_reading_is_bounded(self):
        self.write("long.off", "OFF\n3 1 0\n" + "#" * 2000000)
        self.assertEqual(self.refuse("info", "long.off", "--max-memory", "1M"),
                         "polydec: reading long.off takes about 4 MB of memory, but only 1 MB may "
                         "be used: take fewer or simpler cells, or allow more (--max-memory)")

    def test_a_spectrum_with_a_giant_count_is_refused(self):
        self.succeed("generate", "grid", "--nx", "200", "--ny", "200", "-o", "grid.nsc")
        self.assertEqual(
            self.refuse("spectrum", "grid.nsc", "--side", "primal", "--degree", "0", "--count",
                        "40000", "--max-memory", "400M"),
            "polydec: a spectrum of 40000 eigenpairs of 40401 values takes about 38.8 GB of memory, "
            "but only 400 MB may be used: take fewer or simpler cells, or allow more (--max-memory)")

    def test_a_limit_of_the_process_counts(self):
        if not command.limited:
            self.skipTest("sanitizers reserve more addresses than any limit allows")
        self.assertIn("may be used", self.fail_with(4, "info", self.simplex(22), limit=True))


if __name__ == "__main__":
    command.main()
