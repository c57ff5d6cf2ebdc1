// Marching cubes: the cells of a grid one after the other, each with the case
// that its corners make and the row of the table; then the case that could be
// cut in two ways.

const corners = [0, 1, 2, 3, 4, 5, 6, 7];
const corner_of = ({ at }, c) => vector.plus(at, [c & 1, c >> 1 & 1, c >> 2]);
const inside_of = ({ number }) => corners.filter((c) => number >> c & 1);

/** "64 + 128 = 192" */
function case_text(cell) {
    const bits = inside_of(cell).map((c) => 1 << c);
    return bits.length > 1 ? `${bits.join(" + ")} = ${cell.number}`
                           : String(cell.number);
}

function density_at({ size: [nx, ny], density }, [x, y, z]) {
    return density[x + nx * (y + ny * z)];
}

function points_of({ size: [nx, ny], density }) {
    return density.map((value, n) => ({
        at: [n % nx, Math.floor(n / nx) % ny, Math.floor(n / nx / ny)], value }));
}

function say_of_cell(cell) {
    const inside = inside_of(cell);
    return `Corner${inside.length > 1 ? "s" : ""} ${listed(inside.map(String))}` +
        " inside: " +
        `case ${case_text(cell)}, ${count_of(cell.row.length / 3, "triangle")}.`;
}

/** "Edge 3 goes from 0.6 to 1.35: it passes 1 at 53 % of its length." */
function say_of_edge(cell, grid) {
    const [edge] = cell.row, { level, edges } = page_data;
    const [from, to] = edges[edge].map((c) => density_at(
        grid, corner_of(cell, c)));
    return `Edge ${edge} goes from ${from} to ${to}: it passes ${level} at ` +
        `${percent((level - from) / (to - from))} of its length.`;
}

/** The first cell slowly: corners, case, row of the table, vertices. */
function slow_steps(grid) {
    const [cell] = grid.cells, [corner] = inside_of(cell);
    const step = { n: 0, near: true };
    return [
        { ...step, hide: true, corners: true,
          say: "A cell has eight corners. Each is inside or not." },
        { ...step, hide: true, corners: true, row: true,
          say: `Only corner ${corner} is inside. ` +
              `Bit ${corner} alone is the number ${cell.number}.` },
        { ...step, hide: true, row: true, edges: true,
          say: `Row ${cell.number} of the table: a triangle between the edges ` +
              `${listed(cell.row.map(String))}.` },
        { ...step, row: true, edges: true, say: say_of_edge(cell, grid) },
    ];
}

function steps_of_blob(grid) {
    const { cells, whole, density } = grid;
    const inside = density.filter((value) => value > page_data.level).length;
    const n = whole.faces.length;
    return [
        { n: -1, say: `${density.length} points with a density; ` +
              `${inside} of them above ${page_data.level}: inside.` },
        ...slow_steps(grid),
        ...cells.slice(1).map((cell, k) => (
            { n: k + 1, row: true, edges: true, corners: true,
              say: say_of_cell(cell) })),
        { n: cells.length - 1, all: true,
          say: `${cells.length} cells, ${n} triangles. Neighbours use the same ` +
              "points: no gap." },
    ];
}

function steps_of_two() {
    return [
        { n: -1, side: true, say: "Two cells. On their common side, two corners " +
              "across from each other are inside." },
        { n: -1, side: true, ways: [0, 1],
          say: "The side could be cut in two ways: apart, or joined." },
        { n: -1, side: true, ways: [0],
          say: "This table always keeps inside corners apart." },
        { n: 0, row: true, side: true, ways: [0],
          say: "Left cell: two triangles, two lines on the side." },
        { n: 1, row: true, side: true, ways: [0],
          say: "Right cell: the same two lines. There is no gap." },
        { n: 1, side: true, ways: [0, 1], broken: true,
          say: "If one of the cells joined its corners instead, there " +
              "would be a hole." },
    ];
}

/** The case and the row of the table, corner by corner. */
function draw_panel(panel, cell, step) {
    panel.replaceChildren();
    if (!cell) return;
    const bit = (c) => String(cell.number >> c & 1);
    const down = [...corners].reverse();
    const row = (name, cells, now = () => false) => html("tr", {},
        html("th", {}, name), ...cells.map((text, n) => html("td", {
            class: now(n) ? "now" : "" }, text)));
    if (!step.side) panel.append(html("table", {},
        row("corner", down.map(String)),
        row("inside", down.map(bit), (n) => bit(down[n]) === "1")));
    const triangles = [];
    for (let n = 0; n < cell.row.length; n += 3)
        triangles.push(cell.row.slice(n, n + 3).join(" "));
    if (step.row)
        panel.append(html("p", { class: "big" }, `case ${case_text(cell)}`));
    if (step.edges && !step.side)
        panel.append(html("table", {}, ...triangles.map(
            (text, n) => row(`triangle ${n + 1}`, [`edges ${text}`]))));
}

