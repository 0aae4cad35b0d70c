// Shader of the ground, put into three's Lambert material, so that lights, shadows and fog are as
// everywhere.

const kVertexHead = /* glsl */ `
attribute vec3 tile;  // column, row, stride
uniform sampler2D heightMap;
uniform vec3 gridOrigin;  // west, north, spacing [m]
uniform vec2 gridSize;    // columns, rows
uniform float worldSize, apron;
varying vec3 vPlace;  // map frame [m]
`;

// A vertex of the outermost rows and columns whose skirt goes down stands far outside instead: the
// ground goes on flat from the edge.
const kVertexBody = /* glsl */ `
vec2 gridVertex = min(tile.xy + position.xy * tile.z, gridSize - 1.0);
vec3 transformed = vec3(gridOrigin.x + gridVertex.x * gridOrigin.z, gridOrigin.y - gridVertex.y * gridOrigin.z,
    texelFetch(heightMap, ivec2(gridVertex), 0).r);
if (position.z > 0.5) {
  vec2 outward = vec2(gridVertex.x < 0.5 ? -1.0 : gridVertex.x > gridSize.x - 1.5 ? 1.0 : 0.0,
                      gridVertex.y < 0.5 ? 1.0 : gridVertex.y > gridSize.y - 1.5 ? -1.0 : 0.0);
  if (outward == vec2(0.0)) transformed.z -= tile.z * gridOrigin.z;
  else transformed.xy += outward * apron;
}
vPlace = transformed;
`;

export function kTerrainVertex(source) {
  return kVertexHead + source
      .replace('#include <beginnormal_vertex>', 'vec3 objectNormal = vec3(0.0, 0.0, 1.0);')
      .replace('#include <begin_vertex>', kVertexBody);
}

const kFragmentHead = /* glsl */ `
precision highp sampler2DArray;
uniform sampler2D groundMap, normalMap2, layersA, layersB, classMap;
uniform sampler2DArray tileColors, tileNormals;
uniform vec3 gridOrigin;
uniform vec2 gridSize;
uniform float worldSize, classOverlay, wetness, snowCover, detail;
varying vec3 vPlace;
vec3 groundNormal;  // map frame

void addLayer(float weight, float layer, vec2 uv, vec2 uvDx, vec2 uvDy, inout vec3 tone, inout vec2 bump) {
  if (weight < 0.02) return;
  tone += weight * textureGrad(tileColors, vec3(uv, layer), uvDx, uvDy).rgb;
  bump += weight * (textureGrad(tileNormals, vec3(uv, layer), uvDx, uvDy).rg - 0.5);
}
`;

const kFragmentColor = /* glsl */ `
{
  vec2 mapUv = vPlace.xy / worldSize + 0.5;
  float outside = smoothstep(0.0, 0.06, max(abs(mapUv.x - 0.5), abs(mapUv.y - 0.5)) - 0.5);
  // Beyond the edge the land goes on as its mirror image, softer and softer, and ends in its mean colour.
  vec2 mirrored = abs(mod(mapUv + 1.0, 2.0) - 1.0);
  float beyond = max(max(abs(mapUv.x - 0.5), abs(mapUv.y - 0.5)) - 0.5, 0.0);
  vec3 ground = texture2D(groundMap, clamp(mapUv, 0.002, 0.998)).rgb;
  vec3 softly = textureLod(groundMap, clamp(mirrored, 0.03, 0.97), clamp(1.0 + 3.0 * beyond, 0.0, 5.0)).rgb;
  ground = mix(ground, mix(softly, textureLod(groundMap, vec2(0.5), 6.0).rgb, smoothstep(0.3, 6.0, beyond)), outside);

  vec2 slopes = (texture2D(normalMap2, vec2((vPlace.x - gridOrigin.x) / gridOrigin.z + 0.5,
      (gridOrigin.y - vPlace.y) / gridOrigin.z + 0.5) / gridSize).rg * 2.0 - 1.0) * (1.0 - outside);
  groundNormal = vec3(slopes, sqrt(max(1.0 - dot(slopes, slopes), 0.05)));

  vec4 a = texture2D(layersA, mirrored), b = texture2D(layersB, mirrored);
  float far = length(vViewPosition);
  vec2 uv = vPlace.xy / 3.2, uvDx = dFdx(uv), uvDy = dFdy(uv);
  vec3 tone = vec3(0.0);
  vec2 bump = vec2(0.0);
  float sum = dot(a, vec4(1.0)) + dot(b, vec4(1.0));
  if (detail > 0.0 && far < 260.0 && sum > 0.1) {
    a /= sum; b /= sum;
    addLayer(a.x, 0.0, uv, uvDx, uvDy, tone, bump);
    addLayer(a.y, 1.0, uv, uvDx, uvDy, tone, bump);
    addLayer(a.z, 2.0, uv, uvDx, uvDy, tone, bump);
    addLayer(a.w, 3.0, uv, uvDx, uvDy, tone, bump);
    addLayer(b.x, 4.0, uv, uvDx, uvDy, tone, bump);
    addLayer(b.y, 5.0, uv, uvDx, uvDy, tone, bump);
    addLayer(b.z, 6.0, uv, uvDx, uvDy, tone, bump);
    addLayer(b.w, 7.0, uv, uvDx, uvDy, tone, bump);
    float near = detail * (1.0 - smoothstep(120.0, 260.0, far));
    ground *= mix(vec3(1.0), tone / 0.5, near * 0.85);
    groundNormal = normalize(groundNormal + vec3(bump * 1.6 * (1.0 - smoothstep(30.0, 120.0, far)), 0.0));
  }
  // Larger patches, which no tile repeats.
  float patches = textureLod(tileColors, vec3(vPlace.xy / 71.0, 0.0), 1.0).g + textureLod(tileColors, vec3(vPlace.yx / 29.0, 1.0), 1.0).g;
  ground *= 0.86 + 0.14 * patches;
  ground *= 1.0 - 0.35 * wetness;
  ground = mix(ground, vec3(0.82, 0.86, 0.92), snowCover * smoothstep(0.55, 0.85, groundNormal.z));
  diffuseColor.rgb = mix(ground, texture2D(classMap, clamp(mapUv, 0.0, 1.0)).rgb, min(classOverlay, 0.999));
}
`;

export function kTerrainFragment(source) {
  return kFragmentHead + source
      .replace('#include <color_fragment>', kFragmentColor)
      .replace('#include <normal_fragment_begin>',
               'vec3 normal = normalize((viewMatrix * vec4(groundNormal, 0.0)).xyz);\nvec3 nonPerturbedNormal = normal;')
      .replace('#include <opaque_fragment>',
               'outgoingLight = mix(outgoingLight, diffuseColor.rgb, step(0.99, classOverlay));\n#include <opaque_fragment>');
}
