// SPDX-License-Identifier: Apache-2.0
// The report's page. The address says what is shown: #index, or #pair=0&mode=slider&zoom=8&pixel=3,4&split=0.5, so that a link leads to a pixel.
const pairs = data.pairs;

const MARKS = {pass: '\u2713', warn: '!', fail: '\u2717', incomparable: '\u2260', error: '\u2717'};
function verdictOf(pair) {
  const verdict = pair.document.verdict || '';
  return of('span', {class: 'verdict ' + verdict}, (MARKS[verdict] || '') + ' ' + verdict);
}

function metric(pair, name, number) {
  const numbers = (pair.document.metrics || {})[name];
  return numbers ? numbers[number] : undefined;
}

// ---- the colours of errors: the stops of --heatmap

const STOPS = [[0, 0, 0], [66, 20, 107], [168, 43, 102], [237, 97, 61], [252, 181, 56], [255, 255, 217]];
function heat(error) {
  const at = Math.min(Math.max(error, 0), 1) * (STOPS.length - 1), from = Math.min(Math.floor(at), STOPS.length - 2);
  return STOPS[from].map((low, i) => Math.round(low + (at - from) * (STOPS[from + 1][i] - low)));
}
const HEAT = Array.from({length: 256}, (_, i) => heat(i / 255));

// ---- pictures

/// The pictures' blocks stand behind this script: the index is there before the browser has read them.
const parsed = new Promise((done) => {
  if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', done, {once: true});
  else done();
});

async function decode(what, index) {
  await parsed;
  const block = byId(what + '-' + index);
  if (!block) return null;
  const image = new Image();
  image.src = 'data:image/png;base64,' + block.textContent;
  await image.decode();
  const canvas = of('canvas', {width: image.naturalWidth, height: image.naturalHeight});
  const context = canvas.getContext('2d', {willReadFrequently: true});
  context.drawImage(image, 0, 0);
  return {canvas, context, values: context.getImageData(0, 0, canvas.width, canvas.height).data};
}

/// The linear values of a picture from the two bytes of their IEEE halves; null if the pair has none.
async function decodeLinear(what, index) {
  const high = await decode(what + '-high', index), low = await decode(what + '-low', index);
  if (!high) return null;
  return Float32Array.from(high.values, (byte, i) => {
    const bits = byte * 256 + low.values[i], exponent = (bits >> 10) & 31, mantissa = bits & 1023;
    const size = exponent === 0 ? mantissa * 2 ** -24 : exponent === 31 ? (mantissa ? NaN : Infinity) : (1 + mantissa / 1024) * 2 ** (exponent - 15);
    return bits >> 15 ? -size : size;
  });
}

/// Draws linear values as a display shows them at an exposure, in stops.
function expose(picture, linear, stops) {
  const factor = 2 ** stops, pixels = picture.context.createImageData(picture.canvas.width, picture.canvas.height);
  for (let i = 0; i < linear.length; ++i) {
    const light = Math.min(Math.max(linear[i] * factor, 0), 1);
    pixels.data[i] = i % 4 === 3 ? 255 : Math.round(255 * (light <= 0.0031308 ? light * 12.92 : 1.055 * light ** (1 / 2.4) - 0.055));
  }
  picture.context.putImageData(pixels, 0, 0);
}

function colored(error) {
  const canvas = of('canvas', {width: error.canvas.width, height: error.canvas.height});
  const pixels = new ImageData(canvas.width, canvas.height);
  for (let i = 0; i < pixels.data.length; i += 4) {
    pixels.data.set(HEAT[error.values[i]], i);
    pixels.data[i + 3] = 255;
  }
  canvas.getContext('2d').putImageData(pixels, 0, 0);
  return canvas;
}

// ---- the viewer

const MODES = [
  ['slider', 'Slider', 'reference left of the line, test right of it'],
  ['blink', 'Blink', 'reference and test in turns'],
  ['onion', 'Onion skin', 'the test laid over the reference'],
  ['error', 'Error', 'FLIP error as colour'],
  ['side', 'Side by side', 'reference, test and error, linked'],
];
const ZOOMS = [1, 2, 4, 8, 16, 32];
const BLINK_MS = 250;   // two changes there and back a second: 2 Hz, below what may harm

