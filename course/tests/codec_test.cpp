// The codec: what is written comes back, and bytes of a hostile process end in
// CodecError and never in a large allocation.
#include "course/runner/codec.h"

#include <cstdlib>
#include <limits>
#include <new>
#include <random>

#include "course/mesh/zoo.h"
#include "course/runner/catch2.h"
#include "course/runner/results.h"

namespace {

std::size_t largest_allocation = 0;

}  // namespace

// Every allocation of this program is watched: a count in hostile bytes must
// not become one. Not inlined: g++ would pair new with free and complain.
[[gnu::noinline]] void* operator new(std::size_t size) {
    largest_allocation = std::max(largest_allocation, size);
    void* const memory = std::malloc(size);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace {

using namespace course;

enum class Colour : std::uint8_t { red, green };

struct Small {
    int a = 0;
    bool b = false;
    std::vector<int> c;

    friend bool operator==(const Small&, const Small&) = default;
};

struct Eight {
    int a = 1, b = 2, c = 3, d = 4, e = 5, f = 6, g = 7;
    std::optional<std::string> h;

    friend bool operator==(const Eight&, const Eight&) = default;
};

/// Whether the value comes back, and no shorter or longer bytes are taken for
/// one of its type.
template <class T>
void check_exact(const T& value) {
    const std::string bytes = encode(value);
    CHECK((decode<T>(bytes) == value));
    CHECK_THROWS_AS(decode<T>(bytes + '\0'), CodecError);
    for (std::size_t n = 0; n < bytes.size(); ++n)
        CHECK_THROWS_AS(decode<T>(bytes.substr(0, n)), CodecError);
}

const IndexedMesh lens{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}},
                       {{0, 1, 2, 3}, {0, 3, 2}},
                       {{1, 4}}};

/// A count, and nothing after it.
std::string count_of(std::uint64_t n) {
    return encode(n);
}

/// Decodes hostile bytes; whatever it says, it may not take much memory.
template <class T>
bool decodes(const std::string& bytes) {
    largest_allocation = 0;
    bool accepted = true;
    try {
        (void)decode<T>(bytes);
    } catch (const CodecError&) {
        accepted = false;
    }
    // Growing by doubling, and room for the text of the exception.
    CHECK(largest_allocation <= 512 + 2 * sizeof(T) * (bytes.size() + 1));
    return accepted;
}

template <class T>
void check_huge_counts() {
    for (const std::uint64_t n :
         {std::uint64_t{1}, std::uint64_t{1} << 20, std::uint64_t{1} << 32,
          (std::uint64_t{1} << 61) + 1, std::uint64_t{1} << 62,
          (std::uint64_t{1} << 63) + 1,
          std::numeric_limits<std::uint64_t>::max()}) {
        CAPTURE(n);
        CHECK_FALSE(decodes<T>(count_of(n)));
    }
}

std::string random_bytes(std::mt19937_64& random) {
    std::string bytes(random() % 65, '\0');
    // Small numbers in most of them, so that counts are often believed.
    const bool small = random() % 4 != 0;
    for (char& byte : bytes)
        byte = static_cast<char>(small ? random() % 8 / 6 : random() % 256);
    return bytes;
}

}  // namespace

TEST_CASE("plain values come back, and only from bytes of their length") {
    check_exact(0);
    check_exact(std::numeric_limits<int>::min());
    check_exact(std::numeric_limits<std::int64_t>::max());
    check_exact(std::uint8_t{255});
    check_exact(-0.5);
    check_exact(Colour::green);
    check_exact(HalfEdge{1, -1, 3, 4});
}

TEST_CASE("a double that is no number keeps its bits") {
    const std::string bytes = encode(std::numeric_limits<double>::quiet_NaN());
    CHECK(encode(decode<double>(bytes)) == bytes);
}

TEST_CASE("bools, texts and lists come back") {
    check_exact(true);
    check_exact(false);
    check_exact(std::string());
    check_exact(std::string("with \0 inside", 13));
    check_exact(std::vector<int>{});
    check_exact(std::vector<int>{1, -2, 3});
    check_exact(std::vector<bool>{true, false, true});
    check_exact(std::vector<std::string>{"", "a", "bc"});
    check_exact(std::vector<std::vector<int>>{{}, {1}, {2, 3}});
    check_exact(std::array<int, 3>{1, 2, 3});
}

TEST_CASE("optional values, maps and structs come back") {
    check_exact(std::optional<int>());
    check_exact(std::optional<int>(7));
    check_exact(std::optional<std::vector<int>>({1, 2}));
    check_exact(std::map<int, int>{});
    check_exact(std::map<int, std::string>{{-1, "a"}, {2, "b"}});
    check_exact(std::map<std::string, std::vector<int>>{{"", {}}, {"x", {1}}});
    check_exact(Small{1, true, {2, 3}});
    check_exact(Eight{});
    check_exact(Eight{1, 2, 3, 4, 5, 6, 7, "eight"});
    check_exact(std::vector<Small>{{}, {1, true, {1}}});
}

TEST_CASE("a table comes back row by row") {
    check_exact(HalfEdgeTable());
    check_exact(zoo::slide().he);
}

