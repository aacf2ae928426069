
for (const table of document.querySelectorAll('table.sorts')) {
  const heads = [...table.tHead.rows[0].cells], body = table.tBodies[0];
  const collator = new Intl.Collator(undefined, {numeric: true});
  // A cell's value; null where a row has none, which comes last in both directions.
  const value = (row, k) => {
    const cell = row.cells[k];
    if (!cell || cell.colSpan > 1 || cell.textContent === '–') return null;
    const text = cell.textContent;
    if (!cell.classList.contains('n')) return text;
    return text === 'identical' ? Infinity : Number(text);
  };
  const compare = (a, b) => typeof a === 'string' ? collator.compare(a, b)
    : a === b ? 0 : a > b ? 1 : -1;
  const sort = (k) => {
    const sign = heads[k].getAttribute('aria-sort') === 'ascending' ? -1 : 1;
    for (const head of heads) head.removeAttribute('aria-sort');
    heads[k].setAttribute('aria-sort', sign > 0 ? 'ascending' : 'descending');
    const rows = [...body.rows].map(row => ({row, key: value(row, k)}));
    rows.sort((a, b) => a.key === null || b.key === null
      ? (a.key === null) - (b.key === null) : sign * compare(a.key, b.key));
    body.append(...rows.map(entry => entry.row));
  };
  heads.forEach((head, k) => {
    // No button element: Chromium does not repeat a table head that has one on every printed page.
    const button = document.createElement('span');
    button.role = 'button';
    button.tabIndex = 0;
    button.title = 'Sort by this column';
    button.append(...head.childNodes);
    button.addEventListener('click', () => sort(k));
    button.addEventListener('keydown', event => {
      if (!['Enter', ' '].includes(event.key)) return;
      event.preventDefault();
      sort(k);
    });
    head.append(button);
  });
}
const choices = [...document.querySelectorAll('.tests')].filter(tests => tests.children.length > 1);
// The choice of a test holds for all parts of the page that have it.
const showTest = name => {
  for (const tests of choices) {
    const sections = [...tests.children];
    if (!sections.some(section => section.dataset.test === name)) continue;
    for (const section of sections) section.hidden = section.dataset.test !== name;
    tests.previousElementSibling.lastChild.value = name;
  }
};
for (const tests of choices) {
  const label = document.createElement('label'), choice = document.createElement('select');
  for (const section of tests.children) choice.append(new Option(section.dataset.test));
  choice.addEventListener('change', () => showTest(choice.value));
  label.append('Test ', choice);
  tests.before(label);
}
for (const tests of choices.reverse()) showTest(tests.children[0].dataset.test);
for (const plot of document.querySelectorAll('svg.brushed')) {
  const lines = [...plot.querySelectorAll('polyline')], kept = new Map();
  const show = () => {
    const hidden = new Set(lines.filter(line => [...kept].some(([x, range]) => {
      const point = [...line.points].find(p => 0.5 > Math.abs(p.x - x));
      return !point || range[0] > point.y || point.y > range[1];
    })).map(line => line.dataset.row));
    for (const one of document.querySelectorAll('[data-row]'))
      one.style.opacity = hidden.has(one.dataset.row) ? 0.05 : '';
  };
  for (const axis of plot.querySelectorAll('.brush')) {
    const x = axis.x.baseVal.value + axis.width.baseVal.value / 2;
    const mark = axis.cloneNode();
    mark.removeAttribute('class');
    axis.before(mark);
    const placeOf = event => {
      const point = new DOMPoint(event.clientX, event.clientY);
      return point.matrixTransform(plot.getScreenCTM().inverse()).y;
    };
    let from = null;
    const brush = event => {
      const to = placeOf(event), range = [Math.min(from, to), Math.max(from, to)];
      if (range[1] - range[0] > 3) kept.set(x, range); else kept.delete(x);
      mark.setAttribute('y', range[0]);
      mark.setAttribute('height', range[1] - range[0]);
      mark.setAttribute('fill-opacity', kept.has(x) ? 0.15 : 0);
      show();
    };
    axis.addEventListener('pointerdown', event => {
      from = placeOf(event);
      axis.setPointerCapture(event.pointerId);
    });
    axis.addEventListener('pointermove', event => { if (from !== null) brush(event); });
    axis.addEventListener('pointerup', event => { brush(event); from = null; });
  }
}
