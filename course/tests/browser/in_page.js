// What page_checks.mjs asks of a page, run inside of it: what is seen of its
// texts, their sizes, places and colours. Changes nothing that is seen.
"use strict";

const checks = globalThis.checks = {};

/** Whether an element, and all that it is in, is drawn. */
checks.is_shown = (element) => {
    for (let e = element; e; e = e.parentElement) {
        const style = getComputedStyle(e);
        if (style.display === "none" || Number(style.opacity) === 0)
            return false;
    }
    return getComputedStyle(element).visibility === "visible";
};

/** The part of a box that the window and scrolled places around it show. */
checks.visible_part = (box, element) => {
    let { left, top, right, bottom } = box;
    const cut = (by) => {
        left = Math.max(left, by.left);
        top = Math.max(top, by.top);
        right = Math.min(right, by.right);
        bottom = Math.min(bottom, by.bottom);
    };
    cut({ left: 0, top: 0, right: innerWidth, bottom: innerHeight });
    for (let e = element; e && e !== document.body; e = e.parentElement)
        if (getComputedStyle(e).overflow !== "visible")
            cut(e.getBoundingClientRect());
    return { left, top, right, bottom,
             width: right - left, height: bottom - top };
};

/** Factor from the units in which an element counts to pixels. */
checks.scale_of = (element) => {
    const matrix = element.getScreenCTM && element.getScreenCTM();
    if (matrix) return Math.hypot(matrix.b, matrix.a);
    const box = element.getBoundingClientRect();
    return element.offsetWidth ? box.width / element.offsetWidth : 1;
};

/** The boxes of the lines of a text node. */
checks.boxes_of = (node) => {
    const range = document.createRange();
    range.selectNodeContents(node);
    return [...range.getClientRects()];
};

/** All texts that are seen: {text, element, size, box, whole} for each line of
    each, with the part of its box that is seen, and all of it; with a dialog
    that is open, those in the dialog. */
checks.texts = () => {
    const root = document.querySelector("dialog[open]") || document.body;
    const walker = document.createTreeWalker(root, NodeFilter.SHOW_TEXT);
    const found = [];
    while (walker.nextNode()) {
        const node = walker.currentNode;
        const element = node.parentElement;
        const text = node.data.trim();
        if (!text || element.closest("script, style, title, option, desc") ||
            !checks.is_shown(element))
            continue;
        const style = getComputedStyle(element);
        const size = parseFloat(style.fontSize) * checks.scale_of(element);
        for (const whole of checks.boxes_of(node)) {
            const box = checks.visible_part(whole, element);
            // A line that is half scrolled away is on its way.
            if (box.width < 1 || box.height < whole.height / 2) continue;
            found.push({ text, element, size, box, whole });
        }
    }
    return found;
};

/** Texts smaller than that many pixels. */
checks.small_texts = (least) => checks.texts()
    .filter(({ size }) => size < least - 0.01)
    .map(({ text, size, element }) =>
        `"${text}" is ${size.toFixed(1)} px high, expected ` +
        `at least ${least.toFixed(1)}: ${element.outerHTML.slice(0, 80)}`);

/** The box of a text's letters: without the room above and below them. */
checks.letters = ({ box, size }) => {
    const middle = (box.top + box.bottom) / 2;
    return { left: box.left, right: box.right,
             top: Math.max(box.top, middle - 0.4 * size),
             bottom: Math.min(box.bottom, middle + 0.4 * size) };
};

/** What belongs to a text of a drawing: its letters, and the shape in the same
    group that is its background. */
checks.label_box = (found) => {
    const box = checks.letters(found);
    const group = found.element.closest("g");
    if (!group || !found.element.closest("svg")) return box;
    const middle = [(box.left + box.right) / 2, (box.top + box.bottom) / 2];
    for (const shape of group.querySelectorAll(
        ":scope > rect, :scope > circle, :scope > ellipse")) {
        const around = shape.getBoundingClientRect();
        const holds = around.left <= middle[0] && middle[0] <= around.right &&
            around.top <= middle[1] && middle[1] <= around.bottom;
        const is_label = around.width < 6 * found.size + found.box.width;
        if (holds && is_label && checks.is_shown(shape)) return around;
    }
    return box;
};

