// The checks find what is wrong: one page that is right, and for each check
// pages that are wrong in one way.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import * as checks from "./page_checks.mjs";

const part = (name) => readFileSync(
    new URL(`../../player/page/${name}`, import.meta.url), "utf8");
let browser;
let folder;

before(async () => {
    browser = await checks.start_browser();
    folder = mkdtempSync(join(tmpdir(), "pages-"));
});
after(async () => {
    await browser.close();
    rmSync(folder, { recursive: true });
});

const drawing = `<svg viewBox="0 0 100 50" style="height: 50vh">
    <g><rect x="10" y="10" width="20" height="8" fill="var(--cur-bg)"/>
       <text x="12" y="16" font-size="6" fill="var(--fg)">H4</text></g>
    <g><rect x="10" y="30" width="20" height="8" fill="var(--next-bg)"/>
       <text x="12" y="36" font-size="6" fill="var(--fg)">H5</text></g></svg>`;

/** A page on the player's own parts; `body` and `script` may spoil it. */
function make({ body = "", script = "", draw = "" }) {
    const file = join(folder, `${Math.random()}.html`);
    writeFileSync(file, `<!doctype html><html lang="en"><head>
        <link rel="icon" href="data:,"><style>${part("base.css")}</style>
        </head><body>${drawing}${body}<div id="say"></div><div id="bar"></div>
        <script>"use strict"; ${part("svg.js")} ${part("stepper.js")}
        const say = document.getElementById("say");
        const stepper = new Stepper(document.getElementById("bar"), {
            draw: (k) => { say.textContent = "step " + k; ${draw} } });
        ${script}
        stepper.reset(5);</script></body></html>`);
    return file;
}

/** What a check finds on a page. */
async function found(spoilt, check, options = {}) {
    const page = await checks.open_page(browser, make(spoilt), options);
    const result = await check(page);
    await page.context().close();
    return result;
}

checks.sizes.forEach((size, k) => {
    const theme = checks.themes[k % 2];
    test(`a page that is right, ${size} ${theme}`, async () => {
        const all = async (page) => [
            ...await checks.looks_at_steps(page, 9),
            ...await checks.forward_back(page),
            ...await checks.out_of_reach(page),
            ...await checks.dead_keys(page),
            ...await checks.only_for_the_mouse(page),
            ...await checks.complaints(page)];
        assert.deepEqual(await found({}, all, { size, theme }), []);
    });
});

/** A page spoilt in one way is found by its check, with these words. */
function finds(what, check, spoilt, words) {
    test(`finds ${what}`, async () => {
        const result = await found(spoilt, check);
        assert.ok(result.length > 0, "nothing was found");
        assert.match(result.join("\n"), words);
    });
}

finds("a step that looks otherwise on the way back", checks.forward_back,
      { draw: "say.textContent += say.was || ''; say.was = k;" },
      /step 4 of 5: .*\n.*later/);
finds("what is wrong with a choice only", checks.forward_back,
      { body: "<div role='group'><button aria-pressed='true'>A</button>" +
          "<button aria-pressed='false'>B</button></div>",
        draw: "if (stepper.bad && say.was) say.textContent += say.was; " +
            "say.was = k;",
        script: "document.querySelector('[role=group]').onclick = (event) => " +
            "{ stepper.bad = event.target.textContent === 'B'; };" },
      /^B, step 4 of 5/m);
finds("what is wrong with an entry of a list only",
      (page) => checks.looks_at_steps(page, 2, 3),
      { body: "<select id='list' aria-label='size'><option>large</option>" +
          "<option>small</option></select><p id='text'>note</p>",
        script: "list.onchange = () => { text.style.fontSize = " +
            "list.value === 'small' ? '5px' : '30px'; };" },
      /^small, step 1: "note" is 5.0/m);
finds("a page that never changes", checks.forward_back,
      { draw: "say.textContent = ''; stepper.seek.value = 0; " +
          "stepper.seek.removeAttribute('aria-valuetext'); " +
          "stepper.output.textContent = 'step 1 / 2';" },
      /the same/);
