// The page: states, sliders, one picture of the newest state.
'use strict';

const $ = id => document.getElementById(id);
for (const part of [$('session'), $('engine')])
  if (textHash(part.textContent) !== part.dataset.hash) throw new Error(DAMAGED);
const data = {
  session: JSON.parse($('session').textContent),
  engine: $('engine').textContent,
  hashes: [...document.querySelectorAll('.field')].map(field => field.dataset.hash),
  names: [...document.querySelectorAll('.field')].map(field => JSON.parse(field.textContent)),
  isExact: document.querySelector('.field').dataset.exact === 'yes',
  pictures: [...document.querySelectorAll('.views')].map(script =>
      ({ field: +script.dataset.field, u: +script.dataset.u, v: +script.dataset.v, base64: script.textContent })),
};
// Fields of a state that have a slider, by section.
const SLIDERS = {
  camera: ['fov'], stereo: ['ipd'], pupil: ['diameter', 'focus'], psf: ['sigma', 'windowSize'],
  distortion: ['k1', 'k2', 'k3', 'p1', 'p2'], sampling: ['reconstruction'],
};

let state, orbit, fields, current = 0, isMoving = false, isWaiting = false, isWanted = false, cost = 0, shown;
let content = 0, test = 1;  // what is shown; the test that is compared with content 0
const isExperiment = typeof startExperiment === 'function';
let sampling = { ...data.session.sampling };

function tell(error) { $('error').textContent = error ? error.message : ''; }

// --- the worker: an answer for each request, and the share of a long one

let ask;

function startWorker() {
  const source = ["'use strict';", $('engineScript').textContent, $('workerScript').textContent].join('\n');
  const worker = new Worker(URL.createObjectURL(new Blob([source], { type: 'text/javascript' })));
  const waiting = new Map();
  let last = 0;
  worker.onmessage = ({ data: { number, share, failure, ...answer } }) => {
    const { done, failed, told } = waiting.get(number);
    if (share !== undefined) return told(share);
    waiting.delete(number);
    if (failure) failed(new Error(failure));
    else done(answer);
  };
  worker.onerror = () => tell(new Error('The engine cannot start in this browser.'));
  ask = (what, request = {}, told = () => {}) => new Promise((done, failed) => {
    waiting.set(++last, { done, failed, told });
    worker.postMessage({ number: last, what, ...request });
  });
}

// --- the picture

async function draw() {
  if (isWaiting) { isWanted = true; return; }
  isWaiting = true;
  isWanted = false;
  // While a hand moves the eye, a slow view has half the pixels across and down.
  const share = isMoving && cost > 40 ? 2 : 1;
  const request = { ...state, eye: orbit.eye }, detail = { eye: request.eye, content };
  if (share > 1) {
    request.res = state.res.map(count => Math.max(1, Math.round(count / share)));
    if (state.intrinsics)
      request.intrinsics = Object.fromEntries(Object.entries(state.intrinsics).map(([k, value]) => [k, value / share]));
  }
  try {
    const picture = await pictureOf({ state: request, sampling, show: +$('show').value });
    cost = share * share * picture.ms;
    shown = picture;
    const canvas = $('view');
    if (canvas.width !== picture.width || canvas.height !== picture.height)
      [canvas.width, canvas.height] = [picture.width, picture.height];
    put(canvas, picture);
    place(picture.ms);
    tell();
    canvas.dispatchEvent(new CustomEvent('drawn', { detail }));
  } catch (error) { tell(error); }
  isWaiting = false;
  if (isWanted) draw();
}

