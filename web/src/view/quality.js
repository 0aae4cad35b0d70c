// How much is drawn, so that it stays smooth: goes down where frames are slow, up where there is time.

/** Steps from the finest to the coarsest. */
export const kQualitySteps = Object.freeze([
  { name: 'high', pixels: 2, shadowMap: 2048, shadowRadius_m: 90, detail: 1, plants: 1, particles: 1 },
  { name: 'medium', pixels: 1.25, shadowMap: 2048, shadowRadius_m: 70, detail: 1, plants: 0.75, particles: 0.8 },
  { name: 'low', pixels: 1, shadowMap: 1024, shadowRadius_m: 55, detail: 1, plants: 0.5, particles: 0.5 },
  { name: 'lower', pixels: 0.75, shadowMap: 1024, shadowRadius_m: 45, detail: 1, plants: 0.32, particles: 0.3 },
  { name: 'least', pixels: 0.5, shadowMap: 0, shadowRadius_m: 0, detail: 0, plants: 0.2, particles: 0.15 },
]);

const kSlow_ms = 40;       // frames longer than this are too slow
const kFast_ms = 19;       // there is time for more
const kLongest_ms = 700;   // so that one very long frame alone decides nothing
const kSlowSeconds = 1.2;  // how long it has to be so
const kFastSeconds = 8;

export class QualityGovernor {
  #slow_s = 0;
  #fast_s = 0;
  #ceiling = 0;  // a step that proved too slow is not tried again

  constructor(step = 1) {
    this.step = step;
    this.fixed = false;
  }

  get settings() {
    return kQualitySteps[this.step];
  }

  /** The user's choice; 'auto' leaves it to the frames. */
  choose(name) {
    const step = kQualitySteps.findIndex((entry) => entry.name === name);
    this.fixed = step >= 0;
    if (this.fixed) this.step = step;
    this.#ceiling = 0;
  }

  /** Tells how long a frame took; true where the step has changed. */
  frame(duration_ms) {
    if (this.fixed) return false;
    const seconds = Math.min(duration_ms, kLongest_ms) / 1000;
    this.#slow_s = duration_ms > kSlow_ms ? this.#slow_s + seconds : Math.max(this.#slow_s - seconds, 0);
    this.#fast_s = duration_ms < kFast_ms ? this.#fast_s + seconds : 0;
    if (this.#slow_s > kSlowSeconds && this.step < kQualitySteps.length - 1) {
      this.step++;
      this.#ceiling = Math.max(this.#ceiling, this.step);
      this.#slow_s = this.#fast_s = 0;
      return true;
    }
    if (this.#fast_s > kFastSeconds && this.step > this.#ceiling) {
      this.step--;
      this.#fast_s = this.#slow_s = 0;
      return true;
    }
    return false;
  }
}
