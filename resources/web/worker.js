// The engine in a worker, so that the page never waits for it. A message has a number and a request.
'use strict';

let engine, data;

onmessage = async ({ data: { number, what, ...request } }) => {
  try {
    if (what === 'load') data = request.data;
    if (!engine) engine = await engineWith(data, share => postMessage({ number, share }));
    const { state, show, field, x, y, width, height } = request;
    const from = performance.now();
    let answer = {};
    if (what === 'load') {
      engine.setState(data.session.cameras[0]);
      answer = { fields: Object.fromEntries(['camera', ...HEAD, 'sampling'].map(s => [s, engine.fields(s)])),
                 version: engine.text(engine.c.hs_version()) };
    }
    if (what === 'render') {
      if (request.sampling) engine.setAll('sampling', request.sampling);
      answer = engine.render(state, show, field);
    }
    if (what === 'compare') {
      engine.setAll('sampling', request.sampling);
      answer = { error: engine.compare(state, show, field), reference: engine.render(state, show, 0), test: engine.render(state, show, field) };
    }
    if (what === 'panel') answer = engine.panel(state, width, height, field) || {};
    if (what === 'why') answer = { text: engine.why(state, x, y, field) };
    if (what === 'focus') answer = { focus: engine.focus(state, x, y, field) };
    postMessage({ number, ms: performance.now() - from, ...answer },
                answer.rgba ? [answer.rgba.buffer, answer.mask.buffer] : []);
  } catch (error) {
    if (!(error instanceof RangeError)) engine = undefined;  // an error of the core leaves it unusable
    postMessage({ number, failure: error.message });
  }
};
