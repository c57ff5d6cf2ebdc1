// The pages of recorded walks: what every page must hold, and that what they
// show is true.
import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { FaceList, is_right, oracle } from "./oracle.mjs";
import * as checks from "./page_checks.mjs";
import { data_of, size_of, temporary_folder, walk_page } from "./pages.mjs";

const include = (name) => `#include "exercises/01_traversal/${name}.h"\n\n`;
// Files as students write them, wrong in the ways that the lecture warns of.
const wrong = {
    face_sides: include("face_sides") +
        "int face_sides(const HalfEdgeTable& he, int i) {\n" +
        "    int start = i, sides = 0;\n    do {\n        ++sides;\n" +
        "        i = he[he[i].opp].opp;\n        i = he[i].next;\n" +
        "        if (sides == 3) i = he[i].fi;\n" +
        "    } while (i != start);\n    return sides;\n}\n",
    vertex_star: include("vertex_star") +
        "std::vector<int> vertex_star(const HalfEdgeTable& he, int i) {\n" +
        "    std::vector<int> star;\n    int start = i;\n    do {\n" +
        "        int i = he[start].opp;\n        star.push_back(he[i].vi);\n" +
        "        i = he[i].next;\n    } while (i != start);\n" +
        "    return star;\n}\n",
};

let browser;
const folder = temporary_folder();
const pages = {};
const names = [...Object.keys(oracle), "face_sides_file", "vertex_star_file"];
// All pages have the same scripts: those of the wrong files show most.
const looked_at = checks.all ? names
    : ["face_sides", "face_sides_file", "vertex_star_file"];

before(async () => {
    browser = await checks.start_browser();
    for (const name of Object.keys(oracle))
        pages[name] = join(process.env.PAGES, `walk_${name}.html`);
    for (const [name, code] of Object.entries(wrong))
        pages[`${name}_file`] = await walk_page(folder.path, name, code);
});
after(async () => {
    await browser?.close();
    folder.remove();
});

/** What `look` finds on a page. */
async function found(name, look, options) {
    const page = await checks.open_page(browser, pages[name], options);
    try {
        return await look(page);
    } finally {
        await page.context().close();
    }
}

test("the walks return what brute force over the faces returns", () => {
    for (const exercise of Object.keys(oracle)) {
        const { mesh, walks } = data_of(pages[exercise]);
        const faces = new FaceList(mesh);
        assert.deepEqual(faces.faults(), []);
        assert.ok(walks.length > 1, `${exercise}: ${walks.length} walks`);
        for (const { call, start, result } of walks)
            assert.ok(is_right(exercise, faces, start, result),
                      `${call} returned ${JSON.stringify(result)}`);
    }
});

test("a wrong file is shown beside the reference, and as wrong", () => {
    for (const exercise of Object.keys(wrong)) {
        const { mesh, sources, walks } = data_of(pages[`${exercise}_file`]);
        const faces = new FaceList(mesh);
        assert.equal(sources.length, 2);
        const own = walks.filter(({ source }) => source === 1);
        assert.equal(own.length * 2, walks.length);
        for (const { call, start, result, error, expected } of own) {
            assert.ok(is_right(exercise, faces, start, expected), call);
            assert.ok((result === undefined) !== (error === undefined), call);
        }
        assert.ok(own.some(({ start, result }) => result === undefined ||
            !is_right(exercise, faces, start, result)), exercise);
    }
});

test("a page of walks is below 200 kB", () => {
    const all = readdirSync(process.env.PAGES)
        .filter((name) => name.startsWith("walk_"))
        .map((name) => join(process.env.PAGES, name));
    assert.ok(all.length > 30);
    for (const page of [...all, ...Object.values(pages)])
        assert.ok(size_of(page) < 200_000, `${page}: ${size_of(page)} bytes`);
});

