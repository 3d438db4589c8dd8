#!/usr/bin/env python3
"""Makes configs/looks/studio_room.hdr: what surrounds the table in the `studio` look.

A photographer's studio: a grey paper sweep behind the set, black flags beside it, a large soft box at the left, a
strip box at the right, a small cool one behind for the rims. The boxes are darker towards their edges, like
cloth lit from within.
"""
import math
import sys

from radiance_file import bump, step, turn, write

#        azimuth, elevation, half width, half height, radiance at the middle
BOXES = [(128, 34, 26, 17, (5.4, 5.3, 5.1)),
         (-40, 26, 5.5, 24, (7.5, 7.4, 7.2)),
         (18, 13, 15, 3.2, (2.6, 3.0, 3.6))]


def box(azimuth, elevation, centre, height, half_width, half_height):
    x = turn(azimuth - centre) * math.cos(math.radians(elevation)) / half_width
    y = (elevation - height) / half_height
    inside = step(1 - abs(x), 0.05) * step(1 - abs(y), 0.05)
    return inside * (0.55 + 0.45 * math.exp(-1.6 * (x * x + y * y)))


def radiance(azimuth, elevation):
    # The paper sweep is lightest a little above the horizon, darker upwards and to the sides.
    sweep = 0.030 + 0.125 * math.exp(-((elevation - 5) / 15) ** 2) * (0.35 + 0.65 * bump(turn(azimuth - 30), 110))
    if elevation < 0:
        sweep = 0.030 + (sweep - 0.030) * math.exp(elevation / 6)
    flags = 1 - 0.75 * bump(turn(azimuth - 75), 14) - 0.75 * bump(turn(azimuth + 75), 14)
    r, g, b = sweep * flags, sweep * flags * 1.005, sweep * flags * 1.03
    for centre, height, half_width, half_height, light in BOXES:
        share = box(azimuth, elevation, centre, height, half_width, half_height)
        r, g, b = (c + (l - c) * share if share > 0 else c for c, l in zip((r, g, b), light))
    return r, g, b


if __name__ == "__main__":
    write(sys.argv[1] if len(sys.argv) > 1 else "configs/looks/studio_room.hdr", radiance)