/// The largest zoom up to `factor`: any below 1, above it those of the list.
function wholeOrSmaller(factor) {
  return factor < 1 ? factor : ZOOMS.filter((zoom) => zoom <= factor).pop();
}

class Viewer {
  constructor(index, pictures, wanted) {
    this.pair = pairs[index];
    this.pictures = pictures;
    this.heat = colored(pictures.error);
    this.width = pictures.reference.canvas.width;
    this.height = pictures.reference.canvas.height;
    this.mode = MODES.some(([name]) => name === wanted.mode) ? wanted.mode : 'slider';
    this.split = wanted.split === undefined ? 0.5 : Math.min(Math.max(Number(wanted.split) || 0, 0), 1);
    this.showTest = false;
    this.stops = 0;
    this.timer = null;
    this.center = [this.width / 2, this.height / 2];
    this.pixel = null;
    this.build();
    this.resize();
    this.zoom = this.fit();
    if (ZOOMS.includes(Number(wanted.zoom))) this.zoom = Number(wanted.zoom);
    const pixel = (wanted.pixel || '').split(',').map(Number);
    if (pixel.length === 2 && pixel.every(Number.isInteger)) this.inspect(pixel[0], pixel[1], true);
    this.update();
  }

  build() {
    this.canvas = of('canvas', {class: 'view', tabindex: 0, role: 'img', id: 'view', 'aria-describedby': 'inspector'});
    this.canvas.addEventListener('pointermove', (event) => this.moved(event));
    this.canvas.addEventListener('pointerdown', (event) => this.pressed(event));
    this.canvas.addEventListener('pointerup', () => { this.drag = null; });
    this.canvas.addEventListener('pointercancel', () => { this.drag = null; });
    this.canvas.addEventListener('wheel', (event) => this.wheeled(event), {passive: false});
    this.output = of('output', {id: 'inspector', 'aria-live': 'polite'}, 'Point at a pixel, or move with the arrow keys.');
    this.buttons = MODES.map(([name, label, doc], i) =>
      of('button', {type: 'button', 'data-mode': name, title: doc + ' (' + (i + 1) + ')', onclick: () => this.setMode(name)}, label));
    this.range = of('input', {type: 'range', id: 'split', min: 0, max: 100, value: this.split * 100,
      oninput: () => { this.split = Number(this.range.value) / 100; this.update(); }});
    this.exposure = of('input', {type: 'number', id: 'exposure', min: -20, max: 20, step: 1, value: 0, onchange: () => this.expose(Number(this.exposure.value))});
    const exposureLabel = this.pictures.referenceLinear ? of('label', {}, 'Exposure (stops)', this.exposure) : null;
    this.rangeLabel = of('label', {}, of('span', {}, 'Line'), this.range);
    this.zoomSelect = of('select', {id: 'zoom', onchange: () => { this.setZoom(this.zoomSelect.value === 'fit' ? this.fit() : Number(this.zoomSelect.value)); }},
      of('option', {value: 'fit'}, 'fit'), ...ZOOMS.map((zoom) => of('option', {value: zoom}, '\u00d7' + zoom)));
    this.element = of('section', {'aria-label': 'Pictures'},
      of('div', {class: 'toolbar', role: 'toolbar', 'aria-label': 'View'}, ...this.buttons, this.rangeLabel, of('label', {}, 'Zoom', this.zoomSelect), ...[exposureLabel].filter(Boolean)),
      of('div', {class: 'stage'}, this.canvas), legend(), this.output, keysHelp());
    byId('stage-place').replaceChildren(this.element);
    this.resizer = new ResizeObserver(() => { this.resize(); this.draw(); });
    this.resizer.observe(this.canvas.parentElement);
  }

  close() {
    clearInterval(this.timer);
    this.resizer.disconnect();
  }

  panes() {
    const count = this.mode === 'side' ? 3 : 1, width = this.viewWidth / count;
    return Array.from({length: count}, (_, i) => ({left: i * width, width, what: count === 3 ? ['reference', 'test', 'error'][i] : this.mode}));
  }

  /// All of the picture: made smaller by any factor, larger by whole ones alone.
  fit() {
    return wholeOrSmaller(Math.min(this.panes()[0].width / this.width, this.viewHeight / this.height));
  }

