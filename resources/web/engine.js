// The engine behind functions of JavaScript, in the page or in its worker: memory, errors, a
// session's parameters by their names, and content that a page holds.
'use strict';

const SHOW = { itself: 0, left: 1, right: 2, sideBySide: 3, anaglyph: 4, anaglyphGrey: 5, crossEyed: 6 };
const HEAD = ['distortion', 'psf', 'intrinsics', 'pupil', 'stereo'];

class Engine {
  // Makes an engine of the bytes of engine.wasm. The core asks the system for nothing but the time;
  // what the C library links besides is answered with "no such file".
  static of(bytes) {
    const made = new Engine();
    const system = new Proxy({
      clock_time_get: (id, precision, at) => {
        new DataView(made.memory.buffer).setBigUint64(at >>> 0, BigInt(Math.round(1e6 * performance.now())), true);
        return 0;
      },
      proc_exit: status => { throw new Error('the engine ended with ' + status); },
    }, { get: (known, name) => known[name] || (() => 8) });
    const instance = new WebAssembly.Instance(new WebAssembly.Module(bytes), {
      page: { thrown: at => { throw new Error(made.text(at)); } },
      wasi_snapshot_preview1: system,
    });
    made.c = instance.exports;
    made.memory = instance.exports.memory;
    made.c._initialize();
    made.c.hs_reset(1);
    made.numbers = made.c.hs_alloc(64 * 8) >>> 0;
    return made;
  }

  text(at) {
    const all = new Uint8Array(this.memory.buffer);
    return new TextDecoder().decode(all.slice(at >>> 0, all.indexOf(0, at >>> 0)));
  }
  // Calls `use` with the addresses of texts.
  with(texts, use) {
    const at = texts.map(text => {
      const bytes = new TextEncoder().encode(text + '\0');
      const place = this.c.hs_alloc(bytes.length) >>> 0;
      new Uint8Array(this.memory.buffer, place, bytes.length).set(bytes);
      return place;
    });
    const result = use(...at);
    at.forEach(place => this.c.hs_free(place));
    return result;
  }

  // Sets a field as a session's document has it.
  set(section, field, value) {
    const list = typeof value === 'string' ? [] : [].concat(value).map(Number);
    new Float64Array(this.memory.buffer, this.numbers, list.length).set(list);
    const wrong = this.with([section, field, typeof value === 'string' ? value : ''], (s, f, words) =>
        this.text(this.c.hs_set(s, f, this.numbers, list.length, words)));
    if (wrong) throw new RangeError(wrong);
  }
  setAll(section, values) {
    for (const [field, value] of Object.entries(values)) this.set(section, field, value);
  }
  setSession(session) {
    this.c.hs_reset(1);
    this.setAll('display', session.display);
    this.setAll('sampling', session.sampling || {});
    if (session.lightField && session.lightField.viewingDistance)
      this.set('lightField', 'viewingDistance', session.lightField.viewingDistance);
  }
  setState(state) {
    this.c.hs_reset(0);
    for (const [name, value] of Object.entries(state))
      if (HEAD.includes(name)) this.setAll(name, value);
      else this.set('camera', name, value);
  }
  // A section's fields: name, label, help, unit, range, value.
  fields(section) { return JSON.parse(this.with([section], at => this.text(this.c.hs_fields(at)))); }

  // Returns { rgba, mask, width, height }, copied out of the engine's memory.
  picture(height) {
    const width = this.c.hs_width();
    const copy = (at, bytes) => new Uint8Array(this.memory.buffer, at >>> 0, bytes).slice();
    return { width, height, rgba: copy(this.c.hs_picture(), 4 * width * height),
             mask: copy(this.c.hs_mask(), width * height) };
  }
  render(state, show = SHOW.itself, field = 0) {
    this.setState(state);
    this.c.hs_render(field, show);
    return this.picture(state.res[1]);
  }
  // The error of a light field against the first one as a picture, and its PSNR.
  compare(state, show, field) {
    this.setState(state);
    const psnr = this.c.hs_compare(field, show);
    return { psnr, ...this.picture(state.res[1]) };
  }
  // The panel as the state's eye sees it; none if the eye is not before it.
  panel(state, width, height, field = 0) {
    this.setState(state);
    return this.c.hs_panel(field, width, height) ? this.picture(height) : null;
  }
  why(state, x, y, field = 0) {
    this.setState(state);
    return this.text(this.c.hs_why(field, x, y));
  }
  focus(state, x, y, field = 0) {
    this.setState(state);
    return this.c.hs_focus(field, x, y);
  }
  hash(field = 0) { return (this.c.hs_hash(field) >>> 0).toString(16).padStart(8, '0'); }
}

// FNV-1a, 32 bits, over R, G, B and the mask (255 or 0) of a picture.
function hashOf({ rgba, mask }) {
  let hash = 2166136261;
  const add = value => { hash = Math.imul(hash ^ value, 16777619); };
  for (let k = 0; k < mask.length; ++k) {
    add(rgba[4 * k]);
    add(rgba[4 * k + 1]);
    add(rgba[4 * k + 2]);
    add(mask[k] ? 255 : 0);
  }
  return (hash >>> 0).toString(16).padStart(8, '0');
}

