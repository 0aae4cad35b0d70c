"""Drake parses exports --to sdf and --to mjcf."""
# pypi: drake==1.51.1 numpy==2.4.6

import importlib.metadata

from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import MultibodyPlant
from pydrake.geometry import SceneGraph, Role

from peer import Peer, export


def main():
    peer = Peer("Drake", importlib.metadata.version("drake"), "`--to sdf`, `--to mjcf`",
                "it knows no height fields: what collides stands, the ground is not there, and the "
                "log says so. `latticeworld_media` has to be added to its package map")
    for form, path in (("sdf", export("sdf", "sdf") / "world.sdf"),
                       ("mjcf", export("mjcf", "mjcf") / "world.xml")):
        plant, scene = MultibodyPlant(0.002), SceneGraph()
        plant.RegisterAsSourceForSceneGraph(scene)
        parser = Parser(plant)
        if form == "sdf":
            parser.package_map().Add("latticeworld_media", str(path.parent / "latticeworld_media"))
        try:
            parser.AddModels(str(path))
        except RuntimeError as error:
            peer.check(form, False, str(error)[:300])
            continue
        plant.Finalize()
        inspector = scene.model_inspector()
        peer.check(form, inspector.NumGeometriesWithRole(Role.kProximity) > 60, f"{plant.num_bodies()} bodies, "
                   f"{inspector.NumGeometriesWithRole(Role.kProximity)} collide, "
                   f"{inspector.NumGeometriesWithRole(Role.kPerception)} are seen")
    peer.finish()


main()
