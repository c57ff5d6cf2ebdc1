// The page of a large mesh: what it holds is the mesh and its table, and it
// stays small.
#include "course/player/large_mesh.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "course/halfedge/build.h"
#include "course/mesh/generators.h"
#include "course/runner/catch2.h"

namespace {

using namespace course;

/// What follows `before` in the page, up to the next `end`.
std::string between(const std::string& page, const std::string& before,
                    char end) {
    const std::size_t found = page.find(before);
    REQUIRE(found != std::string::npos);
    const std::size_t begin = found + before.size();
    return page.substr(begin, page.find(end, begin) - begin);
}

int digit(char c) {
    const std::string digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    return static_cast<int>(digits.find(c));
}

std::vector<int> bytes_of(const std::string& base64) {
    std::vector<int> bytes;
    int bits = 0;
    int held = 0;
    for (const char c : base64) {
        if (c == '=') break;
        held = (held << 6 | digit(c)) & 0xffff;
        bits += 6;
        if (bits < 8) continue;
        bits -= 8;
        bytes.push_back(held >> bits & 255);
    }
    return bytes;
}

/// The list of that name, taken apart again.
std::vector<int> list_in(const std::string& page, const std::string& name) {
    const std::string list = between(page, "\"" + name + "\":{", '}');
    const auto stride =
        static_cast<std::size_t>(std::stoi(between(list, "\"stride\":", ',')));
    std::vector<int> numbers;
    int rest = 0;
    int shift = 0;
    for (const int byte : bytes_of(between(list, "\"packed\":\"", '"'))) {
        rest |= (byte & 127) << shift;
        shift += 7;
        if (byte >= 128) continue;
        const int step = rest % 2 == 0 ? rest / 2 : -(rest + 1) / 2;
        numbers.push_back(step + (numbers.size() < stride
                                      ? 0
                                      : numbers[numbers.size() - stride]));
        rest = shift = 0;
    }
    CHECK(between(list, "\"count\":", ',') == std::to_string(numbers.size()));
    return numbers;
}

IndexedMesh tent() {  // a quad, a triangle on it, a loose edge
    IndexedMesh mesh;
    mesh.positions = {
        {-1, -1, -1}, {3, -1, -1}, {3, 1, -1}, {-1, 1, -1}, {1, 0, 0}};
    mesh.faces = {{0, 1, 2, 3}, {1, 0, 4}};
    mesh.loose_edges = {{4, 2}};
    return mesh;
}

}  // namespace

TEST_CASE("the page of a large mesh holds its faces and loose edges") {
    const std::string page = large_mesh_page("tent", tent());
    CHECK(list_in(page, "corners") == std::vector{0, 1, 2, 3, 1, 0, 4});
    CHECK(list_in(page, "sides") == std::vector{1, 4, 1, 3});
    CHECK(list_in(page, "loose") == std::vector{4, 2});
    CHECK(between(page, "\"half_edges\":", ',') == "14");
    CHECK(between(page, "\"recording\":", '}') == "null");
}

TEST_CASE("coordinates have 16 bits on the longest side of the box") {
    const std::string page = large_mesh_page("tent", tent());
    CHECK(list_in(page, "positions") == std::vector{0, 0, 0, 65535, 0, 0, 65535,
                                                    32768, 0, 0, 32768, 0,
                                                    32768, 16384, 16384});
}

TEST_CASE("the page knows a sum of the table, to prove its own by") {
    const IndexedMesh mesh = random_polygons(5);
    const HalfEdgeTable he = build(mesh);
    std::uint32_t sum = 2166136261U;
    for (int i = 0; i < he.size(); ++i)
        for (const int cell : {he[i].vi, he[i].fi, he[i].next, he[i].opp}) {
            sum ^= static_cast<std::uint32_t>(cell);
            sum *= 16777619U;
        }
    const std::string page = large_mesh_page("random", mesh);
    CHECK(between(page, "\"sum\":", '}') == std::to_string(sum));
    CHECK(list_in(page, "corners") == mesh.faces.corners());
}

TEST_CASE("text in a title or a recording cannot leave its place") {
    const std::string page = large_mesh_page(
        "<b>", tent(), R"({"sources":[],"walks":[],"title":"</script>"})");
    CHECK(between(page, "<title>", '/') == "&lt;b&gt;<");
    CHECK(page.find("\"title\":\"\\u003c/script>\"") != std::string::npos);
}

TEST_CASE("a page of a hundred thousand faces is below two megabytes") {
    const IndexedMesh mesh = torus(400, 125, Cells::triangles);
    CHECK(large_mesh_page("torus", mesh).size() < 2'000'000);
}

TEST_CASE("a mesh without a table, or without a place in space, has no page") {
    IndexedMesh mesh = tent();
    mesh.faces.push_back({0, 1, 2, 3});
    CHECK_THROWS_AS(large_mesh_page("", mesh), BuildError);
    mesh = tent();
    mesh.positions[2].y = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(large_mesh_page("", mesh), std::invalid_argument);
}

TEST_CASE("the largest and the smallest boxes have a page") {
    IndexedMesh mesh = tent();
    for (Vec3& p : mesh.positions) p = 5e307 * p;
    CHECK(list_in(large_mesh_page("", mesh), "positions")[3] == 65535);
    for (Vec3& p : mesh.positions) p = {7, 7, 7};
    CHECK(list_in(large_mesh_page("", mesh), "positions")[3] == 0);
    CHECK(list_in(large_mesh_page("", {}), "corners").empty());
}
