// Meshes in space, drawn from behind to the front (painter's algorithm) with
// parallel projection; turned by dragging or by keys.

const vector = {
    plus: (a, b) => a.map((x, k) => x + b[k]),
    minus: (a, b) => a.map((x, k) => x - b[k]),
    times: (s, a) => a.map((x) => s * x),
    dot: (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0),
    cross: (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                      a[0] * b[1] - a[1] * b[0]],
    length: (a) => Math.hypot(...a),
    unit: (a) => vector.times(1 / (vector.length(a) || 1), a),
    mean: (list) => vector.times(1 / list.length, list.reduce(vector.plus)),
};

/** From where all solids of a page are seen: angles in degrees. */
class View {
    constructor(yaw, pitch) {
        this.first = { yaw, pitch };
        this.yaw = yaw;
        this.pitch = pitch;
        this.solids = [];
    }

    turn(yaw, pitch) {
        this.yaw += yaw;
        this.pitch = Math.max(-90, Math.min(90, this.pitch + pitch));
        this.redraw();
    }

    reset() {
        Object.assign(this, this.first);
        this.redraw();
    }

    redraw() {
        this.solids = this.solids.filter(({ svg }) => svg.isConnected);
        for (const solid of this.solids) solid.draw();
    }

    /** What of p is to the right, up, and towards the eye. */
    seen(p) {
        const yaw = this.yaw * Math.PI / 180, pitch = this.pitch * Math.PI / 180;
        const right = Math.cos(yaw) * p[0] + Math.sin(yaw) * p[1];
        const away = Math.cos(yaw) * p[1] - Math.sin(yaw) * p[0];
        return [right, p[2] * Math.cos(pitch) + away * Math.sin(pitch),
                p[2] * Math.sin(pitch) - away * Math.cos(pitch)];
    }

    keys() {
        const key = (text, yaw, pitch) =>
            ({ text, run: () => this.turn(yaw, pitch) });
        return {
            j: key("turn left", 10, 0), l: key("turn right", -10, 0),
            i: key("from above", 0, 10), k: key("from below", 0, -10),
            r: { text: "first view", run: () => this.reset() },
        };
    }
}

/**
 * new Solid(place, view, frame, name)
 *   frame  what is seen of space; see frame_of
 *   name   for those who hear the page
 * frame and zoom may be changed before show
 * show({faces, lines, dots})
 *   faces  {at: [point...], is: class, front_only: true where the eye never
 *          sees its back, as in a closed mesh}
 *   lines  {at: [from, to], is, arrow: true for a head}
 *   dots   {at: point, is, text, size: its radius, beside: [x, y] of the text
 *          from it}, in the size of text
 *   each with `lift`: how much nearer it counts as than it is, so that it
 *   hides, or is not hidden by, what it lies on
 */
class Solid {
    constructor(place, view, frame, name) {
        this.view = view;
        this.frame = frame;
        this.zoom = 1;
        this.parts = { faces: [], lines: [], dots: [] };
        this.svg = svg("svg", { class: "solid", role: "img",
                                "aria-label": name }, place);
        view.solids.push(this);
        this.turn_by_dragging();
        new ResizeObserver(() => this.draw()).observe(place);
    }

    show({ faces = [], lines = [], dots = [] }) {
        this.parts = { faces, lines, dots };
        this.draw();
    }

    draw() {
        if (!this.svg.isConnected) return;  // another case is shown
        const { faces, lines, dots } = this.parts;
        this.measure();
        const all = [
            ...faces.flatMap((part) => this.face(part)),
            ...lines.map((part) => this.line(part)),
            ...dots.map((part) => this.dot(part)),
        ];
        all.sort((a, b) => a.depth - b.depth);
        this.svg.replaceChildren(...all.map(({ element }) => element));
    }

    /** Where the center is, how long 1 is, and the size of text, in pixels. */
    measure() {
        const { width, height } = this.svg.getBoundingClientRect();
        this.middle = [width / 2, height / 2];
        const { around, up } = this.frame;
        const pitch = this.view.pitch * Math.PI / 180;
        const high = up * Math.cos(pitch) + around * Math.abs(Math.sin(pitch));
        this.scale = 0.47 * this.zoom * Math.min(width / around, height / high);
        this.em = parseFloat(getComputedStyle(this.svg).fontSize);
    }

    on_screen(p) {
        const [x, y, depth] = this.view.seen(vector.minus(p, this.frame.center));
        return [this.middle[0] + x * this.scale,
                this.middle[1] - y * this.scale, depth];
    }

