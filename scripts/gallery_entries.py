# SPDX-License-Identifier: MIT
"""What the gallery shows, and by which command or example each page is made."""
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Entry:
    name: str     # of the picture
    title: str
    words: str    # what there is to see
    lines: tuple  # commands, and examples by their names; the last one makes the page
    page: str
    choices: dict = field(default_factory=dict)  # controls of the page, before the picture is taken
    keys: tuple = ()                             # pressed in the picture then


LEFT, DOWN = "ArrowLeft", "ArrowDown"

ENTRIES = (
    Entry("merged_flange", "A machine part, merged",
          "Every face of a flange is a split quad or a ring of triangles on one circle. Black lines "
          "are edges of the merged polygons; red ones had dual length 0 and were merged away.",
          ("polydec generate flange --segments 48 -o flange.off",
           "polydec view flange.off -o flange.html"), "flange.html", keys=(DOWN,) * 2),
    Entry("flange_mode", "A certified mode of the flange",
          "An eigenfunction of the Laplacian on its vertices. The table beside the page gives each "
          "eigenvalue with a radius, and a proof that none is missing.",
          ("polydec generate flange --segments 48 -o flange.off",
           "polydec spectrum flange.off --side primal --degree 0 --count 12 -o flange-modes.html"),
          "flange-modes.html", {"field": "4", "edges": False, "levels": True}, (DOWN,) * 2),
    Entry("harmonics_on_quads", "Spherical harmonics on quads",
          "The UV sphere has one circumcircle for the two triangles of each quad. On the merged "
          "quads the 5 eigenvalues near 6 = 2 (2 + 1) belong to harmonics of degree 2.",
          ("polydec generate uv-sphere --meridians 48 --bands 24 -o uv-sphere.off",
           "polydec spectrum uv-sphere.off --side primal --degree 0 --count 16 -o uv-sphere.html"),
          "uv-sphere.html", {"field": "6"}),
    Entry("harmonics_on_hexagons", "Spherical harmonics on hexagons, one value a face",
          "Dual 0-forms have a value for each hexagon and each of the 12 pentagons of a Goldberg "
          "sphere: here a harmonic of degree 3.",
          ("polydec generate goldberg --frequency 8 -o goldberg.off",
           "polydec spectrum goldberg.off --side dual --degree 0 --count 16 -o goldberg.html"),
          "goldberg.html", {"field": "10"}),
    Entry("harmonic_field", "A harmonic field on a torus",
          "The torus has two loops, and two harmonic 1-forms: eigenvalue 0 twice. Colors show the "
          "length of the field, and lines run along it.",
          ("polydec generate torus --major 32 --minor 16 -o torus.off",
           "polydec spectrum torus.off --side primal --degree 1 --count 6 -o torus.html"),
          "torus.html", {"field": "0", "edges": False}, (DOWN,) * 4),
    Entry("hodge_parts", "The exact part of a wind",
          "A wind on a torus is a gradient, plus a curl, plus a harmonic field; the page shows all "
          "three. This is the gradient.",
          ("07_hodge_decomposition",), "hodge_decomposition.html", {"field": "1"}, (DOWN,) * 4),
    Entry("octahedra", "Octahedra and tetrahedra, cut open",
          "The face-centered cubic lattice: the tetrahedra of each octahedron have one "
          "circumsphere and are merged. A cut removes whole cells.",
          ("polydec generate fcc --cells 4 -o fcc.mesh", "polydec view fcc.mesh -o fcc.html"),
          "fcc.html", {"field": "0", "axis": "0", "cut": "55"}, (LEFT,) * 7),
    Entry("cubes", "Poisson's equation, a value for each cube",
          "Six tetrahedra with one circumsphere merge into a cube, centered at the center of the "
          "sphere. The solution of a dual Poisson problem, cut open.",
          ("polydec generate kuhn --cells 10 -o cubes.nsc",
           "polydec poisson cubes.nsc --side dual --rhs 'cos(2*pi*x)*cos(2*pi*y)*cos(pi*z)' "
           "-o cubes.html"), "cubes.html", {"axis": "0", "cut": "50"}, (LEFT,) * 7),
    Entry("clusters", "Many points on one sphere",
          "Random points around a sphere with many points on it: the Delaunay tetrahedra inside "
          "merge into one cell.",
          ("polydec generate clusters -o clusters.nsc",
           "polydec view clusters.nsc -o clusters.html"),
          "clusters.html", {"field": "0", "axis": "0", "cut": "56"}, (LEFT,) * 7),
    Entry("hexagons", "Poisson's equation on hexagons",
          "Values are 0 on the boundary; level lines are drawn by the page.",
          ("polydec generate hexagons --columns 16 -o hexagons.off",
           "polydec poisson hexagons.off --side primal --rhs 1 -o hexagons.html"),
          "hexagons.html", {"levels": True}),
    Entry("moebius", "A mode of the Moebius strip",
          "The strip has no orientation. Primal forms and their Laplacian need none.",
          ("polydec generate moebius --around 48 --across 8 -o moebius.off",
           "polydec spectrum moebius.off --side primal --degree 0 --count 8 -o moebius.html"),
          "moebius.html", {"field": "3"}, (DOWN,) * 3),
    Entry("dual_mesh", "A mesh and its dual",
          "Every triangle is acute, so that each circumcenter lies inside; dual edges, blue, cross "
          "the edges at right angles.",
          ("polydec generate well-centered --rows 4 -o well-centered.off",
           "polydec view well-centered.off -o well-centered.html"),
          "well-centered.html", {"dual": True}),
    Entry("distance", "Distance on a bad mesh",
          "Triangles wind around a drill as helices, and most edges have a negative dual. After "
          "intrinsic flips the heat method measures the distance at the same vertices to 2 %.",
          ("15_distance_on_a_bad_mesh",), "distance.html",
          {"field": "1", "edges": False, "levels": True}),
    Entry("darcy", "Water around a block of clay",
          "A pressure in each octahedron and tetrahedron; arrows are the velocities. Inflow equals "
          "outflow in each cell, to rounding.",
          ("11_darcy_flow",), "darcy_flow.html", {"axis": "2", "cut": "35", "edges": False},
          (DOWN,) * 5),
    Entry("cavity", "A standing wave in a box",
          "An electric wave in a box of cubes with conducting walls, cut open: the vertical field, "
          "a combination of the six modes of one eigenvalue.",
          ("12_maxwell_cavity",), "maxwell_cavity.html", {"axis": "2", "cut": "50"}, (LEFT,) * 2),
    Entry("hot_spot", "A hot spot, blown around a sphere",
          "A user-defined PDE: transport by a wind with upwind sampling, and heat, on quads.",
          ("10_your_own_pde",), "temperature.html", {"step": "8", "levels": True}, (LEFT,) * 6),
    Entry("wave", "A wave on a torus",
          "From rest, a bump runs around the tube both ways, meets itself and continues. Energy is "
          "conserved to rounding; the page plays the steps.",
          ("polydec generate torus --major 96 --minor 48 -o fine-torus.off",
           "polydec wave fine-torus.off --initial 'exp(-30*((x-1.5)^2+y^2+z^2))' --until 3 "
           "--frames 60 -o wave.html"), "wave.html", 
          {"step": "18", "edges": False, "from": "-0.1", "to": "0.1"},
          (DOWN,) * 4),
    Entry("flow", "Vortices on a sphere",
          "Two vortices of one sense turn around each other on a sphere of hexagons, stretch each "
          "other and merge; the energy loss is due to friction.",
          ("polydec generate goldberg --frequency 16 -o ball.off",
           "polydec flow ball.off --vorticity 'exp(-25*(x-.95)^2-25*(y-.3)^2-25*z^2)"
           "+exp(-25*(x-.95)^2-25*(y+.3)^2-25*z^2)' --viscosity .0003 --until 24 --frames 12 "
           "--scheme imex -o flow.html"), "flow.html", {"step": "8", "edges": False}, (LEFT,) * 7),
    Entry("pulse", "A pulse of light among octahedra",
          "The vertical electric field, by leapfrog on octahedra and tetrahedra, a value for each "
          "cell; the page plays the steps. A cut removes the front half.",
          ("13_electromagnetic_pulse",), "pulse_on_octahedra.html",
          {"axis": "0", "cut": "50", "step": "14", "from": "-0.2", "to": "0.2"}, (LEFT,) * 7),
)
