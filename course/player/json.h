// JSON as text, for recordings and the data of pages. Written only, never read.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "course/halfedge/half_edge_table.h"
#include "course/mesh/indexed_mesh.h"

namespace course {

/// The text in quotes, escaped; what no reader would see is spelled out.
std::string json_string(std::string_view text);

/// A number with as many digits as a page shows; null for what JSON has no
/// number for.
std::string json_number(double value);

/// One JSON value, made from what the course's code has at hand.
class Json {
public:
    // NOLINTBEGIN(google-explicit-constructor): a value stands where Json does
    Json(bool value) : text_(value ? "true" : "false") {}
    Json(int value) : text_(std::to_string(value)) {}
    Json(std::int64_t value) : text_(std::to_string(value)) {}
    Json(std::size_t value) : text_(std::to_string(value)) {}
    Json(double value) : text_(json_number(value)) {}
    Json(const char* value) : Json(std::string_view(value)) {}
    Json(const std::string& value) : Json(std::string_view(value)) {}
    Json(std::string_view value) : text_(json_string(value)) {}
    /// [vi, fi, next, opp]
    Json(const HalfEdge& row);
    /// [x, y, z]
    Json(const Vec3& point);
    /// The corners of a face.
    Json(FaceList::Face corners);
    template <class T>
    Json(const std::vector<T>& values) : text_(array_of(values)) {}
    template <std::size_t n>
    Json(const std::array<int, n>& values) : text_(array_of(values)) {}
    Json(const FaceList& faces) : text_(array_of(faces)) {}
    // NOLINTEND(google-explicit-constructor)

    static Json array(std::initializer_list<Json> values) {
        Json json;
        json.text_ = array_of(values);
        return json;
    }
    static Json object(
        std::initializer_list<std::pair<std::string_view, Json>> members);

    /// Text that is JSON already.
    static Json verbatim(std::string json);

    /// One more member of an object.
    Json& add(std::string_view name, const Json& value);

    const std::string& text() const { return text_; }

private:
    Json() = default;

    template <class Values>
    static std::string array_of(const Values& values) {
        std::string text = "[";
        for (const auto& value : values) {
            if (text.size() > 1) text += ',';
            text += Json(value).text_;
        }
        return text + "]";
    }

    std::string text_;
};

}  // namespace course
