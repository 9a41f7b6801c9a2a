// Bodies as solids whose turns are seen: shapes with their edges, ellipsoids and balls with octants of two tones. Bodies
// that look alike are drawn together, however many there are.
class Solids {
  constructor(film, scene) {
    this.film = film;
    this.groups = new Map();
    for (const body of film.bodies) {
      if (body.hidden) continue;
      const key = JSON.stringify([body.shape && [body.shape.kind, body.shape.axis, body.shape.sizes], !body.axes, body.colour]);
      if (!this.groups.has(key)) this.groups.set(key, []);
      this.groups.get(key).push(body);
    }
    this.groups = [...this.groups.values()].map((bodies) => this.group(bodies, scene));
  }

  group(bodies, scene) {
    const { shape, axes, colour } = bodies[0], color = new THREE.Color(tinted(colour, BODY)), fine = bodies.length > 20 ? 16 : 32;
    const geometry = shape ? solid(shape, fine) : new THREE.SphereGeometry(1, fine, 0.75 * fine);
    const round = !shape || shape.kind === "ball";
    if (round && (shape || axes)) geometry.copy(octants(geometry, color, shape ? color.clone().multiplyScalar(0.7) : color.clone().lerp(new THREE.Color(0xffffff), 0.7)));
    const toned = round && (shape || axes), opacity = shape ? 0.88 : axes ? 0.55 : 1;
    // Seen through: the links of a mechanism stand inside its ellipsoids.
    const material = new THREE.MeshLambertMaterial({ color: toned ? 0xffffff : color, vertexColors: toned, transparent: opacity < 1, opacity, depthWrite: opacity > 0.8 });
    const mesh = new THREE.InstancedMesh(geometry, material, bodies.length);
    mesh.frustumCulled = false;
    scene.add(mesh);
    const group = { bodies, mesh, own: bodies.map((body) => this.own(body)), edges: null };
    if (!round) {
      group.corners = new THREE.EdgesGeometry(geometry, 30).attributes.position;
      group.edges = segments(scene, group.corners.count * bodies.length, JOINT, 1);
    }
    return group;
  }

  // Sizes and axes of the inertia ellipsoid; a small ball for what has none.
  own({ shape, axes, sizes }) {
    if (shape) return new THREE.Matrix4();
    const least = 0.008 * this.film.size, ball = 0.016 * this.film.size;
    const lengths = axes ? sizes.map((x) => Math.max(x, least)) : [ball, ball, ball];
    const basis = new THREE.Matrix4().makeBasis(...(axes || [[1, 0, 0], [0, 1, 0], [0, 0, 1]]).map((axis) => new THREE.Vector3(...axis)));
    if (basis.determinant() < 0) lengths[2] = -lengths[2];
    return basis.multiply(new THREE.Matrix4().makeScale(...lengths));
  }

  draw(at) {
    const corner = new THREE.Vector3();
    for (const { bodies, mesh, own, edges, corners } of this.groups) {
      bodies.forEach((body, n) => {
        const centre = body.shape && body.shape.at !== null ? body.shape.at : body.centre;
        const place = this.film.turn(body.turn).setPosition(at[centre]).multiply(own[n]);
        mesh.setMatrixAt(n, place);
        for (let k = 0; edges && k < corners.count; k++) {
          corner.fromBufferAttribute(corners, k).applyMatrix4(place);
          edges.geometry.attributes.position.setXYZ(n * corners.count + k, corner.x, corner.y, corner.z);
        }
      });
      mesh.instanceMatrix.needsUpdate = true;
      if (edges) edges.geometry.attributes.position.needsUpdate = true;
    }
  }
}

// A shape along its axis; three.js' cylinders stand along y.
function solid({ kind, sizes, axis }, fine) {
  if (kind === "box") return new THREE.BoxGeometry(...sizes);
  if (kind === "ball") return new THREE.SphereGeometry(sizes[0], fine, 0.75 * fine);
  const geometry = new THREE.CylinderGeometry(sizes[0], sizes[0], sizes[1], fine);
  if (axis === 0) geometry.rotateZ(-0.5 * Math.PI);
  if (axis === 2) geometry.rotateX(0.5 * Math.PI);
  return geometry;
}

// Neighbouring octants in two colours.
function octants(sphere, ...two) {
  const geometry = sphere.toNonIndexed(), place = geometry.attributes.position, colors = new Float32Array(3 * place.count);
  for (let n = 0; n < place.count; n += 3) {
    const middle = [0, 1, 2].map((c) => place.array[3 * n + c] + place.array[3 * n + 3 + c] + place.array[3 * n + 6 + c]);
    for (let k = 0; k < 3; k++) two[middle.filter((x) => x < 0).length % 2].toArray(colors, 3 * (n + k));
  }
  geometry.setAttribute("color", new THREE.BufferAttribute(colors, 3));
  return geometry;
}

// Lines between pairs of places, which change.
function segments(scene, count, color, opacity) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(3 * count), 3));
  const lines = new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ color, opacity, transparent: opacity < 1 }));
  lines.frustumCulled = false;
  scene.add(lines);
  return lines;
}

// A colour of the model's [view] as three.js takes it, or the usual one.
function tinted(colour, usual) { return colour ? colour[0] << 16 | colour[1] << 8 | colour[2] : usual; }
