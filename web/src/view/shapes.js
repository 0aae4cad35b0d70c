// What each agent and each element looks like.

/** Row of the table `agents` -> shape for Bodies. */
export function agentShapes(description, models) {
  const species = new Map(description.species.map((entry) => [entry.name, entry]));
  return ({ species: name }) => {
    const entry = species.get(name) ?? { node: `agent/${name}`, height_m: 1, radius_m: 0.4 };
    return {
      key: entry.node, geometry: models.bodyOf(entry.node, entry.height_m, entry.radius_m), scale: [1, 1, 1],
      height_m: entry.height_m,
    };
  };
}

/**
 * Row of the table `elements` -> shape. Their meshes are of size 1 about the origin that poses tell of: the
 * middle of the base, of a gate the base of its hinge.
 */
export function elementShapes(description, models) {
  const nodes = new Map(description.elements.map((entry) => [entry.kind, entry.node]));
  return ({ kind, size_m }) => {
    const node = nodes.get(kind) ?? `element/${kind}`;
    return { key: node, geometry: models.bodyOf(node, 1, 0.5), scale: size_m, height_m: size_m[2] };
  };
}
