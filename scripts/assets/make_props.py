#!/usr/bin/env python3
"""Makes configs/props/*.obj: things that lie or hang about a billiard table, in metres, Z up.

  chalk_block     a cube of chalk, worn hollow on top; its origin is the middle of its underside
  lamp_shade      a long trough over a lamp of 1.7 m by 0.42 m; its origin is the middle of its opening
  stick_*         a cue stick's four parts along +x from the tip's end, which is the origin

Only the Python standard library; the same files every time.
"""
import math
import os
import sys


class Mesh:
    def __init__(self):
        self.lines, self.faces, self.count = [], [], 0

    def vertex(self, place, normal):
        length = math.sqrt(sum(n * n for n in normal))
        self.lines.append("v %.6g %.6g %.6g" % tuple(round(p, 7) + 0.0 for p in place))
        self.lines.append("vn %.4g %.4g %.4g" % tuple(round(n / length, 4) + 0.0 for n in normal))
        self.count += 1
        return self.count

    def quad(self, a, b, c, d):
        for face in ((a, b, c), (a, c, d)):
            if len(set(face)) == 3:
                self.faces.append("f " + " ".join("%d//%d" % (i, i) for i in face))

    def grid(self, rows, columns, point):
        """`point` of row and column: position and normal; faces are oriented towards (row x column)."""
        index = [[self.vertex(*point(i, j)) for j in range(columns + 1)] for i in range(rows + 1)]
        for i in range(rows):
            for j in range(columns):
                self.quad(index[i][j], index[i + 1][j], index[i + 1][j + 1], index[i][j + 1])

    def write(self, folder, name, what):
        with open(os.path.join(folder, name + ".obj"), "w") as file:
            file.write("# %s; made by scripts/assets/make_props.py\n" % what)
            file.write("\n".join(self.lines + self.faces) + "\n")


def chalk_block(edge=0.0215, radius=0.0016, steps=10):
    """A cube with rounded edges; its top is worn hollow, deepest in the middle."""
    mesh, half = Mesh(), edge / 2

    def hollow(x, y):
        return 0.0042 * math.exp(-(x * x + y * y) / (0.0062 * 0.0062))

    def at(axis, side, i, j):
        u, v = (math.tan((2.0 * k / steps - 1) * 0.25 * math.pi) for k in (i, j))
        cube = [0.0, 0.0, 0.0]
        cube[axis], cube[(axis + 1) % 3], cube[(axis + 2) % 3] = side * half, u * half, v * half
        core = [max(-half + radius, min(half - radius, c)) for c in cube]
        out = [c - k for c, k in zip(cube, core)]
        length = math.sqrt(sum(o * o for o in out))
        normal = [o / length for o in out]
        place = [k + radius * n for k, n in zip(core, normal)]
        if axis == 2 and side > 0:
            x, y = place[0], place[1]
            depth = hollow(x, y)
            place[2] -= depth
            slope = 2 * depth / (0.0062 * 0.0062)
            normal = [normal[0] - slope * x, normal[1] - slope * y, normal[2]]
        return [place[0], place[1], place[2] + half], normal

    for axis in range(3):
        for side in (1, -1):
            mesh.grid(steps, steps, (lambda i, j: at(axis, side, i, j)) if side > 0 else (lambda i, j: at(axis, side, j, i)))
    return mesh


def lamp_shade(length=1.7, width=0.42, height=0.15, slope=0.07, margin=0.05, wall=0.004):
    """Four sloping walls and a lid, each double-sided."""
    mesh = Mesh()

    def skin(inset, turned):
        lx, ly = length / 2 + margin - inset, width / 2 + margin - inset
        low = [(-lx, -ly), (lx, -ly), (lx, ly), (-lx, ly)]
        high = [(x - math.copysign(slope, x), y - math.copysign(slope, y)) for x, y in low]
        top = height - inset
        for k in range(4):
            (ax, ay), (bx, by) = low[k], low[(k + 1) % 4]
            (cx, cy), (dx, dy) = high[(k + 1) % 4], high[k]
            normal = [by - ay, ax - bx, 0.0]
            size = math.hypot(normal[0], normal[1])
            normal = [normal[0] / size * height, normal[1] / size * height, slope]
            sign = -1 if turned else 1
            corners = [(ax, ay, 0.0), (bx, by, 0.0), (cx, cy, top), (dx, dy, top)]
            v = [mesh.vertex(c, [sign * n for n in normal]) for c in corners]
            mesh.quad(*(reversed(v) if turned else v))
        v = [mesh.vertex((x, y, top), (0, 0, -1 if turned else 1)) for x, y in high]
        mesh.quad(*(reversed(v) if turned else v))
        return low

    outer, inner = skin(0.0, False), skin(wall, True)
    for k in range(4):  # the rim
        ring = [outer[k], inner[k], inner[(k + 1) % 4], outer[(k + 1) % 4]]
        mesh.quad(*[mesh.vertex((x, y, 0.0), (0, 0, -1)) for x, y in ring])
    return mesh


def lathe(profile, around=28):
    """`profile`: (x, radius) from the tip on; a repeated x gives a sharp edge between two rows."""
    mesh = Mesh()
    rows, start = [], 0
    for k in range(1, len(profile) + 1):
        if k == len(profile) or (profile[k] == profile[k - 1]):
            rows.append(profile[start:k])
            start = k
    for part in rows:
        def point(i, j):
            before, behind = part[max(0, i - 1)], part[min(len(part) - 1, i + 1)]
            along, out = behind[0] - before[0], behind[1] - before[1]
            angle = 2 * math.pi * j / around
            x, r = part[i]
            return ((x, r * math.cos(angle), r * math.sin(angle)),
                    (-out, along * math.cos(angle), along * math.sin(angle)))
        mesh.grid(len(part) - 1, around, lambda i, j: point(i, around - j))
    return mesh


def stick_parts():
    dome = [(0.0062 * (1 - math.cos(a)) * 0.55, max(1e-5, 0.0062 * math.sin(a)))
            for a in (math.radians(90.0 * k / 8) for k in range(9))]
    tip = dome + [dome[-1], (0.0068, 0.00625)]
    ferrule = [(0.0068, 0.00632), (0.0318, 0.00635)]
    shaft = [(0.0318 + 0.70 * k / 10, 0.00632 + 0.0041 * (k / 10.0) ** 1.4) for k in range(11)]
    butt = [(0.7318 + 0.73 * k / 8, 0.01045 + 0.0042 * (k / 8.0)) for k in range(9)]
    butt += [butt[-1], (1.466, 0.0135), (1.47, 0.0115), (1.47, 0.0115), (1.47, 1e-5)]
    return {"stick_tip": (tip, "a cue stick's tip"), "stick_ferrule": (ferrule, "its ferrule"),
            "stick_shaft": (shaft, "its shaft"), "stick_butt": (butt, "its butt")}


def main(folder):
    chalk_block().write(folder, "chalk_block", "a cube of chalk")
    lamp_shade().write(folder, "lamp_shade", "a long lamp's shade")
    for name, (profile, what) in stick_parts().items():
        lathe(profile).write(folder, name, what)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "configs/props")
