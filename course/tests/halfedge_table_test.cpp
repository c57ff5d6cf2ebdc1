// What the checked subscript says when a walk leaves the table, or never ends.
#include "course/halfedge/half_edge_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "course/halfedge/table_errors.h"
#include "course/runner/catch2.h"

namespace {

// One triangle, 0-1-2, with its border.
HalfEdgeTable triangle() {
    return {{0, 0, 1, 3},  {1, 0, 2, 4},  {2, 0, 0, 5},
            {1, -1, 5, 0}, {2, -1, 3, 1}, {0, -1, 4, 2}};
}

/// The message of the exception that the call throws, and its line.
template <class Error, class Call>
std::string message_of(Call call) {
    try {
        call();
    } catch (const Error& error) {
        return error.what();
    }
    return "nothing was thrown";
}

std::string line(int number) {
    return fmt::format("line {}", number);
}

}  // namespace

TEST_CASE("an index below the table names its line and where it came from") {
    const HalfEdgeTable he = triangle();
    const int first = __LINE__ + 2;
    const auto walk = [&] {
        const int face = he[he[0].opp].fi;
        return he[face].vi;
    };
    CHECK(message_of<OutOfTable>(walk) ==
          line(first + 1) +
              ": he[-1] does not exist: the table has 6 half-edges, 0..5. -1 "
              "is the value of he[3].fi, read at " +
              line(first) +
              ": a face index of -1 means that the half-edge is on the border");
}

TEST_CASE("an index above the table is explained as one below it") {
    HalfEdgeTable he = triangle();
    const int read = __LINE__ + 2;
    const auto walk = [&] {
        he[1].next = 6;
        return he[he[1].next].vi;
    };
    CHECK(message_of<OutOfTable>(walk) ==
          line(read + 1) +
              ": he[6] does not exist: the table has 6 half-edges, 0..5. 6 is "
              "the value of he[1].next, read at " +
              line(read + 1));
}

TEST_CASE("a -1 in the table of an interior half-edge is not called a border") {
    HalfEdgeTable he = triangle();
    const int first = __LINE__ + 2;
    const auto walk = [&] {
        he[1].next = -1;
        const int after = he[1].next;
        return he[after].vi;
    };
    CHECK(message_of<OutOfTable>(walk) ==
          line(first + 2) +
              ": he[-1] does not exist: the table has 6 half-edges, 0..5. -1 "
              "is the value of he[1].next, read at " +
              line(first + 1));
}

TEST_CASE("an index that no field explains is asked for its value") {
    const HalfEdgeTable he = triangle();
    const auto walk = [&] { return he[0].vi + he[1000].vi; };
    const std::string message = message_of<OutOfTable>(walk);
    CHECK(message.find("he[1000] does not exist: the table has 6 half-edges, "
                       "0..5. 1000 is no value of the half-edges read last: "
                       "does the variable have a value yet?") !=
          std::string::npos);
}

TEST_CASE("a first read off the table has no history to be explained by") {
    const HalfEdgeTable he = triangle();
    const int here = __LINE__ + 1;
    const auto walk = [&] { return he[6].vi; };
    CHECK(message_of<OutOfTable>(walk) ==
          line(here) +
              ": he[6] does not exist: the table has 6 half-edges, 0..5");
}

TEST_CASE("an empty table says that it is empty") {
    const HalfEdgeTable he;
    const int here = __LINE__ + 1;
    const auto walk = [&] { return he[0].vi; };
    CHECK(message_of<OutOfTable>(walk) ==
          line(here) +
              ": he[0] does not exist: the table is empty, it has no "
              "half-edges");
}

TEST_CASE("writing off the table is caught as reading is") {
    HalfEdgeTable he = triangle();
    CHECK_THROWS_AS(he[-1].next = 3, OutOfTable);
    CHECK_THROWS_AS((he[6] = {1, 2, 3, 4}), OutOfTable);
    CHECK(he == triangle());
}

TEST_CASE("every row can be read, the first and the last included") {
    const HalfEdgeTable he = triangle();
    CHECK(he[0].vi == 0);
    CHECK(he[5].opp == 2);
}

