// The indexed mesh: positions once, faces as lists of vertex indices. The
// other one of the lecture's two representations. (Slides 157-158, 169)
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <vector>

#include "course/mesh/vec3.h"

/// Faces of any number of sides, their corners in one array:
/// faces[f] is a span of vertex indices, counter-clockwise.
class FaceList {
public:
    using Face = std::span<const int>;

    class Iterator {
    public:
        using value_type = Face;
        using difference_type = std::ptrdiff_t;

        Iterator() = default;
        Iterator(const FaceList* list, int face) : list_(list), face_(face) {}
        Face operator*() const { return (*list_)[face_]; }
        Iterator& operator++() { return ++face_, *this; }
        Iterator operator++(int) { return Iterator(list_, face_++); }
        friend bool operator==(const Iterator&, const Iterator&) = default;

    private:
        const FaceList* list_ = nullptr;
        int face_ = 0;
    };

    FaceList();
    FaceList(std::initializer_list<std::initializer_list<int>> faces);
    FaceList(const FaceList&);
    FaceList(FaceList&&) noexcept;
    FaceList& operator=(const FaceList&);
    FaceList& operator=(FaceList&&) noexcept;
    ~FaceList();

    int size() const;
    bool empty() const;
    Face operator[](int f) const;
    void push_back(Face corners);
    void push_back(std::initializer_list<int> corners);
    void reserve(std::size_t faces, std::size_t corners);
    /// Corners of all faces, one after the other.
    const std::vector<int>& corners() const { return corners_; }
    /// For each face, where its corners end among those of all.
    const std::vector<std::size_t>& ends() const { return end_; }

    Iterator begin() const { return {this, 0}; }
    Iterator end() const { return {this, size()}; }

    friend bool operator==(const FaceList& a, const FaceList& b) {
        return a.equals(b);
    }

private:
    bool equals(const FaceList& other) const;

    std::vector<std::size_t> end_;
    std::vector<int> corners_;
};

/// Vertices 0 <= v < positions.size(); faces name them by index.
/// `loose_edges` belong to no face (the lecture's dangling edges).
struct IndexedMesh {
    std::vector<Vec3> positions;
    FaceList faces;
    std::vector<std::array<int, 2>> loose_edges;

    int vertex_count() const { return static_cast<int>(positions.size()); }

    friend bool operator==(const IndexedMesh& a, const IndexedMesh& b);
};

// Inline where the compiler optimises. A submission, which it does not, calls
// code that was compiled with it: what these need of <vector> would cost each
// of them 40 ms to compile.
#if defined(__OPTIMIZE__) || defined(COURSE_DEFINE_INDEXED_MESH)
#ifdef COURSE_DEFINE_INDEXED_MESH
#define COURSE_INLINE
#else
#define COURSE_INLINE inline
#endif

COURSE_INLINE FaceList::FaceList() = default;
COURSE_INLINE FaceList::FaceList(const FaceList&) = default;
COURSE_INLINE FaceList::FaceList(FaceList&&) noexcept = default;
COURSE_INLINE FaceList& FaceList::operator=(const FaceList&) = default;
COURSE_INLINE FaceList& FaceList::operator=(FaceList&&) noexcept = default;
COURSE_INLINE FaceList::~FaceList() = default;

COURSE_INLINE FaceList::FaceList(
    std::initializer_list<std::initializer_list<int>> faces) {
    for (const auto& face : faces) push_back(face);
}
COURSE_INLINE int FaceList::size() const {
    return static_cast<int>(end_.size());
}
COURSE_INLINE bool FaceList::empty() const {
    return end_.empty();
}
COURSE_INLINE FaceList::Face FaceList::operator[](int f) const {
    const auto i = static_cast<std::size_t>(f);
    const std::size_t begin = i == 0 ? 0 : end_[i - 1];
    return Face(corners_).subspan(begin, end_[i] - begin);
}
COURSE_INLINE void FaceList::push_back(Face corners) {
    corners_.insert(corners_.end(), corners.begin(), corners.end());
    end_.push_back(corners_.size());
}
COURSE_INLINE void FaceList::push_back(std::initializer_list<int> corners) {
    push_back(Face(corners.begin(), corners.size()));
}
COURSE_INLINE void FaceList::reserve(std::size_t faces, std::size_t corners) {
    end_.reserve(faces);
    corners_.reserve(corners);
}
COURSE_INLINE bool FaceList::equals(const FaceList& other) const {
    return end_ == other.end_ && corners_ == other.corners_;
}
COURSE_INLINE bool operator==(const IndexedMesh& a, const IndexedMesh& b) {
    return a.positions == b.positions && a.faces == b.faces &&
           a.loose_edges == b.loose_edges;
}
#undef COURSE_INLINE
#endif
