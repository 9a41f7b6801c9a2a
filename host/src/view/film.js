"use strict";
// The motion as numbers: places of points and turns of bodies at any time. Nothing here draws.
const element = (id) => document.getElementById(id);

// Whole numbers of 16 bits, as base64.
function words(text) {
  const raw = atob(text), out = new Uint16Array(raw.length / 2);
  for (let n = 0; n < out.length; n++) out[n] = raw.charCodeAt(2 * n) | raw.charCodeAt(2 * n + 1) << 8;
  return out;
}

// Numbers of 32 bits, as base64.
function floats(text) { return new Float32Array(Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)).buffer); }

// The least of 1, 2, 5 times a power of ten that is not below x > 0.
function round(x) { const power = 10 ** Math.floor(Math.log10(x)); return power * [1, 2, 5, 10].find((n) => n * power >= x * (1 - 1e-9)); }

class Film {
  constructor(data) {
    Object.assign(this, data);
    this.forces = floats(data.forces);
    this.starts = [0];
    for (const count of data.contacts) this.starts.push(this.starts[this.starts.length - 1] + count);
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
    this.usual = this.usual_force();
    // Solids are what a world is as large as.
    const { low, high } = this.bones === "bare" ? this.room : this.box;
    this.size = Math.hypot(...[0, 1, 2].map((axis) => high[axis] - low[axis])) || 1;
    this.full = this.full_strain();
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

  // Contacts of the frame before a time: where, forces (N) along and across the normal, whether both are pushed.
  touching(time) {
    const frame = this.place(time)[time < this.end ? 0 : 1], found = [];
    const three = (at) => new THREE.Vector3(...this.forces.subarray(at, at + 3));
    for (let n = this.starts[frame]; n < this.starts[frame + 1]; n++)
      found.push({ point: three(10 * n), normal: three(10 * n + 3), friction: three(10 * n + 6), both: this.forces[10 * n + 9] > 0 });
    return found;
  }

  // Three times the median of the normal forces (N): a blow is many times what carries the weight, and its arrow is cut.
  usual_force() {
    const found = [];
    for (let at = 0; at < this.forces.length; at += 10) found.push(Math.hypot(...this.forces.subarray(at + 3, at + 6)));
    const largest = found.reduce((most, force) => Math.max(most, force), 0), told = found.filter((force) => force > 1e-4 * largest).sort((a, b) => a - b);
    return told.length ? 3 * told[told.length >> 1] : 0;
  }

  // By how much a spring is longer than at rest, as a part of that.
  strain(spring) {
    const [a, b, rest] = this.edges[spring];
    return rest > 0 ? this.point(a).distanceTo(this.point(b)) / rest - 1 : 0;
  }

  // What gets the full colour: a round strain that two of a hundred exceed, over all time.
  full_strain() {
    const found = [], every = Math.ceil(this.times.length / 24), spring = Math.ceil(this.edges.length / 2000);
    for (let frame = 0; frame < this.times.length; frame += every) {
      this.seek(this.times[frame]);
      for (let n = 0; n < this.edges.length; n += spring) found.push(Math.abs(this.strain(n)));
    }
    found.sort((a, b) => a - b);
    return round(Math.max(found.length ? found[Math.floor(0.98 * (found.length - 1))] : 0.1, 1e-6));
  }

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
