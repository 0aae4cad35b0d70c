// The ground: one grid of heights on the graphics card, drawn in tiles, each as fine as it is near.

import * as THREE from 'three';
import { kGroundLayers, layerOf, makeGroundTextures } from './ground_textures.js';
import { kTerrainFragment, kTerrainVertex } from './terrain_shader.js';

const kTileQuads = 64;     // of the finest level; each further level halves them
const kLevels = 5;
const kFinestWithin = 1.1;  // widths of a tile, from its middle; doubles from level to level
const kApron_m = 6000;     // how far the ground goes on beyond the world's edge

/** Grid of n x n quads with a skirt: corner (x, y in [0, n], down 0 or 1). */
function tileGeometry(quads) {
  const side = quads + 1;
  const corners = [];
  const index = [];
  for (let y = 0; y < side; y++) for (let x = 0; x < side; x++) corners.push(x, y, 0);
  for (let y = 0; y < quads; y++) {
    for (let x = 0; x < quads; x++) {
      const northWest = y * side + x;
      // Split from north-west to south-east, as the ground of physics is; rows go south.
      index.push(northWest, northWest + side + 1, northWest + 1);
      index.push(northWest, northWest + side, northWest + side + 1);
    }
  }
  const edge = [];
  for (let x = 0; x < quads; x++) edge.push([x, 0]);
  for (let y = 0; y < quads; y++) edge.push([quads, y]);
  for (let x = quads; x > 0; x--) edge.push([x, quads]);
  for (let y = quads; y > 0; y--) edge.push([0, y]);
  const first = corners.length / 3;
  for (const [x, y] of edge) corners.push(x, y, 1);
  edge.forEach(([x, y], i) => {
    const next = (i + 1) % edge.length;
    const a = y * side + x;
    const b = edge[next][1] * side + edge[next][0];
    index.push(a, b, first + i, b, first + next, first + i);
  });
  const geometry = new THREE.InstancedBufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(corners, 3));
  geometry.setIndex(index);
  return geometry;
}

/** Slopes of the ground as a texture: normals' x and y, 0.5 + 0.5 n. */
function normalTexture(field) {
  const { rows, cols, heights_m: z, spacing_m } = field;
  const data = new Uint8Array(4 * rows * cols);
  for (let r = 0, i = 0; r < rows; r++) {
    const north = Math.max(r - 1, 0) * cols;
    const south = Math.min(r + 1, rows - 1) * cols;
    for (let c = 0; c < cols; c++, i++) {
      const west = Math.max(c - 1, 0);
      const east = Math.min(c + 1, cols - 1);
      const dx = (z[r * cols + west] - z[r * cols + east]) / (spacing_m * (east - west));
      const dy = (z[south + c] - z[north + c]) / (spacing_m * ((south - north) / cols));
      const scale = 127.5 / Math.hypot(dx, dy, 1);
      data[4 * i] = 127.5 + dx * scale;
      data[4 * i + 1] = 127.5 + dy * scale;
      data[4 * i + 3] = 255;
    }
  }
  return smoothTexture(new THREE.DataTexture(data, cols, rows));
}

function smoothTexture(texture) {
  texture.magFilter = THREE.LinearFilter;
  texture.minFilter = THREE.LinearMipmapLinearFilter;
  texture.generateMipmaps = true;
  texture.needsUpdate = true;
  return texture;
}

/** Share of each layer around each texel, kGroundLayers / 4 textures; row 0 south. */
function layerTextures(description, surface) {
  const { rows, cols } = description.texture;
  const layers = description.surfaces.map(layerOf);
  const kernel = [1, 2, 1];
  const textures = [];
  for (let first = 0; first < kGroundLayers; first += 4) {
    const data = new Uint8Array(4 * rows * cols);
    for (let r = 0; r < rows; r++) {
      for (let c = 0; c < cols; c++) {
        const at = 4 * ((rows - 1 - r) * cols + c);
        for (let j = -1; j <= 1; j++) {
          const row = Math.min(Math.max(r + j, 0), rows - 1) * cols;
          for (let i = -1; i <= 1; i++) {
            const layer = layers[surface[row + Math.min(Math.max(c + i, 0), cols - 1)]] - first;
            if (layer >= 0 && layer < 4) data[at + layer] = Math.min(data[at + layer] + 16 * kernel[i + 1] * kernel[j + 1], 255);
          }
        }
      }
    }
    textures.push(smoothTexture(new THREE.DataTexture(data, cols, rows)));
  }
  return textures;
}

/** Colours of the classes, blended by their weights; row 0 south. */
function classTexture(description, weights) {
  const { rows, cols } = description.texture;
  const planes = description.classes.filter((entry) => entry.weighted)
      .map((entry) => parseInt(entry.color.slice(1), 16));
  const data = new Uint8Array(4 * rows * cols);
  const texels = rows * cols;
  for (let i = 0; i < texels; i++) {
    let red = 0, green = 0, blue = 0, sum = 0;
    for (let plane = 0; plane < planes.length; plane++) {
      const weight = weights[plane * texels + i];
      red += weight * (planes[plane] >> 16);
      green += weight * ((planes[plane] >> 8) & 255);
      blue += weight * (planes[plane] & 255);
      sum += weight;
    }
    const at = 4 * ((rows - 1 - Math.floor(i / cols)) * cols + (i % cols));
    data.set([red / (sum || 1), green / (sum || 1), blue / (sum || 1), 255], at);
  }
  const texture = smoothTexture(new THREE.DataTexture(data, cols, rows));
  texture.colorSpace = THREE.SRGBColorSpace;
  return texture;
}

