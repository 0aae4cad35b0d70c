// The bridges of roads: boxes that stand still.

import * as THREE from 'three';

export class Bridges {
  constructor({ bridges = [] }) {
    this.group = new THREE.Group();
    this.group.name = 'bridges';
    this.box = new THREE.BoxGeometry(1, 1, 1);
    this.materials = new Map();
    for (const { boxes } of bridges) {
      for (const [x, y, z, yaw, length, width, height, ...color] of boxes) {
        const mesh = new THREE.Mesh(this.box, this.#materialOf(color));
        mesh.position.set(x, y, z);
        mesh.rotation.z = yaw;
        mesh.scale.set(length, width, height);
        mesh.castShadow = mesh.receiveShadow = true;
        this.group.add(mesh);
      }
    }
  }

  #materialOf([red, green, blue]) {
    const key = `${red} ${green} ${blue}`;
    if (!this.materials.has(key)) {
      const color = new THREE.Color().setRGB(red, green, blue, THREE.SRGBColorSpace);
      this.materials.set(key, new THREE.MeshLambertMaterial({ color }));
    }
    return this.materials.get(key);
  }

  dispose() {
    this.box.dispose();
    for (const material of this.materials.values()) material.dispose();
  }
}
