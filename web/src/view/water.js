// Waters: surfaces over the height field that end where the ground cuts them.

import * as THREE from 'three';

const kMostQuads = 200000;

const kVertex = /* glsl */ `
#include <common>
#include <fog_pars_vertex>
attribute float depth;
uniform float rise;
varying float vDepth;
varying vec3 vPlace;
void main() {
  vec3 transformed = position + vec3(0.0, 0.0, rise);
  vDepth = depth + rise;
  vPlace = transformed;
  vec4 mvPosition = viewMatrix * vec4(transformed, 1.0);
  gl_Position = projectionMatrix * mvPosition;
  #include <fog_vertex>
}`;

const kFragment = /* glsl */ `
#include <common>
#include <fog_pars_fragment>
uniform float time, light, ice;
uniform vec3 zenith, horizon, sunColor, sunDirection, wind;
varying float vDepth;
varying vec3 vPlace;

float hash2(vec2 p) { return fract(sin(dot(p, vec2(127.1, 311.7))) * 43758.5453); }
vec3 noised(vec2 p) {  // value and slopes
  vec2 i = floor(p), f = fract(p), u = f * f * (3.0 - 2.0 * f), du = 6.0 * f * (1.0 - f);
  float a = hash2(i), b = hash2(i + vec2(1, 0)), c = hash2(i + vec2(0, 1)), d = hash2(i + vec2(1, 1));
  return vec3(a + (b - a) * u.x + (c - a) * u.y + (a - b - c + d) * u.x * u.y,
              du * (vec2(b - a, c - a) + (a - b - c + d) * u.yx));
}

void main() {
  float far = distance(cameraPosition, vPlace);
  vec2 blow = wind.xy * 0.06 + vec2(0.05, 0.03);
  vec2 slope = noised(vPlace.xy * 0.55 + blow * time * 2.0).yz * 0.10
             + noised(vPlace.yx * 1.7 - blow * time * 3.1).zy * 0.07
             + noised(vPlace.xy * 4.3 + blow.yx * time * 4.0).yz * 0.035 * smoothstep(60.0, 10.0, far);
  slope *= (0.55 + 0.1 * min(length(wind.xy), 8.0)) * (1.0 - 0.8 * smoothstep(80.0, 500.0, far));
  vec3 n = normalize(vec3(-slope, 1.0));
  vec3 view = normalize(cameraPosition - vPlace);
  float fresnel = 0.02 + 0.98 * pow(1.0 - max(dot(n, view), 0.0), 5.0);
  vec3 mirrored = reflect(-view, n);
  vec3 sky = mix(horizon, zenith, 1.0 - pow(1.0 - max(mirrored.z, 0.0), 3.2));
  float clear = 1.0 - exp(-max(vDepth, 0.0) * 1.4);
  vec3 body = mix(vec3(0.16, 0.30, 0.27), vec3(0.025, 0.12, 0.18), clear) * light;
  vec3 color = mix(body, sky, fresnel);
  vec3 halfway = normalize(view + sunDirection);
  color += sunColor * pow(max(dot(n, halfway), 0.0), 420.0) * 2.5 * step(0.0, sunDirection.z) * light;
  float lap = 0.02 + 0.02 * noised(vPlace.xy * 2.2 + time * 0.25).x;
  float foam = smoothstep(lap, 0.0, vDepth) * smoothstep(-0.02, 0.01, vDepth) * 0.2;
  color = mix(color, vec3(0.9) * light, foam);
  float alpha = clamp(0.18 + 0.82 * clear + fresnel * 0.5 + foam, 0.0, 0.96) * smoothstep(-0.04, 0.02, vDepth);
  gl_FragColor = vec4(color, alpha);
  #include <tonemapping_fragment>
  #include <colorspace_fragment>
  #include <fog_fragment>
}`;

/** Quads of the grid that are under water, every `stride`-th vertex. */
function waterGeometry(field, level_m, stride) {
  const { rows, cols, west_m, north_m, spacing_m, heights_m } = field;
  const number = new Map();
  const corners = [];
  const depths = [];
  const index = [];
  const vertex = (r, c) => {
    const at = r * cols + c;
    let id = number.get(at);
    if (id === undefined) {
      id = depths.length;
      number.set(at, id);
      corners.push(west_m + c * spacing_m, north_m - r * spacing_m, level_m[at]);
      depths.push(level_m[at] - heights_m[at]);
    }
    return id;
  };
  for (let r = 0; r + stride < rows; r += stride) {
    for (let c = 0; c + stride < cols; c += stride) {
      const at = r * cols + c;
      if (isNaN(level_m[at] + level_m[at + stride] + level_m[at + stride * cols] + level_m[at + stride * (cols + 1)])) continue;
      const northWest = vertex(r, c);
      const southEast = vertex(r + stride, c + stride);
      index.push(northWest, southEast, vertex(r, c + stride), northWest, vertex(r + stride, c), southEast);
    }
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(corners, 3));
  geometry.setAttribute('depth', new THREE.Float32BufferAttribute(depths, 1));
  geometry.setIndex(index);
  return geometry;
}

export class Water {
  constructor(world, shared) {
    let wet = 0;
    for (const level of world.water_m) if (!isNaN(level)) wet++;
    const stride = Math.max(1, Math.ceil(Math.sqrt(wet / kMostQuads)));
    const { time, zenith, horizon, sunColor, sunDirection, wind } = shared;
    const material = new THREE.ShaderMaterial({
      uniforms: {
        ...THREE.UniformsUtils.clone(THREE.UniformsLib.fog), time, zenith, horizon, sunColor, sunDirection, wind,
        rise: { value: 0 }, light: { value: 1 }, ice: { value: 0 },
      },
      vertexShader: kVertex, fragmentShader: kFragment, transparent: true, depthWrite: false, fog: true,
    });
    this.mesh = new THREE.Mesh(waterGeometry(world.height, world.water_m, stride), material);
    this.mesh.name = 'water';
    this.mesh.visible = wet > 0;
    this.mesh.renderOrder = 1;
  }

  set(weather, day) {
    this.mesh.material.uniforms.rise.value = weather.water_rise_m ?? 0;
    this.mesh.material.uniforms.light.value = 0.12 + 0.88 * day;
  }

  dispose() {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}
