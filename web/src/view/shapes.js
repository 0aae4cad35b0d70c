// What each agent and each element looks like.

/** Row of the table `agents` -> shape for Bodies. */
export function agentShapes(description, models) {
  const species = new Map(description.species.map((entry) => [entry.name, entry]));
  return ({ species: name }) => {
    const entry = species.get(name) ?? { node: `agent/${name}`, height_m: 1, radius_m: 0.4 };
    return {
      key: entry.node, geometry: models.bodyOf(entry.node, entry.height_m, entry.radius_m), scale: [1, 1, 1], lift_m: 0,
      height_m: entry.height_m,
    };
  };
}

/** Row of the table `elements` -> shape. Their meshes fill a box of one metre around their middle. */
export function elementShapes(description, models) {
  const nodes = new Map(description.elements.map((entry) => [entry.kind, entry.node]));
  const boxes = new Map();
  return ({ kind, size_m }) => {
    const node = nodes.get(kind) ?? `element/${kind}`;
    const geometry = models.bodyOf(node, 1, 0.5);
    if (!boxes.has(node)) {
      geometry.computeBoundingBox();
      boxes.set(node, geometry.boundingBox);
    }
    const { min, max } = boxes.get(node);
    const scale = ['x', 'y', 'z'].map((axis, i) => size_m[i] / Math.max(max[axis] - min[axis], 0.01));
    return { key: node, geometry, scale, lift_m: -(0.5 * (min.z + max.z)) * scale[2], height_m: size_m[2] };
  };
}
