// The real nodes for tests of the page: a ROS master, a world server and a viewer of their own.

import { spawn, spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const kEnvScript = process.env.LATTICEWORLD_ENV_SCRIPT;

/** A port that nobody listens at. */
export async function freePort() {
  const server = createServer();
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  const { port } = server.address();
  await new Promise((resolve) => server.close(resolve));
  return port;
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

  static async start() {
    const nodes = new Nodes();
    nodes.home = mkdtempSync(join(tmpdir(), 'latticeworld_browser_'));
    nodes.masterPort = await freePort();
    nodes.viewerPort = await freePort();
    nodes.env = Object.fromEntries(Object.entries(process.env).filter(([name]) => !/^(ROS|PYTHONPATH|CMAKE_PREFIX_PATH|LD_LIBRARY_PATH)/.test(name)));
    Object.assign(nodes.env, {
      PATH: `/usr/bin:${process.env.PATH}`, HOME: nodes.home, ROS_HOME: nodes.home, ROS_IP: '127.0.0.1',
      ROS_LOG_DIR: join(nodes.home, 'log'), ROS_MASTER_URI: `http://127.0.0.1:${nodes.masterPort}`,
    });
    nodes.#spawn('master', ['roscore', '-p', String(nodes.masterPort)]);
    await until('a ROS master', () => nodes.call('rosparam', 'list').status === 0, 30);
    return nodes;
  }

  get address() {
    return `http://127.0.0.1:${this.viewerPort}/`;
  }

  #spawn(name, command) {
    const child = spawn(kEnvScript, command, { env: this.env, stdio: ['ignore', 'pipe', 'pipe'], detached: true });
    const entry = { child, output: '', ended: new Promise((resolve) => child.on('close', resolve)) };
    for (const stream of [child.stdout, child.stderr]) stream.on('data', (data) => { entry.output = (entry.output + data).slice(-8000); });
    this.#running.set(name, entry);
  }

  /** Runs a command line program of ROS. */
  call(...command) {
    return spawnSync(kEnvScript, command, { env: this.env, encoding: 'utf8', timeout: 20000 });
  }

  startServer(layout, environment, seed) {
    this.#spawn('server', ['roslaunch', '-p', String(this.masterPort), 'latticeworld', 'world.launch', `generate:=${layout}`,
                           `environment:=${environment}`, `seed:=${seed}`, 'size:=96', `worlds_directory:=${this.home}/worlds`]);
  }

  startViewer() {
    this.#spawn('viewer', ['rosrun', 'latticeworld', 'world_viewer', `_port:=${this.viewerPort}`]);
  }

  output(name) {
    return this.#running.get(name)?.output ?? '';
  }

  async stop(name) {
    const entry = this.#running.get(name);
    if (!entry) return;
    this.#running.delete(name);
    const signal = (which) => {
      try {
        process.kill(-entry.child.pid, which);  // its own group: rosrun and roslaunch have children
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
