// How the builder fills the table, side by side of each face. It gives a list
// of faces the same rows, whatever faces come after it: so what a face adds is
// the difference between the tables with it and without it.
#include "course/halfedge/build.h"
#include "course/mesh/zoo.h"
#include "course/player/json.h"
#include "course/player/pictures/pictures.h"

namespace course {

namespace {

/// The table while it is built: only what is known so far.
class Steps {
public:
    /// Side k of face f, which is half-edge i of the table `he`: it waited for
    /// the face as an opposite, or its edge is new.
    void add_side(const HalfEdgeTable& he, int f, int k, int i) {
        const bool is_new = i >= rows_;
        if (is_new) rows_ = i + 2;
        const HalfEdge& row = he.rows()[static_cast<std::size_t>(i)];
        std::vector<Json> cells = {Json::array({i, 1, f})};
        if (is_new)
            cells = {Json::array({i, 0, row.vi}), Json::array({i, 1, f}),
                     Json::array({i, 3, i + 1}),
                     Json::array({i + 1, 0, he[i + 1].vi}),
                     Json::array({i + 1, 3, i})};
        steps_.push_back(Json::object({{"do", is_new ? "pair" : "match"},
                                       {"face", f},
                                       {"side", k},
                                       {"i", i},
                                       {"set", cells}}));
    }

    /// The half-edges of face f follow each other.
    void close_face(const HalfEdgeTable& he, int f,
                    const std::vector<int>& sides) {
        std::vector<Json> cells;
        for (const int i : sides)
            cells.push_back(Json::array({i, 2, he[i].next}));
        steps_.push_back(Json::object(
            {{"do", "close"}, {"face", f}, {"i", sides[0]}, {"set", cells}}));
    }

    /// Half-edge i of the finished table has no face.
    void add_border(const HalfEdgeTable& he, int i) {
        steps_.push_back(Json::object(
            {{"do", "border"},
             {"i", i},
             {"set", Json::array({Json::array({i, 1, -1}),
                                  Json::array({i, 2, he[i].next})})}}));
    }

    const std::vector<Json>& steps() const { return steps_; }

private:
    int rows_ = 0;
    std::vector<Json> steps_;
};

/// The half-edges of face f, from its first corner on.
std::vector<int> sides_of(const HalfEdgeTable& he, FaceList::Face corners,
                          int f) {
    int i = 0;
    while (he[i].fi != f || he[i].vi != corners[0]) ++i;
    std::vector<int> sides;
    for (std::size_t k = 0; k < corners.size(); ++k, i = he[i].next)
        sides.push_back(i);
    return sides;
}

Json built(const Fixture& fixture) {
    const IndexedMesh& mesh = fixture.mesh;
    IndexedMesh part{mesh.positions, {}, {}};
    Steps steps;
    for (int f = 0; f < mesh.faces.size(); ++f) {
        part.faces.push_back(mesh.faces[f]);
        const HalfEdgeTable he = build(part);
        const std::vector<int> sides = sides_of(he, mesh.faces[f], f);
        for (std::size_t k = 0; k < sides.size(); ++k)
            steps.add_side(he, f, static_cast<int>(k), sides[k]);
        steps.close_face(he, f, sides);
    }
    const HalfEdgeTable he = build(mesh);
    for (int i = 0; i < he.size(); ++i)
        if (he[i].fi == -1) steps.add_border(he, i);
    return Json::object({{"name", fixture.name},
                         {"points", mesh.positions},
                         {"faces", mesh.faces},
                         {"table", he.rows()},
                         {"steps", steps.steps()}});
}

}  // namespace

std::string build_picture() {
    std::vector<Json> meshes;
    for (const Fixture& fixture :
         {zoo::slide(), zoo::lens(), zoo::tetra(), zoo::annulus()})
        meshes.push_back(built(fixture));
    return Json::object({{"meshes", meshes}}).text();
}

}  // namespace course
