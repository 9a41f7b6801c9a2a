// Surfaces: facets coloured by stretch or by the pressure inside, their outlines, the rim by which they are held; facets that
// are held all round are a base, plain.
const SKIN = 0xd8d8d8, BASE = 0x9a9a9a, RIM = 0x282828;

class Skin {
  constructor(stage, film, scene) {
    [this.stage, this.film] = [stage, film];
    const held = new Set(film.held), along = new Map();
    const key = (a, b) => Math.min(a, b) * film.points.length + Math.max(a, b);
    film.edges.forEach(([a, b], n) => along.set(key(a, b), n));
    const facets = film.facets.map((facet, number) => {
      const corners = facet.filter((p, n) => facet.indexOf(p) === n), pairs = [];
      corners.forEach((a, n) => corners.slice(n + 1).forEach((b) => pairs.push(key(a, b))));
      const surface = film.surfaces.find(({ from, to }) => from <= number && number < to);
      return { corners, colour: surface && surface.colour, springs: pairs.filter((pair) => along.has(pair)).map((pair) => along.get(pair)), gauge: film.series.find((one) => surface && one.name === surface.gauge) };
    });
    const isBase = ({ corners }) => corners.every((p) => held.has(p));
    this.moving = facets.filter((facet) => !isBase(facet));
    this.base = facets.filter(isBase);
    this.sides = sides(this.moving, key);
    this.rim = this.sides.filter(([a, b]) => held.has(a) && held.has(b));
    this.skin = this.mesh(scene, this.moving, 0.92);
    this.floor = this.mesh(scene, this.base, 0.6);
    this.lines = film.bones === "all" ? null : segments(scene, 2 * this.sides.length, 0x202020, 0.35);
    this.tubes = stage.many(new THREE.CylinderGeometry(1, 1, 1, 8, 1, true), this.rim.length, RIM);
    film.seek(film.times[0]);
    this.first = this.moving.map((facet) => this.area(facet));
    this.gauges = [...new Set(this.moving.map(({ gauge }) => gauge).filter((gauge) => gauge))];
  }

  mesh(scene, facets, opacity) {
    const count = facets.reduce((sum, { corners }) => sum + 3 * (corners.length - 2), 0), geometry = new THREE.BufferGeometry();
    for (const name of ["position", "color"]) geometry.setAttribute(name, new THREE.BufferAttribute(new Float32Array(3 * count), 3));
    const mesh = new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({ vertexColors: true, flatShading: true, side: THREE.DoubleSide, transparent: true, opacity }));
    mesh.frustumCulled = false;
    scene.add(mesh);
    return mesh;
  }

  area({ corners }) {
    const [a, ...rest] = corners.map((p) => this.film.point(p).clone()), sum = new THREE.Vector3();
    for (let n = 0; n + 1 < rest.length; n++) sum.add(rest[n].clone().sub(a).cross(rest[n + 1].clone().sub(a)));
    return sum.length();
  }

  // The mean of the springs along sides and diagonals; without any, (1 + e)^2 is what the area has become.
  strain(facet, n) {
    if (facet.springs.length) return facet.springs.reduce((sum, spring) => sum + this.film.strain(spring), 0) / facet.springs.length;
    return this.first[n] > 0 ? Math.sqrt(this.area(facet) / this.first[n]) - 1 : 0;
  }

  // Least and largest gauge pressure of all time (Pa).
  range() { return [Math.min(0, ...this.gauges.map((one) => one.low)), Math.max(0, ...this.gauges.map((one) => one.high))]; }

  draw(at, time, paint) {
    const { film } = this, chosen = film.colours.surface ? new THREE.Color(tinted(film.colours.surface)) : null, [low, high] = this.range();
    const color = (facet, n) => chosen || (facet.colour ? new THREE.Color(tinted(facet.colour)) : paint === "pressure" ? pressed(facet.gauge ? (film.series_at(facet.gauge, time) - low) / (high - low || 1) : 0) : strained(this.strain(facet, n) / film.full, SKIN));
    const plain = new THREE.Color(BASE);
    this.fill(this.skin, this.moving, at, color);
    this.fill(this.floor, this.base, at, () => plain);
    if (this.lines) {
      const place = this.lines.geometry.attributes.position;
      this.sides.forEach((ends, n) => ends.forEach((p, k) => place.setXYZ(2 * n + k, at[p].x, at[p].y, at[p].z)));
      place.needsUpdate = true;
    }
    this.rim.forEach(([a, b], n) => this.stage.span(this.tubes, n, at[a], at[b], 0.45 * this.stage.thick));
    this.tubes.instanceMatrix.needsUpdate = true;
  }

  // A facet of n corners is n - 2 triangles.
  fill({ geometry }, facets, at, color) {
    const { position, color: tints } = geometry.attributes;
    let vertex = 0;
    facets.forEach((facet, n) => {
      const tint = color(facet, n), { corners } = facet;
      for (let k = 1; k + 1 < corners.length; k++)
        for (const p of [corners[0], corners[k], corners[k + 1]]) {
          position.setXYZ(vertex, at[p].x, at[p].y, at[p].z);
          tints.setXYZ(vertex++, tint.r, tint.g, tint.b);
        }
    });
    position.needsUpdate = tints.needsUpdate = true;
  }
}

// Sides of facets, each once.
function sides(facets, key) {
  const found = new Map();
  for (const { corners } of facets) corners.forEach((a, n) => { const b = corners[(n + 1) % corners.length]; found.set(key(a, b), [a, b]); });
  return [...found.values()];
}

// The neutral colour at rest, vermilion stretched, blue compressed.
function strained(share, neutral) {
  return new THREE.Color(neutral).lerp(new THREE.Color(share > 0 ? BODY : LINK), Math.min(Math.abs(share), 1));
}

// From white to blue.
function pressed(share) { return new THREE.Color(0xf4f4f4).lerp(new THREE.Color(LINK), Math.min(Math.max(share, 0), 1)); }
