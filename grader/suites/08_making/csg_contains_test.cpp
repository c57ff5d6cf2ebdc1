// Hidden suite of csg_contains.
#include "exercises/08_making/csg_contains.h"

#include <cmath>
#include <functional>
#include <random>

#include "course/runner/suite.h"

using namespace course;

namespace {

using Nodes = std::vector<CsgNode>;

CsgNode ball(Vec3 centre, double radius) {
    return {CsgKind::ball, -1, -1, centre, {radius, 0, 0}};
}
CsgNode box(Vec3 corner, Vec3 edges) {
    return {CsgKind::box, -1, -1, corner, edges};
}
CsgNode cylinder(Vec3 foot, double radius, double height) {
    return {CsgKind::cylinder, -1, -1, foot, {radius, 0, height}};
}
CsgNode operation(CsgKind kind, int left, int right) {
    return {kind, left, right, {}, {}};
}

/// Asks for each point, and compares with a formula.
void check(const Nodes& nodes, int root, const std::vector<Vec3>& where,
           const std::function<bool(Vec3)>& expected) {
    for (const Vec3 p : where) {
        INFO("the point " << show(p));
        REQUIRE(csg_contains(nodes, root, p) == expected(p));
    }
}

double square(double x) {
    return x * x;
}

/// Whether p is in a primitive, from its middle.
bool in_primitive(const CsgNode& node, Vec3 p) {
    const Vec3 d = p - node.at, s = node.size;
    const bool in_layer = std::fabs(d.z - s.z / 2) <= s.z / 2;
    if (node.kind == CsgKind::cylinder)
        return square(d.x) + square(d.y) <= square(s.x) && in_layer;
    if (node.kind == CsgKind::box)
        return std::fabs(d.x - s.x / 2) <= s.x / 2 &&
               std::fabs(d.y - s.y / 2) <= s.y / 2 && in_layer;
    return square(d.x) + square(d.y) + square(d.z) <= square(s.x);
}

class Random {
public:
    explicit Random(std::uint64_t salt) : next_(seed() * 1000 + salt) {}
    int below(int n) {
        return static_cast<int>(next_() % static_cast<std::uint64_t>(n));
    }
    double between(double a, double b) {
        return a + (b - a) * static_cast<double>(next_() >> 11) / 0x1p53;
    }
    /// Points all over a box; hardly ever on a surface.
    std::vector<Vec3> points(int n, Vec3 low, Vec3 high) {
        std::vector<Vec3> list;
        for (int k = 0; k < n; ++k) {
            const double x = between(low.x, high.x);
            const double y = between(low.y, high.y);
            list.push_back({x, y, between(low.z, high.z)});
        }
        return list;
    }
    /// Points in and round a primitive.
    std::vector<Vec3> points_near(const CsgNode& node, int n) {
        const Vec3 margin = {0.7, 0.7, 0.7};
        const double r = node.size.x;
        Vec3 low = node.at, high = node.at + node.size;
        if (node.kind != CsgKind::box) low = low - Vec3{r, r, 0};
        if (node.kind == CsgKind::cylinder) high.y += r;
        if (node.kind == CsgKind::ball) {
            low.z -= r;
            high = node.at + Vec3{r, r, r};
        }
        return points(n, low - margin, high + margin);
    }
    /// Eighths that are no fourths.
    Vec3 point() {
        return {below(20) / 4.0 + 0.125, below(20) / 4.0 + 0.125,
                below(20) / 4.0 + 0.125};
    }
    CsgNode primitive() {
        const Vec3 at = {1.0 * below(5), 1.0 * below(5), 1.0 * below(5)};
        const double r = 0.8 + 0.5 * below(4);  // its square is no 64th
        switch (below(3)) {
            case 0:
                return ball(at, r);
            case 1:
                return box(at,
                           {1.0 + below(3), 1.0 + below(3), 1.0 + below(3)});
            default:
                return cylinder(at, r, 1.0 + below(3));
        }
    }

private:
    std::mt19937_64 next_;
};

/// A tree, and for each node whether it contains each of some points, found
/// from the leaves upwards.
struct Solved {
    Nodes nodes;
    std::vector<std::vector<bool>> answers;
    std::vector<Vec3> asked;
    int root = 0;
};

std::vector<bool> combined(CsgKind kind, const std::vector<bool>& a,
                           const std::vector<bool>& b) {
    std::vector<bool> both(a.size());
    for (std::size_t k = 0; k < a.size(); ++k)
        both[k] = kind == CsgKind::union_of       ? a[k] + b[k] > 0
                  : kind == CsgKind::intersection ? a[k] + b[k] == 2
                                                  : a[k] > b[k];
    return both;
}

/// Nodes at mixed places, joined two by two until one is left.
Solved random_tree(Random& random, int leaves, int asked) {
    Solved tree;
    const auto size = static_cast<std::size_t>(2 * leaves - 1);
    tree.nodes.resize(size);
    tree.answers.resize(size);
    for (int k = 0; k < asked; ++k) tree.asked.push_back(random.point());
    std::vector<int> places(size), open;
    for (std::size_t k = 0; k < size; ++k) places[k] = static_cast<int>(k);
    const auto take = [&](std::vector<int>& list) {
        const int k = random.below(static_cast<int>(list.size()));
        const int value = list[static_cast<std::size_t>(k)];
        list.erase(list.begin() + k);
        return value;
    };
    for (int k = 0; k < leaves; ++k) {
        open.push_back(take(places));
        const auto at = static_cast<std::size_t>(open.back());
        tree.nodes[at] = random.primitive();
        for (const Vec3 p : tree.asked)
            tree.answers[at].push_back(in_primitive(tree.nodes[at], p));
    }
    while (open.size() > 1) {
        const int a = take(open), b = take(open);
        open.push_back(take(places));
        const auto at = static_cast<std::size_t>(open.back());
        const CsgKind kinds[] = {CsgKind::union_of, CsgKind::union_of,
                                 CsgKind::intersection, CsgKind::difference};
        tree.nodes[at] = operation(kinds[random.below(4)], a, b);
        tree.answers[at] = combined(tree.nodes[at].kind,
                                    tree.answers[static_cast<std::size_t>(a)],
                                    tree.answers[static_cast<std::size_t>(b)]);
    }
    tree.root = open.front();
    return tree;
}

}  // namespace

