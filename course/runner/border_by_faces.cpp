#include "course/runner/border_by_faces.h"

#include <algorithm>

namespace course::oracle {

Border::Border(const Fixture& fixture) {
    const std::vector<HalfEdge>& rows = fixture.he.rows();
    for (int i = 0; i < fixture.he.size(); ++i) {
        const HalfEdge& row = rows[at(i)];
        ends_.push_back({row.vi, rows[at(row.opp)].vi});
        half_edges_[ends_.back()] = i;
    }
    for (const FaceList::Face face : fixture.mesh.faces)
        for (std::size_t k = 0; k < face.size(); ++k)
            sides_.insert({face[k], face[(k + 1) % face.size()]});
    find_vertices(fixture.mesh);
    find_loops(rows);
}

int Border::faces_at(int i) const {
    const Ends ends = ends_[at(i)];
    return static_cast<int>(sides_.count(ends) + sides_.count(reversed(ends)));
}

std::vector<int> Border::walk(int i) const {
    const int from = has(i) ? i : half_edges_.at(reversed(ends_[at(i)]));
    for (const std::vector<int>& loop : loops_)
        if (std::find(loop.begin(), loop.end(), from) != loop.end())
            return loop;
    return {};
}

void Border::find_vertices(const IndexedMesh& mesh) {
    for (const Ends& ends : sides_)
        if (!sides_.contains(reversed(ends)))
            vertices_.insert(ends.begin(), ends.end());
    for (const Ends& ends : mesh.loose_edges)
        vertices_.insert(ends.begin(), ends.end());
}

void Border::find_loops(const std::vector<HalfEdge>& rows) {
    std::map<int, std::vector<int>> leaving;  // border half-edges by vertex
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (has(static_cast<int>(i)))
            leaving[ends_[i][0]].push_back(static_cast<int>(i));

    std::set<int> done;
    for (const auto& [vertex, starts] : leaving)
        for (int i : starts) {
            std::vector<int> loop;
            while (done.insert(i).second) {
                loop.push_back(i);
                const std::vector<int>& ways_on = leaving.at(ends_[at(i)][1]);
                i = ways_on.size() == 1 ? ways_on.front() : rows[at(i)].next;
            }
            if (!loop.empty()) loops_.push_back(loop);
        }
}

}  // namespace course::oracle
