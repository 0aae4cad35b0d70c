// peer.py for programs of Node.
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';

const WORLDS = process.env.PEER_WORLDS;

export class Peer {
  constructor(name, version, fed, must = '') {
    this.result = {name, version, fed, must, checks: []};
    console.log(`${name} ${version}: ${fed}`);
  }
  check(name, ok, figures) {
    this.result.checks.push([name, Boolean(ok), String(figures)]);
    console.log(`${ok ? 'ok  ' : 'OFF '} ${name}: ${figures}`);
  }
  finish() {
    fs.writeFileSync(process.env.PEER_RESULT, JSON.stringify(this.result));
    process.exit(this.result.checks.every(([, ok]) => ok) ? 0 : 1);
  }
}

export function exported(form, name, ...options) {
  const file = path.join(WORLDS, name);
  if (!fs.existsSync(file)) {
    execFileSync(process.env.PEER_PROGRAM, ['export', path.join(WORLDS, 'world'), '--to', form,
                                            '--out', file, ...options], {stdio: 'ignore'});
  }
  return file;
}

// The bag of a recorded episode, and how many messages rosbag counts in it.
export function episode() {
  const python = (...words) => execFileSync('/usr/bin/python3', words, {encoding: 'utf8'}).trim();
  const file = python(path.join(process.env.PYTHONPATH, 'episode.py'));
  const count = python('-c', 'import rosbag, sys; print(rosbag.Bag(sys.argv[1]).get_message_count())',
                       file);
  return {file, count: Number(count)};
}

// How many things assets.csv has.
export function assetCount() {
  const text = fs.readFileSync(path.join(WORLDS, 'world', 'assets.csv'), 'utf8');
  return text.trim().split('\n').length - 1;
}

export function versionOf(name) {
  const file = path.join(process.env.PEER_FOLDER, 'node_modules', name, 'package.json');
  return JSON.parse(fs.readFileSync(file, 'utf8')).version;
}

// The ground of --to heights.
export class Ground {
  constructor(folder) {
    this.about = JSON.parse(fs.readFileSync(path.join(folder, 'heights.json'), 'utf8'));
    const bytes = fs.readFileSync(path.join(folder, 'heights.npy'));
    const begin = 10 + bytes.readUInt16LE(8);
    this.values = new Float32Array(bytes.buffer.slice(bytes.byteOffset + begin));
    [this.west, this.north] = this.about.origin;
    [this.width, this.depth] = this.about.size;
  }
  // As the height field is split, from north-west to south-east.
  at(x, y) {
    const {cols, rows, resolution} = this.about;
    const col = (x - this.west) / resolution, row = (this.north - y) / resolution;
    const c = Math.min(Math.floor(col), cols - 2), r = Math.min(Math.floor(row), rows - 2);
    const u = col - c, v = row - r;
    const value = (i, k) => this.values[i * cols + k];
    const nw = value(r, c), se = value(r + 1, c + 1);
    return u >= v ? nw + u * (value(r, c + 1) - nw) + v * (se - value(r, c + 1))
                  : nw + v * (value(r + 1, c) - nw) + u * (se - value(r + 1, c));
  }
  holds(x, y) {
    return Math.abs(x) < this.width / 2 && Math.abs(y) < this.depth / 2;
  }
  // points: [x, y, z] of the frame map.
  check(peer, points, limit_m = 1e-3) {
    const inside = points.filter(([x, y]) => this.holds(x, y));
    const step = Math.max(1, Math.floor(inside.length / 1000));
    const chosen = inside.filter((_, i) => i % step === 0).slice(0, 1000);
    const rms = (errors) => Math.sqrt(errors.reduce((sum, e) => sum + e * e, 0) / errors.length);
    const off = chosen.map(([x, y, z]) => z - this.at(x, y));
    const west = chosen.map(([x, y, z]) => z - this.at(-x, y));
    const north = chosen.map(([x, y, z]) => z - this.at(x, -y));
    const worst = Math.max(...off.map(Math.abs));
    peer.check(`heights at ${chosen.length} places`,
               worst < limit_m && Math.min(rms(west), rms(north)) > 0.1,
               `off ${rms(off).toPrecision(2)} m, at most ${worst.toPrecision(2)} m ` +
               `(mirrored ${rms(west).toPrecision(2)} m, ${rms(north).toPrecision(2)} m)`);
  }
}
