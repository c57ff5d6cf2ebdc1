// A mesh drawn with its half-edges: an arrow for each, on the left of the
// line from its vertex to its tip, with labels that never lie on one another.
// Needs svg.js, layout.js, labels.js and mesh.css.
//
//     const picture = new MeshPicture(svg_element, {points, faces, table});
//     picture.on_pick = (h) => ...;                  // an arrow was clicked
//     picture.show({current: 4, next: 11, seen: [1, 4], flags: {4: ["i"]}});
//
// The size of the text is the font size of the SVG element (CSS).

/** The vertex that half-edge h points to; -1 when the rows do not say. */
function tip_of(table, h) {
    const row = table[h];
    const opposite = table[row[3]];
    if (opposite && opposite[0] !== row[0]) return opposite[0];
    const next = table[row[2]];
    return next && next[0] !== row[0] ? next[0] : -1;
}

/** The same for both directions of an edge. */
const edge_name = ([a, b]) => Math.min(a, b) + "," + Math.max(a, b);

/** Edges as pairs of vertices, each once, of the table or of the faces. */
function edges_of(table, faces) {
    const found = new Map();
    const add = (a, b) => {
        if (a >= 0 && b >= 0 && a !== b)
            found.set(edge_name([a, b]), [a, b]);
    };
    for (let h = 0; h < table.length; ++h) add(table[h][0], tip_of(table, h));
    if (!table.length)
        for (const face of faces)
            face.forEach((v, k) => add(v, face[(k + 1) % face.length]));
    return [...found.values()];
}

function neighbours(v, edges) {
    return edges.filter((edge) => edge.includes(v))
        .map(([a, b]) => (a === v ? b : a));
}

/** [[face, [half-edges of its loop]], ...] of the loops that close. */
function face_loops(table) {
    const loops = new Map();
    table.forEach((row, start) => {
        if (row[1] < 0 || loops.has(row[1])) return;
        const loop = [];
        let h = start;
        do {
            loop.push(h);
            h = table[h][2];
        } while (table[h] && h !== start && loop.length <= table.length);
        if (h === start) loops.set(row[1], loop);
    });
    return [...loops];
}

class MeshPicture {
    /**
     * place    an SVG element, sized by CSS
     * mesh     {points, faces, table}: points of two or three coordinates,
     *          faces as lists of vertices, table as rows [vi, fi, next, opp];
     *          faces or table may be []; sparse: labels only for what is lit
     */
    constructor(place, { points, faces = [], table = [], sparse = false }) {
        this.place = place;
        this.sparse = sparse;
        this.on_pick = null;
        this.table = table;
        this.faces = faces;
        this.points = points;
        this.flat = null;
        this.state = {};
        place.classList.add("mesh-picture");
        place.addEventListener("click", (event) => this.pick(event));
        new ResizeObserver(() => this.show(this.state)).observe(place);
    }

    pick(event) {
        const element = event.target.closest("[data-half-edge]");
        if (element && this.on_pick)
            this.on_pick(Number(element.dataset.halfEdge));
    }

    /** Shows the whole mesh. */
    show_all() {
        this.whole ??= flat_layout(this.points, this.faces,
                                   edges_of(this.table, this.faces));
        this.flat = [...this.whole];
    }

    /** Of a large mesh only the faces round these half-edges. */
    focus_on(half_edges) {
        const near = new Set(half_edges.flatMap((h) =>
            this.table[h] ? [this.table[h][0], tip_of(this.table, h)] : []));
        const faces = this.faces.filter((f) => f.some((v) => near.has(v)));
        if (this.table.length < 150 || !faces.length ||
            faces.length > this.faces.length / 2) return this.show_all();
        const edges = edges_of([], faces);
        const used = new Set(edges.flat());
        this.flat = flat_layout(this.points, faces, edges)
            .map((p, v) => (used.has(v) ? p : null));
    }

    /**
     * Gives vertices of `table` that have no point yet a place amid their
     * neighbours. For tables that are edited: call it with the last one.
     */
    remember(table) {
        if (!this.flat) this.show_all();
        const edges = edges_of(table, []);
        const known = this.flat.length;
        for (const v of new Set(edges.flat().filter((v) => v >= known))) {
            const others = neighbours(v, edges).filter((o) => o < known);
            this.flat[v] = others.length > 1 ? mean(others, this.flat)
                : others.length ? this.outside(others[0], edges, known)
                : [0, 0];
        }
    }

