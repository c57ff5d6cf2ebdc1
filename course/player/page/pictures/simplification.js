// A mesh simplified by clustering, beside the same number of triangles by edge
// collapse: cubes of growing size, first what falls into one, then the result.

const { mesh, ways } = page_data;
const diagonal = vector.length(vector.minus(
    ...[Math.max, Math.min].map((pick) => mesh.points.reduce(
        (most, p) => p.map((x, k) => pick(x, most[k]))))));

function error_of(simpler) {
    const part = simpler.error / diagonal;
    return percent(part, part < 1e-9 ? 0 : 1);
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
    return `${clustered.mesh.faces.length} triangles each. Clustering is off ` +
        `by ${error_of(clustered)}, collapse by ${error_of(collapsed)}.`;
}

function steps_of(way) {
    const cubes = cubes_of(way.cell), bad = way.clustered.bad_edges;
    const steps = [
        { way, cubes, say: `Cubes of ${way.cell}: ${mesh.points.length} ` +
              `vertices lie in ${cubes.length}. Those in one become one.` },
        { way, result: true, say: say_of_result(way) },
    ];
    if (bad.length)
        steps.push({ way, result: true, say: "Top and bottom have fallen " +
            `together: at ${count_of(bad.length, "edge")} meet four faces.` });
    return steps;
}

const steps = [
    { say: `${count_of(mesh.faces.length, "triangle")}, most of them where it ` +
          "is flat. How few will do?" },
    ...ways.flatMap(steps_of),
    { way: ways.at(-1), result: true,
      say: "Clustering treats all places alike. Collapse takes the cheapest " +
          "edge first and stays closed." },
];

/** The vertices that edge collapse is going to leave. */
function parts_of_left({ mesh: { points, faces } }) {
    const dots = [...new Set(faces.flat())].map(
        (v) => ({ at: points[v], is: "cell", size: 0.3, lift: 0.15 }));
    return { dots };
}

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
        faces: closed_facets(simpler.mesh),
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
        const before = { faces: closed_facets(mesh) };
        left.solid.show(result ? parts_of(way.clustered)
            : { ...before, ...(cubes ? parts_of_cubes(cubes) : {}) });
        right.solid.show(result ? parts_of(way.collapsed)
            : { ...before, ...(way ? parts_of_left(way.collapsed) : {}) });
        for (const [{ note }, name, before] of [
            [left, "clustered", "one vertex for each cube"],
            [right, "collapsed", "vertices that will stay"]])
            note.textContent = result ? note_of(way[name])
                : way ? before : count_of(mesh.faces.length, "triangle");
        return say;
    };
}

function note_of(simpler) {
    const bad = simpler.bad_edges.length;
    return `error ${error_of(simpler)} of the size, ` +
        (bad ? count_of(bad, "bad edge") : "closed");
}

show_cases([{ name: "simplification", count: steps.length, make }],
           view.keys());
