// What tests and people at the console can read and do: window.latticeworld.

import * as THREE from 'three';

export function makeTestHooks(page) {
  const { viewer } = page;
  const vector = ({ x, y, z }) => [x, y, z];
  return {
    /** Everything that is shown, as plain data. */
    get state() {
      const entries = viewer.agents?.entries.filter((entry) => entry.placed) ?? [];
      return {
        connection: page.connection.state, role: page.state.role, key: page.state.key, ready: viewer.furnished && page.state.key !== null,
        world: viewer.world?.description.id ?? null, stats: { ...viewer.stats }, quality: viewer.quality.settings.name,
        clock: page.state.clock, weather: viewer.atmosphere.weather, precipitation: viewer.precipitation.kind,
        agents: entries.map((entry) => ({ name: entry.name, species: entry.row.species, position: vector(entry.position), health: entry.thing.health / 255,
          behaviour: viewer.world.description.behaviours[entry.thing.behaviour] })),
        felled: viewer.felled?.trees.size ?? 0, things_drawn: viewer.scenery?.drawn ?? 0, lidar_points: viewer.lidar.count,
        paths: viewer.paths?.paths.size ?? 0, labels: viewer.labels.shown,
        camera: { mode: viewer.cameras.mode, position: vector(viewer.camera.position) }, driven: page.driving.robot?.name ?? null,
      };
    },

    get description() {
      return viewer.world?.description ?? null;
    },

    /** Puts the orbit camera at a place [m] and lets it look at another. */
    look(from, to) {
      viewer.cameras.set('orbit');
      viewer.camera.position.set(...from);
      viewer.cameras.orbit.target.set(...to);
      viewer.cameras.orbit.update();
    },

    /** Draws at most one frame in so many milliseconds. */
    slowDown(least_ms) {
      viewer.leastFrame_ms = least_ms;
    },

    setWeather: (weather) => viewer.setWeather(weather),
    chooseQuality: (name) => viewer.chooseQuality(name),
    follow: (name) => page.follow(name),
    drive: (name) => page.drive(name),

    heightAt: (x_m, y_m) => viewer.world.height.at(x_m, y_m),

    /**
     * Colours [r, g, b] (0 .. 255) of places [[x, y], ...] as seen from straight above, without haze.
     * classes: those of the land's classes alone, unlit, without what stands on it.
     */
    colorsFromAbove(places, { classes = false, pixels = 512 } = {}) {
      const half = viewer.world.description.size_m / 2;
      const camera = new THREE.OrthographicCamera(-half, half, half, -half, 1, 4000);
      camera.up.set(0, 1, 0);
      camera.position.set(0, 0, 2000);
      camera.lookAt(0, 0, 0);
      const { renderer, scene, terrain, scenery, water } = viewer;
      const before = { fog: scene.fog, tone: renderer.toneMapping, overlay: terrain.uniforms.classOverlay.value, water: water.mesh.visible };
      const target = new THREE.WebGLRenderTarget(pixels, pixels);
      target.texture.colorSpace = THREE.SRGBColorSpace;
      viewer.override = camera;
      if (classes) {
        terrain.classOverlay = 1;
        scenery.group.visible = water.mesh.visible = viewer.agents.group.visible = viewer.elements.group.visible = false;
        renderer.toneMapping = THREE.NoToneMapping;
      }
      const density = viewer.atmosphere.fog.density;
      viewer.atmosphere.fog.density = 1e-9;
      renderer.setRenderTarget(target);
      viewer.render(0);
      const bytes = new Uint8Array(4 * pixels * pixels);
      renderer.readRenderTargetPixels(target, 0, 0, pixels, pixels, bytes);
      renderer.setRenderTarget(null);
      target.dispose();
      viewer.atmosphere.fog.density = density;
      viewer.override = null;
      terrain.classOverlay = before.overlay;
      renderer.toneMapping = before.tone;
      scenery.group.visible = viewer.agents.group.visible = viewer.elements.group.visible = true;
      water.mesh.visible = before.water;
      return places.map(([x, y]) => {
        const col = Math.min(Math.max(Math.floor((x / (2 * half) + 0.5) * pixels), 0), pixels - 1);
        const row = Math.min(Math.max(Math.floor((y / (2 * half) + 0.5) * pixels), 0), pixels - 1);
        return [...bytes.slice(4 * (row * pixels + col), 4 * (row * pixels + col) + 3)];
      });
    },
  };
}
