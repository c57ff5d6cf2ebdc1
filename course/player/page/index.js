// The list of all pages of the set, by chapter.

document.getElementById("title").textContent = document.title;
for (const { title, pages } of page_data) {
    const links = pages.map((page) => html("li",
        page.is_picture ? { class: "picture" } : {},
        html("a", { href: page.file }, page.title)));
    document.getElementById("chapters").append(
        html("section", {}, html("h2", {}, title), html("ul", {}, ...links)));
}
