# blender -b --python channels_in_blender.py -- F.exr: checks that Blender's compositor has an output for every layer of the
# frame, with the values of the file. F.exr must have depth, normal, albedo, roughness, motion, object_id, material_id, variance and
# cryptomatte_object.
import os
import sys
import tempfile

import numpy

numpy.bool = bool  # as in compare_in_blender.py
import bpy

path = sys.argv[sys.argv.index("--") + 1]
bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
scene.view_settings.view_transform = "Raw"
scene.use_nodes = True
nodes = scene.node_tree.nodes
nodes.clear()
source = nodes.new("CompositorNodeImage")
source.image = bpy.data.images.load(path)
assert source.image.type == "MULTILAYER", source.image.type
outputs = [socket.name for socket in source.outputs if socket.enabled]
expected = ["Combined", "Depth", "N", "albedo", "roughness", "motion", "object_id", "material_id", "variance"]
expected += [f"CryptoObject0{rank}" for rank in range(3)]
missing = [name for name in expected if name not in outputs]
assert not missing, f"no {', '.join(missing)} among {', '.join(outputs)}"

# Blender's values of one layer, written to a separate picture.
folder = tempfile.mkdtemp()
written = nodes.new("CompositorNodeOutputFile")
written.base_path = folder
written.format.file_format = "OPEN_EXR"
written.format.color_depth = "32"
written.file_slots.clear()
for name in ("object_id", "material_id", "variance"):
    written.file_slots.new(name)
    scene.node_tree.links.new(source.outputs[name], written.inputs[name])
nodes.new("CompositorNodeComposite")
scene.camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
scene.collection.objects.link(scene.camera)
scene.render.filepath = os.path.join(folder, "whole")
bpy.ops.render.render(write_still=False)


def layer(name):
    file = next(f for f in os.listdir(folder) if f.startswith(name))
    image = bpy.data.images.load(os.path.join(folder, file))
    image.colorspace_settings.name = "Raw"
    return numpy.array(image.pixels[:])[:: image.channels]


ids = layer("object_id")
assert (ids == numpy.round(ids)).all() and ids.max() >= 2, "ids are whole numbers of several objects"
materials = layer("material_id")
assert (materials == numpy.round(materials)).all() and materials.max() >= 1
assert layer("variance").max() > 0
print(f"Blender {bpy.app.version_string}: {len(outputs)} layers, among them {', '.join(expected)}; {int(ids.max())} is the highest object_id")
