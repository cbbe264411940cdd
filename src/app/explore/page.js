// What the page shows, and what its buttons do. (Script files are one script in the page.)

const state = { pixel: 0, ray: -1, until: Infinity, levels: Infinity, held: false, pins: [], timer: 0 };
const picture = byId('picture');
let pictures = [], pending = 0;

const draw = () => {
  pending = pending || requestAnimationFrame(() => { pending = 0; drawView(state); });
};
const button = (text, action) => {
  const result = document.createElement('button');
  result.textContent = text;
  result.addEventListener('click', action);
  return result;
};
const nameOf = (p) => pixelAt(p).join(',');

// Shows a pixel: everything on the page is about it.
function show(p) {
  stop();
  Object.assign(state, { pixel: p, ray: -1, until: Infinity });
  const [x, y] = [p % head.columns, Math.floor(p / head.columns)], first = rays.first[p];
  byId('cross').style.left = `${(x + 0.5) / head.columns * 100}%`;
  byId('cross').style.top = `${(y + 0.5) / head.rows * 100}%`;
  const colour = colourOf(first), faults = [...new Set(faultsOf(p))];
  byId('pixel').textContent = `pixel ${nameOf(p)}${state.held ? ' (held)' : ''}\n` +
    `linear ${vector(colour, 6)}\nshown as ${shown(colour).join(' ')}\n` +
    `${rayCount(p)} ray${rayCount(p) > 1 ? 's' : ''}, hits ${isHit(first) ? shapeText(rays.shape[first]) :
      'nothing'}` + faults.map((kind) => `\n!! ${head.faults[kind]}`).join('');
  const lens = byId('magnifier').getContext('2d');
  lens.imageSmoothingEnabled = false;
  lens.fillStyle = '#777';
  lens.fillRect(0, 0, 165, 165);
  lens.drawImage(picture, x - 5, y - 5, 11, 11, 0, 0, 165, 165);
  lens.strokeStyle = '#ffd54a';
  lens.strokeRect(75.5, 75.5, 14, 14);
  showTree(byId('tree'), first, rays.first[p + 1], (i) => choose(i, state.until));
  choose(-1, Infinity);
}

// Highlights a ray in list and scene; -1: none. Rays from `until` on are not drawn.
function choose(ray, until) {
  Object.assign(state, { ray, until });
  [...byId('tree').children].forEach((item, k) => {
    const i = rays.first[state.pixel] + k;
    item.setAttribute('aria-selected', i === ray);
    item.tabIndex = i === Math.max(ray, rays.first[state.pixel]) ? 0 : -1;
    item.classList.toggle('later', i >= until || rays.level[i] > state.levels);
    if (i === ray) {
      item.parentNode.scrollTop = item.offsetTop - item.parentNode.offsetTop - 60;
      if (item.parentNode.contains(document.activeElement)) item.focus({ preventScroll: true });
    }
  });
  draw();
}

// One ray on or back in the order of the calls.
function step(by) {
  const first = rays.first[state.pixel], end = rays.first[state.pixel + 1];
  const now = state.ray < 0 ? (by > 0 ? first - 1 : end) : state.ray;
  const ray = Math.max(first, Math.min(end - 1, now + by));
  choose(ray, ray + 1);
  if (ray === end - 1 && by > 0) stop();
}

function stop() {
  clearInterval(state.timer);
  state.timer = 0;
  byId('play').textContent = 'Play';
}

function play() {
  if (state.timer) return stop();
  if (state.ray < 0 || state.ray === rays.first[state.pixel + 1] - 1) choose(-1, 0);
  state.timer = setInterval(() => step(1), 700);
  byId('play').textContent = 'Stop';
  step(1);
}

