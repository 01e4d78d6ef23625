// The style sheet of the compile report, besides kPageStyle.
#pragma once

namespace temblor::app {

inline constexpr const char* kReportStyle = R"(
.tex { width: 34px; height: 34px; object-fit: contain; image-rendering: pixelated; display: block; }
td:has(.tex) { width: 46px; padding: .15rem .6rem; }
.plan { width: 100%; max-height: 80vh; display: block; margin: .6rem 0; }
.plan path { fill: none; vector-effect: non-scaling-stroke; }
.plan .heat { image-rendering: pixelated; }
.plan .walls { stroke: currentColor; stroke-width: .6px; opacity: .45; }
.plan .portals { stroke: #35b6c9; stroke-width: .8px; opacity: .8; }
.plan .way { stroke: var(--alarm); stroke-width: 2.5px; }
.plan .dot { stroke-width: 11px; stroke-linecap: round; stroke: var(--alarm); }
.plan .start, .plan .inside { stroke: var(--good); }
.plan text { fill: #fff; stroke: #000; stroke-width: .25em; paint-order: stroke; text-anchor: middle;
  dominant-baseline: central; font-weight: 700; }
#heat:not(:checked) ~ .plan .heat, #walls:not(:checked) ~ .plan .walls,
#portals:not(:checked) ~ .plan .portals { display: none; }
label { margin: 0 1rem 0 .2rem; }
.legend { display: flex; align-items: center; gap: .6rem; color: var(--soft); font-size: .85rem; }
.legend i { flex: 0 1 16rem; height: .7rem; border-radius: 4px; }
.bins { width: 100%; height: 11rem; display: block; }
.bins rect { fill: var(--bar); }
.bins .cut { fill: var(--alarm); }
.axis { display: flex; justify-content: space-between; color: var(--soft); font-size: .85rem; }
ul { margin: .2rem 0 .8rem; padding-left: 1.3rem; columns: 2 20rem; column-gap: 2rem; }
)";

}  // namespace temblor::app
