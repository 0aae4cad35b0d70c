// three's GLTFLoader reads exports --to glb, with instances and expanded.
// npm: three@0.187.0
import fs from 'node:fs';
import * as THREE from 'three';
import {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';
import {Ground, Peer, assetCount, exported} from './peer.mjs';

// What its loader of textures asks a browser for.
globalThis.self = globalThis;
globalThis.createImageBitmap = async () => ({width: 1, height: 1, close() {}});
globalThis.ProgressEvent ??= class {};

async function load(file) {
  const bytes = fs.readFileSync(file);
  const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
  const loader = new GLTFLoader();
  return (await loader.parseAsync(buffer, '')).scene;
}

const peer = new Peer('three', THREE.REVISION, '`--to glb`, `--expand`');
const ground = new Ground(exported('heights', 'heights'));
for (const [name, ...options] of [['instanced.glb'], ['expanded.glb', '--expand']]) {
  const scene = await load(exported('glb', name, ...options));
  scene.updateMatrixWorld(true);
  const numbers = new Set();
  let meshes = 0, triangles = 0;
  scene.traverse((node) => {
    if (!node.isMesh) return;
    ++meshes;
    const count = node.isInstancedMesh ? node.count : 1;
    triangles += count * node.geometry.index.count / 3;
    const asset = node.geometry.getAttribute('_ASSET') ?? node.geometry.getAttribute('_asset');
    if (asset) for (let i = 0; i < asset.count; ++i) numbers.add(asset.getX(i));
    for (let up = node; up; up = up.parent)
      if (up.userData.asset !== undefined) numbers.add(up.userData.asset);
  });
  peer.check(`things of ${name}`, numbers.size === assetCount(),
             `${numbers.size} of ${assetCount()} by number, ${meshes} meshes, ${triangles} triangles`);
  const land = scene.getObjectByName('ground');
  const place = land.geometry.getAttribute('position');
  const points = [];
  for (let i = 0; i < place.count; ++i) points.push([place.getX(i), -place.getZ(i), place.getY(i)]);
  if (name === 'instanced.glb') ground.check(peer, points);
}
peer.finish();
