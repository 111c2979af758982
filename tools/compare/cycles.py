# SPDX-License-Identifier: Apache-2.0
"""Renders a .glb with Cycles as Alidade renders it: blender -b --factory-startup --python-exit-code 1 --python cycles.py -- job.json

The job, written by cycles_reference.cpp, holds what glTF cannot: camera, sky, default sun, samples, seeds, depth. Its vectors are in glTF's axes.
"""
import json
import math
import os
import sys

import bpy
import mathutils
import numpy

numpy.bool = bool   # Blender 3.4's importer uses a name that numpy 1.24 has no longer


def blender_vector(v):
    return mathutils.Vector((v[0], -v[2], v[1]))


def put(owner, **values):
    """Sets those that this version of Blender has."""
    for name, value in values.items():
        if hasattr(owner, name):
            setattr(owner, name, value)


def add(data, name):
    thing = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(thing)
    return thing


def frame(x, y, z):
    """Columns are the axes."""
    return mathutils.Matrix([blender_vector(axis) for axis in (x, y, z)]).transposed().to_4x4()


def place_camera(job):
    camera = bpy.data.cameras.new("camera")
    thing = add(camera, "camera")
    thing.matrix_world = mathutils.Matrix.Translation(blender_vector(job["location"])) @ frame(job["right"], job["up"], job["back"])
    camera.sensor_fit = "HORIZONTAL"
    camera.clip_start, camera.clip_end = job["near"], 1e30
    camera.shift_x, camera.shift_y = job["shift"]
    if job["projection"] == "orthographic":
        camera.type, camera.ortho_scale = "ORTHO", job["width"]
    else:   # width: of the window at the distance 1. A larger sensor with a longer lens sees the same.
        lens = max(36, 1000 * job["aperture"])
        camera.lens, camera.sensor_width = lens, lens * job["width"]
    if job["aperture"] > 0:
        camera.dof.use_dof, camera.dof.focus_distance = True, job["focus"]
        camera.dof.aperture_fstop = camera.lens / (1000 * job["aperture"])
    return thing


def light_by_sky(job, folder):
    """What a ray meets that leaves the scene; it lights surfaces only if the job says so."""
    world = bpy.data.worlds.new("world")
    bpy.context.scene.world = world
    world.use_nodes = True
    background = world.node_tree.nodes["Background"]
    background.inputs["Strength"].default_value = 1
    if "picture" in job:
        picture = world.node_tree.nodes.new("ShaderNodeTexEnvironment")
        picture.image = bpy.data.images.load(os.path.join(folder, job["picture"]))
        picture.interpolation = "Closest"
        world.node_tree.links.new(picture.outputs["Color"], background.inputs["Color"])
    else:
        background.inputs["Color"].default_value = [*job["color"], 1]
    world.cycles_visibility.diffuse = job["lights"]


def light_by_suns(suns):
    for sun in suns:
        light = bpy.data.lights.new("sun", "SUN")
        light.energy, light.color = 1, sun["irradiance"]
        add(light, "sun").rotation_euler = blender_vector(sun["direction"]).to_track_quat("-Z", "Y").to_euler()


def soften_edge(spot):
    """KHR_lights_punctual's law between the two angles. Blender's has a smooth edge of another kind, which is set to none, and dims by the cosine of the
    angle from the axis, which is taken out."""
    outer = math.cos(spot.spot_size / 2)
    inner = max(math.cos(spot.spot_size / 2 * (1 - spot.spot_blend)), outer + 1e-6)
    spot.spot_blend, spot.use_nodes = 0, True
    nodes, links = spot.node_tree.nodes, spot.node_tree.links
    place, split, scale, square, cosine = (nodes.new("ShaderNode" + kind) for kind in ("TexCoord", "SeparateXYZ", "MapRange", "Math", "Math"))
    scale.inputs["From Min"].default_value, scale.inputs["From Max"].default_value = -outer, -inner
    square.operation, cosine.operation = "MULTIPLY", "DIVIDE"
    links.new(place.outputs["Normal"], split.inputs[0])   # of a light: the direction of its ray, in its space
    links.new(split.outputs["Z"], scale.inputs["Value"])
    for socket in square.inputs[:2]:
        links.new(scale.outputs[0], socket)
    links.new(square.outputs[0], cosine.inputs[0])
    links.new(split.outputs["Z"], cosine.inputs[1])
    turned = nodes.new("ShaderNodeMath")   # the axis is -Z
    turned.operation = "MULTIPLY"
    turned.inputs[1].default_value = -1
    links.new(cosine.outputs[0], turned.inputs[0])
    links.new(turned.outputs[0], nodes["Emission"].inputs["Strength"])


def correct_lights():
    """The importer leaves Blender's default sizes; glTF's lights have none."""
    for light in bpy.data.lights:
        put(light, shadow_soft_size=0, angle=0)
        put(light.cycles, max_bounces=1024, use_multiple_importance_sampling=False)
        if light.type == "SPOT":
            soften_edge(light)


def copied_node(tree, node):
    copy = tree.nodes.new(node.bl_idname)
    for of, to in zip(node.inputs, copy.inputs):
        to.default_value = of.default_value
        for link in of.links:
            tree.links.new(link.from_socket, to)
    return copy


def feed(tree, socket, source):
    """A socket or a number into a socket."""
    if isinstance(source, bpy.types.NodeSocket):
        tree.links.new(source, socket)
    else:
        socket.default_value = source


