// The model library: meshes of models.glb in the axes of the map frame (z up), each one geometry
// with a colour a vertex, so that a model is one draw call whatever its parts.

import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

// The part that takes a thing's own colour, by kind.
const kMainPart = {
  tree: 'leaves', bush: 'leaves', crop: 'leaves', grass_tuft: 'leaves', flower: 'blossom', stone: 'stone',
  building: 'wall', dead_branch: 'bark',
};

export function mainPartOf(kind) {
  return kMainPart[kind] ?? 'leaves';
}

/** Name of a material's part: "oak/leaves" -> "leaves". */
function partOf(material) {
  return (material.userData.name ?? material.name ?? '').toLowerCase().split(/[/ .:_]/).pop();
}

/**
 * A copy with float positions and normals. Where the library has none, every facet is flat, as walls and
 * leaves are.
 */
function facets(geometry) {
  const { position, normal, color } = geometry.attributes;
  const copy = new THREE.BufferGeometry();
  for (const [name, attribute] of Object.entries({ position, normal, color })) {
    if (!attribute) continue;
    const values = new Float32Array(3 * attribute.count);
    for (let i = 0; i < attribute.count; i++) values.set([attribute.getX(i), attribute.getY(i), attribute.getZ(i)], 3 * i);
    copy.setAttribute(name, new THREE.BufferAttribute(values, 3));
  }
  copy.setIndex(geometry.index);
  if (normal) return copy;
  const flat = copy.index ? copy.toNonIndexed() : copy;
  flat.computeVertexNormals();
  return flat;
}

/**
 * Meshes of a node as one geometry: attributes position, normal, shade (linear colour); userData.parts
 * tells which of its vertices belong to which part.
 */
function mergeNode(node) {
  const positions = [];
  const normals = [];
  const colors = [];
  const parts = [];
  const index = [];
  node.updateMatrixWorld(true);
  const fromNode = node.matrixWorld.clone().invert();
  const toMap = new THREE.Matrix4().makeRotationX(Math.PI / 2);
  node.traverse((mesh) => {
    if (!mesh.isMesh) return;
    const matrix = toMap.clone().multiply(node.matrix.clone().setPosition(0, 0, 0)).multiply(fromNode).multiply(mesh.matrixWorld);
    const geometry = facets(mesh.geometry).applyMatrix4(matrix);
    const { position, normal, color } = geometry.attributes;
    const base = mesh.material.color ?? new THREE.Color(1, 1, 1);
    const first = positions.length / 3;
    for (let i = 0; i < position.count; i++) {
      positions.push(position.getX(i), position.getY(i), position.getZ(i));
      normals.push(normal.getX(i), normal.getY(i), normal.getZ(i));
      const shade = color ? [color.getX(i), color.getY(i), color.getZ(i)] : [1, 1, 1];
      colors.push(base.r * shade[0], base.g * shade[1], base.b * shade[2]);
    }
    const count = geometry.index ? geometry.index.count : position.count;
    parts.push({ name: partOf(mesh.material), first, count: position.count });
    for (let i = 0; i < count; i++) index.push(first + (geometry.index ? geometry.index.getX(i) : i));
  });
  if (!index.length) return null;
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(positions, 3));
  geometry.setAttribute('normal', new THREE.Float32BufferAttribute(normals, 3));
  geometry.setAttribute('shade', new THREE.Float32BufferAttribute(colors, 3));
  geometry.setIndex(index);
  geometry.userData.parts = parts;
  return geometry;
}

/**
 * Marks the vertices whose part takes the thing's own colour, and those of windows and lamps: attributes
 * tinted and glass, 0 or 1.
 */
export function tinted(geometry, mainPart) {
  const marks = new Uint8Array(geometry.attributes.position.count);
  const glass = new Uint8Array(geometry.attributes.position.count);
  for (const { name, first, count } of geometry.userData.parts ?? []) {
    if (name === mainPart) marks.fill(1, first, first + count);
    if (name === 'window') glass.fill(1, first, first + count);
  }
  const result = geometry.clone();
  result.setAttribute('tinted', new THREE.BufferAttribute(marks, 1));
  result.setAttribute('glass', new THREE.BufferAttribute(glass, 1));
  if (mainPart === 'leaves') roundCrown(result, marks);
  return result;
}

/** Leaves are lit as the crown that they are part of, not each by itself: crowns look soft. */
function roundCrown(geometry, marks) {
  const { position, normal } = geometry.attributes;
  const outward = new THREE.Vector3();
  for (let i = 0; i < position.count; i++) {
    if (!marks[i]) continue;
    outward.fromBufferAttribute(position, i);
    outward.z = 1.4 * (outward.z - 0.35);
    outward.normalize();
    normal.setXYZ(i, outward.x + 0.25 * normal.getX(i), outward.y + 0.25 * normal.getY(i), outward.z + 0.25 * normal.getZ(i));
  }
}

