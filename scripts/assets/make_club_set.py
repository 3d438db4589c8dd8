#!/usr/bin/env python3
"""Makes configs/sets/club/*.obj: the parts of a bar with a billiard table, in metres, Z up.

  planks_1 .. 4      a floor of boards along x, 11.2 m by 7.6 m, whose boards are in one of four files by chance; the
                     origin is the middle of its top
  panel              a wainscot panel, 0.92 m wide and 1 m high, whose front faces +y; its origin is below the middle
  door               a door of six panels, 0.9 m by 2.05 m, likewise
  frame              the frame of a picture of 0.6 m by 0.45 m, likewise, about its middle
  bottle_1 .. 4      bottles; tumbler: a glass that stands upside down; their origin is the middle of their foot
  stool_seat, stool_foot
                     a bar stool, 0.76 m high, standing at its origin
  enamel, enamel_inside
                     a lamp shade of enamel, 0.4 m wide, whose opening's middle is the origin
  sconce             a half bowl on a wall that faces +y

Only the Python standard library; the same files every time.
"""
import math
import os
import random
import sys


class Mesh:
    def __init__(self):
        self.vertices, self.faces = [], []

    def vertex(self, x, y, z):
        self.vertices.append((x, y, z))
        return len(self.vertices)

    def polygon(self, *places):
        self.faces.append([self.vertex(*place) for place in places])

    def write(self, folder, name, what):
        with open(os.path.join(folder, name + ".obj"), "w") as file:
            file.write("# %s; made by scripts/assets/make_club_set.py\n" % what)
            for vertex in self.vertices:
                file.write("v %.5g %.5g %.5g\n" % tuple(round(c, 5) + 0.0 for c in vertex))
            for face in self.faces:
                file.write("f " + " ".join(map(str, face)) + "\n")


def lathe(profile, around=24, turn=1.0):
    """`profile`: (radius, z), upwards on the outside; the surface faces away from the axis on its right."""
    mesh = Mesh()
    count = around if turn == 1.0 else around + 1
    rings = []
    for radius, z in profile:
        angles = [2 * math.pi * turn * k / around for k in range(count)]
        rings.append([mesh.vertex(radius * math.cos(a), radius * math.sin(a), z) for a in angles])
    for low, high in zip(rings, rings[1:]):
        for k in range(around):
            n = (k + 1) % count
            mesh.faces.append([low[k], low[n], high[n], high[k]])
    return mesh


def arc(cx, cz, radius, start, end, steps):
    """Points around (cx, cz), by angles in degrees."""
    return [(cx + radius * math.cos(math.radians(start + (end - start) * k / steps)),
             cz + radius * math.sin(math.radians(start + (end - start) * k / steps))) for k in range(steps + 1)]


def bottles():
    claret = [(0, 0.012), (0.025, 0.002), (0.037, 0.003), (0.038, 0.19)] + arc(0.016, 0.19, 0.022, 0, 62, 5) + \
             [(0.0155, 0.225), (0.0145, 0.285), (0.0155, 0.287), (0.0155, 0.300), (0.0, 0.301)]
    spirit = [(0, 0.006), (0.036, 0.0), (0.041, 0.005), (0.041, 0.165)] + arc(0.026, 0.165, 0.015, 0, 80, 4) + \
             [(0.015, 0.195), (0.014, 0.250), (0.018, 0.252), (0.018, 0.275), (0.0, 0.276)]
    squat = [(0, 0.004), (0.048, 0.0), (0.055, 0.02), (0.056, 0.10)] + arc(0.030, 0.10, 0.026, 0, 70, 5) + \
            [(0.016, 0.150), (0.016, 0.185), (0.021, 0.187), (0.021, 0.215), (0.0, 0.217)]
    slim = [(0, 0.006), (0.030, 0.0), (0.034, 0.005), (0.030, 0.14), (0.024, 0.23), (0.013, 0.285), (0.0125, 0.33),
            (0.015, 0.332), (0.015, 0.350), (0.0, 0.351)]
    return [claret, spirit, squat, slim]


def planks(seed=5, length=11.2, width=7.6, board=0.112, bevel=0.0012, depth=0.0015):
    """Four meshes: what a board has of the other three is chance."""
    chance = random.Random(seed)
    meshes = [Mesh() for _ in range(4)]
    for row in range(int(math.ceil(width / board))):
        y0 = -width / 2 + row * board
        y1 = min(y0 + board, width / 2)
        x = -length / 2 - chance.uniform(0.0, 1.2)
        while x < length / 2:
            size = chance.uniform(0.8, 1.9)
            a, b = max(x, -length / 2), min(x + size, length / 2)
            x += size
            if b - a < 0.02:
                continue
            mesh = chance.choice(meshes)
            outer = [(a, y0), (b, y0), (b, y1), (a, y1)]
            inner = [(a + bevel, y0 + bevel), (b - bevel, y0 + bevel), (b - bevel, y1 - bevel), (a + bevel, y1 - bevel)]
            top = [mesh.vertex(px, py, 0.0) for px, py in inner]
            low = [mesh.vertex(px, py, -depth) for px, py in outer]
            mesh.faces.append(top)
            for k in range(4):
                n = (k + 1) % 4
                mesh.faces.append([low[k], low[n], top[n], top[k]])
    return meshes


