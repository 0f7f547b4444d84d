// The overview, its filters, and which image is looked at.
(() => {
const { comparison, verdict, pictures, leftOut, curves, outcomes, explanations } = JSON.parse(byId('data').textContent);
const { images } = comparison;
const infoOf = Object.fromEntries(outcomes.map((info, order) => [info.name, { ...info, order }]));
const six = (v) => v === null || v === undefined ? '' : String(Number(v.toPrecision(6)));
const badge = (outcome) => make('span', { class: infoOf[outcome].passes ? 'good' : 'bad', title: infoOf[outcome].meaning }, outcome);
let current = -1;

byId('head').textContent = `${verdict}. Golden: ${comparison.golden}. Output: ${comparison.output}.` +
  (leftOut ? ` The values of ${leftOut} images are left out, which would have made this page too large.` : '');

const decided = (image) => image.decision || {};
const rows = images.map((image, index) => ({
  index, image, go: () => select(index),
  cells: [image.name, image.outcome, image.aov, image.frame || undefined, decided(image).value ?? undefined, decided(image).limit ?? undefined],
}));
const severity = (row) => infoOf[row.image.outcome].passes ? row.image.outcome === 'pass' ? 2 : 1 : 0;
rows.sort((a, b) => severity(a) - severity(b));
const named = (row) => {
  const { thumbnail } = pictures[row.index], button = make('button', { type: 'button' });
  if (thumbnail) button.append(make('img', { src: thumbnail, alt: '', loading: 'lazy', decoding: 'async' }));
  button.append(row.image.name);
  button.addEventListener('click', row.go);
  return button;
};
sortable(byId('images'), 'images', [{ name: 'image', show: named }, { name: 'outcome', show: (row) => badge(row.image.outcome) }, { name: 'aov' },
  { name: 'frame' }, { name: 'value', doc: 'of what decided', show: (row) => six(row.cells[4]) }, { name: 'limit', show: (row) => six(row.cells[5]) }], rows);
for (const row of rows) row.element.dataset.index = row.index;

// Filters: outcomes that are pressed (none: all), an AOV, and words of the name or the reason.
const pressed = new Set();
for (const [name, count] of Object.entries(comparison.counts)) {
  const here = images.filter((image) => image.outcome === name).length;
  if (here === 0) continue;
  const chip = make('button', { type: 'button', 'aria-pressed': 'false', 'data-outcome': name, title: infoOf[name].meaning }, badge(name), ` ${here}`);
  chip.addEventListener('click', () => {
    pressed.delete(name) || pressed.add(name);
    chip.setAttribute('aria-pressed', pressed.has(name));
    filter();
  });
  byId('outcomes').append(chip);
}
for (const aov of [...new Set(images.map((image) => image.aov))].sort()) if (aov) byId('aov').append(make('option', { value: aov }, aov));
function filter() {
  const aov = byId('aov').value, words = byId('text').value.toLowerCase().split(/\s+/);
  for (const row of rows) {
    const text = `${row.image.name} ${explanations[row.index]}`.toLowerCase();
    row.element.hidden = (pressed.size > 0 && !pressed.has(row.image.outcome)) || (aov !== '' && row.image.aov !== aov) ||
      !words.every((word) => text.includes(word));
  }
  const count = rows.filter((row) => !row.element.hidden).length;
  byId('shown').textContent = count === images.length ? `${count} images` : `${count} of ${images.length} images`;
}
byId('aov').addEventListener('change', filter);
byId('text').addEventListener('input', filter);
filter();

if (comparison.budgets) {
  showBudgets(comparison.budgets, (budget) => budget.unit, (frame) => {
    const index = frame > 0 ? images.findIndex((image) => image.frame === frame) : -1;
    return index >= 0 && (() => select(index));
  });
}

// One image.
async function select(index) {
  if (index === current) return;
  current = index;
  const image = images[index], known = pictures[index];
  for (const row of rows) {
    if (row.index !== index) row.element.removeAttribute('aria-current');
    else {
      row.element.setAttribute('aria-current', 'true');
      row.element.scrollIntoView({ block: 'nearest' });
    }
  }
  byId('image-title').replaceChildren(image.name, ' ', badge(image.outcome));
  byId('image-why').textContent = explanations[index];
  byId('figures').replaceChildren(...Object.entries(image.figures).map(([metric, value]) => make('tr', {},
    make('th', { scope: 'row' }, metric), make('td', {}, value === null ? 'infinite' : six(value)))),
    make('tr', {}, make('th', { scope: 'row' }, 'size'), make('td', {}, `${image.width} x ${image.height}, ${image.channels.join(' ')}`)));
  byId('worst').hidden = !image.worst;
  byId('thumbnail').hidden = !known.thumbnail || Boolean(known.golden || known.output);
  byId('thumbnail').src = known.thumbnail || 'data:,';
  byId('thumbnail').alt = known.thumbnail ? `thumbnail of ${image.name}` : '';
  delete byId('viewer').dataset.ready;
  const textOf = (name) => byId(`${name}-${index}`).textContent;
  const golden = known.golden ? await unpack(known.golden, textOf('golden')) : null;
  const output = known.output ? await unpack(known.output, textOf('output'), golden) : null;
  if (index !== current) return;  // another one was chosen in the meantime
  viewer.show(golden, output, known.view);
  byId('viewer').dataset.ready = index;
}

function step(by) {
  const shown = [...byId('images').querySelectorAll('tbody tr')].filter((row) => !row.hidden).map((row) => Number(row.dataset.index));
  if (shown.length === 0) return;
  const at = shown.indexOf(current);
  select(shown[at < 0 ? 0 : Math.max(0, Math.min(shown.length - 1, at + by))]);
}
const lookAtWorst = () => { if (current >= 0 && images[current].worst) viewer.look(...images[current].worst); };
byId('worst').addEventListener('click', lookAtWorst);

const keys = { ArrowDown: () => step(1), ArrowUp: () => step(-1), ArrowRight: () => step(1), ArrowLeft: () => step(-1), j: () => step(1), k: () => step(-1),
  s: viewer.swap, b: viewer.blink, l: viewer.slide, d: viewer.side, '+': () => viewer.zoomBy(2), '=': () => viewer.zoomBy(2), '-': () => viewer.zoomBy(.5),
  0: viewer.reset, w: lookAtWorst, '/': () => byId('text').focus() };
const moves = { ArrowDown: [0, 1], ArrowUp: [0, -1], ArrowRight: [1, 0], ArrowLeft: [-1, 0] };
document.addEventListener('keydown', (event) => {
  if (event.key === 'Escape' && event.target.blur) return event.target.blur();
  if (event.ctrlKey || event.altKey || event.metaKey || ['INPUT', 'SELECT'].includes(event.target.tagName)) return;
  const action = event.shiftKey && moves[event.key] ? () => viewer.moveCursor(...moves[event.key]) : keys[event.key];
  if (!action) return;
  event.preventDefault();
  action();
});

// Curves, statistics, commands, origin.
if (curves.length > 0) {
  const wanted = (images.find((image) => !infoOf[image.outcome].passes && image.decision) || {}).decision;
  const show = () => { byId('curves').innerHTML = curves[byId('metric').value].svg; };
  byId('metric').append(...curves.map((curve, i) => make('option', { value: i }, curve.metric)));
  byId('metric').value = Math.max(0, curves.findIndex((curve) => wanted && curve.metric === wanted.metric));
  byId('metric').addEventListener('change', show);
  byId('curves-part').hidden = false;
  show();
}
if (comparison.statistics.length > 0) {
  const list = comparison.statistics.map((s) => ({ s, cells: [s.column, s.outcome, s.frame || undefined, s.golden ?? undefined, s.output ?? undefined, s.tolerance ?? undefined, s.reason] }));
  sortable(byId('statistics'), 'statistics', [{ name: 'column' }, { name: 'outcome', show: (row) => badge(row.s.outcome) },
    ...['frame', 'golden', 'output', 'tolerance', 'reason'].map((name) => ({ name }))], list);
  byId('statistics-part').hidden = false;
}
for (const [id, title, command] of [['render', 'Render again', comparison.renderCommand], ['accept', 'Accept the output as golden', comparison.acceptCommand]]) {
  if (!command) continue;
  const code = make('code', { id: `command-${id}` }, command), button = make('button', { type: 'button', id: `copy-${id}` }, 'copy'), said = make('span', { role: 'status' });
  button.addEventListener('click', async () => {
    getSelection().selectAllChildren(code);  // for those whose browser does not let pages copy
    try {
      await navigator.clipboard.writeText(command);
      said.textContent = 'copied';
    } catch {
      said.textContent = 'selected: press Ctrl+C';
    }
  });
  byId('commands').append(make('div', { class: 'command' }, make('span', {}, title), code, button, said));
}
byId('origin').parentElement.hidden = !comparison.goldenFrom && !comparison.outputFrom && comparison.notes.length === 0;
byId('commands').hidden = !comparison.renderCommand && !comparison.acceptCommand;
const origins = ['goldenFrom', 'outputFrom'].filter((key) => comparison[key]);
byId('origin').append(...(origins.length === 0 ? [] : Object.keys(comparison[origins[0]]).map((name) => make('tr', {},
  make('th', { scope: 'row' }, name), ...origins.map((key) => make('td', {}, comparison[key][name]))))));
if (origins.length > 0) byId('origin').prepend(make('tr', {}, make('td'), ...origins.map((key) => make('th', { scope: 'col' }, key.replace('From', '')))));
byId('notes').append(...comparison.notes.map((note) => make('li', {}, note)));
if (comparison.foreignDevice) byId('notes').append(make('li', {}, 'Made by another device than the golden, and judged by the tolerance of that pair.'));
step(0);
})();