// Renders what is shown: a content, or two of them compared.
async function pictureOf(request) {
  if (data.hashes.length === 1 || isExperiment) return ask('render', { ...request, field: content });
  const { error, reference, test: other, ms } = await ask('compare', { ...request, field: test });
  const decibels = error.psnr === Infinity ? 'identical' : Number.isNaN(error.psnr) ? 'nothing is seen in both' : `PSNR ${error.psnr.toFixed(2)} dB`;
  $('psnr').textContent = `${data.names[test]} against ${data.names[0]}: ${decibels}`;
  if ($('mode').value === 'error') return { ...error, ms };
  if ($('mode').value === 'blink') return { ...(content ? other : reference), ms };
  // Left of the line is the reference.
  const place = Math.round($('wipe').value / 100 * reference.width), row = 4 * reference.width;
  for (let y = 0; y < reference.height; ++y)
    reference.rgba.set(other.rgba.subarray(y * row + 4 * place, (y + 1) * row), y * row + 4 * place);
  for (let y = 0; y < reference.height && place < reference.width; ++y) reference.rgba.set([255, 255, 255, 255], y * row + 4 * place);
  return { ...reference, ms };
}

function showContent(k) {
  if (k >= data.names.length) return;
  content = k;
  if (k) test = k;
  if ($('mode').value !== 'blink' && !k) $('mode').value = 'blink';
  [...$('contents').children].forEach((button, n) => button.setAttribute('aria-pressed', n === k));
  $('wipeLabel').hidden = $('mode').value !== 'wipe';
  draw();
}

function addContents() {
  if (data.names.length < 2) return;
  $('compare').hidden = false;
  data.names.forEach((name, k) => {
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = `${k + 1}  ${name}`;
    button.onclick = () => showContent(k);
    $('contents').append(button);
  });
  $('mode').addEventListener('input', () => showContent($('mode').value === 'blink' ? content : test));
  const sayWipe = () => { $('wipe').nextElementSibling.textContent = `${$('wipe').value} %`; };
  $('wipe').addEventListener('input', () => { sayWipe(); draw(); });
  sayWipe();
  $('digits').textContent = 'choose what is shown, Page Up and Page Down a state,';
  [...$('contents').children].forEach((button, n) => button.setAttribute('aria-pressed', n === 0));
}

function put(canvas, { rgba, width, height }) {
  canvas.getContext('2d').putImageData(new ImageData(new Uint8ClampedArray(rgba), width, height), 0, 0);
}

function place(ms) {
  const degrees = angle => `${(angle * 180 / Math.PI).toFixed(1)}°`;
  $('place').textContent = `Eye at ${orbit.eye.map(value => value.toFixed(3)).join(', ')} m: ${orbit.distance.toFixed(3)} m away, `
      + `${degrees(orbit.across)} across, ${degrees(orbit.up)} up · ${ms.toFixed(1)} ms`;
}

// --- states and fields

function choose(k) {
  const camera = data.session.cameras[k];
  if (!camera) return;
  current = k;
  state = structuredClone(camera);
  for (const section of Object.keys(SLIDERS)) if (section !== 'camera' && section !== 'sampling') state[section] ??= {};
  orbit = new Orbit(camera.eye, camera.lookat || [0, 0, 0]);
  [...$('states').querySelectorAll('button')].forEach((button, n) => button.setAttribute('aria-pressed', n === k));
  $('pixel').textContent = '';
  fill();
  draw();
}

const holder = section => section === 'camera' ? state : section === 'sampling' ? sampling : state[section];
// Lengths of eyes are in millimetres, as in the window.
const isSmall = (section, field) => section === 'stereo' || (section === 'pupil' && field.name === 'diameter');

function valueText(section, field, value) {
  if (section === 'pupil' && field.name === 'focus' && !value) return 'on lookat';
  const [number, unit] = isSmall(section, field) ? [1000 * value, 'mm'] : [value, field.unit];
  const digits = Number.isInteger(number) ? number : +number.toPrecision(3);
  return unit ? `${digits} ${unit}`.replace(' °', '°') : `${digits}`;
}

