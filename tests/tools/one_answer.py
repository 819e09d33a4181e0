# SPDX-License-Identifier: MIT
"""One question has one answer: the command and the package for Python give the same numbers with
the same warnings, or refuse for the same reason. POLYDEC_MOST_CELLS=8000 takes larger meshes."""
import collections
import os
import warnings

import numpy as np
import polydec

import command
from bad_meshes import FILES
from command import TestCase
from hostile import OBTUSE
from mesh_laws import differences

MOST_CELLS = int(os.environ.get("POLYDEC_MOST_CELLS", 1100))
SECONDS = 300

# options in the words of Python, and in those of the command
WORDING = {'delaunay="flips_and_splits"': "--delaunay=split-boundary",
           "give boundary_flux, or open facets (open)": "give --boundary-velocity, or open facets "
                                                        "(--open-where)",
           'delaunay="flips"': "--delaunay", 'star="automatic"': "--star automatic",
           'side="primal"': "--side primal", "polydec.meshes.peeled(mesh)": "--peel",
           "polydec.meshes.weld(mesh)": "--weld",
           "polydec.meshes.join_hanging(mesh)": "--join-hanging",
           "polydec.set_memory_limit": "--max-memory"}
IN_UNITS_OF_THE_FILE = ("spectrum", "poisson", "distance", "heat")
# errors of Python, and how the command ends
CODES = {"InvalidInput": 2, "SolverFailure": 3, "BackendUnavailable": 4, "IoError": 4}

#: How it ended, numbers, the size beside which they count, warnings, and the reason of a refusal.
Answer = collections.namedtuple("Answer", "code numbers size warnings refusal")
#: Arguments of the command, the members of its object that are compared, and a function of a mesh
#: or of the path of its file that gives the same and a size.
Question = collections.namedtuple("Question", "words members python")


def spoken(value):
    """Texts of Python in the words of the command, wherever they are."""
    if isinstance(value, dict):
        return {key: spoken(each) for key, each in value.items()}
    if isinstance(value, list):
        return [spoken(each) for each in value]
    if isinstance(value, str):
        for ours, theirs in WORDING.items():
            value = value.replace(ours, theirs)
    return value


def linear(points):
    """x + 2 y, if there are as many coordinates."""
    return points[:, 0] + 2 * points[:, min(1, points.shape[1] - 1)]


def swirl(points):
    """The coefficients of the 1-form y dx + x dy."""
    form = np.zeros_like(points)
    form[:, :2] = points[:, 1::-1] if points.shape[1] > 1 else points
    return form


def texts(N):
    """Both as the command takes them, in N coordinates."""
    return ("x+2*y", ";".join(["y", "x"] + (N - 2) * ["0"])) if N > 1 else ("x+2*x", "x")


def extremes(values):
    """They are nan at vertices that no cell uses."""
    return {"min": np.nanmin(values), "max": np.nanmax(values)}


def in_time(until, step=None):
    """Few steps; a little longer ones are allowed, so that rounding makes none more."""
    steps = [] if step is None else ["--time-step", repr(step * 1.0001)]
    return ["--until", repr(until), "--frames", 1, *steps]


def _numbers(report):
    """Without the warnings, which are compared for all answers."""
    return {name: value for name, value in report.items() if name != "warnings"}


def report(_):
    return Question(["info", "--star", "automatic"], None, lambda mesh: (_numbers(mesh.report()), 0))


def spectrum(_, side, degree, *words, **options):
    def python(mesh):
        found = polydec.spectrum(mesh, side=side, degree=degree, count=4, **options)
        return {"eigenvalues": found.eigenvalues.tolist(), "radii": found.radii.tolist()}, 0

    return Question(["spectrum", "--side", side, "--degree", degree, "--count", 4, *words],
                    ["eigenvalues", "radii"], python)


def poisson(_, side, *words, **options):
    def python(mesh):
        u = polydec.poisson(mesh, 1.0, side=side, **options)
        found = extremes(u.values)
        return found, max(map(abs, found.values()))

    return Question(["poisson", "--side", side, "--rhs", 1, *words], ["min", "max"], python)


def distance(mesh):
    source = int(mesh._given.simplices.min())

    def python(mesh):
        found = polydec.geodesic_distance(mesh, source)
        return {"max": np.nanmax(found), "mean": np.nanmean(found)}, np.nanmax(found)

    return Question(["distance", "--from", source], ["max", "mean"], python)


def heat(mesh, side):
    step = 1e-4 * extent(mesh)**2

    def python(given):
        start = linear(mesh.points if side == "primal" else mesh.dual_sites())
        u = polydec.heat(given, start, step, 4, side=side)
        return {**extremes(u), "star": mesh.star_kind}, np.abs(start).max()

    return Question(["heat", "--side", side, "--initial", texts(mesh.points.shape[1])[0],
                     *in_time(4 * step, step)], ["min", "max", "star"], python)


