#!/usr/bin/env python3
"""SSIM and FLIP by the letter of their papers, in plain double precision and without any shortcut: every window is a sum
over a square, nothing is separated. Prints the numbers that tests/unit/metrics_test.cpp holds the program to.

SSIM: Wang, Bovik, Sheikh, Simoncelli 2004. FLIP: Andersson et al., HPG 2020. Pictures are the two of `picture`.
"""
from math import ceil, exp, hypot, pi, sqrt

WIDTH, HEIGHT = 24, 18


def picture(which):
    """8-bit levels, rows of (r, g, b); the same arithmetic stands in the test."""
    rows = []
    for y in range(HEIGHT):
        row = []
        for x in range(WIDTH):
            r = (x * 10 + y * 3) % 256
            g = (x * y * 5 + 40) % 256
            b = 200 if (x // 4 + y // 3) % 2 else 30
            if which == 1:
                r = (r * 7 + x * x) // 8 % 256
                if 8 <= x < 13 and 5 <= y < 11:
                    g, b = 255 - g, b // 2
            row.append((r, g, b))
        rows.append(row)
    return rows


def changed(kind):
    """The first picture with one kind of fault; the same stands in the test."""
    rows = picture(0)
    if kind == 'brighter':
        return [[tuple(min(v + 5, 255) for v in c) for c in row] for row in rows]
    if kind == 'one pixel to the right':
        return [[row[max(x - 1, 0)] for x in range(WIDTH)] for row in rows]
    if kind == 'a black square':
        return [[(0, 0, 0) if 9 <= x < 15 and 6 <= y < 12 else c for x, c in enumerate(row)]
                for y, row in enumerate(rows)]
    return [[(r, g, (b + (16 if (x + y) % 2 else -16)) % 256) for x, (r, g, b) in enumerate(row)]
            for y, row in enumerate(rows)]  # dithered blue


def clamped(plane, x, y):
    return plane[min(max(y, 0), len(plane) - 1)][min(max(x, 0), len(plane[0]) - 1)]


def correlate(plane, weights):
    """weights[(dx, dy)] over a square, border repeated."""
    return [[sum(w * clamped(plane, x + dx, y + dy) for (dx, dy), w in weights.items())
             for x in range(len(plane[0]))] for y in range(len(plane))]


def ssim(a, b, span):
    radius, sigma = 5, 1.5
    square = [(dx, dy) for dy in range(-radius, radius + 1) for dx in range(-radius, radius + 1)]
    weights = {d: exp(-(d[0] ** 2 + d[1] ** 2) / (2 * sigma ** 2)) for d in square}
    total = sum(weights.values())
    c1, c2 = (0.01 * span) ** 2, (0.03 * span) ** 2
    values = []
    for y in range(radius, len(a) - radius):
        for x in range(radius, len(a[0]) - radius):
            ma = sum(w * a[y + dy][x + dx] for (dx, dy), w in weights.items()) / total
            mb = sum(w * b[y + dy][x + dx] for (dx, dy), w in weights.items()) / total
            va = sum(w * (a[y + dy][x + dx] - ma) ** 2 for (dx, dy), w in weights.items()) / total
            vb = sum(w * (b[y + dy][x + dx] - mb) ** 2 for (dx, dy), w in weights.items()) / total
            cov = sum(w * (a[y + dy][x + dx] - ma) * (b[y + dy][x + dx] - mb) for (dx, dy), w in weights.items()) / total
            values.append((2 * ma * mb + c1) * (2 * cov + c2) / ((ma * ma + mb * mb + c1) * (va + vb + c2)))
    return sum(values) / len(values)


def linear_of_srgb(v):
    return v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4


# sRGB primaries under D65, and the inverse by Cramer's rule.
M = [[10135552 / 24577794, 8788810 / 24577794, 4435075 / 24577794],
     [2613072 / 12288897, 8788810 / 12288897, 887015 / 12288897],
     [1425312 / 73733382, 8788810 / 73733382, 70074185 / 73733382]]
WHITE = [sum(row) for row in M]


def inverse(m):
    (a, b, c), (d, e, f), (g, h, i) = m
    det = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    return [[(e * i - f * h) / det, (c * h - b * i) / det, (b * f - c * e) / det],
            [(f * g - d * i) / det, (a * i - c * g) / det, (c * d - a * f) / det],
            [(d * h - e * g) / det, (b * g - a * h) / det, (a * e - b * d) / det]]


M_INVERSE = inverse(M)


def times(m, v):
    return [sum(m[i][j] * v[j] for j in range(3)) for i in range(3)]


def ycxcz(rgb):
    x, y, z = [c / w for c, w in zip(times(M, rgb), WHITE)]
    return 116 * y - 16, 500 * (x - y), 200 * (y - z)


def rgb_of_ycxcz(c):
    y = (c[0] + 16) / 116
    return times(M_INVERSE, [(y + c[1] / 500) * WHITE[0], y * WHITE[1], (y - c[2] / 200) * WHITE[2]])


def hunt(rgb):
    def f(t):
        return t ** (1 / 3) if t > (6 / 29) ** 3 else t / (3 * (6 / 29) ** 2) + 4 / 29
    x, y, z = [f(c / w) for c, w in zip(times(M, rgb), WHITE)]
    lightness = 116 * y - 16
    return lightness, 0.01 * lightness * 500 * (x - y), 0.01 * lightness * 200 * (y - z)


def hyab(a, b):
    return abs(a[0] - b[0]) + hypot(a[1] - b[1], a[2] - b[2])


def flip(a, b, ppd):
    def csf(a1, b1, a2, b2):
        radius = ceil(3 * sqrt(0.04 / (2 * pi ** 2)) * ppd)
        weights = {}
        for dy in range(-radius, radius + 1):
            for dx in range(-radius, radius + 1):
                d2 = (dx / ppd) ** 2 + (dy / ppd) ** 2
                weights[dx, dy] = (a1 * sqrt(pi / b1) * exp(-pi ** 2 * d2 / b1)
                                   + a2 * sqrt(pi / b2) * exp(-pi ** 2 * d2 / b2))
        total = sum(weights.values())
        return {d: w / total for d, w in weights.items()}

    filters = [csf(1, 0.0047, 0, 1e-5), csf(1, 0.0053, 0, 1e-5), csf(34.1, 0.04, 13.5, 0.025)]

    def seen(image):
        opponent = [[ycxcz(c) for c in row] for row in image]
        planes = [correlate([[c[k] for c in row] for row in opponent], filters[k]) for k in range(3)]
        lab = [[hunt([min(max(v, 0), 1) for v in rgb_of_ycxcz([p[y][x] for p in planes])])
                for x in range(len(image[0]))] for y in range(len(image))]
        return lab, [[(c[0] + 16) / 116 for c in row] for row in opponent]

    def features(grey, kind):
        sigma = 0.5 * 0.082 * ppd
        radius = ceil(3 * sigma)
        weights = {}
        for dy in range(-radius, radius + 1):
            for dx in range(-radius, radius + 1):
                g = exp(-(dx * dx + dy * dy) / (2 * sigma * sigma))
                weights[dx, dy] = -dx * g if kind == 'edge' else (dx * dx / (sigma * sigma) - 1) * g
        positive = sum(w for w in weights.values() if w > 0)
        negative = -sum(w for w in weights.values() if w < 0)
        weights = {d: w / positive if w > 0 else w / negative for d, w in weights.items()}
        across = correlate(grey, weights)
        down = correlate(grey, {(dy, dx): w for (dx, dy), w in weights.items()})
        return [[hypot(p, q) for p, q in zip(*rows)] for rows in zip(across, down)]

    lab_a, grey_a = seen(a)
    lab_b, grey_b = seen(b)
    kinds = {kind: (features(grey_a, kind), features(grey_b, kind)) for kind in ('edge', 'point')}
    cmax = hyab(hunt([0, 1, 0]), hunt([0, 0, 1])) ** 0.7
    values = []
    for y in range(len(a)):
        for x in range(len(a[0])):
            power = hyab(lab_a[y][x], lab_b[y][x]) ** 0.7
            if power < 0.4 * cmax:
                colour = 0.95 / (0.4 * cmax) * power
            else:
                colour = 0.95 + (power - 0.4 * cmax) / (cmax - 0.4 * cmax) * 0.05
            feature = max(abs(f[y][x] - g[y][x]) for f, g in kinds.values())
            values.append(colour ** (1 - (feature / sqrt(2)) ** 0.5))
    return values


def main():
    a, b = picture(0), picture(1)
    plane = [[[[c[k] for c in row] for row in p] for k in range(3)] for p in (a, b)]
    print('ssim of the red, green and blue levels:')
    for k in range(3):
        print(f'  {ssim(plane[0][k], plane[1][k], 255):.15f}')
    linear = [[[[linear_of_srgb(v / 255) for v in c] for c in row] for row in p] for p in (a, b)]
    for ppd in (0.7 * (3840 / 0.7) * pi / 180, 20.0):
        values = flip(linear[0], linear[1], ppd)
        print(f'flip at {ppd:.15f} pixels per degree: mean {sum(values) / len(values):.15f}')
        print(f'  at (0, 0) {values[0]:.15f}, at (10, 7) {values[7 * WIDTH + 10]:.15f}')
    for kind in ('brighter', 'one pixel to the right', 'a black square', 'dithered blue'):
        other = [[[linear_of_srgb(v / 255) for v in c] for c in row] for row in changed(kind)]
        values = flip(linear[0], other, 0.7 * (3840 / 0.7) * pi / 180)
        print(f'flip, {kind}: {sum(values) / len(values):.15f}')


main()