    /** For a vertex at the end of a loose edge: away from all others. */
    outside(v, edges, known) {
        const others = neighbours(v, edges).filter((o) => o < known);
        const [x, y] = this.flat[v];
        if (!others.length) return [x + 1, y];
        const length = others.reduce((sum, o) => sum + Math.hypot(
            ...subtract(this.flat[o], this.flat[v])), 0) / others.length;
        const [ux, uy] = unit(subtract([x, y], mean(others, this.flat)));
        return [x + 0.8 * length * ux, y + 0.8 * length * uy];
    }

    /**
     * Shows a state, of which each part may be absent:
     *   table         the rows now, when they are not those of the mesh
     *   current       half-edge that is read or written
     *   next, opp     half-edge that this field of `current` leads to
     *   seen          half-edges that were visited
     *   half_edges, vertices, faces      those that are lit
     *   edges         [[v, v], ...], lit too
     *   face, edge, vertex               the one that it is about
     *   both_sides    lit faces are drawn, too, if seen from behind
     *   flags         {h: [names]}: signs at half-edges, names of variables
     *   outline       true: the edges of `faces` are drawn, too
     */
    show(state) {
        this.state = state;
        const frame = emptied_frame(this.place);
        if (!frame) return;
        const table = state.table || this.table;
        this.remember(table);
        new MeshDrawing(this, table, frame).draw();
    }
}

/** One drawing of a MeshPicture in pixels; y downwards. */
class MeshDrawing {
    constructor(picture, table, frame) {
        this.state = picture.state;
        this.faces = picture.faces;
        this.sparse = picture.sparse;
        this.point_count = picture.points.length;
        this.table = table;
        this.frame = frame;
        this.font = parseFloat(getComputedStyle(picture.place).fontSize);
        this.edges = edges_of(table, picture.faces).filter((edge) =>
            edge.every((v) => picture.flat[v]));
        this.fit(picture.flat);
        this.measure();
        this.layer = (name) => svg("g", { class: name }, picture.place);
        this.labels = new Labels(frame.width, frame.height);
    }

    /** this.at: the places of the vertices in the frame. */
    fit(flat) {
        const [x, y] = extent(flat.filter(Boolean));
        const margin = [this.font * 3, this.font * 2.5];
        const fits = [this.frame.width, this.frame.height].map((size, d) =>
            Math.max(1, size - 2 * margin[d]) /
            Math.max(1e-9, [x, y][d][1] - [x, y][d][0]));
        // Stretched a little where there is room: the labels need it.
        const scale = fits.map((fit) =>
            Math.min(fit, 1.45 * Math.min(...fits)));
        this.at = flat.map((p) => p && [
            this.frame.width / 2 + scale[0] * (p[0] - (x[0] + x[1]) / 2),
            this.frame.height / 2 - scale[1] * (p[1] - (y[0] + y[1]) / 2)]);
    }

    /** Sizes that hang on how long the edges are. */
    measure() {
        const lengths = this.edges.map(([a, b]) => Math.hypot(
            ...subtract(this.at[a], this.at[b]))).sort((a, b) => a - b);
        const middle = lengths[lengths.length >> 1] || 100;
        const digits = String(this.at.length - 1).length;
        this.radius = this.font * (0.45 + 0.33 * digits);
        this.dense = this.sparse || middle < 2 * this.radius + 1.6 * this.font;
        const thin = Math.max(0.3, Math.min(1, middle / (6 * this.font)));
        this.offset = 0.42 * this.font * thin;
        this.head = 0.8 * this.font * thin;
        if (this.dense) this.radius = 0.3 * this.font * thin;
    }

    draw() {
        const [face_layer, edge_layer, link_layer, arrow_layer, vertex_layer,
               label_layer] = ["faces", "edges", "links", "arrows", "vertices",
                               "labels"].map(this.layer);
        this.label_layer = label_layer;
        this.drawn = new Map();
        this.arrows = this.table.map((row, h) => this.arrow(h));
        this.draw_faces(face_layer);
        this.draw_edges(edge_layer);
        this.arrows.forEach((arrow) =>
            arrow && this.draw_arrow(arrow, arrow_layer));
        this.draw_vertices(vertex_layer);
        this.draw_labels();
        this.draw_link(link_layer);
    }

