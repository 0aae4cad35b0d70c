// Driving a robot: keyboard, gamepad or a joystick on the screen.

const kPeriod_ms = 100;  // the server stops a robot of which it has not heard for 0.4 s
const kDeadZone = 0.14;

const kWays = {
  KeyW: [1, 0], ArrowUp: [1, 0], KeyS: [-1, 0], ArrowDown: [-1, 0], KeyA: [0, 1], ArrowLeft: [0, 1], KeyD: [0, -1], ArrowRight: [0, -1],
};

/** Keys that are down -> {forward, left, up} in [-1, 1]. */
export function wayOfKeys(keys) {
  let forward = 0;
  let left = 0;
  for (const key of keys) {
    const way = kWays[key];
    if (way) {
      forward += way[0];
      left += way[1];
    }
  }
  const up = (keys.has('KeyE') ? 1 : 0) - (keys.has('KeyQ') ? 1 : 0);
  return { forward: Math.sign(forward), left: Math.sign(left), up };
}

function wayOfGamepad() {
  const pad = [...(navigator.getGamepads?.() ?? [])].find((entry) => entry?.connected);
  if (!pad) return null;
  const axis = (value) => (Math.abs(value ?? 0) < kDeadZone ? 0 : value);
  return { forward: -axis(pad.axes[1]), left: -axis(pad.axes[2] ?? pad.axes[0]) || -axis(pad.axes[0]), up: -axis(pad.axes[3]), strike: pad.buttons[0]?.pressed };
}

export class Driving {
  /** send: (message) -> anything; keys: the Set of codes that are down */
  constructor(send, keys) {
    this.send = send;
    this.keys = keys;
    this.stick = { forward: 0, left: 0 };
    this.robot = null;  // {name, top_speed_mps, turn_rate_radps, flies}
    this.moving = false;
    this.struck = false;
    setInterval(() => this.#tick(), kPeriod_ms);
  }

  start(robot) {
    this.stop();
    this.robot = robot;
  }

  stop() {
    if (this.robot && this.moving) this.#drive({ forward: 0, left: 0, up: 0 });
    this.moving = false;
    this.robot = null;
    this.stick = { forward: 0, left: 0 };
  }

  strike() {
    if (this.robot) this.send({ type: 'strike', robot: this.robot.name });
  }

  #tick() {
    if (!this.robot) return;
    let way = wayOfKeys(this.keys);
    if (!way.forward && !way.left && !way.up) way = { ...this.stick, up: 0 };
    const pad = wayOfGamepad();
    if (pad) {
      if (!way.forward && !way.left && !way.up) way = pad;
      if (pad.strike && !this.struck) this.strike();
      this.struck = pad.strike;
    }
    const moves = way.forward !== 0 || way.left !== 0 || way.up !== 0;
    if (moves || this.moving) this.#drive(way);
    this.moving = moves;
  }

  #drive({ forward, left, up }) {
    const { name, top_speed_mps, turn_rate_radps, flies } = this.robot;
    const fast = this.keys.has('ShiftLeft') || this.keys.has('ShiftRight') ? 1 : 0.7;
    this.send({
      type: 'drive', robot: name, linear_mps: forward * top_speed_mps * fast, angular_radps: left * Math.min(turn_rate_radps, 2),
      ...(flies ? { vertical_mps: up * 2 } : {}),
    });
  }
}
