// The panel that says what is searched for.
import {element, fileName, number, picture} from './grid.js';
import {go, place} from './place.js';
import {matchesUrl} from './server.js';

/// `parameters` are those of the search, for the lists to download.
export function showQuery(panel, query, parameters) {
  const download = (format) => element('a', {className: 'button', href: matchesUrl({...parameters, format}),
                                             download: `matches.${format}`, textContent: format.toUpperCase()});
  const through = element('input', {type: 'checkbox', checked: place().through === '1'});
  through.addEventListener('change', () => go({through: through.checked ? '1' : '', show: ''}));
  const facts = element('div', {},
      element('h2', {textContent: fileName(query.name), title: query.name}),
      element('p', {textContent: `${number(query.faces, 0)} triangles, R ${number(query.rectilinearity, 3)}`}));
  if (query.note) facts.append(element('p', {textContent: query.note}));
  facts.append(
      element('div', {className: 'actions', role: 'group', ariaLabel: 'Download the matches'}, download('csv'), download('json')),
      element('label', {className: 'switch'}, through, 'rank through what lies between shapes'));
  panel.replaceChildren(picture(query), facts);
  panel.hidden = false;
}
