// Names, states and health of agents, as text over the picture.

import * as THREE from 'three';

const kMostLabels = 28;
const kFurthest_m = 130;
const kTeamColors = ['#9fb3c8', '#4cc9f0', '#f4845f', '#80ed99', '#ffd166', '#c77dff'];

export class Labels {
  constructor(container) {
    this.container = container;
    this.enabled = true;
    this.pool = [];
    this.shown = 0;
  }

  update(entries, behaviours, camera, width, height) {
    const place = new THREE.Vector3();
    const near = [];
    if (this.enabled) {
      for (const entry of entries) {
        if (!entry.placed) continue;
        const distance = entry.position.distanceTo(camera.position);
        if (distance < kFurthest_m) near.push({ entry, distance });
      }
      near.sort((a, b) => a.distance - b.distance);
    }
    let used = 0;
    for (const { entry, distance } of near) {
      if (used === kMostLabels) break;
      place.copy(entry.position);
      place.z += entry.shape.height_m + 0.35;
      place.project(camera);
      if (place.z > 1 || Math.abs(place.x) > 1.05 || Math.abs(place.y) > 1.05) continue;
      this.#show(used++, entry, behaviours, ((place.x + 1) / 2) * width, ((1 - place.y) / 2) * height, distance);
    }
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