/** The common side, seen from the right: y to the right, z up. */
function draw_ways(panel, { ways = [] }) {
    const names = ["apart", "joined"];
    panel.replaceChildren(...ways.map((way) => {
        const figure = svg("svg", { viewBox: "-0.6 -0.35 2.2 1.95",
                                    class: "way", role: "img",
                                    "aria-label": names[way] });
        svg("rect", { width: 1, height: 1 }, figure);
        const cuts = way === 0 ? ["M0.5 1L0 0.5", "M0.5 0L1 0.5"]
                               : ["M0.5 1L1 0.5", "M0.5 0L0 0.5"];
        for (const d of cuts) svg("path", { d }, figure);
        for (const [cx, cy, is] of [[0, 1, "inside"], [1, 0, "inside"],
                                    [0, 0, ""], [1, 1, ""]])
            svg("circle", { cx, cy, r: 0.1, class: is }, figure);
        svg("text", { x: 0.5, y: 1.4 }, figure).textContent = names[way];
        return figure;
    }));
}

function dots_of(grid, cell, step) {
    const in_cell = (p) => step.corners && cell ? corners.findIndex(
        (c) => corner_of(cell, c).every((x, k) => x === p[k])) : -1;
    const dots = points_of(grid).map(({ at, value }) => {
        const c = in_cell(at);
        const is_inside = value > page_data.level;
        return { at, is: is_inside ? "cur" : "hollow",
                 size: is_inside ? 0.4 : 0.2,
                 text: c >= 0 ? String(c) : "", beside: [0.7, -0.6],
                 lift: c >= 0 ? 0.3 : 0 };
    });
    return step.near && step.edges ? [...dots, ...names_of_edges(cell)] : dots;
}

function names_of_edges(cell) {
    return cell.row.map((edge) => ({
        at: vector.mean(page_data.edges[edge].map((c) => corner_of(cell, c))),
        is: "next", text: `edge ${edge}`, size: 0, lift: 2 }));
}

/** Where the triangles of the cell end at its side x = 1. */
function lines_at_side({ mesh: { points, faces } }) {
    const at_side = (face) => face.filter((v) => points[v][0] === 1);
    return faces.map(at_side).filter((ends) => ends.length === 2).map(
        (ends) => ({ at: ends.map((v) => points[v]), is: "cell", lift: 2 }));
}

function lines_of(grid, cell, step) {
    const lines = [];
    const frame = (of, is, lift) => page_data.edges.forEach(([a, b], e) =>
        lines.push({ at: [corner_of(of, a), corner_of(of, b)], lift,
                     is: step.edges && of === cell && cell.row.includes(e)
                         ? "next" : is }));
    if (step.side) grid.cells.forEach((of) => frame(of, "thin", 0));
    if (cell) frame(cell, "", 0.2);
    if (step.side && cell) lines.push(...lines_at_side(cell));
    return lines;
}

function faces_of(grid, step) {
    const faces = [];
    grid.cells.slice(0, step.n + 1).forEach((cell, n) => {
        if (n === step.n && step.hide) return;
        const is = n === step.n && !step.all ? "now" : "";
        faces.push(...facets(cell.mesh, () => is));
    });
    return faces;
}

const view = new View(-25, 22);

/** A cell and what lies round it. */
function frame_of_cell(cell) {
    return { center: vector.plus(cell.at, [0.5, 0.5, 0.5]), around: 1.1,
             up: 0.8 };
}

function make_case(grid, steps, heading) {
    return (place) => {
        const all = frame_of(points_of(grid).map(({ at }) => at));
        const { solid } = add_solid(place, view, heading, all);
        const table = html("div"), below = html("div", { class: "ways" });
        place.append(html("div", { class: "pane narrow beside case" },
                          table, below));
        return (k) => {
            const step = steps[k];
            const cell = step.all ? undefined : grid.cells[step.n];
            solid.frame = step.near ? frame_of_cell(cell) : all;
            solid.show({ faces: faces_of(grid, step),
                         lines: lines_of(grid, cell, step),
                         dots: dots_of(grid, cell, step) });
            draw_panel(table, cell, step);
            draw_ways(below, step);
            return step.say;
        };
    };
}

const { blob, two_cells } = page_data;
const blob_steps = steps_of_blob(blob), two_steps = steps_of_two();
show_cases([
    { name: "a blob", count: blob_steps.length,
      make: make_case(blob, blob_steps, "4 × 4 × 4 points") },
    { name: "two ways to cut", count: two_steps.length,
      make: make_case(two_cells, two_steps, "two cells") },
], view.keys());
