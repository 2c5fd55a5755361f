// The style sheet of the gallery's page. No '<' and no '&': the page is XML too.
#pragma once

namespace pathrace::results {

inline constexpr const char* gallery_style = R"(:root {
  color-scheme: light dark;
  --page: #f3f1ea; --card: #ffffff; --edge: #e4e0d6; --ink: #212529; --faint: #5c6470;
  --paper: #ffffff; --ground: #fbfaf6; --grid: #e9e5db; --obstacle: #3b4452;
  --path: #e8590c; --start: #0b7285; --goal: #c2255c;
}
@media (prefers-color-scheme: dark) {
  :root {
    --page: #14171c; --card: #1c2027; --edge: #2c323c; --ink: #e9ecef; --faint: #a3abb8;
    --paper: #14171c; --ground: #161a20; --grid: #222831; --obstacle: #8793a6;
    --path: #ff922b; --start: #3bc9db; --goal: #f783ac;
  }
}
* { box-sizing: border-box; }
body {
  margin: 0 auto; padding: 2.5rem clamp(1rem, 3vw, 3rem) 4rem; max-width: 100rem;
  background: var(--page); color: var(--ink);
  font: 16px/1.5 system-ui, -apple-system, "Segoe UI", Roboto, Helvetica, Arial, sans-serif;
}
header { margin-bottom: 2rem; }
h1 { margin: 0 0 .25rem; font-size: 2rem; line-height: 1.2; letter-spacing: -.02em; }
header p { margin: 0; max-width: 46rem; color: var(--faint); }
.legend { display: flex; flex-wrap: wrap; gap: .25rem 1.75rem; margin: 1rem 0 0; padding: 0; list-style: none; }
.legend li { display: flex; align-items: center; gap: .5rem; font-size: .9rem; }
.key { width: 24px; height: 24px; }
main { display: grid; gap: 1.25rem; grid-template-columns: repeat(auto-fill, minmax(min(100%, 34rem), 1fr)); }
section {
  padding: 1.1rem 1.25rem 1.25rem; border: 1px solid var(--edge); border-radius: 12px; background: var(--card);
}
h2 { margin: 0; font-size: 1.15rem; letter-spacing: -.01em; }
section p { margin: 0 0 .9rem; font-size: .9rem; color: var(--faint); }
.maps { display: grid; gap: 1rem; grid-template-columns: repeat(auto-fit, minmax(9rem, 1fr)); }
figure { margin: 0; max-width: 22rem; }
figure svg { display: block; width: 100%; height: auto; overflow: visible; }
figcaption { margin-top: .5rem; font-size: .8rem; line-height: 1.4; }
figcaption code, figcaption span { display: block; overflow-wrap: anywhere; }
figcaption code { font: 600 .8rem/1.4 ui-monospace, SFMono-Regular, Menlo, Consolas, monospace; }
figcaption span { color: var(--faint); font-variant-numeric: tabular-nums; }
@media print { body { background: none; } section { break-inside: avoid; } }
)";

}  // namespace pathrace::results
