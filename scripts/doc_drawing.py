# SPDX-License-Identifier: MIT
"""Plane geometry and a picture that is written as SVG, for doc_pictures.py."""
import math

BLUE, ORANGE, RED, GREY, BLACK = "#0072B2", "#E69F00", "#D55E00", "#888888", "#222222"
LIGHT_BLUE, LIGHT_ORANGE, LIGHT_GREY = "#D3E7F3", "#FBEBCB", "#F0F0F0"


# plane geometry on pairs of numbers

def plus(a, b, factor=1.0):
    return (a[0] + factor * b[0], a[1] + factor * b[1])


def minus(a, b):
    return (a[0] - b[0], a[1] - b[1])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def mean(*points):
    return (sum(p[0] for p in points) / len(points), sum(p[1] for p in points) / len(points))


def unit(a):
    return (a[0] / math.hypot(*a), a[1] / math.hypot(*a))


def polar(r, degrees):
    return (r * math.cos(math.radians(degrees)), r * math.sin(math.radians(degrees)))


def solid(p):
    """Where a point of space is seen, from the right, above and in front."""
    x, y, z = p
    return (0.95 * x + 0.42 * y, 0.9 * z + 0.28 * y - 0.12 * x)


def circumcenter(a, b, c):
    u, v = minus(b, a), minus(c, a)
    double = 2 * cross(u, v)
    return plus(a, ((v[1] * dot(u, u) - u[1] * dot(v, v)) / double,
                    (u[0] * dot(v, v) - v[0] * dot(u, u)) / double))


class Picture:
    """Shapes on a white ground. frame() says where the origin is and how long a unit is."""

    def __init__(self, width, height):
        self.width, self.height = width, height
        self.shapes = []
        self.frame(0, height, 1)

    def frame(self, x, y, scale):
        self.x, self.y, self.scale = x, y, scale

    def at(self, p):
        return self.x + self.scale * p[0], self.y - self.scale * p[1]

    def path(self, points, color=BLACK, width=2.0, fill="none", dash="", close=False):
        corners = " L ".join("%.1f %.1f" % self.at(p) for p in points)
        style = f' stroke-dasharray="{dash}"' if dash else ""
        self.shapes.append(f'<path d="M {corners}{" Z" if close else ""}" fill="{fill}" '
                           f'stroke="{color}" stroke-width="{width}" stroke-linejoin="round" '
                           f'stroke-linecap="round"{style}/>')

    def polygon(self, points, fill, color="none", width=1.0):
        self.path(points, color, width, fill, close=True)

    def dot(self, p, color=BLACK, radius=4.0, fill=""):
        x, y = self.at(p)
        self.shapes.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}" fill="{fill or color}" '
                           f'stroke="{color}" stroke-width="1.5"/>')

    def circle(self, p, radius, color=GREY, width=1.0, dash="4 4"):
        x, y = self.at(p)
        self.shapes.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius * self.scale:.1f}" '
                           f'fill="none" stroke="{color}" stroke-width="{width}" '
                           f'stroke-dasharray="{dash}"/>')

    def arrow(self, a, b, color=BLACK, width=2.0, dash="", head=9.0):
        """From a to b; the head is a triangle of so many pixels."""
        direction = unit(minus(b, a))
        across = (-direction[1], direction[0])
        size = head / self.scale
        back = plus(b, direction, -size)
        self.path([a, back], color, width, dash=dash)
        self.polygon([b, plus(back, across, 0.4 * size), plus(back, across, -0.4 * size)], color)

    def orient(self, a, b, color=BLACK, width=2.0):
        """A segment with a head in the middle."""
        self.path([a, b], color, width)
        middle = plus(mean(a, b), unit(minus(b, a)), 5 / self.scale)
        self.arrow(plus(middle, unit(minus(b, a)), -9.5 / self.scale), middle, color, width)

    def text(self, p, words, color=BLACK, size=14, anchor="middle", shift=(0, 0), style="",
             weight="normal"):
        x, y = self.at(p)
        words = words.replace("&", "&amp;").replace("<", "&lt;")
        self.shapes.append(
            f'<text x="{x + shift[0]:.1f}" y="{y + shift[1]:.1f}" font-family="sans-serif" '
            f'font-size="{size}" fill="{color}" text-anchor="{anchor}" font-weight="{weight}"'
            f'{f" font-style={chr(34)}{style}{chr(34)}" if style else ""}>{words}</text>')

    def svg(self, title):
        return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{self.width}" '
                f'height="{self.height}" viewBox="0 0 {self.width} {self.height}" role="img">\n'
                f'<title>{title}</title>\n<rect width="100%" height="100%" fill="#FFFFFF"/>\n'
                + "\n".join(self.shapes) + "\n</svg>\n")


# six neighbors of a vertex, all triangles acute
FAN = [polar(r, a) for r, a in ((1.0, 10), (1.12, 72), (1.02, 130), (1.1, 190), (0.98, 248),
                                (1.1, 310))]
