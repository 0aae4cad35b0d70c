// How finely a thing is drawn, by how far away it is.

// A level is drawn up to this many heights of its things away (the last level: kSightHeights).
const kLevelHeights = [2.5, 8, 24];
const kSightHeights = 260;

/** How far [m] a thing of that height is drawn at all. quality: 1 all, less is nearer. */
export function sightOf(height_m, quality) {
  return kSightHeights * height_m * quality;
}

/**
 * Level of detail, 0 the finest of `count`, of a thing of that height [m] at that distance [m].
 * scale: 1; more keeps finer levels farther away.
 */
export function levelAt(distance_m, height_m, scale, count) {
  let level = 0;
  while (level < count - 1 && distance_m > (kLevelHeights[level] ?? Infinity) * height_m * scale) level++;
  return level;
}

/** Where that level begins [m]. */
export function beginOf(level, height_m, scale) {
  return level === 0 ? 0 : (kLevelHeights[level - 1] ?? Infinity) * height_m * scale;
}
