// SPDX-License-Identifier: Apache-2.0
// The page of `alidade stress`: tables, plots of what a cost is at each size (both axes logarithmic), bars where there is one size.

const COLORS = 6;

/// What a peer is called, and how it is drawn: a colour for each accelerator, dashes for double.
const peers = [];
for (const scene of data.scenes) {
  for (const size of scene.sizes) {
    for (const one of size.structures || []) {
      if (!peers.some((peer) => peer.name === one.accelerator && peer.precision === one.precision)) peers.push({name: one.accelerator, precision: one.precision, hidden: false});
    }
  }
}
const accelerators = [...new Set(peers.map((peer) => peer.name))];
for (const peer of peers) {
  peer.color = `var(--s${accelerators.indexOf(peer.name) % COLORS})`;
  peer.dashed = peer.precision === 'double';
  peer.label = peer.name + ' ' + peer.precision;
}
const peerOf = (one) => peers.find((peer) => peer.name === one.accelerator && peer.precision === one.precision);

// ---- plots

const BOX = {left: 62, top: 12, width: 400, height: 230};

/// The powers of ten around [low, high]; where there is less than one decade, 2 and 5 times them too.
function ticksOf(low, high) {
  const ticks = [], dense = high / low < 30;
  for (let e = Math.floor(Math.log10(low)); e <= Math.ceil(Math.log10(high)); ++e)
    for (const m of dense ? [1, 2, 5] : [1]) ticks.push(m * 10 ** e);
  const from = ticks.filter((tick) => tick <= low * 1.0001).pop(), to = ticks.find((tick) => tick >= high * 0.9999);
  return ticks.filter((tick) => tick >= from && tick <= to);
}

/// A logarithmic axis over `values`: its ends, ticks, and where a value lies between 0 and 1.
function axisOf(values) {
  let ticks = ticksOf(Math.min(...values), Math.max(...values));
  if (ticks.length < 2) ticks = [ticks[0] / 2, ticks[0], ticks[0] * 2];
  const low = Math.log10(ticks[0]), high = Math.log10(ticks[ticks.length - 1]);
  return {ticks, at: (value) => (Math.log10(value) - low) / (high - low)};
}

/// `series`: [{peer, points: [{x, y}]}], all positive. `unit` of y.
class Plot {
  constructor(title, unit, series) {
    this.title = title;
    this.unit = unit;
    this.series = series;
    const points = series.flatMap((one) => one.points);
    const x = axisOf(points.map((point) => point.x)), y = axisOf(points.map((point) => point.y));
    this.place = (point) => [BOX.left + BOX.width * x.at(point.x), BOX.top + BOX.height * (1 - y.at(point.y))];
    this.output = of('output', {'aria-live': 'polite'}, 'Point at a line, or use the arrow keys.');
    this.svg = of('svg', {viewBox: `0 0 ${BOX.left + BOX.width + 24} ${BOX.top + BOX.height + 40}`, width: BOX.left + BOX.width + 24, height: BOX.top + BOX.height + 40, tabindex: 0,
      role: 'img', 'aria-label': `${title}, ${unit}, by number of triangles; both axes logarithmic`, onpointermove: (event) => this.moved(event), onkeydown: (event) => this.key(event)});
    for (const tick of x.ticks) {
      const at = BOX.left + BOX.width * x.at(tick);
      this.svg.append(of('line', {x1: at, x2: at, y1: BOX.top, y2: BOX.top + BOX.height}), of('text', {x: at, y: BOX.top + BOX.height + 16, 'text-anchor': 'middle'}, brief(tick)));
    }
    for (const tick of y.ticks) {
      const at = BOX.top + BOX.height * (1 - y.at(tick));
      this.svg.append(of('line', {x1: BOX.left, x2: BOX.left + BOX.width, y1: at, y2: at}), of('text', {x: BOX.left - 6, y: at + 4, 'text-anchor': 'end'}, brief(tick)));
    }
    this.svg.append(of('text', {x: BOX.left + BOX.width / 2, y: BOX.top + BOX.height + 34, 'text-anchor': 'middle'}, 'triangles'));
    for (const one of series) this.svg.append(this.drawn(one));
    this.element = of('figure', {class: 'plot', 'data-title': title}, of('figcaption', {}, of('strong', {}, title), ' ', of('span', {class: 'quiet'}, unit)), this.svg, this.output);
    this.update();
  }

