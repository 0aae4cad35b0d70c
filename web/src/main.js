// The page: connects to the server, shows its world, and does what the user asks.

import { Driving } from './control/driving.js';
import { makeJoystick } from './control/joystick.js';
import { listenToKeys } from './keyboard.js';
import { socketAddress } from './protocol/addresses.js';
import { Connection } from './protocol/connection.js';
import { MessageKind, StateDecoder, decodePoints } from './protocol/state_frames.js';
import { readModels, readWorld } from './protocol/world_source.js';
import { makeTestHooks } from './test_hooks.js';
import { AgentList, showEvent } from './ui/agent_list.js';
import { byId, clockText, toast } from './ui/dom.js';
import { Inset } from './ui/inset.js';
import { Panel } from './ui/panel.js';
import { Viewer } from './view/viewer.js';

const kWorldRetry_ms = 1500;
const kInsetPeriod_ms = 120;

class Page {
  constructor() {
    this.state = { role: 'viewer', moves: true, paused: false, key: null, clock: null, weather: null, messages: 0, errors: [] };
    this.connection = new Connection(socketAddress());
    this.viewer = new Viewer(byId('view'), byId('labels'));
    this.decoders = { [MessageKind.agents]: new StateDecoder(), [MessageKind.elements]: new StateDecoder() };
    this.tables = { agents: null, elements: null };
    this.loading = null;
    this.keys = listenToKeys(this.#shortcuts());
    this.viewer.cameras.keys = this.keys;
    this.driving = new Driving((message) => this.connection.send(message), this.keys);
    this.panel = new Panel((message) => this.connection.request(message), this.viewer, { subscribe: () => this.#subscribe() });
    this.inset = new Inset(this.viewer);
    this.agentList = new AgentList({ follow: (name) => this.follow(name), drive: (name) => this.drive(name) }, () => this.state.role === 'controller');
    this.#makeControls();
    this.#listen();
    this.connection.open();
  }

  #shortcuts() {
    const click = (id) => () => byId(id).click();
    const camera = (mode) => () => document.querySelector(`[data-camera=${mode}]`).click();
    return {
      Digit1: camera('orbit'), Digit2: camera('fly'), Digit3: camera('follow'), Space: click('play'), Period: click('step'),
      KeyF: () => this.driving.strike(), Escape: () => this.leaveRobot(), KeyN: click('layer-names'), KeyL: click('layer-lidar'),
      KeyC: click('layer-classes'), KeyM: click('inset-toggle'), KeyP: click('panel-toggle'), KeyH: click('help-toggle'),
    };
  }

  #makeControls() {
    const { panel } = this;
    byId('help-toggle').addEventListener('click', () => byId('help').showModal());
    byId('play').addEventListener('click', () => panel.ask({ type: this.state.paused ? 'unpause' : 'pause' }));
    byId('step').addEventListener('click', async () => {
      if (!this.state.paused) await panel.ask({ type: 'pause' });
      await panel.ask({ type: 'step', steps: 1 });
    });
    byId('reset').addEventListener('click', () => panel.ask({ type: 'reset' }));
    byId('speed').addEventListener('change', ({ target }) => panel.ask({ type: 'speed', factor: Number(target.value) }));
    byId('strike').addEventListener('click', () => this.driving.strike());
    byId('drive-stop').addEventListener('click', () => this.leaveRobot());
    makeJoystick(byId('joystick'), (way) => { this.driving.stick = way; });
    for (const button of document.querySelectorAll('[data-camera]')) {
      button.addEventListener('click', () => {
        const { camera } = button.dataset;
        if (camera === 'follow') this.follow(this.#someAgent());
        else this.viewer.cameras.set(camera);
        byId('view').focus();
      });
    }
    byId('view').addEventListener('cameramode', ({ detail }) => {
      for (const button of document.querySelectorAll('[data-camera]')) button.setAttribute('aria-pressed', String(button.dataset.camera === detail));
    });
    this.viewer.addEventListener('lost', () => toast('The graphics card was lost; reload the page.', 'error'));
    let inset_ms = 0;
    this.viewer.addEventListener('frame', ({ detail: { now_ms } }) => {
      if (now_ms - inset_ms < kInsetPeriod_ms) return;
      inset_ms = now_ms;
      this.inset.update();
      if (this.viewer.world) this.agentList.update(this.viewer.agents.entries, this.viewer.world.description.behaviours);
      const { fps, draw_calls, triangles } = this.viewer.stats;
      byId('stats').textContent = `${fps.toFixed(0)} frames/s · ${draw_calls} draw calls · ${(triangles / 1e6).toFixed(2)} M triangles · ${this.viewer.quality.settings.name}`;
    });
  }

  /** Name of the agent that is followed where none was chosen. */
  #someAgent() {
    const rows = this.tables.agents?.agents ?? [];
    return (rows.find((row) => row.controllable) ?? rows[0])?.name;
  }

  follow(name) {
    const entry = name && this.viewer.agents?.find(name);
    if (entry) {
      this.viewer.cameras.set('follow', entry);
      this.panel.makeRoom();
    } else {
      toast('There is nobody to follow.');
    }
  }

  drive(name) {
    const row = this.tables.agents?.agents.find((entry) => entry.name === name);
    if (!row || !this.viewer.world) return;
    const species = this.viewer.world.description.species.find((entry) => entry.name === row.species);
    this.follow(name);
    this.driving.start({ top_speed_mps: 1, turn_rate_radps: 1, flies: false, ...species, name });
    byId('drive-name').textContent = name;
    byId('strike').hidden = !species?.strikes;
    byId('drive').hidden = false;
    byId('view').focus();
    this.#subscribe();
  }

  leaveRobot() {
    this.driving.stop();
    byId('drive').hidden = true;
    this.viewer.cameras.set('orbit');
  }

  #listen() {
    const { connection } = this;
    connection.addEventListener('state', ({ detail: { state, retry_ms } }) => {
      byId('connection').dataset.state = state;
      byId('connection').lastElementChild.textContent = state === 'open' ? 'connected' : state === 'lost' ? `lost, again in ${Math.ceil(retry_ms / 1000)} s` : 'connecting';
      if (state !== 'lost') return;
      for (const decoder of Object.values(this.decoders)) decoder.reset();
      if (!this.viewer.world) byId('loading-text').textContent = 'The server does not answer; trying again …';
    });
    connection.addEventListener('json', ({ detail }) => this.#receive(detail));
    connection.addEventListener('binary', ({ detail }) => this.#receiveBinary(detail));
  }

  #receive(message) {
    this.state.messages++;
    const handlers = {
      hello: () => {
        Object.assign(this.state, { role: message.role, moves: message.moves });
        this.panel.setRole(message.role, message.token_accepted, message.moves);
        if (this.tables.agents) this.agentList.setTable(this.tables.agents.agents);
        this.#subscribe();
        this.#load(message.world);
      },
      world: () => this.#load(message.key),
      agents: () => this.#setTable('agents', message),
      elements: () => this.#setTable('elements', message),
      felled: () => {
        this.felledTrees = message.trees;
        this.viewer.felled?.set(message.trees);
      },
      clock: () => this.#showClock(message),
      weather: () => {
        this.state.weather = message;
        this.viewer.setWeather(message);
        this.panel.showWeather(message);
      },
      event: () => showEvent(message),
      path: () => this.viewer.paths?.set(message.topic, byId('layer-paths').checked ? message.points_m : []),
      progress: () => this.panel.showProgress(message),
      reply: () => {
        if (!message.ok) toast(message.message, 'error');
      },
      error: () => toast(message.message, 'error'),
    };
    handlers[message.type]?.();
  }

  #receiveBinary(buffer) {
    const kind = new DataView(buffer).getUint8(0);
    if (kind === MessageKind.points) {
      if (byId('layer-lidar').checked) this.viewer.lidar.set(decodePoints(buffer));
      return;
    }
    const frame = this.decoders[kind]?.decode(buffer);
    if (!frame) return;
    const bodies = kind === MessageKind.agents ? this.viewer.agents : this.viewer.elements;
    this.lastFrames ??= {};
    this.lastFrames[kind] = frame;
    bodies?.push(frame, performance.now());
  }