  resize() {
    const ratio = window.devicePixelRatio || 1;
    this.viewWidth = Math.max(this.canvas.parentElement.clientWidth, 100);
    const room = window.innerHeight * 0.65;
    this.viewHeight = Math.max(200, Math.round(Math.min(room, this.height * wholeOrSmaller(Math.min(this.viewWidth / this.width, room / this.height)))));
    this.canvas.style.height = this.viewHeight + 'px';
    this.canvas.width = Math.round(this.viewWidth * ratio);
    this.canvas.height = Math.round(this.viewHeight * ratio);
    this.ratio = ratio;
  }

  /// Where the picture's corner lies in a pane; on whole screen pixels, so that no picture pixel is wider than another.
  origin(pane) {
    const snap = (value) => Math.round(value * this.ratio) / this.ratio;
    return [snap(pane.left + pane.width / 2 - this.center[0] * this.zoom), snap(this.viewHeight / 2 - this.center[1] * this.zoom)];
  }

  draw() {
    const context = this.canvas.getContext('2d');
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    context.clearRect(0, 0, this.viewWidth, this.viewHeight);
    context.imageSmoothingEnabled = this.zoom < 1;
    for (const pane of this.panes()) {
      context.save();
      context.beginPath();
      context.rect(pane.left, 0, pane.width, this.viewHeight);
      context.clip();
      this.drawPane(context, pane);
      context.restore();
    }
  }

  drawPane(context, pane) {
    const [left, top] = this.origin(pane);
    const place = (picture) => context.drawImage(picture, left, top, this.width * this.zoom, this.height * this.zoom);
    const reference = this.pictures.reference.canvas, test = this.pictures.test.canvas;
    if (pane.what === 'error') place(this.heat);
    else if (pane.what === 'test' || (pane.what === 'blink' && this.showTest)) place(test);
    else place(reference);
    if (pane.what === 'onion') {
      context.globalAlpha = this.split;
      place(test);
      context.globalAlpha = 1;
    }
    if (pane.what === 'slider') this.drawSlider(context, place, test);
    if (this.pixel) this.drawPixel(context, left, top);
  }

  drawSlider(context, place, test) {
    const x = this.split * this.viewWidth;
    context.save();
    context.beginPath();
    context.rect(x, 0, this.viewWidth - x, this.viewHeight);
    context.clip();
    place(test);
    context.restore();
    context.fillStyle = '#000';
    context.fillRect(x - 1.5, 0, 3, this.viewHeight);
    context.fillStyle = '#fff';
    context.fillRect(x - 0.5, 0, 1, this.viewHeight);
  }

  /// A frame around the pixel, black and white, outside of it: seen on any colour, hiding none.
  drawPixel(context, left, top) {
    const size = Math.max(this.zoom, 1), x = left + this.pixel[0] * this.zoom, y = top + this.pixel[1] * this.zoom;
    for (const [grow, color] of [[2, '#fff'], [1, '#000']]) {
      context.strokeStyle = color;
      context.lineWidth = 1;
      context.strokeRect(x - grow + 0.5, y - grow + 0.5, size + 2 * grow - 1, size + 2 * grow - 1);
    }
  }

  /// The controls and the canvas say what is shown; the address does too.
  update() {
    for (const button of this.buttons) button.setAttribute('aria-pressed', String(button.dataset.mode === this.mode));
    this.rangeLabel.hidden = this.mode !== 'slider' && this.mode !== 'onion';
    this.rangeLabel.style.display = this.rangeLabel.hidden ? 'none' : '';
    this.rangeLabel.firstChild.textContent = this.mode === 'onion' ? 'Test' : 'Line';
    this.range.value = Math.round(this.split * 100);
    this.zoomSelect.value = ZOOMS.includes(this.zoom) ? String(this.zoom) : 'fit';
    const shown = this.mode === 'blink' ? (this.showTest ? 'test' : 'reference') : this.mode;
    this.canvas.dataset.shown = shown;
    this.canvas.dataset.zoom = this.zoom;
    this.canvas.setAttribute('aria-label', `${MODES.find(([name]) => name === this.mode)[2]}; shown: ${shown}; zoom ${short(this.zoom)}`);
    this.draw();
  }

