// What happens at a step of a walk, in words: {main, more}, where main is the
// large sentence and more, which may be "", says what it means.

function say_state(walk, k, state) {
    if (k === 0) return say_call(walk);
    if (walk.is_last(k)) return say_end(walk, state);
    const step = walk.step(k);
    if (step.n !== undefined)
        return { main: `The table has ${step.n} rows now`, more: "" };
    if (step.i === undefined) return say_line(walk, step, state);
    return { main: say_access(walk, step),
             more: say_meaning(walk, step, state) };
}

function say_call(walk) {
    const kind = { "half-edge": "H", vertex: "V", face: "F" };
    const letter = kind[walk.recording.starts];
    return { main: walk.call,
             more: letter ? `The walk starts at ${letter}${walk.start}.` : "" };
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
    if (f === undefined) return `${what} is read`;
    if (w !== undefined) return `${what} becomes ${v} (was ${w})`;
    return `${what} is ${v}` + (v < 0 ? "" : ` – ${value_kinds[f]}${v}`);
}

/** What the value means, and which variables have changed. */
function say_meaning(walk, step, state) {
    const { f, v, w } = step;
    const parts = say_function(step, state);
    if (step.o) parts.push("in the table as it was given");
    if (w === undefined && f === 1 && v < 0) parts.push("no face: border");
    if (f >= 2 && v === state.start && w === undefined)
        parts.push(`H${v} is the start`);
    parts.push(...say_changes(step, state));
    return parts.join(" · ");
}

function say_changes({ d = {} }, { variables }) {
    return Object.keys(d).filter((key) => variables.has(key))
        .slice(0, 3).map((key) => {
            const { name, value, line } = variables.get(key);
            const text = `${name} = ${value_text(value)}`;
            const outer = line && variables.get(name);
            return outer ? `a second ${text}; the outer ${name} stays ` +
                value_text(outer.value) : text;
        });
}

function say_line(walk, step, state) {
    const text = walk.code.text(step.l).trim().replace(/\s*\/\/.*/, "");
    const condition = say_condition(text, state);
    return { main: `line ${step.l}: ${text}`,
             more: condition
                 ? [...say_end_of_second(step), condition].join("; ")
                 : [...say_function(step, state), ...say_changes(step, state)]
                     .join(" · ") };
}

/** A variable that hid another one of its name is gone: a surprise to those who
 *  take the two for one. */
function say_end_of_second({ d = {} }) {
    return Object.keys(d).filter((key) => d[key] === null)
        .flatMap((key) => key.match(/^\S+(?= \(line)/) || [])
        .map((name) => `the second ${name} is gone`);
}

/** Said when it is another function than in the step before. */
function say_function({ fn }, { is_back }) {
    return fn ? [`${is_back ? "back" : "now"} in ${fn}`] : [];
}

const comparisons = {
    "!=": (a, b) => a !== b, "==": (a, b) => a === b, "<": (a, b) => a < b,
    ">": (a, b) => a > b, "<=": (a, b) => a <= b, ">=": (a, b) => a >= b,
};

/** while (i != start): what the two are, and so whether it goes on. */
function say_condition(text, { variables }) {
    const found = text.match(
        /\b(while|if) \((\w+) ([!=<>]=?) (-?\w+)\)/);
    if (!found) return "";
    const [, word, left, sign, right] = found;
    const is_name = (text) => /^[a-z_]/i.test(text);
    const value = (text) => is_name(text) ? variables.get(text)?.value
                                          : Number(text);
    const [a, b] = [value(left), value(right)];
    if (a === undefined || b === undefined) return "";
    const holds = comparisons[sign](a, b);
    const values = [[left, a], [right, b]]
        .filter(([name]) => is_name(name))
        .map(([name, x]) => `${name} is ${x}`).join(", ");
    if (word === "if") return `${values}: ${holds ? "yes" : "no"}`;
    const same = { true: "not the same, ", false: "the same, " };
    return `${values}: ${sign === "!=" ? same[holds] : ""}` +
        (holds ? "go on" : "the loop ends");
}

function say_end(walk, state) {
    const left_out = walk.skipped
        ? `${walk.skipped} more reads are not shown.` : "";
    const more = (...parts) => parts.filter(Boolean).join(" ");
    const { error, result, expected, expected_error } = walk;
    if (error)
        return { main: error,
                 more: more(say_reference(walk), say_shadow(walk, state),
                            left_out) };
    const main = `returns ${value_text(result)}`;
    if (!differs(walk))
        return { main, more: more(say_why_ended(walk), left_out) };
    const hint = more(say_shadow(walk, state), left_out);
    if (expected_error)
        return { main, more: more(`The reference: ${expected_error}`, hint) };
    const other = value_text(expected);
    return Array.isArray(expected)
        ? { main, more: more(`The reference returns ${other}.`, hint) }
        : { main: `${main}, expected ${other}`, more: hint };
}

/** What the reference does where a file is stopped. */
function say_reference({ expected, expected_error }) {
    if (expected_error) return "The reference stops, too.";
    return expected === undefined ? ""
        : `The reference returns ${value_text(expected)}.`;
}

/** A declaration that hides a variable of the same name is a likely cause. */
function say_shadow(walk, { variables }) {
    const shadow = walk.code.shadows.find(({ line }) =>
        walk.steps.some(({ l }) => l === line));
    if (!shadow) return "";
    const { name, line } = shadow;
    const outer = variables.get(name);
    return `Line ${line} declares a second ${name}` +
        (outer ? `; the outer ${name} stays ${value_text(outer.value)}.` : ".");
}

function is_wrong(walk) {
    return walk.error ? walk.expected !== undefined : differs(walk);
}

function differs({ result, expected, expected_error }) {
    return expected_error !== undefined ||
        (expected !== undefined && !same_result(expected, result));
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
    const is_back = !walk.skipped && walk.starts_at_half_edge && f >= 2 &&
        v === walk.start && accesses.length > 1;
    return is_back ? `The walk is back at the start, H${v}.` : "";
}
