// What happens at a step of a walk, in words: {main, more}, where main is the
// large sentence and more, which may be "", says what it means.

function say_state(walk, k, state) {
    if (k === 0) return say_call(walk);
    if (walk.is_last(k)) return say_end(walk);
    const step = walk.step(k);
    if (step.i === undefined) return say_line(walk, step, state);
    const skipped = walk.skipped && k === walk.steps.length
        ? `${walk.skipped} reads later. ` : "";
    return { main: say_access(walk, step),
             more: skipped + say_meaning(walk, step, state) };
}

function say_call(walk) {
    return { main: walk.call,
             more: walk.starts_at_half_edge
                 ? `The walk starts at H${walk.start}.` : "" };
}

/** he[4].next, as the source calls the table. */
function access_text(walk, { l, c, i, f }) {
    const name = c && walk.code.split(l, c)[1].match(/^(\w+)\[/);
    const field = f === undefined ? "" : "." + field_names[f];
    return `${name ? name[1] : "he"}[${i}]${field}`;
}

function say_access(walk, step) {
    const { i, f, v, w } = step;
    if (step.new) return `Row H${i} is new: ${step.new.join(", ")}`;
    const what = access_text(walk, step);
    if (f === undefined)
        return `${what} is ${w === undefined ? "read" : "written"}`;
    if (w !== undefined) return `${what} becomes ${v} (was ${w})`;
    return `${what} is ${v}` + (v < 0 ? "" : ` – ${value_kinds[f]}${v}`);
}

/** What the value means, and which variables have changed. */
function say_meaning(walk, step, state) {
    const { f, v, w } = step;
    const parts = [];
    if (w === undefined && f === 1 && v < 0) parts.push("no face: border");
    if (f >= 2 && v === state.start && w === undefined)
        parts.push(`H${v} is the start`);
    parts.push(...say_changes(walk, step, state));
    return parts.join(" · ");
}

function say_changes(walk, { l, d = {} }, state) {
    return Object.entries(d).filter(([, value]) => value !== null)
        .slice(0, 3).map(([name, value]) => {
            const outer = walk.code.shadow(name, l) &&
                state.variables.get(name);
            const text = `${name} = ${value_text(value)}`;
            return outer ? `a second ${text}; the outer ${name} stays ` +
                value_text(outer.value) : text;
        });
}

function say_line(walk, step, state) {
    const text = walk.code.text(step.l).trim().replace(/\s*\/\/.*/, "");
    return { main: `line ${step.l}: ${text}`,
             more: say_condition(walk, text, step.l, state) ||
                 say_changes(walk, step, state).join(" · ") };
}

const comparisons = {
    "!=": (a, b) => a !== b, "==": (a, b) => a === b, "<": (a, b) => a < b,
    ">": (a, b) => a > b, "<=": (a, b) => a <= b, ">=": (a, b) => a >= b,
};

/** while (i != start): what the two are, and so whether it goes on. */
function say_condition(walk, text, line, { variables }) {
    const found = text.match(
        /\b(while|if) \((\w+) ([!=<>]=?) (-?\w+)\)/);
    if (!found) return "";
    const [, word, left, sign, right] = found;
    const value = (name) => /^-?\d+$/.test(name) ? Number(name)
        : (variables.get(name) || {}).value;
    const [a, b] = [value(left), value(right)];
    if (a === undefined || b === undefined) return "";
    const holds = comparisons[sign](a, b);
    const values = [[left, a], [right, b]].filter(([name]) => /^\D/.test(name))
        .map(([name, x]) => `${name} is ${x}`).join(", ");
    if (word === "if") return `${values}: ${holds ? "yes" : "no"}`;
    if (holds) return `${values}: not the same, go on`;
    return `${values}: ${sign === "!=" ? "the same, " : ""}the loop ends`;
}

function say_end(walk) {
    if (walk.error) return { main: walk.error, more: "" };
    const result = value_text(walk.result);
    if (walk.expected === undefined || same_result(walk.expected, walk.result))
        return { main: `returns ${result}`, more: say_why_ended(walk) };
    const expected = value_text(walk.expected);
    return Array.isArray(walk.expected)
        ? { main: `returns ${result}`,
            more: `The reference returns ${expected}.` }
        : { main: `returns ${result}, expected ${expected}`, more: "" };
}

/** Equal, or the same list begun at another place. */
function same_result(a, b) {
    const [left, right] = [a, b].map((x) => JSON.stringify(x));
    if (left === right) return true;
    if (!Array.isArray(a) || !Array.isArray(b)) return false;
    return b.some((x, k) =>
        JSON.stringify([...b.slice(k), ...b.slice(0, k)]) === left);
}

/** A walk ends when it is back where it began: say it when it is so. */
function say_why_ended(walk) {
    const accesses = walk.steps.filter((step) => step.i !== undefined);
    const { f, v } = accesses[accesses.length - 1] || {};
    return walk.starts_at_half_edge && f >= 2 && v === walk.start &&
        accesses.length > 1 ? `The walk is back at the start, H${v}.` : "";
}
