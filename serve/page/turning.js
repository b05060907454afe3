// Turning by pointer, wheel, fingers and keys.

const kStep = Math.PI / 24;  // of an arrow key
const kPerPixel = 0.008;     // radians
const kKeys = {
  ArrowLeft: (pose) => pose.rotate(-kStep, 0),
  ArrowRight: (pose) => pose.rotate(kStep, 0),
  ArrowUp: (pose) => pose.rotate(0, -kStep),
  ArrowDown: (pose) => pose.rotate(0, kStep),
  '+': (pose) => pose.magnify(1.2),
  '=': (pose) => pose.magnify(1.2),
  '-': (pose) => pose.magnify(1 / 1.2),
  Home: (pose) => pose.reset(),
};

export function makeTurnable(box, pose) {
  const fingers = new Map();
  const spread = () => {
    const [a, b] = [...fingers.values()];
    return Math.hypot(a.x - b.x, a.y - b.y);
  };
  box.addEventListener('pointerdown', (event) => {
    fingers.set(event.pointerId, {x: event.clientX, y: event.clientY});
    box.setPointerCapture(event.pointerId);
  });
  box.addEventListener('pointermove', (event) => {
    const before = fingers.get(event.pointerId);
    if (!before) return;
    const apart = fingers.size === 2 ? spread() : 0;
    const now = {x: event.clientX, y: event.clientY};
    fingers.set(event.pointerId, now);
    if (fingers.size === 1) pose.rotate((now.x - before.x) * kPerPixel, (now.y - before.y) * kPerPixel);
    else if (apart > 0) pose.magnify(spread() / apart);
  });
  for (const end of ['pointerup', 'pointercancel']) box.addEventListener(end, (event) => fingers.delete(event.pointerId));
  box.addEventListener('wheel', (event) => {
    event.preventDefault();
    pose.magnify(Math.exp(-event.deltaY * 0.0015));
  }, {passive: false});
  box.addEventListener('keydown', (event) => {
    const act = kKeys[event.key];
    if (!act || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    act(pose);
  });
}
