// The pages that are tested: made by the lab program of this build.
import { execFile } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, statSync,
         writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { promisify } from "node:util";

/** A folder that is gone when the tests are. */
export function temporary_folder() {
    const path = mkdtempSync(join(tmpdir(), "pages-"));
    return { path, remove: () => rmSync(path, { recursive: true }) };
}

/** Runs `lab demo` with these arguments. */
async function demo(...arguments_) {
    await promisify(execFile)(process.env.LAB, ["demo", ...arguments_],
                              { timeout: 120_000 });
}

/** Makes the page of an exercise; `code` is the text of a student's file. */
export async function walk_page(folder, exercise, code, ...more) {
    const name = `${exercise}${code ? "_file" : ""}`;
    const page = join(folder, `${name}.html`);
    if (code) {
        const file = join(folder, `${name}.cpp`);
        writeFileSync(file, code);
        more.push("--file", file);
    }
    await demo(exercise, "--out", page, ...more);
    return page;
}

/** What the scripts of a page read as `page_data`. */
export function data_of(page) {
    const text = readFileSync(page, "utf8");
    const [, json] = text.match(
        /<script type="application\/json" id="page-data">([^]*?)<\/script>/);
    return JSON.parse(json);
}

export const size_of = (page) => statSync(page).size;
