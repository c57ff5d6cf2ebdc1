// Values to bytes and back, for the pipes between judge, worker and grader.
// Every byte that is read may come from a hostile process: a length is believed
// only if that many elements can still follow, and decoding is exact.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "course/halfedge/half_edge_table.h"
#include "course/mesh/indexed_mesh.h"
#include "course/runner/limits.h"

namespace course {

/// Thrown when bytes do not decode to what was expected.
struct CodecError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Appends values to a buffer, in the byte order of the host: both ends are
/// processes of one machine.
struct Writer {
    std::string bytes;

    void raw(const void* data, std::size_t size) {
        if (size > 0) bytes.append(static_cast<const char*>(data), size);
    }
};

/// Takes values from a buffer that it does not own.
class Reader {
public:
    explicit Reader(std::string_view bytes) : bytes_(bytes) {}

    std::size_t left() const { return bytes_.size(); }

    void raw(void* data, std::size_t size) {
        const std::string_view taken = take(size);
        if (size > 0) std::memcpy(data, taken.data(), size);
    }

    /// The next `size` bytes, as a view of the buffer.
    std::string_view take(std::size_t size) {
        if (size > left()) throw CodecError("the data is cut short");
        const std::string_view taken = bytes_.substr(0, size);
        bytes_.remove_prefix(size);
        return taken;
    }

    /// A count of elements of at least `unit` bytes each.
    std::size_t count(std::size_t unit) {
        std::uint64_t n = 0;
        raw(&n, sizeof n);
        if (n > left() / unit)
            throw CodecError("a length is larger than the data");
        return static_cast<std::size_t>(n);
    }

    void done() const {
        if (left() > 0) throw CodecError("the data has trailing bytes");
    }

private:
    std::string_view bytes_;
};

/// How a type is written and read. `smallest` is its least size in bytes.
template <class T>
struct Codec;

template <class T>
void put(Writer& out, const T& value) {
    Codec<T>::put(out, value);
}

template <class T>
T get(Reader& in) {
    return Codec<T>::get(in);
}

/// All of `bytes` as one value. Throws CodecError.
template <class T>
T decode(std::string_view bytes) {
    Reader in(bytes);
    T value = get<T>(in);
    in.done();
    return value;
}

template <class T>
std::string encode(const T& value) {
    Writer out;
    put(out, value);
    return std::move(out.bytes);
}

/// Copied as they lie in memory: no padding, every bit pattern is a value.
template <class T>
concept Plain = (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) ||
                std::is_enum_v<T> || std::is_same_v<T, HalfEdge> ||
                std::is_same_v<T, Vec3> || std::is_same_v<T, Limits>;

template <Plain T>
struct Codec<T> {
    static constexpr std::size_t smallest = sizeof(T);

    static void put(Writer& out, const T& v) { out.raw(&v, sizeof v); }
    static T get(Reader& in) {
        T v;
        in.raw(&v, sizeof v);
        return v;
    }
};

template <>
struct Codec<bool> {
    static constexpr std::size_t smallest = 1;

    static void put(Writer& out, bool v) {
        const char byte = v ? 1 : 0;
        out.raw(&byte, 1);
    }
    static bool get(Reader& in) {
        unsigned char byte = 0;
        in.raw(&byte, 1);
        if (byte > 1) throw CodecError("a bool is neither 0 nor 1");
        return byte == 1;
    }
};

template <>
struct Codec<std::string> {
    static constexpr std::size_t smallest = 8;

    static void put(Writer& out, const std::string& v) {
        course::put(out, std::uint64_t{v.size()});
        out.raw(v.data(), v.size());
    }
    static std::string get(Reader& in) {
        const std::size_t n = in.count(1);
        return std::string(in.take(n));
    }
};

template <class T>
struct Codec<std::vector<T>> {
    static constexpr std::size_t smallest = 8;

    static void put(Writer& out, const std::vector<T>& v) {
        course::put(out, std::uint64_t{v.size()});
        if constexpr (Plain<T>)
            out.raw(v.data(), v.size() * sizeof(T));
        else
            for (const T& x : v) course::put(out, x);
    }
    static std::vector<T> get(Reader& in) {
        const std::size_t n = in.count(Codec<T>::smallest);
        std::vector<T> v;
        if constexpr (Plain<T>) {
            v.resize(n);
            in.raw(v.data(), n * sizeof(T));
        } else {
            for (std::size_t k = 0; k < n; ++k) v.push_back(course::get<T>(in));
        }
        return v;
    }
};

template <>
struct Codec<std::vector<bool>> {
    static constexpr std::size_t smallest = 8;

    static void put(Writer& out, const std::vector<bool>& v) {
        course::put(out, std::uint64_t{v.size()});
        for (const bool x : v) course::put(out, x);
    }
    static std::vector<bool> get(Reader& in) {
        std::vector<bool> v(in.count(1));
        for (std::size_t k = 0; k < v.size(); ++k) v[k] = course::get<bool>(in);
        return v;
    }
};

/// Written as the vector of the same elements, and read as one.
template <class T>
struct Codec<std::span<const T>> {
    static void put(Writer& out, std::span<const T> v) {
        course::put(out, std::vector<T>(v.begin(), v.end()));
    }
};

template <class T, std::size_t N>
struct Codec<std::array<T, N>> {
    static constexpr std::size_t smallest = N * Codec<T>::smallest;

