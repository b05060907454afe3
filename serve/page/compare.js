// A result beside the query, both in one pose.
import {element, fileName, number, picture} from './grid.js';
import {go} from './place.js';
import * as server from './server.js';
import {makeTurnable} from './turning.js';

/// The dialog. `inThreeD` is false where there is no three.js; pictures are shown then.
export class Comparison {
  #dialog;
  #inThreeD;
  #three;        // view.js, once it is needed
  #pose;
  #sides = [];   // of the query and of the result: {box, note, caption, view}
  #loading = new AbortController();
  #shown = '';   // id of the query whose mesh is in its view
  #results = [];
  #at = 0;

  constructor(dialog, inThreeD) {
    this.#dialog = dialog;
    this.#inThreeD = inThreeD;
    this.title = element('h2', {id: 'compare-title', tabIndex: -1});
    const button = (text, act) => {
      const made = element('button', {type: 'button', textContent: text});
      made.addEventListener('click', act);
      return made;
    };
    this.before = button('Previous match', () => this.#step(-1));
    this.after = button('Next match', () => this.#step(1));
    this.like = button('Search for this', () => go({like: this.#results[this.#at].id, show: '', words: '', from: 0}));
    const views = element('div', {id: 'views'});
    for (const label of ['query', 'result']) {
      const note = element('p', {hidden: true});
      const box = element('div', {className: 'view', tabIndex: inThreeD ? 0 : -1}, note);
      box.dataset.side = label;
      const caption = element('figcaption');
      views.append(element('figure', {}, box, caption));
      this.#sides.push({box, note, caption});
    }
    dialog.replaceChildren(
        element('header', {}, this.title, button('Close', () => go({show: ''}))), views,
        element('div', {className: 'actions'}, this.before, this.after, this.like,
                ...(inThreeD ? [button('Turn back', () => this.#pose?.reset())] : [])));
    if (inThreeD)
      dialog.append(element('p', {className: 'help keys', textContent:
          'Drag, or arrow keys, turn both; wheel, or + and -, bring them nearer; Home puts them back.'}));
    dialog.addEventListener('cancel', (event) => {  // Escape
      event.preventDefault();
      go({show: ''});
    });
  }

  close() {
    this.#loading.abort();
    if (this.#dialog.open) this.#dialog.close();
  }

  async open(query, results, id) {
    this.#results = results;
    this.#at = results.findIndex((result) => result.id === id);
    if (this.#at < 0) return this.close();
    const result = results[this.#at];
    this.title.textContent = `${fileName(result.name)}, ${number(result.distance, 4)} from ${fileName(query.name)}`;
    this.before.disabled = this.#at === 0;
    this.after.disabled = this.#at === results.length - 1;
    [query, result].forEach((shape, side) => {
      this.#sides[side].caption.textContent = `${side ? '' : 'Query: '}${shape.name}`;
      this.#sides[side].box.ariaLabel = `${shape.name}${this.#inThreeD ? '; arrow keys turn it' : ''}`;
      this.#sides[side].box.role = 'img';
    });
    if (!this.#dialog.open) {
      this.#dialog.showModal();
      this.#sides[1].box.focus();
    }
    this.#loading.abort();
    this.#loading = new AbortController();
    const {signal} = this.#loading;
    try {
      await (this.#inThreeD ? this.#showMeshes(query, result, signal) : this.#showPictures([query, result]));
    } catch (error) {
      if (error.name !== 'AbortError') this.#say(1, error.message);
    }
  }

  #step(by) {
    go({show: this.#results[this.#at + by].id}, {replace: true});
  }

  #say(side, text) {
    this.#sides[side].note.textContent = text;
    this.#sides[side].note.hidden = !text;
  }

  #showPictures(shapes) {
    shapes.forEach((shape, side) => {
      const {box, note} = this.#sides[side];
      box.replaceChildren(picture(shape), note);
    });
    this.#say(1, 'Pictures only: this rectilin was built without three.js.');
  }

  async #showMeshes(query, result, signal) {
    this.#three ??= await import('./view.js');
    if (!this.#pose) {
      this.#pose = new this.#three.Pose();
      for (const side of this.#sides) {
        side.view = new this.#three.View(side.box, this.#pose);
        makeTurnable(side.box, this.#pose);
      }
    }
    this.#dialog.dataset.ready = '';
    this.#say(1, 'Loading');
    this.#sides[1].view.clear();
    if (this.#shown !== query.id) {
      this.#sides[0].view.clear();
      this.#pose.reset();
      this.#shown = '';
      this.#sides[0].view.show(await server.mesh(query.id, signal));
      this.#shown = query.id;
    }
    const [bytes, turn] = await Promise.all([server.mesh(result.id, signal), server.turn(query.id, result.id, signal)]);
    if (signal.aborted) return;
    this.#sides[1].view.show(bytes, turn.rotation);
    this.#say(1, '');
    this.#dialog.dataset.ready = result.id;
  }
}
