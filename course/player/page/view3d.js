// A large mesh in 3D, and the walks on its table: recorded ones and walks by
// hand. What stands in page_data is written by large_mesh.cpp.

const [VI, FI, NEXT, OPP] = [0, 1, 2, 3];

/** Points, sides and normals of the mesh; its box has the half diagonal 1 and
    its middle at the origin. */
class Geometry {
    constructor(table) {
        this.table = table;
        const q = table.positions, low = [1e9, 1e9, 1e9], high = [0, 0, 0];
        for (let k = 0; k < q.length; ++k) {
            low[k % 3] = Math.min(low[k % 3], q[k]);
            high[k % 3] = Math.max(high[k % 3], q[k]);
        }
        const scale = 2 / (Math.hypot(...minus(high, low)) || 1);
        this.points = new Float32Array(q.length);
        for (let k = 0; k < q.length; ++k)
            this.points[k] = scale * (q[k] - (low[k % 3] + high[k % 3]) / 2);
    }

    point(v) {
        return [...this.points.subarray(3 * v, 3 * v + 3)];
    }

    ends(h) {
        return [this.point(this.table.vi[h]), this.point(this.table.vi[h ^ 1])];
    }

    corners(f) {
        const { starts, corners } = this.table;
        return [...corners.subarray(starts[f], starts[f + 1])];
    }

    centre(f) {
        const corners = this.corners(f);
        return corners.reduce(
            (sum, v) => along(sum, 1 / corners.length, this.point(v)),
            [0, 0, 0]);
    }

    normal(f) {
        const p = this.corners(f).map((v) => this.point(v));
        let sum = [0, 0, 0];
        for (let k = 1; k + 1 < p.length; ++k)
            sum = along(sum, 1, cross(minus(p[k], p[0]), minus(p[k + 1], p[0])));
        return unit(sum);
    }

    /** Of the face that h runs along; on the border that of the other side. */
    normal_beside(h) {
        const f = Math.max(this.table.fi[h], this.table.fi[h ^ 1]);
        if (this.table.fi[h] >= 0) return this.normal(this.table.fi[h]);
        return f >= 0 ? this.normal(f) : [0, 0, 1];
    }
}

const table = new LargeTable(page_data.mesh);
const geometry = new Geometry(table);
const camera = new Camera();
const raster = new Raster(at_id("mesh"), geometry.points, table.corners,
                          table.starts);
const arrows = new Arrows(at_id("arrows"), geometry, raster, camera, pick);
const recording = page_data.recording ||
    { exercise: "", starts: "half-edge", sources: [], walks: [] };

// ---- walks

const exists = (h) => h >= 0 && h < table.size;

/** A walk whose states have the rows of the table that it comes to. */
class LargeWalk extends Walk {
    first_table() {
        const rows = [];
        for (const h of this.visited())
            if (exists(h)) rows[h] = table.row(h);
        return rows;
    }

    /** Where it is: the half-edge of step k, or of the last one before. */
    place(k) {
        if (this.by_hand) return k > 0 ? this.step(k).v : this.start;
        const step = this.steps.slice(0, k).findLast(({ i }) => exists(i));
        return step?.i ?? (recording.starts === "half-edge" ? this.start : -1);
    }

    /** All half-edges that it reads or writes. */
    rows() {
        return [...new Set(this.steps.map(({ i }) => i).filter(exists))];
    }
}

recording.code = recording.sources.map((source) => new Source(source));
const walks = recording.walks.map((walk) => new LargeWalk(recording, walk));
let walk = null;   // the one that is shown
let state = null;  // of its step

/** The half-edges of the face (or border) that h runs along, from h on; then
    those that leave its vertex, and their opposites; at most 24 of each. */
function neighbours(h) {
    const face = [], star = [];
    let i = h;
    do {
        face.push(i);
        i = table.next[i];
    } while (i !== h && face.length < 24);
    i = h;
    do {
        star.push(i, i ^ 1);
        i = table.next[i ^ 1];
    } while (i !== h && star.length < 48);
    return [...new Set([...face, ...star])];
}

/** What is shown beside the current half-edge: all of a small walk, so that the
    picture stands still, else what is near. */
function near_rows() {
    const rows = walk.by_hand ? [] : walk.rows();
    if (rows.length > 0 && rows.length <= 40) return rows;
    return exists(state.at) ? neighbours(state.at) : [];
}

function state_of(k) {
    const now = walk.state(k);
    now.k = k;
    now.at = walk.place(k);
    if (walk.by_hand && walk.is_last(k)) now.current = now.at;
    return now;
}

/** The half-edge that the step reads; -1: none. */
function target() {
    const read = state.next ?? state.opp ?? -1;
    return exists(read) ? read : -1;
}