export class Terrain {
  /** @param shared uniforms of all views: see atmosphere.js */
  constructor(world, shared, { anisotropy }) {
    const { description, height } = world;
    this.field = height;
    this.group = new THREE.Group();
    this.group.name = 'terrain';
    const size = description.size_m;
    const heights = new THREE.DataTexture(height.heights_m, height.cols, height.rows, THREE.RedFormat, THREE.FloatType);
    heights.needsUpdate = true;
    const [layersA, layersB] = layerTextures(description, world.surface);
    const classes = classTexture(description, world.weights);
    let ground = classes;
    if (world.ground) {
      ground = smoothTexture(new THREE.Texture(world.ground));
      ground.flipY = false;
      ground.colorSpace = THREE.SRGBColorSpace;
      ground.anisotropy = anisotropy;
    }
    const tiles = makeGroundTextures(anisotropy);
    this.uniforms = {
      heightMap: { value: heights }, normalMap2: { value: normalTexture(height) }, groundMap: { value: ground },
      layersA: { value: layersA }, layersB: { value: layersB }, classMap: { value: classes },
      tileColors: { value: tiles.color }, tileNormals: { value: tiles.normal },
      gridOrigin: { value: new THREE.Vector3(height.west_m, height.north_m, height.spacing_m) },
      gridSize: { value: new THREE.Vector2(height.cols, height.rows) },
      worldSize: { value: size }, apron: { value: kApron_m }, classOverlay: { value: 0 },
      wetness: shared.wetness, snowCover: shared.snowCover, detail: { value: 1 },
    };
    this.material = this.#makeMaterial();
    this.#makeTiles(height);
    this.textures = [heights, this.uniforms.normalMap2.value, ground, classes, layersA, layersB, tiles.color, tiles.normal];
  }

  /** Colours of the classes over the ground: 0 none, 1 them alone and unlit. */
  set classOverlay(share) {
    this.uniforms.classOverlay.value = share;
  }

  #makeMaterial() {
    const material = new THREE.MeshLambertMaterial();
    material.onBeforeCompile = (shader) => {
      Object.assign(shader.uniforms, this.uniforms);
      shader.vertexShader = kTerrainVertex(shader.vertexShader);
      shader.fragmentShader = kTerrainFragment(shader.fragmentShader);
    };
    return material;
  }

  #makeTiles(field) {
    this.tiles = [];
    const { rows, cols, spacing_m, heights_m } = field;
    for (let row = 0; row < rows - 1; row += kTileQuads) {
      for (let col = 0; col < cols - 1; col += kTileQuads) {
        let low = Infinity, high = -Infinity;
        const lastRow = Math.min(row + kTileQuads, rows - 1);
        const lastCol = Math.min(col + kTileQuads, cols - 1);
        for (let r = row; r <= lastRow; r++) {
          for (let c = col; c <= lastCol; c++) {
            low = Math.min(low, heights_m[r * cols + c]);
            high = Math.max(high, heights_m[r * cols + c]);
          }
        }
        // The outermost tiles carry the apron, and are in sight whenever it may be.
        const box = new THREE.Box3(
            new THREE.Vector3(field.west_m + col * spacing_m, field.north_m - lastRow * spacing_m, low),
            new THREE.Vector3(field.west_m + lastCol * spacing_m, field.north_m - row * spacing_m, high));
        const outer = row === 0 || col === 0 || lastRow === rows - 1 || lastCol === cols - 1;
        this.tiles.push({ row, col, box, outer, middle: box.getCenter(new THREE.Vector3()) });
      }
    }
    this.levels = [];
    for (let level = 0; level < kLevels; level++) {
      const geometry = tileGeometry(kTileQuads >> level);
      const places = new THREE.InstancedBufferAttribute(new Float32Array(3 * this.tiles.length), 3);
      places.setUsage(THREE.DynamicDrawUsage);
      geometry.setAttribute('tile', places);  // column, row, quads of the grid that one of its quads spans
      const mesh = new THREE.Mesh(geometry, this.material);
      mesh.frustumCulled = false;
      mesh.receiveShadow = true;
      this.levels.push({ mesh, places, stride: 1 << level });
      this.group.add(mesh);
    }
  }

  /** Chooses what is drawn, and how finely. quality: 1 fine, less is coarser. */
  update(camera, frustum, quality) {
    const counts = this.levels.map(() => 0);
    const width = kTileQuads * this.field.spacing_m;
    for (const tile of this.tiles) {
      if (!tile.outer && !frustum.intersectsBox(tile.box)) continue;
      const distance = Math.max(tile.middle.distanceTo(camera.position), 1);
      const level = Math.min(Math.max(Math.ceil(Math.log2(distance / (kFinestWithin * width * quality))), 0), kLevels - 1);
      const { places, stride } = this.levels[level];
      places.setXYZ(counts[level]++, tile.col, tile.row, stride);
    }
    this.levels.forEach(({ mesh, places }, level) => {
      mesh.geometry.instanceCount = counts[level];
      mesh.visible = counts[level] > 0;
      places.needsUpdate = true;
    });
  }

  dispose() {
    for (const texture of this.textures) texture.dispose();
    for (const { mesh } of this.levels) mesh.geometry.dispose();
    this.material.dispose();
  }
}
