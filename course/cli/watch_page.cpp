#include "course/cli/watch_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "course/cli/lists.h"
#include "course/report/text.h"

namespace course {

namespace {

constexpr std::size_t two_columns_from = 140;

constexpr const char* keys =
    " n next  h hint  l list  r replay  c check all  x reset  o open  q quit";

std::string_view state_of(const ExerciseView& view) {
    if (view.is_building) return "building the suite ...";
    if (view.is_running) return "checking ...";
    if (!view.outcome) return "";
    if (view.outcome->code == 0) return "accepted";
    return view.outcome->code == 1 ? "not accepted" : "could not be checked";
}

std::string head_line(const ExerciseView& view) {
    return fmt::format("\033[1m{}  {}\033[0m  {}", view.exercise.topic,
                       view.exercise.name, state_of(view));
}

std::string result_text(const ExerciseView& view) {
    std::string text = view.note.empty() ? "" : view.note + "\n\n";
    if (view.outcome) text += view.outcome->text;
    if (view.outcome && view.outcome->code == 0)
        text += "\nDone. n: the next exercise.\n";
    return text;
}

std::string hints_text(const ExerciseView& view) {
    std::string text;
    for (std::size_t k = 0; k < view.hints && k < view.statement.hints.size();
         ++k)
        text += fmt::format("Hint: {}. {}\n", k + 1, view.statement.hints[k]);
    if (view.hints > 0 && view.hints < view.statement.hints.size())
        text += fmt::format("(h: hint {} of {})\n", view.hints + 1,
                            view.statement.hints.size());
    return text.empty() ? "" : text + "\n";
}

std::string statement_of(const ExerciseView& view) {
    return fmt::format("{}\nYour file: {}\n",
                       plain_markdown(view.statement.text), view.file);
}

/// Two texts, one below the other, with a line between.
std::string stacked(const std::string& above, const std::string& below,
                    std::size_t columns) {
    if (above.empty() || below.empty()) return above + below;
    std::string line;
    for (std::size_t k = 0; k < columns; ++k) line += "─";
    return above + "\n" + line + "\n" + below;
}

}  // namespace

Page exercise_page(const ExerciseView& view, ScreenSize size) {
    Page page;
    page.head = {head_line(view)};
    for (std::string& line :
         wrapped(short_chapters_of(view.progress), size.columns))
        page.head.push_back("\033[2m" + std::move(line));
    page.head.emplace_back();
    page.foot = keys;
    const std::string hints = hints_text(view), result = result_text(view),
                      statement = statement_of(view);
    if (size.columns >= two_columns_from) {
        const std::size_t half = (size.columns - 3) / 2;
        page.body = in_two_columns(wrapped(hints + result, half),
                                   wrapped(statement, half), half);
    } else {
        page.body =
            wrapped(hints + (view.is_untouched
                                 ? stacked(statement, result, size.columns)
                                 : stacked(result, statement, size.columns)),
                    size.columns);
    }
    return page;
}

Page list_page(const ListView& view, ScreenSize size) {
    Page page;
    page.head = {fmt::format("\033[1mList\033[0m  filter: {}_", view.filter),
                 ""};
    page.foot = " type to filter  up, down  enter: go there  esc: back";
    const std::size_t room = size.lines > 6 ? size.lines - 6 : 1;
    const std::size_t first =
        view.selected >= room ? view.selected - room + 1 : 0;
    for (std::size_t k = first; k < std::min(view.found.size(), first + room);
         ++k) {
        const std::string line = fmt::format(
            "{} {:<13} {:<24} {:<6} {}", k == view.selected ? ">" : " ",
            view.found[k].exercise.topic, view.found[k].exercise.name,
            words(view.progress.state(view.found[k].exercise)),
            view.found[k].title);
        page.body.push_back(fitted(line, size.columns));
    }
    if (view.found.empty()) page.body = {"  Nothing like that."};
    return page;
}

Page text_page(const std::string& title, const std::string& text,
               const std::string& foot, ScreenSize size) {
    return {
        {"\033[1m" + title + "\033[0m", ""}, wrapped(text, size.columns), foot};
}

}  // namespace course
