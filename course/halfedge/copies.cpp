#include "course/halfedge/copies.h"

#include <map>
#include <numeric>
#include <utility>

#include "course/halfedge/large_pages.h"

namespace course {

MixedNumbers::Mix::Mix(std::int64_t n, std::uint64_t seed) : size(n) {
    if (size == 0) return;
    // Near the golden section neighbours come to lie far apart.
    factor = (size * 618 / 1000 + static_cast<std::int64_t>(seed % 997)) % size;
    while (std::gcd(factor, size) != 1) ++factor;
    shift = static_cast<std::int64_t>(seed % static_cast<std::uint64_t>(size));
}

MixedNumbers::MixedNumbers(std::int32_t of_each, const Copies& copies)
    : places_(of_each, copies.seed), slots_(copies.count, copies.seed) {}

int MixedNumbers::operator()(int k, int c) const {
    return k == -1 ? -1 : block(k) + static_cast<int>(slots_.of(c));
}

int MixedNumbers::block(int k) const {
    return k == -1 ? -1 : static_cast<int>(places_.of(k) * slots_.size);
}

HalfEdgeTable table_of(const Copies& copies) {
    const std::vector<HalfEdge>& tile = copies.tile;
    const MixedNumbers half_edges(static_cast<int>(tile.size()), copies);
    const MixedNumbers vertices(copies.vertices, copies);
    const MixedNumbers faces(copies.faces, copies);
    std::map<int, HalfEdge> blocks;  // in the order of the rows
    for (std::size_t i = 0; i < tile.size(); ++i)
        blocks[half_edges.block(static_cast<int>(i))] = {
            vertices.block(tile[i].vi), faces.block(tile[i].fi),
            half_edges.block(tile[i].next), half_edges.block(tile[i].opp)};
    std::vector<HalfEdge> rows;
    rows.reserve(half_edges.size());
    prefer_large_pages(rows.data(), half_edges.size() * sizeof(HalfEdge));
    for (const auto& [begin, first] : blocks) {
        const int border = first.fi == -1 ? 0 : 1;
        for (int slot = 0; slot < copies.count; ++slot)
            rows.push_back({first.vi + slot, first.fi + border * slot,
                            first.next + slot, first.opp + slot});
    }
    return HalfEdgeTable(std::move(rows));
}

}  // namespace course