def hodge(mesh, side):
    def python(mesh):
        form = polydec.de_rham(mesh, 1, swirl, side=side)
        space = polydec.FormSpace(mesh, 1, side=side, essential=side == "dual")
        form, space = space.restrict(form), space.inside
        parts = polydec.hodge_decomposition(space, form, degree=1, side=side)
        norms = {name: space.norm(getattr(parts, name))
                 for name in ("exact", "coexact", "harmonic")}
        norms["form"] = space.norm(form, 1, side)
        return {"norms": norms}, norms["form"]

    return Question(["hodge", "--side", side, "--form", texts(mesh.points.shape[1])[1]], ["norms"],
                    python)


def wave(mesh, *words, degree, essential):
    """Of forms at rest at time 0."""
    until = 0.01 * extent(mesh)

    def python(mesh):
        start = polydec.de_rham(mesh, 1, swirl) if degree else linear(mesh.points[mesh.vertices])
        longest = 0.9 * polydec.stable_step(mesh, degree, essential=essential)
        steps = max(1, int(np.ceil(until / longest)))
        run = polydec.Waves(mesh, start, degree=degree, time_step=until / steps,
                            essential=essential)
        run.march(until)
        try:
            energy = run.energy
        except polydec.InvalidInput:  # out of range
            return {**extremes(run.forms[0]), "energy": None}, np.abs(start).max()
        return {**extremes(run.forms[0]), "energy": energy}, max(np.abs(start).max(), energy)

    return Question([*words, "--initial", texts(mesh.points.shape[1])[degree], *in_time(until)],
                    ["min", "max", "energy"], python)


def flow(_):
    step = 1e-3

    def python(mesh):
        equations = polydec.IncompressibleFlow(mesh)
        w = equations.project(polydec.flow_of_vorticity(mesh, linear(mesh.points)))
        run = polydec.Flow(equations, w, step)
        run.march(2 * step)
        w = run.forms[0]
        z = equations.vorticity(w)
        return {"energy": equations.energy(w), "min_vorticity": z.min(),
                "max_vorticity": z.max()}, np.abs(z).max()

    return Question(["flow", "--vorticity", "x+2*y", *in_time(2 * step, step)],
                    ["energy", "min_vorticity", "max_vorticity"], python)


def questions(mesh):
    """Of a mesh far from size 1 Python has other numbers in the unit that it says."""
    yield from (each for each in all_questions(mesh)
                if mesh.unit == 1 or each.words[0] in ("info", "wave", *IN_UNITS_OF_THE_FILE))


def all_questions(mesh):
    yield report(mesh)
    for side in ("primal", "dual"):
        for degree in (0, 1):
            yield spectrum(mesh, side, degree)
        alpha = 2 / extent(mesh)
        yield spectrum(mesh, side, 0, "--robin", repr(alpha), robin=alpha)
        yield poisson(mesh, side)
        yield poisson(mesh, side, "--boundary", texts(mesh.points.shape[1])[0], boundary=linear)
        yield poisson(mesh, side, "--natural", essential=False)
        if 1e-290 < extent(mesh)**2 < 1e290: # of which times are numbers
            yield heat(mesh, side)
        yield hodge(mesh, side)
    yield wave(mesh, "wave", degree=0, essential=False)
    if mesh.dim == 2:
        yield distance(mesh)
        yield flow(mesh)
    if mesh.dim == 3:
        yield wave(mesh, "maxwell", degree=1, essential=True)


def extent(mesh):
    used = mesh._given.points[mesh._given.simplices.ravel()]
    return float(np.ptp(used, axis=0).max())


def of_the_command(question, path):
    outcome = command.run(question.words[0], path, *question.words[1:], "--json", seconds=SECONDS)
    lines = [line.removeprefix("polydec: ") for line in outcome.err.splitlines()]
    warned = [line.removeprefix("warning: ") for line in lines if line.startswith("warning: ")]
    if outcome.code != 0:
        return Answer(outcome.code, {}, 0, warned, "\n".join(lines[len(warned):]))
    answer = command.parse(outcome.out)
    assert warned == answer.pop("warnings"), outcome.err
    if "star" in (question.members or []):
        answer["star"] = answer["star"]["kind"]
    return Answer(0, {key: answer[key] for key in question.members or answer}, 0, warned, "")


def of_python(ask):
    """What it returns or raises, and what it warns of meanwhile."""
    code, numbers, size, refusal = 0, {}, 0, ""
    with warnings.catch_warnings(record=True) as found:
        warnings.simplefilter("always")
        try:
            numbers, size = ask()
        except polydec.Error as error:
            code, refusal = CODES[type(error).__name__], spoken(str(error))
    for each in found:
        assert each.category is polydec.PolydecWarning, each
    return Answer(code, numbers, size, [spoken(str(each.message)) for each in found], refusal)


