// Binary messages of the server: docs/viewer.md, "Binary messages", has their bytes.

export const MessageKind = Object.freeze({ agents: 1, elements: 2, points: 3 });

const kHeaderBytes = 18;
const kKeyEntryBytes = 22;
const kMetresPerStep = 0.01;
const kRadiansPerStep = (2 * Math.PI) / 65536;

/**
 * One agent or element.
 * @typedef {{x: number, y: number, z: number, yaw: number, pitch: number, roll: number,
 *            behaviour: number, health: number}} Thing
 * x, y, z in cm (whole numbers); yaw, pitch, roll in 2 pi / 65536 rad.
 */

/** Reads seven bits a byte, the lowest first; zigzag. `at` is {offset}, which moves on. */
function readZigzag(view, at) {
  let value = 0;
  let factor = 1;
  for (let bytes = 0; ; bytes++) {
    if (bytes === 5) throw new RangeError('a varint has more than five bytes');
    const byte = view.getUint8(at.offset++);
    value += (byte & 0x7f) * factor;  // not <<: that would turn negative at bit 31
    if (byte < 0x80) break;
    factor *= 128;
  }
  return value % 2 === 0 ? value / 2 : -(value + 1) / 2;
}

function readThing(view, offset) {
  return {
    x: view.getInt32(offset, true),
    y: view.getInt32(offset + 4, true),
    z: view.getInt32(offset + 8, true),
    yaw: view.getUint16(offset + 12, true),
    pitch: view.getUint16(offset + 14, true),
    roll: view.getUint16(offset + 16, true),
    behaviour: view.getUint8(offset + 18),
    health: view.getUint8(offset + 19),
  };
}

function readChange(view, at, base) {
  const mask = view.getUint8(at.offset++);
  const thing = { ...base };
  if (mask & 1) thing.x += readZigzag(view, at);
  if (mask & 2) thing.y += readZigzag(view, at);
  if (mask & 4) thing.z += readZigzag(view, at);
  for (const [bit, name] of [[8, 'yaw'], [16, 'pitch'], [32, 'roll']]) {
    if (mask & bit) {
      thing[name] = view.getUint16(at.offset, true);
      at.offset += 2;
    }
  }
  if (mask & 64) thing.behaviour = view.getUint8(at.offset++);
  if (mask & 128) thing.health = view.getUint8(at.offset++);
  return thing;
}

/** Decodes the state frames of one kind (agents or elements). Deltas count from its last key frame. */
export class StateDecoder {
  #key = null;  // {number, version, things}

  /** The next connection begins with a key frame. */
  reset() {
    this.#key = null;
  }

  /**
   * @param {ArrayBuffer} buffer one message
   * @returns {?{time_s: number, version: number, key: boolean, things: Thing[]}} null: a delta whose
   *     key frame is not here, to be ignored. `things` is by index of the table.
   * @throws {RangeError} what is no state frame
   */
  decode(buffer) {
    const view = new DataView(buffer);
    const isKey = view.getUint8(1) === 1;
    const number = view.getUint16(2, true);
    const version = view.getUint32(4, true);
    const time_s = view.getFloat64(8, true);
    const count = view.getUint16(16, true);
    const at = { offset: kHeaderBytes };
    if (isKey) {
      if (buffer.byteLength !== kHeaderBytes + count * kKeyEntryBytes) {
        throw new RangeError(`a key frame of ${count} entries has ${buffer.byteLength} bytes`);
      }
      const things = new Array(count);
      for (let i = 0; i < count; i++, at.offset += kKeyEntryBytes) {
        things[view.getUint16(at.offset, true)] = readThing(view, at.offset + 2);
      }
      this.#key = { number, version, things };
      return { time_s, version, key: true, things: things.slice() };
    }
    const key = this.#key;
    if (!key || key.number !== number || key.version !== version) return null;
    const things = key.things.slice();
    for (let i = 0; i < count; i++) {
      const index = view.getUint16(at.offset, true);
      at.offset += 2;
      if (!key.things[index]) throw new RangeError(`a delta names ${index}, which is not in its key frame`);
      things[index] = readChange(view, at, key.things[index]);
    }
    return { time_s, version, key: false, things };
  }
}

/** @returns {{position_m: number[], yaw_rad: number, pitch_rad: number, roll_rad: number}} */
export function poseOf(thing) {
  return {
    position_m: [thing.x * kMetresPerStep, thing.y * kMetresPerStep, thing.z * kMetresPerStep],
    yaw_rad: thing.yaw * kRadiansPerStep,
    pitch_rad: thing.pitch * kRadiansPerStep,
    roll_rad: thing.roll * kRadiansPerStep,
  };
}

/** How far a gate is open [rad], of an element's byte `health`. */
export function openingOf(thing) {
  return (thing.health - 128) * (Math.PI / 128);
}

/**
 * Decodes a message of points.
 * @returns {{time_s: number, sensor_m: number[], positions_m: Float32Array, intensities: Uint8Array}}
 *     positions_m: (count x 3), map frame.
 */
export function decodePoints(buffer) {
  const view = new DataView(buffer);
  const count = view.getUint16(2, true);
  const step_m = view.getFloat32(4, true);
  const sensor_m = [16, 20, 24].map((offset) => view.getFloat32(offset, true));
  if (buffer.byteLength !== 28 + 7 * count) {
    throw new RangeError(`${count} points have ${buffer.byteLength} bytes`);
  }
  const positions_m = new Float32Array(3 * count);
  const intensities = new Uint8Array(count);
  for (let i = 0; i < count; i++) {
    const offset = 28 + 7 * i;
    for (let axis = 0; axis < 3; axis++) {
      positions_m[3 * i + axis] = sensor_m[axis] + step_m * view.getInt16(offset + 2 * axis, true);
    }
    intensities[i] = view.getUint8(offset + 6);
  }
  return { time_s: view.getFloat64(8, true), sensor_m, positions_m, intensities };
}
