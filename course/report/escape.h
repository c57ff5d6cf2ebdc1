// One escaping function for each place that reports write text to. Nothing
// that a student may have chosen reaches a report by another way.
#pragma once

#include <string>
#include <string_view>

namespace course {

/// For the content and the quoted attributes of HTML.
std::string escape_html(std::string_view text);

/// For the content and the quoted attributes of XML 1.0; characters that XML
/// forbids are spelled out.
std::string escape_xml(std::string_view text);

/// One field of a CSV line, quoted where it must be; line feeds are spelled
/// out, so that a record is a line. A field that a spreadsheet would take for
/// a formula gets an apostrophe in front; numbers of our own do not go here.
std::string escape_csv(std::string_view text);

/// For a terminal, within one line: line feeds and tabs are spelled out, too.
std::string escape_terminal(std::string_view text);

/// For a string of JSON that a web page may show; nlohmann-json does the
/// quoting.
std::string escape_json(std::string_view text);

}  // namespace course
