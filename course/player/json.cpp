#include "course/player/json.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "course/report/escape.h"

namespace course {

std::string json_string(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : escape_json(text)) {
        if (c == '"' || c == '\\')
            quoted += {'\\', c};
        else if (c == '\n')
            quoted += "\\n";
        else if (c == '\t')
            quoted += "\\t";
        else
            quoted += c;
    }
    return quoted + '"';
}

std::string json_number(double value) {
    return std::isfinite(value) ? fmt::format("{:.9g}", value) : "null";
}

Json::Json(const HalfEdge& row)
    : Json(array({row.vi, row.fi, row.next, row.opp})) {}

Json::Json(const Vec3& point) : Json(array({point.x, point.y, point.z})) {}

Json::Json(FaceList::Face corners) : text_(array_of(corners)) {}

Json Json::object(
    std::initializer_list<std::pair<std::string_view, Json>> members) {
    Json json;
    json.text_ = "{}";
    for (const auto& [name, value] : members) json.add(name, value);
    return json;
}

Json Json::verbatim(std::string text) {
    Json json;
    json.text_ = std::move(text);
    return json;
}

Json& Json::add(std::string_view name, const Json& value) {
    text_.pop_back();
    if (text_ != "{") text_ += ',';
    text_ += Json(name).text_ + ':' + value.text_ + '}';
    return *this;
}

}  // namespace course
