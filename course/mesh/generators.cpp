// Regular and random meshes of any size.
#include "course/mesh/generators.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <numeric>
#include <random>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "course/halfedge/build.h"

namespace course {

namespace {

void require_range(const char* what, int value, int least, int most) {
    if (value < least || value > most)
        throw std::invalid_argument(
            fmt::format("{} is {}, expected {}..{}", what, value, least, most));
}

std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

/// Enough cells for any machine, and no product of two sizes overflows.
constexpr int most_cells = 50'000'000;

void require_cells(const char* what, int nu, int nv, int least) {
    require_range(what, nu, least, most_cells / least);
    require_range(what, nv, least, most_cells / nu);
}

void push_cell(FaceList& faces, Cells cells, int a, int b, int c, int d) {
    if (cells == Cells::quads) {
        faces.push_back({a, b, c, d});
    } else {
        faces.push_back({a, b, c});
        faces.push_back({a, c, d});
    }
}

// ---- the sphere

IndexedMesh icosahedron() {
    const double g = (1 + std::sqrt(5.0)) / 2;  // the golden ratio
    return {{{0, -1, -g},
             {0, 1, -g},
             {0, -1, g},
             {0, 1, g},
             {-1, -g, 0},
             {1, -g, 0},
             {-1, g, 0},
             {1, g, 0},
             {-g, 0, -1},
             {-g, 0, 1},
             {g, 0, -1},
             {g, 0, 1}},
            {{0, 1, 10},  {1, 0, 8},   {2, 3, 9},  {3, 2, 11}, {4, 5, 2},
             {5, 4, 0},   {6, 7, 1},   {7, 6, 3},  {8, 9, 6},  {9, 8, 4},
             {10, 11, 5}, {11, 10, 7}, {0, 4, 8},  {0, 10, 5}, {1, 8, 6},
             {1, 7, 10},  {2, 9, 4},   {2, 5, 11}, {3, 6, 9},  {3, 11, 7}},
            {}};
}

/// The vertices in the middle of edges, made when first asked for.
class Midpoints {
public:
    explicit Midpoints(std::vector<Vec3>& positions) : positions_(positions) {}

    int operator()(int a, int b) {
        const auto [low, high] = std::minmax(a, b);
        const auto key = static_cast<std::uint64_t>(low) << 32 |
                         static_cast<std::uint64_t>(high);
        const auto [at, fresh] =
            made_.try_emplace(key, static_cast<int>(positions_.size()));
        if (fresh)
            positions_.push_back(0.5 *
                                 (positions_[index(a)] + positions_[index(b)]));
        return at->second;
    }

private:
    std::vector<Vec3>& positions_;
    std::unordered_map<std::uint64_t, int> made_;
};

void to_unit_length(std::vector<Vec3>& positions) {
    for (Vec3& p : positions) p = (1 / length(p)) * p;
}

FaceList cut_into_four(const FaceList& faces, std::vector<Vec3>& positions) {
    Midpoints middle(positions);
    FaceList cut;
    for (const auto& face : faces) {
        const int a = face[0];
        const int b = face[1];
        const int c = face[2];
        const int ab = middle(a, b);
        const int bc = middle(b, c);
        const int ca = middle(c, a);
        cut.push_back({a, ab, ca});
        cut.push_back({b, bc, ab});
        cut.push_back({c, ca, bc});
        cut.push_back({ab, bc, ca});
    }
    return cut;
}

// ---- random meshes

/// The generator is the standard's, bit for bit the same everywhere; the
/// standard's distributions are not, so the reduction is written here.
class Random {
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    /// 0 <= below(n) < n.
    int below(int n) {
        return static_cast<int>(
            (engine_() >> 32) * static_cast<std::uint64_t>(n) >> 32);
    }

    /// A multiple of 1/256 in -1/8 <= x < 1/8: no grid cell turns over.
    double jitter() { return (below(64) - 32) / 256.0; }

    void shuffle(std::vector<int>& items) {
        for (int n = static_cast<int>(items.size()); n > 1; --n)
            std::swap(items[index(n - 1)], items[index(below(n))]);
    }

private:
    std::mt19937_64 engine_;
};

/// A mesh whose faces are joined and taken out. Half-edges of the border, and
/// of edges that are gone, lose their meaning but for `fi`.
class Reworked {
public:
    Reworked(IndexedMesh base, Random& random)
        : rows_(build(base).rows()),
          positions_(std::move(base.positions)),
          on_border_(positions_.size(), false),
          seen_by_(positions_.size(), -1),
          corner_(index(base.faces.size()), -1),
          sides_(index(base.faces.size()), 0),
          random_(random) {
        for (int i = 0; index(i) < rows_.size(); ++i) {
            const HalfEdge& row = rows_[index(i)];
            if (row.fi == -1) {
                on_border_[index(row.vi)] = true;
                closed_ = false;
            } else {
                corner_[index(row.fi)] = i;
                ++sides_[index(row.fi)];
            }
        }
    }

