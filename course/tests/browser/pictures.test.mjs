// The other pictures of the notes, and the page that lists them: what every
// page must hold.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import * as checks from "./page_checks.mjs";
import { data_of } from "./pages.mjs";

const folder = process.env.PAGES;
const text_of = (name) => readFileSync(join(folder, name), "utf8");
// Pages of walks have their own tests.
const pages = readdirSync(folder).filter((name) =>
    name.endsWith(".html") && !(text_of(name).includes('id="page-data"') &&
                                data_of(join(folder, name))?.walks));
let browser;

before(async () => {
    browser = await checks.start_browser();
});
after(async () => {
    await browser?.close();
});

/** What `look` finds on a page; `has_steps` tells it of what kind that is. */
async function found(name, look, options) {
    const page = await checks.open_page(browser, join(folder, name),
                                        options);
    try {
        const has_steps = await page.locator(".transport").count() > 0;
        return await look(page, has_steps);
    } finally {
        await page.context().close();
    }
}

test("there are pictures", () => assert.ok(pages.length > 1, pages.join()));

describe("each picture", { concurrency: 4 }, () => {
    pages.forEach((name, n) => {
        test(`${name}: nothing is asked for, keys do all`, async () => {
            assert.deepEqual(await found(name, async (page, has_steps) => {
                console.log(`${name}: opened in ` +
                            `${page.opened_in.toFixed(0)} ms`);
                return [...has_steps ? await checks.dead_keys(page) : [],
                        ...has_steps ? await checks.forward_back(page, 4) : [],
                        ...await checks.out_of_reach(page),
                        ...await checks.only_for_the_mouse(page),
                        ...await checks.complaints(page)];
            }), []);
        });
        // Another theme changes no sizes: each size needs only one of them.
        checks.sizes.forEach((size, k) => {
            if (!checks.all && k !== n % 3) return;
            test(`${name}: legible at ${size.join(" x ")}`, async () => {
                const theme = checks.themes[k % 2];
                assert.deepEqual(await found(name, (page, has_steps) =>
                    has_steps ? checks.looks_at_steps(page, 5, 4)
                              : checks.looks(page), { size, theme }), []);
            });
        });
    });
});
