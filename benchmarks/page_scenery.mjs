// What the page of world_viewer draws of a forest of 100,000 trees, and what choosing it takes: the page's own
// code in Node.js, without a browser or a graphics card.
// node benchmarks/page_scenery.mjs --modules BUILD/web/node_modules [--trees N]

import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { parseArgs } from 'node:util';

const web = join(dirname(dirname(fileURLToPath(import.meta.url))), 'web');
const { values } = parseArgs({ options: { modules: { type: 'string' }, trees: { type: 'string', default: '100000' } } });
if (!values.modules) throw new Error('--modules: give the build\'s web/node_modules');
const modules = resolve(values.modules);
const esbuild = createRequire(join(modules, 'here.js'))('esbuild');

const folder = mkdtempSync(join(tmpdir(), 'latticeworld_page_'));
const bundle = join(folder, 'page.mjs');
const sources = [`export * from '${web}/src/view/scenery.js';`, `export * from '${web}/src/view/quality.js';`, "export * as THREE from 'three';"];
await esbuild.build({
  stdin: { contents: sources.join('\n'), resolveDir: web }, outfile: bundle, nodePaths: [modules], bundle: true, format: 'esm', logLevel: 'warning',
});
const { Scenery, kQualitySteps, THREE } = await import(pathToFileURL(bundle));
rmSync(folder, { recursive: true });

const kSize_m = 1000;
const kFrames = 40;
const kFog_m = 1.15 * 3000;
const kKinds = [
  { kind: 'tree', each: 1, models: 16, height_m: [9, 16], slender: 0.3, triangles: [13200, 1950, 250] },  // as maples have
  { kind: 'grass_tuft', each: 3, models: 8, height_m: [0.3, 0.6], slender: 0.5, triangles: [60, 15, 4] },
];

let seed = 1;
function random() {
  seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
  return seed / 2 ** 32;
}

/** Leaves in the upper part of the unit box, of so many triangles. */
function crown(triangles) {
  const positions = Float32Array.from({ length: 9 * triangles }, (_, i) => (i % 3 === 2 ? 0.3 + 0.7 * random() : 2 * random() - 1));
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
  geometry.setAttribute('normal', new THREE.BufferAttribute(positions.slice().fill(0.577), 3));
  geometry.setAttribute('shade', new THREE.BufferAttribute(positions.slice().fill(0.5), 3));
  geometry.userData.parts = [{ name: 'leaves', first: 0, count: 3 * triangles }];
  return geometry;
}

function forest(trees) {
  const count = kKinds.reduce((sum, { each }) => sum + each * trees, 0);
  const assets = {
    count, place: new Float32Array(4 * count), size: new Float32Array(4 * count), color: new Uint8Array(4 * count).fill(128),
    number: Uint32Array.from({ length: count }, (_, i) => i),
  };
  const groups = [];
  let at = 0;
  for (const { kind, each, models, height_m: [low, high], slender } of kKinds) {
    for (let model = 0; model < models; model++) {
      const members = Math.floor((each * trees * (model + 1)) / models) - Math.floor((each * trees * model) / models);
      groups.push({ node: `${kind}/${model}`, kind, first: at, count: members, stretch: [1, 1] });
      for (let i = 0; i < members; i++, at++) {
        const height = low + (high - low) * random();
        assets.place.set([kSize_m * (random() - 0.5), kSize_m * (random() - 0.5), 0, 6.28 * random()], 4 * at);
        assets.size.set([slender * height, slender * height, height, random()], 4 * at);
      }
    }
  }
  return { assets, description: { size_m: kSize_m, assets: { groups } } };
}

const shapes = new Map(kKinds.map(({ kind, triangles }) => [kind, triangles.map(crown)]));
const uniform = { value: 0 };
const shared = { time: uniform, wind: { value: new THREE.Vector3() }, snowCover: uniform };
const began = performance.now();
const scenery = new Scenery(forest(Number(values.trees)), { levelsOf: (node, kind) => shapes.get(kind) }, shared);
console.log(`${values.trees} trees and ${3 * values.trees} tufts on ${kSize_m} m: made in ${((performance.now() - began) / 1000).toFixed(1)} s`);

const kViews = [
  { name: 'eye level, in the midst', from: [0, 0, 1.7], to: [50, 0, 1.7] },
  { name: '30 m up', from: [0, 0, 30], to: [80, 0, 0] },
  { name: 'the whole world', from: [100, -620, 340], to: [0, 0, 0] },
];
console.log('view | quality | draw calls | of shadows | M triangles | of shadows | choosing, median ms of CPU | worst');
for (const { name, from, to } of kViews) {
  for (const quality of kQualitySteps) {
    const camera = new THREE.PerspectiveCamera(55, 16 / 9, 0.2, 9000);
    camera.up.set(0, 0, 1);
    const times_ms = [];
    for (let frame = 0; frame < kFrames; frame++) {
      camera.position.set(from[0] + frame, from[1], from[2]);
      camera.lookAt(to[0] + frame, to[1], to[2]);
      camera.updateMatrixWorld();
      const frustum = new THREE.Frustum().setFromProjectionMatrix(
          new THREE.Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse));
      const start = process.cpuUsage();
      scenery.update(camera, frustum, quality.plants, kFog_m, quality.shadowRadius_m * Math.max(1, from[2] / 30));
      times_ms.push(process.cpuUsage(start).user / 1000);
    }
    times_ms.sort((a, b) => a - b);
    const drawn = scenery.batches.filter(({ count }) => count > 0);
    const casting = quality.shadowMap > 0 ? drawn.filter(({ mesh }) => mesh.castShadow) : [];
    const millions = (batches) => (batches.reduce((sum, { count, triangles }) => sum + count * triangles, 0) / 1e6).toFixed(2);
    console.log([name, quality.name, drawn.length, casting.length, millions(drawn), millions(casting),
      times_ms[kFrames / 2].toFixed(1), times_ms.at(-1).toFixed(1)].join(' | '));
  }
}
