// The sense of F0 is passed on over the edges; on the Möbius strip it comes
// back the wrong way round.

/** Which faces have a sense after the first `count` steps, and which: 1 as
    the list has them, -1 turned. */
function senses_after(steps, count) {
    const senses = new Map([[0, 1]]);
    for (const { neighbour, alike, first } of steps.slice(0, count))
        if (first) senses.set(neighbour, alike ? -1 : 1);
    return senses;
}

const fails = (strip) =>
    strip.steps.some(({ alike, first }) => alike && !first);

/** The last step, when nothing is left to compare. */
function strip_result(strip) {
    if (fails(strip))
        return "This strip cannot be oriented: it has one side only";
    const turned = [...senses_after(strip.steps, strip.steps.length)]
        .filter(([, sense]) => sense < 0).map(([f]) => "F" + f);
    return "All neighbours agree: it can be oriented, " +
        (turned.length ? `with ${listed(turned)} turned` : "as it is");
}

/** Two half steps for each edge: compare, then what follows from it. */
function strip_sentence(strip, k) {
    if (k === 0) return "F0 keeps its sense. Its neighbours have to agree " +
        "with it";
    const step = strip.steps[Math.floor((k - 1) / 2)];
    if (!step) return strip_result(strip);
    const { edge: [a, b], face, neighbour, alike, first } = step;
    if (k % 2)
        return `F${face} runs ${side_name(a, b)}, F${neighbour} runs ` +
            (alike ? side_name(a, b) + " too" : side_name(b, a));
    if (!alike) return `Opposite directions: F${face} and F${neighbour} agree`;
    if (first) return `The same direction: so F${neighbour} is turned`;
    return `The same direction, and both have their sense already: ` +
        "it fails here";
}

/** The arrows of all faces; the compared ones have a role of their own. */
function strip_state(strip, k) {
    const step = strip.steps[Math.floor((k - 1) / 2)];
    const senses = senses_after(strip.steps, Math.floor(k / 2));
    const arrows = {};
    strip.faces.forEach((face, f) => {
        arrows[f] = { sense: senses.get(f) || 1, roles: {} };
    });
    if (k > 0 && step) {
        const name = edge_name(step.edge);
        arrows[step.face].roles[name] = "one";
        arrows[step.neighbour].roles[name] = "other";
    }
    return { arrows, faces: [...senses.keys()],
             vertices: k > 0 && step ? step.edge : [] };
}

function strip_case(strip) {
    return {
        name: strip.name,
        count: 2 * strip.steps.length + 2,
        make(place) {
            const links = strip.steps.filter(({ first }) => first);
            const picture = net_pane(place, strip, 1, links);
            return (k) => {
                picture.show(strip_state(strip, k));
                return strip_sentence(strip, k);
            };
        },
    };
}

show_cases(page_data.strips.map(strip_case));
