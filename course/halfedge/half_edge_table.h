// The half-edge table that every exercise walks on: the record, and the
// subscript in its three builds. Every submission includes it: no header that
// takes long to compile belongs here (<string> alone would double that time).
#pragma once

#include <cstdint>
#include <initializer_list>
#include <utility>
#include <vector>

// COURSE_TABLE chooses the build of the subscript; the student's source is the
// same in all three.
//   0  plain    vector access, nothing else: benchmarks
//   1  checked  range check, read budget, the last reads with their lines
//   2  traced   as checked, and each read and write is recorded for replay
#ifndef COURSE_TABLE
#define COURSE_TABLE 1
#endif

#if COURSE_TABLE == 0
#define COURSE_TABLE_NAMESPACE plain_table
#elif COURSE_TABLE == 1
#define COURSE_TABLE_NAMESPACE checked_table
#else
#define COURSE_TABLE_NAMESPACE traced_table
// What a function takes to know from which place of the source it is called,
// and that place. With COURSE_TABLE_SILENT nothing of what the file does is
// recorded: for functions that the traced file only calls.
#ifdef COURSE_TABLE_SILENT
#define COURSE_HERE std::int64_t place_of_caller = -1
#define COURSE_PLACE place_of_caller
#elif defined(__clang__) || !__has_include(<source_location>)
#define COURSE_HERE                       \
    std::int64_t line = __builtin_LINE(), \
                 std::int64_t column = __builtin_COLUMN()
#define COURSE_PLACE (line * 4096 + (column < 4095 ? column : 4095))
#else
#include <source_location>
#define COURSE_HERE std::source_location at = std::source_location::current()
#define COURSE_PLACE \
    (std::int64_t{at.line()} * 4096 + (at.column() < 4095 ? at.column() : 4095))
#endif
#endif

// Inline where the compiler optimises. A submission, which it does not, calls
// code that was compiled with it: the check would be slow in it, and what the
// others need of <vector> would cost each of them 25 ms to compile. Aligned to
// lines of the cache, as a call takes a sixth longer elsewhere.
#if defined(__OPTIMIZE__) || COURSE_TABLE != 1 || \
    defined(COURSE_DEFINE_HALF_EDGE_TABLE)
#define COURSE_TABLE_INLINE
#endif
#if defined(COURSE_TABLE_INLINE) && !defined(COURSE_DEFINE_HALF_EDGE_TABLE)
#define COURSE_SUBSCRIPT [[gnu::always_inline]]
#else
#define COURSE_SUBSCRIPT [[gnu::aligned(64)]]
#endif

