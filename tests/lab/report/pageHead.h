#pragma once

namespace lab {

/// From the start of the page to its heading: the looks, in light and in dark.
constexpr const char* pageHead = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>swTracer lab: your report</title>
<style>
:root { color-scheme: light dark; --text: #222; --quiet: #5c5c5c; --back: #fff; --card: #f5f5f3;
  --line: #d5d5d0; --good: #1a6e2e; --bad: #b3261e; --hint: #fff3cd; --edge: #b98900;
  --link: #0b57a4; }
@media (prefers-color-scheme: dark) { :root { --text: #e4e4e0; --quiet: #a8a8a2; --back: #17181a;
  --card: #222427; --line: #3b3e42; --good: #6fce86; --bad: #ff8a80; --hint: #3a3115;
  --edge: #d8a520; --link: #8ab8f0; } }
body { font: 16px/1.5 sans-serif; color: var(--text); background: var(--back); margin: 0 auto;
  padding: 1rem; max-width: 60rem; overflow-wrap: anywhere; }
a { color: var(--link); }
h1 { margin: 0; line-height: 1.2; }
h2 { margin: 0; line-height: 1.3; }
h3 { margin: 0 0 .5rem; font-size: 1rem; }
.quiet { color: var(--quiet); }
.passed { color: var(--good); font-weight: bold; }
.failed { color: var(--bad); font-weight: bold; }
.tasks { list-style: none; padding: 0; display: grid; gap: .5rem;
  grid-template-columns: repeat(auto-fill, minmax(16rem, 1fr)); }
.tasks li { background: var(--card); border: 1px solid var(--line); border-radius: .4rem;
  padding: .5rem .8rem; }
section { border-top: 1px solid var(--line); margin-top: 1.5rem; padding-top: 1rem; }
.verdict { margin: .2rem 0 1rem; }
.test { background: var(--card); border-left: .3rem solid var(--bad); border-radius: .2rem;
  margin: 1rem 0; padding: .8rem 1rem; }
.test p { margin: 0 0 .5rem; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .2rem .8rem; margin: 0 0 .8rem; }
dt { color: var(--quiet); }
dd { margin: 0; white-space: pre-line; }
.test p.hint { background: var(--hint); border-left: .3rem solid var(--edge); margin: .5rem 0 0;
  padding: .5rem .8rem; white-space: pre-line; }
.note { border: 1px solid var(--edge); border-radius: .4rem; padding: .4rem .8rem; }
.pictures { display: grid; gap: .8rem; max-width: 56rem; margin: .8rem 0 .3rem;
  grid-template-columns: repeat(auto-fit, minmax(9.5rem, 1fr)); }
.shot { position: relative; max-width: 18rem; overflow: hidden; }
figure { margin: 0; }
img { display: block; width: 100%; max-width: 100%; height: auto; image-rendering: pixelated; }
figcaption { font-size: .85rem; color: var(--quiet); }
.ring { position: absolute; top: 0; width: 1.1rem; height: 1.1rem; box-sizing: border-box;
  transform: translate(-50%, -50%); border: 2px solid #fff; border-radius: 50%;
  box-shadow: 0 0 0 2px #000, inset 0 0 0 1px #000; }
summary { cursor: pointer; }
</style></head><body>
<h1>swTracer lab</h1>
)";

}  // namespace lab
