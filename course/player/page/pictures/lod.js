// Levels of detail: which one is shown at which distance. A step is a distance.

const { points, levels } = page_data;
const finest = levels[0].faces.length;
const sum = levels.reduce((n, { faces }) => n + faces.length, 0);

/** The coarsest level that is good enough. */
function level_at(distance) {
    return levels.findLastIndex(({ from }) => from <= distance);
}

function say_at(distance) {
    const l = level_at(distance);
    if (l !== level_at(distance - 0.1))
        return `Level ${l} has edges ${levels[l].from.toFixed(2)} times as ` +
            "long. Seen from here they are no longer than at first.";
    return `Distance ${distance.toFixed(1)}: level ${l} will do, ` +
        `${levels[l].faces.length} of ${finest} triangles.`;
}

const farthest = Math.ceil(levels.at(-1).from + 1);
const steps = [
    { distance: 1, say: `${finest} triangles at distance 1. Walk away.` },
];
for (let tenths = 11; tenths <= 10 * farthest; ++tenths)
    steps.push({ distance: tenths / 10, say: say_at(tenths / 10) });
steps.push({ distance: farthest, all: true,
             say: `All levels: ${sum} triangles, less than twice the finest ` +
                 "one's: 1 + 1/2 + 1/4 + ..." });

const view = new View(20, 18);

/** A bar for each level, as long as it has triangles. */
function draw_levels(panel, { distance, all }) {
    const now = level_at(distance);
    panel.replaceChildren(...levels.map(({ faces, from }, l) => html("div", {
        class: `level ${all || l === now ? "now" : ""}` },
        html("span", {}, `${l}: from ${from.toFixed(1)}`),
        html("span", { class: "level-bar",
                       style: `width: ${30 * faces.length / finest}%` }),
        html("b", {}, String(faces.length)))));
}

function make(place) {
    const frame = frame_of(points);
    const far = add_solid(place, view, "seen from there", frame);
    const near = add_solid(place, view, "the same, enlarged", frame);
    const panel = html("div", { class: "pane narrow beside levels" });
    place.append(panel);
    return (k) => {
        const { distance, say } = steps[k];
        const level = level_at(distance);
        const { faces } = levels[level];
        far.solid.zoom = 1 / distance;
        for (const { solid } of [far, near])
            solid.show({ faces: closed_facets({ points, faces }) });
        far.note.textContent = `distance ${distance.toFixed(1)}`;
        near.note.textContent =
            `level ${level}: ${count_of(faces.length, "triangle")}`;
        draw_levels(panel, steps[k]);
        return say;
    };
}

show_cases([{ name: "levels", count: steps.length, make }], view.keys());
