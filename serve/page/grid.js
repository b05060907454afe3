// Shapes as pictures with their names.
import {pictureUrl} from './server.js';
import {addressOf} from './place.js';

export function element(name, properties = {}, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

export function picture(shape) {
  const image = element('img', {className: 'picture', src: pictureUrl(shape), alt: '', width: 280, height: 280,
                                loading: 'lazy', decoding: 'async'});
  image.addEventListener('error', () => image.classList.add('missing'));
  return image;
}

/// Without its folder and archive.
export const fileName = (name) => name.split(/\/|::/).at(-1);

export const number = (x, digits) => x.toLocaleString('en', {minimumFractionDigits: digits, maximumFractionDigits: digits});

function card(shape, target) {
  const name = fileName(shape.name);
  const folder = shape.name.slice(0, shape.name.length - name.length).replace(/[/:]+$/, '');
  const link = element('a', {className: 'shape', href: target, title: shape.name}, picture(shape),
                       element('span', {className: 'name', textContent: name}));
  if (folder) link.append(element('span', {className: 'folder'}, element('bdi', {textContent: folder})));
  if (shape.distance !== undefined)
    link.append(element('span', {className: 'value', textContent: number(shape.distance, 4)}));
  link.dataset.id = shape.id;
  return element('li', {}, link);
}

/// Fills the grid. A shape leads to a search for it or, if it is itself what was found, to its view beside the query.
export function fill(grid, shapes) {
  grid.replaceChildren(...shapes.map((shape) =>
      card(shape, shape.distance === undefined ? addressOf({like: shape.id, from: 0, words: ''}) : addressOf({show: shape.id}))));
}

/// Arrow keys go from shape to shape; Tab alone would take very many.
export function arrowKeys(grid) {
  grid.addEventListener('keydown', (event) => {
    const links = [...grid.querySelectorAll('a')];
    const at = links.indexOf(document.activeElement);
    if (at < 0 || event.altKey || event.ctrlKey || event.metaKey) return;
    const top = links[0].getBoundingClientRect().top;
    const columns = Math.max(1, links.filter((link) => link.getBoundingClientRect().top === top).length);
    const step = {ArrowRight: 1, ArrowLeft: -1, ArrowDown: columns, ArrowUp: -columns}[event.key];
    if (!step || !links[at + step]) return;
    event.preventDefault();
    links[at + step].focus();
  });
}
