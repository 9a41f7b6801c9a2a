// The motion in space: links, springs, solids, surfaces, ground, gravity; seen by a camera that circles and nears.
const LINK = 0x0072b2, SPRING = 0x009e73, BODY = 0xd55e00, JOINT = 0x282828, TRACE = 0xe8c8a8, TOUCH = 0xe69f00, REST = 0x828282, FORCE = 0xcc79a7;
// Strain that gets the full colour.
const FULL = 0.1;

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
    this.links = film.links.filter(([a, b]) => !film.rests(a) || !film.rests(b));
    this.rods = this.many(new THREE.CylinderGeometry(1, 1, 1, 8, 1, true), this.links.length, LINK);
    this.edges = this.many(new THREE.CylinderGeometry(1, 1, 1, 6, 1, true), film.edges.length, REST);
    this.joints = this.many(new THREE.SphereGeometry(1, 10, 8), film.points.length, JOINT);
    this.touches = this.many(new THREE.SphereGeometry(1, 10, 8), film.ground ? film.points.length : 0, TOUCH);
    this.shafts = this.many(new THREE.CylinderGeometry(1, 1, 1, 8), film.usual > 0 ? film.points.length : 0, FORCE);
    this.heads = this.many(new THREE.CylinderGeometry(0, 1, 1, 12), film.usual > 0 ? film.points.length : 0, FORCE);
    this.coils = film.springs.map(([, , colour]) => this.line(tinted(colour, SPRING), 2 * 14 * 12 + 2));
    const bodies = film.bodies.filter((body) => !body.hidden);
    this.solids = bodies.map((body) => (body.shape ? this.shaped(body) : this.solid(body)));
    this.paths = bodies.filter((body) => !film.rests(body.centre)).map((body) => this.line(TRACE, film.times.length, film.path(body.centre)));
    this.covered = new Set(film.hidden);
    this.surface = film.facets.length ? this.skin() : null;
    this.up = film.gravity && Math.hypot(...film.gravity) > 0 ? new THREE.Vector3(...film.gravity).normalize().negate() : null;
    this.flat = [2, 1, 0].find((axis) => film.box.high[axis] - film.box.low[axis] < 1e-6 * film.size);
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

  line(color, count, points) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(3 * count), 3));
    const line = new THREE.Line(geometry, new THREE.LineBasicMaterial({ color }));
    line.frustumCulled = false;
    if (points) points.forEach((p, n) => geometry.attributes.position.setXYZ(n, p.x, p.y, p.z));
    this.scene.add(line);
    return line;
  }

  // The inertia ellipsoid, its octants in two colours so that a turn is seen; a ball for what has none.
  solid(body) {
    const geometry = new THREE.SphereGeometry(1, 32, 24).toNonIndexed(), place = geometry.attributes.position;
    const colors = new Float32Array(3 * place.count), two = [new THREE.Color(tinted(body.colour, BODY)), new THREE.Color(tinted(body.colour, BODY)).lerp(new THREE.Color(0xffffff), 0.7)];
    for (let n = 0; n < place.count; n += 3) {
      const middle = [0, 1, 2].map((c) => place.array[3 * n + c] + place.array[3 * n + 3 + c] + place.array[3 * n + 6 + c]);
      const color = body.axes ? two[middle.filter((x) => x < 0).length % 2] : two[0];
      for (let k = 0; k < 3; k++) color.toArray(colors, 3 * (n + k));
    }
    geometry.setAttribute("color", new THREE.BufferAttribute(colors, 3));
    // Seen through: the links of a mechanism stand inside its solids.
    const clear = body.axes ? { transparent: true, opacity: 0.55, depthWrite: false } : {};
    const mesh = new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({ vertexColors: true, ...clear }));
    const least = 0.008 * this.film.size, ball = 0.016 * this.film.size;
    const sizes = body.axes ? body.sizes.map((x) => Math.max(x, least)) : [ball, ball, ball];
    const axes = body.axes || [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    const basis = new THREE.Matrix4().makeBasis(...axes.map((axis) => new THREE.Vector3(...axis)));
    if (basis.determinant() < 0) sizes[2] = -sizes[2];
    mesh.userData = { body, shape: basis.multiply(new THREE.Matrix4().makeScale(...sizes)) };
    mesh.matrixAutoUpdate = false; mesh.frustumCulled = false;
    this.scene.add(mesh);
    return mesh;
  }

  // The shape that the model gives a body, along its axes, edges drawn so that a turn is seen.
  shaped(body) {
    const { kind, sizes, axis } = body.shape;
    const geometry = kind === "box" ? new THREE.BoxGeometry(...sizes) : kind === "ball" ? new THREE.SphereGeometry(sizes[0], 32, 24)
      : new THREE.CylinderGeometry(sizes[0], sizes[0], sizes[1], 32);
    // three.js' cylinders stand along y.
    if (kind === "cylinder" && axis === 0) geometry.rotateZ(-0.5 * Math.PI);
    if (kind === "cylinder" && axis === 2) geometry.rotateX(0.5 * Math.PI);
    const color = tinted(body.colour, BODY), group = new THREE.Group();
    group.add(new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({ color, transparent: true, opacity: 0.8 })));
    if (kind !== "ball") group.add(new THREE.LineSegments(new THREE.EdgesGeometry(geometry, 30), new THREE.LineBasicMaterial({ color: JOINT })));
    group.userData = { body, shape: new THREE.Matrix4() };
    group.matrixAutoUpdate = false;
    this.scene.add(group);
    return group;
  }

  // Facets with four corners are two triangles; colours by the triangle's area against its first one.
  skin() {
    const corners = [];
    this.film.facets.forEach(([a, b, c, d]) => { corners.push([a, b, c]); if (d !== a && d !== c) corners.push([a, c, d]); });
    const geometry = new THREE.BufferGeometry(), count = 3 * corners.length;
    geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(3 * count), 3));
    geometry.setAttribute("color", new THREE.BufferAttribute(new Float32Array(3 * count), 3));
    const material = new THREE.MeshLambertMaterial({ vertexColors: true, side: THREE.DoubleSide, transparent: true, opacity: 0.85 });
    const mesh = new THREE.Mesh(geometry, material);
    mesh.frustumCulled = false; mesh.userData = { corners, first: null };
    this.scene.add(mesh);
    return mesh;
  }

  // The ground's plane under the motion, as a grid.
  floor() {
    const { film } = this;
    if (!film.ground || !film.ground.shown) return;
    const normal = new THREE.Vector3(...film.ground.normal), width = 2.2 * film.size;
    const grid = new THREE.GridHelper(width, 22, 0x999999, 0xcccccc);
    grid.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), normal);
    const middle = new THREE.Vector3(...[0, 1, 2].map((axis) => 0.5 * (film.box.low[axis] + film.box.high[axis])));
    grid.position.copy(middle.addScaledVector(normal, film.ground.offset - middle.dot(normal)));
    this.scene.add(grid);
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
    this.fall = { tip: corner.clone().addScaledVector(down, 0.14 * film.size) };
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
    // Half the extent across, upwards and towards the camera, of the box's corners.
    const half = new THREE.Vector3(1e-3 * film.size, 1e-3 * film.size, 0);
    const inverse = this.camera.matrixWorldInverse.copy(this.camera.matrixWorld).invert();
    // The points' box with some air; a room's corners are empty.
    for (const [{ low, high }, air] of [[film.box, 1.2], [film.room, film.bodies.some((body) => body.shape && !body.hidden) ? 1.05 : 0.8]])
      for (let n = 0; n < 8; n++) {
        const corner = new THREE.Vector3(...[0, 1, 2].map((axis) => (n >> axis & 1 ? high : low)[axis])).applyMatrix4(inverse);
        half.set(Math.max(half.x, air * Math.abs(corner.x)), Math.max(half.y, air * Math.abs(corner.y)), Math.max(half.z, Math.abs(corner.z + 1)));
      }
    const slope = Math.tan(this.camera.fov * Math.PI / 360);
    const distance = Math.max(half.y / slope, half.x / (slope * this.camera.aspect)) + half.z;
    this.camera.position.copy(middle).addScaledVector(from, distance);
    [this.camera.near, this.camera.far] = [0.005 * distance, 40 * distance];
    this.camera.updateProjectionMatrix();
    if (this.control) this.control.dispose();
    this.control = new THREE.OrbitControls(this.camera, this.renderer.domElement);
    this.control.target.copy(middle);
    this.control.update();
  }

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

  draw(time, paths) {
    const { film } = this, at = film.points.map(() => null);
    film.seek(time);
    for (let n = 0; n < at.length; n++) at[n] = film.point(n);
    this.at = at;
    this.links.forEach(([a, b], n) => this.span(this.rods, n, at[a], at[b], this.thick));
    const thin = (film.facets.length ? 0.25 : 0.7) * this.thick;
    film.edges.forEach(([a, b, rest], n) => {
      this.span(this.edges, n, at[a], at[b], thin);
      this.edges.setColorAt(n, film.colours.springs ? new THREE.Color(tinted(film.colours.springs)) : strained(rest > 0 ? at[a].distanceTo(at[b]) / rest - 1 : 0));
    });
    const ball = film.edges.length ? 1.4 * thin : 1.5 * this.thick, still = new THREE.Quaternion();
    let touching = 0;
    at.forEach((p, n) => {
      const shown = this.covered.has(n) ? 1e-9 : ball;
      this.joints.setMatrixAt(n, new THREE.Matrix4().compose(p, still, new THREE.Vector3(shown, shown, shown)));
      if (this.touches.instanceMatrix.count > 1 && n > 0 && p.dot(new THREE.Vector3(...film.ground.normal)) - film.ground.offset < 2e-4 * film.size)
        this.touches.setMatrixAt(touching++, new THREE.Matrix4().compose(p, still, new THREE.Vector3(2.2 * ball, 2.2 * ball, 2.2 * ball)));
    });
    this.touches.count = touching;
    this.push(at);
    [this.rods, this.edges, this.joints, this.touches, this.shafts, this.heads].forEach((mesh) => {
      mesh.instanceMatrix.needsUpdate = true;
      if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
    });
    film.springs.forEach(([a, b], n) => this.coil(this.coils[n], at[a], at[b]));
    this.solids.forEach((mesh) => {
      const { body, shape } = mesh.userData;
      mesh.matrix.copy(film.turn(body.turn)).setPosition(at[body.shape && body.shape.at !== null ? body.shape.at : body.centre]).multiply(shape);
      mesh.matrixWorldNeedsUpdate = true;
    });
    this.paths.forEach((path) => { path.visible = paths; });
    if (this.surface) this.stretch(at);
    this.control.update();
    this.sun.position.copy(this.camera.position);
    this.renderer.render(this.scene, this.camera);
  }

  // The ground's forces as arrows whose tips are the points, none longer than a fifth of the picture.
  push(at) {
    const { film } = this;
    let count = 0;
    this.strongest = null;
    if (!(film.usual > 0)) return;
    const normal = new THREE.Vector3(...film.ground.normal);
    for (let n = 1; n < at.length; n++) {
      const force = film.force(n);
      if (force <= 1e-2 * film.usual) continue;
      const length = 0.2 * film.size * Math.min(force / film.usual, 1), head = Math.min(0.4 * length, 0.03 * film.size);
      const tail = at[n].clone().addScaledVector(normal, -length), neck = at[n].clone().addScaledVector(normal, -head);
      this.span(this.shafts, count, tail, neck, 0.5 * this.thick);
      this.span(this.heads, count++, neck, at[n], 0.4 * head);
      if (!this.strongest || force > this.strongest.force) this.strongest = { force, tail };
    }
    this.shafts.count = this.heads.count = count;
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

  stretch(at) {
    const { geometry, userData } = this.surface, place = geometry.attributes.position, color = geometry.attributes.color;
    const areas = userData.corners.map(([a, b, c]) => new THREE.Vector3().subVectors(at[b], at[a]).cross(new THREE.Vector3().subVectors(at[c], at[a])).length());
    userData.first = userData.first || areas;
    const chosen = this.film.colours.surface ? new THREE.Color(tinted(this.film.colours.surface)) : null;
    userData.corners.forEach((corners, n) => {
      // A triangle stretched by e in both directions has (1 + e)^2 times its area.
      const tint = chosen || strained(userData.first[n] > 0 ? Math.sqrt(areas[n] / userData.first[n]) - 1 : 0);
      corners.forEach((corner, k) => {
        place.setXYZ(3 * n + k, at[corner].x, at[corner].y, at[corner].z);
        color.setXYZ(3 * n + k, tint.r, tint.g, tint.b);
      });
    });
    place.needsUpdate = color.needsUpdate = true;
    geometry.computeVertexNormals();
  }

  // Where a place is on the screen (pixels).
  screen(p) {
    const seen = p.clone().project(this.camera);
    return [0.5 * (seen.x + 1) * this.host.clientWidth, 0.5 * (1 - seen.y) * this.host.clientHeight];
  }
}

// A colour of the model's [view] as three.js takes it, or the usual one.
function tinted(colour, usual) { return colour ? colour[0] << 16 | colour[1] << 8 | colour[2] : usual; }

// Grey at rest, vermilion stretched, blue compressed.
function strained(strain) {
  const share = Math.min(Math.abs(strain) / FULL, 1);
  return new THREE.Color(REST).lerp(new THREE.Color(strain > 0 ? BODY : LINK), share);
}