    /** The arrow of half-edge h: ends, direction, left normal; or null. */
    arrow(h) {
        const [from, to] = [this.table[h][0], tip_of(this.table, h)];
        const [a, b] = [this.at[from], this.at[to]];
        if (!a || !b) return null;
        const length = Math.hypot(...subtract(b, a));
        const [ux, uy] = unit(subtract(b, a));
        const [nx, ny] = [uy, -ux];
        const cut = Math.min(this.radius + 0.35 * this.font, 0.3 * length);
        const shift = this.offset * (1 + 2 * this.twins_before(from, to));
        return {
            h, length, ux, uy, nx, ny,
            x1: a[0] + ux * cut + nx * shift, y1: a[1] + uy * cut + ny * shift,
            x2: b[0] - ux * cut + nx * shift, y2: b[1] - uy * cut + ny * shift,
        };
    }

    /** In a wrong table two half-edges may run alike: side by side then. */
    twins_before(from, to) {
        const key = from + "," + to;
        const count = this.drawn.get(key) || 0;
        this.drawn.set(key, count + 1);
        return count;
    }

    draw_faces(layer) {
        const lit = this.faces_with_role();
        this.polygons = [];
        const add = (f, vertices) => {
            if (vertices.some((v) => !this.at[v])) return;
            const corners = vertices.map((v) => this.at[v]);
            this.polygons.push({ f, corners });
            if (this.is_behind(f, corners)) return;
            svg("polygon", { class: "face" + (lit.has(f) ? " lit" : "") +
                                 (f === this.state.face ? " current" : ""),
                             points: corners.join(" ") }, layer);
        };
        if (this.table.length)
            for (const [f, loop] of face_loops(this.table))
                add(f, loop.map((h) => this.table[h][0]));
        else for (const f of this.faces_in_order(lit)) add(f, this.faces[f]);
    }

    /** Those that are lit lie on top where they may be hidden. */
    faces_in_order(lit) {
        const all = [...this.faces.keys()];
        if (!this.state.both_sides) return all;
        return [...all.filter((f) => !lit.has(f)), ...lit];
    }

    draw_edges(layer) {
        const { edges = [], edge, outline } = this.state;
        const lit = new Set(edges.map(edge_name));
        const current = edge && edge_name(edge);
        const all = outline ? edges_of([], this.faces) : [];
        for (const [a, b] of [...all, ...this.edges]) {
            const name = edge_name([a, b]);
            svg("path", { class: "edge" + (lit.has(name) ? " lit" : "") +
                              (name === current ? " current" : ""),
                          d: `M${this.at[a]}L${this.at[b]}` }, layer);
        }
    }

    /** The classes of half-edge h: what it is in the state. */
    roles(h) {
        const { current, next, opp, seen = [], half_edges = [] } = this.state;
        const roles = ["half-edge"];
        if (seen.includes(h)) roles.push("seen");
        if (half_edges.includes(h)) roles.push("lit");
        if (h === next) roles.push("next");
        if (h === opp) roles.push("opp");
        if (h === current) roles.push("current");
        return roles;
    }

    draw_arrow({ h, x1, y1, x2, y2, ux, uy, nx, ny }, layer) {
        const roles = this.roles(h);
        const group = svg("g", { class: roles.join(" "),
                                 "data-half-edge": h }, layer);
        const long = Math.min(this.head, 0.7 * Math.hypot(x2 - x1, y2 - y1));
        const wide = (roles.length > 1 ? 0.5 : 0.38) * long;
        const [bx, by] = [x2 - ux * long, y2 - uy * long];
        svg("path", { class: "reach", d: `M${x1} ${y1}L${x2} ${y2}`,
                      "stroke-width": 2 * this.offset }, group);
        svg("path", { class: "shaft", d: `M${x1} ${y1}L${bx} ${by}`,
                      "stroke-width": this.offset *
                          (roles.length > 1 ? 0.6 : 0.28) }, group);
        svg("polygon", { points: [
            [x2, y2], [bx + nx * wide, by + ny * wide],
            [bx - nx * wide, by - ny * wide]].join(" ") }, group);
    }

    draw_vertices(layer) {
        const lit = new Set(this.state.vertices);
        const used = new Set(this.edges.flat());
        this.at.forEach((p, v) => {
            if (!p || (v >= this.point_count && !used.has(v))) return;
            const group = svg("g", { class: "vertex" +
                (lit.has(v) ? " lit" : "") + (used.has(v) ? "" : " unused") +
                (v === this.state.vertex ? " current" : "") }, layer);
            svg("circle", { cx: p[0], cy: p[1], r: this.radius }, group);
            if (!this.dense)
                svg("text", { x: p[0], y: p[1] }, group).textContent = "V" + v;
            this.labels.take({ x: p[0], y: p[1], w: 1.8 * this.radius,
                               h: 1.8 * this.radius });
        });
    }

