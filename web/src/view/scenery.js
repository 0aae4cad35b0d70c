// What stands in the world in great numbers: plants, stones, buildings. Sorted into chunks of the
// land; what of them is drawn, and how finely, is chosen as the camera moves.

import * as THREE from 'three';
import { instancedMaterials } from './instanced_material.js';
import { beginOf, levelAt, sightOf } from './levels.js';
import { farHull, mainPartOf, tinted } from './models.js';

const kChunk_m = 48;
const kShadowReach_m = 30;  // what is nearer throws its shadow into the view, wherever it stands
const kMargin_m = 8;
const kShadowLevel = 2;       // as finely as what is seen of its shadow alone is drawn
const kShadowPart = 0.7;      // a level that begins farther away, of the reach of shadows, throws none
// Those of few facets, in which it is seen at once that some are missing.
const kFinerOf = { building: 6, stone: 2, bush: 3, crop: 3, grass_tuft: 12, flower: 12 };
const kSwayOf = { tree: 1, bush: 0.8, crop: 1.2, grass_tuft: 1.5, flower: 1.4 };
const kWithHull = new Set(['tree', 'bush']);

/** An instanced mesh whose instances are chosen anew again and again. */
class Batch {
  constructor(geometry, { material, depth }, capacity, castShadow) {
    this.geometry = new THREE.InstancedBufferGeometry();
    this.geometry.index = geometry.index;
    Object.assign(this.geometry.attributes, geometry.attributes);
    this.place = this.#add('place', new Float32Array(4 * capacity), false);
    this.size = this.#add('size', new Float32Array(4 * capacity), false);
    this.color = this.#add('color4', new Uint8Array(4 * capacity), true);
    this.mesh = new THREE.Mesh(this.geometry, material);
    this.mesh.customDepthMaterial = depth;
    this.mesh.frustumCulled = false;
    this.mesh.castShadow = this.casts = castShadow;
    this.height_m = 0;  // of the highest thing
    this.mesh.receiveShadow = true;
    this.triangles = (geometry.index?.count ?? geometry.attributes.position.count) / 3;
    this.count = 0;
  }

  #add(name, array, normalized) {
    const attribute = new THREE.InstancedBufferAttribute(array, 4, normalized);
    attribute.setUsage(THREE.DynamicDrawUsage);
    this.geometry.setAttribute(name, attribute);
    return attribute;
  }

  append(things, first, count) {
    const at = 4 * this.count;
    this.place.array.set(things.place.subarray(4 * first, 4 * (first + count)), at);
    this.size.array.set(things.size.subarray(4 * first, 4 * (first + count)), at);
    this.color.array.set(things.color.subarray(4 * first, 4 * (first + count)), at);
    this.count += count;
  }

  appendOne({ place, size, color }, index) {
    const at = 4 * this.count++;
    for (let k = 0, from = 4 * index; k < 4; k++, from++) {
      this.place.array[at + k] = place[from];
      this.size.array[at + k] = size[from];
      this.color.array[at + k] = color[from];
    }
  }

  finish() {
    this.geometry.instanceCount = this.count;
    this.mesh.visible = this.count > 0;
    for (const attribute of [this.place, this.size, this.color]) {
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, 4 * this.count);
      attribute.needsUpdate = this.count > 0;
    }
  }
}

