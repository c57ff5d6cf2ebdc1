// Compares all pairs of faces: right, and quadratic.
// Hint: Your answers are right, but the larger the mesh is, the longer you
// search at every step.
#include "exercises/04_topology/is_consistently_oriented.h"

bool is_consistently_oriented(const IndexedMesh& mesh) {
    for (int f = 0; f < mesh.faces.size(); ++f)
        for (int g = 0; g < f; ++g) {
            FaceList::Face a = mesh.faces[f], b = mesh.faces[g];
            for (std::size_t j = 0; j < a.size(); ++j)
                for (std::size_t k = 0; k < b.size(); ++k)
                    if (a[j] == b[k] &&
                        a[(j + 1) % a.size()] == b[(k + 1) % b.size()])
                        return false;
        }
    return true;
}