    /** Of a dense mesh only what is near to half-edges with a role. */
    draw_labels() {
        this.labels.lines = this.arrows.filter(Boolean);
        this.boxes = new Map();
        const first = this.half_edges_with_role();
        const all = [...this.labels.lines].sort((a, b) =>
            a.length - b.length || a.h - b.h).map(({ h }) => h);
        const lit = this.faces_with_role();
        if (this.dense) this.label_some(first);
        else if (lit.size) this.label_half_edges(first);
        else this.label_all(all, first);
        this.draw_face_labels((f) => lit.has(f), "face-label lit");
        if (!this.dense)
            this.label_half_edges(all.filter((h) => !this.boxes.has(h)));
        this.draw_boxes();
        this.draw_flags(this.state.flags || {});
        if (!this.dense)
            this.draw_face_labels((f) => !lit.has(f), "face-label");
    }

    is_behind(f, corners) {
        return is_inside_out(corners) &&
            !(this.state.both_sides && this.faces_with_role().has(f));
    }

    faces_with_role() {
        const { faces = [], face } = this.state;
        return new Set(face === undefined ? faces : [...faces, face]);
    }

    half_edges_with_role() {
        const { current, next, opp, flags = {}, half_edges = [],
                seen = [] } = this.state;
        return [...new Set([
            current, next, opp, ...Object.keys(flags).map(Number),
            ...half_edges, ...seen].filter((h) => this.arrows[h]))];
    }

    /** In a dense mesh: these half-edges and the vertices that they leave. */
    label_some(half_edges) {
        const lit = new Set(this.state.vertices);
        lit.forEach((v) => this.label_vertex(v, "vertex-label lit"));
        this.label_half_edges(half_edges);
        for (const v of new Set(half_edges.map((h) => this.table[h][0])))
            if (!lit.has(v)) this.label_vertex(v, "vertex-label");
    }

    /** Those that found no place get theirs first in the next attempt. */
    label_all(order, first) {
        for (let attempt = 0; attempt < 8; ++attempt) {
            this.clear_labels();
            if (this.label_half_edges(order)) return;
            const placed = (h) => this.boxes.has(h);
            order = [...order.filter((h) => !placed(h)),
                     ...order.filter(placed)];
        }
        this.clear_labels();
        this.label_half_edges(first);
    }

    clear_labels() {
        const mine = new Set(this.boxes.values());
        this.labels.taken = this.labels.taken.filter((b) => !mine.has(b));
        this.boxes.clear();
    }

    /** Whether all have found a place. */
    label_half_edges(half_edges) {
        for (const h of half_edges) {
            const box = this.labels.place(this.label_places(this.arrows[h]));
            if (box) this.boxes.set(h, box);
        }
        return half_edges.every((h) => this.boxes.has(h));
    }

    /** Beside the arrow on its left, or else on it. */
    label_places({ h, x1, y1, x2, y2, nx, ny }) {
        const w = text_width("H" + h, this.font) + 0.3 * this.font;
        const tall = 1.2 * this.font;
        const beside = 0.15 * this.font + (Math.abs(nx) * w +
                                           Math.abs(ny) * tall) / 2;
        const places = [];
        for (const t of [0.5, 0.42, 0.58, 0.34, 0.66, 0.25, 0.75, 0.15, 0.85])
            for (const [side, cost] of [[beside, 0], [0, 1.5],
                                        [0.5 * beside, 1], [1.6 * beside, 3]])
                places.push({ w, h: tall, cost: cost + 4 * Math.abs(t - 0.5),
                              x: x1 + t * (x2 - x1) + side * nx,
                              y: y1 + t * (y2 - y1) + side * ny });
        return places;
    }

    label_vertex(v, classes) {
        const [x, y] = this.at[v] || [];
        if (x === undefined) return;
        const side = 2 * this.radius;
        const box = this.labels.place(around_box(
            { x, y, w: side, h: side },
            text_width("V" + v, this.font) + 0.3 * this.font,
            1.2 * this.font));
        if (box) this.draw_box(box, "V" + v, classes);
    }

    draw_boxes() {
        for (const [h, box] of this.boxes)
            this.draw_box(box, "H" + h, this.roles(h).join(" "), h);
    }