  #setTable(name, message) {
    this.tables[name] = message;
    this.viewer[name]?.setTable(message.version, message[name]);
    if (name === 'agents') this.agentList.setTable(message.agents);
  }

  #showClock(clock) {
    this.state.clock = clock;
    this.state.paused = clock.paused;
    byId('play').textContent = clock.paused ? '▶' : '❚❚';
    byId('play').setAttribute('aria-label', clock.paused ? 'Go on' : 'Pause');
    byId('clock').textContent = clockText(clock.time_s);
    byId('factor').textContent = clock.paused ? '' : `×${clock.real_time_factor.toFixed(2)}`;
    const known = [...byId('speed').options].find((option) => Number(option.value) === clock.speed);
    if (clock.speed !== null && known && document.activeElement !== byId('speed')) known.selected = true;
  }

  #subscribe() {
    const layers = ['lidar', 'paths'].filter((layer) => byId(`layer-${layer}`).checked);
    if (!layers.includes('lidar')) this.viewer.lidar.set(null);
    if (!layers.includes('paths')) this.viewer.paths?.clear();
    const robot = this.driving.robot?.name;
    this.connection.send({ type: 'subscribe', layers, ...(robot ? { robot } : {}) });
  }

  /** Shows the world of that key; null: none runs. */
  async #load(key) {
    if (key === this.state.key && this.viewer.furnished) return;
    this.loading?.abort();
    document.body.classList.toggle('idle', !key);  // the panel stays within reach: it can make a world
    if (!key) {
      byId('loading').classList.remove('done');
      byId('loading-text').textContent = 'No world runs. One appears here as soon as it does.';
      this.state.key = null;
      return;
    }
    const abort = new AbortController();
    this.loading = abort;
    if (!this.viewer.world) byId('loading-text').textContent = 'Reading the world …';
    try {
      const world = await readWorld((fraction) => { byId('loading-bar').value = fraction; }, abort.signal);
      if (abort.signal.aborted) return;
      await this.viewer.setWorld(world, true);
      this.#shown(world);
      await this.#furnish(world, abort.signal);
    } catch (error) {
      if (error.name === 'AbortError') return;
      console.warn('the world cannot be shown', error);
      byId('loading-text').textContent = error.message;
      // The server may be in the middle of a change.
      setTimeout(() => {
        if (this.loading === abort) this.#load(key);
      }, kWorldRetry_ms);
    }
  }

  /** The models, most of a world's bytes, come when its land is in sight already. */
  async #furnish(world, signal) {
    const { id } = world.description;
    const tell = (fraction) => { byId('world-name').textContent = `${id} · plants, buildings, bodies ${Math.round(100 * fraction)} %`; };
    tell(0);
    const models = await readModels(world.description, tell, signal);
    if (signal.aborted) return;
    await this.viewer.furnish(world, models);
    if (this.viewer.world !== world) return;
    byId('world-name').textContent = id;
    this.#fill();
  }

  /** Tells the view what is known of all that moves. */
  #fill() {
    for (const name of ['agents', 'elements']) {
      if (this.tables[name]) this.viewer[name].setTable(this.tables[name].version, this.tables[name][name]);
      const frame = this.lastFrames?.[MessageKind[name]];
      if (frame) this.viewer[name].push(frame, performance.now());
    }
    if (this.felledTrees) this.viewer.felled.set(this.felledTrees);
    const { cameras } = this.viewer;
    if (cameras.mode === 'follow') cameras.target = this.viewer.agents.find(cameras.target.name) ?? cameras.target;
    this.panel.applyLayers();
  }

  #shown({ description }) {
    if (!this.viewer.world || this.viewer.world.description !== description) return;
    this.state.key = description.key;
    this.leaveRobot();
    this.#fill();
    if (this.state.weather) this.viewer.setWeather(this.state.weather);
    this.inset.setWorld(this.viewer.world);
    document.title = `LatticeWorld · ${description.id}`;
    if (!byId('layout-text').value) {
      byId('layout-text').value = description.request.layout;
      byId('environment-text').value = description.request.environment;
    }
    byId('loading').classList.add('done');
  }
}

try {
  window.latticeworld = makeTestHooks(new Page());
} catch (error) {
  byId('loading-text').textContent = error.message;
  throw error;
}
