// Triangles on a 2D canvas, with a depth buffer and the face of each pixel; the
// reason why it is not WebGL stands in large_mesh.h.

/** A camera that turns round a target, the y axis upwards. Lengths are those of
    the mesh, angles in radians. */
class Camera {
    constructor() {
        this.view = { target: [0, 0, 0], yaw: 0.5, pitch: 0.35, distance: 3 };
        this.resize(1, 1);
    }

    resize(width, height) {
        this.width = width;
        this.height = height;
        this.focal = 1.6 * Math.min(width, height);
        this.look(this.view);
    }

    look(view) {
        this.view = view;
        const { target, yaw, pitch, distance } = view;
        const [sy, cy] = [Math.sin(yaw), Math.cos(yaw)];
        const [sp, cp] = [Math.sin(pitch), Math.cos(pitch)];
        this.right = [cy, 0, -sy];
        this.up = [-sy * sp, cp, -cy * sp];
        this.back = [sy * cp, sp, cy * cp];
        this.eye = target.map((t, c) => t + distance * this.back[c]);
        this.near = 0.02 * distance;
    }

    /** {x, y} in pixels, z: the distance in front of the eye. */
    project(p) {
        const d = [p[0] - this.eye[0], p[1] - this.eye[1], p[2] - this.eye[2]];
        const z = Math.max(-dot(d, this.back), this.near);
        return { x: this.width / 2 + this.focal * dot(d, this.right) / z,
                 y: this.height / 2 - this.focal * dot(d, this.up) / z, z };
    }
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                         a[0] * b[1] - a[1] * b[0]];
const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
/** a + s * b */
const along = (a, s, b) => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
const unit = (a) => {
    const length = Math.hypot(...a);
    return length > 0 ? a.map((x) => x / length) : [0, 0, 1];
};

/** Faces as triangles, three corners each, a fan from the first corner. */
function fans(corners, starts) {
    const faces = starts.length - 1;
    const count = corners.length - 2 * faces;
    const triangles = new Int32Array(3 * count), face_of = new Int32Array(count);
    for (let f = 0, t = 0; f < faces; ++f)
        for (let k = starts[f] + 2; k < starts[f + 1]; ++k, ++t) {
            triangles[3 * t] = corners[starts[f]];
            triangles[3 * t + 1] = corners[k - 1];
            triangles[3 * t + 2] = corners[k];
            face_of[t] = f;
        }
    return { triangles, face_of };
}

const shades = 128;

/** Of two colours as pixels have them, in 256 steps: 0 the first, 256 the
    second. Red and blue are reckoned at once. */
function mix_colours(a, b, step) {
    const red_blue = (a & 0xff00ff) * (256 - step) + (b & 0xff00ff) * step;
    const green = (a & 0xff00) * (256 - step) + (b & 0xff00) * step;
    return (0xff000000 | red_blue >>> 8 & 0xff00ff | green >>> 8 & 0xff00) >>> 0;
}

/**
 * new Raster(canvas, points, corners, starts)
 *   points    coordinates, three of each vertex
 *   corners   of all faces; those of face f from starts[f] on
 * After draw: face_at(x, y) and depth_at(x, y) tell what a pixel shows.
 */
class Raster {
    constructor(canvas, points, corners, starts) {
        this.context = canvas.getContext("2d", { alpha: false });
        this.canvas = canvas;
        this.points = points;
        Object.assign(this, fans(corners, starts));
        this.marks = new Uint8Array(starts.length - 1);  // palette of each face
        this.palettes = new Uint32Array(shades);
        const n = points.length / 3;
        this.x = new Float32Array(n);
        this.y = new Float32Array(n);
        this.w = new Float32Array(n);  // 1 / distance; 0: not in front
        // The triangle that is drawn: three edge functions and w, at the first
        // pixel and their steps.
        this.start = new Float64Array(4);
        this.step_x = new Float64Array(4);
        this.step_y = new Float64Array(4);
        this.near = new Float64Array(3);
    }

