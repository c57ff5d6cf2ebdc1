// The page of recorded walks: mesh, table, source and variables of a step, two
// walks side by side, and the questions to the room. Scripts before it, in
// this order: svg.js layout.js labels.js mesh.js table.js code.js stepper.js
// steps.js say.js words.js compare.js; styles: base.css mesh.css parts.css
// walk.css; body: walk.html.

/** Mesh and source of one walk. */
class Pane {
    constructor(recording) {
        this.heading = html("h2");
        this.picture_box = svg("svg", { class: "picture",
                                        "aria-hidden": "true" });
        this.code_box = html("div", { class: "code" });
        this.root = html("section", { class: "pane" }, this.heading,
                         this.picture_box, this.code_box);
        const lengths = recording.sources.map(({ lines }) => lines.length);
        this.root.style.setProperty("--lines", Math.max(...lengths, 0) + 1);
        at_id("panes").append(this.root);
        this.mesh = new MeshPicture(this.picture_box, recording.mesh);
        this.code = new CodePicture(this.code_box);
    }

    /** A new walk: new vertices get their places. */
    begin(walk) {
        this.mesh.focus_on(walk.visited());
        this.mesh.remember(walk.state(walk.count - 1).table);
    }

    show_code(walk, { line, columns }) {
        this.code.show(walk.code, line, columns);
    }
}

class WalkPage {
    constructor(recording) {
        this.recording = recording;
        recording.code = recording.sources.map((s) => new Source(s));
        this.walks = recording.walks.map((w) => new Walk(recording, w));
        this.panes = [new Pane(recording)];
        this.table = new TablePicture(at_id("table"));
        this.typed = "";
        this.room = { on: false, question: null, verdict: null,
                      right: 0, asked: 0 };
        this.comparison = null;
        this.make_controls();
        this.open_link();
        addEventListener("hashchange", () => this.open_link());
        addEventListener("resize", () => this.draw(this.stepper.k));
    }

    make_controls() {
        this.stepper = new Stepper(at_id("bar"), {
            draw: (k) => this.draw(k),
            before_next: () => this.ask_first(),
            keys: this.keys(),
        });
        at_id("title").textContent = this.recording.title;
        this.panes[0].mesh.on_pick = this.table.on_pick = (h) => this.pick(h);
        this.fill_source_list();
        this.on_choice(at_id("start"), (value) =>
            this.restart(this.walks[value]));
        this.on_choice(at_id("source"), () => this.change_source());
        this.predict_button = this.add_button("predict", "q");
        this.compare_button = this.add_button("compare", "c");
        this.compare_button.hidden = this.recording.sources.length < 2;
    }

    /** After a choice with the mouse the arrow keys step again. */
    on_choice(list, run) {
        list.onchange = () => {
            run(list.value);
            if (!list.matches(":focus-visible")) list.blur();
        };
    }

    add_button(text, key) {
        const button = html("button", { type: "button", "aria-pressed": "false",
                                        title: `${text} (${key})` }, text);
        button.onclick = () => this.stepper.keys[key].run();
        at_id("bar").append(button);
        return button;
    }

    keys() {
        const digit = (d) => ({ text: "number of a half-edge, then Enter",
                                run: () => this.type(d) });
        const keys = {
            q: { text: "predict: ask the room", run: () => this.predict() },
            Enter: { text: "answer, or start there", run: () => this.enter() },
        };
        if (this.recording.sources.length > 1) {
            keys.c = { text: "compare both files", run: () => this.compare() };
            keys.s = { text: "other file", run: () => this.change_source() };
        }
        for (let d = 0; d <= 9; ++d) keys[d] = digit(String(d));
        return keys;
    }

    fill_source_list() {
        const list = at_id("source");
        this.recording.sources.forEach(({ label }, n) =>
            list.append(html("option", { value: n }, label)));
        list.hidden = this.recording.sources.length < 2;
    }

    fill_start_list() {
        const list = at_id("start");
        list.textContent = "";
        this.walks.forEach((walk, n) => {
            if (walk.source === this.walk.source)
                list.append(html("option", { value: n }, walk.call));
        });
        list.value = this.walks.indexOf(this.walk);
        at_id("source").value = this.walk.source;
    }

    /** The walk of a source with this start; undefined if not recorded. */
    find(source, start) {
        return this.walks.find((w) => w.source === source && w.start === start);
    }

    /** The first that goes wrong, or else the longest that returns. */
    most_telling(source) {
        const of_source = this.walks.filter((w) => w.source === source);
        const rank = (w) => (is_wrong(w) ? 2e6 : w.error ? 0 : w.count + 1e6);
        return of_source.reduce((best, w) => rank(w) > rank(best) ? w : best,
                                of_source[0] || this.walks[0]);
    }

    open_link() {
        const link = read_link();
        const last = this.recording.sources.length - 1;
        const source = Number(link.source ?? last);
        const walk = this.find(source, Number(link.i)) ||
            this.most_telling(source);
        this.open(walk, Number(link.step || 0));
        if (link.compare) this.compare(Number(link.step || 0));
    }

    open(walk, k) {
        this.comparison = null;
        this.walk = walk;
        this.fill_start_list();
        this.forget_question();
        this.panes[0].begin(walk);
        this.stepper.reset(walk.count, k);
    }

    /** From its first step on; two walks are still compared then. */
    restart(walk) {
        const comparing = this.comparison;
        this.open(walk, 0);
        if (comparing) this.compare();
    }

