# SPDX-License-Identifier: MIT
"""Questions to the command, drawn at random, about a mesh that is given in one way or another."""
import collections
import math
import random

from motions import Mesh

GENERATED = [
    "grid --nx 4 --ny 3", "hexagons --columns 3", "well-centered --rows 2",
    "uv-sphere --meridians 8 --bands 4", "icosphere --frequency 2", "goldberg --frequency 2",
    "torus --major 8 --minor 5", "moebius --around 9 --across 2", "flange --segments 8",
    "kuhn --dimension 2 --cells 3", "kuhn --dimension 3 --cells 2", "kuhn --dimension 4 --cells 1",
    "split-boxes --dimension 2 --cells 3 --seed {seed}",
    "split-boxes --dimension 3 --cells 2 --seed {seed}", "bcc --cells 1", "bcc --cells 2",
    "fcc --cells 1", "d4 --cells 1", "clusters --dimension 2 --cells 3 --points 7 --seed {seed}",
    "clusters --dimension 3 --cells 2 --points 7 --seed {seed}"]
JITTERS = [0, 0, 1e-12, 1e-8, 1e-6, 3e-5, 3e-4, 1e-2, .1]
FLATNESS = [1, 1, 1, 1, .1, 1e-2, 1e-3]

#: The members of an answer that are compared, and the power of the length that each is in.
Asked = collections.namedtuple("Asked", "words powers")


