"""laspy and plyfile read exports --to las and ply of the same points."""
# pypi: laspy==2.7.0 plyfile==1.1.5 pyproj==3.7.2 numpy==2.4.6

import laspy
import numpy
import plyfile
import pyproj

from ground import Ground
from peer import Peer, export


def main():
    peer = Peer("laspy", laspy.__version__, "`--to las`, compared with plyfile's `--to ply`")
    las = laspy.read(export("las", "points.las"))
    ply = plyfile.PlyData.read(str(export("ply", "points.ply")))["vertex"]
    off = max(numpy.abs(numpy.asarray(getattr(las, axis)) - ply[axis]).max() for axis in "xyz")
    peer.check("points", len(las.points) == ply.count and off < 6e-4,
               f"{len(las.points)} in both, off by {off:.1g} m at most")
    numbers, counts = numpy.unique(numpy.asarray(las.classification), return_counts=True)
    peer.check("classes", 2 in numbers, dict(zip(numbers.tolist(), counts.tolist())))
    truth = Ground(export("heights", "heights"))
    half = numpy.array([truth.width, truth.depth]) / 2
    ground = las.xyz[(numpy.asarray(las.classification) == 2)
                     & (numpy.abs(las.xyz[:, :2]) < half).all(axis=1)][::37][:1000]
    truth.check(peer, ground[:, 2], ground[:, :2].tolist(), limit_m=0.01)
    system = las.header.parse_crs()
    where = pyproj.Transformer.from_crs(system, "EPSG:4326").transform(0.0, 0.0)
    earth = truth.about["earth"]
    off = max(abs(where[0] - earth["latitude_deg"]), abs(where[1] - earth["longitude_deg"]))
    peer.check("place on the earth", off < 1e-8, f"{where[0]:.6f}, {where[1]:.6f}")
    peer.finish()


main()