TEST_CASE("an endless walk names its half-edges and the start it misses") {
    const HalfEdgeTable he = triangle();
    he.begin_call(1000, 3);
    const int here = __LINE__ + 4;
    const auto walk = [&] {
        int i = he[3].opp;  // the loop of the face does not hold 3
        do {
            i = he[i].next;
        } while (i != 3);
    };
    const std::string message = message_of<TooManyReads>(walk);
    CHECK(message.find(line(here) + ": the walk does not end: ") == 0);
    CHECK(message.find("he[0]") != std::string::npos);
    CHECK(message.find("he[1]") != std::string::npos);
    CHECK(message.find("he[2]") != std::string::npos);
    CHECK(message.find("he[4]") == std::string::npos);
    CHECK(message.find("are visited again and again (stopped after 1000 "
                       "reads); the start, he[3], is never met again") !=
          std::string::npos);
}

TEST_CASE("a walk that passes its start and goes on is told so") {
    const HalfEdgeTable he = triangle();
    he.begin_call(1000, 0);
    const auto walk = [&] {
        for (int i = 0; i != 3;) i = he[i].next;
    };
    CHECK(message_of<TooManyReads>(walk).find(
              "; it passes the start, he[0], but does not stop there") !=
          std::string::npos);
}

TEST_CASE("a walk that stands still names its one half-edge") {
    const HalfEdgeTable he = triangle();
    he.begin_call(1000);
    const auto walk = [&] {
        while (he[2].fi == 0) continue;
    };
    CHECK(message_of<TooManyReads>(walk).find(
              "the walk does not end: he[2] is visited again and again") !=
          std::string::npos);
}

TEST_CASE("a budget that the exercise fixes is explained by the exercise") {
    const HalfEdgeTable he = triangle();
    he.begin_call(4);
    const auto scan = [&] {
        int n = 0;
        for (int i = 0; i < he.size(); ++i) n += he[i].fi == -1;
        return n;
    };
    CHECK(message_of<TooManyReads>(scan).find(
              "more than 4 reads of the table: the exercise allows a fixed "
              "number for each step of the walk, however large the mesh is") !=
          std::string::npos);
}

TEST_CASE("a budget of n allows n reads and not one more") {
    // Around the size of the ring of last reads, too.
    const std::int64_t n = GENERATE(0, 1, 3, 63, 64, 65, 127, 128, 1000);
    const HalfEdgeTable he = triangle();
    he.begin_call(n);
    std::int64_t k = 0;
    CHECK_THROWS_AS(
        [&] {
            for (;; ++k) he[static_cast<int>(k % 6)];
        }(),
        TooManyReads);
    CHECK(k == n);
    CHECK(he.reads() == n);
    CHECK(he.reads_left() == 0);

    const std::vector<Visit> visits = he.last_visits();
    REQUIRE(static_cast<std::int64_t>(visits.size()) ==
            std::min<std::int64_t>(n, 64));
    for (const Visit& visit : visits) {
        const auto back = &visits.back() - &visit + 1;
        CHECK(visit.i == (n - back) % 6);
    }
}

TEST_CASE("no budget is taken for less than none") {
    const HalfEdgeTable he = triangle();
    he.begin_call(-5);
    CHECK(he.reads_left() == 0);
    CHECK_THROWS_AS(he[0], TooManyReads);
}

TEST_CASE("a new call forgets the reads of the one before") {
    const HalfEdgeTable he = triangle();
    he.begin_call(100);
    CHECK(he[0].vi + he[1].vi == 1);
    CHECK(he.reads() == 2);
    he.begin_call(100);
    CHECK(he.reads() == 0);
    CHECK(he.last_visits().empty());
}

TEST_CASE("a loop over the table counts as reading every row") {
    const HalfEdgeTable he = triangle();
    he.begin_call(100);
    int borders = 0;
    for (const HalfEdge& row : he) borders += row.fi == -1;
    CHECK(borders == 3);
    CHECK(he.reads() == 6);
}

TEST_CASE("the last reads are kept in order with their lines") {
    const HalfEdgeTable he = triangle();
    he.begin_call(1000);
    int i = 0;
    for (int k = 0; k < 100; ++k) i = he[i].next;
    const int here = __LINE__ - 1;
    const std::vector<Visit> visits = he.last_visits();
    REQUIRE(visits.size() == 64);
    for (int k = 0; k < 64; ++k)
        CHECK(visits[static_cast<std::size_t>(k)] == Visit{(36 + k) % 3, here});
}

TEST_CASE("a table that nobody watches still ends an endless walk") {
    const HalfEdgeTable he = triangle();
    const auto walk = [&] {
        for (int i = 0; i != 3;) i = he[i].next;
    };
    CHECK_THROWS_AS(walk(), TooManyReads);
}
