// The data of the pictures of the notes against counts that do not use the
// same code: over the list of faces, or known from the lecture.
#include "course/player/pictures/pictures.h"

#include <algorithm>
#include <array>
#include <set>

#include "course/halfedge/build.h"
#include "course/halfedge/validate.h"
#include "course/mesh/generators.h"
#include "course/mesh/zoo.h"
#include "course/player/json.h"
#include "course/player/pictures/orientation.h"
#include "course/runner/catch2.h"
#include "course/tests/json_reader.h"
#include "course/tests/mesh_counts.h"

namespace {

using namespace course;
using brute::at;

IndexedMesh mesh_of(const JsonValue& value) {
    IndexedMesh mesh;
    for (const JsonValue& p : value["points"].items)
        mesh.positions.push_back({p[0].number(), p[1].number(), p[2].number()});
    for (const JsonValue& face : value["faces"].items)
        mesh.faces.push_back(face.integers());
    return mesh;
}

HalfEdgeTable table_of(const JsonValue& value) {
    HalfEdgeTable he;
    for (const JsonValue& row : value["table"].items)
        he.push_back({row[0].integer(), row[1].integer(), row[2].integer(),
                      row[3].integer()});
    return he;
}

/// The faces that have the vertex.
std::set<int> faces_at(const IndexedMesh& mesh, int v) {
    std::set<int> found;
    for (int f = 0; f < mesh.faces.size(); ++f)
        if (std::count(mesh.faces[f].begin(), mesh.faces[f].end(), v))
            found.insert(f);
    return found;
}

// ---- building

constexpr int unset = -2;
using Cells = std::vector<std::array<int, 4>>;

/// The cells that the steps write; each is written once.
Cells written(const JsonValue& steps, std::size_t rows) {
    Cells cells(rows, {unset, unset, unset, unset});
    for (const JsonValue& step : steps.items)
        for (const JsonValue& write : step["set"].items) {
            int& cell =
                cells.at(at(write[0].integer())).at(at(write[1].integer()));
            CHECK(cell == unset);
            cell = write[2].integer();
        }
    return cells;
}

Cells cells_of(const HalfEdgeTable& he) {
    Cells cells;
    for (const HalfEdge& row : he.rows())
        cells.push_back({row.vi, row.fi, row.next, row.opp});
    return cells;
}

int steps_that(const JsonValue& steps, const std::string& what) {
    return static_cast<int>(std::count_if(
        steps.items.begin(), steps.items.end(),
        [&](const JsonValue& s) { return s["do"].text == what; }));
}

// ---- orientation

/// The mesh with those faces turned over whose bit is set.
IndexedMesh with_turned(const IndexedMesh& mesh, unsigned bits) {
    IndexedMesh turned{mesh.positions, {}, {}};
    for (int f = 0; f < mesh.faces.size(); ++f) {
        const FaceList::Face face = mesh.faces[f];
        std::vector<int> corners(face.begin(), face.end());
        if (bits >> f & 1U) std::reverse(corners.begin(), corners.end());
        turned.faces.push_back(corners);
    }
    return turned;
}

/// No edge is run along twice in one direction.
bool is_consistent(const IndexedMesh& mesh) {
    std::set<std::pair<int, int>> sides;
    for (const FaceList::Face face : mesh.faces)
        for (std::size_t k = 0; k < face.size(); ++k)
            if (!sides.insert({face[k], face[(k + 1) % face.size()]}).second)
                return false;
    return true;
}

/// By trying every choice of faces.
bool some_choice_is_consistent(const IndexedMesh& mesh) {
    for (unsigned bits = 0; bits < 1U << mesh.faces.size(); ++bits)
        if (is_consistent(with_turned(mesh, bits))) return true;
    return false;
}

/// The faces that the steps turn, as bits.
unsigned turned_by(const std::vector<OrientationStep>& steps) {
    unsigned bits = 0;
    for (const OrientationStep& step : steps)
        if (step.first && step.alike) bits |= 1U << step.neighbour;
    return bits;
}

// ---- structures

/// What a structure takes altogether, in the order of the page.
std::vector<int> numbers_of(const JsonValue& mesh) {
    std::vector<int> all;
    for (const JsonValue& structure : mesh["structures"].items) {
        int sum = 0;
        for (const JsonValue& part : structure["parts"].items)
            sum += part["numbers"].integer();
        all.push_back(sum);
    }
    return all;
}

// ---- elements

/// What was counted so far; complains of what is counted twice or too early.
class Elements {
public:
    void count(const JsonValue& element, const IndexedMesh& mesh) {
        if (element.has("vertex"))
            CHECK(vertices_.insert(element["vertex"].integer()).second);
        if (element.has("edge"))
            count_edge(element["edge"][0].integer(),
                       element["edge"][1].integer());
        if (element.has("face")) count_face(element["face"].integer(), mesh);
    }

    int euler() const {
        return static_cast<int>(vertices_.size() + faces_.size()) -
               static_cast<int>(edges_.size());
    }

private:
    void count_edge(int a, int b) {
        CHECK(edges_.insert(std::minmax(a, b)).second);
        CHECK((vertices_.contains(a) && vertices_.contains(b)));
    }