function choose(chosen, k) {
    walk = chosen;
    at_id("walks").value = walks.indexOf(walk);
    stepper.reset(walk.count, k);
}

/** A click: the recorded walk from there, or the first of one by hand. */
function pick(h) {
    const found = recording.starts === "half-edge" && walks.find((one) =>
        one.start === h && (walk.by_hand || one.source === walk.source));
    if (found) choose(found, 0);
    else start_by_hand(h);
}

const by_hand = (start, steps) => new LargeWalk(recording, {
    by_hand: true, call: `by hand from H${start}`, start, steps });

function start_by_hand(h) {
    choose(by_hand(h, []), 0);
}

/** Reads fields one after the other, each of the half-edge read before. */
function move(...fields) {
    if (!exists(state.at)) return;
    let h = state.at;
    const steps = walk.by_hand ? walk.steps.slice(0, state.k) : [];
    const start = walk.by_hand ? walk.start : h;
    for (const f of fields) {
        steps.push({ i: h, f, v: table.row(h)[f] });
        h = table.row(h)[f];
    }
    choose(by_hand(start, steps), steps.length + 1);
}

// ---- words, source, variables, rows

/** Where a walk by hand is. */
function say_place() {
    const { at } = state, reads = walk.steps.length;
    const [v, f] = table.row(at);
    const is_back = reads > 0 && at === walk.start;
    return { main: `H${at} leaves V${v}, ` +
                 (f < 0 ? "on the border" : `along F${f}`),
             more: is_back ? `The start again, after ${reads} reads.` : "" };
}

function draw_texts() {
    const { k } = state;
    show_words(walk.by_hand && walk.is_last(k) ? say_place()
                                               : say_state(walk, k, state));
    show_variables(state, walk.step(k), k);
    if (walk.code.lines.length)
        code.show(walk.code, state.line, state.columns);
    else at_id("code").replaceChildren();
    for (const h of near_rows()) state.table[h] ??= table.row(h);
    rows.show(state);
}

// ---- the picture

/** Half-edges that get an arrow, the most important first. */
function half_edges_shown() {
    const kinds = new Map();
    const add = (h, kind) => {
        if (exists(h) && !kinds.has(h)) kinds.set(h, kind);
    };
    add(state.at, "cur");
    add(target(), state.next === undefined ? "opp" : "next");
    for (const h of state.seen.slice(-200)) add(h, "seen");
    for (const h of near_rows()) add(h, "near");
    return [...kinds].map(([h, kind]) => ({ h, kind }));
}

/** Labels of vertices and faces: what the step reads, then the ends of the
    current half-edge and its face. */
function spots_shown() {
    const { at, vertices = [], faces = [] } = state;
    if (!exists(at)) return [];
    const spots = [table.vi[at], table.vi[at ^ 1]].map((v) => ({
        text: `V${v}`, point: geometry.point(v),
        kind: vertices.includes(v) ? "vertex hit" : "vertex" }));
    const f = table.fi[at];
    if (f >= 0)
        spots.push({ text: `F${f}`, point: geometry.centre(f),
                     kind: faces.includes(f) ? "face hit" : "face" });
    return spots;
}

const marked = { none: 0, walked: 1, current: 2, read: 3 };

function mark_faces() {
    const mark = (h, kind) => {
        if (exists(h) && table.fi[h] >= 0) raster.marks[table.fi[h]] = kind;
    };
    raster.marks.fill(marked.none);
    for (const h of state.seen) mark(h, marked.walked);
    mark(state.at, state.faces ? marked.read : marked.current);
}

function use_colours() {
    const style = getComputedStyle(document.documentElement);
    const colour = (name) => style.getPropertyValue(name).trim()
        .match(/[0-9a-f]{2}/g).map((part) => parseInt(part, 16));
    const darker = (c) => c.map((x) => 0.7 * x);
    const back = [colour("--back-shade"), colour("--back-lit")];
    const sides = ["--trail-bg", "--cur-bg", "--cell-bg"].flatMap(
        (name) => [[darker(colour(name)), colour(name)], back]);
    raster.set_colours([[colour("--shade"), colour("--lit")], back, ...sides],
                       colour("--ground"), colour("--edge"));
}

let frame_asked = false, still = null, cost = 0, is_moving = false;

/** Draws before the next frame of the screen; coarser while it moves, where
    that takes long. */
function ask_frame(moving = false) {
    is_moving = moving;
    clearTimeout(still);
    if (moving) still = setTimeout(() => ask_frame(), 150);
    if (frame_asked) return;
    frame_asked = true;
    requestAnimationFrame(() => {
        frame_asked = false;
        draw_picture();
    });
}

