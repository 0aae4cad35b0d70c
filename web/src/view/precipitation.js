// Rain, snow and blown sand: particles in a box that goes with the camera; the shader moves them.

import * as THREE from 'three';
import { clamp } from '../protocol/payloads.js';

const kBox_m = 36;
const kMost = 14000;

// What falls, by kind: how fast [m/s], how much of the wind it takes, length of its streak [s], width
// [m], colour.
const kKinds = {
  rain: { fall: 8.5, drift: 0.5, streak_s: 0.05, width_m: 0.011, color: 0xc8d8e8, alpha: 0.42 },
  snow: { fall: 1.2, drift: 0.9, streak_s: 0, width_m: 0.055, color: 0xffffff, alpha: 0.9 },
  sand: { fall: 0.3, drift: 1.3, streak_s: 0.03, width_m: 0.03, color: 0xe0b878, alpha: 0.5 },
};

const kVertex = /* glsl */ `
attribute vec3 seed;
uniform float time, streak, width, box;
uniform vec3 velocity, center;
varying vec2 vCorner;
void main() {
  vCorner = position.xy;
  vec3 wobble = streak > 0.0 ? vec3(0.0) : 0.4 * vec3(sin(time * 1.3 + seed.x * 40.0), cos(time * 1.1 + seed.y * 40.0), 0.0);
  vec3 at = seed * box + velocity * time * (0.85 + 0.3 * seed.z) + wobble;
  at = center + mod(at - center + 0.5 * box, box) - 0.5 * box;
  vec3 along = velocity * streak;
  vec3 toCamera = normalize(cameraPosition - at);
  vec3 axis = streak > 0.0 ? along : vec3(0.0, 0.0, width);
  vec3 side = normalize(cross(axis, toCamera)) * width;
  vec3 up = streak > 0.0 ? axis * 0.5 : normalize(cross(toCamera, side)) * width;
  gl_Position = projectionMatrix * viewMatrix * vec4(at + side * position.x + up * position.y, 1.0);
}`;

const kFragment = /* glsl */ `
uniform vec3 color;
uniform float alpha, streak;
varying vec2 vCorner;
void main() {
  float shape = streak > 0.0 ? 1.0 - abs(vCorner.y) : 1.0 - smoothstep(0.3, 1.0, length(vCorner));
  gl_FragColor = vec4(color, alpha * shape);
  #include <colorspace_fragment>
}`;

export class Precipitation {
  constructor(shared) {
    const geometry = new THREE.InstancedBufferGeometry();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0], 3));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    const seeds = Float32Array.from({ length: 3 * kMost }, () => Math.random());
    geometry.setAttribute('seed', new THREE.InstancedBufferAttribute(seeds, 3));
    this.uniforms = {
      time: shared.time, streak: { value: 0 }, width: { value: 0.01 }, box: { value: kBox_m },
      velocity: { value: new THREE.Vector3() }, center: { value: new THREE.Vector3() },
      color: { value: new THREE.Color() }, alpha: { value: 0 },
    };
    const material = new THREE.ShaderMaterial({
      uniforms: this.uniforms, vertexShader: kVertex, fragmentShader: kFragment, transparent: true, depthWrite: false,
      side: THREE.DoubleSide,
    });
    this.mesh = new THREE.Mesh(geometry, material);
    this.mesh.name = 'precipitation';
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
    this.mesh.renderOrder = 3;
    this.amount = 0;
  }

  set(weather, day) {
    const amounts = {
      rain: clamp((weather.rain_mmph ?? 0) / 12, 0, 1),
      snow: clamp((weather.snowfall_mmph ?? 0) / 4, 0, 1),
      sand: clamp(weather.blown_sand ?? 0, 0, 1),
    };
    const [kind, amount] = Object.entries(amounts).reduce((a, b) => (b[1] > a[1] ? b : a));
    this.kind = amount > 0 ? kind : 'none';
    this.amount = amount > 0 ? 0.2 + 0.8 * amount : 0;
    this.mesh.visible = amount > 0;
    const { fall, drift, streak_s, width_m, color, alpha } = kKinds[kind];
    const wind = weather.wind_mps ?? [0, 0, 0];
    this.uniforms.velocity.value.set(wind[0] * drift, wind[1] * drift, -fall);
    this.uniforms.streak.value = streak_s;
    this.uniforms.width.value = width_m;
    this.uniforms.color.value.set(color).multiplyScalar(0.15 + 0.85 * day);
    this.uniforms.alpha.value = alpha;
  }

  update(camera, quality) {
    this.uniforms.center.value.copy(camera.position);
    this.mesh.geometry.instanceCount = Math.round(kMost * this.amount * quality);
  }
}