    bool is_closed() const { return closed_; }

    void merge_faces(int percent, int max_sides) {
        std::vector<int> edges;
        for (int i = 0; index(i) < rows_.size(); ++i)
            if (i < rows_[index(i)].opp) edges.push_back(i);
        for (const int i : some_of(std::move(edges), percent, 0))
            if (can_merge(i, max_sides)) merge(i);
    }

    void take_out_faces(int percent, int at_least, BowTies bow_ties) {
        std::vector<int> faces;
        for (int f = 0; index(f) < corner_.size(); ++f)
            if (corner_[index(f)] != -1) faces.push_back(f);
        int left = static_cast<int>(faces.size());
        for (const int f : some_of(std::move(faces), percent, at_least)) {
            if (left == 1) return;  // no part vanishes
            if (bow_ties == BowTies::none && would_make_bow_tie(f)) continue;
            take_out(f);
            --left;
        }
    }

    /// Appends what is left to `mesh`, with x from `left` on; returns the
    /// largest x.
    double append_to(IndexedMesh& mesh, double left, Unused unused) const {
        const auto by_x = [](Vec3 a, Vec3 b) { return a.x < b.x; };
        const auto [min, max] =
            std::minmax_element(positions_.begin(), positions_.end(), by_x);
        const Vec3 shift{left - min->x, 0, 0};
        std::vector<int> number = kept(unused);
        for (std::size_t v = 0; v < number.size(); ++v) {
            if (number[v] == -1) continue;
            number[v] = mesh.vertex_count();
            mesh.positions.push_back(positions_[v] + shift);
        }
        append_faces(mesh.faces, number);
        return max->x + shift.x;
    }

private:
    const HalfEdge& row(int i) const { return rows_[index(i)]; }

    /// Per vertex 0 if it stays, else -1.
    std::vector<int> kept(Unused unused) const {
        if (unused == Unused::kept)
            return std::vector<int>(positions_.size(), 0);
        std::vector<int> number(positions_.size(), -1);
        for (const int first : corner_)
            if (first != -1)
                for_each_half_edge(
                    first, [&](int i) { number[index(row(i).vi)] = 0; });
        return number;
    }

    void append_faces(FaceList& faces, const std::vector<int>& number) const {
        std::vector<int> corners;
        for (const int first : corner_) {
            if (first == -1) continue;
            corners.clear();
            for_each_half_edge(first, [&](int i) {
                corners.push_back(number[index(row(i).vi)]);
            });
            faces.push_back(corners);
        }
    }

    template <class Visit>
    void for_each_half_edge(int first, Visit visit) const {
        int i = first;
        do {
            visit(i);
            i = row(i).next;
        } while (i != first);
    }

    std::vector<int> some_of(std::vector<int> items, int percent,
                             int at_least) {
        random_.shuffle(items);
        const auto share =
            static_cast<int>(items.size() * index(percent) / 100);
        items.resize(index(std::max(share, at_least)));
        return items;
    }

    int previous(int i) const {
        int before = i;
        for_each_half_edge(i, [&](int j) { before = j; });
        return before;
    }

    /// One face instead of two is a polygon only when they have nothing in
    /// common but the ends of the edge between them.
    bool can_merge(int i, int max_sides) {
        const int opp = row(i).opp;
        const int f = row(i).fi;
        const int g = row(opp).fi;
        if (f == -1 || g == -1 || f == g) return false;
        if (sides_[index(f)] + sides_[index(g)] - 2 > max_sides) return false;
        for_each_half_edge(i, [&](int j) { seen_by_[index(row(j).vi)] = i; });
        int common = 0;
        for_each_half_edge(
            opp, [&](int j) { common += seen_by_[index(row(j).vi)] == i; });
        return common == 2;
    }

    void merge(int i) {
        const int opp = row(i).opp;
        const int f = row(i).fi;
        const int g = row(opp).fi;
        const int before_i = previous(i);
        const int before_opp = previous(opp);
        rows_[index(before_i)].next = row(opp).next;
        rows_[index(before_opp)].next = row(i).next;
        for_each_half_edge(before_i, [&](int j) { rows_[index(j)].fi = f; });
        corner_[index(f)] = before_i;
        corner_[index(g)] = -1;
        sides_[index(f)] += sides_[index(g)] - 2;
    }

    /// It would where the border passes already, but not along a side of f.
    bool would_make_bow_tie(int f) const {
        int before = previous(corner_[index(f)]);
        bool would = false;
        for_each_half_edge(corner_[index(f)], [&](int i) {
            const bool beside_border =
                row(row(i).opp).fi == -1 || row(row(before).opp).fi == -1;
            if (on_border_[index(row(i).vi)] && !beside_border) would = true;
            before = i;
        });
        return would;
    }

    void take_out(int f) {
        for_each_half_edge(corner_[index(f)], [&](int i) {
            rows_[index(i)].fi = -1;
            on_border_[index(row(i).vi)] = true;
        });
        corner_[index(f)] = -1;
    }

