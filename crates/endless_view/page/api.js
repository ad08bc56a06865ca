// What the server is asked for. Everything is named by numbers and by words of fixed lists.

/** The server says no, or cannot be reached. */
export class ApiError extends Error {
  constructor(message, status) {
    super(message);
    this.status = status;
  }
}

async function ask(path, options) {
  let response;
  try {
    response = await fetch(`/api/${path}`, options);
  } catch (error) {
    if (error.name === 'AbortError') throw error;
    throw new ApiError('The server does not answer: is endless view still running?', 0);
  }
  if (!response.ok) throw new ApiError((await response.text()).trim(), response.status);
  return response;
}

/** Data, and its entity tag. */
export async function tagged(path) {
  const response = await ask(path);
  return { data: await response.json(), tag: response.headers.get('etag') };
}

export const json = async (path) => (await ask(path)).json();
export const blob = async (path, signal) => (await ask(path, { signal })).blob();

const camera = (video, number) => `videos/${video}/cameras/${number}`;

export const paths = {
  dataset: 'dataset',
  video: (video) => `videos/${video}`,
  timeline: (video) => `videos/${video}/timeline`,
  actors: (video) => `videos/${video}/actors`,
  frames: (video, from, count) => `videos/${video}/frames?from=${from}&count=${count}`,
  objects: (video, number, from, count) => `${camera(video, number)}/objects?from=${from}&count=${count}`,
  poses: (video, number, from, count) => `${camera(video, number)}/poses?from=${from}&count=${count}`,
  map: (video, number) => `${camera(video, number)}/map`,
  stored: (video, number, layer, frame) => `${camera(video, number)}/images/${layer}/${frame}`,
  inColor: (video, number, layer, frame) => `${camera(video, number)}/pictures/${layer}/${frame}`,
  thumbnail: (video, number) => `/api/${camera(video, number)}/thumbnail`,
};
