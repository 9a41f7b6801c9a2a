// Time, its slider and speed; plots with a cursor, ledger, events; following the file where it is served.
const COLORS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#000000"];
// Marks on a curve.
const MARKS = 5;
const ENERGY = { kinetic: "#e69f00", gravity: "#cc79a7", spring: "#d55e00", pressure: "#56b4e9", potential: "#009e73", total: "#0072b2" };
// Without WebGL nothing can be drawn: say so, and stop.
const stage = (() => {
  try { return new Stage(element("stage")); } catch (error) { element("fault").textContent = "this browser draws nothing in 3-D (no WebGL)"; throw error; }
})();
let film, time = 0, playing = true, last = null, frames = 0, since = 0;

function load(data, keep) {
  film = new Film(data);
  document.title = film.title;
  element("title").textContent = film.title;
  element("note").textContent = film.note;
  const groups = [...new Set(film.series.map((one) => one.group))].filter((group) => group !== "energy [J]");
  element("group").replaceChildren(...groups.map((group) => Object.assign(document.createElement("option"), { textContent: group })));
  element("events").replaceChildren(...film.events.map(([at, text]) => {
    const item = document.createElement("li"), button = document.createElement("button");
    button.textContent = at.toFixed(4) + " s  " + text;
    button.onclick = () => { play(false); wind(at); };
    item.append(button);
    return item;
  }));
  element("paint-of").style.display = film.surfaces.some((one) => one.gauge) ? "" : "none";
  if (!keep) element("paint").value = film.paint || "stretch";
  element("events-head").style.display = film.events.length ? "" : "none";
  time = keep ? Math.min(time, film.end) : 0;
  stage.show(film, keep);
}

function play(yes) { playing = yes; element("play").textContent = yes ? "pause" : "play"; }
function wind(to) { time = Math.min(Math.max(to, 0), film.end); draw(); }

function draw() {
  if (!film || !film.times.length) return;
  stage.draw(time, element("paths").checked, element("paint").value);
  labels();
  const chosen = element("group").value;
  plot(element("energies"), film.series.filter((one) => one.group === "energy [J]"));
  plot(element("curves"), film.series.filter((one) => one.group === chosen));
  table(element("ledger"), film.series.filter((one) => one.group === "energy [J]" || one.group === "ledger"));
  table(element("values"), film.series.filter((one) => one.group === chosen));
  [...element("events").children].forEach((item, n) => { item.className = film.events[n][0] <= time ? "past" : ""; });
  element("clock").textContent = time.toFixed(3) + " s of " + film.end.toFixed(2) + " s";
  element("time").value = film.end ? time / film.end : 0;
}

function pen(canvas) {
  const ratio = window.devicePixelRatio || 1, [width, height] = [canvas.clientWidth, canvas.clientHeight];
  [canvas.width, canvas.height] = [ratio * width, ratio * height];
  const pen = canvas.getContext("2d");
  pen.scale(ratio, ratio); pen.font = "12px 'Noto Sans', Arial, sans-serif";
  return [pen, width, height];
}

// Names of points, g beside its arrow, and a bar of a round length.
function labels() {
  const [ink, , height] = pen(element("words"));
  const write = (text, [x, y]) => { ink.lineWidth = 3; ink.strokeStyle = "#fff"; ink.strokeText(text, x, y); ink.fillStyle = "#282828"; ink.fillText(text, x, y); };
  if (element("names").checked && film.edges.length < 200) film.points.forEach((name, n) => { if (stage.covered.has(n)) return; const [x, y] = stage.screen(stage.at[n]); write(name, [x + 8, y - 7]); });
  if (stage.fall) { const [x, y] = stage.screen(stage.fall.tip); write("g", [x + 8, y]); }
  if (stage.strongest) { const [x, y] = stage.screen(stage.strongest.tail); write(Number(stage.strongest.force.toPrecision(3)) + " N", [x + 8, y + 4]); }
  key(ink, write, height);
  const middle = stage.control.target, right = new THREE.Vector3().setFromMatrixColumn(stage.camera.matrixWorld, 0);
  const [a, b] = [stage.screen(middle), stage.screen(middle.clone().addScaledVector(right, 0.01 * film.size))];
  const metre = Math.hypot(b[0] - a[0], b[1] - a[1]) / (0.01 * film.size), wanted = 160 / metre, power = 10 ** Math.floor(Math.log10(wanted));
  const length = power * [5, 2, 1].find((n) => n * power <= wanted);
  ink.strokeStyle = "#555"; ink.lineWidth = 2; ink.beginPath(); ink.moveTo(16, height - 14); ink.lineTo(16 + length * metre, height - 14); ink.stroke();
  write(Number(length.toPrecision(2)) + " m", [16, height - 22]);
}

