// Layers over the world: lidar points and paths.

import * as THREE from 'three';

export class LidarLayer {
  constructor() {
    const geometry = new THREE.BufferGeometry();
    const material = new THREE.PointsMaterial({ size: 3.5, sizeAttenuation: false, vertexColors: true, fog: false });
    this.object = new THREE.Points(geometry, material);
    this.object.frustumCulled = false;
    this.object.renderOrder = 4;
    this.count = 0;
  }

  /** points: of decodePoints(); null takes them away. */
  set(points) {
    this.object.geometry.dispose();
    const geometry = new THREE.BufferGeometry();
    this.count = points ? points.intensities.length : 0;
    if (points) {
      const colors = new Float32Array(3 * this.count);
      const color = new THREE.Color();
      const [x, y, z] = points.sensor_m;
      for (let i = 0; i < this.count; i++) {
        const at = 3 * i;
        const away = Math.hypot(points.positions_m[at] - x, points.positions_m[at + 1] - y, points.positions_m[at + 2] - z);
        color.setHSL(0.95 - 0.75 * Math.exp(-away / 15), 0.95, 0.55);
        color.toArray(colors, at);
      }
      geometry.setAttribute('position', new THREE.BufferAttribute(points.positions_m, 3));
      geometry.setAttribute('color', new THREE.BufferAttribute(colors, 3));
    }
    this.object.geometry = geometry;
    this.object.visible = this.count > 0;
  }

  dispose() {
    this.object.geometry.dispose();
    this.object.material.dispose();
  }
}

const kPathWidth_m = 0.35;
const kPathColors = [0xff3d81, 0x29d3ff, 0xffc93c, 0x8c6bff, 0x4be38a];

/** Ribbons a little above the ground, one a topic. */
export class PathLayer {
  constructor(heightAt) {
    this.heightAt = heightAt;
    this.group = new THREE.Group();
    this.group.name = 'paths';
    this.paths = new Map();
    this.colors = new Map();  // a topic keeps its colour from one path to the next
  }

  set(topic, points_m) {
    const known = this.paths.get(topic);
    if (known) {
      known.removeFromParent();
      known.geometry.dispose();
      known.material.dispose();
      this.paths.delete(topic);
    }
    if (points_m.length < 2) return;
    if (!this.colors.has(topic)) this.colors.set(topic, kPathColors[this.colors.size % kPathColors.length]);
    const corners = [];
    const index = [];
    points_m.forEach(([x, y, z], i) => {
      const before = points_m[Math.max(i - 1, 0)];
      const after = points_m[Math.min(i + 1, points_m.length - 1)];
      const along = new THREE.Vector2(after[0] - before[0], after[1] - before[1]).normalize().multiplyScalar(kPathWidth_m / 2);
      const up = Math.max(z, this.heightAt(x, y)) + 0.12;
      corners.push(x - along.y, y + along.x, up, x + along.y, y - along.x, up);
      if (i > 0) index.push(2 * i - 2, 2 * i - 1, 2 * i, 2 * i - 1, 2 * i + 1, 2 * i);
    });
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute(corners, 3));
    geometry.setIndex(index);
    const material = new THREE.MeshBasicMaterial({
      color: this.colors.get(topic), side: THREE.DoubleSide, transparent: true, opacity: 0.85,
      depthWrite: false, polygonOffset: true, polygonOffsetFactor: -4,
    });
    const ribbon = new THREE.Mesh(geometry, material);
    ribbon.renderOrder = 2;
    this.paths.set(topic, ribbon);
    this.group.add(ribbon);
  }

  clear() {
    for (const topic of [...this.paths.keys()]) this.set(topic, []);
  }
}
