#include "course/player/recording.h"

#include <algorithm>

#include "course/player/json.h"

namespace course {

namespace {

Json json_of(const Step& step);
Json json_of(const RecordedWalk& walk);
Json json_of(const RecordedSource& source);

template <class T>
Json list_of(const std::vector<T>& elements) {
    std::vector<Json> all;
    for (const T& element : elements) all.push_back(json_of(element));
    return all;
}

void add_cell(Json& object, const Step& step) {
    object.add("i", step.i);
    if (step.added) object.add("new", *step.added);
    if (step.field < 0) return;
    object.add("f", step.field).add("v", step.value);
    if (step.before) object.add("w", *step.before);
}

Json json_of(const Step& step) {
    Json object = Json::object({});
    if (step.line > 0) object.add("l", step.line);
    if (step.from > 0) object.add("c", Json::array({step.from, step.to}));
    if (step.i >= 0) add_cell(object, step);
    if (step.cut) object.add("n", *step.cut);
    if (step.in_original) object.add("o", true);
    Json locals = Json::object({});
    for (const auto& [name, value] : step.locals)
        locals.add(name, Json::verbatim(value));
    if (!step.locals.empty()) object.add("d", locals);
    if (!step.function.empty()) object.add("fn", step.function);
    if (step.depth) object.add("in", *step.depth);
    return object;
}

Json json_of(const RecordedWalk& walk) {
    Json object = Json::object({{"source", walk.source}, {"call", walk.call}});
    object.add("start", walk.start ? *walk.start : Json::verbatim("null"));
    if (walk.table) object.add("table", *walk.table);
    object.add("steps", list_of(walk.steps));
    if (walk.skipped > 0) object.add("skipped", walk.skipped);
    if (!walk.result.empty()) object.add("result", Json::verbatim(walk.result));
    if (!walk.expected.empty())
        object.add("expected", Json::verbatim(walk.expected));
    if (!walk.error.empty()) object.add("error", walk.error);
    if (!walk.expected_error.empty())
        object.add("expected_error", walk.expected_error);
    return object;
}

Json json_of(const RecordedSource& source) {
    return Json::object({{"label", source.label},
                         {"file", source.file},
                         {"first", source.first},
                         {"lines", source.lines}});
}

Json mesh_of(const Recording& recording) {
    return Json::object({{"name", recording.mesh_name},
                         {"points", recording.mesh.positions},
                         {"faces", recording.mesh.faces},
                         {"table", recording.table}});
}

std::string text_of(const Recording& recording, bool with_mesh) {
    Json object = Json::object({{"exercise", recording.exercise},
                                {"topic", recording.topic},
                                {"title", recording.title},
                                {"starts", recording.start_kind}});
    if (with_mesh) object.add("mesh", mesh_of(recording));
    object.add("sources", list_of(recording.sources))
        .add("walks", list_of(recording.walks));
    return object.text() + "\n";
}

}  // namespace

std::string to_json(const Recording& recording) {
    return text_of(recording, true);
}

std::string page_json(const Recording& recording) {
    return text_of(recording, recording.mesh.faces.size() <= most_drawn_faces);
}

void shorten(Recording& recording, std::size_t most, std::size_t least) {
    std::vector<std::size_t> lengths;
    for (const RecordedWalk& walk : recording.walks)
        lengths.push_back(walk.steps.size());
    std::sort(lengths.begin(), lengths.end());
    // What the shorter ones leave is shared among the longer ones.
    std::size_t longest = most, left = most;
    for (std::size_t k = 0; k < lengths.size(); ++k) {
        longest = left / (lengths.size() - k);
        if (lengths[k] > longest) break;
        left -= lengths[k];
    }
    longest = std::max(longest, least);
    for (RecordedWalk& walk : recording.walks) {
        if (walk.steps.size() <= longest) continue;
        for (std::size_t k = longest; k < walk.steps.size(); ++k)
            if (walk.steps[k].i >= 0) ++walk.skipped;
        walk.steps.resize(longest);
    }
}

}  // namespace course
