// Pictures of the same data: what a pixel's rays say, as a colour from 0 to 255.

const grey = (x) => [x, x, x];
const hues = (k) => [0, 2, 4].map((shift) => {
  const at = (k * 0.381966 * 6 + shift) % 6;
  return 60 + 180 * Math.max(0, Math.min(1, Math.abs(at - 3) - 1));
});
const heat = (x) => [255 * Math.min(1, 2 * x), 255 * Math.max(0, Math.min(1, 2 * x - 0.6)),
  255 * Math.max(0, Math.min(0.55, 1.2 * x) - 1.6 * Math.max(0, x - 0.5))];
const shown = (colour) => colour.map(toByte);
const most = (of) => {
  let best = 1;
  for (let p = 0; p < head.columns * head.rows; ++p) best = Math.max(best, of(p));
  return best;
};
const rayCount = (p) => rays.first[p + 1] - rays.first[p];
function deepest(p) {
  let level = 0;
  for (let i = rays.first[p]; i < rays.first[p + 1]; ++i)
    if (isTraced(i)) level = Math.max(level, rays.level[i]);
  return level;
}

// The light that the first rays of a kind bring back to the pixel.
function brought(p, kind) {
  let sum = [0, 0, 0];
  for (let i = rays.first[p] + 1; i < rays.first[p + 1]; ++i)
    if (rays.level[i] === 1 && isTraced(i) && kindOf(i) === kind)
      sum = add(sum, colourOf(i), rays.weight[i]);
  return shown(sum);
}

function lightAt(p, light) {
  for (let i = rays.first[p] + 1; i < rays.first[p + 1]; ++i)
    if (rays.level[i] === 1 && rays.light[i] === light) return isHit(i) ? [74, 48, 120] : [255, 240, 180];
  return grey(isHit(rays.first[p]) ? 96 : 0);
}

// How far a pixel's shown colour is from its right and lower neighbours'.
function difference(p) {
  const own = shown(colourOf(rays.first[p]));
  const others = [(p + 1) % head.columns ? p + 1 : p, p + head.columns];
  const far = others.filter((q) => q < head.columns * head.rows)
    .map((q) => Math.max(...shown(colourOf(rays.first[q])).map((x, c) => Math.abs(x - own[c]))));
  return grey(Math.min(255, 3 * Math.max(0, ...far)));
}

function faultsOf(p) {
  const found = [];
  for (let i = rays.first[p]; rays.faults.size && i < rays.first[p + 1]; ++i)
    for (const kind of rays.faults.get(i) || []) found.push(kind);
  return found;
}

// [name, what the colours mean, colour of a pixel]
function allPictures() {
  const mostOfRays = most(rayCount), mostOfLevels = most(deepest), root = (p) => rays.first[p];
  const list = [
    ['picture', 'One ray through each pixel\'s centre.', (p) => shown(colourOf(root(p)))],
    ['which shape', 'Every shape has a colour of its own; black: none was hit.', (p) =>
      isHit(root(p)) ? hues(rays.shape[root(p)]) : grey(0)],
    ['depth of recursion', `Black: none; white: ${mostOfLevels} reflections or refractions.`, (p) =>
      heat(deepest(p) / mostOfLevels)],
    ['number of rays', `Black: none; white: ${mostOfRays}.`, (p) => heat(rayCount(p) / mostOfRays)],
    ['normals', 'Red, green and blue are x, y and z of the normal; medium grey is 0.', (p) =>
      isHit(root(p)) ? normalOf(root(p)).map((x) => 128 + 127 * x) : grey(0)],
    ...head.lights.slice(0, 12).map((_, k) => [`light ${k + 1}`,
      'Yellow: lit; violet: in shadow; grey: no ray was cast there; black: nothing was hit.',
      (p) => lightAt(p, k + 1)]),
    ['only reflection', 'What reflected rays bring.', (p) => brought(p, 'reflected')],
    ['only refraction', 'What refracted rays bring.', (p) => brought(p, 'refracted')],
    ['differences of neighbours', 'White: 85 or more of 255 steps to the right or lower one.', difference],
    ['faults', 'Red: a fault; the rest of the picture is darker.', (p) =>
      faultsOf(p).length ? [255, 60, 50] : grey(toByte(0.15 * colourOf(root(p))[1]))]];
  if (rays.error.length) list.splice(-1, 0, ['estimated error',
    'Of the rendered picture. Black: 0.0001 or less; white: 1.', (p) => heat(rays.error[p] / 255)]);
  return list;
}

function paint(canvas, colourAt) {
  canvas.width = head.columns;
  canvas.height = head.rows;
  const image = new ImageData(head.columns, head.rows);
  for (let p = 0; p < head.columns * head.rows; ++p) {
    image.data.set(colourAt(p), 4 * p);
    image.data[4 * p + 3] = 255;
  }
  canvas.getContext('2d').putImageData(image, 0, 0);
}