describe("each page", { concurrency: 4 }, () => {
    for (const name of looked_at) {
        test(`${name}: nothing is asked for, keys do all`, async () => {
            assert.deepEqual(await found(name, async (page) => {
                console.log(`${name}: opened in ` +
                            `${page.opened_in.toFixed(0)} ms`);
                return [...await checks.dead_keys(page),
                        ...await checks.out_of_reach(page),
                        // A number and Enter do what a click there does.
                        ...await checks.only_for_the_mouse(page, "svg g, tr"),
                        ...await checks.looks_at_steps(page, 2, 4),
                        ...await checks.complaints(page)];
            }), []);
        });
        test(`${name}: forward and back are the same`, async () => {
            // One page with all its starts.
            const most = name === "face_sides" ? Infinity : 1;
            assert.deepEqual(await found(name, (page) =>
                checks.forward_back(page, most)), []);
        });
        // Another theme changes no sizes: each size needs only one of them.
        checks.sizes.forEach((size, k) =>
            test(`${name}: legible at ${size.join(" x ")}`, async () => {
                const theme = checks.themes[k % 2];
                assert.deepEqual(await found(name, (page) =>
                    checks.looks_at_steps(page, 6), { size, theme }), []);
            }));
    }
});

/** Sources of which too little is seen at a step: all lines, or so many. */
const hidden_sources = (least) => {
    const seen = (line) => {
        const box = line.closest(".code").getBoundingClientRect();
        const { top, bottom } = line.getBoundingClientRect();
        return top >= box.top - 1 && bottom <= box.bottom + 1;
    };
    checks.hidden_sources = () => [...document.querySelectorAll(".code")]
        .flatMap((code) => {
            const lines = [...code.querySelectorAll(".line")];
            const count = lines.filter(seen).length;
            const lit = code.querySelector("mark, .current");
            const found = lit && !seen(lit) ? ["the lit line is hidden"] : [];
            if (count < Math.min(least, lines.length))
                found.push(`${count} of ${lines.length} lines are seen`);
            return found;
        });
    return checks.at_steps([["hidden_sources"]], Infinity);
};

describe("two walks side by side", { concurrency: 4 }, () => {
    for (const name of ["face_sides_file", "vertex_star_file"])
        for (const size of checks.sizes)
            test(`${name} at ${size.join(" x ")}`, async () => {
                assert.deepEqual(await found(name, async (page) => {
                    await page.keyboard.press("c");
                    return [...await checks.looks_at_shown_steps(page, 6),
                            ...await page.evaluate(hidden_sources, 10),
                            ...await checks.complaints(page)];
                }, { size }), []);
            });
});

test("a number and Enter start the walk there", async () => {
    const said = await found("face_sides", async (page) => {
        for (const key of ["1", "2", "Enter", "End"])
            await page.keyboard.press(key);
        return page.textContent("#say");
    });
    const { walks } = data_of(pages.face_sides);
    const { result } = walks.find(({ start }) => start === 12);
    assert.match(said, new RegExp(`returns ${result}`));
});

test("why the shadowed variable visits one edge is said", async () => {
    const said = await found("vertex_star_file", (page) => page.evaluate(() =>
        [...Array(player.stepper.count).keys()].map((k) => {
            player.stepper.go(k);
            return document.getElementById("say").textContent;
        })), { link: "i=4" });
    for (const words of ["a second i = 3; the outer i stays 4",
                         "a second i = 5; the outer i stays 4",
                         "the second i is gone; i is 4, start is 4: the same, " +
                             "the loop ends",
                         "Line 7 declares a second i; the outer i stays 4"])
        assert.ok(said.some((text) => text.includes(words)),
                  `${words} is not in\n${said.join("\n")}`);
});

test("the last step says what was returned, from each start", async () => {
    const { walks } = data_of(pages.face_sides);
    const wrong_ones = await found("face_sides", async (page) => {
        const bad = [];
        for (const { start, result } of walks) {
            await page.evaluate((i) => { location.hash = `i=${i}`; }, start);
            await page.waitForFunction((i) =>
                player.state().walk === i, walks.findIndex((walk) =>
                walk.start === start));
            await page.keyboard.press("End");
            const said = await page.textContent("#say");
            if (!said.includes(`returns ${result}`)) bad.push([start, said]);
        }
        return bad;
    });
    assert.deepEqual(wrong_ones, []);
});
