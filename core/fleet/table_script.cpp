#include "fleet/table_script.h"

namespace breakaway {

const char* const fleetTableStyle = R"(<style>
.filters { display: flex; flex-wrap: wrap; gap: .6rem 1.2rem; align-items: center; margin: 1rem 0 .4rem; }
.filters input[type=search], .filters select { font: inherit; color: inherit; background: var(--paper); border: 1px solid var(--rule);
  border-radius: 4px; padding: .3rem .5rem; } .filters input[type=search] { min-width: 18rem; }
.fleet { width: calc(100vw - 3rem); margin-left: calc(50% - 50vw + 1.5rem); overflow: auto; border: 1px solid var(--rule); }
.fleet.live { max-height: 75vh; }
.fleet table { table-layout: fixed; margin: 0; font-size: .9rem; }
.fleet td, .fleet th { padding: .25rem .6rem; white-space: nowrap; overflow: hidden; text-overflow: ellipsis; }
.fleet thead th { position: sticky; top: 0; background: var(--wash); white-space: normal; vertical-align: bottom; }
.fleet thead button { all: unset; cursor: pointer; width: 100%; } .fleet thead button:focus-visible { outline: 2px solid var(--mark); }
.fleet th[aria-sort=ascending] button::after { content: " \25B2"; } .fleet th[aria-sort=descending] button::after { content: " \25BC"; }
.fleet tr.apart td:first-child { border-left: 4px solid #d55e00; padding-left: calc(.6rem - 4px); } .fleet a { color: var(--mark); }
.fleet tr.room td { padding: 0; border: 0; }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(26rem, 100%), 1fr)); gap: 0 1.5rem; }
@media print { .fleet { width: auto; margin: 0; } .fleet.live { max-height: none; } .filters { display: none; } }
</style>
)";

// The data: {"apart": rows that stand out come first, so many, "columns": [{"n": name} with "w", the words, and "i",
// the index of each row's, or "v", numbers, with "l" and "h", their intervals, and "abs": sorted by size], "reports":
// [...]}.
const char* const fleetTableScript = R"js(<script>
(() => {
  const data = JSON.parse(document.getElementById('fleet-data').textContent);
  const box = document.querySelector('.fleet'), table = box.querySelector('table'), body = table.tBodies[0];
  const search = document.getElementById('fleet-search'), verdict = document.getElementById('fleet-verdict');
  const apart = document.getElementById('fleet-apart'), count = document.getElementById('fleet-count');
  const columns = data.columns, rows = data.rows, heads = [...table.tHead.rows[0].cells];
  const height = body.rows.length ? body.rows[0].getBoundingClientRect().height : 30;
  const digits = v => v !== 0 && Math.abs(v) < 1e-4 ? v.toExponential().replace(/e([-+])(\d)$/, 'e$10$2') : String(v);
  const textOf = (c, k) => c.w ? c.w[c.i[k]] : c.v[k] === null ? '' : digits(c.v[k]).replace('-', '\u2212');
  const searched = columns.filter(c => c.w);
  let words = null, order = [...Array(rows).keys()], shown = order;

  const cellOf = (c, k, at) => {
    const cell = document.createElement('td'), text = textOf(c, k);
    if (c.v) cell.className = 'number';
    if (c.l && c.v[k] !== null) cell.title = '95 %: ' + digits(c.l[k]) + ' to ' + digits(c.h[k]);
    if (c.w && text.length > 24) cell.title = text;
    if (at === 0 && data.reports && data.reports[k]) {
      const link = document.createElement('a');
      link.href = data.reports[k];
      link.textContent = text;
      cell.append(link);
    } else cell.textContent = text;
    return cell;
  };
  const rowOf = k => {
    const row = document.createElement('tr');
    if (k < data.apart) row.className = 'apart';
    row.append(...columns.map((c, at) => cellOf(c, k, at)));
    return row;
  };
  const room = lines => {
    const row = document.createElement('tr'), cell = document.createElement('td');
    row.className = 'room';
    cell.colSpan = columns.length;
    cell.style.height = lines * height + 'px';
    row.append(cell);
    return row;
  };
  const draw = () => {
    const first = Math.max(0, Math.min(Math.floor(box.scrollTop / height) - 10, shown.length - 1));
    const last = Math.min(shown.length, first + Math.ceil(box.clientHeight / height) + 20);
    const drawn = shown.slice(first, last).map(rowOf);
    if (first > 0) drawn.unshift(room(first));
    if (last < shown.length) drawn.push(room(shown.length - last));
    body.replaceChildren(...drawn);
  };
  const filter = () => {
    const wanted = search.value.toLowerCase().split(/\s+/).filter(Boolean), chosen = verdict.value;
    if (wanted.length && !words) words = order.slice().sort((a, b) => a - b).map(k => searched.map(c => textOf(c, k)).join('\n').toLowerCase());
    const verdicts = columns[1];
    shown = order.filter(k => (!chosen || textOf(verdicts, k) === chosen) && (!apart.checked || k < data.apart) &&
                              wanted.every(one => words[k].includes(one)));
    count.textContent = shown.length.toLocaleString('en') + ' of ' + rows.toLocaleString('en');
    box.scrollTop = 0;
    draw();
  };
  const sort = at => {
    const c = columns[at], up = heads[at].getAttribute('aria-sort') === (c.v ? 'descending' : 'none');
    heads.forEach(head => head.setAttribute('aria-sort', 'none'));
    heads[at].setAttribute('aria-sort', up ? 'ascending' : 'descending');
    const rank = c.w ? (() => {
      const places = [...c.w.keys()].sort((a, b) => c.w[a].localeCompare(c.w[b], 'en', {numeric: true})), of = [];
      places.forEach((word, place) => of[word] = c.w[word] === '' ? null : place);
      return k => of[c.i[k]];
    })() : c.abs ? k => c.v[k] === null ? null : Math.abs(c.v[k]) : k => c.v[k];
    const sign = up ? 1 : -1;
    order.sort((a, b) => {
      const x = rank(a), y = rank(b);
      if (x === null || y === null) return (x === null) - (y === null) || a - b;  // what has none comes last
      return sign * (x - y) || a - b;
    });
    filter();
  };

  heads.forEach((head, at) => {
    const button = document.createElement('button');
    button.append(...head.childNodes);
    button.addEventListener('click', () => sort(at));
    head.append(button);
    head.setAttribute('aria-sort', 'none');
  });
  let waits = false;
  box.addEventListener('scroll', () => {
    if (waits) return;
    waits = true;
    requestAnimationFrame(() => { waits = false; draw(); });
  });
  [search, verdict, apart].forEach(one => one.addEventListener('input', filter));
  addEventListener('resize', draw);
  box.classList.add('live');
  document.querySelector('.filters').hidden = false;
  filter();
})();
</script>
)js";

}  // namespace breakaway
