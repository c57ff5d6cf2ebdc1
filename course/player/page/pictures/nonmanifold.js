// Why an edge with three faces has no place in the table, and what a walk
// round a vertex with two fans meets.

// ---- edges

/** Which step of the page belongs to which defect, and to which of its uses;
    the step after the uses is what the builder says. */
function defect_steps(defects) {
    return defects.flatMap((defect) => [
        ...defect.uses.map((use, u) => ({ defect, u })),
        { defect, u: defect.uses.length }]);
}

/** Which of the uses finds its half-edge taken already. */
const is_taken = ({ uses }, u) => uses.slice(0, u).some(({ from }) =>
    from === uses[u].from);

function edge_sentence(mesh, step) {
    if (!step)
        return "A row of the table has one face, and one opposite. Is that " +
            "enough for this mesh?";
    const { defect, u } = step;
    if (u === defect.uses.length) return `The builder: ${defect.says}`;
    const { face, from, to } = defect.uses[u];
    const runs = `F${face} runs ${side_name(from, to)}: `;
    if (!is_taken(defect, u)) return runs + "it takes this half-edge";
    return runs + `taken, by F${defect.uses.find((use) =>
        use.from === from).face}. There is no place for it`;
}

/** The half-edges of the edge and who has them. */
function edge_uses({ defect, u }) {
    const rows = defect.uses.slice(0, u + 1).map(({ face, from, to }, k) =>
        html("tr", { class: is_taken(defect, k) ? "refused" : "" },
             html("th", {}, side_name(from, to)), html("td", {}, "F" + face),
             html("td", {}, is_taken(defect, k) ? "no place" : "")));
    return html("table", { class: "counters small" },
                html("caption", {}, `edge V${defect.edge.join("–V")}`),
                ...rows);
}

function edge_case(mesh) {
    const steps = defect_steps(mesh.defects);
    return {
        name: mesh.name,
        count: steps.length + 1,
        make(place) {
            const picture = mesh_pane(place, mesh, 1.5);
            const uses = pane(place, "column");
            return (k) => {
                const step = steps[k - 1];
                const used = step ? step.defect.uses.slice(0, step.u + 1) : [];
                picture.show({ both_sides: true, edge: step?.defect.edge,
                               face: step?.defect.uses[step.u]?.face,
                               faces: used.map(({ face }) => face) });
                uses.replaceChildren(step ? edge_uses(step) : "");
                return edge_sentence(mesh, step);
            };
        },
    };
}

// ---- vertices

const tips = ({ table, walk }) => walk.map((h) => table[table[h][3]][0]);

function vertex_sentence(mesh, k) {
    const { vertex, neighbours, walk } = mesh;
    const names = (list) => listed(list.map((v) => "V" + v));
    if (k === 0)
        return `V${vertex} has the neighbours ${names(neighbours)}. Walk ` +
            "round it: opp, then next";
    if (k <= walk.length)
        return (k === 1 ? "Start" : "opp, then next") + `: H${walk[k - 1]} ` +
            `goes to V${tips(mesh)[k - 1]}`;
    const missed = neighbours.filter((v) => !tips(mesh).includes(v));
    if (k === walk.length + 1)
        return `Back at H${walk[0]}: the walk ends. ` +
            (missed.length ? `It missed ${names(missed)}` : "It met all");
    return missed.length
        ? `Two fans at V${vertex}: the walk stays in the one where it starts`
        : `Two fans at V${vertex}, but one border goes through both: so does ` +
            "the walk";
}

/** The neighbours of the vertex, and which of them were met. */
function neighbour_list({ neighbours }, met, done) {
    const text = (v) => met.includes(v) ? "met" : done ? "missed" : "";
    return html("table", { class: "counters small" },
        html("caption", {}, "neighbours"),
        ...neighbours.map((v) => html("tr", {
            class: text(v) === "missed" ? "refused" : "" },
            html("th", {}, "V" + v), html("td", {}, text(v)))));
}

function vertex_case(mesh) {
    const { walk, vertex } = mesh;
    return {
        name: mesh.name,
        count: walk.length + 3,
        make(place) {
            const picture = mesh_pane(place, mesh, 1.8);
            const list = pane(place, "column");
            return (k) => {
                const met = tips(mesh).slice(0, k);
                picture.show({ current: walk[Math.min(k - 1, walk.length) %
                                             walk.length],
                               seen: walk.slice(0, k), start: walk[0],
                               vertices: [vertex, ...met] });
                list.replaceChildren(
                    neighbour_list(mesh, met, k > walk.length));
                return vertex_sentence(mesh, k);
            };
        },
    };
}

show_cases([...page_data.edges.map(edge_case),
            ...page_data.vertices.map(vertex_case)]);