// One namespace per build: objects of two builds never link by accident.
inline namespace COURSE_TABLE_NAMESPACE {

/// One row of the table: a half-edge, as on the slides. (Lecture "half-edge",
/// slide 166)
struct HalfEdge {
    int vi = -1;    ///< the vertex that it leaves
    int fi = -1;    ///< the face that it runs along; -1 on the border
    int next = -1;  ///< the half-edge after it, on the same face or border
    int opp = -1;   ///< the other half-edge of the same edge; never -1

    friend bool operator==(const HalfEdge&, const HalfEdge&) = default;
};

/// One use of the subscript: which row, and from which line of the source.
struct Visit {
    int i = -1;
    int line = 0;

    friend bool operator==(const Visit&, const Visit&) = default;
};

#if COURSE_TABLE == 0
using HalfEdgeIndex = int;
#elif COURSE_TABLE == 1
/// What he[...] takes: an int, and the line it is written on. Students never
/// name it. One word, with the line in its upper half: to hand over two makes
/// the subscript half as slow again where nothing is optimised.
struct HalfEdgeIndex {
    std::int64_t word;

    // NOLINTNEXTLINE(google-explicit-constructor): he[i] converts i to it
    [[gnu::always_inline]] constexpr HalfEdgeIndex(
        int index,
        std::int64_t line_above = std::int64_t{__builtin_LINE()} << 32)
        : word(line_above | static_cast<std::uint32_t>(index)) {}

    constexpr int i() const { return static_cast<int>(word); }
    constexpr int line() const { return static_cast<int>(word >> 32); }
    void forget_line() { word = static_cast<std::uint32_t>(word); }
};
#else
/// As in the checked build, with the column, and the function's stack frame.
struct HalfEdgeIndex {
    int index;
    std::int64_t place;  // line * 4096 + column; -1 silent
    const void* frame;

    // NOLINTNEXTLINE(google-explicit-constructor): he[i] converts i to it
    constexpr HalfEdgeIndex(int i, COURSE_HERE,
                            const void* at_frame = __builtin_frame_address(0))
        : index(i), place(COURSE_PLACE), frame(at_frame) {}

    constexpr int i() const { return index; }
    constexpr int line() const {
        return place < 0 ? 0 : static_cast<int>(place / 4096);
    }
    void forget_line() { place = 0; }
};
#endif

#if COURSE_TABLE == 2
/// A field of the table that changed: which, and from what to what.
struct Change {
    int i;
    int field;  ///< 0 vi, 1 fi, 2 next, 3 opp
    int before;
    int after;
};

/// One use of a table in the traced build, and the changes of that table that
/// were seen after it and before its next one. The first event of each table is
/// none that the source shows: it has the changes before all others.
struct TraceEvent {
    int i;  ///< -1 in the first event
    int line;
    int column;  ///< as the compiler gives it: at or inside the brackets
    std::vector<Change> changes;

    enum class Kind { begin, subscript, push_back };
    Kind kind = Kind::subscript;
    /// Which table: 0 is the one whose start_trace was called, others follow
    /// in the order in which they are first used. A copy is a table of its own.
    int table = 0;
    /// In the first event of a table: what it was before the changes.
    std::vector<HalfEdge> rows = {};
    /// Address of the stack frame of the function that does it, so that a
    /// debugger can tell of which call it is a part; 0 in the first event.
    std::uint64_t frame = 0;
};

/// What tells tables apart while they are copied and moved: a copy gets a
/// number of its own, a table that is moved keeps its number.
class TableNumber {
public:
    TableNumber() : n_(next()) {}
    TableNumber(const TableNumber&) : n_(next()) {}
    TableNumber(TableNumber&& other) noexcept
        : n_(std::exchange(other.n_, -1)) {}
    TableNumber& operator=(const TableNumber&) {
        n_ = next();
        return *this;
    }
    TableNumber& operator=(TableNumber&& other) noexcept {
        n_ = std::exchange(other.n_, -1);
        return *this;
    }
    ~TableNumber() = default;

    std::int64_t get() const { return n_; }

private:
    static std::int64_t next();

    std::int64_t n_;
};
#endif

/// The table `he`: he[i] is half-edge i, 0 <= i < he.size(). A class, not a
/// vector, for the sake of what the subscript checks; in use it is the same.
class HalfEdgeTable {
public:
    using value_type = HalfEdge;
    using iterator = HalfEdge*;
    using const_iterator = const HalfEdge*;

    HalfEdgeTable();
    HalfEdgeTable(std::initializer_list<HalfEdge> rows);
    explicit HalfEdgeTable(std::vector<HalfEdge> rows);
    HalfEdgeTable(const HalfEdgeTable&);
    HalfEdgeTable(HalfEdgeTable&&) noexcept;
    HalfEdgeTable& operator=(const HalfEdgeTable&);
    HalfEdgeTable& operator=(HalfEdgeTable&&) noexcept;
    ~HalfEdgeTable();

    /// Number of half-edges: twice the number of edges.
    int size() const;
    bool empty() const;

    /// Adds a row; its index is the size before.
#if COURSE_TABLE == 2
    void push_back(const HalfEdge& row, COURSE_HERE,
                   const void* frame = __builtin_frame_address(0)) {
        append(row, COURSE_PLACE, frame);
    }
#else
    void push_back(const HalfEdge& row);
#endif

    /// Row i. Constant time.
    /// Throws OutOfTable when there is no such row, TooManyReads when the
    /// budget of the call is used up (table_errors.h); the plain build checks
    /// nothing.
    COURSE_SUBSCRIPT const HalfEdge& operator[](HalfEdgeIndex i) const;
    COURSE_SUBSCRIPT HalfEdge& operator[](HalfEdgeIndex i);

    /// All rows in order; counts as reading each of them.
    iterator begin();
    iterator end();
    const_iterator begin() const;
    const_iterator end() const;

    friend bool operator==(const HalfEdgeTable& a, const HalfEdgeTable& b) {
        return a.has_rows_of(b);
    }

    // ---- for the course's own code: what a call read, and how much it may

    /// The rows, unchecked and uncounted.
    const std::vector<HalfEdge>& rows() const {
        return rows_;
    }

#if COURSE_TABLE != 0
    /// Reads that a call may make when nothing else is said: enough for any
    /// honest walk, and used up by an endless one in milliseconds.
    std::int64_t default_budget() const {
        return 100'000 + 64 * std::int64_t{size()};
    }

    /// What a table may be read while nobody watches: still ends an endless
    /// walk, in a second.
    static constexpr std::int64_t unwatched = std::int64_t{1} << 28;

    /// Starts a call: forgets all reads, allows `budget` new ones. `start` is
    /// the half-edge that the call is given, or -1; messages name it.
    void begin_call(std::int64_t budget, int start = -1) const {
        allow(budget);
        budget_ = reads_left();
        start_ = start;
        exact_ = budget != default_budget();
    }

    /// Reads since begin_call, and how many more are allowed.
    std::int64_t reads() const {
        return budget_ - reads_left();
    }
    std::int64_t reads_left() const {
        return later_ + slot_;
    }

    /// The last reads, at most 64, oldest first.
    std::vector<Visit> last_visits() const;

    /// The same into `to`, room for `last_visits_size`; returns how many. Safe
    /// in a signal handler.
    static constexpr int last_visits_size = 64;
    int copy_last_visits(Visit* to) const;

    /// Takes over the reads that the same call made on a copy of this table in
    /// another process.
    void note_reads(std::int64_t reads, const std::vector<Visit>& last) const;
#endif

#if COURSE_TABLE == 2
    /// Starts recording what is done with this table, and with those that are
    /// made from now on: the first `most` events. What was recorded is lost.
    void start_trace(std::size_t most = ~std::size_t{0}) const;

    /// Ends it; the events in the order of time.
    std::vector<TraceEvent> stop_trace() const;

    /// How many events there are since start_trace, also those not kept.
    static const std::size_t& trace_size();
#endif

private:
    bool has_rows_of(const HalfEdgeTable& other) const;

    std::vector<HalfEdge> rows_;

#if COURSE_TABLE == 0
    [[gnu::always_inline]] const HalfEdge* row(int i) const {
        return rows_.data() + static_cast<std::size_t>(i);
    }
    void charge() const {}
    static void lend(int) {}
    static void lend_all() {}
};
#else
    static constexpr int ring_size = last_visits_size;

    // Mutable: reading through a const table is what is counted.
    mutable std::int64_t budget_ = unwatched;
    // Reads left: until the ring is full, and a multiple of its size after
    // that, so that one test serves for both. Of another type than what is
    // written to the ring: a loop keeps them in registers.
    mutable long long slot_ = 0;
    mutable long long later_ = unwatched;
    mutable int start_ = -1;
    mutable bool exact_ = false;            // the exercise fixed the budget
    mutable std::int64_t ring_[ring_size];  // as the word of HalfEdgeIndex

    [[gnu::always_inline]] const HalfEdge* row(HalfEdgeIndex at) const {
        const std::uint64_t i = static_cast<std::uint32_t>(at.i());
        if (i >= rows_.size()) [[unlikely]]
            fail(at);
        long long slot = slot_;
        if (slot == 0) [[unlikely]] {
            if (later_ == 0) fail(at);
            later_ -= ring_size;
            slot = ring_size;
        }
        slot_ = slot - 1;
        note(at);
        return rows_.data() + i;
    }
    void allow(std::int64_t reads) const {
        reads = reads > 0 ? reads : 0;
        slot_ = reads % ring_size;
        later_ = reads - slot_;
    }
    void charge() const;
    [[noreturn]] void fail(HalfEdgeIndex at) const;

#if COURSE_TABLE == 1
    void note(HalfEdgeIndex at) const {
        ring_[slot_] = at.word;
    }
    static void lend(HalfEdgeIndex) {}
    static void lend_all() {}
};
#else
    void note(HalfEdgeIndex at) const;
    void append(const HalfEdge& row, std::int64_t place, const void* frame);
    void lend(HalfEdgeIndex i) const;
    void lend_all() const;
    bool is_recorded() const;
    void note_changes() const;
    void note_all_changes() const;
    void note_changes_of(int i) const;
    void begin_events() const;
    void add_event(TraceEvent::Kind kind, int i, std::int64_t place,
                   const void* frame) const;

    TableNumber number_;
    mutable std::vector<HalfEdge> shadow_;  // the rows at the last event
    mutable std::size_t last_event_ = 0;    // of this table
    // Rows that may be written to: to look at all of them at each event would
    // make a trace quadratic.
    mutable std::vector<int> lent_;
    mutable std::vector<bool> is_lent_;
};
#endif
#endif

