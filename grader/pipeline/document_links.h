// Links of a Markdown document, for a copy that lacks some of their targets.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace grader {

/// The document without links to what is missing: of [text](target) the text
/// stays, and a row of a table that begins with such a link goes, the last row
/// with the table's head. A target is told without its #anchor. Works on links
/// only, wherever they stand: say "missing" of nothing that may be code.
std::string without_links(
    const std::string& document,
    const std::function<bool(std::string_view target)>& is_missing);

}  // namespace grader
