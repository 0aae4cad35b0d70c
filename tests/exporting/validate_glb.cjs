// Validates GLBs with Khronos' gltf-validator: node validate_glb.cjs NODE_MODULES FILE...
// Prints one JSON line a file: {"file", "errors", "warnings", "codes"}. A file that requires
// EXT_mesh_gpu_instancing, which the validator does not know, is validated once more as one that
// only uses it, so that all of it is looked at.
'use strict';
const fs = require('fs');
const path = require('path');

const validator = require(path.join(process.argv[2], 'gltf-validator'));

function withoutRequired(glb) {
  const length = glb.readUInt32LE(12);
  const json = JSON.parse(glb.subarray(20, 20 + length).toString('utf8'));
  if (!(json.extensionsRequired || []).includes('EXT_mesh_gpu_instancing')) return null;
  delete json.extensionsRequired;
  let text = Buffer.from(JSON.stringify(json), 'utf8');
  text = Buffer.concat([text, Buffer.alloc((4 - text.length % 4) % 4, 0x20)]);
  const rest = glb.subarray(20 + length);
  const head = Buffer.alloc(20);
  head.write('glTF', 0, 'latin1');
  head.writeUInt32LE(2, 4);
  head.writeUInt32LE(20 + text.length + rest.length, 8);
  head.writeUInt32LE(text.length, 12);
  head.writeUInt32LE(0x4e4f534a, 16);
  return Buffer.concat([head, text, rest]);
}

async function validate(bytes) {
  const report = await validator.validateBytes(new Uint8Array(bytes), {maxIssues: 0});
  const codes = {};
  for (const issue of report.issues.messages) codes[issue.code] = issue.severity;
  return {errors: report.issues.numErrors, warnings: report.issues.numWarnings, codes,
          triangles: report.info ? report.info.totalTriangleCount : null};
}

(async () => {
  for (const file of process.argv.slice(3)) {
    const bytes = fs.readFileSync(file);
    const result = await validate(bytes);
    const other = withoutRequired(bytes);
    const second = other === null ? null : await validate(other);
    console.log(JSON.stringify({
      file,
      errors: result.errors + (second ? second.errors : 0),
      warnings: result.warnings + (second ? second.warnings : 0),
      codes: Object.assign({}, result.codes, second ? second.codes : {}),
      triangles: (second || result).triangles
    }));
  }
})().catch((error) => {
  console.error(error);
  process.exit(1);
});