/** Whether an element is in a place that can be scrolled. */
checks.can_scroll = (element) => {
    for (let e = element; e; e = e.parentElement)
        if (/auto|scroll/.test(getComputedStyle(e).overflow) &&
            (e.scrollHeight > e.clientHeight || e.scrollWidth > e.clientWidth))
            return true;
    return false;
};

/** Texts of which the window, or what they are in, cuts off more than the blank
    after a line that is wrapped. */
checks.cut_texts = () => checks.texts()
    .filter(({ element, size, box, whole }) => !checks.can_scroll(element) &&
        (box.width < whole.width - 0.4 * size ||
         box.height < 0.8 * whole.height))
    .map(({ text, box, whole }) =>
        `"${text}" is cut off: of ${whole.width.toFixed(0)} x ` +
        `${whole.height.toFixed(0)} px ${box.width.toFixed(0)} x ` +
        `${box.height.toFixed(0)} are seen`);

/** Pairs of labels that lie over one another by more than a pixel. */
checks.overlaps = () => {
    const labels = checks.texts().map((found) => ({
        ...found, label: checks.label_box(found) }));
    labels.sort((a, b) => a.label.left - b.label.left);
    const found = [];
    for (let j = 0; j < labels.length; ++j)
        for (let i = j - 1; i >= 0; --i) {
            const a = labels[i];
            const b = labels[j];
            const wide = Math.min(a.label.right, b.label.right) -
                Math.max(a.label.left, b.label.left);
            const high = Math.min(a.label.bottom, b.label.bottom) -
                Math.max(a.label.top, b.label.top);
            if (wide > 1 && high > 1 && a.element !== b.element)
                found.push(`"${a.text}" and "${b.text}" lie over one ` +
                           `another, ${wide.toFixed(0)} x ` +
                           `${high.toFixed(0)} px`);
        }
    return found;
};

/** [red, green, blue, opacity] of a computed colour; null for none. */
checks.colour = (text) => {
    const numbers = text.match(/[\d.]+/g);
    if (!numbers || !text.startsWith("rgb")) return null;
    const [r, g, b, a = 1] = numbers.map(Number);
    return [r, g, b, a];
};

/** What a shape or box paints at a point; null when nothing. */
checks.paint_at = (element, x, y) => {
    const style = getComputedStyle(element);
    if (!(element instanceof SVGGeometryElement))
        return element instanceof SVGElement
            ? null : checks.colour(style.backgroundColor);
    const place = new DOMPoint(x, y)
        .matrixTransform(element.getScreenCTM().inverse());
    if (!element.isPointInFill(place)) return null;
    const colour = checks.colour(style.fill);
    if (colour) colour[3] *= Number(style.fillOpacity);
    return colour;
};

/** One colour painted over another that is opaque. */
checks.over = ([r, g, b, a], below) =>
    [r, g, b].map((value, k) => a * value + (1 - a) * below[k]);

/** The colour behind an element at a point. */
checks.background_at = (element, x, y) => {
    const stack = document.elementsFromPoint(x, y);
    const own = stack.indexOf(element);
    const layers = [];
    for (const below of stack.slice(Math.max(own, 0))) {
        if (below === element && below instanceof SVGElement) continue;
        const paint = checks.paint_at(below, x, y);
        if (!paint) continue;
        paint[3] *= checks.opacity_of(below);
        layers.push(paint);
        if (paint[3] === 1) break;
    }
    return layers.reduceRight((below, paint) => checks.over(paint, below),
                              [255, 255, 255]);
};

checks.opacity_of = (element) => {
    let opacity = 1;
    for (let e = element; e; e = e.parentElement)
        opacity *= Number(getComputedStyle(e).opacity);
    return opacity;
};

