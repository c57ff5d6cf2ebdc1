// Arrows and labels of a few half-edges over a mesh in 3D.

/** Half-edge h in space: its ends drawn in to the face that it runs along, on
    the border to the outside. */
function arrow_in_space(geometry, h) {
    const [a, b] = geometry.ends(h);
    const edge = minus(b, a), length = Math.hypot(...edge);
    const left = unit(cross(geometry.normal_beside(h), edge));
    const inside = along(a, 0.08 * length, left);
    return { from: along(inside, 0.17, edge), to: along(inside, 0.83, edge),
             middle: along(inside, 0.5, edge),
             beside: along(inside, 0.5, along(edge, 0.1 * length, left)),
             length };
}

/** Of the page, in pixels: the widths of the arrows hang on it, too. */
const text_size = () => parseFloat(getComputedStyle(document.body).fontSize);

class Arrows {
    /** element: the SVG over the canvas; on_pick(h): an arrow was clicked. */
    constructor(element, geometry, raster, camera, on_pick) {
        Object.assign(this, { element, geometry, raster, camera, on_pick });
    }

    /** half_edges: [{h, kind}], the most important first, kind one of cur,
        next, opp, seen, near; spots: [{text, point, kind}], labels at points,
        placed after the labels of cur, next and opp. */
    draw(half_edges, spots) {
        const { width, height } = this.camera;
        this.element.setAttribute("viewBox", `0 0 ${width} ${height}`);
        this.element.replaceChildren();
        this.size = text_size();
        this.taken = [];
        const seen = half_edges.map((one) => this.on_screen(one))
            .filter((one) => one !== null);
        for (const one of [...seen].reverse()) this.draw_arrow(one);
        const first = (one) => ["cur", "next", "opp"].includes(one.kind);
        for (const one of seen.filter(first)) this.block(one);
        for (const one of seen.filter(first)) this.label_arrow(one);
        if (seen.some((one) => one.kind === "near" || one.kind === "seen"))
            for (const spot of spots) this.label_spot(spot);
        for (const one of seen) if (!first(one)) this.label_arrow(one);
    }

    on_screen({ h, kind }) {
        const arrow = arrow_in_space(this.geometry, h);
        let from = this.camera.project(arrow.from);
        let to = this.camera.project(arrow.to);
        const middle = this.camera.project(arrow.middle);
        const length = Math.hypot(to.x - from.x, to.y - from.y);
        const least = kind === "near" || kind === "seen" ? 0 : 2 * this.size;
        if (length < 0.5 * this.size && least === 0) return null;
        if (length < least) {
            const s = length > 0.01 ? least / length / 2 : 0;
            const half = s > 0 ? { x: s * (to.x - from.x),
                                   y: s * (to.y - from.y) }
                               : { x: least / 2, y: 0 };
            from = { x: middle.x - half.x, y: middle.y - half.y };
            to = { x: middle.x + half.x, y: middle.y + half.y };
        }
        const beside = this.camera.project(arrow.beside);
        return { h, kind, from, to, middle, beside,
                 behind: this.is_hidden(middle, arrow.length) };
    }

    is_hidden({ x, y, z }, length) {
        const scale = this.raster.width / this.camera.width;
        if (x < 0 || y < 0 || x >= this.camera.width ||
            y >= this.camera.height) return false;
        const shown = this.raster.depth_at(Math.floor(x * scale),
                                           Math.floor(y * scale));
        return z - shown > 0.4 * length;
    }

    draw_arrow({ h, kind, from, to, behind }) {
        const thick = this.size * { cur: 0.3, next: 0.22, opp: 0.22,
                                    seen: 0.16, near: 0.1 }[kind];
        const dx = to.x - from.x, dy = to.y - from.y;
        const length = Math.hypot(dx, dy);
        const head = Math.min(2.2 * thick + 0.15 * this.size, 0.5 * length);
        const ux = head * dx / length, uy = head * dy / length;
        const wing = (s) => `${to.x - ux - s * 0.6 * uy} ` +
            `${to.y - uy + s * 0.6 * ux}`;
        const d = `M${from.x} ${from.y}L${to.x} ${to.y}` +
            `M${wing(1)}L${to.x} ${to.y}L${wing(-1)}`;
        const group = svg("g", { class: kind + (behind ? " behind" : "") },
                          this.element);
        group.onclick = () => this.on_pick(h);
        const path = (name, width) =>
            svg("path", { class: name, d, "stroke-width": width }, group);
        path("halo", 2.2 * thick);
        path("line", thick);
        path("grip", 3 * thick + 0.4 * this.size);
    }

    /** Keeps labels from lying on an arrow. */
    block({ from, to }) {
        const half = 0.2 * this.size;
        for (let s = 0; s <= 1; s += 0.125) {
            const x = from.x + s * (to.x - from.x);
            const y = from.y + s * (to.y - from.y);
            this.taken.push([x - half, y - half, x + half, y + half]);
        }
    }

    label_arrow({ h, kind, middle, beside }) {
        const dx = beside.x - middle.x, dy = beside.y - middle.y;
        const length = Math.hypot(dx, dy) || 1;
        this.place("H" + h, middle, [dx / length, dy / length], kind);
    }

    label_spot({ text, point, kind }) {
        this.place(text, this.camera.project(point), [0, 0], kind);
    }

    /** Puts a label where it lies on no other, or leaves it out. */
    place(text, { x, y }, [nx, ny], kind) {
        const size = 2.1 / 2.3 * this.size;
        const w = size * (0.35 + 0.72 * text.length), h = 1.25 * size;
        const far = Math.abs(nx) * w / 2 + Math.abs(ny) * h / 2;
        const places = [[nx * far, ny * far], [nx * 1.5 * far, ny * 1.5 * far]];
        if (kind !== "near" && kind !== "seen")
            for (const r of [1, 1.7, 2.6])
                for (let turn = 0; turn < 8; ++turn)
                    places.push([r * w * 0.7 * Math.cos(turn * Math.PI / 4),
                                 r * h * Math.sin(turn * Math.PI / 4)]);
        for (const [dx, dy] of places) {
            const box = [x + dx - w / 2, y + dy - h / 2,
                         x + dx + w / 2, y + dy + h / 2];
            if (this.is_free(box)) return this.draw_label(text, box, kind);
        }
    }

    is_free([x0, y0, x1, y1]) {
        return x0 >= 0 && y0 >= 0 && x1 <= this.camera.width &&
            y1 <= this.camera.height &&
            this.taken.every(([a, b, c, d]) =>
                x1 <= a || c <= x0 || y1 <= b || d <= y0);
    }

    draw_label(text, box, kind) {
        this.taken.push(box);
        const [x0, y0, x1, y1] = box;
        const group = svg("g", { class: "label " + kind }, this.element);
        svg("rect", { x: x0 + 1, y: y0 + 1, width: x1 - x0 - 2,
                      height: y1 - y0 - 2, rx: 0.2 * (y1 - y0) }, group);
        svg("text", { x: (x0 + x1) / 2, y: (y0 + y1) / 2 },
            group).textContent = text;
    }
}
