// The half-edge table of a large mesh, made in the page from the faces: they
// are a third of its size.

/** The numbers of a list that large_mesh.cpp packed: differences to the number
    `stride` places before, 7 bits a byte, the sign in the lowest bit. */
function unpack({ count, stride, packed }) {
    const bytes = atob(packed);
    const numbers = new Int32Array(count);
    for (let i = 0, at = 0; i < count; ++i) {
        let rest = 0, shift = 0, byte;
        do {
            byte = bytes.charCodeAt(at++);
            rest |= (byte & 127) << shift;
            shift += 7;
        } while (byte & 128);
        numbers[i] = (rest >>> 1) ^ -(rest & 1);
        if (i >= stride) numbers[i] += numbers[i - stride];
    }
    return numbers;
}

/** Where each face begins in the list of corners, and the end of the last. */
function face_starts(runs) {
    let faces = 0;
    for (let r = 0; r < runs.length; r += 2) faces += runs[r];
    const starts = new Int32Array(faces + 1);
    for (let r = 0, f = 0; r < runs.length; r += 2)
        for (let k = 0; k < runs[r]; ++k, ++f)
            starts[f + 1] = starts[f] + runs[r + 1];
    return starts;
}

/** As course/halfedge/build.cpp: opposites side by side, numbered as the faces
    name the edges. vi, fi, next are arrays; opp of i is i ^ 1. */
class LargeTable {
    constructor(mesh) {
        this.positions = unpack(mesh.positions);
        this.corners = unpack(mesh.corners);
        this.starts = face_starts(unpack(mesh.sides));
        this.size = mesh.half_edges;
        this.vi = new Int32Array(this.size);
        this.fi = new Int32Array(this.size).fill(-1);
        this.next = new Int32Array(this.size).fill(-1);
        this.first = new Int32Array(this.starts.length - 1);
        this.made = 0;
        // Of each vertex, a list of half-edges that wait for their face,
        // threaded through `next`.
        this.waiting = new Int32Array(this.positions.length / 3).fill(-1);
        for (let f = 0; f < this.first.length; ++f) this.add_face(f);
        const ends = unpack(mesh.loose);
        for (let e = 0; e < ends.length; e += 2)
            this.add_edge(ends[e], ends[e + 1], -1);
        this.link_borders();
        if (this.sum() !== mesh.sum)
            throw new Error("the table of this page is not the program's");
    }

    row(i) {
        return [this.vi[i], this.fi[i], this.next[i], i ^ 1];
    }

    add_edge(from, to, face) {
        const i = this.made;
        this.made += 2;
        this.vi[i] = from;
        this.vi[i + 1] = to;
        this.fi[i] = face;
        return i;
    }

    side(from, to, face) {
        const { vi, next } = this;
        const low = Math.min(from, to);
        let before = -1;
        for (let i = this.waiting[low]; i !== -1; before = i, i = next[i]) {
            if (vi[i] !== from || vi[i - 1] !== to) continue;
            if (before === -1) this.waiting[low] = next[i];
            else next[before] = next[i];
            this.fi[i] = face;
            return i;
        }
        const i = this.add_edge(from, to, face);
        next[i + 1] = this.waiting[low];
        this.waiting[low] = i + 1;
        return i;
    }

    add_face(f) {
        const begin = this.starts[f], end = this.starts[f + 1];
        let last = -1;
        for (let k = begin; k < end; ++k) {
            const to = this.corners[k + 1 < end ? k + 1 : begin];
            const i = this.side(this.corners[k], to, f);
            if (last === -1) this.first[f] = i;
            else this.next[last] = i;
            last = i;
        }
        this.next[last] = this.first[f];
    }

    link_borders() {
        const { vi, fi, next, waiting } = this;
        waiting.fill(-1);
        for (let i = 0; i < this.size; ++i) {
            if (fi[i] !== -1) continue;
            let j = i ^ 1;
            while (fi[j] !== -1) j = next[j] ^ 1;
            next[j] = i;
            const before = waiting[vi[i]];
            if (before === -1) waiting[vi[i]] = j;
            else [next[before], next[j]] = [next[j], next[before]];
        }
    }

    sum() {
        let sum = 2166136261;
        const add = (cell) => { sum = Math.imul(sum ^ cell, 16777619); };
        for (let i = 0; i < this.size; ++i) {
            add(this.vi[i]);
            add(this.fi[i]);
            add(this.next[i]);
            add(i ^ 1);
        }
        return sum >>> 0;
    }
}
