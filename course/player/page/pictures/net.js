// A mesh cut open and laid flat, each face a regular polygon: where faces come
// together again, a vertex or an edge is there twice, under the same name.

/** The sides of a face as pairs of vertices. */
const face_sides = (face) =>
    face.map((v, k) => [v, face[(k + 1) % face.length]]);

const centre_of = (places) => mean([...places.keys()], places);

/** The faces across the sides of face f, with the edges. */
function neighbours_of(faces, f) {
    return face_sides(faces[f]).flatMap((edge) => {
        const neighbour = faces.findIndex((face, g) => g !== f &&
            face_sides(face).some((side) =>
                edge_name(side) === edge_name(edge)));
        return neighbour < 0 ? [] : [{ face: f, neighbour, edge }];
    });
}

/** Over which edges the faces are reached, the nearest to face 0 first; a face
    that is not reached begins anew, and has no edge. */
function links_of(faces) {
    const reached = new Set([0]);
    const links = [];
    const follow = (link) => {
        if (reached.has(link.neighbour)) return;
        reached.add(link.neighbour);
        links.push(link);
    };
    faces.forEach((_, start) => {
        follow({ neighbour: start });
        for (const f of reached) neighbours_of(faces, f).forEach(follow);
    });
    return links;
}

/** The corners of a regular polygon on the left of a-b, from a on. */
function polygon_on(a, b, sides) {
    const corners = [a, b];
    const angle = 2 * Math.PI / sides;
    let [dx, dy] = subtract(b, a);
    while (corners.length < sides) {
        [dx, dy] = [dx * Math.cos(angle) - dy * Math.sin(angle),
                    dx * Math.sin(angle) + dy * Math.cos(angle)];
        const last = corners.at(-1);
        corners.push([last[0] + dx, last[1] + dy]);
    }
    return corners;
}

/** The places of the corners of each face, y upwards. */
function unfold(faces, links = links_of(faces)) {
    const places = [];
    const put = (f, [from, to], a, b) => {
        const face = faces[f];
        const forward = face_sides(face).some(([x, y]) =>
            x === from && y === to);
        const order = forward ? face : [...face].reverse();
        const corners = polygon_on(a, b, face.length);
        const first = order.indexOf(from);
        places[f] = face.map((v) => corners[
            (order.indexOf(v) - first + face.length) % face.length]);
    };
    put(0, faces[0], [0, 0], [1, 0]);
    for (const { face, neighbour, edge } of links) {
        if (!edge) {
            const right = extent(places.flat())[0][1] + 1.3;
            put(neighbour, faces[neighbour], [right, 0], [right + 1, 0]);
            continue;
        }
        const [a, b] = edge.map((v) => places[face][faces[face].indexOf(v)]);
        const centre = centre_of(places[face]);
        const left = turn(a, b, centre) > 0;  // the neighbour lies beyond
        put(neighbour, left ? [edge[1], edge[0]] : edge,
            ...(left ? [b, a] : [a, b]));
    }
    return places;
}

function turned_by(flat, degrees) {
    const angle = degrees * Math.PI / 180;
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    return flat.map((corners) => corners.map(([x, y]) =>
        [c * x - s * y, s * x + c * y]));
}

class NetPicture {
    /** place: an SVG element; links: as of links_of, for another cut. */
    constructor(place, { faces }, links) {
        this.place = place;
        this.faces = faces;
        this.flat = unfold(faces, links);
        this.state = {};
        place.classList.add("mesh-picture");
        new ResizeObserver(() => this.show(this.state)).observe(place);
    }

    /**
     * As MeshPicture.show: faces, edges, vertices, face, edge, vertex; and
     * arrows: {f: {sense, roles}}, along the sides of face f, sense 1 or -1 as
     * the face has it; roles {edge name: class} of single ones.
     */
    show(state) {
        this.state = state;
        const frame = emptied_frame(this.place);
        if (!frame) return;
        this.font = parseFloat(getComputedStyle(this.place).fontSize);
        this.fit(frame.width, frame.height);
        this.draw_faces();
        this.draw_edges();
        this.draw_arrows();
        this.draw_vertices();
    }

