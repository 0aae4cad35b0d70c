// Takes the pictures of the page that docs/gallery.md and README show, in a browser without a graphics card.
//
//   source devel/setup.bash
//   LATTICEWORLD_NODE_MODULES=$PWD/build/web/node_modules LATTICEWORLD_CHROMIUM=$(which chromium) \
//     LATTICEWORLD_ENV_SCRIPT=$PWD/devel/env.sh node scripts/page_pictures.mjs docs/images [name ...]
//
// Needs Chromium and, for the flight, img2webp (Debian's package webp). Half a minute a picture.

import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { Nodes, until } from '../tests/web/nodes.mjs';

const { chromium } = createRequire(join(process.env.LATTICEWORLD_NODE_MODULES, 'here.js'))('playwright-core');

const kRiver = {
  layout: 'A river winds from the north to the south between dense forest in the upper left and farmland on the right. '
    + 'A road runs from the west to the east, with a small village in the center.',
  environment: 'A sunny autumn afternoon. Nine sheep graze in the lower left, two goblins patrol near the upper right, '
    + 'an eagle circles above, and a wheeled robot waits in the center.',
  seed: 37, size_m: 256,
};
const kRain = {
  layout: 'A village in the center with a road from the west to the east. Forest in the north. A pond in the lower right.',
  environment: 'Heavy rain on a summer evening. A wheeled robot waits in the center.', seed: 11, size_m: 192,
};
const kSnow = {
  layout: 'Snow-capped mountains cover the northern third. A lake lies in the lower left, and a river runs into it from the '
    + 'upper right. Forest covers the lower right.',
  environment: 'A clear winter morning. Six horses graze near the lake and a robotic dog patrols in the center.', seed: 7, size_m: 384,
};

// Each with the world that it shows; from, to: [x, y, height above the ground] in metres.
const kPictures = {
  viewer_page: { world: kRiver, from: [20, -82, 34], to: [-12, 6, 0], page: true },
  viewer_village: { world: kRiver, from: [-52, -62, 9], to: [-8, -6, 3] },
  viewer_sheep: { world: kRiver, near: 'sheep', from: [-7, -9, 2.6], to: [0, 0, 0.6] },
  viewer_robot: { world: kRiver, near: 'wheeled robot', from: [-7, -7, 3.5], to: [1, 1, 0.5], layers: ['layer-lidar'] },
  viewer_rain: { world: kRain, from: [-30, -52, 9], to: [-4, 4, 3] },
  viewer_snow: { world: kSnow, from: [-20, -120, 40], to: [0, 60, 10] },
};
const kFlight = 'viewer_flight';

async function openPage(browser, nodes, viewport) {
  const page = await browser.newPage({ viewport });
  page.setDefaultTimeout(300000);
  page.on('pageerror', (error) => { throw error; });
  await page.goto(nodes.address, { waitUntil: 'domcontentloaded' });
  await until('a furnished world', () => page.evaluate(() => window.latticeworld?.state.ready), 300);
  return page;
}

/** Waits until the page has drawn so many frames more. */
async function drawn(page, count) {
  const before = await page.evaluate(() => window.latticeworld.state.stats.frames);
  await page.waitForFunction((frames) => window.latticeworld.state.stats.frames > frames, before + count);
}

async function take(page, picture, path) {
  await page.evaluate(({ from, to, near, layers = [], page: whole }) => {
    const { latticeworld } = window;
    document.querySelector('#panel').classList.toggle('closed', !whole);
    for (const id of ['top', 'inset', 'time']) document.querySelector(`#${id}`).style.visibility = whole ? '' : 'hidden';
    for (const id of layers) {
      const box = document.querySelector(`#${id}`);
      if (!box.checked) box.click();
    }
    const middle = near ? latticeworld.state.agents.find((agent) => agent.species === near).position : [0, 0, 0];
    const place = ([x, y, z]) => [middle[0] + x, middle[1] + y, latticeworld.heightAt(middle[0] + x, middle[1] + y) + z];
    latticeworld.chooseQuality('high');
    latticeworld.look(place(from), place(to));
  }, picture);
  await drawn(page, picture.layers ? 12 : 4);
  await page.evaluate(() => window.latticeworld.slowDown(60000));
  await page.screenshot({ path, type: 'jpeg', quality: 85 });
  await page.evaluate(() => window.latticeworld.slowDown(0));
}

/** Once around the village, as an endless WebP. */
async function fly(page, path) {
  const kFrames = 48;
  const folder = mkdtempSync(join(tmpdir(), 'latticeworld_flight_'));
  await page.evaluate(() => {
    for (const id of ['top', 'inset', 'time', 'panel']) document.querySelector(`#${id}`).style.visibility = 'hidden';
    window.latticeworld.chooseQuality('low');
  });
  const files = [];
  for (let i = 0; i < kFrames; ++i) {
    const angle = -2.5 + 2 * Math.PI * i / kFrames, radius = 62 + 14 * Math.cos(2 * angle);
    await page.evaluate(([x, y, z]) => {
      const { latticeworld } = window;
      latticeworld.look([x, y, latticeworld.heightAt(x, y) + z], [0, 4, latticeworld.heightAt(0, 4) + 2]);
    }, [radius * Math.cos(angle), 4 + radius * Math.sin(angle), 17 + 5 * Math.sin(angle)]);
    await drawn(page, 2);
    files.push(join(folder, `${String(i).padStart(3, '0')}.png`));
    await page.screenshot({ path: files.at(-1) });
  }
  const { status } = spawnSync('img2webp', ['-loop', '0', '-d', '100', '-lossy', '-q', '45', ...files, '-o', path], { stdio: 'ignore' });
  rmSync(folder, { recursive: true });
  if (status !== 0) throw new Error('img2webp failed: is the package webp installed?');
}

const [out, ...names] = process.argv.slice(2);
if (!out) throw new Error('where to? node scripts/page_pictures.mjs DIR [name ...]');
const known = [...Object.keys(kPictures), kFlight];
for (const name of names) if (!known.includes(name)) throw new Error(`no picture is called ${name}; there are ${known.join(', ')}`);
const wanted = names.length ? names : known;
mkdirSync(out, { recursive: true });

const browser = await chromium.launch({ executablePath: process.env.LATTICEWORLD_CHROMIUM,
  args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'] });
try {
  for (const world of [kRiver, kRain, kSnow]) {
    const here = wanted.filter((name) => (name === kFlight ? kRiver : kPictures[name].world) === world);
    if (!here.length) continue;
    const nodes = await Nodes.start();
    try {
      nodes.startServer(world.layout, world.environment, world.seed, world.size_m);
      nodes.startViewer();
      await nodes.untilServed('the viewer', async () => {
        try {
          return (await fetch(`${nodes.address}api/world.json`)).ok;
        } catch {
          return false;
        }
      });
      const stills = here.filter((name) => name !== kFlight);
      if (stills.length) {
        const page = await openPage(browser, nodes, { width: 960, height: 540 });
        for (const name of stills) {
          await take(page, kPictures[name], join(out, `${name}.jpg`));
          console.log(`${name}.jpg`);
        }
        await page.close();
      }
      if (here.includes(kFlight)) {
        const page = await openPage(browser, nodes, { width: 480, height: 270 });
        await fly(page, join(out, `${kFlight}.webp`));
        console.log(`${kFlight}.webp`);
        await page.close();
      }
    } finally {
      await nodes.end();
    }
  }
} finally {
  await browser.close();
}