TEST_CASE("balls, boxes and cylinders", "[points:2]") {
    hint("What do `at` and `size` mean for this kind of primitive?");
    Random random(3);
    for (const CsgNode& node :
         {ball({1, 0.5, 2}, 1.6), ball({0, 0, 0}, 0.9), ball({2, 2, 2}, 3),
          box({0, 1, -1}, {2, 1, 3}), box({-1, -1, -1}, {1, 2, 4}),
          cylinder({1, 1, 0}, 1.5, 2), cylinder({0, 2, 1}, 0.8, 3),
          cylinder({2, 1, -1}, 2, 0.9)})
        check({node}, 0, random.points_near(node, 60),
              [&](Vec3 p) { return in_primitive(node, p); });
}

TEST_CASE("points on a surface", "[points:1]") {
    hint("Which of < and <= do you use, and what does a difference leave?");
    const Nodes nodes = {ball({1, 1, 1}, 5),
                         box({1, 2, 3}, {2, 3, 4}),
                         cylinder({0, 0, 1}, 5, 2),
                         ball({0, 0, 0}, 10),
                         operation(CsgKind::difference, 3, 0),
                         operation(CsgKind::difference, 3, 1),
                         operation(CsgKind::difference, 3, 2)};
    const std::vector<std::vector<Vec3>> on_surface = {
        {{4, 5, 1}, {1, -3, -2}, {6, 1, 1}, {1, 1, -4}},
        {{1, 2, 3},
         {3, 5, 7},
         {1, 3, 4},
         {3, 3, 4},
         {2, 2, 4},
         {2, 5, 4},
         {2, 3, 3},
         {2, 3, 7}},
        {{3, 4, 2}, {-5, 0, 1}, {0, 0, 1}, {1, 2, 3}, {4, -3, 3}}};
    for (int k = 0; k < 3; ++k)
        for (const Vec3 p : on_surface[static_cast<std::size_t>(k)]) {
            INFO("the point " << show(p));
            CHECK(csg_contains(nodes, k, p));
            CHECK(!csg_contains(nodes, 4 + k, p));
        }
}

