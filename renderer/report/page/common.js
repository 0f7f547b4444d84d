'use strict';
// What all pages use.
const byId = (id) => document.getElementById(id);

function make(name, attributes = {}, ...children) {
  const isSvg = ['svg', 'g', 'line', 'polyline', 'polygon', 'rect', 'text', 'title'].includes(name);
  const element = isSvg ? document.createElementNS('http://www.w3.org/2000/svg', name) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

const format = (value) => value === undefined ? '' :
  value.toLocaleString('en-US', { maximumFractionDigits: Math.abs(value) >= 1000 ? 0 : Math.abs(value) >= 10 ? 2 : 3 });
const short = (value) => value.toLocaleString('en-US', { notation: 'compact', maximumSignificantDigits: 3 });

function ticks(low, high, count) {
  const wanted = (high - low) / count || 1, power = 10 ** Math.floor(Math.log10(wanted));
  const step = [1, 2, 5, 10].map((f) => f * power).find((s) => s >= wanted);
  const list = [];
  for (let i = Math.floor(low / step); ; ++i) {
    list.push(i * step);
    if (i * step >= high && list.length > 1) return list;
  }
}

// columns: [{name, doc, show: row => node in place of the value}]; rows: [{go, cells: [value]}], which get their element;
// the first column names the row.
function sortable(holder, caption, columns, rows) {
  const body = make('tbody');
  const show = (list) => body.replaceChildren(...list.map((row) => row.element));
  for (const row of rows) {
    row.element = make('tr', {}, ...row.cells.map((cell, c) => {
      const td = make('td', { 'data-value': cell === undefined ? '' : cell });
      if (columns[c].show) {
        td.append(columns[c].show(row));
      } else if (c === 0 && row.go) {
        const button = make('button', { type: 'button' }, String(cell));
        button.addEventListener('click', row.go);
        td.append(button);
      } else {
        td.append(typeof cell === 'number' ? format(cell) : cell || '');
      }
      return td;
    }));
  }
  const heads = columns.map((column, c) => {
    const button = make('button', { type: 'button', title: column.doc || '' }, column.name);
    const th = make('th', { scope: 'col' }, button);
    button.addEventListener('click', () => {
      const order = th.getAttribute('aria-sort') === 'descending' || (c === 0 && !th.hasAttribute('aria-sort')) ? 1 : -1;
      for (const other of heads) other.removeAttribute('aria-sort');
      th.setAttribute('aria-sort', order > 0 ? 'ascending' : 'descending');
      const compare = (a, b) => a === undefined ? (b === undefined ? 0 : 1) : b === undefined ? -1 :
        order * (typeof a === 'number' ? a - b : a.localeCompare(b));
      show([...rows].sort((a, b) => compare(a.cells[c], b.cells[c])));
    });
    return th;
  });
  show(rows);
  holder.replaceChildren(make('table', { 'aria-label': caption }, make('thead', {}, make('tr', {}, ...heads)), body));
}

// Budgets and the worst frame of each. unitOf: budget => its unit; goTo: frame => what shows it, or nothing.
function showBudgets(budgets, unitOf, goTo) {
  const rows = budgets.map((budget) => {
    const least = budget.min !== undefined, limit = least ? budget.min : budget.max;
    const excess = least ? limit - budget.value : budget.value - limit;
    const share = limit > 0 ? ` (${(100 * excess / limit).toFixed(1)} %)` : '';
    const verdict = !budget.exceeded ? '\u2713 held' : budget.value === undefined ? '\u2717 no value' :
      `\u2717 ${least ? 'under' : 'over'} by ${format(excess)}${share}`;
    const frame = make('td'), go = goTo(budget.frame);
    if (go) {
      const button = make('button', { type: 'button' }, String(budget.frame));
      button.addEventListener('click', go);
      frame.append(button);
    } else if (budget.frame !== undefined) {
      frame.append(String(budget.frame));
    }
    return make('tr', { class: budget.exceeded ? 'exceeded' : '' }, make('td', {}, budget.name), make('td', { 'data-value': limit }, `at ${least ? 'least' : 'most'} ${format(limit)}`),
      make('td', { 'data-value': budget.value ?? '' }, format(budget.value)), frame, make('td', {}, budget.light || ''), make('td', { class: 'verdict' }, verdict),
      make('td', {}, unitOf(budget)));
  });
  byId('budgets').append(make('table', { 'aria-label': 'budgets' }, make('thead', {}, make('tr', {},
    ...['figure', 'limit', 'worst', 'frame', 'light', '', 'unit'].map((name) => make('th', { scope: 'col' }, name)))), make('tbody', {}, ...rows)));
  byId('budgets-part').hidden = false;
}
