// What the page decides without a browser: heights, payloads, quality, waiting, keys.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { wayOfKeys } from '../../web/src/control/driving.js';
import { addressOf, socketAddress } from '../../web/src/protocol/addresses.js';
import { backoff_ms } from '../../web/src/protocol/connection.js';
import { HeightField, decodeAssets, decodeWater } from '../../web/src/protocol/payloads.js';
import { readModels } from '../../web/src/protocol/world_source.js';
import { chooseLabels } from '../../web/src/view/label_places.js';
import { levelAt, sightOf } from '../../web/src/view/levels.js';
import { elementShapes } from '../../web/src/view/shapes.js';
import { QualityGovernor, kQualitySteps } from '../../web/src/view/quality.js';

const kGrid = { rows: 2, cols: 2, spacing_m: 2, west_m: -1, north_m: 1, low_m: 10, step_m: 0.5 };

test('heights are those of the triangles, split from north-west to south-east', () => {
  const field = new HeightField(kGrid, Uint16Array.of(0, 8, 4, 2).buffer);  // NW 10, NE 14, SW 12, SE 11
  assert.equal(field.at(-1, 1), 10);
  assert.equal(field.at(1, 1), 14);
  assert.equal(field.at(-1, -1), 12);
  assert.equal(field.at(1, -1), 11);
  assert.equal(field.at(0, 0), 10.5);          // on the diagonal
  assert.equal(field.at(0.5, 0.5), 12.25);
  assert.equal(field.at(100, 100), 14);        // flat beyond the edge
});

test('a payload of another size is refused', () => {
  assert.throws(() => new HeightField(kGrid, new Uint16Array(3).buffer), RangeError);
  assert.throws(() => decodeWater(kGrid, new Uint16Array(5).buffer), RangeError);
  assert.throws(() => decodeAssets({ count: 2, bytes_each: 28 }, new ArrayBuffer(28)), RangeError);
});

test('water is a level or nothing', () => {
  const levels = decodeWater(kGrid, Uint16Array.of(0, 1, 3, 0).buffer);
  assert.ok(Number.isNaN(levels[0]));
  assert.equal(levels[1], 10);
  assert.equal(levels[2], 11);
});

test('an asset has its place, size and colour', () => {
  const bytes = new DataView(new ArrayBuffer(28));
  [1.5, -2.5, 3].forEach((value, i) => bytes.setFloat32(4 * i, value, true));
  bytes.setUint32(12, 77, true);
  bytes.setUint16(16, 16384, true);
  [120, 110, 900].forEach((value, i) => bytes.setUint16(18 + 2 * i, value, true));
  [10, 20, 30].forEach((value, i) => bytes.setUint8(24 + i, value));
  const assets = decodeAssets({ count: 1, bytes_each: 28 }, bytes.buffer);
  assert.deepEqual([...assets.place.subarray(0, 3)], [1.5, -2.5, 3]);
  assert.ok(Math.abs(assets.place[3] - Math.PI / 2) < 1e-6);
  assert.ok(Math.abs(assets.size[0] - 1.2) < 1e-6 && assets.size[2] === 9);
  assert.deepEqual([...assets.color], [10, 20, 30, 255]);
  assert.equal(assets.number[0], 77);
});

test('slow frames lower the quality, fast ones raise it, and it does not swing', () => {
  const governor = new QualityGovernor(0);
  for (let i = 0; i < 60; i++) governor.frame(60);
  const low = governor.step;
  assert.ok(low > 0);
  for (let i = 0; i < 2000; i++) governor.frame(16);
  assert.equal(governor.step, low, 'a step that proved too slow is not tried again');
  const fast = new QualityGovernor(2);
  for (let i = 0; i < 2000; i++) fast.frame(10);
  assert.equal(fast.step, 0);
});

test('one long frame alone decides nothing, and a choice of the user stays', () => {
  const governor = new QualityGovernor(1);
  governor.frame(5000);
  assert.equal(governor.step, 1);
  governor.choose('least');
  for (let i = 0; i < 3000; i++) governor.frame(5);
  assert.equal(governor.settings, kQualitySteps.at(-1));
});

