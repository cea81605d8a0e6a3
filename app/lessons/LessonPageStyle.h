// How a lesson's page looks, on a screen and on paper.
#pragma once

namespace umbra {

inline constexpr const char* lessonPageStyle = R"(
:root { --ink: #1f2933; --muted: #5b6672; --border: #d9dee4; --accent: #3f6fb5; --probe: #f59e0b; }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 52rem; padding: 1.5rem; color: var(--ink); background: white;
       font: 1rem/1.55 "Source Serif 4", Charter, "DejaVu Serif", Georgia, serif; }
h1, h2, h3, th, .label, figcaption, summary { font-family: Inter, "DejaVu Sans", Arial, sans-serif; }
h1 { margin: 0 0 .3rem; font-size: 1.9rem; line-height: 1.2; }
h2 { margin: 0 0 .6rem; font-size: 1.25rem; }
header { padding-bottom: 1rem; border-bottom: 2px solid var(--ink); }
header p { margin: .3rem 0; }
.after, figcaption { color: var(--muted); font-size: .88rem; }
section { padding: 1.4rem 0 .8rem; border-bottom: 1px solid var(--border); }
.number { color: var(--accent); margin-right: .5rem; }
.formula { margin: .8rem 0 .8rem 1.5rem; overflow-x: auto; white-space: pre;
           font: 1.02rem/1.5 "DejaVu Sans Mono", Consolas, monospace; }
code { font: .92em "DejaVu Sans Mono", Consolas, monospace; }
figure { margin: 1rem 0; break-inside: avoid; }
figure img, figure svg { display: block; width: 100%; height: auto; border: 1px solid var(--border); }
.look { margin: 1rem 0; padding: .1rem 1rem; border-left: 4px solid var(--probe);
        break-inside: avoid; }
.question { margin: 1rem 0; padding: .5rem 1rem .8rem; border: 1px solid var(--border);
            border-left: 4px solid var(--accent); break-inside: avoid; }
.label { margin: .5rem 0 0; font-size: .8rem; font-weight: 600; color: var(--muted); }
.answer { display: inline-block; width: 9rem; border-bottom: 1px solid var(--ink); }
summary { cursor: pointer; font-weight: 600; color: var(--accent); }
table { border-collapse: collapse; width: 100%; margin: .8rem 0; font-size: .92rem; }
th { text-align: left; font-size: .8rem; color: var(--muted); }
th, td { padding: .3rem .6rem .3rem 0; border-bottom: 1px solid var(--border);
         vertical-align: top; }
td.figure { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
footer { padding-top: 1rem; color: var(--muted); font-size: .85rem; }
@page { margin: 18mm; }
@media print {
  body { max-width: none; padding: 0; font-size: 10.5pt; }
  h1, h2, h3 { break-after: avoid; }
  summary { color: var(--muted); }
}
)";

}  // namespace umbra