  setMode(mode) {
    this.stopBlinking();
    this.mode = mode;
    this.update();
  }

  setZoom(zoom) {
    this.zoom = zoom;
    if (this.pixel && zoom > 1) this.center = [this.pixel[0] + 0.5, this.pixel[1] + 0.5];
    if (zoom <= this.fit()) this.center = [this.width / 2, this.height / 2];
    this.update();
  }

  zoomBy(step) {
    const levels = this.fit() < 1 ? [this.fit(), ...ZOOMS] : ZOOMS;
    let at = 0;
    levels.forEach((level, i) => { if (level <= this.zoom) at = i; });
    this.setZoom(levels[Math.min(Math.max(at + step, 0), levels.length - 1)]);
  }

  /// Space: blinks, or stops. Who asks for less motion changes the picture by each press instead.
  blink() {
    const running = this.timer !== null;
    if (this.mode !== 'blink') this.setMode('blink');
    if (window.matchMedia('(prefers-reduced-motion: reduce)').matches) return this.swap();
    if (running) return this.stopBlinking();
    this.swap();
    this.timer = setInterval(() => this.swap(), BLINK_MS);
  }
  stopBlinking() {
    clearInterval(this.timer);
    this.timer = null;
  }
  swap() {
    this.showTest = !this.showTest;
    this.update();
  }

  /// The pictures alone: their error and their values stay.
  expose(stops) {
    if (!this.pictures.referenceLinear) return;
    this.stops = Math.min(Math.max(stops || 0, -20), 20);
    this.exposure.value = this.stops;
    expose(this.pictures.reference, this.pictures.referenceLinear, this.stops);
    expose(this.pictures.test, this.pictures.testLinear, this.stops);
    this.update();
  }

  moveSplit(step) {
    this.split = Math.min(Math.max(Math.round((this.split + step) * 100) / 100, 0), 1);
    this.update();
  }

  at(event) {
    const box = this.canvas.getBoundingClientRect(), x = event.clientX - box.left - 1, y = event.clientY - box.top - 1;
    const pane = this.panes().find((one) => x >= one.left && x < one.left + one.width) || this.panes()[0];
    const [left, top] = this.origin(pane);
    return {x, y, column: Math.floor((x - left) / this.zoom), row: Math.floor((y - top) / this.zoom)};
  }

  moved(event) {
    const at = this.at(event);
    if (!this.drag) return this.inspect(at.column, at.row, false);
    if (this.drag.line) {
      this.split = Math.min(Math.max(at.x / this.viewWidth, 0), 1);
    } else {
      this.center = [this.center[0] - (at.x - this.drag.x) / this.zoom, this.center[1] - (at.y - this.drag.y) / this.zoom];
      this.drag = at;
    }
    this.update();
  }

  pressed(event) {
    const at = this.at(event);
    this.drag = {...at, line: this.mode === 'slider' && Math.abs(at.x - this.split * this.viewWidth) < 10};
    this.canvas.setPointerCapture(event.pointerId);
  }

  /// With Ctrl, as pages are zoomed; else the page scrolls.
  wheeled(event) {
    if (!event.ctrlKey) return;
    event.preventDefault();
    const at = this.at(event);
    this.inspect(at.column, at.row, false);
    this.zoomBy(event.deltaY < 0 ? 1 : -1);
  }

  inspect(x, y, follow) {
    if (x < 0 || y < 0 || x >= this.width || y >= this.height) {
      if (!follow) return;
      x = Math.min(Math.max(x, 0), this.width - 1);
      y = Math.min(Math.max(y, 0), this.height - 1);
    }
    this.pixel = [x, y];
    if (follow) this.keepInView();
    this.output.textContent = this.describe(x, y);
    this.output.dataset.pixel = x + ',' + y;
    this.draw();
  }

  keepInView() {
    const spans = [this.panes()[0].width / this.zoom, this.viewHeight / this.zoom];
    spans.forEach((span, i) => {
      if (Math.abs(this.pixel[i] + 0.5 - this.center[i]) > span / 2 - 1) this.center[i] = this.pixel[i] + 0.5;
    });
  }

