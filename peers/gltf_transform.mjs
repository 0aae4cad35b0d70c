// glTF-Transform reads an export --to glb, prunes, quantizes and writes it again; Khronos' validator
// looks at both.
// npm: @gltf-transform/core@4.5.1 @gltf-transform/extensions@4.5.1 @gltf-transform/functions@4.5.1 gltf-validator@2.0.0-dev.3.10
import fs from 'node:fs';
import {createRequire} from 'node:module';
import {NodeIO} from '@gltf-transform/core';
import {ALL_EXTENSIONS} from '@gltf-transform/extensions';
import {dedup, prune, quantize, weld} from '@gltf-transform/functions';
import {Peer, assetCount, exported, versionOf} from './peer.mjs';

const validator = createRequire(import.meta.url)('gltf-validator');

async function faults(bytes) {
  const {issues} = await validator.validateBytes(new Uint8Array(bytes), {maxIssues: 0});
  return issues;
}

function instances(document) {
  let count = 0, numbers = new Set();
  for (const node of document.getRoot().listNodes()) {
    const batch = node.getExtension('EXT_mesh_gpu_instancing');
    if (!batch) continue;
    const asset = batch.getAttribute('_ASSET');
    count += batch.getAttribute('TRANSLATION').getCount();
    for (let i = 0; asset && i < asset.getCount(); ++i) numbers.add(asset.getElement(i, [])[0]);
  }
  return [count, numbers.size];
}

const peer = new Peer('glTF-Transform', versionOf('@gltf-transform/core'),
                      '`--to glb`; Khronos\' validator ' + versionOf('gltf-validator'));
const file = exported('glb', 'instanced.glb');
const io = new NodeIO().registerExtensions(ALL_EXTENSIONS);
const given = await faults(fs.readFileSync(exported('glb', 'expanded.glb', '--expand')));
peer.check('validator on --expand', given.numErrors + given.numWarnings === 0,
           `${given.numErrors} errors, ${given.numWarnings} warnings`);
const document = await io.read(file);
const before = instances(document);
peer.check('instances', before[0] === assetCount() && before[1] === assetCount(),
           `${before[0]} of ${assetCount()}, ${before[1]} numbers`);
await document.transform(dedup(), weld(), quantize(), prune());
const bytes = await io.writeBinary(document);
const after = instances(await io.readBinary(bytes));
peer.check('after dedup, weld, quantize, prune', after[0] === before[0] && after[1] === before[1],
           `${after[0]} instances, ${after[1]} numbers, ${fs.statSync(file).size} to ${bytes.length} bytes`);
const written = await faults(bytes);
peer.check('validator on what it wrote', written.numErrors === 0,
           `${written.numErrors} errors, ${written.numWarnings} warnings`);
peer.finish();