    void count_face(int f, const IndexedMesh& mesh) {
        CHECK(faces_.insert(f).second);
        IndexedMesh alone{mesh.positions, {}, {}};
        alone.faces.push_back(mesh.faces[f]);
        for (const auto& [edge, count] : brute::edges_of(alone))
            CHECK(edges_.contains(edge));
    }

    std::set<int> vertices_, faces_;
    std::set<std::pair<int, int>> edges_;
};

}  // namespace

TEST_CASE("values become JSON as a page reads it") {
    const Json json =
        Json::object({{"row", HalfEdge{4, -1, 11, 3}},
                      {"point", Vec3{0.5, 0, -2}},
                      {"lists", std::vector<std::vector<int>>{{1, 2}, {}}},
                      {"text", "a \"quoted\" \\"},
                      {"flags", Json::array({true, false})}});
    CHECK(json.text() ==
          R"({"row":[4,-1,11,3],"point":[0.5,0,-2],"lists":[[1,2],[]],)"
          R"("text":"a \"quoted\" \\","flags":[true,false]})");
}

TEST_CASE("the steps of building fill the builder's table, cell by cell") {
    const JsonValue data = JsonReader::read(build_picture());
    REQUIRE(data["meshes"].items.size() == 4);
    for (const JsonValue& shown : data["meshes"].items) {
        CAPTURE(shown["name"].text);
        const IndexedMesh mesh = mesh_of(shown);
        const HalfEdgeTable he = build(mesh);
        const JsonValue& steps = shown["steps"];
        CHECK(written(steps, at(he.size())) == cells_of(he));
        CHECK(table_of(shown) == he);
        CHECK(steps_that(steps, "pair") ==
              static_cast<int>(brute::edges_of(mesh).size()));
        CHECK(steps_that(steps, "pair") + steps_that(steps, "match") ==
              static_cast<int>(mesh.faces.corners().size()));
        CHECK(steps_that(steps, "close") == mesh.faces.size());
    }
}

TEST_CASE("a query finds the same on the list of faces and on half-edges") {
    const JsonValue data = JsonReader::read(cost_picture())["query"];
    const IndexedMesh mesh = mesh_of(data);
    const std::set<int> expected = faces_at(mesh, data["vertex"].integer());
    std::set<int> searched;
    std::set<int> walked;
    for (const JsonValue& step : data["search"].items)
        if (step["found"].truth()) searched.insert(step["face"].integer());
    for (const JsonValue& step : data["walk"].items)
        walked.insert(step["face"].integer());
    CHECK(searched == expected);
    CHECK(walked == expected);
    CHECK(data["search"].items.back()["reads"].integer() ==
          3 * mesh.faces.size());
    // fi, opp and next, once for each face of an interior vertex.
    CHECK(data["walk"].items.back()["reads"].integer() ==
          3 * static_cast<int>(expected.size()));
}

