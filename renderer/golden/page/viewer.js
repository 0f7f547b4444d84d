// Golden, output and difference, side by side or on top of each other, all at one place and scale.
const viewer = (() => {
const { palette } = JSON.parse(byId('data').textContent);
const panes = ['golden', 'output', 'difference'].map((name) => ({ name, figure: byId(`figure-${name}`), canvas: byId(`pane-${name}`) }));
const state = { golden: null, output: null, difference: null, view: null, canvases: {}, mode: 'side', showing: 'golden',
  split: .5, zoom: 1, x: 0, y: 0, width: 1, height: 1, cursor: null };
let blinking = 0;

const encode = (v) => v <= .0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - .055;
const decode = (v) => v <= .04045 ? v / 12.92 : ((v + .055) / 1.055) ** 2.4;
const clamp = (v, low, high) => Math.max(low, Math.min(high, v));
// As few digits as tell a float from its neighbours.
function places(v) {
  if (!Number.isFinite(v)) return String(v).replace('Infinity', 'inf').toLowerCase();
  const digits = [6, 7, 8].find((count) => Math.fround(Number(v.toPrecision(count))) === Math.fround(v)) || 9;
  return String(Number(v.toPrecision(digits)));
}

function paint(width, height, colorOf) {
  const canvas = make('canvas', { width, height }), context = canvas.getContext('2d');
  const image = context.createImageData(width, height);
  for (let p = 0; p < width * height; ++p) colorOf(p, image.data, 4 * p);
  context.putImageData(image, 0, 0);
  return canvas;
}

const displayOf = (picture, view) => paint(picture.width, picture.height, (p, data, at) => {
  let isNumber = true;
  for (let i = 0; i < 3; ++i) {
    const value = picture.values[Math.min(view.shown[i], picture.values.length - 1)][p];
    const share = clamp((value - view.low) / (view.high - view.low), 0, 1);
    isNumber = isNumber && !Number.isNaN(value);
    data[at + i] = Math.round(255 * (view.encoded ? encode(share) : share));
  }
  if (!isNumber) data.set([255, 0, 255], at);
  data[at + 3] = view.alpha < 0 || view.alpha >= picture.values.length ? 255 : Math.round(255 * clamp(picture.values[view.alpha][p], 0, 1));
});

const sameValue = (a, b) => a === b || (Number.isNaN(a) && Number.isNaN(b));

// The largest difference of a channel that both have, where both have the pixel.
function differenceOf(golden, output) {
  const width = Math.min(golden.width, output.width), height = Math.min(golden.height, output.height);
  const values = new Float32Array(width * height);
  golden.channels.forEach((channel, c) => {
    const other = output.values[output.channels.indexOf(channel)];
    if (!other) return;
    for (let y = 0, p = 0; y < height; ++y) {
      for (let x = 0; x < width; ++x, ++p) {
        const a = golden.values[c][y * golden.width + x], b = other[y * output.width + x];
        if (!sameValue(a, b)) values[p] = Math.max(values[p], Math.abs(a - b));  // NaN stays
      }
    }
  });
  return { width, height, values };
}

const scale = () => Number(byId('scale').value);

function heatColor(value, p, width, most) {
  const stripe = (p % width + Math.floor(p / width)) % 4 === 0;
  if (value === 0) return [0, 0, 0];
  if (Number.isNaN(value)) return [255, 0, 255];
  if (value > most) return stripe ? [120, 120, 120] : [255, 255, 255];
  return palette[Math.round(value / most * 255)];
}

function paintHeat() {
  const { difference } = state, most = scale();
  if (!difference) return;
  state.canvases.difference = paint(difference.width, difference.height, (p, data, at) => {
    data.set(heatColor(difference.values[p], p, difference.width, most), at);
    data[at + 3] = 255;
  });
  byId('legend-most').textContent = String(most);
  byId('legend').style.background = `linear-gradient(90deg, ${palette.filter((_, i) => i % 15 === 0).map((c) => `rgb(${c})`).join()})`;
}

function drawHistogram() {
  const { difference } = state, holder = byId('histogram');
  byId('histogram-part').hidden = !difference;
  if (!difference) return;
  // four bins a decade from 1e-6 on, the same for every picture
  const counts = new Map();
  let equal = 0, none = 0;
  for (const value of difference.values) {
    if (value === 0) ++equal;
    else if (!Number.isFinite(value)) ++none;
    else {
      const bin = Math.max(-24, Math.floor(4 * Math.log10(value) + 1e-6));
      counts.set(bin, (counts.get(bin) || 0) + 1);
    }
  }
  const first = -24, last = Math.max(0, ...counts.keys()), width = 640, height = 150, left = 44, bottom = 22;
  const most = Math.log10(Math.max(10, ...counts.values()));
  const x = (bin) => left + (bin - first) / (last + 1 - first) * (width - left);
  const y = (n) => height - bottom - Math.log10(Math.max(1, n)) / most * (height - bottom - 8);
  const svg = make('svg', { viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': 'histogram of differences' });
  for (let power = 0; power <= most; ++power) {
    svg.append(make('line', { x1: left, x2: width, y1: y(10 ** power), y2: y(10 ** power), class: 'grid' }),
      make('text', { x: left - 4, y: y(10 ** power) + 4, 'text-anchor': 'end' }, short(10 ** power)));
  }
  for (const [bin, pixels] of counts) {
    const level = y(pixels) - 2, bar = make('rect', { x: x(bin), y: level, width: x(bin + 1) - x(bin) - 1, height: height - bottom - level, class: 'bar' });
    bar.append(make('title', {}, `${(10 ** (bin / 4)).toPrecision(3)} to ${(10 ** ((bin + 1) / 4)).toPrecision(3)}: ${pixels} pixels`));
    svg.append(bar);
  }
  for (let bin = first; bin <= last; bin += 4) svg.append(make('text', { x: x(bin), y: height - 5, 'text-anchor': 'middle' }, `1e${bin / 4}`));
  holder.replaceChildren(svg);
  byId('histogram-figures').textContent = `${equal} of ${difference.values.length} pixels are equal` +
    (none ? `, ${none} are not finite` : '') + '. Height: pixels, logarithmic.';
}

function isFitted(canvas) {
  const ratio = window.devicePixelRatio || 1, width = Math.round(canvas.clientWidth * ratio), height = Math.round(canvas.clientHeight * ratio);
  if (canvas.width !== width) canvas.width = width;
  if (canvas.height !== height) canvas.height = height;
  return width > 0 && height > 0;
}

const fit = (canvas) => Math.min(canvas.clientWidth / state.width, canvas.clientHeight / state.height);
const zoomOf = (canvas) => fit(canvas) * state.zoom;
const left = (canvas) => canvas.clientWidth / 2 - state.x * zoomOf(canvas);
const top = (canvas) => canvas.clientHeight / 2 - state.y * zoomOf(canvas);

function drawPicture(context, canvas, name) {
  const picture = state.canvases[name], zoom = zoomOf(canvas);
  if (!picture) return;
  const box = [left(canvas), top(canvas), picture.width * zoom, picture.height * zoom];
  context.save();
  context.beginPath();
  context.rect(...box);
  context.clip();
  context.fillStyle = '#fff';
  context.fillRect(...box);
  context.fillStyle = '#c8c8c8';
  const step = 8, startX = Math.max(0, Math.floor(-box[0] / step)), startY = Math.max(0, Math.floor(-box[1] / step));
  for (let j = startY; j * step < box[3] && j * step + box[1] < canvas.clientHeight; ++j) {
    for (let i = startX; i * step < box[2] && i * step + box[0] < canvas.clientWidth; ++i) {
      if ((i + j) % 2) context.fillRect(box[0] + i * step, box[1] + j * step, step, step);
    }
  }
  context.imageSmoothingEnabled = zoom < 1;
  context.drawImage(picture, ...box);
  context.restore();
}

function draw() {
  const side = state.mode === 'side';
  for (const { name, figure, canvas } of panes) {
    const exists = name === 'difference' ? state.difference : name === 'output' && !side ? state.golden || state.output : state[name];
    figure.hidden = !exists || (name === 'golden' && !side);
    canvas.style.aspectRatio = `${state.width} / ${state.height}`;
  }
  for (const { name, canvas } of panes) {
    if (!isFitted(canvas)) continue;
    const context = canvas.getContext('2d'), ratio = window.devicePixelRatio || 1;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, canvas.clientWidth, canvas.clientHeight);
    if (name !== 'output' || side) {
      drawPicture(context, canvas, name);
    } else if (state.mode === 'slider') {
      const edge = state.split * canvas.clientWidth;
      for (const [which, from, to] of [['golden', 0, edge], ['output', edge, canvas.clientWidth]]) {
        context.save();
        context.beginPath();
        context.rect(from, 0, to - from, canvas.clientHeight);
        context.clip();
        drawPicture(context, canvas, which);
        context.restore();
      }
      context.fillStyle = '#e69f00';
      context.fillRect(edge - 1, 0, 2, canvas.clientHeight);
    } else {
      drawPicture(context, canvas, state.showing);
    }
    if (state.cursor) {
      const zoom = zoomOf(canvas), size = Math.max(zoom, 7), middle = (at) => (at + .5) * zoom;
      context.strokeStyle = '#000';
      context.lineWidth = 3;
      const box = [left(canvas) + middle(state.cursor[0]) - size / 2, top(canvas) + middle(state.cursor[1]) - size / 2, size, size];
      context.strokeRect(...box);
      context.strokeStyle = '#fff';
      context.lineWidth = 1;
      context.strokeRect(...box);
    }
  }
  byId('caption-output').textContent = side ? 'output' : state.mode === 'slider' ? 'golden | output' : state.showing;
  byId('split-part').hidden = state.mode !== 'slider';
  for (const button of document.querySelectorAll('[data-mode]')) button.setAttribute('aria-pressed', button.dataset.mode === state.mode);
  byId('viewer').dataset.showing = side ? 'all' : state.mode === 'slider' ? 'both' : state.showing;
  byId('zoom').textContent = `${Number(zoomOf(panes.map((p) => p.canvas).find((c) => c.clientWidth) || panes[0].canvas).toFixed(2))}x`;
}

// A row of values for each picture; linear and display values of colour, else what is stored.
function readOut() {
  const table = byId('readout');
  table.replaceChildren();
  byId('place').textContent = state.cursor ? `pixel ${state.cursor.join(', ')}` : '';
  if (!state.cursor) return;
  const [x, y] = state.cursor, names = [...new Set([...(state.golden || { channels: [] }).channels, ...(state.output || { channels: [] }).channels])];
  const row = (name, values) => make('tr', { 'data-row': name }, make('th', { scope: 'row' }, name), ...values.map((v) => make('td', {}, v === undefined ? '' : v)));
  const rows = [], stored = {};
  for (const which of ['golden', 'output']) {
    const picture = state[which];
    if (!picture || x >= picture.width || y >= picture.height) continue;
    stored[which] = names.map((name) => (picture.values[picture.channels.indexOf(name)] || [])[y * picture.width + x]);
    const shown = (convert) => names.map((name, c) => stored[which][c] === undefined ? undefined : convert(stored[which][c], name === 'A'));
    if (picture.display || state.view.encoded) {
      rows.push(row(`${which} linear`, shown((v, alpha) => places(picture.display && !alpha ? decode(v) : v))),
        row(`${which} display`, shown((v, alpha) => {
          const code = 255 * (picture.display || alpha ? v : encode(clamp(v, 0, 1)));
          return picture.type === 'u8' ? String(Math.round(code)) : String(Number(code.toFixed(2)));
        })));
    } else {
      rows.push(row(which, shown((v) => places(v))));
    }
  }
  if (stored.golden && stored.output) {
    rows.push(row('difference', names.map((_, c) => stored.golden[c] === undefined || stored.output[c] === undefined ? undefined :
      places(sameValue(stored.golden[c], stored.output[c]) ? 0 : Math.fround(stored.output[c] - stored.golden[c])))));
  }
  table.append(make('thead', {}, make('tr', {}, make('td'), ...names.map((name) => make('th', { scope: 'col' }, name)))), make('tbody', {}, ...rows));
}

function setCursor(x, y) {
  state.cursor = [clamp(x, 0, state.width - 1), clamp(y, 0, state.height - 1)];
  readOut();
  draw();
}

function zoomBy(factor, x = state.cursor ? state.cursor[0] + .5 : state.x, y = state.cursor ? state.cursor[1] + .5 : state.y) {
  const zoom = clamp(state.zoom * factor, 1, 256), change = state.zoom / zoom;
  state.x = zoom === 1 ? state.width / 2 : x + (state.x - x) * change;
  state.y = zoom === 1 ? state.height / 2 : y + (state.y - y) * change;
  state.zoom = zoom;
  draw();
}

function reset() {
  state.zoom = 1;
  state.x = state.width / 2;
  state.y = state.height / 2;
  draw();
}

function setMode(mode) {
  clearInterval(blinking);
  state.mode = mode;
  if (mode === 'blink') blinking = setInterval(swap, 500);
  draw();
}

function swap() {
  state.showing = state.showing === 'golden' ? 'output' : 'golden';
  draw();
}

for (const { canvas } of panes) {
  const at = (event) => {
    const box = canvas.getBoundingClientRect(), zoom = zoomOf(canvas);
    return [(event.clientX - box.left - left(canvas)) / zoom, (event.clientY - box.top - top(canvas)) / zoom];
  };
  let drag = null;
  canvas.addEventListener('pointerdown', (event) => {
    drag = at(event);
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener('pointerup', () => { drag = null; });
  canvas.addEventListener('pointermove', (event) => {
    const [x, y] = at(event);
    if (drag) {
      state.x += drag[0] - x;
      state.y += drag[1] - y;
      draw();
    } else if (x >= 0 && y >= 0 && x < state.width && y < state.height) {
      setCursor(Math.floor(x), Math.floor(y));
    }
  });
  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    zoomBy(event.deltaY < 0 ? 1.25 : .8, ...at(event));
  }, { passive: false });
}
for (const button of document.querySelectorAll('[data-mode]')) button.addEventListener('click', () => setMode(button.dataset.mode));
byId('split').addEventListener('input', () => { state.split = byId('split').value / 100; draw(); });
byId('scale').addEventListener('change', () => { paintHeat(); draw(); });
byId('zoom-in').addEventListener('click', () => zoomBy(2));
byId('zoom-out').addEventListener('click', () => zoomBy(.5));
byId('zoom-fit').addEventListener('click', reset);
new ResizeObserver(draw).observe(byId('panes'));

return {
  // golden, output: as unpack() gives them, either may be null
  show(golden, output, view) {
    const shape = golden || output;
    Object.assign(state, { golden, output, view, difference: golden && output ? differenceOf(golden, output) : null, canvases: {}, cursor: null });
    byId('panes').hidden = byId('tools').hidden = !shape;
    readOut();
    if (!shape) return drawHistogram();
    const [width, height] = [Math.max(golden ? golden.width : 0, output ? output.width : 0), Math.max(golden ? golden.height : 0, output ? output.height : 0)];
    const sameSize = width === state.width && height === state.height;  // then zoom and place stay
    Object.assign(state, { width, height });
    for (const which of ['golden', 'output']) if (state[which]) state.canvases[which] = displayOf(state[which], view);
    paintHeat();
    drawHistogram();
    sameSize && state.zoom > 1 ? draw() : reset();
  },
  swap() {
    if (state.mode === 'blink') setMode('swap');
    state.mode === 'swap' ? swap() : setMode('swap');
  },
  blink() { setMode(state.mode === 'blink' ? 'side' : 'blink'); },
  slide() { setMode(state.mode === 'slider' ? 'side' : 'slider'); },
  side() { setMode('side'); },
  zoomBy,
  reset,
  moveCursor(x, y) {
    const [fromX, fromY] = state.cursor || [Math.floor(state.width / 2), Math.floor(state.height / 2)];
    setCursor(fromX + x, fromY + y);
  },
  look(x, y) {
    state.zoom = Math.max(state.zoom, 8);
    state.x = x + .5;
    state.y = y + .5;
    setCursor(x, y);
  },
};
})();
