// The table is filled from the list of faces, side by side of each face.

/** The table after the first `count` steps: null where nothing is known. */
function table_after(steps, count) {
    const table = [];
    for (const { set } of steps.slice(0, count))
        for (const [i, field, value] of set) {
            while (table.length <= i) table.push([null, null, null, null]);
            table[i][field] = value;
        }
    return table;
}

const build_sentences = {
    pair: (step, [a, b]) => `${side_name(a, b)} of F${step.face} is new: ` +
        `H${step.i} for F${step.face}; opposite, H${step.i + 1} waits`,
    match: (step, [a, b]) => `${side_name(a, b)} of F${step.face}: ` +
        `H${step.i} waits there, and gets F${step.face}`,
    close: (step) => `F${step.face} is complete: its half-edges get next`,
    border: (step, side, table) => `H${step.i} still waits: it is on the ` +
        `border. Its next is H${table[step.i][2]}`,
};

function build_sentence(mesh, k) {
    if (k === 0)
        return `Given: a list of ${count_of(mesh.faces.length, "face")}. ` +
            "The table is still empty";
    if (k > mesh.steps.length)
        return `Finished: ${mesh.table.length} half-edges, each with vi, fi, ` +
            "next and opp";
    const step = mesh.steps[k - 1];
    return build_sentences[step.do](step, side_of(mesh.faces, step),
                                    mesh.table);
}

/** The two vertices of the side that the step is about. */
function side_of(faces, { face, side }) {
    if (side === undefined) return [];
    const corners = faces[face];
    return [corners[side], corners[(side + 1) % corners.length]];
}

/** The faces as rows of numbers; the side of the step is set off. */
function face_list(faces, step) {
    const table = html("table", { class: "numbers large" },
                       html("caption", {}, "list of faces"));
    faces.forEach((corners, f) => {
        const row = html("tr", {}, html("th", {}, "F" + f));
        if (f === step.face) row.className = "current";
        corners.forEach((v, k) => {
            const at = f === step.face && (step.do === "close" ||
                k === step.side || k === (step.side + 1) % corners.length);
            row.append(html("td", { class: at ? "current" : "" }, v));
        });
        table.append(row);
    });
    return table;
}

function waiting_legend() {
    return html("p", { class: "legend" }, html("span", { class: "waits" }, "?"),
                " waits for a face");
}

/** One cell; a half-edge without a face waits for one. */
function build_cell(row, field, is_new) {
    const value = row[field];
    const waits = field === 1 && value === null;
    const text = waits ? "?" : value === null ? "" : value < 0 ? "-" : value;
    return html("td", { class: is_new ? "new" : waits ? "waits" : "" }, text);
}

function half_edge_rows(table, set, rows) {
    const fresh = new Set(set.map(([i, field]) => `${i},${field}`));
    const result = html("table", { class: "numbers" }, html("tr", {},
        ...["", "vi", "fi", "next", "opp"].map((t) => html("th", {}, t))));
    for (let i = 0; i < rows; ++i) {
        const row = table[i];
        result.append(html("tr", {}, html("th", {}, row ? "H" + i : "\u00a0"),
            ...[0, 1, 2, 3].map((field) => row
                ? build_cell(row, field, fresh.has(`${i},${field}`))
                : html("td"))));
    }
    return result;
}

/** What the mesh shows; it takes -1 for what is not known. */
function build_mesh_state(table, step) {
    const waiting = [...table.keys()].filter((i) => table[i][1] === null);
    return {
        table: table.map((row) => row.map((value) => value ?? -1)),
        current: step.i,
        opp: step.do === "pair" ? step.i + 1 : undefined,
        next: step.do === "border" ? step.set[1][2] : undefined,
        half_edges: step.do === "close" ? step.set.map(([i]) => i) : [],
        seen: waiting,
    };
}

function build_case(mesh) {
    return {
        name: mesh.name,
        count: mesh.steps.length + 2,
        make(place) {
            const faces = pane(place, "narrow");
            const picture = mesh_pane(place, mesh);
            const rows = pane(place, "narrow");
            return (k) => {
                const step = mesh.steps[k - 1] || { set: [] };
                const table = table_after(mesh.steps, k);
                faces.replaceChildren(face_list(mesh.faces, step),
                                      waiting_legend());
                picture.show(build_mesh_state(table, step));
                rows.replaceChildren(half_edge_rows(table, step.set,
                                                    mesh.table.length));
                return build_sentence(mesh, k);
            };
        },
    };
}

show_cases(page_data.meshes.map(build_case));
