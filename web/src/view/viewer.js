// The picture: everything of a world on one canvas.

import * as THREE from 'three';
import { clamp } from '../protocol/payloads.js';
import { Atmosphere } from './atmosphere.js';
import { Bodies } from './bodies.js';
import { Bridges } from './bridges.js';
import { Cameras } from './cameras.js';
import { FelledTrees } from './felled_trees.js';
import { Labels } from './labels.js';
import { LidarLayer, PathLayer } from './layers.js';
import { ModelLibrary } from './models.js';
import { Precipitation } from './precipitation.js';
import { QualityGovernor, kQualitySteps } from './quality.js';
import { Scenery } from './scenery.js';
import { agentShapes, elementShapes } from './shapes.js';
import { makeSky } from './sky.js';
import { Terrain } from './terrain.js';
import { Water } from './water.js';

const kFieldOfView_deg = 55;

/** Whether there is no graphics card, so that the processor draws. */
function drawsInSoftware() {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (!gl) throw new Error('This browser has no WebGL 2.');
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  const name = info ? gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : '';
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|software/i.test(name);
}

export class Viewer extends EventTarget {
  constructor(canvas, labelContainer) {
    super();
    this.canvas = canvas;
    const software = drawsInSoftware();
    this.software = software;
    // Panes of frosted glass cost the processor more than the world.
    document.body.classList.toggle('plain', software);
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: !software, powerPreference: 'high-performance' });
    this.renderer.toneMapping = THREE.NeutralToneMapping;
    this.renderer.toneMappingExposure = 1;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = THREE.PCFShadowMap;
    this.renderer.info.autoReset = false;
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(kFieldOfView_deg, 1, 0.2, 9000);
    this.camera.up.set(0, 0, 1);
    this.cameras = new Cameras(this.camera, canvas);
    this.atmosphere = new Atmosphere(this.scene);
    this.sky = makeSky(this.atmosphere.uniforms);
    this.precipitation = new Precipitation(this.atmosphere.uniforms);
    this.lidar = new LidarLayer();
    this.scene.add(this.sky, this.precipitation.mesh, this.lidar.object);
    this.labels = new Labels(labelContainer);
    this.quality = new QualityGovernor(software ? kQualitySteps.length - 1 : 1);
    this.leastFrame_ms = software ? 80 : 0;  // leaves the processor something for the page
    this.override = null;  // a camera of tests and pictures
    this.world = null;
    this.furnished = false;
    this.stats = { fps: 0, frames: 0, draw_calls: 0, triangles: 0 };
    this.lastFrame_ms = performance.now();
    this.#applyQuality();
    new ResizeObserver(() => this.#resize()).observe(canvas);
    canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();
      this.dispatchEvent(new CustomEvent('lost'));
    });
    this.renderer.setAnimationLoop((now_ms) => this.#frame(now_ms));
  }

  /**
   * Shows the land of a world that readWorld() read, and who moves in it as plain bodies; furnish() puts the
   * rest there. keepCamera: where it has the size of the one before.
   */
  async setWorld(world, keepCamera) {
    const nothing = await ModelLibrary.read(null);
    const size_m = world.description.size_m;
    const sameSize = this.world?.description.size_m === size_m;
    this.#clear();
    const shared = this.atmosphere.uniforms;
    const anisotropy = this.software ? 1 : Math.min(this.renderer.capabilities.getMaxAnisotropy(), 8);
    this.world = world;
    this.terrain = new Terrain(world, shared, { anisotropy });
    this.water = new Water(world, shared);
    this.bridges = new Bridges(world.description);
    this.paths = new PathLayer((x, y) => world.height.at(x, y));
    for (const part of [this.terrain, this.water, this.bridges, this.paths]) this.scene.add(part.group ?? part.mesh);
    const { description } = world;
    this.#fill({ ...world, description: { ...description, assets: { ...description.assets, groups: [] } } }, nothing);
    this.setWeather(world.description.atmosphere);
    const heightAt = (x, y) => world.height.at(x, y);
    if (keepCamera && sameSize) this.cameras.set('orbit');
    else this.cameras.frameWorld(size_m, heightAt);
    this.cameras.heightAt = heightAt;
    this.#applyQuality();
  }

  /** Puts plants, buildings and bodies into the world that is shown. bytes: of readModels(). */
  async furnish(world, bytes) {
    const models = await ModelLibrary.read(bytes);
    if (this.world !== world) return;  // another came meanwhile
    this.#empty();
    this.#fill(world, models);
    this.furnished = true;
    this.#applyQuality();
  }

  /** What is made of models. */
  #fill(world, models) {
    this.scenery = new Scenery(world, models, this.atmosphere.uniforms);
    this.felled = new FelledTrees(this.scenery);
    this.agents = new Bodies('agents', agentShapes(world.description, models));
    this.elements = new Bodies('elements', elementShapes(world.description, models));
    this.movables = [this.felled, this.scenery, this.agents, this.elements];
    for (const part of this.movables) this.scene.add(part.group);
  }

  #empty() {
    for (const part of this.movables) {
      this.scene.remove(part.group);
      part.dispose();
    }
  }

  #clear() {
    if (!this.world) return;
    this.furnished = false;
    this.cameras.set('orbit');
    this.paths.clear();
    this.#empty();
    for (const part of [this.terrain, this.water, this.bridges, this.paths]) this.scene.remove(part.group ?? part.mesh);
    for (const part of [this.terrain, this.water, this.bridges]) part.dispose();
    this.lidar.set(null);
    this.world = null;
  }

  setWeather(weather) {
    this.atmosphere.set(weather);
    const day = 1 - 0.9 * this.atmosphere.uniforms.night.value;
    this.precipitation.set(this.atmosphere.weather, day);
    this.water?.set(this.atmosphere.weather, day);
  }

  /** A step of kQualitySteps by name, or 'auto'. */
  chooseQuality(name) {
    this.quality.choose(name);
    this.#applyQuality();
  }

  #applyQuality() {
    const { pixels, shadowMap, detail } = this.quality.settings;
    const ratio = Math.min(globalThis.devicePixelRatio || 1, pixels);
    this.renderer.setPixelRatio(ratio);
    const { sun } = this.atmosphere;
    sun.castShadow = shadowMap > 0;
    if (shadowMap > 0 && sun.shadow.mapSize.x !== shadowMap) {
      sun.shadow.mapSize.set(shadowMap, shadowMap);
      sun.shadow.map?.dispose();
      sun.shadow.map = null;
    }
    if (this.terrain) this.terrain.uniforms.detail.value = detail;
    if (this.scenery) this.scenery.dirty = true;
    this.#resize();
  }

  #resize() {
    const { clientWidth, clientHeight } = this.canvas;
    if (!clientWidth || !clientHeight) return;
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
  }

  #frame(now_ms) {
    const duration_ms = now_ms - this.lastFrame_ms;
    if (duration_ms < this.leastFrame_ms) return;
    this.lastFrame_ms = now_ms;
    const seconds = Math.min(duration_ms / 1000, 0.1);
    if (!document.hidden && this.quality.frame(duration_ms)) this.#applyQuality();
    this.stats.frames++;
    if (duration_ms > 0) this.stats.fps += (1000 / duration_ms - this.stats.fps) * 0.08;
    this.dispatchEvent(new CustomEvent('frame', { detail: { now_ms, seconds } }));
    this.render(seconds);
  }

  render(seconds) {
    const now_ms = performance.now();
    const { atmosphere, camera, quality } = this;
    atmosphere.uniforms.time.value = (now_ms / 1000) % 3600;
    if (this.world) {
      this.agents.update(now_ms);
      this.elements.update(now_ms);
      this.felled.update(seconds);
      this.cameras.update(seconds);
    }
    const eye = this.override ?? camera;
    eye.updateMatrixWorld();
    eye.matrixWorldInverse.copy(eye.matrixWorld).invert();
    if (this.world) this.#choose(eye, quality.settings);
    this.renderer.info.reset();
    this.renderer.render(this.scene, eye);
    this.stats.draw_calls = this.renderer.info.render.calls;
    this.stats.triangles = this.renderer.info.render.triangles;
    if (this.world) {
      this.labels.update(this.override ? [] : this.agents.entries, this.world.description.behaviours, eye, this.canvas.clientWidth, this.canvas.clientHeight);
    }
  }

  /** What of the world is drawn from there. */
  #choose(eye, settings) {
    const frustum = new THREE.Frustum().setFromProjectionMatrix(new THREE.Matrix4().multiplyMatrices(eye.projectionMatrix, eye.matrixWorldInverse));
    this.terrain.update(eye, frustum, Math.min(1, 1.5 * settings.plants));
    const sight_m = 1.15 * 1.978 / this.atmosphere.fog.density;
    const high_m = eye.position.z - this.world.height.at(eye.position.x, eye.position.y);
    const radius_m = Math.round(clamp(settings.shadowRadius_m * Math.max(1, high_m / 30), 20, 400) / 20) * 20;
    this.scenery.update(eye, frustum, settings.plants, this.override ? Infinity : sight_m, radius_m);
    this.precipitation.update(eye, settings.particles);
    const focus = this.cameras.mode === 'orbit' ? this.cameras.orbit.target.clone()
        : eye.position.clone().addScaledVector(eye.getWorldDirection(new THREE.Vector3()), 0.5 * radius_m);
    if (this.atmosphere.sun.castShadow) this.atmosphere.placeShadows(focus, radius_m);
    else {
      const { sun, lightDirection } = this.atmosphere;
      sun.target.position.copy(focus);
      sun.position.copy(focus).addScaledVector(lightDirection, 100);
    }
  }
}
