// Payloads of a world, decoded: docs/viewer.md has their bytes.

/** Heights of the solid ground on a grid, as physics has them. */
export class HeightField {
  /**
   * @param {object} grid `height` of world.json
   * @param {ArrayBuffer} bytes payload `height`
   */
  constructor(grid, bytes) {
    const steps = new Uint16Array(bytes);
    if (steps.length !== grid.rows * grid.cols) {
      throw new RangeError(`height.bin has ${steps.length} values, not ${grid.rows} x ${grid.cols}`);
    }
    Object.assign(this, grid);
    this.heights_m = Float32Array.from(steps, (value) => grid.low_m + value * grid.step_m);
  }

  /** Height [m] at a place of the map frame, on the triangles that the page draws. */
  at(x_m, y_m) {
    const col = clamp((x_m - this.west_m) / this.spacing_m, 0, this.cols - 1);
    const row = clamp((this.north_m - y_m) / this.spacing_m, 0, this.rows - 1);
    const c = Math.min(Math.floor(col), this.cols - 2);
    const r = Math.min(Math.floor(row), this.rows - 2);
    const u = col - c;
    const v = row - r;
    const first = r * this.cols + c;
    const northWest = this.heights_m[first];
    const southEast = this.heights_m[first + this.cols + 1];
    if (u >= v) {
      const northEast = this.heights_m[first + 1];
      return northWest + u * (northEast - northWest) + v * (southEast - northEast);
    }
    const southWest = this.heights_m[first + this.cols];
    return northWest + v * (southWest - northWest) + u * (southEast - southWest);
  }
}

/**
 * Levels of the water on the vertices of the height field.
 * @returns {Float32Array} level [m], (rows x cols), NaN: none
 */
export function decodeWater(grid, bytes) {
  const values = new Uint16Array(bytes);
  if (values.length !== grid.rows * grid.cols) {
    throw new RangeError(`water.bin has ${values.length} values, not ${grid.rows} x ${grid.cols}`);
  }
  return Float32Array.from(values, (value) => (value ? grid.low_m + (value - 1) * grid.step_m : NaN));
}

/**
 * Things that stand in the world.
 * @returns {{count: number, place: Float32Array, size: Float32Array, color: Uint8Array,
 *            number: Uint32Array}} place: x, y, z [m], yaw [rad]; size: half length, half width,
 *     height [m], a random number in [0, 1); color: sRGB, 255
 */
export function decodeAssets(table, bytes) {
  const { count, bytes_each: stride } = table;
  if (bytes.byteLength !== count * stride) {
    throw new RangeError(`assets.bin has ${bytes.byteLength} bytes, not ${count} x ${stride}`);
  }
  const view = new DataView(bytes);
  const place = new Float32Array(4 * count);
  const size = new Float32Array(4 * count);
  const color = new Uint8Array(4 * count);
  const number = new Uint32Array(count);
  for (let i = 0, offset = 0; i < count; i++, offset += stride) {
    for (let k = 0; k < 3; k++) {
      place[4 * i + k] = view.getFloat32(offset + 4 * k, true);
      size[4 * i + k] = view.getUint16(offset + 18 + 2 * k, true) / 100;
      color[4 * i + k] = view.getUint8(offset + 24 + k);
    }
    number[i] = view.getUint32(offset + 12, true);
    place[4 * i + 3] = (view.getUint16(offset + 16, true) * 2 * Math.PI) / 65536;
    size[4 * i + 3] = ((number[i] * 2654435761) >>> 8) / 16777216;
    color[4 * i + 3] = 255;
  }
  return { count, place, size, color, number };
}

export function clamp(value, low, high) {
  return Math.min(Math.max(value, low), high);
}
