#include "grader/pipeline/document_links.h"

#include <optional>

namespace grader {

namespace {

/// [text](target) by the places of its brackets.
struct Link {
    std::size_t open, middle, end;

    std::string_view text(std::string_view document) const {
        return document.substr(open + 1, middle - open - 1);
    }
    std::string_view target(std::string_view document) const {
        const auto whole = document.substr(middle + 2, end - middle - 2);
        return whole.substr(0, whole.find('#'));
    }
};

/// The bracket that is closed by the one at `close`.
std::size_t opening_of(std::string_view document, std::size_t close) {
    int depth = 0;
    for (std::size_t k = close + 1; k-- > 0;) {
        if (document[k] == ']') ++depth;
        if (document[k] == '[' && --depth == 0) return k;
    }
    return document.npos;
}

/// The first link that ends behind `from`.
std::optional<Link> next_link(std::string_view document, std::size_t from) {
    const std::size_t middle = document.find("](", from);
    if (middle == document.npos) return std::nullopt;
    const std::size_t end = document.find(')', middle);
    if (end == document.npos) return std::nullopt;
    return Link{opening_of(document, middle), middle, end};
}

/// Whether a row of a table has the link at its begin.
bool begins_row(std::string_view document, const Link& link) {
    const std::string_view row = "| ";
    if (link.open < row.size() ||
        document.substr(link.open - row.size(), row.size()) != row)
        return false;
    return link.open == row.size() || document[link.open - 3] == '\n';
}

/// Takes out the row that begins at `begin`, and with the last one the head of
/// the table; where to go on.
std::size_t without_row(std::string& document, std::size_t begin) {
    const std::size_t end = document.find('\n', begin);
    document.erase(begin, end == document.npos ? end : end - begin + 1);
    const std::size_t rule = document.rfind("\n|---", begin);
    const bool is_empty = rule != document.npos && rule > 0 &&
                          document.find('\n', rule + 1) == begin - 1 &&
                          document.substr(begin, 1) != "|";
    if (!is_empty) return begin;
    const std::size_t head = document.rfind('\n', rule - 1) + 1;
    document.erase(head, begin - head);
    return head;
}

}  // namespace

std::string without_links(
    const std::string& document,
    const std::function<bool(std::string_view target)>& is_missing) {
    std::string left = document;
    std::size_t from = 0;
    while (const auto link = next_link(left, from)) {
        from = link->middle + 1;
        const auto target = link->target(left);
        if (link->open == left.npos || target.empty() || !is_missing(target))
            continue;
        if (begins_row(left, *link)) {
            from = without_row(left, link->open - 2);
            continue;
        }
        const std::string text(link->text(left));
        left.replace(link->open, link->end - link->open + 1, text);
        from = link->open + text.size();
    }
    return left;
}

}  // namespace grader