function pin() {
  const at = state.pins.indexOf(state.pixel);
  at < 0 ? state.pins.push(state.pixel) : state.pins.splice(at, 1);
  byId('pins').replaceChildren(...state.pins.map((p) => {
    const line = document.createElement('p');
    line.append(button(nameOf(p), () => hold(p)), ` ${vector(colourOf(rays.first[p]), 4)}, ` +
      `${rayCount(p)} rays, ${isHit(rays.first[p]) ? shapeText(rays.shape[rays.first[p]]) : 'nothing hit'}`);
    return line;
  }));
  draw();
}

function hold(p, held = true) {
  state.held = held;
  byId('frame').classList.toggle('held', held);
  show(p);
}

const clamp = (x, most) => Math.max(0, Math.min(most, x));
function move(dx, dy) {
  const x = clamp(state.pixel % head.columns + dx, head.columns - 1);
  const y = clamp(Math.floor(state.pixel / head.columns) + dy, head.rows - 1);
  hold(y * head.columns + x);
}

function choosePicture(k) {
  byId('kind').selectedIndex = k;
  byId('legend').textContent = pictures[k][1];
  paint(picture, pictures[k][2]);
  show(state.pixel);
}

// Pixels by what is wrong with them; returns the first one, or -1.
function listFaults() {
  const lists = new Map();
  for (let p = 0; rays.faults.size && p < head.columns * head.rows; ++p)
    for (const kind of new Set(faultsOf(p))) {
      if (!lists.has(kind)) lists.set(kind, []);
      lists.get(kind).push(p);
    }
  const parts = [...lists].map(([kind, pixels]) => {
    const part = document.createElement('div'), title = document.createElement('h3');
    title.textContent = `${head.faults[kind]}: ${pixels.length} pixel${pixels.length > 1 ? 's' : ''}`;
    const bar = document.createElement('p');
    bar.className = 'bar';
    bar.append(...pixels.slice(0, 24).map((p) => button(nameOf(p), () => hold(p))));
    part.append(title, bar);
    return part;
  });
  byId('faults').replaceChildren(...(parts.length ? parts : ['None: no NaN, nothing infinite or negative.']));
  return Math.min(...[...lists.values()].map((pixels) => pixels[0]));
}

async function start() {
  await readRays();
  const ordinal = `${head.step}${{ 2: 'nd', 3: 'rd' }[head.step] || 'th'}`;
  document.title = `Where the rays of ${head.scene} went`;
  byId('about').textContent = `${head.scene}, ${head.width}x${head.height}, depth ${head.depth}: ` +
    `${rays.count} rays through ${head.columns * head.rows} pixels` +
    (head.step > 1 ? `, of every ${ordinal} row and column` : '') + '.';
  for (const id of ['frame', 'view'])
    byId(id).style.maxWidth = `calc(78vh * ${head.columns / head.rows})`;
  for (const [kind, colour] of Object.entries(colours)) {
    const name = document.createElement('span');
    name.className = 'kind';
    name.style.borderColor = colour;
    name.textContent = colourNames[kind];
    byId('colours').append(name);
  }
  pictures = allPictures();
  byId('kind').append(...pictures.map(([name]) => new Option(name)));
  byId('levels').max = byId('levels').value = byId('levelsText').textContent = most(deepest);
  lookThroughCamera();
  orbit(0.7, 0.35);
  zoom(1.6);
  listenToPicture();
  listenToView();
  listenToButtons();
  const fault = listFaults(), best = most(rayCount);
  state.pixel = Number.isFinite(fault) ? fault : 0;
  for (let p = 0; !Number.isFinite(fault) && rayCount(state.pixel) < best; ++p)
    if (rayCount(p) === best) state.pixel = p;
  const wanted = location.hash.slice(1).split(',').map(Number);
  if (wanted.length === 2) state.pixel = clamp(Math.floor((wanted[1] - head.top) / head.step), head.rows - 1) *
    head.columns + clamp(Math.floor((wanted[0] - head.left) / head.step), head.columns - 1);
  choosePicture(0);
  document.body.dataset.ready = 'yes';
}
start();
