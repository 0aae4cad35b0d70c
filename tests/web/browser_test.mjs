// The page in a real browser, without a graphics card, with the real nodes.

import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { Nodes, until } from './nodes.mjs';
import { startPrefixProxy } from './prefix_proxy.mjs';

const { chromium } = createRequire(join(process.env.LATTICEWORLD_NODE_MODULES, 'here.js'))('playwright-core');

const kLayout = 'A lake in the upper left. Forest covers the eastern half, and farmland the lower left.';
const kEnvironment = 'A sunny summer noon. A wheeled robot waits in the center, two sheep graze in the lower left.';

let nodes;
let browser;
let page;
const complaints = [];

function launch() {
  return chromium.launch({
    executablePath: process.env.LATTICEWORLD_CHROMIUM,
    args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
  });
}

async function openPage(inBrowser, address = nodes.address) {
  const opened = await inBrowser.newPage({ viewport: { width: 320, height: 240 } });
  opened.on('pageerror', (error) => complaints.push(String(error)));
  opened.on('console', (message) => {
    // What the browser itself says of a lost connection is no fault of the page.
    if (message.type() === 'error' && !/WebSocket|ERR_CONNECTION|favicon/.test(message.text())) complaints.push(message.text());
  });
  opened.on('request', (request) => {
    const { protocol, host } = new URL(request.url());
    if (!/^(data|blob):$/.test(protocol) && host !== new URL(address).host) complaints.push(`asked ${request.url()}`);
  });
  await opened.goto(address, { timeout: 120000, waitUntil: 'domcontentloaded' });
  return opened;
}

const stateOf = (which) => which.evaluate(() => globalThis.latticeworld?.state ?? null);

async function ready(which, check = () => true) {
  let state = null;
  try {
    return await nodes.untilServed('the page shows a world', async () => {
      state = await stateOf(which);
      return state?.ready && state.connection === 'open' && check(state) ? state : null;
    }, 180);
  } catch (error) {
    error.message += `--- page\n${JSON.stringify(state)}\n${complaints.join('\n')}\n`;
    throw error;
  }
}

/** Place of the robot by its odometry [m]. */
function odometry() {
  const { stdout } = nodes.call('rostopic', 'echo', '-n', '1', '-p', '/robot/ground_truth/pose/pose/position');
  const row = stdout.trim().split('\n').at(-1).split(',').map(Number);
  return row.slice(-3);
}

before(async () => {
  nodes = await Nodes.start();
  nodes.startServer(kLayout, kEnvironment, 5);
  nodes.startViewer();
  browser = await launch();
  await nodes.untilServed('the viewer answers', async () => {
    try {
      return (await fetch(`${nodes.address}api/world.json`, { signal: AbortSignal.timeout(5000) })).ok;
    } catch {
      return false;  // it does not listen yet, or takes its time
    }
  }, 180);
  page = await openPage(browser);
  page.setDefaultTimeout(60000);
}, { timeout: 420000 });

after(async () => {
  await browser?.close();
  await nodes?.end();
}, { timeout: 60000 });

test('the page shows the world, its agents and its time', { timeout: 240000 }, async () => {
  const state = await ready(page, ({ agents, clock }) => agents.length === 3 && clock);
  assert.equal(state.role, 'controller');
  assert.deepEqual(state.agents.map((agent) => agent.species).sort(), ['sheep', 'sheep', 'wheeled robot']);
  const world = await (await fetch(`${nodes.address}api/world.json`)).json();
  assert.equal(state.world, world.id);
  const frames = state.stats.frames;
  await until('frames go on', async () => (await stateOf(page)).stats.frames > frames + 2);
  const { stats } = await stateOf(page);
  assert.ok(stats.draw_calls > 5 && stats.triangles > 1000, JSON.stringify(stats));
});

