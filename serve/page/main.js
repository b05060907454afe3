// The page: shows what its address asks for, and takes files.
import {Comparison} from './compare.js';
import {arrowKeys, fill, fileName} from './grid.js';
import {go, onPlace, place} from './place.js';
import {showQuery} from './query.js';
import * as server from './server.js';

const kPerPage = 60;    // shapes
const kResults = 48;
const kTyping = 200;    // milliseconds without a key before the words count

const part = (id) => document.getElementById(id);
const grid = part('grid');
let collection;
let comparison;
let loading = new AbortController();
let last = {key: '', found: null};  // the last search, so that opening a result does not repeat it

function say(text) {
  part('message').textContent = text;
  part('message').hidden = !text;
}

const counted = (n, thing) => `${n.toLocaleString('en')} ${thing}${n === 1 ? '' : 's'}`;

async function browse({words, from}, signal) {
  const page = await server.shapes({name: words, from, count: kPerPage}, signal);
  fill(grid, page.shapes);
  const end = Math.min(page.total, from + page.shapes.length);
  part('summary').textContent =
      collection.shapes === 0 ? 'There are no shapes in this database yet: rectilin index adds them.'
      : page.total === 0      ? `No name has the words "${words}".`
                              : counted(page.total, 'shape') + (words ? ` with "${words}" in their names` : '') +
          (collection.failed && !words ? `; ${counted(collection.failed, 'file')} could not be read` : '') +
          '. Choose one to see what is like it, or drop a file.';
  part('pages').hidden = page.total <= kPerPage;
  part('where').textContent = `${from + 1} to ${end} of ${page.total.toLocaleString('en')}`;
  part('earlier').disabled = from === 0;
  part('later').disabled = end >= page.total;
}

async function search({words, like, through}, signal) {
  const parameters = {id: like, count: kResults, name: words, collection: through === '1' ? 1 : 0};
  const key = JSON.stringify(parameters);
  if (last.key !== key) {
    last = {key, found: await server.search(parameters, signal)};
    fill(grid, last.found.results);
    showQuery(part('query'), last.found.query, parameters);
    scrollTo(0, 0);
  }
  part('summary').textContent = last.found.results.length === 0
      ? 'Nothing else is in the database' + (words ? ` with "${words}" in its name.` : '.')
      : `The ${counted(last.found.results.length, 'shape')} nearest to ${fileName(last.found.query.name)}` +
          (words ? ` with "${words}" in their names` : '') + ', and how far they are.';
}

async function show() {
  loading.abort();
  loading = new AbortController();
  const {signal} = loading;
  const at = place();
  say('');
  if (document.activeElement !== part('words')) part('words').value = at.words;
  document.querySelector('main').classList.toggle('searching', at.like !== '');
  part('query').hidden = at.like === '';
  try {
    if (at.like) {
      part('pages').hidden = true;
      await search(at, signal);
      if (at.show) await comparison.open(last.found.query, last.found.results, at.show);
    } else {
      last = {key: '', found: null};
      await browse(at, signal);
    }
    if (!at.show) comparison.close();
  } catch (error) {
    if (error.name === 'AbortError') return;
    comparison.close();
    last = {key: '', found: null};
    grid.replaceChildren();
    part('query').hidden = part('pages').hidden = true;
    document.querySelector('main').classList.remove('searching');
    part('summary').textContent = '';
    say(error.message);
  }
}

async function take(file) {
  say('');
  if (file.size > collection.upload_bytes)
    return say(`${file.name}: larger than ${Math.floor(collection.upload_bytes / 2 ** 20)} MiB, the most this server takes.`);
  const summary = part('summary').textContent;
  part('summary').textContent = `Reading ${file.name} ...`;
  document.body.ariaBusy = 'true';
  try {
    const found = await server.send(file, {count: kResults, name: '', collection: 0});
    go({like: found.query.id, words: '', from: 0, through: '', show: ''});
  } catch (error) {
    part('summary').textContent = summary;
    say(error.message);
  } finally {
    document.body.ariaBusy = 'false';
  }
}

function takeDrops() {
  const hasFile = (event) => event.dataTransfer?.types.includes('Files');
  const drop = part('drop');
  addEventListener('dragover', (event) => {
    if (!hasFile(event)) return;
    event.preventDefault();
    drop.hidden = false;
  });
  addEventListener('dragleave', (event) => {
    if (!event.relatedTarget) drop.hidden = true;  // it left the window
  });
  addEventListener('drop', (event) => {
    if (!hasFile(event)) return;
    event.preventDefault();
    drop.hidden = true;
    const [file] = event.dataTransfer.files;
    if (file) take(file);
  });
}

function listen() {
  let typing;
  part('words').addEventListener('input', () => {
    clearTimeout(typing);
    typing = setTimeout(() => go({words: part('words').value.trim(), from: 0, show: ''}, {replace: true}), kTyping);
  });
  part('tools').addEventListener('submit', (event) => event.preventDefault());
  part('file').addEventListener('change', () => {
    const [file] = part('file').files;
    part('file').value = '';  // so that the same file can be chosen again
    if (file) take(file);
  });
  for (const [id, step] of [['earlier', -kPerPage], ['later', kPerPage]])
    part(id).addEventListener('click', () => {
      go({from: Math.max(0, place().from + step)});
      scrollTo(0, 0);
    });
  document.addEventListener('click', (event) => {  // links within the page
    const link = event.target.closest('a[href^="#"]');
    if (!link || event.ctrlKey || event.metaKey || event.shiftKey) return;
    event.preventDefault();
    history.pushState(null, '', link.hash || '#');
    dispatchEvent(new Event('place'));
  });
  arrowKeys(grid);
  takeDrops();
  onPlace(show);
}

try {
  collection = await server.collection();
  document.title = part('title').textContent = collection.title;
  comparison = new Comparison(part('compare'), collection.viewer);
  listen();
  await show();
} catch (error) {
  say(error.message);
}
document.documentElement.dataset.ready = 'yes';