#ifdef COURSE_TABLE_INLINE
#ifdef COURSE_DEFINE_HALF_EDGE_TABLE
#define COURSE_INLINE
#else
#define COURSE_INLINE inline
#endif

COURSE_INLINE HalfEdgeTable::HalfEdgeTable() = default;
COURSE_INLINE HalfEdgeTable::HalfEdgeTable(const HalfEdgeTable&) = default;
COURSE_INLINE HalfEdgeTable::HalfEdgeTable(HalfEdgeTable&&) noexcept = default;
COURSE_INLINE HalfEdgeTable& HalfEdgeTable::operator=(const HalfEdgeTable&) =
    default;
COURSE_INLINE HalfEdgeTable& HalfEdgeTable::operator=(
    HalfEdgeTable&&) noexcept = default;
#if COURSE_TABLE == 2
COURSE_INLINE HalfEdgeTable::~HalfEdgeTable() {
    note_all_changes();
}
#else
COURSE_INLINE HalfEdgeTable::~HalfEdgeTable() = default;
#endif

COURSE_INLINE HalfEdgeTable::HalfEdgeTable(std::initializer_list<HalfEdge> rows)
    : rows_(rows) {}
COURSE_INLINE HalfEdgeTable::HalfEdgeTable(std::vector<HalfEdge> rows)
    : rows_(std::move(rows)) {}
