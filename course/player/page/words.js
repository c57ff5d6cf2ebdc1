// The large sentence of a step, and the variables, on the page: in the elements
// #main and #more of #say, and in #variables.

const at_id = (id) => document.getElementById(id);

// Of the sentence and of what it means, in --u's: the first that fit.
const say_sizes = [[3.6, 2.6], [3.6, 1.9], [2.9, 1.9], [2.5, 1.9], [2.2, 1.9],
                   [1.9, 1.9], [1.7, 1.7]];

/** {main, more} of say_state. */
function show_words({ main, more }) {
    at_id("main").textContent = main;
    at_id("more").textContent = more;
    const box = at_id("say");
    for (const [large, small] of say_sizes) {
        at_id("main").style.fontSize = `calc(${large} * var(--u))`;
        at_id("more").style.fontSize = `calc(${small} * var(--u))`;
        if (box.scrollHeight <= box.clientHeight) break;
    }
}

/** Those of a state, which is number k and shows the step. */
function show_variables({ variables }, step, k) {
    const hidden = new Set();
    for (const { name, line } of variables.values())
        if (line) hidden.add(name);
    const chips = [...variables.values()].map((variable) => {
        const { name, value, line } = variable;
        const which = line ? "inner " : hidden.has(name) ? "outer " : "";
        const fresh = variable.step === step && k > 0;
        return html("span", { class: fresh ? "chip fresh" : "chip" },
                    `${which}${name} = `, html("b", {}, value_text(value)));
    });
    at_id("variables").replaceChildren(...chips);
}