    /** One [dark, lit] of [r, g, b] for each side of each kind of mark: the
        front of mark 0, its back, the front of mark 1 ... */
    set_colours(pairs, ground, edges) {
        const pack = ([r, g, b]) => (0xff000000 | b << 16 | g << 8 | r) >>> 0;
        this.palettes = new Uint32Array(shades * pairs.length);
        pairs.forEach(([dark, lit], p) => {
            for (let s = 0; s < shades; ++s)
                this.palettes[p * shades + s] = pack(dark.map(
                    (d, c) => Math.round(d + (lit[c] - d) * s / (shades - 1))));
        });
        this.ground = pack(ground);
        this.edges = pack(edges);
    }

    resize(width, height) {
        if (this.width === width && this.height === height) return;
        this.width = this.canvas.width = width;
        this.height = this.canvas.height = height;
        this.image = this.context.createImageData(width, height);
        this.pixels = new Uint32Array(this.image.data.buffer);
        this.depth = new Float32Array(width * height);
        this.faces = new Int32Array(width * height);
    }

    draw(camera) {
        this.pixels.fill(this.ground);
        this.depth.fill(0);
        this.faces.fill(-1);
        this.project(camera);
        this.light = unit(along(along(camera.back, 0.35, camera.up), -0.25,
                                camera.right));
        const count = this.face_of.length;
        for (let t = 0; t < count; ++t) this.triangle(t);
        this.context.putImageData(this.image, 0, 0);
    }

    face_at(x, y) {
        return this.faces[y * this.width + x] ?? -1;
    }

    /** The distance of what pixel x, y shows; infinite where it is nothing. */
    depth_at(x, y) {
        return 1 / (this.depth[y * this.width + x] || 0);
    }

    project(camera) {
        const { points, x, y, w } = this;
        const [ex, ey, ez] = camera.eye, [rx, ry, rz] = camera.right;
        const [ux, uy, uz] = camera.up, [bx, by, bz] = camera.back;
        const fx = camera.focal * this.width / camera.width;
        const cx = this.width / 2, cy = this.height / 2;
        for (let v = 0, k = 0; v < x.length; ++v, k += 3) {
            const dx = points[k] - ex, dy = points[k + 1] - ey;
            const dz = points[k + 2] - ez;
            const z = -(dx * bx + dy * by + dz * bz);
            const s = z > camera.near ? 1 / z : 0;
            x[v] = cx + fx * s * (dx * rx + dy * ry + dz * rz);
            y[v] = cy - fx * s * (dx * ux + dy * uy + dz * uz);
            w[v] = s;
        }
    }

    /** Finds the box of pixels that the triangle may cover, and fills it. */
    triangle(t) {
        const { x, y, w, triangles } = this;
        const a = triangles[3 * t], b = triangles[3 * t + 1];
        const c = triangles[3 * t + 2];
        if (w[a] === 0 || w[b] === 0 || w[c] === 0) return;
        const x0 = Math.max(0, Math.ceil(Math.min(x[a], x[b], x[c]) - 0.5));
        const y0 = Math.max(0, Math.ceil(Math.min(y[a], y[b], y[c]) - 0.5));
        const x1 = Math.min(this.width,
                            Math.ceil(Math.max(x[a], x[b], x[c]) - 0.5));
        const y1 = Math.min(this.height,
                            Math.ceil(Math.max(y[a], y[b], y[c]) - 0.5));
        if (x0 < x1 && y0 < y1) this.fill(t, a, b, c, x0, y0, x1, y1);
    }

    /** The number in the palettes for a triangle that is seen from its front
        or its back. */
    colour(t, a, b, c, is_front) {
        const p = this.points, { 0: lx, 1: ly, 2: lz } = this.light;
        const ux = p[3 * b] - p[3 * a], uy = p[3 * b + 1] - p[3 * a + 1];
        const uz = p[3 * b + 2] - p[3 * a + 2], vx = p[3 * c] - p[3 * a];
        const vy = p[3 * c + 1] - p[3 * a + 1];
        const vz = p[3 * c + 2] - p[3 * a + 2];
        const nx = uy * vz - uz * vy, ny = uz * vx - ux * vz;
        const nz = ux * vy - uy * vx;
        const lit = Math.abs(lx * nx + ly * ny + lz * nz) /
            Math.sqrt(nx * nx + ny * ny + nz * nz);
        const palette = 2 * this.marks[this.face_of[t]] + (is_front ? 0 : 1);
        return this.palettes[palette * shades + (lit * (shades - 1) | 0)];
    }