    static void put(Writer& out, const std::array<T, N>& v) {
        for (const T& x : v) course::put(out, x);
    }
    static std::array<T, N> get(Reader& in) {
        std::array<T, N> v;
        for (T& x : v) x = course::get<T>(in);
        return v;
    }
};

template <class T>
struct Codec<std::optional<T>> {
    static constexpr std::size_t smallest = 1;

    static void put(Writer& out, const std::optional<T>& v) {
        course::put(out, v.has_value());
        if (v) course::put(out, *v);
    }
    static std::optional<T> get(Reader& in) {
        if (!course::get<bool>(in)) return std::nullopt;
        return course::get<T>(in);
    }
};

/// Keys must come in ascending order, each once, as a map is written.
template <class K, class V>
struct Codec<std::map<K, V>> {
    static constexpr std::size_t smallest = 8;

    static void put(Writer& out, const std::map<K, V>& v) {
        course::put(out, std::uint64_t{v.size()});
        for (const auto& [key, value] : v) {
            course::put(out, key);
            course::put(out, value);
        }
    }
    static std::map<K, V> get(Reader& in) {
        const std::size_t n = in.count(Codec<K>::smallest + Codec<V>::smallest);
        std::map<K, V> v;
        for (std::size_t k = 0; k < n; ++k) {
            K key = course::get<K>(in);
            if (!v.empty() && !(v.rbegin()->first < key))
                throw CodecError("the keys of a map are not ascending");
            V value = course::get<V>(in);
            v.emplace_hint(v.end(), std::move(key), std::move(value));
        }
        return v;
    }
};

template <>
struct Codec<HalfEdgeTable> {
    static constexpr std::size_t smallest = 8;

    static void put(Writer& out, const HalfEdgeTable& v) {
        course::put(out, v.rows());
    }
    static HalfEdgeTable get(Reader& in) {
        return HalfEdgeTable(course::get<std::vector<HalfEdge>>(in));
    }
};

/// How many corners each face has, then the corners of all faces.
template <>
struct Codec<FaceList> {
    static constexpr std::size_t smallest = 16;

    static void put(Writer& out, const FaceList& v) {
        std::vector<std::uint32_t> sides;
        for (const FaceList::Face face : v)
            sides.push_back(static_cast<std::uint32_t>(face.size()));
        course::put(out, sides);
        course::put(out, v.corners());
    }
    static FaceList get(Reader& in) {
        const auto sides = course::get<std::vector<std::uint32_t>>(in);
        const auto corners = course::get<std::vector<int>>(in);
        FaceList v;
        v.reserve(sides.size(), corners.size());
        std::span<const int> left(corners);
        for (const std::uint32_t n : sides) {
            if (n > left.size())
                throw CodecError("faces have more corners than there are");
            v.push_back(left.first(n));
            left = left.subspan(n);
        }
        if (!left.empty())
            throw CodecError("there are more corners than faces have");
        return v;
    }
};

// ---- structs: written field by field, so that no exercise needs code for its
// own result type

namespace detail {

struct Anything {
    template <class T>
    operator T() const;  // NOLINT(google-explicit-constructor)
};

/// A struct of N fields can be initialised with N values and not with N + 1.
template <class T, class... Field>
constexpr std::size_t field_count() {
    if constexpr (requires { T{Field()..., Anything()}; })
        return field_count<T, Field..., Anything>();
    else
        return sizeof...(Field);
}

/// The fields as a tuple of references; structs of at most eight fields.
template <class T>
auto fields(T& v) {
    constexpr std::size_t n = field_count<std::remove_const_t<T>>();
    static_assert(n >= 1 && n <= 8, "a struct of one to eight fields");
    if constexpr (n == 1) {
        auto& [a] = v;
        return std::tie(a);
    } else if constexpr (n == 2) {
        auto& [a, b] = v;
        return std::tie(a, b);
    } else if constexpr (n == 3) {
        auto& [a, b, c] = v;
        return std::tie(a, b, c);
    } else if constexpr (n == 4) {
        auto& [a, b, c, d] = v;
        return std::tie(a, b, c, d);
    } else if constexpr (n == 5) {
        auto& [a, b, c, d, e] = v;
        return std::tie(a, b, c, d, e);
    } else if constexpr (n == 6) {
        auto& [a, b, c, d, e, f] = v;
        return std::tie(a, b, c, d, e, f);
    } else if constexpr (n == 7) {
        auto& [a, b, c, d, e, f, g] = v;
        return std::tie(a, b, c, d, e, f, g);
    } else {
        auto& [a, b, c, d, e, f, g, h] = v;
        return std::tie(a, b, c, d, e, f, g, h);
    }
}

}  // namespace detail

template <class T>
concept Struct = std::is_class_v<T> && std::is_aggregate_v<T> && !Plain<T> &&
                 !requires(T value) {
    value.begin();
};

template <Struct T>
struct Codec<T> {
    static constexpr std::size_t smallest = 1;

    static void put(Writer& out, const T& v) {
        std::apply(
            [&](const auto&... field) { (course::put(out, field), ...); },
            detail::fields(v));
    }
    static T get(Reader& in) {
        T v;
        std::apply(
            [&](auto&... field) {
                ((field = course::get<std::remove_reference_t<decltype(field)>>(
                      in)),
                 ...);
            },
            detail::fields(v));
        return v;
    }
};

}  // namespace course