/** Relative luminance (WCAG 2) of a colour. */
checks.luminance = (colour) => {
    const [r, g, b] = colour.map((value) => {
        const part = value / 255;
        return part <= 0.04045 ? part / 12.92
                               : ((part + 0.055) / 1.055) ** 2.4;
    });
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
};

/** Contrast (WCAG 2) of a text with what is behind it, where it is least. */
checks.contrast = ({ element, box }) => {
    const style = getComputedStyle(element);
    const ink = checks.colour(element instanceof SVGElement ? style.fill
                                                            : style.color);
    if (!ink) return 21;
    ink[3] *= checks.opacity_of(element);
    const halo = element instanceof SVGElement &&
        style.paintOrder.startsWith("stroke") && checks.colour(style.stroke);
    const y = (box.top + box.bottom) / 2;
    return Math.min(...[0.1, 0.5, 0.9].map((part) => {
        const x = box.left + part * (box.right - box.left);
        const below = halo ? halo.slice(0, 3)
                           : checks.background_at(element, x, y);
        const [dark, light] = [checks.over(ink, below), below]
            .map(checks.luminance).sort((a, b) => a - b);
        return (light + 0.05) / (dark + 0.05);
    }));
};

/** Texts with less contrast than that. */
checks.faint_texts = (least) => {
    // What lets the mouse through must be seen by elementsFromPoint, too.
    const style = document.createElement("style");
    style.textContent = "* { pointer-events: auto !important; }";
    document.head.append(style);
    const found = checks.texts().map((text) => ({
        text: text.text, contrast: checks.contrast(text) }));
    style.remove();
    return found.filter(({ contrast }) => contrast < least - 0.005)
        .map(({ text, contrast }) =>
            `"${text}" has contrast ${contrast.toFixed(2)}, expected ` +
            `at least ${least}`);
};

/** How far the page is wider than the window, or higher, when it steps through
    something: nobody scrolls on a projector. */
checks.overflow = () => {
    const { scrollWidth, scrollHeight } = document.documentElement;
    const sticks_out = (e) =>
        e.getBoundingClientRect().right > innerWidth + 0.5 ||
        e.getBoundingClientRect().bottom > innerHeight + 0.5;
    const name = [...document.body.querySelectorAll("*")].filter(sticks_out)
        .at(-1)?.outerHTML.slice(0, 80) ?? "";
    const found = [];
    if (scrollWidth > innerWidth)
        found.push(`the page is ${scrollWidth - innerWidth} px wider than ` +
                   `the window: ${name}`);
    if (scrollHeight > innerHeight && document.querySelector(".transport"))
        found.push(`the page is ${scrollHeight - innerHeight} px higher than ` +
                   `the window: ${name}`);
    return found;
};

/** All that is seen, as text: elements, and what stands in controls. */
checks.picture = () => {
    const controls = document.querySelectorAll("input, select");
    const values = [...controls].map((control) =>
        control.type === "checkbox" ? control.checked : control.value);
    return document.documentElement.dataset.theme + values.join(" ") +
        document.body.outerHTML.replace(/<script[^]*?<\/script>/g, "");
};

/** Presses a key as a user would, but at once. */
checks.press = (key) => document.body.dispatchEvent(
    new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true }));

/** The first place where two texts differ, with what is around it. */
checks.difference = (a, b) => {
    let k = 0;
    while (k < a.length && a[k] === b[k]) ++k;
    const from = Math.max(0, k - 60);
    return `${a.slice(from, k + 60)}\n    is later\n    ` +
        b.slice(from, k + 60);
};

/** {k, n}: step k of n, both from 1, as the transport bar says. */
checks.place = () => {
    const output = document.querySelector(".transport output");
    const [k, n] = output.textContent.match(/\d+/g).map(Number);
    return { k, n };
};

/** Chooses from a list as a user would. */
checks.choose = (select, value) => {
    if (select.value === value) return;
    select.value = value;
    select.dispatchEvent(new Event("change", { bubbles: true }));
};