def nested(mesh, x0, x1, z0, z1, steps):
    """Frames of decreasing rectangles on a wall that faces +y. `steps`: (inset, y) of each; the last one is filled."""
    rings = []
    for inset, y in steps:
        rings.append([mesh.vertex(x0 + inset, y, z0 + inset), mesh.vertex(x1 - inset, y, z0 + inset),
                      mesh.vertex(x1 - inset, y, z1 - inset), mesh.vertex(x0 + inset, y, z1 - inset)])
    for outer, inner in zip(rings, rings[1:]):
        for k in range(4):
            n = (k + 1) % 4
            mesh.faces.append([outer[n], outer[k], inner[k], inner[n]])
    mesh.faces.append(list(reversed(rings[-1])))


RAISED = [(0.0, 0.0), (0.0, 0.022), (0.075, 0.022), (0.083, 0.017), (0.090, 0.010), (0.105, 0.010), (0.135, 0.019), (0.140, 0.019)]


def panel():
    mesh = Mesh()
    nested(mesh, -0.46, 0.46, 0.0, 1.0, RAISED)
    return mesh


def door():
    mesh = Mesh()
    nested(mesh, -0.45, 0.45, 0.0, 2.05, [(0.0, 0.0), (0.0, 0.04), (0.001, 0.04)])
    for column in (-1, 1):
        for low, high in ((0.18, 0.78), (0.90, 1.45), (1.57, 1.93)):
            left = 0.06 if column > 0 else -0.36
            nested(mesh, left, left + 0.30, low, high,
                   [(0.0, 0.0401), (0.008, 0.047), (0.016, 0.0402), (0.045, 0.049), (0.05, 0.049)])
    return mesh


def frame():
    mesh = Mesh()
    rings = [(-0.055, 0.0), (-0.055, 0.022), (-0.045, 0.030), (-0.030, 0.027), (-0.012, 0.018), (0.0, 0.016), (0.0, 0.006)]
    nested(mesh, -0.30, 0.30, -0.225, 0.225, rings)
    mesh.faces.pop()  # the picture is another object
    return mesh


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.join(os.path.dirname(__file__), "../../configs/sets/club")
    os.makedirs(folder, exist_ok=True)
    for k, profile in enumerate(bottles()):
        lathe(profile).write(folder, "bottle_%d" % (k + 1), "A bottle")
    glass = [(0.040, 0.0), (0.042, 0.003), (0.031, 0.088), (0.028, 0.095), (0.0, 0.095)]
    lathe(glass).write(folder, "tumbler", "A glass, upside down")
    for k, mesh in enumerate(planks()):
        mesh.write(folder, "planks_%d" % (k + 1), "Some boards of a floor")
    panel().write(folder, "panel", "A wainscot panel")
    door().write(folder, "door", "A door")
    frame().write(folder, "frame", "The frame of a picture")
    seat = [(0.0, 0.690), (0.165, 0.690), (0.178, 0.697)] + arc(0.160, 0.725, 0.030, -70, 80, 6) + \
           [(0.120, 0.762), (0.060, 0.766), (0.0, 0.767)]
    lathe(seat, 32).write(folder, "stool_seat", "The seat of a bar stool")
    foot = [(0.215, 0.0), (0.215, 0.008), (0.19, 0.018), (0.10, 0.032), (0.030, 0.050), (0.026, 0.060), (0.026, 0.300),
            (0.030, 0.305), (0.030, 0.335), (0.026, 0.340), (0.026, 0.660), (0.060, 0.680), (0.100, 0.690)]
    lathe(foot, 24).write(folder, "stool_foot", "The foot of a bar stool")
    outside = [(0.200, 0.0), (0.202, 0.004), (0.196, 0.012), (0.150, 0.085), (0.095, 0.135), (0.050, 0.160), (0.036, 0.185),
               (0.036, 0.215), (0.0, 0.220)]
    lathe(outside, 40).write(folder, "enamel", "A lamp shade")
    inside = [(0.0, 0.150), (0.050, 0.147), (0.092, 0.130), (0.147, 0.082), (0.193, 0.011), (0.200, 0.0)]
    lathe(inside, 40).write(folder, "enamel_inside", "The inside of a lamp shade")
    bowl = [(0.0, 0.0)] + arc(0.0, 0.15, 0.15, -86, -4, 7) + [(0.150, 0.156), (0.143, 0.156)] + arc(0.0, 0.15, 0.143, -4, -86, 7)
    lathe(bowl, 20, 0.5).write(folder, "sconce", "A half bowl")


if __name__ == "__main__":
    main()
