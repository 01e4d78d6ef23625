// The style sheet that all of our pages share. Colors follow the reader's choice of a light or dark screen.
#pragma once

namespace temblor::app {

inline constexpr const char* kPageStyle = R"(
:root { color-scheme: light dark; --ink: #1d2129; --soft: #667085; --line: #d9dde5; --back: #f6f7f9;
  --card: #ffffff; --bar: #4a78c2; --alarm: #c8372d; --good: #2d8a4e; }
@media (prefers-color-scheme: dark) { :root { --ink: #e6e8ec; --soft: #98a1b0; --line: #343a46; --back: #14171c;
  --card: #1d2128; --bar: #6d97dc; --alarm: #ef6a5e; --good: #5cc283; } }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 2rem 1.5rem 4rem; max-width: 68rem; background: var(--back); color: var(--ink);
  font: 15px/1.5 system-ui, "Segoe UI", "Noto Sans", sans-serif; }
h1 { margin: 0; font-size: 1.7rem; }
h2 { margin: 0 0 .8rem; font-size: 1.15rem; }
p { margin: .3rem 0 .9rem; }
.soft, footer { color: var(--soft); }
section { margin-top: 1.4rem; padding: 1.1rem 1.3rem 1.3rem; background: var(--card);
  border: 1px solid var(--line); border-radius: 10px; }
.cards { display: flex; flex-wrap: wrap; gap: .8rem; margin-top: 1.4rem; }
.cards div { flex: 1 1 8rem; padding: .7rem 1rem; background: var(--card); border: 1px solid var(--line);
  border-radius: 10px; }
.cards b { display: block; font-size: 1.35rem; font-weight: 600; font-variant-numeric: tabular-nums; }
.cards span { color: var(--soft); font-size: .85rem; }
.alarm, .cards .alarm b { color: var(--alarm); }
.good, .cards .good b { color: var(--good); }
table { width: 100%; border-collapse: collapse; font-variant-numeric: tabular-nums; }
th { padding: .25rem .6rem; text-align: left; font-weight: 600; color: var(--soft); font-size: .85rem;
  border-bottom: 1px solid var(--line); white-space: nowrap; }
td { padding: .25rem .6rem; border-bottom: 1px solid var(--line); vertical-align: middle; }
tr:last-child td { border-bottom: 0; }
.n { text-align: right; white-space: nowrap; }
td:has(.bar) { width: 45%; }
.bar { display: block; height: .7rem; border-radius: 4px; background: var(--line); overflow: hidden; }
.bar i { display: block; height: 100%; min-width: 1px; background: var(--bar); }
.bar.alarm i { background: var(--alarm); }
.wide { width: 100%; height: auto; display: block; border-radius: 6px; }
footer { margin-top: 1.4rem; font-size: .85rem; }
)";

}  // namespace temblor::app
