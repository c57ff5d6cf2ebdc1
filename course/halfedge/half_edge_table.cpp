// The parts of the subscript that stay out of the student's object file: the
// check without optimisation, the record of reads, the messages, and what it
// would compile anew.
#define COURSE_DEFINE_HALF_EDGE_TABLE
#include "course/halfedge/half_edge_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <tuple>

#include "course/halfedge/table_errors.h"

#if COURSE_TABLE != 0

inline namespace COURSE_TABLE_NAMESPACE {

static_assert(HalfEdgeTable::unwatched % HalfEdgeTable::last_visits_size == 0,
              "what is allowed beyond the ring is a multiple of its size");

namespace {

std::int64_t word_of(const Visit& visit) {
    return std::int64_t{visit.line} << 32 | static_cast<std::uint32_t>(visit.i);
}

Visit visit_of(std::int64_t word) {
    return {static_cast<int>(word), static_cast<int>(word >> 32)};
}

std::string at_line(int line) {
    return line > 0 ? fmt::format(" at line {}", line) : std::string();
}

std::string what_minus_one_means(const HalfEdge& row) {
    if (row.fi != -1) return "";
    return ": a face index of -1 means that the half-edge is on the border";
}

/// Which field of the last rows read holds the index `bad`: where it may come
/// from. Empty when none of them does.
std::string origin(const std::vector<HalfEdge>& rows, int bad,
                   const std::vector<Visit>& visits) {
    constexpr std::size_t look_back = 3;
    for (std::size_t k = 0; k < std::min(look_back, visits.size()); ++k) {
        const Visit& visit = visits[visits.size() - 1 - k];
        const HalfEdge& row = rows[static_cast<std::size_t>(visit.i)];
        std::vector<std::string> fields;
        if (row.vi == bad) fields.push_back(fmt::format("he[{}].vi", visit.i));
        if (row.fi == bad) fields.push_back(fmt::format("he[{}].fi", visit.i));
        if (row.next == bad)
            fields.push_back(fmt::format("he[{}].next", visit.i));
        if (row.opp == bad)
            fields.push_back(fmt::format("he[{}].opp", visit.i));
        if (fields.empty()) continue;
        return fmt::format(" {} is the value of {}, read{}{}", bad,
                           fmt::join(fields, " and "), at_line(visit.line),
                           bad == -1 ? what_minus_one_means(row) : "");
    }
    return fmt::format(
        " {} is no value of the half-edges read last: does the variable have "
        "a value yet?",
        bad);
}

std::string no_such_row(const std::vector<HalfEdge>& rows, int bad, int line,
                        const std::vector<Visit>& visits) {
    const std::string where = line > 0 ? fmt::format("line {}: ", line) : "";
    if (rows.empty())
        return fmt::format(
            "{}he[{}] does not exist: the table is empty, it has no half-edges",
            where, bad);
    std::string why;
    if (!visits.empty()) why = "." + origin(rows, bad, visits);
    return fmt::format(
        "{}he[{}] does not exist: the table has {} half-edges, 0..{}{}", where,
        bad, rows.size(), rows.size() - 1, why);
}

/// The shortest sequence of visits that the walk has repeated to the end.
std::vector<Visit> cycle(const std::vector<Visit>& visits) {
    const std::size_t n = visits.size();
    for (std::size_t period = 1; 2 * period <= n; ++period)
        if (std::equal(visits.begin() + static_cast<std::ptrdiff_t>(period),
                       visits.end(), visits.begin()))
            return {visits.end() - static_cast<std::ptrdiff_t>(period),
                    visits.end()};
    return {};
}

std::string path(const std::vector<Visit>& visits) {
    std::string text;
    int last = -1;
    for (const Visit& visit : visits) {
        if (visit.i == last) continue;
        last = visit.i;
        text += fmt::format("{}he[{}]", text.empty() ? "" : " ", visit.i);
    }
    return text;
}

std::string endless(std::vector<Visit> repeated, std::int64_t budget,
                    int start) {
    // One turn: the half-edge that it comes back to is named once.
    while (repeated.size() > 1 && repeated.back().i == repeated.front().i)
        repeated.pop_back();
    std::string text = fmt::format(
        "the walk does not end: {} {} visited again and again (stopped after "
        "{} reads)",
        path(repeated), repeated.size() == 1 ? "is" : "are", budget);
    const bool met = std::any_of(repeated.begin(), repeated.end(),
                                 [&](const Visit& v) { return v.i == start; });
    if (start >= 0 && !met)
        text += fmt::format("; the start, he[{}], is never met again", start);
    if (start >= 0 && met)
        text += fmt::format(
            "; it passes the start, he[{}], but does not stop there", start);
    return text;
}

}  // namespace

int HalfEdgeTable::copy_last_visits(Visit* to) const {
    const auto n = static_cast<int>(std::min<std::int64_t>(reads(), ring_size));
    for (int k = n - 1; k >= 0; --k)
        *to++ = visit_of(ring_[(reads_left() + k) & (ring_size - 1)]);
    return n;
}

std::vector<Visit> HalfEdgeTable::last_visits() const {
    std::vector<Visit> visits(ring_size);
    visits.resize(static_cast<std::size_t>(copy_last_visits(visits.data())));
    return visits;
}

void HalfEdgeTable::note_reads(std::int64_t reads,
                               const std::vector<Visit>& last) const {
    allow(reads_left() - reads);
    for (std::size_t k = 0; k < last.size(); ++k)
        ring_[(reads_left() + static_cast<std::int64_t>(last.size() - 1 - k)) &
              (ring_size - 1)] = word_of(last[k]);
}

void HalfEdgeTable::charge() const {
    for (int i = 0; i < size(); ++i) {
        HalfEdgeIndex at(i);
        at.forget_line();  // a loop over the whole table has none of its own
        row(at);
    }
}

void HalfEdgeTable::fail(HalfEdgeIndex at) const {
    const std::vector<Visit> visits = last_visits();
    const int line = at.line();
    if (static_cast<std::uint32_t>(at.i()) >= rows_.size())
        throw OutOfTable(no_such_row(rows_, at.i(), line, visits));
    const std::string where = line > 0 ? fmt::format("line {}: ", line) : "";
    const std::vector<Visit> repeated = cycle(visits);
    if (!repeated.empty())
        throw TooManyReads(where + endless(repeated, budget_, start_));
    if (exact_)
        throw TooManyReads(fmt::format(
            "{}more than {} reads of the table: the exercise allows a fixed "
            "number for each step of the walk, however large the mesh is",
            where, budget_));
    throw TooManyReads(fmt::format(
        "{}stopped after {} reads of the table: the walk does not end", where,
        budget_));
}

#if COURSE_TABLE == 2

namespace {

/// The recording of this process: a call may use several tables.
struct TraceLog {
    bool running = false;
    std::size_t most = 0;
    std::size_t size = 0;
    std::vector<TraceEvent> events;
    std::vector<std::int64_t> numbers;  // of the tables, as they are used

    bool is_open() const { return running && size <= most; }

    /// How a table is called in the events; -1 when it has none yet.
    int index_of(std::int64_t number) const {
        const auto found = std::find(numbers.begin(), numbers.end(), number);
        return found == numbers.end()
                   ? -1
                   : static_cast<int>(found - numbers.begin());
    }

    void add(TraceEvent event) {
        if (++size <= most) events.push_back(std::move(event));
    }
};

TraceLog trace_log;

/// The row as an array, in the order of the fields.
std::array<int, 4> cells(const HalfEdge& row) {
    return {row.vi, row.fi, row.next, row.opp};
}

bool is_before(const Change& a, const Change& b) {
    return std::tie(a.i, a.field) < std::tie(b.i, b.field);
}

}  // namespace

std::int64_t TableNumber::next() {
    static std::int64_t last = 0;
    return ++last;
}

void HalfEdgeTable::start_trace(std::size_t most) const {
    trace_log = {};
    trace_log.running = true;
    trace_log.most = most;
    shadow_ = rows_;
    begin_events();
}

std::vector<TraceEvent> HalfEdgeTable::stop_trace() const {
    note_all_changes();
    trace_log.running = false;
    return std::move(trace_log.events);
}

const std::size_t& HalfEdgeTable::trace_size() {
    return trace_log.size;
}

void HalfEdgeTable::begin_events() const {
    TraceEvent event{-1, 0, 0, {}, TraceEvent::Kind::begin};
    event.table = static_cast<int>(trace_log.numbers.size());
    event.rows = shadow_;
    last_event_ = trace_log.size;
    trace_log.numbers.push_back(number_.get());
    trace_log.add(std::move(event));
}

void HalfEdgeTable::add_event(TraceEvent::Kind kind, int i, std::int64_t place,
                              const void* frame) const {
    if (!trace_log.running || place < 0) return;
    if (!trace_log.is_open()) {
        ++trace_log.size;
        return;
    }
    if (trace_log.index_of(number_.get()) < 0) begin_events();
    note_changes();
    last_event_ = trace_log.size;
    trace_log.add({i,
                   static_cast<int>(place / 4096),
                   static_cast<int>(place % 4096),
                   {},
                   kind,
                   trace_log.index_of(number_.get()),
                   {},
                   reinterpret_cast<std::uintptr_t>(frame)});
}

void HalfEdgeTable::lend(HalfEdgeIndex i) const {
    const auto at = static_cast<std::size_t>(i.i());
    if (at >= is_lent_.size()) is_lent_.resize(rows_.size());
    if (is_lent_[at]) return;
    is_lent_[at] = true;
    lent_.push_back(i.i());
}

void HalfEdgeTable::lend_all() const {
    for (int i = 0; i < size(); ++i) lend(i);
}

/// Whether there is an event to which changes could belong.
bool HalfEdgeTable::is_recorded() const {
    return trace_log.is_open() && last_event_ < trace_log.events.size() &&
           trace_log.index_of(number_.get()) >= 0;
}

void HalfEdgeTable::note_changes() const {
    if (!is_recorded()) return;
    const std::size_t known = std::min(shadow_.size(), rows_.size());
    shadow_.resize(rows_.size());
    for (const int i : lent_)
        if (static_cast<std::size_t>(i) < known) note_changes_of(i);
    for (std::size_t i = known; i < rows_.size(); ++i)
        note_changes_of(static_cast<int>(i));
}

/// Also those of rows that were never handed out, but cast to be written.
void HalfEdgeTable::note_all_changes() const {
    note_changes();
    if (!is_recorded()) return;
    for (int i = 0; i < size(); ++i) note_changes_of(i);
}

void HalfEdgeTable::note_changes_of(int i) const {
    const auto at = static_cast<std::size_t>(i);
    if (shadow_[at] == rows_[at]) return;
    const auto before = cells(shadow_[at]), after = cells(rows_[at]);
    std::vector<Change>& changes = trace_log.events[last_event_].changes;
    for (int field = 0; field < 4; ++field) {
        const auto f = static_cast<std::size_t>(field);
        if (before[f] == after[f]) continue;
        const Change change{i, field, before[f], after[f]};
        // In the order of the table.
        changes.insert(
            std::upper_bound(changes.begin(), changes.end(), change, is_before),
            change);
    }
    shadow_[at] = rows_[at];
}

void HalfEdgeTable::note(HalfEdgeIndex at) const {
    ring_[slot_] = word_of({at.i(), at.line()});
    add_event(TraceEvent::Kind::subscript, at.i(), at.place, at.frame);
}

void HalfEdgeTable::append(const HalfEdge& row, std::int64_t place,
                           const void* frame) {
    add_event(TraceEvent::Kind::push_back, size(), place, frame);
    rows_.push_back(row);
}

#endif

}  // namespace COURSE_TABLE_NAMESPACE

#endif
