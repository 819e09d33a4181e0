# SPDX-License-Identifier: MIT
"""Draws which cells each of three ranks holds: docs/images/many_machines.svg. Needs Python 3 alone.

Usage: doc_pictures_ranks.py FILE
"""
import sys

WIDTH, HEIGHT, STEP = 9, 5, 22  # vertices, vertices, pixels
COLORS = ["#3b75af", "#c8553d", "#4d9b5b"]


def owner(x):
    return x // 3


def triangles():
    for x in range(WIDTH - 1):
        for y in range(HEIGHT - 1):
            yield (x, y), (x + 1, y), (x + 1, y + 1)
            yield (x, y), (x, y + 1), (x + 1, y + 1)


def panel(rank, left):
    """The cells that this rank holds: darker those around which all vertices are its own."""
    def place(corner):
        return f"{left + corner[0] * STEP},{20 + corner[1] * STEP}"

    for cell in triangles():
        own = sum(owner(x) == rank for x, _ in cell)
        fill = COLORS[rank] if own else "none"
        opacity = 0.55 if own == 3 else 0.22
        yield (f'<polygon points="{" ".join(map(place, cell))}" fill="{fill}" '
               f'fill-opacity="{opacity}" stroke="#999" stroke-width="0.6"/>')
    for x in range(WIDTH):
        for y in range(HEIGHT):
            if owner(x) == rank:
                cx, cy = place((x, y)).split(",")
                yield f'<circle cx="{cx}" cy="{cy}" r="3.4" fill="{COLORS[rank]}"/>'
    yield (f'<text x="{left + (WIDTH - 1) * STEP / 2}" y="{20 + HEIGHT * STEP}" '
           f'text-anchor="middle">rank {rank}</text>')


def main(path):
    panels = [line for rank in range(3)
              for line in panel(rank, 12 + rank * (WIDTH * STEP + 6))]
    size = f'{24 + 3 * (WIDTH * STEP + 6) - STEP} {36 + HEIGHT * STEP}'
    width, height = size.split()
    with open(path, "w", encoding="utf-8") as file:
        file.write(f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
                   f'viewBox="0 0 {size}" font-family="sans-serif" font-size="12">\n'
                   f'<rect width="100%" height="100%" fill="white"/>\n'
                   + "\n".join(panels) + "\n</svg>\n")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