    std::vector<HalfEdge> rows_;
    std::vector<Vec3> positions_;
    std::vector<bool> on_border_;
    std::vector<int> seen_by_;  // per vertex: the edge that last looked at it
    std::vector<int> corner_;   // per face: one of its half-edges; -1 if gone
    std::vector<int> sides_;    // per face
    bool closed_ = true;
    Random& random_;
};

/// Two factors, neither below `least`, whose product is about n.
std::pair<int, int> sides_of(int n, int least, Random& random) {
    const auto root = static_cast<int>(std::sqrt(n));
    const int a = std::max(least, root / 2 + random.below(root + 1));
    return {a, std::max(least, n / a)};
}

IndexedMesh random_plane(int faces, Random& random) {
    const Cells cells = random.below(2) == 0 ? Cells::quads : Cells::triangles;
    const int n = cells == Cells::quads ? faces : (faces + 1) / 2;
    const auto [nx, ny] = sides_of(n, 1, random);
    IndexedMesh mesh = grid(nx, ny, cells);
    for (Vec3& p : mesh.positions)
        p = p + Vec3{random.jitter(), random.jitter(), 0};
    return mesh;
}

IndexedMesh random_closed(int faces, Random& random) {
    if (faces >= 20 && random.below(2) == 0) {
        int levels = 0;
        while (faces / 4 >= 20 << 2 * levels) ++levels;
        return icosphere(levels);
    }
    const Cells cells = random.below(2) == 0 ? Cells::quads : Cells::triangles;
    const int n = cells == Cells::quads ? faces : faces / 2;
    const auto [nu, nv] = sides_of(n, 3, random);
    return torus(nu, nv, cells);
}

Reworked random_part(int faces, const RandomMesh& options, Random& random) {
    const bool flat = options.surface == Surface::plane;
    const bool open =
        flat || options.surface == Surface::open ||
        (options.surface == Surface::mixed && random.below(2) == 0);
    Reworked part(open && (flat || random.below(2) == 0)
                      ? random_plane(faces, random)
                      : random_closed(faces, random),
                  random);
    part.merge_faces(options.merge_percent, options.max_sides);
    if (open)
        part.take_out_faces(options.hole_percent, part.is_closed() ? 1 : 0,
                            options.bow_ties);
    return part;
}

}  // namespace

IndexedMesh icosphere(int levels) {
    require_range("levels of an icosphere", levels, 0, 10);
    IndexedMesh mesh = icosahedron();
    to_unit_length(mesh.positions);
    for (int level = 0; level < levels; ++level) {
        mesh.faces = cut_into_four(mesh.faces, mesh.positions);
        to_unit_length(mesh.positions);
    }
    return mesh;
}

IndexedMesh torus(int nu, int nv, Cells cells) {
    require_cells("cells round a torus", nu, nv, 3);
    const auto vertex = [&](int i, int j) { return i % nu * nv + j % nv; };
    IndexedMesh mesh;
    for (int i = 0; i < nu; ++i)
        for (int j = 0; j < nv; ++j) {
            const double u = 2 * std::numbers::pi * i / nu;
            const double v = 2 * std::numbers::pi * j / nv;
            const double r = 2 + std::cos(v);
            mesh.positions.push_back(
                {r * std::cos(u), r * std::sin(u), std::sin(v)});
            push_cell(mesh.faces, cells, vertex(i, j), vertex(i + 1, j),
                      vertex(i + 1, j + 1), vertex(i, j + 1));
        }
    return mesh;
}

IndexedMesh grid(int nx, int ny, Cells cells) {
    require_cells("cells along a grid", nx, ny, 1);
    const auto vertex = [&](int x, int y) { return y * (nx + 1) + x; };
    IndexedMesh mesh;
    for (int y = 0; y <= ny; ++y)
        for (int x = 0; x <= nx; ++x)
            mesh.positions.push_back(
                {static_cast<double>(x), static_cast<double>(y)});
    for (int y = 0; y < ny; ++y)
        for (int x = 0; x < nx; ++x)
            push_cell(mesh.faces, cells, vertex(x, y), vertex(x + 1, y),
                      vertex(x + 1, y + 1), vertex(x, y + 1));
    return mesh;
}

IndexedMesh random_polygons(std::uint64_t seed, const RandomMesh& options) {
    require_range("faces", options.faces, 1, most_cells);
    require_range("parts", options.parts, 1, options.faces);
    require_range("max_sides", options.max_sides, 4, most_cells);
    require_range("merge_percent", options.merge_percent, 0, 100);
    require_range("hole_percent", options.hole_percent, 0, 100);
    Random random(seed);
    IndexedMesh mesh;
    double left = 0;
    for (int k = 0; k < options.parts; ++k) {
        const Reworked part =
            random_part(options.faces / options.parts, options, random);
        left = part.append_to(mesh, left, options.unused) + 1;
    }
    return mesh;
}

}  // namespace course
