"use strict";
// The motion as numbers: places of points and turns of bodies at any time. Nothing here draws.
const element = (id) => document.getElementById(id);

// Whole numbers of 16 bits, as base64.
function words(text) {
  const raw = atob(text), out = new Uint16Array(raw.length / 2);
  for (let n = 0; n < out.length; n++) out[n] = raw.charCodeAt(2 * n) | raw.charCodeAt(2 * n + 1) << 8;
  return out;
}

class Film {
  constructor(data) {
    Object.assign(this, data);
    this.motion = words(data.motion);
    this.width = data.low.length;
    this.end = this.times.length ? this.times[this.times.length - 1] : 0;
    this.series.forEach((one) => { one.words = words(one.words); });
    this.now = new Float64Array(this.width);
    // Extent of every point over all time; the origin counts.
    this.box = { low: [0, 0, 0], high: [0, 0, 0] };
    for (let n = 0; n < 3 * (this.points.length - 1); n++) {
      this.box.low[n % 3] = Math.min(this.box.low[n % 3], this.low[n]);
      this.box.high[n % 3] = Math.max(this.box.high[n % 3], this.high[n]);
    }
    // With the solids on the points.
    this.room = { low: [...this.box.low], high: [...this.box.high] };
    const half = { box: (a, b, c) => 0.5 * Math.hypot(a, b, c), cylinder: (r, l) => Math.hypot(r, 0.5 * l), ball: (r) => r };
    for (const { centre, sizes, shape, hidden } of this.bodies)
      for (let axis = 0, reach = shape ? half[shape.kind](...shape.sizes) : sizes ? Math.max(...sizes) : 0; axis < 3 && centre > 0 && !hidden; axis++) {
        this.room.low[axis] = Math.min(this.room.low[axis], this.low[3 * centre - 3 + axis] - reach);
        this.room.high[axis] = Math.max(this.room.high[axis], this.high[3 * centre - 3 + axis] + reach);
      }
    this.usual = this.forces === null ? 0 : this.usual_force();
    this.size = Math.hypot(...[0, 1, 2].map((axis) => this.box.high[axis] - this.box.low[axis])) || 1;
  }

  value(frame, n) { return this.low[n] + (this.high[n] - this.low[n]) * this.motion[frame * this.width + n] / 65535; }

  // The frame before a time, and how far the time is to the next one.
  place(time) {
    let [a, b] = [0, this.times.length - 1];
    while (b - a > 1) { const middle = (a + b) >> 1; if (this.times[middle] <= time) a = middle; else b = middle; }
    const span = this.times[b] - this.times[a];
    return [a, b, span > 0 ? Math.min(Math.max((time - this.times[a]) / span, 0), 1) : 0];
  }

  seek(time) {
    const [a, b, share] = this.place(time);
    for (let n = 0; n < this.width; n++) this.now[n] = (1 - share) * this.value(a, n) + share * this.value(b, n);
  }

  // Point 0 is the origin.
  point(n) { return n === 0 ? new THREE.Vector3() : new THREE.Vector3(this.now[3 * n - 3], this.now[3 * n - 2], this.now[3 * n - 1]); }
  path(n) {
    return this.times.map((_, f) => new THREE.Vector3(this.value(f, 3 * n - 3), this.value(f, 3 * n - 2), this.value(f, 3 * n - 1)));
  }

  // Three times the median of the ground's forces (N): a blow is many times what carries the weight, and its arrow is cut.
  usual_force() {
    const found = [], every = Math.ceil(this.times.length / 200);
    for (let frame = 0; frame < this.times.length; frame += every)
      for (let n = 0; n < this.points.length - 1; n++) {
        const force = this.value(frame, this.forces + n);
        if (force > 1e-4 * this.high[this.forces + n]) found.push(force);
      }
    found.sort((a, b) => a - b);
    return found.length ? 3 * found[found.length >> 1] : 0;
  }

  // The ground's force on a point of a scene (N).
  force(n) { return n > 0 && this.forces !== null ? this.now[this.forces + n - 1] : 0; }

  // The turn of a body: its frame's x and y axes stand behind the points; null for a particle.
  turn(turn) {
    if (turn === null) return new THREE.Matrix4();
    const at = 3 * (this.points.length - 1) + 6 * turn;
    const x = new THREE.Vector3(this.now[at], this.now[at + 1], this.now[at + 2]).normalize();
    const y = new THREE.Vector3(this.now[at + 3], this.now[at + 4], this.now[at + 5]);
    const z = new THREE.Vector3().crossVectors(x, y).normalize();
    return new THREE.Matrix4().makeBasis(x, new THREE.Vector3().crossVectors(z, x), z);
  }

  rests(n) { return n === 0 || [0, 1, 2].every((axis) => this.high[3 * n - 3 + axis] - this.low[3 * n - 3 + axis] < 1e-9 * this.size); }

  series_at(one, time) {
    const [a, b, share] = this.place(time);
    return one.low + (one.high - one.low) * ((1 - share) * one.words[a] + share * one.words[b]) / 65535;
  }
}
