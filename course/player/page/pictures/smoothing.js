// Smoothing a noisy ball: first what happens to one vertex, then to all of
// them, by Laplace's steps beside Taubin's.

const { mesh, laplace, taubin } = page_data;
const [inwards, outwards] = page_data.weights;

const view = new View(20, 20);

/** The topmost vertex, seen from the side, and the others of its edges. */
const vertex = mesh.points.reduce(
    (best, p, v) => view.seen(p)[1] > view.seen(mesh.points[best])[1]
        ? v : best, 0);
const neighbours = [...new Set(mesh.faces.filter(
    (face) => face.includes(vertex)).flat())].filter((v) => v !== vertex);
const mean = vector.mean(neighbours.map((v) => mesh.points[v]));

const volume = (step) => percent(step.volume / laplace[0].volume);
const bumps = (step) => percent(step.bumps, 1);

function steps_of_all() {
    return laplace.slice(1).map((step, n) => {
        const other = taubin[n + 1];
        const way = n % 2 ? "out" : "in";
        return {
            k: n + 1,
            say: `Step ${n + 1}: Laplace has ${volume(step)} of the volume, ` +
                `Taubin (${way}wards) ${volume(other)}.`,
        };
    });
}

const last = laplace.length - 1;
const steps = [
    { k: 0, say: `A ball as a scanner sees it: bumps of ${bumps(laplace[0])}.` },
    { k: 0, one: 1, say: `V${vertex} has ${neighbours.length} neighbours.` },
    { k: 0, one: 2, say: "Their mean lies further in than the vertex." },
    { k: 0, one: 3,
      say: `A step takes V${vertex} half of the way to it: w = ${inwards}.` },
    { k: 0, say: "All vertices do so at once. Taubin goes outwards every " +
          `second step: w = ${outwards}.`.replace("-", "−") },
    ...steps_of_all(),
    { k: last, say: `Both are smooth. Laplace has lost ` +
          `${percent(1 - laplace[last].volume / laplace[0].volume)} of the ` +
          "ball: a mean of neighbours lies inside." },
];

/** What the step shows of the one vertex. */
function parts_of_vertex({ one }) {
    if (!one) return {};
    const p = mesh.points[vertex], lift = 5;
    const dots = neighbours.map(
        (v) => ({ at: mesh.points[v], is: "next", lift }));
    dots.push({ at: p, is: "cur", text: `V${vertex}`, beside: [0, -1], lift });
    const lines = neighbours.map(
        (v) => ({ at: [p, mesh.points[v]], is: "next thin", lift }));
    if (one > 1)
        dots.push({ at: mean, is: "cell", text: "mean", beside: [0, 1.1],
                    lift });
    if (one > 2)
        lines.push({ at: [p, laplace[1].points[vertex]], is: "cur",
                     arrow: true, lift: lift + 1 });
    return { dots, lines };
}

/** Two curves over the steps: Laplace's and Taubin's. */
class Curves {
    constructor(place, heading, { most, value, text }) {
        Object.assign(this, { heading, most, value, text });
        this.svg = svg("svg", { class: "curves", role: "img",
                                "aria-label": heading }, place);
        new ResizeObserver(() => this.draw()).observe(this.svg);
    }

    show(k) {
        this.k = k;
        this.draw();
    }

    draw() {
        if (!this.svg.isConnected) return;  // the page begins anew
        const { width, height } = this.svg.getBoundingClientRect();
        const em = parseFloat(getComputedStyle(this.svg).fontSize);
        this.box = { left: 0.3 * em, right: width - 9.2 * em,
                     top: 1.6 * em, bottom: height - 0.4 * em };
        this.svg.replaceChildren();
        const { left, right, top, bottom } = this.box;
        svg("path", { class: "axis", d: `M${left} ${top}V${bottom}H${right}` },
            this.svg);
        this.text_at(left, top - 0.6 * em, this.heading);
        const ends = [["Laplace", "cur", laplace], ["Taubin", "next", taubin]]
            .map(([name, is, list]) => this.curve(name, is, list));
        this.part(ends, 1.15 * em);
        for (const { y, is, label } of ends)
            this.text_at(right + 0.8 * em, y, label, is);
    }

    text_at(x, y, text, is = "") {
        svg("text", { x, y, class: is, "dominant-baseline": "middle" },
            this.svg).textContent = text;
    }

    curve(name, is, list) {
        const { left, right, top, bottom } = this.box;
        const points = list.slice(0, this.k + 1).map((step, n) => [
            left + (right - left) * n / (list.length - 1),
            bottom - (bottom - top) * this.value(step) / this.most]);
        const group = svg("g", { class: is }, this.svg);
        svg("path", { d: "M" + points.map((p) => p.join(" ")).join("L") },
            group);
        const [cx, cy] = points.at(-1);
        svg("circle", { cx, cy, r: "0.35em" }, group);
        return { y: cy, is, label: `${name} ${this.text(list[this.k])}` };
    }

    /** The labels at the right do not touch each other. */
    part([one, other], least) {
        const gap = least - Math.abs(one.y - other.y);
        if (gap <= 0) return;
        const down = one.y >= other.y ? one : other;
        const up = down === one ? other : one;
        down.y += gap / 2;
        up.y -= gap / 2;
    }
}

function make(place) {
    const frame = { center: [0, 0, 0], around: 1.15, up: 0.9 };
    const near = { center: vector.minus(mesh.points[vertex], [0, 0, 0.12]),
                   around: 0.42, up: 0.3 };
    const left = add_solid(place, view, "Laplace", frame);
    const right = add_solid(place, view, "Taubin", frame);
    const panel = html("div", {});
    place.append(html("div", { class: "pane narrow beside" }, panel));
    const curves = [
        new Curves(panel, "volume", {
            most: 1.3 * laplace[0].volume, value: (step) => step.volume,
            text: volume }),
        new Curves(panel, "bumps", {
            most: 1.3 * laplace[0].bumps, value: (step) => step.bumps,
            text: bumps }),
    ];
    return (k) => {
        const step = steps[k];
        for (const [{ solid }, list] of [[left, laplace], [right, taubin]]) {
            const { points } = list[step.k];
            solid.frame = step.one && list === laplace ? near : frame;
            solid.show({ faces: closed_facets({ points, faces: mesh.faces }),
                         ...(list === laplace ? parts_of_vertex(step) : {}) });
        }
        for (const one of curves) one.show(step.k);
        return step.say;
    };
}

show_cases([{ name: "smoothing", count: steps.length, make }], view.keys());
