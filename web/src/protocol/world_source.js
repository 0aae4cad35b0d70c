// Reads a world from the server: its description and its payloads.

import { addressOf } from './addresses.js';
import { HeightField, decodeAssets, decodeWater } from './payloads.js';

const kBinary = ['height', 'water', 'weights', 'surface', 'assets'];

/** Reads a path of the server. */
async function fetchOk(path, options) {
  const response = await fetch(addressOf(path), options);
  if (response.ok) return response;
  let text = `${path}: ${response.status} ${response.statusText}`;
  try {
    text = (await response.json()).message;
  } catch {
    // no JSON: the status line says enough
  }
  throw Object.assign(new Error(text), { status: response.status });
}

/** Reads a payload and tells onBytes of every part that arrives. */
async function readBytes(url, onBytes, signal) {
  const response = await fetchOk(url, { signal });
  const reader = response.body.getReader();
  const parts = [];
  let length = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    parts.push(value);
    length += value.length;
    onBytes(value.length);
  }
  const bytes = new Uint8Array(length);
  let offset = 0;
  for (const part of parts) {
    bytes.set(part, offset);
    offset += part.length;
  }
  return bytes.buffer;
}

async function readImage(url, signal) {
  const blob = await (await fetchOk(url, { signal })).blob();
  return createImageBitmap(blob, { imageOrientation: 'flipY', colorSpaceConversion: 'none' });
}

/**
 * Reads the running world but its models, which are most of its bytes. onProgress: fraction in [0, 1].
 * Errors: with `status` 404 where no world runs; AbortError.
 * @returns {Promise<object>} {description, height, water_m, weights, surface, assets, ground, layout}; images have row 0 south, as textures do
 */
export async function readWorld(onProgress, signal) {
  const description = await (await fetchOk('/api/world.json', { signal, cache: 'no-cache' })).json();
  const { payloads } = description;
  const present = kBinary.filter((name) => payloads[name]);
  const total = present.reduce((sum, name) => sum + payloads[name].bytes, 0);
  let read = 0;
  const onBytes = (count) => {
    read += count;
    onProgress(Math.min(read / total, 1));
  };
  const binary = {};
  const images = {};
  await Promise.all([
    ...present.map(async (name) => {
      binary[name] = await readBytes(payloads[name].url, onBytes, signal);
    }),
    ...['ground', 'layout'].filter((name) => payloads[name]).map(async (name) => {
      images[name] = await readImage(payloads[name].url, signal);
    }),
  ]);
  return {
    description,
    height: new HeightField(description.height, binary.height),
    water_m: decodeWater(description.height, binary.water),
    weights: new Uint8Array(binary.weights),
    surface: new Uint8Array(binary.surface),
    assets: decodeAssets(description.assets, binary.assets),
    ...images,
  };
}

/** Reads the models of a world; null where it has none. Errors as of readWorld(). */
export async function readModels({ payloads }, onProgress, signal) {
  if (!payloads.models) return null;
  let read = 0;
  return readBytes(payloads.models.url, (count) => {
    read += count;
    onProgress(Math.min(read / payloads.models.bytes, 1));
  }, signal);
}
