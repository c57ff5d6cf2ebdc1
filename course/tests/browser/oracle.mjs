// Answers to the traversal exercises by brute force over the face list: nothing
// here follows next or opp. Written from the contracts, not from the solutions.

const same_set = (a, b) => a.length === b.length &&
    [...a].sort().join() === [...b].sort().join();

const same_list = (a, b) => a.length === b.length && a.join() === b.join();

/** The faces, and for each half-edge where it leads from and to, and its face.
    The table tells only which number a side of a face has. */
export class FaceList {
    constructor({ faces, table }) {
        this.faces = faces;
        this.half_edges = table.map(([vi, fi, , opp]) => ({
            from: vi, to: table[opp][0], face: fi }));
    }

    /** What is wrong with the table: each side of each face must be one row. */
    faults() {
        const sides = this.faces.flatMap((corners, face) => corners.map(
            (from, k) => [from, corners[(k + 1) % corners.length], face]));
        const rows = this.half_edges.filter(({ face }) => face >= 0)
            .map(({ from, to, face }) => [from, to, face]);
        return same_set(sides.map(String), rows.map(String))
            ? [] : [`sides ${sides.join("; ")}, rows ${rows.join("; ")}`];
    }

    /** The faces that go from one vertex to the other. */
    along(from, to) {
        return this.faces.flatMap((corners, face) => corners.flatMap((v, k) =>
            v === from && corners[(k + 1) % corners.length] === to
                ? [face] : []));
    }

    /** The sides of a face, as pairs of vertices. */
    sides(face) {
        const corners = this.faces[face] ?? [];
        return corners.map((v, k) => [v, corners[(k + 1) % corners.length]]);
    }

    neighbours(v) {
        const ends = this.half_edges.flatMap(({ from, to }) =>
            from === v ? [to] : to === v ? [from] : []);
        return [...new Set(ends)];
    }
}

const at = (mesh, i) => mesh.half_edges[i];
const unique = (list) => [...new Set(list)];

/** For an exercise: the right answer, and when an answer is as good. */
export const oracle = {
    face_sides: {
        answer: (mesh, i) => mesh.sides(at(mesh, i).face).length },
    face_vertices: {
        answer: (mesh, i) => {
            const { from, face } = at(mesh, i);
            const corners = mesh.faces[face] ?? [];
            const k = corners.indexOf(from);
            return [...corners.slice(k), ...corners.slice(0, Math.max(k, 0))];
        },
        same: same_list },
    adjacent_edge_count: {
        answer: (mesh, i) => mesh.sides(at(mesh, i).face)
            .filter(([a, b]) => mesh.along(b, a).length > 0).length },
    adjacent_faces: {
        answer: (mesh, i) => unique(mesh.sides(at(mesh, i).face)
            .flatMap(([a, b]) => mesh.along(b, a)))
            .filter((face) => face !== at(mesh, i).face),
        same: same_set },
    face_across: {
        answer: (mesh, i) =>
            mesh.along(at(mesh, i).to, at(mesh, i).from)[0] ?? null },
    vertex_degree: {
        answer: (mesh, i) => mesh.neighbours(at(mesh, i).from).length },
    vertex_star: {
        answer: (mesh, i) => mesh.neighbours(at(mesh, i).from),
        same: same_set },
    vertex_faces: {
        answer: (mesh, i) => mesh.faces.flatMap((corners, face) =>
            corners.includes(at(mesh, i).from) ? [face] : []),
        same: same_set },
    outgoing: {
        answer: (mesh, v) => mesh.half_edges.flatMap(({ from }, i) =>
            from === v ? [i] : []),
        same: same_set },
};

/** Whether a result is right; `start` is what the walk began at. */
export function is_right(exercise, mesh, start, result) {
    const { answer, same = (a, b) => a === b } = oracle[exercise];
    return same(answer(mesh, start), result);
}
