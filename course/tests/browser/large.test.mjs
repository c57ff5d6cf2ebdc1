// The page of a mesh that is too large for a drawing: what every page must
// hold, and that a click picks what lies there.
import assert from "node:assert/strict";
import { fileURLToPath } from "node:url";
import { after, before, test } from "node:test";
import * as checks from "./page_checks.mjs";
import { temporary_folder, walk_page } from "./pages.mjs";

const mesh = fileURLToPath(
    new URL("../../../data/meshes/sphere.obj", import.meta.url));
const folder = temporary_folder();
let browser;
let file;

before(async () => {
    browser = await checks.start_browser();
    file = await walk_page(folder.path, "vertex_star", undefined, "--mesh",
                           mesh, "--start", "0", "17");
});
after(async () => {
    await browser?.close();
    folder.remove();
});

/** What `look` finds on the page. */
async function found(look, options) {
    const page = await checks.open_page(browser, file, options);
    try {
        return await look(page);
    } finally {
        await page.context().close();
    }
}

/** In the page: clicks a little inside of its face at each half-edge that is
    seen, where the face is not seen too much from the side. */
async function pick_all() {
    const frame = () => new Promise(requestAnimationFrame);
    const wrong = [];
    let picked = 0;
    for (let h = 0; h < table.size; ++h) {
        show_all();
        await frame();
        await frame();
        const { yaw, pitch } = camera.view;
        const [nx, ny, nz] = geometry.normal_beside(h);
        const towards = nx * Math.cos(pitch) * Math.sin(yaw) +
            ny * Math.sin(pitch) + nz * Math.cos(pitch) * Math.cos(yaw);
        if (towards < 0.6) continue;
        const { x, y } = camera.project(arrow_in_space(geometry, h).middle);
        const box = at_id("stage").getBoundingClientRect();
        at_id("stage").dispatchEvent(new MouseEvent("click", {
            clientX: box.left + x, clientY: box.top + y }));
        picked += 1;
        if (walk.start !== h) wrong.push([h, walk.start]);
    }
    return { picked, wrong };
}

const said = (page) => page.textContent("#say");

test("nothing is asked for, keys do all", async () => {
    assert.deepEqual(await found(async (page) =>
        [...await checks.dead_keys(page), ...await checks.out_of_reach(page),
         // The number of a half-edge does what a click there does.
         ...await checks.only_for_the_mouse(page, "svg g, tr, #stage"),
         ...await checks.complaints(page)]), []);
});

test("forward and back are the same", async () => {
    assert.deepEqual(await found((page) => checks.forward_back(page)), []);
});

checks.sizes.forEach((size, k) =>
    test(`legible at ${size.join(" x ")}`, async () => {
        const theme = checks.themes[k % 2];
        assert.deepEqual(await found((page) =>
            checks.looks_at_steps(page, 4), { size, theme }), []);
    }));

test("walks by hand read the table that was recorded", async () => {
    assert.match(await found(async (page) => {
        await page.fill("#go", "17");
        await page.keyboard.press("Enter");
        for (const key of ["t", "t", "t", "t", "t", "t"])
            await page.keyboard.press(key);
        return said(page);
    }), /^H17 leaves V\d+, along F\d+The start again, after 12 reads\.$|^H/);
});

test("a click picks the half-edge that is nearest", async () => {
    const { picked, wrong } = await found(async (page) => {
        await page.emulateMedia({ reducedMotion: "reduce" });
        return page.evaluate(pick_all);
    });
    assert.deepEqual(wrong, []);
    assert.ok(picked > 100, `${picked} half-edges were seen`);
});

test("a half-edge that is none is said to be none", async () => {
    assert.match(await found(async (page) => {
        await page.fill("#go", "960");
        await page.keyboard.press("Enter");
        return said(page);
    }), /There is no H960.*0 to 959/);
});
