// Live mode: shows the newest page in a frame, at the step where the one before
// stood, and says what is wrong with the file in the meantime.

const say = document.getElementById("say");
const pages = document.getElementById("pages");
let shown = "0";

/** Where and how the page in the frame stands: its link and its theme. */
function state_of(frame) {
    if (!frame) return { link: location.hash, theme: null };
    return { link: frame.contentWindow.location.hash,
             theme: frame.contentDocument.documentElement.dataset.theme };
}

/** Puts the new page in the place of the old one when it is ready, so that
    nothing flickers. */
function load_page(number) {
    shown = number;
    for (const late of pages.querySelectorAll(".coming")) late.remove();
    const old = pages.querySelector("iframe");
    const { link, theme } = state_of(old);
    const coming = html("iframe", { class: "coming", title: "the walk" });
    // The number only keeps it from being taken for the same page.
    coming.src = `page?${number}${link}`;
    coming.onload = () => {
        if (theme) coming.contentDocument.documentElement.dataset.theme = theme;
        if (old) old.remove();
        coming.className = "";
        coming.contentWindow.focus();
    };
    pages.append(coming);
}

/** Waits for what the server has to tell; answers with its version. */
async function listen(known) {
    const news = await fetch(`news?after=${known}`);
    if (!news.ok) throw new Error(`status ${news.status}`);
    const { theme } = state_of(pages.querySelector("iframe:not(.coming)"));
    if (theme) set_theme(theme);
    say.textContent = await news.text();
    const page = news.headers.get("Page");
    if (page !== shown) load_page(page);
    return news.headers.get("Version");
}

async function listen_for_ever() {
    let known = "";
    while (true) {
        try {
            known = await listen(known);
        } catch {
            say.textContent = "Live mode has ended: start it again with " +
                "./course/lab demo --live, and open its new address.";
            await new Promise((wake) => setTimeout(wake, 2000));
        }
    }
}

listen_for_ever();
