// The scene and the rays as lines, seen from anywhere. The view that the camera has is one of many:
// forward, right and down are unit vectors, a pixel of the picture is as wide as `camera.right`.

const view = { canvas: byId('view'), ofCamera: true };
const up = [0, 0, 0];
{
  const sizes = camera.down.map(Math.abs), axis = sizes.indexOf(Math.max(...sizes));
  up[axis] = camera.down[axis] > 0 ? -1 : 1;
}

function lookFrom(forward, upward, target, distance) {
  view.forward = unit(forward);
  view.right = unit(cross(view.forward, upward));
  view.down = cross(view.forward, view.right);
  view.distance = distance;
  view.target = target;
  view.ofCamera = false;
}

function lookThroughCamera() {
  const middle = add(add(shapes.box[0], shapes.box[1], 1), [0, 0, 0]).map((x) => x / 2);
  const distance = Math.max(dot(add(middle, camera.eye, -1), camera.forward), shapes.extent / 10);
  lookFrom(camera.forward, add([0, 0, 0], camera.down, -1), add(camera.eye, camera.forward, distance),
    distance);
  view.ofCamera = true;
}

function lookAlong(direction, upward) {
  const middle = add(shapes.box[0], shapes.box[1]).map((x) => x / 2);
  lookFrom(direction, upward, middle, 0.62 * shapes.extent / (size(camera.down) * head.height / 2));
}

const eyeOf = () => add(view.target, view.forward, -view.distance);
const scale = () => Math.min(view.width / head.width, view.height / head.height);

// A point in front of the eye as [x, y, distance], in pixels of the canvas.
function project(point) {
  const v = add(point, eyeOf(), -1), z = dot(v, view.forward), s = scale();
  return [view.width / 2 + s * dot(v, view.right) / z / size(camera.right),
    view.height / 2 + s * dot(v, view.down) / z / size(camera.down), z];
}

function turn(v, axis, angle) {
  const c = Math.cos(angle), s = Math.sin(angle);
  return add(add([c * v[0], c * v[1], c * v[2]], cross(axis, v), s), axis, dot(axis, v) * (1 - c));
}

function orbit(dx, dy) {
  for (const [axis, angle] of [[up, -dx], [view.right, dy]])
    for (const name of ['forward', 'right', 'down']) view[name] = turn(view[name], axis, angle);
  view.ofCamera = false;
}

function pan(dx, dy) {
  const step = view.distance * size(camera.right) / scale();
  view.target = add(add(view.target, view.right, -dx * step), view.down, -dy * step);
  view.ofCamera = false;
}

function zoom(factor) {
  view.distance *= factor;
  view.ofCamera = false;
}

// Draws a line through points, cut off where it is behind the eye.
function polyline(points, close = false) {
  const g = view.g, near = 1e-4 * shapes.extent, eye = eyeOf();
  const depth = (p) => dot(add(p, eye, -1), view.forward) - near;
  const all = close ? [...points, points[0]] : points;
  g.beginPath();
  for (let i = 1; i < all.length; ++i) {
    let [a, b] = [all[i - 1], all[i]];
    const [da, db] = [depth(a), depth(b)];
    if (!(da > 0 || db > 0)) continue;
    if (da < 0) a = add(a, add(b, a, -1), da / (da - db));
    if (db < 0) b = add(b, add(a, b, -1), db / (db - da));
    const from = project(a), to = project(b);
    if (i === 1 || da < 0 || !(depth(all[i - 2] ?? a) > 0)) g.moveTo(from[0], from[1]);
    g.lineTo(to[0], to[1]);
  }
  g.stroke();
  return all.every((p) => depth(p) > 0);
}

function circle(centre, axis, radius) {
  const a = unit(cross(axis, Math.abs(axis[0]) < 0.8 * size(axis) ? [1, 0, 0] : [0, 1, 0]));
  const b = unit(cross(axis, a));
  return Array.from({ length: 40 }, (_, k) => add(add(centre, a, radius * Math.cos(k * Math.PI / 20)), b,
    radius * Math.sin(k * Math.PI / 20)));
}

// Lines that show a shape; the first is its outline.
function outlinesOf(shape) {
  const points = pointsOf(shape), [centre, radius] = points[0];
  if (shape.name === 'sphere') {
    const way = add(eyeOf(), centre, -1), d = size(way);
    if (d <= radius) return [circle(centre, up, radius), circle(centre, view.right, radius)];
    const r = radius * Math.sqrt(1 - (radius / d) ** 2);
    return [circle(add(centre, way, (radius / d) ** 2), way, r), circle(centre, up, radius)];
  }
  if (shape.name === 'cone') {
    const axis = add(points[1][0], centre, -1);
    const [a, b] = points.map(([point, r]) => circle(point, axis, r));
    return [a, b, ...[0, 10, 20, 30].map((k) => [a[k], b[k]])];
  }
  const [low, high] = points.map(([point]) => point);
  if (shape.name === 'triangle') return [points.map(([point]) => point)];
  const corner = (k) => [0, 1, 2].map((axis) => (k >> axis & 1 ? high : low)[axis]);
  return [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6]].map((face) => face.map(corner));
}