/** A few facets in the outline of a plant: what is drawn far away. Takes the thing's colour alone. */
export function farHull(geometry, sides = 5) {
  const { position } = geometry.attributes;
  const slices = 8;
  const radius = new Float32Array(slices);
  for (let i = 0; i < position.count; i++) {
    const slice = Math.min(Math.max(Math.floor(position.getZ(i) * slices), 0), slices - 1);
    radius[slice] = Math.max(radius[slice], Math.hypot(position.getX(i), position.getY(i)));
  }
  let widest = 0;
  for (let k = 1; k < slices; k++) if (radius[k] > radius[widest]) widest = k;
  let lowest = widest;
  while (lowest > 0 && radius[lowest - 1] > 0.35 * radius[widest]) lowest--;
  const upper = Math.min(widest + 2, slices - 1);
  const rings = [[lowest / slices, 0.3 * radius[widest]], [(widest + 0.5) / slices, 0.92 * radius[widest]],
                 [(upper + 0.5) / slices, 0.8 * radius[upper]]].filter(([z], i, all) => i === 0 || z > all[i - 1][0]);
  const corners = [];
  const index = [];
  rings.forEach(([z, r], ring) => {
    for (let k = 0; k < sides; k++) {
      const angle = (2 * Math.PI * (k + 0.5 * ring)) / sides;
      corners.push(r * Math.cos(angle), r * Math.sin(angle), z);
      if (ring === 0) continue;
      const a = (ring - 1) * sides + k;
      const b = (ring - 1) * sides + ((k + 1) % sides);
      index.push(a, b, ring * sides + k, b, ring * sides + ((k + 1) % sides), ring * sides + k);
    }
  });
  const top = corners.length / 3;
  corners.push(0, 0, 1);
  for (let k = 0; k < sides; k++) index.push((rings.length - 1) * sides + k, (rings.length - 1) * sides + ((k + 1) % sides), top);
  const hull = new THREE.BufferGeometry();
  hull.setAttribute('position', new THREE.Float32BufferAttribute(corners, 3));
  hull.setIndex(index);
  hull.computeVertexNormals();
  hull.setAttribute('shade', new THREE.BufferAttribute(new Float32Array(corners.length).fill(0.1), 3));
  hull.setAttribute('tinted', new THREE.BufferAttribute(new Uint8Array(corners.length / 3).fill(1), 1));
  hull.setAttribute('glass', new THREE.BufferAttribute(new Uint8Array(corners.length / 3), 1));
  return hull;
}

function plain(geometry, color, part) {
  const count = geometry.attributes.position.count;
  const shade = new Float32Array(3 * count);
  const { r, g, b } = new THREE.Color(color);
  for (let i = 0; i < count; i++) shade.set([r, g, b], 3 * i);
  geometry.setAttribute('shade', new THREE.BufferAttribute(shade, 3));
  geometry.userData.parts = [{ name: part, first: 0, count }];
  return geometry;
}

export class ModelLibrary {
  #geometries = new Map();

  /** @param {?ArrayBuffer} bytes models.glb; null: simple shapes stand for everything */
  static async read(bytes) {
    const library = new ModelLibrary();
    if (!bytes) return library;
    const gltf = await new GLTFLoader().parseAsync(bytes, '');
    gltf.scene.traverse((node) => {
      const name = node.userData.name ?? node.name;
      if (!name.includes('/')) return;
      const geometry = mergeNode(node);
      if (geometry) library.#geometries.set(name, geometry);
    });
    return library;
  }

  get names() {
    return [...this.#geometries.keys()];
  }

  /** The geometry of a node; null where the library has none. */
  find(name) {
    return this.#geometries.get(name) ?? null;
  }

  /** Levels of an asset's node, the finest first: what there is, else a simple shape of its kind. */
  levelsOf(node, kind) {
    const levels = [0, 1, 2].map((level) => this.find(`${node}/${level}`)).filter(Boolean);
    if (levels.length) return levels;
    const shape = kind === 'building' ? new THREE.BoxGeometry(2, 2, 1).translate(0, 0, 0.5)
        : kind === 'tree' ? new THREE.ConeGeometry(1, 1, 7).rotateX(Math.PI / 2).translate(0, 0, 0.5)
                          : new THREE.IcosahedronGeometry(1, 0).scale(1, 1, 0.5).translate(0, 0, 0.5);
    return [plain(shape, 0x888888, mainPartOf(kind))];
  }

  /** The body of a species or an element, true size; a capsule or box of its size where there is none. */
  bodyOf(node, height_m, radius_m) {
    return this.find(node) ?? this.find(`${node}/0`) ??
        plain(new THREE.CapsuleGeometry(radius_m, Math.max(height_m - 2 * radius_m, 0.05), 3, 8).rotateX(Math.PI / 2).translate(0, 0, 0.5 * height_m),
              0xb08850, 'body');
  }
}
