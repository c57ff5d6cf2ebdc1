// How many whole numbers each structure takes for a face, and which they are.

/** 13.5 as "13.5", 3.3333 as "3.33" */
const rounded = (n) => String(Math.round(n * 100) / 100);

const numbers_of = ({ parts }) =>
    parts.reduce((sum, { numbers }) => sum + numbers, 0);

const per_face = (mesh, structure) => numbers_of(structure) / mesh.faces;

function bar(mesh, structure, most, is_current) {
    const value = per_face(mesh, structure);
    return html("div", { class: "bar-row" + (is_current ? " current" : "") },
        html("span", { class: "bar-name" }, structure.name),
        html("span", { class: "bar-track" }, html("span", {
            class: "bar", style: `width: ${100 * value / most}%` })),
        html("span", { class: "bar-value" }, rounded(value)));
}

function bars(mesh, k) {
    const most = Math.max(...mesh.structures.map((s) => per_face(mesh, s)));
    return html("div", { class: "bars" }, ...mesh.structures.slice(0, k)
        .map((structure, j) => bar(mesh, structure, most, j === k - 1)));
}

/** The numbers of one record as boxes; of a list, how many on average. */
function boxes_of({ fields, entry, records, numbers }) {
    const names = fields || [`${entry} × ${rounded(numbers / records)}`];
    return names.map((name) => html("span", { class: "box" }, name));
}

/** "1.5 edges have [from] [to] ... = 12" */
function part_line(mesh, part) {
    const many = rounded(part.records / mesh.faces);
    const names = { vertex: "vertices" };
    const name = many === "1" ? part.of : names[part.of] || part.of + "s";
    return html("div", { class: "part" },
        html("span", { class: "part-name" }, `${many} ${name}:`),
        html("span", { class: "boxes" }, ...boxes_of(part)),
        html("span", { class: "bar-value" },
             rounded(part.numbers / mesh.faces)));
}

function integers_sentence(mesh, k) {
    const { vertices, edges, faces, structures } = mesh;
    if (k === 0)
        return `${vertices} vertices, ${edges} edges, ${faces} faces: what ` +
            `does a ${mesh.face} cost?`;
    const shares = `For each ${mesh.face} there are ` +
        `${rounded(vertices / faces)} vertices and ${rounded(edges / faces)} ` +
        "edges: that decides";
    if (k > structures.length) return shares;
    const value = per_face(mesh, structures[k - 1]);
    const times = rounded(value / per_face(mesh, structures[0]));
    const name = structures[k - 1].name;
    return `${name[0].toUpperCase()}${name.slice(1)}: ${rounded(value)} ` +
        `for each ${mesh.face}` + (k > 1 ? `, ${times} times the list` : "");
}

function integers_case(mesh) {
    return {
        name: mesh.name,
        count: mesh.structures.length + 2,
        make(place) {
            const all = pane(place, "column integers");
            return (k) => {
                const structure = mesh.structures[k - 1];
                const lines = structure
                    ? structure.parts.map((part) => part_line(mesh, part)) : [];
                all.replaceChildren(bars(mesh, k),
                                    html("div", { class: "parts" }, ...lines));
                return integers_sentence(mesh, k);
            };
        },
    };
}

show_cases(page_data.meshes.map(integers_case));