    /** The same start in the other file, at the same place in the walk. */
    change_source() {
        const source = (this.walk.source + 1) % this.recording.sources.length;
        const walk = this.find(source, this.walk.start) ||
            this.walks.find((w) => w.source === source);
        if (walk) this.open(walk, this.comparison ? 0 : this.stepper.k);
    }

    pick(h) {
        if (this.room.question) return this.answer(h);
        const at_vertex = this.recording.starts === "vertex";
        const start = at_vertex ? (this.recording.mesh.table[h] || [])[0] : h;
        const walk = this.find(this.walk.source, start);
        if (walk) this.restart(walk);
    }

    type(digit) {
        this.typed += digit;
        this.draw(this.stepper.k);
    }

    enter() {
        const typed = this.typed;
        this.typed = "";
        if (typed) this.pick(Number(typed));
        else this.stepper.keys.ArrowRight.run();
    }

    compare(k) {
        const other = this.walks.find((w) => w.source !== this.walk.source &&
                                             w.start === this.walk.start);
        if (this.comparison || !other) return this.open(this.walk, 0);
        this.panes[1] ??= new Pane(this.recording);
        this.panes[1].mesh.on_pick = this.panes[0].mesh.on_pick;
        const pair = [this.walk, other].sort((a, b) => a.source - b.source);
        this.forget_question();
        this.comparison = new Comparison(...pair);
        pair.forEach((walk, n) => this.panes[n].begin(walk));
        this.stepper.reset(this.comparison.count,
                           k ?? Math.max(0, this.comparison.parting));
    }

    predict() {
        this.room.on = !this.room.on;
        this.forget_question();
        this.draw(this.stepper.k);
    }

    forget_question() {
        this.room.question = this.room.verdict = null;
        this.typed = "";
    }

    /** Whether a question has to be answered before the next step. */
    ask_first() {
        const k = this.stepper.k + 1;
        const { i, f, v, w } = this.walk.step(k);
        const is_read = k <= this.walk.steps.length && i >= 0 && f >= 2 &&
            v >= 0 && w === undefined;
        if (!this.room.on || this.room.question || !is_read || this.comparison)
            return false;
        this.stepper.stop();
        this.room.question = { k: k - 1 };
        this.draw(k - 1);
        return true;
    }

    answer(h) {
        const k = this.stepper.k + 1;
        const right = h === this.walk.step(k).v;
        this.room.verdict = { k, h, right };
        this.room.asked += 1;
        this.room.right += right;
        this.stepper.go(k);
    }

    draw(k) {
        const { question, verdict } = this.room;
        if (question && question.k !== k) this.room.question = null;
        if (verdict && verdict.k !== k) this.room.verdict = null;
        document.body.classList.toggle("comparing", Boolean(this.comparison));
        this.compare_button?.setAttribute("aria-pressed",
                                          String(Boolean(this.comparison)));
        this.predict_button?.setAttribute("aria-pressed", String(this.room.on));
        if (this.comparison) this.draw_comparison(k);
        else this.draw_walk(k);
        this.show_score();
        this.keep_link(k);
    }

    keep_link(step) {
        const { source, start } = this.walk;
        const link = { i: start ?? 0, step, source };
        if (this.comparison) link.compare = 1;
        if (read_link().theme) link.theme = read_link().theme;
        write_link(link);
    }

    draw_walk(k) {
        const state = this.walk.state(k);
        let words = say_state(this.walk, k, state);
        if (this.room.question) words = this.put_question(k, state);
        if (this.room.verdict) words.more = this.say_verdict(state);
        if (this.typed) words.more = `H${this.typed} … Enter`;
        show_words(words);
        // The variables first: how much room they leave decides the rest.
        show_variables(state, this.walk.step(k), k);
        this.panes[0].show_code(this.walk, state);
        this.panes[0].mesh.show(state);
        this.table.show(state);
    }

    /** The state before the read, with the cell that is asked for. */
    put_question(k, state) {
        const step = this.walk.step(k + 1);
        for (const name of ["next", "opp", "vertices", "faces", "old"])
            delete state[name];
        Object.assign(state, { current: step.i, field: step.f, value: "?",
                               line: step.l, columns: step.c });
        return { main: access_text(this.walk, step) + " is … ?",
                 more: "Which half-edge? Click it or type its number." };
    }

    say_verdict(state) {
        const { h, right, k } = this.room.verdict;
        if (right) return "✓ The room is right.";
        (state.flags[h] ??= []).push("room");
        return `✗ The room said H${h}; it is H${this.walk.step(k).v}.`;
    }

    show_score() {
        const { right, asked } = this.room;
        at_id("score").textContent = asked ? `room: ${right} of ${asked}` : "";
    }

    draw_comparison(k) {
        show_words({ main: this.comparison.say(k), more: "" });
        const states = this.comparison.walks.map((walk, n) =>
            walk.state(this.comparison.place(n, k)));
        this.comparison.walks.forEach((walk, n) => {
            this.panes[n].heading.textContent =
                this.comparison.heading(n, k, states[n]);
            this.panes[n].show_code(walk, states[n]);
        });
        // The meshes last: they have the room that is left.
        states.forEach((state, n) => this.panes[n].mesh.show(state));
    }
}

const page = new WalkPage(page_data);
window.player = {
    stepper: page.stepper,
    state: () => ({ walk: page.walks.indexOf(page.walk), k: page.stepper.k,
                    comparing: Boolean(page.comparison), room: page.room }),
};
