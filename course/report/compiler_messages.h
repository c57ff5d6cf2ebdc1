// What g++ or clang said about a student's file, cut down to what the student
// can act on, with advice for the usual mistakes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace course {

/// One error or warning.
struct CompilerMessage {
    bool is_error = false;
    std::string place;   ///< "face_sides.cpp:8:19", of the student's own file
    std::string text;    ///< what the compiler says
    std::string source;  ///< the lines of source that it shows, with line feeds
    std::string advice;  ///< what it mostly means here; may be empty
    /// Of a warning: it often is why an answer is wrong or a walk endless.
    bool explains_failures = false;
};

/// Errors before warnings, warnings that explain failures before others; else
/// in the compiler's order; of several at one place the first. A message about
/// a header stands at the student's line that led there. Notes, and what
/// concerns no file of the student's, are left out.
std::vector<CompilerMessage> compiler_messages(std::string_view output);

/// The first of them in full, and how many more there are, below the word that
/// the compiler was stopped; the output as it is when no message is found in
/// it. Of lines that no terminal shows whole, the begin. The first line of each
/// is "file:line:column: error: text", as editors know it.
std::string explain_compiler(std::string_view output);

}  // namespace course
