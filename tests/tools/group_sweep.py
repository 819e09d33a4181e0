# SPDX-License-Identifier: MIT
"""Answers do not depend on what a mesh can be given as: other numbers of vertices and cells, another
unit of length, reflected, other axes, more coordinates. Commands, options and meshes are drawn at
random: POLYDEC_SWEEP=10000 draws more, POLYDEC_SWEEP_SEED=7 others.

What is left out is exactly symmetric, or no number of the mesh (see docs/trust.md).
"""
import collections
import math
import os
import re

import command
from command import TestCase
from draws import Draw
from golden_numbers import Matrix
from motions import Mesh, Motion

DRAWS = int(os.environ.get("POLYDEC_SWEEP", 200))
SEED = int(os.environ.get("POLYDEC_SWEEP_SEED", 0))
SECONDS = 120


def member(answer, path):
    path = ("entries", path) if "entries" in answer else (path,) if isinstance(path, str) else path
    for key in path:
        answer = answer.get(key) if isinstance(answer, dict) else answer[key]
    return answer


def without_numbers(lines):
    """What lines say of no cell or vertex in particular, of no length, and of no time that a run takes."""
    return [re.sub(r"-?\d[\w.^+-]*", "#", line) for line in lines
            if not command.says(line, "lengths", "far from 1", "units") and "; about " not in line]


def numbers_of(value):
    if isinstance(value, dict):
        return [x for key in sorted(value) for x in numbers_of(value[key])]
    if isinstance(value, list):
        return [x for each in value for x in numbers_of(each)]
    return [value]


class GroupSweep(TestCase):
    made = {}

    def generate(self, name):
        if name not in self.made:
            self.succeed("generate", *name.split(), "-o", "made.nsc")
            self.made[name] = Mesh.of_text(self.read("made.nsc")).oriented()
        return self.made[name]

    def answer(self, mesh, asked):
        path = self.write("mesh.nsc", mesh.text())
        outcome = command.run(asked.words[0], path, *asked.words[1:], "--json", folder=self.folder,
                              seconds=SECONDS)
        lines = [line.replace(path, "mesh") for line in outcome.err.splitlines()]
        answer = command.parse(outcome.out) if outcome.code == 0 else None
        if answer and asked.words[0] == "operators":
            answer["entries"] = {key: self.entries(key) for key in asked.powers}
        return outcome.code, lines, answer

    def entries(self, name):
        """Of an operator that is written, but for signs, which depend on orientations, and order."""
        path = self.path(f"operators/{name}.mtx")
        return sorted(map(abs, Matrix(path).values()), reverse=True) if os.path.exists(path) else None

    def differences(self, before, after, powers, scale, rounding):
        """What is not the same in two answers, but for rounding."""
        (code, lines, answer), (other_code, other_lines, other) = before, after
        if code != other_code:
            return [f"code {code} became {other_code}: {lines[-1:]}, {other_lines[-1:]}"]
        said = [without_numbers(each) for each in (lines, other_lines)]
        found = [] if said[0] == said[1] else [f"{lines}\nbecame\n{other_lines}"]
        for key, power in powers.items() if code == 0 else ():
            a, b = (numbers_of(member(each, key)) for each in (answer, other))
            if key == "eigenvalues":
                zeros = [2 * (p + q * scale**2) for p, q in zip(answer["radii"], other["radii"])]
            else:
                zeros = [self.zero(answer, key, x, rounding) for x in a]
            b = [y * scale**-power if isinstance(y, float) else y for y in b]
            if "entries" in answer: # zeros may be there or not
                a, b, zeros = (each + [0.0] * (max(len(a), len(b)) - len(each))
                               for each in (a, b, zeros))
            found += [f"{key}: {x} became {y}" for x, y, zero in zip(a, b, zeros, strict=True)
                      if not (math.isclose(x, y, rel_tol=rounding, abs_tol=zero)
                              if isinstance(x, float) and isinstance(y, float) else x == y)]
        return found

    def zero(self, answer, key, value, rounding):
        """What counts as zero beside the answer and the data, which are of the size 1."""
        if key in ("min", "max"):
            return 1e-13 + rounding * max(abs(answer.get(each, 0)) for each in ("min", "max"))
        if key in ("energy", "enstrophy"):
            return 1e-15
        if "entries" in answer:
            return rounding * max(answer["entries"][key] or [0])
        if key[0] in ("stars", "input_stars") and key[2] in ("min", "max"):
            return rounding * answer[key[0]][key[1]]["max"]
        if key[-1] == "condition":
            return 1e-14 * (value or 0)**2
        return rounding * answer["norms"]["form"] if key[0] == "norms" else 0

    def before_and_after(self, number, moved=None):
        """The answers of a draw, what is compared of them, and what the draw is; in place of the
        motion another function may change the mesh."""
        draw = Draw(number)
        mesh = draw.mesh(self.generate)
        motion, rest = Motion(mesh, draw.random), Motion(mesh)
        question = draw.question(mesh, motion)
        if moved is not None:
            motion, moved = rest, moved(mesh)
        asked = question(motion)
        before, after = (self.answer(each, question(how)) for each, how in (
            (mesh, rest), (moved or motion.mesh(mesh), motion)))
        words = " ".join(map(str, question(rest).words))
        return before, self.differences(before, after, asked.powers, motion.scale, draw.rounding), \
            f"draw {number}: {words}\n{draw.about}; {motion}"

    def test_answers_are_the_same(self):
        ended = collections.Counter()
        for number in range(SEED, SEED + DRAWS):
            before, found, about = self.before_and_after(number)
            ended[before[0]] += 1
            with self.subTest(about):
                self.assertEqual(found, [], about)
        self.assertGreater(ended[0], DRAWS / 2)
        self.assertEqual(ended[1], 0)

    def test_other_meshes_have_other_answers(self):
        def stretched(mesh):
            return Mesh([[1.5 * point[0], *point[1:]] for point in mesh.points], mesh.cells)

        differ = sum(bool(self.before_and_after(number, stretched)[1]) for number in range(20))
        self.assertGreater(differ, 10)
