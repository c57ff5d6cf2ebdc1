#include "grader/report/page.h"

#include <algorithm>

#include "course/report/mesh_drawing.h"
#include "grader/report/class_results.h"

namespace grader {

namespace {

using course::Verdict;

// Greys and one blue; amber for what needs a look. Every state is also told
// by its letters, so that the page can be read in black and white.
constexpr std::string_view style_before = R"css(
:root {
  --ink: #1a2330; --soft: #586475; --line: #d4dae2; --tint: #f4f6f9;
  --blue: #1d5b96; --blue-tint: #e6eef7; --amber: #9a4300;
  --amber-tint: #fcefe2;
}
* { box-sizing: border-box; }
html { font-size: 15px; -webkit-print-color-adjust: exact;
       print-color-adjust: exact; }
body {
  margin: 0 auto; padding: 40px 32px 64px; max-width: 1120px;
  color: var(--ink); background: #fff;
  font: 1rem/1.5 "Source Sans 3", -apple-system, "Segoe UI", "Helvetica Neue",
        "Liberation Sans", Arial, system-ui, sans-serif;
  font-variant-numeric: tabular-nums;
}
h1, h2, h3, h4 { line-height: 1.25; margin: 0; font-weight: 650; }
h1 { font-size: 2rem; letter-spacing: -0.01em; }
h2 { font-size: 1.33rem; margin: 44px 0 4px; }
h3 { font-size: 1.2rem; }
h4 { font-size: 1rem; }
p { margin: 6px 0; }
a { color: var(--blue); text-decoration-thickness: 1px;
    text-underline-offset: 2px; }
.over { color: var(--soft); font-size: 0.93rem; margin: 0 0 4px; }
.soft { color: var(--soft); }
.small { font-size: 0.87rem; }
code, pre, .mono {
  font-family: "Source Code Pro", "SF Mono", Menlo, Consolas,
               "DejaVu Sans Mono", "Liberation Mono", monospace;
  font-size: 0.88em;
}
pre {
  margin: 8px 0; padding: 10px 12px; background: var(--tint);
  border-left: 3px solid var(--line); white-space: pre-wrap;
  overflow-wrap: anywhere; tab-size: 4; line-height: 1.45;
}
code, bdi { overflow-wrap: anywhere; }
table { border-collapse: collapse; width: 100%; margin: 12px 0; }
th, td { text-align: left; padding: 6px 10px 6px 0; vertical-align: baseline;
         border-bottom: 1px solid var(--line); }
thead th { font-size: 0.87rem; font-weight: 600; color: var(--soft);
           border-bottom: 1.5px solid var(--ink); vertical-align: bottom; }
.n { text-align: right; white-space: nowrap; }
.when { white-space: nowrap; }
.n + td:not(.n), .n + th:not(.n) { padding-left: 16px; }
.numbers { display: flex; flex-wrap: wrap; margin: 24px 0 8px; padding: 0;
           border-top: 1.5px solid var(--ink);
           border-bottom: 1px solid var(--line); }
.numbers div { padding: 12px 28px 12px 0; margin-right: 28px;
               border-right: 1px solid var(--line); }
.numbers div:last-child { border-right: 0; }
.numbers dt { color: var(--soft); font-size: 0.87rem; }
.numbers dd { margin: 0; font-size: 1.73rem; font-weight: 600;
              letter-spacing: -0.01em; }
.numbers dd.words { font-size: 1.33rem; line-height: 2.6rem; }
.numbers dd small { font-size: 1rem; font-weight: 400; color: var(--soft); }
.alert { margin: 24px 0 0; padding: 14px 18px; background: var(--amber-tint);
         border-left: 5px solid var(--amber); }
.alert ul { margin: 6px 0 0; padding-left: 20px; }
.v { display: inline-block; min-width: 1.8rem; padding: 0 4px;
     border-radius: 3px;
     text-align: center; font-size: 0.77rem; line-height: 1.13rem;
     font-weight: 650; border: 1px solid var(--line); color: var(--soft);
     background: #fff; }
.v.ok { color: var(--blue); border-color: #a9c3de;
        background: var(--blue-tint); }
.v.bad { color: var(--amber); border-color: #e2b78f;
         background: var(--amber-tint); }
.v.fault { color: #fff; background: var(--ink); border-color: var(--ink); }
.legend { font-size: 0.87rem; color: var(--soft); }
.legend > span { white-space: nowrap; margin-right: 14px; }
.notes { font-size: 0.9rem; }
.notes td { overflow-wrap: anywhere; }
.notes td:first-child { width: 220px; }
.bar { display: inline-block; width: 100%; min-width: 70px; height: 9px;
       background: var(--tint); border: 1px solid var(--line);
       border-radius: 2px; vertical-align: middle; }
.bar i { display: block; height: 100%; background: var(--blue); }
.class { width: auto; min-width: 55%; }
.class td, .class th { padding: 5px 3px; }
.class .score { text-align: center; width: 33px; line-height: 1.25; }
.class .score small { display: block; font-size: 0.77rem; color: var(--soft); }
.class th.up { height: 138px; padding: 0 0 6px; width: 34px;
               text-align: center; }
.class th.up span { writing-mode: vertical-rl; transform: rotate(180deg);
                    font-weight: 600; white-space: nowrap; }
.class th.group { text-align: left; font-size: 0.8rem; border-bottom: 0;
                  padding-bottom: 0; }
.class .first { border-left: 1px solid var(--line); }
.class td.who { padding-right: 12px; min-width: 130px; max-width: 180px;
                overflow-wrap: anywhere; }
.class .n { padding-left: 8px; padding-right: 8px; }
.class .n small { display: inline-block; min-width: 6rem; line-height: 1.25;
                  white-space: normal; }
.class .mean td { border-bottom: 0; color: var(--soft); font-size: 0.87rem;
                  border-top: 1.5px solid var(--ink); }
.of-bar { width: 180px; }
.exercise { margin: 34px 0 0; padding-top: 14px;
            border-top: 1.5px solid var(--ink); }
.exercise > header { display: flex; align-items: baseline; gap: 12px; }
.exercise > header .points { margin-left: auto; font-size: 1.13rem;
                             font-weight: 600; white-space: nowrap; }
.cases { list-style: none; margin: 10px 0 0; padding: 0; }
.cases > li { padding: 7px 0; border-bottom: 1px solid var(--line);
              display: grid; grid-template-columns: 44px 1fr auto;
              column-gap: 4px; }
.cases > li:last-child { border-bottom: 0; }
.cases .v { justify-self: start; align-self: start; margin-top: 2px; }
.cases .detail { grid-column: 2 / 4; min-width: 0; }
.hint { margin: 6px 0 0; padding: 6px 12px;
        border-left: 3px solid var(--blue); background: var(--blue-tint); }
.failure { margin: 12px 0 4px; break-inside: avoid; display: flex;
           flex-wrap: wrap; gap: 0 28px; }
.failure + .failure { border-top: 1px dashed var(--line); padding-top: 12px; }
.failure dl { display: grid; grid-template-columns: 86px 1fr; margin: 0;
              row-gap: 3px; flex: 1 1 330px; align-content: start; }
.failure dt { color: var(--soft); font-size: 0.87rem; }
.failure dd { margin: 0; min-width: 0; white-space: pre-wrap;
              overflow-wrap: anywhere; }
.failure dd.got { font-weight: 650; color: var(--amber); }
figure { margin: 4px 0 0; max-width: 500px; }
figcaption { font-size: 0.83rem; color: var(--soft); }
svg.mesh { max-width: 100%; height: auto; font-family: inherit; }
svg text { text-anchor: middle; }
)css";

constexpr std::string_view style_after =
    R"css(.charts { display: grid; gap: 8px 48px; margin: 28px 0 0;
          grid-template-columns: repeat(auto-fit, minmax(300px, 1fr)); }
.charts figure { max-width: 520px; width: 100%; }
.charts figcaption { margin-bottom: 4px; font-size: 0.87rem; }
.columns { display: block; width: 100%; height: auto; }
.columns text { font-size: 12px; fill: var(--ink); }
.columns .axis { font-size: 11px; fill: var(--soft); }
.fill { fill: var(--blue); background: var(--blue); }
.part { fill: #a9c3de; background: #a9c3de; }
.lost { fill: #e2b78f; background: #e2b78f; }
.columns .base { stroke: var(--ink); }
.outcome { display: block; width: 100%; height: 13px; background: #fff;
           border: 1px solid var(--line); border-radius: 2px; }
.exercises td { vertical-align: middle; }
.exercises .wide-bar { width: 45%; min-width: 90px; }
.exercises .chapter { font-size: 0.8rem; font-weight: 600; padding-top: 14px;
                      color: var(--soft); }
.key { display: inline-block; width: 22px; height: 11px;
       border: 1px solid var(--line); border-radius: 2px; }
details { margin: 12px 0; }
summary { cursor: pointer; color: var(--blue); }
footer { margin-top: 48px; padding-top: 10px; color: var(--soft);
         font-size: 0.87rem; border-top: 1px solid var(--line); }
@media (max-width: 600px) {
  body { padding: 20px 14px 40px; }
  h1 { font-size: 1.6rem; }
  .numbers div { padding: 8px 14px 8px 0; margin-right: 14px; }
  .numbers dd { font-size: 1.4rem; }
  th, td { padding-right: 6px; }
  /* Too wide for a phone: each scrolls by itself. */
  table:not(.exercises) { display: block; overflow-x: auto; }
  td bdi { overflow-wrap: break-word; }
  /* The number beside it says the same. */
  .bar, .of-bar, .no-file { display: none; }
  .overview { font-size: 0.87rem; }
  .exercises .wide-bar { width: 30%; min-width: 70px; }
  .exercises tr > :nth-child(3) { display: none; }
  .failure dl { flex-basis: 100%; grid-template-columns: 72px 1fr; }
}
@media print {
  @page { size: A4; margin: 14mm 13mm; }
  html { font-size: 11.5px; }
  body { padding: 0; max-width: none; }
  h2 { margin-top: 26px; break-after: avoid; }
  h2 + p, h3, .exercise > header, .exercise > header + p, .cases .hint,
  tr:has(.chapter) { break-after: avoid; }
  .cases, .cases .detail { break-before: avoid; }
  /* In a grid a page may end between a case and its hint. */
  .cases > li { display: block; }
  .cases > li > .v { margin-right: 12px; }
  .cases > li > div { display: inline; }
  .cases > li > .n { float: right; }
  .cases > li > .detail { display: block; margin-left: 36px; }
  tr, figure, .alert { break-inside: avoid; }
  details { display: none; }
  .charts { grid-template-columns: 1fr 1fr; gap: 0 24px; }
  .charts figure { max-width: none; }
  thead { display: table-header-group; }
  a { color: inherit; text-decoration: none; }
  .numbers div { padding-right: 18px; margin-right: 18px; }
  .failure { flex-wrap: nowrap; gap: 0 16px; }
  .failure dl { flex-basis: 200px; grid-template-columns: 60px 1fr; }
  figure { flex: 0 0 auto; max-width: 250px; }
  svg.mesh { max-height: 180px; width: auto; }
  .class td, .class th { padding: 4px 1px; }
  .class th.up, .class .score { width: 24px; }
  .class td.who { min-width: 110px; }
  .v { padding: 0 2px; }
}
)css";

Html badge_of(std::string_view kind, std::string_view title,
              std::string_view letters) {
    return markup(R"(<span class="v {}" title="{}">{}</span>)", kind, title,
                  letters);
}

std::string_view kind(Verdict verdict) {
    if (verdict == Verdict::accepted) return "ok";
    if (verdict == Verdict::not_submitted) return "none";
    return verdict == Verdict::grader_fault ? "fault" : "bad";
}

}  // namespace

Html begin_page(std::string_view title) {
    return markup(
        R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; )"
        R"(style-src 'unsafe-inline'">
<title>{}</title>
<style>{}{}{}</style>
</head>
<body>
)",
        title, Html{std::string(style_before)},
        Html{std::string(course::mesh_style)}, Html{std::string(style_after)});
}

void end_page(Html& page) {
    append(page, "</body>\n</html>\n");
}

Html badge(Verdict verdict) {
    return badge_of(kind(verdict), words(verdict), mark(verdict));
}

Html badge_not_judged() {
    return badge_of("none", "not judged yet", "..");
}

Html legend() {
    Html all;
    for (int k = 0; k <= static_cast<int>(Verdict::grader_fault); ++k) {
        const auto verdict = static_cast<Verdict>(k);
        all += markup("<span>{} {}</span> ", badge(verdict), words(verdict));
    }
    return markup(R"(<p class="legend">{}</p>)"
                  "\n",
                  all);
}

Html bar(double share) {
    return markup(R"(<span class="bar"><i style="width:{:.1f}%"></i></span>)",
                  100 * std::clamp(share, 0.0, 1.0));
}

}  // namespace grader
