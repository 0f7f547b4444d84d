(() => {
const { file, thumbnails, colors, dashes } = JSON.parse(document.getElementById('data').textContent);
const { frames, counters, quantities, summary } = file;
const numbers = frames.map((f) => f.frame);
const lights = Object.keys(summary.lights);
const color = (i) => colors[i % colors.length];
const dash = (i) => dashes[Math.floor(i / colors.length) % dashes.length];
const swatch = (i) => make('span', { class: 'swatch', style: dash(i) === 0 ? `background:${color(i)}` :
  `background:repeating-linear-gradient(90deg,${color(i)} 0 ${dash(i)}px,transparent 0 ${2 * dash(i)}px)` });
const valueOf = (place, name) => place && place.values[name];

// The cursor: one frame for the whole page.
const watchers = [];
let current = -1;
function go(index) {
  index = Math.max(0, Math.min(frames.length - 1, index));
  if (index === current || frames.length === 0) return;
  current = index;
  for (const watch of watchers) watch(index);
}

// Curves over the frames, or areas on top of each other. series: [{name, index, values: [number or undefined]}]
function chart(id, title, unit, doc, series, stacked) {
  const width = 900, height = 240, left = 60, right = 8, top = 8, bottom = 24;
  const sums = frames.map((_, f) => series.reduce((sum, s) => sum + (s.values[f] || 0), 0));
  const all = stacked ? sums : series.flatMap((s) => s.values).filter((v) => v !== undefined);
  const marks = ticks(Math.min(0, ...all), Math.max(0, ...all) || 1, 4);
  const low = marks[0], high = marks[marks.length - 1], first = numbers[0], last = numbers[numbers.length - 1];
  const x = (f) => last === first ? (left + width - right) / 2 : left + (numbers[f] - first) / (last - first) * (width - left - right);
  const y = (v) => height - bottom - (v - low) / (high - low) * (height - top - bottom);
  const svg = make('svg', { viewBox: `0 0 ${width} ${height}`, class: 'plot', tabindex: 0, role: 'img', id,
    'aria-label': `${title} over frames ${first} to ${last}; arrow keys choose a frame` });
  for (const mark of marks) {
    svg.append(make('line', { x1: left, x2: width - right, y1: y(mark), y2: y(mark), class: mark === 0 ? 'axis' : 'grid' }),
      make('text', { x: left - 6, y: y(mark) + 4, 'text-anchor': 'end' }, short(mark)));
  }
  const every = Math.ceil(numbers.length / 16);
  numbers.forEach((n, f) => {
    if (f % every === 0) svg.append(make('text', { x: x(f), y: height - 6, 'text-anchor': 'middle' }, String(n)));
  });
  const base = frames.map(() => 0);
  for (const s of series) {
    if (stacked) {
      const above = frames.map((_, f) => `${x(f)},${y(base[f] + (s.values[f] || 0))}`);
      const below = frames.map((_, f) => `${x(f)},${y(base[f])}`).reverse();
      if (frames.length === 1) {
        const h = y(base[0]) - y(base[0] + (s.values[0] || 0));
        svg.append(make('rect', { x: x(0) - 20, width: 40, y: y(base[0]) - h, height: h, fill: color(s.index) }));
      } else {
        svg.append(make('polygon', { points: above.concat(below).join(' '), fill: color(s.index), 'fill-opacity': dash(s.index) ? .55 : .9 }));
      }
      frames.forEach((_, f) => { base[f] += s.values[f] || 0; });
    } else {
      const points = s.values.map((v, f) => v === undefined ? null : `${x(f)},${y(v)}`).filter((p) => p);
      const only = points.length === 1 ? points[0].split(',').map(Number) : null;
      svg.append(make('polyline', { points: only ? `${only[0] - 6},${only[1]} ${only[0] + 6},${only[1]}` : points.join(' '), fill: 'none',
        stroke: color(s.index), 'stroke-width': 2, 'stroke-dasharray': dash(s.index) || 'none' }));
    }
  }
  const cursor = make('line', { y1: top, y2: height - bottom, class: 'cursor' });
  svg.append(cursor);
  watchers.push((f) => { cursor.setAttribute('x1', x(f)); cursor.setAttribute('x2', x(f)); });
  svg.addEventListener('pointermove', (event) => {
    const box = svg.getBoundingClientRect(), at = (event.clientX - box.left) / box.width * width;
    let nearest = 0;
    numbers.forEach((_, f) => { if (Math.abs(x(f) - at) < Math.abs(x(nearest) - at)) nearest = f; });
    go(nearest);
  });
  svg.addEventListener('keydown', (event) => {
    const to = { ArrowLeft: current - 1, ArrowRight: current + 1, Home: 0, End: frames.length - 1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    go(to);
  });
  const legend = make('ul', { class: 'legend' }, ...series.map((s) => make('li', {}, swatch(s.index), s.name)));
  byId('charts').append(make('section', {}, make('h2', {}, title, ' ', make('span', { class: 'unit' }, `(${unit})`)),
    make('p', { class: 'hint' }, doc), svg, ...(series.length > 1 ? [legend] : [])));
}

function lightChart(name) {
  const whole = frames.map((f) => valueOf(f, name));
  const series = lights.map((light, index) => ({ name: light, index, values: frames.map((f) => valueOf(f.lights && f.lights[light], name)) }))
    .filter((s) => s.values.some((v) => v !== undefined));
  if (series.length === 0 && whole.some((v) => v !== undefined)) series.push({ name: 'frame', index: 0, values: whole });
  if (series.length > 0) chart('chart-' + name.replace(/\./g, '-'), name, counters[name].unit, counters[name].doc, series, false);
}

const named = Object.keys(counters);
const used = (places) => named.filter((name) => places.some((place) => valueOf(place, name) !== undefined));
const column = (name) => ({ name, doc: `${counters[name].doc} (${counters[name].unit})` });

// Time, stacked; what the whole frame took is no part of it.
const times = used(frames).filter((name) => counters[name].group === 'time' && name !== 'time.frame');
if (times.length > 0) {
  chart('chart-time', 'Time of each pass', counters[times[0]].unit, `Stacked. ${file.clock || ''}`,
    times.map((name, index) => ({ name, index, values: frames.map((f) => valueOf(f, name)) })), true);
}
for (const name of ['overdraw.fragments', 'overdraw.updates', 'edges.silhouette']) if (counters[name]) lightChart(name);

// The frame at the cursor.
const lightColumns = ['overdraw.fragments', 'overdraw.updates', 'edges.silhouette'].filter((n) => counters[n]);
function distributionsOf(f) {
  const list = Object.entries(frames[f].distributions || {}).map(([name, d]) => ({ key: name, name, d }));
  for (const light of lights) {
    const place = frames[f].lights && frames[f].lights[light];
    for (const [name, d] of Object.entries((place && place.distributions) || {})) list.push({ key: `${name} ${light}`, name, d });
  }
  return list;
}

function drawHistogram() {
  const list = distributionsOf(current), select = byId('quantity');
  byId('histogram-part').hidden = list.length === 0;
  if (list.length === 0) return;
  const chosen = list.find((entry) => entry.key === select.value) || list[0];
  select.replaceChildren(...list.map((entry) => make('option', { value: entry.key }, entry.key)));
  select.value = chosen.key;
  const { histogram } = chosen.d, width = 360, height = 150, bottom = 20, left = 40;
  const widthOf = (start) => start < 256 ? 1 : 2 ** (Math.floor(Math.log2(start)) - 7);
  const last = Math.max(8, ...histogram.map(([start]) => start + widthOf(start)));
  const most = Math.log10(Math.max(10, ...histogram.map(([start, pixels]) => pixels / widthOf(start))));
  const x = (v) => left + v / last * (width - left), y = (n) => height - bottom - Math.log10(Math.max(1, n)) / most * (height - bottom - 8);
  const svg = make('svg', { viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': `histogram of ${chosen.key}` });
  for (let power = 0; power <= most; ++power) {
    svg.append(make('line', { x1: left, x2: width, y1: y(10 ** power), y2: y(10 ** power), class: 'grid' }),
      make('text', { x: left - 4, y: y(10 ** power) + 4, 'text-anchor': 'end' }, short(10 ** power)));
  }
  for (const [start, pixels] of histogram) {
    const span = widthOf(start), level = y(pixels / span) - 2, room = x(start + span) - x(start);
    const bar = make('rect', { x: x(start), width: room > 4 ? room - 1 : room + .1, y: level, height: height - bottom - level, class: 'bar' });
    bar.append(make('title', {}, span === 1 ? `${start}: ${pixels} pixels` : `${start} to ${start + span}: ${pixels} pixels`));
    svg.append(bar);
  }
  for (const mark of ticks(0, last, 5)) {
    if (mark < last) svg.append(make('text', { x: x(mark), y: height - 4, 'text-anchor': 'middle' }, short(mark)));
  }
  byId('histogram').replaceChildren(svg);
  byId('histogram-figures').textContent = ['mean', 'p50', 'p95', 'p99', 'max'].map((f) => `${f} ${format(chosen.d[f])}`).join(', ') +
    `; ${quantities[chosen.name].unit}. Height: pixels for each whole value, logarithmic`;
}
byId('quantity').addEventListener('change', drawHistogram);

watchers.push((f) => {
  const frame = frames[f];
  byId('frame-title').textContent = `Frame ${frame.frame}`;
  const image = byId('thumbnail'), source = thumbnails[frame.frame];
  image.hidden = !source;
  if (source) image.src = source;
  image.alt = source ? `frame ${frame.frame}` : '';
  const rows = lights.map((light, index) => [light, index, frame.lights && frame.lights[light]]).filter(([, , place]) => place);
  const present = lightColumns.filter((name) => rows.some(([, , place]) => valueOf(place, name) !== undefined));
  byId('frame-lights').replaceChildren(...(present.length === 0 ? [] : [make('table', { 'aria-label': 'lights of the frame' },
    make('thead', {}, make('tr', {}, make('th', {}, 'light'), ...present.map((n) => make('th', { scope: 'col', title: n }, n.split('.')[1])))),
    make('tbody', {}, ...rows.map(([light, index, place]) => make('tr', {}, make('td', { title: light }, swatch(index), light),
      ...present.map((n) => make('td', { 'data-value': valueOf(place, n) ?? '' }, format(valueOf(place, n))))))))]));
  byId('frame-values').replaceChildren(make('table', { 'aria-label': 'values of the frame' }, make('tbody', {},
    ...used([frame]).map((name) => make('tr', {}, make('td', { title: counters[name].doc }, name),
      make('td', { 'data-counter': name, 'data-value': valueOf(frame, name) }, format(valueOf(frame, name))), make('td', {}, counters[name].unit))))));
  drawHistogram();
});

// Tables.
const frameColumns = used(frames);
const frameRows = frames.map((frame, f) => ({ go: () => go(f), cells: [frame.frame, ...frameColumns.map((n) => valueOf(frame, n))] }));
sortable(byId('frames'), 'frames', [{ name: 'frame' }, ...frameColumns.map(column)], frameRows);
watchers.push((f) => frameRows.forEach((row, i) => row.element.classList.toggle('current', i === f)));

const sumOf = (name, entry) => entry === undefined ? undefined :
  counters[name].combine === 'sum' ? entry.total : counters[name].combine === 'largest' ? entry.max : entry.mean;
if (lights.length > 0) {
  const columns = used(lights.map((light) => summary.lights[light]));
  sortable(byId('lights'), 'lights', [{ name: 'light' }, ...columns.map(column)],
    lights.map((light) => ({ cells: [light, ...columns.map((n) => sumOf(n, summary.lights[light].values[n]))] })));
  byId('lights-part').hidden = false;
}
if (summary.topCasters.length > 0) {
  const rows = summary.topCasters.map((top) => make('tr', {}, make('td', {}, top.caster),
    make('td', { 'data-value': top['overdraw.fragments'] }, format(top['overdraw.fragments'])), make('td', {}, `${(100 * top.share).toFixed(1)} %`),
    make('td', { style: 'text-align:left' }, make('span', { class: 'share', style: `width:${(12 * top.share).toFixed(2)}rem` }))));
  byId('casters').append(make('table', { 'aria-label': 'casters' }, make('thead', {}, make('tr', {},
    ...['caster', 'overdraw.fragments', 'share', ''].map((name) => make('th', { scope: 'col' }, name)))), make('tbody', {}, ...rows)));
  byId('casters-part').hidden = false;
}

if (file.budgets) {
  showBudgets(file.budgets, ({ name }) => (counters[name] || quantities[name.slice(0, name.lastIndexOf('.'))]).unit,
    (frame) => numbers.includes(frame) && (() => go(numbers.indexOf(frame))));
}

byId('head').textContent = [file.device, file.version && `umbrage ${file.version}`,
  frames.length === 1 ? '1 frame' : `${frames.length} frames`, file.clock].filter((text) => text).join(' · ');
let group = '';
for (const name of named) {
  if (counters[name].group !== group) byId('terms').append(make('dt', { class: 'group' }, group = counters[name].group));
  byId('terms').append(make('dt', {}, name), make('dd', {}, `${counters[name].doc} (${counters[name].unit})`));
}
byId('terms').append(make('dt', { class: 'group' }, 'pixels'));
for (const [name, q] of Object.entries(quantities)) byId('terms').append(make('dt', {}, name), make('dd', {}, `${q.doc} (${q.unit})`));
go(0);
})();
