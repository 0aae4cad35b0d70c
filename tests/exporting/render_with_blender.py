"""Imports a GLB into Blender and renders a picture of it from the south, above.

Run by Blender: blender --background --factory-startup --python-exit-code 1
    --python render_with_blender.py -- IN.glb OUT.jpg [WIDTH [SAMPLES [AZIMUTH_DEG ELEVATION_DEG]]]
Prints "blender: N meshes, M objects, E x N x U m" (extents east, north, up) before it renders.
"""

import math
import sys

import bpy
import numpy
from mathutils import Vector

# The importer of Blender 3.4 names a type that numpy dropped in 1.24; Debian 12 has both.
if "bool" not in vars(numpy):
    numpy.bool = bool

SUN_STRENGTH = 4.0
SKY = (0.55, 0.70, 0.90, 1.0)


def bounds(objects):
    """Corners (low, high) of the box around what objects' own boxes cover."""
    corners = [o.matrix_world @ Vector(c) for o in objects for c in o.bound_box]
    return (Vector(min(c[i] for c in corners) for i in range(3)),
            Vector(max(c[i] for c in corners) for i in range(3)))


def main():
    arguments = sys.argv[sys.argv.index("--") + 1:]
    path, picture = arguments[0], arguments[1]
    width = int(arguments[2]) if len(arguments) > 2 else 640
    samples = int(arguments[3]) if len(arguments) > 3 else 8
    azimuth = math.radians(float(arguments[4]) if len(arguments) > 4 else -90.0)
    elevation = math.radians(float(arguments[5]) if len(arguments) > 5 else 35.0)

    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=path)
    scene = bpy.context.scene
    things = [o for o in scene.objects if o.type == "MESH"]
    low, high = bounds(things)
    size = high - low
    print("blender: %d meshes, %d objects, %.3f x %.3f x %.3f m"
          % (len({o.data.name for o in things}), len(things), size.x, size.y, size.z))

    for light in (o for o in scene.objects if o.type == "LIGHT"):
        light.data.energy = SUN_STRENGTH
        light.data.angle = math.radians(0.5)
    world = bpy.data.worlds.new("sky")
    world.use_nodes = True
    world.node_tree.nodes["Background"].inputs["Color"].default_value = SKY
    world.node_tree.nodes["Background"].inputs["Strength"].default_value = 0.9
    scene.world = world

    ground = scene.objects.get("ground") or things[0]
    low, high = bounds([ground])
    middle = (low + high) / 2
    reach = max((high - low).x, (high - low).y)
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    camera.data.angle = math.radians(40.0)
    camera.data.clip_end = 10.0 * reach
    towards = Vector((math.cos(azimuth) * math.cos(elevation),
                      math.sin(azimuth) * math.cos(elevation), math.sin(elevation)))
    camera.location = middle + towards * 1.55 * reach
    camera.rotation_euler = (-towards).to_track_quat("-Z", "Y").to_euler()
    scene.collection.objects.link(camera)
    scene.camera = camera

    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = samples
    scene.cycles.use_denoising = False
    scene.cycles.max_bounces = 3
    scene.cycles.seed = 1
    scene.render.threads_mode = "FIXED"
    scene.render.threads = 1
    scene.view_settings.view_transform = "Standard"
    scene.render.resolution_x = width
    scene.render.resolution_y = width * 2 // 3
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "JPEG"
    scene.render.image_settings.quality = 85
    scene.render.filepath = picture
    bpy.ops.render.render(write_still=True)


main()