// What colours and arrows mean: a bar for stretch or pressure, an arrow for each kind of force that is there.
function key(ink, write, height) {
  const left = ink.canvas.clientWidth - 236, skin = stage.surface, paint = element("paint").value, bar = [];
  if (paint === "pressure" && skin && skin.gauges.length) {
    const [low, high] = skin.range(), kilo = Math.max(-low, high) >= 1000 ? [1e3, "kPa"] : [1, "Pa"];
    for (let n = 0; n <= 100; n++) bar.push(pressed(n / 100));
    write("gauge pressure [" + kilo[1] + "]", [left, height - 36]);
    bar.ends = [low, high].map((x) => Number((x / kilo[0]).toPrecision(3)).toString());
  } else if ((skin && skin.moving.length && !film.colours.surface) || (stage.bones.length && !film.colours.springs)) {
    for (let n = 0; n <= 100; n++) bar.push(strained(n / 50 - 1, skin ? SKIN : REST));
    write("stretch [%]", [left, height - 36]);
    bar.ends = [-1, 1].map((sign) => (sign < 0 ? "\u2212" : "+") + Number((100 * film.full).toPrecision(3)));
  }
  bar.forEach((color, n) => { ink.fillStyle = "#" + color.getHexString(); ink.fillRect(left + 2 * n, height - 30, 2, 10); });
  if (bar.length) {
    write(bar.ends[0], [left, height - 6]);
    ink.textAlign = "right"; write(bar.ends[1], [left + 202, height - 6]); ink.textAlign = "left";
  }
  const kinds = [[stage.normals.count, FORCE, "normal force"], [stage.frictions.count, FRICTION, "friction"]].filter(([count]) => count);
  kinds.forEach(([, color, name], n) => {
    const y = 18 + 18 * n;
    ink.strokeStyle = ink.fillStyle = "#" + color.toString(16).padStart(6, "0"); ink.lineWidth = 3;
    ink.beginPath(); ink.moveTo(16, y - 4); ink.lineTo(34, y - 4); ink.stroke();
    ink.beginPath(); ink.moveTo(34, y - 9);
    if (color === FRICTION) { ink.lineTo(40, y - 7); ink.lineTo(40, y - 1); } else ink.lineTo(42, y - 4);
    ink.lineTo(34, y + 1); ink.fill();
    write(name, [50, y]);
  });
}

const colorOf = (one, n) => ENERGY[one.name] || COLORS[n % COLORS.length];

// A curve's mark, in the order of plots: disk, square, two triangles, diamond, plus, cross.
function mark(ink, n, x, y) {
  const turned = (angles, r) => angles.map((angle) => [x + r * Math.cos(angle * Math.PI / 180), y - r * Math.sin(angle * Math.PI / 180)]), kind = n % 7;
  const arms = [[1, 0], [0, 1]].map(([a, b]) => (kind === 5 ? [a, b] : [0.7 * (a + b), 0.7 * (a - b)]));
  ink.beginPath();
  if (kind > 4) {
    ink.save(); ink.lineWidth = 2; ink.strokeStyle = ink.fillStyle;
    arms.forEach(([a, b]) => { ink.moveTo(x - 4 * a, y - 4 * b); ink.lineTo(x + 4 * a, y + 4 * b); });
    ink.stroke(); ink.restore();
    return;
  }
  if (kind === 0) ink.arc(x, y, 3.2, 0, 7);
  else turned([[45, 135, 225, 315], [90, 210, 330], [30, 150, 270], [0, 90, 180, 270]][kind - 1], 4.4).forEach(([a, b]) => ink.lineTo(a, b));
  ink.fill();
}

