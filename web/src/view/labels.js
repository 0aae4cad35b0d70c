// Names, states and health of agents, as text over the picture.

import * as THREE from 'three';
import { chooseLabels } from './label_places.js';

const kMostLabels = 28;
const kFurthest_m = 130;
const kKeep = 0.85;  // whose label is shown counts as that much nearer, so that labels do not flicker
const kTeamColors = ['#9fb3c8', '#4cc9f0', '#f4845f', '#80ed99', '#ffd166', '#c77dff'];

export class Labels {
  constructor(container) {
    this.container = container;
    this.enabled = true;
    this.pool = [];
    this.shown = 0;
    this.named = new Set();  // whose labels are shown
  }

  update(entries, behaviours, camera, width, height) {
    const place = new THREE.Vector3();
    const wanted = [];
    for (const entry of this.enabled ? entries : []) {
      if (!entry.placed) continue;
      const distance = entry.position.distanceTo(camera.position);
      if (distance >= kFurthest_m) continue;
      place.copy(entry.position);
      place.z += entry.shape.height_m + 0.35;
      place.project(camera);
      if (place.z > 1 || Math.abs(place.x) > 1.05 || Math.abs(place.y) > 1.05) continue;
      const rank = distance * (this.named.has(entry.name) ? kKeep : 1);
      wanted.push({ entry, distance, rank, x: ((place.x + 1) / 2) * width, y: ((1 - place.y) / 2) * height });
    }
    wanted.sort((a, b) => a.rank - b.rank);
    const chosen = chooseLabels(wanted, kMostLabels);
    chosen.forEach(({ entry, x, y, distance }, index) => this.#show(index, entry, behaviours, x, y, distance));
    this.named = new Set(chosen.map(({ entry }) => entry.name));
    const used = chosen.length;
    for (let i = used; i < this.pool.length; i++) this.pool[i].root.hidden = true;
    this.shown = used;
  }

  #show(index, entry, behaviours, x, y, distance) {
    const label = this.pool[index] ?? this.#add();
    label.root.hidden = false;
    label.root.style.transform = `translate(-50%, -100%) translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
    label.root.style.opacity = Math.min(1, (kFurthest_m - distance) / 40).toFixed(2);
    const { row, thing } = entry;
    const state = behaviours[thing.behaviour] ?? '';
    const text = `${entry.name}|${state}|${thing.health}|${row.team}`;
    if (label.text === text) return;
    label.text = text;
    label.name.textContent = entry.name;
    label.state.textContent = state;
    label.root.style.setProperty('--team', kTeamColors[row.team % kTeamColors.length]);
    label.health.style.width = `${(thing.health / 2.55).toFixed(0)}%`;
    label.health.style.background = thing.health > 150 ? '#5dd39e' : thing.health > 70 ? '#ffd166' : '#ef476f';
    label.root.classList.toggle('hurt', thing.health < 255);
  }

  #add() {
    const root = document.createElement('div');
    root.className = 'label';
    const [name, state, bar, health] = ['b', 'span', 'i', 'i'].map((tag) => document.createElement(tag));
    bar.append(health);
    root.append(name, state, bar);
    this.container.append(root);
    const label = { root, name, state, health, text: '' };
    this.pool.push(label);
    return label;
  }
}
