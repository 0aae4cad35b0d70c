// Which of many labels are shown, so that each can be read.

const kWidth_px = 84;
const kHeight_px = 34;
const kMostOverlap = 0.3;  // of a label's area

function overlap(a, b) {
  const across = Math.max(0, kWidth_px - Math.abs(a.x - b.x));
  const down = Math.max(0, kHeight_px - Math.abs(a.y - b.y));
  return (across * down) / (kWidth_px * kHeight_px);
}

/**
 * Those of `wanted`, [{x, y, ...}] in pixels with the most important first, that hide no one before
 * them; at most `most`.
 */
export function chooseLabels(wanted, most) {
  const chosen = [];
  for (const label of wanted) {
    if (chosen.length === most) break;
    if (chosen.every((other) => overlap(label, other) <= kMostOverlap)) chosen.push(label);
  }
  return chosen;
}