def product(tree, first, *factors):
    """A colour times numbers; each is a socket or a value."""
    for factor in factors:
        scale = tree.nodes.new("ShaderNodeVectorMath")
        scale.operation = "SCALE"
        feed(tree, scale.inputs["Vector"], first[:3] if not isinstance(first, bpy.types.NodeSocket) else first)
        feed(tree, scale.inputs["Scale"], factor)
        first = scale.outputs["Vector"]
    return first


def source_of(socket):
    return socket.links[0].from_socket if socket.links else socket.default_value


def use_lambert(tree, shader):
    """glTF mixes metals with dielectrics that scatter by Lambert's law what is not reflected. Blender's shader scatters by Burley's law, whatever is
    reflected: its diffuse part is replaced."""
    inputs = shader.inputs
    metallic, transmission, specular = (source_of(inputs[name]) for name in ("Metallic", "Transmission", "Specular"))
    if metallic == 1.0 or transmission != 0.0:
        return
    reflected = 0.08 * (specular if isinstance(specular, float) else 0.5)   # at the normal
    diffuse, both, mixed = (tree.nodes.new("ShaderNode" + kind) for kind in ("BsdfDiffuse", "AddShader", "MixShader"))
    feed(tree, diffuse.inputs["Color"], product(tree, source_of(inputs["Base Color"]), 1 - reflected, source_of(inputs["Alpha"])))
    for link in inputs["Normal"].links:
        tree.links.new(link.from_socket, diffuse.inputs["Normal"])
    dielectric = copied_node(tree, shader)
    for metal, kind in ((0, dielectric), (1, shader)):
        for link in kind.inputs["Metallic"].links:
            tree.links.remove(link)
        kind.inputs["Metallic"].default_value = metal
    for link in dielectric.inputs["Base Color"].links:
        tree.links.remove(link)
    dielectric.inputs["Base Color"].default_value = (0, 0, 0, 1)
    for link in shader.outputs["BSDF"].links:
        tree.links.new(mixed.outputs[0], link.to_socket)
    feed(tree, mixed.inputs[0], metallic)
    for node, socket in ((diffuse, both.inputs[0]), (dielectric, both.inputs[1]), (both, mixed.inputs[1]), (shader, mixed.inputs[2])):
        tree.links.new(node.outputs[0], socket)


def hide_emission_from_diffuse(tree, shader):
    """Surfaces that emit are seen, in mirrors too, and light nothing."""
    strength = shader.inputs["Emission Strength"]
    path, rest = tree.nodes.new("ShaderNodeLightPath"), tree.nodes.new("ShaderNodeMath")
    rest.operation = "MULTIPLY_ADD"   # -strength * is diffuse + strength
    rest.inputs[0].default_value, rest.inputs[2].default_value = -strength.default_value, strength.default_value
    tree.links.new(path.outputs["Is Diffuse Ray"], rest.inputs[1])
    tree.links.new(rest.outputs[0], strength)


def correct_materials():
    def shaders(tree):
        return [node for node in tree.nodes if node.type == "BSDF_PRINCIPLED"]

    for material in bpy.data.materials:
        put(material.cycles, sample_as_light=False)
        put(material.cycles, emission_sampling="NONE")
        if not material.use_nodes:
            continue
        for shader in shaders(material.node_tree):
            use_lambert(material.node_tree, shader)
        for shader in shaders(material.node_tree):
            hide_emission_from_diffuse(material.node_tree, shader)


def set_up_render(job):
    """One thread, direct light, mirrors and glass to a depth, all samples of a pixel from the pixel itself; linear floats."""
    scene = bpy.context.scene
    render, cycles = scene.render, scene.cycles
    render.engine = "CYCLES"
    render.resolution_x, render.resolution_y, render.resolution_percentage = job["width"], job["height"], 100
    stretched = job["camera"]["aspect"] * job["width"] / job["height"]
    render.pixel_aspect_x, render.pixel_aspect_y = max(1, 1 / stretched), max(1, stretched)
    put(render, threads_mode="FIXED", threads=1, use_persistent_data=True, film_transparent=False, use_border=False, use_file_extension=False)
    put(render.image_settings, file_format="OPEN_EXR", color_mode="RGB", color_depth="32", exr_codec="ZIP")
    put(scene, frame_start=0, frame_end=0)
    put(cycles, device="CPU", samples=job["samples"], use_adaptive_sampling=False, use_denoising=False, pixel_filter_type="BOX", film_exposure=1,
        use_auto_tile=False, light_sampling_threshold=0, sample_clamp_direct=0, sample_clamp_indirect=0, blur_glossy=0, use_fast_gi=False)
    depth = job["depth"]
    put(cycles, max_bounces=depth, diffuse_bounces=0, glossy_bounces=depth, transmission_bounces=depth, volume_bounces=0, transparent_max_bounces=256,
        min_light_bounces=depth, min_transparent_bounces=256, caustics_reflective=False, caustics_refractive=False)


def main():
    with open(sys.argv[-1], encoding="utf-8") as file:
        job = json.load(file)
    folder = os.path.dirname(os.path.abspath(sys.argv[-1]))
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=os.path.join(folder, job["scene"]), import_shading="NORMALS", merge_vertices=False)
    light_by_suns(job["suns"])
    correct_lights()
    correct_materials()
    light_by_sky(job["sky"], folder)
    set_up_render(job)
    bpy.context.scene.camera = place_camera(job["camera"])
    for seed, picture in enumerate(job["pictures"]):
        bpy.context.scene.cycles.seed = seed
        bpy.context.scene.render.filepath = os.path.join(folder, picture)
        bpy.ops.render.render(write_still=True)


try:
    main()
except Exception as wrong:   # the line that a user sees; Blender's own errors end with what matters
    print("error:", type(wrong).__name__, (str(wrong).strip().splitlines() or [""])[-1], flush=True)
    raise
