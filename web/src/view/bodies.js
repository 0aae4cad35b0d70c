// Agents and elements: bodies that move. Between two states they are drawn where they were a short
// while ago, so that they move smoothly though states come twenty times a second, or fewer.

import * as THREE from 'three';
import { poseOf } from '../protocol/state_frames.js';

const kDelay_ms = 130;
const kLongestGap_ms = 600;  // after a longer silence bodies jump: they stood still
const kMostBodies = 2048;    // of one shape

const quaternionOf = (() => {
  const euler = new THREE.Euler();
  return (pose) => new THREE.Quaternion().setFromEuler(euler.set(pose.roll_rad, pose.pitch_rad, pose.yaw_rad, 'ZYX'));
})();

/** Where one thing was, and when the news came. */
class Track {
  #samples = [];

  push(time_ms, thing) {
    const pose = poseOf(thing);
    const last = this.#samples.at(-1);
    if (last && time_ms - last.time_ms > kLongestGap_ms) last.time_ms = time_ms - 50;
    this.#samples.push({ time_ms, position: new THREE.Vector3(...pose.position_m), rotation: quaternionOf(pose) });
    if (this.#samples.length > 8) this.#samples.shift();
  }

  /** Pose at that time into position and rotation. */
  at(time_ms, position, rotation) {
    const samples = this.#samples;
    let next = samples.findIndex((sample) => sample.time_ms >= time_ms);
    if (next < 0) next = samples.length - 1;
    const after = samples[next];
    const before = samples[Math.max(next - 1, 0)];
    const span = after.time_ms - before.time_ms;
    // Who is set somewhere else (a reset) does not fly there.
    const jumps = after.position.distanceToSquared(before.position) > 400;
    const share = span > 0 && !jumps ? Math.min(Math.max((time_ms - before.time_ms) / span, 0), 1) : 1;
    position.lerpVectors(before.position, after.position, share);
    rotation.slerpQuaternions(before.rotation, after.rotation, share);
  }
}

function bodyMaterial() {
  const material = new THREE.MeshLambertMaterial({ side: THREE.DoubleSide });
  material.onBeforeCompile = (shader) => {
    shader.vertexShader = 'attribute vec3 shade;\nvarying vec3 vShade;\n' +
        shader.vertexShader.replace('#include <begin_vertex>', '#include <begin_vertex>\nvShade = shade;');
    shader.fragmentShader = 'varying vec3 vShade;\n' +
        shader.fragmentShader.replace('#include <color_fragment>', '#include <color_fragment>\ndiffuseColor.rgb *= vShade;');
  };
  return material;
}

/** Bodies of one table (agents, or elements). */
export class Bodies {
  /** @param geometryOf (row of the table) -> {key, geometry, scale: number[3], height_m} */
  constructor(name, geometryOf) {
    this.group = new THREE.Group();
    this.group.name = name;
    this.geometryOf = geometryOf;
    this.material = bodyMaterial();
    this.meshes = new Map();  // key -> InstancedMesh
    this.table = [];
    this.version = -1;
    this.entries = [];  // what is drawn, for labels and tests: see #entry
  }

  setTable(version, rows) {
    this.version = version;
    this.table = rows;
    const known = new Map(this.entries.map((entry) => [entry.name, entry]));
    this.entries = rows.map((row) => {
      const entry = known.get(row.name) ?? { name: row.name, track: new Track(), position: new THREE.Vector3(), rotation: new THREE.Quaternion(), thing: null };
      return Object.assign(entry, { row, shape: this.geometryOf(row) });
    });
    for (const { shape } of this.entries) this.#meshOf(shape);
  }

  #meshOf({ key, geometry }) {
    if (!this.meshes.has(key)) {
      const mesh = new THREE.InstancedMesh(geometry, this.material, kMostBodies);
      mesh.castShadow = mesh.receiveShadow = true;
      mesh.frustumCulled = false;
      this.meshes.set(key, mesh);
      this.group.add(mesh);
    }
    return this.meshes.get(key);
  }

  /** A decoded state frame; ignored where it is of another table. */
  push(frame, now_ms) {
    if (frame.version !== this.version) return;
    frame.things.forEach((thing, index) => {
      const entry = this.entries[index];
      if (!entry) return;
      const still = entry.thing && thing.x === entry.thing.x && thing.y === entry.thing.y && thing.z === entry.thing.z &&
          thing.yaw === entry.thing.yaw && thing.pitch === entry.thing.pitch && thing.roll === entry.thing.roll;
      entry.thing = thing;
      if (!still || !entry.placed || !entry.settled) entry.track.push(now_ms, thing);
      entry.settled = still;
      entry.placed = true;
    });
  }

  update(now_ms) {
    const counts = new Map([...this.meshes.keys()].map((key) => [key, 0]));
    const matrix = new THREE.Matrix4();
    const scale = new THREE.Vector3();
    for (const entry of this.entries) {
      if (!entry.placed) continue;
      entry.track.at(now_ms - kDelay_ms, entry.position, entry.rotation);
      const { key, scale: [x, y, z] } = entry.shape;
      const count = counts.get(key);
      if (count >= kMostBodies) continue;
      matrix.compose(entry.position, entry.rotation, scale.set(x, y, z));
      this.meshes.get(key).setMatrixAt(count, matrix);
      counts.set(key, count + 1);
    }
    for (const [key, mesh] of this.meshes) {
      mesh.count = counts.get(key);
      mesh.visible = mesh.count > 0;
      mesh.instanceMatrix.needsUpdate = true;
    }
  }

  find(name) {
    return this.entries.find((entry) => entry.name === name && entry.placed) ?? null;
  }

  dispose() {
    for (const mesh of this.meshes.values()) mesh.dispose();
    this.material.dispose();
  }
}

