// What is true at each step of a recorded walk. All is worked out from the
// recording and the number of the step alone, so that back is as good as
// forward.

const value_kinds = ["V", "F", "H", "H"];

/** A value of the recording as text; long lists are cut. */
function value_text(value) {
    if (value === null) return "nothing";
    if (!Array.isArray(value)) return String(value);
    if (value.length > 4 && value.every((row) => row?.length === 4))
        return `a table of ${value.length} rows`;
    return "[" + value.map(value_text).join(", ") + "]";
}

/**
 * One walk. Its states are: 0 the call; k the k-th step of the recording; the
 * last one the result or the error.
 */
class Walk {
    constructor(recording, walk) {
        Object.assign(this, walk);
        this.recording = recording;
        this.code = recording.code[walk.source] || no_source;
        this.count = walk.steps.length + 2;
        this.starts_at_half_edge = recording.starts === "half-edge";
    }

    /** Half-edges that it reads or writes, and where they lead. */
    visited() {
        const found = new Set(this.starts_at_half_edge ? [this.start] : []);
        for (const { i, f, v } of this.steps) {
            if (i >= 0) found.add(i);
            if (f >= 2 && v >= 0) found.add(v);
        }
        return [...found];
    }

    /** The rows before its first step; a copy, which may leave rows out. */
    first_table() {
        return (this.table || this.recording.mesh.table).map((r) => [...r]);
    }

    is_last(k) {
        return k === this.count - 1;
    }

    /** The recorded step that state k shows; {} for the call. */
    step(k) {
        return this.steps[Math.min(k, this.steps.length) - 1] || {};
    }

    /** Table, variables, lit rows... of state k. */
    state(k) {
        const state = {
            table: this.first_table(),
            calls: [new Map()], seen: [], changed: new Set(),
            new_rows: new Set(), flags: {},
            outline: Boolean(this.table) };
        const last = Math.min(k, this.steps.length);
        for (let j = 1; j <= last; ++j) this.apply(this.steps[j - 1], state);
        state.variables = state.calls.at(-1);
        state.start = this.start_mark(state.variables);
        if (k > 0) this.light(this.step(k), state);
        else if (this.recording.starts === "vertex")
            state.vertices = [this.start];
        if (this.is_last(k)) this.light_end(state);
        state.line = k > 0 ? this.step(k).l || 0
                           : this.code.definition(this.call.split("(")[0]);
        state.columns = this.is_last(k) && !this.error ? null
                                                       : this.step(k).c;
        this.set_flags(state);
        return state;
    }

    apply(step, state) {
        const { i, f, v, w } = step;
        if (step.new) state.table[i] = [...step.new];
        else if (w !== undefined && state.table[i]) state.table[i][f] = v;
        if (step.n !== undefined) state.table.length = step.n;
        if (w !== undefined) state.changed.add(i + "," + f);
        if (step.new) state.new_rows.add(i);
        if (i !== undefined && i >= 0 && !state.seen.includes(i))
            state.seen.push(i);
        this.enter_or_leave(step, state);
        this.set_variables(step, state.calls.at(-1));
    }

    /** Each call of a function of the file has variables of its own. */
    enter_or_leave({ in: depth }, state) {
        const before = state.calls.length - 1;
        state.is_back = depth < before;
        if (depth === undefined) return;
        state.calls.length = Math.min(before, depth) + 1;
        while (state.calls.length <= depth) state.calls.push(new Map());
    }

    /**
     * A variable that hides another one has a name of its own,
     * "i (line 12)". Without locals there are those that index the table.
     */
    set_variables(step, variables) {
        const { l, i, c, d = {} } = step;
        for (const [key, value] of Object.entries(d)) {
            const [, name, line] = key.match(/^(.*?)(?: \(line (\d+)\))?$/);
            if (value === null) variables.delete(key);
            else variables.set(key, { name, value, line, step });
        }
        if (this.has_locals() || !c || i === undefined) return;
        const index = this.code.split(l, c)[1].match(/\[([a-z_]\w*)\]/);
        if (index) variables.set(index[1], { name: index[1], value: i, step });
    }

    has_locals() {
        this.locals_seen ??= this.steps.some((step) => step.d);
        return this.locals_seen;
    }

    /** A variable of the name `start` has the last word. */
    start_mark(variables) {
        const own = this.starts_at_half_edge ? this.start : undefined;
        return (variables.get("start") || { value: own }).value;
    }

    /** What the step itself reads or writes. */
    light({ i, f, v, w }, state) {
        if (i === undefined) return;
        state.current = i;
        state.field = f;
        state.value = v;
        if (w !== undefined && f !== undefined) state.old = w;
        if (f === 0) state.vertices = [v];
        if (f === 1) state.faces = [v];
        if (f === 2) state.next = v;
        if (f === 3) state.opp = v;
    }

    /** At the end: the elements of the result, or the cycle of no end. */
    light_end(state) {
        if (this.error) {
            if (this.cycle().length) state.half_edges = this.cycle();
            // The last value that was read is where a wrong index comes from.
            if (state.current === undefined)
                this.light(this.steps.findLast((s) => s.i >= 0) || {}, state);
            return;
        }
        for (const name of ["current", "field", "next", "opp", "old",
                            "vertices", "faces"]) delete state[name];
        const kind = result_kind(this.recording.exercise);
        const values = [this.result].flat(2);
        if (!kind || values.some((x) => !Number.isInteger(x))) return;
        state[kind] = values;
    }

    /** The half-edges that the walk's end visits again and again. */
    cycle() {
        const visits = this.steps.filter((s) => s.i >= 0)
            .map((s) => `${s.i} ${s.f}`);
        if (!this.skipped && visits.length < 100) return [];
        for (let period = 1; 3 * period <= visits.length; ++period) {
            const end = visits.slice(-2 * period);
            if (end.every((x, k) => x === end[k % period]))
                return [...new Set(end.map((x) => parseInt(x)))];
        }
        return [];
    }

    /** Names of variables at the half-edges that they hold. */
    set_flags({ flags, variables, start, table }) {
        const add = (h, name) => {
            if (!table[h]) return;
            flags[h] ??= [];
            if (!flags[h].includes(name)) flags[h].push(name);
        };
        for (const { name, value } of variables.values())
            if (this.code.half_edge_names.has(name)) add(value, name);
        if (!flags[start]) add(start, "start");
    }
}

/** Which elements the numbers of the exercise's result are. */
function result_kind(exercise) {
    if (/(faces|face_across|strip)$/.test(exercise)) return "faces";
    if (/(vertices|star|tip)$/.test(exercise)) return "vertices";
    if (/(outgoing|walk|walk_bug|loops|prev)$/.test(exercise))
        return "half_edges";
    return "";
}
