# SPDX-License-Identifier: MIT
"""What a page holds, read by other code than its own script."""
import base64
import html
import json
import math
import re
import struct
import zlib


class PageFile:
    """The header of a page, its arrays by name, and its text."""

    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            self.text = file.read()
        self.header = json.loads(self.element("page-header"))
        self.bytes = zlib.decompress(base64.b64decode(self.element("page-data")), -15)
        self.arrays = {name: self.array(entry) for name, entry in self.header["arrays"].items()}
        self.fields = {field["name"]: field for field in self.header["fields"]}

    def element(self, name):
        return re.search(rf'<script [^>]*id="{name}">(.*?)</script>', self.text, re.DOTALL).group(1)

    def array(self, entry):
        """The numbers of an entry of the directory: see io/pages/page_data.h."""
        at, count, width = entry["at"], entry["count"], entry["width"]
        planes = [self.bytes[at + i * count:at + (i + 1) * count] for i in range(4)]
        words = [a | b << 8 | c << 16 | d << 24 for a, b, c, d in zip(*planes)]
        if entry["kind"] == "float":
            packed = struct.pack(f"<{count}I", *words)
            return [math.ldexp(x, entry["exponent"]) for x in struct.unpack(f"<{count}f", packed)]
        numbers = []
        for i, word in enumerate(words):
            step = word >> 1 ^ -(word & 1)
            number = (numbers[i - width] if i >= width else 0) + step
            numbers.append((number + 2**31) % 2**32 - 2**31)
        if entry["kind"] == "rounded":
            return [entry["low"] + entry["step"] * number for number in numbers]
        return numbers

    def values(self, name, step=None):
        """Of a field, at a step of a series."""
        i = list(self.fields).index(name)
        return self.arrays[f"f{i}" if step is None else f"f{i}.{step}"]

    def points(self):
        """Three coordinates a point, as in the file that the page shows."""
        flat, origin = self.arrays["points"], self.header["origin"]
        return [tuple(flat[i + c] + origin[c] for c in range(3)) for i in range(0, len(flat), 3)]

    def table(self):
        """The cells of the rows of the table, as text."""
        body = re.search(r"<tbody>(.*?)</tbody>", self.text, re.DOTALL)
        return [[html.unescape(cell) for cell in re.findall("<td>(.*?)</td>", row)]
                for row in body.group(1).split("</tr>") if "<td>" in row] if body else []


def map_color(colors, t):
    """Of a color map, hexadecimal colors at even steps, red, green and blue from 0 to 255."""
    at = min(1, max(0, t)) * (len(colors) - 1)
    i = min(int(at), len(colors) - 2)
    first, second = ([int(color[c:c + 2], 16) for c in (1, 3, 5)] for color in colors[i:i + 2])
    return tuple(a + (at - i) * (b - a) for a, b in zip(first, second))