    /** The part with its depth; `points` are on the screen. */
    placed(part, points, element) {
        const depth = points.reduce((sum, p) => sum + p[2], 0) / points.length;
        return { depth: depth + (part.lift || 0), element };
    }

    /** A list of one, or of none when its back is not to be seen. */
    face(part) {
        const points = part.at.map((p) => this.on_screen(p));
        // How much light falls on it, from the upper left behind the eye.
        const normal = vector.unit(this.view.seen(vector.cross(
            vector.minus(part.at[1], part.at[0]),
            vector.minus(part.at[2], part.at[0]))));
        if (part.front_only && normal[2] < 0) return [];
        const light = vector.dot(normal, vector.unit([-0.5, 0.7, 0.8]));
        const element = svg("polygon", {
            points: points.map(([x, y]) => `${x.toFixed(1)},${y.toFixed(1)}`)
                .join(" "),
            class: `facet ${part.is || ""}`,
            style: `--light:${Math.max(0, light).toFixed(2)}`,
        });
        return [this.placed(part, points, element)];
    }

    line(part) {
        const points = part.at.map((p) => this.on_screen(p));
        const [[x1, y1], [x2, y2]] = points;
        const element = svg("g", { class: `line ${part.is || ""}` });
        svg("line", { x1, y1, x2, y2 }, element);
        if (part.arrow) this.head(points, element);
        return this.placed(part, points, element);
    }

    head([[x1, y1], [x2, y2]], place) {
        const long = Math.hypot(x2 - x1, y2 - y1) || 1;
        const u = [(x2 - x1) / long, (y2 - y1) / long], size = 0.7 * this.em;
        const corner = (back, side) =>
            `${x2 - back * u[0] - side * u[1]},${y2 - back * u[1] + side * u[0]}`;
        svg("polygon", { points: [corner(-size / 3, 0), corner(size, size / 2),
                                  corner(size, -size / 2)].join(" ") }, place);
    }

    dot(part) {
        const point = this.on_screen(part.at);
        const element = svg("g", {
            class: `dot ${part.is || ""}`,
            transform: `translate(${point[0].toFixed(1)},${point[1].toFixed(1)})`,
        });
        const { size = 0.35 } = part;
        if (size) svg("circle", { r: size * this.em }, element);
        if (part.text) {
            const [dx, dy] = part.beside || [0, 0];
            svg("text", { x: dx * this.em, y: dy * this.em }, element)
                .textContent = part.text;
        }
        return this.placed(part, [point], element);
    }

    turn_by_dragging() {
        let last = null;
        this.svg.onpointerdown = (event) => {
            last = event;
            this.svg.setPointerCapture(event.pointerId);
        };
        this.svg.onpointermove = (event) => {
            if (!last) return;
            this.view.turn((last.clientX - event.clientX) / 2,
                           (event.clientY - last.clientY) / 2);
            last = event;
        };
        this.svg.onpointerup = this.svg.onpointercancel = () => last = null;
    }
}

/** The faces of {points, faces}, each of the class that `is` gives it. */
function facets({ points, faces }, is = () => "") {
    return faces.map((face, f) => ({
        at: face.map((v) => points[v]), is: is(f, face) }));
}

/** Those of a closed mesh, as show takes them. */
function closed_facets(mesh) {
    return facets(mesh).map((part) => ({ ...part, front_only: true }));
}

/**
 * The room that the points need, however it is turned round: how far they are
 * from the upright axis through the center, and how far above or below it.
 */
function frame_of(points) {
    const bound = (pick) => points.reduce(
        (most, p) => p.map((x, k) => pick(x, most[k])));
    const center = vector.mean([bound(Math.min), bound(Math.max)]);
    const most = (of) => Math.max(...points.map(
        (p) => of(...vector.minus(p, center))));
    return { center, around: most((x, y) => Math.hypot(x, y)),
             up: most((x, y, z) => Math.abs(z)) };
}

/** A solid below a heading, and a place for a line about it; see Solid. */
function add_solid(place, view, heading, frame) {
    const drawing = html("div", { class: "drawing" });
    const note = html("p", { class: "note" });
    place.append(html("figure", { class: "pane one-solid" },
                      html("figcaption", {}, heading), drawing, note));
    return { solid: new Solid(drawing, view, frame, heading), note };
}

/** 0.0123 as "1.2 %". */
function percent(x, digits = 0) {
    return `${(100 * x).toFixed(digits)} %`;
}
