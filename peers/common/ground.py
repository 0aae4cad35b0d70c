"""The ground of an export --to heights, and how far another one is from it."""

import json

import numpy


class Ground:
    """heights.npy as heights.json says that it lies."""

    def __init__(self, folder):
        self.heights = numpy.load(folder / "heights.npy")
        self.about = json.loads((folder / "heights.json").read_text())
        self.resolution = self.about["resolution"]
        self.west, self.north = self.about["origin"]
        self.width, self.depth = self.about["size"]

    def at(self, x, y):
        """Height [m] at a place of the frame map [m] between the outermost centres."""
        col, row = (x - self.west) / self.resolution, (self.north - y) / self.resolution
        c = min(int(col), self.heights.shape[1] - 2)
        r = min(int(row), self.heights.shape[0] - 2)
        u, v = col - c, row - r
        nw, ne = self.heights[r, c:c + 2].astype(float)
        sw, se = self.heights[r + 1, c:c + 2].astype(float)
        if u >= v:
            return nw + u * (ne - nw) + v * (se - ne)
        return nw + v * (sw - nw) + u * (se - sw)

    def places(self, count, centers=False, margin_m=0.0):
        """Places by chance; centers: of cells."""
        random = numpy.random.default_rng(1)
        if centers:
            rows = random.integers(0, self.heights.shape[0], count)
            cols = random.integers(0, self.heights.shape[1], count)
            return [(self.west + col * self.resolution, self.north - row * self.resolution)
                    for row, col in zip(rows.tolist(), cols.tolist())]
        return [(self.west + margin_m + (self.width - 2 * margin_m) * random.random(),
                 self.north - margin_m - (self.depth - 2 * margin_m) * random.random())
                for _ in range(count)]

    def check(self, peer, found, places, limit_m=1e-3):
        """Against the true heights and mirrored ones, so that a level world cannot pass."""
        found = numpy.asarray(found, dtype=float)
        rms = lambda errors: float(numpy.sqrt(numpy.mean(numpy.square(errors))))
        true = numpy.array([self.at(x, y) for x, y in places])
        west_east = [self.at(2 * self.west + self.width - x, y) for x, y in places]
        north_south = [self.at(x, 2 * self.north - self.depth - y) for x, y in places]
        worst = float(numpy.abs(found - true).max())
        others = rms(found - west_east), rms(found - north_south)
        peer.check(f"heights at {len(places)} places", worst < limit_m and min(others) > 0.1,
                   f"off {rms(found - true):.2g} m, at most {worst:.2g} m "
                   f"(mirrored {others[0]:.2g} m, {others[1]:.2g} m)")
