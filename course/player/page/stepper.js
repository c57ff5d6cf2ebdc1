// Steps through the states of a page, forward, back and by itself: keys, a
// transport bar, deep links, the dark theme. Knows nothing of what is drawn.

/** What stands after the # of the address, as an object of strings. */
function read_link() {
    return Object.fromEntries(new URLSearchParams(location.hash.slice(1)));
}

/** Keeps the state in the address, so that it can be sent and reloaded. */
function write_link(state) {
    history.replaceState(null, "", "#" + new URLSearchParams(state));
}

function set_theme(theme) {
    document.documentElement.dataset.theme = theme;
}

function toggle_theme() {
    const dark = document.documentElement.dataset.theme === "dark";
    set_theme(dark ? "light" : "dark");
}

set_theme(read_link().theme ||
    (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light"));

/**
 * new Stepper(place, {draw, keys, before_next})
 *   place        element that gets the transport bar
 *   draw(k)      shows step k; nothing but k (and what the page holds) decides
 *                what is shown
 *   keys         {key: {text, run}}: more keys, named in the help
 *   before_next  optional: called before a step forward by hand or in play;
 *                true keeps the step from being taken
 */
class Stepper {
    constructor(place, { draw, keys = {}, before_next = () => false }) {
        this.draw = draw;
        this.before_next = before_next;
        this.count = 0;
        this.k = 0;
        this.delay = 1200;
        this.timer = null;
        this.keys = { ...this.own_keys(), ...keys };
        this.make_bar(place);
        this.make_help();
        addEventListener("keydown", (event) => this.on_key(event));
    }

    /** A new walk of `count` steps, shown from step k on. */
    reset(count, k = 0) {
        this.stop();
        this.count = count;
        this.seek.max = count - 1;
        this.go(k);
    }

    go(k) {
        this.k = Math.max(0, Math.min(k, this.count - 1));
        this.seek.value = this.k;
        this.seek.setAttribute("aria-valuetext", this.place_text());
        this.output.textContent = this.place_text();
        this.draw(this.k);
    }

    place_text() {
        return `step ${this.k + 1} / ${this.count}`;
    }

    next() {
        if (this.before_next()) return;
        if (this.k + 1 < this.count) this.go(this.k + 1);
        else this.stop();
    }

    back() {
        this.go(this.k - 1);
    }

    play() {
        if (this.timer) return this.stop();
        if (this.k + 1 >= this.count) this.go(0);
        this.timer = setInterval(() => this.next(), this.delay);
        this.play_button.textContent = "pause";
    }

    stop() {
        clearInterval(this.timer);
        this.timer = null;
        if (this.play_button) this.play_button.textContent = "play";
    }

    /** Faster by a factor above 1, slower by one below. */
    change_speed(factor) {
        this.delay = Math.max(100, Math.min(this.delay / factor, 10000));
        if (!this.timer) return;
        this.stop();
        this.play();
    }

    // The keys of a clicker are PageDown, PageUp and b or . for a blank screen.
    own_keys() {
        const by_hand = (run) => () => {
            this.stop();
            run();
        };
        const next = { text: "step", run: by_hand(() => this.next()) };
        const back = { text: "back", run: by_hand(() => this.back()) };
        const blank = {
            text: "blank screen",
            run: () => document.body.classList.toggle("blank"),
        };
        return {
            ArrowRight: next, PageDown: next, n: next,
            ArrowLeft: back, PageUp: back, p: back,
            " ": { text: "play, pause", run: () => this.play() },
            Home: { text: "first step", run: by_hand(() => this.go(0)) },
            End: { text: "last step",
                   run: by_hand(() => this.go(this.count - 1)) },
            "+": { text: "faster", run: () => this.change_speed(1.4) },
            "-": { text: "slower", run: () => this.change_speed(1 / 1.4) },
            d: { text: "dark, light", run: toggle_theme },
            b: blank, ".": blank,
            "?": { text: "this help", run: () => this.show_help() },
        };
    }

    on_key(event) {
        if (event.ctrlKey || event.metaKey || event.altKey) return;
        const key = event.key.length === 1 ? event.key.toLowerCase()
                                           : event.key;
        const in_control = event.target.closest("select, input, button");
        if (in_control && (key === " " || key === "Enter")) return;
        if (event.target.closest("select") && key.startsWith("Arrow")) return;
        const found = this.keys[key];
        if (!found || this.help.open) return;
        event.preventDefault();
        found.run();
    }

    make_bar(place) {
        const button = (text, name, run) => {
            const element = html("button", { type: "button", title: name },
                                 text);
            element.onclick = run;
            place.append(element);
            return element;
        };
        place.classList.add("transport");
        button("back", "back (left arrow)", () => this.keys.ArrowLeft.run());
        this.play_button = button("play", "play (space)", () => this.play());
        button("step", "step (right arrow)", () => this.keys.ArrowRight.run());
        this.seek = html("input", {
            type: "range", min: 0, value: 0, "aria-label": "step" });
        this.seek.oninput = () => {
            this.stop();
            this.go(Number(this.seek.value));
        };
        this.output = html("output");
        place.append(this.seek, this.output);
        button("?", "keys (?)", () => this.show_help());
    }

    make_help() {
        const names = { " ": "space", ArrowRight: "→", ArrowLeft: "←" };
        const table = html("table");
        const rows = new Map();
        for (const [key, { text }] of Object.entries(this.keys)) {
            if (!rows.has(text)) rows.set(text, []);
            rows.get(text).push(html("kbd", {}, names[key] || key), " ");
        }
        for (const [text, keys] of rows) {
            if (keys.length > 8) keys.splice(2, keys.length - 4, "to ");
            table.append(html("tr", {}, html("td", {}, ...keys),
                              html("td", {}, text)));
        }
        const close = html("form", { method: "dialog" },
                           html("button", {}, "close"));
        this.help = html("dialog", { "aria-label": "keys" }, table, close);
        document.body.append(this.help);
    }

    show_help() {
        this.stop();
        this.help.showModal();
    }
}
