// Light, fog and colours of the air by hour and weather, shared by all that is drawn.

import * as THREE from 'three';
import { clamp } from '../protocol/payloads.js';

const kLeastVisibility_m = 12;
const kVeiled_m = [60, 500];  // nothing of the sky is seen, all of it
// Eyes get used to the dark: nights show shapes.
const kMoonlight = 0.7;
const kNightSky = 1.1;
const kFarthestSight_m = 3000;  // on a clear day, so that the land ends in haze

/** Colours by the sun's elevation: [sine of it, zenith, horizon, sun]; in between they blend. */
const kSkies = [
  [-0.3, 0x05070f, 0x0b1020, 0x000000],
  [-0.1, 0x0e1631, 0x2b2d4a, 0x2a2030],
  [0.0, 0x2c4276, 0xd98a5c, 0xff8a3c],
  [0.15, 0x3c6cb4, 0xe8c9a0, 0xffcf94],
  [0.4, 0x2f74c8, 0xb9d8ef, 0xfff0d8],
  [1.0, 0x1f66bf, 0xa9d0ee, 0xfff8ee],
].map(([sine, ...colors]) => [sine, ...colors.map((hex) => new THREE.Color(hex))]);

function skyColor(sine, which, target) {
  let k = 0;
  while (k < kSkies.length - 2 && sine > kSkies[k + 1][0]) k++;
  const share = clamp((sine - kSkies[k][0]) / (kSkies[k + 1][0] - kSkies[k][0]), 0, 1);
  return target.lerpColors(kSkies[k][1 + which], kSkies[k + 1][1 + which], share);
}

const kGrey = new THREE.Color(0xaab2bb);
const kStormGrey = new THREE.Color(0x7c858f);
const kSand = new THREE.Color(0xc79a5e);

export class Atmosphere {
  constructor(scene) {
    /** Uniforms that materials share by reference. */
    this.uniforms = {
      time: { value: 0 }, wind: { value: new THREE.Vector3() }, wetness: { value: 0 }, snowCover: { value: 0 },
      sunDirection: { value: new THREE.Vector3(0, 0, 1) }, sunColor: { value: new THREE.Color() },
      zenith: { value: new THREE.Color() }, horizon: { value: new THREE.Color() },
      clouds: { value: 0 }, night: { value: 0 }, veil: { value: 0 }, lamps: { value: 0 },
    };
    this.sun = new THREE.DirectionalLight(0xffffff, 3);
    this.sky = new THREE.HemisphereLight(0xffffff, 0x806a50, 1);
    this.sky.position.set(0, 0, 1);
    scene.fog = new THREE.FogExp2(0xffffff, 0.001);
    this.fog = scene.fog;
    scene.add(this.sun, this.sun.target, this.sky);
    this.weather = {};
  }

  /** weather: a message `weather`, or `atmosphere` of world.json. */
  set(weather) {
    this.weather = { ...this.weather, ...weather };
    const w = this.weather;
    const u = this.uniforms;
    u.sunDirection.value.fromArray(w.sun_direction ?? [0.3, 0.2, 0.9]).normalize();
    const sine = u.sunDirection.value.z;
    const day = clamp((sine + 0.15) / 0.24, 0, 1);
    const cover = clamp(w.cloud_cover ?? 0, 0, 1);
    const grey = (cover > 0.5 ? kGrey.clone().lerp(kStormGrey, (cover - 0.5) * 2 * (w.rain_mmph > 0 ? 1 : 0.3)) : kGrey.clone())
        .multiplyScalar(0.04 + 0.9 * day);
    const sand = kSand.clone().multiplyScalar(0.05 + 0.85 * day);
    const haze = 0.85 * cover ** 1.5;
    skyColor(sine, 0, u.zenith.value).lerp(grey, haze * 0.9).lerp(sand, 0.9 * (w.blown_sand ?? 0));
    skyColor(sine, 1, u.horizon.value).lerp(grey, haze).lerp(sand, w.blown_sand ?? 0);
    skyColor(sine, 2, u.sunColor.value);
    u.clouds.value = cover;
    u.night.value = 1 - clamp((sine + 0.15) / 0.2, 0, 1);
    u.lamps.value = 1 - clamp((sine + 0.02) / 0.1, 0, 1);
    u.wetness.value = clamp(w.ground_wetness ?? 0, 0, 1);
    u.snowCover.value = clamp((w.snow_depth_m ?? 0) / 0.05, 0, 1);
    u.wind.value.fromArray(w.wind_mps ?? [1, 0, 0]);

    // Moonlight where the sun is down, so that nights can be seen.
    const up = sine > -0.02;
    this.lightDirection = up ? u.sunDirection.value.clone() : new THREE.Vector3(-0.4, 0.3, 0.85).normalize();
    if (up) this.lightDirection.z = Math.max(this.lightDirection.z, 0.12);
    this.lightDirection.normalize();
    this.sun.color.copy(up ? u.sunColor.value : new THREE.Color(0x7f95c8));
    this.sun.intensity = up ? 3.0 * clamp(w.sun_intensity ?? 1, 0, 1) * clamp(0.25 + sine * 4, 0, 1) : kMoonlight * (1 - 0.6 * cover);
    // The sky's light has the sky's tint, and a brightness of its own: skies look dark where eyes adapt.
    const tint = (color) => color.multiplyScalar(1 / Math.max(color.r, color.g, color.b, 0.001)).lerp(new THREE.Color(0xffffff), 0.4);
    this.sky.color.copy(tint(u.zenith.value.clone().lerp(u.horizon.value, 0.4)));
    this.sky.groundColor.copy(tint(u.horizon.value.clone())).multiplyScalar(0.6).lerp(new THREE.Color(0x8a7558), 0.35);
    this.sky.intensity = kNightSky + (0.45 - kNightSky) * day + 2.4 * (0.45 + 0.55 * clamp(w.ambient_intensity ?? 0.4, 0, 1)) * day;

    this.fog.color.copy(u.horizon.value);
    const sight_m = clamp(w.visibility_m ?? kFarthestSight_m, kLeastVisibility_m, kFarthestSight_m);
    u.veil.value = 1 - clamp((sight_m - kVeiled_m[0]) / (kVeiled_m[1] - kVeiled_m[0]), 0, 1);
    this.fog.density = 1.978 / sight_m;  // 2 % of the contrast is left at the visibility
  }

  /** Shadows around a place. radius_m: half the side of the square that has them. */
  placeShadows(focus, radius_m) {
    const { sun } = this;
    const texel = (2 * radius_m) / sun.shadow.mapSize.x;
    // Whole texels, so that edges do not crawl as the place moves.
    sun.target.position.set(Math.round(focus.x / texel) * texel, Math.round(focus.y / texel) * texel, Math.round(focus.z));
    sun.position.copy(sun.target.position).addScaledVector(this.lightDirection ?? new THREE.Vector3(0, 0, 1), 3 * radius_m);
    const camera = sun.shadow.camera;
    if (camera.right !== radius_m) {
      camera.left = camera.bottom = -radius_m;
      camera.right = camera.top = radius_m;
      camera.near = 0.1;
      camera.far = 6 * radius_m;
      camera.updateProjectionMatrix();
      sun.shadow.normalBias = texel * 1.5;
      sun.shadow.bias = -0.0004;
    }
  }
}
