'use strict';
// What rayColumns.h describes, unpacked: for every ray its parent, where it ends, and so on.

const byId = (id) => document.getElementById(id);
const head = JSON.parse(byId('head').textContent);
const camera = head.camera;
const rays = { count: head.rays };
const shapes = [];
const shapeKinds = [['sphere', 4], ['triangle', 9], ['cone', 8], ['shape', 6]];
const kinds = ['primary', 'shadow', 'reflected', 'refracted', 'other'];
const bit = { hit: 8, front: 16, traced: 32, parent: 64, last: 128 };

const add = (a, b, k = 1) => [a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) =>
  [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const size = (a) => Math.hypot(a[0], a[1], a[2]);
const unit = (a) => add([0, 0, 0], a, 1 / (size(a) || 1));

const isHit = (i) => (rays.head[i] & bit.hit) > 0;
const isFront = (i) => (rays.head[i] & bit.front) > 0;
const isTraced = (i) => (rays.head[i] & bit.traced) > 0;
const kindOf = (i) => kinds[rays.head[i] & 7];
const endOf = (i) => [rays.x[i], rays.y[i], rays.z[i]];
const startOf = (i) => rays.origins.get(i) || (rays.parent[i] < 0 ? camera.eye : endOf(rays.parent[i]));
const colourOf = (i) => [rays.red[i], rays.green[i], rays.blue[i]];
const isTotal = (i) => kindOf(i) === 'refracted' && rays.parent[i] >= 0 &&
  dot(add(endOf(i), startOf(i), -1), normalOf(rays.parent[i])) > 0;

// Numbers of a column; packed.h says how they are stored.
async function readColumn(element) {
  const bytes = Number(element.dataset.bytes), count = Number(element.dataset.count);
  if (!count) return new Uint32Array(0);
  const packed = Uint8Array.from(atob(element.textContent), (c) => c.charCodeAt(0));
  const inflater = new DecompressionStream('deflate'), writer = inflater.writable.getWriter();
  writer.write(packed);
  writer.close();
  const planes = new Uint8Array(bytes * count), reader = inflater.readable.getReader();
  for (let at = 0, part; !(part = await reader.read()).done; at += part.value.length)
    planes.set(part.value, at);
  const values = new Uint32Array(count), mask = 0xffffffff >>> (32 - 8 * bytes);
  let before = 0;
  for (let i = 0; i < count; ++i) {
    let number = 0;
    for (let j = 0; j < bytes; ++j) number |= planes[j * count + i] << (8 * j);
    values[i] = before = (before + ((number >>> 1) ^ -(number & 1))) & mask;
  }
  return values;
}

const floats = (values) => new Float32Array(values.buffer);
const float24 = (values) => floats(values.map((value) => value << 8));
function float16(value) {
  const sign = value & 0x8000 ? -1 : 1, exponent = value >> 10 & 31, rest = value & 1023;
  if (exponent === 31) return rest ? NaN : sign * Infinity;
  return exponent ? sign * (1 + rest / 1024) * 2 ** (exponent - 15) : sign * rest * 2 ** -24;
}

// A normal is stored as a point of an unfolded octahedron.
function normalOf(i) {
  let u = rays.u[i] / 32767 - 1, v = rays.v[i] / 32767 - 1;
  if (rays.u[i] > 65534 || rays.v[i] > 65534) return [NaN, NaN, NaN];
  const w = 1 - Math.abs(u) - Math.abs(v);
  if (w < 0) [u, v] = [(1 - Math.abs(v)) * (u < 0 ? -1 : 1), (1 - Math.abs(u)) * (v < 0 ? -1 : 1)];
  return unit([u, v, w]);
}

// The direction through a recorded pixel's centre.
const pixelAt = (p) => [head.left + p % head.columns * head.step,
  head.top + Math.floor(p / head.columns) * head.step];
function directionOf(p) {
  const [x, y] = pixelAt(p);
  return unit(add(add(camera.forward, camera.right, x + 0.5 - head.width / 2), camera.down,
    y + 0.5 - head.height / 2));
}

// Reads all columns; columns of first rays and of all others are merged, one entry per ray.
async function readRays() {
  const columns = {};
  const elements = [...document.querySelectorAll('script.column')];
  await Promise.all(elements.map(async (element) => {
    columns[element.dataset.name] = await readColumn(element);
  }));
  readShapes(columns);
  rays.head = columns.head;
  rays.error = columns.error;
  rays.origins = new Map([...columns.originRay].map((ray, i) => [ray,
    ['X', 'Y', 'Z'].map((axis) => floats(columns['origin' + axis])[i])]));
  rays.faults = new Map();
  columns.faultRay.forEach((ray, i) => {
    if (!rays.faults.has(ray)) rays.faults.set(ray, []);
    rays.faults.get(ray).push(columns.faultKind[i]);
  });
  for (const name of ['x', 'y', 'z', 'red', 'green', 'blue', 'weight'])
    rays[name] = new Float32Array(rays.count);
  for (const name of ['light', 'shape', 'u', 'v', 'level']) rays[name] = new Uint16Array(rays.count);
  rays.parent = new Int32Array(rays.count);
  rays.first = new Uint32Array(head.columns * head.rows + 1);
  mergeColumns(columns);
}

function mergeColumns(columns) {
  for (const name of ['x', 'y', 'z']) columns[name] = float24(columns[name]);
  for (const name of ['share', 'firstT', 'firstRed', 'firstGreen', 'firstBlue'])
    columns[name] = floats(columns[name]);
  const next = {};
  const take = (name) => columns[name][next[name] = (next[name] ?? -1) + 1];
  const parents = [];
  let pixel = 0;
  for (let i = 0; i < rays.count; ++i) {
    const first = parents.length === 0, of = (name) => (first ? 'first' + name : name.toLowerCase());
    rays.parent[i] = first ? -1 : parents[parents.length - 1];
    rays.level[i] = parents.length;
    if (first) rays.first[pixel++] = i;
    if (!isTraced(i)) rays.light[i] = take('light');
    place(i, first, pixel - 1, take);
    if (isHit(i)) rays.shape[i] = take(of('Shape'));
    if (isTraced(i) && !first) rays.weight[i] = float16(take('weight'));
    if (isTraced(i) && isHit(i)) [rays.u[i], rays.v[i]] = [take(of('U')), take(of('V'))];
    if (isTraced(i))
      for (const name of ['Red', 'Green', 'Blue'])
        rays[name.toLowerCase()][i] = first ? take(of(name)) : float16(take(of(name)));
    if (rays.head[i] & bit.parent) parents.push(i);
    else for (let j = i; parents.length && rays.head[j] & bit.last;) j = parents.pop();
  }
  rays.first[pixel] = rays.count;
}

// Where a ray ends. One that hits nothing ends as far away as the scene is large.
function place(i, first, pixel, take) {
  const start = startOf(i);
  let end;
  if (first) {
    end = add(start, directionOf(pixel), isHit(i) ? take('firstT') : shapes.extent);
  } else if (rays.light[i]) {
    const light = head.lights[rays.light[i] - 1].position;
    end = isHit(i) ? add(start, add(light, start, -1), take('share')) : light;
  } else {
    end = [take('x'), take('y'), take('z')];
    if (!isHit(i)) end = add(start, end, shapes.extent);
  }
  [rays.x[i], rays.y[i], rays.z[i]] = end.map((x) => Math.abs(x) < 1e-7 * shapes.extent ? 0 : x);
}

function readShapes(columns) {
  const numbers = floats(columns.geometry);
  let at = 0;
  columns.kind.forEach((kind, i) => {
    const [name, count] = shapeKinds[kind];
    shapes.push({ name, line: columns.line[i], material: head.materials[columns.material[i]],
      numbers: [...numbers.subarray(at, at += count)] });
  });
  shapes.box = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
  for (const shape of shapes)
    for (const [point, radius] of pointsOf(shape))
      for (let axis = 0; axis < 3; ++axis) {
        if (!Number.isFinite(point[axis])) continue;
        shapes.box[0][axis] = Math.min(shapes.box[0][axis], point[axis] - radius);
        shapes.box[1][axis] = Math.max(shapes.box[1][axis], point[axis] + radius);
      }
  if (!(shapes.box[0][0] <= shapes.box[1][0])) shapes.box = [add(camera.eye, [-1, -1, -1]), add(camera.eye, [1, 1, 1])];
  shapes.extent = size(add(shapes.box[1], shapes.box[0], -1));
}

// What spans a shape: points, and radii around them.
function pointsOf(shape) {
  const n = shape.numbers;
  if (shape.name === 'sphere') return [[n.slice(0, 3), Math.abs(n[3])]];
  if (shape.name === 'cone') return [[n.slice(0, 3), Math.abs(n[3])], [n.slice(4, 7), Math.abs(n[7])]];
  return [0, 3, 6].filter((at) => at < n.length).map((at) => [n.slice(at, at + 3), 0]);
}
