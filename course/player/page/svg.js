// Making elements of SVG and HTML.

/** A new SVG element with attributes, appended to `parent`. */
function svg(tag, attributes = {}, parent = null) {
    const element = document.createElementNS(
        "http://www.w3.org/2000/svg", tag);
    for (const name in attributes) element.setAttribute(name, attributes[name]);
    if (parent) parent.append(element);
    return element;
}

/** Empties an SVG, which is measured in pixels from now on; its size, or
    nothing while it is not shown. */
function emptied_frame(place) {
    place.textContent = "";
    const { width, height } = place.getBoundingClientRect();
    if (!width || !height) return null;
    place.setAttribute("viewBox", `0 0 ${width} ${height}`);
    return { width, height };
}

/** A new HTML element with attributes and children (nodes or text). */
function html(tag, attributes = {}, ...children) {
    const element = document.createElement(tag);
    for (const name in attributes) element.setAttribute(name, attributes[name]);
    element.append(...children);
    return element;
}