function addFields() {
  for (const [section, names] of Object.entries(SLIDERS))
    for (const name of names) {
      const field = fields[section].find(each => each.name === name);
      const label = document.createElement('label');
      const title = document.createElement('span');
      title.textContent = section === 'pupil' && name === 'diameter' ? 'Pupil' : field.label || name.replace(/[A-Z]/g, letter => ' ' + letter.toLowerCase()).replace(/^[a-z](?=[a-z])/, l => l.toUpperCase());
      label.title = field.help;
      const input = document.createElement(field.choices ? 'select' : 'input');
      if (field.choices) {
        label.className = 'choice';
        for (const choice of field.choices) input.append(new Option(choice, choice));
      } else {
        const [least, most] = field.slide;
        const step = field.type === 'integer' ? field.step : (most - least) / 200;
        Object.assign(input, { type: 'range', min: least, max: most, step });
      }
      input.id = `${section}.${name}`;
      label.append(title, input);
      if (!field.choices) label.append(document.createElement('output'));
      input.addEventListener('input', () => {
        holder(section)[name] = field.choices ? input.value : +input.value;
        if (section === 'camera') delete state.intrinsics;
        say(section, field);
        draw();
      });
      $(section).append(label);
    }
}

function say(section, field) {
  const input = $(`${section}.${field.name}`);
  if (field.choices) return;
  const value = holder(section)[field.name] ?? field.value[0] ?? 0;
  const text = valueText(section, field, value);
  input.nextElementSibling.textContent = text;
  input.setAttribute('aria-valuetext', text);
}

function fill() {
  for (const [section, names] of Object.entries(SLIDERS))
    for (const name of names) {
      const field = fields[section].find(each => each.name === name);
      const value = holder(section)[name] ?? (field.choices ? field.value : field.value[0] ?? 0);
      $(`${section}.${name}`).value = value;
      say(section, field);
    }
}

function addStates() {
  for (const [k, camera] of data.session.cameras.entries()) {
    const button = document.createElement('button');
    button.type = 'button';
    const picture = document.createElement('canvas');
    [picture.width, picture.height] = [80, 60];
    button.append(picture, document.createTextNode(camera.name));
    button.title = camera.name;
    button.onclick = () => choose(k);
    $('states').append(button);
  }
}

// Small pictures come after the first large one.
async function addSmallPictures() {
  const canvases = [...$('states').querySelectorAll('canvas')];
  for (const [k, camera] of data.session.cameras.entries()) {
    const factor = Math.max(camera.res[0] / 160, camera.res[1] / 120, 1);
    const small = { ...camera, res: camera.res.map(count => Math.max(1, Math.round(count / factor))) };
    if (small.intrinsics)
      small.intrinsics = Object.fromEntries(Object.entries(small.intrinsics).map(([name, value]) => [name, value / factor]));
    try {
      const picture = await ask('render', { state: small, sampling: data.session.sampling || {}, show: SHOW.itself, field: 0 });
      [canvases[k].width, canvases[k].height] = [picture.width, picture.height];
      put(canvases[k], picture);
    } catch { /* the large one says what is wrong */ }
  }
}

// --- clicks

async function clicked(x, y, isControl) {
  if (!shown || isExperiment || +$('show').value !== SHOW.itself) return;
  const [px, py] = [Math.floor(x * state.res[0]), Math.floor(y * state.res[1])];
  const looking = { ...state, eye: orbit.eye };
  try {
    if (isControl && (state.pupil.diameter || 0) > 0) {
      const { focus } = await ask('focus', { state: looking, x: px, y: py, field: 0 });
      if (Number.isNaN(focus)) $('pixel').textContent = 'There is no contrast here to focus on.';
      else {
        state.pupil.focus = +focus.toFixed(3);
        $('pixel').textContent = `Focused at ${state.pupil.focus} m.`;
        fill();
        draw();
      }
      return;
    }
    const { text } = await ask('why', { state: looking, x: px, y: py, field: content });
    $('pixel').textContent = `Pixel ${px}, ${py}: ${text}`
        + (isControl ? '. This state is a pinhole, which sees everything sharp: give its pupil a diameter' : '');
  } catch (error) { tell(error); }
}

