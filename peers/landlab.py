"""landlab takes an export --to heights and routes water over it."""
# pypi: landlab==2.11.0 requireit==0.8.0 numpy==2.4.6

import importlib.metadata

import landlab
import numpy
from landlab.components import FlowAccumulator, LakeMapperBarnes

from ground import Ground
from peer import Peer, export


def main():
    peer = Peer("landlab", importlib.metadata.version("landlab"), "`--to heights`",
                "turn the rows around: its nodes begin in the south-west. Python 3.11 needs "
                "`requireit==0.8.0`: 0.9.0, which pip takes, has the syntax of 3.12")
    ground = Ground(export("heights", "heights"))
    h = ground.heights.astype(float)
    res = ground.resolution
    grid = landlab.RasterModelGrid(h.shape, xy_spacing=res, xy_of_lower_left=(
        ground.west, ground.north - ground.depth))
    z = grid.add_field("topographic__elevation", h[::-1].ravel().copy(), at="node")
    places = ground.places(1000, centers=True)
    nodes = grid.find_nearest_node(tuple(numpy.array(places).T))
    ground.check(peer, z[nodes], places)
    FlowAccumulator(grid, flow_director="FlowDirectorD8").run_one_step()
    area = grid.at_node["drainage_area"]
    outlets = area[grid.status_at_node != 0].sum()
    interior = grid.number_of_core_nodes * res * res
    peer.check("water over the ground as it is", outlets <= interior * 1.000001,
               f"{outlets / interior:.3f} of the land drains to the border, the rest into hollows")
    steepest = numpy.rad2deg(numpy.arctan(grid.calc_slope_at_node().max()))
    peer.check("steepest slope", steepest < 90, f"{steepest:.1f} degrees")
    peer.finish()


main()