    draw_box(box, text, classes, half_edge) {
        const group = svg("g", { class: classes + " label" },
                          this.label_layer);
        if (half_edge !== undefined) group.dataset.halfEdge = half_edge;
        svg("rect", { x: box.x - box.w / 2, y: box.y - box.h / 2,
                      width: box.w, height: box.h, rx: box.h / 4 }, group);
        svg("text", { x: box.x, y: box.y }, group).textContent = text;
    }

    draw_flags(flags) {
        for (const [h, names] of Object.entries(flags)) {
            const own = this.boxes.get(Number(h));
            if (!own) continue;
            const text = names.join(" ");
            const box = this.labels.place(around_box(
                own, text_width(text, this.font) + 0.4 * this.font,
                1.3 * this.font));
            if (!box) continue;
            this.draw_box(box, text, "flag");
            // Below all labels: a flag may stand beside another half-edge.
            this.label_layer.prepend(svg("path", {
                class: "leader", "stroke-width": 0.16 * this.font,
                d: `M${own.x} ${own.y}L${box.x} ${box.y}` }));
        }
    }

    /** Where a face has most room; in a corner for the one that is behind. */
    draw_face_labels(wanted, classes) {
        const turned = this.polygons.filter((p) => is_inside_out(p.corners));
        for (const { f, corners } of this.polygons) {
            const behind = this.is_behind(f, corners);
            if (!wanted(f) || (behind && turned.length > 1)) continue;
            const text = "F" + f + (behind ? " behind" : "");
            const w = text_width(text, this.font) + 0.1 * this.font;
            const size = { w, h: 1.1 * this.font };
            const box = this.labels.place(behind
                ? corner_places(this.frame, size)
                : inner_places(corners, size, this.offset));
            if (box) this.draw_box(box, text, classes);
        }
    }

    /** A dashed curve from the half-edge that is read to where it leads. */
    draw_link(layer) {
        const { current, next, opp } = this.state;
        const to = next ?? opp;
        const [from, end] = [this.arrows[current], this.arrows[to]];
        if (!from || !end || current === to) return;
        const [a, b] = [from, end].map(({ x1, y1, x2, y2 }) =>
            [(x1 + x2) / 2, (y1 + y2) / 2]);
        const bend = [(a[0] + b[0]) / 2 + (b[1] - a[1]) * 0.2,
                      (a[1] + b[1]) / 2 - (b[0] - a[0]) * 0.2];
        svg("path", { class: "link " + (next === undefined ? "opp" : "next"),
                      d: `M${a}Q${bend} ${b}`,
                      "stroke-width": 0.16 * this.font }, layer);
    }
}

/** Of the sans-serif font in bold, a little too wide rather than too small. */
function text_width(text, font) {
    return 0.7 * font * text.length;
}

/** Clockwise on the screen is anticlockwise with y downwards. */
function is_inside_out(corners) {
    let area = 0;
    corners.forEach(([x, y], k) => {
        const [u, v] = corners[(k + 1) % corners.length];
        area += x * v - u * y;
    });
    return area >= 0;
}

/** Points of a grid inside the polygon, those far from its sides first. */
function inner_places(corners, size, margin) {
    const [[left, right], [top, bottom]] = extent(corners);
    const places = [];
    for (let j = 1; j < 16; ++j)
        for (let k = 1; k < 16; ++k) {
            const p = [left + (right - left) * j / 16,
                       top + (bottom - top) * k / 16];
            const away = Math.min(...corners.map((a, i) => segment_distance(
                p, a, corners[(i + 1) % corners.length])));
            if (is_in(p, corners) && away > size.h / 2 + margin)
                places.push({ x: p[0], y: p[1], ...size,
                              cost: -away / size.h });
        }
    return places;
}

function is_in([x, y], corners) {
    let inside = false;
    corners.forEach(([ax, ay], k) => {
        const [bx, by] = corners[(k + 1) % corners.length];
        if ((ay > y) !== (by > y) &&
            x < (bx - ax) * (y - ay) / (by - ay) + ax) inside = !inside;
    });
    return inside;
}

/** The corners of the frame. */
function corner_places({ width, height }, { w, h }) {
    return [[1, 0], [0, 0], [1, 1], [0, 1]].map(([right, low], k) => ({
        x: right ? width - w / 2 : w / 2,
        y: low ? height - h / 2 : h / 2, w, h, cost: k / 10 }));
}
