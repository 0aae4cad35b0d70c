// The small map: layout or heights, agents, and where the camera is.

import { addressOf } from '../protocol/addresses.js';
import { byId } from './dom.js';

const kAgentColors = ['#ffffff', '#4cc9f0', '#ff7b54', '#80ed99', '#ffd166', '#c77dff'];

export class Inset {
  constructor(viewer) {
    this.viewer = viewer;
    this.canvas = byId('inset-map');
    this.context = this.canvas.getContext('2d');
    this.kind = 'layout';
    byId('inset-toggle').addEventListener('click', () => this.toggle());
  }

  toggle() {
    this.kind = this.kind === 'layout' ? 'relief' : 'layout';
    byId('inset-name').textContent = this.kind === 'layout' ? 'layout' : 'heights';
  }

  setWorld(world) {
    this.size_m = world.description.size_m;
    this.pictures = {};
    for (const kind of ['layout', 'relief']) {
      const payload = world.description.payloads[kind];
      if (!payload) continue;
      this.pictures[kind] = new Image();
      this.pictures[kind].src = addressOf(payload.url);
    }
  }

  /** Pixel of a place of the map frame. */
  #at(x_m, y_m) {
    const { width, height } = this.canvas;
    return [(x_m / this.size_m + 0.5) * width, (0.5 - y_m / this.size_m) * height];
  }

  update() {
    if (!this.size_m) return;
    const { context, canvas, viewer } = this;
    context.fillStyle = '#16202a';
    context.fillRect(0, 0, canvas.width, canvas.height);
    const picture = this.pictures[this.kind];
    if (picture?.complete && picture.naturalWidth) {
      context.imageSmoothingEnabled = this.kind !== 'layout';
      context.drawImage(picture, 0, 0, canvas.width, canvas.height);
    }
    context.lineWidth = 1.5;
    for (const { placed, position, row } of viewer.agents?.entries ?? []) {
      if (!placed) continue;
      const [x, y] = this.#at(position.x, position.y);
      context.beginPath();
      context.arc(x, y, 3.2, 0, 2 * Math.PI);
      context.fillStyle = kAgentColors[row.team % kAgentColors.length];
      context.strokeStyle = '#10151b';
      context.fill();
      context.stroke();
    }
    const eye = viewer.camera;
    const forward = eye.matrixWorld.elements;
    const yaw = Math.atan2(-forward[9], -forward[8]);
    const margin = 8;
    const [x, y] = this.#at(eye.position.x, eye.position.y);
    const cx = Math.min(Math.max(x, margin), canvas.width - margin);
    const cy = Math.min(Math.max(y, margin), canvas.height - margin);
    context.beginPath();
    context.moveTo(cx, cy);
    context.arc(cx, cy, 34, -yaw - 0.45, -yaw + 0.45);
    context.closePath();
    context.fillStyle = 'rgba(255, 255, 255, 0.35)';
    context.fill();
    context.beginPath();
    context.arc(cx, cy, 4.5, 0, 2 * Math.PI);
    context.fillStyle = '#ff3d81';
    context.strokeStyle = '#fff';
    context.fill();
    context.stroke();
  }
}
