// SPDX-License-Identifier: Apache-2.0
// The page of `alidade tradeoff`; elements.js stands before it.
const rows = data.rows;
const make = (parent, name, text, attributes = {}) => parent.appendChild(of(name, attributes, text));
byId('main').append(
  of('p', {id: 'reference'}),
  of('div', {id: 'view'},
    of('div', {id: 'stage'}, of('svg', {id: 'plot', viewBox: '0 0 900 520', role: 'group', 'aria-label': 'Error over cost, both logarithmic'})),
    of('aside', {id: 'details', 'aria-live': 'polite'}, of('p', {class: 'quiet'}, 'Point at a setting, or go to it with the Tab key.'))),
  of('p', {id: 'legend', class: 'quiet'}), of('ul', {id: 'recommended'}), of('ul', {id: 'complaints'}),
  of('table', {}, of('thead', {}, of('tr', {id: 'heads'})), of('tbody', {id: 'rows'})));
const number = value => value === null || value === undefined ? '-' : brief(value);
const errorOf = row => row.errors[data.metric];

// ---- The plot: both axes logarithmic; an error of 0 stands on the floor ----
const box = {left: 80, right: 880, top: 20, bottom: 460};
const shown = rows.map((row, i) => i).filter(i => errorOf(rows[i]) !== undefined && errorOf(rows[i]) !== null && rows[i].cpu_seconds !== null);
const costOf = row => Math.max(row.cpu_seconds, 1e-6);
const positive = shown.map(i => errorOf(rows[i])).filter(error => error > 0);
const range = values => {
  const low = Math.log10(Math.min(...values)), high = Math.log10(Math.max(...values)), room = Math.max(0.08 * (high - low), 0.08);
  return [low - room, high + room];
};
const [x0, x1] = range(shown.length ? shown.map(i => costOf(rows[i])) : [1]);
let [y0, y1] = range(positive.length ? positive : [1]);
const zero = positive.length < shown.length;
if (zero) y0 -= 0.1 * (y1 - y0);
const x = cost => box.left + (Math.log10(Math.max(cost, 1e-6)) - x0) / (x1 - x0) * (box.right - box.left);
const y = error => error > 0 ? box.bottom - (Math.log10(error) - y0) / (y1 - y0) * (box.bottom - box.top) : box.bottom;

function ticks(low, high) {
  const out = [];
  for (let decade = Math.floor(low); decade <= high; ++decade)
    for (const factor of high - low > 3 ? [1] : [1, 2, 5])
      if (Math.log10(factor) + decade >= low && Math.log10(factor) + decade <= high) out.push(Number(`${factor}e${decade}`));
  return out;
}

function drawAxes(plot) {
  for (const value of ticks(x0, x1)) {
    make(plot, 'line', null, {class: 'grid', x1: x(value), x2: x(value), y1: box.top, y2: box.bottom});
    make(plot, 'text', String(value), {x: x(value), y: box.bottom + 18, 'text-anchor': 'middle'});
  }
  for (const value of ticks(y0, y1)) {
    make(plot, 'line', null, {class: 'grid', x1: box.left, x2: box.right, y1: y(value), y2: y(value)});
    make(plot, 'text', String(value), {x: box.left - 8, y: y(value) + 4, 'text-anchor': 'end'});
  }
  if (zero) make(plot, 'text', '0', {x: box.left - 8, y: box.bottom + 4, 'text-anchor': 'end'});
  make(plot, 'text', 'CPU seconds', {x: (box.left + box.right) / 2, y: box.bottom + 42, 'text-anchor': 'middle'});
  make(plot, 'text', data.metric, {x: 18, y: (box.top + box.bottom) / 2, 'text-anchor': 'middle', transform: `rotate(-90 18 ${(box.top + box.bottom) / 2})`});
  const own = data.reference.own_error[data.metric];
  if (own > 0 && y(own) < box.bottom && y(own) > box.top) make(plot, 'line', null, {class: 'own', x1: box.left, x2: box.right, y1: y(own), y2: y(own)});
}

function drawPoint(plot, i) {
  const row = rows[i], at = {x: x(row.cpu_seconds), y: y(errorOf(row))};
  const inside = place => Math.min(Math.max(place, box.left), box.right);
  make(plot, 'line', null, {class: 'spread', x1: inside(x(row.cpu_seconds - row.cpu_seconds_mad)), x2: inside(x(row.cpu_seconds + row.cpu_seconds_mad)), y1: at.y, y2: at.y});
  const other = row.program !== 'alidade';
  const names = 'point' + (row.front ? ' front' : '') + (other ? ' other' : '');
  const common = {class: names, tabindex: 0, role: 'img', 'data-row': i, 'aria-label': `${row.name}: ${number(row.cpu_seconds)} s, ${data.metric} ${number(errorOf(row))}`};
  const point = other ? make(plot, 'rect', null, {x: at.x - 6, y: at.y - 6, width: 12, height: 12, ...common}) : make(plot, 'circle', null, {cx: at.x, cy: at.y, r: 7, ...common});
  for (const event of ['mouseenter', 'focus', 'click']) point.addEventListener(event, () => choose(i));
}

