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