function drawShapes() {
  const every = Math.ceil(shapes.length / 3000), g = view.g, eye = eyeOf();
  const middle = (shape) => pointsOf(shape).reduce((sum, [p], _, all) => add(sum, p, 1 / all.length), [0, 0, 0]);
  const list = shapes.filter((_, i) => i % every === 0)
    .map((shape) => [dot(add(middle(shape), eye, -1), view.forward), shape]).sort((a, b) => b[0] - a[0]);
  for (const [, shape] of list) {
    const colour = shown(shape.material.color).map((x) => Math.max(x, 90));  // black is seen, too
    g.lineWidth = 1;
    g.strokeStyle = view.ofCamera ? 'rgba(128,128,128,.5)' : `rgba(${colour.map((x) => 105 + x * 0.3)},.75)`;
    g.fillStyle = `rgba(${colour},${shape.name === 'triangle' ? 0.1 : 0.3})`;
    outlinesOf(shape).forEach((line, k) => {
      if (line.flat().every(Number.isFinite) && polyline(line, line.length > 2) && k === 0 && !view.ofCamera)
        g.fill();
    });
  }
}

function label(point, text, colour) {
  const [x, y, z] = project(point);
  if (!(z > 0)) return;
  view.g.fillStyle = colour;
  view.g.beginPath();
  view.g.arc(x, y, 4, 0, 7);
  view.g.fill();
  view.g.font = '12px system-ui, sans-serif';
  view.g.fillText(text, x + 7, y - 6);
}

// One ray; how far it goes beyond what blocks it is dashed, as is a ray that hits nothing.
function drawRay(i, alpha, width) {
  const g = view.g, start = startOf(i), end = endOf(i), kind = look(i);
  g.globalAlpha = alpha;
  g.lineWidth = width;
  g.strokeStyle = colours[kind];
  g.setLineDash(isTraced(i) && !isHit(i) ? [7, 5] : []);
  polyline([start, end]);
  if (kind === 'blocked' && rays.light[i]) {
    g.setLineDash([2, 5]);
    polyline([end, head.lights[rays.light[i] - 1].position]);
  }
  g.setLineDash([]);
  if (!isTraced(i) || !isHit(i)) return;
  g.strokeStyle = g.fillStyle = view.ink;
  g.lineWidth = 1;
  polyline([end, add(end, normalOf(i), 0.05 * view.unit)]);
  const [x, y, z] = project(end);
  if (z > 0) g.fillRect(x - 2, y - 2, 4, 4);
}

// state: what page.js shows
function drawView(state) {
  const { canvas } = view, ratio = window.devicePixelRatio || 1;
  view.width = canvas.clientWidth;
  view.height = Math.round(view.width * Math.min(1, head.height / head.width));
  canvas.style.height = `${view.height}px`;
  canvas.width = view.width * ratio;
  canvas.height = view.height * ratio;
  const g = view.g = canvas.getContext('2d'), s = scale();
  view.ink = getComputedStyle(canvas).color;
  const way = add(endOf(rays.first[state.pixel]), camera.eye, -1);
  view.unit = Math.min(shapes.extent, size(way));  // what normals and the camera are as large as
  g.scale(ratio, ratio);
  if (view.ofCamera) {
    const at = [(head.left - head.width / 2) * s + view.width / 2, (head.top - head.height / 2) * s + view.height / 2];
    g.globalAlpha = 0.75;
    g.drawImage(byId('picture'), ...at, head.columns * head.step * s, head.rows * head.step * s);
    g.globalAlpha = 1;
  }
  drawShapes();
  if (!view.ofCamera) {
    const d = view.unit / 8 / (head.height * size(camera.down));
    const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([x, y]) => add(add(add(camera.eye,
      camera.forward, d), camera.right, d * x * head.width / 2), camera.down, d * y * head.height / 2));
    g.strokeStyle = view.ink;
    polyline(corners, true);
    for (const corner of corners) polyline([camera.eye, corner]);
    label(camera.eye, 'camera', view.ink);
  }
  head.lights.forEach((light, k) => label(light.position, `light ${k + 1}`, colours.lit));
  for (const p of state.pins)
    for (let i = rays.first[p]; i < rays.first[p + 1]; ++i) drawRay(i, 0.45, 1.5);
  for (let i = rays.first[state.pixel]; i < rays.first[state.pixel + 1]; ++i)
    if (i < state.until && rays.level[i] <= state.levels && i !== state.ray)
      drawRay(i, state.ray < 0 ? 1 : 0.6, 2);
  if (state.ray >= 0) drawRay(state.ray, 1, 4.5);
  g.globalAlpha = 1;
}