    /** An edge function, k of three: positive inside the triangle, whichever
        way it is wound (s: 1 or -1); px, py is where the scan begins. */
    set_edge(k, s, dx, dy, px, py) {
        this.start[k] = s * (dx * py - dy * px);
        this.step_x[k] = -s * dy;
        this.step_y[k] = s * dx;
    }

    /** Which pixels of the triangle show its sides, and how much of them; the
        inner sides of a fan are no edges of the mesh. Lines vanish by and by
        where they come too close to each other. */
    set_lines(t, area, colour) {
        const { step_x: x, step_y: y, near, face_of } = this;
        for (let k = 0; k < 3; ++k)
            near[k] = Math.sqrt(x[k] * x[k] + y[k] * y[k]);
        const room = area / Math.max(near[0], near[1], near[2]);
        const step = Math.min(256, Math.floor(17 * (room - 5)));
        const line = step > 0 ? 1 : 0;
        near[0] *= face_of[t - 1] === face_of[t] ? 0 : line;
        near[1] *= line;
        near[2] *= face_of[t + 1] === face_of[t] ? 0 : line;
        this.line = mix_colours(colour, this.edges, Math.max(0, step));
    }

    fill(t, a, b, c, x0, y0, x1, y1) {
        const { x, y, w } = this;
        const abx = x[b] - x[a], aby = y[b] - y[a];
        const cax = x[a] - x[c], cay = y[a] - y[c];
        const area = cax * aby - abx * cay, s = area > 0 ? 1 : -1;
        if (area === 0) return;
        const px = x0 + 0.5, py = y0 + 0.5;
        this.set_edge(0, s, abx, aby, px - x[a], py - y[a]);
        this.set_edge(1, s, x[c] - x[b], y[c] - y[b], px - x[b], py - y[b]);
        this.set_edge(2, s, cax, cay, px - x[c], py - y[c]);
        const wb = w[b] - w[a], wc = w[c] - w[a];
        this.step_x[3] = (wc * aby + wb * cay) / -area;
        this.step_y[3] = (wb * cax + wc * abx) / area;
        this.start[3] = w[a] + (px - x[a]) * this.step_x[3] +
            (py - y[a]) * this.step_y[3];
        const colour = this.colour(t, a, b, c, area < 0);
        this.near[0] = this.near[1] = this.near[2] = 0;
        if (x1 - x0 > 5 || y1 - y0 > 5) this.set_lines(t, s * area, colour);
        this.scan(x0, y0, x1, y1, this.face_of[t], colour);
    }

    // Nearly all the time of a frame is spent here: all in local variables.
    scan(x0, y0, x1, y1, f, colour) {
        const { depth, pixels, faces, line } = this;
        const { 0: x_0, 1: x_1, 2: x_2, 3: x_w } = this.step_x;
        const { 0: y_0, 1: y_1, 2: y_2, 3: y_w } = this.step_y;
        const { 0: near_0, 1: near_1, 2: near_2 } = this.near;
        let { 0: row_0, 1: row_1, 2: row_2, 3: row_w } = this.start;
        for (let row = y0 * this.width; y0 < y1; ++y0) {
            let e_0 = row_0, e_1 = row_1, e_2 = row_2, at_w = row_w;
            for (let i = row + x0; i < row + x1; ++i) {
                if (e_0 >= 0 && e_1 >= 0 && e_2 >= 0 && at_w > depth[i]) {
                    depth[i] = at_w;
                    faces[i] = f;
                    pixels[i] = e_0 < near_0 || e_1 < near_1 || e_2 < near_2
                        ? line : colour;
                }
                e_0 += x_0, e_1 += x_1, e_2 += x_2, at_w += x_w;
            }
            row_0 += y_0, row_1 += y_1, row_2 += y_2, row_w += y_w;
            row += this.width;
        }
    }
}
