"""Places that a robot can get to on a map."""

from collections import deque

import numpy as np


class FreeSpace:
    """The free cells of a nav_msgs/OccupancyGrid that are clearance_m away from all others.

    The outermost cells count as not free, as planners (navfn, global_planner) take them.
    """

    OCCUPIED = 50  # of 100; unknown is -1
    NEAR = 4  # cells around a robot that lead on in any case

    def __init__(self, grid, clearance_m):
        info = grid.info
        self._cell_m = info.resolution
        self._origin = np.array([info.origin.position.x, info.origin.position.y])
        data = np.asarray(grid.data, dtype=np.int8).reshape(info.height, info.width)
        free = (data >= 0) & (data < self.OCCUPIED)
        free[[0, -1], :] = free[:, [0, -1]] = False
        self._free = _shrunk(free, int(np.ceil(clearance_m / self._cell_m)))

    def draw(self, x_m, y_m, least_m, most_m, rng):
        """A free place so far from (x, y), linked with it by free cells within twice that; (x, y) [m].

        Where there is none as far away, it is the farthest that there is, of equally far ones the
        most southern, then the most western one; where none is free at all, the cell of (x, y).
        rng: numpy Generator.
        """
        row, column = self._cell_of(x_m, y_m)
        reachable = self._reachable(row, column, int(np.ceil(2.0 * most_m / self._cell_m)))
        # What is let in around the robot leads on, and is no goal.
        cells = reachable[self._free[reachable[:, 0], reachable[:, 1]]]
        if len(cells) == 0:
            cells = np.array([(row, column)])
        places = self._origin + (cells[:, ::-1] + 0.5) * self._cell_m
        distances_m = np.hypot(places[:, 0] - x_m, places[:, 1] - y_m)
        legal = np.flatnonzero((distances_m >= least_m) & (distances_m <= most_m))
        if legal.size > 0:
            chosen = legal[rng.integers(legal.size)]
        else:
            chosen = int(np.argmax(np.where(distances_m <= most_m, distances_m, -1.0)))
        return float(places[chosen, 0]), float(places[chosen, 1])

    def _cell_of(self, x_m, y_m):
        column, row = np.floor((np.array([x_m, y_m]) - self._origin) / self._cell_m).astype(int)
        rows, columns = self._free.shape
        return int(np.clip(row, 0, rows - 1)), int(np.clip(column, 0, columns - 1))

    def _reachable(self, row, column, reach):
        """Cells (row, column), sorted, linked with that one by sides; it counts as free itself.
        (n, 2) integers."""
        rows, columns = self._free.shape
        low_row, high_row = max(0, row - reach), min(rows, row + reach + 1)
        low_column, high_column = max(0, column - reach), min(columns, column + reach + 1)
        # The robot may stand nearer to something than the clearance: its surroundings are let in.
        seen = {(row, column)}
        waiting = deque(seen)
        near = self.NEAR
        while waiting:
            r, c = waiting.popleft()
            for next_cell in ((r - 1, c), (r + 1, c), (r, c - 1), (r, c + 1)):
                if next_cell in seen:
                    continue
                if not (low_row <= next_cell[0] < high_row
                        and low_column <= next_cell[1] < high_column):
                    continue
                is_near = abs(next_cell[0] - row) <= near and abs(next_cell[1] - column) <= near
                if self._free[next_cell] or is_near:
                    seen.add(next_cell)
                    waiting.append(next_cell)
        return np.array(sorted(seen))


def _shrunk(free, cells):
    """True where all cells of a square of that half width are free; beyond the edge none is."""
    for axis in (0, 1):
        shrunk = free.copy()
        for shift in range(1, cells + 1):
            for step in (shift, -shift):
                moved = np.zeros_like(free)
                source = [slice(None), slice(None)]
                target = [slice(None), slice(None)]
                source[axis] = slice(max(0, step), free.shape[axis] + min(0, step))
                target[axis] = slice(max(0, -step), free.shape[axis] + min(0, -step))
                moved[tuple(target)] = free[tuple(source)]
                shrunk &= moved
        free = shrunk
    return free
