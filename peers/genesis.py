"""Genesis takes an export --to heights as docs/exports.md shows it, on a CPU; it needs minutes."""
# pypi: genesis-world==1.4.5 torch==2.15.0 numpy==2.4.6

import importlib.metadata

import genesis

from ground import Ground
from peer import Peer, export


def main():
    region = "--region=-16,-16,16,16"
    peer = Peer("Genesis", importlib.metadata.version("genesis-world"), f"`--to heights {region}`",
                "x first, `pos` the south-western value, `vertical_scale=1.0`; a `--region`, as it "
                "makes a signed distance field of the land (minutes)")
    ground = Ground(export("heights", "heights_small", region))
    genesis.init(backend=genesis.cpu, logging_level="error")
    scene = genesis.Scene(show_viewer=False)
    scene.add_entity(genesis.morphs.Terrain(
        height_field=ground.heights[::-1].T.copy(), horizontal_scale=ground.resolution,
        vertical_scale=1.0, pos=(ground.west, ground.north - ground.depth, 0.0)))
    balls = [scene.add_entity(genesis.morphs.Sphere(radius=0.2, pos=(x, y, ground.at(x, y) + 0.4)))
             for x, y in ground.places(5, margin_m=6)]
    scene.build()
    for _ in range(100):
        scene.step()
    places = [ball.get_pos().numpy().ravel().tolist() for ball in balls]
    off = [z - 0.2 - ground.at(x, y) for x, y, z in places]
    mirrored = [abs(z - 0.2 - ground.at(x, -y)) for x, y, z in places]
    peer.check("five balls after 1 s", max(map(abs, off)) < 0.05 and max(mirrored) > 0.05,
               f"{min(off):.3f} to {max(off):.3f} m above the ground (mirrored {max(mirrored):.2g} m)")
    peer.finish()


main()
