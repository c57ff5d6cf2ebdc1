// A mesh simplified by clustering, beside the same number of triangles by edge
// collapse: cubes of growing size, first what falls into one, then the result.

const { mesh, ways } = page_data;
const diagonal = vector.length(vector.minus(
    ...[Math.max, Math.min].map((pick) => mesh.points.reduce(
        (most, p) => p.map((x, k) => pick(x, most[k]))))));

function error_of(simpler) {
    return percent(simpler.error / diagonal, 1);
}

/** The vertices by the cube that they lie in, as cluster has it. */
function cubes_of(cell) {
    const cubes = new Map();
    mesh.points.forEach((p) => {
        const key = p.map((x) => Math.floor(x / cell)).join(" ");
        cubes.set(key, [...(cubes.get(key) || []), p]);
    });
    return [...cubes.values()];
}

function say_of_result({ clustered, collapsed }) {
    const n = clustered.mesh.faces.length;
    const bad = clustered.bad_edges.length;
    const pinched = bad
        ? ` Clustering: ${count_of(bad, "edge")} with too many faces.` : "";
    return `${n} triangles each. Error: clustering ${error_of(clustered)}, ` +
        `collapse ${error_of(collapsed)}.${pinched}`;
}

const steps = [
    { say: `${count_of(mesh.faces.length, "triangle")}. How few will do?` },
    ...ways.flatMap((way) => [
        { way, cubes: cubes_of(way.cell),
          say: `Cubes of ${way.cell}: the ${mesh.points.length} vertices lie ` +
              `in ${cubes_of(way.cell).length}. Those in one become one.` },
        { way, result: true, say: say_of_result(way) },
    ]),
    { way: ways.at(-1), result: true,
      say: "Clustering treats all places alike. Collapse takes what costs " +
          "least first, and keeps the mesh closed." },
];

/** Each vertex is pulled to the mean of its cube. */
function parts_of_cubes(cubes) {
    const lines = [], dots = [];
    for (const points of cubes) {
        const middle = vector.mean(points);
        dots.push({ at: middle, is: "cell", size: 0.3, lift: 0.15 });
        if (points.length > 1)
            for (const p of points)
                lines.push({ at: [p, middle], is: "cell", lift: 0.1 });
    }
    return { lines, dots };
}

function parts_of(simpler) {
    const { points } = simpler.mesh;
    return {
        faces: facets(simpler.mesh),
        lines: simpler.bad_edges.map(([from, to]) => ({
            at: [points[from], points[to]], is: "opp", lift: 0.3 })),
    };
}

const view = new View(28, 30);

function make(place) {
    const frame = frame_of(mesh.points);
    const left = add_solid(place, view, "clustering", frame);
    const right = add_solid(place, view, "edge collapse", frame);
    return (k) => {
        const { way, cubes, result, say } = steps[k];
        const before = { faces: facets(mesh) };
        left.solid.show(result ? parts_of(way.clustered)
            : { ...before, ...parts_of_cubes(cubes || []) });
        right.solid.show(result ? parts_of(way.collapsed) : before);
        for (const [{ note }, name] of [[left, "clustered"],
                                        [right, "collapsed"]])
            note.textContent = result
                ? note_of(way[name]) : count_of(mesh.faces.length, "triangle");
        return say;
    };
}

function note_of(simpler) {
    const bad = simpler.bad_edges.length;
    return `${count_of(simpler.mesh.faces.length, "triangle")}, ` +
        `error ${error_of(simpler)}, ` +
        (bad ? `${count_of(bad, "bad edge")}` : "closed");
}

show_cases([{ name: "simplification", count: steps.length, make }],
           view.keys());
