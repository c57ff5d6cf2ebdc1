// Compares each face with the one before it in the list.
// Hint: You compare only faces that follow each other in the list.
#include "exercises/04_topology/is_consistently_oriented.h"

#include <algorithm>

bool is_consistently_oriented(const IndexedMesh& mesh) {
    for (int f = 1; f < mesh.faces.size(); ++f) {
        FaceList::Face a = mesh.faces[f - 1], b = mesh.faces[f];
        for (std::size_t j = 0; j < a.size(); ++j)
            for (std::size_t k = 0; k < b.size(); ++k)
                if (a[j] == b[k] &&
                    a[(j + 1) % a.size()] == b[(k + 1) % b.size()])
                    return false;
    }
    return true;
}
