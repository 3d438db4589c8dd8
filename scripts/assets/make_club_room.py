#!/usr/bin/env python3
"""Makes configs/looks/club_room.hdr: what surrounds the table in the `club` look.

An equirectangular Radiance picture (Ward, Real Pixels, Graphics Gems II, 1991), Z up, whose centre column looks
along +x: dark panelled walls, a lit bar with bottles on one side, rows of small bulbs, two dim windows. Only the
Python standard library; the same file every time.
"""
import math
import sys

WIDTH, HEIGHT = 512, 256


def noise(*key):
    """A fixed pseudo-random number in [0, 1) of a few integers."""
    h = 2166136261
    for k in key:
        h = ((h ^ (k & 0xFFFFFFFF)) * 16777619) & 0xFFFFFFFF
        h ^= h >> 15
        h = (h * 2246822519) & 0xFFFFFFFF
        h ^= h >> 13
    return h / 4294967296.0


def bump(x, half):
    """1 at 0, falling smoothly to 0 at +-half."""
    t = abs(x) / half
    return (1 - t * t) ** 2 if t < 1 else 0.0


def turn(a):
    """An angle in degrees brought into [-180, 180)."""
    return (a + 180.0) % 360.0 - 180.0


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
    if elevation < 0:  # floor: mostly hidden by the shot's own
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


def rgbe(r, g, b):
    top = max(r, g, b)
    if top < 1e-32:
        return 0, 0, 0, 0
    mantissa, exponent = math.frexp(top)
    scale = mantissa * 256.0 / top
    return int(r * scale), int(g * scale), int(b * scale), exponent + 128


def run_lengths(values):
    """One channel of a scan line, run-length coded as the format has it."""
    out, i = bytearray(), 0
    while i < len(values):
        run = 1
        while run < 127 and i + run < len(values) and values[i + run] == values[i]:
            run += 1
        if run >= 4:
            out += bytes((128 + run, values[i]))
            i += run
            continue
        start = i
        while i < len(values) and i - start < 128:
            if i + 3 < len(values) and values[i] == values[i + 1] == values[i + 2] == values[i + 3]:
                break
            i += 1
        out += bytes((i - start,)) + bytes(values[start:i])
    return bytes(out)


def main(path):
    with open(path, "wb") as file:
        file.write(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % (HEIGHT, WIDTH))
        for y in range(HEIGHT):
            elevation = 90 - (y + 0.5) * 180 / HEIGHT
            line = [rgbe(*radiance(180 - (x + 0.5) * 360 / WIDTH, elevation)) for x in range(WIDTH)]
            file.write(bytes((2, 2, WIDTH >> 8, WIDTH & 255)))
            for channel in range(4):
                file.write(run_lengths([pixel[channel] for pixel in line]))


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "configs/looks/club_room.hdr")
