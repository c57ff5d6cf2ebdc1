// A source file with a line and an expression lit, and what can be said about
// its names from the text alone.

const declarations =
    /[{}();]|\b(?:int|auto|bool|double)\s*&?\s+(\w+)\s*(?=[=;:,)[])/g;

/** The lines of one file: {label, file, first, lines} of the recording. */
class Source {
    constructor({ label, file, first, lines }) {
        Object.assign(this, { label, file, first, lines });
        this.plain = lines.map((line) => line.replace(/\/\/.*/, ""));
        this.half_edge_names = half_edge_names(this.plain.join("\n"));
        this.shadows = find_shadows(this.plain, first);
    }

    text(line) {
        return this.lines[line - this.first] || "";
    }

    /** The line where a function begins; 0 when it is not found. */
    definition(name) {
        const begin = new RegExp(`^\\w.*\\b${name}\\(`);
        const k = this.plain.findIndex((text) => begin.test(text));
        return k < 0 ? 0 : this.first + k;
    }

    /** [before, expression, after] of columns that are counted in bytes. */
    split(line, [from, to]) {
        const bytes = new TextEncoder().encode(this.text(line));
        return [[0, from - 1], [from - 1, to - 1], [to - 1]].map(
            (range) => new TextDecoder().decode(bytes.slice(...range)));
    }
}

/** Of a walk that no program made. */
const no_source = new Source({ first: 1, lines: [] });

/** Names of variables that hold half-edges: he[X].vi, then A = X, A != X. */
function half_edge_names(text) {
    const names = new Set();
    for (const [, name] of text.matchAll(/\w\[(\w+)\]\.(?:vi|fi|next|opp)\b/g))
        names.add(name);
    for (const [, name] of text.matchAll(/(\w+)\s*=[^=;]*\.(?:next|opp);/g))
        names.add(name);
    for (let size = -1; size !== names.size;) {
        size = names.size;
        const pairs = text.matchAll(/(\w+)\s*[!=]?=\s*(\w+)\s*[;)]/g);
        for (const [, a, b] of pairs) {
            if (names.has(b)) names.add(a);
            if (names.has(a)) names.add(b);
        }
    }
    return new Set([...names].filter((name) => !/^\d/.test(name)));
}

/**
 * Declarations of a name that an outer scope of the same function has, too:
 * [{name, line}].
 */
function find_shadows(lines, first) {
    const scopes = [[]];
    const shadows = [];
    const pending = [];  // names in parentheses belong to the block after them
    let parentheses = 0;
    const on = {
        "(": () => ++parentheses,
        ")": () => --parentheses,
        "{": () => scopes.push(pending.splice(0)),
        "}": () => scopes.pop(),
        ";": () => parentheses || pending.splice(0),
    };
    const declare = (name, line) => {
        if (scopes.flat().includes(name)) shadows.push({ name, line });
        (parentheses ? pending : scopes[scopes.length - 1] || []).push(name);
    };
    lines.forEach((text, k) => {
        for (const [token, name] of text.matchAll(declarations))
            if (name) declare(name, first + k);
            else on[token]();
    });
    return shadows;
}

class CodePicture {
    /** box: a block element, which gets the lines and scrolls by itself. */
    constructor(box) {
        this.box = box;
        box.classList.add("code-picture");
    }

    /** As wide as lets the lines fit, not below the size of the style, and
     *  larger by its --grow at most. */
    fit(source) {
        const inner = source.plain.filter((text) => /^\s/.test(text));
        const longest = Math.max(...inner.map((t) => t.trimEnd().length), 20);
        this.box.style.fontSize = "";
        const style = getComputedStyle(this.box);
        const least = parseFloat(style.fontSize);
        const most = least * parseFloat(style.getPropertyValue("--grow"));
        const fitting = this.box.clientWidth / (0.61 * longest + 2);
        this.box.style.fontSize =
            Math.max(least, Math.min(fitting, most)) + "px";
    }

    /** line 0: none is lit; columns: [from, to) of the lit expression. */
    show(source, line, columns) {
        this.box.textContent = "";
        this.fit(source);
        source.lines.forEach((text, k) => {
            const here = source.first + k === line;
            const parts = here && columns ? this.lit(source, line, columns)
                                          : [text.trimStart() || " "];
            const indent = Math.min(text.search(/\S|$/), 16);
            this.box.append(html(
                "div", { class: here ? "line current" : "line",
                         "data-line": source.first + k,
                         style: `--indent: ${indent}ch` },
                html("code", {}, ...parts)));
        });
        const lit = this.box.querySelector(".current") ||
            this.box.firstElementChild;
        if (lit) scroll_to_middle(this.box, lit);
    }

    lit(source, line, columns) {
        const [before, expression, after] = source.split(line, columns);
        return [before.trimStart(), html("mark", {}, expression), after];
    }
}
