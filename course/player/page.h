// One self-contained HTML file out of the parts in page/: it works from a USB
// stick, with no network.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace course {

/// What a page consists of. Styles, scripts and body are names of files in
/// course/player/page; scripts are plain ones that share one global scope, in
/// this order.
struct PageParts {
    std::string title;
    std::vector<std::string> styles;
    std::string body;  ///< the inner part of <body>
    std::vector<std::string> scripts;
    std::string data;  ///< JSON; scripts read it as `page_data`
    /// More that it may load, as a content security policy says it; a page
    /// that is a file needs nothing but itself.
    std::string policy = {};
};

/// The whole file. Throws SystemError when a part cannot be read.
std::string make_page(const PageParts& parts);

}  // namespace course
