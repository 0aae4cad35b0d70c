// The panel: tabs, the form that creates worlds, weather, saved worlds, layers, access.

import { byId, etaText, make, toast } from './dom.js';

const kTabs = ['create', 'worlds', 'agents', 'view'];
const kNarrow_px = 760;           // as in style.css
const kProgressSilence_ms = 10000;  // who hears nothing more for so long takes a generation as over

function showTab(name) {
  for (const tab of kTabs) {
    byId(`tab-${tab}`).setAttribute('aria-selected', String(tab === name));
    byId(`tab-${tab}`).tabIndex = tab === name ? 0 : -1;
    byId(`page-${tab}`).hidden = tab !== name;
  }
}

function makeTabs(onShow) {
  kTabs.forEach((name, index) => {
    const tab = byId(`tab-${name}`);
    tab.addEventListener('click', () => {
      showTab(name);
      onShow(name);
    });
    tab.addEventListener('keydown', (event) => {
      const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      if (!step) return;
      event.stopPropagation();
      const next = kTabs[(index + step + kTabs.length) % kTabs.length];
      byId(`tab-${next}`).focus();
      byId(`tab-${next}`).click();
    });
  });
}

export class Panel {
  /** request: (message) -> Promise of the reply; viewer: the picture */
  constructor(request, viewer, { subscribe }) {
    this.request = request;
    this.viewer = viewer;
    makeTabs((name) => {
      if (name === 'worlds') this.listWorlds();
    });
    byId('panel-toggle').addEventListener('click', () => this.toggle());
    this.makeRoom();
    this.#makeForms();
    this.#makeLayers(subscribe);
  }

  toggle() {
    const closed = byId('panel').classList.toggle('closed');
    byId('panel-toggle').setAttribute('aria-expanded', String(!closed));
  }

  /** Closes where the screen is so narrow that it lies over the view. */
  makeRoom() {
    if (innerWidth <= kNarrow_px && !byId('panel').classList.contains('closed')) this.toggle();
  }

  /** Sends a request; what fails is shown. */
  async ask(message) {
    try {
      return await this.request(message);
    } catch (error) {
      toast(error.message, 'error');
      return null;
    }
  }

  #makeForms() {
    byId('generate').addEventListener('submit', (event) => {
      event.preventDefault();
      this.generate();
    });
    byId('cancel').addEventListener('click', () => this.ask({ type: 'cancel' }));
    byId('weather').addEventListener('input', () => {
      this.weatherTouched = true;
      this.#showHour();
    });
    byId('weather').addEventListener('submit', (event) => {
      event.preventDefault();
      this.weatherTouched = false;
      this.ask({
        type: 'set_weather', weather: byId('weather-kind').value, intensity: Number(byId('weather-intensity').value),
        hour: Number(byId('weather-hour').value) % 24, transition_s: 3,
      });
    });
    byId('save').addEventListener('submit', async (event) => {
      event.preventDefault();
      const name = byId('save-name').value.trim();
      if (await this.ask({ type: 'save_world', name })) {
        toast(`Saved as ${name}.`);
        this.listWorlds();
      }
    });
    byId('refresh-worlds').addEventListener('click', () => this.listWorlds());
    byId('access').addEventListener('submit', (event) => {
      event.preventDefault();
      this.ask({ type: 'authenticate', token: byId('token').value });
      byId('token').value = '';
    });
  }

  #showHour() {
    const minutes = Math.round(byId('weather-hour').value * 60) % 1440;
    byId('hour-text').textContent = `${Math.floor(minutes / 60)}:${String(minutes % 60).padStart(2, '0')}`;
  }

  /** The form begins with the weather that there is, and leaves alone what somebody has begun to choose. */
  showWeather({ weather, intensity, hour }) {
    if (this.weatherTouched || byId('weather').contains(document.activeElement)) return;
    if ([...byId('weather-kind').options].some(({ value }) => value === weather)) byId('weather-kind').value = weather;
    byId('weather-intensity').value = intensity;
    byId('weather-hour').value = hour;
    this.#showHour();
  }

  async generate() {
    const message = { type: 'generate', layout: byId('layout-text').value.trim(), environment: byId('environment-text').value.trim() };
    const seed = byId('seed').value.trim();
    if (seed) message.seed = seed;
    if (byId('size').value) message.size_m = Number(byId('size').value);
    if (byId('vocabulary').value) message.vocabulary = byId('vocabulary').value;
    this.generating = true;
    byId('generate').querySelector('.primary').disabled = true;
    this.showProgress({ stage: 'starting', fraction: 0, eta_s: -1 });
    await this.ask(message);
    this.generating = false;
    byId('generate').querySelector('.primary').disabled = false;
    byId('progress').hidden = true;
  }

  showProgress({ stage, fraction, eta_s }) {
    byId('progress').hidden = false;
    byId('progress-stage').textContent = `${stage} · ${Math.round(100 * fraction)} %`;
    byId('progress-bar').value = fraction;
    byId('progress-eta').textContent = etaText(eta_s);
    clearTimeout(this.progressTimer);
    if (fraction >= 1 && stage === 'viewer') byId('progress').hidden = true;
    else if (!this.generating) {
      this.progressTimer = setTimeout(() => { byId('progress').hidden = true; }, kProgressSilence_ms);
    }
  }

  async listWorlds() {
    const reply = await this.ask({ type: 'list_worlds' });
    if (!reply) return;
    byId('worlds').replaceChildren(...(reply.worlds ?? []).map(({ name, id, layout }) => {
      const load = make('button', {}, 'Load');
      load.setAttribute('aria-label', `Load ${name}`);
      load.addEventListener('click', async () => {
        load.disabled = true;
        await this.ask({ type: 'load_world', name });
        load.disabled = false;
      });
      return make('li', {}, make('div', {}, name, make('small', { title: layout || id }, layout || id)), load);
    }));
    if (!reply.worlds?.length) byId('worlds').append(make('li', { className: 'quiet' }, 'No world has been saved.'));
  }

  #makeLayers(subscribe) {
    const { viewer } = this;
    const on = (id, act) => byId(id).addEventListener('change', ({ target }) => act(target.checked));
    on('layer-names', (checked) => { viewer.labels.enabled = checked; });
    on('layer-lidar', subscribe);
    on('layer-paths', subscribe);
    on('layer-classes', () => this.applyLayers());
    on('layer-plants', () => this.applyLayers());
    on('layer-water', () => this.applyLayers());
    byId('quality').addEventListener('change', ({ target }) => viewer.chooseQuality(target.value));
  }

  /** Puts the layers' switches into effect; for another world, too. */
  applyLayers() {
    const { viewer } = this;
    if (!viewer.world) return;
    viewer.terrain.classOverlay = byId('layer-classes').checked ? 0.7 : 0;
    viewer.scenery.group.visible = byId('layer-plants').checked;
    viewer.water.mesh.visible = byId('layer-water').checked && viewer.water.mesh.geometry.index.count > 0;
  }

  /** Who may only look sees what they may not do. */
  setRole(role, tokenAccepted, moves) {
    const may = role === 'controller';
    byId('role').textContent = may ? 'This page controls the world.' : tokenAccepted ? 'View only: enter the token to control.' : 'View only.';
    byId('access').hidden = may || !tokenAccepted;
    for (const id of ['generate', 'weather', 'save']) {
      for (const field of byId(id).elements) field.disabled = !may || !moves;
    }
    for (const id of ['play', 'step', 'reset', 'speed']) byId(id).disabled = !may || !moves;
    byId('time').hidden = !moves;
  }
}
