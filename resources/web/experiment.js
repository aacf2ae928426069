// An experiment: votes on the contents of the page, in an order that is drawn for each viewer.
'use strict';

const METHODS = {
  pairs: {
    instructions: 'You see one display twice, with other content. Say which of the two looks better.',
    question: 'Which looks better?', answers: [[1, 'The first'], [0, 'They look the same'], [2, 'The second']],
  },
  // The grades of ITU-R BT.500.
  dsis: {
    instructions: 'You see one display twice. The first is the original, the second may have errors. Say how the second looks beside the first.',
    question: 'How are the errors of the second?',
    answers: [[5, 'Imperceptible'], [4, 'Perceptible, but not annoying'], [3, 'Slightly annoying'], [2, 'Annoying'], [1, 'Very annoying']],
  },
};
const LETTERS = 'abcde', SECONDS_EACH = 15, PRACTICE = 3, CARD = 0.0856;  // m, ISO/IEC 7810 ID-1

// Numbers from 0 to 1, always the same for a seed (mulberry32).
function drawsOf(seed) {
  return () => {
    seed = seed + 0x6D2B79F5 | 0;
    let t = Math.imul(seed ^ seed >>> 15, 1 | seed);
    t = t + Math.imul(t ^ t >>> 7, 61 | t) ^ t;
    return ((t ^ t >>> 14) >>> 0) / 4294967296;
  };
}

function shuffled(list, draw) {
  const result = [...list];
  for (let k = result.length - 1; k > 0; --k) {
    const other = Math.floor(draw() * (k + 1));
    [result[k], result[other]] = [result[other], result[k]];
  }
  return result;
}

// All questions: each test beside the reference, or each pair with its sides drawn.
function trialsOf(method, contents, states, draw) {
  const trials = [];
  for (let state = 0; state < states; ++state)
    for (let a = 0; a < (method === 'dsis' ? 1 : contents); ++a)
      for (let b = a + 1; b < contents; ++b) trials.push({ state, shown: [a, b] });
  return shuffled(trials, draw).map(({ state, shown }) =>
      ({ state, shown: method === 'pairs' && draw() < 0.5 ? [shown[1], shown[0]] : shown }));
}

function startExperiment() {
  const method = JSON.parse($('method').textContent), { instructions, question, answers } = METHODS[method];
  const page = textHash([$('session').textContent, method, ...data.names, ...data.hashes].join('\n'));
  const count = trialsOf(method, data.names.length, data.session.cameras.length, () => 0).length;
  const asked = new URLSearchParams(location.search), seed = asked.get('seed');
  let result, trials, practice, side, seen, path, begun;

  const store = () => `hogelscope votes ${page} ${result.viewer} ${seed ?? ''}`;
  const keep = () => { try { localStorage.setItem(store(), JSON.stringify(result)); } catch { /* a browser without a store */ } };
  const kept = () => {
    try {
      const old = JSON.parse(localStorage.getItem(store()));
      return old && old.page === page && Array.isArray(old.trials) && old.trials.length <= count ? old : null;
    } catch { return null; }
  };
  const now = () => practice[0] || trials[result.trials.length];
  const only = name => {
    for (const part of ['welcome', 'trial', 'thanks']) $(part).hidden = part !== name;
    document.querySelector('main').classList.toggle('asks', name !== 'trial');
  };

  function showSide(which) {
    side = which;
    seen[which] = true;
    [...$('sides').children].forEach((button, k) => button.setAttribute('aria-pressed', k === which));
    [...$('answers').children].forEach(button => { button.disabled = !(seen[0] && seen[1]); });
    $('wait').hidden = seen[0] && seen[1];
    content = now().shown[which];
    draw();
  }

  function next() {
    if (!now()) return finish();
    only('trial');
    $('count').textContent = practice.length ? `Practice, ${practice.length} to go` : `Question ${result.trials.length + 1} of ${count}`;
    [seen, path, begun] = [[false, false], [], undefined];
    content = now().shown[0];
    choose(now().state);
    showSide(0);
    $('view').focus();
  }

  function answer(vote) {
    if (!seen[0] || !seen[1] || begun === undefined) return;
    if (practice.length) practice.shift();
    else {
      const { state, shown } = now();
      result.trials.push({ state: data.session.cameras[state].name, shown: shown.map(k => data.names[k]), vote,
                           seconds: Math.round(performance.now() - begun) / 1000, path });
      keep();
    }
    next();
  }

  function finish() {
    only('thanks');
    $('given').textContent = `You answered ${result.trials.length} of ${count} questions.`;
    const link = $('votesFile');
    link.href = URL.createObjectURL(new Blob([JSON.stringify(result)], { type: 'application/json' }));
    link.download = `votes_${result.viewer.replace(/[^\p{L}\p{N}_-]/gu, '_')}.json`;
    link.focus();
  }

  $('instructions').textContent = instructions;
  $('length').textContent = `${count} questions, about ${Math.max(1, Math.round(count * SECONDS_EACH / 60))} minutes. `
      + 'You can stop, and go on later in the same browser under the same name.';
  $('viewer').value = asked.get('id') || '';
  $('question').textContent = question;
  answers.forEach(([vote, words], k) => {
    const button = document.createElement('button'), key = document.createElement('kbd');
    button.type = 'button';
    key.textContent = LETTERS[k];
    button.append(key, ` ${words}`);
    button.onclick = () => answer(vote);
    $('answers').append(button);
  });
  $('card').addEventListener('input', () => {
    $('cardPicture').style.width = `${$('card').value}px`;
    $('screenWidth').value = (100 * CARD * screen.width / $('card').value).toFixed(1);
  });
  $('cardPicture').style.width = `${$('card').value}px`;
  [...$('sides').children].forEach((button, k) => { button.onclick = () => showSide(k); });
  $('stop').onclick = finish;
  $('view').addEventListener('drawn', ({ detail: { eye, content: drawn } }) => {
    if ($('trial').hidden || drawn !== now().shown[side]) return;
    begun ??= performance.now();
    path.push([Math.round(performance.now() - begun), side, ...eye.map(value => +value.toFixed(4))]);
  });
  // Before the page's own keys, whose digits choose a state.
  document.addEventListener('keydown', event => {
    if ($('trial').hidden || event.ctrlKey || event.altKey || event.metaKey) return;
    const vote = LETTERS.indexOf(event.key.toLowerCase());
    if (event.key === '1' || event.key === '2') showSide(event.key - 1);
    else if (event.key.length === 1 && vote >= 0 && vote < answers.length) answer(answers[vote][0]);
    else if (!/^([03-9]|Page(Up|Down))$/.test(event.key)) return;
    event.preventDefault();
    event.stopPropagation();
  }, true);
  $('experiment').addEventListener('submit', event => {
    event.preventDefault();
    const viewer = $('viewer').value.trim(), metres = name => +(+$(name).value / 100).toFixed(4);
    if (!viewer) return;
    result = { 'hogelscope votes': 1, page, method, viewer, trials: [] };
    const old = kept();
    if (old) result.trials = old.trials;
    result.screen = { width: metres('screenWidth'), distance: metres('screenDistance'),
                      pixels: [screen.width, screen.height].map(value => Math.round(value * devicePixelRatio)) };
    const draw = drawsOf(parseInt(textHash(seed ?? viewer), 16));
    trials = trialsOf(method, data.names.length, data.session.cameras.length, draw);
    practice = old ? [] : shuffled(trials, draw).slice(0, Math.min(PRACTICE, count - 1));
    next();
  });
  $('experiment').hidden = false;
  only('welcome');
}
