// The page reads what the C++ encoder writes: LATTICEWORLD_SAMPLES names the folder that
// write_stream_samples filled.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { StateDecoder, decodePoints, poseOf } from '../../web/src/protocol/state_frames.js';

const folder = process.env.LATTICEWORLD_SAMPLES;
const read = (name) => {
  const bytes = readFileSync(join(folder, name));
  return bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
};
const expected = JSON.parse(readFileSync(join(folder, 'expected.json')));

function assertFrame(frame, wanted) {
  assert.equal(frame.time_s, wanted.time_s);
  assert.equal(frame.version, wanted.version);
  assert.deepEqual(frame.things.map((thing) => ({
    position_cm: [thing.x, thing.y, thing.z], angle: [thing.yaw, thing.pitch, thing.roll],
    behaviour: thing.behaviour, health: thing.health,
  })), wanted.things);
}

test('a key frame and a delta on it give the states that were encoded', () => {
  const decoder = new StateDecoder();
  assertFrame(decoder.decode(read('key.bin')), expected.key);
  assertFrame(decoder.decode(read('delta.bin')), expected.delta);
});

test('a delta may come twice, as it counts from the key frame alone', () => {
  const decoder = new StateDecoder();
  decoder.decode(read('key.bin'));
  decoder.decode(read('delta.bin'));
  assertFrame(decoder.decode(read('delta.bin')), expected.delta);
});

test('a delta whose key frame is not here is ignored', () => {
  const decoder = new StateDecoder();
  assert.equal(decoder.decode(read('delta.bin')), null);
  decoder.decode(read('key.bin'));
  decoder.reset();
  assert.equal(decoder.decode(read('delta.bin')), null);
  const other = read('key.bin');
  new DataView(other).setUint16(2, new DataView(other).getUint16(2, true) + 1, true);
  decoder.decode(other);
  assert.equal(decoder.decode(read('delta.bin')), null);
});

test('what is cut off is an error, not a state', () => {
  for (const name of ['key.bin', 'delta.bin']) {
    const whole = read(name);
    for (let length = 0; length < whole.byteLength; length++) {
      const decoder = new StateDecoder();
      decoder.decode(read('key.bin'));
      assert.throws(() => decoder.decode(whole.slice(0, length)), RangeError, `${name} of ${length} bytes`);
    }
  }
});

test('a varint without an end is an error', () => {
  const decoder = new StateDecoder();
  const key = read('key.bin');
  decoder.decode(key);
  const bytes = new Uint8Array(18 + 3 + 8).fill(0xff);
  bytes.set(new Uint8Array(key).subarray(0, 18));
  const view = new DataView(bytes.buffer);
  view.setUint8(1, 0);
  view.setUint16(16, 1, true);
  view.setUint16(18, 0, true);
  view.setUint8(20, 1);
  assert.throws(() => decoder.decode(bytes.buffer), RangeError);
});

test('points lie where the sensor saw them', () => {
  const points = decodePoints(read('points.bin'));
  assert.equal(points.time_s, expected.points.time_s);
  assert.deepEqual([...points.intensities], expected.points.intensity);
  expected.points.points_m.flat().forEach((value, i) => assert.ok(Math.abs(points.positions_m[i] - value) < 0.01));
});

test('poses are in metres and radians', () => {
  const pose = poseOf({ x: 150, y: -250, z: 5, yaw: 16384, pitch: 0, roll: 32768 });
  assert.deepEqual(pose.position_m.map((value) => Math.round(value * 100)), [150, -250, 5]);
  assert.ok(Math.abs(pose.yaw_rad - Math.PI / 2) < 1e-9);
  assert.ok(Math.abs(pose.roll_rad - Math.PI) < 1e-9);
});
