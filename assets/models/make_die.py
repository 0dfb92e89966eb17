#!/usr/bin/env python3
"""Writes die.obj, die.mtl and die.png beside itself: a die with rounded edges, its faces on one 3 x 2 picture.

Opposite faces add up to seven. Needs nothing but Python; run it again after changing it.
"""
import pathlib
import struct
import zlib

FOLDER = pathlib.Path(__file__).resolve().parent
STEPS = 8       # quads along a face
ROUND = 0.28    # radius of the edges, in half edge lengths
TILE = 128      # texels along a face

# The face's number: its direction, and the directions of u and v (v downwards) on it, seen from outside.
FACES = {
    1: ((0, 0, 1), (1, 0, 0), (0, -1, 0)),
    6: ((0, 0, -1), (-1, 0, 0), (0, -1, 0)),
    2: ((1, 0, 0), (0, 0, -1), (0, -1, 0)),
    5: ((-1, 0, 0), (0, 0, 1), (0, -1, 0)),
    3: ((0, 1, 0), (1, 0, 0), (0, 0, 1)),
    4: ((0, -1, 0), (1, 0, 0), (0, 0, -1)),
}
PIPS = {
    1: [(0, 0)],
    2: [(-1, -1), (1, 1)],
    3: [(-1, -1), (0, 0), (1, 1)],
    4: [(-1, -1), (1, -1), (-1, 1), (1, 1)],
    5: [(-1, -1), (1, -1), (-1, 1), (1, 1), (0, 0)],
    6: [(-1, -1), (1, -1), (-1, 0), (1, 0), (-1, 1), (1, 1)],
}


def place(face, s, t):
    """Position and normal of the rounded cube for s, t in [-1, 1] on a face."""
    n, u, v = FACES[face]
    p = [n[i] + s * u[i] + t * v[i] for i in range(3)]
    core = [max(-1 + ROUND, min(1 - ROUND, x)) for x in p]
    away = [p[i] - core[i] for i in range(3)]
    length = sum(x * x for x in away) ** 0.5
    normal = [x / length for x in away]
    return [core[i] + ROUND * normal[i] for i in range(3)], normal


def write_obj():
    lines = ["# Written by make_die.py", "mtllib die.mtl", "o die"]
    faces = []
    for number in FACES:
        column, row = (number - 1) % 3, (number - 1) // 3
        first = sum(line.startswith("v ") for line in lines) + 1
        # More steps in the rounded part, where the normal turns.
        marks = [-1, -0.92, -0.84, -1 + ROUND, 0, 1 - ROUND, 0.84, 0.92, 1]
        for t in marks:
            for s in marks:
                p, n = place(number, s, t)
                lines.append("v %.6f %.6f %.6f" % tuple(p))
                lines.append("vt %.6f %.6f" % ((column + 0.5 + 0.498 * s) / 3, 1 - (row + 0.5 + 0.498 * t) / 2))
                lines.append("vn %.6f %.6f %.6f" % tuple(n))
        width = len(marks)
        for j in range(STEPS):
            for i in range(STEPS):
                a = first + j * width + i
                corners = (a, a + width, a + width + 1, a + 1)
                faces.append("f " + " ".join("%d/%d/%d" % (c, c, c) for c in corners))
    lines += ["usemtl ivory"] + faces
    (FOLDER / "die.obj").write_text("\n".join(lines) + "\n")
    (FOLDER / "die.mtl").write_text(
        "# Written by make_die.py\nnewmtl ivory\nKa 1 1 1\nKd 1 1 1\nKs 0.6 0.6 0.6\nNs 60\nillum 2\nmap_Kd die.png\n")


def texel(x, y):
    number = y // TILE * 3 + x // TILE + 1
    a, b = (x % TILE + 0.5) / TILE * 2 - 1, (y % TILE + 0.5) / TILE * 2 - 1
    nearest = min(((a - 0.48 * p) ** 2 + (b - 0.48 * q) ** 2) ** 0.5 for p, q in PIPS[number])
    radius = 0.24 if number == 1 else 0.17
    ink = max(0.0, min(1.0, (radius - nearest) * TILE / 2 + 0.5))
    pip = (170, 30, 35) if number == 1 else (35, 38, 52)
    grain = (x * 7 + y * 13 + x * y * 3) % 11 - 5
    body = (238 + grain, 229 + grain, 205 + grain)
    return bytes(round(body[i] + (pip[i] - body[i]) * ink) for i in range(3))


def write_png():
    width, height = 3 * TILE, 2 * TILE
    rows = b"".join(b"\0" + b"".join(texel(x, y) for x in range(width)) for y in range(height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    png = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")
    (FOLDER / "die.png").write_bytes(png)


if __name__ == "__main__":
    write_obj()
    write_png()
