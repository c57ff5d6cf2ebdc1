// What the pictures of the notes have in common: a page has one or more cases
// to choose from, and steps through the one that is chosen.

/** "V1→V4" */
const side_name = (a, b) => `V${a}→V${b}`;

/** "V1, V2 and V3"; "none" of an empty list. */
function listed(names) {
    if (names.length < 2) return names[0] || "none";
    return names.slice(0, -1).join(", ") + " and " + names.at(-1);
}

/** "1 face", "2 faces" */
const count_of = (n, one, many = one + "s") => `${n} ${n === 1 ? one : many}`;

/** A part of the picture that takes its share of the room. */
function pane(place, name = "", share = 1) {
    const element = html("div", { class: "pane " + name,
                                  style: `flex-grow: ${share}` });
    place.append(element);
    return element;
}

/** A pane with a mesh that fills it; see mesh.js. */
function mesh_pane(place, mesh, share = 1) {
    const element = pane(place, "mesh-pane", share);
    return new MeshPicture(svg("svg", {}, element), mesh);
}

/**
 * A case is {name, count, make}: make(place) puts its picture there and returns
 * draw(k), which shows step k of `count` and returns the sentence of the step.
 * Nothing but the case and k decides what is shown.
 */
class Cases {
    constructor(cases, keys) {
        this.cases = cases;
        this.place = document.getElementById("picture");
        this.say = document.getElementById("say");
        document.getElementById("title").textContent = document.title;
        this.stepper = new Stepper(document.getElementById("transport"), {
            draw: (k) => this.draw(k), keys: { ...this.keys(), ...keys } });
        this.make_buttons(document.getElementById("choices"));
        this.follow_link();
        addEventListener("hashchange", () => this.follow_link());
    }

    /** The digits choose a case. */
    keys() {
        if (this.cases.length < 2) return {};
        return Object.fromEntries(this.cases.map(({ name }, c) => [
            String(c + 1), { text: name, run: () => this.choose(c) }]));
    }

    make_buttons(place) {
        if (this.cases.length < 2) return;
        this.buttons = this.cases.map(({ name }, c) => {
            const button = html("button", { type: "button" }, name);
            button.onclick = () => this.choose(c);
            place.append(button);
            return button;
        });
    }

    follow_link() {
        const { case: c, step } = read_link();
        this.choose(Math.max(0, Math.min((Number(c) || 1) - 1,
                                         this.cases.length - 1)),
                    (Number(step) || 1) - 1);
    }

    choose(c, k = 0) {
        this.chosen = c;
        this.buttons?.forEach((button, other) =>
            button.setAttribute("aria-pressed", other === c));
        this.place.textContent = "";
        this.draw_step = this.cases[c].make(this.place);
        this.stepper.reset(this.cases[c].count, k);
    }

    draw(k) {
        this.say.textContent = this.draw_step(k);
        const link = { ...read_link(), case: this.chosen + 1, step: k + 1 };
        write_link(link);
    }

    /** For tests. */
    state() {
        return { case: this.chosen, step: this.stepper.k,
                 count: this.stepper.count, say: this.say.textContent };
    }
}

/**
 * Makes the page; the browser tests find it as window.player. `keys` are those
 * of the picture itself, as Stepper takes them.
 */
function show_cases(cases, keys = {}) {
    window.player = new Cases(cases, keys);
}
