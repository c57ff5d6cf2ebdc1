#include "course/player/json.h"

namespace course {

Json::Json(std::string_view value) : text_("\"") {
    for (const char c : value) {
        if (c == '"' || c == '\\')
            text_ += {'\\', c};
        else if (static_cast<unsigned char>(c) < 0x20)
            text_ += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
        else
            text_ += c;
    }
    text_ += '"';
}

Json::Json(const HalfEdge& row)
    : Json(array({row.vi, row.fi, row.next, row.opp})) {}

Json::Json(const Vec3& point) : Json(array({point.x, point.y, point.z})) {}

Json::Json(FaceList::Face corners) : text_(array_of(corners)) {}

Json Json::object(
    std::initializer_list<std::pair<std::string_view, Json>> members) {
    Json json;
    json.text_ = "{";
    for (const auto& [name, value] : members) {
        if (json.text_.size() > 1) json.text_ += ',';
        json.text_ += Json(name).text_ + ':' + value.text_;
    }
    json.text_ += '}';
    return json;
}

}  // namespace course