  describe(x, y) {
    const at = 4 * (y * this.width + x), values = (picture) => Array.from(picture.values.slice(at, at + 3));
    const both = ['reference', 'test'].map((what) => {
      const linear = this.pictures[what + 'Linear'];
      return linear ? Array.from(linear.slice(at, at + 3)) : values(this.pictures[what]);
    });
    const text = (list) => list.map((value) => String(Number(value.toPrecision(4)))).join(' ');   // as many digits as halves hold
    const lines = [
      `pixel ${x},${y}`,
      `reference ${text(both[0])}   test ${text(both[1])}   difference ${text(both[1].map((value, i) => value - both[0][i]))}`,
      `FLIP ${short(Math.round(this.pictures.error.values[at] / 255 * 1000) / 1000)}`,
    ];
    if (this.pictures.objects) {
      const [high, middle, low] = values(this.pictures.objects), name = this.pair.objects[high * 65536 + middle * 256 + low];
      lines.push(name === undefined ? 'no object' : `object ${name}`);
    }
    return lines.join('\n');
  }

  step(x, y) {
    const [column, row] = this.pixel || [Math.floor(this.center[0]) - x, Math.floor(this.center[1]) - y];
    this.inspect(column + x, row + y, true);
  }
}

function legend() {
  const stops = STOPS.map((color, i) => `rgb(${color.join(',')}) ${100 * i / (STOPS.length - 1)}%`).join(',');
  return of('div', {class: 'legend quiet', id: 'legend'}, 'FLIP error 0', of('span', {class: 'bar', role: 'img', 'aria-label': 'from black over purple and orange to white',
    style: `background:linear-gradient(to right,${stops})`}), '1');
}

// ---- keys

const KEYS = [
  ['1', '2', '3', '4', '5', 'views: slider, blink, onion skin, error, side by side'],
  ['Space', 'blinks reference and test at 2 Hz, or stops'],
  ['[', ']', 'move the slider\u2019s line, or how much of the test is laid over'],
  ['+', '-', '0', 'zoom in, out, fit'],
  ['\u2190', '\u2191', '\u2192', '\u2193', 'inspect the next pixel; with Shift ten pixels on'],
  [',', '.', 'of linear pictures: a stop darker, a stop brighter'],
  ['n', 'p', 'i', 'next pair, previous pair, index'],
];
function keysHelp() {
  const rows = KEYS.map((row) => of('tr', {}, of('td', {}, ...row.slice(0, -1).flatMap((key) => [of('kbd', {}, key), ' '])), of('td', {}, row[row.length - 1])));
  return of('details', {id: 'keys'}, of('summary', {}, 'Keys'), of('table', {}, of('tbody', {}, ...rows)),
    of('p', {class: 'quiet'}, 'Drag to move the pictures or the line; Ctrl and the wheel zoom. Values are those on a display, 0 to 255, or of linear pictures the light itself; light beyond white is shown clipped.'));
}

function onKey(event) {
  if (event.ctrlKey || event.altKey || event.metaKey || /^(INPUT|SELECT|TEXTAREA)$/.test(event.target.tagName)) return;
  if (event.target.closest('.tiles') && event.key.startsWith('Arrow')) return;
  if (event.key === ' ' && /^(BUTTON|SUMMARY|A)$/.test(event.target.tagName)) return;
  const far = event.shiftKey ? 10 : 1;
  const go = (id) => () => { if (byId(id).href) location.hash = byId(id).getAttribute('href'); };
  const actions = {n: go('next'), p: go('previous'), i: go('to-index')};
  if (viewer) {
    MODES.forEach(([name], i) => { actions[i + 1] = () => viewer.setMode(name); });
    Object.assign(actions, {
      ' ': () => viewer.blink(), '[': () => viewer.moveSplit(-0.05), ']': () => viewer.moveSplit(0.05),
      ',': () => viewer.expose(viewer.stops - 1), '.': () => viewer.expose(viewer.stops + 1), '+': () => viewer.zoomBy(1), '=': () => viewer.zoomBy(1), '-': () => viewer.zoomBy(-1), 0: () => viewer.setZoom(viewer.fit()),
      ArrowLeft: () => viewer.step(-far, 0), ArrowRight: () => viewer.step(far, 0), ArrowUp: () => viewer.step(0, -far), ArrowDown: () => viewer.step(0, far),
    });
  }
  const action = actions[event.key];
  if (!action) return;
  event.preventDefault();
  action();
}