COURSE_INLINE const HalfEdge& HalfEdgeTable::operator[](HalfEdgeIndex i) const {
    return *row(i);
}
COURSE_INLINE HalfEdge& HalfEdgeTable::operator[](HalfEdgeIndex i) {
    auto* const row_i = const_cast<HalfEdge*>(row(i));
    lend(i);
    return *row_i;
}
COURSE_INLINE int HalfEdgeTable::size() const {
    return static_cast<int>(rows_.size());
}
COURSE_INLINE bool HalfEdgeTable::empty() const {
    return rows_.empty();
}
#if COURSE_TABLE != 2
COURSE_INLINE void HalfEdgeTable::push_back(const HalfEdge& row) {
    rows_.push_back(row);
}
#endif
COURSE_INLINE HalfEdgeTable::iterator HalfEdgeTable::begin() {
    charge();
    lend_all();
    return rows_.data();
}
COURSE_INLINE HalfEdgeTable::iterator HalfEdgeTable::end() {
    lend_all();
    return rows_.data() + rows_.size();
}
COURSE_INLINE HalfEdgeTable::const_iterator HalfEdgeTable::begin() const {
    charge();
    return rows_.data();
}
COURSE_INLINE HalfEdgeTable::const_iterator HalfEdgeTable::end() const {
    return rows_.data() + rows_.size();
}
COURSE_INLINE bool HalfEdgeTable::has_rows_of(
    const HalfEdgeTable& other) const {
    return rows_ == other.rows_;
}
#undef COURSE_INLINE
#endif
#undef COURSE_SUBSCRIPT
#undef COURSE_TABLE_INLINE

}  // namespace COURSE_TABLE_NAMESPACE
