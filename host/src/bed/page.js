// Frames are inflated, summed up byte by byte, and shown: in space, as maps, as a table.
const by = (id) => document.getElementById(id);
const data = JSON.parse(by("data").textContent);
by("title").textContent = data.title;
by("note").textContent = data.note;
const [rows, columns] = data.tiles, tiles = rows * columns, wide = data.across.length, high = data.along.length;
const nodes = wide * high, length = 3 * nodes * tiles + 4 * tiles + 14 * data.segments.length;
let frames = [], shown = 0;

// Blue to red over the range, white where nothing presses.
const hue = (share) => 240 - 240 * Math.min(1, share);
const colour = (share) => (share <= 0 ? "#fff" : `hsl(${hue(share)} 80% 55%)`);

async function inflate(text) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  const all = new Uint8Array(await new Response(stream).arrayBuffer()), found = [];
  for (let at = 0; at + length <= all.length; at += length) {
    const frame = all.slice(at, at + length), before = found[found.length - 1];
    if (before) for (let n = 0; n < length; n++) frame[n] += before[n];
    found.push(frame);
  }
  return found;
}

// A map: every node is a box as wide as what belongs to it; the frame is as wide as its tiles.
function draw(id, frame, from, most, unit) {
  const canvas = by(id), pen = canvas.getContext("2d");
  const xs = data.middles.map((m) => m[0]), ys = data.middles.map((m) => m[1]), [a, b] = data.size;
  const [left, top] = [Math.min(...xs) - a / 2, Math.max(...ys) + b / 2];
  const [width, height] = [Math.max(...xs) + a / 2 - left, top - Math.min(...ys) + b / 2];
  const scale = Math.min(300 / width, 560 / height);
  [canvas.width, canvas.height] = [Math.ceil(scale * width), Math.ceil(scale * height)];
  let largest = 0;
  data.middles.forEach(([x, y], tile) => {
    for (let j = 0; j < high; j++) for (let i = 0; i < wide; i++) {
      const value = frame[from + tile * nodes + j * wide + i];
      largest = Math.max(largest, value);
      if (!value) continue;
      const ends = (shares, k) => [k ? (shares[k - 1] + shares[k]) / 2 : 0, k + 1 < shares.length ? (shares[k] + shares[k + 1]) / 2 : 1];
      const [u, v] = ends(data.across, i), [s, t] = ends(data.along, j);
      pen.fillStyle = colour(value / most);
      pen.fillRect(scale * (x - a / 2 + a * u - left), scale * (top - (y - b / 2 + b * t)), scale * a * (v - u) + 0.5, scale * b * (t - s) + 0.5);
    }
    pen.strokeStyle = "#bbb";
    pen.strokeRect(scale * (x - a / 2 - left), scale * (top - y - b / 2), scale * a, scale * b);
  });
  canvas.title = `largest ${largest / unit}`;
}

