// What may be wrong with the faces of a mesh: the vocabulary of the exercise
// that asks for it.
#pragma once

/// What may be wrong with the faces of a mesh, and which `elements` are named
/// with it.
enum class MeshFault {
    too_few_corners,     ///< {face}: it has less than three corners
    index_out_of_range,  ///< {face, corner}: no vertex of the mesh stands
                         ///< there; corners count from 0, each has its own
                         ///< defect
    repeated_vertex,  ///< {face, number}: this number, whether it is a vertex
                      ///< of the mesh or not, stands at two or more of the
                      ///< corners; one defect for each such number
    too_many_faces,   ///< {a, b, faces...}: the edge of vertices a < b is a
                      ///< side of these faces, three or more, ascending
    wound_alike,      ///< {a, b, f, g}: exactly the faces f < g have the edge
                      ///< of vertices a < b, and both run along it from a to
                      ///< b, or both from b to a
    duplicate_faces,  ///< {faces...}: all the faces, two or more, ascending,
                      ///< that have the same corners in the same cyclic
                      ///< order; the other way round is another face
    several_fans,     ///< {vertex}: the faces at it do not form one fan: from
                      ///< one of them one cannot come to every other, going
                      ///< from face to face across edges that end there
};

/// Writes the name of the fault to a std::ostream. A template, so that
/// students' files need not include one.
template <class Stream>
Stream& operator<<(Stream& out, MeshFault fault) {
    constexpr const char* names[] = {"too_few_corners", "index_out_of_range",
                                     "repeated_vertex", "too_many_faces",
                                     "wound_alike",     "duplicate_faces",
                                     "several_fans"};
    const int k = static_cast<int>(fault);
    out << (0 <= k && k < 7 ? names[k] : "no MeshFault");
    return out;
}
