#!/usr/bin/env python3
"""FLIP once more, slowly: dense two-dimensional filters in double precision, by numpy, after the paper's formulas.

usage: flip_dense.py      prints the figures that tests/unit/tools/flip_test.cpp expects

Andersson et al., FLIP: A Difference Evaluator for Alternating Images, HPG 2020. 67 pixels per degree.
"""
import numpy as np

PPD = 3840 * np.pi / 180  # a screen of 3840 pixels, seen from as far as it is wide
TO_XYZ = np.array([[10135552 / 24577794, 8788810 / 24577794, 4435075 / 24577794],
                   [2613072 / 12288897, 8788810 / 12288897, 887015 / 12288897],
                   [1425312 / 73733382, 8788810 / 73733382, 70074185 / 73733382]])
WHITE = TO_XYZ.sum(axis=1)


def linear(srgb):
    return np.where(srgb > 0.04045, ((srgb + 0.055) / 1.055) ** 2.4, srgb / 12.92)


def opponent(f):
    return np.stack((116 * f[..., 1] - 16, 500 * (f[..., 0] - f[..., 1]), 200 * (f[..., 1] - f[..., 2])), axis=-1)


def ycxcz(rgb):
    return opponent(rgb @ TO_XYZ.T / WHITE)


def from_ycxcz(c):
    y = (c[..., 0] + 16) / 116
    return np.stack((y + c[..., 1] / 500, y, y - c[..., 2] / 200), axis=-1) * WHITE @ np.linalg.inv(TO_XYZ).T


def hunt(rgb):
    f = rgb @ TO_XYZ.T / WHITE
    lab = opponent(np.where(f > (6 / 29) ** 3, np.cbrt(f), f / (3 * (6 / 29) ** 2) + 4 / 29))
    lab[..., 1:] *= 0.01 * lab[..., :1]
    return lab


def hyab(a, b):
    d = a - b
    return np.abs(d[..., 0]) + np.hypot(d[..., 1], d[..., 2])


def filtered(plane, kernel):
    r = kernel.shape[0] // 2
    padded = np.pad(plane, r, mode="edge")
    out = np.zeros_like(plane)
    for dy in range(-r, r + 1):
        for dx in range(-r, r + 1):
            out += kernel[dy + r, dx + r] * padded[r + dy:r + dy + plane.shape[0], r + dx:r + dx + plane.shape[1]]
    return out


def sensitivity(a1, b1, a2, b2):
    r = int(np.ceil(3 * np.sqrt(0.04 / (2 * np.pi ** 2)) * PPD))
    x, y = np.meshgrid(range(-r, r + 1), range(-r, r + 1))
    z = (x ** 2 + y ** 2) / PPD ** 2
    s = sum(a * np.sqrt(np.pi / b) * np.exp(-np.pi ** 2 * z / b) for a, b in ((a1, b1), (a2, b2)))
    return s / s.sum()


def features(y, point):
    sd = 0.5 * 0.082 * PPD
    r = int(np.ceil(3 * sd))
    i, j = np.meshgrid(range(-r, r + 1), range(-r, r + 1))
    g = np.exp(-(i ** 2 + j ** 2) / (2 * sd ** 2))
    k = g * (i ** 2 / sd ** 2 - 1) if point else -i * g
    k = np.where(k < 0, k / -k[k < 0].sum(), k / k[k > 0].sum())
    return np.hypot(filtered(y, k), filtered(y, k.T))


def flip(reference, test):
    seen = []
    for rgb in (reference, test):
        c = ycxcz(linear(rgb / 255.))
        f = np.stack([filtered(c[..., k], sensitivity(*w)) for k, w in
                      enumerate(((1, 0.0047, 0, 1e-5), (1, 0.0053, 0, 1e-5), (34.1, 0.04, 13.5, 0.025)))], axis=-1)
        y = (c[..., 0] + 16) / 116
        seen.append((hunt(np.clip(from_ycxcz(f), 0, 1)), features(y, False), features(y, True)))
    (lab0, edge0, point0), (lab1, edge1, point1) = seen
    most = hyab(hunt(np.array([0., 1, 0])), hunt(np.array([0., 0, 1]))) ** 0.7
    e = hyab(lab0, lab1) ** 0.7
    colour = np.where(e < 0.4 * most, 0.95 * e / (0.4 * most), 0.95 + 0.05 * (e - 0.4 * most) / (0.6 * most))
    feature = np.sqrt(np.maximum(np.abs(edge0 - edge1), np.abs(point0 - point1)) / np.sqrt(2))
    return colour ** (1 - feature)


def picture(of, width=72, height=48):
    return np.array([[[of(x, y, c) for c in range(3)] for x in range(width)] for y in range(height)])


def checks(x, y, c):
    return 40 + 60 * c + x if (x // 8 + y // 8) % 2 else 200 - 30 * c - y


def noise(x, y, c):
    return (x * 73856093 ^ y * 19349663 ^ (c + 1) * 83492791) >> 3 & 255


def main():
    moved = picture(lambda x, y, c: checks(x + 1, y, c))
    brighter = picture(lambda x, y, c: min(255, checks(x, y, c) + 6))
    noisy = picture(lambda x, y, c: min(255, checks(x, y, c) + noise(x, y, c) // 8))
    for name, test in (("moved", moved), ("brighter", brighter), ("noisy", noisy), ("noise", picture(noise))):
        e = flip(picture(checks), test)
        print("%-9s mean %.6f, at 0,0 %.6f, at 37,21 %.6f, at 71,47 %.6f" % (name, e.mean(), e[0, 0], e[21, 37], e[47, 71]))


main()