/** Order of a group's things by chunk: [{first, count, sphere, height_m}], and `order` of all. */
function sortIntoChunks(assets, group, size_m) {
  const side = Math.max(1, Math.ceil(size_m / kChunk_m));
  const cellOf = (i) => {
    const cell = (value) => Math.min(Math.max(Math.floor((value + size_m / 2) / kChunk_m), 0), side - 1);
    return cell(assets.place[4 * i + 1]) * side + cell(assets.place[4 * i]);
  };
  const members = new Map();
  for (let i = group.first; i < group.first + group.count; i++) {
    const cell = cellOf(i);
    if (!members.has(cell)) members.set(cell, []);
    members.get(cell).push(i);
  }
  const order = [];
  const chunks = [];
  for (const numbers of members.values()) {
    const box = new THREE.Box3();
    let height_m = 0;
    let reach_m = 0;
    for (const i of numbers) {
      box.expandByPoint(new THREE.Vector3().fromArray(assets.place, 4 * i));
      height_m = Math.max(height_m, assets.size[4 * i + 2]);
      reach_m = Math.max(reach_m, assets.size[4 * i] + assets.size[4 * i + 1]);
    }
    box.max.z += height_m;
    box.expandByScalar(Math.max(0.5 * height_m, reach_m) + 1);
    chunks.push({ first: order.length, count: numbers.length, sphere: box.getBoundingSphere(new THREE.Sphere()), height_m });
    order.push(...numbers);
  }
  return { order, chunks };
}

export class Scenery {
  constructor(world, models, shared) {
    const { assets, description } = world;
    this.group = new THREE.Group();
    this.group.name = 'scenery';
    this.things = {
      place: new Float32Array(4 * assets.count), size: new Float32Array(4 * assets.count), color: new Uint8Array(4 * assets.count),
    };
    this.indexOf = new Map();  // number of an asset -> index in things
    this.groups = [];
    this.batches = [];
    this.hidden = new Map();  // index in things -> its height [m]
    const materials = new Map();
    const batchesOf = new Map();  // node -> one batch a level
    const total = new Map();
    for (const group of description.assets.groups) total.set(group.node, (total.get(group.node) ?? 0) + group.count);
    let filled = 0;
    for (const group of description.assets.groups) {
      const sway = kSwayOf[group.kind] ?? 0;
      if (!materials.has(sway)) materials.set(sway, instancedMaterials(shared, sway));
      if (!batchesOf.has(group.node)) {
        batchesOf.set(group.node, this.#makeBatches(models, group, materials.get(sway), total.get(group.node)));
      }
      const { order, chunks } = sortIntoChunks(assets, group, description.size_m);
      order.forEach((from, k) => this.#copy(assets, from, filled + k, group.stretch));
      for (const chunk of chunks) chunk.first += filled;
      filled += order.length;
      for (const batch of batchesOf.get(group.node)) batch.height_m = Math.max(batch.height_m, ...chunks.map(({ height_m }) => height_m));
      this.groups.push({ finer: kFinerOf[group.kind] ?? 1, batches: batchesOf.get(group.node), chunks });
    }
    this.materials = [...materials.values()];
    this.lastView = new THREE.Matrix4();
    this.dirty = true;
  }

  #makeBatches(models, group, materials, capacity) {
    const levels = models.levelsOf(group.node, group.kind).map((geometry) => tinted(geometry, mainPartOf(group.kind)));
    if (kWithHull.has(group.kind)) levels.push(farHull(levels[0]));
    const batches = levels.map((geometry, level) => new Batch(geometry, materials, capacity, level < 3 && group.kind !== 'grass_tuft'));
    for (const batch of batches) {
      this.group.add(batch.mesh);
      this.batches.push(batch);
    }
    return batches;
  }

  #copy(assets, from, to, [wider, higher]) {
    const { place, size, color } = this.things;
    place.set(assets.place.subarray(4 * from, 4 * from + 4), 4 * to);
    color.set(assets.color.subarray(4 * from, 4 * from + 4), 4 * to);
    const s = 4 * from;
    size.set([assets.size[s] * wider, assets.size[s + 1] * wider, assets.size[s + 2] * higher, assets.size[s + 3]], 4 * to);
    this.indexOf.set(assets.number[from], to);
  }

  /** Leaves out these assets (by number), which something else draws, and shows all others. */
  hide(numbers) {
    for (const [index, height_m] of this.hidden) this.things.size[4 * index + 2] = height_m;
    this.hidden = new Map();
    for (const number of numbers) {
      const index = this.indexOf.get(number);
      if (index === undefined) continue;
      this.hidden.set(index, this.things.size[4 * index + 2]);
      this.things.size[4 * index + 2] = 0;
    }
    this.dirty = true;
  }

