// Where the vertices of a mesh stand in the plane, so that its half-edges can
// be read: no two vertices on one place and as few crossing edges as possible.
// Seen from some directions, and, for what no direction shows well, drawn with
// one face or border loop outside and each other vertex amid its neighbours
// (Tutte, "How to draw a graph", 1963).

const subtract = (a, b) => a.map((x, k) => x - b[k]);
const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                         a[0] * b[1] - a[1] * b[0]];
const unit = (a) => a.map((x) => x / (Math.hypot(...a) || 1));

/** Twice the signed area of the triangle a, b, c; positive: anticlockwise. */
function turn(a, b, c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/** The points in the plane across `towards`, which points at the eye. */
function seen_from(points, towards) {
    const z = unit(towards);
    const help = Math.abs(z[1]) < 0.9 ? [0, 1, 0] : [0, 0, -Math.sign(z[1])];
    const x = unit(cross(help, z));
    const y = cross(z, x);
    return points.map((p) => [dot(p, x), dot(p, y)]);
}

/** The sum of the normals of the faces, each as long as its area. */
function area_vector_sum(points, faces) {
    const sum = [0, 0, 0];
    for (const face of faces)
        for (let k = 1; k + 1 < face.length; ++k) {
            const [a, b, c] = [face[0], face[k], face[k + 1]]
                .map((v) => points[v]);
            cross(subtract(b, a), subtract(c, a))
                .forEach((x, d) => (sum[d] += x));
        }
    return sum;
}

/** Directions to look from, the usual ones first, `count` more all round. */
function directions(points, faces, count) {
    const found = [[0, 0, 1], area_vector_sum(points, faces),
                   [0, 0.4, 1], [0.35, 0.45, 1], [-0.5, 0.7, 0.8]];
    const golden = Math.PI * (3 - Math.sqrt(5));
    for (let k = 0; k < count; ++k) {
        const z = 1 - (2 * k + 1) / count;
        const r = Math.sqrt(1 - z * z);
        found.push([r * Math.cos(golden * k), z, r * Math.sin(golden * k)]);
    }
    return found.filter((d) => Math.hypot(...d) > 1e-9);
}

/** Loops of vertices along the border, run through like border half-edges. */
function border_loops(faces) {
    const directed = new Set();
    const sides = faces.flatMap((face) =>
        face.map((v, k) => [v, face[(k + 1) % face.length]]));
    for (const [a, b] of sides) directed.add(a + "," + b);
    const next = new Map();
    for (const [a, b] of sides)
        if (!directed.has(b + "," + a)) next.set(b, a);
    const loops = [];
    while (next.size) {
        const loop = [];
        let v = next.keys().next().value;
        while (next.has(v)) {
            loop.push(v);
            const to = next.get(v);
            next.delete(v);
            v = to;
        }
        if (loop.length > 2) loops.push(loop);
    }
    return loops;
}

/** `outside` on a circle, clockwise; each other vertex amid its neighbours. */
function tutte(count, edges, outside) {
    const flat = Array.from({ length: count }, () => [0, 0]);
    const fixed = new Set(outside);
    outside.forEach((v, k) => {
        const angle = Math.PI * (1 / outside.length - 0.5 -
                                 2 * k / outside.length);
        flat[v] = [Math.cos(angle), Math.sin(angle)];
    });
    const around = flat.map(() => []);
    for (const [a, b] of edges) {
        around[a].push(b);
        around[b].push(a);
    }
    for (let round = 0; round < 300; ++round)
        around.forEach((others, v) => {
            if (!fixed.has(v) && others.length) flat[v] = mean(others, flat);
        });
    return flat;
}

function mean(vertices, flat) {
    const sum = [0, 0];
    for (const v of vertices) {
        sum[0] += flat[v][0] / vertices.length;
        sum[1] += flat[v][1] / vertices.length;
    }
    return sum;
}

/** Distance of p from the segment a, b. */
function segment_distance(p, a, b) {
    const ab = subtract(b, a);
    const length = dot(ab, ab) || 1;
    const t = Math.max(0, Math.min(1, dot(subtract(p, a), ab) / length));
    return Math.hypot(p[0] - a[0] - t * ab[0], p[1] - a[1] - t * ab[1]);
}

function cross_each_other([a, b], [c, d], flat) {
    if (a === c || a === d || b === c || b === d) return false;
    const [p, q, r, s] = [a, b, c, d].map((v) => flat[v]);
    return turn(p, q, r) * turn(p, q, s) < 0 &&
        turn(r, s, p) * turn(r, s, q) < 0;
}

/** How far the nearest vertex is from an edge, in parts of the whole width. */
function spacing(flat, edges) {
    const used = [...new Set(edges.flat())];
    let least = Infinity;
    for (const v of used)
        for (const [a, b] of edges)
            if (v !== a && v !== b)
                least = Math.min(least, segment_distance(
                    flat[v], flat[a], flat[b]));
    const [x, y] = extent(used.map((v) => flat[v]));
    return least / (Math.max(x[1] - x[0], y[1] - y[0]) || 1);
}

/** [[least x, largest x], [least y, largest y]]. */
function extent(flat) {
    return [0, 1].map((d) => [Math.min(...flat.map((p) => p[d])),
                              Math.max(...flat.map((p) => p[d]))]);
}

/** The part of the faces that run clockwise, as if seen from behind. */
function turned_over(flat, faces) {
    const area = (face) => face.slice(2).reduce((sum, v, k) =>
        sum + turn(flat[face[0]], flat[face[k + 1]], flat[v]), 0);
    return faces.filter((face) => area(face) < 0).length / (faces.length || 1);
}

/** The less the better: crossings, vertices near to edges, faces turned. */
function layout_cost(flat, edges, faces) {
    let crossings = 0;
    for (let j = 0; j < edges.length; ++j)
        for (let k = 0; k < j; ++k)
            if (cross_each_other(edges[j], edges[k], flat)) ++crossings;
    return crossings + 0.05 / (spacing(flat, edges) + 1e-4) +
        turned_over(flat, faces);
}

/** Each layout worth trying, made when it is asked for. */
function* layouts(points, faces, edges) {
    const large = edges.length > 250;
    for (const direction of directions(points, faces, large ? 0 : 24))
        yield seen_from(points, direction);
    const by_size = (a, b) => b.length - a.length;
    const outsides = [...border_loops(faces).sort(by_size),
                      ...[...faces].sort(by_size)].slice(0, large ? 1 : 8);
    for (const outside of outsides) {
        const flat = tutte(points.length, edges, outside);
        for (const power of [1, 0.75, 0.55, 0.4])  // more room in the middle
            yield flat.map((p) => p.map((x) =>
                x * Math.pow(Math.hypot(...p) || 1, power - 1)));
    }
}

/**
 * The points (two or three coordinates each) in the plane, y upwards.
 * Takes the first layout that is good, else the best.
 */
function flat_layout(points, faces, edges) {
    const solid = points.map((p) => [p[0], p[1], p[2] || 0]);
    const from_above = seen_from(solid, [0, 0, 1]);
    if (!edges.length || edges.length > 900) return from_above;
    const enough = solid.every((p) => p[2] === solid[0][2]) ? 1 : 0.45;
    let best = null;
    for (const flat of layouts(solid, faces, edges)) {
        const cost = layout_cost(flat, edges, faces);
        if (!best || cost < best.cost) best = { flat, cost };
        if (cost < enough) break;
    }
    return best.flat;
}