test('attempts to connect come less and less often, up to ten seconds', () => {
  const middle = () => 0.5;
  const waits = [0, 1, 2, 3, 10].map((attempt) => backoff_ms(attempt, middle));
  assert.deepEqual(waits, [500, 1000, 2000, 4000, 10000]);
});

test('all addresses stand beside the page, below whatever prefix a proxy gives it', () => {
  const rows = [
    ['http://127.0.0.1:8080/', 'http://127.0.0.1:8080', 'ws://127.0.0.1:8080'],
    ['https://robots.example/lab/world/', 'https://robots.example/lab/world', 'wss://robots.example/lab/world'],
    ['https://robots.example/world/index.html?a=1#b', 'https://robots.example/world', 'wss://robots.example/world'],
  ];
  for (const [page, base, socket] of rows) {
    assert.equal(addressOf('/api/world.json', page), `${base}/api/world.json`);
    assert.equal(socketAddress(page), `${socket}/ws`);
  }
});

test('a payload that the server names by its path is read below the prefix', async () => {
  const { fetch } = globalThis;
  const asked = [];
  globalThis.document = { baseURI: 'https://robots.example/world/' };
  globalThis.fetch = async (address) => {
    asked.push(address);
    return new Response(Uint8Array.of(1, 2, 3));
  };
  try {
    const models = await readModels({ payloads: { models: { url: '/api/worlds/key/models.glb', bytes: 3 } } }, () => {});
    assert.deepEqual([...new Uint8Array(models)], [1, 2, 3]);
    assert.deepEqual(asked, ['https://robots.example/world/api/worlds/key/models.glb']);
  } finally {
    globalThis.fetch = fetch;
    delete globalThis.document;
  }
});

test('no file of the page is named from the root of the server', () => {
  const names = { 'public/index.html': /(?:src|href|action)="\//, 'src/style.css': /url\(["']?\// };
  for (const [name, from_root] of Object.entries(names)) {
    assert.doesNotMatch(readFileSync(new URL(`../../web/${name}`, import.meta.url), 'utf8'), from_root);
  }
});

test('keys that contradict each other cancel', () => {
  assert.deepEqual(wayOfKeys(new Set(['KeyW', 'ArrowLeft'])), { forward: 1, left: 1, up: 0 });
  assert.deepEqual(wayOfKeys(new Set(['KeyW', 'KeyS', 'KeyE'])), { forward: 0, left: 0, up: 1 });
});

test('a thing is drawn the coarser the farther away and the lower it is', () => {
  const levels = [1, 40, 200, 1000].map((distance_m) => levelAt(distance_m, 12, 1, 4));
  assert.deepEqual(levels, [0, 1, 2, 3]);
  assert.equal(levelAt(1000, 12, 1, 3), 2, 'the coarsest that there is');
  assert.ok(levelAt(40, 0.5, 1, 4) > levelAt(40, 12, 1, 4), 'a flower before a tree');
  assert.ok(levelAt(40, 12, 0.3, 4) > levelAt(40, 12, 1, 4), 'at less quality');
  assert.ok(sightOf(12, 1) > sightOf(12, 0.5) && sightOf(12, 1) > sightOf(0.5, 1));
});

test('a label that would hide one before it is left out', () => {
  const first = { x: 100, y: 100 };
  const behind = { x: 110, y: 104 };
  const beside = { x: 200, y: 100 };
  const below = { x: 105, y: 150 };
  assert.deepEqual(chooseLabels([first, behind, beside, below], 10), [first, beside, below]);
  assert.deepEqual(chooseLabels([behind, first, beside], 10), [behind, beside], 'the order decides');
  assert.deepEqual(chooseLabels([first, beside, below], 2), [first, beside], 'at most so many');
});

test('an element is drawn as large as it is, about the origin that its pose tells of', () => {
  const shapeOf = elementShapes({ elements: [{ kind: 'gate', node: 'element/gate' }] }, { bodyOf: (node) => `mesh of ${node}` });
  const shape = shapeOf({ kind: 'gate', size_m: [2, 0.1, 1.1] });
  assert.deepEqual(shape, { key: 'element/gate', geometry: 'mesh of element/gate', scale: [2, 0.1, 1.1], height_m: 1.1 });
});
