// The real nodes for tests of the page: a ROS master, a world server and a viewer of their own.

import { spawn, spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const kEnvScript = process.env.LATTICEWORLD_ENV_SCRIPT;
// What of the surroundings would lead the nodes elsewhere than to the master and the package of the test.
const kForeign = /^(ROS|ROSLISP|PYTHONPATH|CMAKE_PREFIX_PATH|LD_LIBRARY_PATH|NODE_|LATTICEWORLD_VIEWER_TOKEN|https?_proxy$)/i;
const kKept_bytes = 8000;

/** Ports that nobody listens at, all different. */
export async function freePorts(count) {
  const servers = Array.from({ length: count }, () => createServer());
  await Promise.all(servers.map((server) => new Promise((resolve, reject) => {
    server.on('error', reject);
    server.listen(0, '127.0.0.1', resolve);
  })));
  const ports = servers.map((server) => server.address().port);
  await Promise.all(servers.map((server) => new Promise((resolve) => server.close(resolve))));
  return ports;
}

/** Waits until `check` gives something; fails after that many seconds, saying what was waited for. */
export async function until(what, check, seconds = 60) {
  const end_ms = Date.now() + 1000 * seconds;
  let last;
  while (Date.now() < end_ms) {
    last = await check();
    if (last) return last;
    await new Promise((resolve) => setTimeout(resolve, 200));
  }
  throw new Error(`${what}: not after ${seconds} s`);
}

export class Nodes {
  #running = new Map();

  /** A master that answers; what was started of it is ended where it does not. */
  static async start() {
    const nodes = new Nodes();
    nodes.home = mkdtempSync(join(tmpdir(), 'latticeworld_browser_'));
    [nodes.masterPort, nodes.viewerPort] = await freePorts(2);
    nodes.env = Object.fromEntries(Object.entries(process.env).filter(([name]) => !kForeign.test(name)));
    Object.assign(nodes.env, {
      PATH: `/usr/bin:${process.env.PATH}`, HOME: nodes.home, ROS_HOME: nodes.home, ROS_IP: '127.0.0.1',
      ROS_LOG_DIR: join(nodes.home, 'log'), ROS_MASTER_URI: `http://127.0.0.1:${nodes.masterPort}`,
    });
    nodes.#spawn('master', ['roscore', '-p', String(nodes.masterPort)]);
    try {
      await nodes.untilServed('a ROS master', () => nodes.call('rosparam', 'list').status === 0);
    } catch (error) {
      await nodes.end();
      throw error;
    }
    return nodes;
  }

  get address() {
    return `http://127.0.0.1:${this.viewerPort}/`;
  }

  #spawn(name, command) {
    const child = spawn(kEnvScript, command, { env: this.env, stdio: ['ignore', 'pipe', 'pipe'], detached: true });
    const entry = { child, output: '', end: null };
    const keep = (data) => { entry.output = (entry.output + data).slice(-kKept_bytes); };
    for (const stream of [child.stdout, child.stderr]) stream.on('data', keep);
    entry.ended = new Promise((resolve) => {
      const end = (how) => {
        entry.end = how;
        keep(`[${how}]\n`);
        resolve();
      };
      child.on('error', (error) => end(`not started: ${error.message}`));
      child.on('close', (code, signal) => end(`ended with ${signal ?? code}`));
    });
    this.#running.set(name, entry);
  }

  /** What every program has said lately, for who has to find out why a test failed. */
  said() {
    return [...this.#running].map(([name, { output }]) => `--- ${name} (${this.home})\n${output.trim()}\n`).join('');
  }

  /** As `until`, and at once where one of the programs has ended; tells what they said when it fails. */
  async untilServed(what, check, seconds = 120) {
    try {
      return await until(what, async () => {
        const done = await check();
        const ended = [...this.#running].find(([, { end }]) => end !== null);
        if (!done && ended) throw new Error(`${what}: ${ended[0]} has ${ended[1].end}`);
        return done;
      }, seconds);
    } catch (error) {
      error.message += `\n${this.said()}`;
      throw error;
    }
  }

  /** Runs a command line program of ROS. */
  call(...command) {
    return spawnSync(kEnvScript, command, { env: this.env, encoding: 'utf8', timeout: 20000 });
  }

  startServer(layout, environment, seed, size_m = 96) {
    this.#spawn('server', ['roslaunch', '-p', String(this.masterPort), 'latticeworld', 'world.launch', `generate:=${layout}`,
                           `environment:=${environment}`, `seed:=${seed}`, `size:=${size_m}`, `worlds_directory:=${this.home}/worlds`]);
  }

  startViewer() {
    this.#spawn('viewer', ['rosrun', 'latticeworld', 'world_viewer', `_port:=${this.viewerPort}`]);
  }

  async stop(name) {
    const entry = this.#running.get(name);
    if (!entry) return;
    this.#running.delete(name);
    const signal = (which) => {
      try {
        process.kill(-entry.child.pid, which);  // its own group: roslaunch has children
      } catch {
        // it has ended
      }
    };
    signal('SIGINT');
    const timer = setTimeout(() => signal('SIGKILL'), 20000);
    await entry.ended;
    clearTimeout(timer);
  }

  async end() {
    for (const name of ['viewer', 'server', 'master']) await this.stop(name);
    rmSync(this.home, { recursive: true, force: true });
  }
}
