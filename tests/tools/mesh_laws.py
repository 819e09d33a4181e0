# SPDX-License-Identifier: MIT
"""What the numbers of every mesh obey, and meshes as text in every format for tetrahedra."""
import math


# Laws: each returns what is wrong

def topology_flaws(info):
    """Merging changes neither Betti numbers nor Euler's, which is the alternating sum of both."""
    found = [key for key in ("betti", "euler") if info[key]["input"] != info[key]["merged"]]
    for stage in ("input", "merged"):
        for numbers in (info["betti"][stage], info["cells"][stage]):
            if sum((-1)**k * x for k, x in enumerate(numbers)) != info["euler"][stage]:
                found.append(f"alternating sum of {stage}")
    return found


def kernel_flaws(eigenvalues, betti):
    """There are as many harmonic k-forms as the k-th Betti number says."""
    scale = max(map(abs, eigenvalues))
    zeros = sum(abs(value) < 1e-9 * scale for value in eigenvalues)
    return [] if zeros == min(betti, len(eigenvalues)) else [f"{zeros} zeros, Betti number {betti}"]


def inclusion_flaws(lower, higher, relative=1e-8):
    """d takes the eigenforms of degree 0 that are not constant to such of degree 1: their
    eigenvalues, as far as they come, are there again."""
    scale = higher[-1]
    wanted = [x for x in lower if 1e-9 * scale < x < higher[-1] * (1 - relative)]
    return [x for x in wanted if not any(math.isclose(x, y, rel_tol=relative) for y in higher)]


def partition_flaws(n, volumes, duals, total, relative=1e-11):
    """For every k, the sum of volume times signed dual volume over the k-cells is n over k times
    the volume of the mesh."""
    found = []
    for k in range(n + 1):
        products = [a * b for a, b in zip(volumes[k], duals[k], strict=True)]
        size = math.fsum(map(abs, products))
        if abs(math.fsum(products) - math.comb(n, k) * total) > relative * size:
            found.append(k)
    return found


def differences(first, second, relative=1e-9, path="", zero=1e-12):
    """Where two JSON objects differ by more than rounding, and by more than what counts as zero."""
    if isinstance(first, dict) and isinstance(second, dict) and set(first) == set(second):
        return [x for key in first
                for x in differences(first[key], second[key], relative, f"{path}/{key}", zero)]
    if isinstance(first, list) and isinstance(second, list) and len(first) == len(second):
        return [x for i, (a, b) in enumerate(zip(first, second))
                for x in differences(a, b, relative, f"{path}/{i}", zero)]
    if isinstance(first, float) and isinstance(second, (int, float)):
        return [] if math.isclose(first, second, rel_tol=relative, abs_tol=zero) else [path]
    return [] if first == second else [path]


def mesh_files(points, cells):
    """{name: text} of a mesh of tetrahedra in every format."""
    rows = "".join(" ".join(map(repr, p)) + "\n" for p in points)
    sizes = len(points), len(cells)

    def lines(first, front="", back="", numbered=False):
        return "".join((f"{i + first} " if numbered else "") + front
                       + " ".join(str(v + first) for v in cell) + back + "\n"
                       for i, cell in enumerate(cells))

    numbered = [f"{i} {row}\n" for i, row in enumerate(rows.splitlines())]
    return {
        "a.nsc": f"3 3 {sizes[0]} {sizes[1]}\n{rows}{lines(0)}",
        "a.mesh": f"MeshVersionFormatted 2\nDimension 3\nVertices\n{sizes[0]}\n"
                  + rows.replace("\n", " 0\n")
                  + f"Tetrahedra\n{sizes[1]}\n{lines(1, back=' 0')}End\n",
        "a.msh": f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{sizes[0]}\n"
                 + "".join(f"{i + 1} {row}\n" for i, row in enumerate(rows.splitlines()))
                 + f"$EndNodes\n$Elements\n{sizes[1]}\n"
                 + lines(1, "4 2 0 1 ", numbered=True) + "$EndElements\n",
        "a.vtk": "# vtk DataFile Version 2.0\nmesh\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                 f"POINTS {sizes[0]} double\n{rows}CELLS {sizes[1]} {5 * sizes[1]}\n"
                 f"{lines(0, '4 ')}CELL_TYPES {sizes[1]}\n" + "10\n" * sizes[1],
        "a.node": f"{sizes[0]} 3 0 0\n{''.join(numbered)}",
        "a.ele": f"{sizes[1]} 4 0\n{lines(0, numbered=True)}",
    }
