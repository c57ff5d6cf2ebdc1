// Two walks from the same start in lock step: access by access, whatever the
// lines between them are.

class Comparison {
    constructor(...walks) {
        this.walks = walks;
        // The states that count: the call, each access, the end.
        this.places = walks.map((walk) => [
            0, ...walk.steps.flatMap((step, k) =>
                step.i === undefined ? [] : [k + 1]), walk.count - 1]);
        this.count = Math.max(...this.places.map((p) => p.length));
        this.parting = this.find_parting();
    }

    /** The state of walk n at common step k. */
    place(n, k) {
        const places = this.places[n];
        return places[Math.min(k, places.length - 1)];
    }

    /** What the walk does at its state, to be compared. */
    deed(n, k) {
        const walk = this.walks[n];
        const state = this.place(n, k);
        if (state === 0) return "call";
        if (walk.is_last(state))
            return walk.error ? "stops" :
                `returns ${value_text(walk.result)}`;
        const step = walk.step(state);
        if (step.new) return `adds row ${step.new}`;
        const write = step.w !== undefined;
        return `${write ? "writes" : "reads"} ` +
            `${access_text(walk, step).replace(/^\w+/, "he")}` +
            (write ? ` = ${step.v}` : "");
    }

    /** The first common step where they differ; -1 if there is none. */
    find_parting() {
        for (let k = 0; k < this.count; ++k)
            if (this.deed(0, k) !== this.deed(1, k)) return k;
        return -1;
    }

    label(n) {
        const { recording, source } = this.walks[n];
        return recording.sources[source].label;
    }

    /** Above walk n. Why it is stopped is a matter of the large sentence. */
    heading(n, k, state) {
        const walk = this.walks[n];
        const own = this.place(n, k);
        const is_stopped = walk.is_last(own) && walk.error;
        return `${this.label(n)}: ` +
            (is_stopped ? "is stopped" : say_state(walk, own, state).main);
    }

    say(k) {
        if (this.parting < 0 || k < this.parting) return "The same so far";
        const [a, b] = [0, 1].map((n) =>
            this.label(n).replace(/^ref/, "the ref"));
        const after = k - this.parting;
        if (k === this.count - 1 && this.walks[1].error)
            return `${b}: ${this.walks[1].error}`;
        return after ? `They parted ${after} step${after > 1 ? "s" : ""} ago`
            : `They part here: ${b} ${this.deed(1, k)}, ` +
              `${a} ${this.deed(0, k)}`;
    }
}