function draw_picture() {
    const { clientWidth: w, clientHeight: h } = at_id("stage");
    const pixels = Math.min(devicePixelRatio, Math.sqrt(1.5e6 / (w * h)));
    const coarse = is_moving && cost > 40 ? 0.5 : 1;
    camera.resize(w, h);
    raster.resize(Math.round(w * pixels * coarse),
                  Math.round(h * pixels * coarse));
    const begin = performance.now();
    raster.draw(camera);
    if (coarse === 1) cost = performance.now() - begin;
    arrows.draw(half_edges_shown(), spots_shown());
}

// ---- the camera

let follows = true;

/** A view of a ball: from where its half-edges are seen from outside. */
function view_of(half_edges) {
    const points = half_edges.flatMap((h) => geometry.ends(h));
    const low = [0, 1, 2].map((c) => Math.min(...points.map((p) => p[c])));
    const high = [0, 1, 2].map((c) => Math.max(...points.map((p) => p[c])));
    const middle = low.map((x, c) => (x + high[c]) / 2);
    const out = unit(half_edges.reduce(
        (sum, h) => along(sum, 1, geometry.normal_beside(h)), [0, 0, 0]));
    const radius = Math.max(...points.map((p) =>
        Math.hypot(...minus(p, middle))));
    return { target: middle, yaw: Math.atan2(out[0], out[2]),
             pitch: Math.asin(out[1]), distance: 3.4 * radius || 1 };
}

/** The whole walk where that is small, else what is near to the half-edge. It
    depends on nothing but the walk and the step. */
function view_of_step() {
    if (!exists(state.at)) return camera.view;
    const near = view_of(neighbours(state.at));
    const rows = walk.rows();
    if (rows.length === 0 || rows.length > 200) return near;
    const all = view_of([...rows, walk.place(walk.count - 1)]);
    return all.distance < 3 * near.distance ? all : near;
}

function glide(to) {
    const from = camera.view, begin = performance.now();
    const full = 2 * Math.PI;
    const turn = ((to.yaw - from.yaw + Math.PI) % full + full) % full - Math.PI;
    const mix = (a, b, s) => a + s * (b - a);
    const calm = matchMedia("(prefers-reduced-motion: reduce)").matches;
    glide.running = to;
    const go_on = (now) => {
        if (glide.running !== to) return;
        const part = calm ? 1 : Math.min(1, Math.max(0, (now - begin) / 350));
        const s = part * part * (3 - 2 * part);
        camera.look(s === 1 ? to : {
            target: from.target.map((x, c) => mix(x, to.target[c], s)),
            yaw: from.yaw + s * turn, pitch: mix(from.pitch, to.pitch, s),
            distance: from.distance * (to.distance / from.distance) ** s });
        ask_frame(part < 1);
        if (part < 1) requestAnimationFrame(go_on);
    };
    go_on(begin);
}

function look_by_hand(change) {
    follows = false;
    glide.running = null;
    camera.look({ ...camera.view, ...change });
    ask_frame(true);
}

function turn(yaw, pitch) {
    const { view } = camera;
    look_by_hand({ yaw: view.yaw + yaw,
                   pitch: Math.max(-1.55, Math.min(1.55, view.pitch + pitch)) });
}

function zoom(factor) {
    const distance = camera.view.distance * factor;
    look_by_hand({ distance: Math.max(1e-4, Math.min(12, distance)) });
}

function follow() {
    follows = true;
    glide(view_of_step());
}

function show_all() {
    follows = false;
    glide({ ...camera.view, target: [0, 0, 0], distance: 3.3 });
}

// ---- mouse, fingers, keys

/** The half-edge of a face that is nearest to a place on the screen. */
function nearest_in_face(f, x, y) {
    const distance = (h) => {
        const [a, b] = geometry.ends(h).map((p) => camera.project(p));
        const dx = b.x - a.x, dy = b.y - a.y;
        const s = ((x - a.x) * dx + (y - a.y) * dy) / (dx * dx + dy * dy);
        const t = Math.max(0, Math.min(1, s || 0));
        return Math.hypot(a.x + t * dx - x, a.y + t * dy - y);
    };
    let best = table.first[f];
    for (let h = table.next[best]; h !== table.first[f]; h = table.next[h])
        if (distance(h) < distance(best)) best = h;
    return best;
}

function pick_at(x, y) {
    const scale = raster.width / camera.width;
    const f = raster.face_at(Math.floor(x * scale), Math.floor(y * scale));
    if (f >= 0) pick(nearest_in_face(f, x, y));
}

