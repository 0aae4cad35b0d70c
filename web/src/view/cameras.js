// Ways to look: orbit around a place, fly freely, follow an agent.

import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { clamp } from '../protocol/payloads.js';

const kLeastAboveGround_m = 0.6;
const kFlySpeed_mps = 18;

export class Cameras {
  constructor(camera, element) {
    this.camera = camera;
    this.element = element;
    this.mode = 'orbit';
    this.heightAt = () => 0;
    this.target = null;  // entry of Bodies that is followed
    this.follow = { yaw: 0, pitch: 0.32, distance_m: 7, heading: null };
    this.keys = new Set();
    this.orbit = new OrbitControls(camera, element);
    this.orbit.enableDamping = true;
    this.orbit.dampingFactor = 0.09;
    this.orbit.maxPolarAngle = Math.PI / 2 - 0.03;
    this.orbit.minDistance = 2;
    this.orbit.screenSpacePanning = false;
    this.orbit.zoomToCursor = true;
    this.#listen();
  }

  /** Looks at a whole world. */
  frameWorld(size_m, heightAt) {
    this.heightAt = heightAt;
    this.size_m = size_m;
    this.orbit.maxDistance = 2.2 * size_m;
    this.orbit.target.set(0, 0, heightAt(0, 0));
    this.camera.position.set(0.1 * size_m, -0.62 * size_m, heightAt(0, 0) + 0.34 * size_m);
    this.set('orbit');
  }

  /** mode: 'orbit', 'fly', 'follow' (with the entry of an agent). */
  set(mode, target = null) {
    if (mode === 'follow' && !target) mode = 'orbit';
    const forward = this.camera.getWorldDirection(new THREE.Vector3());
    if (mode === 'orbit' && this.mode !== 'orbit') {
      const away = clamp(this.mode === 'follow' ? this.follow.distance_m * 2 : 25, 4, 200);
      this.orbit.target.copy(this.camera.position).addScaledVector(forward, away);
      this.orbit.target.z = Math.max(this.orbit.target.z, this.heightAt(this.orbit.target.x, this.orbit.target.y));
    }
    if (mode === 'fly') {
      this.flyYaw = Math.atan2(forward.y, forward.x);
      this.flyPitch = Math.asin(clamp(forward.z, -1, 1));
    }
    if (mode === 'follow' && target !== this.target) {
      const size = Math.max(target.shape?.height_m ?? 1, 0.5);
      Object.assign(this.follow, { yaw: 0, pitch: 0.3, distance_m: clamp(4.5 * size + 2, 4, 16), heading: null });
    }
    this.mode = mode;
    this.target = target;
    this.orbit.enabled = mode === 'orbit';
    this.element.dispatchEvent(new CustomEvent('cameramode', { bubbles: true, detail: mode }));
  }

  #listen() {
    let last = null;
    this.element.addEventListener('pointerdown', (event) => {
      if (this.mode === 'orbit') return;
      last = { id: event.pointerId, x: event.clientX, y: event.clientY };
      this.element.setPointerCapture(event.pointerId);
    });
    this.element.addEventListener('pointermove', (event) => {
      if (!last || last.id !== event.pointerId) return;
      this.#turn((event.clientX - last.x) * 0.005, (event.clientY - last.y) * 0.005);
      last.x = event.clientX;
      last.y = event.clientY;
    });
    for (const end of ['pointerup', 'pointercancel']) this.element.addEventListener(end, () => { last = null; });
    this.element.addEventListener('wheel', (event) => {
      if (this.mode !== 'follow') return;
      event.preventDefault();
      this.follow.distance_m = clamp(this.follow.distance_m * Math.exp(event.deltaY * 0.001), 1.5, 80);
    }, { passive: false });
  }

  #turn(right, down) {
    if (this.mode === 'fly') {
      this.flyYaw -= right;
      this.flyPitch = clamp(this.flyPitch - down, -1.5, 1.5);
    } else {
      this.follow.yaw -= right;
      this.follow.pitch = clamp(this.follow.pitch + down, -0.15, 1.45);
    }
  }

  update(seconds) {
    if (this.mode === 'orbit') this.orbit.update(seconds);
    else if (this.mode === 'fly') this.#fly(seconds);
    else this.#follow(seconds);
    const { position } = this.camera;
    position.z = Math.max(position.z, this.heightAt(position.x, position.y) + kLeastAboveGround_m);
  }

  #fly(seconds) {
    const { camera, keys } = this;
    const forward = new THREE.Vector3(Math.cos(this.flyYaw) * Math.cos(this.flyPitch), Math.sin(this.flyYaw) * Math.cos(this.flyPitch), Math.sin(this.flyPitch));
    const right = new THREE.Vector3(Math.sin(this.flyYaw), -Math.cos(this.flyYaw), 0);
    const step = kFlySpeed_mps * seconds * (keys.has('ShiftLeft') ? 4 : 1);
    const way = (plus, minus) => (plus.some((key) => keys.has(key)) ? 1 : 0) - (minus.some((key) => keys.has(key)) ? 1 : 0);
    camera.position.addScaledVector(forward, step * way(['KeyW', 'ArrowUp'], ['KeyS', 'ArrowDown']));
    camera.position.addScaledVector(right, step * way(['KeyD', 'ArrowRight'], ['KeyA', 'ArrowLeft']));
    camera.position.z += step * way(['KeyE'], ['KeyQ']);
    camera.lookAt(camera.position.clone().add(forward));
  }

  #follow(seconds) {
    const { camera, follow, target } = this;
    const ahead = new THREE.Vector3(1, 0, 0).applyQuaternion(target.rotation);
    const heading = Math.atan2(ahead.y, ahead.x);
    if (follow.heading === null) follow.heading = heading;
    const turn = Math.atan2(Math.sin(heading - follow.heading), Math.cos(heading - follow.heading));
    follow.heading += turn * (1 - Math.exp(-3.5 * seconds));
    const yaw = follow.heading + follow.yaw;
    const focus = target.position.clone();
    focus.z += 0.6 * (target.shape?.height_m ?? 1);
    const flat = follow.distance_m * Math.cos(follow.pitch);
    const wanted = new THREE.Vector3(focus.x - flat * Math.cos(yaw), focus.y - flat * Math.sin(yaw), focus.z + follow.distance_m * Math.sin(follow.pitch));
    wanted.z = Math.max(wanted.z, this.heightAt(wanted.x, wanted.y) + kLeastAboveGround_m);
    const far = camera.position.distanceToSquared(wanted) > 60 * 60;
    camera.position.lerp(wanted, far ? 1 : 1 - Math.exp(-9 * seconds));
    camera.lookAt(focus);
  }
}