class Space {
  constructor(canvas) {
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.renderer.setClearColor(0xffffff);
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(35, canvas.width / canvas.height, 0.05, 30);
    this.camera.up.set(0, 0, 1);
    const far = 0.75 * Math.hypot(columns * 0.25, rows * 0.3) + 0.5;
    this.camera.position.set(1.2 * far, -1.3 * far, 1.2 * far);
    this.controls = new THREE.OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => this.render());
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x888888, 2.5));
    const light = new THREE.DirectionalLight(0xffffff, 1.5);
    light.position.set(1, -2, 4);
    this.scene.add(light);
    this.sheets = data.middles.map(() => this.sheet());
    this.segments = data.segments.map((shape) => this.segment(shape));
  }

  sheet() {
    const geometry = new THREE.BufferGeometry(), corners = [];
    for (let j = 0; j + 1 < high; j++) for (let i = 0; i + 1 < wide; i++) {
      const n = j * wide + i;
      corners.push(n, n + 1, n + wide + 1, n, n + wide + 1, n + wide);
    }
    for (const name of ["position", "color"]) geometry.setAttribute(name, new THREE.BufferAttribute(new Float32Array(3 * nodes), 3));
    geometry.setIndex(corners);
    const mesh = new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({ vertexColors: true, side: THREE.DoubleSide }));
    mesh.frustumCulled = false;
    this.scene.add(mesh);
    return mesh;
  }

  // A mesh as it is; a box with round edges as its ball or, longer, as balls at the corners' middles and a box between.
  segment(shape) {
    const group = new THREE.Group(), skin = new THREE.MeshLambertMaterial({ color: 0xe0b49a, transparent: true, opacity: 0.55 });
    if (shape.corners) {
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(shape.corners), 3));
      geometry.setIndex(shape.triangles);
      geometry.computeVertexNormals();
      group.add(new THREE.Mesh(geometry, skin));
      this.scene.add(group);
      return group;
    }
    const [a, b, c, r] = shape;
    const put = (geometry, x, y, z) => { const mesh = new THREE.Mesh(geometry, skin); mesh.position.set(x, y, z); group.add(mesh); };
    for (const x of a ? [-a, a] : [0]) for (const y of b ? [-b, b] : [0]) for (const z of c ? [-c, c] : [0]) put(new THREE.SphereGeometry(r, 16, 12), x, y, z);
    if (a + b + c) put(new THREE.BoxGeometry(2 * a + (a ? 0 : 1.6 * r), 2 * b + (b ? 0 : 1.6 * r), 2 * c + (c ? 0 : 1.6 * r)), 0, 0, 0);
    this.scene.add(group);
    return group;
  }

  show(frame) {
    const paint = new THREE.Color();
    this.sheets.forEach((mesh, tile) => {
      const [x, y] = data.middles[tile], place = mesh.geometry.attributes.position, tint = mesh.geometry.attributes.color;
      for (let n = 0; n < nodes; n++) {
        const at = tile * nodes + n, value = frame[nodes * tiles + at];
        place.setXYZ(n, x + data.size[0] * (data.across[n % wide] - 0.5), y + data.size[1] * (data.along[Math.floor(n / wide)] - 0.5), (frame[at] - 128) / 1000);
        value ? paint.setHSL(hue(value / 100) / 360, 0.8, 0.55) : paint.set(0xdddddd);
        tint.setXYZ(n, paint.r, paint.g, paint.b);
      }
      place.needsUpdate = tint.needsUpdate = true;
      mesh.geometry.computeVertexNormals();
    });
    const words = new DataView(frame.buffer, 3 * nodes * tiles + 4 * tiles);
    this.segments.forEach((group, n) => {
      const word = (k) => words.getInt16(14 * n + 2 * k, true);
      group.position.set(word(0) / 1e4, word(1) / 1e4, word(2) / 1e4);
      group.quaternion.set(word(4), word(5), word(6), word(3)).normalize();
    });
    this.render();
  }

  render() { this.renderer.render(this.scene, this.camera); }
}

function table(frame) {
  const body = by("tiles"), from = 3 * nodes * tiles;
  body.replaceChildren();
  data.middles.forEach((_, tile) => {
    if (tile % columns === 0) body.insertRow();
    const [gauge, heave, x, y] = frame.slice(from + 4 * tile, from + 4 * tile + 4);
    const tilt = Math.atan(Math.hypot((x - 128) / 500, (y - 128) / 500)) * 180 / Math.PI;
    body.rows[body.rows.length - 1].insertCell().textContent = `${tile + 1}: ${(gauge / 20).toFixed(2)} · ${((heave - 128) / 2).toFixed(1)} · ${tilt.toFixed(1)}`;
  });
}

let space = null;
function show(number) {
  shown = number;
  const frame = frames[number];
  if (!frame) return;
  by("clock").textContent = `${data.times[number]} s`;
  draw("pressure", frame, nodes * tiles, 100, 1);
  draw("shear", frame, 2 * nodes * tiles, 20, 10);
  table(frame);
  if (space) space.show(frame);
}

const slider = by("time");
let playing = null;
slider.oninput = () => show(Number(slider.value));
by("play").onclick = () => {
  by("play").textContent = playing ? "play" : "stop";
  if (playing) { clearInterval(playing); playing = null; return; }
  playing = setInterval(() => { slider.value = (shown + 1) % frames.length; show(Number(slider.value)); }, 100);
};
// Without WebGL maps and words are left.
try { space = new Space(by("space")); } catch { by("space").remove(); }
inflate(data.frames).then((found) => {
  frames = found;
  slider.max = Math.max(0, frames.length - 1);
  show(0);
  document.body.dataset.frames = frames.length;
});
