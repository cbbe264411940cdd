// Mouse, touch and keys.

function pixelUnder(event) {
  const box = picture.getBoundingClientRect();
  const x = Math.floor((event.clientX - box.left) / box.width * head.columns);
  const y = Math.floor((event.clientY - box.top) / box.height * head.rows);
  return clamp(y, head.rows - 1) * head.columns + clamp(x, head.columns - 1);
}

const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
// Calls the action for a key, and keeps the browser from doing something else with it.
function onKeys(element, actionOf) {
  element.addEventListener('keydown', (event) => {
    const action = !event.ctrlKey && !event.altKey && !event.metaKey && actionOf(event);
    if (!action) return;
    event.preventDefault();
    action();
  });
}

function listenToPicture() {
  picture.addEventListener('pointermove', (event) => {
    if (event.buttons || event.pointerType === 'touch') hold(pixelUnder(event));
    else if (!state.held && pixelUnder(event) !== state.pixel) show(pixelUnder(event));
  });
  picture.addEventListener('pointerdown', (event) => {
    const p = pixelUnder(event);
    hold(p, !(state.held && p === state.pixel && event.pointerType !== 'touch'));
  });
  onKeys(picture, ({ key, shiftKey }) => {
    const by = shiftKey ? 10 : 1;
    if (key in arrows) return () => move(...arrows[key].map((d) => d * by));
    return { Enter: () => hold(state.pixel), Escape: () => hold(state.pixel, false) }[key];
  });
}

function listenToView() {
  const pointers = new Map();
  const spread = () => {
    const [a, b] = [...pointers.values()];
    return [Math.hypot(a[0] - b[0], a[1] - b[1]), (a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
  };
  view.canvas.addEventListener('pointerdown', (event) => {
    view.canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, [event.clientX, event.clientY]);
  });
  for (const end of ['pointerup', 'pointercancel'])
    view.canvas.addEventListener(end, (event) => pointers.delete(event.pointerId));
  view.canvas.addEventListener('pointermove', (event) => {
    const last = pointers.get(event.pointerId);
    if (!last) return;
    const before = pointers.size > 1 && spread();
    pointers.set(event.pointerId, [event.clientX, event.clientY]);
    const [dx, dy] = [event.clientX - last[0], event.clientY - last[1]];
    if (before) {
      const after = spread();
      zoom(before[0] / Math.max(1, after[0]));
      pan(after[1] - before[1], after[2] - before[2]);
    } else if (event.shiftKey || event.buttons > 1) pan(dx, dy);
    else orbit(dx / 150, dy / 150);
    draw();
  });
  view.canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    zoom(Math.exp(clamp(event.deltaY + 300, 600) / 600 - 0.5));
    draw();
  }, { passive: false });
  onKeys(view.canvas, ({ key, shiftKey }) => {
    const turned = arrows[key], factor = { '+': 0.87, '=': 0.87, '-': 1.15 }[key];
    if (!turned && !factor) return null;
    return () => {
      if (factor) zoom(factor);
      else if (shiftKey) pan(-30 * turned[0], -30 * turned[1]);
      else orbit(turned[0] / 10, turned[1] / 10);
      draw();
    };
  });
}

function listenToButtons() {
  const actions = { pin, back: () => step(-1), next: () => step(1), play, all: () => choose(-1, Infinity),
    throughCamera: lookThroughCamera,
    outside: () => { lookThroughCamera(); orbit(0.7, 0.35); zoom(1.6); },
    alongX: () => lookAlong([-1, 0, 0], [0, 1, 0]), alongY: () => lookAlong([0, -1, 0], [0, 0, -1]),
    alongZ: () => lookAlong([0, 0, -1], [0, 1, 0]) };
  for (const [id, action] of Object.entries(actions))
    byId(id).addEventListener('click', () => { action(); draw(); });
  onKeys(document.body, ({ key, target }) => (target.tagName === 'SELECT' ? null :
    { p: pin, n: () => step(1), b: () => step(-1) }[key]));
  onKeys(byId('tree'), ({ key }) => ({ ArrowDown: () => step(1), ArrowUp: () => step(-1) }[key]));
  byId('levels').addEventListener('input', ({ target }) => {
    state.levels = Number(target.value);
    byId('levelsText').textContent = target.value;
    choose(state.ray, state.until);
  });
  byId('kind').addEventListener('change', ({ target }) => choosePicture(target.selectedIndex));
  window.addEventListener('resize', draw);
}
