// The sky: a dome with sun, clouds and stars, in the colours of the atmosphere.

import * as THREE from 'three';

const kVertex = /* glsl */ `
varying vec3 vDirection;
void main() {
  vDirection = position;
  vec4 place = projectionMatrix * vec4(mat3(viewMatrix) * position, 1.0);
  gl_Position = place.xyww;
}`;

const kFragment = /* glsl */ `
uniform vec3 zenith, horizon, sunColor, sunDirection, wind;
uniform float clouds, night, time, veil;
varying vec3 vDirection;

float hash(vec2 p) { return fract(sin(dot(p, vec2(127.1, 311.7))) * 43758.5453); }
float noise(vec2 p) {
  vec2 i = floor(p), f = fract(p);
  f = f * f * (3.0 - 2.0 * f);
  return mix(mix(hash(i), hash(i + vec2(1, 0)), f.x), mix(hash(i + vec2(0, 1)), hash(i + vec2(1, 1)), f.x), f.y);
}
float fbm(vec2 p) {
  float sum = 0.0, weight = 0.5;
  for (int i = 0; i < 5; i++) { sum += weight * noise(p); p = p * 2.03 + 17.0; weight *= 0.5; }
  return sum;
}

void main() {
  vec3 d = normalize(vDirection);
  float up = max(d.z, 0.0);
  vec3 color = mix(horizon, zenith, 1.0 - pow(1.0 - up, 3.2));
  float toSun = max(dot(d, sunDirection), 0.0);
  float clear = 1.0 - clouds * 0.92;
  color += sunColor * clear * (pow(toSun, 12.0) * 0.16 + pow(toSun, 180.0) * 0.35);
  color += sunColor * clear * smoothstep(0.99955, 0.9998, toSun) * 6.0 * step(-0.02, sunDirection.z);
  if (night > 0.01 && up > 0.0) {
    vec3 cell = floor(d * 190.0);
    float star = step(0.9975, hash(cell.xy + cell.z * 13.7));
    color += star * night * clear * smoothstep(0.02, 0.3, up) * hash(cell.yx) * 0.9;
  }
  if (clouds > 0.01 && d.z > 0.01) {
    vec2 at = d.xy / (d.z + 0.08) * 1.3 + wind.xy * time * 0.0006;
    float density = fbm(at) + 0.35 * fbm(at * 2.7 + 5.0) - 0.18;
    float cover = smoothstep(0.86 - 0.78 * clouds, 1.06 - 0.72 * clouds, density + 0.22);
    vec3 lit = mix(horizon, vec3(dot(zenith, vec3(0.333))), 0.3) * (1.12 - 0.42 * smoothstep(0.4, 1.0, density)) + sunColor * 0.2 * clear;
    color = mix(color, lit, cover * smoothstep(0.01, 0.16, d.z) * 0.92);
  }
  gl_FragColor = vec4(color, 1.0);
  #include <tonemapping_fragment>
  #include <colorspace_fragment>
  // Lower down there is more air before the sky: at the horizon it ends in the haze that the land ends in, which
  // is of that colour as it is seen, without tone mapping.
  float haze = max(smoothstep(0.03, -0.01, d.z), 1.0 - pow(1.0 - veil, 0.6 / max(up, 0.02)));
  gl_FragColor.rgb = mix(gl_FragColor.rgb, linearToOutputTexel(vec4(horizon, 1.0)).rgb, haze);
}`;

export function makeSky(uniforms) {
  const { zenith, horizon, sunColor, sunDirection, wind, clouds, night, time, veil } = uniforms;
  const material = new THREE.ShaderMaterial({
    uniforms: { zenith, horizon, sunColor, sunDirection, wind, clouds, night, time, veil },
    vertexShader: kVertex, fragmentShader: kFragment, side: THREE.BackSide, depthWrite: false,
  });
  const sky = new THREE.Mesh(new THREE.SphereGeometry(1, 32, 24).rotateX(Math.PI / 2), material);
  sky.name = 'sky';
  sky.frustumCulled = false;
  sky.renderOrder = -1;
  return sky;
}
