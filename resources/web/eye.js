// The eye that hands move around the display: mouse, wheel, fingers, keys.
'use strict';

// An eye on a sphere around a target: angles in radians, distance in metres.
class Orbit {
  constructor(eye, target) {
    const [x, y, z] = eye.map((value, k) => value - target[k]);
    this.target = target;
    this.distance = Math.max(Math.hypot(x, y, z), 1e-3);
    this.across = Math.atan2(x, z);
    this.up = Math.asin(y / this.distance);
  }
  limit() {
    this.across = Math.max(-1.5, Math.min(1.5, this.across));
    this.up = Math.max(-1.5, Math.min(1.5, this.up));
    this.distance = Math.max(0.02, Math.min(20, this.distance));
  }
  get eye() {
    const flat = this.distance * Math.cos(this.up);
    return [this.target[0] + flat * Math.sin(this.across), this.target[1] + this.distance * Math.sin(this.up),
            this.target[2] + flat * Math.cos(this.across)];
  }
}

// Calls moved(isMoving) when the eye of `orbit()` has moved, and clicked(x, y, isControl), with shares
// of the canvas, for a press that did not move.
function moveByHand(canvas, orbit, moved, clicked) {
  const fingers = new Map();
  const spread = () => { const [a, b] = [...fingers.values()]; return Math.hypot(a.x - b.x, a.y - b.y); };
  let way = 0;
  const change = () => { orbit().limit(); moved(fingers.size > 0); };
  canvas.addEventListener('pointerdown', e => {
    try { canvas.setPointerCapture(e.pointerId); } catch { /* a pointer that is gone already */ }
    if (!fingers.size) way = 0;
    fingers.set(e.pointerId, { x: e.clientX, y: e.clientY });
  });
  canvas.addEventListener('pointermove', e => {
    const before = fingers.get(e.pointerId);
    if (!before) return;
    const old = fingers.size === 2 ? spread() : 0;
    fingers.set(e.pointerId, { x: e.clientX, y: e.clientY });
    way += Math.abs(e.clientX - before.x) + Math.abs(e.clientY - before.y) + (fingers.size === 2 ? 9 : 0);
    if (way < 4) return;
    if (fingers.size === 2) orbit().distance *= old / Math.max(spread(), 1);
    else {
      orbit().across -= (e.clientX - before.x) / canvas.clientWidth * 2;
      orbit().up += (e.clientY - before.y) / canvas.clientWidth * 2;
    }
    change();
  });
  const end = e => {
    if (!fingers.delete(e.pointerId)) return;
    if (e.type === 'pointerup' && way < 4 && !fingers.size) {
      const place = canvas.getBoundingClientRect();
      clicked((e.clientX - place.left) / place.width, (e.clientY - place.top) / place.height, e.ctrlKey);
    } else change();
  };
  canvas.addEventListener('pointerup', end);
  canvas.addEventListener('pointercancel', end);
  canvas.addEventListener('wheel', e => {
    e.preventDefault();
    orbit().distance *= Math.exp(e.deltaY / 1000);
    change();
  }, { passive: false });
  canvas.addEventListener('keydown', e => {
    const step = e.shiftKey ? 0.005 : 0.02;
    const move = {
      ArrowLeft: o => { o.across -= step; }, ArrowRight: o => { o.across += step; },
      ArrowUp: o => { o.up += step; }, ArrowDown: o => { o.up -= step; },
      '+': o => { o.distance /= 1.03; }, '=': o => { o.distance /= 1.03; }, '-': o => { o.distance *= 1.03; },
    }[e.key];
    if (!move || e.ctrlKey || e.altKey || e.metaKey) return;
    e.preventDefault();
    move(orbit());
    change();
  });
}
