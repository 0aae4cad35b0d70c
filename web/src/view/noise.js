// Tileable noise for the textures that the page draws itself.

/** A number in [0, 1) of whole numbers; the same everywhere. */
export function hash(x, y, seed) {
  let h = Math.imul(x, 374761393) ^ Math.imul(y, 668265263) ^ Math.imul(seed, 2246822519);
  h = Math.imul(h ^ (h >>> 13), 1274126177);
  return ((h ^ (h >>> 16)) >>> 0) / 4294967296;
}

/** Value noise in [0, 1) with period `period` in both directions (x, y in lattice units). */
export function tileNoise(x, y, period, seed) {
  const x0 = Math.floor(x);
  const y0 = Math.floor(y);
  const u = smooth(x - x0);
  const v = smooth(y - y0);
  const wrap = (k) => ((k % period) + period) % period;
  const at = (i, j) => hash(wrap(x0 + i), wrap(y0 + j), seed);
  const north = at(0, 0) + u * (at(1, 0) - at(0, 0));
  const south = at(0, 1) + u * (at(1, 1) - at(0, 1));
  return north + v * (south - north);
}

/** Sum of octaves, in [0, 1); u, v in [0, 1) over the tile. */
export function tileFbm(u, v, period, octaves, seed) {
  let sum = 0;
  let weight = 0.5;
  let total = 0;
  for (let octave = 0; octave < octaves; octave++, period *= 2, weight *= 0.5) {
    sum += weight * tileNoise(u * period, v * period, period, seed + octave);
    total += weight;
  }
  return sum / total;
}

/** Distance to the nearest of scattered points, in cells of the lattice; and that cell's number. */
export function tileCells(u, v, period, seed) {
  const x = u * period;
  const y = v * period;
  let nearest = 9;
  let second = 9;
  let cell = 0;
  for (let j = -1; j <= 1; j++) {
    for (let i = -1; i <= 1; i++) {
      const cx = Math.floor(x) + i;
      const cy = Math.floor(y) + j;
      const wx = ((cx % period) + period) % period;
      const wy = ((cy % period) + period) % period;
      const d = Math.hypot(cx + hash(wx, wy, seed) - x, cy + hash(wx, wy, seed + 1) - y);
      if (d < nearest) {
        second = nearest;
        nearest = d;
        cell = hash(wx, wy, seed + 2);
      } else if (d < second) {
        second = d;
      }
    }
  }
  return { nearest, edge: second - nearest, cell };
}

function smooth(t) {
  return t * t * (3 - 2 * t);
}