TEST_CASE("the search grows with the mesh, the walk does not") {
    const JsonValue growing = JsonReader::read(cost_picture())["growing"];
    for (const JsonValue& size : growing.items) {
        CHECK(size["search"].integer() == 3 * size["faces"].integer());
        CHECK(size["walk"].integer() == 18);
    }
    CHECK(growing.items.back()["faces"].integer() > 900'000);
}

TEST_CASE("the structures take what the lecture says") {
    const JsonValue meshes = JsonReader::read(integers_picture())["meshes"];
    const auto per_face = [&](std::size_t m) {
        std::vector<double> each;
        for (const int sum : numbers_of(meshes[m]))
            each.push_back(sum / meshes[m]["faces"].number());
        return each;
    };
    CHECK(per_face(0) == std::vector<double>{3, 6, 12, 13.5, 13.5, 18});
    CHECK(per_face(2) == std::vector<double>{4, 8, 16, 18, 18, 24});
    // The example in the contract of `storage`, and twice its face list.
    CHECK(numbers_of(meshes[3]) == std::vector<int>{10, 20, 64, 73, 73, 72});
}

TEST_CASE("elements are counted once, a face after its edges and vertices") {
    const JsonValue data = JsonReader::read(euler_picture());
    for (const JsonValue& shown : data["meshes"].items) {
        CAPTURE(shown["name"].text);
        const IndexedMesh mesh = mesh_of(shown);
        Elements elements;
        for (const JsonValue& element : shown["elements"].items)
            elements.count(element, mesh);
        CHECK(elements.euler() == brute::euler_of(mesh));
        CHECK(shown["pieces"].items.size() ==
              brute::components_of(mesh).size());
        CHECK(static_cast<int>(shown["loops"].items.size()) ==
              brute::border_circles_of(mesh));
    }
}

TEST_CASE("Euler's equation holds where the page says that it does") {
    // pieces, loops, orientable, genus; the last two only of manifolds
    const std::vector<std::array<int, 4>> expected = {
        {1, 1, 1, 0}, {1, 0, 1, 0}, {1, 0, 1, 0}, {1, 2, 1, 0},
        {2, 2, 1, 0}, {1, 0, 1, 1}, {1, 1, 0, 0}, {1, 0, 1, 0}};
    const JsonValue data = JsonReader::read(euler_picture())["meshes"];
    REQUIRE(data.items.size() == expected.size());
    for (std::size_t m = 0; m < expected.size(); ++m) {
        CAPTURE(data[m]["name"].text);
        const auto [pieces, loops, orientable, genus] = expected[m];
        CHECK(static_cast<int>(data[m]["pieces"].items.size()) == pieces);
        CHECK(static_cast<int>(data[m]["loops"].items.size()) == loops);
        CHECK(data[m]["orientable"].truth() == (orientable == 1));
        const bool manifold = data[m]["bow_ties"].items.empty();
        CHECK(manifold == (data[m]["name"].text != "hourglass"));
        if (manifold && orientable == 1)
            CHECK(brute::euler_of(mesh_of(data[m])) ==
                  2 * (pieces - genus) - loops);
    }
}

TEST_CASE("orientation is passed on if and only if some choice agrees") {
    for (const Fixture& fixture :
         {zoo::slide(), zoo::tetra(), zoo::cube(), zoo::annulus(), zoo::lens(),
          zoo::moebius3q(), zoo::moebius5(), zoo::rp2_6()})
        for (const unsigned bits : {0U, 1U, 2U, 5U, 12U}) {
            CAPTURE(fixture.name, bits);
            const IndexedMesh mesh = with_turned(fixture.mesh, bits);
            const auto steps = pass_orientation(mesh);
            CHECK(is_orientable(mesh) == some_choice_is_consistent(mesh));
            CHECK(is_consistent(with_turned(mesh, turned_by(steps))) ==
                  is_orientable(mesh));
        }
}

TEST_CASE("each inner edge is compared once, a face turned at most once") {
    const IndexedMesh mesh = with_turned(torus(3, 3), 0b101'010'011U);
    std::set<std::pair<int, int>> edges;
    std::set<int> reached = {0};
    for (const OrientationStep& step : pass_orientation(mesh)) {
        CHECK(edges.insert(std::minmax(step.edge[0], step.edge[1])).second);
        CHECK(reached.contains(step.face));
        CHECK(reached.insert(step.neighbour).second == step.first);
    }
    CHECK(edges.size() == brute::edges_of(mesh).size());
    CHECK(reached.size() == at(mesh.faces.size()));
}

TEST_CASE("only the strips with half a turn fail") {
    const JsonValue strips = JsonReader::read(moebius_picture())["strips"];
    std::vector<std::string> failing;
    for (const JsonValue& strip : strips.items)
        for (const JsonValue& step : strip["steps"].items)
            if (step["alike"].truth() && !step["first"].truth())
                failing.push_back(strip["name"].text);
    CHECK(failing == std::vector<std::string>{"Möbius strip",
                                              "Möbius strip of triangles"});
}

TEST_CASE("edges with three faces are shown with what the builder says") {
    const JsonValue edges = JsonReader::read(nonmanifold_picture())["edges"];
    REQUIRE(edges[0]["defects"].items.size() == 1);
    const JsonValue& defect = edges[0]["defects"][0];
    CHECK(defect["says"].text ==
          "edge 0-1 has 3 faces, 0, 1 and 2, but an edge has at most 2");
    std::vector<int> from;
    for (const JsonValue& use : defect["uses"].items)
        from.push_back(use["from"].integer());
    CHECK(from == std::vector<int>{0, 1, 0});
    CHECK(edges[1]["defects"].items.size() == 4);
}

TEST_CASE("a walk round a vertex with two fans meets one, or both") {
    const JsonValue all = JsonReader::read(nonmanifold_picture())["vertices"];
    std::vector<std::set<int>> missed;
    for (const JsonValue& shown : all.items) {
        const HalfEdgeTable he = table_of(shown);
        CHECK(validate(he).empty());
        const std::vector<int> neighbours = shown["neighbours"].integers();
        std::set<int> rest(neighbours.begin(), neighbours.end());
        for (const int i : shown["walk"].integers()) {
            CHECK(he[i].vi == shown["vertex"].integer());
            CHECK(rest.erase(he[he[i].opp].vi) == 1);
        }
        missed.push_back(rest);
    }
    CHECK(missed == std::vector<std::set<int>>{{3, 4}, {}, {4, 5, 6}});
}

TEST_CASE("each picture is one small page that asks for nothing") {
    std::set<std::string> names;
    for (const Picture& picture : lecture_pictures()) {
        CAPTURE(picture.name);
        CHECK(names.insert(picture.name).second);
        const std::string page = picture_page(picture);
        CHECK(page.size() < 200'000);
        CHECK(page.find("default-src 'none'") != std::string::npos);
        CHECK(page.find(" src=") == std::string::npos);
        CHECK(page.find("@import") == std::string::npos);
    }
    CHECK(names.size() >= 6);
}
