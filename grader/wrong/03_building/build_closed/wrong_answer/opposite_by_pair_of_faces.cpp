// Finds the opposite by the two faces: those that share several edges get the
// last one for all.
// Hint: You find the opposite by the two faces beside it; they may share
// several edges.
#include "exercises/03_building/build_closed.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

HalfEdgeTable build_closed(const IndexedMesh& mesh) {
    HalfEdgeTable he;
    std::map<std::pair<int, int>, int> face_of;
    for (int f = 0; f < mesh.faces.size(); ++f) {
        FaceList::Face face = mesh.faces[f];
        int first = he.size();
        for (std::size_t k = 0; k < face.size(); ++k) {
            bool last = k + 1 == face.size();
            int i = he.size();
            he.push_back({face[k], f, last ? first : i + 1, -1});
            face_of[{face[k], last ? face[0] : face[k + 1]}] = f;
        }
    }
    std::map<std::pair<int, int>, int> between;
    for (int i = 0; i < he.size(); ++i)
        between[{he[i].fi, face_of.at({he[he[i].next].vi, he[i].vi})}] = i;
    for (int i = 0; i < he.size(); ++i) {
        int across = face_of.at({he[he[i].next].vi, he[i].vi});
        he[i].opp = between.at({across, he[i].fi});
    }
    return he;
}