function plot(canvas, list) {
  const [ink, width, height] = pen(canvas), left = 52, bottom = height - 18, across = (t) => left + (width - left - 6) * (film.end ? t / film.end : 0);
  let [low, high] = [Math.min(...list.map((one) => one.low)), Math.max(...list.map((one) => one.high))];
  if (!list.length) return;
  if (!(high - low > 1e-6 * Math.max(-low, high))) [low, high] = [low - (Math.abs(low) || 1), high + (Math.abs(high) || 1)];
  const up = (value) => bottom - (bottom - 8) * (value - low) / (high - low);
  ink.strokeStyle = "#ccc"; ink.lineWidth = 1; ink.strokeRect(left, 8, width - left - 6, bottom - 8);
  ink.fillStyle = "#282828"; ink.textAlign = "right";
  [low, 0.5 * (low + high), high].forEach((value) => ink.fillText(Number((Math.abs(value) < 2e-3 * (high - low) ? 0 : value).toPrecision(3)).toString(), left - 4, up(value) + 4));
  ink.fillText(film.end.toPrecision(3) + " s", width - 6, height - 4);
  list.forEach((one, n) => {
    ink.strokeStyle = colorOf(one, n); ink.lineWidth = 1.5; ink.beginPath();
    film.times.forEach((t, f) => { const y = up(one.low + (one.high - one.low) * one.words[f] / 65535); if (f) ink.lineTo(across(t), y); else ink.moveTo(across(t), y); });
    ink.stroke();
    ink.fillStyle = colorOf(one, n);
    for (let k = 0; k < MARKS; k++) {
      const f = Math.floor((k + (n % 7 + 0.5) / 7) / MARKS * (film.times.length - 1));
      mark(ink, n, across(film.times[f]), up(one.low + (one.high - one.low) * one.words[f] / 65535));
    }
  });
  ink.strokeStyle = "#282828"; ink.lineWidth = 1; ink.beginPath(); ink.moveTo(across(time), 8); ink.lineTo(across(time), bottom); ink.stroke();
  const drag = (event) => {
    if (event.type === "pointermove" && !event.buttons) return;
    const box = canvas.getBoundingClientRect();
    play(false); wind(film.end * (event.clientX - box.left - left) / (width - left - 6));
  };
  canvas.onpointerdown = canvas.onpointermove = drag;
}

function table(table, list) {
  const size = list.reduce((size, one) => (one.group === "ledger" ? size : Math.max(size, Math.abs(one.low), Math.abs(one.high))), 0);
  const curves = list.filter((one) => one.group !== "ledger");
  table.replaceChildren(...list.map((one) => {
    const n = curves.indexOf(one);
    const row = document.createElement("tr"), name = document.createElement("td"), value = document.createElement("td"), swatch = Object.assign(document.createElement("canvas"), { className: "swatch", width: 18, height: 10 });
    if (n >= 0) {
      const ink = swatch.getContext("2d");
      ink.fillStyle = colorOf(one, n); ink.fillRect(0, 4, 18, 2); mark(ink, n, 9, 5);
    }
    name.append(swatch, one.name);
    // What is small beside its group is rounding.
    const found = film.series_at(one, time);
    value.textContent = (Math.abs(found) > 1e-12 * size ? found : 0).toPrecision(5);
    row.append(name, value);
    return row;
  }));
}

function tick(stamp) {
  const before = time;
  if (playing && last !== null && film && film.end) time = (time + (stamp - last) / 1000 * Number(element("speed").value)) % film.end;
  last = stamp;
  if (time !== before || stage.turned) { stage.turned = false; draw(); }
  frames += 1;
  if (stamp - since > 1000) { element("rate").textContent = Math.round(1000 * frames / (stamp - since)) + " frames/s"; [frames, since] = [0, stamp]; }
  requestAnimationFrame(tick);
}

element("play").onclick = () => play(!playing);
element("time").oninput = () => wind(element("time").value * film.end);
element("group").onchange = element("paint").onchange = element("paths").onchange = element("names").onchange = () => draw();
element("reset").onclick = () => { stage.look(); draw(); };
window.onresize = () => { stage.resized(); draw(); };
document.onkeydown = (event) => { if (event.key === " " && event.target === document.body) play(!playing); };

load(JSON.parse(element("data").textContent), false);
// page.html#t=0.5 opens at 0.5 s and waits; page.html#t=0.5,still shows nothing but the picture.
const asked = location.hash.match(/^#t=([0-9.eE+-]+)(,still)?$/);
if (asked) {
  if (asked[2]) {
    document.body.className = "still"; stage.look();
    element("note").textContent = film.note + ", t = " + Number(Number(asked[1]).toPrecision(9)) + " s";
  }
  play(false); wind(Number(asked[1]));
}
draw();
// A still is drawn once.
if (!asked || !asked[2]) requestAnimationFrame(tick);

// Served by `smartbed view`, the page asks whether the file has changed.
if (location.protocol.startsWith("http")) {
  let version = null;
  setInterval(async () => {
    try {
      const state = await (await fetch("state")).json();
      element("fault").textContent = state.fault;
      if (version !== null && state.version !== version && !state.fault) load(await (await fetch("data")).json(), true);
      version = state.version;
    } catch (gone) { element("fault").textContent = "the server has gone"; }
  }, 300);
}