test('the ground has the colours of the classes where the layout has them', { timeout: 60000 }, async () => {
  const { layout, classes, size_m } = await page.evaluate(() => globalThis.latticeworld.description);
  const colors = new Map(classes.filter((entry) => entry.weighted).map((entry) => [entry.letter, parseInt(entry.color.slice(1), 16)]));
  const cells = [];
  for (let row = 1; row < 31; row++) {
    for (let col = 1; col < 31; col++) {
      const letter = layout[row][col];
      const inside = [-1, 0, 1].every((j) => [-1, 0, 1].every((i) => layout[row + j][col + i] === letter));
      if (inside && colors.has(letter)) cells.push({ letter, place: [((col + 0.5) / 32 - 0.5) * size_m, (0.5 - (row + 0.5) / 32) * size_m] });
    }
  }
  const letters = new Set(cells.map((cell) => cell.letter));
  assert.ok(letters.size >= 3, `cells of ${[...letters]}`);
  const places = cells.map((cell) => cell.place);
  const [flat, lit] = await page.evaluate((where) => [
    globalThis.latticeworld.colorsFromAbove(where, { classes: true }), globalThis.latticeworld.colorsFromAbove(where),
  ], places);
  const right = cells.filter(({ letter }, i) => {
    const color = colors.get(letter);
    return [color >> 16, (color >> 8) & 255, color & 255].every((value, k) => Math.abs(value - flat[i][k]) <= 24);
  });
  assert.ok(right.length > 0.95 * cells.length, `${right.length} of ${cells.length} cells`);
  // The lit picture is no single colour either, and water is bluer than land.
  const mean = (letter, of) => {
    const values = lit.filter((_, i) => cells[i].letter === letter).map(of);
    return values.reduce((sum, value) => sum + value, 0) / values.length;
  };
  const blueness = ([red, green, blue]) => blue - (red + green) / 2;
  if (letters.has('W')) assert.ok(mean('W', blueness) > mean('A', blueness) + 15, `${mean('W', blueness)} ${mean('A', blueness)}`);
  assert.ok(new Set(lit.map(String)).size > 20);
});

test('the land is seen at night and in the rain', { timeout: 60000 }, async () => {
  const noon = { sun_direction: [0.2, 0.3, 0.9], sun_intensity: 1, ambient_intensity: 0.4, cloud_cover: 0, rain_mmph: 0 };
  const night = { sun_direction: [0.2, 0.3, -0.9], sun_intensity: 0, ambient_intensity: 0, cloud_cover: 0.95, rain_mmph: 5 };
  const [day, dark] = await page.evaluate((weathers) => {
    const { latticeworld } = globalThis;
    const before = latticeworld.state.weather;
    const places = [];
    for (let y = -60; y <= 60; y += 7.5) for (let x = -60; x <= 60; x += 7.5) places.push([x, y]);
    const seen = weathers.map((weather) => {
      latticeworld.setWeather({ ...before, ...weather });
      return latticeworld.colorsFromAbove(places);
    });
    latticeworld.setWeather(before);
    return seen;
  }, [noon, night]).then((seen) => seen.map((colors) => {
    const grey = colors.map(([r, g, b]) => 0.2126 * r + 0.7152 * g + 0.0722 * b);
    const mean = grey.reduce((sum, value) => sum + value, 0) / grey.length;
    return { mean, contrast: Math.sqrt(grey.reduce((sum, value) => sum + (value - mean) ** 2, 0) / grey.length) };
  }));
  assert.ok(dark.mean > 0.4 * day.mean, `brightness ${dark.mean}, by day ${day.mean}`);
  assert.ok(dark.contrast > 0.35 * day.contrast, `contrast ${dark.contrast}, by day ${day.contrast}`);
});

test('two browsers at once see the same agents, one of them below the prefix of a proxy', { timeout: 300000 }, async () => {
  // Without a graphics card both share one processor: the first rests while the second loads.
  await page.evaluate(() => globalThis.latticeworld.slowDown(3600000));
  const proxy = await startPrefixProxy(nodes.viewerPort);
  const otherBrowser = await launch();
  try {
    const other = await openPage(otherBrowser, proxy.address);
    const { role } = await ready(other, ({ agents }) => agents.length === 3);
    assert.equal(role, 'viewer');  // though all of it comes from the machine itself
    for (const path of ['/world/', '/world/api/world.json', '/world/ws']) assert.ok(proxy.asked.includes(path), path);
    assert.deepEqual(proxy.asked.filter((path) => !path.startsWith('/world/') && path !== '/favicon.ico'), []);
    await page.evaluate(() => globalThis.latticeworld.slowDown(200));
    await until('both show the same', async () => {
      const [first, second] = [await stateOf(page), await stateOf(other)];
      return first.key === second.key && second.agents.every((agent) => {
        const same = first.agents.find(({ name }) => name === agent.name);
        return Math.hypot(same.position[0] - agent.position[0], same.position[1] - agent.position[1]) < 2;
      });
    });
  } finally {
    await otherBrowser.close();
    await proxy.close();
    await page.evaluate(() => globalThis.latticeworld.slowDown(200));
  }
});

