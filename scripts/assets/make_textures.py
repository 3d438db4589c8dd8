#!/usr/bin/env python3
"""Makes the pictures of examples/gallery/textures.yaml in examples/assets.

planks.png: the colour of a floor of oak, 1.2 m by 1.2 m, which repeats. planks_maps.png: red is its height (joints lie 2 mm
below), green its roughness (feet have worn the varnish), blue nothing. board.png: a chess board whose white squares are not there.
scratches.png: heights of a metal plate, brushed around its middle.
"""
import math
import os
import sys

from png_file import write_png
from radiance_file import noise

SIDE = 640
ROWS = 10  # planks across
LENGTHS = 2  # along


def smooth(x, y, cells_x, cells_y, seed):
    """Value noise that repeats after 1 in x and in y, [0, 1]."""
    u, v = x * cells_x, y * cells_y
    i, j = math.floor(u), math.floor(v)
    a, b = u - i, v - j
    a, b = a * a * (3 - 2 * a), b * b * (3 - 2 * b)

    def at(di, dj):
        return noise(seed, (i + di) % cells_x * 977 + (j + dj) % cells_y)

    low = at(0, 0) * (1 - a) + at(1, 0) * a
    high = at(0, 1) * (1 - a) + at(1, 1) * a
    return low * (1 - b) + high * b


def encoded(value):
    value = min(max(value, 0.0), 1.0)
    value = 12.92 * value if value <= 0.0031308 else 1.055 * value ** (1 / 2.4) - 0.055
    return round(255 * value)


def planks():
    colours, maps = [], []
    for py in range(SIDE):
        colour_row, map_row = bytearray(), bytearray()
        y = (py + 0.5) / SIDE
        row = int(y * ROWS)
        across = y * ROWS - row
        shift = noise(11, row)
        for px in range(SIDE):
            x = (px + 0.5) / SIDE
            along = (x + shift) * LENGTHS
            plank = int(along) % LENGTHS + LENGTHS * row
            # Distance to the plank's edges, in mm: 60 wide, 600 long.
            end = (along - math.floor(along)) * 600
            edge = min(across * 120, (1 - across) * 120, end, 600 - end)
            joint = min(max(edge / 2.2, 0.0), 1.0)
            tone = noise(12, plank)
            warp = smooth(x, y, 4, 2 * ROWS, 13 + plank) - 0.5
            rings = 0.5 + 0.5 * math.sin(2 * math.pi * (4 * across + 5 * warp + 7 * tone))
            fibre = smooth(x, y, 24, 320, 5) * 0.6 + smooth(x, y, 60, 320, 6) * 0.4
            light = (0.72 + 0.5 * tone) * (0.80 + 0.2 * rings) * (0.86 + 0.28 * fibre)
            light *= 0.25 + 0.75 * joint
            colour_row += bytes(encoded(c * light) for c in (0.33, 0.185, 0.088))
            height = 0.82 * joint + 0.18 * joint * (0.6 * fibre + 0.4 * rings)
            worn = smooth(x, y, 3, 3, 7) * 0.6 + smooth(x, y, 9, 9, 8) * 0.4
            rough = 0.16 + 0.50 * min(max(1.9 * (worn - 0.32), 0.0), 1.0) + 0.12 * (1 - fibre)
            rough = rough * joint + 0.9 * (1 - joint)
            map_row += bytes((round(255 * height), round(255 * min(rough, 1.0)), 0))
        colours.append(colour_row)
        maps.append(map_row)
    return colours, maps


def board():
    side, margin = 512, 32
    square = (side - 2 * margin) // 8
    rows = []
    for py in range(side):
        row = bytearray()
        for px in range(side):
            x, y = (px - margin) // square, (py - margin) // square
            inside = 0 <= x < 8 and 0 <= y < 8
            is_there = not inside or (x + y) % 2 == 0
            row += bytes((58, 28, 20, 255) if is_there else (0, 0, 0, 0))
        rows.append(row)
    return rows


def scratches():
    side = 512
    rows = []
    for py in range(side):
        row = bytearray()
        for px in range(side):
            x, y = (px + 0.5) / side - 0.5, (py + 0.5) / side - 0.5
            radius = math.hypot(x, y) * side
            angle = math.atan2(y, x)
            value = 0.0
            for k, spacing in enumerate((1.3, 2.1, 3.7)):
                ring = radius / spacing
                i = math.floor(ring)
                part = ring - i
                # Each scratch is a part of a ring.
                at = [noise(20 + k, j * 31 + int((angle + 7 * noise(30 + k, j)) * 3)) for j in (i, i + 1)]
                value += (at[0] * (1 - part) + at[1] * part) / 3
            row.append(round(255 * value))
        rows.append(row)
    return rows


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(__file__), "../../examples/assets")
    colours, maps = planks()
    write_png(os.path.join(folder, "planks.png"), SIDE, SIDE, 3, colours)
    write_png(os.path.join(folder, "planks_maps.png"), SIDE, SIDE, 3, maps)
    write_png(os.path.join(folder, "board.png"), 512, 512, 4, board())
    write_png(os.path.join(folder, "scratches.png"), 512, 512, 1, scratches())


main()
