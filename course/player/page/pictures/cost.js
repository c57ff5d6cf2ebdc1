// The same query on the list of faces and on half-edges, read by read; and what
// becomes of it when the mesh grows.

const query = page_data.query;

/** A column: what it is, its mesh, and how many reads so far. */
function cost_column(place, name, mesh) {
    const column = pane(place, "column");
    column.append(html("p", { class: "caption" }, name));
    const picture = mesh_pane(column, mesh);
    const reads = html("p", { class: "big reads" });
    column.append(reads);
    return { picture, reads };
}

/** What was found in the first `count` steps of a query. */
function found_in(steps, count) {
    return steps.slice(0, count).filter(({ found = true }) => found)
        .map(({ face }) => face);
}

function show_reads(column, steps, count) {
    const n = count ? steps[Math.min(count, steps.length) - 1].reads : 0;
    const done = count >= steps.length ? ", done" : "";
    column.reads.textContent = `${count_of(n, "read")}${done}`;
}

function query_sentence(k) {
    const { search, walk, vertex } = query;
    if (k === 0) return `Which faces are at V${vertex}? Both know, but at ` +
        "what price?";
    const face = search[k - 1];
    const left = `The list looks at F${face.face}: ` +
        (face.found ? "found" : "not at V" + vertex);
    if (k < walk.length)
        return `${left}. The walk is at H${walk[k - 1].i}: ` +
            `F${walk[k - 1].face}`;
    if (k === walk.length)
        return `The walk is round V${vertex} and done: ` +
            `${walk.at(-1).reads} reads. The list must go on`;
    if (k < search.length) return left;
    return `The list had to read all of it: ${face.reads} against ` +
        walk.at(-1).reads;
}

const query_case = {
    name: "one query",
    count: query.search.length + 1,
    make(place) {
        const { points, faces, table, vertex, search, walk } = query;
        const left = cost_column(place, "list of faces: search it",
                                 { points, faces, sparse: true });
        const right = cost_column(place, "half-edges: walk round the vertex",
                                  { points, faces, table, sparse: true });
        return (k) => {
            left.picture.show({
                face: k ? search[k - 1].face : undefined,
                faces: found_in(search, k), vertices: [vertex] });
            right.picture.show({
                current: k <= walk.length ? walk[k - 1]?.i : undefined,
                seen: walk.slice(0, k).map(({ i }) => i),
                faces: found_in(walk, k), vertices: [vertex] });
            show_reads(left, search, k);
            show_reads(right, walk, k);
            return query_sentence(k);
        };
    },
};

// ---- the chart: both axes count by factors of ten

const chart = { width: 1000, height: 490, left: 150, right: 760, top: 30,
                bottom: 400 };

/** 12345 as "12 345" */
const grouped = (n) => String(n).replace(/\B(?=(\d{3})+$)/g, "\u2009");

const log_scale = (low, high, from, to) => (value) =>
    from + (Math.log10(value) - low) / (high - low) * (to - from);

const chart_x = log_scale(1, 6.1, chart.left, chart.right);
const chart_y = log_scale(0.8, 6.6, chart.bottom, chart.top);

function chart_text(parent, x, y, text, name) {
    svg("text", { x, y, class: name }, parent).textContent = text;
}

function draw_axes(parent) {
    for (let power = 1; power <= 6; ++power) {
        const [x, y] = [chart_x(10 ** power), chart_y(10 ** power)];
        svg("path", { class: "grid", d: `M${x} ${chart.top}V${chart.bottom}` +
            `M${chart.left} ${y}H${chart.right}` }, parent);
        chart_text(parent, chart.left - 12, y, grouped(10 ** power), "left");
        if (power % 2)
            chart_text(parent, x, chart.bottom + 28, grouped(10 ** power),
                       "middle");
    }
    chart_text(parent, (chart.left + chart.right) / 2, chart.bottom + 62,
               "triangles in the mesh", "middle");
    chart_text(parent, 4, chart.top - 8, "reads", "right");
}

/** The line of one structure, as far as it was measured. */
function draw_line(parent, sizes, field, label) {
    const points = sizes.map((size) => [chart_x(size.faces),
                                        chart_y(size[field])]);
    const group = svg("g", { class: field }, parent);
    svg("polyline", { points: points.join(" ") }, group);
    for (const [x, y] of points)
        svg(...(field === "walk"
            ? ["circle", { cx: x, cy: y, r: 9 }]
            : ["rect", { x: x - 8, y: y - 8, width: 16, height: 16 }]), group);
    if (!points.length) return;
    const [x, y] = points.at(-1);
    const low = field === "walk" ? 0 : Math.max(0, chart.top + 10 - y);
    chart_text(group, x + 22, y + low - 14, label, "right");
    chart_text(group, x + 22, y + low + 16, grouped(sizes.at(-1)[field]),
               "right");
}

function growing_sentence(k) {
    if (k === 0) return "The same query, on larger and larger meshes";
    const { faces, search, walk } = page_data.growing[k - 1];
    return `${grouped(faces)} triangles: the list reads ${grouped(search)} ` +
        `numbers, the walk ${grouped(walk)}`;
}

const growing_case = {
    name: "growing meshes",
    count: page_data.growing.length + 1,
    make(place) {
        const element = svg("svg", {
            class: "chart", viewBox: `0 0 ${chart.width} ${chart.height}`,
        }, pane(place));
        return (k) => {
            element.textContent = "";
            draw_axes(element);
            const sizes = page_data.growing.slice(0, k);
            draw_line(element, sizes, "search", "list of faces");
            draw_line(element, sizes, "walk", "half-edges");
            return growing_sentence(k);
        };
    },
};

show_cases([query_case, growing_case]);