  drawn(one) {
    const places = one.points.map((point) => this.place(point));
    one.circles = places.map(([cx, cy], i) => of('circle', {cx, cy, r: 4, 'data-x': one.points[i].x, 'data-y': one.points[i].y}));
    one.group = of('g', {class: 'series', style: `--color:${one.peer.color}`, 'data-peer': one.peer.label},
      of('path', {class: one.peer.dashed ? 'dashed' : null, d: 'M' + places.map((place) => place.join(' ')).join('L')}), ...one.circles);
    return one.group;
  }

  update() {
    for (const one of this.series) one.group.style.display = one.peer.hidden ? 'none' : '';
  }

  shown() {
    return this.series.filter((one) => !one.peer.hidden);
  }

  /// The nearest point is told.
  moved(event) {
    const box = this.svg.getBoundingClientRect(), scale = (BOX.left + BOX.width + 24) / box.width;
    const x = (event.clientX - box.left) * scale, y = (event.clientY - box.top) * scale;
    let best = null;
    for (const one of this.shown()) {
      one.points.forEach((point, i) => {
        const [px, py] = this.place(point), distance = (px - x) ** 2 + (py - y) ** 2;
        if (!best || distance < best.distance) best = {one, i, distance};
      });
    }
    if (best) this.tell(best.one, best.i);
  }

  key(event) {
    const shown = this.shown();
    if (!['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown'].includes(event.key) || shown.length === 0) return;
    event.preventDefault();
    if (!this.at || !shown.includes(this.at.one)) return this.tell(shown[0], 0);
    const turn = {ArrowUp: -1, ArrowDown: 1}[event.key] || 0, step = {ArrowLeft: -1, ArrowRight: 1}[event.key] || 0;
    const one = shown[(shown.indexOf(this.at.one) + turn + shown.length) % shown.length];
    this.tell(one, Math.min(Math.max(this.at.i + step, 0), one.points.length - 1));
  }

  tell(one, i) {
    if (this.at) this.at.one.circles[this.at.i].classList.remove('at');
    this.at = {one, i};
    one.circles[i].classList.add('at');
    this.output.textContent = `${one.peer.label}, ${one.points[i].x} triangles: ${brief(one.points[i].y)} ${this.unit}`;
  }
}

/// What is plotted: a title, a unit, and its value for a peer at a size (undefined: there is none).
function costsOf(scene) {
  const costs = [['Build', 's', (size, one) => one.build_seconds.median], ['Memory', 'bytes a triangle', (size, one) => one.bytes / size.triangles],
    ['Peak memory', 'bytes a triangle', (size, one) => (one.peak_bytes === null ? undefined : one.peak_bytes / size.triangles)]];
  const kinds = [...new Set(scene.sizes.flatMap((size) => (size.structures || []).flatMap((one) => (one.rays || []).map((rays) => rays.rays))))];
  const found = (one, kind) => (one.rays || []).find((rays) => rays.rays === kind && rays.left_out === undefined);
  for (const kind of kinds) {
    costs.push([`Time of a ray: ${kind}`, 'microseconds', (size, one) => (found(one, kind) ? 1e6 / found(one, kind).rays_per_second : undefined)]);
    costs.push([`Tests of a ray: ${kind}`, 'boxes and triangles', (size, one) => (found(one, kind) && found(one, kind).boxes !== null ? found(one, kind).boxes + found(one, kind).triangles : undefined)]);
  }
  return costs;
}

function seriesOf(scene, cost) {
  return peers.map((peer) => ({peer, points: scene.sizes.flatMap((size) => {
    const one = (size.structures || []).find((each) => peerOf(each) === peer && each.left_out === undefined), y = one ? cost(size, one) : undefined;
    return y > 0 ? [{x: size.triangles, y}] : [];
  })})).filter((one) => one.points.length > 0);
}