/** Drag turns, two fingers zoom, a click picks. */
function listen_to_pointers(stage) {
    const down = new Map();
    let moved = 0;
    const spread = () => {
        const [a, b] = [...down.values()];
        return Math.hypot(a.offsetX - b.offsetX, a.offsetY - b.offsetY);
    };
    stage.onpointerdown = (event) => {
        if (down.size === 0) moved = 0;
        down.set(event.pointerId, event);
    };
    stage.onpointermove = (event) => {
        const before = down.get(event.pointerId);
        if (!before) return;
        const old = down.size === 2 ? spread() : 0;
        const dx = event.clientX - before.clientX;
        const dy = event.clientY - before.clientY;
        down.set(event.pointerId, event);
        moved += Math.hypot(dx, dy);
        if (moved < 5) return;
        stage.setPointerCapture(event.pointerId);
        if (old > 0) zoom(old / spread());
        else turn(-0.008 * dx, 0.008 * dy);
    };
    const end = (event) => down.delete(event.pointerId);
    stage.onpointerup = stage.onpointercancel = end;
    stage.onclick = (event) => {
        const box = stage.getBoundingClientRect();
        if (moved < 5 && !event.target.closest("#arrows g"))
            pick_at(event.clientX - box.left, event.clientY - box.top);
    };
    stage.onwheel = (event) => {
        event.preventDefault();
        zoom(Math.exp(0.0015 * event.deltaY));
    };
}

const own_keys = {
    n: { text: "by hand: next", run: () => move(NEXT) },
    o: { text: "by hand: opp", run: () => move(OPP) },
    t: { text: "by hand: opp, then next (round the vertex)",
         run: () => move(OPP, NEXT) },
    f: { text: "follow the walk", run: follow },
    a: { text: "all of the mesh", run: show_all },
    "+": { text: "nearer", run: () => zoom(0.8) },
    "-": { text: "farther", run: () => zoom(1.25) },
    j: { text: "turn", run: () => turn(-0.15, 0) },
    l: { text: "turn", run: () => turn(0.15, 0) },
    i: { text: "turn", run: () => turn(0, 0.15) },
    k: { text: "turn", run: () => turn(0, -0.15) },
    ">": { text: "faster", run: () => stepper.change_speed(1.4) },
    "<": { text: "slower", run: () => stepper.change_speed(1 / 1.4) },
    g: { text: "go to a half-edge", run: () => at_id("go").select() },
};

// ---- the page

function draw(k) {
    state = state_of(k);
    draw_texts();
    mark_faces();
    if (follows) glide(view_of_step());
    else ask_frame();
    const place = walk.by_hand ? { half_edge: walk.start }
                               : { walk: walks.indexOf(walk) };
    write_link({ ...place, step: k });
}

function go_to_half_edge() {
    const h = Number(at_id("go").value);
    if (exists(h)) pick(h);
    else show_words({ main: `There is no H${h}.`,
                      more: `The half-edges are 0 to ${table.size - 1}.` });
    at_id("go").blur();
}

function make_header() {
    const number = (n) => n.toLocaleString("en").replaceAll(",", "\u2009");
    at_id("title").textContent = document.title;
    at_id("counts").textContent = `${number(table.first.length)} faces`;
    const hand = html("option", { value: -1 }, "by hand");
    at_id("walks").append(hand, ...walks.map((one, n) =>
        html("option", { value: n }, recording.sources.length > 1
            ? `${one.call}, ${recording.sources[one.source].label}`
            : one.call)));
    at_id("walks").hidden = walks.length === 0;
    at_id("walks").onchange = () => {
        const chosen = walks[at_id("walks").value];
        if (chosen) choose(chosen, 0);
        else start_by_hand(Math.max(0, state.at));
    };
    at_id("go").onchange = go_to_half_edge;
    at_id("go").max = table.size - 1;
}

function start_at(link) {
    const chosen = walks[link.walk ?? (link.half_edge ? -1 : 0)];
    const h = Number(link.half_edge ?? 0);
    if (chosen) choose(chosen, Number(link.step ?? 0));
    else start_by_hand(exists(h) ? h : 0);
    if (!chosen && !link.half_edge) show_all();
}

const code = new CodePicture(at_id("code"));
const rows = new TablePicture(at_id("rows"));
rows.on_pick = pick;
const stepper = new Stepper(at_id("transport"), { draw, keys: own_keys });
use_colours();
new MutationObserver(() => {
    use_colours();
    ask_frame();
}).observe(document.documentElement, { attributeFilter: ["data-theme"] });
new ResizeObserver(() => ask_frame()).observe(at_id("stage"));
listen_to_pointers(at_id("stage"));
make_header();
start_at(read_link());
