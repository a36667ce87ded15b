#include "testbench/report/report_html.h"

namespace ptm::testbench::html {

std::string style() {
  return R"css(
:root { color-scheme: light dark;
  --paper: #fcfcfa; --ink: #1d2226; --soft: #59636b; --rule: #d5d9dc; --panel: #f2f3f1;
  --accent: #1f5f8b; --good: #1b6b3a; --good-bg: #e3f2e8; --bad: #a3201d; --bad-bg: #fbe6e4;
  --mark: #fff1cf; --bar: #2f6f9f; --moved: #2f6f9f; --blocked: #b07a00; --wait: #b8392f;
  --ring: #7d4fa3; --empty: #8a949b; --second: #b8392f; }
@media (prefers-color-scheme: dark) { :root {
  --paper: #14181b; --ink: #e4e7e9; --soft: #9aa5ad; --rule: #333b41; --panel: #1c2226;
  --accent: #7fbce6; --good: #7fd3a0; --good-bg: #14301f; --bad: #ff9c94; --bad-bg: #3d1a18;
  --mark: #43380f; --bar: #6aaede; --moved: #5b9fd0; --blocked: #dba93a; --wait: #e8766b;
  --ring: #b28ad6; --empty: #7d878e; --second: #ffab6b; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--paper); color: var(--ink);
  font: 15px/1.5 system-ui, -apple-system, "Segoe UI", "Liberation Sans", sans-serif; }
header, main, footer { max-width: 1240px; margin: 0 auto; padding: 0 20px; }
header { padding-top: 28px; }
h1 { font-size: 26px; line-height: 1.25; margin: 0 0 4px; overflow-wrap: anywhere; }
h2 { font-size: 19px; margin: 44px 0 8px; padding-top: 14px; border-top: 2px solid var(--ink); }
h3 { font-size: 15.5px; margin: 24px 0 8px; }
p { margin: 6px 0 12px; max-width: 76ch; }
.over { color: var(--soft); font-size: 13px; letter-spacing: .04em; margin: 0 0 2px; }
.soft { color: var(--soft); }
.verdict { border-left: 5px solid; padding: 10px 14px; margin: 16px 0; max-width: none;
  border-radius: 0 4px 4px 0; }
.good { color: var(--good); background: var(--good-bg); border-color: var(--good); }
.bad { color: var(--bad); background: var(--bad-bg); border-color: var(--bad); }
.verdict strong { font-size: 16.5px; }
.tiles { display: grid; gap: 12px; margin: 16px 0; padding: 0;
  grid-template-columns: repeat(auto-fit, minmax(min(100%, 190px), 1fr)); }
.tile { background: var(--panel); border-radius: 5px; padding: 10px 14px; }
.tile b { display: block; font-size: 22px; font-weight: 600; font-variant-numeric: tabular-nums; }
.tile span { display: block; color: var(--soft); font-size: 13px; line-height: 1.35; }
dl.facts { display: grid; grid-template-columns: max-content 1fr; gap: 2px 18px; margin: 14px 0; }
dl.facts dt { color: var(--soft); } dl.facts dd { margin: 0; overflow-wrap: anywhere; }
.row { display: grid; gap: 14px; align-items: start;
  grid-template-columns: repeat(auto-fit, minmax(min(100%, 215px), 1fr)); }
.duo { display: grid; gap: 20px 28px; align-items: start;
  grid-template-columns: repeat(auto-fit, minmax(min(100%, 420px), 1fr)); }
figure { margin: 0; min-width: 0; }
figure img { display: block; width: 100%; height: auto; background: #000; }
figure img.tiny { image-rendering: pixelated; }
figcaption { font-size: 13px; line-height: 1.4; padding-top: 5px; color: var(--soft); }
figcaption b { color: var(--ink); }
svg { display: block; width: 100%; height: auto; max-width: 620px; }
svg text { fill: var(--ink); font: 13px system-ui, "Liberation Sans", sans-serif; }
svg .axis { stroke: var(--soft); } svg .grid { stroke: var(--rule); } svg .bar { fill: var(--bar); }
svg.cycles { height: 26px; max-width: 940px; border-radius: 3px; }
svg.cycles rect { shape-rendering: crispEdges; }
.cycle0 { fill: var(--moved); background: var(--moved); }
.cycle1 { fill: var(--blocked); background: var(--blocked); }
.cycle2 { fill: var(--wait); background: var(--wait); }
.cycle3 { fill: var(--ring); background: var(--ring); }
.cycle4 { fill: var(--empty); background: var(--empty); }
.swatch { display: inline-block; width: 12px; height: 12px; border-radius: 2px;
  margin-right: 7px; vertical-align: -1px; }
.swatch.line0, .swatch.line1, .swatch.mean { height: 0; border-radius: 0; width: 22px;
  vertical-align: 4px; border-top: 2.5px solid var(--bar); }
.swatch.line1 { border-top: 2.5px dashed var(--second); }
.swatch.mean { border-top: 1.5px dotted var(--ink); }
.barname { margin: 12px 0 3px; font-size: 13px; color: var(--soft); }
.barname b { color: var(--ink); margin-right: 6px; }
figure.rate { max-width: 860px; } figure.rate .scroll { margin: 0; }
figure.rate svg { max-width: none; min-width: 520px; }
svg .area { fill: var(--bar); opacity: .2; }
svg .rate0, svg .rate1 { fill: none; stroke: var(--bar); stroke-width: 1.5; }
svg .rate1 { stroke: var(--second); stroke-dasharray: 5 3; }
svg .mean { stroke: var(--ink); stroke-dasharray: 2 3; }
.key { display: block; }
.timed thead th { white-space: normal; }
.timed tbody th { white-space: normal; min-width: 118px; }
.textures td:nth-child(2), .textures th:nth-child(2) { text-align: left; }
td small { display: block; color: var(--soft); font-size: 12px; }
.scroll { overflow-x: auto; margin: 10px 0 18px; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: 14px; }
caption { text-align: left; color: var(--soft); font-size: 13px; padding-bottom: 6px; }
th, td { padding: 4px 14px 4px 0; text-align: right; white-space: nowrap; vertical-align: top; }
th { font-weight: 600; } thead th { border-bottom: 1.5px solid var(--ink); vertical-align: bottom; }
tbody tr { border-bottom: 1px solid var(--rule); }
tbody th, thead th:first-child { text-align: left; padding-left: 8px; }
tbody th { font-weight: 500; }
th small { display: block; font-weight: 400; color: var(--soft); }
table.pairs, table.presets { width: 100%; max-width: 940px; }
.duo table { width: 100%; }
table.values { min-width: min(100%, 640px); } table.values td, table.values th { padding-top: 2px;
  padding-bottom: 2px; }
tr.marked { background: var(--mark); } tr.marked th::after { content: " ≠"; color: var(--bad);
  font-weight: 700; }
tr.bold td, tr.bold th { font-weight: 650; }
code, td.value, .values tbody th { font-family: ui-monospace, "DejaVu Sans Mono", monospace;
  font-size: 13px; }
details { border: 1px solid var(--rule); border-radius: 5px; margin: 8px 0;
  background: var(--panel); }
summary { cursor: pointer; padding: 8px 12px; font-variant-numeric: tabular-nums; }
summary b { margin-right: 6px; }
details .scroll { margin: 0; padding: 2px 12px 12px; background: var(--paper);
  border-top: 1px solid var(--rule); }
:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px; }
footer { padding-bottom: 48px; color: var(--soft); font-size: 13.5px; }
footer dt { color: var(--ink); font-weight: 600; margin-top: 8px; } footer dd { margin: 0;
  max-width: 90ch; }
@media (max-width: 600px) { header, main, footer { padding-left: 14px; padding-right: 14px; }
  h1 { font-size: 22px; }
  dl.facts { grid-template-columns: 1fr; } dl.facts dt { margin-top: 6px; } }
@media print { body { font-size: 12px; } .row, .duo, table { break-inside: avoid; } }
)css";
}

}  // namespace ptm::testbench::html
