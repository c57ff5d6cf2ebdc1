#include "course/cli/demo_set.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include "course/cli/check.h"
#include "course/mesh/file_defects.h"
#include "course/player/json.h"
#include "course/player/page.h"
#include "course/player/pictures/pictures.h"
#include "course/player/record.h"
#include "course/player/walk_page.h"
#include "course/runner/pool.h"
#include "course/runner/statement.h"

namespace course {

namespace {

namespace fs = std::filesystem;

/// A page of the set, to be made.
struct DemoPage {
    std::string chapter, file, title;
    bool is_picture = false;
    std::function<std::string()> make;
};

std::vector<DemoPage> pictures() {
    std::vector<DemoPage> pages;
    for (const Picture& picture : lecture_pictures())
        pages.push_back({picture.chapter, picture.name + ".html", picture.title,
                         true, [picture] { return picture_page(picture); }});
    return pages;
}

std::vector<Exercise> shown_exercises(const Desk& desk) {
    std::vector<Exercise> all = all_exercises();
    if (!has_solutions()) all = begun(desk, all);
    std::erase_if(all, [](const Exercise& one) { return !can_be_shown(one); });
    return all;
}

std::vector<DemoPage> walks(const Desk& desk,
                            const std::vector<Exercise>& exercises) {
    std::vector<DemoPage> pages;
    for (const Exercise& exercise : exercises) {
        RecordOptions options;
        if (!has_solutions()) options.file = desk.file(exercise);
        pages.push_back({exercise.topic, "walk_" + exercise.name + ".html",
                         statement_of(exercise).title, false,
                         [exercise, options] {
                             return walk_page(record(exercise, options));
                         }});
    }
    return pages;
}

/// "03_building" as the lecture calls it: "3 Building".
std::string title_of_chapter(const std::string& chapter) {
    const std::string text =
        read_file(source_root() / "course" / "lectures" / (chapter + ".md"));
    const auto first = text.find_first_not_of("# ");
    return text.substr(first, text.find('\n') - first);
}

std::string index_page(const std::vector<DemoPage>& pages) {
    std::map<std::string, std::vector<Json>> by_chapter;
    for (const DemoPage& page : pages)
        by_chapter[page.chapter].push_back(
            Json::object({{"file", page.file},
                          {"title", page.title},
                          {"is_picture", page.is_picture}}));
    std::vector<Json> chapters;
    for (const auto& [chapter, list] : by_chapter)
        chapters.push_back(Json::object(
            {{"title", title_of_chapter(chapter)}, {"pages", list}}));
    return make_page({.title = "Walks on the half-edge table",
                      .styles = {"base.css", "index.css"},
                      .body = "index.html",
                      .scripts = {"svg.js", "index.js"},
                      .data = Json(chapters).text()});
}

/// Writes a page, or returns why there is none.
std::optional<std::string> written(const DemoPage& page,
                                   const fs::path& folder) {
    try {
        replace_text(folder / page.file, page.make());
        return std::nullopt;
    } catch (const DoesNotCompile& error) {
        return fmt::format("{} does not compile:\n{}", page.title,
                           error.what());
    } catch (const CannotShow& error) {
        return error.what();
    }
}

/// Writes them on all cores; returns those that could be made.
std::vector<DemoPage> write_pages(const std::vector<DemoPage>& pages,
                                  const fs::path& folder) {
    std::vector<char> is_there(pages.size());
    std::size_t done = 0;
    std::mutex one_at_a_time;
    const bool at_terminal = ::isatty(2) == 1;
    const auto items = static_cast<int>(pages.size());
    for_each_item(core_count(), items, [&](int, int item) {
        const auto k = static_cast<std::size_t>(item);
        const auto complaint = written(pages[k], folder);
        const std::lock_guard guard(one_at_a_time);
        is_there[k] = complaint ? 0 : 1;
        ++done;
        if (complaint) fmt::print(stderr, "lab: {}\n", *complaint);
        if (at_terminal)
            fmt::print(stderr, "\r{} of {} pages{}", done, pages.size(),
                       done == pages.size() ? "\r\033[K" : "");
    });
    std::vector<DemoPage> there;
    for (std::size_t k = 0; k < pages.size(); ++k)
        if (is_there[k] != 0) there.push_back(pages[k]);
    return there;
}

}  // namespace

int demo_set(const Desk& desk, const fs::path& folder) {
    fs::create_directories(folder);
    const std::vector<Exercise> exercises = shown_exercises(desk);
    make_ready_to_record(exercises);
    std::vector<DemoPage> pages = pictures();
    for (DemoPage& page : walks(desk, exercises))
        pages.push_back(std::move(page));
    const std::vector<DemoPage> there = write_pages(pages, folder);
    replace_text(folder / "index.html", index_page(there));
    fmt::print("{} pages are in {}: open {} in a browser.\n", there.size(),
               folder.string(), (folder / "index.html").string());
    return there.size() == pages.size() ? 0 : 1;
}

}  // namespace course