  /** The thing of that number: {place, size, color, batch}; null: there is none. */
  find(number) {
    const index = this.indexOf.get(number);
    if (index === undefined) return null;
    const group = this.groups.find(({ chunks }) => chunks.some((chunk) => index >= chunk.first && index < chunk.first + chunk.count));
    const part = (array) => [...array.subarray(4 * index, 4 * index + 4)];
    const size = part(this.things.size);
    size[2] = this.hidden.get(index) ?? size[2];
    return { place: part(this.things.place), size, color: part(this.things.color), batch: group.batches[0] };
  }

  /**
   * Chooses what is drawn where the view has changed. quality: 1 all, less is coarser and nearer; shadow_m: how
   * far shadows reach.
   */
  update(camera, frustum, quality, sight_m, shadow_m) {
    const view = camera.matrixWorld;
    const moved = !this.dirty && this.quality === quality && this.sight_m === sight_m && this.shadow_m === shadow_m &&
        view.elements.every((value, i) => Math.abs(value - this.lastView.elements[i]) < (i < 12 ? 0.02 : 0.5));
    if (moved) return;
    this.lastView.copy(view);
    this.dirty = false;
    this.quality = quality;
    this.sight_m = sight_m;
    this.shadow_m = shadow_m;
    for (const batch of this.batches) batch.count = 0;
    const padded = new THREE.Sphere();
    for (const { batches, chunks, finer } of this.groups) {
      batches.forEach(({ mesh, casts, height_m }, level) => { mesh.castShadow = casts && beginOf(level, height_m, finer * quality) < kShadowPart * shadow_m; });
      for (const chunk of chunks) {
        const { sphere, height_m } = chunk;
        const middle_m = camera.position.distanceTo(sphere.center);
        const distance = Math.max(middle_m - sphere.radius, 0);
        if (distance > Math.min(sightOf(height_m, quality), sight_m)) continue;
        padded.center.copy(sphere.center);
        padded.radius = sphere.radius + kMargin_m;
        if (distance > kShadowReach_m && !frustum.intersectsSphere(padded)) continue;
        const level = levelAt(distance, height_m, finer * quality, batches.length);
        const coarsest = levelAt(middle_m + sphere.radius, height_m, finer * quality, batches.length);
        if (level === coarsest && distance > kShadowReach_m) batches[level].append(this.things, chunk.first, chunk.count);
        else this.#chooseEach(batches, chunk, camera, frustum, finer * quality);
      }
    }
    for (const batch of this.batches) batch.finish();
  }

  /** For a chunk that is near: its things one by one, each as finely as its own distance asks for. */
  #chooseEach(batches, { first, count, height_m }, { position }, frustum, scale) {
    const { place, size } = this.things;
    const ball = new THREE.Sphere();
    for (let i = first; i < first + count; i++) {
      ball.center.fromArray(place, 4 * i);
      const distance = position.distanceTo(ball.center);
      ball.center.z += 0.5 * size[4 * i + 2];
      ball.radius = Math.hypot(size[4 * i], size[4 * i + 1], 0.5 * size[4 * i + 2]) + 1;
      const seen = frustum.intersectsSphere(ball);
      if (!seen && distance > kShadowReach_m) continue;
      const level = levelAt(distance, height_m, scale, batches.length);
      batches[seen ? level : Math.max(level, Math.min(kShadowLevel, batches.length - 1))].appendOne(this.things, i);
    }
  }

  get drawn() {
    return this.batches.reduce((sum, batch) => sum + batch.count, 0);
  }

  dispose() {
    for (const batch of this.batches) batch.geometry.dispose();
    for (const { material, depth } of this.materials) {
      material.dispose();
      depth.dispose();
    }
  }
}