finds("a label over a label", checks.looks,
      { body: `<svg viewBox="0 0 100 50" style="height: 20vh">
          <text x="10" y="20" font-size="9">V1</text>
          <text x="18" y="20" font-size="9">V2</text></svg>` },
      /"V1" and "V2" lie over one another/);
finds("a label over the background of another", checks.looks,
      { body: `<svg viewBox="0 0 100 50" style="height: 20vh">
          <g><rect x="5" y="10" width="30" height="15" fill="#eee"/>
          <text x="7" y="20" font-size="9">V1</text></g>
          <text x="27" y="20" font-size="9">V2</text></svg>` },
      /"V1" and "V2" lie over one another/);
finds("small text in a drawing", checks.looks,
      { body: `<svg viewBox="0 0 100 50" style="height: 20vh">
          <text x="10" y="20" font-size="3">V1</text></svg>` },
      /"V1" is 8.6 px high, expected at least 16.0/);
finds("small text beside a drawing", checks.looks,
      { body: "<small style='font-size: 10px'>note</small>" },
      /"note" is 10.0/);
finds("text made small by a transform", checks.looks,
      { body: "<p style='transform: scale(0.5)'>note</p>" }, /"note" is 13/);
finds("a text that is cut off", checks.looks,
      { body: "<p style='width: 3em; overflow: hidden; white-space: nowrap'>" +
          "a long sentence</p>" },
      /"a long sentence" is cut off/);
finds("a page wider than the window", checks.looks,
      { body: "<div style='width: 120vw'>x</div>" }, /px wider.*120vw/);
finds("a page higher than the window", checks.looks,
      { body: "<div style='flex: none; height: 120vh'>x</div>" },
      /px higher than the window: <button/);
finds("faint text", checks.looks,
      { body: "<p style='color: #888'>grey</p>" },
      /"grey" has contrast 3.54, expected at least 4.5/);
finds("text that only its opacity makes faint", checks.looks,
      { body: "<p style='opacity: 0.4'>pale</p>" }, /"pale"/);
finds("text like the shape under it", checks.looks,
      { body: `<svg viewBox="0 0 100 50" style="height: 20vh">
          <rect x="5" y="10" width="60" height="15" fill="#222"/>
          <text x="7" y="20" font-size="9" pointer-events="none">V1</text>
          </svg>` },
      /"V1" has contrast 1.\d+/);
finds("a control that tab does not reach", checks.out_of_reach,
      { body: "<button>lost</button>",
        script: `addEventListener("keydown", (event) => {
            if (event.key !== "Tab") return;
            event.preventDefault();
            document.querySelector(".transport button").focus(); });` },
      /tab does not reach <button> lost/);
finds("focus that is not seen", checks.out_of_reach,
      { body: "<button style='outline: none'>secret</button>" },
      /<button> secret does not show/);
finds("a dead key", checks.dead_keys,
      { script: "delete stepper.keys.PageDown;" }, /PageDown leads to step 1/);
finds("a help that does not open", checks.dead_keys,
      { script: "delete stepper.keys['?'];" }, /does not open the help/);
finds("what only a mouse can use", checks.only_for_the_mouse,
      { body: "<p style='cursor: pointer'>click me</p>" }, /<p> click me/);
finds("an error", checks.complaints,
      { script: "setTimeout(() => nothing_there, 0);" }, /nothing_there/);
finds("an error told to the console", checks.complaints,
      { script: "console.error('bad');" }, /console: bad/);
// A reserved address: nobody is ever asked, but if somebody were, nobody is
// there.
for (const asks of ["fetch('https://192.0.2.1/x').catch(() => 0)",
                    "new Image().src = 'https://192.0.2.1/x'",
                    "document.head.append(html('link', {rel: 'stylesheet', " +
                        "href: 'https://192.0.2.1/x'}))",
                    "document.head.append(html('script', {src: 'other.js'}))",
                    "new WebSocket('wss://192.0.2.1/x')"])
    finds(`a request: ${asks.slice(0, 40)}`, checks.complaints,
          { script: `${asks};` }, /asked for|WebSocket/);
