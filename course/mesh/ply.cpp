// PLY files.
#include "course/mesh/ply.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "course/mesh/file_defects.h"

namespace course {

namespace {

/// Numbers in decimals, one line for each element.
class AsciiBody {
public:
    void add(double x) { fmt::format_to(std::back_inserter(text_), "{} ", x); }
    void add(int v) { fmt::format_to(std::back_inserter(text_), "{} ", v); }
    void add_count(int n) { add(n); }
    void end_element() { text_.back() = '\n'; }
    std::string text() && { return std::move(text_); }

private:
    std::string text_;
};

/// Numbers as bytes, the lowest first.
class BinaryBody {
public:
    explicit BinaryBody(std::size_t bytes_of_count)
        : bytes_of_count_(bytes_of_count) {}

    void add(double x) { add_bytes(std::bit_cast<std::uint64_t>(x), 8); }
    void add(int v) { add_bytes(static_cast<std::uint32_t>(v), 4); }
    void add_count(int n) {
        add_bytes(static_cast<std::uint32_t>(n), bytes_of_count_);
    }
    void end_element() {}
    std::string text() && { return std::move(bytes_); }

private:
    void add_bytes(std::uint64_t number, std::size_t n) {
        for (std::size_t k = 0; k < n; ++k, number >>= 8)
            bytes_ += static_cast<char>(number & 0xff);
    }

    std::size_t bytes_of_count_;
    std::string bytes_;
};

/// The file's text after the head.
template <class Body>
std::string text_of(Body body, const IndexedMesh& mesh) {
    for (const auto& [x, y, z] : mesh.positions) {
        body.add(x), body.add(y), body.add(z);
        body.end_element();
    }
    for (const FaceList::Face face : mesh.faces) {
        body.add_count(static_cast<int>(face.size()));
        for (const int v : face) body.add(v);
        body.end_element();
    }
    for (const auto& [a, b] : mesh.loose_edges) {
        body.add(a), body.add(b);
        body.end_element();
    }
    return std::move(body).text();
}

bool has_large_faces(const FaceList& faces) {
    return std::any_of(faces.begin(), faces.end(),
                       [](FaceList::Face face) { return face.size() > 255; });
}

std::string head_of(const IndexedMesh& mesh, std::string_view format,
                    std::string_view type_of_count) {
    std::string head = fmt::format(
        "ply\nformat {} 1.0\n"
        "element vertex {}\n"
        "property double x\nproperty double y\nproperty double z\n"
        "element face {}\nproperty list {} int vertex_indices\n",
        format, mesh.vertex_count(), mesh.faces.size(), type_of_count);
    if (!mesh.loose_edges.empty())
        head += fmt::format(
            "element edge {}\nproperty int vertex1\nproperty int vertex2\n",
            mesh.loose_edges.size());
    return head + "end_header\n";
}

}  // namespace

void write_ply(const std::filesystem::path& file, const IndexedMesh& mesh,
               PlyFormat format) {
    require_writable(mesh);
    const bool is_large = has_large_faces(mesh.faces);
    const bool is_ascii = format == PlyFormat::ascii;
    std::string text =
        head_of(mesh, is_ascii ? "ascii" : "binary_little_endian",
                is_large ? "uint" : "uchar");
    text += is_ascii ? text_of(AsciiBody(), mesh)
                     : text_of(BinaryBody(is_large ? 4 : 1), mesh);
    replace_text(file, text);
}

}  // namespace course
