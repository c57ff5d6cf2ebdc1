#include "course/player/page.h"

#include "course/report/escape.h"
#include "course/runner/exercises.h"

namespace course {

namespace {

std::string part(const std::string& name) {
    return read_file(source_root() / "course" / "player" / "page" / name);
}

/// JSON that cannot end the element that it stands in.
std::string inside_script(const std::string& json) {
    std::string text;
    for (const char c : json) {
        if (c == '<')
            text += "\\u003c";
        else
            text += c;
    }
    return text;
}

}  // namespace

std::string make_page(const PageParts& parts) {
    // Nothing but what is in the file may be asked for.
    std::string page =
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">"
        "\n<meta name=\"viewport\" content=\"width=device-width, "
        "initial-scale=1\">\n<meta http-equiv=\"Content-Security-Policy\" "
        "content=\"default-src 'none'; style-src 'unsafe-inline'; script-src "
        "'unsafe-inline'; img-src data:; " +
        parts.policy + "\">\n<link rel=\"icon\" href=\"data:,\">\n<title>" +
        escape_html(parts.title) + "</title>\n<style>\n";
    for (const std::string& style : parts.styles) page += part(style);
    page += "</style>\n</head>\n<body>\n" + part(parts.body) +
            "<script type=\"application/json\" id=\"page-data\">" +
            inside_script(parts.data) +
            "</script>\n<script>\n\"use strict\";\n"
            "const page_data = JSON.parse("
            "document.getElementById(\"page-data\").textContent);\n";
    for (const std::string& script : parts.scripts) page += part(script);
    page += "</script>\n</body>\n</html>\n";
    return page;
}

}  // namespace course
