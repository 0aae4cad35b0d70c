// Babylon.js reads exports --to glb, with instances.
// npm: @babylonjs/core@9.35.0 @babylonjs/loaders@9.35.0
import fs from 'node:fs';
import {NullEngine} from '@babylonjs/core/Engines/nullEngine.js';
import {Scene} from '@babylonjs/core/scene.js';
import {ImportMeshAsync} from '@babylonjs/core/Loading/sceneLoader.js';
import '@babylonjs/loaders/glTF/index.js';
import {Ground, Peer, assetCount, exported, versionOf} from './peer.mjs';

const peer = new Peer('Babylon.js', versionOf('@babylonjs/core'), '`--to glb`');
const ground = new Ground(exported('heights', 'heights'));
const scene = new Scene(new NullEngine());
const bytes = fs.readFileSync(exported('glb', 'instanced.glb'));
const url = 'data:model/gltf-binary;base64,' + bytes.toString('base64');
const {meshes} = await ImportMeshAsync(url, scene, {pluginExtension: '.glb'});
let things = 0;
for (const mesh of meshes) things += mesh.thinInstanceCount ?? 0;
const land = meshes.find((mesh) => mesh.name === 'ground');
peer.check('instances', things >= assetCount(), `${things} thin instances of ${meshes.length} meshes`);
const place = land.getVerticesData('position');
const points = [];
for (let i = 0; i < place.length; i += 3) points.push([place[i], -place[i + 2], place[i + 1]]);
ground.check(peer, points);
peer.finish();
