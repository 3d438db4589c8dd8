"""Writes equirectangular Radiance pictures (Ward, Real Pixels, Graphics Gems II, 1991), Z up, whose centre column
looks along +x. Only the Python standard library; the same file every time.
"""
import math

WIDTH, HEIGHT = 512, 256


def noise(*key):
    """A pseudo-random number in [0, 1) that depends only on the given integers."""
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


def step(x, soft):
    """From 0 at -soft to 1 at soft, smoothly."""
    t = min(1.0, max(0.0, 0.5 + 0.5 * x / soft))
    return t * t * (3 - 2 * t)


def turn(a):
    """An angle in degrees, reduced to [-180, 180)."""
    return (a + 180.0) % 360.0 - 180.0


def rgbe(r, g, b):
    top = max(r, g, b)
    if top < 1e-32:
        return 0, 0, 0, 0
    mantissa, exponent = math.frexp(top)
    scale = mantissa * 256.0 / top
    return int(r * scale), int(g * scale), int(b * scale), exponent + 128


def run_lengths(values):
    """One channel of a scan line, with the format's run-length encoding."""
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


def write(path, radiance):
    """`radiance` of azimuth and elevation, in degrees: red, green and blue."""
    with open(path, "wb") as file:
        file.write(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % (HEIGHT, WIDTH))
        for y in range(HEIGHT):
            elevation = 90 - (y + 0.5) * 180 / HEIGHT
            line = [rgbe(*radiance(180 - (x + 0.5) * 360 / WIDTH, elevation)) for x in range(WIDTH)]
            file.write(bytes((2, 2, WIDTH >> 8, WIDTH & 255)))
            for channel in range(4):
                file.write(run_lengths([pixel[channel] for pixel in line]))
