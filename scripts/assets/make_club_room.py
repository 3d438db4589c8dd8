#!/usr/bin/env python3
"""Makes configs/looks/club_room.hdr: what surrounds the table in the `club` look.

Dark panelled walls, a lit bar with bottles on one side, rows of small bulbs, two dim windows.
"""
import math
import sys

from radiance_file import bump, noise, turn, write

BULBS = []  # azimuth, elevation, radius (degrees), radiance
for i in range(9):  # along the bar, behind the table's left long side
    BULBS.append((62 + 9.5 * i, 6.4 + 0.8 * (noise(1, i) - 0.5), 1.0, (4.2, 2.5, 1.1)))
for i in range(7):  # over the tables at the far end
    BULBS.append((-38 + 12 * i, 4.6 + 1.2 * (noise(2, i) - 0.5), 0.95, (3.4, 2.1, 1.0)))
for i in range(6):
    BULBS.append((196 + 13 * i, 5.0 + 1.4 * (noise(3, i) - 0.5), 0.95, (3.0, 1.8, 0.85)))
for i in range(10):  # bottles and signs: small and coloured
    hue = noise(4, i)
    colour = (1.8, 0.3, 0.2) if hue < 0.35 else (0.25, 0.7, 1.7) if hue < 0.6 else (1.5, 0.9, 0.3)
    BULBS.append((60 + 8.6 * i + 3 * noise(5, i), 2.4 + 1.2 * noise(6, i), 0.8, colour))


def radiance(azimuth, elevation):
    # Walls: warm and dark, a little lighter near the lamps' height, panelled every 15 degrees.
    wall = 0.016 + 0.022 * bump(elevation - 5, 16)
    panel = 1 - 0.35 * bump(turn(azimuth * 24) / 24, 0.7)
    r, g, b = wall * panel * 1.0, wall * panel * 0.72, wall * panel * 0.52
    if elevation > 24:  # ceiling
        fade = min(1.0, (elevation - 24) / 12)
        r, g, b = r + (0.012 - r) * fade, g + (0.012 - g) * fade, b + (0.014 - b) * fade
    if elevation < 0:  # floor: mostly hidden by the floor of the shot
        r, g, b = 0.010, 0.008, 0.007
    # The bar's back wall, softly lit.
    glow = bump(turn(azimuth - 100), 52) * bump(elevation - 4.0, 6)
    r, g, b = r + 0.30 * glow, g + 0.155 * glow, b + 0.06 * glow
    # Two windows at night.
    for centre in (-78, -112):
        if abs(turn(azimuth - centre)) < 9 and 5 < elevation < 19:
            cross = abs(turn(azimuth - centre)) < 0.5 or abs(elevation - 12) < 0.5
            if not cross:
                r, g, b = r + 0.050, g + 0.075, b + 0.130
    for a, e, radius, colour in BULBS:
        d = math.hypot(turn(azimuth - a) * math.cos(math.radians(elevation)), elevation - e)
        if d < 5 * radius:
            disc = min(1.0, max(0.0, (radius - d) / 0.36 + 0.5))
            halo = 0.012 * bump(d, 5 * radius)
            r, g, b = r + colour[0] * (disc + halo), g + colour[1] * (disc + halo), b + colour[2] * (disc + halo)
    return r, g, b


if __name__ == "__main__":
    write(sys.argv[1] if len(sys.argv) > 1 else "configs/looks/club_room.hdr", radiance)
