// The half-edge table as a table of the page, with a row and a cell lit.

const field_names = ["vi", "fi", "next", "opp"];

/** Scrolls `box` alone so that `element` stands in its middle. */
function scroll_to_middle(box, element) {
    const [outer, inner] = [box, element].map((e) => e.getBoundingClientRect());
    box.scrollTop += inner.top + inner.height / 2 -
        outer.top - outer.height / 2;
}

class TablePicture {
    /** box: a block element, which gets the table and scrolls by itself. */
    constructor(box) {
        this.box = box;
        this.on_pick = null;
        box.classList.add("table-picture");
        this.body = html("tbody");
        const heads = ["", ...field_names].map((name) => html("th", {}, name));
        const head = html("thead", {}, html("tr", {}, ...heads));
        box.append(html("table", {}, head, this.body));
        this.body.addEventListener("click", (event) => {
            const row = event.target.closest("tr");
            if (row && this.on_pick) this.on_pick(Number(row.dataset.row));
        });
    }

    /**
     * Shows the state of a MeshPicture, whose table may lack rows, and, in it,
     *   field     0 to 3: the cell of row `current` that is lit
     *   value     what this cell shows ("?" for a question)
     *   old       the value before, of a write
     *   changed   set of "row,field": cells that were written before
     *   new_rows  set of rows that were added
     */
    show(state) {
        this.body.textContent = "";
        state.table.forEach((row, h) => this.body.append(
            this.row(row, h, state)));
        const lit = this.body.querySelector(
            `[data-row="${state.current ?? state.start ?? 0}"]`);
        if (lit) scroll_to_middle(this.box, lit);
    }

    row(cells, h, state) {
        const flags = (state.flags[h] || []).map((name) =>
            html("b", { class: "flag" }, name));
        const head = html("th", { scope: "row" },
                          html("div", {}, ...flags, "H" + h));
        return html("tr", { class: this.classes(h, state), "data-row": h },
                    head, ...cells.map((value, f) =>
                        this.cell(value, h, f, state)));
    }

    classes(h, { table, current, next, opp, seen, new_rows,
                 half_edges = [] }) {
        const roles = new_rows.has(h) ? ["new"] : [];
        if (h > 0 && !table[h - 1]) roles.push("gap");
        if (seen.includes(h)) roles.push("seen");
        if (half_edges.includes(h)) roles.push("lit");
        if (h === next) roles.push("next");
        if (h === opp) roles.push("opp");
        if (h === current) roles.push("current");
        return roles.join(" ");
    }

    cell(value, h, f, { current, field, value: shown, old, changed }) {
        if (h !== current || f !== field)
            return html("td", changed.has(h + "," + f)
                ? { class: "changed" } : {}, String(value));
        const cell = html("td", { class: "cell" });
        if (old !== undefined)
            cell.append(html("s", {}, String(old)), html("br"));
        cell.append(String(shown ?? value));
        return cell;
    }
}
