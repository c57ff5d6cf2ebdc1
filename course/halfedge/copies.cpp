#include "course/halfedge/copies.h"

#include <numeric>
#include <utility>

namespace course {

namespace {

/// x with a x = 1 mod n. (Extended Euclid)
std::uint64_t inverse(std::uint64_t a, std::uint64_t n) {
    std::int64_t x = 0, next_x = 1;
    auto r = static_cast<std::int64_t>(n),
         next_r = static_cast<std::int64_t>(a);
    while (next_r != 0) {
        const std::int64_t q = r / next_r;
        x = std::exchange(next_x, x - q * next_x);
        r = std::exchange(next_r, r - q * next_r);
    }
    return static_cast<std::uint64_t>(x < 0 ? x + static_cast<std::int64_t>(n)
                                            : x);
}

/// Numbers of one kind in all copies, by a sum: that of copy 0 and what copy c
/// adds to it.
class Sums {
public:
    Sums(std::int32_t of_each, const Copies& copies)
        : numbers_(of_each, copies), size_(static_cast<int>(numbers_.size())) {
        if (of_each == 0) return;
        const int first = numbers_(0, 0);
        for (int c = 0; c < copies.count; ++c)
            added_.push_back((numbers_(0, c) - first + size_) % size_);
    }

    const MixedNumbers& numbers() const { return numbers_; }
    int in_first(int k) const { return numbers_(k, 0); }
    int in_copy(int in_first, std::size_t c) const {
        if (in_first == -1) return -1;
        const int number = in_first + added_[c];
        return number >= size_ ? number - size_ : number;
    }

private:
    MixedNumbers numbers_;
    int size_;
    std::vector<int> added_;
};

std::vector<HalfEdge> first_copy(const Copies& copies, const Sums& half_edges,
                                 const Sums& vertices, const Sums& faces) {
    std::vector<HalfEdge> rows;
    for (const HalfEdge& row : copies.tile)
        rows.push_back({vertices.in_first(row.vi), faces.in_first(row.fi),
                        half_edges.in_first(row.next),
                        half_edges.in_first(row.opp)});
    return rows;
}

}  // namespace

MixedNumbers::MixedNumbers(std::int32_t of_each, const Copies& copies)
    : count_(static_cast<std::uint64_t>(copies.count)),
      size_(count_ * static_cast<std::uint64_t>(of_each)),
      factor_(0),
      shift_(0) {
    if (size_ == 0) return;
    // Near the golden section neighbours come to lie far apart.
    factor_ = (size_ * 618 / 1000 + copies.seed % 1000) % size_;
    while (std::gcd(factor_, size_) != 1) ++factor_;
    factor_ %= size_;
    shift_ = copies.seed % size_;
}

int MixedNumbers::operator()(int k, int c) const {
    if (k == -1) return -1;
    const std::uint64_t plain =
        static_cast<std::uint64_t>(k) * count_ + static_cast<std::uint64_t>(c);
    return static_cast<int>((factor_ * plain + shift_) % size_);
}

std::uint64_t MixedNumbers::step() const {
    return inverse(factor_, size_) % size_;
}

std::uint64_t MixedNumbers::first() const {
    return step() * (size_ - shift_) % size_;
}

HalfEdgeTable table_of(const Copies& copies) {
    if (copies.tile.empty() || copies.count == 0) return {};
    const Sums half_edges(static_cast<int>(copies.tile.size()), copies);
    const Sums vertices(copies.vertices, copies), faces(copies.faces, copies);
    const std::vector<HalfEdge> tile =
        first_copy(copies, half_edges, vertices, faces);
    const std::uint64_t size = half_edges.numbers().size();
    std::vector<HalfEdge> rows;
    rows.reserve(size);
    // In the order of the rows: written once, one after the other.
    std::uint64_t plain = half_edges.numbers().first();
    const std::uint64_t step = half_edges.numbers().step();
    const auto count = static_cast<std::uint32_t>(copies.count);
    while (rows.size() < size) {
        const auto at = static_cast<std::uint32_t>(plain);
        const HalfEdge& row = tile[at / count];
        const std::size_t c = at % count;
        rows.push_back({vertices.in_copy(row.vi, c), faces.in_copy(row.fi, c),
                        half_edges.in_copy(row.next, c),
                        half_edges.in_copy(row.opp, c)});
        plain += step;
        if (plain >= size) plain -= size;
    }
    return HalfEdgeTable(std::move(rows));
}

}  // namespace course
