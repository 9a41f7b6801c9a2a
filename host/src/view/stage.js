// The motion in space: links, springs, forces, grounds, gravity, beside solids and surfaces; seen by a camera that circles and nears.
const LINK = 0x0072b2, SPRING = 0x009e73, BODY = 0xd55e00, JOINT = 0x282828, TRACE = 0xe8c8a8, TOUCH = 0xe69f00, REST = 0x828282, FORCE = 0xcc79a7, FRICTION = 0x56b4e9;

// The longest arrow of a force, over the picture's size.
const LONGEST = 0.2;

class Stage {
  constructor(host) {
    this.host = host;
    this.renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
    this.renderer.setClearColor(0xffffff);
    host.prepend(this.renderer.domElement);
    this.renderer.domElement.id = "picture";
    this.renderer.domElement.title = "drag to turn, wheel to zoom, right button to move";
    this.camera = new THREE.PerspectiveCamera(28, 1, 0.01, 100);
  }

  // Takes a film; the camera stays where it is unless it has never looked at one.
  show(film, keep) {
    this.film = film;
    this.scene = new THREE.Scene();
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0xb0b0b0, 2.2));
    this.sun = new THREE.DirectionalLight(0xffffff, 1.6);
    this.scene.add(this.sun);
    this.thick = 0.006 * film.size;
    // Rods of the ground are left out, unless everything is at rest.
    const moving = film.links.filter(([a, b]) => !film.rests(a) || !film.rests(b));
    this.links = moving.length ? moving : film.links;
    this.rods = this.many(new THREE.CylinderGeometry(1, 1, 1, 8, 1, true), this.links.length, LINK);
    const skinned = new Set(film.facets.flat());
    this.bones = film.edges.map((edge, n) => n).filter((n) => film.bones === "all" || (film.bones === "bare" && !film.edges[n].slice(0, 2).every((p) => skinned.has(p))));
    this.edges = this.many(new THREE.CylinderGeometry(1, 1, 1, 6, 1, true), this.bones.length, REST);
    this.joints = this.many(new THREE.SphereGeometry(1, 10, 8), film.points.length, JOINT);
    const contacts = film.contacts.reduce((most, count) => Math.max(most, count), 0);
    this.touches = this.many(new THREE.SphereGeometry(1, 10, 8), contacts, TOUCH);
    // Friction is told from normal forces by its blunt head, too.
    this.normals = this.arrows(2 * contacts, FORCE, 0);
    this.frictions = this.arrows(2 * contacts, FRICTION, 0.5);
    this.coils = film.springs.map(([, , colour]) => this.line(tinted(colour, SPRING), 2 * 14 * 12 + 2));
    const bodies = film.bodies.filter((body) => !body.hidden);
    this.solids = new Solids(film, this.scene);
    this.paths = bodies.filter((body) => !film.rests(body.centre)).map((body) => this.line(TRACE, film.times.length, film.path(body.centre)));
    this.covered = new Set(film.hidden);
    this.surface = film.facets.length ? new Skin(this, film, this.scene) : null;
    this.up = film.gravity && Math.hypot(...film.gravity) > 0 ? new THREE.Vector3(...film.gravity).normalize().negate() : null;
    // The solids of a world have three dimensions wherever their middles are.
    this.flat = film.bones === "bare" ? undefined : [2, 1, 0].find((axis) => film.box.high[axis] - film.box.low[axis] < 1e-6 * film.size);
    if (!this.up || (this.flat !== undefined && Math.abs(this.up.getComponent(this.flat)) > 0.5))
      this.up = this.flat === 2 ? new THREE.Vector3(0, 1, 0) : new THREE.Vector3(0, 0, 1);
    this.floor();
    this.arrow();
    if (!keep || !this.control) this.look();
  }

  many(geometry, count, color) {
    const mesh = new THREE.InstancedMesh(geometry, new THREE.MeshLambertMaterial(), Math.max(count, 1));
    mesh.count = count; mesh.frustumCulled = false;
    for (let n = 0; n < count; n++) mesh.setColorAt(n, new THREE.Color(color));
    this.scene.add(mesh);
    return mesh;
  }

  arrows(count, color, tip) {
    const shafts = this.many(new THREE.CylinderGeometry(1, 1, 1, 8), count, color), heads = this.many(new THREE.CylinderGeometry(tip, 1, 1, 12), count, color);
    // Seen through solids and surfaces, between which they act.
    [shafts, heads].forEach((mesh) => { mesh.renderOrder = 1; mesh.material.depthTest = false; mesh.material.transparent = true; });
    return { shafts, heads, count: 0 };
  }

  // An arrow from a to b.
  point({ shafts, heads }, n, a, b) {
    const length = a.distanceTo(b), head = Math.min(0.4 * length, 0.03 * this.film.size), neck = b.clone().lerp(a, length > 0 ? head / length : 0);
    this.span(shafts, n, a, neck, 0.5 * this.thick);
    this.span(heads, n, neck, b, 0.4 * head);
  }

  line(color, count, points) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(3 * count), 3));
    const line = new THREE.Line(geometry, new THREE.LineBasicMaterial({ color }));
    line.frustumCulled = false;
    if (points) points.forEach((p, n) => geometry.attributes.position.setXYZ(n, p.x, p.y, p.z));
    this.scene.add(line);
    return line;
  }

  // The grounds' planes beside the motion, as grids.
  floor() {
    const { film } = this, width = 2.2 * film.size;
    for (const { normal: outward, offset, shown } of film.grounds) {
      if (!shown) continue;
      const normal = new THREE.Vector3(...outward), grid = new THREE.GridHelper(width, 22, 0x999999, 0xcccccc);
      grid.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), normal);
      const middle = new THREE.Vector3(...[0, 1, 2].map((axis) => 0.5 * (film.box.low[axis] + film.box.high[axis])));
      grid.position.copy(middle.addScaledVector(normal, offset - middle.dot(normal)));
      this.scene.add(grid);
    }
  }

  // Gravity's direction, beside the motion.
  arrow() {
    const { film } = this;
    if (!film.gravity || Math.hypot(...film.gravity) === 0) return;
    const down = new THREE.Vector3(...film.gravity).normalize();
    // At the corner of the room, a little outside.
    const { low, high } = film.room;
    const corner = new THREE.Vector3(...low.map((x, axis) => (down.getComponent(axis) < -0.5 ? high[axis] : x)));
    const away = corner.clone().sub(new THREE.Vector3(...low.map((x, axis) => 0.5 * (x + high[axis]))));
    corner.addScaledVector(away.addScaledVector(down, -away.dot(down)).normalize(), 0.06 * film.size);
    this.fall = { corner, tip: corner.clone().addScaledVector(down, 0.14 * film.size) };
    this.scene.add(new THREE.ArrowHelper(down, corner, 0.14 * film.size, JOINT, 0.035 * film.size, 0.02 * film.size));
  }

  // Plane motion is seen from the front, other motion from a little above; all of it fits.
  look() {
    const { film } = this, box = film.room;
    const middle = new THREE.Vector3(...[0, 1, 2].map((axis) => 0.5 * (box.low[axis] + box.high[axis])));
    const front = { 2: [0, 0, 1], 1: [0, -1, 0], 0: [1, 0, 0] }[this.flat];
    let from = front ? new THREE.Vector3(...front) : null;
    if (!from) {
      const side = new THREE.Vector3(0.6, -1, 0.35).addScaledVector(this.up, -new THREE.Vector3(0.6, -1, 0.35).dot(this.up)).normalize();
      from = side.addScaledVector(this.up, 0.42).normalize();
    }
    this.resize();
    this.camera.up.copy(this.up);
    this.camera.position.copy(middle).add(from);
    this.camera.lookAt(middle);
    this.camera.updateMatrixWorld();
    // As near as all corners of the boxes allow; the points' box with some air, a room's corners are empty.
    const inverse = this.camera.matrixWorldInverse.copy(this.camera.matrixWorld).invert(), slope = Math.tan(this.camera.fov * Math.PI / 360);
    let distance = 1e-2 * film.size / slope;
    const fit = (place, air) => {
      const { x, y, z } = place.clone().applyMatrix4(inverse);
      distance = Math.max(distance, air * Math.max(Math.abs(y) / slope, Math.abs(x) / (slope * this.camera.aspect)) + z + 1);
    };
    for (const [{ low, high }, air] of [[film.box, 1.2], [film.room, film.bodies.some((body) => body.shape && !body.hidden) ? 1.05 : 0.8]])
      for (let n = 0; n < 8; n++) fit(new THREE.Vector3(...[0, 1, 2].map((axis) => (n >> axis & 1 ? high : low)[axis])), air);
    // Arrows of forces come from under the grounds.
    for (const { normal } of film.forces.length ? film.grounds : [])
      for (let n = 0; n < 8; n++) {
        const corner = new THREE.Vector3(...[0, 1, 2].map((axis) => (n >> axis & 1 ? film.box.high : film.box.low)[axis]));
        fit(corner.addScaledVector(new THREE.Vector3(...normal), -LONGEST * film.size), 1.02);
      }
    if (this.fall) [this.fall.corner, this.fall.tip].forEach((place) => fit(place, 1.08));
    this.camera.position.copy(middle).addScaledVector(from, distance);
    [this.camera.near, this.camera.far] = [0.005 * distance, 40 * distance];
    this.camera.updateProjectionMatrix();
    if (this.control) this.control.dispose();
    this.control = new THREE.OrbitControls(this.camera, this.renderer.domElement);
    this.control.target.copy(middle);
    this.control.update();
    this.control.addEventListener("change", () => { this.turned = true; });
    this.chosen = false;
    this.control.addEventListener("start", () => { this.chosen = true; });
  }

  // In a window of another size all fits again, unless the viewer has chosen where to look from.
  resized() { if (this.chosen) this.resize(); else this.look(); }

  resize() {
    const [width, height] = [this.host.clientWidth, this.host.clientHeight];
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / Math.max(height, 1);
    this.camera.updateProjectionMatrix();
  }

  // A cylinder or ball from a to b.
  span(mesh, n, a, b, radius) {
    const along = new THREE.Vector3().subVectors(b, a), length = along.length();
    const turn = new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(0, 1, 0), length > 0 ? along.divideScalar(length) : new THREE.Vector3(0, 1, 0));
    mesh.setMatrixAt(n, new THREE.Matrix4().compose(a.clone().lerp(b, 0.5), turn, new THREE.Vector3(radius, Math.max(length, 1e-9 * radius), radius)));
  }

  draw(time, paths, paint) {
    const { film } = this, at = film.points.map(() => null);
    film.seek(time);
    for (let n = 0; n < at.length; n++) at[n] = film.point(n);
    this.at = at;
    this.links.forEach(([a, b], n) => this.span(this.rods, n, at[a], at[b], this.thick));
    const thin = (film.facets.length ? 0.25 : 0.7) * this.thick;
    this.bones.forEach((spring, n) => {
      const [a, b] = film.edges[spring];
      this.span(this.edges, n, at[a], at[b], thin);
      this.edges.setColorAt(n, film.colours.springs ? new THREE.Color(tinted(film.colours.springs)) : strained(film.strain(spring) / film.full, REST));
    });
    const ball = film.edges.length ? 1.4 * thin : 1.5 * this.thick, still = new THREE.Quaternion();
    at.forEach((p, n) => {
      const shown = this.covered.has(n) ? 1e-9 : ball;
      this.joints.setMatrixAt(n, new THREE.Matrix4().compose(p, still, new THREE.Vector3(shown, shown, shown)));
    });
    this.push(film.touching(time), 2.2 * ball);
    const { normals, frictions } = this;
    [this.rods, this.edges, this.joints, this.touches, normals.shafts, normals.heads, frictions.shafts, frictions.heads].forEach((mesh) => {
      mesh.instanceMatrix.needsUpdate = true;
      if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
    });
    film.springs.forEach(([a, b], n) => this.coil(this.coils[n], at[a], at[b]));
    this.solids.draw(at);
    this.paths.forEach((path) => { path.visible = paths; });
    if (this.surface) this.surface.draw(at, time, paint);
    this.control.update();
    // From above and the left of who looks, so that sides differ in brightness.
    const right = new THREE.Vector3().setFromMatrixColumn(this.camera.matrixWorld, 0), above = new THREE.Vector3().setFromMatrixColumn(this.camera.matrixWorld, 1);
    const away = this.camera.position.distanceTo(this.control.target);
    this.sun.position.copy(this.camera.position).addScaledVector(above, away).addScaledVector(right, -0.6 * away);
    this.sun.target.position.copy(this.control.target);
    this.sun.target.updateMatrixWorld();
    this.renderer.render(this.scene, this.camera);
  }

  // Forces where things touch: along the normal with the tip where they act, across it beginning there; where both can move
  // each on its own side, against one another. None is longer than a fifth of the picture.
  push(touching, ball) {
    const { film } = this, longest = LONGEST * film.size, still = new THREE.Quaternion();
    let [dots, along, across] = [0, 0, 0];
    this.strongest = null;
    for (const { point, normal, friction, both } of touching) {
      const force = normal.length(), rub = friction.length(), up = normal.clone().normalize();
      this.touches.setMatrixAt(dots++, new THREE.Matrix4().compose(point, still, new THREE.Vector3(ball, ball, ball)));
      if (force <= 1e-2 * film.usual) continue;
      const length = longest * Math.min(force / film.usual, 1), tail = point.clone().addScaledVector(up, -length);
      this.point(this.normals, along++, tail, point);
      if (both) this.point(this.normals, along++, point.clone().addScaledVector(up, length), point);
      if (!this.strongest || force > this.strongest.force) this.strongest = { force, tail };
      if (rub <= 1e-2 * film.usual) continue;
      for (const side of both ? [1, -1] : [1]) {
        const from = point.clone().addScaledVector(up, side * 0.012 * film.size);
        this.point(this.frictions, across++, from, from.clone().addScaledVector(friction, side * longest * Math.min(rub / film.usual, 1) / rub));
      }
    }
    this.touches.count = dots;
    this.normals.shafts.count = this.normals.heads.count = this.normals.count = along;
    this.frictions.shafts.count = this.frictions.heads.count = this.frictions.count = across;
  }

  coil(line, a, b) {
    const along = new THREE.Vector3().subVectors(b, a), length = along.length() || 1, radius = 0.018 * this.film.size;
    const x = new THREE.Vector3(0, 0, 1).cross(along).normalize();
    if (x.lengthSq() < 0.5) x.set(1, 0, 0);
    const y = new THREE.Vector3().crossVectors(along, x).divideScalar(length), place = line.geometry.attributes.position;
    const last = place.count - 1;
    for (let n = 0; n <= last; n++) {
      const share = n === 0 || n === last ? n / last : 0.1 + 0.8 * n / last, r = n === 0 || n === last ? 0 : radius;
      const angle = 2 * Math.PI * 14 * n / last;
      const p = a.clone().addScaledVector(along, share).addScaledVector(x, r * Math.cos(angle)).addScaledVector(y, r * Math.sin(angle));
      place.setXYZ(n, p.x, p.y, p.z);
    }
    place.needsUpdate = true;
  }

  // Where a place is on the screen (pixels).
  screen(p) {
    const seen = p.clone().project(this.camera);
    return [0.5 * (seen.x + 1) * this.host.clientWidth, 0.5 * (1 - seen.y) * this.host.clientHeight];
  }
}