class OneAnswer(TestCase):
    answers = ()

    def check(self, path):
        given = of_python(lambda: (polydec.discretize(path), 0))
        mesh, refused = given.numbers, given.code != 0
        for question in [Question(["info"], None, None)] if refused else questions(mesh):
            asked = " ".join(map(str, [question.words[0], os.path.basename(path),
                                       *question.words[1:]]))
            with self.subTest(asked):
                expected = of_the_command(question, path)
                found = given if refused else of_python(lambda: question.python(mesh))
                if not refused:
                    of_mesh = [each for each in given.warnings
                               if question.words[0] != "distance" or "hybrid" not in each]
                    found = found._replace(warnings=of_mesh + found.warnings)
                self.compare(found, expected, path)
                self.answers.append(expected)
                if not refused and question.words[0] in IN_UNITS_OF_THE_FILE:
                    # where nobody has to know of another unit
                    warned = [text for text in expected.warnings
                              if not command.says(text, "lengths", "far from 1", "units")]
                    self.compare(of_python(lambda: question.python(path)),
                                 expected._replace(warnings=warned), path)

    def compare(self, found, expected, path):
        refusals = [answer.refusal.removeprefix(f"{path}: ") for answer in (found, expected)]
        self.assertEqual((found.code, refusals[0]), (expected.code, refusals[1]))
        self.assertEqual(found.warnings, expected.warnings)
        if found.code != 0:
            return
        found_numbers, numbers = spoken(dict(found.numbers)), dict(expected.numbers)
        self.assertEqual(list(found_numbers), list(numbers)) # in the same order
        if "radii" in numbers:
            for a, b, *radii in zip(*(each.pop(key) for key in ("eigenvalues", "radii")
                                      for each in (found_numbers, numbers)), strict=True):
                self.assertLessEqual(abs(a - b), sum(radii) + 1e-9 * abs(b))
        self.assertEqual(differences(numbers, found_numbers, zero=1e-9 * found.size), [])

    def setUp(self):
        super().setUp()
        self.answers = []

    def check_that_some_warn_and_some_refuse(self):
        self.assertTrue(any(answer.warnings for answer in self.answers))
        self.assertTrue({0, 2} <= {answer.code for answer in self.answers})

    def test_of_found_meshes(self):
        for path in command.data_files("bad", "cad", "planar", "poly", "surface", "tet"):
            read = of_python(lambda: (polydec.as_mesh(path), 0)) if path[-5:] != ".node" else None
            if read and (read.code != 0 or len(read.numbers.simplices) <= MOST_CELLS):
                self.check(path)
        if self.answers:
            self.check_that_some_warn_and_some_refuse()

    def test_of_golden_meshes(self):
        for name in sorted(os.listdir(command.GOLDEN)):
            if name.endswith((".off", ".nsc")):
                self.check(command.golden(name))
        self.check_that_some_warn_and_some_refuse()

    def test_of_bad_meshes(self):
        for name, text in {**FILES, "obtuse.off": OBTUSE}.items():
            self.check(self.write(name, text))
        self.check_that_some_warn_and_some_refuse()

    def test_of_errors_with_and_without_l2(self):
        """The library knows up to which size the error in L2 is proved."""
        for cells, left_out in ((8, False), (159, True)):
            path = self.generate("grid", "--nx", cells, "--ny", cells)
            answer = self.ask("poisson", path, "--side", "primal", "--rhs", 1)
            mesh = polydec.discretize(path)
            u = polydec.poisson(mesh, 1.0).values
            found = of_python(lambda: (polydec.poisson_error(mesh, u, 1.0), 0))
            bound = answer["error_bound"]
            for name in ("energy", "averaged_gradient", "size", "oscillation", "l2"):
                self.assertEqual(differences(bound[name], getattr(found.numbers, name), zero=1e-12), [])
            self.assertEqual(bound["l2"] is None, left_out)
            self.assertEqual(found.warnings, [answer["without_error_bound"]] if left_out else [])

    def test_other_questions_have_other_answers(self):
        path = command.golden("folded_rect.off")
        mesh = polydec.discretize(path)
        answers = [of_the_command(question(mesh), path) for question in (
            lambda mesh: poisson(mesh, "primal"), lambda mesh: poisson(mesh, "dual"),
            lambda mesh: spectrum(mesh, "primal", 3))]
        for found in answers:
            for expected in answers:
                if found is not expected:
                    with self.assertRaises(AssertionError):
                        self.compare(found, expected, path)
