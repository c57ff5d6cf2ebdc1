// Text laid out for a screen: lines that fit, two columns, colours.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "course/cli/terminal.h"

namespace course {

/// The lines of a text, those that are too long broken between words; what
/// follows a break begins where the line began. Tabs become blanks.
/// Precondition: the text is visible (course/report/text.h).
std::vector<std::string> wrapped(std::string_view text, std::size_t columns);

/// Both side by side and coloured, the left one `columns` wide, with a line
/// between.
std::vector<std::string> in_two_columns(const std::vector<std::string>& left,
                                        const std::vector<std::string>& right,
                                        std::size_t columns);

/// A line with colours for what it begins with: verdicts, errors, marked rows.
std::string coloured(const std::string& line);

/// What a screen shows: a head that stays, a body that can be scrolled, a foot.
struct Page {
    std::vector<std::string> head, body;
    std::string foot;  ///< one line, cut if it does not fit
};

/// The lines of the screen, as many as it has; the body begins with its line
/// `top`, which is brought into range. A word in the last line of the body
/// tells how many lines are below.
std::vector<std::string> screen_of(const Page& page, ScreenSize size,
                                   std::size_t& top);

}  // namespace course