/** Of a list's entries at most `most`, spread over it, with the first. */
checks.some_of = (entries, most) => {
    const stride = Math.max(1, Math.ceil(entries.length / most));
    return entries.filter((_, k) => k % stride === 0);
};

/** What a page lets choose from: lists, and groups of buttons of which one is
    pressed; each as entries {text, choose}. */
checks.choices = () => {
    const lists = [...document.querySelectorAll("select")]
        .filter(checks.is_shown)
        .map((list) => [...list.options].map(({ text, value }) => ({
            text, choose: () => checks.choose(list, value) })));
    const groups = [...document.querySelectorAll("[role=group]")]
        .filter(checks.is_shown)
        .map((group) => [...group.querySelectorAll("button[aria-pressed]")]
            .map((button) => ({ text: button.textContent,
                                choose: () => button.click() })));
    return [...lists, ...groups].filter((entries) => entries.length > 0);
};

/** Runs `visit` with all that can be chosen together, at most `most` of each
    list, and puts what was chosen before what it finds. A later list is chosen
    from first: it may decide what the earlier ones hold. */
checks.with_choices = (visit, most) => {
    const found = [];
    const descend = (n, chosen) => {
        if (n < 0) {
            found.push(...visit().map((what) => chosen + what));
            return;
        }
        for (const { text, choose } of checks.some_of(checks.choices()[n],
                                                      most)) {
            choose();
            descend(n - 1, `${text}, ${chosen}`);
        }
    };
    descend(checks.choices().length - 1, "");
    return found;
};

/** What checks (names, and what they are given) find at the steps of what is
    shown: at most `most` of them, the first and the last always. */
checks.at_steps = (named, most) => {
    checks.press("Home");
    const { n } = checks.place();
    const stride = Math.max(1, Math.ceil((n - 1) / Math.max(1, most - 1)));
    const found = [];
    for (let k = 0; k < n; ++k) {
        if (k % stride === 0 || k === n - 1)
            for (const [name, given] of named)
                found.push(...checks[name](given).map((what) =>
                    `step ${k + 1}: ${what}`));
        checks.press("ArrowRight");
    }
    return found;
};

/** Goes through all steps and back; the steps that are another picture then. */
checks.forward_back = () => {
    checks.press("Home");
    const { n } = checks.place();
    const pictures = [checks.picture()];
    for (let k = 1; k < n; ++k) {
        checks.press("ArrowRight");
        pictures.push(checks.picture());
    }
    const found = [];
    for (let k = n - 1; k >= 0; --k) {
        const now = checks.picture();
        if (now !== pictures[k])
            found.push(`step ${k + 1} of ${n}: ` +
                       checks.difference(pictures[k], now));
        checks.press("ArrowLeft");
    }
    if (n > 1 && pictures[0] === pictures[n - 1])
        found.push(`the first and the last of ${n} steps are the same`);
    return found;
};

/** What a user can act on, that is seen. */
checks.controls = () => [...document.querySelectorAll(
    "button, select, input, textarea, a[href], summary, [tabindex]")]
    .filter((e) => e.tabIndex >= 0 && !e.disabled && checks.is_shown(e) &&
        !(e.closest("dialog") && !e.closest("dialog").open));

/** A short name of an element for messages. */
checks.name = (element) => element === document.body ? "body"
    : `<${element.localName}> ` + (element.getAttribute("aria-label") ||
          element.id || element.textContent.trim().slice(0, 30));

/** What asks to be clicked and has no part in the order of the tab key, but for
    what the selector names. */
checks.only_for_the_mouse = (other_way) => {
    const points = (e) => getComputedStyle(e).cursor === "pointer";
    return [...document.body.querySelectorAll("*")]
        .filter((e) => points(e) && !points(e.parentElement) &&
            checks.is_shown(e) && e.tabIndex < 0 && !e.disabled &&
            !e.matches(other_way))
        .map(checks.name);
};