    /** this.at: the corners in the frame, turned so that they are large. */
    fit(width, height) {
        const margin = 1.6 * this.font;
        const fits = [0, 30, 60, 90, 120, 150].map((degrees) => {
            const flat = turned_by(this.flat, degrees);
            const [x, y] = extent(flat.flat());
            return { flat, x, y, scale: Math.min(
                (width - 2 * margin) / (x[1] - x[0]),
                (height - 2 * margin) / (y[1] - y[0])) };
        });
        const { flat, x, y, scale } = fits.reduce((best, other) =>
            other.scale > 1.05 * best.scale ? other : best);
        this.scale = scale;
        this.at = flat.map((corners) => corners.map((p) => [
            width / 2 + scale * (p[0] - (x[0] + x[1]) / 2),
            height / 2 - scale * (p[1] - (y[0] + y[1]) / 2)]));
    }

    classes(name, lit, current) {
        return name + (lit ? " lit" : "") + (current ? " current" : "");
    }

    draw_faces() {
        const { faces: lit = [], face } = this.state;
        this.at.forEach((corners, f) => {
            svg("polygon", { points: corners.join(" "), class: this.classes(
                "face", lit.includes(f), f === face) }, this.place);
            const [x, y] = centre_of(corners);
            const text = svg("text", { x, y, class: "face-name" }, this.place);
            text.textContent = "F" + f;
        });
    }

    draw_edges() {
        const lit = new Set((this.state.edges || []).map(edge_name));
        const current = this.state.edge && edge_name(this.state.edge);
        this.each_side((f, k, name, a, b) =>
            svg("path", { d: `M${a}L${b}`, class: this.classes(
                "edge", lit.has(name), name === current) }, this.place));
    }

    each_side(run) {
        this.faces.forEach((face, f) => face_sides(face).forEach((side, k) =>
            run(f, k, edge_name(side), this.at[f][k],
                this.at[f][(k + 1) % face.length])));
    }

    draw_arrows() {
        this.each_side((f, k, name, a, b) => {
            const arrows = this.state.arrows?.[f];
            if (!arrows) return;
            const ends = arrows.sense > 0 ? [a, b] : [b, a];
            this.draw_arrow(...ends, centre_of(this.at[f]),
                            arrows.roles?.[name] || "");
        });
    }

    /** Along a-b, a little towards the centre. */
    draw_arrow(a, b, centre, role) {
        const middle = centre_of([a, b]);
        const inwards = unit(subtract(centre, middle));
        const along = unit(subtract(b, a));
        const length = this.scale - 3.4 * this.font;
        const point = (t, side) => middle.map((m, d) =>
            m + t * along[d] + (0.75 * this.font + side) * inwards[d]);
        const half = Math.max(0.8 * this.font, length / 2);
        const head = 0.8 * this.font;
        const group = svg("g", { class: "sense " + role }, this.place);
        svg("path", { d: `M${point(-half, 0)}L${point(half - head, 0)}`,
                      "stroke-width": (role ? 0.3 : 0.14) * this.font }, group);
        svg("polygon", { points: [point(half, 0), point(half - head, head / 2),
            point(half - head, -head / 2)].join(" ") }, group);
    }

    draw_vertices() {
        const { vertices: lit = [], vertex } = this.state;
        const done = new Set();
        this.faces.forEach((face, f) => face.forEach((v, k) => {
            const [x, y] = this.at[f][k];
            const place = Math.round(x) + "," + Math.round(y);
            if (done.has(place)) return;
            done.add(place);
            const group = svg("g", { class: this.classes(
                "vertex", lit.includes(v), v === vertex) }, this.place);
            svg("circle", { cx: x, cy: y, r: 0.9 * this.font }, group);
            svg("text", { x, y }, group).textContent = "V" + v;
        }));
    }
}

/** A pane with a net that fills it. */
function net_pane(place, mesh, share = 1, links = undefined) {
    const element = pane(place, "mesh-pane", share);
    return new NetPicture(svg("svg", {}, element), mesh, links);
}
