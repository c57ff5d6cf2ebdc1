// The frame of every page that we write: one file, without scripts, that
// fetches nothing and prints well.
#pragma once

#include <string_view>

#include "course/report/html.h"
#include "course/runner/verdict.h"

namespace grader {

using course::append;
using course::Html;
using course::markup;

/// A page up to its content. `title` is for the browser's tab.
Html begin_page(std::string_view title);

void end_page(Html& page);

/// The mark of a verdict: two letters with a frame; colour only adds to them.
Html badge(course::Verdict verdict);

/// The mark of a result that is still to come.
Html badge_not_judged();

/// What each mark means, on one line.
Html legend();

/// A bar for `share` of 1 in a table cell.
Html bar(double share);

}  // namespace grader
