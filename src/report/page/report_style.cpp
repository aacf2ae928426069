// SPDX-License-Identifier: BSD-3-Clause
// How the report's page looks, the script that sorts its tables, and that nothing else may run.
#include "report/page/report_style.h"

namespace hogelscope {

const char* const reportStyle = R"css(
body { font: 15px/1.5 system-ui, "DejaVu Sans", sans-serif; color: #111; background: #fff;
  max-width: 76em; margin: 2em auto; padding: 0 1.2em; }
h1 { font-size: 1.7em; line-height: 1.25; overflow-wrap: anywhere; }
h2 { font-size: 1.25em; margin: 2em 0 .6em; border-bottom: 2px solid #ccc; }
h3 { font-size: 1em; margin: 1.4em 0 .3em; overflow-wrap: anywhere; }
p, dd { max-width: 52em; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; }
td, th { padding: .25em .7em; border-bottom: 1px solid #ccc; text-align: left;
  vertical-align: top; }
thead th.n, thead th { border-bottom: 2px solid #888; vertical-align: bottom;
  white-space: normal; }
.means, .sorts { font-size: .93em; }
.n { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.problem { color: #555; font-style: italic; }
small { display: block; color: #444; }
.facts th { font-weight: normal; color: #444; white-space: nowrap; }
.facts td { overflow-wrap: anywhere; }
.sorts [role=button] { cursor: pointer; }
.sorts [role=button]:focus-visible { outline: 2px solid #0072b2; outline-offset: 2px; }
.sorts [role=button]::after { content: "\00a0\21c5"; color: #999; }
th[aria-sort=ascending] [role=button]::after { content: "\00a0\25b2"; color: #111; }
th[aria-sort=descending] [role=button]::after { content: "\00a0\25bc"; color: #111; }
figure { margin: 1em 0; }
figcaption { overflow-wrap: anywhere; }
.row { display: flex; gap: 1em; align-items: flex-start; }
.row > * { flex: 1 1 0; min-width: 0; margin: 0; }
svg { font: 13px system-ui, "DejaVu Sans", sans-serif; overflow: visible; }
svg text { fill: #111; }
svg .grid { stroke: #ddd; }
svg .tick { stroke: #111; }
svg .frame { fill: none; stroke: #888; }
svg .bar { fill: #444; }
svg .panel { fill: #00000010; stroke: #444; stroke-width: 1.5; }
svg .points > * { stroke: #222; stroke-width: .6; }
svg .points > .curve { fill: none; stroke: currentColor; stroke-width: 1.5; }
svg .points > .interval { stroke: currentColor; stroke-width: 1.2; }
svg .points > .hollow { fill: #fff; stroke-width: 1.6; }
svg .points > .none { fill: none; stroke: #555; stroke-width: 1.5; }
svg.map { max-width: 430px; }
svg.wide { display: block; width: 100%; max-width: 900px; }
.wide .points > :not(.hollow) { stroke: #fff; }
.wide .points > .hollow { stroke: currentColor; }
.row > svg.colours { flex: 0 0 clamp(56px, 9.5%, 84px); }
.plots { display: grid; gap: .6em 1.2em;
  grid-template-columns: repeat(auto-fill, minmax(min(340px, 100%), 1fr)); }
summary { cursor: pointer; color: #444; font-size: .93em; }
details pre { overflow-x: auto; background: #f4f4f4; padding: .6em; font-size: .85em; }
.legend { list-style: none; margin: .3em 0 0; padding: 0 0 0 4em; display: flex;
  flex-wrap: wrap; gap: .2em 1.6em; }
.legend svg { vertical-align: -2px; }
.legend li { overflow-wrap: anywhere; }
.views img { width: 100%; border: 1px solid #bbb; display: block; box-sizing: border-box; }
.cells { display: grid; grid-template-columns: auto minmax(0, 22em); gap: .2em .5em;
  justify-content: start; }
.cells img { width: 100%; image-rendering: pixelated; border: 1px solid #888; display: block;
  box-sizing: border-box; }
.cells .side { display: flex; flex-direction: column; justify-content: space-between;
  text-align: right; font-size: .85em; }
.cells .foot { grid-column: 2; display: flex; justify-content: space-between;
  font-size: .85em; }
.row > .cells { flex: 0 1 28em; }
dt { font-weight: bold; margin-top: .5em; }
dd { margin-left: 1.2em; }
@media (max-width: 40em) {
  body { margin: 1em auto; padding: 0 .7em; }
  .row { flex-wrap: wrap; }
  .row.views > *, .row > svg.map, .row > .cells { flex: 1 1 100%; max-width: none; }
  .row > figure:not(:only-child) { flex: 1 1 100%; }
  .facts, .facts tbody, .facts tr, .facts th, .facts td { display: block; }
  .facts th { white-space: normal; border-bottom: 0; padding-bottom: 0; }
  .legend { padding: 0; }
  figure { overflow-x: auto; }
  svg.wide { width: 640px; }
}
@page { size: A4; margin: 14mm; }
@media print {
  body { font-size: 9.5pt; margin: 0; padding: 0; max-width: none; color: #000; }
  h2, h3 { break-after: avoid; }
  figure, tr, dt, dd, p { break-inside: avoid; }
  dt, h2 + p { break-after: avoid; }
  thead { display: table-header-group; break-inside: avoid; }
  .scroll { overflow: visible; }
  details { display: none; }
  td, th { padding: .2em .45em; }
  .sorts, .means { font-size: 8pt; }
  .sorts [role=button]::after { content: none; }
  small, .problem { color: #000; }
}
)css";

const char* const reportScript = R"js(
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
)js";

// The hashes are base64 of the SHA-256 of the two texts above; core.report_page says which ones it
// wants after a change.
const char* const reportPolicy =
    "default-src 'none'; img-src data:; "
    "style-src 'sha256-7LeUO1huCndHKGEQLE6gSvdYm6qSAuVzg8XjeZ63mog='; "
    "script-src 'sha256-lmUoGecNZ58PNl/B9kNeqhFLMVy4O+TalemMY/rrKcI='; "
    "base-uri 'none'; form-action 'none'";

}  // namespace hogelscope
