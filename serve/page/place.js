// Where in the page one is, kept behind the # of its address: so that Back works, and an address can be kept.

const kDefaults = {words: '', from: 0, like: '', through: '', show: ''};

/// {words, from, like: id of the query, through: '1' if ranked through the collection, show: id of the result in 3D}
export function place() {
  const found = Object.fromEntries(new URLSearchParams(location.hash.slice(1)));
  return {...kDefaults, ...found, from: Math.max(0, Number.parseInt(found.from ?? '0', 10) || 0)};
}

export function addressOf(changes, from = place()) {
  const next = {...from, ...changes};
  const kept = Object.entries(next).filter(([key, value]) => key in kDefaults && value !== kDefaults[key]);
  return `#${new URLSearchParams(kept)}`;
}

export function go(changes, {replace = false} = {}) {
  const address = addressOf(changes);
  if (address === (location.hash || '#')) return;
  history[replace ? 'replaceState' : 'pushState'](null, '', address);
  dispatchEvent(new Event('place'));
}

export function onPlace(listener) {
  for (const event of ['popstate', 'place']) addEventListener(event, listener);
}
