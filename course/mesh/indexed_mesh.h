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

    FaceList() = default;
    FaceList(std::initializer_list<std::initializer_list<int>> faces) {
        for (const auto& face : faces) push_back(face);
    }

    int size() const { return static_cast<int>(end_.size()); }
    bool empty() const { return size() == 0; }
    Face operator[](int f) const {
        const auto i = static_cast<std::size_t>(f);
        const std::size_t begin = i == 0 ? 0 : end_[i - 1];
        return Face(corners_).subspan(begin, end_[i] - begin);
    }
    void push_back(Face corners) {
        corners_.insert(corners_.end(), corners.begin(), corners.end());
        end_.push_back(corners_.size());
    }
    void push_back(std::initializer_list<int> corners) {
        push_back(Face(corners.begin(), corners.size()));
    }
    void reserve(std::size_t faces, std::size_t corners) {
        end_.reserve(faces);
        corners_.reserve(corners);
    }
    /// Corners of all faces, one after the other.
    const std::vector<int>& corners() const { return corners_; }

    Iterator begin() const { return {this, 0}; }
    Iterator end() const { return {this, size()}; }

    friend bool operator==(const FaceList&, const FaceList&) = default;

private:
    std::vector<std::size_t> end_;  // where each face ends in corners_
    std::vector<int> corners_;
};

/// Vertices 0 <= v < positions.size(); faces name them by index.
/// `loose_edges` belong to no face (the lecture's dangling edges).
struct IndexedMesh {
    std::vector<Vec3> positions;
    FaceList faces;
    std::vector<std::array<int, 2>> loose_edges;

    int vertex_count() const { return static_cast<int>(positions.size()); }

    friend bool operator==(const IndexedMesh&, const IndexedMesh&) = default;
};