TEST_CASE("one operation on two primitives", "[points:2]") {
    hint("Make a table: in A or not, in B or not, and the answer.");
    const CsgNode a = ball({1, 1, 1}, 1.7), b = box({1, 0, 0}, {2, 2, 2});
    Random random(4);
    const auto where = random.points(50, {-0.9, -0.9, -0.9}, {3.2, 2.9, 2.9});
    using Answer = bool (*)(bool, bool);
    const std::pair<CsgKind, Answer> operations[] = {
        {CsgKind::union_of, [](bool x, bool y) { return x || y; }},
        {CsgKind::intersection, [](bool x, bool y) { return x && y; }},
        {CsgKind::difference, [](bool x, bool y) { return x && !y; }}};
    for (const Vec3 p : where)
        for (const auto& [kind, answer] : operations) {
            const bool in_a = in_primitive(a, p), in_b = in_primitive(b, p);
            const Nodes a_b = {a, b, operation(kind, 0, 1)};
            const Nodes b_a = {b, a, operation(kind, 0, 1)};
            const Nodes behind = {operation(kind, 2, 1), b, a};
            INFO("the point " << show(p));
            REQUIRE(csg_contains(a_b, 2, p) == answer(in_a, in_b));
            REQUIRE(csg_contains(b_a, 2, p) == answer(in_b, in_a));
            REQUIRE(csg_contains(behind, 0, p) == answer(in_a, in_b));
        }
}

TEST_CASE("operations on operations", "[points:2]") {
    hint("Whom do you ask about a child that is an operation itself?");
    Random random(5);
    // A plate with a bore, and a knob on it.
    const Nodes nodes = {operation(CsgKind::union_of, 2, 4),
                         box({0, 0, 0}, {4, 4, 1}),
                         operation(CsgKind::difference, 1, 3),
                         cylinder({2, 2, -1}, 1.1, 3),
                         operation(CsgKind::intersection, 5, 6),
                         ball({0.5, 0.5, 1}, 0.9),
                         box({-1, -1, 1}, {3, 3, 3})};
    const auto in = [&](std::size_t k, Vec3 p) {
        return in_primitive(nodes[k], p);
    };
    check(nodes, 0, random.points(250, {-0.6, -0.6, -1.2}, {4.4, 4.4, 2.1}),
          [&](Vec3 p) {
              return (in(1, p) && !in(3, p)) || (in(5, p) && in(6, p));
          });
    // A minus (B minus C) is not (A minus B) minus C.
    const Nodes twice = {ball({1, 1, 1}, 2),
                         operation(CsgKind::difference, 3, 4),
                         operation(CsgKind::difference, 0, 1),
                         ball({1, 1, 1}, 1.5), ball({1, 1, 1}, 0.8)};
    check(twice, 2, random.points(150, {-1, -1, -1}, {3, 3, 3}), [&](Vec3 p) {
        const double far = length(p - Vec3{1, 1, 1});
        return far <= 0.8 || (far > 1.5 && far <= 2);
    });
}

TEST_CASE("any node may be the root", "[points:1]") {
    hint("Where do you begin: at the first node, the last one, or `root`?");
    Random random(1);
    const Solved tree = random_tree(random, 9, 25);
    for (std::size_t node = 0; node < tree.nodes.size(); ++node)
        for (std::size_t k = 0; k < tree.asked.size(); ++k) {
            INFO("the point " << show(tree.asked[k]));
            REQUIRE(csg_contains(tree.nodes, static_cast<int>(node),
                                 tree.asked[k]) == tree.answers[node][k]);
        }
}

TEST_CASE("random trees", "[points:2]") {
    hint("Evaluate this tree by hand, from its leaves upwards.");
    Random random(2);
    for (int n = 1; n <= 30; ++n) {
        const Solved tree = random_tree(random, n, 16);
        const auto root = static_cast<std::size_t>(tree.root);
        for (std::size_t k = 0; k < tree.asked.size(); ++k) {
            INFO("the point " << show(tree.asked[k]));
            REQUIRE(csg_contains(tree.nodes, tree.root, tree.asked[k]) ==
                    tree.answers[root][k]);
        }
    }
}

TEST_CASE("a tree of some thousand nodes", "[points:1]") {
    hint("What do you copy, or go through, once for each node?");
    // A row of balls, joined one by one.
    constexpr int n = 3000;
    for (const bool left : {true, false}) {
        Nodes nodes = {ball({0, 0, 0}, 0.4)};
        for (int k = 1; k < n; ++k) {
            const int before = k == 1 ? 0 : static_cast<int>(nodes.size()) - 1;
            const int one = static_cast<int>(nodes.size());
            nodes.push_back(ball({1.0 * k, 0, 0}, 0.4));
            nodes.push_back(left ? operation(CsgKind::union_of, before, one)
                                 : operation(CsgKind::union_of, one, before));
        }
        const int root = static_cast<int>(nodes.size()) - 1;
        for (const int k : {0, 1, n / 2, n - 2, n - 1}) {
            CHECK(csg_contains(nodes, root, {k + 0.3, 0.2, 0}));
            CHECK(!csg_contains(nodes, root, {k + 0.3, 0.4, 0}));
        }
    }
}