// ---- tables of a pair

function metricsTable(pair) {
  const rows = [];
  for (const [name, numbers] of Object.entries(pair.document.metrics || {})) {
    const known = data.metrics.find((one) => one.name === name) || {unit: '', doc: ''};
    Object.entries(numbers).forEach(([number, value], i) => {
      const doc = i === 0 ? of('td', {rowspan: Object.keys(numbers).length, class: 'quiet'}, `${known.doc}${known.unit && known.unit !== '1' ? ' (' + known.unit + ')' : ''}`) : null;
      const cell = numberCell(value);
      cell.dataset.metric = name + '.' + number;
      rows.push(of('tr', {}, of('th', {scope: 'row'}, i === 0 ? name : ''), of('td', {}, number), cell, doc));
    });
  }
  return rows.length === 0 ? null : section('Metrics', of('div', {class: 'scroll'}, of('table', {id: 'metrics'},
    of('thead', {}, of('tr', {}, of('th', {scope: 'col'}, 'metric'), of('th', {scope: 'col'}, 'number'), of('th', {scope: 'col', class: 'number'}, 'value'), of('th', {scope: 'col'}, 'what it is'))),
    of('tbody', {}, ...rows))));
}


/// Bars on a logarithmic scale: a few bad pixels are seen beside many good ones.
function histogram(pair) {
  if (!pair.histogram) return null;
  const bins = pair.histogram, high = Math.max(1, Math.log10(Math.max(...bins, 1)) || 1), width = 500, height = 150, left = 40, step = width / bins.length;
  const svg = of('svg', {viewBox: `0 0 ${left + width + 10} ${height + 30}`, width: left + width + 10, height: height + 30, role: 'img', id: 'histogram',
    'aria-label': `Pixels by FLIP error, logarithmic; ${bins.reduce((sum, count) => sum + count, 0)} in all`});
  for (let power = 0; power <= high; ++power) {
    const y = 10 + height - height * (power + 0.3) / (high + 0.3);
    svg.append(of('line', {x1: left, x2: left + width, y1: y, y2: y}), of('text', {x: left - 4, y: y + 4, 'text-anchor': 'end'}, String(10 ** power)));
  }
  bins.forEach((count, i) => {
    const tall = count ? height * (Math.log10(count) + 0.3) / (high + 0.3) : 0;
    svg.append(of('rect', {class: 'bar', x: left + i * step, y: 10 + height - tall, width: step - 1, height: tall, 'data-count': count},
      of('title', {}, `${short(i / bins.length)} to ${short((i + 1) / bins.length)}: ${count} pixels`)));
  });
  for (const at of [0, 0.25, 0.5, 0.75, 1]) svg.append(of('text', {x: left + at * width, y: height + 26, 'text-anchor': 'middle'}, String(at)));
  return section('Histogram of the error', of('div', {class: 'scroll'}, svg));
}

