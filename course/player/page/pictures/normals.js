// Three weights of a vertex normal: each triangle at the corner is added to the
// sum, for one weight after the other; then the sides are cut otherwise.

const weights = [
    { name: "uniform", ink: "cur", beside: [-2.2, 0], of: () => 1, text: () => "1" },
    { name: "area", ink: "next", beside: [0, -0.9], of: (t) => t.area,
      text: (t) => t.area.toFixed(1) },
    { name: "angle", ink: "cell", beside: [1.9, 0], of: (t) => t.angle,
      text: (t) => `${degrees(t.angle).toFixed(0)}°` },
];
const diagonal = vector.unit([1, 1, 1]);

function degrees(radians) {
    return 180 * radians / Math.PI;
}

function angle_between(a, b) {
    const sine = vector.length(vector.cross(a, b));
    return degrees(Math.atan2(sine, vector.dot(a, b)));
}

/** "F3, on top" */
function name_of(triangle) {
    const axis = triangle.normal.findIndex((x) => x > 0.5);
    return `F${triangle.face} (${["left", "right", "top"][axis]})`;
}

function sum_text(w, triangles) {
    const { of, name } = weights[w];
    const sums = [0, 0, 0];
    for (const t of triangles)
        t.normal.forEach((x, k) => sums[k] += x * of(t));
    const texts = sums.map((sum) => name === "angle"
        ? `${degrees(sum).toFixed(0)}°` : `${+sum.toFixed(1)}`);
    return `left ${texts[0]}, top ${texts[2]}, right ${texts[1]}`;
}

/** A step for each triangle, then the result. */
function steps_of_weight(w, cut, own_words) {
    const { triangles, normals } = page_data.cuts[cut];
    const { name, text } = weights[w];
    const steps = triangles.map((t, n) => ({
        cut, w, done: n + 1,
        say: `${name}: ${name_of(t)} counts ${text(t)}`,
    }));
    const off = angle_between(normals[w], diagonal).toFixed(0);
    steps.push({ cut, w, done: triangles.length, result: true,
                 say: `${name}: ${sum_text(w, triangles)}. ${own_words(off)}` });
    return steps;
}

function steps_of_second_cut() {
    const [before, now] = page_data.cuts.map(({ normals }) => normals);
    return weights.map(({ name }, w) => ({
        cut: 1, w, done: 9, result: true, compare: w,
        say: `${name}: the normal turns by ` +
            `${angle_between(before[w], now[w]).toFixed(0)}°` +
            (name === "angle" ? ". A side keeps its 90°." : "."),
    }));
}

const steps = [
    { cut: 0, w: -1, done: 0, say: "Corner V0 of a box: which way is its normal?" },
    { cut: 0, w: -1, done: 0, faces: true,
      say: `Seven triangles meet at V0, four of them on the small side.` },
    ...steps_of_weight(0, 0, () => "The small side wins."),
    ...steps_of_weight(1, 0, () => "The large top wins."),
    ...steps_of_weight(2, 0, (off) => off === "0" ? "A draw."
                                                  : `It leans by ${off}°.`),
    { cut: 1, w: 2, done: 0, result: true, compare: -1,
      say: "The same box, cut in another way. Which normal moves?" },
    ...steps_of_second_cut(),
    { cut: 1, w: 2, done: 9, result: true, compare: 2,
      say: "By angle, it does not matter how the sides are cut." },
];

function arrow(direction, ink, extra = {}) {
    const start = page_data.cuts[0].mesh.points[0];
    return { at: [start, vector.plus(start, vector.times(1.7, direction))],
             is: ink, arrow: true, lift: 9, ...extra };
}

/** The sum so far, at unit length. */
function partial_normal({ cut, w, done }) {
    const used = page_data.cuts[cut].triangles.slice(0, done);
    return vector.unit(used.map((t) => vector.times(weights[w].of(t), t.normal))
        .reduce(vector.plus));
}

function arrows_of(step) {
    const lines = [], dots = [];
    const add = (direction, w, before) => {
        const { ink, name, beside } = weights[w];
        const is_named = !before && (step.result || w === step.w);
        const line = arrow(direction, before ? `${ink} before` : ink);
        lines.push(line);
        if (is_named)
            dots.push({ at: line.at[1], is: ink, text: name, beside, size: 0,
                        lift: 10 });
    };
    for (let w = 0; w <= step.w; ++w) {
        if (step.cut === 1) {
            add(page_data.cuts[0].normals[w], w, w <= step.compare);
            if (w <= step.compare) add(page_data.cuts[1].normals[w], w);
        } else if (w < step.w || step.result) {
            add(page_data.cuts[0].normals[w], w);
        } else {
            add(partial_normal(step), w);
        }
    }
    return { lines, dots };
}

function draw_solid(solid, step) {
    const { mesh, triangles } = page_data.cuts[step.cut];
    const place_of = new Map(triangles.map((t, n) => [t.face, n]));
    const faces = facets(mesh, (f) => {
        const n = place_of.get(f);
        if (n === undefined || step.result) return "";
        if (n + 1 === step.done) return "now";
        return n < step.done || step.faces ? "seen" : "";
    });
    const { lines, dots } = arrows_of(step);
    for (const [n, t] of triangles.entries()) {
        // Names only where no arrow lies over them.
        if (step.done ? n + 1 !== step.done || step.result : step.result)
            continue;
        const corners = mesh.faces[t.face].map((v) => mesh.points[v]);
        dots.push({ at: vector.mean([...corners, ...corners.slice(1)]),
                    text: `F${t.face}`, size: 0, lift: 1 });
    }
    dots.push({ at: mesh.points[0], lift: 10 });
    solid.show({ faces, lines, dots });
}

/** Cells that are not filled yet keep their place. */
function draw_table(panel, step) {
    const { triangles, normals } = page_data.cuts[step.cut];
    const filled = (n, w) => step.cut === 1 ? w <= step.compare
        : w < step.w || (w === step.w && (n < step.done || step.result));
    const cell = (text, w, n, now) => html("td", {
        class: `${filled(n, w) ? "" : "ahead"} ${now ? "now" : ""}` }, text);
    const rows = triangles.map((t, n) => html("tr", {},
        html("td", {}, name_of(t)),
        ...weights.map(({ text }, w) => cell(text(t), w, n,
            w === step.w && n + 1 === step.done && !step.result))));
    const leaning = html("tr", {}, html("th", {}, "leans by"),
        ...normals.map((normal, w) => cell(
            `${angle_between(normal, diagonal).toFixed(0)}°`, w, 9)));
    panel.replaceChildren(html("table", {},
        html("tr", {}, html("th", {}, "counts"),
             ...weights.map(({ name }) => html("th", {}, name))),
        ...rows, leaning));
}

const view = new View(146, 16);

function make(place) {
    const { solid } = add_solid(
        place, view, "the corner of a box of 3 × 2 × 1",
        { center: [2, 1.2, 1.1], around: 2.65, up: 1.1 });
    const panel = html("div", { class: "pane narrow beside" });
    place.append(panel);
    return (k) => {
        draw_solid(solid, steps[k]);
        draw_table(panel, steps[k]);
        return steps[k].say;
    };
}

show_cases([{ name: "weights", count: steps.length, make }], view.keys());
