// What the server is asked: every function returns what the API answers, or throws an Error with the server's line.

async function answer(response) {
  if (response.ok) return response;
  let line = `the server says ${response.status}`;
  try {
    line = (await response.json()).error;
  } catch { /* not its own answer: the number must do */ }
  throw new Error(line);
}

async function get(path, parameters = {}, signal) {
  let response;
  try {
    response = await fetch(`api/${path}?${new URLSearchParams(parameters)}`, {signal});
  } catch (error) {
    if (error.name === 'AbortError') throw error;
    throw new Error('the server does not answer; does rectilin still run?');
  }
  return answer(response);
}

export const collection = async () => (await get('collection')).json();
export const shapes = async (parameters, signal) => (await get('shapes', parameters, signal)).json();
export const search = async (parameters, signal) => (await get('search', parameters, signal)).json();
export const turn = async (query, result, signal) => (await get('turn', {query, result}, signal)).json();
export const mesh = async (id, signal) => (await get('mesh', {id}, signal)).arrayBuffer();

/// Searches with a file; the answer's query has an id that it can be searched for again by.
export async function send(file, parameters) {
  let response;
  try {
    response = await fetch(`api/search?${new URLSearchParams({...parameters, file: file.name})}`,
                           {method: 'POST', body: file, headers: {'Content-Type': 'application/octet-stream'}});
  } catch {
    throw new Error(`${file.name}: the server took no file; does rectilin still run?`);
  }
  return (await answer(response)).json();
}

export const pictureUrl = (shape) => `api/picture?${new URLSearchParams({id: shape.id, v: shape.version})}`;
export const matchesUrl = (parameters) => `api/matches?${new URLSearchParams(parameters)}`;
