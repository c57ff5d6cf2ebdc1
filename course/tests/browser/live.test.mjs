// Live mode in a browser: the page follows the file, keeps its place, says what
// is wrong with the file, and asks nobody else for anything.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { readFileSync, renameSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { after, before, test } from "node:test";
import * as checks from "./page_checks.mjs";
import { temporary_folder } from "./pages.mjs";

const folder = temporary_folder();
const file = join(folder.path, "walk.cpp");
const code = (body) => '#include "exercises/01_traversal/face_sides.h"\n' +
    `int face_sides(const HalfEdgeTable& he, int i) {\n${body}\n}\n`;
const walk = (value) => code("    int start = i, sides = 0;\n    do {\n" +
    "        ++sides;\n        i = he[i].next;\n" +
    `    } while (i != start);\n    return ${value};`);
let browser;
let lab;
let page;

/** As editors do it. */
function save(text) {
    writeFileSync(`${file}~`, text);
    renameSync(`${file}~`, file);
}

async function address_of(process) {
    for await (const line of createInterface({ input: process.stdout })) {
        const found = line.match(/http:\S+/);
        if (found) return found[0];
    }
    throw new Error("lab printed no address");
}

/** Waits for a text in the frame around the page, or in the page. */
const says = (words) => page.getByText(words).first().waitFor();
const walk_says = (words) => page.frameLocator("iframe:not(.coming)")
    .locator("#say").getByText(words).first().waitFor();

before(async () => {
    save(walk("sides"));
    lab = spawn(process.env.LAB, ["demo", "face_sides", "--live", "--file",
                                  file], { stdio: ["ignore", "pipe", "pipe"] });
    browser = await checks.start_browser();
    page = await checks.open_address(browser, await address_of(lab));
    page.setDefaultTimeout(60_000);
});
after(async () => {
    lab?.kill("SIGKILL");
    await browser?.close();
    folder.remove();
});

test("a save is shown at the step where the page stood", async () => {
    await walk_says("face_sides");
    await page.keyboard.press("End");
    await walk_says("returns");
    const frame = () => page.frames()[1];
    await frame().evaluate(() => { location.hash = "i=4&step=0&source=1"; });
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("ArrowRight");
    const link = await frame().evaluate(() => location.hash);
    assert.match(link, /i=4&step=2&source=1/);
    save(walk("sides + 7"));
    await page.waitForFunction(() => {
        const frames = document.querySelectorAll("iframe");
        return frames.length === 1 && frames[0].src.includes("page?2");
    });
    assert.equal(await frame().evaluate(() => location.hash), link);
    await page.keyboard.press("End");
    await walk_says("returns 11");
});

test("a file that does not compile is told, with its line", async () => {
    save(code("    return he[i].nxt;"));
    await says(/line 3: .*nxt/);
    await walk_says("returns 11");
    assert.deepEqual(await checks.looks(page), []);
    save(walk("sides"));
    await page.locator("#say:empty").waitFor({ state: "attached" });
});

test("nobody else is asked for anything, and there is no error", async () => {
    assert.deepEqual(await checks.complaints(page), []);
});

test("Ctrl-C ends it, and the page says so", async () => {
    const ended = new Promise((wake) => lab.on("exit", wake));
    lab.kill("SIGINT");
    assert.equal(await ended, 0);
    await says(/Live mode has ended/);
});
