// Trees that fell, or are falling: each is drawn on its own, from where its foot and its tip are.

import * as THREE from 'three';

export class FelledTrees {
  constructor(scenery) {
    this.scenery = scenery;
    this.group = new THREE.Group();
    this.group.name = 'felled';
    this.trees = new Map();  // number -> {mesh, target: Quaternion}
  }

  /** trees: of a message `felled`. */
  set(trees) {
    const numbers = new Set(trees.map((tree) => tree.asset));
    const changed = numbers.size !== this.trees.size || [...numbers].some((number) => !this.trees.has(number));
    for (const [number, { mesh }] of this.trees) {
      if (numbers.has(number)) continue;
      mesh.removeFromParent();
      mesh.geometry.dispose();
      this.trees.delete(number);
    }
    for (const tree of trees) this.#place(tree);
    if (changed) this.scenery.hide(numbers);
  }

  #place({ asset, foot_m, tip_m }) {
    let entry = this.trees.get(asset);
    if (!entry) {
      const thing = this.scenery.find(asset);
      if (!thing) return;
      entry = { mesh: this.#makeMesh(thing), yaw: thing.place[3], stand: null };
      this.trees.set(asset, entry);
      this.group.add(entry.mesh);
    }
    const foot = new THREE.Vector3(...foot_m);
    const along = new THREE.Vector3(...tip_m).sub(foot).normalize();
    const upright = new THREE.Vector3(0, 0, 1);
    entry.target = new THREE.Quaternion().setFromUnitVectors(upright, along)
        .multiply(new THREE.Quaternion().setFromAxisAngle(upright, entry.yaw));
    entry.mesh.position.copy(foot);
    if (!entry.stand) {
      entry.stand = true;
      entry.mesh.quaternion.copy(entry.target);
    }
  }

  #makeMesh({ size, color, batch }) {
    const { position, normal, shade, tinted } = batch.geometry.attributes;
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', position);
    geometry.setAttribute('normal', normal);
    geometry.setIndex(batch.geometry.index);
    const own = new THREE.Color(color[0] / 255, color[1] / 255, color[2] / 255).convertSRGBToLinear();
    const colors = new Float32Array(3 * position.count);
    for (let i = 0; i < position.count; i++) {
      const c = tinted.getX(i) ? [own.r, own.g, own.b] : [shade.getX(i), shade.getY(i), shade.getZ(i)];
      colors.set(c, 3 * i);
    }
    geometry.setAttribute('color', new THREE.BufferAttribute(colors, 3));
    const mesh = new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({ vertexColors: true, side: THREE.DoubleSide }));
    mesh.scale.set(size[0], size[1], size[2]);
    mesh.castShadow = mesh.receiveShadow = true;
    return mesh;
  }

  /** Turns on smoothly between the states that come. */
  update(seconds) {
    for (const { mesh, target } of this.trees.values()) mesh.quaternion.slerp(target, 1 - Math.exp(-10 * seconds));
  }

  dispose() {
    this.set([]);
  }
}
