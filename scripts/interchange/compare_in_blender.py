# blender -b --python compare_in_blender.py -- F.glb F.csv: compares the pose of every object in F.csv with Blender's, frame by
# frame.
import csv
import sys

import numpy

numpy.bool = bool  # Debian 12's importer is older than its numpy
import bpy
from mathutils import Quaternion, Vector

glb, table = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=glb)
scene = bpy.context.scene
assert scene.render.fps == 24
rows = {}
with open(table) as lines:
    for row in csv.DictReader(lines):
        rows.setdefault(round(float(row["time"]) * 24), []).append(row)
first_turns = {}
farthest = most_turned = 0.0
for frame, objects in sorted(rows.items()):
    scene.frame_set(frame)
    for row in objects:
        matrix = bpy.data.objects[row["object"]].matrix_world
        place = Vector([float(row[axis]) for axis in "xyz"])
        farthest = max(farthest, (matrix.translation - place).length)
        turn = Quaternion([float(row["q" + part]) for part in "wxyz"])
        angle = matrix.to_quaternion().rotation_difference(turn).angle
        most_turned = max(most_turned, min(angle, 6.283185307 - angle))
# The linear keys are accurate to 0.05 mm and 2 mrad, Blender's interpolation to another 1.4 mrad; rounding of times to single
# precision adds a little for fast objects.
assert farthest < 1.5e-4, f"{farthest} m off"
assert most_turned < 4e-3, f"{most_turned} rad off"
assert any(o.type == "CAMERA" for o in scene.objects)
print(f"compared {len(rows)} frames of {len(objects)} objects: within {1000 * farthest:.3f} mm and {most_turned:.5f} rad")