// ---- bars

function bars(title, unit, rows) {
  const widest = Math.max(...rows.map((row) => row.value)), height = 20, left = 130, width = 340;
  const svg = of('svg', {viewBox: `0 0 ${left + width + 80} ${rows.length * height + 4}`, width: left + width + 80, height: rows.length * height + 4, role: 'img', 'aria-label': `${title}, ${unit}`});
  rows.forEach((row, i) => {
    const length = Math.max(1, width * row.value / widest), y = i * height;
    svg.append(of('text', {x: left - 6, y: y + 14, 'text-anchor': 'end'}, row.peer.label),
      of('rect', {class: 'bar', style: `--color:${row.peer.color}`, x: left, y: y + 3, width: length, height: height - 6, 'data-peer': row.peer.label, 'data-value': row.value}, of('title', {}, `${row.peer.label}: ${brief(row.value)} ${unit}`)),
      of('text', {x: left + length + 6, y: y + 14}, brief(row.value)));
  });
  return of('figure', {class: 'plot bars', 'data-title': title}, of('figcaption', {}, of('strong', {}, title), ' ', of('span', {class: 'quiet'}, unit)), svg);
}

// ---- tables

function table(caption, columns, rows, id) {
  return of('div', {class: 'scroll'}, of('table', {id}, of('caption', {}, caption), of('thead', {}, of('tr', {}, ...columns.map(([name, , text]) => of('th', {scope: 'col', class: text ? null : 'number'}, name)))),
    of('tbody', {}, ...rows.map((row) => of('tr', {}, ...columns.map(([, value, text]) => {
      const cell = value(row);
      return text ? of('td', {}, String(cell)) : cell === null || cell === undefined ? of('td', {class: 'number'}, '\u2013') : numberCell(cell);
    }))))));
}

const STRUCTURE = [['accelerator', (one) => one.accelerator, true], ['precision', (one) => one.precision, true], ['build s', (one) => one.build_seconds.median],
  ['bytes a triangle', (one, size) => one.bytes / one.size.triangles], ['peak bytes a triangle', (one) => (one.peak_bytes === null ? null : one.peak_bytes / one.size.triangles)],
  ['nodes', (one) => one.nodes], ['depth', (one) => one.depth], ['SAH cost', (one) => one.sah_cost]];
const RAYS = [['rays', (one) => one.rays, true], ['accelerator', (one) => one.peer.accelerator, true], ['precision', (one) => one.peer.precision, true], ['rays/s', (one) => one.rays_per_second],
  ['hit', (one) => one.hits / one.count], ['boxes', (one) => one.boxes], ['triangles', (one) => one.triangles], ['decided', (one) => one.decided], ['unlike', (one) => one.unlike], ['hash', (one) => one.hash, true]];
// What the processor counted of a ray: columns where it did.
const EVENTS = ['instructions', 'cycles', 'cache_misses', 'branch_misses'].map((name) => [name.replace('_', ' '), (one) => one.counted[name]]);
const GROWTH = [['accelerator', (one) => one.accelerator, true], ['precision', (one) => one.precision, true], ['cost', (one) => one.cost, true], ['exponent', (one) => one.exponent],
  ['standard error', (one) => one.error], ['sizes', (one) => one.points]];

function omissions(size) {
  const lines = (size.structures || []).flatMap((one) => (one.left_out !== undefined ? [`${one.accelerator} in ${one.precision}: ${one.left_out}`]
    : one.rays.filter((rays) => rays.left_out !== undefined).map((rays) => `${one.accelerator} in ${one.precision}, ${rays.rays} rays: ${rays.left_out}`)));
  if (size.left_out !== undefined) lines.push(size.left_out);
  return lines.length === 0 ? null : of('div', {class: 'omitted'}, of('p', {}, of('strong', {}, 'Left out')), of('ul', {class: 'left-out'}, ...lines.map((line) => of('li', {}, line))));
}