class Draw:
    """A question, with its mesh and motion, that depends on a number alone."""

    def __init__(self, number):
        self.random = random.Random(number)
        self.number = number

    def mesh(self, generate):
        draw = self.random
        name = draw.choice(GENERATED).format(seed=draw.randrange(5))
        mesh = generate(name)
        jitter, flatness = draw.choice(JITTERS), draw.choice(FLATNESS)
        flat = draw.randrange(mesh.N)
        points = [[(x + jitter * draw.uniform(-1, 1)) * (flatness if axis == flat else 1)
                   for axis, x in enumerate(point)] for point in mesh.points]
        self.about = f"{name}, jitter {jitter}, axis {flat} times {flatness}"
        self.rounding = 1e-9 / flatness
        self.jitter = jitter
        return Mesh(points, mesh.cells)

    def question(self, mesh, motion):
        """Arguments of the command for a motion of the mesh, as a function of the motion."""
        self.n, self.N = mesh.n, mesh.N
        self.usable = [axis for axis in range(mesh.N) if motion.reaches(axis)]
        kinds = [self.info, self.spectrum, self.poisson, self.hodge, self.heat, self.wave,
                 self.operators]
        if len(motion.axes) <= 3:
            kinds += [self.merge] # which writes what is drawn
        if mesh.n == 2:
            kinds += [self.distance]
        if mesh.n >= 2:
            kinds += [self.flow, self.maxwell]
        ask = self.random.choice(kinds)
        common = self.common(ask)
        if "--no-merge" in common and self.jitter > 0: # duals of this size have its rounding
            self.rounding = max(self.rounding, 1e-15 / self.jitter)
        self.is_symmetric = self.jitter == 0 and any("--delaunay" in word for word in common)
        asked = ask(mesh)
        return lambda g: Asked([*asked(g).words, *common], asked(g).powers)

    def common(self, ask):
        draw = self.random
        words = draw.choice([[], [], [], ["--no-merge"], ["--tolerance", "1e-3"],
                             ["--centers", "centroids"]])
        if self.n == 2 and draw.random() < .2:
            words = ["--delaunay"] if draw.random() < .7 else ["--delaunay=split-boundary"]
        if ask not in (self.merge, self.distance) and draw.random() < .5:
            kinds = ["circumcentric", "galerkin", "barycentric", "automatic"]
            words = [*words, "--star", draw.choice(kinds + ["hybrid"] * (self.n == 2))]
        return words

    def template(self):
        """An expression of the size 1 in coordinates that can be named."""
        a, b = (self.random.choice(self.usable) for _ in range(2))
        return self.random.choice(["1", f"{{{a}}}", f"{{{a}}}+2*{{{b}}}", f"{{{a}}}*{{{b}}}-.3",
                                   f"exp(-{{{a}}}^2-{{{b}}}^2)"])

    def conditions(self, extra=()):
        """Arguments as a function of the motion."""
        kind = self.random.choice(["none", "none", "natural", "essential", "where", *extra])
        where = f"{{{self.random.choice(self.usable)}}}<{self.random.uniform(-.7, .9)!r}"
        alpha = self.random.uniform(.5, 3)
        return lambda g: {"none": [], "natural": ["--natural"],
                          "essential": ["--essential-where", "1"],
                          "where": ["--essential-where", g.expression(where)],
                          "robin": ["--robin", repr(alpha / g.scale)]}[kind]

    def side(self):
        return self.random.choice(["primal", "dual"])

    def form_of(self, degree):
        templates = [self.template() for _ in range(math.comb(self.N, degree))]
        return lambda g: g.form(templates, degree) if degree else g.expression(templates[0])

    def info(self, mesh):
        n = mesh.n
        powers = {("volume",): n, "cells": 0, "betti": 0, "euler": 0, "components": 0,
                  "boundary_components": 0, "orientable": 0, "facets": 0, "pairs": 0,
                  "operators": 0, "laplacians": 0, "vertices_per_cell": 0, "concyclic": 0}
        for stage in ("stars", "input_stars"):
            for k in range(n + 1):
                for key in ("min", "max"):
                    powers[stage, k, key] = n - 2 * k
                for key in ("negative", "zero", "condition", "diagonal"):
                    powers[stage, k, key] = 0
        return lambda g: Asked(["info"], powers)

    def merge(self, _):
        return lambda g: Asked(["merge", "-o", "merged.vtu"], {"cells": 0})

    def operators(self, mesh):
        powers = {f"{name}_{k}": power for k in range(mesh.n + 1) for name, power in (
            ("volume", k), ("dual_volume", mesh.n - k), ("star", mesh.n - 2 * k))}
        return lambda g: Asked(["operators", "--out", "operators"],
                               {**powers, "laplacian_primal_0": -2})

    def spectrum(self, mesh):
        side, degree = self.side(), self.random.randint(0, mesh.n)
        count = self.random.randint(1, 5)
        conditions = self.conditions(["robin"])
        return lambda g: Asked(["spectrum", "--side", side, "--degree", degree, "--count", count,
                                *conditions(g)],
                               {"eigenvalues": -2, ("certificate", "complete"): 0, "star": 0})

    def poisson(self, mesh):
        draw, side, rhs = self.random, self.side(), self.template()
        conditions = self.conditions(["robin"])
        boundary, flux, kappa = (self.template() if draw.random() < .4 else None for _ in range(3))

        def asked(g):
            given = conditions(g)
            words = ["poisson", "--side", side, "--rhs", f"({g.expression(rhs)})/{g.scale**2!r}",
                     *given]
            if boundary and given[:1] not in (["--natural"], ["--robin"]):
                words += ["--boundary", g.expression(boundary)]
            if flux and given and given[-1] != "1": # not everywhere essential
                words += ["--flux", f"({g.expression(flux)})/{g.scale!r}"]
            if kappa:
                words += ["--conductivity", f"1+({g.expression(kappa)})^2"]
            return Asked(words, {"min": 0, "max": 0, "unknowns": 0, "free_components": 0,
                                 "star": 0})

        return asked

    def hodge(self, mesh):
        side, degree = self.side(), self.random.randint(0, mesh.n)
        form, conditions = self.form_of(degree), self.conditions()
        power = mesh.n / 2 - degree
        return lambda g: Asked(["hodge", "--side", side, "--degree", degree, "--form", form(g),
                                *conditions(g)],
                               {("norms", key): power
                                for key in ("form", "exact", "coexact", "harmonic")})

    def times(self, until, steps, power):
        """Equal steps over a time, in units of length to a power; a little longer ones are allowed,
        so that rounding makes none more."""
        return lambda g: ["--until", repr(until * g.scale**power), "--time-step",
                          repr(1.0001 * until * g.scale**power / steps), "--frames", "1"]

    def heat(self, mesh):
        draw, side, degree = self.random, self.side(), self.random.choice([0, 0, 1, mesh.n])
        form = self.form_of(degree)
        conditions = self.conditions(["robin"] * (degree == 0))
        times = self.times(draw.choice([1e-4, 1e-2, 1]), draw.randint(1, 5), 2)
        scheme = draw.choice([[], [], ["--integrator", "implicit-midpoint"]])
        source = self.template() if degree == 0 and not scheme and draw.random() < .2 else None

        def asked(g):
            words = ["heat", "--side", side, "--degree", degree, "--initial", form(g), *times(g),
                     *scheme, *conditions(g)]
            if source:
                words += ["--source", f"({g.expression(source)})/{g.scale**2!r}"]
            powers = {"relative_norm": 0, "steps": 0, "star": 0}
            return Asked(words, {**powers, "min": 0, "max": 0} if degree == 0 else powers)

        return asked

    def wave(self, mesh):
        side, degree = self.side(), self.random.choice([0, 0, 1])
        form, conditions = self.form_of(degree), self.conditions()
        until = self.random.uniform(.001, .05)
        power = mesh.n - 2 * degree
        powers = {"relative_energy": 0, "energy": power, "stable_step": 1, "steps": 0}
        return lambda g: Asked(["wave", "--side", side, "--degree", degree, "--initial", form(g),
                                "--until", repr(until * g.scale), "--frames", 1, *conditions(g)],
                               {**powers, "min": 0, "max": 0} if degree == 0 else powers)

    def maxwell(self, mesh):
        draw, side, degree = self.random, self.side(), self.random.choice([0, 1, 1])
        initial, current = self.form_of(degree), self.form_of(degree)
        conditions = self.conditions()
        materials = {name: self.template() if draw.random() < .4 else None
                     for name in ("permittivity", "permeability", "conductivity")}
        until, layer = draw.uniform(.001, .05), draw.uniform(.1, .4)
        has_current, has_layer = draw.random() < .3, draw.random() < .2

        def asked(g):
            words = ["maxwell", "--side", side, "--degree", degree, "--initial", initial(g),
                     "--until", repr(until * g.scale), "--frames", 1, *conditions(g)]
            if has_current:
                scaled = ";".join(f"({each})/{g.scale!r}" for each in current(g).split(";"))
                words += ["--current", scaled, "--pulse", f"1+t/{g.scale!r}"]
            if has_layer:
                words += ["--absorb", repr(layer * g.scale)]
            for name, template in materials.items():
                if template:
                    value = f"1+({g.expression(template)})^2"
                    words += [f"--{name}", f"({value})/{g.scale!r}" if name == "conductivity"
                              else value]
            powers = {"relative_energy": 0, "energy": mesh.n - 2 * degree, "stable_step": 1,
                      "steps": 0}
            return Asked(words, powers)

        return asked

    def distance(self, mesh):
        draw = self.random
        used = sorted({v for cell in mesh.cells for v in cell})
        sources = draw.sample(used, draw.randint(1, 2))
        method = draw.choice([[], ["--method", "heat"], ["--method", "heat", "--time-scale", "2"]])
        return lambda g: Asked(
            ["distance", "--from", *(g.vertices[v] for v in sources),
             *method], {"max": 1, "mean": 1})

    def flow(self, mesh):
        draw = self.random
        viscosity = draw.choice([0, 0, .1])
        # velocities are carried from flip to flip, in an order that symmetry leaves open
        by_vorticity = mesh.n == 2 and (draw.random() < .5 or self.is_symmetric)
        vorticity, velocity = self.template(), [self.template() for _ in range(mesh.N)]
        scheme = draw.choice([[], ["--scheme", "imex"]])
        times = self.times(1e-3, draw.randint(1, 3), 0)
        walls = draw.random() < .3

        def asked(g):
            words = ["flow", "--viscosity", repr(viscosity * g.scale**2), *times(g), *scheme]
            if by_vorticity:
                words += ["--vorticity", g.expression(vorticity)]
            else:
                words += ["--velocity", ";".join(
                    "0" if axis is None else
                    f"{sign * g.scale!r}*({g.expression(velocity[axis])})"
                    for axis, sign in zip(g.axes, g.signs))]
            if walls:
                words += ["--no-slip-where", "1"]
            return Asked(words, {"energy": mesh.n + 2, "enstrophy": mesh.n, "steps": 0})

        return asked
