// Places for labels: boxes {x, y, w, h} about their centre, none over another.

function overlap(a, b, gap = 0) {
    return Math.abs(a.x - b.x) < (a.w + b.w) / 2 + gap &&
        Math.abs(a.y - b.y) < (a.h + b.h) / 2 + gap;
}

/** Whether the segment from (x1, y1) to (x2, y2) meets the box. */
function segment_meets({ x1, y1, x2, y2 }, box) {
    let [from, to] = [0, 1];
    for (const [start, end, centre, half] of [[x1, x2, box.x, box.w / 2],
                                              [y1, y2, box.y, box.h / 2]]) {
        const step = end - start;
        if (Math.abs(step) < 1e-9) {
            if (Math.abs(start - centre) >= half) return false;
            continue;
        }
        const [near, far] = [centre - half - start, centre + half - start]
            .map((d) => d / step).sort((a, b) => a - b);
        [from, to] = [Math.max(from, near), Math.min(to, far)];
    }
    return from < to;
}

/** Keeps track of what is taken in a picture of width by height. */
class Labels {
    constructor(width, height) {
        this.frame = { width, height };
        this.taken = [];
        this.lines = [];
    }

    take(box) {
        this.taken.push(box);
    }

    free(box) {
        const { width, height } = this.frame;
        return box.x - box.w / 2 >= 0 && box.x + box.w / 2 <= width &&
            box.y - box.h / 2 >= 0 && box.y + box.h / 2 <= height &&
            !this.taken.some((other) => overlap(box, other, 1));
    }

    /**
     * The best of the candidates (boxes with an own `cost`), which is taken;
     * null when none is free. A line under a label costs 2.
     */
    place(candidates) {
        let best = null;
        for (const box of candidates) {
            let cost = box.cost || 0;
            if ((best && cost >= best.total) || !this.free(box)) continue;
            for (const line of this.lines)
                if (segment_meets(line, box)) cost += 2;
            if (!best || cost < best.total) best = { ...box, total: cost };
        }
        if (best) this.take(best);
        return best;
    }
}

/** Candidates round `box` for a label of w by h that belongs to it. */
function around_box(box, w, h) {
    const places = [];
    for (const far of [0, 0.6, 1.3])
        for (const [dx, dy] of [[0, -1], [0, 1], [-1, 0], [1, 0],
                                [-1, -0.5], [-1, 0.5], [1, -0.5], [1, 0.5],
                                [-1, -1], [1, -1], [-1, 1], [1, 1]])
            places.push({
                x: box.x + dx * ((box.w + w) / 2 + 2 + far * h),
                y: box.y + dy * ((box.h + h) / 2 + 2 + far * h),
                w, h, cost: far * 3 + (dx && dy ? 1 : 0) });
    return places;
}
