// The three kinds of edge, told apart by the faces beside them.
#pragma once

/// The kind of an edge. (Lecture "half-edge", slides 156 and 181)
enum class EdgeKind {
    interior,  ///< a face on both sides, even if it is the same face
    border,    ///< a face on one side, none on the other
    dangling,  ///< no face on either side
};

/// Writes the name of the kind to a std::ostream. A template, so that students'
/// files need not include one.
template <class Stream>
Stream& operator<<(Stream& out, EdgeKind kind) {
    constexpr const char* names[] = {"interior", "border", "dangling"};
    const int k = static_cast<int>(kind);
    out << (0 <= k && k < 3 ? names[k] : "no EdgeKind");
    return out;
}
