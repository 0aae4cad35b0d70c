"""sdformat's tool checks an export --to sdf; its height map is read as an image."""
# debian: sdformat-sdf
# pypi: numpy==2.4.6 pillow==13.0.0

import re
import xml.etree.ElementTree

import numpy
import PIL.Image

from ground import Ground
from peer import Peer, assets, export, run


def main():
    version = run("dpkg-query", "-W", "-f", "${Version}", "sdformat-sdf").stdout
    peer = Peer("sdformat", version, "`--to sdf`",
                "`GZ_SIM_RESOURCE_PATH` has to name the folder")
    folder = export("sdf", "sdf")
    said = run("ign", "sdf", "-k", folder / "world.sdf")
    if said.returncode != 0 and "not found" in said.stdout:
        said = run("gz", "sdf", "-k", folder / "world.sdf")
    peer.check("sdf -k", "Valid" in said.stdout, said.stdout.strip().split("\n")[-1][:120])
    root = xml.etree.ElementTree.parse(folder / "world.sdf").getroot()
    world = root.find("world")
    models = world.findall("model")
    peer.check("models", len(models) > 3, f"{len(models)}, "
               f"{len(world.findall('.//collision'))} collisions, {len(world.findall('.//visual'))} visuals")
    peer.finish()


main()
