// The rays of a pixel in words, as --pixel prints them.

const colours = { primary: '#9a9ca6', lit: '#d9a400', blocked: '#8f63c9', reflected: '#2b9c56',
  refracted: '#2f86e8', total: '#dd4488', other: '#e2662c' };
const colourNames = { primary: 'primary', lit: 'shadow ray, lit', blocked: 'shadow ray, blocked',
  reflected: 'reflected', refracted: 'refracted', total: 'total internal reflection',
  other: 'made by hand' };

// Which of the colours a ray has.
function look(i) {
  if (!isTraced(i)) return isHit(i) ? 'blocked' : 'lit';
  return isTotal(i) ? 'total' : kindOf(i) === 'shadow' ? 'other' : kindOf(i);
}

const number = (x, digits = 5) => Number.isFinite(x) ? String(Number(x.toPrecision(digits)) || 0) :
  Number.isNaN(x) ? 'NaN' : x < 0 ? '-infinity' : 'infinity';
const vector = (v, digits) => `(${v.map((x) => number(x, digits)).join(', ')})`;
const materialAt = (i) => rays.shape[i] ? shapes[rays.shape[i] - 1].material : null;
const toByte = (x) => x > 0 ? Math.floor(256 * Math.min(x ** (1 / head.gamma), 0.999)) : 0;

function shapeText(number24) {
  if (!number24) return 'a shape that is not listed here';
  const { name, line, numbers: n } = shapes[number24 - 1];
  const point = (at) => vector(n.slice(at, at + 3), 6);
  const what = { sphere: () => `centre ${point(0)}, radius ${number(n[3], 6)}`,
    triangle: () => `${point(0)} ${point(3)} ${point(6)}`,
    cone: () => `from ${point(0)}, radius ${number(n[3])}, to ${point(4)}, radius ${number(n[7])}`,
    shape: () => `between ${point(0)} and ${point(3)}` }[name]();
  return `${name} (line ${line}, ${what})`;
}

const depthOf = (i) => head.depth - rays.level[i];
const childrenOf = (i, end) => {
  const all = [];
  for (let j = i + 1; j < end && rays.level[j] > rays.level[i]; ++j) if (rays.parent[j] === i) all.push(j);
  return all;
};

function headline(i) {
  const kind = `${kindOf(i)} ray`;
  if (!isTraced(i)) {
    const light = rays.light[i];
    const to = light ? `light ${light} at ${vector(head.lights[light - 1].position)}` : 'no light';
    return `${kind} to ${to}: ${isHit(i) ? 'blocked' : 'lit'}`;
  }
  const parts = [kind + (isTotal(i) ? ' (total internal reflection)' : '')];
  if (rays.parent[i] >= 0) parts.push(`weight ${number(rays.weight[i], 3)}${disagreement(i)}`);
  return `${parts.join(', ')}, depth ${depthOf(i)}: colour ${vector(colourOf(i), 4)}`;
}

// The material's weight, if another was measured.
function disagreement(i) {
  const material = materialAt(rays.parent[i]), kind = kindOf(i);
  if (!material || !['reflected', 'refracted'].includes(kind)) return '';
  const expected = kind === 'reflected' ? material.reflectivity : material.transparency;
  if (Math.abs(rays.weight[i] - expected) <= 1e-3 * Math.max(1e-2, expected)) return '';
  return ` (the material says ${number(expected, 3)})`;
}

function hitText(i) {
  if (!isHit(i)) return 'hits nothing';
  const t = size(add(endOf(i), startOf(i), -1));
  const side = isTraced(i) ? `, ${isFront(i) ? 'front' : 'back'}, t = ${number(t)}` : '';
  const normal = isTraced(i) ? `, normal ${vector(normalOf(i), 4)}` : '';
  return `hits ${shapeText(rays.shape[i])}${side} at ${vector(endOf(i))}${normal}`;
}

// Why less light comes than could: no light, behind the surface, depth used up.
function reasons(i, end) {
  if (!isTraced(i) || !isHit(i)) return [];
  const material = materialAt(i), children = childrenOf(i, end), texts = [];
  if (!material) return [];
  const { reflectivity: r, transparency: t } = material;
  if (!head.lights.length) texts.push('no light in the scene, so nothing is scattered');
  if (1 - r - t > 0)
    head.lights.forEach((light, k) => {
      if (children.some((child) => rays.light[child] === k + 1)) return;
      if (!(dot(normalOf(i), add(light.position, endOf(i), -1)) > 0))
        texts.push(`light ${k + 1} at ${vector(light.position)} is behind the surface`);
    });
  if (depthOf(i) <= 0 && !children.some(isTraced) && r + t > 0)
    texts.push('the depth is used up: no reflected or refracted ray follows');
  return texts;
}

// The lines below a ray's headline: [text, whether it is a fault].
function details(i, end) {
  const start = startOf(i);
  const lines = [[`from ${vector(start)} towards ${vector(unit(add(endOf(i), start, -1)), 4)}`, false]];
  if (isTraced(i) || isHit(i)) lines.push([hitText(i), false]);
  for (const text of reasons(i, end)) lines.push([text, false]);
  for (const kind of rays.faults.get(i) || []) lines.push([`!! ${head.faults[kind]}`, true]);
  return lines;
}

// Fills the list of rays; choose(i) is called when one is clicked.
function showTree(list, first, end, choose) {
  const items = [], most = 1000;
  for (let i = first; i < Math.min(end, first + most); ++i) {
    const item = document.createElement('div');
    item.className = 'ray';
    item.setAttribute('role', 'treeitem');
    item.setAttribute('aria-level', rays.level[i] + 1);
    item.style.marginLeft = `${Math.min(rays.level[i], 8) * 18}px`;
    item.style.borderLeftColor = colours[look(i)];
    item.append(headline(i));
    for (const [text, isFault] of details(i, end)) {
      const line = document.createElement('span');
      line.textContent = text;
      line.classList.toggle('fault', isFault);
      item.append(line);
    }
    item.addEventListener('click', () => choose(i));
    items.push(item);
  }
  list.replaceChildren(...items);
  if (end > first + most) list.append(`... and ${end - first - most} more`);
}