TEST_CASE("the result of a case comes back") {
    CaseResult result;
    result.info = {"a name", 2.5, Visibility::shown};
    result.verdict = Verdict::run_time_error;
    result.failures.push_back(
        {"f(1)", "2", "3", "note", {"mesh", {{}}, {{}}}, {{1, 2}}, 9});
    const std::string bytes = encode(result);
    const auto back = decode<CaseResult>(bytes);
    CHECK(encode(back) == bytes);
    CHECK(back.info.name == "a name");
    CHECK(back.failures.at(0).walk.at(0).line == 2);
    for (std::size_t n = 0; n < bytes.size(); ++n)
        CHECK_THROWS_AS(decode<CaseResult>(bytes.substr(0, n)), CodecError);
}

TEST_CASE("a count larger than the data is refused before memory is taken") {
    check_huge_counts<std::string>();
    check_huge_counts<std::vector<char>>();
    check_huge_counts<std::vector<int>>();
    check_huge_counts<std::vector<bool>>();
    check_huge_counts<std::vector<HalfEdge>>();
    check_huge_counts<std::vector<std::string>>();
    check_huge_counts<std::vector<std::vector<int>>>();
    check_huge_counts<std::vector<std::optional<int>>>();
    check_huge_counts<std::vector<Eight>>();
    check_huge_counts<std::map<int, int>>();
    check_huge_counts<HalfEdgeTable>();
}

TEST_CASE("a count is one of elements, not of bytes") {
    const std::string bytes = count_of(1000) + std::string(1000, '\0');
    largest_allocation = 0;
    CHECK_THROWS_AS(decode<std::vector<HalfEdge>>(bytes), CodecError);
    CHECK_THROWS_AS(decode<std::vector<int>>(bytes), CodecError);
    CHECK(largest_allocation < 1000);
}

TEST_CASE("a bool is 0 or 1 wherever it stands") {
    for (int byte = 2; byte < 256; ++byte) {
        const std::string bad(1, static_cast<char>(byte));
        CHECK_THROWS_AS(decode<bool>(bad), CodecError);
        CHECK_THROWS_AS(decode<std::vector<bool>>(count_of(1) + bad),
                        CodecError);
        CHECK_THROWS_AS(decode<std::optional<int>>(bad + encode(1)),
                        CodecError);
        CHECK_THROWS_AS(decode<Small>(encode(1) + bad + count_of(0)),
                        CodecError);
    }
}

TEST_CASE("the keys of a map ascend, each once") {
    using Map = std::map<int, int>;
    const auto pairs = [](int a, int b) {
        return count_of(2) + encode(a) + encode(0) + encode(b) + encode(0);
    };
    CHECK((decode<Map>(pairs(1, 2)) == Map{{1, 0}, {2, 0}}));
    CHECK_THROWS_AS(decode<Map>(pairs(2, 1)), CodecError);
    CHECK_THROWS_AS(decode<Map>(pairs(1, 1)), CodecError);
}

TEST_CASE("bytes left over are refused in an empty value, too") {
    CHECK_THROWS_AS(decode<std::vector<int>>(count_of(0) + "x"), CodecError);
    CHECK_THROWS_AS(decode<std::string>(count_of(1) + "ab"), CodecError);
    CHECK_THROWS_AS(decode<std::optional<int>>(std::string("\0x", 2)),
                    CodecError);
}

TEST_CASE("random bytes decode exactly or are refused, in little memory") {
    std::mt19937_64 random(20'240'101);
    int accepted = 0;
    for (int k = 0; k < 2000; ++k) {
        const std::string bytes = random_bytes(random);
        accepted += decodes<std::vector<int>>(bytes);
        accepted += decodes<std::vector<std::vector<int>>>(bytes);
        accepted += decodes<std::map<int, std::string>>(bytes);
        accepted += decodes<std::vector<bool>>(bytes);
        accepted += decodes<std::optional<std::vector<std::string>>>(bytes);
        accepted += decodes<std::vector<Small>>(bytes);
        accepted += decodes<Eight>(bytes);
        accepted += decodes<HalfEdgeTable>(bytes);
        accepted += decodes<CaseResult>(bytes);
    }
    CHECK(accepted > 0);  // else the bytes ask nothing
}

TEST_CASE("a mesh comes back, and a span as a vector") {
    check_exact(lens);
    check_exact(IndexedMesh{});
    const std::span<const Vec3> points(lens.positions);
    CHECK(decode<std::vector<Vec3>>(encode(points)) == lens.positions);
}

TEST_CASE("faces and corners that do not fit together are refused") {
    using Sides = std::vector<std::uint32_t>;
    const auto faces = [](const Sides& sides, const std::vector<int>& corners) {
        return decodes<FaceList>(encode(sides) + encode(corners));
    };
    CHECK(faces({3}, {0, 1, 2}));
    CHECK_FALSE(faces({4}, {0, 1, 2}));
    CHECK_FALSE(faces({2}, {0, 1, 2}));
    CHECK_FALSE(faces({0xffffffff, 4}, {0, 1, 2}));
    check_huge_counts<FaceList>();
    check_huge_counts<IndexedMesh>();
}
