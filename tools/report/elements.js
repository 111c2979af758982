// SPDX-License-Identifier: Apache-2.0
// What the pages' scripts have in common: it stands before each of them.
'use strict';

const data = JSON.parse(document.getElementById('data').textContent);
const byId = (id) => document.getElementById(id);

/// An element: `of('td', {class: 'number'}, 'text', child)`. Texts stay texts.
function of(tag, attributes = {}, ...children) {
  const svg = ['svg', 'rect', 'line', 'text', 'title', 'g', 'path', 'polyline', 'circle'].includes(tag);
  const element = svg ? document.createElementNS('http://www.w3.org/2000/svg', tag) : document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
    else if (value !== null && value !== undefined) element.setAttribute(name, value);
  }
  element.append(...children.filter((child) => child !== null && child !== undefined));
  return element;
}

/// Four digits, for people: 1.234, 12340000 as 1.234e7.
function brief(value) {
  const size = Math.abs(value);
  return size !== 0 && (size < 1e-3 || size >= 1e6) ? Number(value.toPrecision(4)).toExponential().replace('e+', 'e') : String(Number(value.toPrecision(4)));
}

/// Six digits; JSON has no infinities and writes null.
function short(value) {
  if (value === null || value === undefined) return 'infinite';
  return typeof value === 'number' && !Number.isInteger(value) ? String(Number(value.toPrecision(6))) : String(value);
}

function numberCell(value, tag = 'td') {
  return of(tag, {class: 'number', 'data-value': JSON.stringify(value), title: JSON.stringify(value)}, short(value));
}

function section(title, ...children) {
  return of('section', {}, of('h3', {}, title), ...children);
}