// FNV-1a, 32 bits, over the bytes of a text in UTF-8.
function textHash(text) {
  let hash = 2166136261;
  for (const byte of new TextEncoder().encode(text)) hash = Math.imul(hash ^ byte, 16777619);
  return (hash >>> 0).toString(16).padStart(8, '0');
}

function fromBase64(text) {
  const letters = atob(text.trim());
  const bytes = new Uint8Array(letters.length);
  for (let k = 0; k < letters.length; ++k) bytes[k] = letters.charCodeAt(k);
  return bytes;
}

// The table of a Huffman code: for as many bits as the longest one has, symbol · 16 + length.
function tableOf(lengths) {
  const most = Math.max(...lengths, 1), table = new Uint16Array(1 << most);
  const next = [0, 0];
  for (let bits = 1; bits <= 15; ++bits)
    next[bits + 1] = (next[bits] + lengths.filter(length => length === bits).length) << 1;
  lengths.forEach((length, symbol) => {
    if (!length) return;
    let code = next[length]++, reversed = 0;
    for (let bit = 0; bit < length; ++bit, code >>= 1) reversed = reversed << 1 | code & 1;
    for (let k = reversed; k < table.length; k += 1 << length) table[k] = symbol << 4 | length;
  });
  return { most, table };
}

// Unpacks deflate (RFC 1951) from `at` on to `size` bytes. The browser's own unpacks in the background
// alone, and a page that is loaded with #check has to be complete then.
function unpacked(input, at, size) {
  const extra = (count, step) => Array.from({ length: count }, (_, k) => k < 2 * step ? 0 : Math.floor(k / step) - 1);
  const bases = (bits, first) => bits.map((count, k) => k ? first += 1 << bits[k - 1] : first);
  const lengthBits = [...extra(28, 4), 0], lengths = [...bases(lengthBits.slice(0, 28), 3), 258];
  const wayBits = extra(30, 2), ways = bases(wayBits, 1);
  const result = new Uint8Array(size);
  let to = 0, held = 0, count = 0, isLast = 0;
  const bits = wanted => {
    for (; count < wanted; count += 8) held |= input[at++] << count;
    const value = held & (1 << wanted) - 1;
    held >>>= wanted;
    count -= wanted;
    return value;
  };
  const symbol = ({ most, table }) => {
    for (; count < most; count += 8) held |= (input[at++] || 0) << count;
    const entry = table[held & (1 << most) - 1];
    if (!(entry & 15)) throw new Error('damaged');
    held >>>= entry & 15;
    count -= entry & 15;
    return entry >> 4;
  };
  while (!isLast) {
    isLast = bits(1);
    const kind = bits(2);
    if (kind === 0) {
      at -= count >> 3;  // whole bytes that were read ahead
      held = count = 0;
      const length = input[at] | input[at + 1] << 8;
      at += 4;
      if (to + length > size || at + length > input.length) throw new Error('damaged');
      result.set(input.subarray(at, at + length), to);
      at += length;
      to += length;
      continue;
    }
    let literals, distances;
    if (kind === 1) {
      literals = tableOf(Array.from({ length: 288 }, (_, k) => k < 144 ? 8 : k < 256 ? 9 : k < 280 ? 7 : 8));
      distances = tableOf(Array(30).fill(5));
    } else if (kind === 2) {
      const [literalCount, distanceCount, codes] = [bits(5) + 257, bits(5) + 1, bits(4) + 4];
      const order = [16, 17, 18, 0, 8, 7, 9, 6, 10, 5, 11, 4, 12, 3, 13, 2, 14, 1, 15];
      const own = Array(19).fill(0), all = [];
      for (let k = 0; k < codes; ++k) own[order[k]] = bits(3);
      const table = tableOf(own);
      while (all.length < literalCount + distanceCount) {
        const code = symbol(table);
        if (code < 16) { all.push(code); continue; }
        const value = code === 16 ? all[all.length - 1] : 0;
        for (let k = code === 18 ? 11 + bits(7) : 3 + bits(code === 17 ? 3 : 2); k > 0; --k) all.push(value);
      }
      literals = tableOf(all.slice(0, literalCount));
      distances = tableOf(all.slice(literalCount, literalCount + distanceCount));
    } else throw new Error('damaged');
    for (let code = symbol(literals); code !== 256; code = symbol(literals)) {
      if (code < 256) {
        if (to >= size) throw new Error('damaged');
        result[to++] = code;
        continue;
      }
      const length = lengths[code - 257] + bits(lengthBits[code - 257]);
      const far = symbol(distances), way = ways[far] + bits(wayBits[far]);
      if (to + length > size || way > to) throw new Error('damaged');
      for (const end = to + length; to < end; ++to) result[to] = result[to - way];
    }
    if (at > input.length + 4) throw new Error('damaged');
  }
  if (to !== size) throw new Error('damaged');
  return result;
}

