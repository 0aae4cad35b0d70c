// Detail of the ground by kind of surface: tiles that the page draws itself, so that nothing is
// loaded from anywhere.

import * as THREE from 'three';
import { hash, tileCells, tileFbm } from './noise.js';

export const kGroundLayers = 8;
const kTile_px = 256;

// Layer of each surface that a server may name.
const kLayerOf = {
  grass: 0, 'forest floor': 1, farmland: 2, barren: 3, 'water bed': 3, road: 4, building: 5,
  rock: 6, snow: 7,
};

/** Layer of the surface of that name; what is not known looks like barren ground. */
export function layerOf(surface) {
  return kLayerOf[surface] ?? 3;
}

// Each gives {tone: brightness about 0.5, warm: shift to red or blue about 0, height: 0 .. 1} at
// (u, v) in [0, 1) of its tile.
const kPainters = [
  function grass(u, v) {
    const blades = tileFbm(u, v, 64, 2, 11);
    const tufts = tileFbm(u, v, 8, 4, 12);
    return { tone: 0.5 + 0.34 * (blades - 0.5) + 0.3 * (tufts - 0.5), warm: 0.16 * (tufts - 0.45),
             height: 0.55 * blades + 0.45 * tufts };
  },
  function forestFloor(u, v) {
    const leaves = tileCells(u, v, 28, 21);
    const soil = tileFbm(u, v, 8, 4, 22);
    return { tone: 0.5 + 0.4 * (leaves.cell - 0.5) * (leaves.edge > 0.12 ? 1 : 0.2) + 0.3 * (soil - 0.5),
             warm: 0.25 * (leaves.cell - 0.4), height: 0.6 * Math.min(leaves.edge * 1.5, 1) + 0.4 * soil };
  },
  function farmland(u, v) {
    const clods = tileFbm(u, v, 32, 3, 31);
    const furrow = 0.5 + 0.5 * Math.cos(2 * Math.PI * (8 * v + 0.12 * tileFbm(u, v, 4, 2, 32)));
    return { tone: 0.5 + 0.16 * (furrow - 0.5) + 0.32 * (clods - 0.5), warm: 0.08 * (clods - 0.5),
             height: 0.6 * furrow + 0.4 * clods };
  },
  function barren(u, v) {
    const sand = tileFbm(u, v, 64, 2, 41);
    const waves = tileFbm(u, v, 6, 3, 42);
    const pebble = tileCells(u, v, 24, 43);
    const stone = pebble.cell > 0.72 ? Math.max(0, 0.34 - pebble.nearest) * 2 : 0;
    return { tone: 0.5 + 0.2 * (sand - 0.5) + 0.24 * (waves - 0.5) + 0.35 * stone, warm: 0.1 * (waves - 0.5),
             height: 0.4 * sand + 0.4 * waves + 0.8 * stone };
  },
  function road(u, v) {
    const gravel = tileCells(u, v, 56, 51);
    const wear = tileFbm(u, v, 4, 4, 52);
    return { tone: 0.5 + 0.24 * (gravel.cell - 0.5) + 0.2 * (wear - 0.5), warm: 0.04 * (wear - 0.5),
             height: 0.7 * (1 - Math.min(gravel.nearest, 1)) + 0.3 * wear };
  },
  function paving(u, v) {
    const row = Math.floor(v * 16);
    const x = u * 8 + (row % 2) * 0.5;
    const joint = Math.min(x % 1, 1 - (x % 1)) * 2 < 0.08 || (v * 16) % 1 < 0.09;
    const stone = hash(Math.floor(x) % 8, row, 61);
    const worn = tileFbm(u, v, 16, 3, 62);
    return { tone: joint ? 0.36 : 0.5 + 0.16 * (stone - 0.5) + 0.16 * (worn - 0.5), warm: 0.06 * (stone - 0.5),
             height: joint ? 0.2 : 0.7 + 0.2 * worn };
  },
  function rock(u, v) {
    const crag = tileCells(u, v, 6, 71);
    const grain = tileFbm(u, v, 16, 4, 72);
    const crack = Math.min(crag.edge * 4, 1);
    return { tone: 0.5 + 0.3 * (grain - 0.5) + 0.2 * (crag.cell - 0.5) - 0.2 * (1 - crack), warm: 0.05 * (crag.cell - 0.5),
             height: 0.5 * crack + 0.5 * grain };
  },
  function snow(u, v) {
    const drift = tileFbm(u, v, 4, 4, 81);
    return { tone: 0.5 + 0.08 * (drift - 0.5), warm: -0.03 * (drift - 0.5), height: drift };
  },
];

/**
 * Two texture arrays of kGroundLayers tiles: `color` multiplies the ground's own colour (0.5: as it
 * is), `normal` has the slope of the relief in x and y (0.5: none) and its height in z.
 */
export function makeGroundTextures(anisotropy) {
  const texels = kTile_px * kTile_px;
  const color = new Uint8Array(4 * texels * kGroundLayers);
  const normal = new Uint8Array(4 * texels * kGroundLayers);
  const height = new Float32Array(texels);
  kPainters.forEach((paint, layer) => {
    for (let i = 0; i < texels; i++) {
      const { tone, warm, height: h } = paint((i % kTile_px) / kTile_px, Math.floor(i / kTile_px) / kTile_px);
      const at = 4 * (layer * texels + i);
      color[at] = toByte(tone + 0.5 * warm);
      color[at + 1] = toByte(tone);
      color[at + 2] = toByte(tone - 0.5 * warm);
      color[at + 3] = 255;
      height[i] = h;
    }
    for (let i = 0; i < texels; i++) {
      const x = i % kTile_px;
      const y = Math.floor(i / kTile_px);
      const east = height[y * kTile_px + ((x + 1) % kTile_px)];
      const west = height[y * kTile_px + ((x + kTile_px - 1) % kTile_px)];
      const north = height[((y + 1) % kTile_px) * kTile_px + x];
      const south = height[((y + kTile_px - 1) % kTile_px) * kTile_px + x];
      const at = 4 * (layer * texels + i);
      normal[at] = toByte(0.5 + 0.8 * (west - east));
      normal[at + 1] = toByte(0.5 + 0.8 * (south - north));
      normal[at + 2] = toByte(height[i]);
      normal[at + 3] = 255;
    }
  });
  return { color: arrayTexture(color, anisotropy), normal: arrayTexture(normal, anisotropy) };
}

function arrayTexture(data, anisotropy) {
  const texture = new THREE.DataArrayTexture(data, kTile_px, kTile_px, kGroundLayers);
  texture.wrapS = texture.wrapT = THREE.RepeatWrapping;
  texture.magFilter = THREE.LinearFilter;
  texture.minFilter = THREE.LinearMipmapLinearFilter;
  texture.generateMipmaps = true;
  texture.anisotropy = anisotropy;
  texture.needsUpdate = true;
  return texture;
}

function toByte(value) {
  return Math.max(0, Math.min(255, Math.round(255 * value)));
}