function drawPlot() {
  const plot = byId('plot');
  drawAxes(plot);
  const front = shown.filter(i => rows[i].front).sort((a, b) => rows[a].cpu_seconds - rows[b].cpu_seconds);
  make(plot, 'polyline', null, {class: 'front-line', points: front.map(i => `${x(rows[i].cpu_seconds)},${y(errorOf(rows[i]))}`).join(' ')});
  for (const i of shown.filter(i => !rows[i].front)) drawPoint(plot, i);
  for (const i of front) drawPoint(plot, i);
}

// ---- One setting ----
function choose(i) {
  const row = rows[i], details = byId('details');
  for (const one of document.querySelectorAll('.chosen')) one.classList.remove('chosen');
  for (const one of document.querySelectorAll(`[data-row="${i}"]`)) one.classList.add('chosen');
  details.textContent = '';
  make(details, 'h2', row.name + (row.default && row.name !== 'default' ? ' (default)' : ''));
  for (const [what, image] of [['its picture', data.pictures[i].thumbnail], ['its FLIP error', data.pictures[i].flip]])
    if (image) make(details, 'img', null, {src: 'data:image/png;base64,' + image, alt: what});
  make(details, 'p', `${number(row.cpu_seconds)} s ± ${number(row.cpu_seconds_mad)}, ${number(row.times_default_cost)} of the default's` + (row.cost_differs_from_default === false ? ' (no difference)' : ''));
  make(details, 'p', Object.entries(row.errors).map(([name, value]) => `${name} ${number(value)}`).join(', ') + (row.within_reference_error ? ' (within the reference\'s own error)' : ''));
  if (row.noise) make(details, 'p', `bias² ${number(row.noise.bias2)}, variance ${number(row.noise.variance)}`);
  if (Object.keys(row.counts).length) make(details, 'p', Object.entries(row.counts).map(([name, value]) => `${name} ${value}`).join(', '));
  make(details, 'code', row.command);
}

// ---- Words ----
function drawText() {
  byId('reference').textContent = `${data.width} x ${data.height} pixels; reference: ${data.reference.what}`;
  byId('legend').textContent = 'Blue: the front. Grey: another setting is faster and no worse, or better and no slower. Squares: other programs. Dashed: the reference\'s own error.';
  const chosen = data.recommended, name = row => row === null ? 'none' : rows[row].name;
  make(byId('recommended'), 'li', `fastest with ${data.metric} <= ${number(chosen.error)}: ${name(chosen.fastest_within_error)}`);
  make(byId('recommended'), 'li', `best within ${number(chosen.cpu_seconds)} s: ${name(chosen.best_within_time)}`);
  make(byId('recommended'), 'li', `knee of the front: ${name(chosen.knee)}`);
  for (const text of [...data.not_free.map(each => each.sentence), ...data.warnings]) make(byId('complaints'), 'li', text);
}

function drawTable() {
  const counts = rows.some(row => row.counts.texture_reads > 0) ? {Mrays: 'rays', Mtexels: 'texture_reads'} : {Mrays: 'rays'};
  for (const head of ['', 'CPU s', '±', ...Object.keys(counts), ...Object.keys(rows[0].errors), 'setting']) make(byId('heads'), 'th', head);
  rows.map((row, i) => i).sort((a, b) => rows[a].cpu_seconds - rows[b].cpu_seconds).forEach(i => {
    const row = rows[i], line = make(byId('rows'), 'tr', null, {'data-row': i});
    const millions = Object.values(counts).map(name => number(row.counts[name] === undefined ? null : row.counts[name] / 1e6));
    for (const cell of [row.front ? '*' : '', number(row.cpu_seconds), number(row.cpu_seconds_mad), ...millions, ...Object.keys(rows[0].errors).map(name => number(row.errors[name]))]) make(line, 'td', cell);
    make(line, 'td', row.name + (row.default && row.name !== 'default' ? ' (default)' : ''));
    line.addEventListener('mouseenter', () => choose(i));
  });
}

drawText();
drawPlot();
drawTable();
document.documentElement.dataset.ready = 'yes';