function connect() {
  const canvas = $('view');
  moveByHand(canvas, () => orbit, moving => { isMoving = moving; draw(); }, clicked);
  canvas.addEventListener('keydown', e => {
    if (e.ctrlKey || e.altKey || e.metaKey) return;
    // Digits are contents where there are several, and states follow each other by Page Up and Down.
    if (e.key >= '1' && e.key <= '9') (data.names.length > 1 ? showContent : choose)(e.key - 1);
    const way = { PageDown: 1, PageUp: -1 }[e.key];
    if (way) { e.preventDefault(); choose(current + way); }
    if (e.key === '0') choose(current);
  });
  $('controls').addEventListener('submit', e => e.preventDefault());
  $('show').addEventListener('input', () => {
    if (+$('show').value !== SHOW.itself && !state.stereo.ipd) state.stereo.ipd = 0.063;  // most people's
    fill();
    draw();
  });
  $('reset').onclick = () => choose(current);
  $('full').onclick = () => $('stage').requestFullscreen();
  $('save').onclick = () => canvas.toBlob(blob => {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(blob);
    link.download = 'view.png';
    link.click();
  });
  const use = isLight => {
    document.documentElement.classList.toggle('light', isLight);
    $('look').setAttribute('aria-pressed', isLight);
  };
  $('look').onclick = () => use(!document.documentElement.classList.contains('light'));
  use(matchMedia('(prefers-color-scheme: light)').matches);
}

// The panel in its own frame: where it stands in the session's world does not matter.
async function offerVr() {
  const hasHeadset = navigator.xr && await navigator.xr.isSessionSupported('immersive-vr').catch(() => false);
  if (!hasHeadset) return;
  $('vr').hidden = false;
  const panelOf = (eye, width, height) => {
    const { name, psf } = state;
    return ask('panel', { state: { name, psf, eye, lookat: [0, 0, 0], res: [width, height] }, width, height, field: content });
  };
  $('vr').onclick = () => enterVr(data.session.display, orbit.distance, panelOf).catch(tell);
}

// For tests: a hash of the content, and one of each state's picture and mask. All of it is done when
// the page has been loaded.
function check() {
  const out = document.createElement('pre');
  out.id = 'check';
  const lines = [];
  try {
    if (!data.isExact) lines.push('small', 'this page\'s content is compressed');
    else {
      const engine = exactEngine(data);
      data.hashes.forEach((hash, field) => lines.push(`texels ${engine.hash(field)}`));
      for (const camera of data.session.cameras)
        if (!camera.stereo || !camera.stereo.ipd) lines.push(`${camera.name} ${hashOf(engine.render(camera))}`);
        else for (const eye of ['left', 'right']) lines.push(`${camera.name}.${eye} ${hashOf(engine.render(camera, SHOW[eye]))}`);
    }
  } catch (error) { lines.push(`error ${error.message}`); }
  out.textContent = lines.join('\n');
  document.body.append(out);
}

async function main() {
  if (location.hash === '#check') return check();
  try {
    startWorker();
    const loaded = await ask('load', { data }, share => {
      $('bar').setAttribute('aria-valuenow', Math.round(100 * share));
      $('bar').firstElementChild.style.width = `${100 * share}%`;
    });
    fields = loaded.fields;
    addFields();
    addContents();
    addStates();
    connect();
    choose(0);
    $('still').hidden = $('bar').hidden = true;
    $('view').hidden = false;
    $('controls').hidden = isExperiment;
    if (isExperiment) startExperiment();
    else {
      await addSmallPictures();
      await offerVr();
    }
    document.body.dataset.ready = 'yes';
  } catch (error) {
    $('bar').hidden = true;
    tell(error);
  }
}

if (typeof WebAssembly !== 'object' || typeof structuredClone !== 'function')
  tell(new Error('This browser is too old for the engine: it needs Chrome 98, Firefox 94, Safari 16.4 or later. The picture is still.'));
else main();
