// `lab demo --live`: a page in the browser that follows a file, for code that
// is written in class.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "course/cli/file_watch.h"
#include "course/player/page_server.h"

namespace course {

/// Makes the page from the file as it is now. What it throws is said by the
/// page instead, see large_sentence.
using MakePage = std::function<std::string()>;

/// What a lecture room can read of messages: of a compiler's the first error,
/// "line 12: expected ';' before '}' token", of others the first line.
std::string large_sentence(const std::string& messages);

/// Returns when the file was saved, and then left alone for a moment; false:
/// `stop` (a descriptor) can be read.
bool wait_for_save(FileWatch& file, int stop);

/// Shows the page now and after each save, until `stop` can be read. Saves in
/// quick succession, and those while a page is being made, are one.
void follow(FileWatch& file, PageServer& server, const MakePage& make,
            int stop);

/// The whole command: prints the address and follows the file until Ctrl-C or
/// SIGTERM. Port 0: the system chooses. Returns the exit code. Throws
/// CannotServe and SystemError.
int live(const std::filesystem::path& file, int port, const MakePage& make);

}  // namespace course