function verdict(size) {
  if (!size.structures) return null;
  const asked = size.brute_force.map((one) => `${one.count} ${one.rays} in ${one.precision}`).join(', ');
  const wrong = size.disagreements.map((one) => of('p', {class: 'fail wrong'}, '\u2717 ' + one.sentence));
  return of('div', {class: 'agreement'}, ...wrong, of('p', {class: wrong.length ? 'fail' : 'pass'}, `${wrong.length ? '\u2717 they do not agree' : '\u2713 all agree'}; brute force was asked ${asked || 'no'} rays`));
}

function sizePart(size) {
  const built = (size.structures || []).filter((one) => one.left_out === undefined).map((one) => ({...one, size}));
  const rays = built.flatMap((one) => one.rays.filter((each) => each.left_out === undefined).map((each) => ({...each, peer: one})));
  const order = [...new Set(rays.map((one) => one.rays))];
  rays.sort((a, b) => order.indexOf(a.rays) - order.indexOf(b.rays));
  return of('div', {}, verdict(size), omissions(size), built.length ? table('Structures', STRUCTURE, built, null) : null, rays.length ? table('Rays', RAYS.concat(EVENTS.filter(([, value]) => rays.some((one) => value(one) !== null))), rays, null) : null);
}

function sizeTitle(size) {
  if (size.triangles === undefined) return `${size.asked} triangles`;
  return `${size.triangles} triangles` + (size.places ? ` in ${size.places} places: ${size.placed_triangles} in all` : '');
}

// ---- the page

const plots = [];

function legend() {
  const mark = (peer) => of('svg', {width: 30, height: 10, style: `--color:${peer.color}`, 'aria-hidden': 'true', class: 'plot'}, of('path', {class: peer.dashed ? 'dashed' : null, d: 'M0 5L30 5', style: 'stroke:currentColor;stroke-width:2'}));
  return of('fieldset', {id: 'legend'}, of('legend', {}, 'Shown'), ...peers.map((peer) => of('label', {class: 'key', style: `--color:${peer.color}`},
    of('input', {type: 'checkbox', checked: '', 'data-peer': peer.label, onchange: (event) => { peer.hidden = !event.target.checked; plots.forEach((plot) => plot.update()); }}), mark(peer), peer.label)));
}

function scenePart(scene) {
  const measured = scene.sizes.filter((size) => size.structures), costs = costsOf(scene), figures = [];
  for (const [title, unit, cost] of costs) {
    const series = seriesOf(scene, cost);
    if (series.length === 0) continue;
    if (measured.length > 1) {
      plots.push(new Plot(title, unit, series));
      figures.push(plots[plots.length - 1].element);
    } else {
      figures.push(bars(title, unit, series.map((one) => ({peer: one.peer, value: one.points[0].y}))));
    }
  }
  const heading = of('h2', {}, scene.name, scene.kind === null ? '' : of('span', {class: 'quiet'}, ` seed ${scene.seed}`));
  const tables = scene.sizes.map((size) => (scene.sizes.length > 1 ? of('details', {}, of('summary', {}, sizeTitle(size)), sizePart(size)) : of('div', {}, of('p', {}, sizeTitle(size)), sizePart(size))));
  return of('section', {class: 'scene', 'aria-label': scene.name}, heading, of('div', {class: 'plots'}, ...figures),
    scene.growth.length ? table('Growth: cost ~ triangles ^ exponent', GROWTH, scene.growth, 'growth') : null, ...tables);
}

const machine = of('p', {class: 'quiet', id: 'machine'}, `${data.machine.processor}, ${data.machine.processors} processors; alidade ${data.alidade}; ${data.rounds} rounds; CPU time of one thread`);
const messages = (data.messages || []).map((one) => of('p', {class: 'quiet'}, one.message));
byId('main').replaceChildren(machine, of('pre', {id: 'commands'}, data.command), ...messages, ...(peers.length ? [legend()] : []), ...data.scenes.map(scenePart));
document.documentElement.dataset.ready = 'stress';
