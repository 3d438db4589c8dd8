#!/usr/bin/env python3
"""Makes configs/looks/daylight_room.hdr: what surrounds the table in the `daylight` look.

A light room on a clear day: tall sash windows along one side with the sky, a hedge and a sunlit terrace in them, a
pair of smaller ones at the far end, white walls over pale panelling, a white ceiling lit from below.
"""
import math
import sys

from radiance_file import bump, noise, step, turn, write

# Azimuth of the middle, half width, lower and upper end (all degrees), brightness.
WINDOWS = [(62, 9.5, 3, 34, 1.5), (90, 10.5, 2.5, 37, 1.7), (118, 9.5, 3, 34, 1.5), (-14, 5, 5, 22, 0.7),
           (10, 5, 5, 22, 0.75)]


def view(azimuth, elevation):
    """What is seen through a window."""
    top = 9 + 2.2 * math.sin(azimuth * 0.35) + 1.6 * noise(7, int(azimuth * 1.3))
    sky = [2.9 + 0.02 * elevation, 3.7 + 0.03 * elevation, 5.0 + 0.05 * elevation]
    cloud = bump(elevation - 24 - 4 * math.sin(azimuth * 0.12), 7) * (0.6 + 0.4 * math.sin(azimuth * 0.31 + 1))
    sky = [s + (6.2 - s) * max(0.0, cloud) for s in sky]
    leaf = 0.55 + 0.9 * noise(1, int(azimuth * 2.7), int(elevation * 2.7))
    hedge = (0.42 * leaf, 0.62 * leaf, 0.20 * leaf)
    above = step(elevation - top, 1.2)
    colour = [h + (s - h) * above for h, s in zip(hedge, sky)]
    if elevation < 4.2:  # the terrace
        colour = [2.6, 2.45, 2.2]
    return colour


def radiance(azimuth, elevation):
    # Walls are lightest opposite the windows; panelling up to the height of a chair's back.
    facing = 0.5 - 0.5 * math.cos(math.radians(turn(azimuth - 90)))
    light = 0.09 + 0.17 * facing
    r, g, b = light * 1.02, light, light * 0.95
    if elevation < 1.5:
        groove = 1 - 0.25 * bump(turn(azimuth * 30) / 30, 0.5)
        r, g, b = r * 0.72 * groove, g * 0.69 * groove, b * 0.62 * groove
    if elevation > 42:
        fade = min(1.0, (elevation - 42) / 8)
        r, g, b = r + (0.30 - r) * fade, g + (0.30 - g) * fade, b + (0.31 - b) * fade
    if elevation < -6:
        r, g, b = 0.16, 0.12, 0.085
    for k, (centre, half, low, high, scale) in enumerate(WINDOWS):
        x = turn(azimuth - centre) / half
        y = (elevation - low) / (high - low)
        if abs(x) < 1.12 and -0.04 < y < 1.06:  # the frame, in its own shade
            r, g, b = 0.30, 0.29, 0.28
        bars = max(bump(x, 0.05), bump(abs(x) - 1, 0.05), bump(y - 0.52, 0.03))
        inside = step(1 - abs(x), 0.03) * step(y, 0.012) * step(1 - y, 0.012) * (1 - min(1.0, 2 * bars))
        if inside > 0:
            seen = view(azimuth + 13 * k, elevation)
            r, g, b = (c + (scale * s - c) * inside for c, s in zip((r, g, b), seen))
    return r, g, b


if __name__ == "__main__":
    write(sys.argv[1] if len(sys.argv) > 1 else "configs/looks/daylight_room.hdr", radiance)
