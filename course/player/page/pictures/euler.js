// V - E + F, element by element, and what the number says of the surface.

/** A number with the sign that is as wide as a plus. */
const minus = (n) => String(n).replace("-", "−");

/** How many of each kind are among the elements. */
function counts_of(elements) {
    const n = { vertex: 0, edge: 0, face: 0 };
    for (const element of elements) ++n[Object.keys(element)[0]];
    return { ...n, euler: n.vertex - n.edge + n.face };
}

/** The last counts, and the parts of Euler's equation. */
function equation_of(mesh) {
    const { euler } = counts_of(mesh.elements);
    const [pieces, loops] = [mesh.pieces.length, mesh.loops.length];
    return { euler, pieces, loops, genus: pieces - (euler + loops) / 2,
             holds: mesh.orientable && !mesh.bow_ties.length };
}

/** The steps after the counting. */
function last_sentences(mesh) {
    const { euler, pieces, loops, genus, holds } = equation_of(mesh);
    const first = [
        `All counted: V − E + F = ${minus(euler)}`,
        `The mesh is in ${count_of(pieces, "piece")}: S = ${pieces}`,
        loops ? `Its border has ${count_of(loops, "loop")}: B = ${loops}`
              : "It has no border: it is closed, B = 0"];
    if (mesh.bow_ties.length)
        return [...first, `Two fans meet at V${mesh.bow_ties[0]}: this is no ` +
            "manifold, and Euler's equation does not hold"];
    if (!holds)
        return [...first, "It has one side only: Euler's equation with G " +
            "is for surfaces with two"];
    return [...first, `${minus(euler)} = 2 (S − G) − B = 2 (${pieces} − G) ` +
        `− ${loops}, so G = ${genus}: ` +
        (genus ? count_of(genus, "handle") : "no handle")];
}

/** "2 − 3 + 1 = 0": a face with those of its vertices and edges that did not
    come before. */
function brought(elements) {
    const before = elements.slice(0, -1);
    const last = before.findLastIndex((element) => "face" in element);
    const { vertex, edge, euler } = counts_of(elements.slice(last + 1));
    return `${vertex} − ${edge} + 1 = ${minus(euler)}`;
}

/** The sentence of the last of the elements. */
function element_sentence(elements) {
    const { vertex, edge, face } = elements.at(-1);
    if (face !== undefined)
        return `F${face}: plus one. All that it brought: ${brought(elements)}`;
    const [before, after] = [elements.slice(0, -1), elements].map((counted) =>
        minus(counts_of(counted).euler));
    return (edge ? `The edge V${edge.join("–V")}: minus` : `V${vertex}: plus`) +
        ` one, ${before} becomes ${after}`;
}

function euler_sentence(mesh, k) {
    const { elements } = mesh;
    if (k === 0) return "Count each vertex and face plus one, each edge " +
        "minus one";
    if (k > elements.length)
        return last_sentences(mesh)[k - elements.length - 1];
    return element_sentence(elements.slice(0, k));
}

/** What is lit: all that was counted; in the step of the border, that. */
function euler_mesh_state(mesh, k) {
    if (k === mesh.elements.length + 3 && mesh.loops.length)
        return { edges: mesh.loops.flat(),
                 vertices: mesh.loops.flat(2) };
    const counted = mesh.elements.slice(0, k);
    const pick = (kind) => counted.filter((element) => kind in element)
        .map((element) => element[kind]);
    return { vertices: pick("vertex"), faces: pick("face"),
             edges: pick("edge"), ...mesh.elements[k - 1] };
}

function counter_row(name, sign, value, is_new) {
    return html("tr", { class: is_new ? "new" : "" },
                html("td", {}, sign), html("th", {}, name),
                html("td", {}, value));
}

/** The numbers so far; `last` is the kind of the element of this step. */
function counters(counts, last) {
    const rows = [["vertex", "vertices", "+"], ["edge", "edges", "−"],
                  ["face", "faces", "+"]];
    return html("table", { class: "counters" },
        ...rows.map(([kind, name, sign]) =>
            counter_row(name, sign, counts[kind], kind === last)),
        counter_row("V − E + F", "=", minus(counts.euler), false));
}

/** Euler's equation with what is known of it by step `done` after counting. */
function equation(mesh, done) {
    const { euler, pieces, loops, genus, holds } = equation_of(mesh);
    const lines = [["S", pieces, "pieces"], ["B", loops, "border loops"]];
    if (holds) lines.push(["G", genus, "genus"]);
    return html("table", { class: "counters small" },
        ...lines.slice(0, Math.max(0, done - 1)).map(([name, value, what]) =>
            html("tr", {}, html("th", {}, `${what} ${name}`),
                 html("td", {}, value))));
}

function euler_case(mesh) {
    return {
        name: mesh.name,
        count: mesh.elements.length + 5,
        make(place) {
            const picture = mesh.net ? net_pane(place, mesh, 1.6)
                                     : mesh_pane(place, mesh, 1.6);
            const numbers = pane(place, "column");
            return (k) => {
                const counted = mesh.elements.slice(0, k);
                const last = Object.keys(mesh.elements[k - 1] || {})[0];
                picture.show(euler_mesh_state(mesh, k));
                numbers.replaceChildren(
                    counters(counts_of(counted), last),
                    equation(mesh, k - mesh.elements.length));
                return euler_sentence(mesh, k);
            };
        },
    };
}

show_cases(page_data.meshes.map(euler_case));
