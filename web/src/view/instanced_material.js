// Material of things that stand in great numbers: each has its place, size and colour as attributes
// of its instance, and plants sway in the wind.

import * as THREE from 'three';

const kHead = /* glsl */ `
attribute vec4 place;   // x, y, z [m], yaw [rad]
attribute vec4 size;    // half length, half width, height [m], a random number
attribute vec4 color4;  // sRGB of the main part
attribute vec3 shade;
attribute float tinted, glass;
uniform float time, sway;
uniform vec3 wind;
varying vec3 vShade;
`;

const kNormal = /* glsl */ `
float yawCos = cos(place.w), yawSin = sin(place.w);
vec3 scaled = normal / max(size.xyz, vec3(0.001));
vec3 objectNormal = normalize(vec3(yawCos * scaled.x - yawSin * scaled.y, yawSin * scaled.x + yawCos * scaled.y, scaled.z));
`;

const kPosition = /* glsl */ `
float turnCos = cos(place.w), turnSin = sin(place.w);
vec3 grown = position * size.xyz;
vec3 transformed = vec3(turnCos * grown.x - turnSin * grown.y, turnSin * grown.x + turnCos * grown.y, grown.z);
float gust = sin(time * (1.1 + size.w) + place.x * 0.13 + place.y * 0.17 + size.w * 6.28) + 0.6 * sin(time * 2.7 + size.w * 20.0 + position.z * 3.0);
transformed.xy += sway * (wind.xy * 0.012 + vec2(0.006) + wind.xy * 0.008 * gust) * size.z * position.z * position.z * 0.35;
transformed += place.xyz;
`;

// Lamps behind windows, one for what lies about two metres and a storey apart; street lamps, which are
// slight, are all lit. What lies flat is water or a skylight.
const kLamps = /* glsl */ `
vec3 room = floor(grown * vec3(0.45, 0.45, 0.34)) + place.xyz;
float draw = fract(sin(dot(room, vec3(12.9898, 78.233, 37.719))) * 43758.5453);
vLamp = glass * step(abs(objectNormal.z), 0.7) * max(step(draw, 0.62), step(size.x, 0.5));`;

/** @param shared {time, wind, snowCover, lamps} uniforms; sway: 0 for what stands stiff */
export function instancedMaterials(shared, sway) {
  const uniforms = { time: shared.time, wind: shared.wind, sway: { value: sway }, snowCover: shared.snowCover, lamps: shared.lamps };
  const material = new THREE.MeshLambertMaterial({ side: sway > 0 ? THREE.DoubleSide : THREE.FrontSide });
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, uniforms);
    shader.vertexShader = kHead + 'varying float vUp, vLamp;\n' + shader.vertexShader
        .replace('#include <beginnormal_vertex>', kNormal)
        .replace('#include <begin_vertex>', kPosition + `
vec3 own = pow(color4.rgb, vec3(2.2));
vShade = mix(shade, own * (0.82 + 0.36 * size.w), tinted) * mix(1.0, 0.7 + 0.3 * smoothstep(0.0, 0.7, position.z), step(0.001, sway));
vUp = objectNormal.z;${kLamps}`);
    // Both faces of a leaf are lit alike.
    shader.fragmentShader = shader.fragmentShader.replace('#include <normal_fragment_begin>',
        'vec3 normal = normalize(vNormal);\nvec3 nonPerturbedNormal = normal;');
    shader.fragmentShader = 'varying vec3 vShade;\nvarying float vUp, vLamp;\nuniform float snowCover, lamps;\n' + shader.fragmentShader
        .replace('#include <emissivemap_fragment>', 'totalEmissiveRadiance += vec3(1.0, 0.62, 0.24) * (1.3 * lamps * step(0.5, vLamp));')
        .replace('#include <color_fragment>', `
diffuseColor.rgb = mix(vShade, vec3(0.82, 0.86, 0.92), snowCover * smoothstep(0.25, 0.75, vUp) * 0.9);`);
  };
  material.customProgramCacheKey = () => 'instanced';
  const depth = new THREE.MeshDepthMaterial({ side: THREE.DoubleSide });
  depth.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, uniforms);
    shader.vertexShader = kHead.replace(/varying.*\n/, '') + shader.vertexShader.replace('#include <begin_vertex>', kPosition);
  };
  depth.customProgramCacheKey = () => 'instanced depth';
  return { material, depth };
}