/// Tiles as buttons that lead to their place. One of them is in the tab order; arrows go on from it.
function tilesTable(pair) {
  const tiles = pair.document.tiles;
  if (!tiles || !tiles.columns) return null;
  const worst = tiles.mean.indexOf(Math.max(...tiles.mean)), most = Math.max(...tiles.mean, 1e-9), buttons = [];
  const rows = Array.from({length: tiles.rows}, (_, row) => of('tr', {}, ...Array.from({length: tiles.columns}, (_, column) => {
    const i = row * tiles.columns + column, color = heat(Math.sqrt(tiles.mean[i] / most)), bright = color[0] * 0.3 + color[1] * 0.6 + color[2] * 0.1 > 120;
    const label = `tile ${column},${row} from pixel ${column * tiles.size},${row * tiles.size}: mean ${short(tiles.mean[i])}, max ${short(tiles.max[i])}`;
    buttons.push(of('button', {type: 'button', tabindex: i === worst ? 0 : -1, title: label, 'aria-label': label, 'data-mean': tiles.mean[i], 'data-max': tiles.max[i],
      style: `background:rgb(${color.join(',')});color:${bright ? '#000' : '#fff'}`, onclick: () => showTile(tiles, column, row)}, tileText(tiles.mean[i])));
    return of('td', {}, buttons[i]);
  })));
  const table = of('table', {class: 'tiles', id: 'tiles', 'aria-describedby': 'tiles-doc', onkeydown: (event) => tileKey(event, buttons, tiles)}, of('tbody', {}, ...rows));
  return section('Tiles', of('p', {class: 'quiet', id: 'tiles-doc'}, `Mean difference in ${tiles.size} x ${tiles.size} pixels, in thousandths; a tile leads to its place, arrow keys from tile to tile.`),
    of('div', {class: 'scroll'}, table));
}
function tileText(mean) {
  return mean === 0 ? '0' : mean < 0.0005 ? '<1' : String(Math.round(mean * 1000));
}
function tileKey(event, buttons, tiles) {
  const step = {ArrowLeft: -1, ArrowRight: 1, ArrowUp: -tiles.columns, ArrowDown: tiles.columns}[event.key];
  const from = buttons.indexOf(document.activeElement), to = from + step;
  if (!step || from < 0 || to < 0 || to >= buttons.length) return;
  event.preventDefault();
  buttons[from].tabIndex = -1;
  buttons[to].tabIndex = 0;
  buttons[to].focus();
}
function showTile(tiles, column, row) {
  if (!viewer) return;
  viewer.inspect(Math.floor((column + 0.5) * tiles.size), Math.floor((row + 0.5) * tiles.size), true);
  viewer.setZoom(8);
  viewer.canvas.focus();
}

function checksTable(pair) {
  const checks = pair.document.checks || [];
  if (checks.length === 0) return null;
  const rows = checks.map((check) => of('tr', {}, of('td', {}, of('code', {}, check.rule)), numberCell(check.value),
    of('td', {class: 'verdict ' + (check.kept ? 'pass' : check.broken_means)}, check.kept ? '\u2713 kept' : '\u2717 broken: ' + check.broken_means)));
  return section('Rules', of('table', {id: 'checks'}, of('thead', {}, of('tr', {}, of('th', {scope: 'col'}, 'rule'), of('th', {scope: 'col', class: 'number'}, 'value'), of('th', {scope: 'col'}, ''))),
    of('tbody', {}, ...rows)));
}

/// A nested object as rows "a.b  value"; lists of texts as one line each.
function flatRows(object, path = '') {
  return Object.entries(object).flatMap(([key, value]) => {
    const name = path + key;
    if (Array.isArray(value)) return [[name, value.map((one) => (typeof one === 'object' ? JSON.stringify(one) : String(one))).join(', ')]];
    return value !== null && typeof value === 'object' ? flatRows(value, name + '.') : [[name, value]];
  });
}
function objectTable(title, object, id) {
  if (!object || Object.keys(object).length === 0) return null;
  return section(title, of('div', {class: 'scroll'}, of('table', {id}, of('tbody', {}, ...flatRows(object).map(([name, value]) =>
    of('tr', {}, of('th', {scope: 'row'}, name), typeof value === 'number' ? numberCell(value) : of('td', {}, String(value))))))));
}

function commands(pair) {
  return pair.commands.length === 0 ? null : section('Commands', of('pre', {id: 'commands'}, pair.commands.join('\n')));
}

// ---- the page

let viewer = null;
let request = 0;

function head(pair) {
  const known = pair.document;
  return of('div', {}, of('h2', {}, verdictOf(pair), ' ', pair.name === data.title ? '' : pair.name), of('p', {id: 'reason'}, known.reason || ''),
    known.cause_text && known.cause_text !== known.reason ? of('p', {id: 'cause'}, `${known.cause}: ${known.cause_text}`) : null,
    of('p', {class: 'quiet'}, 'reference ', of('code', {}, known.reference || ''), ' \u00b7 test ', of('code', {}, known.test || ''),
      known.width ? ` \u00b7 ${known.width} x ${known.height} \u00b7 ${known.values} values` : ''),
    ...(known.notes || []).map((note) => of('p', {class: 'quiet'}, note)));
}

