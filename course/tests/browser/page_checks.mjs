// Checks for every page of the player, in a real browser. Each returns what it
// found wrong, as sentences; an empty list is a page that is right.
import { createRequire } from "node:module";
import { fileURLToPath, pathToFileURL } from "node:url";

// The browser's packages are in the build tree: see run, beside this file.
const require = createRequire(`${process.env.BROWSER_MODULES}/`);
const { chromium } = require("playwright-core");

/** Windows that a page must suit: a laptop, an old projector, and a projector
    as the last row of a lecture room sees it. */
export const sizes = [[1280, 720], [1024, 768], [480, 270]];
export const themes = ["light", "dark"];
/** Every page at every size, or a part of them: that takes a third of the time
    on a machine that has better things to do. */
export const all = Boolean(process.env.ALL_PAGES);

/** A browser that asks nothing of anybody by itself. */
export function start_browser() {
    return chromium.launch({
        executablePath: process.env.BROWSER_PROGRAM,
        args: ["--no-sandbox", "--disable-gpu", "--no-first-run",
               "--disable-background-networking", "--disable-sync",
               "--disable-component-update"],
    });
}

/** Lets a page ask for nothing but what begins with its address, and keeps what
    it complains of in `page.complaints`. */
async function watch(page, address) {
    page.complaints = [];
    const complain = (what) => page.complaints.push(what);
    page.on("pageerror", (error) => complain(`error: ${error.message}`));
    page.on("console", (message) => {
        if (["error", "warning"].includes(message.type()))
            complain(`console: ${message.text()}`);
    });
    page.on("websocket", (socket) => complain(`asked for ${socket.url()}`));
    await page.context().route("**/*", (route) => {
        const asked = route.request().url();
        if (asked.startsWith(address)) return route.continue();
        complain(`asked for ${asked}`);
        return route.abort();
    });
    await page.addInitScript({
        path: fileURLToPath(new URL("in_page.js", import.meta.url)) });
}

/** Opens an address of this machine. */
export async function open_address(browser, address,
                                   { size = sizes[0], theme = "light",
                                     offline = false, link = "" } = {}) {
    const context = await browser.newContext({
        viewport: { width: size[0], height: size[1] }, colorScheme: theme,
        offline });
    const page = await context.newPage();
    page.setDefaultTimeout(20_000);
    await watch(page, address);
    const start = performance.now();
    await page.goto(address + (link && `#${link}`));
    await page.evaluate(() => new Promise(requestAnimationFrame));
    /** Until it was drawn, in ms. */
    page.opened_in = performance.now() - start;
    return page;
}

/** Opens a page from its file, with no network at all. */
export function open_page(browser, file, options = {}) {
    return open_address(browser, pathToFileURL(file).href,
                        { ...options, offline: true });
}

/** Errors and requests since the page was opened. */
export async function complaints(page) {
    await page.evaluate(() => new Promise(requestAnimationFrame));
    return page.complaints;
}

/** Steps that look otherwise when they are come back to, with at most `most`
    of the choices that each of the page's lists offers. */
export function forward_back(page, most = Infinity) {
    return page.evaluate((most) => checks.with_choices(checks.forward_back,
                                                       most), most);
}

/** What is wrong with a page as it looks. Smallest text: 1/45 of the window's
    height; contrast: WCAG 2, level AA, for small text. */
const looks_of = (page) => [["small_texts", page.viewportSize().height / 45],
                            ["overlaps"], ["cut_texts"], ["overflow"],
                            ["faint_texts", 4.5]];

/** As it stands. */
export function looks(page) {
    return page.evaluate((looks) => looks.flatMap(([name, given]) =>
        checks[name](given)), looks_of(page));
}

/** At some steps of what is shown, at most `steps`. */
export function looks_at_shown_steps(page, steps) {
    return page.evaluate(([looks, steps]) => checks.at_steps(looks, steps),
                         [looks_of(page), steps]);
}

/** At some steps, at most `steps`, with at most `most` of the choices that each
    of the page's lists offers. */
export function looks_at_steps(page, steps, most = 1) {
    return page.evaluate(([looks, steps, most]) => checks.with_choices(() =>
        checks.at_steps(looks, steps), most), [looks_of(page), steps, most]);
}

/** Controls that the tab key does not reach, or whose focus is not seen. */
export async function out_of_reach(page) {
    const expected = await page.evaluate(() => {
        document.activeElement.blur();
        globalThis.reached = new Set();
        return checks.controls().length;
    });
    const found = [];
    for (let k = 0; k < expected + 2; ++k) {
        await page.keyboard.press("Tab");
        const hidden = await page.evaluate(() => {
            const focus = document.activeElement;
            reached.add(focus);
            const { outlineStyle, boxShadow } = getComputedStyle(focus);
            const seen = outlineStyle !== "none" || boxShadow !== "none";
            return seen || focus === document.body ? "" : checks.name(focus);
        });
        if (hidden) found.push(`${hidden} does not show that it has focus`);
    }
    const missed = await page.evaluate(() => checks.controls()
        .filter((control) => !reached.has(control)).map(checks.name));
    return [...found, ...missed.map((name) => `tab does not reach ${name}`)];
}

/** Keys of a clicker and of a keyboard that do not do what the help says. */
export async function dead_keys(page) {
    const found = [];
    const { n } = await page.evaluate(() => {
        // In a list or a slider the keys are the control's own.
        document.activeElement.blur();
        return checks.place();
    });
    const keys = [["End", n], ["Home", 1], ["ArrowRight", 2], ["ArrowLeft", 1],
                  ["PageDown", 2], ["PageUp", 1]];
    for (const [key, step] of keys) {
        await page.keyboard.press(key);
        const { k } = await page.evaluate(() => checks.place());
        if (k !== Math.min(step, n))
            found.push(`${key} leads to step ${k}, expected ${step}`);
    }
    return [...found, ...await key_of_the_help(page)];
}

async function key_of_the_help(page) {
    const opened = () => page.evaluate(() =>
        Boolean(document.querySelector("dialog[open]")));
    await page.keyboard.press("?");
    if (!await opened()) return ["? does not open the help"];
    const found = await looks(page);
    await page.keyboard.press("Escape");
    if (await opened()) found.push("Escape does not close the help");
    return found;
}

/** What only a mouse can use, but for what has another way of its own. */
export async function only_for_the_mouse(page, other_way = "nothing") {
    return page.evaluate((other_way) => checks.only_for_the_mouse(other_way),
                         other_way);
}
