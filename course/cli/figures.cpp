#include "course/cli/figures.h"

#include <fmt/format.h>

#include "course/mesh/zoo.h"
#include "course/report/mesh_drawing.h"

namespace course {

namespace {

/// What a page would say: colours, and a background for dark viewers.
constexpr std::string_view colours =
    "svg { --ink: #1d2733; --amber: #b45309; background: #fff;"
    " font-family: sans-serif; }\nsvg text { text-anchor: middle; }\n";

/// The faces as rows without opposites, for a mesh that has no table.
std::vector<HalfEdge> rows_of_faces(const FaceList& faces) {
    std::vector<HalfEdge> rows;
    for (int f = 0; f < faces.size(); ++f) {
        const int first = static_cast<int>(rows.size());
        const int sides = static_cast<int>(faces[f].size());
        for (int k = 0; k < sides; ++k)
            rows.push_back({faces[f][static_cast<std::size_t>(k)], f,
                            first + (k + 1) % sides, -1});
    }
    return rows;
}

MeshPicture picture_of(const Fixture& fixture) {
    return {fixture.name,
            fixture.he.empty() ? rows_of_faces(fixture.mesh.faces)
                               : fixture.he.rows(),
            fixture.mesh.positions};
}

/// The drawing as a file of its own; empty where there is none.
std::string svg_file(const MeshPicture& picture, const Walk& walk) {
    std::string svg = mesh_drawing(picture, walk).text;
    const std::string start = "<svg ";
    if (svg.empty()) return svg;
    svg.insert(start.size(), R"(xmlns="http://www.w3.org/2000/svg" )");
    svg.insert(svg.find('>') + 1,
               fmt::format("<style>\n{}{}</style>", colours, mesh_style));
    return svg + "\n";
}

/// The half-edges from `start` on, by `step` from one to the next.
template <class Step>
Walk walk_from(int start, Step step) {
    Walk walk;
    int i = start;
    do {
        walk.steps.push_back(i);
        i = step(i);
    } while (i != start);
    walk.reads = static_cast<std::int64_t>(walk.steps.size());
    return walk;
}

std::map<std::string, Walk> walks_on(const HalfEdgeTable& he) {
    return {
        {"face_walk", walk_from(4, [&](int i) { return he[i].next; })},
        {"star_walk", walk_from(8, [&](int i) { return he[he[i].opp].next; })},
        {"border_walk", walk_from(0, [&](int i) { return he[i].next; })}};
}

std::vector<Fixture> all_meshes() {
    std::vector<Fixture> all = zoo::with_table();
    for (Fixture fixture : {zoo::moebius3q(), zoo::moebius5(), zoo::fan3(),
                            zoo::house_with_wall()})
        all.push_back(std::move(fixture));
    return all;
}

}  // namespace

std::map<std::string, std::string> lecture_figures() {
    std::map<std::string, std::string> figures;
    const auto add = [&](const std::string& name, std::string svg) {
        if (!svg.empty()) figures[name + ".svg"] = std::move(svg);
    };
    for (const Fixture& fixture : all_meshes())
        add(fixture.name, svg_file(picture_of(fixture), {}));
    const Fixture slide = zoo::slide();
    for (const auto& [name, walk] : walks_on(slide.he))
        add(name, svg_file(picture_of(slide), walk));
    return figures;
}

}  // namespace course