async function showPair(index, wanted) {
  const pair = pairs[index], ticket = ++request;
  byId('main').replaceChildren(head(pair), of('div', {id: 'stage-place'}), ...[checksTable(pair), of('div', {class: 'columns'}, ...[metricsTable(pair), of('div', {}, ...[histogram(pair), tilesTable(pair)].filter(Boolean))].filter(Boolean)),
    objectTable('Statistics', pair.statistics, 'statistics'), commands(pair)].filter(Boolean));
  const pictures = {};
  for (const what of ['reference', 'test', 'error', 'objects']) pictures[what] = await decode(what, index);
  for (const what of ['reference', 'test']) pictures[what + 'Linear'] = await decodeLinear(what, index);
  if (ticket !== request) return;   // another pair was asked for meanwhile
  if (pictures.reference) viewer = new Viewer(index, pictures, wanted);
  document.documentElement.dataset.ready = 'pair ' + index;
}

const INDEX_COLUMNS = [['flip', 'mean'], ['flip', 'max'], ['ssim', 'value'], ['rmse', 'value'], ['max_abs', 'value']];
function indexTable() {
  const columns = INDEX_COLUMNS.filter(([name, number]) => pairs.some((pair) => metric(pair, name, number) !== undefined));
  const grouped = pairs.some((pair) => pair.group);
  const headings = ['verdict', 'pair', ...(grouped ? ['group'] : [])].map((text) => of('th', {scope: 'col'}, text));
  headings.push(...columns.map(([name, number]) => of('th', {scope: 'col', class: 'number'}, number === 'value' ? name : name + ' ' + number)), of('th', {scope: 'col'}, 'reason'));
  const rows = pairs.map((pair, i) => of('tr', {}, of('td', {}, verdictOf(pair)), of('td', {}, of('a', {href: '#pair=' + i}, pair.name)), grouped ? of('td', {}, pair.group) : null,
    ...columns.map(([name, number]) => (metric(pair, name, number) === undefined ? of('td', {class: 'number'}, '\u2013') : numberCell(metric(pair, name, number)))), of('td', {}, pair.document.reason || '')));
  return of('div', {class: 'scroll'}, of('table', {id: 'index'}, of('caption', {}, `${pairs.length} pairs, the worst first`), of('thead', {}, of('tr', {}, ...headings)), of('tbody', {}, ...rows)));
}

function groupsTable() {
  if (!pairs.some((pair) => pair.group)) return null;
  const verdicts = ['pass', 'warn', 'fail', 'incomparable', 'error'], groups = [...new Set(pairs.map((pair) => pair.group))].sort();
  const count = (group, verdict) => pairs.filter((pair) => pair.group === group && pair.document.verdict === verdict).length;
  return section('Groups', of('table', {id: 'groups'}, of('thead', {}, of('tr', {}, of('th', {scope: 'col'}, 'group'), ...verdicts.map((verdict) => of('th', {scope: 'col', class: 'number'}, verdict)))),
    of('tbody', {}, ...groups.map((group) => of('tr', {}, of('th', {scope: 'row'}, group), ...verdicts.map((verdict) => numberCell(count(group, verdict))))))));
}

function setLink(id, target) {
  if (target === null) byId(id).removeAttribute('href');
  else byId(id).setAttribute('href', target);
}

function route() {
  const wanted = Object.fromEntries(new URLSearchParams(location.hash.slice(1)));
  const asked = Number(wanted.pair), found = Number.isInteger(asked) && asked >= 0 && asked < pairs.length && 'pair' in wanted;
  const index = found ? asked : pairs.length === 1 ? 0 : -1;
  if (viewer) viewer.close();
  viewer = null;
  delete document.documentElement.dataset.ready;
  byId('nav').hidden = pairs.length < 2;
  setLink('to-index', index >= 0 ? '#index' : null);
  setLink('previous', index > 0 ? '#pair=' + (index - 1) : null);
  setLink('next', index + 1 < pairs.length ? '#pair=' + (index + 1) : null);
  if (index >= 0) return showPair(index, wanted);
  ++request;
  byId('main').replaceChildren(...[groupsTable(), pairs.length ? indexTable() : of('p', {}, 'There are no pairs.')].filter(Boolean));
  document.documentElement.dataset.ready = 'index';
}

document.addEventListener('keydown', onKey);
window.addEventListener('hashchange', () => { route(); byId('main').focus(); });
byId('footer').append(...[objectTable('Versions', data.versions, 'versions')].filter(Boolean));
route();