// Unpacks a file of `gzip -n`.
function unzipped(file) {
  return unpacked(file, 10, new DataView(file.buffer, file.byteOffset + file.length - 4).getUint32(0, true));
}

// Decodes an 8-bit PNG of RGB or grey to rows of RGBA. Not by a canvas, whose pixels some browsers
// change so that pages cannot recognise people by them. Calls take(y, rgba).
function readPng(file, take) {
  const at32 = at => new DataView(file.buffer, file.byteOffset).getUint32(at);
  const parts = [];
  let width = 0, height = 0, channels = 0;
  for (let at = 8; at + 12 <= file.length; at += 12 + at32(at)) {
    const type = String.fromCharCode(...file.subarray(at + 4, at + 8));
    if (type === 'IHDR') {
      [width, height] = [at32(at + 8), at32(at + 12)];
      channels = { 0: 1, 2: 3 }[file[at + 17]];
      if (file[at + 16] !== 8 || !channels || file[at + 20] !== 0) throw new Error('damaged');
    }
    if (type === 'IDAT') parts.push(file.subarray(at + 8, at + 8 + at32(at)));
  }
  const packed = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  parts.reduce((at, part) => { packed.set(part, at); return at + part.length; }, 0);
  const stride = width * channels, line = stride + 1;
  const raw = unpacked(packed, 2, line * height);
  const rgba = new Uint8Array(4 * width).fill(255);
  for (let y = 0; y < height; ++y) {
    const row = y * line + 1, filter = raw[row - 1], up = row - line;
    for (let k = 0; k < stride; ++k) {
      const a = k < channels ? 0 : raw[row + k - channels], b = y ? raw[up + k] : 0;
      if (filter === 1) raw[row + k] += a;
      else if (filter === 2) raw[row + k] += b;
      else if (filter === 3) raw[row + k] += (a + b) >> 1;
      else if (filter === 4) {
        const c = k < channels || !y ? 0 : raw[up + k - channels], p = a + b - c;
        const pa = Math.abs(p - a), pb = Math.abs(p - b), pc = Math.abs(p - c);
        raw[row + k] += pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
      }
    }
    for (let x = 0; x < width; ++x)
      for (let c = 0; c < 3; ++c) rgba[4 * x + c] = raw[row + x * channels + (channels < 3 ? 0 : c)];
    take(y, rgba);
  }
}

// Decodes a WebP by the browser: compressed content is not exact anyway.
async function readWebp(file, take) {
  const bitmap = await createImageBitmap(new Blob([file], { type: 'image/webp' }),
      { colorSpaceConversion: 'none', premultiplyAlpha: 'none' });
  const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
  const context = canvas.getContext('2d', { willReadFrequently: true });
  context.drawImage(bitmap, 0, 0);
  const { data, width, height } = context.getImageData(0, 0, bitmap.width, bitmap.height);
  for (let y = 0; y < height; ++y) take(y, data.subarray(4 * y * width, 4 * (y + 1) * width));
}

const DAMAGED = 'This page is damaged: its content is not what was written. Get the file again.';

// Makes an engine with the light fields of a page, still black.
function emptyEngine(data) {
  const engine = Engine.of(unzipped(fromBase64(data.engine)));
  const { hogels: [nx, ny], directions: [du, dv] } = data.session.display;
  engine.row = engine.c.hs_alloc(4 * nx) >>> 0;
  engine.setSession(data.session);
  for (let field = 0; field < data.hashes.length; ++field) engine.c.hs_field(field, nx, ny, du, dv);
  return engine;
}

// Returns what takes row y of a picture { field, u, v } of views side by side.
function takerOf(engine, data, { field, u, v }) {
  const nx = data.session.display.hogels[0];
  return (y, rgba) => {
    for (let view = 0; 4 * view * nx < rgba.length; ++view) {
      new Uint8Array(engine.memory.buffer, engine.row, 4 * nx).set(rgba.subarray(4 * view * nx, 4 * (view + 1) * nx));
      engine.c.hs_view_row(field, u + view, v, y, engine.row);
    }
  };
}

// Makes an engine with a page's exact content: `data` has the engine, the session, the hashes of light
// fields and pictures { field, u, v, base64 }.
function exactEngine(data, told = () => {}) {
  try {
    const engine = emptyEngine(data);
    data.pictures.forEach((picture, k) => {
      readPng(fromBase64(picture.base64), takerOf(engine, data, picture));
      told((k + 1) / data.pictures.length);
    });
    data.hashes.forEach((hash, field) => { if (engine.hash(field) !== hash) throw new Error(DAMAGED); });
    return engine;
  } catch (error) {
    const signs = [WebAssembly.CompileError, DOMException, RangeError];
    throw error.message === 'damaged' || signs.some(sign => error instanceof sign) ? new Error(DAMAGED) : error;
  }
}

async function engineWith(data, told = () => {}) {
  if (data.isExact) return exactEngine(data, told);
  const engine = emptyEngine(data);
  for (const [k, picture] of data.pictures.entries()) {
    await readWebp(fromBase64(picture.base64), takerOf(engine, data, picture));
    told((k + 1) / data.pictures.length);
  }
  return engine;
}
