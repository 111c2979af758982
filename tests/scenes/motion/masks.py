# SPDX-License-Identifier: Apache-2.0
"""Renders which part of each pixel shows an object of assets/scenes/motion.glb, with Blender's Cycles, at three times.

    blender -b --factory-startup -P tests/scenes/motion/masks.py -- assets/scenes/motion.glb tests/scenes/motion

Writes mask_0.40.png, mask_1.10.png, mask_1.80.png: gray is coverage. Made with Blender 3.4.1; the tests compare them with pictures of the renderer.
"""
import sys

import bpy
import numpy

numpy.bool = bool   # Blender 3.4's glTF importer is older than numpy 1.24
source, folder = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=source)
scene = bpy.context.scene
scene.camera = next(o for o in scene.objects if o.type == "CAMERA")
scene.render.engine = "CYCLES"
scene.cycles.samples = 64
scene.cycles.use_denoising = scene.cycles.use_adaptive_sampling = False
scene.cycles.pixel_filter_type = "BOX"
scene.cycles.max_bounces = 0
scene.render.film_transparent = True
scene.render.dither_intensity = 0
scene.render.resolution_x, scene.render.resolution_y = 320, 240
scene.render.image_settings.file_format = "PNG"
scene.render.image_settings.color_mode = "BW"
scene.render.image_settings.compression = 100
scene.view_settings.view_transform = "Raw"
# The picture is the alpha channel.
scene.use_nodes = True
tree = scene.node_tree
tree.nodes.clear()
layers, out = tree.nodes.new("CompositorNodeRLayers"), tree.nodes.new("CompositorNodeComposite")
tree.links.new(layers.outputs["Alpha"], out.inputs["Image"])
for time in (0.4, 1.1, 1.8):
    frame = time * scene.render.fps / scene.render.fps_base
    scene.frame_set(int(frame), subframe=frame - int(frame))
    scene.render.filepath = f"{folder}/mask_{time:.2f}.png"
    bpy.ops.render.render(write_still=True)