test('keys move the robot, and what the page shows is where it is', { timeout: 120000 }, async () => {
  const start = odometry();
  assert.ok(start.every(Number.isFinite), String(start));
  await page.evaluate(() => globalThis.latticeworld.drive('robot'));
  await page.keyboard.down('KeyW');
  await until('the robot has moved by its odometry', () => {
    const place = odometry();
    return Math.hypot(place[0] - start[0], place[1] - start[1]) > 0.5;
  }, 60);
  await page.keyboard.up('KeyW');
  let last = null;
  const rest = await until('the robot stands again', () => {
    const place = odometry();
    const still = last && Math.hypot(place[0] - last[0], place[1] - last[1]) < 0.01;
    last = place;
    return still ? place : null;
  }, 30);
  await until('the page shows it there', async () => {
    const robot = (await stateOf(page)).agents.find(({ name }) => name === 'robot');
    return Math.hypot(robot.position[0] - rest[0], robot.position[1] - rest[1]) < 0.1;
  }, 30);
  await page.keyboard.press('Escape');
  assert.equal((await stateOf(page)).driven, null);
});

test('pause stops the time, a step moves it on', { timeout: 60000 }, async () => {
  await page.locator('#play').dispatchEvent('click');
  const paused = await until('a pause', async () => {
    const { clock } = await stateOf(page);
    return clock.paused ? clock : null;
  });
  await page.locator('#step').dispatchEvent('click');
  await until('a step', async () => (await stateOf(page)).clock.time_s > paused.time_s);
  assert.ok((await stateOf(page)).clock.paused);
  await page.locator('#play').dispatchEvent('click');
  await until('time goes on', async () => !(await stateOf(page)).clock.paused);
});

test('a sentence that is typed becomes a world', { timeout: 240000 }, async () => {
  const { key } = await stateOf(page);
  // On a narrow screen the panel is closed at first.
  await page.evaluate(() => {
    if (document.querySelector('#panel').classList.contains('closed')) document.querySelector('#panel-toggle').click();
  });
  await page.locator('#layout-text').fill('Forest covers everything but a lake in the center.');
  await page.locator('#environment-text').fill('Rain at noon. One goblin patrols in the upper left.');
  await page.evaluate(() => { document.querySelector('#size').value = '96'; });
  await page.locator('#generate .primary').dispatchEvent('click');
  await until('progress is shown', () => page.evaluate(() => !document.querySelector('#progress').hidden));
  const state = await ready(page, (now) => now.key !== key && now.agents.some(({ species }) => species === 'goblin'));
  assert.ok(!state.agents.some(({ species }) => species === 'sheep'), 'agents of the world before');
  assert.equal(state.precipitation, 'rain');
  const { layout } = await page.evaluate(() => globalThis.latticeworld.description);
  assert.ok(layout.join('').split('F').length > 500, layout.join('\n'));
  assert.equal(layout[16][16], 'W', layout.join('\n'));
});

test('a request that cannot be done is told, not swallowed', { timeout: 60000 }, async () => {
  await page.evaluate(() => { document.querySelector('#save-name').value = '../bad/name'; });
  await page.evaluate(() => { document.querySelector('#save').noValidate = true; document.querySelector('#save').requestSubmit(); });
  await until('a message', () => page.evaluate(() => Boolean(document.querySelector('.toast.error'))));
});

test('the page finds its way back when the server was away', { timeout: 240000 }, async () => {
  const { world } = await stateOf(page);
  await nodes.stop('viewer');
  await until('the loss is seen', async () => (await stateOf(page)).connection !== 'open', 30);
  nodes.startViewer();
  const again = await ready(page, (state) => state.world === world && state.agents.length > 0);
  assert.equal(again.world, world);
  await nodes.stop('server');
  nodes.startServer('A snowy mountain in the north, a forest in the south.', 'A winter morning with snow. Three sheep graze in the center.', 9);
  const other = await ready(page, (state) => state.world !== world && state.agents.filter(({ species }) => species === 'sheep').length === 3);
  assert.notEqual(other.world, world);
});

test('all the while the browser has complained of nothing and asked nobody else', () => {
  assert.deepEqual(complaints, []);
});
